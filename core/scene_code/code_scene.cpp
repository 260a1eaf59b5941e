#include "core/scene_code/code_scene.h"

#include "core/files/path_text.h"
#include "core/text/identifier.h"

#include <cmath>

namespace unprojector::scene_code {
using namespace text;
namespace {

std::string whatIs(const SceneFileObject &object)
{
    const std::string model =
        object.bundled.empty() ? files::utf8FromPath(object.file) : "the bundled model " + object.bundled;
    return onOneLine('"' + object.name + "\", " + model + (object.isHidden ? ", hidden" : ""));
}

/// C++ keeps names with two underscores in a row to itself.
std::string plainName(const std::string &name)
{
    const std::string words = identifier(name);
    const std::size_t first = words.find_first_not_of('_');
    return first == std::string::npos ? "object" : words.substr(first, words.find_last_not_of('_') + 1 - first);
}

bool isReversed(const Picture &picture)
{
    const auto *matrix = std::get_if<MatrixProjection>(&picture.lens);
    if (!matrix)
        return false;
    const Result<RecognisedProjection> seen = recognised(*matrix);
    return seen && seen->reversed;
}

} // namespace

CodeScene codeScene(const SceneFile &scene)
{
    CodeScene code;
    code.picture = pictureOf(scene);
    const Picture &p = code.picture;
    code.isWholeWindow = p.viewport == wholeSurface(p.surface);
    if (const auto *lens = std::get_if<Projection>(&p.lens)) {
        const auto *perspective = std::get_if<Perspective>(lens);
        code.hasViewportsAspect = perspective && perspective->aspect == p.viewport.width / p.viewport.height;
    }
    code.isDepthZeroToOne = ndcDepthOf(p) == NdcDepth::ZeroToOne;
    code.isNearGreater = (p.depthRange.atNear > p.depthRange.atFar) != isReversed(p);
    std::vector<std::string> taken;
    for (const SceneFileObject &object : scene.objects)
        code.objects.push_back(
            {newIdentifier(plainName(object.name), taken), whatIs(object), object.transform, object.isHidden});
    code.clipPlanes = scene.clipPlanes;
    return code;
}

glm::dvec3 axisForCode(const glm::dvec3 &axis)
{
    const double length = std::hypot(axis.x, axis.y, axis.z);
    return length > 1e-3 && length < 1e6 ? axis : axis / length;
}

glm::dmat4 shearOf(const Oblique &oblique)
{
    glm::dmat4 shear(1.0);
    shear[2][0] = cotangent(oblique.thetaRadians);
    shear[2][1] = cotangent(oblique.phiRadians);
    return shear;
}

} // namespace unprojector::scene_code
