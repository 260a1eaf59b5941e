// The document: its functions, their change signals, and undo. No window.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/told_changes.h"

#include "core/geometry/camera_motion.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"

#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace documenttest;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;

Q_DECLARE_METATYPE(Verb)

class TestDocument : public QObject {
    Q_OBJECT

private slots:
    void everyVerbTellsItsKindOnceAndIsUndone_data()
    {
        addColumn<Verb>("verb");
        addColumn<Changes>("kinds");
        const auto row = [](const char *name, Changes kinds, const Verb &verb) {
            newRow(name) << verb << (kinds | Change::History);
        };
        row("camera", Change::Setup, [](SceneDocument &d) { setCamera(d, cameraAt(7.0)); });
        row("projection", Change::Setup, [](SceneDocument &d) { switchProjection(d); });
        row("typed eye", Change::Setup, [](SceneDocument &d) { QVERIFY(editCamera(d, cameraAt(7.0), kLabel)); });
        row("typed near", Change::Setup, [](SceneDocument &d) {
            QVERIFY(editProjection(d, {Ortho{-2, 2, -2, 2, 1, 50}, false, false}, kLabel));
        });
        row("a rule without effect yet", Change::Setup, [](SceneDocument &d) {
            QVERIFY(editProjection(d, {d.scene().projection, false, true}, kLabel));
        });
        row("viewport", Change::Setup, [](SceneDocument &d) {
            ViewportRule rule;
            rule.kind = ViewportRule::Kind::Quarter;
            QVERIFY(editViewport(d, rule, {}, kLabel));
        });
        row("depth range", Change::Setup, [](SceneDocument &d) { QVERIFY(editViewport(d, {}, {0.25, 0.75}, kLabel)); });
        row("clip plane", Change::ClipPlanes, [](SceneDocument &d) {
            QVERIFY(editClipPlanes(d, {{0.0, 1.0, 0.0, 0.0}}, {}, kLabel));
        });
        row("clip plane that does not cut", Change::ClipPlanes, [](SceneDocument &d) {
            QVERIFY(editClipPlanes(d, {}, {{0, {0.0, 1.0, 0.0, 0.0}}}, kLabel));
        });
        // Near and far fit the objects.
        row("transform", Change::Placement | Change::Setup, [](SceneDocument &d) {
            QVERIFY(editTransform(d, 0, {Translate{{40.0, 0.0, 0.0}}}, kLabel));
        });
        const Changes objects = Change::Objects | Change::Placement | Change::Visibility;
        row("removed object", objects, [](SceneDocument &d) { QVERIFY(removeObject(d, 0)); });
        row("order of objects", objects, [](SceneDocument &d) { QVERIFY(moveObject(d, 0, 2)); });
        // Near and far fit the others.
        row("hidden object", Change::Visibility | Change::Setup,
            [](SceneDocument &d) { QVERIFY(setObjectHidden(d, 1, true)); });
        row("name", Change::Names, [](SceneDocument &d) {
            QCOMPARE(renameObject(d, 0, QStringLiteral("  other ")), NameFault::None);
            QCOMPARE(d.objects()[0].name, "other");
        });
        row("fitted object", Change::Setup, [](SceneDocument &d) { fitObject(d, 1); });
        row("added object", objects, [](SceneDocument &d) { QVERIFY(addObjects(d, {examples::bundledScene()[0]})); });
    }

    void everyVerbTellsItsKindOnceAndIsUndone()
    {
        QFETCH(Verb, verb);
        QFETCH(Changes, kinds);
        SceneDocument document;
        openScene(document);
        const Scene before = document.scene();
        Told told(document);
        verb(document);
        QCOMPARE(told.all(), kinds);
        QCOMPARE(told.count(), std::size_t(1));
        QVERIFY(!document.undoStack().undoText().isEmpty());
        const Scene after = document.scene();
        for (int again = 0; again < 2; ++again) {
            told.forget();
            document.undoStack().undo();
            QCOMPARE(told.all(), kinds);
            QVERIFY(!changesBetween(before, document.scene()) && !changesBetween(before.objects, document.objects()));
            QVERIFY(!document.isModified() && !document.isEdited());
            told.forget();
            document.undoStack().redo();
            QCOMPARE(told.all(), kinds);
            QVERIFY(!changesBetween(after, document.scene()) && !changesBetween(after.objects, document.objects()));
        }
    }

