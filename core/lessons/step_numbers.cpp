#include "core/lessons/step_numbers.h"

#include "core/base/expression.h"
#include "core/base/json.h"
#include "core/base/path_text.h"
#include "core/geometry/error_text.h"
#include "core/opening/models.h"
#include "core/pipeline/matrix_factors.h"
#include "core/pipeline/pipeline.h"
#include "core/ray/mesh_point.h"
#include "core/scene_file/scene_file.h"
#include "core/unproject/unprojector.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace unprojector::lessons {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

using Json = nlohmann::ordered_json;
using pipeline::Pipeline;
using pipeline::PipelinePoints;
using unproject::Method;

constexpr std::array kStageNames{"model", "view", "projection", "viewport", "modelview", "whole"};

template <class T>
using Expected = base::Expected<T, base::Error>;

base::Error failed(const std::string &where, const std::string &reason)
{
    return {.text = reason, .subject = where};
}

/// The matrix as JSON, row by row.
Json rowsOf(const glm::dmat4 &matrix)
{
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
    return rows;
}

Json rowsOf(const std::vector<pipeline::MatrixFactor> &factors)
{
    Json rows = Json::array();
    for (const pipeline::MatrixFactor &factor : factors)
        rows.push_back(rowsOf(factor.matrix));
    return rows;
}

template <class Space>
void put(Json &tree, const char *name, const Result<Point<Space>> &point)
{
    constexpr std::array kAxes{"x", "y", "z", "w"};
    if (!point)
        return;
    for (int i = 0; i < Space::kDimension; ++i)
        tree[name][kAxes[static_cast<std::size_t>(i)]] = point->coordinates()[i];
}

/// @pre the pipeline's setup is valid
Json treeOf(const Pipeline &pipeline, const PipelinePoints &points)
{
    Json tree = Json::object();
    for (std::size_t i = 0; i < kStageNames.size(); ++i)
        tree[kStageNames[i]] = rowsOf(pipeline.forward[i]);
    put(tree, "object", points.object);
    put(tree, "world", points.world);
    put(tree, "eye", points.eye);
    put(tree, "clip", points.clip);
    put(tree, "ndc", points.ndc);
    put(tree, "window", points.window);
    put(tree, "device", points.device);
    put(tree, "widget", points.widget);
    if (points.device)
        tree["pixel"] = {std::floor(points.device->x), std::floor(points.device->y)};
    const Result<unproject::Unprojector> unprojector = unproject::Unprojector::of(pipeline.setup);
    if (points.window && unprojector) {
        const unproject::Unprojected back = unprojector->at(*points.window);
        put(tree, "formula", back.world[Method::Formula]);
        put(tree, "inverse", back.world[Method::Matrix]);
    }
    return tree;
}

/// The pipeline of an object of the scene.
/// @param object  its name; if empty, the model matrix is the identity
Expected<Pipeline> pipelineOf(const Scene &scene, const Setup &setup, const std::string &object,
                              const std::string &where)
{
    glm::dmat4 worldFromObject(1.0);
    if (!object.empty()) {
        const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                        [&](const SceneObject &one) { return one.name == object; });
        if (found == scene.objects.end())
            return failed(where, "the scene has no object \"" + object + "\"");
        worldFromObject = geometry::worldFromObject(found->transform);
    }
    const Result<Pipeline> made = pipeline::pipelineOf(setup, worldFromObject);
    if (!made)
        return failed(where, geometry::errorText(made.error()));
    return *made;
}

Expected<Json> treeOf(const Scene &scene, const Setup &setup, const GivenPoint &point, const std::string &where)
{
    const Expected<Pipeline> pipeline = pipelineOf(scene, setup, point.object, where);
    if (!pipeline)
        return pipeline.error();
    return treeOf(*pipeline, pipeline::pointsFrom(*pipeline, point));
}

