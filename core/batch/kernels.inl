// Included by one file for each instruction set, with UNPROJECTOR_KERNELS naming the table to define. Everything is in an
// unnamed namespace and nothing else is included: code compiled for a new processor must not be what the linker takes
// for the same function elsewhere.

#include "core/batch/kernels.h"

namespace unprojector::batch {
namespace {

// No array overlaps another: told by the parameters, since GCC does not take it from local variables.
#define UNPROJECTOR_ARRAYS                                                                                             \
    const Scalar *__restrict px, const Scalar *__restrict py, const Scalar *__restrict depth, Scalar *__restrict x,    \
        Scalar *__restrict y, Scalar *__restrict z

template <class Scalar>
void perspective(const ClosedFormConstants &constants, UNPROJECTOR_ARRAYS, std::size_t count)
{
    const ClosedFormConstants c = constants;
    for (std::size_t i = 0; i < count; ++i) {
        const double d = depth[i];
        const double distance = c.nearTerm / ((c.depthAtFar - d) + (d - c.depthAtNear) * c.farTerm);
        const double across = ((px[i] - c.axisX) - c.axisXRest) * distance;
        const double down = ((py[i] - c.axisY) - c.axisYRest) * distance;
        x[i] = static_cast<Scalar>(c.origin[0] + ((c.across[0] * across + c.down[0] * down) + c.ahead[0] * distance));
        y[i] = static_cast<Scalar>(c.origin[1] + ((c.across[1] * across + c.down[1] * down) + c.ahead[1] * distance));
        z[i] = static_cast<Scalar>(c.origin[2] + ((c.across[2] * across + c.down[2] * down) + c.ahead[2] * distance));
    }
}

template <class Scalar>
void box(const ClosedFormConstants &constants, UNPROJECTOR_ARRAYS, std::size_t count)
{
    const ClosedFormConstants c = constants;
    for (std::size_t i = 0; i < count; ++i) {
        const double d = depth[i];
        const double distance = (c.depthAtFar - d) * c.nearTerm + (d - c.depthAtNear) * c.farTerm;
        const double across = (px[i] - c.axisX) - c.axisXRest;
        const double down = (py[i] - c.axisY) - c.axisYRest;
        x[i] = static_cast<Scalar>(c.origin[0] + ((c.across[0] * across + c.down[0] * down) + c.ahead[0] * distance));
        y[i] = static_cast<Scalar>(c.origin[1] + ((c.across[1] * across + c.down[1] * down) + c.ahead[1] * distance));
        z[i] = static_cast<Scalar>(c.origin[2] + ((c.across[2] * across + c.down[2] * down) + c.ahead[2] * distance));
    }
}

template <class Scalar>
void matrix(const MatrixConstants &constants, UNPROJECTOR_ARRAYS, std::size_t count)
{
    const MatrixConstants m = constants;
    for (std::size_t i = 0; i < count; ++i) {
        const double u = px[i], v = py[i], d = depth[i];
        const double w = (m.rows[3][0] * u + m.rows[3][1] * v) + (m.rows[3][2] * d + m.rows[3][3]);
        const double reciprocal = 1.0 / w;
        x[i] = static_cast<Scalar>(((m.rows[0][0] * u + m.rows[0][1] * v) + (m.rows[0][2] * d + m.rows[0][3])) * reciprocal);
        y[i] = static_cast<Scalar>(((m.rows[1][0] * u + m.rows[1][1] * v) + (m.rows[1][2] * d + m.rows[1][3])) * reciprocal);
        z[i] = static_cast<Scalar>(((m.rows[2][0] * u + m.rows[2][1] * v) + (m.rows[2][2] * d + m.rows[2][3])) * reciprocal);
    }
}

} // namespace

const Kernels UNPROJECTOR_KERNELS{{perspective<double>, box<double>, matrix<double>},
                                  {perspective<float>, box<float>, matrix<float>}};

} // namespace unprojector::batch
