#include "unprojector/scene.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/library/internal.h"
#include "core/library/scene_data.h"
#include "core/ray/snap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector {
static_assert(int(Snap::Face) == int(ray::Snap::Face));
namespace {

Result<Scene> madeOf(base::Expected<opening::OpenedScene, base::Error> opened)
{
    if (!opened)
        return publicError(opened.error());
    const auto setup = opening::setupOf(*opened, std::nullopt);
    if (!setup)
        return publicError(setup.error());
    const auto api = opened->file ? opened->file->conventions.value_or(geometry::Api::OpenGl) : geometry::Api::OpenGl;
    return SceneAccess::make(std::move(opened).value(), SetupAccess::make(*setup, worldFindings(api)).value());
}

/// The scene file of a setup, without objects. A perspective with the viewport's aspect keeps to it at
/// another size.
scene_file::SceneFile fileOf(const Setup &setup)
{
    auto parsed = scene_file::parseScene(setup.sceneText(), "scene");
    scene_file::SceneFile file = std::move(parsed).value();
    const auto *projection = std::get_if<geometry::Projection>(&file.projection);
    file.aspectFromViewport = projection && hasAspectOf(*projection, SetupAccess::of(setup).viewport);
    return file;
}

} // namespace

Result<Scene> Scene::load(const std::filesystem::path &file)
{
    return madeOf(opening::open(file));
}

Result<Scene> Scene::parse(std::string_view text, const std::filesystem::path &folder)
{
    return madeOf(opening::openText(text, folder / "scene.json", "scene"));
}

Result<Scene> Scene::of(const Setup &setup, std::span<const double> vertices, std::span<const std::uint32_t> triangles,
                        const std::string &name)
{
    const std::size_t count = vertices.size() / 3;
    if (vertices.size() % 3 != 0)
        return valueError(base::tr("vertices has %1 numbers; give three coordinates a vertex", vertices.size()));
    if (triangles.size() % 3 != 0)
        return valueError(base::tr("triangles has %1 numbers; give three vertex numbers a triangle", triangles.size()));
    if (triangles.empty())
        return valueError(base::tr("the mesh has no triangle; give three vertex numbers a triangle"));
    const auto wrong = std::find_if(vertices.begin(), vertices.end(), [](double v) { return !std::isfinite(v); });
    if (wrong != vertices.end())
        return valueError(base::tr("vertex %1 has the coordinate %2; give finite numbers",
                                   std::size_t(wrong - vertices.begin()) / 3, base::shortestText(*wrong)));
    const auto outside =
        std::find_if(triangles.begin(), triangles.end(), [count](std::uint32_t index) { return index >= count; });
    if (outside != triangles.end())
        return valueError(base::tr("triangle %1 has the vertex %2; there are %3 vertices, from 0",
                                   std::size_t(outside - triangles.begin()) / 3, *outside, count));
    std::vector<glm::dvec3> positions(count);
    geometry::Box box;
    for (std::size_t i = 0; i < count; ++i) {
        positions[i] = {vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]};
        box.add(positions[i]);
    }
    auto model = std::make_shared<mesh::Model>();
    model->name = name;
    model->fileVertices = count;
    mesh::Mesh &mesh = model->meshes.emplace_back();
    mesh::setPositions(mesh, mesh::originFor(box), positions);
    mesh.indices.assign(triangles.begin(), triangles.end());
    model->bounds = mesh::boundsOf(model->meshes);
    opening::OpenedScene opened;
    opened.name = name;
    opened.objects.push_back({name, {}, std::move(model), {}});
    return SceneAccess::make(std::move(opened), setup);
}

const Setup &Scene::setup() const
{
    return m_data->setup;
}