    void lookingAtNothingIsNoChange_data()
    {
        addColumn<Verb>("first");
        addColumn<Verb>("again");
        const auto row = [](const char *name, const Verb &first, const Verb &again) { newRow(name) << first << again; };
        const auto twice = [&row](const char *name, const Verb &verb) { row(name, verb, verb); };
        const Verb nothing = [](SceneDocument &) {};
        twice("home", [](SceneDocument &d) { goHome(d); });
        row("home where the scene opened", nothing, [](SceneDocument &d) { goHome(d); });
        twice("fit", [](SceneDocument &d) { fitAll(d); });
        twice("fit a box", [](SceneDocument &d) {
            if (isPerspective(d.setup().projection()))
                switchProjection(d);
            fitAll(d);
        });
        twice("from the right",
              [](SceneDocument &d) { setCamera(d, seenFrom(d.setup().camera(), StandardView::Right)); });
        row("turned by nothing", nothing, [](SceneDocument &d) {
            setCamera(d, orbited(d.setup().camera(), WorldPoint(0.3, 1.7, -2.9), 0.0, 0.0), QStringLiteral("drag"));
        });
        row("the same transform", nothing, [](SceneDocument &d) {
            QVERIFY(editTransform(d, 0, std::vector<TransformStep>(d.objects()[0].transform), kLabel));
        });
        row("the same viewport", nothing,
            [](SceneDocument &d) { QVERIFY(editViewport(d, d.scene().viewport, d.scene().depthRange, kLabel)); });
    }

    void fittingCutsNothingOff_data()
    {
        addColumn<bool>("isBox");
        addColumn<double>("nearDistance");
        addColumn<double>("farDistance");
        addColumn<bool>("isKept");
        newRow("near in the objects") << false << 15.0 << 1000.0 << false;
        newRow("far before them") << false << 0.01 << 0.1 << false;
        newRow("far in a box") << true << -1000.0 << 1.0 << false;
        newRow("wide enough") << false << 0.01 << 1000.0 << true;
        newRow("wide enough, a box") << true << -1000.0 << 1000.0 << true;
    }

    /// Typed near and far distances stay where they contain everything.
    void fittingCutsNothingOff()
    {
        QFETCH(bool, isBox);
        QFETCH(double, nearDistance);
        QFETCH(double, farDistance);
        QFETCH(bool, isKept);
        for (const bool isObject : {false, true}) {
            SceneDocument document;
            openScene(document);
            if (isBox)
                switchProjection(document);
            Projection typed = withClipDistances(document.setup().projection(), nearDistance, farDistance);
            QVERIFY(editProjection(document, {typed, true, false}, kLabel));
            if (isObject)
                fitObject(document, 1);
            else
                fitAll(document);
            const ProjectionWindow window = projectionWindow(document.setup().projection());
            const EyeFrame frame = *eyeFrame(document.setup().camera());
            const Box bounds = isObject ? boundsOf(document.objects()[1]) : document.bounds();
            for (const glm::dvec3 &corner : {bounds.lowest, bounds.highest}) {
                const double distance = -eyeFromWorld(frame, WorldPoint(corner)).z;
                QVERIFY(distance > window.nearDistance && distance < window.farDistance);
            }
            QCOMPARE(window.nearDistance == nearDistance && window.farDistance == farDistance, isKept);
            QVERIFY(!document.scene().clipDistancesFitObjects);
        }
    }

    /// A picked point that is near does not shrink the box.
    void theOtherProjectionHasTheSameHeightAtTheCenter()
    {
        SceneDocument document;
        openScene(document);
        pickAt(document, WidgetPoint(400.0, 300.0), {0.01, 0, 24});
        QVERIFY(document.picks().pick() && document.picks().pick()->hit());
        const ProjectionWindow before = projectionWindow(document.setup().projection());
        const LookAt &camera = document.setup().camera();
        const double height = (before.top - before.bottom) / before.nearDistance * distance(camera.center, camera.eye);
        switchProjection(document);
        const ProjectionWindow after = projectionWindow(document.setup().projection());
        QVERIFY(std::abs((after.top - after.bottom) - height) < 1e-9 * height);
    }

    void lookingAtNothingIsNoChange()
    {
        QFETCH(Verb, first);
        QFETCH(Verb, again);
        SceneDocument document;
        openScene(document);
        first(document);
        document.markSaved();
        const int steps = document.undoStack().count();
        const Scene before = document.scene();
        Told told(document);
        again(document);
        QCOMPARE(document.undoStack().count(), steps);
        QVERIFY(!document.isModified());
        QVERIFY(!told.all());
        QVERIFY(!changesBetween(before, document.scene()));
    }

