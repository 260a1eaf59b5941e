// The document: what its verbs do, what they tell, and what undoing brings back. No window.

#include "core/geometry/camera_motion.h"
#include "core/scene/bundled_scene.h"
#include "gui/document/scene_document.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <memory>

using namespace unprojector;
using namespace unprojector::gui;

namespace {

using Verb = std::function<void(SceneDocument &)>;

/// What a document has told, one entry a telling.
class Told {
public:
    explicit Told(SceneDocument &document)
    {
        QObject::connect(&document, &SceneDocument::changed, &m_context,
                         [this](Changes changes) { m_tellings.push_back(changes); });
    }
    Changes all() const
    {
        Changes all;
        for (const Changes &changes : m_tellings)
            all |= changes;
        return all;
    }
    std::size_t count() const { return m_tellings.size(); }
    void forget() { m_tellings.clear(); }

private:
    QObject m_context;
    std::vector<Changes> m_tellings;
};

const Deed kDeed{QStringLiteral("deed")};

void openScene(SceneDocument &document)
{
    document.setSurface({801, 601, 1.0});
    document.setObjects(bundledScene());
}

LookAt cameraAt(double z)
{
    return {WorldPoint(0.0, 0.0, z), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
}

QStringList namesIn(const SceneDocument &document)
{
    QStringList names;
    for (const SceneObject &object : document.objects())
        names << QString::fromStdString(object.name);
    return names;
}

} // namespace

Q_DECLARE_METATYPE(Verb)

class TestDocument : public QObject {
    Q_OBJECT

private slots:
    void everyVerbTellsItsKindOnceAndIsUndone_data();
    void everyVerbTellsItsKindOnceAndIsUndone();
    void lookingAtNothingIsNoChange_data();
    void lookingAtNothingIsNoChange();
    void aRefusedVerbChangesNothing_data();
    void aRefusedVerbChangesNothing();
    void objectsComeAndGoUndoably();
    void aPickGoesWithItsObject();
    void objectsAreMovedInTheirList_data();
    void objectsAreMovedInTheirList();
    void hiddenObjectsAreOutOfSight();
    void namesStayUnique_data();
    void namesStayUnique();
    void whatIsAddedIsInSight_data();
    void whatIsAddedIsInSight();
    void twoSizesCanBothBeSeen();
    void openingTellsWhenAllIsInPlace();
    void aSceneThatIsRefusedLeavesTheUndoStack();
    void whoHearsOfAChangeMayMakeAnother();
    void stepsShareTheObjects();
    void nothingIsToldOfTheEnd_data();
    void nothingIsToldOfTheEnd();
};

void TestDocument::everyVerbTellsItsKindOnceAndIsUndone_data()
{
    QTest::addColumn<Verb>("verb");
    QTest::addColumn<Changes>("kinds");
    const auto row = [](const char *name, Changes kinds, const Verb &verb) {
        QTest::newRow(name) << verb << (kinds | Change::History);
    };
    row("camera", Change::Picture, [](SceneDocument &d) { d.setCamera(cameraAt(7.0)); });
    row("projection", Change::Picture, [](SceneDocument &d) { d.switchProjection(); });
    row("typed eye", Change::Picture, [](SceneDocument &d) { QVERIFY(d.editCamera(cameraAt(7.0), kDeed)); });
    row("typed near", Change::Picture, [](SceneDocument &d) {
        QVERIFY(d.editProjection({Ortho{-2, 2, -2, 2, 1, 50}, false, false}, kDeed));
    });
    row("a rule without effect yet", Change::Picture, [](SceneDocument &d) {
        QVERIFY(d.editProjection({d.scene().projection, false, true}, kDeed));
    });
    row("viewport", Change::Picture, [](SceneDocument &d) {
        ViewportRule rule;
        rule.kind = ViewportRule::Kind::Quarter;
        QVERIFY(d.editViewport(rule, {}, kDeed));
    });
    row("depth range", Change::Picture, [](SceneDocument &d) { QVERIFY(d.editViewport({}, {0.25, 0.75}, kDeed)); });
    row("clip plane", Change::ClipPlanes, [](SceneDocument &d) {
        QVERIFY(d.editClipPlanes({{0.0, 1.0, 0.0, 0.0}}, {}, kDeed));
    });
    row("clip plane that does not cut", Change::ClipPlanes, [](SceneDocument &d) {
        QVERIFY(d.editClipPlanes({}, {{0, {0.0, 1.0, 0.0, 0.0}}}, kDeed));
    });
    // Near and far fit the objects.
    row("transform", Change::Placement | Change::Picture, [](SceneDocument &d) {
        QVERIFY(d.editTransform(0, {Translate{{40.0, 0.0, 0.0}}}, kDeed));
    });
    const Changes objects = Change::Objects | Change::Placement | Change::Visibility;
    row("removed object", objects, [](SceneDocument &d) { QVERIFY(d.removeObject(0)); });
    row("order of objects", objects, [](SceneDocument &d) { QVERIFY(d.moveObject(0, 2)); });
    // Near and far fit the others.
    row("hidden object", Change::Visibility | Change::Picture,
        [](SceneDocument &d) { QVERIFY(d.setObjectHidden(1, true)); });
    row("name", Change::Names, [](SceneDocument &d) {
        QCOMPARE(d.renameObject(0, QStringLiteral("  other ")), NameFault::None);
        QCOMPARE(d.objects()[0].name, "other");
    });
    row("fitted object", Change::Picture, [](SceneDocument &d) { d.fitObject(1); });
    row("added object", objects, [](SceneDocument &d) { QVERIFY(d.addObjects({bundledScene()[0]})); });
}

void TestDocument::everyVerbTellsItsKindOnceAndIsUndone()
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

void TestDocument::lookingAtNothingIsNoChange_data()
{
    QTest::addColumn<Verb>("first");
    QTest::addColumn<Verb>("again");
    const auto row = [](const char *name, const Verb &first, const Verb &again) {
        QTest::newRow(name) << first << again;
    };
    const auto twice = [&row](const char *name, const Verb &verb) { row(name, verb, verb); };
    const Verb nothing = [](SceneDocument &) {};
    twice("home", [](SceneDocument &d) { d.goHome(); });
    row("home where the scene opened", nothing, [](SceneDocument &d) { d.goHome(); });
    twice("fit", [](SceneDocument &d) { d.fit(); });
    twice("fit a box", [](SceneDocument &d) {
        if (isPerspective(d.geometry().projection()))
            d.switchProjection();
        d.fit();
    });
    twice("from the right",
          [](SceneDocument &d) { d.setCamera(seenFrom(d.geometry().camera(), StandardView::Right)); });
    row("turned by nothing", nothing, [](SceneDocument &d) {
        d.setCamera(orbited(d.geometry().camera(), WorldPoint(0.3, 1.7, -2.9), 0.0, 0.0), QStringLiteral("drag"));
    });
    row("the same transform", nothing, [](SceneDocument &d) {
        QVERIFY(d.editTransform(0, std::vector<TransformStep>(d.objects()[0].transform), kDeed));
    });
    row("the same viewport", nothing,
        [](SceneDocument &d) { QVERIFY(d.editViewport(d.scene().viewport, d.scene().depthRange, kDeed)); });
}

void TestDocument::lookingAtNothingIsNoChange()
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

void TestDocument::aRefusedVerbChangesNothing_data()
{
    QTest::addColumn<Verb>("verb");
    QTest::newRow("near beyond far") << Verb([](SceneDocument &d) {
        QVERIFY(!d.editProjection({Ortho{-1, 1, -1, 1, 9, 3}, false, false}, kDeed));
    });
    QTest::newRow("scale by 0") << Verb([](SceneDocument &d) {
        QVERIFY(!d.editTransform(1, {Scale{{1.0, 0.0, 1.0}}}, kDeed));
    });
    QTest::newRow("plane without a normal")
        << Verb([](SceneDocument &d) { QVERIFY(!d.editClipPlanes({glm::dvec4(0.0)}, {}, kDeed)); });
    QTest::newRow("eye at center") << Verb([](SceneDocument &d) { QVERIFY(!d.editCamera(cameraAt(0.0), kDeed)); });
    QTest::newRow("look from nowhere") << Verb([](SceneDocument &d) { d.setCamera(cameraAt(0.0)); });
    QTest::newRow("another scene") << Verb([](SceneDocument &d) {
        Scene scene;
        scene.depthRange = {0.5, 0.5};
        QVERIFY(!d.open(scene));
    });
}

void TestDocument::aRefusedVerbChangesNothing()
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

void TestDocument::objectsComeAndGoUndoably()
{
    SceneDocument document;
    openScene(document);
    const QStringList all = namesIn(document);
    QVERIFY(document.removeObject(1));
    QStringList others = all;
    others.removeAt(1);
    QCOMPARE(namesIn(document), others);
    SceneObject another = bundledScene()[1];
    another.name = "another";
    QVERIFY(document.addObjects({another}));
    QCOMPARE(namesIn(document), others + QStringList(QStringLiteral("another")));
    document.undoStack().undo();
    document.undoStack().undo();
    QCOMPARE(namesIn(document), all);
    document.undoStack().redo();
    document.undoStack().redo();
    QCOMPARE(namesIn(document), others + QStringList(QStringLiteral("another")));
    while (!document.objects().empty())
        QVERIFY(document.removeObject(0));
    QVERIFY(document.bounds().isEmpty());
    document.undoStack().setIndex(0);
    QCOMPARE(namesIn(document), all);
    QVERIFY(!document.isEdited());
}

void TestDocument::aPickGoesWithItsObject()
{
    SceneDocument document;
    openScene(document);
    const auto place = [&document] { return document.pick() ? document.pick()->object : std::nullopt; };
    using Place = std::optional<std::size_t>;
    document.pickAt(WidgetPoint(400, 300), {0.5, 1, 24});
    QCOMPARE(place(), Place(1));
    QVERIFY(document.addObjects({bundledScene()[0]}));
    QCOMPARE(place(), Place(1));
    QVERIFY(document.removeObject(0));
    QCOMPARE(place(), Place(0));
    QVERIFY(document.moveObject(0, 2));
    QCOMPARE(place(), Place(2));
    QVERIFY(document.setObjectHidden(2, true));
    QCOMPARE(document.renameObject(2, QStringLiteral("other")), NameFault::None);
    QCOMPARE(place(), Place(2));
    for (int k = 0; k < 4; ++k)
        document.undoStack().undo();
    QCOMPARE(place(), Place(1));
    QVERIFY(!document.sinceClick().isObjectMoved);
    QVERIFY(document.removeObject(1));
    QVERIFY(!document.pick());
    // One of the background is on no object.
    document.pickAt(WidgetPoint(1, 1), {1.0, std::nullopt, 24});
    QVERIFY(document.removeObject(0));
    QVERIFY(document.pick());
}

void TestDocument::objectsAreMovedInTheirList_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::newRow("to the end") << 0 << 3;
    QTest::newRow("to the start") << 3 << 0;
    QTest::newRow("down by one") << 1 << 2;
    QTest::newRow("up by one") << 2 << 1;
}

