#pragma once

#include "core/unproject/pick.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <optional>
#include <string>
#include <utility>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;

namespace unprojector::gui {

class AnswerView;
class ApiClicksView;
class ComparisonModel;
class CoordinatesTable;
class Fold;
class FormulaView;
class OtherProgramsView;
class RayModel;
class SceneDocument;
class SegmentedSwitch;
class SteadyLabel;
class ThenAndNowView;
class VerdictView;
struct MetPlace;

/// The answer of a click, the most frequent questions first:
///
/// - the coordinate with its uncertainty
/// - the agreement of the two methods, and a table of both
/// - the formula with its numbers
/// - in folds: the steps from the pixel, the exact hit on the mesh, other programs, other APIs, and
///   the last picks of the scene
///
/// All values are from the moment of the click. If the view has changed since, a banner reports it
/// and offers to pick the same pixel again, and a fold shows the current values beside the click's.
class ComparisonPanel : public QWidget {
    Q_OBJECT
public:
    explicit ComparisonPanel(SceneDocument &document, QWidget *parent = nullptr);

    bool showsFloat() const;
    void setShowsFloat(bool shows);
    bool showsRay() const;
    void setShowsRay(bool shows);
    /// The names of the folds that are open: "now", "pixel", "ray", "programs", "apis", "picks".
    QStringList openFolds() const;
    void setOpenFolds(const QStringList &names);

    /// Copies the answer, as its button does. @pre there is a pick
    void copyAnswer();
    /// The text of the whole panel, with all digits, in every space.
    QString text() const;
    /// Marks the term of the formula whose quantity is under the pointer in a view; empty: none.
    void markTerm(const QString &term);
    const ComparisonModel &model() const { return *m_model; }
    const RayModel &rayModel() const { return *m_rayModel; }

    /// A size wide enough for the table.
    QSize sizeHint() const override;

signals:
    /// Emitted when the pointer is over another term of the formula, or over none (empty).
    void termPointed(const QString &term);
    /// Emitted when the user wants to pick the same position again in the current view.
    void pickRequested(const unprojector::geometry::WidgetPoint &position);

private:
    QWidget *answerPart();
    /// Creates the fold of the last picks, visible while there are any.
    Fold *earlierPart();
    QWidget *pixelPart();
    QWidget *rayPart();
    void showPick();
    void showAnswer(const unproject::Pick &pick);
    void showRay();
    /// The snapped hit; null if the click took the surface under the pixel.
    const MetPlace *takenPlace() const;
    /// Returns whether the point is a vertex, whose coordinate no pixel leaves uncertain.
    bool isVertexTaken() const;
    /// The display name of an object; its former name if it is gone, else "the surface".
    QString nameOf(const std::optional<std::size_t> &object, const std::string &formerName) const;
    void showSinceClick();

    SceneDocument &m_document;
    ComparisonModel *m_model;
    RayModel *m_rayModel;
    QWidget *m_before; ///< shown before the first click
    QWidget *m_after;  ///< shown with a pick
    AnswerView *m_answer;
    QLabel *m_edge; ///< shown if an occluding edge crosses the pixel
    VerdictView *m_verdict;
    QWidget *m_changed; ///< the banner and its button
    QLabel *m_sinceClick;
    QPushButton *m_again;
    Fold *m_nowFold; ///< shown with the banner
    ThenAndNowView *m_now;
    SegmentedSwitch *m_space;
    QCheckBox *m_showsFloat;
    QCheckBox *m_showsRay;
    CoordinatesTable *m_table;
    FormulaView *m_formula;
    std::vector<SteadyLabel *> m_chain; ///< widget position, device pixel, window position, depth
    SteadyLabel *m_ray;
    SteadyLabel *m_rayDetail;
    OtherProgramsView *m_others;
    ApiClicksView *m_apis;
    std::vector<std::pair<QString, Fold *>> m_folds;
};

} // namespace unprojector::gui
