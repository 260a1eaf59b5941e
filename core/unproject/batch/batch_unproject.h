#pragma once

#include "core/unproject/batch/kernels.h"
#include "core/unproject/batch/line_constants.h"
#include "core/unproject/unprojector.h"

#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

namespace unprojector::unproject {

/// The instruction sets that the loops over many points are compiled for. The digits of the results
/// do not depend on it.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// The sets that this program was compiled for and this processor can run, Baseline first, the
/// fastest last.
const std::vector<InstructionSet> &availableInstructionSets();

namespace batch {
/// The loops compiled for a set.
const Kernels &kernelsOf(InstructionSet set);
template <class Scalar>
const LoopsOf<Scalar> &loopsOf(InstructionSet set)
{
    if constexpr (std::is_same_v<Scalar, double>)
        return kernelsOf(set).ofDoubles;
    else
        return kernelsOf(set).ofFloats;
}
} // namespace batch

/// The picture elements of a batch, one array a coordinate. px, py: continuous device positions
/// (origin top-left, the centre of pixel (i, j) at (i + 1/2, j + 1/2)). depth: in the depth range.
template <class Scalar>
struct BatchInput {
    const Scalar *px, *py, *depth;
};

/// The output arrays, of the same length. No array may overlap another or an input.
template <class Scalar>
struct BatchOutput {
    Scalar *x, *y, *z;
};

/// Unprojects arrays of picture elements, prepared once for a setup. Constants are precomputed: a
/// point costs about thirty operations, less than its memory traffic. Computes in double for every
/// array type.
class BatchUnprojection {
public:
    /// Formulas (7) to (12) and the camera's axes. X and Y are the position in pixels relative to
    /// the view axis, and the shares of the depth are as in `DepthShares`:
    ///
    ///   p = eye + z (f + X (r - l) / (width n) s - Y (t - b) / (height n) u)  frustum, perspective
    ///   p = eye + X (r - l) / width s - Y (t - b) / height u
    ///           + z (f + cot(theta) s + cot(phi) u)                           box
    ///
    /// Relative to the axis, the terms of (9) and (10) that would cancel do not occur. Within 8
    /// units in the last place of the largest world component for 99.99 of 100 points; the last
    /// digits may differ from a click's. A projection given as a matrix is used by its
    /// coefficients, see `recognised`; a view, by its axes.
    /// @return the errors of check(setup), recognised and axesOff; NotFinite if a constant leaves
    ///         the range of doubles; SingularMatrix
    static geometry::Result<BatchUnprojection> byFormula(const geometry::Setup &setup, const BatchSpace &space);

    /// p = M^-1 (px, py, depth, 1) divided by its w, with M from the space to device positions;
    /// inverted once, by glm::inverse.
    /// @return the errors of check(setup); NotFinite; SingularMatrix also if the inverse overflows
    static geometry::Result<BatchUnprojection> byMatrix(const geometry::Setup &setup, const BatchSpace &space);

    /// Unprojects `count` elements. Results of several megabytes are written past the caches, which
    /// takes half to two thirds of the time.
    /// @pre the depths lie in the depth range and everything is finite. A point that violates this
    ///         is meaningless, and so is one whose coordinates leave the range of Scalar: infinite
    ///         or NaN
    template <class Scalar>
    void operator()(const BatchInput<Scalar> &input, const BatchOutput<Scalar> &output, std::size_t count,
                    InstructionSet set = availableInstructionSets().back()) const;

    /// The points under the pixels of a row of a depth image; background costs little.
    /// @param points  room for as many as the row has pixels, x, y, z one after the other; the rest
    ///         after the results is scratch
    /// @return the number of points written
    template <class Scalar>
    std::size_t operator()(const batch::DepthRow &row, Scalar *points,
                           InstructionSet set = availableInstructionSets().back()) const;

    /// The points under the pixels of a row with window depths, one a pixel.
    /// @param points  x, y, z of each pixel; that of a NaN is NaN
    /// @tparam Line  batch::DepthLine or batch::FloatLine
    template <class Line, class Scalar>
    void line(const Line &line, Scalar *points, InstructionSet set = availableInstructionSets().back()) const;

private:
    using Constants = std::variant<LineConstants, batch::MatrixConstants>;

    explicit BatchUnprojection(const Constants &constants) : m_constants(constants) {}
    /// Calls the method's loops with its constants.
    template <class Scalar, class Call>
    auto withLoops(InstructionSet set, const Call &call) const;

    Constants m_constants;
};

} // namespace unprojector::unproject
