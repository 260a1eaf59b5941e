#include "unprojector/landmarks.h"

#include "core/python/arrays.h"
#include "core/python/bindings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace unprojector::python {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr const char *kAbsences[] = {"not placed", "skipped", "missing"}; // in the order of Absence

/// An array of a vector a row; NaN where a row has none.
template <class Rows, class Of>
py::array_t<double> arrayOf(const Rows &rows, const Of &of)
{
    py::array_t<double> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
    auto numbers = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::optional<glm::dvec3> vector = of(rows[i]);
        for (py::ssize_t k = 0; k < 3; ++k)
            numbers(static_cast<py::ssize_t>(i), k) = vector ? (*vector)[static_cast<glm::length_t>(k)] : kNaN;
    }
    return array;
}

py::array_t<double> pointsOf(const Specimen &specimen)
{
    return arrayOf(specimen.landmarks, [](const Landmark &landmark) { return landmark.world; });
}

std::vector<std::string> namesOf(const Specimen &specimen)
{
    std::vector<std::string> names;
    for (const Landmark &landmark : specimen.landmarks)
        names.push_back(landmark.name);
    return names;
}

std::vector<std::string> absencesOf(const Specimen &specimen)
{
    std::vector<std::string> words;
    for (const Landmark &landmark : specimen.landmarks)
        words.emplace_back(landmark.world ? "" : kAbsences[static_cast<std::size_t>(landmark.absence)]);
    return words;
}

bool hasName(const Specimen &specimen, const std::string &name)
{
    return std::any_of(specimen.landmarks.begin(), specimen.landmarks.end(),
                       [&name](const Landmark &landmark) { return landmark.name == name; });
}

/// The position of the one landmark of a name.
py::array_t<double> pointNamed(const Specimen &specimen, const std::string &name)
{
    const auto isIt = [&name](const Landmark &landmark) { return landmark.name == name; };
    const auto &all = specimen.landmarks;
    const auto count = std::count_if(all.begin(), all.end(), isIt);
    if (count != 1) {
        std::string names;
        for (const Landmark &landmark : all)
            names += (names.empty() ? "" : ", ") + landmark.name;
        throw py::key_error(count == 0 ? "there is no landmark \"" + name + "\"; there are " + names
                                       : std::to_string(count) + " landmarks have the name \"" + name
                                             + "\"; take one by its index in points");
    }
    const glm::dvec3 point = std::find_if(all.begin(), all.end(), isIt)->world.value_or(glm::dvec3(kNaN));
    return python::arrayOf(point);
}

std::string specimenText(const Specimen &specimen)
{
    const auto absent = std::count_if(specimen.landmarks.begin(), specimen.landmarks.end(),
                                      [](const Landmark &landmark) { return !landmark.world; });
    return (specimen.name.empty() ? std::string() : specimen.name + ": ") + std::to_string(specimen.landmarks.size())
           + (specimen.landmarks.size() == 1 ? " landmark" : " landmarks")
           + (absent > 0 ? ", " + std::to_string(absent) + " without a position" : "")
           + (specimen.curves.empty() ? "" : ", " + std::to_string(specimen.curves.size()) + " curves");
}

/// The only specimen.
const Specimen &onlyOf(const Landmarks &landmarks)
{
    if (landmarks.specimens().size() != 1)
        throw py::value_error("there are " + std::to_string(landmarks.specimens().size())
                              + " specimens; take one from specimens");
    return landmarks.specimens().front();
}

Specimen specimenFrom(const std::vector<std::string> &names, const py::object &points)
{
    const py::array given = numbersOf("points", points).array;
    requireRowsOfThree("points", given);
    if (names.size() != static_cast<std::size_t>(given.shape(0)))
        throw py::value_error("there are " + std::to_string(names.size()) + " names and "
                              + std::to_string(given.shape(0)) + " points; give one name a point");
    const py::array_t<double, py::array::c_style | py::array::forcecast> numbers(given);
    Specimen specimen;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto row = static_cast<py::ssize_t>(i);
        const glm::dvec3 point(numbers.at(row, 0), numbers.at(row, 1), numbers.at(row, 2));
        const auto nans = std::isnan(point.x) + std::isnan(point.y) + std::isnan(point.z);
        if ((nans > 0 && nans < 3) || std::isinf(point.x) || std::isinf(point.y) || std::isinf(point.z))
            throw py::value_error("point " + std::to_string(i) + " (" + names[i]
                                  + ") has a coordinate that is not finite; give three numbers, or three nan for a "
                                    "landmark without a position");
        Landmark &landmark = specimen.landmarks.emplace_back();
        landmark.name = names[i];
        if (nans == 0)
            landmark.world = point;
    }
    return specimen;
}

