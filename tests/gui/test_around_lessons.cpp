// What stands around a lesson: panels, places, switches and the window are after it as they were before.

#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/lesson_panel.h"
#include "gui/lessons/lesson_player.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/view/scene_view.h"
#include "tests/support/patience.h"
#include "window_user.h"

#include <QTest>
#include <QTextBrowser>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

constexpr QSize kWide(1280, 800);

void follow(MainWindow &window, const QString &link)
{
    emit window.findChild<LessonPanel *>()->findChild<QTextBrowser *>()->anchorClicked(QUrl(link));
}

/// Makes the window larger than it is, by a link to a view that has no room in it, and waits until it has seen what came of
/// that.
bool grow(MainWindow &window)
{
    const int before = window.height();
    const int high = static_cast<int>(std::lround(before * window.view().devicePixelRatioF()));
    follow(window, QStringLiteral("view:%1x%1").arg(high));
    const bool hasGrown = QTest::qWaitFor(
        [&] { return window.height() > before && window.document().geometry().surface.heightPixels == high; },
        kPatienceMilliseconds);
    settle(200);
    return hasGrown;
}

/// A window whose lesson is at a question that closes the panels Pipeline and Comparison.
std::unique_ptr<MainWindow> windowWithQuestion()
{
    auto window = windowOfSize(kWide);
    const bool isThere = window->lessons().start("weng") && window->lessons().goTo(1);
    return isThere && window->lessons().step().question ? std::move(window) : nullptr;
}

} // namespace

class TestAroundLessons : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init();
    void anAnswerIsHiddenAtEveryPlace();
    void answeredPanelsComeBackAtTheirPlace();
    void hiddenPanelsAreHiddenAgain();
    void theFirstPanelIsInFrontAgain();
    void whatIsPutBackHasItsClick();
    void takingApartGoesBack();
    void aWindowThatGrewIsAsBefore();
    void aWindowOfTheUsersSizeStaysSo();
    void aSizeThatTheScreenCannotShowIsTold();
};

void TestAroundLessons::init()
{
    // Windows makes no window larger than the screen.
    QWidget window;
    window.resize(kWide);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMilliseconds));
    if (window.size() != kWide)
        QSKIP("the screen has no room for the window");
}

void TestAroundLessons::anAnswerIsHiddenAtEveryPlace()
{
    const auto window = windowWithQuestion();
    QVERIFY(window);
    QVERIFY(dockOf(*window, "comparison")->isHidden());
    for (const char *place : {"pipeline", "points", "click"}) {
        window->places().enter(place);
        QVERIFY2(dockOf(*window, "comparison")->isHidden(), place);
        QVERIFY2(dockOf(*window, "pipeline")->isHidden(), place);
    }
    window->places().reset();
    QVERIFY(dockOf(*window, "comparison")->isHidden());
    window->lessons().reveal();
    QVERIFY(isSeen(*window, "comparison"));
}

void TestAroundLessons::answeredPanelsComeBackAtTheirPlace()
{
    const auto window = windowWithQuestion();
    QVERIFY(window);
    QCOMPARE(QByteArray(window->places().current()), QByteArray("click"));
    window->places().enter("points");
    window->lessons().reveal();
    QVERIFY(dockOf(*window, "comparison")->isHidden()); // it is not of this place
    window->places().enter("click");
    QVERIFY(isSeen(*window, "comparison"));
    window->places().enter("pipeline");
    QVERIFY(isSeen(*window, "pipeline"));
}

void TestAroundLessons::hiddenPanelsAreHiddenAgain()
{
    const auto window = windowOfSize(kWide);
    window->hidePanels(true);
    QVERIFY(window->lessons().start("first"));
    QVERIFY(!window->places().arePanelsHidden() && isSeen(*window, "comparison") && isSeen(*window, "lesson"));
    QVERIFY(window->lessons().leave());
    QVERIFY(window->places().arePanelsHidden());
    QVERIFY(dockOf(*window, "comparison")->isHidden());

    window->hidePanels(false);
    QVERIFY(window->lessons().start("first"));
    window->hidePanels(true); // F9 gives the view the whole window
    QVERIFY(window->lessons().leave());
    QVERIFY(!window->places().arePanelsHidden() && isSeen(*window, "comparison"));
}

