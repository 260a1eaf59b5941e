#include "gui/shell/picture_note.h"

#include "gui/document/scene_document.h"
#include "gui/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::gui {
using namespace scene;
using namespace geometry;
namespace {

/// The nearest and farthest distance of the objects from the eye, eye units.
struct Extent {
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -std::numeric_limits<double>::infinity();
};

Extent extentOf(const Box &bounds, const EyeFrame &frame)
{
    Extent extent;
    for (const double x : {bounds.lowest.x, bounds.highest.x}) {
        for (const double y : {bounds.lowest.y, bounds.highest.y}) {
            for (const double z : {bounds.lowest.z, bounds.highest.z}) {
                const double distance = -eyeFromWorld(frame, WorldPoint(x, y, z)).z;
                extent.nearest = std::min(extent.nearest, distance);
                extent.farthest = std::max(extent.farthest, distance);
            }
        }
    }
    return extent;
}

/// Returns whether the depth buffer stores this distance like the far plane's, although it is well
/// in front of it.
bool isLostInDepth(const ProjectionWindow &window, double distance)
{
    constexpr double kHalfStep = 0.5 / double(1 << 24);
    constexpr double kWellBefore = 0.9;
    const double n = window.nearDistance, f = window.farDistance;
    return distance > n && distance < kWellBefore * f && n * (f - distance) / (distance * (f - n)) < kHalfStep;
}

bool isOutside(const Viewport &viewport, const Surface &surface)
{
    return viewport.x >= surface.widthPixels || viewport.x + viewport.width <= 0.0 || viewport.y >= surface.heightPixels
           || viewport.y + viewport.height <= 0.0;
}

} // namespace

QString emptyPictureText(const SceneDocument &document)
{
    const std::vector<SceneObject> &objects = document.objects();
    if (objects.empty())
        return {};
    if (std::all_of(objects.begin(), objects.end(), [](const SceneObject &object) { return object.isHidden; }))
        return PictureNote::tr("All objects are hidden. The Objects panel shows them again.");
    const auto &[surface, viewport, range, lens, pose] = document.setup();
    if (isOutside(viewport, surface))
        return PictureNote::tr(
                   "The viewport (x %1, y %2, width %3, height %4) lies wholly outside the window, which is "
                   "%5 × %6 pixels: nothing is drawn. Change x or y, or Reset it.")
            .arg(readableText(viewport.x), readableText(viewport.y), readableText(viewport.width),
                 readableText(viewport.height))
            .arg(surface.widthPixels)
            .arg(surface.heightPixels);
    const Projection &projection = document.setup().projection();
    const ProjectionWindow window = projectionWindow(projection);
    const Result<EyeFrame> frame = eyeFrame(document.setup().camera());
    if (!frame || document.bounds().isEmpty())
        return {};
    const Extent extent = extentOf(document.bounds(), *frame);
    if (extent.farthest < window.nearDistance || extent.nearest > window.farDistance)
        return PictureNote::tr("Nothing lies between near, %1, and far, %2: the objects begin at %3 and end at %4.")
            .arg(writtenText(window.nearDistance, 4), writtenText(window.farDistance, 4),
                 writtenText(extent.nearest, 4), writtenText(extent.farthest, 4));
    if (isPerspective(projection) && isLostInDepth(window, extent.farthest))
        return PictureNote::tr("Far is %1 times near: the depth buffer is too coarse for it, and surfaces look like "
                               "background. Increase near.")
            .arg(readableText(window.farDistance / window.nearDistance));
    return {};
}

PictureNote::PictureNote(const SceneDocument &document, QWidget *parent) : QLabel(parent), m_document(document)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("Reason for the empty view"));
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setAlignment(Qt::AlignCenter);
    setMargin(fontMetrics().height() / 2);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (kVisibleChanges | Change::Preview))
            refresh();
    });
    refresh();
}

QSize PictureNote::sizeHint() const
{
    constexpr int kDigits = 44;
    const int around = 2 * (margin() + frameWidth());
    const QRect room(0, 0, kDigits * fontMetrics().horizontalAdvance(u'0'), 1 << 16);
    const QSize text = fontMetrics().boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, this->text()).size();
    return text + QSize(around + 2, around + 2);
}

void PictureNote::refresh()
{
    const QString text = emptyPictureText(m_document);
    if (text != this->text())
        setText(text);
    setVisible(!text.isEmpty());
}

} // namespace unprojector::gui
