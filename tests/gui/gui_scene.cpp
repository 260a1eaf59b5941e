#include "tests/gui/gui_scene.h"

#include "core/examples/solids.h"
#include "gui/document/camera_looks.h"
#include "tests/support/mesh_model.h"
#include "tests/support/patience.h"

#include "tests/gui/document_edits.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QAbstractProxyModel>
#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QWheelEvent>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace guitest {
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::mesh;
using namespace unprojector::scene;

void redirectSettings()
{
    static QTemporaryDir folder;
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("UnprojectorTests"));
    QCoreApplication::setApplicationName(QStringLiteral("UnprojectorTests"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    QSettings::setPath(QSettings::IniFormat, QSettings::SystemScope, folder.path());
}

// ---- models ----------------------------------------------------------------------------------

namespace {

/// From when a view is first on the screen, its model, and the one that it is made from, must tell every
/// change as Qt asks of models.
class ModelsAreTested : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *object, QEvent *event) override
    {
        if (const auto *view = event->type() == QEvent::Show ? qobject_cast<QAbstractItemView *>(object) : nullptr) {
            const auto *proxy = qobject_cast<QAbstractProxyModel *>(view->model());
            QAbstractItemModel *own = proxy ? proxy->sourceModel() : view->model();
            if (own && QByteArray(own->metaObject()->className()).startsWith("unprojector::")) {
                attach(own);
                attach(view->model());
            }
        }
        return QObject::eventFilter(object, event);
    }

private:
    using Tester = QAbstractItemModelTester;

    static void attach(QAbstractItemModel *model)
    {
        constexpr int kMostRows = 100; // it looks at all of them at each change
        if (model->rowCount() > kMostRows || model->findChild<Tester *>({}, Qt::FindDirectChildrenOnly))
            return;
        auto *tester = new Tester(model, Tester::FailureReportingMode::QtTest, model);
        const auto detach = [model, tester] {
            if (model->rowCount() > kMostRows)
                tester->deleteLater();
        };
        connect(model, &QAbstractItemModel::rowsInserted, tester, detach);
        connect(model, &QAbstractItemModel::modelReset, tester, detach);
    }
};

void testModels()
{
    qApp->installEventFilter(new ModelsAreTested(qApp));
}

} // namespace

Q_COREAPP_STARTUP_FUNCTION(testModels)

// ---- scenes ----------------------------------------------------------------------------------

const std::array<Face, 6> &cubeFaces()
{
    static const std::array<Face, 6> faces{{
        {"+x, red", {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {230, 0, 0}},
        {"-x, cyan", {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0, 200, 200}},
        {"+y, green", {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0, 200, 0}},
        {"-y, magenta", {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}, {200, 0, 200}},
        {"+z, blue", {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0, 0, 230}},
        {"-z, yellow", {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}, {200, 200, 0}},
    }};
    return faces;
}

std::vector<SceneObject> cubeScene()
{
    Mesh mesh = examples::cubeMesh(2.0);
    mesh.baseColor = glm::vec4(1.0f);
    for (const Face &face : cubeFaces())
        mesh.colors.insert(mesh.colors.end(), examples::kVerticesPerCubeFace, glm::u8vec4(face.color, 255));
    return {{"cube", {}, modelOf(std::move(mesh)), {Translate{kCubeCenter}}}};
}

std::vector<SceneObject> twoCubes()
{
    std::vector<SceneObject> cubes = cubeScene();
    cubes.push_back(cubes.front());
    cubes.back().transform = {Translate{kTwoCubeCenters[1]}};
    return cubes;
}

int faceOfColor(const QColor &color)
{
    const glm::dvec3 seen = glm::dvec3(color.redF(), color.greenF(), color.blueF());
    int best = -1;
    double bestDistance = 0.25;
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 pure = glm::normalize(glm::dvec3(cubeFaces()[static_cast<std::size_t>(i)].color));
        const double distance = glm::length(glm::normalize(seen) - pure);
        if (distance < bestDistance) {
            best = i;
            bestDistance = distance;
        }
    }
    return best;
}

