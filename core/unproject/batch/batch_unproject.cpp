#include "core/unproject/batch/batch_unproject.h"

namespace unprojector::unproject {
using namespace geometry;

Result<BatchUnprojection> BatchUnprojection::byFormula(const Setup &setup, const BatchSpace &space)
{
    const Result<LineConstants> constants = lineConstants(setup, space);
    return constants ? Result<BatchUnprojection>(BatchUnprojection(*constants)) : constants.error();
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
    return BatchUnprojection(constants);
}

template <class Scalar, class Call>
auto BatchUnprojection::withLoops(InstructionSet set, const Call &call) const
{
    const batch::LoopsOf<Scalar> &loops = batch::loopsOf<Scalar>(set);
    if (const auto *line = std::get_if<LineConstants>(&m_constants))
        return call(line->perspective ? loops.perspective : loops.box, line->numbers);
    return call(loops.matrix, *std::get_if<batch::MatrixConstants>(&m_constants));
}

template <class Scalar>
void BatchUnprojection::operator()(const BatchInput<Scalar> &input, const BatchOutput<Scalar> &output,
                                   std::size_t count, InstructionSet set) const
{
    withLoops<Scalar>(set, [&](const auto &loops, const auto &constants) {
        loops.arrays(constants, input.px, input.py, input.depth, output.x, output.y, output.z, count);
    });
}

template <class Scalar>
std::size_t BatchUnprojection::operator()(const batch::DepthRow &row, Scalar *points, InstructionSet set) const
{
    return withLoops<Scalar>(
        set, [&](const auto &loops, const auto &constants) { return loops.row(constants, row, points); });
}

template <class Line, class Scalar>
void BatchUnprojection::line(const Line &line, Scalar *points, InstructionSet set) const
{
    withLoops<Scalar>(set, [&](const auto &loops, const auto &constants) { loops.line(constants, line, points); });
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
