#include "gui/doctor/camera_step.h"

#include "core/scene/given_matrices.h"

#include "gui/doctor/step_heading.h"
#include "gui/text/number_text.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/fold.h"
#include "gui/widgets/refused_field.h"
#include "gui/widgets/typing_pause.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace unprojector::gui {
using namespace geometry;
namespace {

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

CameraStep::CameraStep(QWidget *parent)
    : QWidget(parent), m_camera(new QLabel), m_paste(new QPushButton(tr("&Paste camera…"))), m_setup(new QLabel),
      m_currentView(new QPushButton(tr("Use curre&nt view")))
{
    for (QLabel *label : {m_camera, m_setup}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText); // it repeats typed text
    }
    m_camera->setAccessibleName(tr("The camera that counts"));
    m_setup->setAccessibleName(tr("Setup of the pixels"));
    m_paste->setToolTip(tr("Give the camera of your program: K, R, t, a camera's file, matrices, or calls"));
    m_currentView->setToolTip(tr("Read the pixels in the current view"));
    // The widgets below don't move when this appears.
    QSizePolicy policy = m_currentView->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_currentView->setSizePolicy(policy);
    auto *cameraLine = new QHBoxLayout;
    cameraLine->addWidget(m_camera, 1);
    cameraLine->addWidget(m_paste);
    auto *setupLine = new QHBoxLayout;
    setupLine->addWidget(m_setup, 1);
    setupLine->addWidget(m_currentView);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(stepHeading(1, tr("Your camera")));
    layout->addLayout(cameraLine);
    layout->addLayout(setupLine);
    layout->addWidget(new Fold(tr("More about your program"),
                               tr("The size of its window, and another size that it may use by mistake"), createSizes(),
                               QStringLiteral("wrong")));
    connect(m_paste, &QPushButton::clicked, this, &CameraStep::pasteWanted);
    connect(m_currentView, &QPushButton::clicked, this, &CameraStep::currentViewWanted);
}

QWidget *CameraStep::createSizes()
{
    m_window = sizeField(tr("Its window"), tr("Device pixels, such as 1000 x 700. Empty: as large as the view"));
    m_otherSize =
        sizeField(tr("Another size"),
                  tr("Device pixels, such as 640 x 480: an earlier size of the window, or another framebuffer's"));
    m_otherSize->setPlaceholderText(tr("none"));
    m_fault = new QLabel;
    m_fault->setWordWrap(true);
    m_fault->setTextFormat(Qt::PlainText);
    m_fault->hide();
    auto *sizes = new QWidget;
    auto *form = new QFormLayout(sizes);
    form->setContentsMargins(16, 0, 0, 0);
    form->addRow(tr("Its &window:"), m_window);
    form->addRow(tr("Another &size it may use:"), m_otherSize);
    form->addRow(m_fault);
    const auto finish = [this] {
        QString fault;
        for (QLineEdit *field : {m_window, m_otherSize}) {
            const QString text = field->text().trimmed();
            const bool isBad = !text.isEmpty() && !typedSize(text);
            setRefused(*field, isBad);
            if (isBad && fault.isEmpty())
                fault = sizeFaultText(text);
        }
        m_fault->setText(fault);
        m_fault->setVisible(!fault.isEmpty());
    };
    auto *pause = new QTimer(sizes);
    pause->setSingleShot(true);
    pause->setInterval(kTypingPause);
    connect(pause, &QTimer::timeout, this, finish);
    for (const QLineEdit *field : {m_window, m_otherSize})
        connect(field, &QLineEdit::textEdited, pause, qOverload<>(&QTimer::start));
    connect(m_window, &QLineEdit::editingFinished, this, [this, finish] {
        finish();
        const bool isNew = m_window->isModified();
        m_window->setModified(false);
        emit windowEntered(isNew);
    });
    connect(m_otherSize, &QLineEdit::editingFinished, this, [this, finish] {
        finish();
        emit otherSizeEntered();
    });
    return sizes;
}

std::optional<Surface> CameraStep::window() const
{
    return typedSize(m_window->text());
}

std::optional<Surface> CameraStep::otherSize() const
{
    return typedSize(m_otherSize->text());
}

void CameraStep::showCamera(const scene::Scene &scene, const Setup &setup, bool isPast)
{
    const bool hasProjection = scene::givenLens(scene).has_value(), hasView = scene.camera.matrix();
    const QString which = isPast ? tr("The camera with which the points were entered counts.")
                          : hasProjection && hasView
                              ? tr("The camera that you gave counts: its projection and its view.")
                          : hasProjection ? tr("The projection that you gave counts, with this scene's view.")
                          : hasView       ? tr("The view that you gave counts, with this scene's projection.")
                                          : tr("This scene's camera counts.");
    const ProjectionWindow planes = projectionWindow(setup.projection());
    const QString kind = isPerspective(setup.projection()) ? tr("Perspective") : tr("Orthographic");
    m_camera->setText(which + u' '
                      + tr("%1, near %2, far %3.", "kind of projection")
                            .arg(kind, writtenText(planes.nearDistance, 4), writtenText(planes.farDistance, 4)));
}

void CameraStep::showSetup(const std::optional<Setup> &own, const std::optional<Setup> &now, const Surface &view)
{
    m_window->setPlaceholderText(tr("as the view, %1").arg(sizeText(view)));
    if (!own) {
        m_setup->setText(tr("The scene cannot be drawn in a window of %1.").arg(m_window->text()));
        m_currentView->hide();
        return;
    }
    const QString size = sizeText(own->surface);
    const bool isPast = now && *own != *now;
    m_setup->setText(isPast     ? tr("Pixels of %1, of the view when they were entered").arg(size)
                     : window() ? tr("Pixels of your program's window, %1").arg(size)
                                : tr("Pixels of the view, %1").arg(size));
    m_currentView->setVisible(isPast);
}

void CameraStep::showUnused(const QString &why)
{
    m_setup->setText(tr("Not used: %1").arg(why));
}

} // namespace unprojector::gui