/// The result of a click on a pixel.
Expected<Json> treeOf(const Scene &scene, const Setup &setup, const ClickedPixel &clicked, const std::string &where)
{
    const Result<unproject::Unprojector> unprojector = unproject::Unprojector::of(setup);
    if (!unprojector)
        return failed(where, geometry::errorText(unprojector.error()));
    std::vector<std::shared_ptr<const ray::RayCaster>> casters;
    for (const SceneObject &object : scene.objects)
        casters.push_back(ray::RayCaster::build(object.model, {}));
    const auto rays = std::make_shared<const ray::SceneRays>(*unprojector, scene.objects, casters, scene.clipPlanes);
    const DevicePoint center = pixelCenter(clicked.pixel);
    const auto hit = rays->at(center, clicked.snap);
    const std::optional<WorldPoint> surface = ray::MeshPoint(rays)(center);
    if (!hit || !*hit || (clicked.snap == ray::Snap::Surface && !surface))
        return failed(where, "at the pixel there is no surface");
    const Expected<Pipeline> pipeline = pipelineOf(scene, setup, scene.objects[(*hit)->object].name, where);
    if (!pipeline)
        return pipeline.error();
    if (clicked.snap == ray::Snap::Surface) {
        const Result<WindowPoint> seen = windowFromWorld(setup, *surface);
        if (!seen)
            return failed(where, geometry::errorText(seen.error()));
        return treeOf(*pipeline, pipeline::pointsBackward(*pipeline, windowFromDevice(setup.surface, center, seen->z)));
    }
    const WorldPoint &taken = clicked.snap == ray::Snap::Vertex ? (*hit)->vertex.world : (*hit)->world;
    return treeOf(*pipeline, pipeline::pointsForward(*pipeline, taken));
}

/// All numbers under a node, in their order.
void flatten(const Json &node, std::vector<double> &numbers)
{
    if (base::isJsonNumber(node))
        numbers.push_back(base::valueOfJsonNumber(node));
    for (const Json &child : node.is_structured() ? node : Json::array())
        flatten(child, numbers);
}

/// Follows one step along a path: a key before "." or "[", or an index in brackets.
/// @return null if there is no such node
const Json *follow(const Json *node, std::string_view &path)
{
    if (path.front() == '[') {
        const std::size_t close = path.find(']');
        if (close == std::string_view::npos)
            return nullptr;
        std::size_t index = 0;
        const auto read = std::from_chars(path.data() + 1, path.data() + close, index);
        const bool isIndex = read.ec == std::errc() && read.ptr == path.data() + close;
        path.remove_prefix(close + 1);
        return isIndex && node->is_array() && index < node->size() ? &(*node)[index] : nullptr;
    }
    if (path.front() == '.')
        path.remove_prefix(1);
    const std::string key(path.substr(0, path.find_first_of(".[")));
    path.remove_prefix(key.size());
    const auto found = node->is_object() ? node->find(key) : node->end();
    return found == node->end() ? nullptr : &*found;
}

} // namespace

Expected<Scene> sceneOf(const Step &step)
{
    const std::string where = step.id + ".scene";
    const scene_file::SceneOrError file = scene_file::parseScene(base::compactJson(step.scene.json()), where);
    if (!file)
        return file.error();
    auto objects = opening::objectsOf(*file, {}, [](const std::filesystem::path &model) {
        return opening::ReadModel(
            base::Error{.text = "a lesson has no files except its own", .file = base::utf8FromPath(model)});
    });
    if (!objects)
        return failed(where, objects.error().message());
    auto scene = scene_file::sceneFromFile(*file, {}, std::move(objects).value());
    if (!scene)
        return failed(where + ": " + scene.error().subject, scene.error().text);
    return std::move(scene).value();
}

Surface surfaceOf(const Step &step, const Surface &surface)
{
    return step.view ? Surface{step.view->x, step.view->y, surface.devicePixelRatio} : surface;
}

