#include "gui/shell/status_readout.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/text/number_text.h"
#include "gui/widgets/digits_font.h"
#include "gui/window/window.h"

#include <QLabel>
#include <QStatusBar>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

StatusReadout::StatusReadout(Window &window)
    : QObject(&window), m_window(window), m_pointed(new QLabel), m_preparing(new QLabel), m_projection(new QLabel)
{
    m_pointed->setAccessibleName(tr("World coordinate under the pointer"));
    m_pointed->setToolTip(tr("World coordinate under the pointer, without digits smaller than the uncertainty"));
    // An empty label has another height than one with text, and would change the view's size.
    m_pointed->setMinimumHeight(
        std::max(m_pointed->sizeHint().height(), lineHeight(m_pointed->font(), tr("background, %1"))));
    m_projection->setAccessibleName(tr("Projection"));
    m_projection->setToolTip(tr("Projection and distances of the near and far planes, world units"));
    m_preparing->setAccessibleName(tr("Preparing the exact hit"));
    m_preparing->setToolTip(
        tr("Clicks already use the depth buffer; the ray follows when the model is prepared for it"));
    m_preparing->hide();
    window.statusBar()->addWidget(m_pointed, 1);
    window.statusBar()->addPermanentWidget(m_preparing);
    window.statusBar()->addPermanentWidget(m_projection);

    SceneDocument &document = window.document();
    connect(&window, &Window::pointed, this, [this](const std::optional<PixelClick> &click) {
        m_pointed->setText(click ? pointedText(*click) : QString());
    });
    connect(&window, &Window::coordinatesHidden, this, [this](bool areHidden) {
        m_areHidden = areHidden;
        m_pointed->clear(); // until the pointer moves
    });
    connect(&document.picks().rayCasters(), &RayCasters::progressed, this, &StatusReadout::showPreparing);
    connect(&document.picks().rayCasters(), &RayCasters::finished, this, [this] {
        m_sincePreparing.invalidate();
        m_preparing->hide();
    });
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Setup)
            showProjection();
    });
    showProjection();
}

void StatusReadout::showPreparing(double share)
{
    constexpr qint64 kUnnoticedMilliseconds = 500;
    if (!m_sincePreparing.isValid())
        m_sincePreparing.start();
    m_preparing->setText(tr("Preparing the exact hit: %1 %").arg(static_cast<int>(100.0 * share)));
    m_preparing->setVisible(m_sincePreparing.hasExpired(kUnnoticedMilliseconds));
}

QString StatusReadout::pointedText(const PixelClick &click) const
{
    const Result<Pick> pick = m_window.document().picks().unprojected(click);
    if (!pick || (pick->hit() && !pick->point.world[Method::Formula]))
        return {};
    const QString pixel = tr("pixel (%1, %2)").arg(click.pixel.i).arg(click.pixel.j);
    if (!pick->hit())
        return tr("background, %1").arg(pixel);
    if (m_areHidden)
        return pixel;
    // All to the same place: the least certain coordinate's.
    const WorldVector &open = pick->withinPixel.world;
    const double most = std::max({open.x, open.y, open.z});
    return tr("world %1, %2").arg(pointText(*pick->point.world[Method::Formula], WorldVector(most, most, most)), pixel);
}

void StatusReadout::showProjection()
{
    const Projection &projection = m_window.document().setup().projection();
    const ProjectionWindow w = projectionWindow(projection);
    const QString kind = isPerspective(projection)                       ? tr("Perspective")
                         : kindOf(projection) == ProjectionKind::Oblique ? tr("Oblique")
                                                                         : tr("Orthographic");
    m_projection->setText(
        tr("%1, near %2, far %3").arg(kind, writtenText(w.nearDistance, 4), writtenText(w.farDistance, 4)));
}

} // namespace unprojector::gui
