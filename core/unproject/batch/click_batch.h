#pragma once

#include "core/unproject/batch/batch_unproject.h"
#include "core/unproject/unprojector.h"

#include <variant>

namespace unprojector::unproject {

/// Unprojects rows of picture elements to the digits that a click there has, to the last one: what a table says and what
/// the window says are the same. Prepared once for a picture.
///
/// The formulas are computed with about 30 digits, many points at a time; where that does not tell how the sum is to be
/// rounded (once in a billion points, and where a coordinate is 0), the click's own functions are asked. A point costs
/// five to ten times that of a BatchUnprojection, which is still little beside its text. In an object's space, where no click
/// is told, it is a BatchUnprojection.
class ClickBatch {
public:
    /// preciseEyePoint and worldFromEye.
    /// @return the errors of BatchUnprojection::byFormula
    static Result<ClickBatch> byFormula(const Picture &geometry, const BatchSpace &space);

    /// unprojectByInverse, the inverse computed once.
    /// @return the errors of BatchUnprojection::byMatrix; SingularMatrix
    static Result<ClickBatch> byMatrix(const Picture &geometry, const BatchSpace &space);

    /// A point that a click could not compute is not finite.
    void operator()(const BatchInput<double> &input, const BatchOutput<double> &output, std::size_t count,
                    InstructionSet set = availableInstructionSets().back()) const;

private:
    struct Formula {
        Unprojector unprojector;
        BatchSpace::Kind space;
        bool isPerspective;
        batch::PreciseConstants constants;

        Result<glm::dvec3> exactly(const WindowPoint &window) const;
    };
    using Kind = std::variant<Formula, batch::ClickMatrixConstants, BatchUnprojection>;

    explicit ClickBatch(const Kind &method) : m_method(method) {}

    Kind m_method;
};

} // namespace unprojector::unproject
