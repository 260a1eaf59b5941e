#include "unprojector/project.h"

#include "core/python/arrays.h"
#include "core/python/loops.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::python {
namespace {

constexpr const char *kProjectHelp = R"(The positions of points in the window.

project(points, *, space="world", stages=False, threads=None)

points : array_like of shape (..., 3)
    World or eye coordinates.
space : "world" or "eye"
    The space of the points.
stages : bool
    Whether to return the points in every space.
threads : int, optional
    The maximum number of threads; None: all cores.

Returns window coordinates, float64 of shape (..., 3): x, y in device pixels from the
bottom-left corner, and the window depth. With stages, a named tuple of arrays:

    eye     (..., 3)
    clip    (..., 4)
    ndc     (..., 3)
    window  (..., 3)
    pixel   (..., 3)  px, py, depth as unproject takes them, from the top-left corner

    px, py, depth = np.moveaxis(setup.project(points, stages=True).pixel, -1, 0)
    setup.unproject(px, py, depth)      # the points again

Numbers are nan from the first stage on that a point does not have: in the plane of the
eye it has no NDC. The digits are those of `unproject project`.)";

constexpr const char *kModule = "unprojector._core";
constexpr const char *kStagesType = "Stages";

/// The components of a stage within Stages.
struct StageMember {
    const char *name;
    py::ssize_t width;
    const double *(*of)(const Stages &stages);
};

constexpr std::array kStageMembers{
    StageMember{"eye", 3, [](const Stages &s) { return &s.eye.x; }},
    StageMember{"clip", 4, [](const Stages &s) { return &s.clip.x; }},
    StageMember{"ndc", 3, [](const Stages &s) { return &s.ndc.x; }},
    StageMember{"window", 3, [](const Stages &s) { return &s.window.x; }},
    StageMember{"pixel", 3, [](const Stages &s) { return &s.pixel.x; }},
};
constexpr std::size_t kWindow = 3;

/// Adds the named tuple of the stages to the module, so that pickle finds it there.
void addStagesType(py::module_ &module)
{
    py::list names;
    for (const StageMember &member : kStageMembers)
        names.append(member.name);
    py::object type = py::module_::import("collections")
                          .attr("namedtuple")(kStagesType, names, py::arg("module") = module.attr("__name__"));
    type.attr("__doc__") = "Points in each space on their way to a pixel, see Setup.project.";
    module.attr(kStagesType) = type;
}

py::object project(const Setup &setup, const py::object &points, const std::string &space, bool hasStages,
                   const py::object &threads)
{
    const std::size_t most = threadsOf(threads);
    const ForwardProjection projection = valueOrRaise(ForwardProjection::of(setup, spaceOf(space)));
    const Numbers given = numbersOf("points", points);
    Shape shape = shapeOf(given.array);
    constexpr py::ssize_t kAxes = 3;
    if (shape.empty() || shape.back() != kAxes)
        refuseShape("points", given.array, "(..., 3)");
    Strides strides({shape.begin(), shape.end() - 1});
    std::vector<Input> inputs;
    for (py::ssize_t k = 0; k < kAxes; ++k) {
        const py::array component = given.array[py::make_tuple(py::ellipsis(), k)];
        inputs.emplace_back(Numbers{given.name, component, given.isFloat}, strides);
    }
    std::vector<std::pair<const StageMember *, Output>> outputs;
    for (std::size_t i = 0; i < kStageMembers.size(); ++i) {
        if (!hasStages && i != kWindow)
            continue;
        shape.back() = kStageMembers[i].width;
        outputs.emplace_back(&kStageMembers[i], Output(py::array_t<double>(shape), strides));
    }
    strides.join();

    constexpr std::size_t kTask = std::size_t{1} << 12; // about a millisecond
    inBlocks(strides.size(), kTask, most, [&](std::size_t begin, std::size_t count) {
        std::array<double, kBlock> scratch;
        std::array<double, 3 * kBlock> vectors;
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            const double *numbers = inputs[k].block(strides, begin, count, scratch.data());
            for (std::size_t i = 0; i < count; ++i)
                vectors[3 * i + k] = numbers[i];
        }
        std::array<Stages, kBlock> stages;
        projection(vectors.data(), stages.data(), count);
        std::array<double, 4 * kBlock> results;
        for (const auto &[member, output] : outputs) {
            const auto width = static_cast<std::size_t>(member->width);
            double *const to = output.room(strides, begin, results.data());
            for (std::size_t i = 0; i < count; ++i)
                std::copy_n(member->of(stages[i]), width, to + width * i);
            output.write(strides, begin, count, to);
        }
    });
    if (!hasStages)
        return outputs.front().second.array();
    py::tuple arrays(outputs.size());
    for (std::size_t i = 0; i < outputs.size(); ++i)
        arrays[i] = outputs[i].second.array();
    return py::module_::import(kModule).attr(kStagesType)(*arrays);
}

} // namespace

void bindProject(py::module_ &module, SetupClass &setup)
{
    addStagesType(module);
    setup.def("project", &project, py::arg("points"), py::kw_only(), py::arg("space") = "world",
              py::arg("stages") = false, py::arg("threads") = py::none(), kProjectHelp);
}

} // namespace unprojector::python
