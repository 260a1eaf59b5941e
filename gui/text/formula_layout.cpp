#include "gui/text/formula_layout.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStringView>

#include <algorithm>
#include <limits>
#include <utility>

namespace unprojector::gui {
namespace {

using Box = FormulaLayout::Box;

/// Smaller type is illegible.
constexpr double kLeastScale = 0.55;
constexpr double kScaleStep = 0.94;
/// The scale of sub- and superscripts.
constexpr double kIndexScale = 0.72;

bool isLatinLetter(QChar c)
{
    return (c >= u'a' && c <= u'z') || (c >= u'A' && c <= u'Z');
}

Box textBox(const QString &text, const QFont &font, double spaceBefore = 0.0, double spaceAfter = 0.0)
{
    const QFontMetricsF metrics(font);
    Box box;
    box.kind = Box::Kind::Text;
    box.text = text;
    box.font = font;
    // Some fonts' parentheses extend below their descent, where a fraction's bar may be.
    const QRectF ink = metrics.tightBoundingRect(text);
    box.ascent = std::max(metrics.ascent(), -ink.top());
    box.descent = std::max(metrics.descent(), ink.bottom());
    box.width = spaceBefore + metrics.horizontalAdvance(text) + spaceAfter;
    box.axis = spaceBefore; // for a text: its start
    return box;
}

/// Side by side on one baseline.
void placeInRow(Box &row)
{
    double x = 0.0;
    row.ascent = row.descent = 0.0;
    for (Box &part : row.parts) {
        part.origin.setX(x);
        x += part.width;
        row.ascent = std::max(row.ascent, part.ascent - part.origin.y());
        row.descent = std::max(row.descent, part.descent + part.origin.y());
    }
    row.width = x;
}

/// Reads markup into boxes.
class Reader {
public:
    Reader(const QString &markup, const QFont &font) : m_markup(markup) { m_style = font; }

    Box readRow()
    {
        Box row;
        row.font = m_style;
        int parentheses = 0;
        const QFontMetricsF metrics(m_style);
        const double em = metrics.height();
        while (m_at < m_markup.size()) {
            const QChar c = m_markup[m_at];
            if (c == u'}' || c == u'|' || c == u';' || m_markup.mid(m_at, 2) == u"</")
                break;
            if (c == u'{') {
                row.parts.push_back(readBraces());
            } else if (c == u'<') {
                row.parts.push_back(readTag());
            } else if (isOperatorAt(m_at)) {
                const QChar sign = m_markup[m_at + 1];
                Box box = textBox(QString(sign), m_style, 0.22 * em, 0.22 * em);
                if (parentheses == 0)
                    box.breakBefore = sign == u'×' || sign == u'·' ? Box::Break::Late : Box::Break::Early;
                row.parts.push_back(std::move(box));
                m_at += 3;
            } else if (c == u'=' && row.parts.empty()) { // a line that continues the equation
                row.parts.push_back(textBox(QStringLiteral("="), m_style, 0.0, 0.22 * em));
                m_at += m_markup.mid(m_at + 1, 1) == u" " ? 2 : 1;
            } else if (c == u' ') {
                row.parts.push_back(textBox({}, m_style, 0.16 * em));
                ++m_at;
            } else {
                parentheses += c == u'(' ? 1 : c == u')' ? -1 : 0;
                row.parts.push_back(readWord());
            }
        }
        // Blanks around a bar are not part of its operands.
        while (!row.parts.empty() && row.parts.back().kind == Box::Kind::Text && row.parts.back().text.isEmpty())
            row.parts.pop_back();
        placeInRow(row);
        return row;
    }

private:
    bool isOperatorAt(qsizetype at) const
    {
        return at + 2 < m_markup.size() && m_markup[at] == u' ' && m_markup[at + 2] == u' '
               && QStringView(u"=+−×·").contains(m_markup[at + 1]);
    }

    /// A run of letters, of which a single one is a symbol, or of other characters.
    Box readWord()
    {
        const qsizetype start = m_at;
        const bool isWord = isLatinLetter(m_markup[start]);
        while (m_at < m_markup.size() && isLatinLetter(m_markup[m_at]) == isWord
               && !QStringView(u"{}|;< ").contains(m_markup[m_at])) {
            ++m_at;
            if (!isWord && (m_markup[m_at - 1] == u'(' || m_markup[m_at - 1] == u')'))
                break; // parentheses are counted one by one
        }
        QFont font = m_style;
        font.setItalic(isWord && m_at - start == 1 && !m_isUpright);
        return textBox(m_markup.mid(start, m_at - start), font);
    }

