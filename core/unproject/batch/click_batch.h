#pragma once

#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/object_from_world.h"
#include "core/unproject/unprojector.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace unprojector::unproject {

/// Unprojects rows of picture elements to exactly the digits of a click there, so that a table and
/// the window show the same. Prepared once for a setup.
///
/// The formulas are computed with about 30 digits, many points at a time. If that does not
/// determine the rounding of the sum (once in a billion points, and if a coordinate is 0), the
/// click's own functions are called. A point costs two to three times a BatchUnprojection's, which
/// is little beside its text. Single precision, and by a matrix the conversion to an object's space,
/// are computed as in a click, one point after the other.
class ClickBatch {
public:
    /// @return the errors of check(setup), of ObjectFromWorld::of, and of
    ///         BatchUnprojection::byFormula or, for the matrix, byMatrix
    static geometry::Result<ClickBatch> of(Method method, const geometry::Setup &setup, const BatchSpace &space);

    /// Unprojects `count` elements. A point that a click could not compute is not finite.
    void operator()(const BatchInput<double> &input, const BatchOutput<double> &output, std::size_t count,
                    InstructionSet set = availableInstructionSets().back()) const;

private:
    /// Unprojects elements as operator() does, but to world space where an object's is computed from it.
    using Loop =
        std::function<void(const BatchInput<double> &, const BatchOutput<double> &, std::size_t count, InstructionSet)>;

    explicit ClickBatch(Loop loop) : m_loop(std::move(loop)) {}
    static geometry::Result<ClickBatch> byFormula(const Unprojector &unprojector, BatchSpace::Kind space,
                                                  const std::optional<ObjectFromWorld> &object);
    static geometry::Result<ClickBatch> byMatrix(const geometry::Setup &setup, BatchSpace::Kind space);

    Loop m_loop;
    std::optional<ObjectFromWorld> m_object; ///< for points in world space that belong in an object's
};

} // namespace unprojector::unproject
