// The surroundings of a lesson: panels, workspaces, switches and the window are after it as they
// were before.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/lesson_panel.h"
#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/number_grid.h"
#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QStatusBar>
#include <QTextBrowser>
#include <QToolButton>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;

namespace {

constexpr QSize kWide(1280, 800);

void follow(MainWindow &window, const QString &link)
{
    emit window.findChild<LessonPanel *>()->findChild<QTextBrowser *>()->anchorClicked(QUrl(link));
}

/// Makes the window larger by a link to a view that has no room in it, and waits until the new size
/// has taken effect.
bool grow(MainWindow &window)
{
    const int before = window.height();
    const int high = static_cast<int>(std::lround(before * window.view().devicePixelRatioF()));
    follow(window, QStringLiteral("view:%1x%1").arg(high));
    const bool hasGrown = QTest::qWaitFor(
        [&] { return window.height() > before && window.document().setup().surface.heightPixels == high; },
        kPatienceMilliseconds);
    settle(200);
    return hasGrown;
}

/// A window whose lesson is at a question that covers the panels Pipeline and Comparison.
std::unique_ptr<MainWindow> windowWithQuestion()
{
    auto window = windowOfSize(kWide);
    const bool isThere = part<LessonPlayer>(*window).start("weng") && part<LessonPlayer>(*window).goTo(1);
    return isThere && part<LessonPlayer>(*window).step().question ? std::move(window) : nullptr;
}

/// The geometry of each panel; panels behind others have none.
QMap<QString, QRect> layoutOf(MainWindow &window)
{
    QMap<QString, QRect> layout;
    for (const QDockWidget *dock : window.findChildren<QDockWidget *>()) {
        if (!dock->isHidden())
            layout[dock->objectName()] = window.workspaces().isFront(*dock) ? dock->geometry() : QRect();
    }
    layout[QStringLiteral("the view")] = window.view().geometry();
    return layout;
}

} // namespace

