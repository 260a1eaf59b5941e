// Clicks on a drawn scene, followed from the mouse event to the world. Run at several pixel ratios
// (QT_SCALE_FACTOR), each with and without smooth edges.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QDockWidget>
#include <QScreen>
#include <QToolBar>

#include <glm/geometric.hpp>

#include <cmath>
#include <set>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::unproject;

namespace {

/// The rasterizer computes in single precision: it rounds the matrix and the corners, interpolates
/// the depth, and rounds to 24 bits. So the stored depth can be this many steps of a 24-bit buffer
/// off.
constexpr double kRasterizerSteps = 6.0;
/// Corners are snapped to 1/256 of a pixel before depth is interpolated between them.
constexpr double kSubpixel = 1.0 / 256.0;
/// The largest difference of a quantity of the plane point from its value at the centre, for a
/// sample beside it.
template <class Quantity>
double slopeTerm(const Setup &g, const glm::dvec2 &window, double reach, const glm::dvec3 &point,
                 const glm::dvec3 &normal, Quantity quantity)
{
    const double middle = quantity(onPlane(rayThrough(g, window), point, normal));
    double farthest = 0.0;
    for (const double x : {-reach, reach}) {
        for (const double y : {-reach, reach})
            farthest =
                std::max(farthest,
                         std::abs(quantity(onPlane(rayThrough(g, window + glm::dvec2(x, y)), point, normal)) - middle));
    }
    return farthest;
}

glm::dvec2 obliqueWindowHalf(const SceneView &view)
{
    return {2.2 * view.width() / view.height(), 2.2};
}

/// The projections of the rows, for the view's aspect; the clip distances are fitted by the
/// document.
Projection projectionNamed(const QString &name, const SceneView &view)
{
    const glm::dvec2 half = obliqueWindowHalf(view);
    const Ortho box{-half.x, half.x, -half.y, half.y, 1.0, 10.0};
    if (name == QStringLiteral("frustum"))
        return Frustum{-half.x / 6.0, half.x / 6.0, -half.y / 6.0, half.y / 6.0, 1.0, 10.0};
    if (name == QStringLiteral("frustum, off-centre"))
        return Frustum{-half.x / 12.0, half.x / 4.0, -half.y / 4.0, half.y / 12.0, 1.0, 10.0};
    if (name == QStringLiteral("ortho"))
        return box;
    return Oblique{box, 1.35, 1.85};
}

/// A camera in front of a face, moved to the side and up, so that it sees the face at a slant. Its
/// target is in the middle of an off-centre or sheared picture.
LookAt cameraBefore(const Face &face, const Setup &g)
{
    const glm::dvec3 middle = kCubeCenter + face.normal;
    const glm::dvec3 other = glm::cross(face.normal, face.across);
    const LookAt camera{WorldPoint(middle + 5.0 * face.normal + 1.7 * face.across + 2.3 * other), WorldPoint(middle),
                        std::abs(face.normal.y) > 0.5 ? WorldVector(0.0, 0.0, -1.0) : WorldVector(0.0, 1.0, 0.0)};
    Setup seen = g;
    seen.camera() = camera;
    return recentered(seen, WorldPoint(middle));
}

} // namespace

