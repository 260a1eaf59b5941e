// The hit of a pick's ray: in the scene as of the click, after any change of the scene, and
// whenever the models are ready. No window.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/told_changes.h"

#include "core/examples/solids.h"
#include "core/ray/drawn_surface.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "tests/support/mesh_model.h"
#include "tests/support/patience.h"

#include <QSignalSpy>

#include <functional>
#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace documenttest;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

using Happening = std::function<void(SceneDocument &)>;

/// Opens three cubes of edge 2 behind each other, "front", "middle" and "back", seen along -z from
/// (0, 0, 12): their fronts are at z = 1, -4 and -9.
void openCubes(SceneDocument &document)
{
    const auto cube = modelOf(examples::cubeMesh(2.0));
    document.setSurface({400, 300, 1.0});
    Scene scene;
    scene.camera = scene.home = {WorldPoint(0, 0, 12), WorldPoint(0, 0, 0), {0, 1, 0}};
    scene.projection = Ortho{-4, 4, -3, 3, 1, 40};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    scene.objects = {{"front", {}, cube, {}},
                     {"middle", {}, cube, {Translate{{0, 0, -5}}}},
                     {"back", {}, cube, {Translate{{0, 0, -10}}}}};
    QVERIFY(document.open(scene));
}

/// The pixel (220, 140), whose centre is at (0.41, 0.19) in the world.
const WidgetPoint kInCube(220.0, 140.0);

void pickCube(SceneDocument &document, std::size_t object = 0)
{
    pickAt(document, kInCube, {0.3, object, 24});
}

/// The hit as "front 1": the object's current name and z.
QString met(const SceneDocument &document)
{
    const PickedRay *ray = document.picks().pickedRay();
    if (!ray)
        return QStringLiteral("no pick");
    if (ray->state == PickedRay::State::Preparing)
        return QStringLiteral("preparing");
    if (ray->state == PickedRay::State::Impossible)
        return QStringLiteral("impossible");
    if (!ray->met)
        return QStringLiteral("nothing");
    const QString name = ray->met->object ? QString::fromStdString(document.objects()[*ray->met->object].name)
                                          : QStringLiteral("removed");
    return QStringLiteral("%1 %2").arg(name).arg(ray->met->hit.world.z, 0, 'g', 10);
}

} // namespace

Q_DECLARE_METATYPE(Happening)

class TestPickedRay : public QObject {
    Q_OBJECT

private slots:
    void theRayMeetsWhatIsShown_data()
    {
        addColumn<Happening>("before");
        addColumn<QString>("expected");
        const auto row = [](const char *name, const Happening &before, const char *expected) {
            newRow(name) << before << QString::fromLatin1(expected);
        };
        row(
            "the first", [](SceneDocument &) {}, "front 1");
        row(
            "not what is hidden", [](SceneDocument &d) { QVERIFY(setObjectHidden(d, 0, true)); }, "middle -4");
        row(
            "not what is cut away",
            [](SceneDocument &d) {
                QVERIFY(editClipPlanes(d, {{0.0, 0.0, -1.0, 0.5}}, {}, kLabel));
            },
            "front -1");
        row(
            "what a plane that is off would cut",
            [](SceneDocument &d) {
                QVERIFY(editClipPlanes(d, {}, {{0, {0.0, 0.0, -1.0, 0.5}}}, kLabel));
            },
            "front 1");
        row(
            "not what is before the near plane",
            [](SceneDocument &d) {
                QVERIFY(editProjection(d, {Ortho{-4, 4, -3, 3, 14, 40}, false, false}, kLabel));
            },
            "middle -4");
        row(
            "nothing there",
            [](SceneDocument &d) {
                for (const std::size_t index : {0, 1, 2})
                    QVERIFY(setObjectHidden(d, index, true));
            },
            "nothing");
        row(
            "where it stands",
            [](SceneDocument &d) {
                QVERIFY(editTransform(d, 0, {Translate{{0, 0, 3}}}, kLabel));
            },
            "front 4");
    }