class TestAroundLessons : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void init()
    {
        // Windows makes no window larger than the screen.
        QWidget window;
        window.resize(kWide);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMilliseconds));
        if (window.size() != kWide)
            QSKIP("the screen has no room for the window");
    }

    void anAnswerIsCoveredInEveryWorkspace()
    {
        const auto window = windowWithQuestion();
        QVERIFY(window);
        for (const char *place : {"pipeline", "points", "click"}) {
            enter(*window, place);
            QVERIFY2(isCovered(*window, "comparison") && isCovered(*window, "pipeline"), place);
            QVERIFY2(!isCovered(*window, "objects"), place);
        }
        window->workspaces().reset();
        QVERIFY(isCovered(*window, "comparison") && isSeen(*window, "comparison"));
        // Answered one after the other: each of these steps asks for a coordinate of the same click.
        LessonPlayer &player = part<LessonPlayer>(*window);
        for (const char *id : {"look_at", "frustum", "viewport", "windows", "back", "world"}) {
            QVERIFY(player.goTo(std::size_t(player.lesson()->step(id) - player.lesson()->steps.data())));
            QVERIFY2(isCovered(*window, "comparison") && isCovered(*window, "pipeline"), id);
            player.reveal();
        }
        QVERIFY(!isCovered(*window, "comparison") && !isCovered(*window, "pipeline") && isSeen(*window, "comparison"));
    }

    /// No part moves when a panel is covered or opened, or when a verdict is shown.
    void nothingMovesWithAnAnswer()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("pipeline"));
        follow(*window, QStringLiteral("panel:pipeline"));
        QVERIFY(player.goTo(std::size_t(player.lesson()->step("viewport_50") - player.lesson()->steps.data())));
        settle(200);
        QVERIFY(isCovered(*window, "pipeline") && isSeen(*window, "pipeline"));
        auto *field = window->findChild<LessonPanel *>()->findChild<QLineEdit *>();
        const auto placeOf = [&] { return QRect(field->mapTo(window.get(), QPoint()), field->size()); };
        const QMap<QString, QRect> layout = layoutOf(*window);
        const QRect place = placeOf();
        for (const char *answer : {"0.5", "7", "2*", "(0.5 + 1) / 2"}) {
            field->setText(QLatin1String(answer));
            QTest::keyClick(field, Qt::Key_Return);
            settle(100);
            QCOMPARE(placeOf(), place);
            QCOMPARE(layoutOf(*window), layout);
        }
        QVERIFY(!isCovered(*window, "pipeline") && isSeen(*window, "pipeline"));
    }

    /// The status bar shows the world coordinate under the pointer, but not while a question asks for
    /// it.
    void theStatusBarKeepsTheAnswer()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("first"));
        // The view is 500 × 500 device pixels, as far as the screen's scale allows.
        const double ratio = window->view().devicePixelRatioF();
        const QPoint cube = (QPointF(112, 412) / ratio).toPoint();
        const QString pixel =
            QStringLiteral("pixel (%1, %2)").arg(std::floor(cube.x() * ratio)).arg(std::floor(cube.y() * ratio));
        const auto readout = [&] {
            QString text;
            for (const QLabel *label : window->statusBar()->findChildren<QLabel *>()) {
                if (label->accessibleName() == QStringLiteral("World coordinate under the pointer"))
                    text = label->text();
            }
            return text;
        };
        // On a busy machine a late layout takes the pointer from the view: it points again until it is read.
        const auto points = [&](const QString &words) {
            return QTest::qWaitFor(
                [&] {
                    if (readout().contains(words))
                        return true;
                    QTest::mouseMove(&window->view(), cube + QPoint(3, 3));
                    QTest::mouseMove(&window->view(), cube);
                    settle(200);
                    return readout().contains(words);
                },
                kPatienceMilliseconds);
        };
        follow(*window, QStringLiteral("view:500x500"));
        QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), (QSizeF(500, 500) / ratio).toSize(), kPatienceMilliseconds);
        settle(200);
        QVERIFY2(points(pixel), qPrintable(readout()));
        QVERIFY2(!readout().contains(QStringLiteral("world")), qPrintable(readout()));
        for (std::size_t i = 0; i < player.lesson()->steps.size(); ++i) {
            QVERIFY(player.goTo(i));
            if (player.step().question)
                player.reveal();
        }
        QVERIFY2(points(QStringLiteral("world")), qPrintable(readout()));
    }

    void hiddenPanelsAreHiddenAgain()
    {
        const auto window = windowOfSize(kWide);
        window->workspaces().hidePanels(true);
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        QVERIFY(!window->workspaces().arePanelsHidden() && isSeen(*window, "comparison") && isSeen(*window, "lesson"));
        QVERIFY(part<LessonPlayer>(*window).leave());
        QVERIFY(window->workspaces().arePanelsHidden());
        QVERIFY(dockOf(*window, "comparison")->isHidden());

        window->workspaces().hidePanels(false);
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        window->workspaces().hidePanels(true); // F9 gives the view the whole window
        QVERIFY(part<LessonPlayer>(*window).leave());
        QVERIFY(!window->workspaces().arePanelsHidden() && isSeen(*window, "comparison"));
    }

    void theFirstPanelIsInFrontAgain()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &lessons = part<LessonPlayer>(*window);
        for (const char *other : {"pipeline", "weng", "rows"}) {
            QVERIFY(lessons.start(other));
            while (lessons.hasNext())
                QVERIFY(lessons.next());
            QVERIFY(lessons.start("first"));
            QVERIFY2(isSeen(*window, "comparison"), other); // its first step speaks of it
        }
        QVERIFY(lessons.start("pipeline"));
        follow(*window, QStringLiteral("panel:pipeline"));
        QVERIFY(lessons.leave());
        QVERIFY(isSeen(*window, "comparison"));
    }

    void theLayoutIsExactlyAsBefore_data()
    {
        addColumn<QString>("workspace");
        addColumn<bool>("hasObserver");
        for (const char *workspace : lessons::kWorkspaceNames) {
            addRow("%s", workspace) << QString(workspace) << false;
            addRow("%s with the view from outside", workspace) << QString(workspace) << true;
        }
    }

    /// Panels, tabs and splits, also where the user has made a panel larger.
    void theLayoutIsExactlyAsBefore()
    {
        QFETCH(QString, workspace);
        QFETCH(bool, hasObserver);
        const auto window = windowOfSize(kWide);
        enter(*window, workspace.toUtf8());
        settle();
        if (hasObserver) {
            actionOf(*window, QStringLiteral("View from Outside"))->trigger();
            emit part<ObserverPanel>(*window).dockRequested(true);
            settle();
        }
        for (QDockWidget *dock :
             window->findChildren<QDockWidget *>()) { // the last one of its column has a size of its own
            if (isSeen(*window, dock->objectName().toUtf8()) && dock->objectName() != QLatin1String("observer"))
                window->resizeDocks({dock}, {dock->height() - 37}, Qt::Vertical);
        }
        window->workspaces().show(Panel::Objects);
        settle();
        const QMap<QString, QRect> before = layoutOf(*window);
        const QSize size = window->size();
        // One of them is enough beside the view from outside.
        QStringList names{QStringLiteral("pipeline")};
        if (!hasObserver)
            names << QStringLiteral("first") << QStringLiteral("weng");
        for (const QString &name : std::as_const(names)) {
            LessonPlayer &lessons = part<LessonPlayer>(*window);
            QVERIFY(lessons.start(name.toStdString()));
            while (lessons.hasNext()) {
                follow(*window, QStringLiteral("panel:lifecycle"));
                if (lessons.step().question)
                    lessons.reveal();
                QVERIFY(lessons.next());
            }
            follow(*window, QStringLiteral("place:points"));
            follow(*window, QStringLiteral("panel:observer"));
            settle();
            QVERIFY(lessons.leave());
            settle();
            QCOMPARE(window->size(), size);
            QCOMPARE(layoutOf(*window), before);
            settle(200); // later events change nothing
            QCOMPARE(layoutOf(*window), before);
        }
    }

    /// The state before each lesson: a click, panels side by side, a matrix opened and decomposed, and a
    /// number chosen.
    void theWindowIsPixelForPixelAsBefore()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        const QPoint middle = window->view().rect().center();
        QTest::mouseClick(&window->view(), Qt::LeftButton, {}, middle);
        QVERIFY(window->document().picks().pick());
        window->workspaces().show(Panel::Pipeline);
        window->workspaces().show(Panel::Inspector);
        settle(200);
        auto *pipeline = window->findChild<PipelinePanel *>();
        window->findChild<QAction *>(QStringLiteral("open_modelview"))->trigger();
        pipeline->takeApart(PipelineStage::ProjectionMatrix);
        window->findChild<QAction *>(QStringLiteral("factors_0"))->trigger();
        for (NumberGrid *grid : pipeline->findChildren<NumberGrid *>()) {
            if (grid->accessibleName().contains(QStringLiteral("eye")))
                grid->setCurrentIndex(grid->model()->index(grid->model()->rowCount() - 1, 0));
        }
        const auto picture = [&] {
            window->view().setFocus();
            QTest::mouseMove(window.get(), QPoint(5, window->height() - 5)); // where nothing lights up
            settle(300);
            return window->grab().toImage();
        };
        const QImage before = picture();
        QCOMPARE(differentPixels(before, picture()), 0); // it is still
        const PipelinePanel::Kept kept = pipeline->kept();
        QVERIFY(kept.isProjectionApart && kept.chosen);
        for (const Lesson &lesson : player.lessons()) {
            const char *name = lesson.name.c_str();
            QVERIFY2(player.start(lesson.name), name);
            QVERIFY2(!pipeline->kept().chosen && !pipeline->kept().isProjectionApart, name);
            for (std::size_t i = 0; i < player.lesson()->steps.size(); ++i) {
                QVERIFY2(player.goTo(i), name);
                follow(*window, QStringLiteral("click:clicked"));
                if (player.step().question)
                    player.reveal();
                settle(20);
            }
            for (const char *link : {"apart:view", "action:open_whole", "panel:lifecycle", "panel:observer"})
                follow(*window, QLatin1String(link));
            settle(100);
            QVERIFY2(player.leave(), name);
            const QImage now = picture();
            const PipelinePanel::Kept after = pipeline->kept();
            QVERIFY2(after.opened == kept.opened && after.areAllOpen == kept.areAllOpen && after.chosen == kept.chosen,
                     name);
            QVERIFY2(after.isProjectionApart && !after.isViewApart && after.percents == kept.percents, name);
            QVERIFY2(differentPixels(before, now) == 0, name);
        }
    }

    void whatIsPutBackHasItsClick()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &lessons = part<LessonPlayer>(*window);
        QVERIFY(lessons.start("first"));
        settle(); // the view has the step's size then
        follow(*window, QStringLiteral("click:clicked"));
        QVERIFY(window->document().picks().pick());
        QVERIFY(lessons.goTo(2)); // which speaks of the click
        const DevicePixel pixel = window->document().picks().pick()->devicePixel;
        setCamera(window->document(), LookAt{{9.0, 3.0, 12.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
        QVERIFY(!lessons.isAsTheStep());
        follow(*window, QStringLiteral("restart:"));
        QVERIFY(lessons.isAsTheStep());
        QVERIFY(window->document().picks().pick() && window->document().picks().pick()->devicePixel == pixel);
        // The lesson adds no click.
        QVERIFY(lessons.start("weng"));
        follow(*window, QStringLiteral("restart:"));
        QVERIFY(!window->document().picks().pick());
    }

    void takingApartGoesBack()
    {
        const auto window = windowOfSize(kWide);
        auto *pipeline = window->findChild<PipelinePanel *>();
        pipeline->setDirection(PipelineDirection::Backward);
        pipeline->open(PointModel::Space::Window);
        pipeline->setAllOpen(true);
        const QList<QToolButton *> apart = pipeline->findChildren<QToolButton *>(QStringLiteral("takeApart"));
        QVERIFY(part<LessonPlayer>(*window).start("derivation"));
        pipeline->setAllOpen(false);
        follow(*window, QStringLiteral("apart:projection"));
        QVERIFY(apart.back()->isChecked() && pipeline->opened() == ChainPart(PointModel::Space::Clip));
        QCOMPARE(pipeline->direction(), PipelineDirection::Forward);
        follow(*window, QStringLiteral("action:rows"));
        QVERIFY(part<LessonPlayer>(*window).leave());
        QCOMPARE(pipeline->direction(), PipelineDirection::Backward);
        QVERIFY(pipeline->opened() == ChainPart(PointModel::Space::Window) && pipeline->areAllOpen());
        QVERIFY(!apart.front()->isChecked() && !apart.back()->isChecked());
    }

    void aWindowThatGrewIsAsBefore()
    {
        const QSize before(900, 560);
        const auto window = windowOfSize(before);
        QVERIFY(part<LessonPlayer>(*window).start("weng"));
        QVERIFY(grow(*window));
        QVERIFY(part<LessonPlayer>(*window).leave());
        QTRY_COMPARE_WITH_TIMEOUT(window->size(), before, kPatienceMilliseconds);
    }

    void aWindowOfTheUsersSizeStaysSo()
    {
        const QSize before(900, 560), users(1000, 720);
        const auto window = windowOfSize(before);
        QVERIFY(part<LessonPlayer>(*window).start("weng"));
        QVERIFY(grow(*window));
        window->resize(users);
        QTRY_COMPARE_WITH_TIMEOUT(window->size(), users, kPatienceMilliseconds);
        QVERIFY(part<LessonPlayer>(*window).leave());
        settle(); // a size that is put back needs the window manager
        QCOMPARE(window->size(), users);
    }

    void theSizeOfAStepIsGivenExactly()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("weng"));
        follow(*window, QStringLiteral("view:500x500"));
        QTRY_COMPARE_WITH_TIMEOUT(window->view().width(), 500, kPatienceMilliseconds);
        QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
        QCOMPARE(window->message(), QString());
    }
};

UNPROJECTOR_TEST(TestAroundLessons, display)
#include "test_around_lessons.moc"
