// The window and its lessons: their menu, their panel, what their links do.

#include "gui/lessons/lesson_player.h"
#include "gui/lessons/lesson_text.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/shell/main_window.h"
#include "gui/shell/overlay_bars.h"
#include "gui/shell/place_ids.h"
#include "gui/shell/work_places.h"
#include "gui/view/scene_view.h"

#include <nlohmann/json.hpp>

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QGridLayout>
#include <QMenu>
#include <QStatusBar>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using lessons::Highlight;

void MainWindow::createLessonsMenu(QMenu &menu)
{
    for (const Lesson &lesson : m_lessons->lessons()) {
        addAction(&menu, lessonTitle(lesson.title), {}, lessonTitle(lesson.title),
                  [this, name = lesson.name] { m_lessons->start(name); });
    }
    menu.addSeparator();
    QAction *next = addAction(&menu, tr("&Next Step"), Qt::ALT | Qt::Key_PageDown, tr("The next step of the lesson"),
                              [this] { m_lessons->next(); });
    QAction *back = addAction(&menu, tr("&Previous Step"), Qt::ALT | Qt::Key_PageUp,
                              tr("The step of the lesson before this one"), [this] { m_lessons->previous(); });
    QAction *leave =
        addAction(&menu, tr("L&eave Lesson"), {}, tr("End the lesson; the scene that was shown before it comes back"),
                  [this] { m_lessons->leave(); });
    const auto enable = [this, next, back, leave] {
        next->setEnabled(m_lessons->hasNext());
        back->setEnabled(m_lessons->hasPrevious());
        leave->setEnabled(m_lessons->lesson() != nullptr);
    };
    connect(m_lessons, &LessonPlayer::changed, &menu, enable);
    enable();
}

QString MainWindow::startLesson(const QString &nameAndStep)
{
    const std::string name = nameAndStep.section(u':', 0, 0).toStdString();
    bool isNumber = true;
    const int step = nameAndStep.contains(u':') ? nameAndStep.section(u':', 1).toInt(&isNumber) : 1;
    QStringList names;
    for (const Lesson &lesson : m_lessons->lessons()) {
        const int steps = static_cast<int>(lesson.steps.size());
        if (lesson.name == name && isNumber && step >= 1 && step <= steps) {
            if (m_lessons->start(name) && step > 1)
                m_lessons->goTo(static_cast<std::size_t>(step - 1));
            return {}; // what failed beyond that is told where every failure is
        }
        names << QStringLiteral("%1:1-%2").arg(QString::fromStdString(lesson.name)).arg(steps);
    }
    //: %2 are all lessons with their steps: first:1-7, weng:1-16
    return tr("--lesson is %1; give a lesson, or one of its steps behind a colon: %2.")
        .arg(nameAndStep, names.join(QStringLiteral(", ")));
}

void MainWindow::leaveLessonOrStay()
{
    if (m_lessons->leave())
        return;
    // Once the dock, which is only about to close, has closed.
    QTimer::singleShot(0, this, [this] {
        if (m_lessons->lesson())
            m_places->show(kLessonPanel);
    });
}

void MainWindow::putBackAfterLesson()
{
    wantViewOfLesson({}, false);
    m_places->dock(kLessonPanel)->hide();
    putObserverBack();
    putSwitchesBack();
    for (const auto &[at, panel] : std::exchange(m_panelsOfLesson, {})) {
        m_places->enter(at);
        m_places->dock(panel)->hide();
    }
    for (const auto &[at, panel] : std::exchange(m_panelsWithAnswer, {})) {
        m_places->enter(at);
        m_places->show(panel.c_str());
    }
    if (const auto before = std::exchange(m_placeBeforeLesson, std::nullopt)) {
        m_places->enter(before->place);
        for (const char *panel : before->fronts) {
            if (!m_places->dock(panel)->isHidden())
                m_places->show(panel); // where a tab went away, Qt has chosen another
        }
        m_places->hidePanels(before->arePanelsHidden);
    }
    // One that the user has made larger or smaller meanwhile stays so.
    const auto grown = std::exchange(m_grown, std::nullopt);
    if (grown && !isMaximized() && !isFullScreen() && (!grown->given.isValid() || grown->given == size()))
        resize(grown->before);
    m_lessonPlace.clear();
    m_placesWithLesson.clear();
}

