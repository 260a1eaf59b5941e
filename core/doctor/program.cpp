#include "core/doctor/program.h"

#include "core/cameras/lens.h"
#include "core/geometry/finite.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::doctor {
using namespace geometry;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Sets what a projection's matrix alone does not contain.
void readLens(Given &given, const Lens &lens)
{
    if (const auto *projection = std::get_if<Projection>(&lens)) {
        const ProjectionWindow window = projectionWindow(*projection);
        given.isPerspective = geometry::isPerspective(*projection);
        given.isFrustum = std::holds_alternative<Frustum>(*projection);
        given.nearDistance = window.nearDistance;
        given.farDistance = window.farDistance;
        return;
    }
    given.isPerspective = given.clipFromEye[2][3] != 0.0;
    given.nearDistance = given.farDistance = kUnknown;
    const Result<RecognisedProjection> form = recognised(std::get<MatrixProjection>(lens));
    if (!form)
        return;
    given.isReversed = form->reversed;
    given.side = form->looksAlongPlusZ ? 1.0 : -1.0;
    std::visit(
        [&](const auto &parameters) {
            const ProjectionWindow window = projectionWindow(Projection(parameters));
            given.nearDistance = window.nearDistance;
            given.farDistance = form->infiniteFar ? kInfinity : window.farDistance;
        },
        form->parameters);
}

glm::dmat4 combined(const Run &run)
{
    const glm::dmat4 eyeFromSpace = run.eyeFromWorld * run.click.worldFromObject;
    switch (run.order) {
    case Run::Order::InverseOfProduct: break;
    case Run::Order::InverseOfTransposed: return glm::inverse(glm::transpose(run.clipFromEye * eyeFromSpace));
    case Run::Order::InversesInTheOrderOfTheFactors: return glm::inverse(run.clipFromEye) * glm::inverse(eyeFromSpace);
    case Run::Order::NotInverted: return run.clipFromEye * eyeFromSpace;
    }
    return glm::inverse(run.clipFromEye * eyeFromSpace);
}

glm::dvec4 product(const glm::dmat4 &m, glm::dvec4 v, bool isInPlace)
{
    if (!isInPlace)
        return m * v;
    for (int row = 0; row < 4; ++row)
        v[row] = m[0][row] * v.x + m[1][row] * v.y + m[2][row] * v.z + m[3][row] * v.w;
    return v;
}

/// Applies the mistakes in the order of the stages.
class Mistakes {
public:
    Mistakes(Run &run, std::span<const Variant *const> mistakes) : m_run(run), m_mistakes(mistakes) {}

    bool has(Stage stage) const
    {
        return std::any_of(m_mistakes.begin(), m_mistakes.end(),
                           [stage](const Variant *mistake) { return mistake->stage == stage; });
    }
    void make(Stage stage)
    {
        for (const Variant *mistake : m_mistakes) {
            if (mistake->stage != stage)
                continue;
            m_run.parameter = mistake->parameter;
            m_run.second = mistake->second;
            m_run.matrix = &mistake->matrix;
            mistake->apply(m_run);
        }
    }

private:
    Run &m_run;
    std::span<const Variant *const> m_mistakes;
};

/// Applies the mistakes of closed formulas to the eye point. The matrices then get the input that
/// leads there.
void throughEye(Run &run, Mistakes &mistakes)
{
    run.eye = transformed(mistakes.has(Stage::Lens) ? glm::inverse(run.clipFromEye) : run.given.eyeFromClip, run.ndc);
    mistakes.make(Stage::Eye);
    run.ndc = transformed(run.clipFromEye, run.eye);
}

} // namespace

Result<Given> Given::of(const Setup &setup, const cameras::Distortion &distortion)
{
    if (const Check valid = check(setup); !valid)
        return valid.error();
    const Result<glm::dmat4> projection = geometry::clipFromEye(setup), view = geometry::eyeFromWorld(setup);
    if (!projection)
        return projection.error();
    if (!view)
        return view.error();
    Given given;
    given.surface = setup.surface;
    given.viewport = setup.viewport;
    given.depthRange = setup.depthRange;
    given.ndcDepth = ndcDepthOf(setup);
    given.clipFromEye = *projection;
    given.eyeFromWorld = *view;
    given.eyeFromClip = glm::inverse(*projection);
    given.worldFromClip = glm::inverse(*projection * (*view * glm::dmat4(1.0))); // as combined()
    readLens(given, setup.lens);
    if (given.isPerspective)
        given.distortion = distortion;
    const glm::dmat4 worldFromEye = glm::inverse(*view);
    given.eyePosition = glm::dvec3(worldFromEye[3]) / worldFromEye[3].w;
    if (!checkFinite(given.eyeFromClip) || !checkFinite(worldFromEye))
        return Error{ErrorCode::SingularMatrix};
    return given;
}

void Run::setDistance(double distance)
{
    if (given.isPerspective)
        eye *= distance / this->distance();
    else
        eye.z = given.side * distance;
}

