#include "unprojector/diagnose.h"

#include "core/python/arrays.h"
#include "core/python/loops.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::python {
namespace {

constexpr const char *kDiagnoseHelp = R"(Finds the mistake behind a wrong coordinate.

diagnose(setup, pixel, depth, got, *, space="world", other_size=None)

setup : Setup or Scene
    With a scene, an unknown depth is that of its meshes, and mistakes of model matrices
    are tried.
pixel : (2,) or (n, 2)
    The clicked pixels: device pixels from the top-left corner; n is at most 100.
depth : float, (n,) or None
    The right depths; None: unknown. A depth that prints with four decimals or more counts
    as rounded to them, one with fewer as exact.
got : (3,) or (n, 3)
    The wrong program's coordinates, of one program. Strings count as they were printed:
    "0.7051 -0.4122 0.0918", or one string a coordinate. Numbers count with the digits
    that their type prints: give float32 arrays as such.
space : "world" or "eye"
    The space of got.
other_size : (int, int), optional
    Another size that the program may still use, as before a resize.

Returns a Diagnosis; print it.)";

/// The digits that a number prints with: "0.1" for np.float32(0.1).
std::string textOf(const py::handle &number)
{
    return py::str(py::isinstance<py::str>(number) ? py::reinterpret_borrow<py::object>(number)
                                                   : number.attr("__str__")());
}

/// True for several items, and not one number or text.
bool isRow(const py::handle &item)
{
    return (py::isinstance<py::sequence>(item) && !py::isinstance<py::str>(item))
           || (py::isinstance<py::array>(item) && py::reinterpret_borrow<py::array>(item).ndim() > 0);
}

/// The rows of an argument, each as a text of `width` numbers; a string is a row of its own.
std::vector<std::string> rowsOf(const char *name, const py::object &argument, std::size_t width)
{
    if (py::isinstance<py::str>(argument))
        return {argument.cast<std::string>()};
    if (!py::isinstance<py::sequence>(argument) && !py::isinstance<py::array>(argument))
        throw py::type_error(std::string(name) + " is no sequence of " + std::to_string(width) + " numbers");
    const py::list items(argument);
    std::vector<std::string> rows;
    const auto isText = [](const py::handle &item) { return py::isinstance<py::str>(item); };
    // As many strings as a row has numbers are one row.
    const bool areRows =
        std::all_of(items.begin(), items.end(), isRow)
        || (items.size() != width && std::all_of(items.begin(), items.end(), [&](const py::handle &item) {
                return isRow(item) || isText(item);
            }));
    if (areRows) {
        for (const py::handle item : items) {
            for (std::string &row : rowsOf(name, py::reinterpret_borrow<py::object>(item), width))
                rows.push_back(std::move(row));
        }
        return rows;
    }
    if (items.size() != width)
        throw py::value_error(std::string(name) + " has " + std::to_string(items.size()) + " numbers; give "
                              + std::to_string(width));
    std::string row;
    for (const py::handle item : items)
        row += (row.empty() ? "" : ",") + textOf(item);
    return {row};
}

std::vector<std::string> depthsOf(const py::object &depth, std::size_t count)
{
    if (depth.is_none())
        return std::vector<std::string>(count);
    if (!isRow(depth))
        return {textOf(depth)};
    std::vector<std::string> depths;
    for (const py::handle item : py::list(depth))
        depths.push_back(item.is_none() ? std::string() : textOf(item));
    return depths;
}

Diagnosis diagnosed(const py::object &setup, const py::object &pixel, const py::object &depth, const py::object &got,
                    const std::string &space, const std::optional<std::pair<int, int>> &otherSize)
{
    const std::vector<std::string> pixels = rowsOf("pixel", pixel, 2), answers = rowsOf("got", got, 3);
    const std::vector<std::string> depths = depthsOf(depth, pixels.size());
    if (pixels.size() != answers.size() || pixels.size() != depths.size())
        throw py::value_error("there are " + std::to_string(pixels.size()) + " pixels, " + std::to_string(depths.size())
                              + " depths and " + std::to_string(answers.size()) + " coordinates; give as many of each");
    std::vector<WrongPoint> points;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        Result<WrongPoint> point = wrongPoint(pixels[i], depths[i], answers[i]);
        if (!point && pixels.size() > 1)
            point = Error{point.error().kind, "point " + std::to_string(i) + ": " + point.error().message};
        points.push_back(valueOrRaise(std::move(point)));
    }
    DiagnoseOptions options;
    options.space = spaceOf(space);
    options.otherSize = otherSize;
    if (py::isinstance<Scene>(setup)) {
        const auto scene = setup.cast<Scene>();
        return withoutGil([&] { return diagnose(scene, points, options); });
    }
    if (!py::isinstance<Setup>(setup))
        throw py::type_error("the first argument is no Setup and no Scene");
    const auto from = setup.cast<Setup>();
    return withoutGil([&] { return diagnose(from, points, options); });
}

