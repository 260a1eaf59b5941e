// The uncertainty that a click reports, against the mesh itself, over many random clicks on models
// that OpenGL draws, at all pixel ratios, projections and depth ranges. 99.9 % of the exact ray's
// hits lie in the reported box; fewer would in a box half as large.

#include "tests/support/test.h"

#include "tests/gui/view/drawn_clicks.h"
#include "tests/support/cube_sphere.h"

using namespace unprojector;

namespace {
using ModelPointer = std::shared_ptr<const mesh::Model>;
}

class TestDrawnCertainty : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_stage = std::make_unique<drawnclicks::Stage>(); }
    void cleanupTestCase() { m_stage.reset(); }

    void theMeshLiesInTheBox_data()
    {
        addColumn<ModelPointer>("model");
        addColumn<bool>("isSmooth"); // so that the depths around a pixel tell the triangle's slope
        newRow("cube sphere") << ModelPointer(cubeSphere(60)) << true;
        newRow("cube") << ModelPointer(cubeSphere(1, 0.0)) << true;
        newRow("far from the origin") << ModelPointer(drawnclicks::movedFarAway(*cubeSphere(60))) << true;
        newRow("rough terrain") << ModelPointer(drawnclicks::roughTerrain(200)) << false;
        newRow("triangles smaller than pixels") << ModelPointer(cubeSphere(250)) << true;
        newRow("slivers") << ModelPointer(drawnclicks::slivers(1500)) << false;
    }

    void theMeshLiesInTheBox()
    {
        QFETCH(ModelPointer, model);
        QFETCH(bool, isSmooth);
        // Every projection with every pixel ratio and depth range in turn.
        constexpr int kPictures = 30, kClicks = 420;
        drawnclicks::Shares all;
        for (int number = 0; number < kPictures; ++number) {
            const auto shares = m_stage->clicked(model, number, kClicks);
            QVERIFY(shares);
            all.add(*shares);
        }
        const auto told = [](const InsideShare &share) {
            return QStringLiteral("%1 % inside, needed scale %2").arg(100.0 * share.inside()).arg(share.neededScale());
        };
        qInfo("%zu clicks; by triangle %s; by neighbours %s", all.byTriangle.count(), qPrintable(told(all.byTriangle)),
              qPrintable(told(all.byNeighbours)));
        QVERIFY(all.byTriangle.count() >= 10'000);
        QVERIFY(all.byTriangle.inside() >= 0.999);
        QVERIFY(all.byTriangle.neededScale() >= 0.5);
        if (isSmooth)
            QVERIFY(all.byNeighbours.inside() >= 0.999);
    }

    void aGridOfCornersIsFound_data()
    {
        addColumn<double>("grid");
        addColumn<double>("least");
        addColumn<double>("most");
        // A software renderer has no such grid for its depths, a graphics card has 1/256 of a pixel at
        // most.
        newRow("OpenGL's own") << 0.0 << 0.0 << 0x1p-9;
        newRow("1/256 of a pixel") << 256.0 << 0x1p-9 << 0x1p-9;
        newRow("1/16 of a pixel") << 16.0 << 0x1p-5 << 0x1p-5;
    }

    void aGridOfCornersIsFound()
    {
        QFETCH(double, grid);
        QFETCH(double, least);
        QFETCH(double, most);
        const double shift = m_stage->cornerShift(grid);
        qInfo("%g of a pixel", shift);
        QVERIFY(shift >= least && shift <= most);
        // The drawing that measures the shift leaves no trace: clicks are read as before.
        const auto shares = m_stage->clicked(cubeSphere(20), 0, 100);
        QVERIFY(shares && shares->byTriangle.count() == 100 && shares->byTriangle.inside() > 0.99);
    }

private:
    std::unique_ptr<drawnclicks::Stage> m_stage;
};

UNPROJECTOR_TEST(TestDrawnCertainty, unsanitized, display)
#include "test_drawn_certainty.moc"