void MainWindow::showLesson()
{
    showHighlights();
    placeFirstSteps();
    const Lesson *lesson = m_lessons->lesson();
    if (const std::string name = lesson ? lesson->name : std::string(); name.empty() || name != m_lessonShown) {
        putBackAfterLesson(); // a lesson begins as if none had been before it
        m_lessonShown = name;
    }
    if (!lesson)
        return;
    if (!m_placeBeforeLesson) {
        m_placeBeforeLesson = PlaceBefore{m_places->current(), m_places->arePanelsHidden(), {}};
        m_places->hidePanels(false); // a lesson speaks of them
        for (const WorkPlaces::Panel &panel : m_places->panels()) {
            if (m_places->isFront(*panel.dock))
                m_placeBeforeLesson->fronts.push_back(panel.id);
        }
        m_places->dock(kPipelinePanel)->findChild<PipelinePanel *>()->scrollToTop();
    }
    const lessons::Step &step = m_lessons->step();
    if (step.place != m_lessonPlace) {
        m_lessonPlace = step.place;
        if (!step.place.empty())
            followLessonLink(QStringLiteral("place"), QString::fromStdString(step.place));
    }
    showPanelsOfStep();
    // What it letters is to be seen.
    const bool hasCube = step.highlights.contains(Highlight::Cube);
    const bool hasObserver = std::count(step.panels.begin(), step.panels.end(), kObserverPanel) > 0;
    if (hasCube || hasObserver || step.highlights.contains(Highlight::Volume)) {
        showObserverOfLesson();
        m_observer->view().setMorph(hasCube ? 1.0 : 0.0);
    } else {
        putObserverBack();
    }
    m_places->show(kLessonPanel);
    giveLessonRoom(false);
    wantViewOfLesson(step.view ? QSize(step.view->x, step.view->y) : QSize(), false);
}

void MainWindow::giveLessonRoom(bool isAgain)
{
    if (!m_lessons->lesson() || (!m_placesWithLesson.insert(m_places->current()).second && !isAgain))
        return;
    // Once all stands where it will.
    QTimer::singleShot(0, this, [this] {
        constexpr double kShare = 0.6; // what stands above it is looked up, this is read
        QDockWidget *dock = m_places->dock(kLessonPanel);
        const int column = statusBar()->geometry().top() - m_viewFrame->geometry().top();
        if (dockWidgetArea(dock) == Qt::LeftDockWidgetArea && !dock->isFloating())
            resizeDocks({dock}, {static_cast<int>(kShare * column)}, Qt::Vertical);
    });
}

void MainWindow::showObserverOfLesson()
{
    const bool isShown = m_observerAction->isChecked();
    m_observerAction->setChecked(true);
    if (!m_observerBeforeLesson)
        m_observerBeforeLesson = ObserverBefore{isShown, !m_inset, m_observer->view().morph()};
    if (m_inset) {
        dockObserver(true);
        // Half of the height: what else there is below has less to show. Once all stands where it will.
        QTimer::singleShot(0, this,
                           [this] { resizeDocks({m_places->dock(kObserverPanel)}, {height() / 2}, Qt::Vertical); });
    }
    m_places->show(kObserverPanel);
    giveLinkedRoom(*m_places->dock(kPipelinePanel)); // but for that, where numbers stand one below the other
}

void MainWindow::putObserverBack()
{
    const auto before = std::exchange(m_observerBeforeLesson, std::nullopt);
    if (!before)
        return;
    m_observer->view().setMorph(before->morph);
    if (!before->isDocked && !m_inset)
        dockObserver(false);
    m_observerAction->setChecked(before->isShown);
    showObserver(before->isShown);
}

void MainWindow::showHighlights()
{
    const std::set<Highlight> highlights = m_lessons->lesson() ? m_lessons->step().highlights : std::set<Highlight>();
    m_view->setHighlights(highlights);
    if (m_observer)
        m_observer->view().setHighlights(highlights);
}

std::vector<std::string> MainWindow::panelsWithAnswer() const
{
    if (!m_lessons->lesson() || m_lessons->isRevealed() || !m_lessons->step().question)
        return {};
    return m_lessons->step().question->hides;
}

void MainWindow::showPanelsOfStep()
{
    hideAnswers();
    const std::vector<std::string> hidden = panelsWithAnswer();
    for (const std::string &panel : m_lessons->step().panels) { // in front of those that come back
        if (std::count(hidden.begin(), hidden.end(), panel) == 0)
            followLessonLink(QStringLiteral("panel"), QString::fromStdString(panel));
    }
}

