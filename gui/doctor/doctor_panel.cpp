#include "gui/doctor/doctor_panel.h"

#include "core/doctor/known_points.h"
#include "core/ray/mesh_point.h"
#include "core/scene/given_matrices.h"
#include "gui/doctor/camera_step.h"
#include "gui/doctor/candidates_table.h"
#include "gui/doctor/code_changes_view.h"
#include "gui/doctor/diagnoser.h"
#include "gui/doctor/diagnosis_view.h"
#include "gui/doctor/space_choice.h"
#include "gui/doctor/wrong_points_form.h"
#include "gui/document/picks.h"
#include "gui/text/error_text.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <glm/matrix.hpp>

#include <cmath>
#include <memory>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;
using namespace doctor;

DoctorPanel::DoctorPanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_diagnoser(new Diagnoser(this)), m_camera(new CameraStep),
      m_form(new WrongPointsForm), m_space(new SpaceChoice(document)), m_answer(new DiagnosisView),
      m_code(new CodeChangesView), m_candidates(new CandidatesTable)
{
    auto *spaceLine = new QHBoxLayout;
    auto *spaceLabel = new QLabel(tr("&In the space:"));
    spaceLabel->setBuddy(m_space);
    spaceLine->addWidget(spaceLabel);
    spaceLine->addWidget(m_space, 1);

    // Counted in digits, as in the comparison.
    constexpr int kLeastDigits = 48;
    setMinimumWidth(kLeastDigits * fontMetrics().horizontalAdvance(u'0'));

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(m_camera);
    layout->addWidget(m_form);
    layout->addLayout(spaceLine);
    auto *line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    layout->addWidget(line);
    m_answer->setBelowVerdict(m_code);
    layout->addWidget(m_answer);
    layout->addWidget(m_candidates);
    layout->addStretch();
    m_candidates->hide();
    connectSteps();
    connectDocument();
    showSetup();
    ask();
}

DoctorPanel::~DoctorPanel() = default;

void DoctorPanel::connectSteps()
{
    connect(m_camera, &CameraStep::pasteWanted, this, &DoctorPanel::pasteCameraWanted);
    connect(m_camera, &CameraStep::currentViewWanted, this, [this] {
        m_setup = setupNow();
        refresh();
    });
    connect(m_camera, &CameraStep::windowEntered, this, [this](bool isNew) {
        if (isNew && !m_form->isEmpty())
            m_setup = setupNow();
        refresh();
    });
    connect(m_camera, &CameraStep::otherSizeEntered, this, &DoctorPanel::ask);
    connect(m_form, &WrongPointsForm::changed, this, &DoctorPanel::refresh);
    connect(m_space, &QComboBox::activated, this, &DoctorPanel::ask);
    connect(m_answer, &DiagnosisView::clickRequested, this, &DoctorPanel::goToPixel);
    connect(m_candidates, &CandidatesTable::chosen, this, [this](int index) {
        const Candidate &candidate = m_diagnosis->candidates[static_cast<std::size_t>(index)];
        m_code->setMistake(candidate.id == "right" ? std::string() : candidate.id, candidate.values);
    });
    connect(m_diagnoser, &Diagnoser::answered, this, [this](const Result<Diagnosis> &answer) {
        if (answer)
            showDiagnosis(*answer);
        else
            showNothing(errorText(answer.error()));
    });
    connect(m_diagnoser, &Diagnoser::jobFailed, this, [this](const JobFailure &failure) {
        showNothing(
            tr("The mistakes could not be tried: %1. Close other programs, then try again.").arg(failureText(failure)));
    });
}

void DoctorPanel::connectDocument()
{
    connect(&m_document, &SceneDocument::opened, this, [this] {
        m_left = {std::exchange(m_setup, std::nullopt), std::exchange(m_taken, std::nullopt),
                  m_form->takeClickedRows()};
        m_setupBefore.reset();
        m_takenBefore.reset();
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (!isVisible())
            return;
        if (changes & Change::Setup)
            takeGivenCamera();
        if (changes & Change::Pick)
            takePick();
        if (!(changes & (kVisibleChanges | Change::Names)))
            return;
        // Points with their own setup are not diagnosed again while the view turns: a chosen
        // candidate stays.
        if (m_setup && !(changes & ((kVisibleChanges & ~Changes(Change::Setup)) | Change::Names)))
            showSetup();
        else
            refresh();
    });
    connect(&m_document.picks().rayCasters(), &RayCasters::built, this, [this] {
        if (isVisible())
            ask();
    });
}

