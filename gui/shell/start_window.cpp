#include "gui/shell/start_window.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/lesson_player.h"
#include "gui/shell/main_window.h"
#include "gui/shell/start_options.h"
#include "gui/view/scene_view.h"
#include "gui/window/scan_list.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QSettings>

namespace unprojector::gui {
namespace {

/// Picks a pixel of the bundled scene as an example: on the teapot, in any window. Picks again
/// after a change of the view's size, until the user does something in the window.
class ExamplePick : public QObject {
public:
    explicit ExamplePick(MainWindow &window) : QObject(&window), m_window(window)
    {
        connect(&window.view(), &QOpenGLWidget::frameSwapped, this, &ExamplePick::pick);
        qApp->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::KeyPress:
        case QEvent::Wheel:
        case QEvent::Drop: m_isOver = true; break;
        default: break;
        }
        return QObject::eventFilter(watched, event);
    }

private:
    void pick()
    {
        SceneView &view = m_window.view();
        if (m_isOver || m_window.session().isLoading() || view.isCoarse() || view.size() == m_picked)
            return;
        m_picked = view.size();
        constexpr double kAcross = 0.4, kDown = 0.51; // clear of the view from outside
        view.onLButtonDown(geometry::WidgetPoint(kAcross * view.width(), kDown * view.height()));
    }

    MainWindow &m_window;
    QSize m_picked; ///< the view's size at the pick
    bool m_isOver = false;
};

/// Shows the ray of the pick in the view from outside, at the very first start.
void showFromOutside(MainWindow &window)
{
    if (!QSettings().contains(QStringLiteral("observer/isShown")))
        window.findChild<QAction *>(QStringLiteral("outside"))->setChecked(true);
}

} // namespace

QString startWindow(MainWindow &window, const StartOptions &options)
{
    if (options.windowSize)
        window.resize(*options.windowSize);
    if (options.workspace)
        window.workspaces().enter(*options.workspace);
    if (!options.hasPanels)
        window.workspaces().hidePanels(true);
    if (options.series) {
        if (window.scans().open(std::filesystem::path(options.series->toStdU16String())))
            window.workspaces().show(Panel::Series);
    } else if (options.files.empty())
        window.session().openBundledScene();
    else
        window.session().openFiles(options.files);
    window.session().offerRecovery();
    window.show();
    if (options.lesson) {
        if (QString mistake = window.findChild<LessonPlayer *>()->startAt(*options.lesson); !mistake.isEmpty())
            return mistake;
    }
    if (options.viewSize)
        window.setViewSize(*options.viewSize);
    if (!options.isScreenshotRun() && options.files.empty() && !options.lesson && !options.series) {
        new ExamplePick(window);
        showFromOutside(window);
    }
    return {};
}

} // namespace unprojector::gui