void MainWindow::hideAnswers()
{
    const std::vector<std::string> hidden = panelsWithAnswer();
    std::erase_if(m_panelsWithAnswer, [&](const auto &one) {
        const bool comesBack =
            std::count(hidden.begin(), hidden.end(), one.second) == 0 && qstrcmp(one.first, m_places->current()) == 0;
        if (comesBack)
            m_places->show(one.second.c_str());
        return comesBack;
    });
    std::vector<QDockWidget *> docks;
    for (const std::string &panel : hidden) {
        if (QDockWidget *dock = m_places->dock(panel.c_str()); !dock->isHidden())
            docks.push_back(dock);
    }
    // One that is in front of others comes back last, and so in front again.
    std::stable_partition(docks.begin(), docks.end(), [this](QDockWidget *dock) { return !m_places->isFront(*dock); });
    for (QDockWidget *dock : docks) {
        dock->hide();
        m_panelsWithAnswer.emplace_back(m_places->current(), dock->objectName().toStdString());
    }
}

void MainWindow::showPanelOfLesson(const char *panel)
{
    if (qstrcmp(panel, kObserverPanel) == 0) { // which goes along from place to place
        showObserverOfLesson();
        return;
    }
    const bool isHidden = m_places->dock(panel)->isHidden();
    if (isHidden)
        m_panelsOfLesson.emplace_back(m_places->current(), panel);
    m_places->show(panel);
    if (isHidden)
        giveLessonRoom(true);
}

void MainWindow::followLessonLink(const QString &scheme, const QString &target)
{
    const auto isIt = [id = target.toLatin1()](const auto &one) { return id == one.id; };
    if (scheme == QLatin1String("formulas")) {
        showFormulas(target);
    } else if (scheme == QLatin1String("click")) {
        if (const auto pixel = m_lessons->clickedPixel(target.toStdString()))
            m_view->pickPixel(*pixel);
        else
            m_message->showMessage(
                tr("The point is not in the picture as it is now. Put the picture back as the step has it."));
    } else if (scheme == QLatin1String("set")) {
        const std::string change = target.toStdString();
        if (m_lessons->change(change) && m_lessons->step().changes.at(change).json().contains("point"))
            m_places->dock(kPipelinePanel)->findChild<PipelinePanel *>()->followGiven();
    } else if (scheme == QLatin1String("panel")) {
        const auto &panels = m_places->panels();
        if (const auto panel = std::find_if(panels.begin(), panels.end(), isIt); panel != panels.end())
            showPanelOfLesson(panel->id);
    } else if (scheme == QLatin1String("apart")) {
        rememberSwitches();
        showPanelOfLesson(kPipelinePanel);
        giveLinkedRoom(*m_places->dock(kPipelinePanel));
        m_places->dock(kPipelinePanel)
            ->findChild<PipelinePanel *>()
            ->takeApart(target == QLatin1String("view") ? PipelineStage::ViewMatrix : PipelineStage::ProjectionMatrix);
    } else if (scheme == QLatin1String("action")) {
        triggerForLesson(target.section(u':', 0, 0), target.section(u':', 1) == QLatin1String("off"));
    } else if (scheme == QLatin1String("place")) {
        const auto &places = m_places->places();
        if (const auto place = std::find_if(places.begin(), places.end(), isIt);
            place != places.end() && qstrcmp(place->id, m_places->current()) != 0)
            m_places->enter(place->id);
    } else if (scheme == QLatin1String("view")) {
        wantViewOfLesson({target.section(u'x', 0, 0).toInt(), target.section(u'x', 1).toInt()}, true);
    }
}

void MainWindow::triggerForLesson(const QString &name, bool isOff)
{
    QAction *action = findChild<QAction *>(name);
    if (!action)
        return;
    rememberSwitches();
    for (QObject *owner = action->parent(); owner; owner = owner->parent()) {
        if (auto *dock = qobject_cast<QDockWidget *>(owner)) { // where the switch stands
            followLessonLink(QStringLiteral("panel"), dock->objectName());
            giveLinkedRoom(*dock);
        }
    }
    if (!action->isCheckable() || action->isChecked() == isOff)
        action->trigger();
}

