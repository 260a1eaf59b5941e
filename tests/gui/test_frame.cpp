// What the views draw and what is read back: surface or background, the object, the depth, under every kind of depth
// range; what is cut away; and what is drawn how often. Run once more with object ids as colours.

#include "gui/painters/mesh_painter.h"
#include "gui/panels/observer_panel.h"
#include "gui/view/observer_view.h"
#include "tests/gui/gui_scene.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QSignalSpy>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace guitest;

namespace {

/// Where a ray enters a cube of edge 2, as a multiple of its direction; nothing where it passes by. By hand, from the
/// cube's six planes.
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

/// Two cubes, the second partly behind the first, and the boxes around them overlap in the picture.
const std::array<glm::dvec3, 2> kCenters{{kCubeCenter, kCubeCenter + glm::dvec3(-1.2, 0.4, -3.1)}};

std::vector<SceneObject> twoCubes()
{
    std::vector<SceneObject> cubes = cubeScene();
    cubes.push_back(cubes.front());
    cubes.back().transform = {Translate{kCenters[1]}};
    return cubes;
}

const LookAt kCamera{WorldPoint(kCubeCenter + glm::dvec3(1.9, 2.3, 7.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}};
const LookAt kElsewhere{WorldPoint(kCubeCenter + glm::dvec3(3.0, 1.0, 6.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}};

void setPlanes(SceneDocument &document, const std::vector<glm::dvec4> &planes)
{
    QVERIFY(document.editClipPlanes(planes, {}, {QStringLiteral("Planes")}));
}

void setDepthRange(SceneDocument &document, const DepthRange &range)
{
    QVERIFY(document.editViewport(document.scene().viewport, range, {QStringLiteral("Depth range")}));
}

/// A plane through a point, its positive side that of the normal.
glm::dvec4 planeThrough(const glm::dvec3 &point, const glm::dvec3 &normal)
{
    return glm::dvec4(normal, -glm::dot(normal, point));
}

/// How many of the pictures drew the objects.
int drawnObjects(const QSignalSpy &steps)
{
    int count = 0;
    for (const QList<QVariant> &step : steps)
        count += step.at(0).value<LifecycleEvent>().calls.contains(QStringLiteral("glDrawElements")) ? 1 : 0;
    return count;
}

int pictures(const QSignalSpy &steps)
{
    int count = 0;
    for (const QList<QVariant> &step : steps)
        count += step.at(0).value<LifecycleEvent>().kind == LifecycleEvent::Kind::OnDraw ? 1 : 0;
    return count;
}

} // namespace

class TestFrame : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyPixelIsTheSurfaceThatIsThere_data();
    void everyPixelIsTheSurfaceThatIsThere();
    void smoothEdgesMoveNoDepth_data() { addDepthRanges(); }
    void smoothEdgesMoveNoDepth();
    void smoothEdgesAreSeenInBothViews();
    void aGrabbedPictureIsSmoothInMotion();
    void theScreenShowsSmoothEdgesAtRest();
    void aWindowThatOpensIsDrawnOnce();
    void aResizedViewIsOnTheScreen();
    void aPickIsNeverOnAClippedPart_data();
    void aPickIsNeverOnAClippedPart();
    void aRemovedPlaneIsGone();
    void aRemovedPlaneIsGoneInTheObserver();
    void aPlaneIsShownAndCannotBePicked();
    void objectsAreDrawnOnceAChange();
    void theListOfObjectsMayChange();
    void theReadoutFollowsThePointer();
    void anAnswerThatIsOvertakenIsGivenOfTheNextPicture();
    void aFrameTooLargeIsRefusedAndLeavesNothingBehind();
    void aBufferTooLargeIsRefused();

private:
    static void addDepthRanges();
    std::unique_ptr<MainWindow> window(const DepthRange &range = {});
};

void TestFrame::initTestCase()
{
    redirectSettings();
    qRegisterMetaType<LifecycleEvent>();
}

std::unique_ptr<MainWindow> TestFrame::window(const DepthRange &range)
{
    auto window = shownWindow(false, {420, 360});
    window->document().setObjects(twoCubes(), kCamera);
    setDepthRange(window->document(), range);
    return window;
}

void TestFrame::addDepthRanges()
{
    QTest::addColumn<double>("atNear");
    QTest::addColumn<double>("atFar");
    QTest::newRow("whole range") << 0.0 << 1.0;
    QTest::newRow("reversed") << 1.0 << 0.0;
    QTest::newRow("the middle") << 0.2 << 0.9;
    QTest::newRow("the front") << 0.0 << 0.65;
}

void TestFrame::everyPixelIsTheSurfaceThatIsThere_data()
{
    addDepthRanges();
}

void TestFrame::everyPixelIsTheSurfaceThatIsThere()
{
    QFETCH(double, atNear);
    QFETCH(double, atFar);
    for (const bool isOrtho : {false, true}) {
        const auto window = this->window({atNear, atFar});
        if (isOrtho)
            window->document().switchProjection();
        SceneView &view = window->view();
        int background = 0;
        std::array<int, 2> seen{};
        for (int y = 3; y < view.height(); y += 17) {
            for (int x = 2; x < view.width(); x += 14) {
                window->document().clearPick();
                click(view, QPointF(x, y));
                QVERIFY(window->document().pick());
                const Pick &pick = *window->document().pick();
                const DevicePixel pixel = pixelUnder(view, QPointF(x, y));
                const guitest::Ray ray = rayThrough(window->document().geometry(), windowOf(view, pixel));
                std::optional<std::size_t> object;
                double nearest = std::numeric_limits<double>::infinity();
                for (std::size_t i = 0; i < kCenters.size(); ++i) {
                    if (const std::optional<double> at = entry(ray, kCenters[i]); at && *at < nearest) {
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
                // Sides that are seen at a slant: a 256th of a pixel beside is as far as that.
                QVERIFY(glm::length(pick.point.world[Method::Formula]->coordinates() - expected)
                        <= 40.0 * pick.certainty.halfDepthStep + 0.1 * pick.certainty.footprintWidth);
            }
        }
        QVERIFY(background > 50 && seen[0] > 20 && seen[1] > 5);
    }
}

void TestFrame::smoothEdgesMoveNoDepth()
{
    QFETCH(double, atNear);
    QFETCH(double, atFar);
    const auto window = this->window({atNear, atFar});
    SceneView &view = window->view();
    const auto depths = [&](bool smooth) {
        view.setSmoothEdges(smooth);
        (void)view.grabFramebuffer();
        std::vector<double> read;
        for (int y = 0; y < view.height(); y += 13) {
            for (int x = 0; x < view.width(); x += 11) {
                click(view, QPointF(x, y));
                read.push_back(window->document().pick()->window.z);
            }
        }
        return read;
    };
    QCOMPARE(depths(true), depths(false));
}

void TestFrame::smoothEdgesAreSeenInBothViews()
{
    const auto window = this->window();
    QAction *smooth = nullptr, *observer = nullptr;
    for (QAction *action : window->findChildren<QAction *>()) {
        if (action->text() == QStringLiteral("&Smooth Edges"))
            smooth = action;
        if (action->text() == QStringLiteral("&View from Outside"))
            observer = action;
    }
    QVERIFY(smooth && observer && !smooth->isChecked());
    window->resize(900, 420);
    observer->trigger();
    auto *outside = window->findChild<ObserverView *>();
    QVERIFY(outside);
    QVERIFY(QTest::qWaitFor([&] { return outside->width() > 200; }));
    QTest::qWait(50);
    const QImage before = window->view().grabFramebuffer(), outsideBefore = outside->grabFramebuffer();
    smooth->trigger();
    QVERIFY(window->view().grabFramebuffer() != before);
    QVERIFY(outside->grabFramebuffer() != outsideBefore);
    smooth->trigger();
    QVERIFY(window->view().grabFramebuffer() == before);
    QVERIFY(outside->grabFramebuffer() == outsideBefore);
}

/// What the screen shows of a widget, as its framebuffer would be.
QImage onScreen(const QWidget &widget)
{
    const QPoint corner = widget.mapToGlobal(QPoint(0, 0));
    return widget.screen()
        ->grabWindow(0, corner.x(), corner.y(), widget.width(), widget.height())
        .toImage()
        .convertToFormat(QImage::Format_RGB32);
}

QImage grabbed(SceneView &view)
{
    return view.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

void TestFrame::aGrabbedPictureIsSmoothInMotion()
{
    const auto window = this->window();
    SceneView &view = window->view();
    view.setSmoothEdges(true);
    QTest::qWait(300);
    const QImage atRest = grabbed(view);
    window->document().setCamera(kElsewhere);
    QVERIFY(grabbed(view) != atRest);
    window->document().setCamera(kCamera);
    QVERIFY(grabbed(view) == atRest);
}

void TestFrame::theScreenShowsSmoothEdgesAtRest()
{
    const auto window = this->window();
    SceneView &view = window->view();
    const QImage plain = grabbed(view);
    QTRY_VERIFY(onScreen(view) == plain);
    view.setSmoothEdges(true);
    const QImage smooth = grabbed(view);
    QVERIFY(smooth != plain);
    QTRY_VERIFY(onScreen(view) == smooth);
    // A picture that has just been drawn may be shown as it is; it does not stay so.
    window->document().setCamera(kElsewhere);
    window->document().setCamera(kCamera);
    QTest::qWait(40);
    QTRY_VERIFY(onScreen(view) == smooth);
}

void TestFrame::aWindowThatOpensIsDrawnOnce()
{
    MainWindow::Options options;
    options.remembers = false;
    MainWindow window(options);
    QSignalSpy steps(&window.view(), &SceneView::happened);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QTRY_VERIFY(drawnObjects(steps) > 0);
    QTest::qWait(50);
    // The window's system may lay it out once more.
    QVERIFY2(drawnObjects(steps) <= 2, qPrintable(QString::number(drawnObjects(steps))));
}

void TestFrame::aResizedViewIsOnTheScreen()
{
    const auto window = this->window();
    for (const QSize &size : {QSize(500, 300), QSize(300, 420), QSize(640, 480)}) {
        window->resize(size);
        QTRY_COMPARE(window->size(), size);
        QTest::qWait(30);
        QTRY_VERIFY(onScreen(window->view()) == grabbed(window->view()));
    }
}

void TestFrame::aPickIsNeverOnAClippedPart_data()
{
    QTest::addColumn<QList<QVector4D>>("planes");
    const auto row = [](const char *name, const std::vector<glm::dvec3> &normals) {
        QList<QVector4D> planes;
        for (const glm::dvec3 &normal : normals) {
            const glm::dvec4 p = planeThrough(kCubeCenter + glm::dvec3(0.15, -0.1, 0.2), normal);
            planes << QVector4D(float(p.x), float(p.y), float(p.z), float(p.w));
        }
        QTest::newRow(name) << planes;
    };
    row("along an axis", {{-1.0, 0.0, 0.0}});
    row("at a slant", {{-0.6, 0.3, -1.0}});
    row("of another length", {{-600.0, 300.0, -1000.0}});
    row("two", {{-1.0, 0.0, 0.0}, {0.0, -1.0, 0.1}});
    row("six",
        {{-1.0, 0.2, 0.0}, {0.0, -1.0, 0.1}, {0.1, 0.0, -1.0}, {-1.0, 0.3, 0.0}, {0.0, -1.0, 0.3}, {0.3, 0.0, -1.0}});
}

void TestFrame::aPickIsNeverOnAClippedPart()
{
    QFETCH(QList<QVector4D>, planes);
    const auto window = this->window();
    std::vector<glm::dvec4> cutting;
    for (const QVector4D &p : planes)
        cutting.emplace_back(double(p.x()), double(p.y()), double(p.z()), double(p.w()));
    setPlanes(window->document(), cutting);
    int hits = 0, cut = 0;
    for (int y = 0; y < window->view().height(); y += 12) {
        for (int x = 0; x < window->view().width(); x += 10) {
            click(window->view(), QPointF(x, y));
            const Pick &pick = *window->document().pick();
            const guitest::Ray ray = rayThrough(window->document().geometry(),
                                                windowOf(window->view(), pixelUnder(window->view(), QPointF(x, y))));
            const std::optional<double> uncut = entry(ray, kCenters[0]);
            if (!pick.hit()) {
                cut += uncut ? 1 : 0;
                continue;
            }
            ++hits;
            const glm::dvec3 point = pick.point.world[Method::Formula]->coordinates();
            for (const glm::dvec4 &plane : cutting) {
                const double distance = glm::dot(plane, glm::dvec4(point, 1.0)) / glm::length(glm::dvec3(plane));
                QVERIFY2(distance >= -pick.certainty.radius(), qPrintable(QString::number(distance)));
            }
        }
    }
    QVERIFY2(hits > 8 && cut > 5, qPrintable(QStringLiteral("%1 hits, %2 cut away").arg(hits).arg(cut)));
}

void TestFrame::aRemovedPlaneIsGone()
{
    const auto window = this->window();
    SceneDocument &document = window->document();
    const QImage before = window->view().grabFramebuffer();
    const glm::dvec4 plane = planeThrough(kCubeCenter, {-0.6, 0.3, -1.0});
    setPlanes(document, {plane});
    const QImage one = window->view().grabFramebuffer();
    QVERIFY(one != before);
    setPlanes(document, {plane, planeThrough(kCubeCenter, {-1.0, 0.0, 0.0})});
    QVERIFY(window->view().grabFramebuffer() != one);
    setPlanes(document, {plane});
    QVERIFY(window->view().grabFramebuffer() == one);
    setPlanes(document, {});
    QVERIFY(window->view().grabFramebuffer() == before);
    // Nor does it cut the next scene.
    setPlanes(document, {plane});
    (void)window->view().grabFramebuffer();
    document.setObjects(twoCubes(), kCamera);
    QVERIFY(window->view().grabFramebuffer() == before);
}

void TestFrame::aRemovedPlaneIsGoneInTheObserver()
{
    SceneDocument document;
    document.setSurface({420, 360, 1.0});
    document.setObjects(twoCubes(), kCamera);
    ObserverPanel panel(document);
    panel.resize(500, 600);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    ObserverView &view = panel.view();
    const QImage before = view.grabFramebuffer();
    setPlanes(document, {planeThrough(kCubeCenter, {-0.6, 0.3, -1.0})});
    QVERIFY(view.grabFramebuffer() != before);
    setPlanes(document, {});
    QVERIFY(view.grabFramebuffer() == before);
    // The morph cuts with all eight of OpenGL's.
    view.setMorph(1.0);
    QVERIFY(view.grabFramebuffer() != before);
    view.setMorph(0.0);
    QVERIFY(view.grabFramebuffer() == before);
}

void TestFrame::aPlaneIsShownAndCannotBePicked()
{
    const auto window = this->window();
    SceneView &view = window->view();
    const QImage before = view.grabFramebuffer();
    // It cuts nothing off the cubes and stands in front of them.
    const glm::dvec3 beside = kCubeCenter + glm::dvec3(0.0, 0.0, 1.3);
    setPlanes(window->document(), {planeThrough(beside, {0.0, 0.0, -1.0})});
    const QImage with = view.grabFramebuffer();
    const QPointF place = localOf(*window, beside + glm::dvec3(-2.2, 0.4, 0.0));
    const DevicePixel pixel = pixelUnder(view, place);
    QVERIFY(before.rect().contains(pixel.i, pixel.j));
    QVERIFY(before.pixel(pixel.i, pixel.j) != with.pixel(pixel.i, pixel.j));
    click(view, localOf(*window, beside));
    QVERIFY(window->document().pick()->hit());
    const glm::dvec3 picked = window->document().pick()->point.world[Method::Formula]->coordinates();
    QVERIFY(std::abs(picked.z - (kCubeCenter.z + 1.0)) < 0.01);
}

void TestFrame::objectsAreDrawnOnceAChange()
{
    SceneDocument document;
    document.setObjects(twoCubes(), kCamera);
    SceneView view(document);
    QSignalSpy steps(&view, &SceneView::happened);
    view.resize(400, 300);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QTRY_VERIFY(pictures(steps) > 0);
    QTest::qWait(50);
    QCOMPARE(drawnObjects(steps), 1);

    // A pick is drawn over the picture that is there; the pointer draws nothing at all.
    steps.clear();
    click(view, {200.0, 150.0});
    (void)view.grabFramebuffer();
    QVERIFY(document.pick() && document.pick()->hit());
    QVERIFY(pictures(steps) > 0);
    QCOMPARE(drawnObjects(steps), 0);
    QTest::qWait(50);
    steps.clear();
    QSignalSpy hovered(&view, &SceneView::hovered);
    for (int x = 190; x < 210; ++x)
        sendMouse(view, QEvent::MouseMove, QPointF(x, 150.0), Qt::NoButton, Qt::NoButton);
    QTRY_VERIFY(!hovered.isEmpty() && hovered.last().at(0).value<WidgetPoint>().x == 209.0);
    QCOMPARE(pictures(steps), 0);

    // A click on a picture that is not drawn yet draws it; the paint that follows does not.
    document.setCamera({WorldPoint(kCubeCenter + glm::dvec3(0.5, 0.3, 7.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
    click(view, {200.0, 150.0});
    QCOMPARE(drawnObjects(steps), 1);
    QTRY_VERIFY(pictures(steps) > 1);
    QTest::qWait(50);
    QCOMPARE(drawnObjects(steps), 1);
}

void TestFrame::theListOfObjectsMayChange()
{
    const auto window = this->window();
    SceneDocument &document = window->document();
    const QImage two = window->view().grabFramebuffer();
    SceneObject third = cubeScene().front(); // a model that no object has shown yet
    third.transform = {Translate{kCubeCenter + glm::dvec3(0.0, 2.2, 0.0)}};
    QVERIFY(document.addObjects({third}));
    const QImage three = window->view().grabFramebuffer();
    QVERIFY(three != two);
    QVERIFY(document.removeObject(0));
    (void)window->view().grabFramebuffer();
    document.undoStack().undo();
    QVERIFY(window->view().grabFramebuffer() == three);
    document.undoStack().undo();
    QVERIFY(window->view().grabFramebuffer() == two);
}

void TestFrame::theReadoutFollowsThePointer()
{
    const auto window = this->window();
    SceneView &view = window->view();
    QSignalSpy hovered(&view, &SceneView::hovered);
    const QPointF place = localOf(*window, kCubeCenter + glm::dvec3(0.2, 0.1, 1.0));
    sendMouse(view, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
    // The picture changes while the pointer waits for its answer: it is given the new one's.
    window->document().setCamera(
        {WorldPoint(kCubeCenter + glm::dvec3(0.0, 0.0, 9.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
    QTRY_VERIFY(!hovered.isEmpty());
    click(view, place);
    QCOMPARE(hovered.last().at(1).value<DepthSample>().depth, window->document().pick()->window.z);
    // Nothing is told of a pointer that has left.
    hovered.clear();
    sendMouse(view, QEvent::MouseMove, place + QPointF(3.0, 0.0), Qt::NoButton, Qt::NoButton);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&view, &leave);
    QTest::qWait(50);
    QVERIFY(hovered.isEmpty());
    // It comes back.
    sendMouse(view, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
    QTRY_COMPARE(hovered.size(), 1);
    QCOMPARE(hovered.last().at(1).value<DepthSample>().depth, window->document().pick()->window.z);
}

void TestFrame::anAnswerThatIsOvertakenIsGivenOfTheNextPicture()
{
    const auto window = this->window();
    SceneView &view = window->view();
    (void)view.grabFramebuffer(); // or the answer would be asked for later, once there is a picture
    QSignalSpy hovered(&view, &SceneView::hovered);
    const QPointF place = localOf(*window, kCubeCenter + glm::dvec3(0.2, 0.1, 1.0));
    sendMouse(view, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
    // The answer comes while the next picture is not drawn yet.
    view.setUpdatesEnabled(false);
    window->document().setCamera(kElsewhere);
    QTest::qWait(100);
    QVERIFY(hovered.isEmpty());
    view.setUpdatesEnabled(true);
    QTRY_COMPARE(hovered.size(), 1);
    click(view, place);
    QCOMPARE(hovered.last().at(1).value<DepthSample>().depth, window->document().pick()->window.z);
}

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

void TestFrame::aFrameTooLargeIsRefusedAndLeavesNothingBehind()
{
    Context gl;
    QVERIFY(gl.isCurrent);
    Frame frame;
    frame.initialize();
    QCOMPARE(frame.ids(), qEnvironmentVariable("UNPROJECTOR_OBJECT_IDS") == QStringLiteral("colors")
                              ? ObjectIds::Colors
                              : ObjectIds::Integers);
    const auto picture = [](int size) {
        Picture g;
        g.surface = {size, size, 1.0};
        g.viewport = wholeSurface(g.surface);
        return g;
    };
    QVERIFY(!frame.sample({0, 0}));
    QVERIFY(frame.begin(drawable(picture(16)).value()));
    frame.end();
    QVERIFY(frame.sample({3, 4}) && !frame.sample({3, 4})->hit());
    Drawable tooLarge; // more than any driver has, and more than drawable() lets through
    tooLarge.picture = picture(1 << 20);
    QVERIFY(!frame.begin(tooLarge));
    QVERIFY(!frame.picture() && !frame.sample({3, 4}));
    QVERIFY(frame.begin(drawable(picture(16)).value()));
    frame.end();
    QVERIFY(frame.sample({3, 4}));
    QCOMPARE(gl.context.functions()->glGetError(), GLenum(GL_NO_ERROR));
    frame.release();
}

void TestFrame::aBufferTooLargeIsRefused()
{
    Context gl;
    QVERIFY(gl.isCurrent);
    QOpenGLExtraFunctions &functions = *gl.context.extraFunctions();
    GLuint buffer = 0;
    functions.glGenBuffers(1, &buffer);
    functions.glBindBuffer(GL_ARRAY_BUFFER, buffer);
    const float data[] = {1.0f, 2.0f};
    QVERIFY(fillBuffer(functions, GL_ARRAY_BUFFER, sizeof data, data));
    QVERIFY(!fillBuffer(functions, GL_ARRAY_BUFFER, std::size_t(1) << 46, nullptr));
    functions.glDeleteBuffers(1, &buffer);
}

QTEST_MAIN(TestFrame)
#include "test_frame.moc"
