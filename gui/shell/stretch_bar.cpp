#include "gui/shell/stretch_bar.h"

#include "core/geometry/proportions.h"
#include "core/scene/given_matrices.h"
#include "gui/document/scene_document.h"
#include "gui/shell/overlay_bars.h"
#include "gui/text/proportion_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

double projectionAspect(const Setup &setup)
{
    const ProjectionWindow w = projectionWindow(setup.projection());
    return std::abs((w.right - w.left) / (w.top - w.bottom));
}

double viewportAspect(const Setup &setup)
{
    return setup.viewport.width / setup.viewport.height;
}

/// Returns whether the view has the size that came with another program's camera. Its pixels need not be
/// square.
bool hasCamerasSize(const SceneDocument &document)
{
    const Scene &scene = document.scene();
    return givenLens(scene) && scene.windowSize && scene.viewport.kind == ViewportRule::Kind::WholeWindow
           && *scene.windowSize == document.setup().surface;
}

} // namespace

bool isPictureStretched(const SceneDocument &document)
{
    const Setup &setup = document.setup();
    if (hasCamerasSize(document))
        return false;
    if (document.objects().empty() || !isDistorted(circleAspect(setup)))
        return false;
    // No rectangle of whole pixels is closer in a small window.
    const ViewportRule fitting{ViewportRule::Kind::KeepAspect, {}, projectionAspect(setup)};
    return !check(fitting) || viewportIn(fitting, setup.surface) != setup.viewport;
}

void letterbox(SceneDocument &document)
{
    const double aspect = projectionAspect(document.setup());
    static_cast<void>(document.edit({StretchBar::tr("Letterbox")}, [aspect](Scene &scene) {
        scene.viewport.kind = ViewportRule::Kind::KeepAspect;
        scene.viewport.aspect = aspect;
    }));
}

StretchBar::StretchBar(SceneDocument &document, QWidget *parent)
    : QFrame(parent), m_document(document), m_text(new QLabel)
{
    makeOverlay(*this, "#f4f6f8", "#a9b3bd");
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_text->setAccessibleName(tr("Stretched view"));
    auto *fit = new QPushButton(tr("Letterbox"));
    fit->setToolTip(tr("Give the viewport the aspect of the projection, with bars beside or above it"));
    auto *close = new QToolButton;
    close->setText(QStringLiteral("×"));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::StrongFocus);
    close->setToolTip(tr("Keep the view stretched and close this message"));
    close->setAccessibleName(close->toolTip());
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    layout->addWidget(m_text, 1);
    layout->addWidget(fit);
    layout->addWidget(close);
    connect(fit, &QPushButton::clicked, this, [this] { letterbox(m_document); });
    connect(close, &QToolButton::clicked, this, [this] {
        m_isClosed = true;
        hide();
    });
    connect(&document, &SceneDocument::opened, this, [this] { m_isClosed = false; });
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::Setup | Change::Objects | Change::Preview))
            refresh();
    });
    refresh();
}

void StretchBar::setInLesson(bool isInLesson)
{
    m_isInLesson = isInLesson;
    refresh();
}

void StretchBar::refresh()
{
    const bool isStretched = isPictureStretched(m_document);
    m_isClosed = m_isClosed && isStretched;
    if (isStretched) {
        const Setup &setup = m_document.setup();
        const auto [projection, viewport] = aspectTexts(projectionAspect(setup), viewportAspect(setup));
        //: Two aspects, width to height, such as 4 : 3 and 1.11 : 1.
        m_text->setText(tr("Projection %1, viewport %2: the view is stretched.").arg(projection, viewport));
    }
    setVisible(isStretched && !m_isClosed && !m_isInLesson);
}

} // namespace unprojector::gui
