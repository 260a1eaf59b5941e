#include "core/unproject_comparison.h"

#include "core/unproject_closed_form.h"
#include "core/unproject_matrix_inverse.h"

#include <algorithm>
#include <cmath>

namespace unprojector {
namespace {

template <class Space, class Scalar>
Result<Point<Space>> byInverse(const Result<glm::dmat4> &clipFromSpace, const ViewGeometry &g, const WindowPoint &window)
{
    if (!clipFromSpace)
        return clipFromSpace.error();
    return unprojectByInverse<Space, Scalar>(*clipFromSpace, g.viewport, g.depthRange, window);
}

Result<WorldPoint> worldByFormula(const Result<EyePoint> &eye, const LookAt &camera)
{
    if (!eye)
        return eye.error();
    const Result<EyeFrame> frame = eyeFrame(camera);
    if (!frame)
        return frame.error();
    return worldFromEye(*frame, *eye);
}

} // namespace

Comparison compareUnprojections(const ViewGeometry &g, const WindowPoint &window)
{
    const Result<EyePoint> eyeByFormula = unprojectClosedForm(g.projection, g.viewport, g.depthRange, window);
    const Result<glm::dmat4> clipFromEyeMatrix = clipFromEye(g.projection);
    const Result<glm::dmat4> clipFromWorldMatrix = clipFromWorld(g);
    return {
        {eyeByFormula, byInverse<EyeSpace, double>(clipFromEyeMatrix, g, window),
         byInverse<EyeSpace, float>(clipFromEyeMatrix, g, window)},
        {worldByFormula(eyeByFormula, g.camera), byInverse<WorldSpace, double>(clipFromWorldMatrix, g, window),
         byInverse<WorldSpace, float>(clipFromWorldMatrix, g, window)},
    };
}

double ulpOfLargest(const glm::dvec3 &point)
{
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

} // namespace unprojector