Result<Setup> Scene::setupAt(int width, int height) const
{
    const geometry::Surface surface{width, height, 1.0};
    if (const geometry::Check valid = check(surface); !valid)
        return valueError(valid.error());
    opening::OpenedScene opened = m_data->opened;
    const bool isOfArrays = !opened.file && opened.objects.front().file.empty();
    if (isOfArrays)
        opened.file = fileOf(m_data->setup);
    const auto setup = opening::setupOf(opened, surface);
    if (!setup)
        return publicError(setup.error());
    return SetupAccess::make(*setup);
}

const std::vector<SceneObject> &Scene::objects() const
{
    return m_data->objects;
}

Result<std::monostate> Scene::save(const std::filesystem::path &file) const
{
    scene_file::SceneFile scene;
    if (m_data->opened.file) {
        scene = *m_data->opened.file;
        scene.objects.clear();
    } else {
        scene = fileOf(m_data->setup);
    }
    for (std::size_t i = 0; i < m_data->opened.objects.size(); ++i) {
        const scene::SceneObject &object = m_data->opened.objects[i];
        if (m_data->opened.file && !m_data->opened.file->objects[i].bundled.empty()) {
            scene.objects.push_back(m_data->opened.file->objects[i]);
            continue;
        }
        if (object.file.empty())
            return valueError(object.name + ": "
                              + base::tr("the mesh comes from arrays; write it to a model file first"));
        scene.objects.push_back(scene_file::sceneFileObject(object, file));
    }
    const auto written = scene_file::writeSceneFile(file, scene);
    if (!written)
        return publicError(written.error());
    return std::monostate{};
}

struct Picker::Data {
    Scene scene; ///< keeps the models
    std::shared_ptr<const ray::SceneRays> rays;
};

namespace {

Hit noHit()
{
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const glm::dvec3 none(kNaN);
    return {none, none, none, none, none, kNaN, none, none, -1, -1, {-1, -1, -1}, -1, {-1, -1}, false, false, {}};
}

Hit publicHit(const ray::SceneHit &hit)
{
    Hit result = noHit();
    result.isHit = true;
    result.world = hit.world.coordinates();
    result.uncertainty = hit.uncertainty.coordinates();
    result.objectPoint = hit.objectPoint.coordinates();
    result.distance = hit.distance;
    result.object = static_cast<std::int64_t>(hit.object);
    result.vertex = hit.vertex.id;
    result.vertexWorld = hit.vertex.world.coordinates();
    if (hit.triangle) {
        result.triangle = hit.triangle->triangle;
        result.barycentric = hit.triangle->barycentric;
        result.normal = hit.triangle->normal.coordinates();
        std::copy(hit.triangle->ids.begin(), hit.triangle->ids.end(), result.vertices);
        std::copy(hit.triangle->edge.ids.begin(), hit.triangle->edge.ids.end(), result.edge);
        result.edgeWorld = hit.triangle->edge.world.coordinates();
    }
    return result;
}

} // namespace

Result<Picker> Picker::of(const Scene &scene, const std::optional<Setup> &setup)
{
    const SceneAccess::Rays rays = SceneAccess::rays(scene, SetupAccess::of(setup.value_or(scene.setup())));
    if (!rays)
        return rays.error();
    return Picker(std::make_shared<const Data>(Data{scene, *rays}));
}

Hit Picker::at(double px, double py, Snap snap) const
{
    const geometry::DevicePoint position(px, py);
    if (m_data->rays->rays().isInPicture(position)) {
        if (const auto hit = m_data->rays->at(position, sameOf<ray::Snap>(snap)))
            return *hit ? publicHit(**hit) : noHit();
    }
    Hit none = noHit();
    none.isOutside = true;
    return none;
}

void Picker::operator()(const double *px, const double *py, Hit *hits, std::size_t count, Snap snap,
                        unsigned threads) const
{
    constexpr std::size_t kTask = 1024; // a few milliseconds
    base::inParallelRanges(
        count, kTask, {},
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                hits[i] = at(px[i], py[i], snap);
        },
        threads);
}

} // namespace unprojector
