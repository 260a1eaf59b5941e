#include "core/unproject/batch/batch_unproject.h"

#include "core/unproject/batch/line_constants.h"

#include <type_traits>

namespace unprojector::unproject {
using namespace geometry;

Result<BatchUnprojection> BatchUnprojection::byFormula(const Setup &setup, const BatchSpace &space)
{
    const Result<LineConstants> constants = lineConstants(setup, space);
    if (!constants)
        return constants.error();
    if (constants->perspective)
        return BatchUnprojection(Kind(Perspective{constants->numbers}));
    return BatchUnprojection(Kind(Box{constants->numbers}));
}

Result<BatchUnprojection> BatchUnprojection::byMatrix(const Setup &setup, const BatchSpace &space)
{
    const Result<glm::dmat4> inverse = spaceFromDevice(setup, space);
    if (!inverse)
        return inverse.error();
    batch::MatrixConstants constants{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            constants.rows[row][column] = (*inverse)[column][row];
    }
    return BatchUnprojection(Kind(constants));
}

template <class Loops, class Call>
auto BatchUnprojection::withLoop(const Loops &loops, const Call &call) const
{
    if (const auto *perspective = std::get_if<Perspective>(&m_constants))
        return call(loops.perspective, *perspective);
    if (const auto *box = std::get_if<Box>(&m_constants))
        return call(loops.box, *box);
    return call(loops.matrix, *std::get_if<batch::MatrixConstants>(&m_constants));
}

template <class Scalar>
void BatchUnprojection::operator()(const BatchInput<Scalar> &input, const BatchOutput<Scalar> &output,
                                   std::size_t count, InstructionSet set) const
{
    const auto run = [&](const auto &loops) {
        withLoop(loops, [&](auto loop, const auto &constants) {
            loop(constants, input.px, input.py, input.depth, output.x, output.y, output.z, count);
        });
    };
    if constexpr (std::is_same_v<Scalar, double>)
        run(batch::kernelsOf(set).ofDoubles);
    else
        run(batch::kernelsOf(set).ofFloats);
}

template <class Scalar>
std::size_t BatchUnprojection::operator()(const batch::DepthRow &row, Scalar *points, InstructionSet set) const
{
    const auto run = [&](const auto &loops) {
        return withLoop(loops, [&](auto loop, const auto &constants) { return loop(constants, row, points); });
    };
    if constexpr (std::is_same_v<Scalar, double>)
        return run(batch::kernelsOf(set).rowsOfDoubles);
    else
        return run(batch::kernelsOf(set).rowsOfFloats);
}

template <class Line, class Scalar>
void BatchUnprojection::line(const Line &line, Scalar *points, InstructionSet set) const
{
    const auto run = [&](const auto &loops) {
        withLoop(loops, [&](auto loop, const auto &constants) { loop(constants, line, points); });
    };
    if constexpr (std::is_same_v<Scalar, double>)
        run(batch::kernelsOf(set).linesOfDoubles);
    else
        run(batch::kernelsOf(set).linesOfFloats);
}

template void BatchUnprojection::operator()<double>(const BatchInput<double> &, const BatchOutput<double> &,
                                                    std::size_t, InstructionSet) const;
template void BatchUnprojection::operator()<float>(const BatchInput<float> &, const BatchOutput<float> &, std::size_t,
                                                   InstructionSet) const;
template std::size_t BatchUnprojection::operator()<double>(const batch::DepthRow &, double *, InstructionSet) const;
template std::size_t BatchUnprojection::operator()<float>(const batch::DepthRow &, float *, InstructionSet) const;
template void BatchUnprojection::line(const batch::DepthLine &, double *, InstructionSet) const;
template void BatchUnprojection::line(const batch::DepthLine &, float *, InstructionSet) const;
template void BatchUnprojection::line(const batch::FloatLine &, double *, InstructionSet) const;
template void BatchUnprojection::line(const batch::FloatLine &, float *, InstructionSet) const;

} // namespace unprojector::unproject
