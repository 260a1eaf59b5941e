#pragma once

#include "core/unproject/pick.h"

#include <QWidget>

#include <optional>
#include <string>

class QCheckBox;
class QPushButton;

namespace unprojector::gui {
using namespace unproject;

class ApiClicksView;
class ComparisonModel;
class ComparisonTable;
class ElidedLabel;
class FormulaView;
class HelpLink;
class OtherProgramsView;
class RayModel;
class RayTable;
class SceneDocument;
class SteadyLabel;
struct MetPlace;

/// The picked point, computed twice from the depth buffer and once without it: the chain of the click, the table of both
/// methods, how certain the coordinate is, what the ray meets on the mesh and which to trust, and the formula with its numbers
/// put in. All of it is of the moment of the click; when the document is another one since,
/// the panel says so and offers to pick the same position anew.
class ComparisonPanel : public QWidget {
    Q_OBJECT
public:
    explicit ComparisonPanel(SceneDocument &document, QWidget *parent = nullptr);

    bool showsFloat() const;
    void setShowsFloat(bool shows);

    /// Everything the panel shows, with all digits.
    QString text() const;
    const ComparisonModel &model() const { return *m_model; }
    const RayModel &rayModel() const { return *m_rayModel; }

    /// As wide as its tables need.
    QSize sizeHint() const override;

signals:
    void showsFloatChanged(bool shows);
    /// The position of the pick shall be picked anew, in the view as it is now.
    void pickRequested(const unprojector::geometry::WidgetPoint &position);

private:
    void showPick();
    void showRay();
    void showCertainty(const Pick &pick);
    const MetPlace *takenPlace() const;
    /// Of an object in the list as it is now; of none, or one without a name, what else to call it.
    QString nameOf(const std::optional<std::size_t> &object, const std::string &formerName) const;
    void showSinceClick();

    SceneDocument &m_document;
    ElidedLabel *m_heading;
    SteadyLabel *m_sinceClick;
    QPushButton *m_again;
    SteadyLabel *m_widget;
    SteadyLabel *m_devicePixel;
    SteadyLabel *m_window;
    SteadyLabel *m_depth;
    ComparisonTable *m_table;
    ComparisonModel *m_model;
    SteadyLabel *m_certainty;
    SteadyLabel *m_cause;
    HelpLink *m_certaintyHelp; ///< where there is something to explain
    HelpLink *m_causeHelp;
    RayModel *m_rayModel;
    RayTable *m_rayTable;
    SteadyLabel *m_ray;
    SteadyLabel *m_rayDetail;
    OtherProgramsView *m_others;
    ApiClicksView *m_apis;
    FormulaView *m_formula;
    QCheckBox *m_showsFloat;
    QPushButton *m_copy;
};

} // namespace unprojector::gui
