#include "gui/document/since_click_text.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"

#include <QCoreApplication>

namespace unprojector::gui {
using namespace unproject;
using namespace geometry;
using namespace pipeline;
namespace {

struct SinceClickTexts {
    Q_DECLARE_TR_FUNCTIONS(SinceClickTexts)
};

QString inWords(Outside where)
{
    switch (where) {
    case Outside::Left: return SinceClickTexts::tr("x < −w: left of the view volume");
    case Outside::Right: return SinceClickTexts::tr("x > w: right of the view volume");
    case Outside::Bottom: return SinceClickTexts::tr("y < −w: below the view volume");
    case Outside::Top: return SinceClickTexts::tr("y > w: above the view volume");
    case Outside::Near: return SinceClickTexts::tr("z < −w: before the near plane");
    case Outside::Far: return SinceClickTexts::tr("z > w: behind the far plane");
    case Outside::InEyePlane: return SinceClickTexts::tr("w = 0: in the plane of the eye");
    case Outside::BehindEye: return SinceClickTexts::tr("w < 0: behind the eye");
    }
    Q_UNREACHABLE();
}

} // namespace

QString clipTestText(const ClipPoint &point)
{
    QStringList failed;
    for (const Outside where : clipTest(point))
        failed << inWords(where);
    return failed.join(QStringLiteral(", "));
}

QString sinceClickText(const SceneDocument &document)
{
    const std::optional<Pick> &pick = document.picks().pick();
    if (!pick)
        return {};
    const SinceClick since = document.picks().sinceClick();
    if (since.isObjectHidden)
        return SinceClickTexts::tr("The object of this click is hidden now.");
    if (since.isObjectMoved)
        return SinceClickTexts::tr("The object was moved since this click; the point is where its surface was.");
    if (since.isCutAway)
        return SinceClickTexts::tr("A clip plane cuts the point of this click away now.");
    if (!since.isOtherSetup)
        return {};
    const Result<WorldPoint> &world = pick->point.world[Method::Formula];
    const Result<glm::dmat4> matrix = clipFromWorld(document.setup());
    if (pick->hit() && world && matrix) {
        const ClipPoint clip(*matrix * glm::dvec4(world->coordinates(), 1.0));
        if (const QString outside = clipTestText(clip); !outside.isEmpty())
            return SinceClickTexts::tr("The view has changed since this click. The point is outside it now: %1.")
                .arg(outside);
    }
    return SinceClickTexts::tr("The view has changed since this click; all numbers are those of the click.");
}

} // namespace unprojector::gui
