#include "gui/lessons/view_resizer.h"

#include "gui/document/scene_document.h"
#include "gui/view/scene_view.h"
#include "gui/window/view_frame.h"
#include "gui/window/window.h"

#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

/// The time that panels and window manager need after a change of the window's size.
constexpr int kSettlingMilliseconds = 40;

} // namespace

ViewResizer::ViewResizer(Window &window, QObject *parent) : QObject(parent), m_window(window)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(kSettlingMilliseconds);
    connect(&m_timer, &QTimer::timeout, this, &ViewResizer::fit);
}

void ViewResizer::want(const QSize &size, bool isAskedFor)
{
    m_size = size;
    m_isAskedFor = isAskedFor;
    m_trials = 0;
    fit();
}

void ViewResizer::fit()
{
    constexpr int kMostTrials = 6;
    Workspaces &workspaces = m_window.workspaces();
    if (m_grown && !m_grown->given.isValid())
        m_grown->given = m_window.size();
    if (!m_size.isValid() || workspaces.arePanelsHidden()) {
        m_timer.stop();
        workspaces.setLeastForView({});
        m_window.frame().limitView({});
        return;
    }
    const SceneView &view = m_window.view();
    const QSize wanted = (QSizeF(m_size) / view.devicePixelRatioF()).toSize();
    workspaces.setLeastForView(wanted);
    m_window.frame().limitView(wanted);
    const bool isFitted = view.size() == wanted && m_trials > 0;
    if (isFitted || m_trials == kMostTrials) {
        if (m_isAskedFor)
            tell(isFitted);
        return;
    }
    // Qt lays panels out a little later. If the view is still too small then, a link that asks for
    // a size enlarges the window.
    const QSize missing = (wanted - m_window.frame().size()).expandedTo(QSize(0, 0));
    if (m_isAskedFor && m_trials > 1 && !missing.isNull() && !m_window.isMaximized() && !m_window.isFullScreen()) {
        m_grown = Grown{m_grown ? m_grown->before : m_window.size(), {}};
        m_window.resize(m_window.size() + missing);
    }
    ++m_trials;
    m_timer.start();
}

void ViewResizer::tell(bool isFitted)
{
    const Surface &surface = m_window.document().setup().surface;
    const QSize there(surface.widthPixels, surface.heightPixels);
    if (there == m_size)
        return;
    const auto with = [&](const QString &text) {
        return text.arg(there.width()).arg(there.height()).arg(m_size.width()).arg(m_size.height());
    };
    if (isFitted) {
        //: Sizes in pixels: what the view has, then what it should have;
        //: the last is the scale of the screen, such as 1.75.
        m_window.showMessage(with(tr("The view is %1 × %2 now. It cannot be %3 × %4 on a screen scaled by %5: numbers "
                                     "differ a little from the text."))
                                 .arg(m_window.view().devicePixelRatioF()));
    } else {
        //: Sizes in pixels: what the view has, then what it should have.
        m_window.showMessage(
            with(tr("The view is %1 × %2 now: in this window it cannot be %3 × %4. Close panels beside "
                    "it, or take the window out of full screen.")));
    }
}

void ViewResizer::shrinkBack()
{
    const auto grown = std::exchange(m_grown, std::nullopt);
    if (grown && !m_window.isMaximized() && !m_window.isFullScreen()
        && (!grown->given.isValid() || grown->given == m_window.size()))
        m_window.resize(grown->before);
}

} // namespace unprojector::gui
