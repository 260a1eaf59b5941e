// Lessons in the window: every step of every lesson opens, every link of it does what it says, what it asks is checked, and
// what was shown before comes back.

#include "core/lessons/lesson.h"
#include "gui/document/lesson_player.h"
#include "gui/panels/factor_shares.h"
#include "gui/panels/factors_view.h"
#include "gui/panels/pipeline_panel.h"
#include "gui/text/formula_markup.h"
#include "gui/view/highlight_marks.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/observer_view.h"
#include "gui/view/scene_overlay.h"
#include "gui/view/scene_view.h"
#include "gui/window/first_steps.h"
#include "gui/window/lesson_panel.h"
#include "window_user.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QTextBrowser>

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

constexpr QSize kWide(1280, 800);

LessonPanel &panelOf(MainWindow &window)
{
    return *window.findChild<LessonPanel *>();
}

/// The links of a text.
QStringList linksOf(const std::vector<std::string> &paragraphs)
{
    static const QRegularExpression link(QStringLiteral("<a href='([^']*)'>"));
    QStringList links;
    for (const std::string &paragraph : paragraphs) {
        for (auto it = link.globalMatch(QString::fromStdString(paragraph)); it.hasNext();)
            links << it.next().captured(1);
    }
    return links;
}

void follow(MainWindow &window, const QString &link)
{
    emit panelOf(window).findChild<QTextBrowser *>()->anchorClicked(QUrl(link));
}

QPushButton *buttonOf(MainWindow &window, const QString &text)
{
    for (QPushButton *button : panelOf(window).findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == text)
            return button;
    }
    return nullptr;
}

/// What the panel says of an answer or of the picture: the label with this name or with a link.
QString verdictOf(MainWindow &window)
{
    for (const QLabel *label : panelOf(window).findChildren<QLabel *>()) {
        if (label->accessibleName() == QStringLiteral("Whether your answer is right"))
            return label->textFormat() == Qt::PlainText ? label->text() : QStringLiteral("markup");
    }
    return {};
}

QLabel *hintOf(MainWindow &window)
{
    for (QLabel *label : panelOf(window).findChildren<QLabel *>()) {
        if (label->text().contains(QLatin1String("<a href=")))
            return label;
    }
    return nullptr;
}

void answer(MainWindow &window, const QString &text)
{
    auto *field = panelOf(window).findChild<QLineEdit *>();
    field->setText(text);
    QTest::keyClick(field, Qt::Key_Return);
}

QSet<QString> anchorsOfHelp()
{
    QFile file(QStringLiteral(":/help/formulas.html"));
    QSet<QString> names;
    static const QRegularExpression name(QStringLiteral("<a name=['\"]([^'\"]+)['\"]"));
    const QString page = file.open(QIODevice::ReadOnly) ? typeset(QString::fromUtf8(file.readAll())) : QString();
    for (auto matches = name.globalMatch(page); matches.hasNext();)
        names.insert(matches.next().captured(1));
    return names;
}

template <class List>
bool has(const List &list, const QString &id)
{
    return std::any_of(list.begin(), list.end(), [&id](const auto &one) { return id == QLatin1String(one.id); });
}

} // namespace

class TestLessonsWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void everyStepOpensAndItsLinksLead_data();
    void everyStepOpensAndItsLinksLead();
    void anAnswerIsChecked();
    void anAnswerIsShown();
    void whatIsDoneStaysInTheSameScene();
    void whatWasShownComesBack();
    void whatCannotBeShownLeavesTheSceneThere();
    void aDragEndsWithItsScene();
    void aClosedWindowIsAsBeforeTheLesson();
    void anotherSceneEndsTheLesson();
    void theKeysGoFromStepToStep();
    void theViewGetsTheSizeOfTheNumbers_data();
    void theViewGetsTheSizeOfTheNumbers();
    void aLinkMakesRoom();
    void theLastLinkSaysTheSize_data();
    void theLastLinkSaysTheSize();
    void theNoteForNewcomersWaits();
    void aSizeThatCannotBeIsTold();
    void theCrosshairIsInTheMiddleOfAnotherScene();
    void whatHasTheAnswerWaitsForIt();
    void thePapersAnswersWait();
    void theReasonStaysInFront();
    void theViewIsCalledAsThePaperSays();
    void whatLinksSwitchGoesBack();
    void aLessonBeginsAsIfNoneHadBeenBefore();
    void whatALinkLeadsToHasRoom();
    void aLinkChangesTheScene();
    void aChangeThatDoesNotFitIsTold();
    void lettersAreDrawnWhereAStepWantsThem();
    void lettersOverlapNothing_data();
    void lettersOverlapNothing();
    void theViewFromOutsideComesAndGoes();
    void theTextHasRoomBesideOtherPanels();
    void aClickMeetsTheStepsPointInEveryView_data();
    void aClickMeetsTheStepsPointInEveryView();
};

void TestLessonsWindow::everyStepOpensAndItsLinksLead_data()
{
    QTest::addColumn<QByteArray>("name");
    const auto window = windowOfSize(kWide);
    for (const Lesson &lesson : window->lessons().lessons())
        QTest::newRow(lesson.name.c_str()) << QByteArray::fromStdString(lesson.name);
}

