#pragma once

#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/object_from_world.h"
#include "core/unproject/unprojector.h"

#include <optional>
#include <variant>

namespace unprojector::unproject {

/// Unprojects rows of picture elements to the digits that a click there has, to the last one: what a table says and what
/// the window says are the same. Prepared once for a picture.
///
/// The formulas are computed with about 30 digits, many points at a time; where that does not tell how the sum is to be
/// rounded (once in a billion points, and where a coordinate is 0), the click's own functions are asked. A point costs
/// five to ten times that of a BatchUnprojection, which is still little beside its text. Single precision, and the way from
/// the world into an object's space, are computed as a click does it, one point after the other.
class ClickBatch {
public:
    /// @return the errors of check(setup), of ObjectFromWorld::of, and those of BatchUnprojection::byFormula or, for the
    ///         matrix, byMatrix
    static geometry::Result<ClickBatch> of(Method method, const geometry::Setup &setup, const BatchSpace &space);

    /// A point that a click could not compute is not finite.
    void operator()(const BatchInput<double> &input, const BatchOutput<double> &output, std::size_t count,
                    InstructionSet set = availableInstructionSets().back()) const;

private:
    struct Formula {
        Unprojector unprojector;
        BatchSpace::Kind space;
        bool isPerspective;
        batch::PreciseConstants constants;
    };
    /// A method that has no loop of its own.
    struct OneByOne {
        Unprojector unprojector;
        BatchSpace::Kind space;
        Method method;
    };
    using Loop = std::variant<Formula, batch::ClickMatrixConstants, OneByOne>;

    explicit ClickBatch(const Loop &loop) : m_loop(loop) {}

    static geometry::Result<ClickBatch> byFormula(const Unprojector &unprojector, BatchSpace::Kind space);
    static geometry::Result<ClickBatch> byMatrix(const geometry::Setup &setup, BatchSpace::Kind space);

    void run(const Formula &formula, const BatchInput<double> &input, const BatchOutput<double> &output,
             std::size_t count, InstructionSet set) const;
    void run(const batch::ClickMatrixConstants &matrix, const BatchInput<double> &input,
             const BatchOutput<double> &output, std::size_t count, InstructionSet set) const;
    void run(const OneByOne &click, const BatchInput<double> &input, const BatchOutput<double> &output,
             std::size_t count, InstructionSet set) const;

    Loop m_loop;
    std::optional<ObjectFromWorld> m_object; ///< to go on from world space
};

} // namespace unprojector::unproject