void TestDocument::objectsAreMovedInTheirList()
{
    QFETCH(int, from);
    QFETCH(int, to);
    SceneDocument document;
    openScene(document);
    QVERIFY(document.objects().size() >= 4);
    QStringList names = namesIn(document);
    QVERIFY(document.moveObject(static_cast<std::size_t>(from), static_cast<std::size_t>(to)));
    names.move(from, to);
    QCOMPARE(namesIn(document), names);
    const int steps = document.undoStack().count();
    QVERIFY(document.moveObject(static_cast<std::size_t>(to), static_cast<std::size_t>(to)));
    QCOMPARE(document.undoStack().count(), steps); // it is there
}

void TestDocument::hiddenObjectsAreOutOfSight()
{
    SceneDocument document;
    std::vector<SceneObject> objects = bundledScene();
    objects.resize(2);
    objects[1].transform = {Translate{{50.0, 0.0, 0.0}}};
    document.setObjects(objects);
    const Box both = document.bounds();
    QVERIFY(document.setObjectHidden(1, true));
    QVERIFY(document.bounds().highest.x < both.highest.x - 40.0);
    document.fit();
    const LookAt one = document.geometry().camera();
    document.undoStack().undo();
    document.undoStack().undo();
    QCOMPARE(document.bounds().highest.x, both.highest.x);
    document.fit();
    QVERIFY(distance(document.geometry().camera().eye, one.eye) > 10.0);
    // A hidden one can be looked at all the same, and all can be hidden.
    document.fitObject(0);
    QVERIFY(distance(document.geometry().camera().eye, one.eye) < 1e-9);
    QVERIFY(document.setObjectHidden(0, true) && document.setObjectHidden(1, true));
    QVERIFY(document.bounds().isEmpty());
    document.fit();
    document.fitObject(1);
    QVERIFY(std::abs(document.geometry().camera().center.x - both.highest.x) < 10.0);
}

