#include "unprojector/scene.h"

#include "core/python/arrays.h"
#include "core/python/loops.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::python {
namespace {

constexpr const char *kSceneHelp = R"(A scene with its models: casts the rays of pixels on meshes.

    Scene.load         a scene file or a model
    Scene.parse        the text of a scene file
    Scene.from_arrays  vertices and triangles)";

constexpr const char *kPickHelp = R"(What the rays of pixels hit.

pick(px, py, *, snap="surface", setup=None, threads=None)

px, py : array_like
    Device pixels. The origin is the top-left corner, and the centre of pixel (i, j) is
    (i + 0.5, j + 0.5). They are broadcast.
snap : "surface", "vertex", "edge", "face"
    The hit of the pixel's own ray; the nearest visible vertex, point of an edge, or
    triangle within 8 pixels.
setup : Setup, optional
    The setup of the pixels. None: the scene's.
threads : int, optional
    The maximum number of threads; None: all cores.

Returns a structured array of the broadcast shape. The fields:

    hit           bool     whether the ray hits an object
    outside       bool     the pixel lies outside the viewport: no surface was looked for
    world         (3,) f8  the hit point
    uncertainty   (3,) f8  largest deviation of `world` from the file's geometry
    distance      f8       from the eye along the ray, world units
    object        i8       index in `objects`
    object_point  (3,) f8  the point in the object's own space
    triangle      i8       number of the triangle in its file
    vertices      (3,) i8  its vertices
    barycentric   (3,) f8  of the point in the triangle
    normal        (3,) f8  of the triangle, world space, length 1
    vertex        i8       the nearest of the vertices
    vertex_world  (3,) f8  its position
    edge          (2,) i8  the vertices of the nearest edge
    edge_world    (3,) f8  its nearest point

Where there is no such thing, numbers are nan and indices -1. The digits are those of
`unproject pick`.)";

py::dtype hitType()
{
    struct Field {
        const char *name, *format;
        std::size_t offset;
    };
    const std::array fields{
        Field{"hit", "?", offsetof(Hit, isHit)},
        Field{"outside", "?", offsetof(Hit, isOutside)},
        Field{"world", "(3,)f8", offsetof(Hit, world)},
        Field{"uncertainty", "(3,)f8", offsetof(Hit, uncertainty)},
        Field{"distance", "f8", offsetof(Hit, distance)},
        Field{"object", "i8", offsetof(Hit, object)},
        Field{"object_point", "(3,)f8", offsetof(Hit, objectPoint)},
        Field{"triangle", "i8", offsetof(Hit, triangle)},
        Field{"vertices", "(3,)i8", offsetof(Hit, vertices)},
        Field{"barycentric", "(3,)f8", offsetof(Hit, barycentric)},
        Field{"normal", "(3,)f8", offsetof(Hit, normal)},
        Field{"vertex", "i8", offsetof(Hit, vertex)},
        Field{"vertex_world", "(3,)f8", offsetof(Hit, vertexWorld)},
        Field{"edge", "(2,)i8", offsetof(Hit, edge)},
        Field{"edge_world", "(3,)f8", offsetof(Hit, edgeWorld)},
    };
    py::list names, formats, offsets;
    for (const Field &field : fields) {
        names.append(field.name);
        formats.append(field.format);
        offsets.append(field.offset);
    }
    py::dict description;
    description["names"] = names;
    description["formats"] = formats;
    description["offsets"] = offsets;
    description["itemsize"] = sizeof(Hit);
    return py::dtype::from_args(description);
}

py::array pick(const Scene &scene, const py::object &pixelX, const py::object &pixelY, const std::string &snap,
               const std::optional<Setup> &setup, const py::object &threads)
{
    const auto target = valueOf<Snap>("snap", snap, {"surface", "vertex", "edge", "face"});
    const std::size_t most = threadsOf(threads);
    const std::array<Numbers, 2> given{numbersOf("px", pixelX), numbersOf("py", pixelY)};
    const Shape shape = broadcastShape(given);
    py::array hits(hitType(), shape);
    auto *const results = static_cast<Hit *>(hits.mutable_data());
    Strides strides(shape);
    const Input x(given[0], strides), y(given[1], strides);
    strides.join();
    // Building the search trees takes a while.
    const Picker picker = withoutGil([&] { return Picker::of(scene, setup); });
    constexpr std::size_t kTask = 1024; // a few milliseconds
    inBlocks(strides.size(), kTask, most, [&](std::size_t begin, std::size_t count) {
        std::array<double, kBlock> xs, ys;
        picker(x.block(strides, begin, count, xs.data()), y.block(strides, begin, count, ys.data()), results + begin,
               count, target);
    });
    return hits;
}

/// The indices as 32 bits. They are read as 64 bits, so that negative and large ones are found.
template <class Index>
std::vector<std::uint32_t> indicesOf(const py::array &triangles, std::size_t count)
{
    const py::array_t<Index, py::array::c_style | py::array::forcecast> wide(triangles);
    std::vector<std::uint32_t> indices(static_cast<std::size_t>(wide.size()));
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const Index index = wide.data()[i];
        // A negative number is a large one without its sign.
        if (static_cast<std::uint64_t>(index) >= count)
            throw py::value_error("triangle " + std::to_string(i / 3) + " has the vertex " + std::to_string(index)
                                  + "; there are " + std::to_string(count) + " vertices, from 0");
        indices[i] = static_cast<std::uint32_t>(index);
    }
    return indices;
}

