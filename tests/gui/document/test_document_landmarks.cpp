// The placed points of a document: their edits, their selection, their attachment to objects, and
// their placement by clicks. No window.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/told_changes.h"

#include "core/geometry/camera.h"
#include "core/landmark_files/landmark_file.h"
#include "core/ray/closest_place.h"
#include "core/ray/placed_landmark.h"
#include "core/scene_file/scene_file.h"
#include "gui/document/camera_looks.h"
#include "gui/document/landmark_placing.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/text/landmark_text.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace unprojector;
using namespace unprojector::gui;
using namespace documenttest;
using namespace unprojector::geometry;
using namespace unprojector::landmarks;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using namespace unprojector::unproject;
using landmarks::Landmark;

namespace {

Landmark pointAt(double x, const char *name = "")
{
    Landmark landmark;
    landmark.name = name;
    landmark.world = WorldPoint(x, 2.0, 3.0);
    return landmark;
}

QStringList pointNames(const SceneDocument &document)
{
    QStringList names;
    for (const Landmark &landmark : document.landmarks())
        names << QString::fromStdString(landmark.name);
    return names;
}

using Places = std::vector<std::size_t>;

/// Three points, "a" at 0, "b" at 1, "c" at 2.
void openPoints(SceneDocument &document)
{
    openScene(document);
    QVERIFY(editLandmarks(document, {pointAt(0, "a"), pointAt(1, "b"), pointAt(2, "c")}, kLabel));
}

/// One triangle (0,0,0) (4,0,0) (0,4,0), looked at from (1, 1, 10).
void openTriangle(SceneDocument &document, ray::Snap snap = ray::Snap::Surface)
{
    auto model = std::make_shared<Model>();
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    model->meshes.push_back(mesh);
    model->bounds = boundsOf(model->meshes);
    document.setSurface({801, 601, 1.0});
    openObjects(document, {{"triangle", {}, model, {}}},
                {WorldPoint(1.0, 1.0, 10.0), WorldPoint(1.0, 1.0, 0.0), {0.0, 1.0, 0.0}});
    document.picks().setSnap(snap);
}

/// The device position of a world point, by hand.
DevicePoint deviceOf(const SceneDocument &document, const glm::dvec3 &world)
{
    const Setup &g = document.setup();
    const glm::dvec4 clip = *clipFromWorld(g) * glm::dvec4(world, 1.0);
    return {(clip.x / clip.w + 1.0) / 2.0 * g.surface.widthPixels,
            (1.0 - clip.y / clip.w) / 2.0 * g.surface.heightPixels};
}

} // namespace

class TestDocumentLandmarks : public QObject {
    Q_OBJECT

private slots:
    void eachVerbIsOneStepByName_data()
    {
        addColumn<Verb>("verb");
        addColumn<QString>("text");
        addColumn<QStringList>("names");
        const auto row = [](const char *name, const char *text, const char *names, const Verb &verb) {
            newRow(name) << verb << QString::fromLatin1(text) << QString::fromLatin1(names).split(u' ');
        };
        row("place", "Place nasion", "a b c nasion",
            [](auto &d) { QVERIFY(d.sceneLandmarks().place(pointAt(5, "nasion"))); });
        row("move", "Move b", "a b c", [](auto &d) { QVERIFY(d.sceneLandmarks().move(1, pointAt(9))); });
        row("move to", "Move b", "a b c", [](auto &d) { QVERIFY(d.sceneLandmarks().moveTo(1, WorldPoint(7, 7, 7))); });
        row("rename", "Rename b", "a x c",
            [](auto &d) { QVERIFY(d.sceneLandmarks().rename(1, QStringLiteral(" x "))); });
        row("note", "Note on c", "a b c",
            [](auto &d) { QVERIFY(d.sceneLandmarks().setNote(2, QStringLiteral("chipped"))); });
        row("colour", "Colour of a", "a b c",
            [](auto &d) { QVERIFY(d.sceneLandmarks().setColor({0}, glm::u8vec3(1, 2, 3))); });
        row("hide", "Hide a", "a b c", [](auto &d) { QVERIFY(d.sceneLandmarks().setHidden({0}, true)); });
        row("hide two", "Hide 2 landmarks", "a b c", [](auto &d) {
            QVERIFY(d.sceneLandmarks().setHidden({0, 2}, true));
        });
        row("remove", "Remove a", "b c", [](auto &d) { QVERIFY(d.sceneLandmarks().remove({0})); });
        row("remove two", "Remove 2 landmarks", "b", [](auto &d) { QVERIFY(d.sceneLandmarks().remove({2, 0})); });
        row("missing", "Mark b as missing", "a b c", [](auto &d) { QVERIFY(d.sceneLandmarks().setMissing({1})); });
        row("two missing", "Mark 2 landmarks as missing", "a b c", [](auto &d) {
            QVERIFY(d.sceneLandmarks().setMissing({0, 1}));
        });
        row("again", "Place c again", "a b c", [](auto &d) { QVERIFY(d.sceneLandmarks().placeAgain({2})); });
        row("all again", "Place 3 landmarks again", "a b c", [](auto &d) {
            QVERIFY(d.sceneLandmarks().placeAgain({0, 1, 2}));
        });
        row("reorder", "Order of landmarks", "c a b", [](auto &d) { QVERIFY(d.sceneLandmarks().reorder(2, 0)); });
        row("sort", "Order of landmarks", "c b a", [](auto &d) { QVERIFY(d.sceneLandmarks().arrange({2, 1, 0})); });
        row("another set", "Import landmarks", "z", [](auto &d) {
            landmarks::LandmarkSet set;
            set.name = "skull";
            set.mesh = "skull.ply";
            set.unit = "mm";
            set.landmarks = {pointAt(0, "z")};
            QVERIFY(editLandmarkSet(d, std::move(set), {QStringLiteral("Import landmarks")}));
        });
    }

