#pragma once

#include "core/unproject/batch/kernels.h"
#include "core/unproject/unprojector.h"

#include <cstddef>
#include <variant>
#include <vector>

namespace unprojector::unproject {

/// What the loops over many points are compiled for. The digits of the results do not depend on it.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// The sets that this program was compiled for and this processor can run, Baseline first, the fastest last.
const std::vector<InstructionSet> &availableInstructionSets();

namespace batch {
/// The loops compiled for a set.
const Kernels &kernelsOf(InstructionSet set);
} // namespace batch

/// Where the results of a batch lie: in eye or world space, or in that of an object.
struct BatchSpace {
    enum class Kind { Eye, World, Object };
    Kind kind = Kind::World;
    glm::dmat4 worldFromObject{1.0}; ///< of Kind::Object, affine
};

/// The picture elements of a batch, one array a coordinate: continuous device positions (origin top-left, the centre of
/// pixel (i, j) at (i + 1/2, j + 1/2)) and the depth in the depth range.
template <class Scalar>
struct BatchInput {
    const Scalar *px, *py, *depth;
};

/// Room for as many points. No array may overlap another or an input.
template <class Scalar>
struct BatchOutput {
    Scalar *x, *y, *z;
};

/// Unprojects arrays of picture elements, prepared once for a picture. What can be computed beforehand is: a point costs
/// about thirty operations, fewer than moving it through memory does. In double, whatever the arrays hold.
class BatchUnprojection {
public:
    /// Formulas (7) to (12) and the camera's axes. With X and Y the position in pixels counted from where the view axis
    /// meets the picture, and the shares of the depth as in `DepthShares`:
    ///
    ///   p = eye + z (f + X (r - l) / (width n) s - Y (t - b) / (height n) u)    frustum, perspective
    ///   p = eye + X (r - l) / width s - Y (t - b) / height u + z (f + cot(theta) s + cot(phi) u)    box
    ///
    /// Counted from the axis nothing cancels that (9) and (10) would let cancel. Within 8 units in the last place of the
    /// largest world component for 99.99 of 100 points; the last digits may differ from a click's.
    /// A projection given as a matrix is taken by its coefficients, see `recognised`; a view, by its axes.
    /// @return the errors of check(setup), recognised and axesOff; NotFinite where a constant leaves the range of
    ///         doubles; SingularMatrix
    static geometry::Result<BatchUnprojection> byFormula(const geometry::Setup &setup, const BatchSpace &space);

    /// p = M^-1 (px, py, depth, 1) divided by its w, with M from the space to device positions; inverted once, by
    /// glm::inverse.
    /// @return the errors of check(setup); NotFinite; SingularMatrix also where the inverse overflows
    static geometry::Result<BatchUnprojection> byMatrix(const geometry::Setup &setup, const BatchSpace &space);

    /// Where the results fill megabytes they are written past the caches, which takes half to two thirds of the time.
    /// @pre the depths lie in the depth range and everything is finite; a point that is not is worthless, and so is one
    ///      whose coordinates leave the range of Scalar: infinite or NaN
    template <class Scalar>
    void operator()(const BatchInput<Scalar> &input, const BatchOutput<Scalar> &output, std::size_t count,
                    InstructionSet set = availableInstructionSets().back()) const;

    /// The points under the pixels of a row of a depth image; background costs little.
    /// @param points  room for as many as the row has pixels, x, y, z one after the other; behind those written, scratch
    /// @return how many were written
    template <class Scalar>
    std::size_t operator()(const batch::DepthRow &row, Scalar *points,
                           InstructionSet set = availableInstructionSets().back()) const;

private:
    /// Calls the loop of a table that fits, with its constants.
    template <class Loops, class Call>
    auto withLoop(const Loops &loops, const Call &call) const;

    struct Perspective : batch::ClosedFormConstants {};
    struct Box : batch::ClosedFormConstants {};
    using Kind = std::variant<Perspective, Box, batch::MatrixConstants>;

    explicit BatchUnprojection(const Kind &constants) : m_constants(constants) {}

    Kind m_constants;
};

} // namespace unprojector::unproject
