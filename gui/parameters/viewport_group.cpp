#include "gui/parameters/viewport_group.h"

#include "core/geometry/drawable.h"
#include "gui/document/scene_document.h"
#include "gui/parameters/group_heading.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/wheel.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

/// Core's reason why OpenGL doesn't take a number; each field itself checks that it is finite.
QString refusalText(const Check &check)
{
    return check || check.error().code == ErrorCode::NotFinite ? QString() : errorText(check.error());
}

QString pixelRefusal(double value)
{
    return refusalText(checkViewportNumber(value));
}

QString depthRefusal(double value)
{
    return refusalText(checkDepthRangeEnd(value));
}

} // namespace

ViewportGroup::ViewportGroup(SceneDocument &document, QWidget *parent)
    : ParameterGroup(
        document, Change::Setup,
        {tr("Viewport and depth"), tr("glViewport and glDepthRange"), tr("The whole window, depths from 0 to 1")},
        parent)
{
    heading().setHelp(QStringLiteral("viewport"));
    m_kind = new QComboBox;
    m_kind->setObjectName(QStringLiteral("viewportKind"));
    m_kind->setAccessibleName(tr("Part of the window"));
    m_kind->setToolTip(tr("Part of the window that the viewport covers (glViewport)"));
    const auto add = [this](const QString &text, ViewportRule::Kind kind, const QString &tip) {
        m_kind->addItem(text, static_cast<int>(kind));
        m_kind->setItemData(m_kind->count() - 1, tip, Qt::ToolTipRole);
    };
    add(tr("Whole window"), ViewportRule::Kind::WholeWindow, tr("glViewport(0, 0, width, height)"));
    add(tr("Fixed rectangle"), ViewportRule::Kind::Fixed, tr("The same pixels for every size of the window"));
    add(tr("Keep aspect (letterbox)"), ViewportRule::Kind::KeepAspect,
        tr("The largest rectangle of this aspect, centred, with bars beside or above it"));
    add(tr("Lower right quarter"), ViewportRule::Kind::Quarter, tr("glViewport(width/2, 0, width/2, height/2)"));
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    ignoreWheelWithoutFocus(m_kind);
    content()->addWidget(m_kind);

    addRectangleRow(tr("X"), QStringLiteral("viewportX"),
                    tr("Left edge, whole device pixels from the left edge of the window (glViewport: x)"),
                    &Viewport::x);
    addRectangleRow(tr("Y"), QStringLiteral("viewportY"),
                    tr("Lower edge, whole device pixels from the lower edge of the window (glViewport: y)"),
                    &Viewport::y);
    addRectangleRow(tr("Width"), QStringLiteral("viewportWidth"),
                    tr("Width in whole device pixels, above 0 (glViewport: width)"), &Viewport::width);
    addRectangleRow(tr("Height"), QStringLiteral("viewportHeight"),
                    tr("Height in whole device pixels, above 0 (glViewport: height)"), &Viewport::height);
    m_aspect = addRow(content(), tr("Aspect"));
    NumberField *aspect = addField(m_aspect, {}, ratio(),
                                   {tr("Viewport aspect"), tr("Width divided by height of the rectangle, above 0"),
                                    [](const Scene &scene) -> std::optional<double> {
                                        if (scene.viewport.kind != ViewportRule::Kind::KeepAspect)
                                            return std::nullopt;
                                        return scene.viewport.aspect;
                                    },
                                    [](Scene &scene, double value) { scene.viewport.aspect = value; }});
    aspect->setObjectName(QStringLiteral("viewportAspect"));

    m_call = selectable(tr("Viewport in use"));
    m_call->setToolTip(tr("The viewport in use: x, y, width, height in device pixels from the lower left corner"));
    m_window = selectable(tr("Size of the window"));
    m_window->setToolTip(tr("Size of the window in device pixels"));
    m_window->setTextFormat(Qt::RichText);
    m_window->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(m_window, &QLabel::linkActivated, this, &ViewportGroup::sizeRequested);
    content()->addWidget(m_call);
    content()->addWidget(m_window);

    auto *depths = new QLabel(tr("Depth range"));
    QFont bold = depths->font();
    bold.setBold(true);
    depths->setFont(bold);
    content()->addWidget(depths);
    const auto addDepth = [this](const QString &label, const QString &name, const QString &objectName,
                                 const QString &help, double DepthRange::*number) {
        NumberField *field = addField(
            addRow(content(), label), {}, depth(),
            {name, help, [number](const Scene &scene) -> std::optional<double> { return scene.depthRange.*number; },
             [number](Scene &scene, double value) { scene.depthRange.*number = value; }, depthRefusal});
        field->setObjectName(objectName);
        field->setFixedStep(0.01);
    };
    addDepth(tr("Near plane"), tr("Depth of the near plane"), QStringLiteral("depthAtNear"),
             tr("Depth of the near plane, from 0 to 1; usually 0 (glDepthRange)"), &DepthRange::atNear);
    addDepth(tr("Far plane"), tr("Depth of the far plane"), QStringLiteral("depthAtFar"),
             tr("Depth of the far plane, from 0 to 1; usually 1 (glDepthRange)"), &DepthRange::atFar);
    m_depthCall = selectable(tr("Depth range in use"));
    m_depthCall->setToolTip(tr("The depth range in use: OpenGL takes its ends in single precision"));
    content()->addWidget(m_depthCall);

    connect(m_kind, &QComboBox::activated, this,
            [this](int index) { choose(static_cast<ViewportRule::Kind>(m_kind->itemData(index).toInt())); });
}