/// The specimens of an argument: of Landmarks, a Specimen, or a sequence of them.
std::vector<Specimen> specimensOf(const py::object &argument)
{
    if (py::isinstance<Specimen>(argument))
        return {argument.cast<Specimen>()};
    if (py::isinstance<Landmarks>(argument))
        return argument.cast<Landmarks>().specimens();
    std::vector<Specimen> specimens;
    if (py::isinstance<py::sequence>(argument) && !py::isinstance<py::str>(argument)) {
        for (const py::handle item : argument) {
            for (Specimen &specimen : specimensOf(py::reinterpret_borrow<py::object>(item)))
                specimens.push_back(std::move(specimen));
        }
        return specimens;
    }
    throw py::type_error(std::string(py::repr(argument)) + " is no Landmarks, Specimen or sequence of them");
}

/// The names of all specimens' landmarks, in the order of their first appearance.
std::vector<std::string> namesOfAll(const std::vector<Specimen> &specimens)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < specimens.size(); ++i) {
        std::vector<std::string> own;
        for (const Landmark &landmark : specimens[i].landmarks) {
            const std::string specimen =
                "specimen " + std::to_string(i) + (specimens[i].name.empty() ? "" : " (" + specimens[i].name + ")");
            if (landmark.name.empty())
                throw py::value_error(specimen + " has a landmark without a name; landmarks belong together by name");
            if (std::find(own.begin(), own.end(), landmark.name) != own.end())
                throw py::value_error(specimen + " has the name \"" + landmark.name
                                      + "\" twice; landmarks belong together by name");
            own.push_back(landmark.name);
            if (std::find(names.begin(), names.end(), landmark.name) == names.end())
                names.push_back(landmark.name);
        }
    }
    return names;
}

py::tuple tableOf(const py::object &argument)
{
    const std::vector<Specimen> specimens = specimensOf(argument);
    const std::vector<std::string> names = namesOfAll(specimens);
    py::array_t<double> points(
        {static_cast<py::ssize_t>(specimens.size()), static_cast<py::ssize_t>(names.size()), py::ssize_t{3}});
    auto numbers = points.mutable_unchecked<3>();
    std::vector<std::string> specimenNames;
    for (std::size_t i = 0; i < specimens.size(); ++i) {
        specimenNames.push_back(specimens[i].name);
        for (std::size_t k = 0; k < names.size(); ++k) {
            const auto found = std::find_if(specimens[i].landmarks.begin(), specimens[i].landmarks.end(),
                                            [&](const Landmark &landmark) { return landmark.name == names[k]; });
            const bool isThere = found != specimens[i].landmarks.end() && found->world;
            for (py::ssize_t axis = 0; axis < 3; ++axis)
                numbers(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k), axis) =
                    isThere ? (*found->world)[static_cast<glm::length_t>(axis)] : kNaN;
        }
    }
    return py::make_tuple(specimenNames, names, points);
}

std::vector<std::string> written(const std::filesystem::path &file, const Landmarks &landmarks)
{
    std::vector<std::string> notes = withoutGil([&] { return landmarks.write(file); });
    for (const std::string &note : notes)
        warn(note);
    return notes;
}

void bindSpecimen(py::module_ &module)
{
    py::class_<Curve>(module, "Curve", "A line through landmarks, with semilandmarks in equal steps.")
        .def_readonly("name", &Curve::name, "The name of the curve.")
        .def_readonly("landmarks", &Curve::landmarks, "The names of its landmarks, in order.")
        .def_property_readonly(
            "points",
            [](const Curve &curve) {
                return arrayOf(curve.semilandmarks, [](const glm::dvec3 &p) { return std::optional(p); });
            },
            "The semilandmarks, float64 of shape (n, 3).");
    py::class_<Specimen>(module, "Specimen", "The landmarks of one specimen.")
        .def_readonly("name", &Specimen::name, "The name of the specimen; may be empty.")
        .def_readonly("unit", &Specimen::unit, "The unit of the coordinates, as \"mm\"; empty: unknown.")
        .def_readonly("placing", &Specimen::placing, "Which of the repeated placings it is, from 1.")
        .def_readonly("curves", &Specimen::curves, "The curves: a list of Curve.")
        .def_property_readonly("names", &namesOf, "The names of the landmarks.")
        .def_property_readonly("points", &pointsOf,
                               "The positions, float64 of shape (n, 3); nan for a landmark without one, see absence.")
        .def_property_readonly(
            "absence", &absencesOf,
            "For each landmark: \"\" with a position, else \"not placed\", \"skipped\" or \"missing\".")
        .def_property_readonly(
            "uncertainty",
            [](const Specimen &s) {
                return arrayOf(s.landmarks, [](const Landmark &landmark) { return landmark.uncertainty; });
            },
            "The largest error of each coordinate, float64 of shape (n, 3); nan where the file has none.")
        .def("__len__", [](const Specimen &s) { return s.landmarks.size(); })
        .def("__iter__", [](const Specimen &s) { return py::iter(py::cast(namesOf(s))); })
        .def("__contains__", [](const Specimen &s, const std::string &name) { return hasName(s, name); })
        .def("__getitem__", &pointNamed, py::arg("name"), "The position of the landmark of a name, (3,).")
        .def("__repr__", [](const Specimen &s) { return "<Specimen: " + specimenText(s) + '>'; });
}

} // namespace

