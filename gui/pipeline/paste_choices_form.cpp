#include "gui/pipeline/paste_choices_form.h"

#include "gui/document/view_limits.h"
#include "gui/pipeline/matrix_text.h"
#include "gui/text/number_text.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/refused_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
#include <span>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;

namespace {

constexpr std::array kDirections{PoseDirection::WorldToCamera, PoseDirection::CameraToWorld};
constexpr std::array kCentres{PixelCentres::AtIntegers, PixelCentres::AtHalves};
constexpr std::array kRoles{MatrixRole::View, MatrixRole::Projection, MatrixRole::Product};
constexpr std::array kDepths{NdcDepth::MinusOneToOne, NdcDepth::ZeroToOne};

QString depthName(NdcDepth depth)
{
    return depth == NdcDepth::MinusOneToOne ? PasteChoicesForm::tr("−1 to 1: OpenGL")
                                            : PasteChoicesForm::tr("0 to 1: Vulkan, Direct3D, Metal, WebGPU");
}

/// The positive number in a field; nothing for a blank or another text.
std::optional<double> numberIn(const QLineEdit &field)
{
    bool isNumber = false;
    const double value = field.text().trimmed().toDouble(&isNumber);
    return isNumber && value > 0.0 ? std::optional(value) : std::nullopt;
}

bool isRefused(const QLineEdit &field, bool isRead)
{
    return !field.text().trimmed().isEmpty() && !isRead;
}

/// The combo box of a choice; its first item is what was read.
template <class Value, std::size_t n>
QComboBox *choiceOf(const QString &name, const QString &help, const std::array<Value, n> &values,
                    QString (*text)(Value))
{
    auto *box = new QComboBox;
    box->setAccessibleName(name);
    box->setToolTip(help);
    box->addItem(PasteChoicesForm::tr("As read"));
    for (const Value value : values)
        box->addItem(text(value), static_cast<int>(value));
    return box;
}

template <class Value>
std::optional<Value> chosenIn(const QComboBox &box)
{
    return box.currentIndex() > 0 ? std::optional(static_cast<Value>(box.currentData().toInt())) : std::nullopt;
}

void showAsRead(QComboBox &box, const QString &read)
{
    if (box.currentIndex() <= 0)
        box.setItemText(0, PasteChoicesForm::tr("As read: %1").arg(read));
}

QWidget *sideBySide(std::initializer_list<QWidget *> fields)
{
    auto *all = new QWidget;
    auto *line = new QHBoxLayout(all);
    line->setContentsMargins(0, 0, 0, 0);
    for (QWidget *field : fields)
        line->addWidget(field, qobject_cast<QLineEdit *>(field) ? 1 : 0);
    return all;
}

} // namespace

QString axesName(EyeAxes axes)
{
    switch (axes) {
    case EyeAxes::RightUpBack: return PasteChoicesForm::tr("OpenGL: right, up, back");
    case EyeAxes::RightDownAhead: return PasteChoicesForm::tr("OpenCV: right, down, ahead");
    case EyeAxes::RightUpAhead: return PasteChoicesForm::tr("Direct3D: right, up, ahead");
    case EyeAxes::AheadRightUp: return PasteChoicesForm::tr("Unreal: ahead, right, up");
    case EyeAxes::AheadLeftUp: break;
    }
    return PasteChoicesForm::tr("ROS: ahead, left, up");
}

QString directionName(PoseDirection direction)
{
    return direction == PoseDirection::WorldToCamera ? PasteChoicesForm::tr("World to camera")
                                                     : PasteChoicesForm::tr("Camera to world");
}

QString centresName(PixelCentres centres)
{
    return centres == PixelCentres::AtIntegers ? PasteChoicesForm::tr("At 0, 0") : PasteChoicesForm::tr("At 0.5, 0.5");
}

PasteChoicesForm::PasteChoicesForm(QWidget *parent) : QWidget(parent), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(0, 0, 0, 0);
    addFields();
}

