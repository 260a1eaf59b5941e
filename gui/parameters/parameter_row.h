#pragma once

#include <QWidget>

#include <vector>

class QLabel;

namespace unprojector::gui {

class NumberField;

/// A title with its number fields. Each field has its unit beside it, and the reason of a rejection
/// directly beneath it. The fields are side by side if the row is wide enough, else one below the
/// other. All rows of the panel share their columns; all lengths depend on the font. A slider is
/// beneath its field. If several fields are one below the other, each slider is beside its field,
/// in the units' column, and their common unit is beneath the title.
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
    void setSlider(const NumberField *field, QWidget *slider);
    /// The widgets that Tab reaches, in reading order. With several fields it skips their sliders:
    /// the keyboard steps the number in each field.
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
        QWidget *slider = nullptr;
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
    bool hasSliders() const;

    QLabel *m_title;
    std::vector<Cell> m_cells;
    Columns m_columns;
};

} // namespace unprojector::gui
