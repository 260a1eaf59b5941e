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

/// The picked point in object, world, eye, clip, NDC and window coordinates and as widget position, forward or backward, as a
/// chain that is always in sight. Below it stands the matrix of one step, or all of them, each with how a chosen number is
/// computed. In each of these spaces a point can be typed or pasted instead. Hidden, it does nothing; shown again, it catches up.
class PipelinePanel : public QWidget {
    Q_OBJECT
public:
    explicit PipelinePanel(SceneDocument &document, QWidget *parent = nullptr);
    /// What is being typed then counts no more: the document may be gone already.
    ~PipelinePanel() override;

    const PipelineModel &model() const { return *m_model; }

    // How it is shown, to be remembered.
    matrices::PipelineDirection direction() const { return m_model->direction(); }
    void setDirection(matrices::PipelineDirection direction);
    const MatrixView &matrixView() const { return m_model->view(); }
    void setMatrixView(const MatrixView &view);

    const ChainPart &opened() const { return m_opened; }
    /// Shows the step to a space, or a product, and no other step unless all are open. What was explained of another step no
    /// longer is.
    void open(const ChainPart &part);
    bool areAllOpen() const { return m_chain->areAllOpen(); }
    void setAllOpen(bool areOpen) { m_chain->setAllOpen(areOpen); }

    /// What is open and chosen, to be put back after a lesson.
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

    /// Follows the point that is given, also where a click came after it.
    void followGiven() { m_model->followGiven(true); }

    /// Shows points and matrices as they were at the click, where they differ from those now.
    void showClickValues() { m_model->setShowsClick(true); }

    /// Back to the first row; no number is explained and no matrix taken apart any more.
    void startOver();
    /// Shows the factors of the view's or the projection's matrix, forward, and what there is to try with them.
    void takeApart(matrices::PipelineStage stage);
    /// Opens a matrix and scrolls to it.
    void openMatrix(matrices::PipelineStage stage);

    /// What is being typed counts now.
    void applyTyped();

    QSize sizeHint() const override;

signals:
    /// Matrices are about to be pasted: what is being typed anywhere counts first, it was meant for this camera.
    void aboutToPaste();

protected:
    void showEvent(QShowEvent *event) override;
    /// Paste: sixteen numbers and more are matrices of another program, those on a section its own.
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// What lessons link to, by name: each matrix opened, the shares of the projection's factors.
    void createActions();
    /// Opens the step that a matrix makes.
    void openStep(matrices::PipelineStage stage);
    /// @param tried  what below the row is to be in sight as well, or null
    void scrollTo(const QWidget &row, const QWidget *tried);
    void createStages();
    /// The rows in the order of the direction, and their headings.
    void arrange();
    /// Keeps the matrix open that is, or the explanation of the chosen number.
    void followDirection();
    void showPart(const ChainPart &part);
    /// Opens the step to a space and explains the number below it.
    void explain(PointModel::Space space, int coordinate);
    /// Hides what is not open, and puts the explanation below the step that it is of.
    void showOpened();
    /// The row below the chain that leads to a space; null for the start.
    QWidget *stepTo(PointModel::Space space) const;
    bool isOpen(matrices::PipelineStage stage) const;
    bool isOpen(PointModel::Space space) const;
    void showTitles();
    void refresh();
    void showStatus();
    void showHelp();
    /// Of the view's and the projection's matrix, where they are taken apart.
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
    std::array<MatrixSection *, matrices::kPipelineStages.size()> m_sections{};
    FactorsView *m_viewFactors = nullptr;
    FactorsView *m_projectionFactors = nullptr;
    MatrixSection *m_given = nullptr;     ///< before the projection, while that is given as a matrix
    MatrixSection *m_givenView = nullptr; ///< the same of the view
    MatrixFindingsView *m_givenFindings = nullptr;
    MatrixFindingsView *m_givenViewFindings = nullptr;
    QLabel *m_division;                           ///< in a row with its link to Help
    QLabel *m_flip;                               ///< the same
    ChainPart m_opened = PointModel::Space::Clip; ///< forward and backward the projection leads there
};

} // namespace unprojector::gui
