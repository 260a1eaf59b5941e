// The note over the view when the picture is empty.

#include "tests/support/test.h"

#include "gui/document/scene_edits.h"
#include "gui/shell/picture_note.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include <functional>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;

namespace {

using Verb = std::function<void(SceneDocument &)>;

const EditLabel kLabel{QStringLiteral("edit")};

/// The cube's faces lie from 6 to 8 in front of the eye.
void openCube(SceneDocument &document, const Projection &projection)
{
    Scene scene;
    scene.camera = scene.home = {WorldPoint(kCubeCenter + glm::dvec3(0, 0, 7)), WorldPoint(kCubeCenter), {0, 1, 0}};
    scene.projection = projection;
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    scene.objects = cubeScene();
    document.setSurface({400, 300, 1.0});
    QVERIFY(document.open(scene));
}

} // namespace

Q_DECLARE_METATYPE(unprojector::geometry::Projection)

class TestPictureNote : public QObject {
    Q_OBJECT

private slots:
    void anEmptyPictureSaysWhy_data()
    {
        addColumn<Projection>("projection");
        addColumn<bool>("isHidden");
        addColumn<QString>("said"); // nothing: no note
        const auto row = [](const char *name, const Projection &projection, const char *said, bool isHidden = false) {
            newRow(name) << projection << isHidden << QString::fromLatin1(said);
        };
        const auto ortho = [](double n, double f) { return Projection(Ortho{-3, 3, -2, 2, n, f}); };
        const auto perspective = [](double n, double f) { return Projection(Perspective{0.8, 1.3, n, f}); };
        row("all of it in between", perspective(1, 100), "");
        row("all objects hidden", perspective(1, 100), "All objects are hidden", true);
        row("near behind it", perspective(8.5, 100), "Nothing lies between near, 8.5, and far, 100");
        row("near in it", perspective(7, 100), "");
        row("far before it", perspective(1, 5.5), "Nothing lies between near, 1, and far, 5.5");
        row("far in it", perspective(1, 7), "");
        row("a box behind the eye", ortho(-10, -2),
            "Nothing lies between near, -10, and far, -2: the objects begin at 6");
        row("a box about the eye", ortho(-10, 10), "");
        row("more than the depth buffer holds", perspective(1e-9, 1e9), "the depth buffer is too coarse for it");
        row("much, but held", perspective(1e-3, 1e5), "");
        row("the same in a box", ortho(1e-9, 1e9), "");
    }

    void anEmptyPictureSaysWhy()
    {
        QFETCH(Projection, projection);
        QFETCH(bool, isHidden);
        QFETCH(QString, said);
        SceneDocument document;
        openCube(document, projection);
        if (isHidden)
            QVERIFY(setObjectHidden(document, 0, true));
        const QString text = emptyPictureText(document);
        QCOMPARE(text.isEmpty(), said.isEmpty());
        QVERIFY2(text.contains(said), qPrintable(text));
    }

    void aViewportOutsideTheWindowIsSaid_data()
    {
        addColumn<Viewport>("viewport"); // of a window of 400 x 300 pixels
        addColumn<bool>("isSaid");
        newRow("right of it") << Viewport{400, 0, 100, 100} << true;
        newRow("the last column in it") << Viewport{399, 0, 100, 100} << false;
        newRow("left of it") << Viewport{-100, 0, 100, 100} << true;
        newRow("the first column in it") << Viewport{-99, 0, 100, 100} << false;
        newRow("above it") << Viewport{0, 300, 100, 100} << true;
        newRow("below it") << Viewport{0, -100, 100, 100} << true;
        newRow("larger than it") << Viewport{-100, -100, 1000, 1000} << false;
    }

    void aViewportOutsideTheWindowIsSaid()
    {
        QFETCH(Viewport, viewport);
        QFETCH(bool, isSaid);
        SceneDocument document;
        openCube(document, Perspective{0.8, 1.3, 1, 100});
        QVERIFY(editViewport(document, {ViewportRule::Kind::Fixed, viewport, 1.0}, {}, kLabel));
        const QString text = emptyPictureText(document);
        QCOMPARE(text.contains(QStringLiteral("outside the window")), isSaid);
        QCOMPARE(text.contains(QStringLiteral("x %1, y %2").arg(viewport.x).arg(viewport.y)), isSaid);
    }

    void itComesAndGoes()
    {
        SceneDocument document;
        QWidget view;
        const PictureNote note(document, &view);
        QVERIFY(note.isHidden()); // a scene without objects is empty because it is
        openCube(document, Perspective{0.8, 1.3, 1.0, 100.0});
        QVERIFY(note.isHidden());
        QVERIFY(setObjectHidden(document, 0, true));
        QVERIFY(!note.isHidden() && note.text().contains(QStringLiteral("hidden")));
        document.undoStack().undo();
        QVERIFY(note.isHidden());
        QVERIFY(editProjection(document, {Perspective{0.8, 1.3, 50.0, 100.0}, false, false}, kLabel));
        QVERIFY(!note.isHidden() && note.text().contains(QStringLiteral("Nothing lies between")));
    }
};

UNPROJECTOR_TEST(TestPictureNote)
#include "test_picture_note.moc"
