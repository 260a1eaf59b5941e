#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QWidget>

#include <array>
#include <variant>

class QGridLayout;
class QLabel;
class QScrollBar;
class QToolButton;

namespace unprojector::gui {

class NumberGrid;

/// The part that can be opened below the chain: the step that leads to a space, or a product of
/// several matrices.
using ChainPart = std::variant<PointModel::Space, pipeline::PipelineStage>;

/// The point in every space, a line each, in the order of the direction. The name of a space opens
/// the step that leads there; buttons below open the products of matrices, or all matrices at once.
class PipelineChain : public QWidget {
    Q_OBJECT
public:
    explicit PipelineChain(PipelineModel &model, QWidget *parent = nullptr);

    /// Arranges the lines in the order of the model's direction.
    void arrange();
    /// Applies the number format: all digits need more room than there is, and one scroll bar
    /// scrolls all points.
    void showView();
    void setOpened(const ChainPart &part);
    bool areAllOpen() const;
    void setAllOpen(bool areOpen);

    /// Commits pending input.
    void applyTyped();

signals:
    void partChosen(const unprojector::gui::ChainPart &part);
    void allOpenChanged();
    /// @param coordinate  0 for x, 3 for w
    void numberChosen(unprojector::gui::PointModel::Space space, int coordinate);
    /// Emitted when the Tab key reaches a number.
    void numberReached(unprojector::gui::PointModel::Space space, int coordinate);

private:
    struct Line {
        QToolButton *name;
        NumberGrid *grid;
    };
    void createProducts(int line);
    void createScrollBar(int line);
    void scrollAll(int value);
    QToolButton *createOpener(const ChainPart &part);

    PipelineModel &m_model;
    QGridLayout *m_layout;
    std::array<QLabel *, 4> m_axes{}; ///< above the columns
    std::array<Line, PointModel::kSpaces> m_lines{};
    QScrollBar *m_scrollBar;
    bool m_isScrolling = false;
    std::array<QToolButton *, 2> m_products{};
    QToolButton *m_openAll;
};

} // namespace unprojector::gui
