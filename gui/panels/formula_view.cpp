#include "gui/panels/formula_view.h"

#include "gui/panels/contrast.h"
#include "gui/panels/copy_menu.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr double kMargin = 6.0;
/// A serif looks smaller than the window's own type.
constexpr double kTypeScale = 1.12;

} // namespace

FormulaView::FormulaView(QWidget *parent) : QAbstractScrollArea(parent)
{
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    viewport()->setBackgroundRole(QPalette::Base);
    viewport()->setAutoFillBackground(true);
}

void FormulaView::setFormulas(PickFormulas formulas)
{
    m_formulas = std::move(formulas);
    m_marked.clear();
    setAccessibleDescription(m_formulas.text());
    verticalScrollBar()->setValue(0);
    set();
}

void FormulaView::setPlaceholderText(const QString &text)
{
    m_placeholder = text;
    viewport()->update();
}

void FormulaView::set()
{
    const QFont font = formulaFont(this->font().pointSizeF() * kTypeScale);
    const double em = QFontMetricsF(font).height(), indent = 1.2 * em;
    const double width = viewport()->width() - 2.0 * kMargin;
    m_lines.clear();
    double y = kMargin, widest = 0.0;
    for (const FormulaWithNumbers &formula : m_formulas.formulas) {
        const double numberWidth =
            formula.number().isEmpty() ? 0.0 : QFontMetricsF(font).horizontalAdvance(formula.number()) + em;
        const auto add = [&](const QString &markup, double x, double right, const QString &number) {
            Line line{FormulaLayout(markup, font), {kMargin + x, y}, number};
            line.layout.setWidth(width - x - right);
            y += line.layout.size().height();
            widest = std::max(widest, kMargin + x + line.layout.size().width() + right);
            m_lines.push_back(std::move(line));
        };
        add(formula.symbols(), 0.0, numberWidth, formula.number());
        y += 0.15 * em;
        add(formula.numbers(), indent, 0.0, {});
        y += 0.7 * em;
    }
    m_size = {widest + kMargin, y};
    verticalScrollBar()->setPageStep(viewport()->height());
    verticalScrollBar()->setSingleStep(static_cast<int>(em));
    verticalScrollBar()->setRange(0, std::max(0, static_cast<int>(std::ceil(y)) - viewport()->height()));
    viewport()->update();
}

void FormulaView::paintEvent(QPaintEvent *)
{
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::Text), base = palette().color(QPalette::Base);
    const QColor quiet = quietInk(ink, base);
    if (m_lines.empty()) {
        painter.setPen(quiet);
        painter.drawText(QRectF(viewport()->rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin),
                         Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, m_placeholder);
        return;
    }
    QColor mark = palette().color(QPalette::Highlight);
    mark.setAlphaF(0.3F);
    const QPointF scrolled(0.0, -verticalScrollBar()->value());
    for (const Line &line : m_lines) {
        const QPointF place = line.place + scrolled;
        line.layout.paint(painter, place, {ink, mark}, m_marked);
        if (line.number.isEmpty())
            continue;
        painter.setFont(formulaFont(font().pointSizeF() * kTypeScale));
        painter.setPen(quiet);
        painter.drawText(QRectF(kMargin, place.y(), viewport()->width() - 2.0 * kMargin, line.layout.size().height()),
                         Qt::AlignRight | Qt::AlignVCenter, line.number);
    }
}

void FormulaView::resizeEvent(QResizeEvent *event)
{
    QAbstractScrollArea::resizeEvent(event);
    set();
}

void FormulaView::changeEvent(QEvent *event)
{
    QAbstractScrollArea::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange)
        set();
}

QString FormulaView::termAt(const QPoint &position) const
{
    const QPointF inContent = QPointF(position) + QPointF(0.0, verticalScrollBar()->value());
    for (const Line &line : m_lines) {
        if (QString term = line.layout.termAt(inContent - line.place); !term.isEmpty())
            return term;
    }
    return {};
}

std::vector<QRectF> FormulaView::placesOf(const QString &term) const
{
    std::vector<QRectF> places;
    for (const Line &line : m_lines) {
        for (const QRectF &place : line.layout.placesOf(term))
            places.push_back(place.translated(line.place - QPointF(0.0, verticalScrollBar()->value())));
    }
    return places;
}

QString FormulaView::toolTipOf(const QString &term) const
{
    const auto found = m_formulas.terms.find(term);
    if (found == m_formulas.terms.end())
        return {};
    const FormulaTerm &named = found->second;
    const QString value = named.value.size() > 1 ? QStringLiteral("(%1)").arg(named.value.join(QStringLiteral(", ")))
                                                 : named.value.value(0);
    const QString equation = value.isEmpty() ? named.symbol : QStringLiteral("%1 = %2").arg(named.symbol, value);
    return QStringLiteral("<p style='white-space: pre'>%1</p><p>%2</p>").arg(equation, named.name.toHtmlEscaped());
}

void FormulaView::mark(const QString &term)
{
    if (term == m_marked)
        return;
    m_marked = term;
    viewport()->update();
}

void FormulaView::mouseMoveEvent(QMouseEvent *event)
{
    mark(termAt(event->pos()));
}

bool FormulaView::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::Leave)
        mark({});
    if (event->type() == QEvent::ToolTip) {
        auto *help = static_cast<QHelpEvent *>(event);
        const QString text = toolTipOf(termAt(help->pos()));
        if (text.isEmpty())
            QToolTip::hideText();
        else
            QToolTip::showText(help->globalPos(), text, viewport());
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

void FormulaView::contextMenuEvent(QContextMenuEvent *event)
{
    if (m_lines.empty())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy the formulas"), this, &FormulaView::copyAll);
    const QString term = termAt(viewport()->mapFromGlobal(event->globalPos()));
    if (const auto found = m_formulas.terms.find(term);
        found != m_formulas.terms.end() && !found->second.exact.empty()) {
        menu->addSeparator();
        addCopyActions(*menu, {}, {term, found->second.exact});
    }
    menu->popup(event->globalPos());
}

void FormulaView::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy) && !m_lines.empty()) {
        copyAll();
        return;
    }
    QAbstractScrollArea::keyPressEvent(event);
}

void FormulaView::copyAll() const
{
    copyToClipboard(m_formulas.text() + u'\n');
}

QSize FormulaView::sizeHint() const
{
    return minimumSizeHint();
}

QSize FormulaView::minimumSizeHint() const
{
    const QFontMetrics metrics(formulaFont(font().pointSizeF() * kTypeScale));
    return {20 * metrics.horizontalAdvance(u'0'), 6 * metrics.height()};
}

} // namespace unprojector::gui
