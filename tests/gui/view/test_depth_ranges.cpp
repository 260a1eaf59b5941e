// Both views under every kind of depth range: they show, read and move the same as under [0, 1],
// except for the depths themselves.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "tests/gui/depth_ranges.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QSignalSpy>

#include <glm/geometric.hpp>

#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::unproject;

namespace {

/// Two planes that cut the first cube; each keeps the side that its first three numbers point to.
const std::vector<glm::dvec4> kPlanes{{-1.0, 0.1, 0.0, 3.4}, {0.2, -0.3, -1.0, -2.0}};

std::unique_ptr<MainWindow> cubesWindow(const DepthRange &range, bool isOrtho = false)
{
    auto window = twoCubesWindow(range);
    if (isOrtho)
        switchProjection(window->document());
    return window;
}

/// The results of clicks all over the view: the surface's points, nothing on the background.
std::vector<std::optional<glm::dvec3>> pointsOf(MainWindow &window)
{
    std::vector<std::optional<glm::dvec3>> points;
    for (int y = 3; y < window.view().height(); y += tests::spacing(23)) {
        for (int x = 2; x < window.view().width(); x += tests::spacing(19)) {
            click(window.view(), QPointF(x, y));
            const Pick &pick = *window.document().picks().pick();
            points.push_back(pick.hit() ? std::optional(pick.point.world[Method::Formula]->coordinates())
                                        : std::nullopt);
        }
    }
    return points;
}

} // namespace

