#include "gui/widgets/formula_view.h"

#include "gui/text/help_anchors.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/help_link.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr double kMargin = 6.0;
/// A serif looks smaller than the window's own type.
constexpr double kTypeScale = 1.12;

/// The text of a formula's link: one without a number has a "?", like other links.
QString linkText(const FormulaWithNumbers &formula)
{
    return formula.number().isEmpty() ? QStringLiteral("?") : formula.number();
}

} // namespace

FormulaView::FormulaView(QWidget *parent) : QAbstractScrollArea(parent)
{
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    viewport()->setBackgroundRole(QPalette::Base);
    viewport()->setAutoFillBackground(true);
}

void FormulaView::setFormulas(PickFormulas formulas)
{
    m_formulas = std::move(formulas);
    mark({});
    setAccessibleDescription(m_formulas.text());
    set();
}

FormulaView::Content FormulaView::contentFor(double viewportWidth) const
{
    const QFont font = formulaFont(this->font().pointSizeF() * kTypeScale);
    const double em = QFontMetricsF(font).height(), indent = 1.2 * em;
    const double width = viewportWidth - 2.0 * kMargin;
    Content content;
    double y = kMargin, widest = 0.0;
    for (const FormulaWithNumbers &formula : m_formulas.formulas) {
        const QString number = linkText(formula);
        const double numberWidth = QFontMetricsF(font).horizontalAdvance(number);
        const auto add = [&](const QString &markup, double x, double right, bool isNumbered) {
            Line line{FormulaLayout(markup, font), {kMargin + x, y}, {}, {}};
            line.layout.setWidth(width - x - right);
            if (isNumbered) {
                const double middle = y + line.layout.size().height() / 2.0;
                line.number = formula.number();
                line.numberPlace = {kMargin + width - numberWidth, middle - em / 2.0, numberWidth, em};
            }
            y += line.layout.size().height();
            widest = std::max(widest, kMargin + x + line.layout.size().width() + right);
            content.lines.push_back(std::move(line));
        };
        add(formula.symbols(), 0.0, numberWidth + em, true);
        y += 0.15 * em;
        add(formula.numbers(), indent, 0.0, false);
        y += 0.7 * em;
    }
    content.size = {widest + kMargin, y};
    return content;
}

void FormulaView::set()
{
    m_content = contentFor(viewport()->width());
    updateGeometry();
    viewport()->update();
}

int FormulaView::heightForWidth(int width) const
{
    const QSizeF size = width == this->width() ? m_content.size : contentFor(width - 2 * frameWidth()).size;
    return static_cast<int>(std::ceil(size.height())) + 2 * frameWidth();
}

void FormulaView::paintEvent(QPaintEvent *)
{
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::Text);
    QColor mark = palette().color(QPalette::Highlight);
    mark.setAlphaF(0.3F);
    for (const Line &line : m_content.lines) {
        const QPointF place = line.place;
        line.layout.paint(painter, place, {ink, mark}, m_marked);
        if (line.numberPlace.isEmpty())
            continue;
        painter.setFont(formulaFont(font().pointSizeF() * kTypeScale));
        painter.setPen(palette().color(QPalette::Link));
        painter.drawText(line.numberPlace, Qt::AlignRight | Qt::AlignVCenter,
                         line.number.isEmpty() ? QStringLiteral("?") : line.number);
    }
}

void FormulaView::resizeEvent(QResizeEvent *event)
{
    QAbstractScrollArea::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
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
    const QPointF inContent(position);
    for (const Line &line : m_content.lines) {
        if (QString term = line.layout.termAt(inContent - line.place); !term.isEmpty())
            return term;
    }
    return {};
}

std::vector<QRectF> FormulaView::placesOf(const QString &term) const
{
    std::vector<QRectF> places;
    for (const Line &line : m_content.lines) {
        for (const QRectF &place : line.layout.placesOf(term))
            places.push_back(place.translated(line.place));
    }
    return places;
}

const FormulaView::Line *FormulaView::numberAt(const QPoint &position) const
{
    const QPointF inContent(position);
    const auto found = std::find_if(m_content.lines.begin(), m_content.lines.end(), [&inContent](const Line &line) {
        return !line.numberPlace.isEmpty() && line.numberPlace.adjusted(-3.0, -2.0, 3.0, 2.0).contains(inContent);
    });
    return found == m_content.lines.end() ? nullptr : &*found;
}

QRectF FormulaView::placeOfNumber(const QString &number) const
{
    for (const Line &line : m_content.lines) {
        if (!line.numberPlace.isEmpty() && line.number == number)
            return line.numberPlace;
    }
    return {};
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

void FormulaView::setMarkedTerm(const QString &term)
{
    m_marked = term;
    viewport()->update();
}

void FormulaView::mark(const QString &term)
{
    if (term == m_pointed)
        return;
    m_pointed = term;
    setMarkedTerm(term);
    emit termPointed(term);
}

void FormulaView::mouseMoveEvent(QMouseEvent *event)
{
    mark(termAt(event->pos()));
    viewport()->setCursor(numberAt(event->pos()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void FormulaView::mouseReleaseEvent(QMouseEvent *event)
{
    const Line *line = event->button() == Qt::LeftButton ? numberAt(event->pos()) : nullptr;
    if (line)
        openHelp(helpAnchorOf(line->number));
}

bool FormulaView::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::Leave)
        mark({});
    if (event->type() == QEvent::ToolTip) {
        auto *help = static_cast<QHelpEvent *>(event);
        const Line *line = numberAt(help->pos());
        const QString text = !line                    ? toolTipOf(termAt(help->pos()))
                             : line->number.isEmpty() ? tr("This formula in Help")
                                                      : tr("Formula %1 in Help").arg(line->number);
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
    if (m_content.lines.empty())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy the formulas"), this, &FormulaView::copyAll);
    const QPoint position = viewport()->mapFromGlobal(event->globalPos());
    const QString term = termAt(position);
    if (const auto found = m_formulas.terms.find(term);
        found != m_formulas.terms.end() && !found->second.exact.empty()) {
        menu->addSeparator();
        addCopyActions(*menu, {}, {term, found->second.exact});
    }
    menu->addSeparator();
    addHelpActions(*menu, position, event->reason() == QContextMenuEvent::Keyboard);
    menu->popup(event->globalPos());
}

/// Adds links to the formula under the pointer; from the keyboard, to each formula.
void FormulaView::addHelpActions(QMenu &menu, const QPoint &position, bool isOfAll) const
{
    const double y = position.y();
    QString before;
    for (const Line &line : m_content.lines) {
        const double top = line.place.y(), bottom = top + line.layout.size().height();
        if (line.numberPlace.isEmpty() || (!isOfAll && (y < top || y > bottom)))
            continue;
        const QString name =
            line.number.isEmpty() ? tr("This formula in Help") : tr("Formula %1 in Help").arg(line.number);
        if (name != before) // (15) occurs twice
            menu.addAction(name, this, [anchor = helpAnchorOf(line.number)] { openHelp(anchor); });
        before = name;
    }
}

void FormulaView::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy) && !m_content.lines.empty()) {
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
    return {minimumSizeHint().width(), heightForWidth(width())};
}

QSize FormulaView::minimumSizeHint() const
{
    const QFontMetrics metrics(formulaFont(font().pointSizeF() * kTypeScale));
    return {20 * metrics.horizontalAdvance(u'0'), 3 * metrics.height()};
}

} // namespace unprojector::gui
