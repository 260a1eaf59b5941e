#pragma once

#include "core/unproject/batch/batch_unproject.h"

#include <QTest>

#include <algorithm>

/// Helpers for tests of one instruction set at a time. On a processor without it, the test is
/// skipped by name rather than passed silently.
inline const char *name(unprojector::unproject::InstructionSet set)
{
    using unprojector::unproject::InstructionSet;
    switch (set) {
    case InstructionSet::Baseline: return "baseline";
    case InstructionSet::Avx2: return "AVX2";
    case InstructionSet::Avx512: return "AVX-512";
    }
    return "unknown";
}

inline bool isAvailable(unprojector::unproject::InstructionSet set)
{
    const auto &sets = unprojector::unproject::availableInstructionSets();
    return std::find(sets.begin(), sets.end(), set) != sets.end();
}

/// Skips the test function if the processor lacks the set.
#define SKIP_WITHOUT(set)                                                                                              \
    do {                                                                                                               \
        if (!isAvailable(set))                                                                                         \
            QSKIP(qPrintable(QStringLiteral("this processor has no %1").arg(QLatin1String(name(set)))));               \
    } while (false)
