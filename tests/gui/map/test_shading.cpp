// The menu View > Shading in the window: its keys, what is kept, the light that a drag turns, the
// clip planes through picked points, and that clicks read the same with any shading.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/picking.h"
#include "tests/gui/window_user.h"

#include "core/examples/solids.h"
#include "gui/document/camera_looks.h"
#include "gui/document/clip_cuts.h"
#include "gui/document/picks.h"
#include "gui/shading/curvature_bar.h"
#include "gui/shading/light_drag.h"
#include "gui/shading/model_curvatures.h"
#include "gui/view/scene_picture.h"
#include "tests/support/mesh_model.h"
#include "tests/support/patience.h"

#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>

#include <glm/geometric.hpp>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using namespace unprojector::unproject;
using namespace guitest;

namespace {

struct Switch {
    const char *text;
    Qt::Key key;
    bool isOnAtFirst;
};
constexpr std::array<Switch, 4> kSwitches{{{"Light from the Side", Qt::Key_L, false},
                                           {"Curvature", Qt::Key_C, false},
                                           {"Colours and Textures", Qt::Key_T, true},
                                           {"Edges of Triangles", Qt::Key_W, false}}};

QAction &actionNamed(const MainWindow &window, const char *text)
{
    QAction *action = actionOf(window, QString::fromLatin1(text));
    if (!action)
        qFatal("there is no action %s", text);
    return *action;
}

/// The cubes in an active window; the view has the focus.
std::unique_ptr<MainWindow> activeWindow()
{
    auto window = twoCubesWindow();
    window->activateWindow();
    if (!QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds))
        qFatal("the window does not become active");
    window->view().setFocus();
    return window;
}

/// Everything that a click tells.
struct Told {
    std::optional<WorldPoint> formula, matrix;
    double depth = 0.0;
    std::optional<std::size_t> object;
    friend bool operator==(const Told &, const Told &) = default;
};

Told toldAt(MainWindow &window, const QPointF &local)
{
    const std::optional<PixelClick> click = window.view().clickAt({local.x(), local.y()});
    if (!click)
        qFatal("no click");
    const Result<Pick> pick = window.document().picks().unprojected(*click);
    Told told{{}, {}, click->sample.depth, click->sample.object};
    if (pick) {
        if (const auto &point = pick->point.world[Method::Formula])
            told.formula = *point;
        if (const auto &point = pick->point.world[Method::Matrix])
            told.matrix = *point;
    }
    return told;
}

std::vector<Told> toldEverywhere(MainWindow &window)
{
    std::vector<Told> all;
    for (int y = 10; y < window.view().height(); y += 23) {
        for (int x = 10; x < window.view().width(); x += 23)
            all.push_back(toldAt(window, QPointF(x, y)));
    }
    return all;
}

bool isCurvatureComputed(const MainWindow &window)
{
    return !part<ModelCurvatures>(window).isComputing();
}

/// A window with a fine ball: its curvature takes a moment.
std::unique_ptr<MainWindow> ballWindow(int subdivisions)
{
    auto window = shownWindow(false, {500, 400});
    openObjects(window->document(), {{"ball", {}, modelOf(examples::sphereMesh(1.0, subdivisions)), {}}});
    settle();
    return window;
}

double side(const glm::dvec4 &plane, const glm::dvec3 &point)
{
    return glm::dot(plane, glm::dvec4(point, 1.0)) / glm::length(glm::dvec3(plane));
}

} // namespace