QLabel *ViewportGroup::selectable(const QString &name)
{
    QLabel *label = wrappedLabel();
    label->setAccessibleName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

void ViewportGroup::addRectangleRow(const QString &name, const QString &objectName, const QString &help,
                                    double Viewport::*number)
{
    ParameterRow *row = addRow(content(), name);
    NumberField *field =
        addField(row, {}, devicePixels(),
                 {tr("Viewport %1").arg(name.toLower()), help,
                  [number](const Scene &scene) -> std::optional<double> {
                      if (scene.viewport.kind != ViewportRule::Kind::Fixed)
                          return std::nullopt;
                      return scene.viewport.fixed.*number;
                  },
                  [number](Scene &scene, double value) { scene.viewport.fixed.*number = value; }, pixelRefusal});
    field->setObjectName(objectName);
    field->setFixedStep(1.0);
    m_rectangle.push_back(row);
}

void ViewportGroup::choose(ViewportRule::Kind kind)
{
    if (document().scene().viewport.kind == kind)
        return;
    restoreFields();
    change(m_kind->currentText(), [&](Scene &scene) {
        scene.viewport.kind = kind;
        if (kind == ViewportRule::Kind::Fixed)
            scene.viewport.fixed = document().setup().viewport; // the setup stays; its numbers become editable
    });
}

void ViewportGroup::setDefaults(Scene &scene) const
{
    scene.viewport = {};
    scene.depthRange = {};
}

void ViewportGroup::showScene()
{
    const Setup &setup = document().setup();
    const bool isFixed = document().scene().windowSize.has_value();
    if (setup.surface != m_shownSurface || isFixed != m_isFixed) {
        m_shownSurface = setup.surface;
        m_isFixed = isFixed;
        const QString size = isFixed ? tr("Window: %1 × %2 pixels, fixed") : tr("Window: %1 × %2 pixels");
        m_window->setText(
            QStringLiteral("%1 <a href=\"size\">%2</a>")
                .arg(size.arg(m_shownSurface.widthPixels).arg(m_shownSurface.heightPixels), tr("Change…")));
    }
    if (setup.viewport != m_shownViewport) {
        m_shownViewport = setup.viewport;
        const Viewport &v = m_shownViewport;
        m_call->setText(
            QStringLiteral("glViewport(%1, %2, %3, %4)")
                .arg(writtenText(v.x, 9), writtenText(v.y, 9), writtenText(v.width, 9), writtenText(v.height, 9)));
    }
    m_depthCall->setText(QStringLiteral("glDepthRangef(%1, %2)")
                             .arg(writtenText(setup.depthRange.atNear, 9), writtenText(setup.depthRange.atFar, 9)));
    const ViewportRule::Kind kind = document().scene().viewport.kind;
    if (kind == m_shownKind)
        return;
    m_shownKind = kind;
    restoreFields();
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(kind)));
    for (ParameterRow *row : m_rectangle)
        row->setVisible(kind == ViewportRule::Kind::Fixed);
    m_aspect->setVisible(kind == ViewportRule::Kind::KeepAspect);
}

} // namespace unprojector::gui
