#pragma once

#include "core/doctor/diagnosis.h"
#include "core/ray/scene_rays.h"
#include "gui/doctor/wrong_points_form.h"
#include "gui/document/scene_document.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

class CameraStep;
class CandidatesTable;
class CodeChangesView;
class Diagnoser;
class DiagnosisView;
class SpaceChoice;

/// The doctor's panel: the program's camera, the clicks and the program's points for them, in three
/// steps, and the mistake that explains them.
///
/// Pixels belong to a setup: the click's, or the other program's window. It is kept with them when
/// the view changes later.
class DoctorPanel : public QWidget {
    Q_OBJECT
public:
    explicit DoctorPanel(SceneDocument &document, QWidget *parent = nullptr);
    ~DoctorPanel() override;

    DiagnosisView &answer() { return *m_answer; }
    CodeChangesView &code() { return *m_code; }

    /// Call this after another scene was opened. A lesson puts the clicks aside, and the scene before
    /// it comes back with them.
    /// @param lesson  the name of the lesson that the scene is a step of, or empty
    /// @param isBack  it is the scene before a lesson, restored
    void followScene(const QString &lesson, bool isBack);

signals:
    /// Emitted when this pixel of the view should be picked.
    void pickRequested(const unprojector::geometry::DevicePixel &pixel);
    /// Emitted when another program's camera should be pasted.
    void pasteCameraWanted();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void connectSteps();
    void connectDocument();
    /// The setup of the present scene in the program: in a window of its own size, or in the
    /// view's.
    std::optional<geometry::Setup> setupNow() const;
    /// The setup of the entered points; without points, the present one.
    std::optional<geometry::Setup> setup() const;
    /// The rays of a setup; null if they are not available.
    std::shared_ptr<const ray::SceneRays> raysOf(const geometry::Setup &setup) const;

    /// Adds a new pick to the form. A drag restores the pick before the last one; the form then
    /// reverts the last click.
    void takePick();
    void goToPixel(const geometry::DevicePoint &pixel);
    void refresh();
    void showSetup();
    /// Lets the points belong to a camera that was given as matrices since the last call.
    /// @return whether there is one
    bool takeGivenCamera();
    /// Returns whether a setup has the given projection and the given view.
    bool hasGivenCamera(const geometry::Setup &setup) const;
    /// Lets the points belong to the present setup. Depths of clicks belong to the former one, and
    /// are dropped.
    void moveToSetupNow();
    /// Starts the diagnosis of the entered points.
    void ask();
    void showDiagnosis(const doctor::Diagnosis &diagnosis);
    /// Clears the last answer, and shows why there is none.
    void showNothing(const QString &why);
    void mark();

    SceneDocument &m_document;
    Diagnoser *m_diagnoser;
    std::optional<geometry::Setup> m_setup; ///< of the points, if there are any
    /// The last pick taken, and the one before.
    struct Taken {
        geometry::DevicePixel pixel;
        geometry::Setup setup;
        friend bool operator==(const Taken &, const Taken &) = default;
    };
    std::optional<Taken> m_taken, m_takenBefore;
    /// The clicks of a scene that was left.
    struct Clicks {
        std::optional<geometry::Setup> setup;
        std::optional<Taken> taken;
        std::vector<WrongPointsForm::ClickedRow> rows;
    };
    Clicks m_left;
    std::optional<Clicks> m_aside; ///< of the scene before the lesson
    std::optional<geometry::Setup> m_setupBefore;
    std::vector<doctor::WrongPoint> m_asked;
    std::optional<doctor::Diagnosis> m_diagnosis; ///< of m_asked

    /// The scene's projection and view that another program gave, as last seen.
    struct GivenCamera {
        std::optional<geometry::Lens> projection;
        std::optional<glm::dmat4> eyeFromWorld;
        friend bool operator==(const GivenCamera &, const GivenCamera &) = default;
    };
    GivenCamera m_given;

    CameraStep *m_camera;
    WrongPointsForm *m_form;
    SpaceChoice *m_space;
    DiagnosisView *m_answer;
    CodeChangesView *m_code;
    CandidatesTable *m_candidates;
};

} // namespace unprojector::gui