class TestShading : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init() { QSettings().clear(); }

    void keysSwitch()
    {
        const auto window = activeWindow();
        for (const Switch &each : kSwitches) {
            const QAction &action = actionNamed(*window, each.text);
            QCOMPARE(action.isChecked(), each.isOnAtFirst);
            QTest::keyClick(&window->view(), each.key);
            QCOMPARE(action.isChecked(), !each.isOnAtFirst);
            QTest::keyClick(&window->view(), each.key);
            QCOMPARE(action.isChecked(), each.isOnAtFirst);
        }
        QVERIFY(!window->document().isModified()); // the scene has none of it
    }

    void clicksReadTheSame()
    {
        const auto window = twoCubesWindow();
        const std::vector<Told> before = toldEverywhere(*window);
        QVERIFY(std::any_of(before.begin(), before.end(), [](const Told &told) { return told.object == 1U; }));
        for (const Switch &each : kSwitches) {
            actionNamed(*window, each.text).trigger();
            QTRY_VERIFY_WITH_TIMEOUT(isCurvatureComputed(*window), kPatienceMilliseconds);
            settle();
            QVERIFY2(toldEverywhere(*window) == before, each.text);
        }
        for (const Switch &each : kSwitches) // with the others still on
            actionNamed(*window, each.text).trigger();
        QVERIFY(toldEverywhere(*window) == before);
    }

    void everySwitchChangesThePicture()
    {
        const auto window = twoCubesWindow();
        const QImage plain = window->view().grabFramebuffer();
        for (const Switch &each : kSwitches) {
            actionNamed(*window, each.text).trigger();
            QTRY_VERIFY_WITH_TIMEOUT(isCurvatureComputed(*window), kPatienceMilliseconds);
            QVERIFY2(differentPixels(window->view().grabFramebuffer(), plain) > 200, each.text);
            actionNamed(*window, each.text).trigger();
            QVERIFY2(window->view().grabFramebuffer() == plain, each.text);
        }
    }

    void aDragTurnsTheLight()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        click(view, QPointF(view.width() / 2.0, view.height() / 2.0));
        const auto pick = window->document().picks().pickedPoint();
        const LookAt camera = window->document().setup().camera();
        const glm::vec2 before = part<LightDrag>(*window).place();
        drag(view, QPointF(100, 200), QPointF(220, 150), Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier);
        const glm::vec2 now = part<LightDrag>(*window).place();
        const auto half = 0.5f * static_cast<float>(std::min(view.width(), view.height()));
        QVERIFY(std::abs(now.x - before.x - 120.0f / half) < 1e-3f); // it follows the pointer
        QVERIFY(now.y > before.y);
        QVERIFY(actionNamed(*window, "Light from the Side").isChecked());
        QVERIFY(window->document().setup().camera() == camera);
        QVERIFY(window->document().picks().pickedPoint() == pick);
        QVERIFY(!window->document().isModified());
        // The next drag is an ordinary one.
        drag(view, QPointF(100, 200), QPointF(220, 150), Qt::LeftButton);
        QVERIFY(part<LightDrag>(*window).place() == now);
        QVERIFY(!(window->document().setup().camera() == camera));
    }

    void escTakesTheDragBack()
    {
        const auto window = activeWindow();
        SceneView &view = window->view();
        const glm::vec2 before = part<LightDrag>(*window).place();
        const Qt::KeyboardModifiers held = Qt::ControlModifier | Qt::ShiftModifier;
        sendMouse(view, QEvent::MouseButtonPress, {100, 200}, Qt::LeftButton, Qt::LeftButton, held);
        sendMouse(view, QEvent::MouseMove, {200, 200}, Qt::NoButton, Qt::LeftButton, held);
        QVERIFY(part<LightDrag>(*window).place() != before);
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(part<LightDrag>(*window).place() == before);
        sendMouse(view, QEvent::MouseMove, {250, 200}, Qt::NoButton, Qt::LeftButton, held);
        sendMouse(view, QEvent::MouseButtonRelease, {250, 200}, Qt::LeftButton, Qt::NoButton, held);
        QVERIFY(part<LightDrag>(*window).place() == before);
    }

    void otherDragsStay()
    {
        const auto window = twoCubesWindow();
        const glm::vec2 before = part<LightDrag>(*window).place();
        for (const auto &[button, held] : {std::pair(Qt::LeftButton, Qt::KeyboardModifiers(Qt::ShiftModifier)),
                                           std::pair(Qt::LeftButton, Qt::KeyboardModifiers(Qt::ControlModifier)),
                                           std::pair(Qt::MiddleButton, Qt::ControlModifier | Qt::ShiftModifier)}) {
            const LookAt camera = window->document().setup().camera();
            drag(window->view(), QPointF(100, 200), QPointF(180, 150), button, held);
            QVERIFY(!(window->document().setup().camera() == camera));
        }
        QVERIFY(part<LightDrag>(*window).place() == before);
        QVERIFY(!actionNamed(*window, "Light from the Side").isChecked());
    }

    void theLightStaysInFront()
    {
        const auto window = twoCubesWindow();
        LightDrag &light = part<LightDrag>(*window);
        for (const glm::vec2 &place : {glm::vec2(5.0f, 0.0f), {-3.0f, 4.0f}, {0.0f, -1.0f}, {0.2f, 0.1f}}) {
            light.setPlace(place);
            QVERIFY(std::abs(glm::length(light.direction()) - 1.0f) < 1e-5f);
            QVERIFY(light.direction().z > 0.15f);
            QVERIFY(glm::dot(light.place(), place) > 0.99f * glm::length(light.place()) * glm::length(place));
        }
        const glm::vec2 last = light.place();
        light.setPlace({std::numeric_limits<float>::quiet_NaN(), 0.0f});
        QVERIFY(light.place() == last);
    }

    void choicesLast()
    {
        glm::vec2 place;
        {
            const auto window = windowOfSize({900, 700}, true);
            for (const Switch &each : kSwitches)
                actionNamed(*window, each.text).trigger();
            part<LightDrag>(*window).setPlace({0.3f, 0.5f});
            place = part<LightDrag>(*window).place();
            QVERIFY(window->close());
        }
        {
            const auto window = windowOfSize({900, 700}, true);
            for (const Switch &each : kSwitches)
                QCOMPARE(actionNamed(*window, each.text).isChecked(), !each.isOnAtFirst);
            QVERIFY(glm::distance(part<LightDrag>(*window).place(), place) < 1e-6f);
            QTRY_VERIFY_WITH_TIMEOUT(isCurvatureComputed(*window), kPatienceMilliseconds);
            QVERIFY(!part<ModelCurvatures>(*window).all().empty());
        }
        QSettings().setValue(QStringLiteral("shading/light"), QStringLiteral("nonsense"));
        const auto window = windowOfSize({900, 700}, true);
        QVERIFY(glm::length(part<LightDrag>(*window).direction()) > 0.99f);
    }

    void theCurvatureFollowsTheScene()
    {
        const auto window = ballWindow(4);
        ModelCurvatures &curvatures = part<ModelCurvatures>(*window);
        QVERIFY(curvatures.all().empty()); // none is computed before it is wanted
        actionNamed(*window, "Curvature").trigger();
        QTRY_COMPARE_WITH_TIMEOUT(curvatures.all().size(), std::size_t{1}, kPatienceMilliseconds);
        // The next scan of a series.
        const auto next = modelOf(examples::torusMesh(1.0, 0.3, 60, 30));
        openObjects(window->document(), {{"next", {}, next, {}}});
        QTRY_VERIFY_WITH_TIMEOUT(curvatures.all().contains(next), kPatienceMilliseconds);
        QVERIFY(actionNamed(*window, "Curvature").isChecked());
        actionNamed(*window, "Curvature").trigger();
        openObjects(window->document(), {{"other", {}, modelOf(examples::sphereMesh(1.0, 2)), {}}});
        settle();
        QVERIFY(!curvatures.isComputing());
    }

    void theCurvatureIsExplained()
    {
        const auto window = ballWindow(4);
        actionNamed(*window, "Curvature").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(window->statusBar()->currentMessage().startsWith(QStringLiteral("Ridges are light")),
                                 kPatienceMilliseconds);
        actionNamed(*window, "Curvature").trigger();
        window->statusBar()->clearMessage();
        actionNamed(*window, "Curvature").trigger(); // it is there already
        QVERIFY(window->statusBar()->currentMessage().startsWith(QStringLiteral("Ridges are light")));
        Mesh points;
        points.kind = Mesh::Kind::Points;
        points.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        openObjects(window->document(), {{"points", {}, modelOf(points), {}}});
        actionNamed(*window, "Curvature").trigger();
        actionNamed(*window, "Curvature").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(window->statusBar()->currentMessage().startsWith(QStringLiteral("No object")),
                                 kPatienceMilliseconds);
    }

    void theCurvatureCanBeCancelled()
    {
        const auto window = ballWindow(8); // 1.3 million triangles
        CurvatureBar &bar = part<CurvatureBar>(*window);
        QVERIFY(bar.isHidden());
        actionNamed(*window, "Curvature").trigger();
        QVERIFY(part<ModelCurvatures>(*window).isComputing());
        QSignalSpy progressed(&part<ModelCurvatures>(*window), &ModelCurvatures::progressed);
        QTRY_VERIFY_WITH_TIMEOUT(!progressed.isEmpty(), kPatienceMilliseconds);
        bar.findChild<QPushButton *>()->click();
        QVERIFY(!part<ModelCurvatures>(*window).isComputing());
        QVERIFY(bar.isHidden());
        QVERIFY(!actionNamed(*window, "Curvature").isChecked());
        QVERIFY(window->statusBar()->currentMessage().contains(QStringLiteral("cancelled")));
        actionNamed(*window, "Curvature").trigger(); // again, to the end
        QTRY_VERIFY_WITH_TIMEOUT(!part<ModelCurvatures>(*window).all().empty(), kPatienceMilliseconds);
        QTRY_VERIFY_WITH_TIMEOUT(isCurvatureComputed(*window), kPatienceMilliseconds); // of the stand-in, too
        QVERIFY(bar.isHidden());
    }

    void exportedPicturesFollow()
    {
        const auto window = twoCubesWindow();
        PictureOptions options{window->document().setup().surface, {false, false, false, false, false, false}};
        const QImage plain = scenePicture(window->view(), options).value();
        for (const Switch &each : kSwitches) {
            actionNamed(*window, each.text).trigger();
            QTRY_VERIFY_WITH_TIMEOUT(isCurvatureComputed(*window), kPatienceMilliseconds);
            QVERIFY2(differentPixels(scenePicture(window->view(), options).value(), plain) > 200, each.text);
            actionNamed(*window, each.text).trigger();
            QVERIFY2(scenePicture(window->view(), options).value() == plain, each.text);
        }
    }

    void aPlaneCutsAtThePick()
    {
        const auto window = activeWindow();
        SceneDocument &document = window->document();
        QTest::keyClick(&window->view(), Qt::Key_C, Qt::ShiftModifier);
        QVERIFY(document.scene().clipPlanes.empty());
        QVERIFY(window->statusBar()->currentMessage().startsWith(QStringLiteral("Click a point")));
        click(window->view(), localOf(*window, kCubeCenter + glm::dvec3(0.3, 0.2, 1.0)));
        const glm::dvec3 picked = document.picks().pickedPoint().value().coordinates();
        QTest::keyClick(&window->view(), Qt::Key_C, Qt::ShiftModifier);
        QCOMPARE(document.scene().clipPlanes.size(), std::size_t{1});
        const glm::dvec4 plane = document.scene().clipPlanes[0];
        QVERIFY(std::abs(side(plane, picked)) < 1e-12);
        const LookAt &camera = document.setup().camera();
        QVERIFY(glm::distance(glm::normalize(glm::dvec3(plane)), forwardOf(camera)) < 1e-12);
        QVERIFY(side(plane, camera.eye.coordinates()) < 0.0); // what is in front is cut away
        document.undoStack().undo();
        QVERIFY(document.scene().clipPlanes.empty());
    }

    void aPlaneCutsThroughTwoPicks_data()
    {
        addColumn<bool>("isOrtho");
        newRow("perspective") << false;
        newRow("orthographic") << true;
    }

    void aPlaneCutsThroughTwoPicks()
    {
        QFETCH(bool, isOrtho);
        const auto window = cubeWindow(isOrtho);
        SceneDocument &document = window->document();
        QAction &cut = actionNamed(*window, "Clip Through the Last Two Picks");
        cut.trigger();
        QVERIFY(window->statusBar()->currentMessage().startsWith(QStringLiteral("Click two points")));
        std::vector<glm::dvec3> picked;
        for (const glm::dvec3 &way :
             {glm::dvec3(-0.7, 0.8, 1.0), glm::dvec3(-0.4, -0.6, 1.0), glm::dvec3(0.1, 0.5, 1.0)}) {
            click(window->view(), localOf(*window, kCubeCenter + way));
            picked.push_back(document.picks().pickedPoint().value().coordinates());
        }
        cut.trigger();
        QCOMPARE(document.scene().clipPlanes.size(), std::size_t{1});
        const glm::dvec4 plane = document.scene().clipPlanes[0];
        QVERIFY(std::abs(side(plane, picked[1])) < 1e-9 && std::abs(side(plane, picked[2])) < 1e-9);
        QVERIFY(std::abs(side(plane, picked[0])) > 0.1);
        // A line in the view: it contains the way to the eye.
        const LookAt &camera = document.setup().camera();
        if (isOrtho)
            QVERIFY(std::abs(glm::dot(glm::dvec3(plane), forwardOf(camera))) < 1e-9);
        else
            QVERIFY(std::abs(side(plane, camera.eye.coordinates())) < 1e-9);
        QVERIFY(side(plane, kCubeCenter) > 0.0); // the larger part stays
        document.undoStack().undo();
        QVERIFY(document.scene().clipPlanes.empty());
    }

    void cutsAreFlippedAndRemoved()
    {
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        QAction &flip = actionNamed(*window, "Flip the Last Clip Plane"),
                &remove = actionNamed(*window, "Remove the Last Clip Plane");
        QVERIFY(!flip.isEnabled() && !remove.isEnabled());
        const glm::dvec4 first(0.0, 1.0, 0.0, 5.0), last(1.0, 0.0, 0.0, -3.0);
        setClipPlanes(document, {first, last});
        QVERIFY(flip.isEnabled() && remove.isEnabled());
        flip.trigger();
        QVERIFY((document.scene().clipPlanes == std::vector<glm::dvec4>{first, -last}));
        document.undoStack().undo();
        QVERIFY((document.scene().clipPlanes == std::vector<glm::dvec4>{first, last}));
        remove.trigger();
        QVERIFY((document.scene().clipPlanes == std::vector<glm::dvec4>{first}));
        remove.trigger();
        QVERIFY(document.scene().clipPlanes.empty() && !remove.isEnabled());
        document.undoStack().undo();
        QVERIFY(remove.isEnabled());
    }

    void switchedOffPlanesKeepTheirPlace()
    {
        SceneDocument document;
        openObjects(document, cubeScene());
        const glm::dvec4 a(1, 0, 0, 9), b(0, 1, 0, 9), c(0, 0, 1, 9), off(1, 1, 0, 9);
        const auto withOff = [&](std::vector<std::size_t> indices, std::vector<glm::dvec4> cutting) {
            static_cast<void>(document.edit({QStringLiteral("planes")}, [&](Scene &scene) {
                scene.clipPlanes = std::move(cutting);
                scene.clipPlanesOff.clear();
                for (const std::size_t index : indices)
                    scene.clipPlanesOff.push_back({index, off});
            }));
        };
        // In the list: a, off, b, off, off. Without b: a, off, off, off.
        withOff({1, 3, 4}, {a, b});
        QVERIFY(removeLastCut(document));
        QVERIFY(document.scene().clipPlanes == std::vector<glm::dvec4>{a});
        std::vector<std::size_t> indices;
        for (const ClipPlaneOff &each : document.scene().clipPlanesOff)
            indices.push_back(each.index);
        QVERIFY((indices == std::vector<std::size_t>{1, 2, 3}));
        withOff({0}, {a, b, c});
        QVERIFY(removeLastCut(document));
        QCOMPARE(document.scene().clipPlanesOff[0].index, std::size_t{0});
        withOff({0}, {});
        QVERIFY(!removeLastCut(document) && !flipLastCut(document));
    }

    void whatCannotBeCutIsTold()
    {
        SceneDocument document;
        openObjects(document, cubeScene());
        document.setSurface({400, 300, 1.0});
        const glm::dvec3 eye = document.setup().camera().eye.coordinates();
        const glm::dvec3 a = kCubeCenter, b = eye + 0.5 * (a - eye);
        QVERIFY(cutAlongView(document, WorldPoint(a), WorldPoint(b)) == CutFault::NoDirection);
        QVERIFY(cutAlongView(document, WorldPoint(a), WorldPoint(a)) == CutFault::NoDirection);
        for (std::size_t i = 0; i < kMostClipPlanes; ++i)
            QVERIFY(cutAcrossView(document, WorldPoint(a)) == CutFault::None);
        QVERIFY(cutAcrossView(document, WorldPoint(a)) == CutFault::TooMany);
        QVERIFY(cutAlongView(document, WorldPoint(a), WorldPoint(a + glm::dvec3(1, 0, 0))) == CutFault::TooMany);
        QCOMPARE(document.scene().clipPlanes.size(), kMostClipPlanes);
    }
};

UNPROJECTOR_TEST(TestShading, display)
#include "test_shading.moc"
