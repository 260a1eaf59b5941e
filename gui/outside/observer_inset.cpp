#include "gui/outside/observer_inset.h"

#include "gui/outside/observer_panel.h"

#include <QMouseEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr QSizeF kFirstShare(0.38, 0.45);
constexpr double kLeastShare = 0.05;
constexpr double kMostShare = 0.9;
constexpr int kMargin = 8; ///< from the area's corner
constexpr int kBorder = 5; ///< that the mouse can drag

double bounded(double share)
{
    return std::clamp(share, kLeastShare, kMostShare);
}

} // namespace

ObserverInset::ObserverInset(ObserverPanel &observer, QWidget &area, const QSizeF &share)
    : QFrame(&area), m_area(area), m_share(share.isEmpty() ? kFirstShare : share)
{
    m_share = {bounded(m_share.width()), bounded(m_share.height())};
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(kBorder, kBorder, 0, 0);
    layout->addWidget(&observer);
    // Only the border is visible; the observer keeps its own pointer elsewhere.
    setCursor(Qt::SizeFDiagCursor);
    observer.setCursor(Qt::ArrowCursor);
    m_area.installEventFilter(this);
    place();
    raise();
}

void ObserverInset::place()
{
    const QSize least = layout()->minimumSize();
    const auto side = [](double share, int fewest, int whole) {
        return std::min(std::max(static_cast<int>(share * whole), fewest), whole - 2 * kMargin);
    };
    const QSize size(side(m_share.width(), least.width(), m_area.width()),
                     side(m_share.height(), least.height(), m_area.height()));
    setGeometry(
        QRect(QPoint(m_area.width() - kMargin - size.width(), m_area.height() - kMargin - size.height()), size));
}

bool ObserverInset::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_area && event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void ObserverInset::mousePressEvent(QMouseEvent *event)
{
    m_isResizing = event->button() == Qt::LeftButton;
    m_grabbed = event->pos();
}

void ObserverInset::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_isResizing || !(event->buttons() & Qt::LeftButton))
        return;
    const QPoint corner = mapToParent(event->pos() - m_grabbed);
    const auto share = [](int from, int whole) {
        return bounded(static_cast<double>(whole - kMargin - from) / std::max(whole, 1));
    };
    m_share = {share(corner.x(), m_area.width()), share(corner.y(), m_area.height())};
    place();
}

} // namespace unprojector::gui