void TestLessonsWindow::everyStepOpensAndItsLinksLead()
{
    QFETCH(QByteArray, name);
    static const QSet<QString> formulas = anchorsOfHelp();
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
    QVERIFY(dockOf(*window, "lesson")->isHidden());
    QVERIFY(player.start(name.toStdString()));
    for (std::size_t place = 0; place < player.lesson()->steps.size(); ++place) {
        QVERIFY(player.goTo(place));
        const lessons::Step &step = player.step();
        QVERIFY(isSeen(*window, "lesson"));
        QVERIFY(step.place.empty() || step.place == window->places().current());
        QVERIFY(player.isAsTheStep());
        QVERIFY(!step.question || player.answer());
        QVERIFY2(panelOf(*window).sizeHint().width() <= 360, step.id.c_str());
        QVERIFY(!panelOf(*window).text().contains(u'{'));
        for (const std::string &panel : step.panels)
            QVERIFY2(has(window->places().panels(), QString::fromStdString(panel)), step.id.c_str());
        if (step.view) {
            follow(*window, QStringLiteral("view:%1x%2").arg(step.view->x).arg(step.view->y));
            QTRY_VERIFY2(player.hasViewOfStep(), step.id.c_str());
        }
        for (const bool isAnswered : {false, true}) {
            if (isAnswered && !step.question)
                break;
            if (isAnswered) {
                // Whatever was done until then: no panel has given it away.
                for (const std::string &panel : step.question->hides)
                    QVERIFY2(dockOf(*window, panel.c_str())->isHidden(), step.id.c_str());
                player.reveal();
                if (step.view)
                    QTRY_VERIFY2(player.hasViewOfStep(), step.id.c_str());
                for (const std::string &panel : step.panels)
                    QVERIFY2(!dockOf(*window, panel.c_str())->isHidden(), step.id.c_str());
            }
            for (const QString &link : linksOf(isAnswered ? step.question->reveal : step.text)) {
                const QByteArray where = (QString::fromStdString(step.id) + u' ' + link).toUtf8();
                const QString to = link.section(u':', 1);
                if (link.startsWith(QLatin1String("click:"))) {
                    window->document().clearPick();
                    follow(*window, link);
                    QVERIFY2(window->document().pick() && window->document().pick()->hit(), where);
                } else if (link.startsWith(QLatin1String("panel:"))) {
                    QVERIFY2(has(window->places().panels(), to), where);
                    follow(*window, link);
                    QVERIFY2(!dockOf(*window, to.toLatin1())->isHidden(), where);
                } else if (link.startsWith(QLatin1String("set:"))) {
                    const int steps = window->document().undoStack().count();
                    follow(*window, link);
                    QVERIFY2(window->document().undoStack().count() == steps + 1, where);
                    window->document().undoStack().undo();
                } else if (link == QLatin1String("apart:view")) {
                    follow(*window, link);
                    QVERIFY2(dockOf(*window, "pipeline")->findChild<FactorsView *>()->isVisible(), where);
                } else if (link.startsWith(QLatin1String("action:"))) {
                    const QList<QAction *> actions = window->findChildren<QAction *>(to.section(u':', 0, 0));
                    QVERIFY2(actions.size() == 1, where);
                    const QSignalSpy triggers(actions.front(), &QAction::triggered);
                    follow(*window, link);
                    QVERIFY2(actions.front()->isCheckable() ? actions.front()->isChecked() != to.endsWith(u":off")
                                                            : triggers.size() == 1,
                             where);
                } else if (link.startsWith(QLatin1String("apart:"))) {
                    follow(*window, link);
                    const FactorShares *shares = dockOf(*window, "pipeline")->findChildren<FactorShares *>().back();
                    QVERIFY2(shares->isVisible(), where);
                    for (const QSlider *slider : shares->findChildren<QSlider *>())
                        QTRY_VERIFY2(!slider->isVisible() || !slider->visibleRegion().isEmpty(), where);
                } else if (link.startsWith(QLatin1String("place:"))) {
                    QVERIFY2(has(window->places().places(), to), where);
                } else if (link.startsWith(QLatin1String("formulas:"))) {
                    QVERIFY2(formulas.contains(to), where);
                }
            }
        }
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
    }
}

void TestLessonsWindow::anAnswerIsChecked()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("first"));
    QVERIFY(window->lessons().goTo(1));
    const QString shown = panelOf(*window).text();
    QVERIFY(!shown.contains(QStringLiteral("312.5")));
    answer(*window, QStringLiteral("312"));
    QCOMPARE(verdictOf(*window), QStringLiteral("312 is not it. Try again, or have it shown."));
    answer(*window, QStringLiteral("-312.5"));
    QCOMPARE(verdictOf(*window), QStringLiteral("-312.5 has the wrong sign. Try again, or have it shown."));
    QCOMPARE(panelOf(*window).text(), shown);
    answer(*window, QStringLiteral("2*"));
    QCOMPARE(verdictOf(*window), QStringLiteral("“2*” ends where a number is wanted."));
    answer(*window, QStringLiteral("500 - 187.5"));
    QCOMPARE(verdictOf(*window), QStringLiteral("Right: 312.5."));
    QVERIFY(panelOf(*window).text().contains(QStringLiteral("500 − (187 + 0.5) = 312.5")));
    QVERIFY(window->lessons().goTo(2));
    QVERIFY(verdictOf(*window).isEmpty());
}

