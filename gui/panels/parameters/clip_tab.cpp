#include "gui/panels/parameters/clip_tab.h"

#include "gui/document/scene_document.h"
#include "gui/panels/parameters/elided_label.h"
#include "gui/text/number_text.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr int kEquationDigits = 3;
constexpr const char *kLetters = "ABCD";

} // namespace

std::vector<ClipPlaneLine> clipPlaneLines(const Scene &scene)
{
    std::vector<ClipPlaneLine> lines;
    for (const glm::dvec4 &plane : scene.clipPlanes)
        lines.push_back({plane, true});
    for (const ClipPlaneOff &off : scene.clipPlanesOff) {
        const std::size_t place = std::min(off.place, lines.size());
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(place), {off.plane, false});
    }
    return lines;
}

void setClipPlaneLines(Scene &scene, const std::vector<ClipPlaneLine> &lines)
{
    scene.clipPlanes.clear();
    scene.clipPlanesOff.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].isOn)
            scene.clipPlanes.push_back(lines[i].plane);
        else
            scene.clipPlanesOff.push_back({i, lines[i].plane});
    }
}

QString keptSideText(const glm::dvec4 &plane)
{
    QString text;
    for (int i = 0; i < 4; ++i) {
        if (plane[i] == 0.0)
            continue;
        const bool isNegative = plane[i] < 0.0;
        if (text.isEmpty())
            text = isNegative ? QStringLiteral("−") : QString();
        else
            text += isNegative ? QStringLiteral(" − ") : QStringLiteral(" + ");
        const double magnitude = std::abs(plane[i]);
        if (i == 3)
            text += significantText(magnitude, kEquationDigits);
        else if (magnitude == 1.0)
            text += QChar(u'x' + i);
        else
            text += significantText(magnitude, kEquationDigits) + u' ' + QChar(u'x' + i);
    }
    return text + QStringLiteral(" ≥ 0");
}

ClipTab::ClipTab(SceneDocument &document, QWidget *parent) : ParameterTab(document, Change::ClipPlanes, parent)
{
    auto *hint = new QLabel(tr("Kept is where A x + B y + C z + D ≥ 0, in world coordinates."));
    hint->setWordWrap(true);
    content()->addWidget(hint);

    m_letters = new QWidget;
    auto *letters = new QHBoxLayout(m_letters);
    letters->setContentsMargins(0, 0, 0, 0);
    letters->setSpacing(4);
    for (int i = 0; i < 4; ++i) {
        auto *letter = new QLabel(QString(QChar::fromLatin1(kLetters[i])));
        letter->setAlignment(Qt::AlignHCenter);
        letters->addWidget(letter, 1);
    }
    content()->addWidget(m_letters);

    m_list = new QVBoxLayout;
    m_list->setSpacing(8);
    content()->addLayout(m_list);

    m_add = new QPushButton(tr("Add plane"));
    m_add->setObjectName(QStringLiteral("addPlane"));
    m_add->setToolTip(tr("Add a clip plane through the middle of the objects; six at most (glClipPlane)"));
    content()->addWidget(m_add);
    content()->addStretch();
    connect(m_add, &QPushButton::clicked, this, [this] { addPlane(); });
}

void ClipTab::addPlane()
{
    Scene next = document().scene();
    std::vector<ClipPlaneLine> lines = clipPlaneLines(next);
    if (lines.size() >= kMostClipPlanes)
        return;
    // Half of what there is goes, so that the plane is seen at once. A short number, as a hand would type it.
    const Box &bounds = document().bounds();
    const double middle = bounds.isEmpty() ? 0.0 : significantText(bounds.center().x, 3).toDouble();
    lines.push_back({{1.0, 0.0, 0.0, middle == 0.0 ? 0.0 : -middle}, true});
    setClipPlaneLines(next, lines);
    if (change(next, tr("Add clip plane")) && !m_rows.empty())
        bringUp(m_rows.back().first);
}

void ClipTab::removePlane(std::size_t line)
{
    Scene next = document().scene();
    std::vector<ClipPlaneLine> lines = clipPlaneLines(next);
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line));
    setClipPlaneLines(next, lines);
    restoreFields();
    if (!change(next, tr("Remove clip plane")))
        return;
    if (m_rows.empty())
        m_add->setFocus();
    else
        m_rows[std::min(line, m_rows.size() - 1)].remove->setFocus();
}