Expected<StepNumbers> StepNumbers::of(const Scene &scene, const Surface &surface,
                                      const std::map<std::string, StepPoint> &points,
                                      const std::map<std::string, base::JsonValue> &changes)
{
    const Result<Setup> setup = setupOf(scene, surface, {});
    if (!setup)
        return failed("scene", geometry::errorText(setup.error()));
    StepNumbers numbers;
    GivenPoint followed = scene.givenPoint.value_or(GivenPoint{});
    if (followed.object.empty() && !scene.objects.empty() && !scene.givenPoint)
        followed.object = scene.objects.front().name;
    Expected<Json> tree = treeOf(scene, *setup, followed, "point");
    if (!tree)
        return tree.error();
    Json &all = numbers.m_tree.edit();
    all = std::move(tree).value();
    if (!scene.givenPoint) { // the matrices are there anyway
        for (const char *space :
             {"object", "world", "eye", "clip", "ndc", "window", "device", "widget", "pixel", "formula", "inverse"})
            all.erase(space);
    }
    if (setup->isByParameters()) {
        const auto view = pipeline::factors(setup->camera());
        const auto projection = pipeline::factors(setup->projection());
        if (view && projection) {
            all["viewSteps"] = rowsOf(*view);
            all["projectionSteps"] = rowsOf(*projection);
        }
    }
    const auto file = scene_file::sceneText(scene_file::sceneFileFrom(scene, *setup, {}));
    if (!file)
        return file.error();
    all["surface"] = {
        {"width", surface.widthPixels}, {"height", surface.heightPixels}, {"ratio", surface.devicePixelRatio}};
    all["scene"] = Json::parse(*file);
    for (const auto &[name, change] : changes)
        all["set"][name] = change.json();
    for (const auto &[name, point] : points) {
        Expected<Json> one = std::visit(
            [&, where = "points." + name](const auto &given) { return treeOf(scene, *setup, given, where); }, point);
        if (!one)
            return one.error();
        all[name] = std::move(one).value();
    }
    return numbers;
}

std::vector<double> StepNumbers::at(std::string_view path) const
{
    const Json *const root = &m_tree.json();
    const Json *node = root;
    while (node && !path.empty())
        node = follow(node, path);
    std::vector<double> numbers;
    if (node && node != root)
        flatten(*node, numbers);
    return numbers;
}

std::optional<DevicePixel> StepNumbers::pixelOf(const std::string &point) const
{
    const std::vector<double> pixel = at(point == "point" ? "pixel" : point + ".pixel"), width = at("surface.width"),
                              height = at("surface.height");
    // Check before the conversion to integers: a point close to the eye's plane can be too far off
    // for one, or not a number.
    if (pixel.size() != 2 || !(pixel[0] >= 0.0 && pixel[0] < width.front())
        || !(pixel[1] >= 0.0 && pixel[1] < height.front()))
        return std::nullopt;
    return DevicePixel{static_cast<int>(pixel[0]), static_cast<int>(pixel[1])};
}

Expected<LessonNumbers> LessonNumbers::of(const Lesson &lesson, const Surface &surface)
{
    LessonNumbers numbers;
    for (const Step &step : lesson.steps) {
        const Expected<Scene> scene = sceneOf(step);
        if (!scene)
            return failed(lesson.name + ".json", scene.error().message());
        Expected<StepNumbers> made = StepNumbers::of(*scene, surfaceOf(step, surface), step.points, step.changes);
        if (!made)
            return failed(lesson.name + ".json: " + step.id, made.error().message());
        numbers.m_steps.emplace(step.id, std::move(made).value());
    }
    return numbers;
}

std::vector<double> LessonNumbers::at(const std::string &step, std::string_view path) const
{
    const std::size_t colon = path.find(':');
    const std::string of = colon == std::string_view::npos ? step : std::string(path.substr(0, colon));
    const auto found = m_steps.find(of);
    return found == m_steps.end() ? std::vector<double>()
                                  : found->second.at(colon == std::string_view::npos ? path : path.substr(colon + 1));
}

std::vector<double> LessonNumbers::values(const std::string &step, std::string_view source) const
{
    if (std::vector<double> list = at(step, source); !list.empty())
        return list;
    constexpr std::string_view kQuoted = "quoted ";
    bool hasPath = source.starts_with(kQuoted);
    if (hasPath)
        source.remove_prefix(kQuoted.size());
    const auto named = [&](std::string_view path) -> std::optional<double> {
        hasPath = true;
        const std::vector<double> numbers = at(step, path);
        return numbers.size() == 1 ? std::optional(numbers.front()) : std::nullopt;
    };
    const auto value = base::evaluate(source, named);
    return value && hasPath ? std::vector{*value} : std::vector<double>();
}

} // namespace unprojector::lessons