void TestLessonsWindow::anAnswerIsShown()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("pipeline"));
    follow(*window, QStringLiteral("step:model_view"));
    QVERIFY(!panelOf(*window).text().contains(QStringLiteral("m[14] = −8")));
    buttonOf(*window, QStringLiteral("Show"))->click();
    QCOMPARE(verdictOf(*window), QStringLiteral("It is -8."));
    QVERIFY(panelOf(*window).text().contains(QStringLiteral("m[14] = −8")));
}

void TestLessonsWindow::whatIsDoneStaysInTheSameScene()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
    QVERIFY(player.start("first"));
    follow(*window, QStringLiteral("view:500x500"));
    QTRY_VERIFY(player.hasViewOfStep());
    QVERIFY(!hintOf(*window));
    follow(*window, QStringLiteral("click:clicked"));
    QVERIFY(window->document().pick());
    QVERIFY(player.goTo(1));
    QVERIFY(window->document().pick());
    QCOMPARE(window->session().name(), QStringLiteral("Window Coordinates"));
    QVERIFY(window->windowTitle().contains(window->session().name()));
    LookAt turned = window->document().scene().camera;
    turned.eye = turned.eye + WorldVector(1, 0, 0);
    window->document().setCamera(turned);
    QVERIFY(!player.isAsTheStep());
    QVERIFY(hintOf(*window));
    emit hintOf(*window)->linkActivated(QStringLiteral("restart:"));
    QVERIFY(player.isAsTheStep());
    QVERIFY(!hintOf(*window));
    QVERIFY(player.goTo(2));
}

void TestLessonsWindow::whatWasShownComesBack()
{
    const auto window = windowOfSize(kWide);
    SceneDocument &document = window->document();
    window->places().enter("points");
    QVERIFY(document.editClipPlanes({{0.0, 1.0, 0.0, 0.5}}, {}, {QStringLiteral("Plane")}));
    const QString name = window->session().name();
    const Model *model = document.objects().front().model.get();
    const QSize size = window->size();
    QVERIFY(window->lessons().start("first"));
    QCOMPARE(window->places().current(), "click");
    follow(*window, QStringLiteral("view:300x900"));
    QTRY_COMPARE(window->view().size(), QSize(300, 900));
    QVERIFY(window->size() != size);
    QVERIFY(window->session().name() != name);
    follow(*window, QStringLiteral("panel:pipeline"));
    QVERIFY(isSeen(*window, "pipeline"));
    window->places().enter("pipeline"); // which has the panel as its own
    dockOf(*window, "lesson")->close();
    QVERIFY(!window->lessons().lesson());
    QVERIFY(dockOf(*window, "lesson")->isHidden());
    QCOMPARE(window->session().name(), name);
    QCOMPARE(document.objects().front().model.get(), model);
    QCOMPARE(document.scene().clipPlanes.size(), std::size_t(1));
    QVERIFY(window->session().hasUnsavedChanges());
    QCOMPARE(window->places().current(), "points");
    QCOMPARE(window->size(), size);
    window->places().enter("click");
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    window->places().enter("pipeline");
    QVERIFY(!dockOf(*window, "pipeline")->isHidden());
}

void TestLessonsWindow::whatCannotBeShownLeavesTheSceneThere()
{
    const auto window = windowOfSize(kWide);
    const QString name = window->session().name();
    Scene step = window->document().scene();
    step.camera.eye = step.camera.center;
    QVERIFY(!window->session().openLesson(step, QStringLiteral("other"), QStringLiteral("rows")));
    QCOMPARE(window->session().name(), name);
    QVERIFY(!window->message().isEmpty());
}

void TestLessonsWindow::aDragEndsWithItsScene()
{
    const auto window = windowOfSize(kWide);
    const LookAt before = window->document().scene().camera;
    SceneView &view = window->view();
    const QPoint middle = view.rect().center();
    for (const Qt::KeyboardModifiers keys :
         {Qt::KeyboardModifiers(Qt::NoModifier), Qt::KeyboardModifiers(Qt::ShiftModifier)}) {
        QVERIFY(window->lessons().start("pipeline"));
        QTest::mousePress(&view, Qt::LeftButton, keys, middle);
        QVERIFY(window->lessons().leave()); // by a key
        const QPointF away = middle + QPointF(60.0, 40.0);
        QMouseEvent move(QEvent::MouseMove, away, view.mapToGlobal(away), Qt::NoButton, Qt::LeftButton, keys);
        QApplication::sendEvent(&view, &move);
        QVERIFY(window->document().scene().camera == before);
        QTest::mouseRelease(&view, Qt::LeftButton, keys, away.toPoint());
        QVERIFY(!window->document().isModified());
    }
}

