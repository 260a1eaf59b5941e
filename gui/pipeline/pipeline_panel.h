#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLayout;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace unprojector::gui {

struct EntryDerivation;
class FactorsView;
class HelpLink;
class MatrixFindingsView;
class MatrixSection;
class NumberGrid;
class SceneDocument;
class SegmentedSwitch;
class SteadyLabel;

/// The picked point in object, world, eye, clip, NDC and window coordinates and as widget position, with the matrix
/// between two of them; forward or backward. In each of these spaces a point can be typed or pasted instead. Hidden, it does nothing; shown again, it catches up.
class PipelinePanel : public QWidget {
    Q_OBJECT
public:
    explicit PipelinePanel(SceneDocument &document, QWidget *parent = nullptr);
    /// What is being typed then counts no more: the document may be gone already.
    ~PipelinePanel() override;

    const PipelineModel &model() const { return *m_model; }

    // How it is shown, to be remembered.
    PipelineDirection direction() const { return m_model->direction(); }
    void setDirection(PipelineDirection direction);
    const MatrixView &matrixView() const { return m_model->view(); }
    void setMatrixView(const MatrixView &view);

    /// Follows the point that is given, also where a click came after it.
    void followGiven() { m_model->followGiven(true); }

    /// Back to the first row.
    void scrollToTop();
    /// Shows the factors of the view's or the projection's matrix, forward, and what there is to try with them.
    void takeApart(PipelineStage stage);

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
    QWidget *createSwitches();
    /// What lessons link to, by name: the choices of the switches, each matrix opened, the shares of the projection's factors,
    /// the conventions.
    void createActions();
    /// Opens a matrix and scrolls to it.
    void openMatrix(PipelineStage stage);
    /// @param tried  what below the row is to be in sight as well, or null
    void scrollTo(const QWidget &row, const QWidget *tried);
    /// What the points are, and which of the two to follow.
    QLayout *createFollowed();
    void createStages();
    /// The rows in the order of the direction, and their headings.
    void arrange();
    void showTitles();
    void refresh();
    void showStatus();
    void showFollowed();
    void showFlip();
    /// How the chosen coordinate comes about, and what of the panel it comes from marked.
    void showDerivation();
    QString helpOf(PipelineStage stage) const;
    QString helpOf(const EntryDerivation &derivation) const;
    void showHelp();
    /// Of the view's and the projection's matrix, where they are taken apart.
    void showFactors();
    void showGiven();
    void showObjects();
    void showConventions();
    /// Takes over which ones they are, seen or not: what is chosen after that stays.
    void followConventions();
    /// Vectors as the API writes them; until the user says otherwise.
    void takeTheirLayout();
    void takeConventions(Api api);

    // Before the document's objects in the combo box.
    static constexpr int kAutomaticItem = 0;
    static constexpr int kNoneItem = 1;
    static constexpr int kFirstObjectItem = 2;

    SceneDocument &m_document;
    PipelineModel *m_model;
    SegmentedSwitch *m_directionSwitch;
    SegmentedSwitch *m_layoutSwitch;
    SegmentedSwitch *m_memorySwitch;
    SegmentedSwitch *m_digitsSwitch;
    QComboBox *m_conventions;
    QLabel *m_apiNote;
    QComboBox *m_object;
    QLabel *m_status;
    QToolButton *m_follow; ///< the other one of click and given point
    QToolButton *m_remove; ///< the given point
    QScrollArea *m_scrollArea;
    QVBoxLayout *m_rows;
    std::array<QWidget *, PointModel::kSpaces> m_pointRows{};
    std::array<NumberGrid *, PointModel::kSpaces> m_pointGrids{};
    std::array<QLabel *, PointModel::kSpaces> m_pointNames{};
    std::array<MatrixSection *, kPipelineStages.size()> m_sections{};
    FactorsView *m_viewFactors = nullptr;
    FactorsView *m_projectionFactors = nullptr;
    MatrixSection *m_given = nullptr;     ///< before the projection, while that is given as a matrix
    MatrixSection *m_givenView = nullptr; ///< the same of the view
    MatrixFindingsView *m_givenFindings = nullptr;
    MatrixFindingsView *m_givenViewFindings = nullptr;
    QLabel *m_division;
    QLabel *m_flip;
    QWidget *m_divisionRow; ///< with its link to Help
    QWidget *m_flipRow;
    SteadyLabel *m_derivation;
    HelpLink *m_derivationHelp;
    struct Entry {
        PointModel::Space space;
        int coordinate;
    };
    std::optional<Entry> m_chosen;          ///< the coordinate that m_derivation is of
    Api m_api = Api::OpenGl;                ///< as m_flip tells of it
    Surface m_surface;                      ///< as m_flip tells of it
    bool m_isDepthRead = false;             ///< the same
    std::vector<std::string> m_objectNames; ///< as the combo box lists them
};

} // namespace unprojector::gui
