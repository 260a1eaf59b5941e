// In a file of its own: where one of these functions is inlined and the other is not, GCC warns of
// memory that is freed another way.

#include "tests/core/scene/limited_memory.h"

#include <cstdlib>
#include <limits>
#include <new>

std::size_t mostBytesAtOnce = std::numeric_limits<std::size_t>::max();

#ifndef UNPROJECTOR_IS_SANITIZED

void *operator new(std::size_t bytes)
{
    void *memory = bytes <= mostBytesAtOnce ? std::malloc(bytes > 0 ? bytes : 1) : nullptr;
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

void operator delete(void *memory) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}

#endif