    void eachVerbIsOneStepByName()
    {
        QFETCH(Verb, verb);
        QFETCH(QString, text);
        QFETCH(QStringList, names);
        SceneDocument document;
        openPoints(document);
        document.markSaved();
        const landmarks::LandmarkSet before = document.scene().landmarks;
        const int steps = document.undoStack().count();
        Told told(document);
        verb(document);
        QCOMPARE(told.count(), std::size_t{1});
        QVERIFY(told.all().testFlag(Change::Landmarks));
        QVERIFY(!(told.all() & kVisibleChanges)); // the mesh is not drawn again for it
        QCOMPARE(document.undoStack().count(), steps + 1);
        QCOMPARE(document.undoStack().undoText(), text);
        QCOMPARE(pointNames(document), names);
        QVERIFY(document.isEdited());
        const landmarks::LandmarkSet after = document.scene().landmarks;
        QVERIFY(after != before);
        document.undoStack().undo();
        QVERIFY(document.scene().landmarks == before);
        QVERIFY(!document.isEdited());
        document.undoStack().redo();
        QVERIFY(document.scene().landmarks == after);
    }

    void aDragIsOneStep()
    {
        SceneDocument document;
        openPoints(document);
        const int steps = document.undoStack().count();
        for (int i = 0; i < 5; ++i)
            QVERIFY(document.sceneLandmarks().move(1, pointAt(10.0 + i), QStringLiteral("drag 1")));
        QVERIFY(document.sceneLandmarks().move(1, pointAt(20.0), QStringLiteral("drag 2")));
        QCOMPARE(document.undoStack().count(), steps + 2);
        document.undoStack().undo();
        QCOMPARE(document.landmarks()[1].world->x, 14.0);
        document.undoStack().undo();
        QCOMPARE(document.landmarks()[1].world->x, 1.0);
        QCOMPARE(document.landmarks()[1].name, std::string("b")); // only its place was taken
    }

    void whatWaitsIsPlacedFirst()
    {
        SceneDocument document;
        openScene(document);
        Landmark missing;
        missing.note = "a hint";
        missing.name = "nasion";
        std::vector<Landmark> landmarks{missing, pointAt(1, "landmark_4"), missing};
        landmarks[2].name = "gnathion";
        QVERIFY(editLandmarks(document, landmarks, kLabel));
        SceneLandmarks &list = document.sceneLandmarks();
        QVERIFY(list.nextUnplaced() == 0u);
        QVERIFY(list.place(pointAt(5)));
        QCOMPARE(pointNames(document), QStringList({"nasion", "landmark_4", "gnathion"}));
        QCOMPARE(document.landmarks()[0].world->x, 5.0);
        QCOMPARE(document.landmarks()[0].note, std::string("a hint"));
        QVERIFY(list.selection() == Places{0});
        QVERIFY(list.nextUnplaced() == 2u);
        list.selectOnly(1); // a look at another does not skip it
        QVERIFY(list.nextUnplaced() == 2u);
        document.undoStack().undo();
        QVERIFY(!document.landmarks()[0].isPlaced());
        list.selectOnly(0); // chosen, it waits
        QVERIFY(list.nextUnplaced() == 0u);
        QVERIFY(list.place(pointAt(6)));
        QVERIFY(list.place(pointAt(7)));
        QVERIFY(!list.nextUnplaced());
        QVERIFY(list.place(pointAt(8)));
        QVERIFY(list.place(pointAt(9)));
        QCOMPARE(pointNames(document), QStringList({"nasion", "landmark_4", "gnathion", "Landmark 5", "Landmark 6"}));
        QVERIFY(list.current() == 4u);
        list.setNextUnplaced(1);
        QVERIFY(!list.nextUnplaced()); // it has its place
    }

