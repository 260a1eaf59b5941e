#include "gui/widgets/figure_view.h"

#include "gui/text/figures/help_figures.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {

FigureView::FigureView(const QString &name, QWidget *parent) : QWidget(parent), m_name(name)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

QSize FigureView::sizeHint() const
{
    return helpFigureSize(m_name, font()).toSize();
}

int FigureView::heightForWidth(int width) const
{
    const QSizeF size = helpFigureSize(m_name, font());
    return int(std::ceil(size.height() * std::min(1.0, width / size.width())));
}

void FigureView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QSizeF size = helpFigureSize(m_name, font());
    const double scale = std::min(1.0, width() / size.width());
    const QRectF place((width() - scale * size.width()) / 2.0, 0.0, scale * size.width(), scale * size.height());
    drawHelpFigure(painter, place, m_name, font(),
                   FigureColors::of(palette().color(QPalette::WindowText), palette().color(QPalette::Link),
                                    palette().color(QPalette::Window)));
}

} // namespace unprojector::gui