void TestLessonsWindow::aClosedWindowIsAsBeforeTheLesson()
{
    QSize size;
    {
        const auto window = windowOfSize(kWide, true);
        window->places().enter("points");
        size = window->size();
        QVERIFY(window->lessons().start("first"));
        follow(*window, QStringLiteral("view:400x900"));
        QTRY_COMPARE(window->view().size(), QSize(400, 900));
        QVERIFY(window->size() != size);
        follow(*window, QStringLiteral("panel:pipeline"));
        QVERIFY(window->close());
    }
    const auto window = windowOfSize(kWide, true);
    QCOMPARE(window->size(), size);
    QCOMPARE(window->places().current(), "points");
    QVERIFY(dockOf(*window, "lesson")->isHidden());
    window->places().enter("click");
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
}

void TestLessonsWindow::anotherSceneEndsTheLesson()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("rows"));
    const QSignalSpy changes(&window->lessons(), &LessonPlayer::changed);
    window->session().openBundledScene();
    QVERIFY(!window->lessons().lesson());
    QCOMPARE(changes.size(), 1);
    QVERIFY(dockOf(*window, "lesson")->isHidden());
    QVERIFY(!window->lessons().leave());
}

void TestLessonsWindow::theKeysGoFromStepToStep()
{
    const auto window = windowOfSize(kWide);
    QAction *next = actionOf(*window, QStringLiteral("Next Step")),
            *back = actionOf(*window, QStringLiteral("Previous Step")),
            *leave = actionOf(*window, QStringLiteral("Leave Lesson"));
    QVERIFY(!next->isEnabled() && !back->isEnabled() && !leave->isEnabled());
    QVERIFY(window->lessons().start("derivation"));
    QVERIFY(next->isEnabled() && !back->isEnabled() && leave->isEnabled());
    window->activateWindow(); // keys are for the active one
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(&window->view(), Qt::Key_PageDown, Qt::AltModifier);
    QCOMPARE(window->lessons().place(), std::size_t(1));
    auto *steps = panelOf(*window).findChild<QComboBox *>();
    QCOMPARE(steps->currentIndex(), 1);
    const std::size_t count = window->lessons().lesson()->steps.size();
    QVERIFY(steps->currentText().startsWith(QStringLiteral("2 of %1").arg(count)));
    follow(*window, QStringLiteral("step:frustum"));
    QCOMPARE(window->lessons().place(), count - 1);
    QVERIFY(!next->isEnabled() && !buttonOf(*window, QStringLiteral("Next ›"))->isEnabled());
    QTest::keyClick(&window->view(), Qt::Key_PageUp, Qt::AltModifier);
    QCOMPARE(window->lessons().place(), count - 2);
    leave->trigger();
    QVERIFY(!window->lessons().lesson() && !next->isEnabled());
}

void TestLessonsWindow::theViewGetsTheSizeOfTheNumbers_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("larger") << QSize(1280, 800);
    QTest::newRow("with less beside the view") << QSize(1100, 700);
}

/// By itself, and the window stays as it is.
void TestLessonsWindow::theViewGetsTheSizeOfTheNumbers()
{
    QFETCH(QSize, size);
    const auto window = windowOfSize(size);
    const QSize before = window->view().size();
    QVERIFY(window->lessons().start("first"));
    QTRY_VERIFY(window->lessons().hasViewOfStep());
    QTRY_VERIFY(!hintOf(*window));
    follow(*window, QStringLiteral("click:clicked"));
    const auto &pick = window->document().pick();
    QVERIFY(pick && pick->hit());
    const WorldPoint read = *pick->point.world[Method::Formula];
    QVERIFY(distance(read, WorldPoint(-1.5, 3.5, 5.0)) < 1e-5);
    window->places().show("pipeline");
    QTest::qWait(100);
    QVERIFY(window->lessons().hasViewOfStep());
    window->places().hidePanels(true);
    QTRY_VERIFY2(window->view().width() > 900, "it has the whole window");
    window->places().hidePanels(false);
    QTRY_VERIFY(window->lessons().hasViewOfStep());
    QCOMPARE(window->size(), size);
    QVERIFY(window->lessons().leave());
    QTRY_COMPARE(window->view().size(), before);
}

/// Where there is no room for it, the window grows only for who asks.
void TestLessonsWindow::aLinkMakesRoom()
{
    const QSize small(820, 500);
    const auto window = windowOfSize(small);
    QVERIFY(window->lessons().start("first"));
    QTest::qWait(500);
    QVERIFY(!window->lessons().hasViewOfStep());
    QCOMPARE(window->size(), small);
    QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
    QVERIFY(hintOf(*window) && hintOf(*window)->text().contains(QStringLiteral("500 × 500")));
    emit hintOf(*window)->linkActivated(QStringLiteral("view:500x500"));
    QTRY_VERIFY(window->lessons().hasViewOfStep());
    QTRY_VERIFY(!hintOf(*window));
    QVERIFY(window->lessons().leave());
    QTRY_COMPARE(window->size(), small);
}

void TestLessonsWindow::theLastLinkSaysTheSize_data()
{
    QTest::addColumn<QStringList>("links");
    QTest::newRow("larger") << QStringList{"view:300x300", "view:500x500"};
    QTest::newRow("to and fro") << QStringList{"view:300x300", "view:700x400", "view:320x340"};
}