    void theRayMeetsWhatIsShown()
    {
        QFETCH(Happening, before);
        QFETCH(QString, expected);
        SceneDocument document;
        openCubes(document);
        before(document);
        QCOMPARE(met(document), QStringLiteral("no pick"));
        Told told(document);
        pickCube(document);
        QCOMPARE(met(document), expected);
        QCOMPARE(told.count(), std::size_t(1));
        if (const auto &place = document.picks().pickedRay()->met) {
            // Expected by hand: pixels are 0.02 wide, y points up.
            QVERIFY(std::abs(place->hit.world.x - (-4.0 + 220.5 * 0.02)) < 1e-14);
            QVERIFY(std::abs(place->hit.world.y - (3.0 - 140.5 * 0.02)) < 1e-14);
            QVERIFY(place->hit.triangle && std::abs(std::abs(place->hit.triangle->normal.z) - 1.0) < 1e-15);
        }
    }

    void theAnswerIsThatOfTheClick_data()
    {
        addColumn<Happening>("since");
        addColumn<QString>("expected");
        const auto row = [](const char *name, const Happening &since, const char *expected) {
            newRow(name) << since << QString::fromLatin1(expected);
        };
        row(
            "another view", [](SceneDocument &d) { setCamera(d, cameraAt(30.0)); }, "front 1");
        row(
            "hidden", [](SceneDocument &d) { QVERIFY(setObjectHidden(d, 0, true)); }, "front 1");
        row(
            "moved",
            [](SceneDocument &d) {
                QVERIFY(editTransform(d, 0, {Translate{{0, 0, 3}}}, kLabel));
            },
            "front 1");
        row(
            "cut away",
            [](SceneDocument &d) {
                QVERIFY(editClipPlanes(d, {{0.0, 0.0, -1.0, 0.5}}, {}, kLabel));
            },
            "front 1");
        row(
            "another name",
            [](SceneDocument &d) { QCOMPARE(renameObject(d, 0, QStringLiteral("new")), NameFault::None); }, "new 1");
        row(
            "another order", [](SceneDocument &d) { QVERIFY(moveObject(d, 0, 2)); }, "front 1");
        row(
            "added to", [](SceneDocument &d) { QVERIFY(addObjects(d, {d.objects()[2]})); }, "front 1");
        row(
            "another one removed", [](SceneDocument &d) { QVERIFY(removeObject(d, 1)); }, "front 1");
        row(
            "removed", [](SceneDocument &d) { QVERIFY(removeObject(d, 0)); }, "no pick");
        row(
            "removed and back",
            [](SceneDocument &d) {
                QVERIFY(moveObject(d, 0, 1));
                QVERIFY(removeObject(d, 1));
                d.undoStack().undo();
            },
            "front 1");
        row(
            "another scene", [](SceneDocument &d) { openCubes(d); }, "no pick");
    }

    void theAnswerIsThatOfTheClick()
    {
        QFETCH(Happening, since);
        QFETCH(QString, expected);
        SceneDocument document;
        openCubes(document);
        pickCube(document);
        since(document);
        QCOMPARE(met(document), expected);
        if (expected == QStringLiteral("no pick"))
            return;
        while (document.undoStack().canUndo())
            document.undoStack().undo();
        QCOMPARE(met(document), QStringLiteral("front 1"));
    }

    void anEarlierPickHasItsAnswer()
    {
        SceneDocument document;
        openCubes(document);
        pickCube(document);
        const KeptPick kept = document.picks().keptPick();
        pickAt(document, WidgetPoint(1.0, 1.0), {1.0, {}, 24});
        QCOMPARE(met(document), QStringLiteral("nothing"));
        document.picks().putBack(kept);
        QCOMPARE(met(document), QStringLiteral("front 1"));
    }

    void theAnswerComesWhenTheModelIsReady_data()
    {
        addColumn<Happening>("meanwhile");
        addColumn<QString>("expected");
        const auto row = [](const char *name, const Happening &meanwhile, const char *expected) {
            newRow(name) << meanwhile << QString::fromLatin1(expected);
        };
        row(
            "nothing happens", [](SceneDocument &) {}, "ball 1");
        row(
            "another view", [](SceneDocument &d) { setCamera(d, cameraAt(30.0)); }, "ball 1");
        row(
            "the ball is hidden", [](SceneDocument &d) { QVERIFY(setObjectHidden(d, 3, true)); }, "ball 1");
        row(
            "the ball is moved",
            [](SceneDocument &d) {
                QVERIFY(editTransform(d, 3, {Translate{{0, 1, 0}}}, kLabel));
            },
            "ball 1");
        row(
            "the order is another", [](SceneDocument &d) { QVERIFY(moveObject(d, 3, 0)); }, "ball 1");
        row(
            "the ball is removed and comes back",
            [](SceneDocument &d) {
                QVERIFY(removeObject(d, 3));
                QTest::qWait(5);
                d.undoStack().undo();
            },
            "ball 1");
    }

