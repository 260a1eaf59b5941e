#include "gui/shell/export_picture_dialog.h"

#include "core/base/replace_file.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/text/error_text.h"
#include "gui/view/scene_picture.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/save_name.h"
#include "gui/window/window.h"

#include <QBuffer>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace unprojector::gui {
using namespace geometry;

namespace {

/// A frame takes twenty bytes a pixel, and the image four more.
constexpr std::int64_t kMostPixels = 64'000'000;
constexpr double kLeastRatio = 0.1, kMostRatio = 16.0;

QCheckBox *checkBox(const QString &text, const QString &toolTip, bool isChecked = true)
{
    auto *box = new QCheckBox(text);
    box->setToolTip(toolTip);
    box->setChecked(isChecked);
    return box;
}

QSpinBox *pixelsBox(const QString &name, const QString &toolTip, int value)
{
    constexpr int kMost = 999'999; // beyond any driver; the dialog names the limit
    auto *box = new QSpinBox;
    box->setRange(1, kMost);
    box->setValue(value);
    box->setSuffix(QStringLiteral(" px"));
    box->setAccessibleName(name);
    box->setToolTip(toolTip);
    return box;
}

} // namespace

ExportPictureDialog::ExportPictureDialog(const SceneView &view, QWidget *parent)
    : QDialog(parent), m_view(surfaceFromWidget(view.width(), view.height(), view.devicePixelRatio())),
      m_largest(view.largestPicture()), m_problem(new QLabel)
{
    setWindowTitle(tr("Export Image"));
    auto *form = new QFormLayout;
    addSize(*form);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    addMarks(*layout, view.hasMap());
    m_problem->setWordWrap(true);
    m_problem->setAccessibleName(tr("Reason why the image cannot be exported"));
    layout->addWidget(m_problem);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
    m_export->setDefault(true);
    m_export->setToolTip(tr("Choose a file and write the image"));
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showProblem();
}

void ExportPictureDialog::addSize(QFormLayout &form)
{
    m_width = pixelsBox(tr("Width"), tr("Width of the image in pixels"), m_view.widthPixels);
    m_height = pixelsBox(tr("Height"), tr("Height of the image in pixels"), m_view.heightPixels);
    m_ratio = new QDoubleSpinBox;
    m_ratio->setRange(kLeastRatio, kMostRatio);
    m_ratio->setSingleStep(0.25);
    m_ratio->setValue(m_view.devicePixelRatio);
    m_ratio->setAccessibleName(tr("Pixel ratio"));
    m_ratio->setToolTip(tr("Image pixels per logical pixel; sets the size of lines, markers and letters"));
    m_keepsProportions = checkBox(tr("&Keep the view's proportions"),
                                  tr("Width, height and pixel ratio change together: the same image at another size"));
    form.addRow(tr("&Width:"), m_width);
    form.addRow(tr("&Height:"), m_height);
    form.addRow(tr("Pixel &ratio:"), m_ratio);
    form.addRow(QString(), m_keepsProportions);
    connect(m_width, &QSpinBox::valueChanged, this,
            [this] { followSide(*m_width, *m_height, m_view.widthPixels, m_view.heightPixels); });
    connect(m_height, &QSpinBox::valueChanged, this,
            [this] { followSide(*m_height, *m_width, m_view.heightPixels, m_view.widthPixels); });
    connect(m_keepsProportions, &QCheckBox::toggled, this, [this](bool keeps) {
        if (keeps)
            followSide(*m_width, *m_height, m_view.widthPixels, m_view.heightPixels);
    });
}

