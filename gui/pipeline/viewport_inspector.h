#pragma once

#include "gui/text/proportion_text.h"

#include <QWidget>

#include <array>
#include <optional>

class QHBoxLayout;
class QTableView;

namespace unprojector::gui {

class CornersModel;
class SceneDocument;
class SegmentedSwitch;
class SteadyLabel;
class ViewportDrawing;

/// The relation of window, viewport and projection window: drawn to scale, as the proportions (3)
/// and (4) with their numbers, and as a table of the window's corners. It follows the pointer and
/// every resize. It does nothing while hidden and catches up when shown. If it is too narrow for
/// all three, a switch shows one at a time. Its least width depends on fonts, never on numbers.
class ViewportInspector : public QWidget {
    Q_OBJECT
public:
    explicit ViewportInspector(SceneDocument &document, QWidget *parent = nullptr);

    /// The pointer's widget position in the 3-D view.
    void setPointer(const geometry::WidgetPoint &position);
    void clearPointer();

    const CornersModel &corners() const { return *m_corners; }
    /// The text of the whole panel, with all digits in the table.
    QString text() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Emitted when the user wants to resize the window.
    void sizeRequested();

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *createProportions();
    void createTable();
    void fixColumns();
    void addCopyAction();
    int proportionsWidth() const;
    int leastWidth() const;
    void arrange();
    void refresh();
    void showSetup();
    void showPointer();

    const SceneDocument &m_document;
    CornersModel *m_corners;
    ViewportDrawing *m_drawing;
    SegmentedSwitch *m_page;
    QWidget *m_proportions;
    SteadyLabel *m_window;
    SteadyLabel *m_viewport;
    std::array<SteadyLabel *, 2> m_symbols; ///< of the proportions (3) and (4)
    std::array<SteadyLabel *, 2> m_numbers; ///< the numbers of the symbols
    SteadyLabel *m_circle;
    QTableView *m_table;
    QHBoxLayout *m_contents;
    std::optional<geometry::Setup> m_shown; ///< the displayed setup
    std::optional<geometry::WidgetPoint> m_pointer;
};

} // namespace unprojector::gui