    void theAnswerComesWhenTheModelIsReady()
    {
        QFETCH(Happening, meanwhile);
        QFETCH(QString, expected);
        SceneDocument document;
        openCubes(document);
        // The ball has 327,680 triangles, with a vertex at z = 1.
        QVERIFY(addObjects(document, {{"ball", {}, modelOf(examples::sphereMesh(1.0, 7)), {}}}));
        QVERIFY(setObjectHidden(document, 0, true));
        QVERIFY(document.picks().rayCasters().isPreparing());
        pickAt(document, WidgetPoint(199.5, 149.5), {0.3, 3, 24}); // the pixel at (-0.01, 0.01)
        QCOMPARE(met(document), QStringLiteral("preparing"));
        Told told(document);
        meanwhile(document);
        QVERIFY(QTest::qWaitFor([&] { return document.picks().pickedRay()->state == PickedRay::State::Answered; },
                                kPatienceMilliseconds));
        QVERIFY(told.all() & Change::Ray);
        const auto &place = document.picks().pickedRay()->met;
        QVERIFY(place && place->object == document.picks().pick()->object);
        QCOMPARE(QString::fromStdString(document.objects()[*place->object].name), QStringLiteral("ball"));
        QVERIFY(std::abs(glm::length(place->hit.world.coordinates()) - 1.0) < 1e-4);
        QVERIFY(place->hit.world.z > 0.99);
    }

    void aSceneThatIsLeftIsNotKept()
    {
        SceneDocument document;
        openCubes(document);
        auto model = modelOf(examples::sphereMesh(1.0, 7));
        const std::weak_ptr<const Model> weak = model;
        QVERIFY(addObjects(document, {{"ball", {}, std::move(model), {}}}));
        pickAt(document, WidgetPoint(199.5, 149.5), {0.3, 3, 24});
        openCubes(document);
        QVERIFY(QTest::qWaitFor([&] { return weak.expired(); }, kPatienceMilliseconds));
    }

    void itsTriangleSaysHowSureThePointIs_data()
    {
        addColumn<double>("depth");
        addColumn<int>("object");
        addColumn<bool>("isKnown");
        constexpr double kFront = 10.0 / 39.0;
        newRow("the triangle was drawn") << kFront << 0 << true;
        newRow("another part of its object was drawn") << 0.3 << 0 << false;
        newRow("another object was drawn") << kFront << 1 << false;
    }

    /// An unknown slope counts as steep; the cube's front is flat.
    void itsTriangleSaysHowSureThePointIs()
    {
        QFETCH(double, depth);
        QFETCH(int, object);
        QFETCH(bool, isKnown);
        SceneDocument document;
        openCubes(document);
        const auto index = static_cast<std::size_t>(object);
        pickAt(document, kInCube, {depth, index, 24});
        QTRY_COMPARE_WITH_TIMEOUT(met(document), QStringLiteral("front 1"), kPatienceMilliseconds);
        const Pick pick = *document.picks().pick();
        const auto distanceWith = [&pick](const DrawnSurface &surface) {
            return refined(pick, surface).certainty.distance;
        };
        const double known =
            distanceWith(ray::drawnSurface(document.objects()[0], document.picks().pickedRay()->met->hit));
        const double assumed =
            distanceWith(ray::drawnSurface(document.objects()[index], *pick.point.world[Method::Formula]));
        QVERIFY2(assumed > 1.01 * known, qPrintable(QStringLiteral("%1 > %2").arg(assumed).arg(known)));
        QCOMPARE(pick.certainty.distance, isKnown ? known : assumed);
    }
};

UNPROJECTOR_TEST(TestPickedRay)
#include "test_picked_ray.moc"
