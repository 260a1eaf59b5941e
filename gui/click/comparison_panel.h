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

/// The answer of a click, from what most users ask first to what few ask: the coordinate with its uncertainty, whether
/// the two methods agree, both of them in a table, the formula with its numbers, and folded the way of the pixel, the
/// exact hit on the mesh, other programs, other APIs and the last picks of the scene. All of it is of the moment of the
/// click; where the view has changed since, the panel says so, shows the values now beside those of the click, and
/// offers to pick the same pixel again.
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
    /// Marks a term of the formula whose quantity is pointed at in a view; empty: none.
    void markTerm(const QString &term);
    const ComparisonModel &model() const { return *m_model; }
    const RayModel &rayModel() const { return *m_rayModel; }

    /// Wide enough for its table.
    QSize sizeHint() const override;

signals:
    /// The pointer is over a term of the formula, or over none (empty).
    void termPointed(const QString &term);
    /// The position of the pick shall be picked again, in the view as it is now.
    void pickRequested(const unprojector::geometry::WidgetPoint &position);

private:
    QWidget *answerPart();
    /// A fold with the last picks, there while there are any.
    Fold *earlierPart();
    QWidget *pixelPart();
    QWidget *rayPart();
    void showPick();
    void showAnswer(const unproject::Pick &pick);
    void showRay();
    /// The snapped hit; null if the click took the surface under the pixel.
    const MetPlace *takenPlace() const;
    /// The display name of an object; its former name if it is gone, else "the surface".
    QString nameOf(const std::optional<std::size_t> &object, const std::string &formerName) const;
    void showSinceClick();

    SceneDocument &m_document;
    ComparisonModel *m_model;
    RayModel *m_rayModel;
    QWidget *m_before; ///< shown before the first click
    QWidget *m_after;  ///< shown with a pick
    AnswerView *m_answer;
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