void TestLessonsWindow::theLastLinkSaysTheSize()
{
    QFETCH(QStringList, links);
    for (const bool atOnce : {true, false}) {
        const auto window = windowOfSize(kWide);
        QVERIFY(window->lessons().start("rows"));
        follow(*window, QStringLiteral("step:round_trip"));
        const auto hasSize = [&](const QString &link) {
            return QStringLiteral("view:%1x%2").arg(window->view().width()).arg(window->view().height()) == link;
        };
        for (const QString &link : links) {
            follow(*window, link);
            if (!atOnce)
                QTRY_VERIFY(hasSize(link));
        }
        QTRY_VERIFY(hasSize(links.last()));
        QTest::qWait(200); // and it stays so
        QVERIFY2(hasSize(links.last()), qPrintable(links.last()));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
    }
}

void TestLessonsWindow::theNoteForNewcomersWaits()
{
    QSettings().clear();
    const auto window = windowOfSize({1100, 700}, true);
    const auto *note = window->findChild<FirstSteps *>();
    QVERIFY(note && note->isVisible());
    QVERIFY(window->lessons().start("rows"));
    QVERIFY(!note->isVisible());
    follow(*window, QStringLiteral("step:round_trip"));
    follow(*window, QStringLiteral("view:300x300"));
    QTRY_COMPARE(window->view().size(), QSize(300, 300));
    QVERIFY(window->lessons().leave());
    QVERIFY(note->isVisible());
}

void TestLessonsWindow::aSizeThatCannotBeIsTold()
{
    const auto window = windowOfSize({1100, 700});
    QVERIFY(window->lessons().start("rows"));
    follow(*window, QStringLiteral("step:round_trip"));
    window->setMaximumHeight(700);
    follow(*window, QStringLiteral("view:300x900"));
    QTRY_VERIFY2(window->message().contains(QStringLiteral("it cannot be 300 × 900")), qPrintable(window->message()));
    const QString size = QStringLiteral("%1 × %2").arg(window->view().width()).arg(window->view().height());
    QVERIFY2(window->message().contains(QStringLiteral("The view is ") + size), qPrintable(window->message()));
    QVERIFY(hintOf(*window));
    QVERIFY2(hintOf(*window)->text().endsWith(QStringLiteral("This one is %1.").arg(size)),
             qPrintable(hintOf(*window)->text()));
}

void TestLessonsWindow::theCrosshairIsInTheMiddleOfAnotherScene()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
    QVERIFY(player.start("weng"));
    SceneView &view = window->view();
    const auto pixelOfEnter = [&] {
        QTest::keyClick(&view, Qt::Key_Return);
        const auto &pick = window->document().pick();
        return pick ? QPoint(pick->devicePixel.i, pick->devicePixel.j) : QPoint(-1, -1);
    };
    follow(*window, QStringLiteral("click:clicked"));
    const QPoint clicked = pixelOfEnter();
    QVERIFY(player.next()); // the same scene
    QCOMPARE(pixelOfEnter(), clicked);
    QVERIFY(player.start("first"));
    QVERIFY((pixelOfEnter() - view.rect().center()).manhattanLength() <= 2);
}

