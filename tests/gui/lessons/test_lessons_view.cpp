// The view in a lesson: it gets the size of the step's numbers, shows the step's highlights, and
// takes the step's clicks.

#include "tests/support/test.h"

#include "gui/document/landmark_placing.h"
#include "gui/document/picks.h"
#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_view.h"
#include "gui/view/highlight_marks.h"
#include "gui/view/scene_overlay.h"
#include "gui/view/scene_view.h"
#include "tests/gui/lessons/lessons_user.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QMouseEvent>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

class TestLessonsView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theViewGetsTheSizeOfTheNumbers_data()
    {
        addColumn<QSize>("size");
        newRow("larger") << QSize(1280, 800);
        newRow("with no room to spare") << QSize(1200, 760);
        newRow("with less beside the view") << QSize(1100, 700);
    }

    /// The view resizes by itself, and the window keeps its size.
    void theViewGetsTheSizeOfTheNumbers()
    {
        QFETCH(QSize, size);
        const auto window = windowOfSize(size);
        const QSize before = window->view().size();
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
        QTRY_VERIFY_WITH_TIMEOUT(!hintOf(*window), kPatienceMilliseconds);
        follow(*window, QStringLiteral("click:clicked"));
        const auto &pick = window->document().picks().pick();
        QVERIFY(pick && pick->hit());
        const WorldPoint read = *pick->point.world[Method::Formula];
        QVERIFY(distance(read, WorldPoint(3.0, -1.0, 5.0)) < 1e-4);
        window->workspaces().show(Panel::Pipeline);
        settle(*window);
        QVERIFY(isSeen(*window, "pipeline"));
        QVERIFY(part<LessonPlayer>(*window).hasViewOfStep());
        window->workspaces().hidePanels(true);
        QTRY_COMPARE_WITH_TIMEOUT(window->view().width(), window->width(),
                                  kPatienceMilliseconds); // it has the whole window
        window->workspaces().hidePanels(false);
        QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
        QCOMPARE(window->size(), size);
        QVERIFY(part<LessonPlayer>(*window).leave());
        QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), before, kPatienceMilliseconds);
    }

    /// The window grows only on request if there is no room.
    void aLinkMakesRoom()
    {
        const QSize small(820, 480); // less than the step's view by itself
        const auto window = windowOfSize(small);
        QCOMPARE(window->size(), small);
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        QVERIFY(part<LessonPlayer>(*window).step().view->y > small.height());
        settle(*window);
        QVERIFY(!part<LessonPlayer>(*window).hasViewOfStep());
        QCOMPARE(window->size(), small);
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        QVERIFY(hintOf(*window) && hintOf(*window)->text().contains(QStringLiteral("500 × 500")));
        emit hintOf(*window)->linkActivated(QStringLiteral("view:500x500"));
        QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
        QTRY_VERIFY_WITH_TIMEOUT(!hintOf(*window), kPatienceMilliseconds);
        QVERIFY(part<LessonPlayer>(*window).leave());
        QTRY_COMPARE_WITH_TIMEOUT(window->size(), small, kPatienceMilliseconds);
    }

    void theLastLinkSaysTheSize_data()
    {
        addColumn<QStringList>("links");
        newRow("larger") << QStringList{"view:300x300", "view:500x500"};
        newRow("to and fro") << QStringList{"view:300x300", "view:700x400", "view:320x340"};
    }

    void theLastLinkSaysTheSize()
    {
        QFETCH(QStringList, links);
        for (const bool atOnce : {true, false}) {
            const auto window = windowOfSize(kWide);
            QVERIFY(part<LessonPlayer>(*window).start("rows"));
            follow(*window, QStringLiteral("step:round_trip"));
            const auto hasSize = [&](const QString &link) {
                return QStringLiteral("view:%1x%2").arg(window->view().width()).arg(window->view().height()) == link;
            };
            for (const QString &link : links) {
                follow(*window, link);
                if (!atOnce)
                    QTRY_VERIFY_WITH_TIMEOUT(hasSize(link), kPatienceMilliseconds);
            }
            QTRY_VERIFY_WITH_TIMEOUT(hasSize(links.last()), kPatienceMilliseconds);
            settle(*window); // and it stays so
            QVERIFY2(hasSize(links.last()), qPrintable(links.last()));
            QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        }
    }

    void aSizeThatCannotBeIsTold()
    {
        const auto window = windowOfSize({1100, 700});
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        follow(*window, QStringLiteral("step:round_trip"));
        window->setMaximumHeight(700);
        follow(*window, QStringLiteral("view:300x900"));
        QTRY_VERIFY2_WITH_TIMEOUT(window->message().contains(QStringLiteral("it cannot be 300 × 900")),
                                  qPrintable(window->message()), kPatienceMilliseconds);
        const QString size = QStringLiteral("%1 × %2").arg(window->view().width()).arg(window->view().height());
        QVERIFY2(window->message().contains(QStringLiteral("The view is ") + size), qPrintable(window->message()));
        QVERIFY(hintOf(*window));
        QVERIFY2(hintOf(*window)->text().endsWith(QStringLiteral("This view is %1.").arg(size)),
                 qPrintable(hintOf(*window)->text()));
    }

    void aDragEndsWithItsScene()
    {
        const auto window = windowOfSize(kWide);
        const LookAt before = window->document().scene().camera;
        SceneView &view = window->view();
        const QPoint middle = view.rect().center();
        for (const Qt::KeyboardModifiers keys :
             {Qt::KeyboardModifiers(Qt::NoModifier), Qt::KeyboardModifiers(Qt::ShiftModifier)}) {
            QVERIFY(part<LessonPlayer>(*window).start("pipeline"));
            QTest::mousePress(&view, Qt::LeftButton, keys, middle);
            QVERIFY(part<LessonPlayer>(*window).leave()); // by a key
            const QPointF away = middle + QPointF(60.0, 40.0);
            QMouseEvent move(QEvent::MouseMove, away, view.mapToGlobal(away), Qt::NoButton, Qt::LeftButton, keys);
            QApplication::sendEvent(&view, &move);
            QVERIFY(window->document().scene().camera == before);
            QTest::mouseRelease(&view, Qt::LeftButton, keys, away.toPoint());
            QVERIFY(!window->document().isModified());
        }
    }

    /// A drag of a point ends with its scene, and so does the loupe over it.
    void aDraggedPointEndsWithItsScene()
    {
        const auto window = windowOfSize(kWide);
        SceneDocument &document = window->document();
        SceneView &view = window->view();
        const QImage before = view.grabFramebuffer();
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        follow(*window, QStringLiteral("view:500x500"));
        QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
        const QPointF at(112.0, 412.0); // on the cube
        const auto there =
            landmarkOnMesh(document, deviceFromWidget(document.setup().surface, view.widgetPosition(at)));
        QVERIFY(there && document.sceneLandmarks().place(*there));
        document.sceneLandmarks().selectOnly(0);
        const QImage without = view.grabFramebuffer();
        const auto send = [&](QEvent::Type type, const QPointF &way, Qt::MouseButton button, Qt::MouseButtons buttons) {
            sendMouse(view, type, at + way, button, buttons);
        };
        send(QEvent::MouseButtonPress, {}, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseMove, {20.0, 0.0}, Qt::NoButton, Qt::LeftButton);
        QVERIFY(differentPixels(without, view.grabFramebuffer()) > 1000); // the loupe
        QVERIFY(part<LessonPlayer>(*window).leave());
        const LookAt camera = document.scene().camera;
        send(QEvent::MouseMove, {40.0, 0.0}, Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, {40.0, 0.0}, Qt::LeftButton, Qt::NoButton);
        QVERIFY(document.scene().camera == camera && !document.isModified());
        QTRY_COMPARE_WITH_TIMEOUT(view.size(), before.size(), kPatienceMilliseconds);
        QTRY_COMPARE_WITH_TIMEOUT(differentPixels(before, view.grabFramebuffer()), 0, kPatienceMilliseconds);
    }

    void theCrosshairIsInTheMiddleOfAnotherScene()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("weng"));
        SceneView &view = window->view();
        const auto pixelOfEnter = [&] {
            QTest::keyClick(&view, Qt::Key_Return);
            const auto &pick = window->document().picks().pick();
            return pick ? QPoint(pick->devicePixel.i, pick->devicePixel.j) : QPoint(-1, -1);
        };
        follow(*window, QStringLiteral("click:clicked"));
        const QPoint clicked = pixelOfEnter();
        QVERIFY(player.next()); // the same scene
        QCOMPARE(pixelOfEnter(), clicked);
        QVERIFY(player.start("first"));
        QVERIFY((pixelOfEnter() - view.rect().center()).manhattanLength() <= 2);
    }

    void aClickMeetsTheStepsPointInEveryView_data()
    {
        addColumn<QByteArray>("lesson");
        addColumn<QByteArray>("step");
        addColumn<QByteArray>("point");
        addColumn<WorldPoint>("wanted");
        addColumn<double>("pixel"); // its size in the world, about
        newRow("a fixed viewport") << QByteArray("rows") << QByteArray("round_trip") << QByteArray("beside")
                                   << WorldPoint(0.5, -0.5, 0.0) << 1e-5;
        newRow("one that grows") << QByteArray("first") << QByteArray("pixel") << QByteArray("clicked")
                                 << WorldPoint(3.0, -1.0, 5.0) << 0.1;
    }

    void aClickMeetsTheStepsPointInEveryView()
    {
        QFETCH(QByteArray, lesson);
        QFETCH(QByteArray, step);
        QFETCH(QByteArray, point);
        QFETCH(WorldPoint, wanted);
        QFETCH(double, pixel);
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start(lesson.toStdString()));
        follow(*window, QStringLiteral("step:") + QString::fromLatin1(step));
        for (const QSize &size : {QSize(640, 480), QSize(420, 560)}) {
            follow(*window, QStringLiteral("view:%1x%2").arg(size.width()).arg(size.height()));
            QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), size, kPatienceMilliseconds);
            follow(*window, QStringLiteral("click:") + QString::fromLatin1(point));
            const auto &pick = window->document().picks().pick();
            QVERIFY(pick && pick->hit());
            const WorldPoint read = *pick->point.world[Method::Formula];
            QVERIFY2(std::fabs(read.x - wanted.x) <= pixel && std::fabs(read.y - wanted.y) <= pixel,
                     qPrintable(QStringLiteral("%1, %2").arg(read.x).arg(read.y)));
        }
    }

    void lettersAreDrawnWhereAStepWantsThem()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("weng"));
        follow(*window, QStringLiteral("view:500x500"));
        QTRY_VERIFY_WITH_TIMEOUT(player.hasViewOfStep(), kPatienceMilliseconds);
        // The click is on the axis of x_v, which runs along the lower edge, left of the viewport.
        const auto axis = [&] {
            const QImage picture = window->view().grabFramebuffer();
            return picture.pixelColor(50, picture.height() - 6);
        };
        const QColor empty = axis();
        follow(*window, QStringLiteral("step:viewport"));
        QTRY_VERIFY_WITH_TIMEOUT(axis().red() > axis().blue() + 80, kPatienceMilliseconds);
        follow(*window, QStringLiteral("step:frustum"));
        QTRY_COMPARE_WITH_TIMEOUT(axis(), empty, kPatienceMilliseconds);
        follow(*window, QStringLiteral("step:viewport"));
        QTRY_VERIFY_WITH_TIMEOUT(axis() != empty, kPatienceMilliseconds);
        QVERIFY(player.leave());
        QVERIFY(window->view().grabFramebuffer().pixelColor(50, window->view().height() - 6).red()
                < axis().blue() + 80);
    }

    void lettersOverlapNothing_data()
    {
        addColumn<QByteArray>("lesson");
        addColumn<QByteArray>("step");
        addColumn<QSize>("size");
        newRow("lengths") << QByteArray("weng") << QByteArray("windows") << QSize(500, 500);
        newRow("lengths in a small view") << QByteArray("weng") << QByteArray("windows") << QSize(300, 260);
        newRow("lengths of a whole view") << QByteArray("first") << QByteArray("window") << QSize(500, 500);
        newRow("axes") << QByteArray("derivation") << QByteArray("translation") << QSize(500, 500);
        newRow("axes upon each other") << QByteArray("pipeline") << QByteArray("model_view") << QSize(400, 400);
    }

    void lettersOverlapNothing()
    {
        QFETCH(QByteArray, lesson);
        QFETCH(QByteArray, step);
        QFETCH(QSize, size);
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start(lesson.toStdString()));
        QVERIFY(player.goTo(std::size_t(player.lesson()->step(step.toStdString()) - player.lesson()->steps.data())));
        follow(*window, QStringLiteral("view:%1x%2").arg(size.width()).arg(size.height()));
        QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), size, kPatienceMilliseconds);
        const Setup &g = window->document().setup();
        const double side = SceneOverlay::axesSide(*drawable(g));
        const QRectF cross(g.viewport.x, g.surface.heightPixels - g.viewport.y - side, side, side);
        const HighlightMarks marks = highlightsInView(window->document(), player.step().highlights);
        QVERIFY(marks.texts.size() >= 3);
        const std::vector<QRectF> boxes = boxesOf(marks, window->view().font(), QRectF(window->view().rect()), {cross});
        std::size_t placed = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (boxes[i].isNull())
                continue;
            ++placed;
            QVERIFY(QRectF(window->view().rect()).contains(boxes[i]) && !boxes[i].intersects(cross));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY2(!boxes[i].intersects(boxes[j]), marks.texts[i].letter.letter.c_str());
        }
        QVERIFY(placed >= 3);
        // New boxes keep clear of the previous one.
        const QRectF former = boxes.front();
        QVERIFY(!former.isNull());
        for (const QRectF &box : boxesOf(marks, window->view().font(), QRectF(window->view().rect()), {cross, former}))
            QVERIFY(!box.intersects(former));
    }

    void theViewFromOutsideComesAndGoes()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
        QVERIFY(action && !action->isChecked());
        QVERIFY(player.start("first"));
        QVERIFY(!action->isChecked());
        QVERIFY(player.goTo(3)); // the cube
        QVERIFY(isSeen(*window, "observer"));
        auto *observer = window->findChild<ObserverView *>();
        QCOMPARE(observer->morph(), 1.0);
        QVERIFY(player.goTo(4)); // the volume
        QVERIFY(isSeen(*window, "observer"));
        QCOMPARE(observer->morph(), 0.0);
        QVERIFY(player.goTo(5));
        QVERIFY(!action->isChecked() && dockOf(*window, "observer")->isHidden() && !observer->isVisible());
        action->trigger();
        QVERIFY(observer->isVisible()
                && dockOf(*window, "observer")->isHidden()); // over the view, its initial position
        observer->setMorph(0.5);
        QVERIFY(player.goTo(3));
        QCOMPARE(observer->morph(), 1.0);
        QVERIFY(player.goTo(5)); // as the user has it in the lesson
        QVERIFY(action->isChecked() && observer->isVisible() && dockOf(*window, "observer")->isHidden());
        QCOMPARE(observer->morph(), 0.5);
        QVERIFY(player.leave()); // as it was before the lesson
        QVERIFY(!action->isChecked() && !observer->isVisible() && dockOf(*window, "observer")->isHidden());
    }
};

UNPROJECTOR_TEST(TestLessonsView, display)
#include "test_lessons_view.moc"
