#include "core/unproject/batch/batch_unproject.h"

#if defined(UNPROJECTOR_WIDE_KERNELS) && defined(_MSC_VER)
#include <immintrin.h>
#include <intrin.h>
#endif

namespace unprojector::unproject {
namespace {

#ifdef UNPROJECTOR_WIDE_KERNELS
#ifdef _MSC_VER

struct WideSets {
    bool avx2 = false, avx512 = false;
};

/// The sets that the processor has (cpuid) and whose registers the system saves (xgetbv).
WideSets wideSets()
{
    int registers[4];
    __cpuid(registers, 0);
    if (registers[0] < 7)
        return {};
    __cpuid(registers, 1);
    constexpr int kOsSavesRegisters = 1 << 27, kAvx = 1 << 28, kFma = 1 << 12;
    constexpr int kNeeded = kOsSavesRegisters | kAvx | kFma;
    if ((registers[2] & kNeeded) != kNeeded)
        return {};
    const unsigned long long saved = _xgetbv(0);
    __cpuidex(registers, 7, 0);
    const unsigned features = static_cast<unsigned>(registers[1]);
    constexpr unsigned kAvx2 = 1u << 5;
    constexpr unsigned kAvx512 =
        1u << 16 | 1u << 17 | 1u << 28 | 1u << 30 | 1u << 31; // F, DQ, CD, BW, VL: /arch:AVX512
    const bool avx2 = (saved & 0x6) == 0x6 && (features & kAvx2) != 0;
    return {avx2, avx2 && (saved & 0xe6) == 0xe6 && (features & kAvx512) == kAvx512};
}

bool hasAvx2()
{
    return wideSets().avx2;
}

bool hasAvx512()
{
    return wideSets().avx512;
}

#else

bool hasAvx2()
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

bool hasAvx512()
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")
           && hasAvx2();
}

#endif
#endif

} // namespace

const std::vector<InstructionSet> &availableInstructionSets()
{
    static const std::vector<InstructionSet> sets = [] {
        std::vector<InstructionSet> available{InstructionSet::Baseline};
#ifdef UNPROJECTOR_WIDE_KERNELS
        if (hasAvx2())
            available.push_back(InstructionSet::Avx2);
        if (hasAvx512())
            available.push_back(InstructionSet::Avx512);
#endif
        return available;
    }();
    return sets;
}

const batch::Kernels &batch::kernelsOf(InstructionSet set)
{
#ifdef UNPROJECTOR_WIDE_KERNELS
    switch (set) {
    case InstructionSet::Avx512: return batch::kAvx512Kernels;
    case InstructionSet::Avx2: return batch::kAvx2Kernels;
    case InstructionSet::Baseline: break;
    }
#else
    static_cast<void>(set);
#endif
    return batch::kBaselineKernels;
}

} // namespace unprojector::unproject
