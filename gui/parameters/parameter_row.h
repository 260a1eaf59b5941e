#pragma once

#include <QWidget>

#include <vector>

class QLabel;

namespace unprojector::gui {

class NumberField;

/// A title and the numbers that belong to it, each with its unit and, right beneath it, the reason why it is refused.
/// They stand beside each other where the row is wide enough, else beneath each other. Its columns are those of all
/// rows of the panel; all lengths come from the font. A slider stands beneath its field; where several fields stand
/// beneath each other, in the units' column beside it, and the unit that they share beneath the title.
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
    /// Those that Tab reaches, from left to right and above to below. Of several fields the sliders are left out: with
    /// the keyboard each field steps its number.
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
