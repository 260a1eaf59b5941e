#include "core/ray/large_pages.h"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace unprojector::ray {
namespace {

constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kLargePage = std::size_t{2} << 20;

std::align_val_t alignmentOf(std::size_t bytes)
{
    return std::align_val_t(bytes < kLargePage ? kCacheLine : kLargePage);
}

} // namespace

void *allocateInLargePages(std::size_t bytes)
{
    void *memory = ::operator new(bytes, alignmentOf(bytes));
#ifdef __linux__
    // The rest after the last large page stays in small pages. A failure on a system without large
    // pages is harmless.
    if (bytes >= kLargePage)
        static_cast<void>(madvise(memory, bytes / kLargePage * kLargePage, MADV_HUGEPAGE));
#endif
    return memory;
}

void freeLargePages(void *memory, std::size_t bytes) noexcept
{
    ::operator delete(memory, alignmentOf(bytes));
}

} // namespace unprojector::ray