void TestDocument::namesStayUnique_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("fault");
    QTest::newRow("another") << "bunny" << int(NameFault::None);
    QTest::newRow("beyond ASCII") << QString::fromUtf8("兔子") << int(NameFault::None);
    QTest::newRow("its own") << "1" << int(NameFault::None);
    QTest::newRow("that of another") << "0" << int(NameFault::Taken);
    QTest::newRow("that of another, in blanks") << " 0 " << int(NameFault::Taken);
    QTest::newRow("blanks") << "  " << int(NameFault::Empty);
    QTest::newRow("nothing") << "" << int(NameFault::Empty);
}

void TestDocument::namesStayUnique()
{
    QFETCH(QString, name);
    QFETCH(int, fault);
    SceneDocument document;
    std::vector<SceneObject> objects = bundledScene();
    objects.resize(2);
    objects[0].name = "0";
    objects[1].name = "1";
    document.setObjects(objects);
    QCOMPARE(int(document.renameObject(1, name)), fault);
    QCOMPARE(document.objects()[1].name, fault == int(NameFault::None) ? name.toStdString() : "1");
    QCOMPARE(document.undoStack().count(), fault == int(NameFault::None) && name != QStringLiteral("1") ? 1 : 0);
    // What is added gets a name of its own.
    QVERIFY(document.addObjects({objects[0], objects[0]}));
    QCOMPARE(namesIn(document).mid(2), QStringList({QStringLiteral("0 (2)"), QStringLiteral("0 (3)")}));
}

