// The drawn frame and the values read back: surface or background, the object, the depth, under
// every kind of depth range; and clipping. Run once more with object ids as colours.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/view/painters/frame_painter.h"
#include "gui/view/painters/mesh_painter.h"
#include "tests/gui/depth_ranges.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QSignalSpy>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::unproject;

namespace {

/// The entry of a ray into a cube of edge 2, as a multiple of its direction; empty where it passes
/// by. By hand, from the cube's six planes.
std::optional<double> entry(const guitest::Ray &ray, const glm::dvec3 &center)
{
    double enters = -std::numeric_limits<double>::infinity(), leaves = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (center[axis] - 1.0 - ray.origin[axis]) / ray.direction[axis];
        const double b = (center[axis] + 1.0 - ray.origin[axis]) / ray.direction[axis];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
    }
    return enters < leaves ? std::optional(enters) : std::nullopt;
}

/// A plane through a point; its positive side is on the side of the normal.
glm::dvec4 planeThrough(const glm::dvec3 &point, const glm::dvec3 &normal)
{
    return glm::dvec4(normal, -glm::dot(normal, point));
}

} // namespace

namespace {

/// OpenGL without a window.
struct Context {
    Context()
    {
        context.setFormat(SceneView::preCreateWindow());
        surface.setFormat(SceneView::preCreateWindow());
        surface.create();
        isCurrent = context.create() && context.makeCurrent(&surface);
    }
    QOffscreenSurface surface;
    QOpenGLContext context;
    bool isCurrent = false;
};

} // namespace

