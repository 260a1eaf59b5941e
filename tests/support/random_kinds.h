#pragma once

#include "tests/support/oracle.h"

#include <QTest>

/// A test row for each kind of random camera, in the column "kind".
inline void addKinds()
{
    using oracle::RandomKind;
    QTest::addColumn<RandomKind>("kind");
    QTest::newRow("frustum, off-centre and mirrored too") << RandomKind::Frustum;
    QTest::newRow("perspective") << RandomKind::Perspective;
    QTest::newRow("ortho, around the eye too") << RandomKind::Ortho;
    QTest::newRow("oblique") << RandomKind::Oblique;
}
