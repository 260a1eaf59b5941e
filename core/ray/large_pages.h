#pragma once

#include <cstddef>

namespace unprojector::ray {

/// Allocates memory at the start of a 2 MiB page if it is at least that large, else at a cache
/// line.
/// Throws std::bad_alloc.
void *allocateInLargePages(std::size_t bytes);
/// @param bytes  as allocated
void freeLargePages(void *memory, std::size_t bytes) noexcept;

/// An allocator for arrays that are too large for the caches and accessed at random. On systems
/// that give 2 MiB pages on request (Linux), it uses them: the processor's TLB covers too few small
/// ones.
template <class T>
struct InLargePages {
    using value_type = T;

    InLargePages() = default;
    template <class U>
    InLargePages(const InLargePages<U> &)
    {
    }
    T *allocate(std::size_t count) { return static_cast<T *>(allocateInLargePages(count * sizeof(T))); }
    void deallocate(T *memory, std::size_t count) noexcept { freeLargePages(memory, count * sizeof(T)); }
    friend bool operator==(const InLargePages &, const InLargePages &) { return true; }
};

} // namespace unprojector::ray