class TestDepthRanges : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void thePictureIsTheSame_data() { depthranges::addRows(); }

    /// The picture keeps the hidden parts of the cubes, the planes' faint shapes, ground, axes and the
    /// marker.
    void thePictureIsTheSame()
    {
        const DepthRange range = depthranges::ofThisRow();
        for (const bool isOrtho : {false, true}) {
            const auto window = cubesWindow({}, isOrtho);
            setClipPlanes(window->document(), kPlanes);
            SceneView &view = window->view();
            const QPointF marked = localOf(*window, kCubeCenter + glm::dvec3(-0.6, -0.5, 0.9));
            const auto picture = [&] {
                click(view, marked);
                return view.grabFramebuffer();
            };
            const QImage whole = picture();
            QVERIFY(window->document().picks().pick()->hit());
            setDepthRange(window->document(), range);
            const int different = differentPixels(picture(), whole);
            QVERIFY2(different < 40, qPrintable(QString::number(different)));
        }
    }

    void aCutModelIsReadTheSame_data() { depthranges::addRows(); }

    void aCutModelIsReadTheSame()
    {
        const DepthRange range = depthranges::ofThisRow();
        for (const bool isOrtho : {false, true}) {
            const auto window = cubesWindow({}, isOrtho);
            setClipPlanes(window->document(), kPlanes);
            const auto whole = pointsOf(*window);
            setDepthRange(window->document(), range);
            const auto read = pointsOf(*window);
            QCOMPARE(read.size(), whole.size());
            int hits = 0;
            for (std::size_t i = 0; i < read.size(); ++i) {
                QCOMPARE(read[i].has_value(), whole[i].has_value());
                if (!read[i])
                    continue;
                ++hits;
                // Steps of a depth of 24 bits, a third coarser in the shortest of the ranges.
                QVERIFY(glm::length(*read[i] - *whole[i]) < 2e-4);
                for (const glm::dvec4 &plane : kPlanes)
                    QVERIFY(glm::dot(plane, glm::dvec4(*read[i], 1.0)) > -1e-4);
            }
            QVERIFY2(hits > tests::rounds(20) && hits < int(read.size()) / 2, qPrintable(QString::number(hits)));
        }
    }

    void theBackgroundHasTheFarPlanesDepth_data() { depthranges::addRows(); }

    void theBackgroundHasTheFarPlanesDepth()
    {
        const DepthRange range = depthranges::ofThisRow();
        const auto window = cubesWindow(range);
        click(window->view(), QPointF(window->view().width() - 6.0, 7.0));
        const Pick &pick = *window->document().picks().pick();
        QVERIFY(!pick.hit());
        QCOMPARE(pick.window.z, double(float(range.atFar)));
        const ProjectionWindow w = projectionWindow(pick.setup.projection());
        const auto distance = [&](const Unprojected &end) {
            return distanceOf(pick.setup.camera(), end.world[Method::Formula]->coordinates());
        };
        QVERIFY(std::abs(distance(pick.rayNear) - w.nearDistance) < 1e-9);
        QVERIFY(std::abs(distance(pick.rayFar) - w.farDistance) < 1e-9);
    }

    void thePointerReadsWhatAClickReads_data() { depthranges::addRows(); }

    void thePointerReadsWhatAClickReads()
    {
        const auto window = cubesWindow(depthranges::ofThisRow());
        SceneView &view = window->view();
        QSignalSpy hovered(&view, &SceneView::hovered);
        for (const QPointF &place : {localOf(*window, kCubeCenter + glm::dvec3(0.2, 0.1, 1.0)), QPointF(5.0, 7.0)}) {
            hovered.clear();
            sendMouse(view, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
            QTRY_VERIFY_WITH_TIMEOUT(!hovered.isEmpty()
                                         && hovered.last().at(0).value<PixelClick>().position.x == place.x(),
                                     kPatienceMilliseconds);
            click(view, place);
            const auto read = hovered.last().at(0).value<PixelClick>().sample;
            QCOMPARE(read.depth, window->document().picks().pick()->window.z);
            QCOMPARE(read.hit(), window->document().picks().pick()->hit());
        }
    }

    void thePointStaysUnderThePointer_data() { depthranges::addRows(); }

    /// Turning, moving and zooming use the depth under the pointer.
    void thePointStaysUnderThePointer()
    {
        for (const bool isOrtho : {false, true}) {
            const auto window = cubesWindow(depthranges::ofThisRow(), isOrtho);
            SceneView &view = window->view();
            const QPointF place = localOf(*window, kCubeCenter + glm::dvec3(0.3, 0.2, 1.0));
            click(view, place);
            QVERIFY(window->document().picks().pick()->hit());
            const glm::dvec3 point = window->document().picks().pick()->point.world[Method::Formula]->coordinates();
            const auto isAt = [&](const glm::dvec2 &expected) {
                return glm::length(placeOf(*window, point) - expected) < 1e-3;
            };
            const glm::dvec2 center = windowOf(view, pixelUnder(view, place));
            turnWheel(view, place, 2);
            QVERIFY(isAt(center));
            drag(view, place, place + QPointF(40.0, -15.0), Qt::LeftButton);
            QVERIFY(glm::length(
                        placeOf(*window, window->document().picks().pick()->point.world[Method::Formula]->coordinates())
                        - center)
                    < 1e-3);
            const glm::dvec2 before = placeOf(*window, point);
            drag(view, place, place + QPointF(-30.0, 10.0), Qt::MiddleButton);
            const glm::dvec2 way = placeOf(*window, point) - before;
            QVERIFY(glm::length(way - glm::dvec2(-30.0, -10.0) * view.devicePixelRatio()) < 0.5);
        }
    }

    void theViewFromOutsideIsTheSame_data() { depthranges::addRows(); }

    /// The volume, the planes, the ray of a click and its point: half of the way, and morphed.
    void theViewFromOutsideIsTheSame()
    {
        const DepthRange range = depthranges::ofThisRow();
        SceneDocument document;
        document.setSurface({420, 360, 1.0});
        openObjects(document, twoCubes(), kBeforeTwoCubes);
        setClipPlanes(document, kPlanes);
        ObserverPanel panel(document);
        panel.resize(500, 600);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMilliseconds));
        ObserverView &view = panel.view();
        const auto pictures = [&] {
            std::vector<QImage> seen;
            const DepthRange &drawn = document.setup().depthRange;
            for (const bool hit : {true, false}) {
                const double share = hit ? 0.9 : 1.0;
                pickAt(document, WidgetPoint(190.0, 170.0),
                       {drawn.atNear + share * (drawn.atFar - drawn.atNear),
                        hit ? std::optional<std::size_t>(0) : std::nullopt});
                for (const double t : {0.0, 0.5, 1.0}) {
                    view.setMorph(t);
                    seen.push_back(view.grabFramebuffer());
                }
            }
            return seen;
        };
        const std::vector<QImage> whole = pictures();
        setDepthRange(document, range);
        const std::vector<QImage> seen = pictures();
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const int different = differentPixels(seen[i], whole[i]);
            QVERIFY2(different < 40, qPrintable(QStringLiteral("picture %1: %2 pixels").arg(i).arg(different)));
            QVERIFY(i == 0 || differentPixels(seen[i], seen[i - 1]) > 40); // a check of pictures that differ
        }
    }
};

UNPROJECTOR_TEST(TestDepthRanges, display)
#include "test_depth_ranges.moc"
