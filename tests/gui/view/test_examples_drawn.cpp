// The tutorials' examples on the screen: each shows something, and a click on the point of its note
// reads that point.

#include "tests/support/test.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/view/scene_view.h"
#include "tests/support/example_scene.h"
#include "tests/support/patience.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

/// A document and its view on the screen.
struct Stage {
    Stage() : view(document)
    {
        view.resize(800, 600);
        view.show();
    }

    QImage picture(const Scene &scene)
    {
        if (!document.open(scene))
            return {};
        return view.grabFramebuffer();
    }

    SceneDocument document;
    SceneView view;
};

} // namespace

class TestExamplesDrawn : public QObject {
    Q_OBJECT

private slots:
    void everyExampleShowsItsObjects_data()
    {
        addColumn<QString>("id");
        for (const std::string_view id : examples::kExamples)
            newRow(id.data()) << QString::fromLatin1(id.data());
    }

    void everyExampleShowsItsObjects()
    {
        QFETCH(QString, id);
        Stage stage;
        QVERIFY(QTest::qWaitForWindowExposed(&stage.view, kPatienceMilliseconds));
        Scene scene = sceneOfExample(id.toStdString());
        const QImage shown = stage.picture(scene);
        // The clip plane removes all objects; ground and axes stay.
        scene.clipPlanes = {glm::dvec4(0.0, 0.0, 1.0, -1e6)};
        const QImage without = stage.picture(scene);
        QCOMPARE(shown.size(), without.size());
        int different = 0;
        for (int y = 0; y < shown.height(); ++y) {
            for (int x = 0; x < shown.width(); ++x)
                different += shown.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
        }
        QVERIFY2(different > 60, qPrintable(QString::number(different)));
    }

    void aClickReadsThePointOfTheNote_data()
    {
        addColumn<QString>("id");
        addColumn<double>("x");
        addColumn<double>("y");
        addColumn<double>("z");
        newRow("2-D: (1, 1) of MC is (3, 4)") << "zhangci-2d" << 3.0 << 4.0 << 0.0;
        newRow("modelview: 3 behind the origin") << "zhangci-model-view" << 1.0 << 1.0 << -3.0;
        newRow("viewport of 50 x 50") << "zhangci-viewport-50" << 0.0 << 0.0 << 0.0;
        newRow("lower right quarter") << "zhangci-viewport-quarter" << 0.0 << 0.0 << 0.0;
        newRow("three projections: the matrix") << "derivation-matrix" << -8.0 << 0.0 << -20.0;
        newRow("three projections: gluPerspective") << "derivation-perspective" << -8.0 << 0.0 << -20.0;
        newRow("round trip") << "opencascade-round-trip" << 0.0 << 0.0 << 0.0;
        newRow("the quad, its middle") << "parallel-orthographic" << 0.0 << 0.0 << -4.0;
        newRow("the box, its front") << "parallel-oblique" << 0.0 << 0.0 << -3.0;
    }

    void aClickReadsThePointOfTheNote()
    {
        QFETCH(QString, id);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        Stage stage;
        QVERIFY(QTest::qWaitForWindowExposed(&stage.view, kPatienceMilliseconds));
        QVERIFY(!stage.picture(sceneOfExample(id.toStdString())).isNull());
        const WorldPoint expected(x, y, z);
        const Setup &setup = stage.document.setup();
        const Result<WindowPoint> window = windowFromWorld(setup, expected);
        QVERIFY(window);
        const WidgetPoint widget = widgetFromDevice(setup.surface, deviceFromWindow(setup.surface, *window));
        QTest::mouseClick(&stage.view, Qt::LeftButton, {}, QPoint(int(widget.x), int(widget.y)));
        QTRY_VERIFY_WITH_TIMEOUT(stage.document.picks().pick(), kPatienceMilliseconds);
        const Pick &pick = *stage.document.picks().pick();
        QVERIFY(pick.hit());
        QVERIFY(pick.point.world[Method::Formula] && pick.point.world[Method::Matrix]);
        // The point is within the clicked pixel, which is off by at most one pixel; and on the surface,
        // which faces the eye.
        const Certainty c = pick.certainty;
        const glm::dvec3 off = pick.point.world[Method::Formula]->coordinates() - expected.coordinates();
        QVERIFY2(std::abs(off.x) <= 2.0 * c.footprintWidth, qPrintable(QString::number(off.x)));
        QVERIFY2(std::abs(off.y) <= 2.0 * c.footprintHeight, qPrintable(QString::number(off.y)));
        QVERIFY2(std::abs(off.z) <= 8.0 * c.halfDepthStep, qPrintable(QString::number(off.z)));
    }

    void aMirroredObjectIsLitLikeAnother()
    {
        Stage stage;
        QVERIFY(QTest::qWaitForWindowExposed(&stage.view, kPatienceMilliseconds));
        Scene scene = sceneOfExample("zhangci-viewport-quarter");
        scene.viewport = {};
        const auto color = [&](const glm::dvec3 &factors) {
            scene.objects.at(0).transform = {Scale{factors}};
            const QImage picture = stage.picture(scene);
            // The pixel is beside the middle, where the axes start.
            return picture.pixelColor(picture.width() / 2 - 20, picture.height() / 2 + 15);
        };
        const QColor plain = color({1, 1, 1});
        QVERIFY(plain.lightness() > 100);
        QCOMPARE(color({-1, 1, 1}), plain);
        QCOMPARE(color({1, -1, 1}), plain);
        // Seen from behind it is lit as well: twice mirrored is a half turn.
        QCOMPARE(color({-1, 1, -1}), plain);
    }
};

UNPROJECTOR_TEST(TestExamplesDrawn, display)
#include "test_examples_drawn.moc"