void PasteChoicesForm::addFields()
{
    m_image = new QComboBox;
    m_image->setAccessibleName(tr("Image"));
    m_image->setToolTip(tr("The image or frame whose camera is read"));
    const auto field = [this](const QString &name, const QString &help) {
        auto *made = new QLineEdit;
        made->setAccessibleName(name);
        made->setToolTip(help);
        connect(made, &QLineEdit::textEdited, this, &PasteChoicesForm::choicesChanged);
        return made;
    };
    m_size = field(tr("Image size"), tr("Width and height of the camera's image, pixels: 640 x 480"));
    m_takesSize = new QCheckBox(tr("Give the view this size"));
    m_takesSize->setChecked(true);
    m_takesSize->setToolTip(tr("Pixels of the view are then the camera's pixels; View > Fit the Window undoes it"));
    m_sizes = sideBySide({m_size, m_takesSize});
    m_near = field(tr("Near"), tr("Distance of the near plane: it maps depths, and hides what is closer"));
    m_far = field(tr("Far"), tr("Distance of the far plane: it maps depths, and hides what is farther"));
    auto *farLabel = new QLabel(tr("Fa&r:"));
    farLabel->setBuddy(m_far);
    m_distances = sideBySide({m_near, farLabel, m_far});
    m_axes = choiceOf(tr("Axes of the camera"), tr("The directions of the camera's x, y and z in its image"), kEyeAxes,
                      axesName);
    m_direction = choiceOf(tr("Pose"), tr("What the pose turns into what: its direction"), kDirections, directionName);
    m_centres = choiceOf(tr("Pixel centres"), tr("The coordinates of the first pixel's centre in the program"),
                         kCentres, centresName);
    m_isUndistorted = new QCheckBox(tr("My pixels are of the undistorted image"));
    m_isUndistorted->setToolTip(tr("Drop the distortion coefficients: the view has no distortion"));
    m_role = choiceOf(tr("Matrix"), tr("The role of the only matrix in the text"), kRoles, roleName);
    m_ndcDepth = choiceOf(tr("NDC depths"), tr("The depths of NDC at near and far"), kDepths, depthName);
    m_form->addRow(tr("&Image:"), m_image);
    m_form->addRow(tr("Image &size:"), m_sizes);
    m_form->addRow(tr("&Near:"), m_distances);
    m_form->addRow(tr("&Axes:"), m_axes);
    m_form->addRow(tr("P&ose:"), m_direction);
    m_form->addRow(tr("Pixel &centres:"), m_centres);
    m_form->addRow(m_isUndistorted);
    m_form->addRow(tr("&Matrix:"), m_role);
    m_form->addRow(tr("NDC &depths:"), m_ndcDepth);
    for (QComboBox *box : findChildren<QComboBox *>()) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(20);
        connect(box, &QComboBox::activated, this, &PasteChoicesForm::choicesChanged);
    }
    for (QCheckBox *box : {m_takesSize, m_isUndistorted})
        connect(box, &QCheckBox::clicked, this, &PasteChoicesForm::choicesChanged);
}

PasteChoices PasteChoicesForm::choices() const
{
    PasteChoices choices;
    CameraChoices &camera = choices.camera;
    if (m_image->count() > 1) {
        const QString name = m_image->currentText();
        int same = 0;
        for (int i = 0; i < m_image->count(); ++i)
            same += m_image->itemText(i) == name ? 1 : 0;
        camera.image = same > 1 ? std::to_string(m_image->currentIndex()) : name.toStdString();
    }
    if (const auto size = typedSize(m_size->text()))
        camera.size = ImageSize{size->widthPixels, size->heightPixels};
    camera.nearDistance = numberIn(*m_near);
    camera.farDistance = numberIn(*m_far);
    camera.axes = chosenIn<EyeAxes>(*m_axes);
    camera.direction = chosenIn<PoseDirection>(*m_direction);
    camera.centres = chosenIn<PixelCentres>(*m_centres);
    camera.isUndistorted = m_isUndistorted->isChecked();
    choices.role = chosenIn<MatrixRole>(*m_role);
    choices.ndcDepth = chosenIn<NdcDepth>(*m_ndcDepth);
    return choices;
}

void PasteChoicesForm::forgetText()
{
    for (int row = 0; row < m_form->rowCount(); ++row)
        m_form->setRowVisible(row, false);
    m_image->clear();
    m_role->setCurrentIndex(0);
    m_ndcDepth->setCurrentIndex(0);
}

void PasteChoicesForm::forgetAll()
{
    forgetText();
    for (QLineEdit *field : {m_size, m_near, m_far})
        field->clear();
    for (QComboBox *box : {m_axes, m_direction, m_centres})
        box->setCurrentIndex(0);
    m_takesSize->setChecked(true);
    m_isUndistorted->setChecked(false);
}