Scene fromArrays(const Setup &setup, const py::object &vertices, const py::object &triangles, const std::string &name)
{
    const py::array_t<double, py::array::c_style | py::array::forcecast> positions(
        numbersOf("vertices", vertices).array);
    requireRowsOfThree("vertices", positions);
    const py::array given = py::array::ensure(triangles);
    if (!given || (given.dtype().kind() != 'i' && given.dtype().kind() != 'u')) {
        PyErr_Clear();
        throw py::type_error("triangles is no array of whole numbers");
    }
    requireRowsOfThree("triangles", given);
    const auto count = static_cast<std::size_t>(positions.shape(0));
    const std::vector<std::uint32_t> indices =
        given.dtype().kind() == 'u' ? indicesOf<std::uint64_t>(given, count) : indicesOf<std::int64_t>(given, count);
    const double *const coordinates = positions.data();
    return withoutGil([&] { return Scene::of(setup, {coordinates, 3 * count}, indices, name); });
}

std::string sceneText(const Scene &scene)
{
    std::string text = "<Scene:";
    for (const SceneObject &object : scene.objects())
        text += ' ' + object.name + " ("
                + (object.triangles > 0 ? std::to_string(object.triangles) + " triangles"
                                        : std::to_string(object.points) + " points")
                + (object.isHidden ? ", hidden)," : "),");
    if (scene.objects().empty())
        text += " no objects,";
    return text + ' ' + scene.setup().description() + '>';
}

std::string objectText(const SceneObject &object)
{
    return "<SceneObject: " + object.name + ", " + std::to_string(object.vertices) + " vertices, "
           + std::to_string(object.triangles) + " triangles, " + std::to_string(object.points) + " points>";
}

void bindObject(py::module_ &module)
{
    py::class_<SceneObject>(module, "SceneObject", "An object of a scene.")
        .def_readonly("name", &SceneObject::name, "The name of the object.")
        .def_readonly("file", &SceneObject::file, "The file of its model; empty for a bundled model and for arrays.")
        .def_readonly("vertices", &SceneObject::vertices, "The number of vertices.")
        .def_readonly("triangles", &SceneObject::triangles, "The number of triangles.")
        .def_readonly("points", &SceneObject::points, "The number of points that belong to no triangle.")
        .def_readonly("hidden", &SceneObject::isHidden, "Whether a pick passes through it.")
        .def_readonly("notes", &SceneObject::notes, "What the importer changed or dropped: a list of sentences.")
        .def_property_readonly(
            "bounds", [](const SceneObject &o) { return py::make_tuple(arrayOf(o.lowest), arrayOf(o.highest)); },
            "The lowest and the highest corner of its box, world space, (3,) each.")
        .def_property_readonly(
            "matrix", [](const SceneObject &o) { return arrayOf(o.worldFromObject); },
            "World from object space, float64 of shape (4, 4), for column vectors.")
        .def("__repr__", &objectText);
}

} // namespace

void bindScene(py::module_ &module)
{
    bindObject(module);
    py::class_<Scene>(module, "Scene", kSceneHelp)
        .def_static(
            "load", [](const std::filesystem::path &file) { return withoutGil([&] { return Scene::load(file); }); },
            py::arg("file"), R"(Opens a scene file, or a model: OBJ, STL, PLY, OFF, glTF, GLB.

load(file)

A model gets the setup that the window opens it with, at 800 x 600.
Raises FileNotFoundError or OSError for a file that cannot be read, ValueError for one
that is wrong: the message names the file and the line or key.)")
        .def_static(
            "parse",
            [](const std::string &text, const std::filesystem::path &folder) {
                return withoutGil([&] { return Scene::parse(text, folder); });
            },
            py::arg("text"), py::arg("folder") = std::filesystem::path("."), R"(The scene in the text of a scene file.

parse(text, folder=".")

folder : path
    Relative paths of models start there.)")
        .def_static("from_arrays", &fromArrays, py::arg("setup"), py::arg("vertices"), py::arg("triangles"),
                    py::arg("name") = "mesh", R"(A scene of one mesh.

from_arrays(setup, vertices, triangles, name="mesh")

vertices : array_like of shape (n, 3)
    World coordinates.
triangles : array_like of int, shape (m, 3)
    The numbers of each triangle's vertices, from 0.)")
        .def_property_readonly("setup", &Scene::setup, "The setup of the scene file; for a model, the window's.")
        .def_property_readonly("objects", &Scene::objects, "The objects: a list of SceneObject.")
        .def(
            "setup_at",
            [](const Scene &scene, int width, int height) { return valueOrRaise(scene.setupAt(width, height)); },
            py::arg("width"), py::arg("height"), R"(The setup that the window uses at another size.

setup_at(width, height)

A scene of arrays keeps the camera and the projection of its setup.

width, height : int
    Device pixels.)")
        .def("pick", &pick, py::arg("px"), py::arg("py"), py::kw_only(), py::arg("snap") = "surface",
             py::arg("setup") = py::none(), py::arg("threads") = py::none(), kPickHelp)
        .def(
            "save",
            [](const Scene &scene, const std::filesystem::path &file) { withoutGil([&] { return scene.save(file); }); },
            py::arg("file"), R"(Writes the scene as a scene file, which replaces an existing one.

save(file))")
        .def("__repr__", &sceneText);
}

} // namespace unprojector::python