class TestSceneView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theFramebufferHasTheSizeThatDeviceCoordinatesAssume()
    {
        const QByteArray wanted = qgetenv("QT_SCALE_FACTOR");
        for (const QSize &size : {QSize(500, 400), QSize(501, 403), QSize(507, 411)}) {
            const auto window = shownWindow(false, size);
            if (!wanted.isEmpty())
                QCOMPARE(window->view().devicePixelRatio(), wanted.toDouble());
            const Surface &surface = window->document().setup().surface;
            const QImage picture = window->view().grabFramebuffer();
            QCOMPARE(QSize(surface.widthPixels, surface.heightPixels), picture.size());
            QCOMPARE(surface.devicePixelRatio, window->view().devicePixelRatio());
        }
    }

    void aClickOnAFaceGivesItsPlane_data()
    {
        addColumn<bool>("smooth");
        addColumn<QString>("projection");
        addColumn<double>("atNear");
        addColumn<double>("atFar");
        for (const bool smooth : {false, true}) {
            for (const char *projection : {"frustum", "frustum, off-centre", "ortho", "oblique"})
                addRow("%s%s", projection, smooth ? ", smooth edges" : "")
                    << smooth << QString::fromLatin1(projection) << 0.0 << 1.0;
        }
        newRow("frustum, depths reversed") << false << "frustum" << 1.0 << 0.0;
        newRow("frustum, off-centre, the front of the depths") << false << "frustum, off-centre" << 0.0 << 0.65;
        newRow("ortho, the middle of the depths") << false << "ortho" << 0.2 << 0.9;
        newRow("oblique, depths reversed") << false << "oblique" << 1.0 << 0.0;
    }

    void aClickOnAFaceGivesItsPlane()
    {
        QFETCH(bool, smooth);
        QFETCH(QString, projection);
        QFETCH(double, atNear);
        QFETCH(double, atFar);
        const auto window = shownWindow(smooth, {500, 400});
        openObjects(window->document(), cubeScene());
        QVERIFY(editViewport(window->document(), {}, {atNear, atFar}, {QStringLiteral("Depths")}));
        for (const QSize &size : {QSize(500, 400), QSize(417, 431)}) {
            QVERIFY(resized(*window, size));
            for (const Face &face : cubeFaces()) {
                setProjection(window->document(), projectionNamed(projection, window->view()));
                setCamera(window->document(), cameraBefore(face, window->document().setup()));
                QCOMPARE(window->document().setup().projection().index(),
                         projectionNamed(projection, window->view()).index());
                for (const glm::dvec2 &place : {glm::dvec2(0.0, 0.0), glm::dvec2(0.8, -0.7), glm::dvec2(-0.75, 0.6)}) {
                    clickFace(*window, face, place);
                    if (QTest::currentTestFailed())
                        return;
                }
            }
        }
    }

    void depthIsReadInTheRowAndColumnClicked_data()
    {
        addColumn<bool>("smooth");
        addColumn<glm::dvec3>("steep");
        addColumn<glm::dvec3>("level");
        for (const bool smooth : {false, true}) {
            addRow("from row to row%s", smooth ? ", smooth edges" : "")
                << smooth << glm::dvec3(0.0, 8.0, 9.0) << glm::dvec3(12.0, 0.0, 0.0);
            addRow("from column to column%s", smooth ? ", smooth edges" : "")
                << smooth << glm::dvec3(10.0, 0.0, 9.0) << glm::dvec3(0.0, 12.0, 0.0);
        }
    }

    void depthIsReadInTheRowAndColumnClicked()
    {
        QFETCH(bool, smooth);
        QFETCH(glm::dvec3, steep);
        QFETCH(glm::dvec3, level);
        const bool byRow = steep.y != 0.0;
        const auto window = shownWindow(smooth, {400, 360});
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        const glm::dvec3 middle(0.0, 0.0, -30.0);
        openObjects(document, planeScene(middle, steep, level));
        const double aspect = double(view.width()) / view.height();
        setView(document, {WorldPoint(0.0, 0.0, 0.0), WorldPoint(0.0, 0.0, -30.0), {0.0, 1.0, 0.0}},
                Frustum{-0.15 * aspect, 0.15 * aspect, -0.15, 0.15, 1.0, 100.0});
        const Setup &g = document.setup();
        const glm::dvec3 normal = glm::normalize(glm::cross(steep, level));
        const auto depthAt = [&](const glm::dvec3 &p) { return windowFromWorld(g, WorldPoint(p)).value().z; };

        const int w = view.width(), h = view.height();
        std::vector<QPoint> positions{{0, 0}, {w - 1, 0}, {0, h - 1}, {w - 1, h - 1}, {w / 2, h / 2}};
        for (int k = 1; k < 6; ++k)
            positions.push_back({w / 3 + k, h / 3 + k});
        for (const QPoint &position : positions) {
            click(view, position); // QTest takes (0, 0) for the middle
            QVERIFY(document.picks().pick() && document.picks().pick()->hit());
            const Pick &pick = *document.picks().pick();
            const DevicePixel pixel = pixelUnder(view, position);
            QCOMPARE(QPoint(pick.devicePixel.i, pick.devicePixel.j), QPoint(pixel.i, pixel.j));
            const glm::dvec2 center = windowOf(view, pixel);
            const double expected = depthAt(onPlane(rayThrough(g, center), middle, normal));
            const double tolerance =
                kRasterizerSteps / 16777215.0 + slopeTerm(g, center, kSubpixel, middle, normal, depthAt);
            QVERIFY2(std::abs(pick.window.z - expected) <= tolerance,
                     qPrintable(QStringLiteral("pixel (%1, %2): depth %3, not %4 ± %5")
                                    .arg(pixel.i)
                                    .arg(pixel.j)
                                    .arg(pick.window.z, 0, 'g', 12)
                                    .arg(expected, 0, 'g', 12)
                                    .arg(tolerance)));
            // The test can fail: half a pixel to the side is outside that.
            for (const double aside : {-0.5, 0.5}) {
                const glm::dvec2 wrong = center + (byRow ? glm::dvec2(0.0, aside) : glm::dvec2(aside, 0.0));
                QVERIFY(std::abs(depthAt(onPlane(rayThrough(g, wrong), middle, normal)) - expected) > 1.5 * tolerance);
            }
        }
    }

    void everyDevicePixelCanBeClicked()
    {
        const auto window = shownWindow(false, {430, 420});
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        openObjects(document, cubeScene());
        const double ratio = view.devicePixelRatio();
        auto *dock = new QDockWidget;
        window->addDockWidget(Qt::LeftDockWidgetArea, dock);
        QToolBar *bar = window->addToolBar(QStringLiteral("above"));
        window->insertToolBarBreak(bar);
        std::set<double> fractions;
        for (const int size : {61, 62, 63, 64}) {
            dock->setFixedWidth(size);
            bar->setFixedHeight(size);
            QVERIFY(
                QTest::qWaitFor([&] { return dock->width() == size && bar->height() == size; }, kPatienceMilliseconds));
            settle(20);
            const QPoint corner = view.mapTo(window.get(), QPoint(0, 0));
            for (const int origin : {corner.x(), corner.y()})
                fractions.insert(origin * ratio - std::floor(origin * ratio));
            // The pointer is on whole device pixels of the window; Qt divides by the ratio.
            const QPoint first(static_cast<int>(std::floor(corner.x() * ratio + 0.5)),
                               static_cast<int>(std::floor(corner.y() * ratio + 0.5)));
            for (int k = 0; k < 12; ++k) {
                const QPoint pointer = first + QPoint(150 + k, 120 + k);
                click(view, QPointF(pointer) / ratio - QPointF(corner));
                QVERIFY(document.picks().pick());
                QCOMPARE(QPoint(document.picks().pick()->devicePixel.i, document.picks().pick()->devicePixel.j),
                         QPoint(150 + k, 120 + k));
            }
        }
        // The corner stood on every fraction of a pixel that the ratio knows.
        QCOMPARE(fractions.size(), ratio == 1.25 ? 4u : ratio == 1.5 ? 2u : 1u);
    }

    void theViewIsComposedOntoWholeDevicePixels()
    {
        // The dock is at the left, and a tool bar above: the view's corner falls between device pixels
        // at 1.25 and 1.5.
        const auto window = shownWindow(false, {400, 361});
        auto *bar = new QDockWidget;
        bar->setFixedWidth(61);
        window->addDockWidget(Qt::LeftDockWidgetArea, bar);
        QVERIFY(resized(*window, {433, 361}));
        SceneView &view = window->view();
        QVERIFY(view.mapTo(window.get(), QPoint(0, 0)).x() > 61);
        openObjects(window->document(), cubeScene());
        setCamera(window->document(), cameraBefore(cubeFaces()[0], window->document().setup()));
        const double ratio = view.devicePixelRatio();
        QScreen *screen = window->screen();
        if (!screen->availableGeometry().contains(window->frameGeometry()))
            QSKIP("the screen is too small to see the whole window");
        const QPoint corner = view.mapTo(window.get(), QPoint(0, 0));
        const QPoint first(static_cast<int>(std::floor(corner.x() * ratio + 0.5)),
                           static_cast<int>(std::floor(corner.y() * ratio + 0.5)));
        QImage drawn, seen;
        const auto isSame = [&] {
            drawn = view.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
            seen = screen->grabWindow(window->winId()).toImage().convertToFormat(QImage::Format_RGB32);
            for (int j = 40; j < drawn.height() - 40; j += 3) {
                for (int i = 4; i < drawn.width() - 4; ++i) {
                    if (!seen.rect().contains(first + QPoint(i, j))
                        || seen.pixel(first + QPoint(i, j)) != drawn.pixel(i, j))
                        return false;
                }
            }
            return true;
        };
        // The picture reaches the screen some time after it is drawn.
        QVERIFY2(QTest::qWaitFor(isSame, kPatienceMilliseconds),
                 qPrintable(QStringLiteral("corner at (%1, %2), ratio %3").arg(corner.x()).arg(corner.y()).arg(ratio)));
    }

