#include "gui/parameters/clip_group.h"

#include "gui/document/scene_document.h"
#include "gui/parameters/group_heading.h"
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
using namespace geometry;
using namespace scene;

namespace {

constexpr int kEquationDigits = 3;
constexpr const char *kLetters = "ABCD";

/// One line of the group: an active or switched-off plane of the scene.
struct Line {
    glm::dvec4 plane{0.0};
    bool isOn = true;
    base::JsonValue extra = {}; ///< as in ClipPlaneOff
};
using Lines = std::vector<Line>;

/// All planes of a scene in display order.
Lines linesOf(const Scene &scene)
{
    Lines lines;
    for (const glm::dvec4 &plane : scene.clipPlanes)
        lines.push_back({plane, true});
    for (const ClipPlaneOff &off : scene.clipPlanesOff) {
        const std::size_t index = std::min(off.index, lines.size());
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(index), {off.plane, false, off.extra});
    }
    return lines;
}

template <class Edit>
void editLines(Scene &scene, const Edit &edit)
{
    Lines lines = linesOf(scene);
    edit(lines);
    scene.clipPlanes.clear();
    scene.clipPlanesOff.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].isOn)
            scene.clipPlanes.push_back(lines[i].plane);
        else
            scene.clipPlanesOff.push_back({i, lines[i].plane, lines[i].extra});
    }
}

/// The kept side of a plane, its numbers with at most three digits: "x + 0.5 y − 2 ≥ 0".
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
            text += writtenText(magnitude, kEquationDigits);
        else if (magnitude == 1.0)
            text += QChar(u'x' + i);
        else
            text += writtenText(magnitude, kEquationDigits) + u' ' + QChar(u'x' + i);
    }
    return text + QStringLiteral(" ≥ 0");
}

} // namespace

ClipGroup::ClipGroup(SceneDocument &document, QWidget *parent)
    : ParameterGroup(document, Change::ClipPlanes,
                     {tr("Clip planes"), tr("Planes that cut the objects (glClipPlane)"), tr("No clip planes")}, parent)
{
    heading().setHelp(QStringLiteral("clip-planes"));
    content()->addWidget(
        wrappedLabel(tr("The plane keeps points with A x + B y + C z + D ≥ 0, in world coordinates.")));
    m_list = new QVBoxLayout;
    m_list->setSpacing(2 * content()->spacing());
    content()->addLayout(m_list);

    m_add = new QPushButton(tr("Add plane"));
    m_add->setObjectName(QStringLiteral("addPlane"));
    m_add->setToolTip(tr("Add a clip plane through the middle of the objects; six at most (glClipPlane)"));
    content()->addWidget(m_add);
    onClick(m_add, [this](bool byKeyboard) { addPlane(byKeyboard); });
}

void ClipGroup::addPlane(bool byKeyboard)
{
    if (linesOf(document().scene()).size() >= kMostClipPlanes)
        return;
    // The plane cuts half of the scene, so that it is visible at once. A short number, as a user
    // would type it.
    const Box &bounds = document().bounds();
    const double middle = bounds.isEmpty() ? 0.0 : significantText(bounds.center().x, 3).toDouble();
    const auto add = [&](Lines &lines) { lines.push_back({{1.0, 0.0, 0.0, middle == 0.0 ? 0.0 : -middle}, true}); };
    if (change(tr("Add clip plane"), [&](Scene &scene) { editLines(scene, add); }) && !m_rows.empty())
        bringUp(m_rows.back().first, byKeyboard);
}

void ClipGroup::removePlane(std::size_t line, bool byKeyboard)
{
    const auto erase = [&](Lines &lines) { lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line)); };
    restoreFields();
    if (!change(tr("Remove clip plane"), [&](Scene &scene) { editLines(scene, erase); }) || !byKeyboard)
        return;
    if (m_rows.empty())
        m_add->setFocus();
    else
        m_rows[std::min(line, m_rows.size() - 1)].remove->setFocus();
}