Check ClipTab::edit(const Scene &next, const Deed &deed)
{
    return document().editClipPlanes(next.clipPlanes, next.clipPlanesOff, deed);
}

void ClipTab::showScene()
{
    const std::vector<ClipPlaneLine> lines = clipPlaneLines(document().scene());
    while (m_rows.size() > lines.size()) {
        m_list->removeWidget(m_rows.back().widget);
        removeFieldsIn(m_rows.back().widget);
        m_rows.pop_back();
    }
    while (m_rows.size() < lines.size()) {
        m_rows.push_back(makeRow(m_rows.size()));
        m_list->addWidget(m_rows.back().widget);
        m_rows.back().widget->show();
        setTabOrder(m_rows.back().last, m_add); // as it is on the screen
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        m_rows[i].isOn->setChecked(lines[i].isOn);
        m_rows[i].equation->setFullText(keptSideText(lines[i].plane));
    }
    m_letters->setVisible(!lines.empty());
    m_add->setEnabled(lines.size() < kMostClipPlanes);
}

ClipTab::Row ClipTab::makeRow(std::size_t line)
{
    const int number = static_cast<int>(line) + 1;
    Row row{};
    row.widget = new QWidget;
    row.widget->setObjectName(QStringLiteral("plane%1").arg(number));
    row.isOn = new QCheckBox(tr("%1:").arg(number));
    row.isOn->setObjectName(QStringLiteral("isOn"));
    row.isOn->setAccessibleName(tr("Plane %1 cuts").arg(number));
    row.isOn->setToolTip(tr("Whether this plane cuts the objects (glEnable, glDisable)"));
    row.equation = new ElidedLabel;
    row.equation->setAccessibleName(tr("Side of plane %1 that is kept").arg(number));
    row.remove = new QToolButton;
    row.remove->setObjectName(QStringLiteral("remove"));
    row.remove->setText(QStringLiteral("✕"));
    row.remove->setAutoRaise(true);
    row.remove->setFocusPolicy(Qt::StrongFocus);
    row.remove->setAccessibleName(tr("Remove plane %1").arg(number));
    row.remove->setToolTip(tr("Remove this plane"));
    connect(row.remove, &QToolButton::clicked, this, [this, line] { removePlane(line); });
    connect(row.isOn, &QCheckBox::clicked, this, [this, line](bool isOn) {
        Scene next = document().scene();
        std::vector<ClipPlaneLine> lines = clipPlaneLines(next);
        lines[line].isOn = isOn;
        setClipPlaneLines(next, lines);
        change(next, isOn ? tr("Clip plane on") : tr("Clip plane off"));
    });

    auto *top = new QHBoxLayout;
    top->setSpacing(2);
    top->addWidget(row.isOn);
    top->addWidget(row.equation, 1);
    top->addWidget(row.remove);
    auto *numbers = new QHBoxLayout;
    numbers->setSpacing(4);
    for (int i = 0; i < 4; ++i) {
        const QString letter(QChar::fromLatin1(kLetters[i]));
        NumberField *field = addField(
            {tr("Clip plane %1").arg(letter),
             i < 3
                 ? tr("%1 of the plane A x + B y + C z + D = 0; (A, B, C) points to the side that is kept").arg(letter)
                 : tr("D of the plane A x + B y + C z + D = 0, world units where (A, B, C) has length 1"),
             [line, i](const Scene &scene) -> std::optional<double> {
                 const std::vector<ClipPlaneLine> lines = clipPlaneLines(scene);
                 return line < lines.size() ? std::optional<double>(lines[line].plane[i]) : std::nullopt;
             },
             [line, i](Scene &scene, double value) {
                 std::vector<ClipPlaneLine> lines = clipPlaneLines(scene);
                 lines[line].plane[i] = value;
                 setClipPlaneLines(scene, lines);
             }});
        field->setObjectName(QStringLiteral("number%1").arg(i));
        field->setAccessibleName(tr("Plane %1: %2").arg(number).arg(letter));
        field->setFixedStep(0.1);
        numbers->addWidget(field, 1);
        (i == 0 ? row.first : row.last) = field;
    }

    auto *layout = new QVBoxLayout(row.widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(top);
    layout->addLayout(numbers);
    return row;
}

} // namespace unprojector::gui
