#pragma once

#include <cstddef>

namespace unprojector::ray {

/// @return memory that begins at a page of 2 MiB where there are as many bytes, else at a line of the cache
/// Throws std::bad_alloc.
void *allocateInLargePages(std::size_t bytes);
/// @param bytes  as they were asked for
void freeLargePages(void *memory, std::size_t bytes) noexcept;

/// For an array that is too large for the caches and read here and there. Where the system gives pages of 2 MiB to those who ask (Linux),
/// it lies in such: the processor knows the places of too few small ones.
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