void bindLandmarks(py::module_ &module)
{
    bindSpecimen(module);
    py::class_<Landmarks>(module, "Landmarks", R"(The landmarks of a file: of one or several specimens.

With one specimen, its names, points, absence and curves are here too, and
landmarks["bregma"] is a position. Iterating gives the names.)")
        .def_property_readonly("specimens", &Landmarks::specimens, "The specimens: a list of Specimen.")
        .def_property_readonly("notes", &Landmarks::notes, "What reading changed or dropped: a list of sentences.")
        .def_property_readonly(
            "names", [](const Landmarks &l) { return namesOf(onlyOf(l)); }, "See Specimen.names.")
        .def_property_readonly(
            "points", [](const Landmarks &l) { return pointsOf(onlyOf(l)); }, "See Specimen.points.")
        .def_property_readonly(
            "absence", [](const Landmarks &l) { return absencesOf(onlyOf(l)); }, "See Specimen.absence.")
        .def_property_readonly(
            "curves", [](const Landmarks &l) { return onlyOf(l).curves; }, "See Specimen.curves.")
        .def_property_readonly(
            "unit", [](const Landmarks &l) { return onlyOf(l).unit; }, "See Specimen.unit.")
        .def("__len__", [](const Landmarks &l) { return onlyOf(l).landmarks.size(); })
        .def("__iter__", [](const Landmarks &l) { return py::iter(py::cast(namesOf(onlyOf(l)))); })
        .def("__contains__", [](const Landmarks &l, const std::string &name) { return hasName(onlyOf(l), name); })
        .def("__getitem__", [](const Landmarks &l, const std::string &name) { return pointNamed(onlyOf(l), name); })
        .def("__repr__", [](const Landmarks &l) {
            std::string text;
            for (const Specimen &specimen : l.specimens())
                text += (text.empty() ? "" : "; ") + specimenText(specimen);
            return "<Landmarks: " + text + '>';
        });
    module.def(
        "read_landmarks",
        [](const std::filesystem::path &file) { return withoutGil([&] { return Landmarks::read(file); }); },
        py::arg("file"), R"(The landmarks of a file.

read_landmarks(file)

file : path
    CSV, MeshLab (.pp, .pptpl), 3D Slicer (.mrk.json, .fcsv), IDAV (.pts), TPS, NTSYS
    (.nts, .dta), Amira (.landmarkAscii) or landmarker.io (.ljson), by its suffix.

Returns Landmarks. Its notes list what reading changed or dropped.
Raises FileNotFoundError or OSError for a file that cannot be read; ValueError names the
file and the line that is wrong.)");
    module.def(
        "write_landmarks",
        [](const std::filesystem::path &file, const py::object &landmarks, const py::object &points) {
            if (py::isinstance<Landmarks>(landmarks) && points.is_none())
                return written(file, landmarks.cast<Landmarks>());
            if (py::isinstance<Specimen>(landmarks) && points.is_none())
                return written(file, Landmarks::of({landmarks.cast<Specimen>()}));
            if (points.is_none() && py::isinstance<py::sequence>(landmarks) && py::len(landmarks) > 0
                && !py::isinstance<py::str>(landmarks[py::int_(0)]))
                return written(file, Landmarks::of(specimensOf(landmarks)));
            if (points.is_none())
                throw py::type_error("write_landmarks needs Landmarks, a Specimen, or names and points");
            return written(file, Landmarks::of({specimenFrom(landmarks.cast<std::vector<std::string>>(), points)}));
        },
        py::arg("file"), py::arg("landmarks"), py::arg("points") = py::none(), R"(Writes a landmark file.

write_landmarks(file, landmarks)
write_landmarks(file, names, points)

file : path
    Its suffix is the format; see read_landmarks. .landmarkAscii and .ljson are read only.
    An existing file is replaced.
landmarks : Landmarks, Specimen, or a sequence of them
    Landmarks that were read keep all that their file had; a Specimen or a sequence keeps
    what Specimen shows. Several specimens go into CSV, TPS and NTSYS: landmarks belong
    together by name.
names : list of str
points : array_like of shape (n, 3)
    nan for a landmark without a position.

Returns a list of sentences about what the format cannot hold. Each is also a
UserWarning.)");
    module.def("landmark_table", &tableOf, py::arg("landmarks"), R"(The landmarks of several specimens as one array.

landmark_table(landmarks)

landmarks : Landmarks, Specimen, or a sequence of them

Returns a tuple: the names of the specimens, the names of the landmarks in the order of
their first appearance, and the points, float64 of shape (specimens, landmarks, 3) with
nan where a specimen lacks one. Landmarks belong together by name; ValueError names a
specimen with a name twice.)");
}

} // namespace unprojector::python
