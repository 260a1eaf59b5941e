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

/// Why another program's coordinate is wrong: the clicks and what it got for them, and which mistake makes that.
///
/// Pixels belong to a picture: that of the click that was taken, or of the window that the other program has. It is kept with
/// them, whatever the view shows later.
class DoctorPanel : public QWidget {
    Q_OBJECT
public:
    explicit DoctorPanel(SceneDocument &document, QWidget *parent = nullptr);
    ~DoctorPanel() override;

    DiagnosisView &answer() { return *m_answer; }
    CodeChangesView &code() { return *m_code; }

signals:
    /// This pixel of the view is to be picked.
    void pickRequested(const unprojector::geometry::DevicePixel &pixel);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QWidget *createProgram();
    /// The picture that the program has of the scene as it is now: in a window of its own size, or in the view's.
    std::optional<geometry::Setup> setupNow() const;
    /// That of the points that are there, or that of now.
    std::optional<geometry::Setup> setup() const;
    /// What the rays of a picture meet; null where that is not known.
    std::shared_ptr<const ray::SceneRays> raysOf(const geometry::Setup &setup) const;

    /// Fills in the pick, if it is another one; where it is the one before that, a drag has begun and the last was none.
    void takePick();
    void goToPixel(const geometry::DevicePoint &pixel);
    void refresh();
    void showSetup();
    void showSpaces();
    /// Asks what the points that are there tell.
    void ask();
    void showDiagnosis(const doctor::Diagnosis &diagnosis);
    /// Takes away what the last answer has shown, and says why there is none.
    void showNothing(const QString &why);
    void mark();

    SceneDocument &m_document;
    Diagnoser *m_diagnoser;
    std::optional<geometry::Setup> m_setup; ///< of the points, while there are any
    /// Of the pick that was taken last, and of that before.
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