    void aRefusedVerbChangesNothing_data()
    {
        addColumn<Verb>("verb");
        newRow("near beyond far") << Verb([](SceneDocument &d) {
            QVERIFY(!editProjection(d, {Ortho{-1, 1, -1, 1, 9, 3}, false, false}, kLabel));
        });
        newRow("scale by 0") << Verb([](SceneDocument &d) {
            QVERIFY(!editTransform(d, 1, {Scale{{1.0, 0.0, 1.0}}}, kLabel));
        });
        newRow("plane without a normal") << Verb(
            [](SceneDocument &d) { QVERIFY(!editClipPlanes(d, {glm::dvec4(0.0)}, {}, kLabel)); });
        newRow("eye at center") << Verb([](SceneDocument &d) { QVERIFY(!editCamera(d, cameraAt(0.0), kLabel)); });
        newRow("one setting of two") << Verb([](SceneDocument &d) {
            SceneSettings settings = d.scene();
            settings.camera = cameraAt(7.0);
            settings.projection = Ortho{-1, 1, -1, 1, 9, 3};
            QVERIFY(!editSettings(d, settings, kLabel));
        });
        newRow("look from nowhere") << Verb([](SceneDocument &d) { setCamera(d, cameraAt(0.0)); });
        newRow("another scene") << Verb([](SceneDocument &d) {
            Scene scene;
            scene.depthRange = {0.5, 0.5};
            QVERIFY(!d.open(scene));
        });
    }

    void aRefusedVerbChangesNothing()
    {
        QFETCH(Verb, verb);
        SceneDocument document;
        openScene(document);
        const Scene before = document.scene();
        const glm::dvec3 highest = document.bounds().highest;
        Told told(document);
        verb(document);
        QVERIFY(!told.all());
        QVERIFY(!changesBetween(before, document.scene()) && !changesBetween(before.objects, document.objects()));
        QVERIFY(document.bounds().highest == highest);
        QCOMPARE(document.undoStack().count(), 0);
    }

    void openingTellsWhenAllIsInPlace()
    {
        SceneDocument document;
        openScene(document);
        setCamera(document, cameraAt(7.0));
        pickAt(document, WidgetPoint(400, 300), {0.5, 0, 24});
        int tellings = 0;
        connect(&document, &SceneDocument::changed, this, [&](Changes changes) {
            ++tellings;
            QCOMPARE(changes, kVisibleChanges | Change::Pick | Change::GivenPoint | Change::Conventions
                                  | Change::Landmarks | Change::LandmarkSelection | Change::History);
            QVERIFY(!document.picks().pick() && !document.undoStack().canUndo());
            QVERIFY(!document.isModified() && !document.isEdited());
            QVERIFY(document.objects().empty() && document.bounds().isEmpty());
        });
        Scene empty;
        empty.projection = Ortho{-2, 2, -2, 2, 1, 50};
        QVERIFY(document.open(empty));
        QCOMPARE(tellings, 1);
    }

    void aSceneThatIsRefusedLeavesTheUndoStack()
    {
        SceneDocument document;
        openScene(document);
        setCamera(document, cameraAt(7.0));
        pickAt(document, WidgetPoint(400, 300), {0.5, 0, 24});
        Scene scene;
        scene.projection = Ortho{1, 1, -2, 2, 1, 50};
        QVERIFY(!document.open(scene));
        QVERIFY(document.undoStack().canUndo() && document.picks().pick() && document.isModified()
                && !document.isEdited());
    }

    void whoHearsOfAChangeMayMakeAnother()
    {
        SceneDocument document;
        openScene(document);
        bool isFirst = true;
        connect(&document, &SceneDocument::changed, this, [&](Changes changes) {
            if (changes & Change::ClipPlanes && std::exchange(isFirst, false))
                QVERIFY(removeObject(document, 0));
        });
        const std::size_t count = document.objects().size();
        QVERIFY(editClipPlanes(document, {{0.0, 1.0, 0.0, 0.0}}, {}, kLabel));
        QCOMPARE(document.objects().size(), count - 1);
        // The steps are undone in the reverse order.
        document.undoStack().undo();
        QCOMPARE(document.objects().size(), count);
        QCOMPARE(document.scene().clipPlanes.size(), std::size_t(1));
        document.undoStack().undo();
        QVERIFY(document.scene().clipPlanes.empty());
    }

    void stepsShareTheObjects()
    {
        SceneDocument document;
        openScene(document);
        const Model *teapot = document.objects()[0].model.get();
        const auto uses = [&document] { return document.objects()[0].model.use_count(); };
        const long before = uses();
        for (int i = 0; i < 100; ++i)
            setCamera(document, cameraAt(7.0 + i));
        QCOMPARE(document.undoStack().count(), 100);
        QCOMPARE(uses(), before);
        QCOMPARE(document.objects()[0].model.get(), teapot);
    }

