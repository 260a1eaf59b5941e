// A projection and a viewport of two aspects: the message over the view, and the remedy.

#include "tests/support/test.h"

#include "gui/shell/stretch_bar.h"
#include "gui/text/proportion_text.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;

namespace {

const EditLabel kLabel{QStringLiteral("edit")};

/// Opens the cube in a window of 400 x 360 pixels.
void openCube(SceneDocument &document, const Projection &projection, bool followsViewport = false)
{
    Scene scene;
    scene.camera = scene.home = {WorldPoint(kCubeCenter + glm::dvec3(0, 0, 7)), WorldPoint(kCubeCenter), {0, 1, 0}};
    scene.projection = projection;
    scene.projectionFollowsViewport = followsViewport;
    scene.clipDistancesFitObjects = false;
    scene.objects = cubeScene();
    document.setSurface({400, 360, 1.0});
    QVERIFY(document.open(scene));
}

Projection wide(double aspect)
{
    return Perspective{0.8, aspect, 1.0, 100.0};
}

QString textOf(const StretchBar &bar)
{
    return bar.findChild<QLabel *>()->text();
}

} // namespace

Q_DECLARE_METATYPE(unprojector::geometry::Projection)

class TestStretchBar : public QObject {
    Q_OBJECT

private slots:
    void itSaysBothAspects_data()
    {
        addColumn<Projection>("projection");
        addColumn<bool>("follows");
        addColumn<QString>("said"); // nothing: no bar
        const auto row = [](const char *name, const Projection &projection, const char *said, bool follows = false) {
            newRow(name) << projection << follows << QString::fromLatin1(said);
        };
        row("4 : 3 is wider", wide(4.0 / 3.0), "Projection 4 : 3, viewport 1.11 : 1: the view is stretched.");
        row("3 : 4 is higher", wide(0.75), "Projection 3 : 4, viewport 1.11 : 1: the view is stretched.");
        row("a box", Ortho{-2, 2, -1, 1, 1, 100}, "Projection 2 : 1, viewport 1.11 : 1: the view is stretched.");
        row("a box turned round", Ortho{2, -2, -1, 1, 1, 100}, "Projection 2 : 1");
        row("the viewport's", wide(400.0 / 360.0), "");
        row("nearly the viewport's", wide(400.0 / 360.0 * 1.004), "");
        row("a little more", wide(400.0 / 360.0 * 1.007), "Projection 1.12 : 1, viewport 1.11 : 1");
        row("a look-alike that follows", wide(4.0 / 3.0), "", true);
    }

    void itSaysBothAspects()
    {
        QFETCH(Projection, projection);
        QFETCH(bool, follows);
        QFETCH(QString, said);
        SceneDocument document;
        QWidget view;
        const StretchBar bar(document, &view);
        QVERIFY(bar.isHidden()); // nothing is shown yet
        openCube(document, projection, follows);
        QCOMPARE(bar.isHidden(), said.isEmpty());
        QVERIFY2(said.isEmpty() || textOf(bar).startsWith(said), qPrintable(textOf(bar)));
    }

    void textsDifferWhereAspectsDo()
    {
        const auto [one, other] = aspectTexts(1.1111, 1.1149);
        QCOMPARE(one, QStringLiteral("1.111 : 1"));
        QCOMPARE(other, QStringLiteral("1.115 : 1"));
        QCOMPARE(aspectTexts(16.0 / 9.0, 1.0).first, QStringLiteral("16 : 9"));
        QCOMPARE(aspectTexts(16.0 / 9.0, 1.0).second, QStringLiteral("1 : 1"));
    }

    void theButtonLetterboxes()
    {
        SceneDocument document;
        QWidget view;
        const StretchBar bar(document, &view);
        openCube(document, wide(4.0 / 3.0));
        QVERIFY(!bar.isHidden());
        bar.findChild<QPushButton *>()->click();
        QVERIFY(bar.isHidden());
        QVERIFY(document.setup().viewport == (Viewport{0, 30, 400, 300}));
        QVERIFY(document.setup().projection() == wide(4.0 / 3.0)); // as it was typed
        QVERIFY(!isPictureStretched(document));
        document.undoStack().undo();
        QVERIFY(!bar.isHidden());
        // A viewport of few pixels cannot have the aspect: the offer would change nothing.
        letterbox(document);
        document.setSurface({20, 31, 1.0});
        QVERIFY(bar.isHidden());
    }

    void aCamerasOwnSizeIsRight()
    {
        // fx 700, fy 705: its pixels are not square.
        SceneDocument document;
        QWidget view;
        const StretchBar bar(document, &view);
        openCube(document, wide(400.0 / 360.0));
        glm::dmat4 clip(0.0);
        clip[0][0] = 2.0 * 700.0 / 640.0;
        clip[1][1] = 2.0 * 705.0 / 480.0;
        clip[2][2] = -1.1;
        clip[3][2] = -2.1;
        clip[2][3] = -1.0;
        const MatrixProjection lens{clip, NdcDepth::MinusOneToOne};
        QVERIFY(editCamera(document, {lens, {}, {}, Surface{640, 480, 1.0}}, kLabel));
        QVERIFY2(bar.isHidden(), qPrintable(textOf(bar)));
        // In another size it is stretched.
        QVERIFY(document.edit(kLabel, [](Scene &scene) { scene.windowSize = Surface{640, 400, 1.0}; }));
        document.undoStack().undo();
        document.undoStack().undo();
        QVERIFY(editMatrices(document, lens, {}, kLabel));
        QVERIFY(!bar.isHidden());
    }

    void itIsDarkAmongDarkColours()
    {
        const auto ground = [] {
            SceneDocument document;
            QWidget view;
            StretchBar bar(document, &view);
            openCube(document, wide(2.0));
            bar.resize(500, 60);
            return bar.grab().toImage().pixelColor(4, 30).lightness();
        };
        const QPalette before = QApplication::palette();
        const int light = ground();
        QPalette dark = before;
        dark.setColor(QPalette::Window, QColor(0x20, 0x22, 0x24));
        dark.setColor(QPalette::WindowText, Qt::white);
        QApplication::setPalette(dark);
        const int found = ground();
        QApplication::setPalette(before);
        QVERIFY2(light > 200 && found < 90, qPrintable(QStringLiteral("%1 %2").arg(light).arg(found)));
    }

    void closedItStaysAway()
    {
        SceneDocument document;
        QWidget view;
        const StretchBar bar(document, &view);
        openCube(document, wide(4.0 / 3.0));
        bar.findChild<QToolButton *>()->click();
        QVERIFY(bar.isHidden());
        QVERIFY(editProjection(document, {wide(2.0), false, false}, kLabel));
        QVERIFY(bar.isHidden());
        QVERIFY(editProjection(document, {wide(400.0 / 360.0), false, false}, kLabel));
        QVERIFY(editProjection(document, {wide(2.0), false, false}, kLabel));
        QVERIFY(!bar.isHidden()); // it had gone in between
        bar.findChild<QToolButton *>()->click();
        openCube(document, wide(2.0));
        QVERIFY(!bar.isHidden()); // another scene
    }

    void lessonsSayItThemselves()
    {
        SceneDocument document;
        QWidget view;
        StretchBar bar(document, &view);
        openCube(document, wide(2.0));
        bar.setInLesson(true);
        QVERIFY(bar.isHidden());
        bar.setInLesson(false);
        QVERIFY(!bar.isHidden());
    }
};

UNPROJECTOR_TEST(TestStretchBar)
#include "test_stretch_bar.moc"
