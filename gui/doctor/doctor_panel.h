#pragma once

#include "core/doctor/diagnosis.h"
#include "core/ray/scene_rays.h"
#include "gui/document/scene_document.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace unprojector::gui {

class CandidatesTable;
class CodeChangesView;
class Diagnoser;
class DiagnosisView;
class WrongPointsForm;

/// The doctor's panel: the clicks and another program's points for them, and the mistake that
/// explains them.
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

signals:
    /// Emitted when this pixel of the view should be picked.
    void pickRequested(const unprojector::geometry::DevicePixel &pixel);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QWidget *createProgram();
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
    void showSpaces();
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
    std::optional<geometry::Setup> m_setupBefore;
    std::vector<doctor::WrongPoint> m_asked;
    std::optional<doctor::Diagnosis> m_diagnosis; ///< of m_asked

    WrongPointsForm *m_form;
    QComboBox *m_space;
    QLabel *m_setupText;
    QPushButton *m_currentSetup;
    QToolButton *m_fold;
    QWidget *m_program;
    QLineEdit *m_window;
    QLineEdit *m_otherSize;
    QLabel *m_sizeFault;
    DiagnosisView *m_answer;
    CodeChangesView *m_code;
    CandidatesTable *m_candidates;
};

} // namespace unprojector::gui
