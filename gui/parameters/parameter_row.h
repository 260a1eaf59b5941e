#pragma once

#include <QWidget>

#include <vector>

class QLabel;

namespace unprojector::gui {

class NumberField;

/// A title and its numbers, each with its unit and, right beneath it, the reason why it is
/// rejected. They are side by side if the row is wide enough, else stacked. Its columns are common
/// to all rows of the panel; all lengths depend on the font.
class ParameterRow : public QWidget {
    Q_OBJECT
public:
    /// Logical pixels.
    struct Columns {
        int title = 0;
        int unit = 0;
    };

    explicit ParameterRow(const QString &title, QWidget *parent = nullptr);

    /// @param letter  identifies one of several: "x"; empty for a single one
    void addField(NumberField *field, const QString &letter, const QString &unit);
    /// Adds a slider beneath the field.
    void setSlider(QWidget *slider);
    NumberField *firstField() const { return m_cells.front().field; }
    /// The widgets that Tab reaches, from left to right and top to bottom.
    QWidgetList tabStops() const;

    /// The columns that its texts need.
    Columns ownColumns() const;
    void setColumns(const Columns &columns);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    struct Cell {
        QLabel *letter;
        NumberField *field;
        QLabel *unit;
        QLabel *reason;
    };
    /// Called for each child with its rectangle, or an empty one.
    using Place = void (*)(QWidget *child, const QRect &place);

    /// Visits the children with their rectangles in a row of that width.
    /// @return its height
    int arrange(int width, Place place) const;
    void showReason(const Cell &cell);
    void colourReasons();
    int gap() const;
    int letterWidth() const;

    QLabel *m_title;
    std::vector<Cell> m_cells;
    QWidget *m_slider = nullptr;
    Columns m_columns;
};

} // namespace unprojector::gui