std::vector<SceneObject> planeScene(const glm::dvec3 &center, const glm::dvec3 &halfEdge,
                                    const glm::dvec3 &otherHalfEdge)
{
    Mesh mesh;
    // Small numbers about the origin: single precision must not bend the plane.
    for (const auto &[s, t] :
         {std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(1.0, 1.0), std::pair(-1.0, 1.0)}) {
        mesh.positions.push_back(glm::vec3(s * halfEdge + t * otherHalfEdge));
        mesh.normals.push_back(glm::vec3(glm::normalize(glm::cross(halfEdge, otherHalfEdge))));
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return {{"plane", {}, modelOf(std::move(mesh)), {Translate{center}}}};
}

void setClipPlanes(SceneDocument &document, const std::vector<glm::dvec4> &planes)
{
    QVERIFY(editClipPlanes(document, planes, {}, {QStringLiteral("Planes")}));
}

void setDepthRange(SceneDocument &document, const DepthRange &range)
{
    QVERIFY(editViewport(document, document.scene().viewport, range, {QStringLiteral("Depth range")}));
}

// ---- pictures --------------------------------------------------------------------------------

int differentPixels(const QImage &a, const QImage &b)
{
    if (a.size() != b.size())
        return a.width() * a.height();
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue()) > 24;
        }
    }
    return count;
}

// ---- windows ---------------------------------------------------------------------------------

void enter(MainWindow &window, const char *name)
{
    window.workspaces().enter(*lessons::workspaceOf(name));
}

Panel panelNamed(const QString &name)
{
    return *lessons::panelOf(name.toStdString());
}

void bringUp(MainWindow &window)
{
    window.show();
    if (!QTest::qWaitForWindowExposed(&window, kPatienceMilliseconds)
        || !QTest::qWaitFor([&] { return window.view().isReady(); }, kPatienceMilliseconds))
        qFatal("the window does not come up");
}

std::unique_ptr<MainWindow> shownWindow(bool smoothEdges, const QSize &size, bool withDock)
{
    MainWindow::Options options;
    options.smoothEdges = smoothEdges;
    options.remembers = false;
    auto window = std::make_unique<MainWindow>(options);
    if (!withDock)
        window->workspaces().hidePanels(true);
    window->resize(size);
    window->move(0, 0);
    bringUp(*window);
    if (!resized(*window, size))
        qFatal("the window does not have the size that is asked for");
    return window;
}

