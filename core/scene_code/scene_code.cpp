#include "core/scene_code/scene_code.h"

#include "core/base/identifier.h"
#include "core/base/number_text.h"
#include "core/base/path_text.h"
#include "core/base/resource.h"
#include "core/scene_code/code_template.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace unprojector::scene_code {
using namespace geometry;
using namespace scene_file;
using namespace base;
namespace {

constexpr const char *kTemplates[] = {"glu.cpp", "glm.cpp", "qt.cpp", "three.js", "numpy.py"}; // of each CodeDialect

/// Writes a number with the fewest digits that read back to the same double.
using NumberText = std::string (*)(double value);

/// C++ and Python: 1.0, where JavaScript has 1.
std::string textWithPoint(double value)
{
    const std::string digits = shortestText(value);
    return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

/// Removes outer underscores: C++ reserves names with two underscores in a row.
std::string plainName(const std::string &name)
{
    const std::string words = identifier(name);
    const std::size_t first = words.find_first_not_of('_');
    return first == std::string::npos ? "object" : words.substr(first, words.find_last_not_of('_') + 1 - first);
}

/// A description of an object for a comment: "face", models/face.obj
std::string whatIs(const SceneFileObject &object)
{
    const std::string model =
        object.bundled.empty() ? utf8FromPath(object.file) : "the bundled model " + object.bundled;
    return onOneLine('"' + object.name + "\", " + model + (object.isHidden ? ", hidden" : ""));
}

/// glRotate's axis, scaled to length 1 if a library takes it for zero or its square leaves single
/// precision.
glm::dvec3 axisForCode(const glm::dvec3 &axis)
{
    const double length = std::hypot(axis.x, axis.y, axis.z);
    return length > 1e-3 && length < 1e6 ? axis : axis / length;
}

/// The coordinates as start + "x" and so on.
template <glm::length_t N>
Values coordinates(const glm::vec<N, double> &v, NumberText number, const std::string &start = {})
{
    Values values;
    for (glm::length_t k = 0; k < N; ++k)
        values[start + "xyzw"[k]] = number(v[k]);
    return values;
}

Rows columns(const glm::dmat4 &matrix, NumberText number)
{
    return {4, [=](std::size_t k) { return coordinates(matrix[glm::length_t(k)], number); }};
}

Values valuesOf(const TransformStep &step, NumberText number)
{
    const auto *move = std::get_if<Translate>(&step);
    const auto *turn = std::get_if<Rotate>(&step);
    Values values = coordinates(move   ? move->offset
                                : turn ? axisForCode(turn->axis)
                                       : std::get<Scale>(step).factors,
                                number);
    values["isTranslate"] = move != nullptr;
    values["isRotate"] = turn != nullptr;
    if (turn)
        values["degrees"] = number(turn->degrees);
    return values;
}

Rows rowsOf(const std::vector<SceneFileObject> &objects, NumberText number)
{
    DistinctIdentifiers given;
    std::vector<std::string> ids;
    ids.reserve(objects.size());
    for (const SceneFileObject &object : objects)
        ids.push_back(given.next(plainName(object.name)));
    return {objects.size(), [&objects, ids, number](std::size_t k) {
                const SceneFileObject &object = objects[k];
                const auto step = [&object, number](std::size_t i) { return valuesOf(object.transform[i], number); };
                return Values{{"id", ids[k]},
                              {"what", whatIs(object)},
                              {"isHidden", object.isHidden},
                              {"steps", Rows{object.transform.size(), step}},
                              {"hasManySteps", object.transform.size() > 1}};
            }};
}

/// The names that the templates use.
Values valuesOf(const SceneFile &scene, NumberText number)
{
    const Setup setup = setupOf(scene);
    const Surface &surface = setup.surface;
    const DepthRange &range = setup.depthRange;
    const auto *matrix = std::get_if<MatrixProjection>(&setup.lens);
    const auto *projection = std::get_if<Projection>(&setup.lens);
    const auto *perspective = projection ? std::get_if<Perspective>(projection) : nullptr;
    const auto *oblique = projection ? std::get_if<Oblique>(projection) : nullptr;
    const auto *look = std::get_if<LookAt>(&setup.pose);
    const Result<RecognisedProjection> form = matrix ? recognised(*matrix) : geometry::Error{};
    const bool isWhole = setup.viewport == wholeSurface(surface);
    const bool hasItsAspect = perspective && perspective->aspect.value == aspectOf(setup.viewport).value;
    const bool isNearGreater = (range.atNear > range.atFar) != (form && form->reversed);
    const bool isBox = projection ? !isPerspective(*projection) : form && !form->coefficients.perspective;

    const glm::dmat4 view = *eyeFromWorld(setup);
    const glm::dvec3 eye = glm::abs(glm::dvec3(glm::inverse(view)[3]));
    const double eyeRounding = std::max({eye.x, eye.y, eye.z}) * std::ldexp(1.0, -24); // in single precision
    const bool isTooClose = look && glm::distance(look->eye.coordinates(), look->center.coordinates()) < 1e-3;

    Values values = {
        {"windowWidth", std::to_string(surface.widthPixels)},
        {"windowHeight", std::to_string(surface.heightPixels)},
        {"pixelRatio", surface.devicePixelRatio == 1.0 ? "" : shortestText(surface.devicePixelRatio)},
        {"isWholeWindow", isWhole},
        {"isShapeFixed", isWhole && !hasItsAspect},
        {"depthAtNear", number(range.atNear)},
        {"depthAtFar", number(range.atFar)},
        {"hasDepthRange", range != DepthRange{}},
        {"isDepthRangeCut", std::min(range.atNear, range.atFar) < 0.0 || std::max(range.atNear, range.atFar) > 1.0},
        {"isDepthZeroToOne", ndcDepthOf(setup) == NdcDepth::ZeroToOne},
        {"isNearGreater", isNearGreater},
        {"clearDepth", isNearGreater ? "0" : "1"}, // every depth buffer holds these exactly, for any depth range
        {"byMatrix", matrix != nullptr},
        {"byPerspective", perspective != nullptr},
        {"byFrustum", projection && !perspective && !isBox},
        {"byOrtho", projection && isBox && !oblique},
        {"byOblique", oblique != nullptr},
        {"isBox", isBox},
        {"hasFormula", projection || form},
        {"isAspectOfViewport", hasItsAspect},
        {"isAspectOfWindow", hasItsAspect && isWhole},
        {"byLookAt", look != nullptr},
        {"isTooClose", isTooClose},
        {"isLookAtInQt", look && !isTooClose},
        {"view.rows", columns(glm::transpose(view), number)},
        {"view.columns", columns(view, number)},
        {"eyeRounding", eyeRounding > 0.0 && std::isfinite(eyeRounding) ? boundText(eyeRounding) : ""},
        {"needsUnit", look || !scene.objects.empty()},
        {"objects", rowsOf(scene.objects, number)},
        {"clipPlanes", Rows{scene.clipPlanes.size(),
                            [&scene, number](std::size_t k) {
                                Values row = coordinates(scene.clipPlanes[k], number);
                                row["index"] = std::to_string(k);
                                return row;
                            }}},
    };

    const Viewport &v = setup.viewport;
    bool isRounded = false;
    for (const auto &[name, value] : {std::pair{"x", v.x}, {"y", v.y}, {"width", v.width}, {"height", v.height}}) {
        values[std::string("viewport.") + name] = number(value);
        values[std::string("rounded.") + name] = std::to_string(std::llround(value));
        isRounded = isRounded || value != std::round(value);
    }
    values["isViewportRounded"] = isRounded;

    double skew = form ? form->coefficients.xSkew : 0.0;
    if (matrix) {
        values["projection.rows"] = columns(glm::transpose(matrix->clipFromEye), number);
        values["projection.columns"] = columns(matrix->clipFromEye, number);
    } else {
        const ProjectionWindow w = projectionWindow(*projection);
        values.merge(Values{{"left", number(w.left)},
                            {"right", number(w.right)},
                            {"bottom", number(w.bottom)},
                            {"top", number(w.top)},
                            {"near", number(w.nearDistance)},
                            {"far", number(w.farDistance)}});
        skew = w.skew;
    }
    values["skew"] = skew == 0.0 ? "" : number(skew);
    if (perspective) {
        values["fovy"] = number(perspective->verticalFov.degrees());
        values["aspect"] = number(perspective->aspect.value);
    }
    if (oblique) {
        values["cotTheta"] = number(cotangent(oblique->theta));
        values["cotPhi"] = number(cotangent(oblique->phi));
    }
    if (look) {
        values.merge(coordinates(look->eye.coordinates(), number, "eye."));
        values.merge(coordinates(look->center.coordinates(), number, "center."));
        values.merge(coordinates(look->up.coordinates(), number, "up."));
    }
    return values;
}

/// Notes the numbers that a code writes as floats but no float holds: "tooLarge" become infinite,
/// "tooSmall" 0.
void addBeyondFloat(Values &values, const std::string &code)
{
    std::string tooLarge, tooSmall;
    for (std::size_t at = 0; (at = code.find_first_of("0123456789", at)) != code.npos;) {
        const std::size_t end = std::min(code.find_first_not_of("0123456789.e+-", at), code.size());
        const std::string digits = code.substr(at, end - at);
        at = end;
        double value = 0.0;
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool isLarge = value > double(std::numeric_limits<float>::max());
        const bool isSmall = value != 0.0 && value <= 0.5 * double(std::numeric_limits<float>::denorm_min());
        if (!(isLarge || isSmall) || code[end] != 'f' || read.ptr != digits.data() + digits.size())
            continue;
        std::string &known = isLarge ? tooLarge : tooSmall;
        if ((", " + known + ',').find(", " + digits + ',') == std::string::npos)
            known += (known.empty() ? "" : ", ") + digits;
    }
    values["isBeyondFloat"] = !tooLarge.empty() || !tooSmall.empty();
    values["tooLarge"] = tooLarge;
    values["tooSmall"] = tooSmall;
}

} // namespace

std::string sceneCode(const SceneFile &scene, CodeDialect dialect)
{
    Values values = valuesOf(scene, dialect == CodeDialect::ThreeJs ? NumberText(shortestText) : textWithPoint);
    const std::string file = std::string("templates/code/") + kTemplates[std::size_t(dialect)] + ".txt";
    const auto codeAfter = [&](const std::string &code) {
        addBeyondFloat(values, code);
        return filled(resource(file), values);
    };
    const std::string code = codeAfter("");
    return dialect == CodeDialect::Qt ? codeAfter(code) : code;
}

} // namespace unprojector::scene_code