void DoctorPanel::followScene(const QString &lesson, bool isBack)
{
    Clicks left = std::exchange(m_left, {});
    if (lesson.isEmpty() && !isBack) {
        m_aside.reset();
    } else if (!isBack && !m_aside) {
        m_aside = std::move(left);
    } else if (isBack && m_aside) {
        const Clicks clicks = *std::exchange(m_aside, std::nullopt);
        if (m_form->isEmpty())
            m_setup = clicks.setup;
        m_taken = clicks.taken; // its pick comes back and is no new click
        m_form->putBack(clicks.rows);
        if (isVisible())
            refresh();
    }
}

bool DoctorPanel::takeGivenCamera()
{
    const Scene &scene = m_document.scene();
    const glm::dmat4 *view = scene.camera.matrix();
    const GivenCamera given{givenLens(scene), view ? std::optional(*view) : std::nullopt};
    const bool isNew = (given.projection && given.projection != m_given.projection)
                       || (given.eyeFromWorld && given.eyeFromWorld != m_given.eyeFromWorld);
    m_given = given;
    if (isNew && !m_form->isEmpty())
        moveToSetupNow();
    return isNew;
}

bool DoctorPanel::hasGivenCamera(const Setup &setup) const
{
    const std::optional<Setup> now = setupNow();
    return now && (!m_given.projection || setup.lens == now->lens)
           && (!m_given.eyeFromWorld || setup.pose == now->pose);
}

void DoctorPanel::moveToSetupNow()
{
    m_setup = setupNow();
    m_form->forgetClickedDepths();
    refresh();
}

std::optional<Setup> DoctorPanel::setupNow() const
{
    std::optional<Surface> own = m_camera->window();
    if (!own)
        return m_document.setup();
    own->devicePixelRatio = m_document.setup().surface.devicePixelRatio; // a window on the same screen
    const Result<Setup> setup = setupOf(m_document.scene(), *own, m_document.ground().box);
    return setup ? std::optional(*setup) : std::nullopt;
}

std::optional<Setup> DoctorPanel::setup() const
{
    return m_setup ? m_setup : setupNow();
}

std::shared_ptr<const ray::SceneRays> DoctorPanel::raysOf(const Setup &setup) const
{
    const auto casters = m_document.picks().rayCasters().of(m_document.objects());
    const Result<Unprojector> unprojector = Unprojector::of(setup);
    if (m_document.objects().empty() || !casters || !unprojector)
        return nullptr;
    return std::make_shared<const ray::SceneRays>(*unprojector, m_document.objects(), *casters,
                                                  m_document.scene().clipPlanes);
}

void DoctorPanel::takePick()
{
    const std::optional<Pick> &pick = m_document.picks().pick();
    const std::optional<Taken> taken = pick ? std::optional(Taken{pick->devicePixel, pick->setup}) : std::nullopt;
    if (taken == m_taken)
        return;
    if (taken == m_takenBefore) {
        m_taken = taken;
        const std::optional<Setup> since = std::exchange(m_setup, m_setupBefore);
        if (!m_form->takeBackClick())
            m_setup = since;
        showSetup();
        return;
    }
    if (!taken)
        return;
    m_takenBefore = std::exchange(m_taken, taken);
    m_setupBefore = m_setup;
    m_form->forgetClick(); // of the former pick: this one may not fill anything
    const bool isOfView = !m_camera->window();
    const std::optional<Setup> own = !m_form->points().empty() ? setup() : isOfView ? pick->setup : setupNow();
    if (!own)
        return; // showSetup says why
    if (*own == pick->setup) {
        m_setup = own;
        m_form->addClick(pixelCenter(pick->devicePixel), pick->window.z);
        return;
    }
    // The clicked point in the program's own setup.
    const std::optional<WorldPoint> world = m_document.picks().pickedPoint();
    if (!world) {
        m_camera->showUnused(tr("a click on the background has no pixel in another setup."));
        return;
    }
    const Result<WindowPoint> window = windowFromWorld(*own, *world);
    if (!window) {
        m_camera->showUnused(errorText(window.error()));
        return;
    }
    m_setup = own;
    const DevicePoint at = deviceFromWindow(own->surface, *window);
    m_form->addClick(DevicePoint(std::floor(at.x) + kHalfPixel, std::floor(at.y) + kHalfPixel), {});
}

