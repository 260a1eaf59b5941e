#pragma once

#include "gui/pipeline/derivation_line.h"
#include "gui/pipeline/pipeline_chain.h"

#include <QWidget>

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace unprojector::gui {

class FactorsView;
class FollowedPointRow;
class MatrixFindingsView;
class MatrixSection;
class PipelineSwitches;
class SceneDocument;

/// The picked point in object, world, eye, clip, NDC and window coordinates and as widget position,
/// forward or backward: a chain that is always visible. Below it is the matrix of one step, or all
/// of them, each with the derivation of a chosen number. In each of these spaces the user can type
/// or paste a point instead. It does nothing while hidden and catches up when shown.
class PipelinePanel : public QWidget {
    Q_OBJECT
public:
    explicit PipelinePanel(SceneDocument &document, QWidget *parent = nullptr);
    /// Discards pending input: the document may no longer exist.
    ~PipelinePanel() override;

    const PipelineModel &model() const { return *m_model; }

    // The display options, to be saved.
    pipeline::PipelineDirection direction() const { return m_model->direction(); }
    void setDirection(pipeline::PipelineDirection direction);
    const MatrixView &matrixView() const { return m_model->view(); }
    void setMatrixView(const MatrixView &view);

    const ChainPart &opened() const { return m_opened; }
    /// Opens the step to a space, or a product, and closes other steps unless all are open. Removes
    /// the derivation of a number of another step.
    void open(const ChainPart &part);
    bool areAllOpen() const { return m_chain->areAllOpen(); }
    void setAllOpen(bool areOpen) { m_chain->setAllOpen(areOpen); }

    /// The open parts and choices, to be restored after a lesson.
    struct Kept {
        ChainPart opened = PointModel::Space::Clip;
        bool areAllOpen = false;
        bool isViewApart = false, isProjectionApart = false;
        QList<int> percents; ///< of the projection's factors
        std::optional<DerivationLine::Entry> chosen;
        int top = 0; ///< of the scroll bar
    };
    Kept kept() const;
    void restore(const Kept &kept);

    /// Shows the user's point, even if a click came after it.
    void followGiven() { m_model->followGiven(true); }

    /// Shows the points and matrices of the click if they differ from the current ones.
    void showClickValues() { m_model->setShowsClick(true); }

    /// Scrolls back to the first row, and closes the derivation and all decompositions.
    void startOver();
    /// Switches to the forward direction and opens the decomposition of the view's or the
    /// projection's matrix.
    void takeApart(pipeline::PipelineStage stage);
    /// Opens a matrix and scrolls to it.
    void openMatrix(pipeline::PipelineStage stage);

    /// Commits pending input.
    void applyTyped();

    QSize sizeHint() const override;

signals:
    /// Emitted before a camera is pasted: pending input is committed first, because it belongs to
    /// the present camera.
    void aboutToPaste();

protected:
    void showEvent(QShowEvent *event) override;

private:
    /// Creates the actions that lessons link to, by name: each matrix opened, the shares of the
    /// projection's factors.
    void createActions();
    /// Opens the step of a matrix.
    void openStep(pipeline::PipelineStage stage);
    /// @param tried  a widget below the row that must be visible too, or null
    void scrollTo(const QWidget &row, const QWidget *tried);
    void createStages();
    /// Arranges rows and headings in the order of the direction.
    void arrange();
    /// Keeps the open matrix, or the derivation of the chosen number, after a change of direction.
    void followDirection();
    void showPart(const ChainPart &part);
    /// Opens the step to a space and shows the derivation of a number below it.
    void explain(PointModel::Space space, int coordinate);
    /// Hides closed parts, and moves the derivation below its step.
    void showOpened();
    /// The row below the chain that leads to a space; null for the start.
    QWidget *stepTo(PointModel::Space space) const;
    bool isOpen(pipeline::PipelineStage stage) const;
    bool isOpen(PointModel::Space space) const;
    void showTitles();
    void refresh();
    void showStatus();
    void showHelp();
    /// Shows the factors of the view's and the projection's matrix if they are open.
    void showFactors();
    void showGiven();

    SceneDocument &m_document;
    PipelineModel *m_model;
    PipelineSwitches *m_switches;
    FollowedPointRow *m_followed;
    PipelineChain *m_chain;
    DerivationLine *m_derivation;
    QScrollArea *m_scrollArea;
    QVBoxLayout *m_rows;
    QLabel *m_apiNote;
    std::array<MatrixSection *, pipeline::kPipelineStages.size()> m_sections{};
    FactorsView *m_viewFactors = nullptr;
    FactorsView *m_projectionFactors = nullptr;
    MatrixSection *m_given = nullptr;     ///< before the projection, while it is given as a matrix
    MatrixSection *m_givenView = nullptr; ///< the same for the view
    MatrixFindingsView *m_givenFindings = nullptr;
    MatrixFindingsView *m_givenViewFindings = nullptr;
    QLabel *m_division;                           ///< in a row with its link to the help
    QLabel *m_flip;                               ///< the same
    ChainPart m_opened = PointModel::Space::Clip; ///< forward and backward the projection leads there
};

} // namespace unprojector::gui
