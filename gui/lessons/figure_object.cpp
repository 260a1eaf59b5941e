#include "gui/lessons/figure_object.h"

#include "gui/text/figures/help_figures.h"

#include <QTextDocument>
#include <QTextImageFormat>
#include <QWidget>

namespace unprojector::gui {
namespace {

/// The margin at the right of a figure as wide as the page: for text before it in its line.
constexpr double kMargin = 34.0;

QString figureName(const QTextFormat &format)
{
    return format.toImageFormat().name().section(u':', 1);
}

} // namespace

FigureObject::FigureObject(const QWidget &page) : m_page(page) {}

QSizeF FigureObject::intrinsicSize(QTextDocument *text, int, const QTextFormat &format)
{
    const QSizeF size = helpFigureSize(figureName(format), text->defaultFont());
    const double width = text->textWidth() - 2.0 * text->documentMargin() - kMargin;
    return width > 0.0 && width < size.width() ? size * (width / size.width()) : size;
}

void FigureObject::drawObject(QPainter *painter, const QRectF &rect, QTextDocument *text, int,
                              const QTextFormat &format)
{
    const QPalette colors = m_page.palette();
    drawHelpFigure(
        *painter, rect, figureName(format), text->defaultFont(),
        FigureColors::of(colors.color(QPalette::Text), colors.color(QPalette::Link), colors.color(QPalette::Base)));
}

} // namespace unprojector::gui
