// The document's list of objects: its edits, the part that stays visible, and undo. No window.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/told_changes.h"

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace documenttest;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;

namespace {

/// One of the bundled objects, so many times as large, with its middle there.
SceneObject placed(const glm::dvec3 &middle, double scale)
{
    SceneObject object = examples::bundledScene()[0];
    object.name = "placed";
    object.transform = {Translate{middle}, Scale{glm::dvec3(scale)}, Translate{-object.model->bounds.center()}};
    return object;
}

/// Returns whether all of an object is in the picture, and gives the share of the width and height
/// that it covers.
bool isInSight(const SceneDocument &document, const SceneObject &object, glm::dvec2 *share = nullptr)
{
    glm::dvec2 lowest(1e300), highest(-1e300);
    const glm::dmat4 clipFromObject = clipFromWorld(document.setup()).value() * worldFromObject(object.transform);
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

class TestDocumentObjects : public QObject {
    Q_OBJECT

private slots:
    void objectsComeAndGoUndoably()
    {
        SceneDocument document;
        openScene(document);
        const QStringList all = namesIn(document);
        QVERIFY(removeObject(document, 1));
        QStringList others = all;
        others.removeAt(1);
        QCOMPARE(namesIn(document), others);
        SceneObject another = examples::bundledScene()[1];
        another.name = "another";
        QVERIFY(addObjects(document, {another}));
        QCOMPARE(namesIn(document), others + QStringList(QStringLiteral("another")));
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(namesIn(document), all);
        document.undoStack().redo();
        document.undoStack().redo();
        QCOMPARE(namesIn(document), others + QStringList(QStringLiteral("another")));
        while (!document.objects().empty())
            QVERIFY(removeObject(document, 0));
        QVERIFY(document.bounds().isEmpty());
        document.undoStack().setIndex(0);
        QCOMPARE(namesIn(document), all);
        QVERIFY(!document.isEdited());
    }

    void aPickGoesWithItsObject()
    {
        SceneDocument document;
        openScene(document);
        const auto place = [&document] {
            return document.picks().pick() ? document.picks().pick()->object : std::nullopt;
        };
        using Place = std::optional<std::size_t>;
        pickAt(document, WidgetPoint(400, 300), {0.5, 1, 24});
        QCOMPARE(place(), Place(1));
        QVERIFY(addObjects(document, {examples::bundledScene()[0]}));
        QCOMPARE(place(), Place(1));
        QVERIFY(removeObject(document, 0));
        QCOMPARE(place(), Place(0));
        QVERIFY(moveObject(document, 0, 2));
        QCOMPARE(place(), Place(2));
        QVERIFY(setObjectHidden(document, 2, true));
        QCOMPARE(renameObject(document, 2, QStringLiteral("other")), NameFault::None);
        QCOMPARE(place(), Place(2));
        for (int k = 0; k < 4; ++k)
            document.undoStack().undo();
        QCOMPARE(place(), Place(1));
        QVERIFY(!document.picks().sinceClick().isObjectMoved);
        QVERIFY(removeObject(document, 1));
        QVERIFY(!document.picks().pick());
        // A click on the background is on no object.
        pickAt(document, WidgetPoint(1, 1), {1.0, std::nullopt, 24});
        QVERIFY(removeObject(document, 0));
        QVERIFY(document.picks().pick());
    }

    void objectsAreMovedInTheirList_data()
    {
        addColumn<int>("from");
        addColumn<int>("to");
        newRow("to the end") << 0 << 3;
        newRow("to the start") << 3 << 0;
        newRow("down by one") << 1 << 2;
        newRow("up by one") << 2 << 1;
    }

    void objectsAreMovedInTheirList()
    {
        QFETCH(int, from);
        QFETCH(int, to);
        SceneDocument document;
        openScene(document);
        QVERIFY(document.objects().size() >= 4);
        QStringList names = namesIn(document);
        QVERIFY(moveObject(document, static_cast<std::size_t>(from), static_cast<std::size_t>(to)));
        names.move(from, to);
        QCOMPARE(namesIn(document), names);
        const int steps = document.undoStack().count();
        QVERIFY(moveObject(document, static_cast<std::size_t>(to), static_cast<std::size_t>(to)));
        QCOMPARE(document.undoStack().count(), steps); // it is there
    }

    void hiddenObjectsAreOutOfSight()
    {
        SceneDocument document;
        std::vector<SceneObject> objects = examples::bundledScene();
        objects.resize(2);
        objects[1].transform = {Translate{{50.0, 0.0, 0.0}}};
        openObjects(document, objects);
        const Box both = document.bounds();
        QVERIFY(setObjectHidden(document, 1, true));
        QVERIFY(document.bounds().highest.x < both.highest.x - 40.0);
        fitAll(document);
        const LookAt one = document.setup().camera();
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(document.bounds().highest.x, both.highest.x);
        fitAll(document);
        QVERIFY(distance(document.setup().camera().eye, one.eye) > 10.0);
        // A hidden one can be looked at all the same, and all can be hidden.
        fitObject(document, 0);
        QVERIFY(distance(document.setup().camera().eye, one.eye) < 1e-9);
        QVERIFY(setObjectHidden(document, 0, true) && setObjectHidden(document, 1, true));
        QVERIFY(document.bounds().isEmpty());
        fitAll(document);
        fitObject(document, 1);
        QVERIFY(std::abs(document.setup().camera().center.x - both.highest.x) < 10.0);
    }

    void namesStayUnique_data()
    {
        addColumn<QString>("name");
        addColumn<int>("fault");
        newRow("another") << "bunny" << int(NameFault::None);
        newRow("beyond ASCII") << QString::fromUtf8("兔子") << int(NameFault::None);
        newRow("its own") << "1" << int(NameFault::None);
        newRow("that of another") << "0" << int(NameFault::Taken);
        newRow("that of another, in blanks") << " 0 " << int(NameFault::Taken);
        newRow("blanks") << "  " << int(NameFault::Empty);
        newRow("nothing") << "" << int(NameFault::Empty);
    }

    void namesStayUnique()
    {
        QFETCH(QString, name);
        QFETCH(int, fault);
        SceneDocument document;
        std::vector<SceneObject> objects = examples::bundledScene();
        objects.resize(2);
        objects[0].name = "0";
        objects[1].name = "1";
        openObjects(document, objects);
        QCOMPARE(int(renameObject(document, 1, name)), fault);
        QCOMPARE(document.objects()[1].name, fault == int(NameFault::None) ? name.toStdString() : "1");
        QCOMPARE(document.undoStack().count(), fault == int(NameFault::None) && name != QStringLiteral("1") ? 1 : 0);
        // An added object gets a name of its own.
        QVERIFY(addObjects(document, {objects[0], objects[0]}));
        QCOMPARE(namesIn(document).mid(2), QStringList({QStringLiteral("0 (2)"), QStringLiteral("0 (3)")}));
    }

    void whatIsAddedIsInSight_data()
    {
        addColumn<glm::dvec3>("middle");
        addColumn<double>("scale");
        addColumn<bool>("fits"); // near and far are fitted
        addColumn<bool>("moves");
        const glm::dvec3 center(0.0, 0.5, 0.0);
        newRow("in sight: the camera stays") << center << 0.1 << true << false;
        newRow("beside") << glm::dvec3(40.0, 0.0, 0.0) << 1.0 << true << true;
        newRow("behind the eye") << glm::dvec3(0.0, 0.0, 100.0) << 1.0 << true << true;
        newRow("a thousand times as large") << center << 1000.0 << true << true;
        newRow("far off, near and far typed") << glm::dvec3(300.0, 0.0, 0.0) << 1.0 << false << true;
        newRow("in the picture, behind the typed far plane") << glm::dvec3(0.0, 0.0, -60.0) << 1.0 << false << false;
    }

    void whatIsAddedIsInSight()
    {
        QFETCH(glm::dvec3, middle);
        QFETCH(double, scale);
        QFETCH(bool, fits);
        QFETCH(bool, moves);
        SceneDocument document;
        document.setSurface({801, 601, 1.0});
        openObjects(document, {placed({0.0, 0.0, 0.0}, 1.0)},
                    {WorldPoint(0.0, 0.0, 12.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
        const Projection typed = withClipDistances(document.setup().projection(), 1.0, 30.0);
        if (!fits)
            QVERIFY(editProjection(document, {typed, true, false}, kLabel));
        const Setup before = document.setup();
        const int steps = document.undoStack().count();
        QVERIFY(addObjects(document, {placed(middle, scale)}));
        QCOMPARE(document.undoStack().count(), steps + 1);
        QVERIFY(isInSight(document, document.objects()[0]));
        QVERIFY(isInSight(document, document.objects()[1]));
        QCOMPARE(document.setup().camera() != before.camera(), moves);
        QCOMPARE(document.scene().clipDistancesFitObjects, fits); // a rule stays what it is
        document.undoStack().undo();
        QVERIFY(document.setup() == before);
        QCOMPARE(document.objects().size(), std::size_t(1));
    }

    void twoSizesCanBothBeSeen()
    {
        SceneDocument document;
        document.setSurface({801, 601, 1.0});
        openObjects(document, {placed({0.0, 0.0, 0.0}, 1.0)});
        QVERIFY(addObjects(document, {placed({3.0, 0.0, 0.0}, 1e-4)}));
        for (const std::size_t index : {std::size_t(1), std::size_t(0)}) {
            fitObject(document, index);
            glm::dvec2 share(0.0);
            QVERIFY(isInSight(document, document.objects()[index], &share));
            QVERIFY(std::abs(std::max(share.x, share.y) - Framing::kFilled) < 1e-4);
        }
    }
};

UNPROJECTOR_TEST(TestDocumentObjects)
#include "test_document_objects.moc"