void MainWindow::giveLinkedRoom(QDockWidget &dock)
{
    // Once all stands where it will.
    QTimer::singleShot(0, &dock, [this, &dock] {
        const int wanted = height() * 3 / 5;
        QDockWidget *observer = m_places->dock(kObserverPanel);
        if (m_places->isFront(dock) && m_places->isFront(*observer) && dockWidgetArea(&dock) == dockWidgetArea(observer)
            && dock.height() < wanted)
            resizeDocks({&dock}, {wanted}, Qt::Vertical);
    });
}

void MainWindow::rememberSwitches()
{
    if (m_switchesBeforeLesson)
        return;
    const auto &pipeline = *m_places->dock(kPipelinePanel)->findChild<PipelinePanel *>();
    m_switchesBeforeLesson = SwitchesBefore{
        findChild<QAction *>(QStringLiteral("surface"))->actionGroup()->checkedAction()->objectName(),
        m_placingAction->isChecked(), pipeline.direction() == PipelineDirection::Backward, pipeline.matrixView()};
}

void MainWindow::putSwitchesBack()
{
    const auto before = std::exchange(m_switchesBeforeLesson, std::nullopt);
    if (!before)
        return;
    findChild<QAction *>(before->taken)->trigger();
    m_placingAction->setChecked(before->arePlaced);
    auto &pipeline = *m_places->dock(kPipelinePanel)->findChild<PipelinePanel *>();
    pipeline.setDirection(before->isBackward ? PipelineDirection::Backward : PipelineDirection::Forward);
    pipeline.setMatrixView(before->matrices);
}

void MainWindow::wantViewOfLesson(const QSize &size, bool isAskedFor)
{
    m_viewOfLesson = size;
    m_isViewAskedFor = isAskedFor;
    m_viewTrials = 0;
    fitViewOfLesson();
}

void MainWindow::fitViewOfLesson()
{
    constexpr int kMostTrials = 6;
    if (m_grown && !m_grown->given.isValid())
        m_grown->given = size();
    if (!m_viewOfLesson.isValid() || m_places->arePanelsHidden()) {
        m_viewTimer.stop();
        m_places->setLeastForView({});
        m_view->setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
        m_center->setAlignment(m_view, {}); // it fills
        return;
    }
    const QSize wanted = (QSizeF(m_viewOfLesson) / m_view->devicePixelRatioF()).toSize();
    m_places->setLeastForView(wanted);
    m_view->setMaximumSize(wanted); // what the window has more stays around it
    m_center->setAlignment(m_view, Qt::AlignCenter);
    const bool isFitted = m_view->size() == wanted && m_viewTrials > 0;
    if (isFitted || m_viewTrials == kMostTrials) {
        if (m_isViewAskedFor)
            tellOfView(isFitted);
        return;
    }
    // Panels that came, went or had other sizes find their places a little later: only what is missing then is taken from
    // outside of the window, where somebody asks for it.
    const QSize missing = (wanted - m_viewFrame->size()).expandedTo(QSize(0, 0));
    if (m_isViewAskedFor && m_viewTrials > 1 && !missing.isNull() && !isMaximized() && !isFullScreen()) {
        m_grown = Grown{m_grown ? m_grown->before : size(), {}};
        resize(size() + missing);
    }
    ++m_viewTrials;
    m_viewTimer.start();
}

void MainWindow::tellOfView(bool isFitted)
{
    const Surface &surface = m_document->geometry().surface;
    const QSize there(surface.widthPixels, surface.heightPixels);
    if (there == m_viewOfLesson)
        return;
    const auto with = [&](const QString &text) {
        return text.arg(there.width()).arg(there.height()).arg(m_viewOfLesson.width()).arg(m_viewOfLesson.height());
    };
    if (isFitted) {
        //: Sizes in pixels: what the view has, then what it should have; the last is the scale of the screen, such as 1.75.
        m_message->showMessage(
            with(tr("The view is %1 × %2 now, and cannot be %3 × %4 on a screen that is scaled by %5: "
                    "numbers differ a little from those of the text."))
                .arg(m_view->devicePixelRatioF()));
    } else {
        //: Sizes in pixels: what the view has, then what it should have.
        m_message->showMessage(
            with(tr("The view is %1 × %2 now: in this window it cannot be %3 × %4. Close panels beside "
                    "it, or take the window out of full screen.")));
    }
}

} // namespace unprojector::gui
