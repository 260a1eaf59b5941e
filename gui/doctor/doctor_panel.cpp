#include "gui/doctor/doctor_panel.h"

#include "core/doctor/mesh_vertices.h"
#include "core/doctor/written_points.h"
#include "core/ray/mesh_depth.h"
#include "gui/doctor/candidates_table.h"
#include "gui/doctor/code_changes_view.h"
#include "gui/doctor/diagnoser.h"
#include "gui/doctor/diagnosis_view.h"
#include "gui/doctor/wrong_points_form.h"
#include "gui/document/picks.h"
#include "gui/text/bundled_names.h"
#include "gui/text/error_text.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/refused_field.h"
#include "gui/widgets/typing_pause.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;
using namespace doctor;
namespace {

// The index in the combo box of spaces, after the world; then come the objects.
constexpr int kEyeItem = 1;
constexpr int kFirstObjectItem = 2;

/// A window's size in whole device pixels, "1000 x 700"; nothing for other texts.
std::optional<Surface> sizeOf(QString text)
{
    text.replace(u'x', u' ').replace(u'×', u' ').replace(u'X', u' ').replace(u'*', u' ');
    const auto numbers = writtenNumbers(text.toStdString(), 2);
    constexpr double kMost = 1e6;
    if (!numbers)
        return std::nullopt;
    for (const WrittenNumber &number : *numbers) {
        if (!(number.value >= 1.0 && number.value <= kMost) || std::floor(number.value) != number.value)
            return std::nullopt;
    }
    return Surface{static_cast<int>((*numbers)[0].value), static_cast<int>((*numbers)[1].value), 1.0};
}

QString sizeText(const Surface &surface)
{
    return QStringLiteral("%1 × %2").arg(surface.widthPixels).arg(surface.heightPixels);
}

QLineEdit *sizeField(const QString &name, const QString &help)
{
    auto *field = new QLineEdit;
    field->setAccessibleName(name);
    field->setToolTip(help);
    return field;
}

} // namespace