    Box readTag()
    {
        const qsizetype end = m_markup.indexOf(u'>', m_at);
        const QString tag = m_markup.mid(m_at + 1, end - m_at - 1);
        m_at = end + 1;
        const QFont outer = m_style;
        const bool wasUpright = m_isUpright;
        const double em = QFontMetricsF(outer).height();
        double shift = 0.0;
        if (tag == u"sub" || tag == u"sup") {
            m_style.setPointSizeF(outer.pointSizeF() * kIndexScale);
            shift = tag == u"sub" ? 0.13 * em : -0.3 * em;
        } else if (tag == u"b") {
            m_style.setBold(true);
            m_isUpright = true;
        }
        Box row = readRow();
        m_style = outer;
        m_isUpright = wasUpright;
        if (m_markup.mid(m_at, 2) == u"</")
            m_at = m_markup.indexOf(u'>', m_at) + 1;
        if (tag.startsWith(u"t "))
            row.term = tag.mid(2);
        row.origin.setY(shift);
        return row;
    }

    Box readBraces()
    {
        Box box;
        box.font = m_style;
        ++m_at;
        box.parts.push_back(readRow());
        box.kind = Box::Kind::Fraction;
        while (m_at < m_markup.size() && (m_markup[m_at] == u'|' || m_markup[m_at] == u';')) {
            if (m_markup[m_at] == u';')
                box.kind = Box::Kind::Column;
            ++m_at;
            while (m_at < m_markup.size() && m_markup[m_at] == u' ')
                ++m_at;
            box.parts.push_back(readRow());
        }
        ++m_at; // }
        const QFontMetricsF metrics(m_style);
        const double em = metrics.height();
        box.axis = metrics.xHeight() / 2.0 + 0.06 * em;
        double widest = 0.0;
        for (const Box &part : box.parts)
            widest = std::max(widest, part.width);
        if (box.kind == Box::Kind::Fraction && box.parts.size() == 2)
            placeFraction(box, widest, em);
        else
            placeColumn(box, widest, em);
        return box;
    }

    static void placeFraction(Box &box, double widest, double em)
    {
        const double gap = 0.06 * em, overhang = 0.12 * em;
        box.width = widest + 4.0 * overhang;
        Box &above = box.parts[0], &below = box.parts[1];
        above.origin = {(box.width - above.width) / 2.0, -box.axis - gap - above.descent};
        below.origin = {(box.width - below.width) / 2.0, -box.axis + gap + below.ascent};
        box.ascent = above.ascent - above.origin.y();
        box.descent = below.descent + below.origin.y();
    }

    static void placeColumn(Box &box, double widest, double em)
    {
        const double margin = 0.3 * em;
        box.width = widest + 2.0 * margin;
        double height = 0.0;
        for (const Box &part : box.parts)
            height += part.ascent + part.descent;
        double y = -box.axis - height / 2.0;
        for (Box &part : box.parts) {
            part.origin = {margin + (widest - part.width) / 2.0, y + part.ascent};
            y += part.ascent + part.descent;
        }
        box.ascent = box.axis + height / 2.0 + 0.05 * em;
        box.descent = height / 2.0 - box.axis + 0.05 * em;
    }

    QString m_markup;
    qsizetype m_at = 0;
    QFont m_style;
    bool m_isUpright = false;
};

void paintBox(QPainter &painter, const Box &box, const QPointF &around, const FormulaLayout::Colors &colors,
              const QString &marked)
{
    const QPointF origin = around + box.origin;
    if (!marked.isEmpty() && box.term == marked) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors.mark);
        painter.drawRoundedRect(box.rect().translated(around).adjusted(-1.0, 0.0, 1.0, 0.0), 2.0, 2.0);
    }
    painter.setPen(colors.ink);
    if (box.kind == Box::Kind::Text && !box.text.isEmpty()) {
        painter.setFont(box.font);
        painter.drawText(origin + QPointF(box.axis, 0.0), box.text);
    }
    const double stroke = std::max(1.0, QFontMetricsF(box.font).lineWidth());
    painter.setPen(QPen(colors.ink, stroke));
    if (box.kind == Box::Kind::Fraction) {
        const double y = origin.y() - box.axis, inset = box.width * 0.02;
        painter.drawLine(QPointF(origin.x() + inset, y), QPointF(origin.x() + box.width - inset, y));
    }
    if (box.kind == Box::Kind::Column) {
        const double top = origin.y() - box.ascent + stroke, bottom = origin.y() + box.descent - stroke;
        const double arm = 0.16 * QFontMetricsF(box.font).height();
        for (const auto &[x, inwards] :
             {std::pair(origin.x() + stroke, arm), std::pair(origin.x() + box.width - stroke, -arm)}) {
            painter.drawLine(QPointF(x, top), QPointF(x, bottom));
            painter.drawLine(QPointF(x, top), QPointF(x + inwards, top));
            painter.drawLine(QPointF(x, bottom), QPointF(x + inwards, bottom));
        }
    }
    for (const Box &part : box.parts)
        paintBox(painter, part, origin, colors, marked);
}

QString termIn(const Box &box, const QPointF &position)
{
    if (!box.rect().contains(position))
        return {};
    for (const Box &part : box.parts) {
        if (QString inner = termIn(part, position - box.origin); !inner.isEmpty())
            return inner;
    }
    return box.term;
}