void PasteChoicesForm::showCamera(const PastedCamera &camera)
{
    const auto &foreign = camera.foreign;
    QStringList images, shown;
    for (const std::string &name : foreign ? foreign->images : std::vector<std::string>())
        images << QString::fromStdString(name);
    for (int i = 0; i < m_image->count(); ++i)
        shown << m_image->itemText(i);
    if (foreign && shown != images) {
        m_image->clear();
        m_image->addItems(images);
        m_image->setCurrentIndex(static_cast<int>(foreign->image));
    }
    // A fault may ask for one of these, and what is assumed may name it.
    std::vector<std::string> said = foreign ? foreign->assumed : std::vector<std::string>();
    if (camera.scene)
        said.insert(said.end(), camera.scene->assumed.begin(), camera.scene->assumed.end());
    if (camera.fault)
        said.push_back(camera.fault->text);
    const auto asks = [&said](const char *option) {
        return std::ranges::any_of(said,
                                   [option](const std::string &one) { return one.find(option) != std::string::npos; });
    };
    // The fields of one image stay for the others, so that none moves under the pointer.
    const bool areKept = foreign && foreign->images.size() > 1;
    const auto show = [&](QWidget *field, bool isNeeded) {
        m_form->setRowVisible(field, isNeeded || (areKept && m_form->isRowVisible(field)));
    };
    const bool hasPose = foreign && foreign->pose;
    show(m_image, m_image->count() > 1);
    show(m_sizes, foreign || asks("--size") || !m_size->text().isEmpty());
    show(m_distances, (foreign && foreign->intrinsics) || asks("--near") || asks("--far") || !m_near->text().isEmpty()
                          || !m_far->text().isEmpty());
    const auto &matrices = camera.matrices;
    const bool isAlone = matrices.size() == 1 && matrices[0].given.form != MatrixForm::Call;
    const bool isView = camera.openDirection.has_value();
    show(m_direction, hasPose || isView || asks("--pose") || m_direction->currentIndex() > 0);
    if (isView) {
        showAsRead(*m_direction, directionName(PoseDirection::WorldToCamera));
        showAsRead(*m_axes, axesName(EyeAxes::RightUpBack));
    }
    show(m_axes, foreign || isView || asks("--axes") || m_axes->currentIndex() > 0);
    show(m_centres, foreign && hasCentres(*foreign));
    show(m_isUndistorted, (foreign && foreign->distortion && !foreign->distortion->isNone()) || asks("--undistorted")
                              || m_isUndistorted->isChecked());
    show(m_role, isAlone);
    if (isAlone)
        showAsRead(*m_role, roleName(matrices[0].role));
    show(m_ndcDepth, std::any_of(matrices.begin(), matrices.end(), [](const ReadMatrix &one) {
             return one.role != MatrixRole::View && one.given.form != MatrixForm::Call;
         }));
    bool isAny = false;
    for (int row = 0; row < m_form->rowCount(); ++row)
        isAny = isAny || m_form->isRowVisible(row);
    setVisible(isAny);
    if (foreign && foreign->intrinsics)
        m_centres->setItemText(0, tr("As read: %1").arg(centresName(foreign->intrinsics->centres)));
    setRefused(*m_size, isRefused(*m_size, typedSize(m_size->text()).has_value()));
    for (QLineEdit *field : {m_near, m_far})
        setRefused(*field, isRefused(*field, numberIn(*field).has_value()));
    for (QLineEdit *field : {m_size, m_near, m_far})
        field->setPlaceholderText({});
    m_takesSize->setEnabled(camera.scene
                            && std::max(camera.scene->size.width, camera.scene->size.height) <= kMostViewPixels);
    if (!camera.scene)
        return;
    const SceneCamera &scene = *camera.scene;
    m_size->setPlaceholderText(QStringLiteral("%1 × %2").arg(scene.size.width).arg(scene.size.height));
    m_near->setPlaceholderText(scene.nearDistance ? shortestText(*scene.nearDistance) : QString());
    m_far->setPlaceholderText(scene.farDistance ? shortestText(*scene.farDistance) : QString());
    showAsRead(*m_axes, axesName(scene.axes));
    showAsRead(*m_direction, directionName(scene.direction));
}

void PasteChoicesForm::chooseDirection(PoseDirection direction)
{
    m_direction->setCurrentIndex(m_direction->findData(static_cast<int>(direction)));
    emit choicesChanged();
}

QString PasteChoicesForm::fault() const
{
    for (const QLineEdit *field : {m_near, m_far}) {
        if (field->isVisibleTo(this) && isRefused(*field, numberIn(*field).has_value()))
            return tr("“%1” is not a distance: type a number greater than 0.")
                .arg(typedBeginning(field->text().trimmed()));
    }
    const bool isSizeRefused = m_size->isVisibleTo(this) && isRefused(*m_size, typedSize(m_size->text()).has_value());
    return isSizeRefused ? sizeFaultText(m_size->text().trimmed()) : QString();
}

bool PasteChoicesForm::isSizeWanted() const
{
    return m_takesSize->isEnabled() && m_takesSize->isChecked();
}

} // namespace unprojector::gui