std::unique_ptr<MainWindow> cubeWindow(bool isOrtho)
{
    auto window = shownWindow(false, {500, 400});
    openObjects(window->document(), cubeScene());
    setCamera(window->document(),
              {WorldPoint(kCubeCenter + glm::dvec3(4.0, 3.0, 5.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
    if (isOrtho)
        switchProjection(window->document());
    return window;
}

std::unique_ptr<MainWindow> twoCubesWindow(const DepthRange &range)
{
    auto window = shownWindow(false, {420, 360});
    openObjects(window->document(), twoCubes(), kBeforeTwoCubes);
    setDepthRange(window->document(), range);
    return window;
}

void settle(int milliseconds)
{
    constexpr int kRounds = 3; // events cause further events
    for (int round = 0; round < kRounds; ++round) {
        QTest::qWait(milliseconds / kRounds);
        QGuiApplication::sync();
        QCoreApplication::processEvents();
    }
}

bool resized(MainWindow &window, const QSize &size)
{
    window.resize(size);
    const bool has = QTest::qWaitFor([&] { return window.size() == size; }, kPatienceMilliseconds);
    settle(30);
    (void)window.view().grabFramebuffer();
    return has;
}

// ---- positions -------------------------------------------------------------------------------

DevicePixel pixelUnder(const SceneView &view, const QPointF &local)
{
    const double ratio = view.devicePixelRatio();
    const QPoint corner = view.mapTo(view.window(), QPoint(0, 0));
    const auto pixel = [ratio](double position, int origin, int logicalSize) {
        // A device pixel comes as a quotient by the ratio, whose product may fall just short of it.
        const double pointer = std::floor((position + origin) * ratio + 1e-6);
        const int inView = static_cast<int>(pointer - std::floor(origin * ratio + 0.5));
        // The view's corner is rounded to whole pixels, which can carry its rim a pixel out.
        return std::clamp(inView, 0, static_cast<int>(std::floor(logicalSize * ratio + 0.5)) - 1);
    };
    return {pixel(local.x(), corner.x(), view.width()), pixel(local.y(), corner.y(), view.height())};
}

glm::dvec2 windowOf(const SceneView &view, const DevicePixel &pixel)
{
    const double heightPixels = std::floor(view.height() * view.devicePixelRatio() + 0.5);
    return {pixel.i + 0.5, heightPixels - pixel.j - 0.5};
}

glm::dvec2 placeOf(const MainWindow &window, const glm::dvec3 &world)
{
    const Result<WindowPoint> point =
        windowFromWorld(const_cast<MainWindow &>(window).document().setup(), WorldPoint(world));
    return point ? glm::dvec2(point->x, point->y) : glm::dvec2(std::nan(""));
}

QPointF localOf(const MainWindow &window, const glm::dvec3 &world)
{
    SceneView &view = const_cast<MainWindow &>(window).view();
    const Setup &g = const_cast<MainWindow &>(window).document().setup();
    const glm::dvec2 place = placeOf(window, world);
    const WidgetPoint widget =
        widgetFromDevice(g.surface, deviceFromWindow(g.surface, WindowPoint(place.x, place.y, 0.0)));
    // The view's picture starts at a whole device pixel, its logical corner need not.
    const double ratio = view.devicePixelRatio();
    const QPoint corner = view.mapTo(view.window(), QPoint(0, 0));
    const auto composed = [ratio](int origin) { return std::floor(origin * ratio + 0.5) / ratio - origin; };
    return {widget.x + composed(corner.x()), widget.y + composed(corner.y())};
}

// ---- mouse -----------------------------------------------------------------------------------

void sendMouse(SceneView &view, QEvent::Type type, const QPointF &local, Qt::MouseButton button,
               Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers)
{
    QMouseEvent event(type, local, view.mapTo(view.window(), local), view.mapToGlobal(local), button, buttons,
                      modifiers);
    QCoreApplication::sendEvent(&view, &event);
}

void click(SceneView &view, const QPointF &local)
{
    sendMouse(view, QEvent::MouseButtonPress, local, Qt::LeftButton, Qt::LeftButton);
    sendMouse(view, QEvent::MouseButtonRelease, local, Qt::LeftButton, Qt::NoButton);
}

void drag(SceneView &view, const QPointF &from, const QPointF &to, Qt::MouseButton button,
          Qt::KeyboardModifiers modifiers)
{
    sendMouse(view, QEvent::MouseButtonPress, from, button, button, modifiers);
    constexpr int kSteps = 5;
    for (int step = 1; step <= kSteps; ++step)
        sendMouse(view, QEvent::MouseMove, from + (to - from) * step / kSteps, Qt::NoButton, button, modifiers);
    sendMouse(view, QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
}

void turnWheel(SceneView &view, const QPointF &local, int notches)
{
    QWheelEvent event(local, view.mapToGlobal(local), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &event);
}

// ---- rays by hand ----------------------------------------------------------------------------

glm::dvec3 forwardOf(const LookAt &camera)
{
    return glm::normalize(camera.center.coordinates() - camera.eye.coordinates());
}

double distanceOf(const LookAt &camera, const glm::dvec3 &world)
{
    return glm::dot(world - camera.eye.coordinates(), forwardOf(camera));
}

Ray rayThrough(const Setup &g, const glm::dvec2 &window)
{
    const glm::dvec3 f = forwardOf(g.camera());
    const glm::dvec3 s = glm::normalize(glm::cross(f, g.camera().up.coordinates()));
    const glm::dvec3 u = glm::cross(s, f);
    const auto inWindow = [&](double left, double right, double bottom, double top) {
        return glm::dvec2(left + (right - left) * (window.x - g.viewport.x) / g.viewport.width,
                          bottom + (top - bottom) * (window.y - g.viewport.y) / g.viewport.height);
    };
    const glm::dvec3 eye = g.camera().eye.coordinates();
    if (const auto *p = std::get_if<Frustum>(&g.projection())) {
        const glm::dvec2 at = inWindow(p->left, p->right, p->bottom, p->top) / p->nearDistance;
        return {eye, f + at.x * s + at.y * u};
    }
    if (const auto *p = std::get_if<Ortho>(&g.projection())) {
        const glm::dvec2 at = inWindow(p->left, p->right, p->bottom, p->top);
        return {eye + at.x * s + at.y * u, f};
    }
    if (const auto *p = std::get_if<Perspective>(&g.projection())) {
        const double top = std::tan(p->verticalFov.radians.value / 2.0), right = top * p->aspect.value;
        const glm::dvec2 at = inWindow(-right, right, -top, top);
        return {eye, f + at.x * s + at.y * u};
    }
    const auto &p = std::get<Oblique>(g.projection());
    const glm::dvec2 at = inWindow(p.box.left, p.box.right, p.box.bottom, p.box.top);
    return {eye + at.x * s + at.y * u, f + s / std::tan(p.theta.radians.value) + u / std::tan(p.phi.radians.value)};
}

glm::dvec3 onPlane(const Ray &ray, const glm::dvec3 &point, const glm::dvec3 &normal)
{
    return ray.origin + ray.direction * (glm::dot(point - ray.origin, normal) / glm::dot(ray.direction, normal));
}

} // namespace guitest