void TestLessonsWindow::whatHasTheAnswerWaitsForIt()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
    const auto goTo = [&](const char *id) {
        return player.goTo(std::size_t(player.lesson()->step(id) - player.lesson()->steps.data()));
    };
    const auto isSaid = [&] { return panelOf(*window).text().contains(QStringLiteral("Panels that show the answer")); };
    QVERIFY(player.start("pipeline"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden() && isSaid());
    QVERIFY(goTo("load_identity")); // what it asks is of another step
    QVERIFY(isSeen(*window, "pipeline") && !isSaid());
    QVERIFY(goTo("look_at"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden() && isSaid());
    answer(*window, QStringLiteral("0.5")); // which is not it
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    answer(*window, QStringLiteral("0.75"));
    QVERIFY(isSeen(*window, "pipeline") && !isSaid());
    QVERIFY(goTo("model_view"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QTest::mouseClick(buttonOf(*window, QStringLiteral("Show")), Qt::LeftButton);
    QVERIFY(isSeen(*window, "pipeline"));
    QVERIFY(goTo("viewport_50"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QVERIFY(goTo("ortho")); // never answered
    QVERIFY(!dockOf(*window, "pipeline")->isHidden() && dockOf(*window, "comparison")->isHidden());
    QVERIFY(player.leave());
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QVERIFY(player.start("first"));
    QVERIFY(!dockOf(*window, "comparison")->isHidden());
    QVERIFY(player.next()); // asks for what it shows
    QVERIFY(dockOf(*window, "comparison")->isHidden());
    QVERIFY(player.next());
    QVERIFY(isSeen(*window, "comparison"));
    QVERIFY(player.leave());
    // The user's own stays the user's.
    window->places().show("pipeline");
    QVERIFY(player.start("pipeline"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QVERIFY(player.leave());
    QVERIFY(isSeen(*window, "pipeline"));
}

/// Whatever else was shown, what a step of the paper asks is not in sight before it is answered.
void TestLessonsWindow::thePapersAnswersWait()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("weng"));
    follow(*window, QStringLiteral("panel:pipeline"));
    for (const char *id : {"look_at", "viewport", "windows", "back", "world", "ortho", "oblique", "clip_plane"}) {
        follow(*window, QStringLiteral("step:") + QLatin1String(id));
        follow(*window, QStringLiteral("click:clicked"));
        QVERIFY2(dockOf(*window, "comparison")->isHidden() && dockOf(*window, "pipeline")->isHidden(), id);
        buttonOf(*window, QStringLiteral("Show"))->click();
        QVERIFY2(!dockOf(*window, "comparison")->isHidden() && isSeen(*window, "pipeline"), id); // as before in front
    }
}

/// In a narrow window the lesson and the panel that has the answer are tabs of one column.
void TestLessonsWindow::theReasonStaysInFront()
{
    const auto window = windowOfSize({900, 700});
    QVERIFY(window->lessons().start("weng"));
    follow(*window, QStringLiteral("step:look_at"));
    QVERIFY(isSeen(*window, "lesson"));
    buttonOf(*window, QStringLiteral("Show"))->click();
    QVERIFY(!dockOf(*window, "comparison")->isHidden() && !isSeen(*window, "comparison"));
    QVERIFY(isSeen(*window, "lesson"));
}

/// The steps on MFC: what they ask is what Life of the View writes down.
void TestLessonsWindow::theViewIsCalledAsThePaperSays()
{
    const auto window = windowOfSize(kWide);
    const auto *log = window->findChild<LifecycleLog *>();
    QVERIFY(log);
    const auto calls = [log](int first) { return log->text(first, log->rowCount() - 1); };
    QVERIFY(window->lessons().start("weng"));
    follow(*window, QStringLiteral("step:mfc"));
    QVERIFY(dockOf(*window, "lifecycle")->isHidden());
    answer(*window, QStringLiteral("5"));
    QVERIFY(dockOf(*window, "lifecycle")->isHidden());
    answer(*window, QStringLiteral("4"));
    QVERIFY(isSeen(*window, "lifecycle"));

    follow(*window, QStringLiteral("step:mfc_size"));
    follow(*window, QStringLiteral("view:500x500"));
    QTRY_VERIFY(window->lessons().hasViewOfStep());
    QTest::qWait(100);
    const int before = log->rowCount();
    follow(*window, QStringLiteral("view:500x250"));
    QTRY_COMPARE(window->view().size(), QSize(500, 250));
    QTRY_VERIFY(calls(before).contains(QStringLiteral("OnSize(500, 250)\tglViewport(0, 0, 500, 250)")));
    QTRY_VERIFY(calls(before).lastIndexOf(QStringLiteral("OnDraw"))
                > calls(before).lastIndexOf(QStringLiteral("OnSize")));
    QVERIFY2(calls(before).section(u'\n', 0, 0).contains(QStringLiteral("OnSize")), qPrintable(calls(before)));
    const auto stretch = [&] { // of a square
        const Picture &g = window->document().geometry();
        const ProjectionWindow w = projectionWindow(g.projection());
        return g.viewport.width / (w.right - w.left) / (g.viewport.height / (w.top - w.bottom));
    };
    QCOMPARE(stretch(), *window->lessons().answer());
    follow(*window, QStringLiteral("set:follows"));
    QCOMPARE(stretch(), 1.0);
    QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));

    follow(*window, QStringLiteral("step:mfc_click"));
    emit hintOf(*window)->linkActivated(QStringLiteral("restart:"));
    follow(*window, QStringLiteral("view:500x500"));
    QTRY_VERIFY(window->lessons().hasViewOfStep());
    QVERIFY(dockOf(*window, "lifecycle")->isHidden());
    follow(*window, QStringLiteral("click:clicked"));
    QVERIFY2(calls(0).contains(QStringLiteral("glReadPixels(230, %1, 1, 1,").arg(*window->lessons().answer())),
             qPrintable(calls(0)));
}

void TestLessonsWindow::whatALinkLeadsToHasRoom()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("pipeline"));
    follow(*window, QStringLiteral("step:ortho"));
    const QDockWidget *pipeline = dockOf(*window, "pipeline"), *observer = dockOf(*window, "observer");
    QTRY_VERIFY(isSeen(*window, "observer") && observer->height() > window->height() / 3);
    follow(*window, QStringLiteral("action:open_projection"));
    QTRY_VERIFY(isSeen(*window, "pipeline") && pipeline->height() > observer->height() * 4 / 3);
}

void TestLessonsWindow::whatLinksSwitchGoesBack()
{
    const auto window = windowOfSize(kWide);
    const auto isOn = [&](const char *name) { return window->findChild<QAction *>(QLatin1String(name))->isChecked(); };
    const auto *pipeline = window->findChild<PipelinePanel *>();
    window->findChild<QAction *>(QStringLiteral("edge"))->trigger();
    QVERIFY(window->lessons().start("rows"));
    for (const char *name : {"vertex", "place_points", "backward", "rows"})
        follow(*window, QStringLiteral("action:") + QLatin1String(name));
    QVERIFY(isOn("vertex") && isOn("place_points") && window->document().snap() == ray::Snap::Vertex);
    QVERIFY(pipeline->direction() == PipelineDirection::Backward && isSeen(*window, "pipeline"));
    follow(*window, QStringLiteral("action:place_points")); // which it is
    QVERIFY(isOn("place_points"));
    follow(*window, QStringLiteral("action:place_points:off"));
    QVERIFY(!isOn("place_points"));
    follow(*window, QStringLiteral("action:place_points"));
    follow(*window, QStringLiteral("action:nothing")); // what is not there does nothing
    QVERIFY(window->lessons().leave());
    QVERIFY(isOn("edge") && !isOn("place_points") && window->document().snap() == ray::Snap::Edge);
    QVERIFY(pipeline->direction() == PipelineDirection::Forward && pipeline->matrixView() == MatrixView());
}

void TestLessonsWindow::aLessonBeginsAsIfNoneHadBeenBefore()
{
    const auto window = windowOfSize(kWide);
    const QSize size = window->size();
    QVERIFY(window->lessons().start("pipeline"));
    follow(*window, QStringLiteral("view:300x900"));
    QTRY_VERIFY(window->size() != size);
    follow(*window, QStringLiteral("action:backward"));
    QVERIFY(isSeen(*window, "pipeline"));
    QVERIFY(window->lessons().start("first"));
    QTRY_COMPARE(window->size(), size);
    QVERIFY(dockOf(*window, "pipeline")->isHidden() && isSeen(*window, "lesson"));
    QCOMPARE(window->findChild<PipelinePanel *>()->direction(), PipelineDirection::Forward);
    QVERIFY(window->lessons().leave());
    QCOMPARE(window->size(), size);
    QVERIFY(dockOf(*window, "lesson")->isHidden());
}

void TestLessonsWindow::aClickMeetsTheStepsPointInEveryView_data()
{
    QTest::addColumn<QByteArray>("lesson");
    QTest::addColumn<QByteArray>("step");
    QTest::addColumn<QByteArray>("point");
    QTest::addColumn<WorldPoint>("wanted");
    QTest::addColumn<double>("pixel"); // its size in the world, about
    QTest::newRow("a fixed viewport") << QByteArray("rows") << QByteArray("round_trip") << QByteArray("beside")
                                      << WorldPoint(0.5, -0.5, 0.0) << 1e-5;
    QTest::newRow("one that grows") << QByteArray("first") << QByteArray("pixel") << QByteArray("clicked")
                                    << WorldPoint(-1.5, 3.5, 5.0) << 0.05;
}

void TestLessonsWindow::aClickMeetsTheStepsPointInEveryView()
{
    QFETCH(QByteArray, lesson);
    QFETCH(QByteArray, step);
    QFETCH(QByteArray, point);
    QFETCH(WorldPoint, wanted);
    QFETCH(double, pixel);
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start(lesson.toStdString()));
    follow(*window, QStringLiteral("step:") + QString::fromLatin1(step));
    for (const QSize &size : {QSize(640, 480), QSize(420, 560)}) {
        follow(*window, QStringLiteral("view:%1x%2").arg(size.width()).arg(size.height()));
        QTRY_COMPARE(window->view().size(), size);
        follow(*window, QStringLiteral("click:") + QString::fromLatin1(point));
        const auto &pick = window->document().pick();
        QVERIFY(pick && pick->hit());
        const WorldPoint read = *pick->point.world[Method::Formula];
        QVERIFY2(std::fabs(read.x - wanted.x) <= pixel && std::fabs(read.y - wanted.y) <= pixel,
                 qPrintable(QStringLiteral("%1, %2").arg(read.x).arg(read.y)));
    }
}

