#pragma once

#include "core/geometry/viewport.h"

#include <QTest>

/// The depth ranges that every view is tested with: each test's rows, and the range of the row that
/// runs.
namespace depthranges {

inline void addRows()
{
    QTest::addColumn<double>("atNear");
    QTest::addColumn<double>("atFar");
    QTest::newRow("whole range") << 0.0 << 1.0;
    QTest::newRow("reversed") << 1.0 << 0.0;
    QTest::newRow("the middle") << 0.2 << 0.9;
    QTest::newRow("the front") << 0.0 << 0.65;
}

inline unprojector::geometry::DepthRange ofThisRow()
{
    QFETCH(double, atNear);
    QFETCH(double, atFar);
    return {atNear, atFar};
}

} // namespace depthranges
