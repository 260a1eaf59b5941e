#include "gui/shell/view_size_dialog.h"

#include "gui/document/scene_document.h"
#include "gui/document/view_limits.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/view/scene_view.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr double kLeastRatio = 0.25, kMostRatio = 8.0;

} // namespace

ViewSizeDialog::ViewSizeDialog(SceneDocument &document, const SceneView &view, QWidget *parent)
    : QDialog(parent), m_document(document), m_view(view), m_ratio(new QDoubleSpinBox), m_note(new QLabel)
{
    setWindowTitle(tr("View Size"));
    auto *logical = new QHBoxLayout, *device = new QHBoxLayout;
    m_logical = {addNumber(*logical, tr("Width in logical pixels"),
                           tr("Width of the view as programs give it to a widget, logical pixels"), "logicalWidth"),
                 addNumber(*logical, tr("Height in logical pixels"),
                           tr("Height of the view as programs give it to a widget, logical pixels"), "logicalHeight")};
    m_device = {addNumber(*device, tr("Width in device pixels"),
                          tr("Width of the framebuffer (glViewport), device pixels"), "deviceWidth"),
                addNumber(*device, tr("Height in device pixels"),
                          tr("Height of the framebuffer (glViewport), device pixels"), "deviceHeight")};
    m_ratio->setObjectName(QStringLiteral("pixelRatio"));
    m_ratio->setAccessibleName(tr("Pixel ratio"));
    m_ratio->setToolTip(tr("Device pixels per logical pixel. This screen has %1").arg(view.devicePixelRatio()));
    m_ratio->setRange(kLeastRatio, kMostRatio);
    m_ratio->setDecimals(4);
    m_ratio->setSingleStep(0.25);
    m_ratio->setKeyboardTracking(false);
    m_note->setObjectName(QStringLiteral("note"));
    m_note->setAccessibleName(tr("How the view is shown"));
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);

    auto *form = new QFormLayout;
    form->addRow(tr("Logical pixels"), logical);
    form->addRow(tr("× pixel ratio"), m_ratio);
    form->addRow(tr("= device pixels"), device);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton *fit = buttons->addButton(tr("&Fit the window"), QDialogButtonBox::ResetRole);
    fit->setToolTip(tr("Let the view fill the window"));
    fit->setAutoDefault(false);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Set &size"));
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Give the view this size and keep it in the scene"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Leave the view as it is"));
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_note);
    layout->addStretch();
    layout->addWidget(buttons);

    for (QSpinBox *field : m_logical)
        connect(field, &QSpinBox::valueChanged, this, &ViewSizeDialog::takeLogical);
    for (QSpinBox *field : m_device)
        connect(field, &QSpinBox::valueChanged, this, &ViewSizeDialog::takeDevice);
    connect(m_ratio, &QDoubleSpinBox::valueChanged, this, &ViewSizeDialog::takeLogical);
    connect(buttons, &QDialogButtonBox::accepted, this, &ViewSizeDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(fit, &QPushButton::clicked, this, [this] {
        fitWindow(m_document);
        reject();
    });
    setSize(m_document.setup().surface);
    m_logical[0]->selectAll();
}

QSpinBox *ViewSizeDialog::addNumber(QHBoxLayout &row, const QString &name, const QString &tip, const char *objectName)
{
    auto *field = new QSpinBox;
    field->setObjectName(QLatin1String(objectName));
    field->setAccessibleName(name);
    field->setToolTip(tip);
    field->setRange(1, kMostViewPixels);
    field->setKeyboardTracking(false);
    if (row.count() > 0)
        row.addWidget(new QLabel(QStringLiteral("×")));
    row.addWidget(field, 1);
    return field;
}

Surface ViewSizeDialog::typed() const
{
    return surfaceFromWidget(m_logical[0]->value(), m_logical[1]->value(), m_ratio->value());
}

void ViewSizeDialog::setSize(const Surface &surface)
{
    const std::array pixels{surface.widthPixels, surface.heightPixels};
    const QSignalBlocker ratioIsQuiet(m_ratio);
    m_ratio->setValue(surface.devicePixelRatio);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const QSignalBlocker logicalIsQuiet(m_logical[i]), deviceIsQuiet(m_device[i]);
        m_logical[i]->setMaximum(std::max(1, static_cast<int>(kMostViewPixels / surface.devicePixelRatio)));
        m_logical[i]->setValue(logicalFromDevice(surface, pixels[i]));
        // One step is a logical pixel: a smaller step down would be rounded back.
        m_device[i]->setSingleStep(std::max(1, static_cast<int>(std::ceil(surface.devicePixelRatio))));
        m_device[i]->setValue(pixels[i]);
    }
    refresh();
}

void ViewSizeDialog::takeLogical()
{
    const auto most = static_cast<int>(kMostViewPixels / m_ratio->value());
    for (QSpinBox *field : m_logical) {
        const QSignalBlocker quiet(field);
        field->setMaximum(std::max(1, most));
    }
    m_isRounded = false;
    setSize(typed());
}

void ViewSizeDialog::takeDevice()
{
    const Surface wanted{m_device[0]->value(), m_device[1]->value(), m_ratio->value()};
    const auto logical = [&wanted](int pixels) { return std::max(1, logicalFromDevice(wanted, pixels)); };
    const Surface there =
        surfaceFromWidget(logical(wanted.widthPixels), logical(wanted.heightPixels), wanted.devicePixelRatio);
    setSize(there);
    m_isRounded = there != wanted;
    if (m_isRounded)
        m_note->setText(tr("At this ratio no whole number of logical pixels makes %1 × %2 device pixels. %3 × %4 is "
                           "the nearest size.")
                            .arg(wanted.widthPixels)
                            .arg(wanted.heightPixels)
                            .arg(there.widthPixels)
                            .arg(there.heightPixels));
}

void ViewSizeDialog::refresh()
{
    const Surface size = typed();
    const double scale = SurfacePlace(m_view.widgetSurface(), size).scale();
    m_note->setText(
        scale == 1.0
            ? tr("The window is large enough: the view is shown pixel on pixel.")
            : tr("The window is smaller: the view is drawn at this size and shown at %1 %. Clicks read its own pixels.")
                  .arg(significantText(100.0 * scale, 3)));
}

void ViewSizeDialog::accept()
{
    for (QSpinBox *field : {m_logical[0], m_logical[1], m_device[0], m_device[1]})
        field->interpretText();
    m_ratio->interpretText();
    if (std::exchange(m_isRounded, false))
        return;
    const Check set =
        m_document.edit({tr("View size")}, [size = typed()](scene::Scene &scene) { scene.windowSize = size; });
    if (set)
        QDialog::accept();
    else
        m_note->setText(errorText(set.error()));
}

void fitWindow(SceneDocument &document)
{
    static_cast<void>(
        document.edit({ViewSizeDialog::tr("Fit the window")}, [](scene::Scene &scene) { scene.windowSize.reset(); }));
}

} // namespace unprojector::gui