void TestLessonsWindow::lettersAreDrawnWhereAStepWantsThem()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
    QVERIFY(player.start("weng"));
    follow(*window, QStringLiteral("view:500x500"));
    QTRY_VERIFY(player.hasViewOfStep());
    // On the axis of x_v, which runs along the lower edge, left of the viewport.
    const auto axis = [&] {
        const QImage picture = window->view().grabFramebuffer();
        return picture.pixelColor(50, picture.height() - 6);
    };
    const QColor empty = axis();
    follow(*window, QStringLiteral("step:viewport"));
    QTRY_VERIFY(axis().red() > axis().blue() + 80);
    follow(*window, QStringLiteral("step:frustum"));
    QTRY_COMPARE(axis(), empty);
    follow(*window, QStringLiteral("step:viewport"));
    QTRY_VERIFY(axis() != empty);
    QVERIFY(player.leave());
    QVERIFY(window->view().grabFramebuffer().pixelColor(50, window->view().height() - 6).red() < axis().blue() + 80);
}

void TestLessonsWindow::lettersOverlapNothing_data()
{
    QTest::addColumn<QByteArray>("lesson");
    QTest::addColumn<QByteArray>("step");
    QTest::addColumn<QSize>("size");
    QTest::newRow("lengths") << QByteArray("weng") << QByteArray("windows") << QSize(500, 500);
    QTest::newRow("lengths in a small view") << QByteArray("weng") << QByteArray("windows") << QSize(300, 260);
    QTest::newRow("lengths of a whole view") << QByteArray("first") << QByteArray("window") << QSize(500, 500);
    QTest::newRow("axes") << QByteArray("pipeline") << QByteArray("plane") << QSize(500, 500);
    QTest::newRow("axes upon each other") << QByteArray("pipeline") << QByteArray("model_view") << QSize(400, 400);
}