private:
    /// @param place  on the face, in half-edges from its middle
    void clickFace(MainWindow &window, const Face &face, const glm::dvec2 &place)
    {
        SceneView &view = window.view();
        SceneDocument &document = window.document();
        const glm::dvec3 other = glm::cross(face.normal, face.across);
        const glm::dvec3 aimed = kCubeCenter + face.normal + place.x * face.across + place.y * other;
        // QTest clicks at whole logical pixels.
        const QPoint position = localOf(window, aimed).toPoint();
        QVERIFY2(view.rect().contains(position), face.name);
        const DevicePixel pixel = pixelUnder(view, position);

        document.picks().clearPick();
        const QImage picture = view.grabFramebuffer();
        const int shown = faceOfColor(picture.pixelColor(pixel.i, pixel.j));
        QCOMPARE(shown < 0 ? "no face" : cubeFaces()[static_cast<std::size_t>(shown)].name, face.name);

        QTest::mouseClick(&view, Qt::LeftButton, {}, position);
        QVERIFY(document.picks().pick());
        const Pick &pick = *document.picks().pick();
        QVERIFY(pick.hit());
        QCOMPARE(QPoint(pick.devicePixel.i, pick.devicePixel.j), QPoint(pixel.i, pixel.j));
        const glm::dvec2 center = windowOf(view, pixel);
        QCOMPARE(pick.window.x, center.x);
        QCOMPARE(pick.window.y, center.y);

        const Setup &g = document.setup();
        const Ray ray = rayThrough(g, center);
        const glm::dvec3 expected = onPlane(ray, aimed, face.normal);
        const double step = 2.0 * pick.certainty.halfDepthStep;
        const double tolerance = step * kRasterizerSteps
                                 + slopeTerm(g, center, kSubpixel, aimed, face.normal,
                                             [&](const glm::dvec3 &p) { return distanceOf(g.camera(), p); });
        for (const Result<WorldPoint> &point : {pick.point.world[Method::Formula], pick.point.world[Method::Matrix]}) {
            QVERIFY(point.hasValue());
            const glm::dvec3 off = point->coordinates() - expected;
            QVERIFY2(std::abs(glm::dot(off, forwardOf(g.camera()))) <= tolerance,
                     qPrintable(QStringLiteral("%1: off by %2 along the view, tolerance %3")
                                    .arg(face.name)
                                    .arg(glm::dot(off, forwardOf(g.camera())))
                                    .arg(tolerance)));
            // Nothing is read across the ray, so the point is off only by rounding.
            QVERIFY(glm::length(glm::cross(off, ray.direction)) <= 1e-10);
            // The distance along the ray to the face's plane is bounded.
            QVERIFY(std::abs(glm::dot(point->coordinates() - aimed, face.normal))
                    <= tolerance * std::abs(glm::dot(ray.direction, face.normal)) + 1e-10);
        }
        // The projection of the plane's point, which was found without core: back in the middle of the
        // pixel.
        const glm::dvec2 back = placeOf(window, expected);
        QVERIFY(std::abs(back.x - center.x) <= 1e-8 && std::abs(back.y - center.y) <= 1e-8);
    }
};

UNPROJECTOR_TEST(TestSceneView, display, at 1.25, at 1.5, at 2)
#include "test_scene_view.moc"
