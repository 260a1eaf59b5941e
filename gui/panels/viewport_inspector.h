#pragma once

#include "gui/text/proportion_text.h"

#include <QWidget>

#include <array>
#include <optional>

class QBoxLayout;
class QLabel;
class QTableView;

namespace unprojector::gui {

class CornersModel;
class SceneDocument;
class SegmentedSwitch;
class ViewportDrawing;

/// How window, viewport and projection window relate: drawn to scale, as the proportions (3) and (4) with their numbers,
/// and as a table of the window's corners. It follows the pointer and every resize. Hidden, it does nothing; shown again,
/// it catches up. Where it is too narrow for all three, a switch leads to the table.
class ViewportInspector : public QWidget {
    Q_OBJECT
public:
    explicit ViewportInspector(SceneDocument &document, QWidget *parent = nullptr);

    /// The pointer's widget position in the 3-D view.
    void setPointer(const WidgetPoint &position);
    void clearPointer();

    const CornersModel &corners() const { return *m_corners; }
    /// Everything the panel says, with all digits in the table.
    QString text() const;

    QSize sizeHint() const override;
    /// That of the narrow arrangement, whichever is shown.
    QSize minimumSizeHint() const override;

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *createProportions();
    void createTable();
    void fixColumns();
    void addCopyAction();
    int widthForAll() const;
    int widthWithDrawing(int others) const;
    void arrange();
    void refresh();
    void showPicture();
    void showPointer();
    QString proportionLines() const;
    std::array<ProportionText, 2> proportionTexts() const;

    const SceneDocument &m_document;
    CornersModel *m_corners;
    ViewportDrawing *m_drawing;
    SegmentedSwitch *m_page;
    QWidget *m_proportions;
    QLabel *m_window;
    QLabel *m_viewport;
    QLabel *m_formulas;
    QLabel *m_circle;
    QTableView *m_table;
    std::optional<Picture> m_shown; ///< the picture that is on display
    std::optional<WidgetPoint> m_pointer;
};

} // namespace unprojector::gui