namespace {

/// One of the bundled objects, so many times as large, with its middle there.
SceneObject placed(const glm::dvec3 &middle, double scale)
{
    SceneObject object = bundledScene()[0];
    object.name = "placed";
    object.transform = {Translate{middle}, Scale{glm::dvec3(scale)}, Translate{-object.model->bounds.center()}};
    return object;
}

/// Whether all of an object is in the picture; it covers so much of its width and height.
bool isInSight(const SceneDocument &document, const SceneObject &object, glm::dvec2 *share = nullptr)
{
    glm::dvec2 lowest(1e300), highest(-1e300);
    const glm::dmat4 clipFromObject = clipFromWorld(document.geometry()).value() * worldFromObject(object.transform);
    for (const Mesh &mesh : object.model->meshes) {
        for (std::size_t element = 0; element < mesh.elementCount(); ++element) {
            const glm::dvec4 clip = clipFromObject * glm::dvec4(mesh.position(mesh.vertexAt(element)), 1.0);
            if (!(clip.w > 0.0) || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || std::abs(clip.z) > clip.w)
                return false;
            lowest = glm::min(lowest, glm::dvec2(clip) / clip.w);
            highest = glm::max(highest, glm::dvec2(clip) / clip.w);
        }
    }
    if (share)
        *share = (highest - lowest) / 2.0;
    return true;
}

} // namespace

void TestDocument::whatIsAddedIsInSight_data()
{
    QTest::addColumn<glm::dvec3>("middle");
    QTest::addColumn<double>("scale");
    QTest::addColumn<bool>("fits"); // near and far are fitted
    QTest::addColumn<bool>("moves");
    const glm::dvec3 center(0.0, 0.5, 0.0);
    QTest::newRow("in sight: the camera stays") << center << 0.1 << true << false;
    QTest::newRow("beside") << glm::dvec3(40.0, 0.0, 0.0) << 1.0 << true << true;
    QTest::newRow("behind the eye") << glm::dvec3(0.0, 0.0, 100.0) << 1.0 << true << true;
    QTest::newRow("a thousand times as large") << center << 1000.0 << true << true;
    QTest::newRow("far off, near and far typed") << glm::dvec3(300.0, 0.0, 0.0) << 1.0 << false << true;
    QTest::newRow("in the picture, behind the typed far plane") << glm::dvec3(0.0, 0.0, -60.0) << 1.0 << false << false;
}