void ExportPictureDialog::addMarks(QVBoxLayout &layout, bool hasMap)
{
    auto *shown = new QGroupBox(tr("Also shown"));
    auto *boxes = new QVBoxLayout(shown);
    m_pick = checkBox(tr("&Pick"), tr("The picked point with its lines to the ground"));
    m_landmarks = checkBox(tr("&Landmarks"), tr("The placed landmarks with their names"));
    m_curves = checkBox(tr("&Curves"), tr("The curves between landmarks"));
    m_grid = checkBox(tr("&Ground and clip planes"), tr("The grid on the ground, and the planes that cut the objects"));
    m_axes = checkBox(tr("&Axes"), tr("The axes of the world, and their directions in the corner"));
    m_map = checkBox(tr("Error &map"),
                     hasMap ? tr("The map's colours over the objects; needs the proportions of the view")
                            : tr("The view shows no map. View > Error Map shows one."),
                     hasMap);
    m_map->setEnabled(hasMap);
    for (QCheckBox *box : {m_pick, m_landmarks, m_curves, m_grid, m_axes, m_map})
        boxes->addWidget(box);
    m_isTransparent =
        checkBox(tr("&Transparent background"), tr("Leave the background of the image transparent"), false);
    layout.addWidget(shown);
    layout.addWidget(m_isTransparent);
}

void ExportPictureDialog::followSide(const QSpinBox &changed, QSpinBox &other, int changedOfView, int otherOfView)
{
    if (m_keepsProportions->isChecked()) {
        const double scale = static_cast<double>(changed.value()) / changedOfView;
        const QSignalBlocker blocker(other);
        other.setValue(static_cast<int>(std::lround(scale * otherOfView)));
        m_ratio->setValue(scale * m_view.devicePixelRatio);
    }
    showProblem();
}

PictureOptions ExportPictureDialog::options() const
{
    PictureMarks marks;
    marks.pick = m_pick->isChecked();
    marks.landmarks = m_landmarks->isChecked();
    marks.curves = m_curves->isChecked();
    marks.grid = m_grid->isChecked();
    marks.axes = m_axes->isChecked();
    marks.map = m_map->isChecked();
    // The spin box rounds: the view's exact ratio is kept.
    const bool isViews = std::abs(m_ratio->value() - m_view.devicePixelRatio) < 0.006;
    return {{m_width->value(), m_height->value(), isViews ? m_view.devicePixelRatio : m_ratio->value()},
            marks,
            m_isTransparent->isChecked()};
}

QString ExportPictureDialog::problem() const
{
    const int width = m_width->value(), height = m_height->value();
    if (m_largest == 0)
        return tr("OpenGL has not started, so no image can be exported.");
    if (width > m_largest || height > m_largest)
        return tr("The graphics driver draws at most %1 × %1 pixels. You entered %2 × %3.")
            .arg(m_largest)
            .arg(width)
            .arg(height);
    if (std::int64_t(width) * height > kMostPixels)
        return tr("An image has at most %1 million pixels. You entered %2 × %3, which are %4 million.")
            .arg(kMostPixels / 1'000'000)
            .arg(width)
            .arg(height)
            .arg((std::int64_t(width) * height + 999'999) / 1'000'000);
    return {};
}

void ExportPictureDialog::showProblem()
{
    const QString text = problem();
    m_problem->setText(text);
    m_problem->setVisible(!text.isEmpty());
    m_export->setEnabled(text.isEmpty());
    m_export->setToolTip(text.isEmpty() ? tr("Choose a file and write the image") : text);
}

QString writePicture(SceneView &view, const PictureOptions &options, const std::filesystem::path &file)
{
    const Result<QImage> picture = scenePicture(view, options);
    if (!picture)
        return errorText(picture.error());
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (picture->isNull() || !picture->save(&buffer, "png"))
        return ExportPictureDialog::tr("OpenGL has no memory for an image of %1 × %2 pixels. Choose a smaller size.")
            .arg(options.surface.widthPixels)
            .arg(options.surface.heightPixels);
    const base::Done written = base::replaceFile(file, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return written ? QString() : pathText(file) + ": " + QString::fromStdString(written.error().text);
}

void exportPicture(Window &window)
{
    window.session().commitTyped();
    ExportPictureDialog dialog(window.view(), &window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const SaveName named =
        askSaveName(window, ExportPictureDialog::tr("Export Image"), {ExportPictureDialog::tr("Image (*.png)")},
                    pathText(window.session().proposedName().stem()), FileKind::Image);
    if (named.file.empty() || !window.mayExportTo(named.file))
        return;
    if (const QString problem = writePicture(window.view(), dialog.options(), named.file); !problem.isEmpty())
        window.showFailure(problem);
    else
        window.notice(ExportPictureDialog::tr("Image written to %1").arg(pathText(named.file.filename())));
}

} // namespace unprojector::gui