    void anEditRebuildsOnlyWhatFollowsFromIt_data()
    {
        addColumn<Verb>("verb");
        addColumn<bool>("isOfLandmarks");
        addColumn<bool>("keepsRays");
        const auto row = [](const char *name, bool isOfLandmarks, bool keepsRays, const Verb &verb) {
            newRow(name) << verb << isOfLandmarks << keepsRays;
        };
        row("placed landmark", true, true, [](SceneDocument &d) { QVERIFY(d.sceneLandmarks().place({})); });
        row("name of a landmark", true, true, [](SceneDocument &d) { QVERIFY(d.sceneLandmarks().rename(0, "other")); });
        row("moved landmark", true, true,
            [](SceneDocument &d) { QVERIFY(d.sceneLandmarks().moveTo(0, WorldPoint(4, 5, 6))); });
        row("colour of a landmark", true, true,
            [](SceneDocument &d) { QVERIFY(d.sceneLandmarks().setColor({0}, glm::u8vec3(1, 2, 3))); });
        row("note on a landmark", true, true, [](SceneDocument &d) { QVERIFY(d.sceneLandmarks().setNote(0, "note")); });
        row("hidden landmark", true, true, [](SceneDocument &d) { QVERIFY(d.sceneLandmarks().setHidden({0}, true)); });
        row("removed landmark", true, true, [](SceneDocument &d) { QVERIFY(d.sceneLandmarks().remove({0})); });
        row("curve", true, true, [](SceneDocument &d) {
            landmarks::Curve curve;
            curve.name = "curve";
            curve.points = {"a", "b"};
            QVERIFY(d.edit(kLabel, [&](Scene &scene) { scene.landmarks.curves.push_back(curve); }));
        });
        row("given point", false, true, [](SceneDocument &d) {
            QVERIFY(editGivenPoint(d, GivenPoint{WorldPoint(1, 2, 3), {}}, kLabel));
        });
        row("conventions", false, true, [](SceneDocument &d) { QVERIFY(editConventions(d, Api::Vulkan, kLabel)); });
        row("name of an object", false, true,
            [](SceneDocument &d) { QCOMPARE(renameObject(d, 0, "other"), NameFault::None); });
        row("order of objects", false, false, [](SceneDocument &d) { QVERIFY(moveObject(d, 0, 2)); });
        row("clip plane", false, false, [](SceneDocument &d) {
            QVERIFY(editClipPlanes(d, {{0.0, 1.0, 0.0, 0.0}}, {}, kLabel));
        });
        row("camera", false, false, [](SceneDocument &d) { setCamera(d, cameraAt(7.0)); });
        row("size of the view", false, false, [](SceneDocument &d) { d.setSurface({400, 300, 1.0}); });
    }

    void anEditRebuildsOnlyWhatFollowsFromIt()
    {
        QFETCH(Verb, verb);
        QFETCH(bool, isOfLandmarks);
        QFETCH(bool, keepsRays);
        SceneDocument document;
        openScene(document);
        landmarks::Landmark a, b;
        a.name = "a";
        b.name = "b";
        a.world = WorldPoint(1.0, 2.0, 3.0);
        b.world = WorldPoint(2.0, 2.0, 3.0);
        QVERIFY(editLandmarks(document, {a, b}, kLabel));
        document.picks().rayCasters().complete(document.objects());
        // The rays hold their models. So the count of owners shows whether the rays exist when
        // something asks for them.
        const std::shared_ptr<const Model> model = document.objects()[0].model;
        const auto hasRays = [&] {
            const auto owners = model.use_count();
            return document.picks().rays() && model.use_count() == owners;
        };
        QVERIFY(!hasRays() && hasRays());
        // A picture that is not derived anew keeps the value written into it.
        double &planted = const_cast<Setup &>(document.setup()).depthRange.atFar;
        const double value = isOfLandmarks ? planted / 2.0 : planted;
        const auto check = [&] {
            QVERIFY(!isOfLandmarks || planted == value);
            QCOMPARE(hasRays(), keepsRays);
        };
        planted = value;
        verb(document);
        check();
        if (document.undoStack().count() < 2)
            return; // the size of the view is not undoable
        planted = value;
        document.undoStack().undo();
        check();
    }

    void nothingIsToldOfTheEnd_data()
    {
        addColumn<Verb>("verb");
        newRow("steps to undo") << Verb([](SceneDocument &d) { setCamera(d, cameraAt(7.0)); });
        newRow("steps to redo") << Verb([](SceneDocument &d) {
            setCamera(d, cameraAt(7.0));
            d.undoStack().undo();
        });
        newRow("unsaved") << Verb([](SceneDocument &d) { d.markUnsaved(); });
    }

    void nothingIsToldOfTheEnd()
    {
        QFETCH(Verb, verb);
        auto document = std::make_unique<SceneDocument>();
        openScene(*document);
        verb(*document);
        const Told told(*document);
        document.reset();
        QCOMPARE(told.count(), std::size_t(0));
    }
};

UNPROJECTOR_TEST(TestDocument)
#include "test_document.moc"