void ClipGroup::setDefaults(Scene &scene) const
{
    editLines(scene, [](Lines &lines) { lines.clear(); });
}

void ClipGroup::showScene()
{
    const Lines lines = linesOf(document().scene());
    const std::size_t rowsBefore = m_rows.size();
    while (m_rows.size() > lines.size()) {
        m_list->removeWidget(m_rows.back().widget);
        removeFieldsIn(m_rows.back().widget);
        m_rows.pop_back();
    }
    while (m_rows.size() < lines.size()) {
        m_rows.push_back(makeRow(m_rows.size()));
        m_list->addWidget(m_rows.back().widget);
        m_rows.back().widget->show();
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        m_rows[i].isOn->setChecked(lines[i].isOn);
        m_rows[i].equation->setText(keptSideText(lines[i].plane));
    }
    m_add->setEnabled(lines.size() < kMostClipPlanes);
    if (m_rows.size() != rowsBefore)
        emit rowsChanged();
}

ClipGroup::Row ClipGroup::makeRow(std::size_t line)
{
    const int number = static_cast<int>(line) + 1;
    Row row{};
    row.widget = new QWidget;
    row.widget->setObjectName(QStringLiteral("plane%1").arg(number));
    row.isOn = new QCheckBox(tr("%1:").arg(number));
    row.isOn->setObjectName(QStringLiteral("isOn"));
    row.isOn->setAccessibleName(tr("Plane %1 cuts").arg(number));
    row.isOn->setToolTip(tr("Switch this plane on or off (glEnable, glDisable)"));
    row.equation = wrappedLabel();
    row.equation->setAccessibleName(tr("Side of plane %1 that is kept").arg(number));
    row.remove = new QToolButton;
    row.remove->setObjectName(QStringLiteral("remove"));
    row.remove->setText(QStringLiteral("✕"));
    row.remove->setAutoRaise(true);
    row.remove->setAccessibleName(tr("Remove plane %1").arg(number));
    row.remove->setToolTip(tr("Remove this plane"));
    onClick(row.remove, [this, line](bool byKeyboard) { removePlane(line, byKeyboard); });
    connect(row.isOn, &QCheckBox::clicked, this, [this, line](bool isOn) {
        change(isOn ? tr("Clip plane on") : tr("Clip plane off"),
               [&](Scene &scene) { editLines(scene, [&](Lines &lines) { lines[line].isOn = isOn; }); });
    });

    auto *top = new QHBoxLayout;
    top->setSpacing(2);
    top->addWidget(row.isOn);
    top->addWidget(row.equation, 1);
    top->addWidget(row.remove);
    auto *layout = new QVBoxLayout(row.widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(content()->spacing());
    layout->addLayout(top);
    ParameterRow *normal = addRow(layout, tr("Normal"));
    ParameterRow *offset = addRow(layout, tr("Offset"));
    for (int i = 0; i < 4; ++i) {
        const QString letter(QChar::fromLatin1(kLetters[i]));
        NumberField *field = addField(
            i < 3 ? normal : offset, letter, i < 3 ? ofAnyLength() : worldUnits(),
            {tr("Clip plane %1").arg(letter),
             i < 3
                 ? tr("%1 of the plane A x + B y + C z + D = 0; (A, B, C) points to the side that is kept").arg(letter)
                 : tr("D of the plane A x + B y + C z + D = 0, world units where (A, B, C) has length 1"),
             [line, i](const Scene &scene) -> std::optional<double> {
                 const Lines lines = linesOf(scene);
                 return line < lines.size() ? std::optional<double>(lines[line].plane[i]) : std::nullopt;
             },
             [line, i](Scene &scene, double value) {
                 editLines(scene, [&](Lines &lines) { lines[line].plane[i] = value; });
             }});
        field->setObjectName(QStringLiteral("number%1").arg(i));
        field->setAccessibleName(tr("Plane %1: %2").arg(number).arg(letter));
        field->setFixedStep(0.1);
        if (i == 0)
            row.first = field;
    }
    return row;
}

} // namespace unprojector::gui