class TestFrame : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void everyPixelIsTheSurfaceThatIsThere_data() { depthranges::addRows(); }

    void everyPixelIsTheSurfaceThatIsThere()
    {
        QFETCH(double, atNear);
        QFETCH(double, atFar);
        for (const bool isOrtho : {false, true}) {
            const auto window = twoCubesWindow({atNear, atFar});
            if (isOrtho)
                switchProjection(window->document());
            SceneView &view = window->view();
            int background = 0;
            std::array<int, 2> seen{};
            for (int y = 3; y < view.height(); y += 23) {
                for (int x = 2; x < view.width(); x += 19) {
                    window->document().picks().clearPick();
                    click(view, QPointF(x, y));
                    QVERIFY(window->document().picks().pick());
                    const Pick &pick = *window->document().picks().pick();
                    const DevicePixel pixel = pixelUnder(view, QPointF(x, y));
                    const guitest::Ray ray = rayThrough(window->document().setup(), windowOf(view, pixel));
                    std::optional<std::size_t> object;
                    double nearest = std::numeric_limits<double>::infinity();
                    for (std::size_t i = 0; i < kTwoCubeCenters.size(); ++i) {
                        if (const std::optional<double> at = entry(ray, kTwoCubeCenters[i]); at && *at < nearest) {
                            nearest = *at;
                            object = i;
                        }
                    }
                    QCOMPARE(pick.hit(), object.has_value());
                    QCOMPARE(pick.object, object);
                    if (!object) {
                        QCOMPARE(static_cast<float>(pick.window.z), static_cast<float>(atFar));
                        ++background;
                        continue;
                    }
                    ++seen[*object];
                    QVERIFY(pick.point.world[Method::Formula].hasValue());
                    const glm::dvec3 expected = ray.origin + ray.direction * nearest;
                    const glm::dvec3 off = pick.point.world[Method::Formula]->coordinates() - expected;
                    constexpr double kByHand = 1e-12; // the error of the ray and the planes here
                    for (int axis = 0; axis < 3; ++axis)
                        QVERIFY(std::abs(off[axis]) <= pick.uncertainty.world[axis] + kByHand);
                }
            }
            QVERIFY2(background > 30 && seen[0] > 10 && seen[1] > 1,
                     qPrintable(QString("%1 %2 %3").arg(background).arg(seen[0]).arg(seen[1])));
        }
    }

    void smoothEdgesMoveNoDepth_data() { depthranges::addRows(); }

    void smoothEdgesMoveNoDepth()
    {
        QFETCH(double, atNear);
        QFETCH(double, atFar);
        const auto window = twoCubesWindow({atNear, atFar});
        SceneView &view = window->view();
        const auto depths = [&](bool smooth) {
            view.setSmoothEdges(smooth);
            (void)view.grabFramebuffer();
            std::vector<double> read;
            for (int y = 0; y < view.height(); y += tests::spacing(19)) {
                for (int x = 0; x < view.width(); x += tests::spacing(17)) {
                    click(view, QPointF(x, y));
                    read.push_back(window->document().picks().pick()->window.z);
                }
            }
            return read;
        };
        QCOMPARE(depths(true), depths(false));
    }

    void aPickIsNeverOnAClippedPart_data()
    {
        addColumn<QList<QVector4D>>("planes");
        const auto row = [](const char *name, const std::vector<glm::dvec3> &normals) {
            QList<QVector4D> planes;
            for (const glm::dvec3 &normal : normals) {
                const glm::dvec4 p = planeThrough(kCubeCenter + glm::dvec3(0.15, -0.1, 0.2), normal);
                planes << QVector4D(float(p.x), float(p.y), float(p.z), float(p.w));
            }
            newRow(name) << planes;
        };
        row("along an axis", {{-1.0, 0.0, 0.0}});
        row("at a slant", {{-0.6, 0.3, -1.0}});
        row("of another length", {{-600.0, 300.0, -1000.0}});
        row("two", {{-1.0, 0.0, 0.0}, {0.0, -1.0, 0.1}});
        row("six", {{-1.0, 0.2, 0.0},
                    {0.0, -1.0, 0.1},
                    {0.1, 0.0, -1.0},
                    {-1.0, 0.3, 0.0},
                    {0.0, -1.0, 0.3},
                    {0.3, 0.0, -1.0}});
    }

    void aPickIsNeverOnAClippedPart()
    {
        QFETCH(QList<QVector4D>, planes);
        const auto window = twoCubesWindow();
        std::vector<glm::dvec4> cutting;
        for (const QVector4D &p : planes)
            cutting.emplace_back(double(p.x()), double(p.y()), double(p.z()), double(p.w()));
        setClipPlanes(window->document(), cutting);
        int hits = 0, cut = 0;
        for (int y = 0; y < window->view().height(); y += tests::spacing(17)) {
            for (int x = 0; x < window->view().width(); x += tests::spacing(15)) {
                click(window->view(), QPointF(x, y));
                const Pick &pick = *window->document().picks().pick();
                const guitest::Ray ray = rayThrough(
                    window->document().setup(), windowOf(window->view(), pixelUnder(window->view(), QPointF(x, y))));
                const std::optional<double> uncut = entry(ray, kTwoCubeCenters[0]);
                if (!pick.hit()) {
                    cut += uncut ? 1 : 0;
                    continue;
                }
                ++hits;
                const glm::dvec3 point = pick.point.world[Method::Formula]->coordinates();
                for (const glm::dvec4 &plane : cutting) {
                    const double distance = glm::dot(plane, glm::dvec4(point, 1.0)) / glm::length(glm::dvec3(plane));
                    QVERIFY2(distance >= -length(pick.withinPixel.world), qPrintable(QString::number(distance)));
                }
            }
        }
        QVERIFY2(hits >= tests::rounds(5) && cut >= tests::rounds(5),
                 qPrintable(QStringLiteral("%1 hits, %2 cut away").arg(hits).arg(cut)));
    }

    void aRemovedPlaneIsGone()
    {
        const auto window = twoCubesWindow();
        SceneDocument &document = window->document();
        const QImage before = window->view().grabFramebuffer();
        const glm::dvec4 plane = planeThrough(kCubeCenter, {-0.6, 0.3, -1.0});
        setClipPlanes(document, {plane});
        const QImage one = window->view().grabFramebuffer();
        QVERIFY(one != before);
        setClipPlanes(document, {plane, planeThrough(kCubeCenter, {-1.0, 0.0, 0.0})});
        QVERIFY(window->view().grabFramebuffer() != one);
        setClipPlanes(document, {plane});
        QVERIFY(window->view().grabFramebuffer() == one);
        setClipPlanes(document, {});
        QVERIFY(window->view().grabFramebuffer() == before);
        // The plane does not cut the next scene.
        setClipPlanes(document, {plane});
        (void)window->view().grabFramebuffer();
        openObjects(document, twoCubes(), kBeforeTwoCubes);
        QVERIFY(window->view().grabFramebuffer() == before);
    }

    void aRemovedPlaneIsGoneInTheObserver()
    {
        SceneDocument document;
        document.setSurface({420, 360, 1.0});
        openObjects(document, twoCubes(), kBeforeTwoCubes);
        ObserverPanel panel(document);
        panel.resize(500, 600);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMilliseconds));
        ObserverView &view = panel.view();
        const QImage before = view.grabFramebuffer();
        setClipPlanes(document, {planeThrough(kCubeCenter, {-0.6, 0.3, -1.0})});
        QVERIFY(view.grabFramebuffer() != before);
        setClipPlanes(document, {});
        QVERIFY(view.grabFramebuffer() == before);
        // The morph cuts with all eight of OpenGL's.
        view.setMorph(1.0);
        QVERIFY(view.grabFramebuffer() != before);
        view.setMorph(0.0);
        QVERIFY(view.grabFramebuffer() == before);
    }

    void aPlaneIsShownAndCannotBePicked()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        const QImage before = view.grabFramebuffer();
        // It cuts nothing off the cubes and stands in front of them.
        const glm::dvec3 beside = kCubeCenter + glm::dvec3(0.0, 0.0, 1.3);
        setClipPlanes(window->document(), {planeThrough(beside, {0.0, 0.0, -1.0})});
        const QImage with = view.grabFramebuffer();
        const QPointF place = localOf(*window, beside + glm::dvec3(-2.2, 0.4, 0.0));
        const DevicePixel pixel = pixelUnder(view, place);
        QVERIFY(before.rect().contains(pixel.i, pixel.j));
        QVERIFY(before.pixel(pixel.i, pixel.j) != with.pixel(pixel.i, pixel.j));
        click(view, localOf(*window, beside));
        QVERIFY(window->document().picks().pick()->hit());
        const glm::dvec3 picked = window->document().picks().pick()->point.world[Method::Formula]->coordinates();
        QVERIFY(std::abs(picked.z - (kCubeCenter.z + 1.0)) < 0.01);
    }

    void aFrameTooLargeIsRefusedAndLeavesNothingBehind()
    {
        Context gl;
        QVERIFY(gl.isCurrent);
        Frame frame;
        frame.initialize();
        QCOMPARE(frame.ids(), qEnvironmentVariable("UNPROJECTOR_OBJECT_IDS") == QStringLiteral("colors")
                                  ? ObjectIds::Colors
                                  : ObjectIds::Integers);
        const auto picture = [](int size) {
            Setup g;
            g.surface = {size, size, 1.0};
            g.viewport = wholeSurface(g.surface);
            return g;
        };
        QVERIFY(!frame.sample({0, 0}));
        QVERIFY(frame.begin(drawable(picture(16)).value()));
        frame.end();
        QVERIFY(frame.sample({3, 4}) && !frame.sample({3, 4})->hit());
        Drawable tooLarge; // more than any driver has, and more than drawable() lets through
        tooLarge.setup = picture(1 << 20);
        QVERIFY(!frame.begin(tooLarge));
        QVERIFY(!frame.setup() && !frame.sample({3, 4}));
        QVERIFY(frame.begin(drawable(picture(16)).value()));
        frame.end();
        QVERIFY(frame.sample({3, 4}));
        QCOMPARE(gl.context.functions()->glGetError(), GLenum(GL_NO_ERROR));
        frame.release();
    }

    void aBufferTooLargeIsRefused()
    {
        Context gl;
        QVERIFY(gl.isCurrent);
        QOpenGLExtraFunctions &functions = *gl.context.extraFunctions();
        GLuint buffer = 0;
        functions.glGenBuffers(1, &buffer);
        functions.glBindBuffer(GL_ARRAY_BUFFER, buffer);
        const float data[] = {1.0f, 2.0f};
        QVERIFY(fillBuffer(functions, GL_ARRAY_BUFFER, sizeof data, data));
        // Some drivers take any size that OpenGL counts, and look for the memory later.
        QVERIFY(!fillBuffer(functions, GL_ARRAY_BUFFER, std::numeric_limits<std::size_t>::max(), nullptr));
        functions.glDeleteBuffers(1, &buffer);
    }

    void aFrameIsPutOntoWhateverThereIs_data()
    {
        addColumn<bool>("isSmooth");
        addColumn<bool>("hasStencil");
        newRow("depths of the same format") << false << true;
        newRow("depths of another format") << false << false;
        newRow("smooth, depths of the same format") << true << true;
        newRow("smooth, depths of another format") << true << false;
    }

    void aFrameIsPutOntoWhateverThereIs()
    {
        QFETCH(bool, isSmooth);
        QFETCH(bool, hasStencil);
        Context gl;
        QVERIFY(gl.isCurrent);
        QOpenGLExtraFunctions &f = *gl.context.extraFunctions();
        Setup setup;
        setup.surface = {16, 8, 1.0};
        setup.viewport = wholeSurface(setup.surface);
        setup.depthRange = {0.25, 0.75};
        Frame frame;
        frame.initialize();
        FramePainter painter;
        painter.initialize();
        QOpenGLFramebufferObject shown(16, 8,
                                       hasStencil ? QOpenGLFramebufferObject::CombinedDepthStencil
                                                  : QOpenGLFramebufferObject::NoAttachment);
        GLuint depths = 0;
        if (!hasStencil) {
            f.glGenRenderbuffers(1, &depths);
            f.glBindRenderbuffer(GL_RENDERBUFFER, depths);
            f.glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, 16, 8);
            QVERIFY(shown.bind());
            f.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths);
        }
        const std::array<std::array<float, 4>, 2> colors{{{1.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f, 1.0f}}};
        for (int round = 0; round < 2; ++round) { // the second round uses the findings of the first
            QVERIFY(frame.begin(drawable(setup).value()));
            f.glClearBufferfv(GL_COLOR, 0, colors[static_cast<std::size_t>(round)].data());
            frame.end();
            QVERIFY(shown.bind());
            f.glClearColor(0.0f, 1.0f, 0.0f, 0.0f);
            f.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            painter.setStale();
            painter.draw({frame.framebuffer(), frame.colors(), frame.depths(), 16, 8}, isSmooth);
            std::array<std::uint8_t, 4> color{};
            GLuint depth = 0;
            f.glReadPixels(15, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
            f.glReadPixels(15, 7, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &depth);
            const std::array<std::uint8_t, 4> expected{std::uint8_t(round == 0 ? 255 : 0), 0,
                                                       std::uint8_t(round == 0 ? 0 : 255), 255};
            QCOMPARE(color, expected);
            QVERIFY2(std::abs(depth / 4294967295.0 - 0.75) < 1e-4, qPrintable(QString::number(depth / 4294967295.0)));
            QCOMPARE(f.glGetError(), GLenum(GL_NO_ERROR));
        }
        f.glDeleteRenderbuffers(1, &depths);
        painter.release();
        frame.release();
    }
};

UNPROJECTOR_TEST(TestFrame, display, colour_ids, at 1.5)
#include "test_frame.moc"