    void anUndonePlacingWaitsAgain()
    {
        SceneDocument document;
        openScene(document);
        Landmark first, second;
        first.name = "first";
        second.name = "second";
        QVERIFY(editLandmarks(document, {first, second}, kLabel));
        SceneLandmarks &landmarks = document.sceneLandmarks();
        QVERIFY(landmarks.place(pointAt(1)));
        QVERIFY(landmarks.nextUnplaced() == 1u);
        document.undoStack().undo();
        QVERIFY(landmarks.nextUnplaced() == 0u);
        // Without the one that was next, the first one is.
        landmarks.setNextUnplaced(1);
        QVERIFY(landmarks.remove({1}));
        QVERIFY(landmarks.nextUnplaced() == 0u);
        document.undoStack().undo();
        landmarks.setNextUnplaced(0);
        QVERIFY(landmarks.place(pointAt(2)) && landmarks.place(pointAt(3)));
        QCOMPARE(landmarks.all()[0].world->x, 2.0);
        document.undoStack().undo(); // the last of all
        QVERIFY(landmarks.nextUnplaced() == 1u);
        QVERIFY(landmarks.selection() == Places{1});
        document.undoStack().undo(); // the selection goes along with the next one
        QVERIFY(landmarks.nextUnplaced() == 0u);
        QVERIFY(landmarks.selection() == Places{0});
        QVERIFY(landmarks.skip(0));
        QVERIFY(landmarks.nextUnplaced() == 1u);
        QVERIFY(landmarks.selection().empty());
        document.undoStack().undo();
        document.undoStack().redo();
        document.undoStack().undo();
        QVERIFY(landmarks.place(pointAt(2)) && landmarks.place(pointAt(3)));
        QVERIFY(!landmarks.nextUnplaced());
        QVERIFY(landmarks.setMissing({0})); // it is not there: nothing to be placed
        QVERIFY(!landmarks.nextUnplaced());
    }

