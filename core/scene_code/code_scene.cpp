#include "core/scene_code/code_scene.h"

#include "core/base/identifier.h"
#include "core/base/path_text.h"

#include <cmath>
#include <vector>

namespace unprojector::scene_code {
using namespace geometry;
using namespace scene_file;
using namespace base;
namespace {

/// Removes outer underscores: C++ reserves names with two underscores in a row.
std::string plainName(const std::string &name)
{
    const std::string words = identifier(name);
    const std::size_t first = words.find_first_not_of('_');
    return first == std::string::npos ? "object" : words.substr(first, words.find_last_not_of('_') + 1 - first);
}

} // namespace

bool isWholeWindow(const Setup &setup)
{
    return setup.viewport == wholeSurface(setup.surface);
}

bool hasViewportsAspect(const Setup &setup)
{
    const auto *lens = std::get_if<Projection>(&setup.lens);
    const auto *perspective = lens ? std::get_if<Perspective>(lens) : nullptr;
    return perspective && perspective->aspect.value == aspectOf(setup.viewport).value;
}

bool isDepthZeroToOne(const Setup &setup)
{
    return ndcDepthOf(setup) == NdcDepth::ZeroToOne;
}

bool isNearGreater(const Setup &setup)
{
    const auto *matrix = std::get_if<MatrixProjection>(&setup.lens);
    const Result<RecognisedProjection> form = matrix ? recognised(*matrix) : Error{};
    return (setup.depthRange.atNear > setup.depthRange.atFar) != (form && form->reversed);
}

double clearDepth(const Setup &setup)
{
    return isNearGreater(setup) ? 0.0 : 1.0;
}

std::string ofEachObject(const SceneFile &scene, ObjectCode &code)
{
    DistinctIdentifiers ids;
    std::string text;
    for (const SceneFileObject &object : scene.objects)
        text += code(object, ids.next(plainName(object.name)));
    return text;
}

std::string whatIs(const SceneFileObject &object)
{
    const std::string model =
        object.bundled.empty() ? base::utf8FromPath(object.file) : "the bundled model " + object.bundled;
    return onOneLine('"' + object.name + "\", " + model + (object.isHidden ? ", hidden" : ""));
}

glm::dvec3 axisForCode(const glm::dvec3 &axis)
{
    const double length = std::hypot(axis.x, axis.y, axis.z);
    return length > 1e-3 && length < 1e6 ? axis : axis / length;
}

glm::dmat4 shearOf(const Oblique &oblique)
{
    glm::dmat4 shear(1.0);
    shear[2][0] = cotangent(oblique.theta);
    shear[2][1] = cotangent(oblique.phi);
    return shear;
}

glm::dmat4 shearOf(const Frustum &frustum)
{
    glm::dmat4 shear(1.0);
    shear[1][0] = frustum.skew;
    return shear;
}

} // namespace unprojector::scene_code
