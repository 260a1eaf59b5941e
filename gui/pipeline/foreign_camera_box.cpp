#include "gui/pipeline/foreign_camera_box.h"

#include "gui/document/view_limits.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/refused_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;

namespace {

constexpr std::array kDirections{PoseDirection::WorldToCamera, PoseDirection::CameraToWorld};

QString axesName(EyeAxes axes)
{
    switch (axes) {
    case EyeAxes::RightUpBack: return ForeignCameraBox::tr("OpenGL: right, up, back");
    case EyeAxes::RightDownAhead: return ForeignCameraBox::tr("OpenCV: right, down, ahead");
    case EyeAxes::RightUpAhead: return ForeignCameraBox::tr("Direct3D: right, up, ahead");
    case EyeAxes::AheadRightUp: return ForeignCameraBox::tr("Unreal: ahead, right, up");
    case EyeAxes::AheadLeftUp: break;
    }
    return ForeignCameraBox::tr("ROS: ahead, left, up");
}

QString directionName(PoseDirection direction)
{
    return direction == PoseDirection::WorldToCamera ? ForeignCameraBox::tr("World to camera")
                                                     : ForeignCameraBox::tr("Camera to world");
}

QString centresName(PixelCentres centres)
{
    return centres == PixelCentres::AtIntegers ? ForeignCameraBox::tr("At 0, 0") : ForeignCameraBox::tr("At 0.5, 0.5");
}

QString sizeText(const ImageSize &size)
{
    return QStringLiteral("%1 × %2").arg(size.width).arg(size.height);
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

/// A sentence about a camera with the names of fields instead of the command's options.
QString withFieldNames(QString sentence)
{
    const std::array<std::pair<const char *, QString>, 12> names{{
        {"--pixel-centers half", ForeignCameraBox::tr("“Pixel centres”")},
        {"--pixel-centers integer", ForeignCameraBox::tr("“Pixel centres”")},
        {"--pixel-centers", ForeignCameraBox::tr("“Pixel centres”")},
        {"--image NAME", ForeignCameraBox::tr("“Image”")},
        {"--image", ForeignCameraBox::tr("“Image”")},
        {"--size", ForeignCameraBox::tr("“Image size”")},
        {"--near", ForeignCameraBox::tr("“Near”")},
        {"--far", ForeignCameraBox::tr("“Far”")},
        {"--axes", ForeignCameraBox::tr("“Axes”")},
        {"--pose", ForeignCameraBox::tr("“Pose”")},
        {"--objects", ForeignCameraBox::tr("“File > Add to Scene”")},
        {"--undistorted", ForeignCameraBox::tr("“My pixels are of the undistorted image”")},
    }};
    for (const auto &[option, name] : names)
        sentence.replace(QLatin1String(option), name);
    const auto replaceWord = [&sentence](const char *word, const QString &shown) {
        const QRegularExpression whole(QStringLiteral("(?<![\\w.-])%1(?![\\w.-])").arg(QLatin1String(word)));
        sentence.replace(whole, ForeignCameraBox::tr("“%1”", "the item of a field").arg(shown));
    };
    for (const PoseDirection direction : kDirections)
        replaceWord(keyOf(direction), directionName(direction));
    for (const EyeAxes axes : kEyeAxes)
        replaceWord(keyOf(axes), axesName(axes));
    return sentence;
}

/// The combo box of a choice; its first item is what was read.
template <class Value>
QComboBox *choiceOf(const QString &name, const QString &help, std::span<const Value> values, QString (*text)(Value))
{
    auto *box = new QComboBox;
    box->setAccessibleName(name);
    box->setToolTip(help);
    box->addItem({});
    for (const Value value : values)
        box->addItem(text(value), static_cast<int>(value));
    return box;
}

template <class Value>
std::optional<Value> chosenIn(const QComboBox &box)
{
    return box.currentIndex() > 0 ? std::optional(static_cast<Value>(box.currentData().toInt())) : std::nullopt;
}

} // namespace

ForeignCameraBox::ForeignCameraBox(QWidget *parent)
    : QWidget(parent), m_form(new QFormLayout), m_title(new QLabel), m_said(new QLabel)
{
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_said->setWordWrap(true);
    m_said->setTextFormat(Qt::PlainText);
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_said->setAccessibleName(tr("What was assumed"));
    createFields();
    m_form->setContentsMargins(0, 0, 0, 0);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addLayout(m_form);
    layout->addWidget(m_said);
    layout->addStretch();
}

void ForeignCameraBox::createFields()
{
    static constexpr std::array kCentres{PixelCentres::AtIntegers, PixelCentres::AtHalves};
    m_image = new QComboBox;
    m_image->setAccessibleName(tr("Image"));
    m_image->setToolTip(tr("The image or frame whose camera is read"));
    m_image->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_image->setMinimumContentsLength(20);
    const auto field = [this](const QString &name, const QString &help) {
        auto *made = new QLineEdit;
        made->setAccessibleName(name);
        made->setToolTip(help);
        connect(made, &QLineEdit::textEdited, this, &ForeignCameraBox::choicesChanged);
        return made;
    };
    m_size = field(tr("Image size"), tr("Width and height of the camera's image, pixels: 640 x 480"));
    m_takesSize = new QCheckBox(tr("Give the view this size"));
    m_takesSize->setChecked(true);
    m_takesSize->setToolTip(tr("Pixels of the view are then the camera's pixels; View > Fit the Window undoes it"));
    m_near = field(tr("Near"), tr("Distance of the near plane: it maps depths, and hides what is closer"));
    m_far = field(tr("Far"), tr("Distance of the far plane: it maps depths, and hides what is farther"));
    m_axes = choiceOf<EyeAxes>(tr("Axes of the camera"), tr("The directions of the camera's x, y and z in its image"),
                               kEyeAxes, axesName);
    m_direction = choiceOf<PoseDirection>(tr("Pose"), tr("What the pose turns into what: its direction"), kDirections,
                                          directionName);
    m_centres = choiceOf<PixelCentres>(
        tr("Pixel centres"), tr("The coordinates of the first pixel's centre in the program"), kCentres, centresName);
    m_isUndistorted = new QCheckBox(tr("My pixels are of the undistorted image"));
    m_isUndistorted->setToolTip(tr("Drop the distortion coefficients: the view has no distortion"));
    m_form->addRow(tr("&Image:"), m_image);
    m_form->addRow(tr("Image &size:"), m_size);
    m_form->addRow({}, m_takesSize);
    m_form->addRow(tr("&Near:"), m_near);
    m_form->addRow(tr("Fa&r:"), m_far);
    m_form->addRow(tr("&Axes:"), m_axes);
    m_form->addRow(tr("P&ose:"), m_direction);
    m_form->addRow(tr("Pixel &centres:"), m_centres);
    m_form->addRow(m_isUndistorted);
    for (QComboBox *box : {m_image, m_axes, m_direction, m_centres})
        connect(box, &QComboBox::activated, this, &ForeignCameraBox::choicesChanged);
    for (QCheckBox *box : {m_takesSize, m_isUndistorted})
        connect(box, &QCheckBox::toggled, this, &ForeignCameraBox::choicesChanged);
}

CameraChoices ForeignCameraBox::choices() const
{
    CameraChoices choices;
    if (m_image->count() > 1)
        choices.image = m_image->currentText().toStdString();
    if (const auto size = typedSize(m_size->text()))
        choices.size = ImageSize{size->widthPixels, size->heightPixels};
    choices.nearDistance = numberIn(*m_near);
    choices.farDistance = numberIn(*m_far);
    choices.axes = chosenIn<EyeAxes>(*m_axes);
    choices.direction = chosenIn<PoseDirection>(*m_direction);
    choices.centres = chosenIn<PixelCentres>(*m_centres);
    choices.isUndistorted = m_isUndistorted->isChecked();
    return choices;
}

void ForeignCameraBox::dropChoices()
{
    const QSignalBlocker blocker(this);
    m_image->clear();
    for (QLineEdit *field : {m_size, m_near, m_far})
        field->clear();
    for (QComboBox *box : {m_axes, m_direction, m_centres})
        box->setCurrentIndex(0);
    m_takesSize->setChecked(true);
    m_isUndistorted->setChecked(false);
}

void ForeignCameraBox::read(std::span<const NamedText> texts, const std::optional<Box> &objects)
{
    m_camera.reset();
    m_isRead = false;
    auto read = readCamera(texts, choices());
    std::size_t hash = 0;
    for (const NamedText &text : texts)
        hash = 31 * hash + std::hash<std::string>()(text.text);
    const bool areOthers = std::exchange(m_textsHash, hash) != hash;
    const QString before = m_program;
    if (read && *read)
        m_program = QString::fromStdString((*read)->program);
    // A choice that makes the texts readable is of this camera.
    if (areOthers && m_program != before) {
        dropChoices();
        read = readCamera(texts, choices());
    } else if (read && !*read && m_image->count() > 0) {
        m_image->clear(); // the image may be of other texts
        read = readCamera(texts, choices());
    }
    if (!read)
        return;
    if (!*read) {
        m_camera = read->error();
        showFault();
        return;
    }
    m_isRead = true;
    m_camera = sceneCamera(**read, choices(), objects);
    showRead(**read);
    if (!*m_camera)
        showFault();
}

void ForeignCameraBox::showRead(const ForeignCamera &camera)
{
    m_title->setText(tr("Camera of %1").arg(m_program));
    QStringList images;
    for (const std::string &name : camera.images)
        images << QString::fromStdString(name);
    QStringList shown;
    for (int i = 0; i < m_image->count(); ++i)
        shown << m_image->itemText(i);
    if (shown != images) {
        m_image->clear();
        m_image->addItems(images);
        m_image->setCurrentIndex(static_cast<int>(camera.image));
    }
    m_form->setRowVisible(m_image, images.size() > 1);
    m_form->setRowVisible(m_direction, camera.pose.has_value());
    m_form->setRowVisible(m_axes, camera.pose.has_value());
    m_form->setRowVisible(m_centres, hasCentres(camera));
    m_form->setRowVisible(m_isUndistorted, camera.distortion && !camera.distortion->isNone());
    for (QLineEdit *field : {m_near, m_far})
        field->setEnabled(camera.intrinsics.has_value());
    for (QComboBox *box : {m_axes, m_direction, m_centres})
        box->setEnabled(true);
    if (camera.intrinsics)
        m_centres->setItemText(0, tr("As read: %1").arg(centresName(camera.intrinsics->centres)));
    if (!*m_camera)
        return;
    const SceneCamera &scene = **m_camera;
    const bool canTakeSize = std::max(scene.size.width, scene.size.height) <= kMostViewPixels;
    m_takesSize->setEnabled(canTakeSize);
    m_size->setPlaceholderText(sizeText(scene.size));
    m_near->setPlaceholderText(scene.nearDistance ? shortestText(*scene.nearDistance) : QString());
    m_far->setPlaceholderText(scene.farDistance ? shortestText(*scene.farDistance) : QString());
    if (m_axes->currentIndex() <= 0)
        m_axes->setItemText(0, tr("As read: %1").arg(axesName(scene.axes)));
    if (m_direction->currentIndex() <= 0)
        m_direction->setItemText(0, tr("As read: %1").arg(directionName(scene.direction)));
    QStringList said;
    for (const std::string &sentence : scene.assumed)
        said << withFieldNames(QString::fromStdString(sentence));
    if (!canTakeSize)
        said << tr("The image is larger than %1 pixels: the view keeps its own size.").arg(kMostViewPixels);
    setRefused(*m_size, isRefused(*m_size, typedSize(m_size->text()).has_value()));
    for (QLineEdit *field : {m_near, m_far})
        setRefused(*field, isRefused(*field, numberIn(*field).has_value()));
    m_said->setText(said.join(u'\n'));
}

void ForeignCameraBox::showFault()
{
    const base::Error &error = m_camera->error();
    QString place = QString::fromStdString(error.file);
    if (error.line > 0)
        place = place.isEmpty() ? tr("line %1").arg(error.line) : tr("%1, line %2").arg(place).arg(error.line);
    const QString reason = withFieldNames(ended(base::Error{error.text, error.subject}.message()));
    m_fault = place.isEmpty() ? reason : tr("%1: %2", "a place in a text, what is wrong").arg(place, reason);
    m_said->clear();
    if (m_isRead)
        return;
    // The texts are not read: only these choices can make them readable.
    if (m_title->text().isEmpty())
        m_title->setText(tr("Camera"));
    for (QWidget *field : std::initializer_list<QWidget *>{m_near, m_far, m_axes, m_direction, m_centres, m_takesSize})
        field->setEnabled(false);
    for (QLineEdit *field : {m_size, m_near, m_far})
        field->setPlaceholderText({});
}

QString ForeignCameraBox::fault() const
{
    if (!m_camera)
        return {};
    if (!*m_camera)
        return m_fault;
    for (const QLineEdit *field : {m_near, m_far}) {
        if (isRefused(*field, numberIn(*field).has_value()))
            return tr("“%1” is not a distance: type a number greater than 0.")
                .arg(typedBeginning(field->text().trimmed()));
    }
    if (isRefused(*m_size, typedSize(m_size->text()).has_value()))
        return sizeFaultText(m_size->text().trimmed());
    if (!(*m_camera)->distortion)
        return {};
    const Distortion &d = *(*m_camera)->distortion;
    return tr("The camera has distortion (k1 %1, k2 %2, p1 %3, p2 %4, k3 %5), which the view cannot draw. If your "
              "pixels are of the undistorted image, tick the box. Else undo the distortion: unproject points "
              "--distortion.")
        .arg(shortestText(d.k1), shortestText(d.k2), shortestText(d.p1), shortestText(d.p2), shortestText(d.k3));
}

bool ForeignCameraBox::isSizeWanted() const
{
    return m_takesSize->isEnabled() && m_takesSize->isChecked();
}

} // namespace unprojector::gui