DoctorPanel::DoctorPanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_diagnoser(new Diagnoser(this)), m_form(new WrongPointsForm),
      m_space(new QComboBox), m_setupText(new QLabel), m_currentSetup(new QPushButton(tr("Use curre&nt view"))),
      m_answer(new DiagnosisView), m_code(new CodeChangesView), m_candidates(new CandidatesTable)
{
    auto *spaceLine = new QHBoxLayout;
    auto *spaceLabel = new QLabel(tr("&In the space:"));
    spaceLabel->setBuddy(m_space);
    m_space->setAccessibleName(tr("Space of the points that the program got"));
    m_space->setToolTip(tr("Space in which the program expresses its points"));
    m_space->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_space->setMinimumContentsLength(8);
    spaceLine->addWidget(spaceLabel);
    spaceLine->addWidget(m_space, 1);

    m_setupText->setWordWrap(true);
    m_setupText->setTextFormat(Qt::PlainText); // it repeats the typed text
    m_setupText->setAccessibleName(tr("Setup of the pixels"));
    m_currentSetup->setToolTip(tr("Read the pixels in the current view"));
    // The widgets below don't move when this appears.
    QSizePolicy policy = m_currentSetup->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_currentSetup->setSizePolicy(policy);
    auto *setupLine = new QHBoxLayout;
    setupLine->addWidget(m_setupText, 1);
    setupLine->addWidget(m_currentSetup);

    // Counted in digits, as in the comparison.
    constexpr int kLeastDigits = 48;
    setMinimumWidth(kLeastDigits * fontMetrics().horizontalAdvance(u'0'));

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(m_form);
    layout->addLayout(spaceLine);
    layout->addLayout(setupLine);
    layout->addWidget(createProgram());
    auto *line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    layout->addWidget(line);
    layout->addWidget(m_answer);
    layout->addWidget(m_code);
    layout->addWidget(m_candidates);
    layout->addStretch();
    m_candidates->hide();

    connect(m_form, &WrongPointsForm::changed, this, &DoctorPanel::refresh);
    connect(m_space, &QComboBox::activated, this, &DoctorPanel::ask);
    connect(m_currentSetup, &QPushButton::clicked, this, [this] {
        m_setup = setupNow();
        refresh();
    });
    connect(m_answer, &DiagnosisView::clickRequested, this, &DoctorPanel::goToPixel);
    connect(m_candidates, &CandidatesTable::chosen, this, [this](int index) {
        const std::string &id = m_diagnosis->candidates[static_cast<std::size_t>(index)].id;
        m_code->setMistake(id == "right" ? std::string() : id);
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
    connect(&document, &SceneDocument::opened, this, [this] {
        m_setup.reset();
        m_taken.reset();
        m_takenBefore.reset();
    });
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (!isVisible())
            return;
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
    connect(&document.picks().rayCasters(), &RayCasters::built, this, [this] {
        if (isVisible())
            ask();
    });
    showSpaces();
    showSetup();
    ask();
}

DoctorPanel::~DoctorPanel() = default;

QWidget *DoctorPanel::createProgram()
{
    m_fold = new QToolButton;
    m_fold->setText(tr("More about your program"));
    m_fold->setToolTip(tr("The size of its window, and another size that it may use by mistake"));
    m_fold->setCheckable(true);
    m_fold->setAutoRaise(true);
    m_fold->setArrowType(Qt::RightArrow);
    m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_window = sizeField(tr("Its window"), tr("Device pixels, such as 1000 x 700. Empty: as large as the view"));
    m_otherSize =
        sizeField(tr("Another size"),
                  tr("Device pixels, such as 640 x 480: an earlier size of the window, or another framebuffer's"));
    m_otherSize->setPlaceholderText(tr("none"));
    m_sizeFault = new QLabel;
    m_sizeFault->setWordWrap(true);
    m_sizeFault->setTextFormat(Qt::PlainText);
    m_sizeFault->hide();
    m_program = new QWidget;
    auto *form = new QFormLayout(m_program);
    form->setContentsMargins(16, 0, 0, 0);
    form->addRow(tr("Its &window:"), m_window);
    form->addRow(tr("Another &size it may use:"), m_otherSize);
    form->addRow(m_sizeFault);
    m_program->hide();
    auto *whole = new QWidget;
    auto *layout = new QVBoxLayout(whole);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto *head = new QHBoxLayout;
    head->addWidget(m_fold);
    head->addStretch();
    head->addWidget(new HelpLink(QStringLiteral("wrong")));
    layout->addLayout(head);
    layout->addWidget(m_program);
    connect(m_fold, &QToolButton::toggled, this, [this](bool isOpen) {
        m_fold->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        m_program->setVisible(isOpen);
    });
    const auto finish = [this] {
        QString fault;
        for (QLineEdit *field : {m_window, m_otherSize}) {
            const QString text = field->text().trimmed();
            const bool isBad = !text.isEmpty() && !sizeOf(text);
            setRefused(*field, isBad);
            if (isBad && fault.isEmpty())
                fault = tr("“%1” is not a size: type width and height in whole pixels, such as 1000 x 700.").arg(text);
        }
        m_sizeFault->setText(fault);
        m_sizeFault->setVisible(!fault.isEmpty());
    };
    auto *pause = new QTimer(whole);
    pause->setSingleShot(true);
    pause->setInterval(kTypingPause);
    connect(pause, &QTimer::timeout, this, finish);
    for (const QLineEdit *field : {m_window, m_otherSize})
        connect(field, &QLineEdit::textEdited, pause, qOverload<>(&QTimer::start));
    connect(m_window, &QLineEdit::editingFinished, this, [this, finish] {
        finish();
        if (m_window->isModified() && !m_form->isEmpty())
            m_setup = setupNow();
        m_window->setModified(false);
        refresh();
    });
    connect(m_otherSize, &QLineEdit::editingFinished, this, [this, finish] {
        finish();
        ask();
    });
    return whole;
}

std::optional<Setup> DoctorPanel::setupNow() const
{
    std::optional<Surface> own = sizeOf(m_window->text());
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
    const bool isOfView = !sizeOf(m_window->text());
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
        m_setupText->setText(tr("Not used: a click on the background has no pixel in another setup."));
        return;
    }
    const Result<WindowPoint> window = windowFromWorld(*own, *world);
    if (!window) {
        m_setupText->setText(tr("Not used: %1").arg(errorText(window.error())));
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
    takePick(); // the last click, wherever it was made
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
    showSpaces();
    showSetup();
    ask();
}

void DoctorPanel::showSetup()
{
    m_window->setPlaceholderText(tr("as the view, %1").arg(sizeText(m_document.setup().surface)));
    const std::optional<Setup> own = setup(), now = setupNow();
    if (!own) {
        m_setupText->setText(tr("The scene cannot be drawn in a window of %1.").arg(m_window->text()));
        m_currentSetup->hide();
        return;
    }
    const QString size = sizeText(own->surface);
    const bool isPast = now && *own != *now;
    m_setupText->setText(isPast                     ? tr("Pixels of %1, of the view when they were entered").arg(size)
                         : sizeOf(m_window->text()) ? tr("Pixels of your program's window, %1").arg(size)
                                                    : tr("Pixels of the view, %1").arg(size));
    m_currentSetup->setVisible(isPast);
}

void DoctorPanel::showSpaces()
{
    QStringList names{tr("World"), tr("Eye")};
    for (const SceneObject &object : m_document.objects())
        names << tr("Object: %1").arg(readName(object.name, m_document.objects()));
    QStringList shown;
    for (int i = 0; i < m_space->count(); ++i)
        shown << m_space->itemText(i);
    if (names == shown)
        return;
    const QString current = m_space->currentText();
    m_space->clear();
    m_space->addItems(names);
    m_space->setCurrentIndex(std::max(0, static_cast<int>(names.indexOf(current))));
}

void DoctorPanel::ask()
{
    m_asked = m_form->points();
    const int space = m_space->currentIndex();
    for (WrongPoint &point : m_asked) {
        point.space = space == kEyeItem           ? PointSpace::Eye
                      : space >= kFirstObjectItem ? PointSpace::Object
                                                  : PointSpace::World;
        point.model = static_cast<std::size_t>(std::max(0, space - kFirstObjectItem));
    }
    const std::optional<Setup> own = setup();
    if (m_asked.empty() || !own) {
        m_diagnoser->cancel();
        showNothing(
            m_form->isEmpty()
                ? tr("Click the pixel that you gave to your program, and type the wrong coordinate that it returned.")
                : tr("Enter the pixel and the three coordinates that your program returned for it."));
        return;
    }
    Case scene;
    scene.setup = *own;
    for (const SceneObject &object : m_document.objects())
        scene.models.push_back({object.name, worldFromObject(object.transform)});
    scene.otherSize = sizeOf(m_otherSize->text());
    if (auto rays = raysOf(*own))
        scene.depthOnMesh = ray::MeshDepth(std::move(rays));
    scene.verticesIn = [objects = m_document.objects()](const Box &world) { return verticesIn(objects, world); };
    m_diagnoser->ask(std::move(scene), m_asked);
}

void DoctorPanel::showDiagnosis(const Diagnosis &diagnosis)
{
    m_diagnosis = diagnosis;
    m_answer->setDiagnosis(diagnosis, m_asked.front());
    m_candidates->setDiagnosis(diagnosis, m_asked.front());
    m_candidates->show();
    m_code->setMistake(diagnosis.namesMistake() ? diagnosis.verdict : std::string());
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
            std::optional<double> depth = point.depth;
            if (!depth && rays)
                depth = ray::MeshDepth(rays)(point.pixel);
            if (depth && unprojector) {
                const auto right =
                    unprojector->worldAt(Method::Formula, windowFromDevice(own->surface, point.pixel, *depth));
                if (right)
                    mark.right = *right;
            }
            marks.push_back(mark);
        }
    }
    m_document.picks().markWrongPoints(std::move(marks));
}

} // namespace unprojector::gui