/// The corrected lines of each library, by its name in small letters.
py::dict codeOf(const Diagnosis &diagnosis)
{
    py::dict code;
    for (const CodeChange &change : diagnosis.code) {
        std::string key = change.library;
        std::transform(key.begin(), key.end(), key.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
        const std::string text = "- " + change.wrong + "\n+ " + change.right;
        code[py::str(key)] =
            code.contains(key) ? py::str(code[py::str(key)].cast<std::string>() + '\n' + text) : py::str(text);
    }
    return code;
}

} // namespace

void bindDiagnose(py::module_ &module)
{
    py::class_<CodeChange>(module, "CodeChange", "A line of code with the mistake, and the corrected line.")
        .def_readonly("mistake", &CodeChange::mistake, "The id of the mistake.")
        .def_readonly("library", &CodeChange::library, "\"GLU\", \"GLM\", \"Qt\", \"three.js\" or \"NumPy\".")
        .def_readonly("wrong", &CodeChange::wrong, "The line with the mistake.")
        .def_readonly("right", &CodeChange::right, "The corrected line.")
        .def("__repr__", [](const CodeChange &c) { return "<CodeChange: " + c.library + ": " + c.right + '>'; });
    py::class_<Candidate>(module, "Candidate", "One or two mistakes, and their answer to the first point.")
        .def_readonly("id", &Candidate::id, "\"right\", \"y-not-flipped\", …; for two \"a+b\".")
        .def_readonly("sentence", &Candidate::sentence, "What a program with them does.")
        .def_readonly("distance", &Candidate::distance, "From the given points, in units of their last digits.")
        .def_readonly("explains", &Candidate::explains, "Whether it explains all digits that count.")
        .def_property_readonly(
            "point", [](const Candidate &c) { return arrayOf(c.point); }, "Its answer to the first point, (3,).")
        .def_property_readonly(
            "values",
            [](const Candidate &c) {
                py::dict values;
                for (const auto &[name, value] : c.values)
                    values[py::str(name)] = py::cast(value);
                return values;
            },
            "Solved values by name: a dict of lists of numbers, or of words.")
        .def("__repr__",
             [](const Candidate &c) { return "<Candidate: " + c.id + (c.explains ? ", explains all digits>" : ">"); });
    py::class_<Diagnosis>(module, "Diagnosis", "The mistake behind a wrong coordinate. Printing it shows all of it.")
        .def_readonly("verdict", &Diagnosis::verdict, "The id of a mistake, \"right\", \"known-point\" or \"unknown\".")
        .def_readonly("sentence", &Diagnosis::sentence, "The verdict in words.")
        .def_readonly("candidates", &Diagnosis::candidates, "The mistakes, the best first: a list of Candidate.")
        .def_readonly("changes", &Diagnosis::code, "The lines to change: a list of CodeChange.")
        .def_readonly("chance", &Diagnosis::chance, "The chance that an unrelated point is explained as well.")
        .def_property_readonly("code", &codeOf,
                               "The lines to change by library: code[\"numpy\"] has \"- wrong\" and \"+ right\".")
        .def_property_readonly(
            "right", [](const Diagnosis &d) { return d.right ? std::optional(arrayOf(*d.right)) : std::nullopt; },
            "The right answer to the first point, (3,); None where it is unknown.")
        .def_property_readonly(
            "next",
            [](const Diagnosis &d) {
                return d.next ? std::optional(py::make_tuple(d.next->x, d.next->y)) : std::nullopt;
            },
            "The pixel whose answer distinguishes the first candidates; None without one.")
        .def("__str__", [](const Diagnosis &d) { return d.report.substr(0, d.report.find_last_not_of('\n') + 1); })
        .def("_repr_html_", [](const Diagnosis &d) { return d.html; }) // what a notebook shows
        .def("__repr__", [](const Diagnosis &d) { return "<Diagnosis: " + d.verdict + ": " + d.sentence + '>'; });
    module.def("diagnose", &diagnosed, py::arg("setup"), py::arg("pixel"), py::arg("depth"), py::arg("got"),
               py::kw_only(), py::arg("space") = "world", py::arg("other_size") = py::none(), kDiagnoseHelp);
}

} // namespace unprojector::python
