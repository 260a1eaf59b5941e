// The language of the window, and how it comes to speak another one.

#include "gui/doctor/doctor_panel.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/landmark_tool.h"
#include "gui/landmarks/point_templates.h"
#include "gui/landmarks/points_panel.h"
#include "gui/lessons/formulas_window.h"
#include "gui/lessons/lesson_panel.h"
#include "gui/lessons/lesson_player.h"
#include "gui/map/map_overlay.h"
#include "gui/map/map_panel.h"
#include "gui/outside/observer_inset.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/parameters/parameters_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/shell/key_sheet.h"
#include "gui/shell/main_window.h"
#include "gui/shell/overlay_bars.h"
#include "gui/shell/place_ids.h"
#include "gui/shell/scene_code_window.h"
#include "gui/shell/widget_state.h"
#include "gui/shell/work_places.h"
#include "gui/text/translation.h"
#include "gui/view/scene_view.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>
#include <QVBoxLayout>

#include <memory>
#include <optional>
#include <utility>

namespace unprojector::gui {
namespace {

QString whereToGetFont()
{
#ifdef Q_OS_WIN
    return MainWindow::tr("Add Chinese in Settings > Time & Language > Language.");
#else
    return MainWindow::tr("Install one, such as the package fonts-noto-cjk of Debian and Ubuntu.");
#endif
}

} // namespace

QString missingFontText()
{
    return MainWindow::tr(
               "The program speaks Chinese, but no font here has its characters. %1 Then start the program again.")
        .arg(whereToGetFont());
}

void MainWindow::createLanguageMenu(QMenu &menu)
{
    Translation &translation = *m_options.translation;
    auto *group = new QActionGroup(&menu);
    menu.setToolTipsVisible(true); // they say why there is no Chinese
    const auto add = [&](Language language, const QString &text, const QString &tip) {
        QAction *action = addAction(&menu, text, {}, tip, [this, &translation, language] {
            if (m_options.remembers)
                QSettings().setValue(QStringLiteral("window/language"), languageName(language));
            translation.choose(language);
        });
        action->setCheckable(true);
        action->setActionGroup(group);
        action->setChecked(language == translation.choice());
        return action;
    };
    add(Language::System, tr("&System"), tr("The language of the desktop, if the program speaks it"));
    // In their own words: whoever cannot read the others finds them.
    add(Language::English, QStringLiteral("&English"), QStringLiteral("All texts in English"));
    QAction *chinese = add(Language::Chinese, QStringLiteral("简体中文(&C)"), QStringLiteral("所有文字用简体中文显示"));
    if (!translation.hasHanzi()) {
        chinese->setEnabled(false);
        chinese->setText(QStringLiteral("&Chinese, simplified"));
        chinese->setToolTip(
            tr("No font here has Chinese characters. %1 Then start the program again.").arg(whereToGetFont()));
    }
}

void MainWindow::tellOfFont()
{
    const QString key = QStringLiteral("window/fontHintIsShown");
    if (!m_options.remembers || !m_options.translation || !m_options.translation->lacksFont() || !message().isEmpty()
        || QSettings().value(key, false).toBool())
        return;
    m_message->showMessage(missingFontText());
    QSettings().setValue(key, true);
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

/// What stood in the window in the former language. It goes when what takes its place has taken over from it.
struct MainWindow::Former {
    QWidget home; ///< of the panels
    std::vector<WorkPlaces::Panel> panels;
    const PipelinePanel *pipeline;
    const ParametersPanel *parameters;
    const DoctorPanel *doctor;
    const LessonPanel *lesson;
    const MapPanel *mapPanel;
    std::unique_ptr<MapOverlay> map;
    std::unique_ptr<ObserverPanel> observer; ///< none: it was not asked for yet
    bool isObserverShown, isObserverDocked, isMapShown;
    WorkPlaces::Standing standing;
    QByteArray folds;
    QString message;
};

void MainWindow::retranslate()
{
    setUpdatesEnabled(false);
    emit m_session->typedToCount();
    m_document->retranslate();
    m_lessons->retranslate();
    m_templates->retranslate();
    Former former;
    putAside(former);
    build();
    takeOver(former);
    reopenWindows();
    activateWindow(); // the menu was this window's
    m_view->setFocus();
    setUpdatesEnabled(true);
    for (const WorkPlaces::Panel &panel : m_places->panels())
        panel.dock->setUpdatesEnabled(true); // a window of its own by now, it does not have it from this one
}

void MainWindow::putAside(Former &former)
{
    former.standing = m_places->standing();
    former.folds = m_parameters->saveState();
    former.message = message();
    former.isMapShown = m_map->isShown();
    m_map->setShown(false); // what is computed is given up; the other one asks again
    former.isObserverShown = m_observerAction->isChecked();
    former.isObserverDocked = !m_inset;

    former.pipeline = m_places->dock(kPipelinePanel)->findChild<PipelinePanel *>();
    former.parameters = m_parameters;
    former.doctor = m_doctor;
    former.lesson = m_lessonPanel;
    former.panels = m_places->panels();
    for (const WorkPlaces::Panel &panel : former.panels) {
        removeDockWidget(panel.dock);
        panel.dock->setParent(&former.home);
    }
    m_map->panel().setParent(&former.home);
    former.mapPanel = &m_map->panel();
    former.map.reset(std::exchange(m_map, nullptr));
    // An OpenGL widget stays in its window.
    former.observer.reset(std::exchange(m_observer, nullptr));
    if (former.observer) {
        former.observer->hide();
        former.observer->setParent(m_viewFrame);
    }
    if (m_inset)
        m_insetShare = m_inset->share();
    delete std::exchange(m_inset, nullptr);
    delete std::exchange(m_places, nullptr);
    delete std::exchange(m_overlays, nullptr);
    for (QWidget *over : m_viewFrame->findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
        if (over != m_view && over != former.observer.get())
            delete over;
    }
    m_firstSteps = nullptr;
    QToolBar *bar = findChild<QToolBar *>(QStringLiteral("tools"));
    removeToolBar(bar);
    delete bar;
    // At once: as long as there are two menus, no key is clear.
    QMenuBar *menus = menuBar();
    setMenuBar(new QMenuBar);
    delete menus;
    setStatusBar(nullptr);
}

void MainWindow::takeOver(const Former &former)
{
    for (const WorkPlaces::Panel &panel : former.panels) {
        if (!panel.widget->isAncestorOf(former.doctor)) // it has rows of its own
            takeOverState(*m_places->dock(panel.id)->widget(), *panel.widget);
    }
    m_places->dock(kPipelinePanel)->findChild<PipelinePanel *>()->takeOver(*former.pipeline);
    m_doctor->takeOver(*former.doctor);
    m_parameters->takeOver(*former.parameters);
    m_lessonPanel->takeOver(*former.lesson);
    m_parameters->restoreState(former.folds);
    takeOverState(m_map->panel(), *former.mapPanel);
    if (former.observer) { // hidden too: a lesson may know how it was before
        createObserver(former.isObserverDocked);
        m_observer->view().takeOver(former.observer->view());
        m_observerAction->setChecked(former.isObserverShown);
        showObserver(former.isObserverShown);
    }
    m_places->restore(former.standing);
    m_mapAction->setChecked(former.isMapShown);
    m_placingAction->setChecked(m_landmarkTool->isPlacing());
    m_pointsPanel->setPlacing(m_landmarkTool->isPlacing());
    if (m_session->isLoading())
        m_loading->start();
    m_recovery->offer(m_session->offered());
    if (!former.message.isEmpty())
        m_message->showMessage(former.message);
    if (m_areFirstStepsShown)
        showFirstSteps(true);
    showName();
    if (m_lessons->lesson() && m_viewOfLesson.isValid()) // the bars around it are higher in some languages
        wantViewOfLesson(m_viewOfLesson, m_isViewAskedFor);
}

void MainWindow::reopenWindows()
{
    const auto again = [](auto *&window, auto show) {
        const auto *before = std::exchange(window, nullptr);
        if (!before)
            return;
        const bool isShown = before->isVisible();
        const QRect place = before->geometry();
        if (isShown) {
            show();
            takeOverState(*window, *before);
            window->setGeometry(place);
        }
        delete before;
    };
    const std::optional<FormulasWindow::Reading> reading =
        m_formulas ? std::optional(m_formulas->reading()) : std::nullopt;
    again(m_formulas, [this] { showFormulas({}); });
    if (m_formulas)
        m_formulas->setReading(*reading);
    again(m_keys, [this] { showKeys(); });
    again(m_code, [this] { showCode(); });
}

} // namespace unprojector::gui
