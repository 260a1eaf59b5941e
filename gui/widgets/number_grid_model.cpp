#include "gui/widgets/number_grid_model.h"

#include <algorithm>

namespace unprojector::gui {
using namespace pipeline;

namespace {

/// The digits of a double: as many as of a whole float in the debugger's watch window.
constexpr int kSignificantDigits = 9;
/// Room after the decimal points, so that they don't move while the numbers change: ".1234567", and
/// ".12345" if a number has its own line.
constexpr std::size_t kRoomInColumn = 8;
constexpr std::size_t kRoomInLine = 6;

std::string textWithin(double value, Digits digits, bool isWhole, std::size_t capacity)
{
    if (isWhole)
        return numberText(value, digits);
    std::string text = numberText(value, digits, digits == Digits::Float ? 0 : kSignificantDigits);
    for (int significant = digits == Digits::Float ? 8 : kSignificantDigits - 1;
         text.size() > capacity && significant > 0; --significant)
        text = numberText(value, digits, significant);
    return text;
}

QString shown(const std::string &text)
{
    // Ordinary blanks at the end of a line are dropped when text is aligned.
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size())).replace(u' ', QChar::Nbsp);
}

} // namespace

void NumberGridModel::setCapacity(int characters)
{
    if (characters == m_capacity)
        return;
    m_capacity = characters;
    m_textsAreStale = true;
    if (m_rows > 0)
        emit dataChanged(index(0, 0), index(m_rows - 1, m_columns - 1));
}

void NumberGridModel::setNumbers(int rows, int columns, Numbers numbers, Digits digits, bool isWhole)
{
    Q_ASSERT(numbers.size() == static_cast<std::size_t>(rows * columns));
    const bool hasNewShape = rows != m_rows || columns != m_columns || isWhole != m_isWhole;
    if (!hasNewShape && digits == m_digits && numbers == m_numbers)
        return;
    if (hasNewShape) {
        beginResetModel();
        m_marked.clear();
    }
    m_rows = rows;
    m_columns = columns;
    m_numbers = std::move(numbers);
    m_digits = digits;
    m_isWhole = isWhole;
    m_textsAreStale = true;
    if (hasNewShape)
        endResetModel();
    else
        emit dataChanged(index(0, 0), index(rows - 1, columns - 1));
}

void NumberGridModel::setMarked(const QModelIndexList &marked)
{
    if (marked == m_marked)
        return;
    m_marked = marked;
    if (m_rows > 0)
        emit dataChanged(index(0, 0), index(m_rows - 1, m_columns - 1), {kMarkedRole});
}

std::size_t NumberGridModel::placeOf(int row, int column) const
{
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(column);
}

const std::optional<double> &NumberGridModel::number(int row, int column) const
{
    return m_numbers[placeOf(row, column)];
}

void NumberGridModel::makeTexts() const
{
    m_texts.assign(m_numbers.size(), QStringLiteral("–"));
    const auto capacity = static_cast<std::size_t>(std::max(m_capacity, 1));
    for (int column = 0; column < m_columns && m_rows > 0; ++column) {
        std::vector<std::string> texts;
        texts.reserve(static_cast<std::size_t>(m_rows));
        for (int row = 0; row < m_rows; ++row)
            texts.push_back(number(row, column) ? textWithin(*number(row, column), m_digits, m_isWhole, capacity)
                                                : std::string());
        std::vector<std::string> aligned = texts;
        const std::size_t point = alignAtDecimalPoint(aligned);
        const std::size_t length = aligned.front().size();
        // Numbers are right-aligned if there is no room to align their points.
        if (length <= capacity) {
            const std::size_t room = m_rows > 1 ? kRoomInColumn : kRoomInLine;
            for (std::string &text : aligned)
                text.resize(std::min(capacity, std::max(length, point + room)), ' ');
            texts = std::move(aligned);
        }
        for (int row = 0; row < m_rows; ++row) {
            if (number(row, column))
                m_texts[placeOf(row, column)] = shown(texts[static_cast<std::size_t>(row)]);
        }
    }
    m_textsAreStale = false;
}

int NumberGridModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int NumberGridModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : m_columns;
}

QVariant NumberGridModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const int row = index.row(), column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        if (m_textsAreStale)
            makeTexts();
        return m_texts[placeOf(row, column)];
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole: return toolTip(row, column);
    case kLabelRole: return label(row, column);
    case kMarkedRole: return m_marked.contains(index);
    case Qt::EditRole: {
        const std::optional<double> &value = number(row, column);
        return value ? QString::fromStdString(numberText(*value, m_digits)) : QString();
    }
    case kValueRole: {
        const std::optional<double> &value = number(row, column);
        return value ? QVariant(*value) : QVariant();
    }
    default: return {};
    }
}

QString NumberGridModel::label(int, int) const
{
    return {};
}

QString NumberGridModel::fullText(int row, int column) const
{
    const std::optional<double> &value = number(row, column);
    return value ? QString::fromStdString(numberText(*value, m_digits)) : QStringLiteral("–");
}

} // namespace unprojector::gui