void TestAroundLessons::theFirstPanelIsInFrontAgain()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &lessons = window->lessons();
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

void TestAroundLessons::whatIsPutBackHasItsClick()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &lessons = window->lessons();
    QVERIFY(lessons.start("first"));
    follow(*window, QStringLiteral("click:clicked"));
    QVERIFY(window->document().pick());
    QVERIFY(lessons.goTo(2)); // which speaks of the click
    const DevicePixel pixel = window->document().pick()->devicePixel;
    setCamera(window->document(), LookAt{{9.0, 3.0, 12.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
    QVERIFY(!lessons.isAsTheStep());
    follow(*window, QStringLiteral("restart:"));
    QVERIFY(lessons.isAsTheStep());
    QVERIFY(window->document().pick() && window->document().pick()->devicePixel == pixel);
    // Nothing is clicked that was not.
    QVERIFY(lessons.start("weng"));
    follow(*window, QStringLiteral("restart:"));
    QVERIFY(!window->document().pick());
}

void TestAroundLessons::takingApartGoesBack()
{
    const auto window = windowOfSize(kWide);
    auto *pipeline = window->findChild<PipelinePanel *>();
    pipeline->setDirection(PipelineDirection::Backward);
    QVERIFY(window->lessons().start("derivation"));
    follow(*window, QStringLiteral("apart:projection"));
    QCOMPARE(pipeline->direction(), PipelineDirection::Forward);
    follow(*window, QStringLiteral("action:rows"));
    QVERIFY(window->lessons().leave());
    QCOMPARE(pipeline->direction(), PipelineDirection::Backward);
}

void TestAroundLessons::aWindowThatGrewIsAsBefore()
{
    const QSize before(900, 560);
    const auto window = windowOfSize(before);
    QVERIFY(window->lessons().start("weng"));
    QVERIFY(grow(*window));
    QVERIFY(window->lessons().leave());
    QTRY_COMPARE_WITH_TIMEOUT(window->size(), before, kPatienceMilliseconds);
}

void TestAroundLessons::aWindowOfTheUsersSizeStaysSo()
{
    const QSize before(900, 560), users(1000, 720);
    const auto window = windowOfSize(before);
    QVERIFY(window->lessons().start("weng"));
    QVERIFY(grow(*window));
    window->resize(users);
    QTRY_COMPARE_WITH_TIMEOUT(window->size(), users, kPatienceMilliseconds);
    QVERIFY(window->lessons().leave());
    settle(); // a size that is put back needs the window manager
    QCOMPARE(window->size(), users);
}

void TestAroundLessons::aSizeThatTheScreenCannotShowIsTold()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("weng"));
    const double ratio = window->view().devicePixelRatioF();
    const int logical = static_cast<int>(std::lround(500 / ratio));
    const int device = static_cast<int>(std::floor(logical * ratio + 0.5)); // of a widget that is so large
    follow(*window, QStringLiteral("view:500x500"));
    QTRY_COMPARE_WITH_TIMEOUT(window->view().width(), logical, kPatienceMilliseconds);
    if (device == 500) {
        QTRY_VERIFY_WITH_TIMEOUT(window->lessons().hasViewOfStep(), kPatienceMilliseconds);
        QCOMPARE(window->message(), QString());
    } else {
        QTRY_VERIFY_WITH_TIMEOUT(window->message().contains(QString::number(device))
                                     && window->message().contains(QStringLiteral("500")),
                                 kPatienceMilliseconds);
        QVERIFY(window->message().contains(QString::number(ratio)));
        QVERIFY(!window->lessons().hasViewOfStep());
    }
}

QTEST_MAIN(TestAroundLessons)
#include "test_around_lessons.moc"