    void skippedOnesComeAgainAndMissingOnesDoNot()
    {
        SceneDocument document;
        openScene(document);
        std::vector<Landmark> names(5);
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i].name = std::string(1, static_cast<char>('a' + i));
        QVERIFY(editLandmarks(document, names, kLabel));
        SceneLandmarks &list = document.sceneLandmarks();
        QVERIFY(list.skip(0));
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Skip a"));
        QVERIFY(list.all()[0].absence == Absence::Skipped && list.nextUnplaced() == 1u);
        QVERIFY(list.setMissing({1}));
        QVERIFY(list.all()[1].isMissing() && list.nextUnplaced() == 2u);
        document.undoStack().undo(); // each undone step makes its landmark the next again
        QVERIFY(list.nextUnplaced() == 1u);
        document.undoStack().undo();
        QVERIFY(list.nextUnplaced() == 0u);
        document.undoStack().redo();
        document.undoStack().redo();
        QVERIFY(list.nextUnplaced() == 2u);
        QVERIFY(list.place(pointAt(1)) && list.place(pointAt(2)) && list.place(pointAt(3)));
        QVERIFY(list.nextUnplaced() == 0u); // the skipped one comes after all others, the missing one never
        const int steps = document.undoStack().count();
        QVERIFY(list.skip(0)); // it is the only one left, and skipped already
        QVERIFY(list.nextUnplaced() == 0u && document.undoStack().count() == steps);
        QVERIFY(list.place(pointAt(4)));
        QVERIFY(list.all()[0].isPlaced() && list.all()[0].absence == Absence::NotPlaced);
        QVERIFY(!list.nextUnplaced());
        // A missing one is placed all the same if the user chooses it.
        list.selectOnly(1);
        QVERIFY(list.nextUnplaced() == 1u);
        QVERIFY(list.place(pointAt(5)));
        QVERIFY(list.all()[1].isPlaced() && list.all()[1].absence == Absence::NotPlaced && !list.nextUnplaced());
        QVERIFY(list.setMissing({1, 2}));
        QVERIFY(!list.all()[1].isPlaced() && list.all()[1].isMissing() && !list.nextUnplaced());
        QVERIFY(list.setMissing({0, 1, 2}, false));
        QVERIFY(list.all()[0].isPlaced() && list.all()[1].isToPlace() && list.nextUnplaced() == 1u);
        list.toggle(2); // a deselected one is not chosen
        list.toggle(2);
        list.setNextUnplaced(1);
        list.select({3, 4}, 2);
        QVERIFY(list.nextUnplaced() == 1u);
    }

    void redoneStepsLeadOn()
    {
        SceneDocument document;
        openScene(document);
        std::vector<Landmark> names(3);
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i].name = std::string(1, static_cast<char>('a' + i));
        SceneLandmarks &list = document.sceneLandmarks();
        QVERIFY(editLandmarks(document, names, kLabel));
        for (int i = 0; i < 3; ++i)
            QVERIFY(list.place(pointAt(i)));
        for (int i = 0; i < 4; ++i)
            document.undoStack().undo();
        QVERIFY(list.all().empty() && !list.nextUnplaced());
        document.undoStack().redo();
        QVERIFY(list.nextUnplaced() == 0u);
        document.undoStack().redo();
        QVERIFY(list.nextUnplaced() == 1u);
        QVERIFY(list.place(pointAt(7)));
        QCOMPARE(pointNames(document), (QStringList{"a", "b", "c"}));
        QCOMPARE(list.all()[1].world->x, 7.0);
    }

    void theOrderOfTheSelectionIsKept()
    {
        SceneDocument document;
        openScene(document);
        std::vector<Landmark> landmarks;
        landmarks.reserve(6);
        for (int i = 0; i < 6; ++i)
            landmarks.push_back(pointAt(i, QString::number(i).toUtf8().constData()));
        QVERIFY(editLandmarks(document, landmarks, kLabel));
        SceneLandmarks &list = document.sceneLandmarks();
        list.selectOnly(4);
        list.toggle(1);
        list.toggle(3);
        QVERIFY(list.selectionInOrder() == (Places{4, 1, 3}) && list.selection() == (Places{1, 3, 4}));
        list.toggle(1);
        list.toggle(1);
        QVERIFY(list.selectionInOrder() == (Places{4, 3, 1}));
        QVERIFY(list.remove({0})); // it follows the landmarks
        QVERIFY(list.selectionInOrder() == (Places{3, 2, 0}));
        list.selectOnly(3);
        list.select({0, 1, 2, 3}, 0); // a range upwards
        QVERIFY(list.selectionInOrder() == (Places{3, 2, 1, 0}));
        list.selectOnly(1);
        list.select({1, 2, 3, 4}, 4);
        QVERIFY(list.selectionInOrder() == (Places{1, 2, 3, 4}));
        list.selectOnly(2);
        list.select({0, 1, 2, 3, 4}, 2); // all at once
        QVERIFY(list.selectionInOrder() == (Places{0, 1, 2, 3, 4}));
    }

    void aTwinIsAnotherPoint()
    {
        SceneDocument document;
        openScene(document);
        QVERIFY(editLandmarks(document, {pointAt(1, "a"), pointAt(1, "a")}, kLabel));
        document.sceneLandmarks().selectOnly(0);
        QVERIFY(document.sceneLandmarks().moveTo(0, WorldPoint(7, 7, 7)));
        QVERIFY(document.sceneLandmarks().selection() == Places{0});
        document.undoStack().undo();
        QVERIFY(document.sceneLandmarks().selection() == Places{0});
    }

    void theSelectionGoesWithThePoints_data()
    {
        addColumn<Verb>("verb");
        addColumn<Places>("places");
        const auto row = [](const char *name, const Places &places, const Verb &verb) {
            newRow(name) << verb << places;
        };
        row("moved", {1, 2}, [](auto &d) { QVERIFY(d.sceneLandmarks().move(1, pointAt(9))); });
        row("one before it removed", {0, 1}, [](auto &d) { QVERIFY(d.sceneLandmarks().remove({0})); });
        row("one of them removed", {1}, [](auto &d) { QVERIFY(d.sceneLandmarks().remove({1})); });
        row("reordered", {0, 2}, [](auto &d) { QVERIFY(d.sceneLandmarks().reorder(2, 0)); });
        row("all removed", {}, [](auto &d) { QVERIFY(d.sceneLandmarks().remove({0, 1, 2})); });
        row("removed and undone", {0, 1}, [](auto &d) {
            QVERIFY(d.sceneLandmarks().reorder(2, 0));
            QVERIFY(d.sceneLandmarks().remove({1}));
            QVERIFY(d.sceneLandmarks().rename(0, QStringLiteral("C")));
        });
        row("places that are none", {1}, [](auto &d) { d.sceneLandmarks().select({7, 1, 1}); });
    }

    void theSelectionGoesWithThePoints()
    {
        QFETCH(Verb, verb);
        QFETCH(Places, places);
        SceneDocument document;
        openPoints(document);
        document.sceneLandmarks().select({2, 1}, 2);
        QVERIFY(document.sceneLandmarks().selection() == (Places{1, 2}));
        QVERIFY(document.sceneLandmarks().current() == 2u);
        verb(document);
        QVERIFY(document.sceneLandmarks().selection() == places);
        QCOMPARE(document.sceneLandmarks().current().has_value(), !places.empty());
        QVERIFY(!document.sceneLandmarks().current()
                || document.sceneLandmarks().isSelected(*document.sceneLandmarks().current()));
        // It is no step of undo.
        const int steps = document.undoStack().count();
        Told told(document);
        document.sceneLandmarks().clearSelection();
        QVERIFY(document.sceneLandmarks().selection().empty());
        QCOMPARE(document.undoStack().count(), steps);
        QVERIFY(places.empty() || told.all() == Change::LandmarkSelection);
    }

    void anotherSceneHasItsOwn()
    {
        SceneDocument document;
        openPoints(document);
        document.sceneLandmarks().select({1});
        Told told(document);
        Scene other = document.scene();
        other.landmarks.landmarks = {pointAt(4, "other"), pointAt(5, "missing")};
        other.landmarks.landmarks[1].world.reset();
        QVERIFY(document.open(other));
        QVERIFY(document.sceneLandmarks().nextUnplaced() == 1u); // it goes on where it was left
        QVERIFY(told.all().testFlag(Change::Landmarks));
        QCOMPARE(pointNames(document), QStringList({"other", "missing"}));
        QVERIFY(document.sceneLandmarks().selection().empty());
        openObjects(document, examples::bundledScene());
        QVERIFY(document.landmarks().empty());
    }

    void pointsGoWithTheirObject_data()
    {
        addColumn<Verb>("verb");
        addColumn<QString>("object");
        addColumn<glm::dvec3>("held");
        addColumn<glm::dvec3>("free");
        const glm::dvec3 held(1.0, 1.0, 0.0), free(1.0, 1.0, 2.0);
        const auto transform = [](const std::vector<TransformStep> &steps) {
            return [steps](SceneDocument &d) { QVERIFY(editTransform(d, 0, steps, kLabel)); };
        };
        newRow("moved") << Verb(transform({Translate{{10, 0, 0}}})) << "triangle" << held + glm::dvec3(10, 0, 0)
                        << free + glm::dvec3(10, 0, 0);
        newRow("scaled") << Verb(transform({Scale{{2, 3, 4}}})) << "triangle" << glm::dvec3(2, 3, 0)
                         << glm::dvec3(2, 3, 8);
        newRow("turned") << Verb(transform({Rotate{90.0, {0, 0, 1}}})) << "triangle" << glm::dvec3(-1, 1, 0)
                         << glm::dvec3(-1, 1, 2);
        newRow("renamed") << Verb(
            [](auto &d) { QCOMPARE(renameObject(d, 0, QStringLiteral("skull")), NameFault::None); })
                          << "skull" << held << free;
        newRow("removed") << Verb([](auto &d) { QVERIFY(removeObject(d, 0)); }) << "" << held << free;
        newRow("hidden") << Verb([](auto &d) { QVERIFY(setObjectHidden(d, 0, true)); }) << "triangle" << held << free;
        newRow("another added") << Verb([](auto &d) {
            QVERIFY(addObjects(d, {examples::bundledScene()[0]}));
            QVERIFY(moveObject(d, 1, 0));
        }) << "triangle" << held << free;
    }

    void pointsGoWithTheirObject()
    {
        QFETCH(Verb, verb);
        QFETCH(QString, object);
        QFETCH(glm::dvec3, held);
        QFETCH(glm::dvec3, free);
        SceneDocument document;
        openTriangle(document);
        Landmark onMesh = *landmarkOnMesh(document, deviceOf(document, {1.0, 1.0, 0.0}));
        Landmark above = onMesh, elsewhere = onMesh;
        above.anchor = landmarks::Free{};
        above.world = WorldPoint(1.0, 1.0, 2.0);
        elsewhere.anchor = landmarks::Free{};
        elsewhere.object.clear();
        QVERIFY(editLandmarks(document, {onMesh, above, elsewhere}, kLabel));
        const landmarks::LandmarkSet before = document.scene().landmarks;
        const int steps = document.undoStack().count();
        verb(document);
        const std::vector<Landmark> &now = document.landmarks();
        QCOMPARE(QString::fromStdString(now[0].object), object);
        QCOMPARE(QString::fromStdString(now[1].object), object);
        QVERIFY(glm::length(now[0].world->coordinates() - held) < 1e-12);
        QVERIFY(glm::length(now[1].world->coordinates() - free) < 1e-12);
        QVERIFY(now[2] == before.landmarks[2]); // on nothing, it stays
        QCOMPARE(std::holds_alternative<landmarks::OnTriangle>(now[0].anchor), !object.isEmpty());
        while (document.undoStack().count() > steps && document.undoStack().index() > steps)
            document.undoStack().undo();
        QVERIFY(document.scene().landmarks == before); // and with the object they are back
    }

    void turnedUncertaintyDoesNotGrow()
    {
        SceneDocument document;
        openTriangle(document);
        Landmark landmark = *landmarkOnMesh(document, deviceOf(document, {1.0, 1.0, 0.0}));
        landmark.uncertainty = WorldVector(0.1, 0.2, 0.2);
        QVERIFY(editLandmarks(document, {landmark}, kLabel));
        for (int degrees = 1; degrees <= 360; ++degrees)
            QVERIFY(editTransform(document, 0, {Rotate{double(degrees), {1, 2, 3}}}, {QStringLiteral("turn")}));
        QVERIFY(std::abs(length(*document.landmarks()[0].uncertainty) - 0.3) < 1e-9);
        QVERIFY(editTransform(document, 0, {Scale{{2, 2, 2}}}, kLabel));
        QVERIFY(std::abs(length(*document.landmarks()[0].uncertainty) - 0.6) < 1e-9);
    }

    void clicksAreHeldByTheMesh_data()
    {
        addColumn<ray::Snap>("snap");
        addColumn<glm::dvec3>("world");
        addColumn<landmarks::Anchor>("hold");
        using namespace landmarks;
        using namespace unprojector::geometry;
        using namespace unprojector::mesh;
        using namespace unprojector::scene;
        using namespace unprojector::unproject;
        newRow("surface") << ray::Snap::Surface << glm::dvec3(1, 1, 0)
                          << Anchor(OnTriangle{0, glm::dvec3(0.5, 0.25, 0.25)});
        newRow("vertex") << ray::Snap::Vertex << glm::dvec3(4, 0, 0) << Anchor(AtVertex{1});
        newRow("edge") << ray::Snap::Edge << glm::dvec3(1, 0, 0) << Anchor(OnEdge{{0, 1}, 0.25});
        newRow("slanting edge") << ray::Snap::Edge << glm::dvec3(3, 1, 0) << Anchor(OnEdge{{1, 2}, 0.25});
        newRow("face") << ray::Snap::Face << glm::dvec3(1, 2, 0) << Anchor(OnTriangle{0, glm::dvec3(0.25, 0.25, 0.5)});
    }

    void clicksAreHeldByTheMesh()
    {
        QFETCH(ray::Snap, snap);
        QFETCH(glm::dvec3, world);
        QFETCH(landmarks::Anchor, hold);
        SceneDocument document;
        openTriangle(document, snap);
        const std::optional<Landmark> point = landmarkOnMesh(document, deviceOf(document, world));
        QVERIFY(point);
        QCOMPARE(point->object, std::string("triangle"));
        QCOMPARE(point->anchor.index(), hold.index());
        const Model &model = *document.objects()[0].model;
        QVERIFY(glm::length(ray::placeOf(point->anchor, model)->coordinates() - world) < 1e-9);
        QVERIFY(glm::length(ray::placeOf(hold, model)->coordinates() - world) < 1e-9); // the row itself
        QVERIFY(glm::length(ray::placeOf(point->anchor, model)->coordinates() - point->world->coordinates()) < 1e-14);
        QVERIFY(!landmarkOnMesh(document, deviceOf(document, {4.0, 4.0, 0.0})));
    }

    void aHandIsAsSureAsItsPixel()
    {
        SceneDocument document;
        openTriangle(document);
        const Setup &g = document.setup();
        const DevicePoint at = deviceOf(document, {1.0, 1.0, 0.0});
        const ProjectionWindow window = projectionWindow(g.projection());
        const double footprint = (window.right - window.left) / window.nearDistance * 10.0 / g.surface.widthPixels;
        const WorldVector off = *landmarkOnMesh(document, at)->uncertainty;
        QVERIFY(std::abs(off.x - footprint / 2.0) < 1e-3 * footprint); // the surface faces the eye
        QVERIFY(std::abs(off.y - footprint / 2.0) < 1e-3 * footprint);
        QVERIFY(off.z < 1e-3 * footprint);
        const WorldVector tenth = *landmarkOnMesh(document, at, 0.1)->uncertainty;
        QVERIFY(std::abs(tenth.x - footprint / 20.0) < 1e-3 * footprint);
        // Tilted by 60 degrees about the x axis, it is twice as long a way up the surface: y stays, z
        // is tan 60 degrees of it.
        QVERIFY(editTransform(document, 0, {Translate{{1, 1, 0}}, Rotate{60.0, {1, 0, 0}}, Translate{{-1, -1, 0}}},
                              kLabel));
        const WorldVector tilted = *landmarkOnMesh(document, deviceOf(document, {1.0, 1.0, 0.0}))->uncertainty;
        QVERIFY(std::abs(tilted.x - footprint / 2.0) < 0.01 * footprint);
        QVERIFY(std::abs(tilted.z - std::tan(kPi / 3.0) * footprint / 2.0) < 0.01 * footprint);
        // A vertex is where the file has it.
        document.picks().setSnap(ray::Snap::Vertex);
        const glm::dvec3 corner = ray::cornersOf(document.objects()[0].model->meshes[0], 0)[0];
        const glm::dvec3 there(worldFromObject(document.objects()[0].transform) * glm::dvec4(corner, 1.0));
        QVERIFY(length(*landmarkOnMesh(document, deviceOf(document, there))->uncertainty) < 1e-6 * footprint);
    }

    void anEdgeInThePixelIsKept()
    {
        SceneDocument document;
        openTriangle(document);
        SceneObject wall{"wall", {}, document.objects()[0].model, {Translate{{-9, -9, -3}}, Scale{{9, 9, 1}}}};
        QVERIFY(addObjects(document, {wall}));
        const DevicePoint rim = deviceOf(document, {0.0, 1.0, 0.0});
        const Landmark inside = *landmarkOnMesh(document, {rim.x + 1.0, rim.y}),
                       atRim = *landmarkOnMesh(document, {rim.x + 0.2, rim.y});
        QVERIFY(!ray::edgeOf(inside));
        const std::optional<ray::LandmarkEdge> edge = ray::edgeOf(atRim);
        QVERIFY(edge);
        QCOMPARE(QString::fromStdString(edge->object), "wall");
        QVERIFY(edge->behind > 3.0 && edge->behind < 4.0); // the ray is inclined
        // The uncertainty reaches the other surface.
        QVERIFY(inside.uncertainty->z < 0.1);
        QVERIFY(std::abs(atRim.uncertainty->z - 3.0) < 0.1);
        QVERIFY(plusMinusText(atRim).startsWith(QChar(u'▲')) && !plusMinusText(inside).contains(QChar(u'▲')));
        QVERIFY2(landmarkEdgeText(atRim).contains("behind it lay wall"), qPrintable(landmarkEdgeText(atRim)));
        QVERIFY(landmarkEdgeText(inside).isEmpty());
        // It goes with the position, and files keep it.
        QVERIFY(document.sceneLandmarks().place(atRim));
        QVERIFY(ray::edgeOf(document.landmarks()[0]));
        const landmarks::LandmarkSet set = document.scene().landmarks;
        const auto written = landmark_files::landmarksText({&set, 1}, landmark_files::Format::Csv);
        QVERIFY(written);
        const auto read = landmark_files::parseLandmarks(written->text, landmark_files::Format::Csv, "edge.csv");
        QVERIFY(read);
        QVERIFY(std::abs(ray::edgeOf(read->sets[0].landmarks[0])->behind - edge->behind) < 1e-9);
        QVERIFY(document.sceneLandmarks().move(0, inside));
        QVERIFY(!ray::edgeOf(document.landmarks()[0]));
        QVERIFY(document.landmarks()[0].extra == base::JsonValue());
    }

    void aDepthWithoutAMeshIsFree()
    {
        SceneDocument document;
        openTriangle(document);
        QVERIFY(editTransform(document, 0, {Translate{{0, 0, 0}}}, kLabel));
        // No ray next to the triangle hits it, but the frame may have drawn its rim there.
        const DevicePoint beside = deviceOf(document, {-0.5, 1.0, 0.0});
        const WidgetPoint position = widgetFromDevice(document.setup().surface, beside);
        const std::optional<Landmark> point = landmarkOfClick(document, position, DepthSample{0.5, 0, 24});
        QVERIFY(point);
        QVERIFY(std::holds_alternative<landmarks::Free>(point->anchor));
        QCOMPARE(point->object, std::string("triangle"));
        const Result<Pick> pick =
            document.picks().unprojected({position, DevicePixel{int(beside.x), int(beside.y)}, {0.5, 0, 24}});
        QVERIFY(*point->world == *pick->point.world[Method::Formula]);
        QVERIFY(length(*point->uncertainty) > 0.0);
        QVERIFY(!landmarkOfClick(document, position, DepthSample{1.0, std::nullopt, 24})); // the background
        QVERIFY(!landmarkOfClick(document, position, std::nullopt));
        QVERIFY(!landmarkOfClick(document, WidgetPoint(-5, 5), DepthSample{0.5, 0, 24}));
    }

    void aThousandStepsAndBack()
    {
        SceneDocument document;
        document.undoStack().setUndoLimit(0);
        openScene(document);
        QVERIFY(editLandmarks(document, {pointAt(0, "a"), pointAt(1, "b")}, kLabel));
        for (Landmark landmark : {pointAt(5, "c"), pointAt(6, "d")}) {
            landmark.object = document.objects()[1].name;
            landmark.anchor = landmarks::OnTriangle{1, glm::dvec3(0.25, 0.25, 0.5)};
            QVERIFY(document.sceneLandmarks().place(landmark));
        }
        document.markSaved();
        const landmarks::LandmarkSet begin = document.scene().landmarks;
        const int first = document.undoStack().index();
        std::mt19937 random(20240607);
        const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
        std::vector<landmarks::LandmarkSet> states; // by index of the stack, from first on
        states.push_back(begin);
        SceneLandmarks &landmarks = document.sceneLandmarks();
        const auto isSelectionValid = [&] {
            const auto &selection = landmarks.selection();
            return std::is_sorted(selection.begin(), selection.end())
                   && (selection.empty() || selection.back() < document.landmarks().size())
                   && landmarks.current().has_value() == !selection.empty()
                   && (!landmarks.current() || landmarks.isSelected(*landmarks.current()))
                   && std::is_permutation(selection.begin(), selection.end(), landmarks.selectionInOrder().begin(),
                                          landmarks.selectionInOrder().end())
                   && (landmarks.nextUnplaced()
                           ? *landmarks.nextUnplaced() < document.landmarks().size()
                                 && !document.landmarks()[*landmarks.nextUnplaced()].isPlaced()
                           : std::none_of(document.landmarks().begin(), document.landmarks().end(),
                                          [](const Landmark &landmark) { return landmark.isToPlace(); }));
        };
        for (int step = 0; step < 1000; ++step) {
            const std::size_t count = document.landmarks().size();
            const std::size_t some = count ? below(count) : 0, other = count ? below(count) : 0;
            const int kind = static_cast<int>(below(18));
            if (kind < 3 || count == 0) {
                QVERIFY(landmarks.place(pointAt(double(random() % 1000))));
            } else if (kind == 3) {
                QVERIFY(
                    landmarks.move(some, pointAt(double(random() % 1000)), QStringLiteral("drag %1").arg(below(2))));
            } else if (kind == 4) {
                QVERIFY(landmarks.moveTo(some, WorldPoint(double(random() % 1000), 1.0, 1.0)));
            } else if (kind == 5) {
                QVERIFY(landmarks.rename(some, QString::number(random() % 10)));
            } else if (kind == 6) {
                QVERIFY(landmarks.remove({some, other}));
            } else if (kind == 7) {
                QVERIFY(landmarks.reorder(some, other));
            } else if (kind == 8) {
                QVERIFY(landmarks.setHidden({some, other}, random() % 2 == 0));
            } else if (kind == 9) {
                QVERIFY(landmarks.setColor({some}, glm::u8vec3(random() % 3)));
            } else if (kind == 10) {
                QVERIFY(random() % 2 == 0 ? landmarks.setMissing({some}, random() % 3 != 0)
                                          : landmarks.placeAgain({some}));
            } else if (kind == 17) {
                QVERIFY(landmarks.skip(some));
            } else if (kind == 11) {
                landmarks.toggle(some);
            } else if (kind == 12) {
                const auto objects = document.objects().size();
                QVERIFY(editTransform(document, below(objects), {Translate{{double(random() % 9), 0, 0}}}, kLabel));
            } else if (kind == 13) {
                static_cast<void>(renameObject(document, below(document.objects().size()),
                                               QStringLiteral("object %1").arg(random() % 5)));
            } else if (kind == 14 && document.objects().size() > 2) {
                QVERIFY(removeObject(document, below(document.objects().size())));
            } else if (kind == 15) {
                document.undoStack().undo();
                if (document.undoStack().index() < first)
                    document.undoStack().redo();
            } else {
                document.undoStack().redo();
            }
            QVERIFY(isSelectionValid());
            const auto index = static_cast<std::size_t>(document.undoStack().index() - first);
            if (index < states.size() && (kind == 15 || kind == 16)) {
                QVERIFY(states[index] == document.scene().landmarks);
            } else {
                states.resize(index + 1);
                states[index] = document.scene().landmarks;
            }
        }
        QVERIFY(states.size() > 100);
        const auto last = document.undoStack().index();
        const landmarks::LandmarkSet end = document.scene().landmarks;
        while (document.undoStack().index() > first) {
            document.undoStack().undo();
            QVERIFY(states[static_cast<std::size_t>(document.undoStack().index() - first)]
                    == document.scene().landmarks);
            QVERIFY(isSelectionValid());
        }
        QVERIFY(document.scene().landmarks == begin);
        QVERIFY(!document.isModified());
        QVERIFY(!document.isEdited());
        document.undoStack().setIndex(last);
        QVERIFY(document.scene().landmarks == end);
    }

    void pointsAreInTheSceneFile()
    {
        SceneDocument document;
        openScene(document);
        document.picks().rayCasters().complete(document.objects());
        std::optional<Landmark> held;
        for (int x = 5; x < 800 && !held; x += 5)
            held = landmarkOnMesh(document, {x + 0.5, 300.5});
        QVERIFY(held);
        QVERIFY(document.sceneLandmarks().place(*held));
        QVERIFY(document.sceneLandmarks().place(pointAt(0.1, "b")));
        QVERIFY(document.sceneLandmarks().setNote(1, QStringLiteral("chipped")));
        QVERIFY(document.sceneLandmarks().setHidden({1}, true));
        QVERIFY(document.sceneLandmarks().placeAgain({1}));
        const scene_file::SceneFile file = scene_file::sceneFileFrom(document.scene(), document.setup(), "scene.json");
        const auto text = scene_file::sceneText(file);
        QVERIFY(text);
        const auto read = scene_file::parseScene(*text, "scene.json");
        QVERIFY(read);
        QVERIFY(read->landmarks == document.scene().landmarks);
        QVERIFY(std::holds_alternative<landmarks::OnTriangle>(read->landmarks.landmarks[0].anchor));
    }
};

UNPROJECTOR_TEST(TestDocumentLandmarks)
#include "test_document_landmarks.moc"