void TestLessonsWindow::lettersOverlapNothing()
{
    QFETCH(QByteArray, lesson);
    QFETCH(QByteArray, step);
    QFETCH(QSize, size);
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
    QVERIFY(player.start(lesson.toStdString()));
    QVERIFY(player.goTo(std::size_t(player.lesson()->step(step.toStdString()) - player.lesson()->steps.data())));
    follow(*window, QStringLiteral("view:%1x%2").arg(size.width()).arg(size.height()));
    QTRY_COMPARE(window->view().size(), size);
    const Picture &g = window->document().geometry();
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
    // What was there before is kept clear of.
    const QRectF former = boxes.front();
    QVERIFY(!former.isNull());
    for (const QRectF &box : boxesOf(marks, window->view().font(), QRectF(window->view().rect()), {cross, former}))
        QVERIFY(!box.intersects(former));
}

void TestLessonsWindow::theViewFromOutsideComesAndGoes()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
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
    QVERIFY(observer->isVisible() && dockOf(*window, "observer")->isHidden()); // over the view, as it is at first
    observer->setMorph(0.5);
    QVERIFY(player.goTo(3));
    QCOMPARE(observer->morph(), 1.0);
    QVERIFY(player.leave());
    QVERIFY(action->isChecked() && observer->isVisible() && dockOf(*window, "observer")->isHidden());
    QCOMPARE(observer->morph(), 0.5);
}

void TestLessonsWindow::theTextHasRoomBesideOtherPanels()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = window->lessons();
    const QDockWidget *lesson = dockOf(*window, "lesson"), *parameters = dockOf(*window, "parameters");
    const auto isLarger = [&] {
        return isSeen(*window, "lesson") && isSeen(*window, "parameters") && lesson->height() > parameters->height();
    };
    QVERIFY(player.start("first"));
    window->places().enter("pipeline");
    QTRY_VERIFY(isLarger());
    // Drawn to another size it keeps that.
    window->resizeDocks({dockOf(*window, "lesson")}, {200}, Qt::Vertical);
    QTRY_VERIFY(!isLarger());
    QVERIFY(player.next());
    window->places().enter("click");
    window->places().enter("pipeline");
    QTest::qWait(100);
    QVERIFY(!isLarger());
}

void TestLessonsWindow::aLinkChangesTheScene()
{
    const auto window = windowOfSize(kWide);
    SceneDocument &document = window->document();
    QVERIFY(window->lessons().start("pipeline") && window->lessons().next());
    const std::optional<GivenPoint> followed = document.givenPoint();
    QVERIFY(followed);
    follow(*window, QStringLiteral("set:other"));
    QVERIFY(document.givenPoint() == (GivenPoint{ObjectPoint(2, 1, 0), followed->object}));
    QCOMPARE(document.undoStack().count(), 1); // one change for all that it says
    QVERIFY(window->lessons().isAsTheStep());
    // Where a click is followed, the link leads back to the point, which is the same already.
    const PipelineModel &model = dockOf(*window, "pipeline")->findChild<PipelinePanel *>()->model();
    QVERIFY(model.followsGiven());
    follow(*window, QStringLiteral("click:point"));
    QVERIFY(window->document().pick() && !model.followsGiven());
    follow(*window, QStringLiteral("set:other"));
    QVERIFY(model.followsGiven());
    // What was typed in another space, or removed, does not change what it says.
    for (const std::optional<GivenPoint> &typed : {std::optional<GivenPoint>{{ClipPoint(1, 2, 3, 4)}}, {}}) {
        QVERIFY(document.editGivenPoint(typed, {QStringLiteral("Typed")}));
        follow(*window, QStringLiteral("set:other"));
        QVERIFY(document.givenPoint() == (GivenPoint{ObjectPoint(2, 1, 0), followed->object}));
    }
    while (document.undoStack().canUndo())
        document.undoStack().undo();
    QVERIFY(document.givenPoint() == followed);
    follow(*window, QStringLiteral("set:none")); // what the step does not know does nothing
    QVERIFY(document.givenPoint() == followed);
    QVERIFY(window->message().isEmpty());
}

void TestLessonsWindow::aChangeThatDoesNotFitIsTold()
{
    const auto window = windowOfSize(kWide);
    SceneDocument &document = window->document();
    QVERIFY(window->lessons().start("derivation"));
    QVERIFY(window->lessons().goTo(window->lessons().lesson()->steps.size() - 1));
    // Which has no left and right to exchange.
    QVERIFY(document.editProjection({Perspective{1.0, 1.0, 1.0, 10.0}, false, false}, {QStringLiteral("Other")}));
    const int steps = document.undoStack().count();
    follow(*window, QStringLiteral("set:exchanged"));
    QCOMPARE(document.undoStack().count(), steps);
    QVERIFY2(window->message().startsWith(QStringLiteral("The scene as it is now cannot be changed so.")),
             qPrintable(window->message()));
}

QTEST_MAIN(TestLessonsWindow)
#include "test_lessons_window.moc"