void findPlaces(const Box &box, const QPointF &around, const QString &term, std::vector<QRectF> &places)
{
    if (box.term == term)
        places.push_back(box.rect().translated(around));
    for (const Box &part : box.parts)
        findPlaces(part, around + box.origin, term, places);
}

void findInk(const Box &box, const QPointF &around, std::vector<QRectF> &ink)
{
    const QPointF origin = around + box.origin;
    if (box.kind == Box::Kind::Text && !box.text.isEmpty())
        ink.push_back(QFontMetricsF(box.font).tightBoundingRect(box.text).translated(origin + QPointF(box.axis, 0.0)));
    if (box.kind == Box::Kind::Fraction)
        ink.emplace_back(origin.x(), origin.y() - box.axis, box.width, QFontMetricsF(box.font).lineWidth());
    if (box.kind == Box::Kind::Column)
        ink.push_back(box.rect().translated(around));
    for (const Box &part : box.parts)
        findInk(part, origin, ink);
}

} // namespace

QFont formulaFont(double pointSize)
{
    QFont font;
    font.setFamilies({QStringLiteral("STIX Two Text"), QStringLiteral("Cambria"), QStringLiteral("Libertinus Serif"),
                      QStringLiteral("Linux Libertine O"), QStringLiteral("Noto Serif"),
                      QStringLiteral("Liberation Serif"), QStringLiteral("Times New Roman"),
                      QStringLiteral("DejaVu Serif"),
                      // None of the fonts above has Chinese characters. Those below are used only
                      // for them; otherwise the system may choose a font without serifs or with
                      // Japanese forms.
                      QStringLiteral("Noto Serif CJK SC"), QStringLiteral("Noto Serif SC"),
                      QStringLiteral("Source Han Serif SC"), QStringLiteral("Songti SC"), QStringLiteral("SimSun")});
    font.setStyleHint(QFont::Serif);
    font.setPointSizeF(pointSize);
    return font;
}

FormulaLayout::FormulaLayout(const QString &markup, const QFont &font) : m_markup(markup), m_font(font)
{
    build(1.0);
    // The formula stays in one line; its own width, summed in another order, would sometimes break
    // it.
    breakLines(std::numeric_limits<double>::infinity(), false);
}

void FormulaLayout::build(double scale)
{
    QFont font = m_font;
    font.setPointSizeF(m_font.pointSizeF() * scale);
    m_whole = Reader(m_markup, font).readRow();
}

void FormulaLayout::setWidth(double width)
{
    double scale = 1.0;
    while (scale >= kLeastScale) {
        build(scale);
        if (breakLines(width, false) <= width || breakLines(width, true) <= width)
            return;
        scale *= kScaleStep;
    }
}

double FormulaLayout::breakLines(double width, bool isLate)
{
    const double indent = QFontMetricsF(m_whole.font).height();
    m_lines.clear();
    m_lines.emplace_back();
    double x = 0.0, chunk = 0.0;
    const auto breaksBefore = [isLate](const Box &part) {
        return part.breakBefore == Box::Break::Early || (isLate && part.breakBefore == Box::Break::Late);
    };
    for (std::size_t i = 0; i < m_whole.parts.size(); ++i) {
        const Box &part = m_whole.parts[i];
        if (breaksBefore(part)) {
            chunk = part.width;
            for (std::size_t next = i + 1; next < m_whole.parts.size() && !breaksBefore(m_whole.parts[next]); ++next)
                chunk += m_whole.parts[next].width;
            if (x + chunk > width && !m_lines.back().parts.empty()) {
                m_lines.emplace_back();
                x = indent;
            }
        }
        m_lines.back().parts.push_back(part);
        x += part.width;
    }
    double widest = 0.0, y = 0.0;
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        Box &line = m_lines[i];
        line.font = m_whole.font;
        placeInRow(line);
        line.origin = {i == 0 ? 0.0 : indent, y + line.ascent};
        y += line.ascent + line.descent + 2.0;
        widest = std::max(widest, line.origin.x() + line.width);
    }
    m_size = {widest, y};
    return widest;
}

void FormulaLayout::paint(QPainter &painter, const QPointF &topLeft, const Colors &colors, const QString &marked) const
{
    for (const Box &line : m_lines)
        paintBox(painter, line, topLeft, colors, marked);
}

std::vector<QRectF> FormulaLayout::inkRects() const
{
    std::vector<QRectF> ink;
    for (const Box &line : m_lines)
        findInk(line, {}, ink);
    return ink;
}

QString FormulaLayout::termAt(const QPointF &position) const
{
    for (const Box &line : m_lines) {
        if (QString term = termIn(line, position); !term.isEmpty())
            return term;
    }
    return {};
}

std::vector<QRectF> FormulaLayout::placesOf(const QString &term) const
{
    std::vector<QRectF> places;
    for (const Box &line : m_lines)
        findPlaces(line, {}, term, places);
    return places;
}

} // namespace unprojector::gui