void TestDocument::whatIsAddedIsInSight()
{
    QFETCH(glm::dvec3, middle);
    QFETCH(double, scale);
    QFETCH(bool, fits);
    QFETCH(bool, moves);
    SceneDocument document;
    document.setSurface({801, 601, 1.0});
    document.setObjects({placed({0.0, 0.0, 0.0}, 1.0)},
                        {WorldPoint(0.0, 0.0, 12.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
    const Projection typed = withClipDistances(document.geometry().projection(), 1.0, 30.0);
    if (!fits)
        QVERIFY(document.editProjection({typed, true, false}, kDeed));
    const Picture before = document.geometry();
    const int steps = document.undoStack().count();
    QVERIFY(document.addObjects({placed(middle, scale)}));
    QCOMPARE(document.undoStack().count(), steps + 1);
    QVERIFY(isInSight(document, document.objects()[0]));
    QVERIFY(isInSight(document, document.objects()[1]));
    QCOMPARE(document.geometry().camera() != before.camera(), moves);
    QCOMPARE(document.scene().clipDistancesFitObjects, fits); // a rule stays what it is
    document.undoStack().undo();
    QVERIFY(document.geometry() == before);
    QCOMPARE(document.objects().size(), std::size_t(1));
}

void TestDocument::twoSizesCanBothBeSeen()
{
    SceneDocument document;
    document.setSurface({801, 601, 1.0});
    document.setObjects({placed({0.0, 0.0, 0.0}, 1.0)});
    QVERIFY(document.addObjects({placed({3.0, 0.0, 0.0}, 1e-4)}));
    for (const std::size_t place : {std::size_t(1), std::size_t(0)}) {
        document.fitObject(place);
        glm::dvec2 share(0.0);
        QVERIFY(isInSight(document, document.objects()[place], &share));
        QVERIFY(std::abs(std::max(share.x, share.y) - Framing::kFilled) < 1e-4);
    }
}

void TestDocument::openingTellsWhenAllIsInPlace()
{
    SceneDocument document;
    openScene(document);
    document.setCamera(cameraAt(7.0));
    document.pickAt(WidgetPoint(400, 300), {0.5, 0, 24});
    int tellings = 0;
    connect(&document, &SceneDocument::changed, this, [&](Changes changes) {
        ++tellings;
        QCOMPARE(changes, kSeen | Change::Pick | Change::History);
        QVERIFY(!document.pick() && !document.undoStack().canUndo());
        QVERIFY(!document.isModified() && !document.isEdited());
        QVERIFY(document.objects().empty() && document.bounds().isEmpty());
    });
    Scene empty;
    empty.projection = Ortho{-2, 2, -2, 2, 1, 50};
    QVERIFY(document.open(empty));
    QCOMPARE(tellings, 1);
}

void TestDocument::aSceneThatIsRefusedLeavesTheUndoStack()
{
    SceneDocument document;
    openScene(document);
    document.setCamera(cameraAt(7.0));
    document.pickAt(WidgetPoint(400, 300), {0.5, 0, 24});
    Scene scene;
    scene.projection = Ortho{1, 1, -2, 2, 1, 50};
    QVERIFY(!document.open(scene));
    QVERIFY(document.undoStack().canUndo() && document.pick() && document.isModified() && !document.isEdited());
}

void TestDocument::whoHearsOfAChangeMayMakeAnother()
{
    SceneDocument document;
    openScene(document);
    bool isFirst = true;
    connect(&document, &SceneDocument::changed, this, [&](Changes changes) {
        if (changes & Change::ClipPlanes && std::exchange(isFirst, false))
            QVERIFY(document.removeObject(0));
    });
    const std::size_t count = document.objects().size();
    QVERIFY(document.editClipPlanes({{0.0, 1.0, 0.0, 0.0}}, {}, kDeed));
    QCOMPARE(document.objects().size(), count - 1);
    // In the order in which they were done.
    document.undoStack().undo();
    QCOMPARE(document.objects().size(), count);
    QCOMPARE(document.scene().clipPlanes.size(), std::size_t(1));
    document.undoStack().undo();
    QVERIFY(document.scene().clipPlanes.empty());
}

void TestDocument::stepsShareTheObjects()
{
    SceneDocument document;
    openScene(document);
    const Model *teapot = document.objects()[0].model.get();
    const auto uses = [&document] { return document.objects()[0].model.use_count(); };
    const long before = uses();
    for (int i = 0; i < 100; ++i)
        document.setCamera(cameraAt(7.0 + i));
    QCOMPARE(document.undoStack().count(), 100);
    QCOMPARE(uses(), before);
    QCOMPARE(document.objects()[0].model.get(), teapot);
}

void TestDocument::nothingIsToldOfTheEnd_data()
{
    QTest::addColumn<Verb>("verb");
    QTest::newRow("steps to undo") << Verb([](SceneDocument &d) { d.setCamera(cameraAt(7.0)); });
    QTest::newRow("steps to redo") << Verb([](SceneDocument &d) {
        d.setCamera(cameraAt(7.0));
        d.undoStack().undo();
    });
    QTest::newRow("unsaved") << Verb([](SceneDocument &d) { d.markUnsaved(); });
}

void TestDocument::nothingIsToldOfTheEnd()
{
    QFETCH(Verb, verb);
    auto document = std::make_unique<SceneDocument>();
    openScene(*document);
    verb(*document);
    const Told told(*document);
    document.reset();
    QCOMPARE(told.count(), std::size_t(0));
}

QTEST_GUILESS_MAIN(TestDocument)
#include "test_document.moc"