std::optional<Run> ran(const Given &given, const Click &click, std::span<const Variant *const> list, bool isClosedForm)
{
    std::optional<Run> kept(std::in_place, given, click);
    Run &run = *kept;
    run.isClosedForm = isClosedForm;
    Mistakes mistakes(run, list);

    run.position = click.pixel.coordinates();
    run.flipHeight = given.surface.heightPixels;
    run.viewport = given.viewport;
    mistakes.make(Stage::Pixel);
    run.window = {run.position.x, run.isFlipped ? run.flipHeight - run.position.y : run.position.y};
    mistakes.make(Stage::Window);

    run.depth = given.unitDepth(click.depth);
    mistakes.make(Stage::Depth);

    run.nearDistance = given.nearDistance;
    run.farDistance = given.farDistance;
    run.clipFromEye = given.clipFromEye;
    // A program that answers in eye space uses no view matrix.
    run.eyeFromWorld = click.space == PointSpace::Eye ? glm::dmat4(1.0) : given.eyeFromWorld;
    mistakes.make(Stage::Lens);
    run.ndc = glm::dvec3(ndcXy(run.viewport, run.window), given.ndcZ(run.depth));
    if (mistakes.has(Stage::Eye) || run.isClosedForm)
        throughEye(run, mistakes);

    mistakes.make(Stage::Factors);
    mistakes.make(Stage::Product);
    mistakes.make(Stage::Divide);
    if (run.isClosedForm) {
        run.point = glm::dvec3(glm::inverse(run.eyeFromWorld * click.worldFromObject) * glm::dvec4(run.eye, 1.0));
    } else {
        // Most mistakes are not of the matrices, and an inverse takes as long as all the rest.
        const bool areMatricesRight = click.space == PointSpace::World && !mistakes.has(Stage::Lens)
                                      && !mistakes.has(Stage::Factors) && !mistakes.has(Stage::Product);
        run.spaceFromClip = areMatricesRight ? given.worldFromClip : combined(run);
        const glm::dvec4 undivided = product(run.spaceFromClip, glm::dvec4(run.ndc, 1.0), run.isInPlace);
        run.point = glm::dvec3(undivided);
        for (int i = 0; i < run.divisions; ++i)
            run.point /= undivided.w;
    }
    mistakes.make(Stage::Point);
    if (run.isLost || !isFinite(run.point))
        return std::nullopt;
    return kept;
}

std::optional<glm::dvec3> answer(const Given &given, const Click &click, std::span<const Variant *const> list,
                                 bool isClosedForm)
{
    const auto run = ran(given, click, list, isClosedForm);
    return run ? std::optional(run->point) : std::nullopt;
}

glm::dvec3 transformed(const glm::dmat4 &m, const glm::dvec3 &point)
{
    const glm::dvec4 result = m * glm::dvec4(point, 1.0);
    return glm::dvec3(result) / result.w;
}

glm::dvec2 ndcXy(const Viewport &viewport, const glm::dvec2 &window)
{
    return {2.0 * (window.x - viewport.x) / viewport.width - 1.0,
            2.0 * (window.y - viewport.y) / viewport.height - 1.0};
}

double greatestOf(const glm::dvec3 &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

glm::dmat4 worldFromSpace(const Given &given, const Click &click)
{
    return click.space == PointSpace::Eye ? glm::inverse(given.eyeFromWorld) : click.worldFromObject;
}

cameras::Intrinsics intrinsicsOf(const Given &given)
{
    const glm::dmat4 &m = given.clipFromEye;
    const Viewport &v = given.viewport;
    const double w = given.side * m[2][3]; // of a point at distance 1
    const glm::dvec2 middle = given.side * glm::dvec2(m[2]) / w;
    cameras::Intrinsics k;
    k.fx = m[0][0] / w * v.width / 2.0;
    k.fy = m[1][1] / w * v.height / 2.0;
    k.skew = -m[1][0] / w * v.width / 2.0;
    k.cx = v.x + (middle.x + 1.0) / 2.0 * v.width;
    k.cy = flippedY(given.surface, v.y + (middle.y + 1.0) / 2.0 * v.height);
    k.centres = cameras::PixelCentres::AtHalves;
    return k;
}

glm::dvec2 distorted(const Given &given, const glm::dvec2 &position)
{
    return given.distortion.isNone() ? position
                                     : cameras::distortedPixel(given.distortion, intrinsicsOf(given), position);
}

void setPixel(const Given &given, Click &click, const DevicePoint &inImage)
{
    const glm::dvec2 at = inImage.coordinates();
    const auto straight =
        given.distortion.isNone() ? at : cameras::undistortedPixel(given.distortion, intrinsicsOf(given), at);
    if (straight)
        click.pixel = DevicePoint(straight->x, straight->y);
    else
        click.pixel = inImage;
    click.distortedBy = at - click.pixel.coordinates();
    setRightEye(given, click);
}

void setRightEye(const Given &given, Click &click)
{
    const glm::dvec2 window(click.pixel.x, flippedY(given.surface, click.pixel.y));
    const glm::dvec3 ndc(ndcXy(given.viewport, window), given.ndcZ(given.unitDepth(click.depth)));
    click.eye = transformed(given.eyeFromClip, ndc);
}

std::optional<glm::dvec3> projected(const Given &given, const Click &click, const glm::dvec3 &point)
{
    glm::dmat4 clipFromSpace = given.clipFromEye;
    if (click.space != PointSpace::Eye)
        clipFromSpace = clipFromSpace * given.eyeFromWorld * click.worldFromObject;
    const glm::dvec3 ndc = transformed(clipFromSpace, point);
    if (!isFinite(ndc))
        return std::nullopt;
    const WindowPoint window = windowFromNdc(given.viewport, given.depthRange, NdcPoint(ndc), given.ndcDepth);
    return glm::dvec3(window.x, flippedY(given.surface, window.y), window.z);
}

} // namespace unprojector::doctor
