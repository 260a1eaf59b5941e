#include "gui/parameters/parameter_row.h"

#include "gui/parameters/number_field.h"

#include <QEvent>
#include <QLabel>

#include <algorithm>

namespace unprojector::gui {
namespace {

QLabel *plainLabel(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    return label;
}

void putThere(QWidget *child, const QRect &place)
{
    child->setVisible(!place.isEmpty());
    if (!place.isEmpty())
        child->setGeometry(place);
}

void putNowhere(QWidget *, const QRect &) {}

} // namespace

ParameterRow::ParameterRow(const QString &title, QWidget *parent) : QWidget(parent), m_title(plainLabel(title, this))
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void ParameterRow::addField(NumberField *field, const QString &letter, const QString &unit)
{
    if (m_cells.empty())
        m_title->setBuddy(field);
    const Cell cell{plainLabel(letter, this), field, plainLabel(unit, this), plainLabel({}, this)};
    cell.letter->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    cell.letter->setBuddy(field);
    cell.reason->setWordWrap(true);
    cell.reason->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    cell.reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
    cell.reason->setAccessibleName(tr("Reason why the number was rejected"));
    cell.reason->hide();
    field->setParent(this);
    field->show();
    m_cells.push_back(cell);
    connect(field, &NumberField::reasonChanged, this, [this, cell] { showReason(cell); });
    colourReasons();
    updateGeometry();
}

void ParameterRow::setSlider(const NumberField *field, QWidget *slider)
{
    const auto cell =
        std::find_if(m_cells.begin(), m_cells.end(), [field](const Cell &other) { return other.field == field; });
    Q_ASSERT(cell != m_cells.end());
    cell->slider = slider;
    slider->setParent(this);
    slider->show();
    updateGeometry();
}

QWidgetList ParameterRow::tabStops() const
{
    QWidgetList stops;
    for (const Cell &cell : m_cells)
        stops << cell.field;
    if (m_cells.size() == 1 && m_cells.front().slider)
        stops << m_cells.front().slider;
    return stops;
}

int ParameterRow::gap() const
{
    return fontMetrics().averageCharWidth();
}

ParameterRow::Columns ParameterRow::ownColumns() const
{
    Columns columns{m_title->sizeHint().width(), 0};
    for (const Cell &cell : m_cells)
        columns.unit = std::max(columns.unit, cell.unit->sizeHint().width());
    if (m_cells.size() > 1 && hasSliders())
        columns.title = std::max(columns.title, columns.unit);
    if (const int letter = letterWidth())
        columns.title += gap() + letter;
    return columns;
}

int ParameterRow::letterWidth() const
{
    int width = 0;
    for (const Cell &cell : m_cells)
        width = std::max(width, cell.letter->text().isEmpty() ? 0 : cell.letter->sizeHint().width());
    return width;
}

bool ParameterRow::hasSliders() const
{
    return std::any_of(m_cells.begin(), m_cells.end(), [](const Cell &cell) { return cell.slider; });
}

void ParameterRow::setColumns(const Columns &columns)
{
    m_columns = columns;
    updateGeometry();
    arrange(width(), putThere);
}

int ParameterRow::arrange(int width, Place place) const
{
    if (m_cells.empty())
        return 0;
    const int space = gap();
    const int line = m_cells.front().field->sizeHint().height();
    const int between = std::max(2, line / 8);
    const int left = m_columns.title + space;
    const int unitLeft = width - m_columns.unit;
    const int right = unitLeft - space;

    // The first letter is in the title's column, the others are between the fields.
    const int letter = letterWidth();
    const int count = static_cast<int>(m_cells.size());
    const int shared = (right - left - (count - 1) * (letter + 2 * space)) / count;
    const bool isShared = count > 1 && shared >= m_cells.front().field->minimumSizeHint().width();

    const bool areSlidersBeside = count > 1 && !isShared && hasSliders();

    int y = 0;
    const auto putSlider = [&](const Cell &cell, const QRect &at) {
        if (cell.slider)
            place(cell.slider, at);
    };
    const auto putReason = [&](const Cell &cell) {
        if (!cell.field->isBad()) {
            place(cell.reason, {});
            return;
        }
        const int height = cell.reason->heightForWidth(width);
        place(cell.reason, {0, y, width, height});
        y += height + between;
    };
    place(m_title, {0, 0, m_title->sizeHint().width(), line});
    int x = left;
    for (const Cell &cell : m_cells) {
        const bool endsLine = !isShared || &cell == &m_cells.back();
        place(cell.letter, {x - space - letter, y, letter, line});
        place(cell.field, {x, y, endsLine ? right - x : shared, line});
        if (!areSlidersBeside)
            place(cell.unit, endsLine ? QRect(unitLeft, y, m_columns.unit, line) : QRect());
        else // that of all fields, beneath the title
            place(cell.unit, &cell == &m_cells[1] ? QRect(0, y, cell.unit->sizeHint().width(), line) : QRect());
        if (areSlidersBeside)
            putSlider(cell, {unitLeft, y, m_columns.unit, line});
        else if (isShared && cell.slider)
            putSlider(cell, {x, y + line, shared, cell.slider->sizeHint().height()});
        if (isShared) {
            x += shared + 2 * space + letter;
        } else {
            y += line + between;
            putReason(cell);
        }
    }
    if (isShared) {
        y += line + between + (hasSliders() ? m_cells.front().slider->sizeHint().height() : 0);
        for (const Cell &cell : m_cells)
            putReason(cell);
    }
    if (count == 1 && hasSliders()) {
        const int height = m_cells.front().slider->sizeHint().height();
        putSlider(m_cells.front(), {left, y, width - left, height});
        y += height + between;
    }
    return y - between;
}

int ParameterRow::heightForWidth(int width) const
{
    return arrange(width, putNowhere);
}

QSize ParameterRow::minimumSizeHint() const
{
    const int field = m_cells.empty() ? 0 : m_cells.front().field->minimumSizeHint().width();
    // The least height is a wide row's: a narrow one gets more by heightForWidth.
    return {m_columns.title + m_columns.unit + 2 * gap() + field, heightForWidth(QWIDGETSIZE_MAX)};
}

QSize ParameterRow::sizeHint() const
{
    const int width = minimumSizeHint().width();
    return {width, heightForWidth(width)};
}

void ParameterRow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange(width(), putThere);
}

void ParameterRow::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        colourReasons();
}

void ParameterRow::showReason(const Cell &cell)
{
    cell.reason->setText(cell.field->reason());
    cell.reason->setAccessibleDescription(cell.field->reason());
    updateGeometry();
    arrange(width(), putThere);
}

void ParameterRow::colourReasons()
{
    // Red on any background of the theme.
    QPalette reasons = palette();
    const QColor ink = reasons.color(QPalette::WindowText);
    reasons.setColor(QPalette::WindowText, QColor((ink.red() + 3 * 200) / 4, ink.green() / 2, ink.blue() / 2));
    for (const Cell &cell : m_cells)
        cell.reason->setPalette(reasons);
}

} // namespace unprojector::gui