void DoctorPanel::goToPixel(const DevicePoint &pixel)
{
    if (setup() == m_document.setup()) {
        emit pickRequested({static_cast<int>(std::floor(pixel.x)), static_cast<int>(std::floor(pixel.y))});
    } else {
        m_form->addClick(pixel, {});
    }
    m_form->focusWaiting();
}

void DoctorPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    const bool isGiven = takeGivenCamera();
    takePick(); // the last click, wherever it was made
    if (isGiven && m_setup && !hasGivenCamera(*m_setup))
        moveToSetupNow(); // the click was made before
    refresh();
}

void DoctorPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_diagnoser->cancel();
    m_takenBefore = m_taken; // no drag that follows takes a click back here
    m_document.picks().markWrongPoints({});
}

void DoctorPanel::refresh()
{
    if (m_form->isEmpty())
        m_setup.reset();
    else if (!m_setup)
        m_setup = setupNow();
    if (const std::optional<Setup> own = setup())
        m_form->setSetup(*own);
    m_space->refresh();
    showSetup();
    ask();
}

void DoctorPanel::showSetup()
{
    const std::optional<Setup> own = setup(), now = setupNow();
    m_camera->showCamera(m_document.scene(), own.value_or(m_document.setup()), own && now && *own != *now);
    m_camera->showSetup(own, now, m_document.setup().surface);
}

void DoctorPanel::ask()
{
    m_asked = m_form->points();
    const std::optional<SpaceChoice::Space> space = m_space->space();
    for (WrongPoint &point : m_asked) {
        point.space = space ? space->kind : PointSpace::World;
        point.model = space ? space->object : 0;
    }
    const std::optional<Setup> own = setup();
    if (m_asked.empty() || !own || !space) {
        m_diagnoser->cancel();
        showNothing(
            m_form->isEmpty()
                ? tr("Click the pixel that you gave to your program, and type the wrong coordinate that it returned.")
            : !space
                ? tr("The object of this space is not in the scene. Choose the space of your program's coordinates.")
                : tr("Enter the pixel and the three coordinates that your program returned for it."));
        return;
    }
    Case scene;
    scene.setup = *own;
    for (const SceneObject &object : m_document.objects())
        scene.models.push_back({object.name, preciseWorldFromObject(object.transform)});
    scene.otherSize = m_camera->otherSize();
    if (auto rays = raysOf(*own))
        scene.pointOnMesh = ray::MeshPoint(std::move(rays));
    scene.verticesIn = [objects = m_document.objects()](const Box &world) { return verticesIn(objects, world); };
    m_diagnoser->ask(std::move(scene), m_asked);
}

void DoctorPanel::showDiagnosis(const Diagnosis &diagnosis)
{
    m_diagnosis = diagnosis;
    const WrongPoint &first = m_asked[diagnosis.firstPoint()];
    m_answer->setDiagnosis(diagnosis, first);
    m_candidates->setDiagnosis(diagnosis, first);
    m_candidates->show();
    m_code->setMistake(diagnosis.namesMistake() ? diagnosis.verdict : std::string(),
                       diagnosis.candidates.front().values);
    mark();
}

void DoctorPanel::showNothing(const QString &why)
{
    m_diagnosis.reset();
    m_answer->setMessage(why);
    m_code->setMistake({});
    m_candidates->hide();
    mark();
}

void DoctorPanel::mark()
{
    std::vector<WrongPointMark> marks;
    const std::optional<Setup> own = setup();
    if (isVisible() && own && m_diagnosis) {
        const Result<glm::dmat4> eye = eyeFromWorld(*own);
        const Result<Unprojector> unprojector = Unprojector::of(*own);
        const auto rays = raysOf(*own);
        for (const WrongPoint &point : m_asked) {
            glm::dmat4 worldFromSpace(1.0);
            if (point.space == PointSpace::Eye && eye)
                worldFromSpace = glm::inverse(*eye);
            else if (point.space == PointSpace::Object && point.model < m_document.objects().size())
                worldFromSpace = worldFromObject(m_document.objects()[point.model].transform);
            WrongPointMark mark{WorldPoint(glm::dvec3(worldFromSpace * glm::dvec4(point.got, 1.0))), std::nullopt};
            if (point.depth && unprojector) {
                const auto right = unprojector->worldAt(
                    Method::Formula, preciseWindowFromDevice(own->surface, point.pixel, *point.depth));
                if (right)
                    mark.right = *right;
            } else if (rays) {
                mark.right = ray::MeshPoint(rays)(point.pixel);
            }
            marks.push_back(mark);
        }
    }
    m_document.picks().markWrongPoints(std::move(marks));
}

} // namespace unprojector::gui
