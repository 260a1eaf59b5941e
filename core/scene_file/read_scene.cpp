#include "core/files/path_text.h"
#include "core/geometry/angle.h"
#include "core/geometry/condition_number.h"
#include "core/scene_file/json_node.h"
#include "core/scene_file/scene_file.h"
#include "core/scene_file/strict_json.h"

#include <algorithm>
#include <cmath>

namespace unprojector::scene_file {
using namespace geometry;
using namespace files;
namespace {

constexpr int kVersion = 1;

/// Notes what core says of a value under the key that it is about.
void noteAt(const JsonNode &node, const char *key, const Error &cause)
{
    node.member(key).fail(cause);
}

/// Notes an error of one of the 16 numbers at its place.
void checkMatrix(const JsonNode &node, const glm::dmat4 &matrix)
{
    if (!node.failed() && std::isinf(conditionNumber(matrix)))
        node.fail(Error{ErrorCode::SingularMatrix});
}

glm::dmat4 matrixOf(const JsonNode &node)
{
    const JsonNode entries = node.member("matrix");
    const glm::dmat4 matrix = entries.matrix();
    checkMatrix(entries, matrix);
    return matrix;
}

std::optional<NdcDepth> ndcDepthOf(const JsonNode &node)
{
    const std::vector<JsonNode> ends = node.elements(2, JsonKind::Array);
    if (node.failed())
        return std::nullopt;
    const double low = ends[0].number(), high = ends[1].number();
    if (node.failed())
        return std::nullopt;
    if (high == 1.0 && low == 0.0)
        return NdcDepth::ZeroToOne;
    if (high == 1.0 && low == -1.0)
        return NdcDepth::MinusOneToOne;
    SceneFileError error;
    error.code = SceneFileErrorCode::UnknownChoice;
    error.foundKind = JsonKind::Array;
    error.found = node.shown();
    error.choices = {"[-1, 1]", "[0, 1]"};
    node.fail(std::move(error));
    return std::nullopt;
}

LookAt lookAtOf(const JsonNode &node)
{
    const LookAt view{WorldPoint(node.member("eye").vector3()), WorldPoint(node.member("center").vector3()),
                      node.member("up").vector3()};
    if (node.failed())
        return view;
    if (const Result<EyeFrame> frame = eyeFrame(view); !frame) {
        const bool isUp =
            frame.error().code == ErrorCode::UpIsZero || frame.error().code == ErrorCode::UpParallelToView;
        noteAt(node, isUp ? "up" : "center", frame.error());
    }
    return view;
}

Viewport viewportOf(const JsonNode &node)
{
    const Viewport viewport{node.member("x").number(), node.member("y").number(), node.member("width").number(),
                            node.member("height").number()};
    if (node.failed())
        return viewport;
    if (const Check valid = check(viewport); !valid)
        noteAt(node, viewport.width > 0.0 ? "height" : "width", valid.error());
    return viewport;
}

/// The key of a projection's object that an error is about.
const char *keyOf(const Error &error, const Projection &projection)
{
    switch (error.code) {
    case ErrorCode::LeftEqualsRight: return "left";
    case ErrorCode::BottomEqualsTop: return "bottom";
    case ErrorCode::FieldOfViewOutOfRange: return "fovy";
    case ErrorCode::AspectNotPositive: return "aspect";
    case ErrorCode::ShearAngleOutOfRange: {
        const auto *oblique = std::get_if<Oblique>(&projection);
        return oblique && oblique->thetaRadians == error.value ? "theta" : "phi";
    }
    default: return "near"; // near not above 0, not before far
    }
}

std::variant<Projection, MatrixProjection> projectionOf(const JsonNode &node, double viewportAspect,
                                                        bool &aspectFromViewport)
{
    const auto number = [&node](const char *key) { return node.member(key).number(); };
    const auto box = [&number] {
        return Ortho{number("left"), number("right"), number("bottom"), number("top"), number("near"), number("far")};
    };
    Projection projection;
    const JsonNode typeNode = node.member("type");
    const std::string type = typeNode.text();
    if (type == "frustum") {
        const Ortho b = box();
        projection = Frustum{b.left, b.right, b.bottom, b.top, b.nearDistance, b.farDistance};
    } else if (type == "ortho") {
        projection = box();
    } else if (type == "perspective") {
        const double fovy = number("fovy");
        const std::optional<JsonNode> aspect = node.optionalMember("aspect");
        aspectFromViewport = !aspect;
        projection = Perspective{radiansFromDegrees(fovy), aspect ? aspect->number() : viewportAspect, number("near"),
                                 number("far")};
    } else if (type == "oblique") {
        const Ortho b = box();
        projection = Oblique{b, radiansFromDegrees(number("theta")), radiansFromDegrees(number("phi"))};
    } else if (type == "matrix") {
        const auto depth = node.optionalMember("ndcDepth");
        return MatrixProjection{matrixOf(node), depth ? ndcDepthOf(*depth) : std::nullopt};
    } else if (!node.failed()) {
        SceneFileError error;
        error.code = SceneFileErrorCode::UnknownChoice;
        error.found = shortened(type);
        error.choices = {"frustum", "ortho", "perspective", "oblique", "matrix"};
        typeNode.fail(error);
    }
    if (node.failed())
        return projection;
    if (const Check valid = check(projection); !valid)
        noteAt(node, keyOf(valid.error(), projection), valid.error());
    return projection;
}

TransformStep stepOf(const JsonNode &node)
{
    TransformStep step;
    const std::string kind = node.oneKeyOf({"translate", "rotate", "scale"});
    if (kind.empty())
        return step;
    const JsonNode value = node.member(kind.c_str());
    if (kind == "translate") {
        step = Translate{value.vector3()};
    } else if (kind == "scale") {
        step = Scale{value.vector3()};
    } else {
        const glm::dvec4 v = value.vector4();
        step = Rotate{v.x, {v.y, v.z, v.w}};
    }
    if (const Check valid = check(step); !valid)
        value.fail(valid.error());
    return step;
}

std::filesystem::path fileOf(const JsonNode &node)
{
    const std::string text = node.text();
    if (node.failed())
        return {};
    if (text.empty() || text.find('\0') != std::string::npos) {
        node.fail(SceneFileErrorCode::BadFileName);
        return {};
    }
    return pathFromUtf8(text);
}

SceneFileObject objectOf(const JsonNode &node)
{
    SceneFileObject object;
    if (const auto name = node.optionalMember("name"))
        object.name = name->text();
    const auto file = node.optionalMember("file");
    const auto bundled = node.optionalMember("bundled");
    if (!node.failed() && file.has_value() == bundled.has_value()) {
        SceneFileError error;
        error.code = file ? SceneFileErrorCode::NotOneChoice : SceneFileErrorCode::Missing;
        error.keyPath = file ? node.path() : node.path() + ".file";
        error.choices = {"file", "bundled"};
        node.fail(error);
    }
    if (file)
        object.file = fileOf(*file);
    if (bundled) {
        object.bundled = bundled->text();
        if (object.bundled.empty())
            bundled->fail(SceneFileErrorCode::BadFileName);
    }
    if (const auto transform = node.optionalMember("transform")) {
        for (const JsonNode &step : transform->elements()) {
            if (step.failed())
                break;
            object.transform.push_back(stepOf(step));
        }
    }
    object.extra = node.except({"name", "file", "bundled", "transform"});
    return object;
}

glm::dvec4 clipPlaneOf(const JsonNode &node)
{
    const glm::dvec4 plane = node.vector4();
    if (!node.failed() && plane.x == 0.0 && plane.y == 0.0 && plane.z == 0.0)
        node.fail(Error{ErrorCode::ClipPlaneHasNoNormal});
    return plane;
}

std::vector<JsonNode> atMost(const JsonNode &node, std::size_t limit)
{
    std::vector<JsonNode> elements = node.elements();
    if (elements.size() <= limit)
        return elements;
    SceneFileError error;
    error.code = SceneFileErrorCode::TooMany;
    error.value = double(elements.size());
    error.limit = double(limit);
    node.fail(std::move(error));
    return {};
}

ViewportRule viewportRuleOf(const JsonNode &node)
{
    ViewportRule rule;
    const JsonNode kindNode = node.member("kind");
    const std::string kind = kindNode.text();
    if (kind == "wholeWindow") {
        rule.kind = ViewportRule::Kind::WholeWindow;
    } else if (kind == "fixed") {
        rule.kind = ViewportRule::Kind::Fixed;
    } else if (kind == "keepAspect") {
        rule.kind = ViewportRule::Kind::KeepAspect;
    } else if (kind == "quarter") {
        rule.kind = ViewportRule::Kind::Quarter;
    } else if (!node.failed()) {
        SceneFileError error;
        error.code = SceneFileErrorCode::UnknownChoice;
        error.found = shortened(kind);
        error.choices = {"wholeWindow", "fixed", "keepAspect", "quarter"};
        kindNode.fail(std::move(error));
    }
    if (const auto aspect = node.optionalMember("aspect")) {
        rule.aspect = aspect->number();
        if (!node.failed() && !(rule.aspect > 0.0))
            aspect->fail(Error{ErrorCode::AspectNotPositive, rule.aspect});
    }
    if (const auto fixed = node.optionalMember("fixed"))
        rule.fixed = viewportOf(*fixed);
    return rule;
}

SceneFileUi uiOf(const JsonNode &node, std::size_t cuttingPlanes)
{
    SceneFileUi ui;
    node.mustBeObject();
    if (const auto rule = node.optionalMember("viewportRule"))
        ui.viewportRule = viewportRuleOf(*rule);
    if (const auto follows = node.optionalMember("projectionFollowsViewport"))
        ui.projectionFollowsViewport = follows->boolean();
    if (const auto fits = node.optionalMember("clipDistancesFitObjects"))
        ui.clipDistancesFitObjects = fits->boolean();
    if (const auto home = node.optionalMember("home"))
        ui.home = lookAtOf(*home);
    if (const auto planes = node.optionalMember("clipPlanesOff")) {
        const std::vector<JsonNode> nodes = atMost(*planes, kMostClipPlanes - cuttingPlanes);
        const int places = static_cast<int>(cuttingPlanes + nodes.size());
        for (const JsonNode &plane : nodes) {
            const int place = plane.member("place").count(0, places - 1);
            ui.clipPlanesOff.push_back({static_cast<std::size_t>(place), clipPlaneOf(plane.member("plane"))});
        }
    }
    return ui;
}

void readWindow(const JsonNode &node, SceneFile &scene)
{
    scene.windowWidth = node.member("width").count(1, kMostWindowPixels);
    scene.windowHeight = node.member("height").count(1, kMostWindowPixels);
    if (const auto ratio = node.optionalMember("devicePixelRatio")) {
        scene.devicePixelRatio = ratio->number();
        if (node.failed())
            return;
        // Of the smaller side at least one device pixel must be left, of the larger one no more than there may be.
        const int shorter = std::min(scene.windowWidth, scene.windowHeight);
        const int longer = std::max(scene.windowWidth, scene.windowHeight);
        if (!(scene.devicePixelRatio > 0.0))
            ratio->fail(Error{ErrorCode::PixelRatioNotPositive, scene.devicePixelRatio});
        else
            static_cast<void>(ratio->numberBetween(0.5 / shorter, double(kMostWindowPixels) / longer));
    }
    scene.extra.window = node.except({"width", "height", "devicePixelRatio"});
}

SceneFile sceneOf(const JsonNode &root)
{
    SceneFile scene;
    const JsonNode version = root.member("unprojector");
    if (const double found = version.number(); !root.failed() && found != kVersion) {
        SceneFileError error;
        error.code = SceneFileErrorCode::UnknownVersion;
        error.value = found;
        error.limit = kVersion;
        version.fail(std::move(error));
    }
    readWindow(root.member("window"), scene);
    if (const auto viewport = root.optionalMember("viewport")) {
        scene.viewport = viewportOf(*viewport);
        scene.extra.viewport = viewport->except({"x", "y", "width", "height"});
    }
    if (const auto range = root.optionalMember("depthRange")) {
        const std::vector<JsonNode> ends = range->elements(2, JsonKind::Array);
        if (!root.failed())
            scene.depthRange = {ends[0].number(), ends[1].number()};
        if (const Check valid = check(scene.depthRange); !valid)
            range->fail(valid.error());
    }
    if (root.failed())
        return scene;

    const Surface surface = surfaceFromWidget(scene.windowWidth, scene.windowHeight, scene.devicePixelRatio);
    const Viewport viewport = scene.viewport.value_or(wholeSurface(surface));
    const JsonNode projection = root.member("projection");
    scene.projection = projectionOf(projection, viewport.width / viewport.height, scene.aspectFromViewport);
    scene.extra.projection = projection.except({"type", "left", "right", "bottom", "top", "near", "far", "fovy",
                                                "aspect", "theta", "phi", "matrix", "ndcDepth"});
    const JsonNode view = root.member("view");
    if (view.optionalMember("matrix"))
        scene.view = matrixOf(view);
    else
        scene.view = lookAtOf(view);
    scene.extra.view = view.except({"eye", "center", "up", "matrix"});

    if (const auto objects = root.optionalMember("objects")) {
        for (const JsonNode &object : objects->elements()) {
            if (root.failed())
                break;
            scene.objects.push_back(objectOf(object));
        }
    }
    if (const auto planes = root.optionalMember("clipPlanes")) {
        for (const JsonNode &plane : atMost(*planes, kMostClipPlanes))
            scene.clipPlanes.push_back(clipPlaneOf(plane));
    }
    if (const auto ui = root.optionalMember("ui")) {
        scene.ui = uiOf(*ui, scene.clipPlanes.size());
        scene.extra.ui = ui->except(
            {"viewportRule", "projectionFollowsViewport", "clipDistancesFitObjects", "home", "clipPlanesOff"});
    }
    scene.extra.document = root.except(
        {"unprojector", "window", "viewport", "depthRange", "projection", "view", "objects", "clipPlanes", "ui"});
    return scene;
}

} // namespace

Result<SceneFile, SceneFileError> parseScene(std::string_view text, const std::string &name)
{
    const Result<nlohmann::ordered_json, SceneFileError> json = parseStrictJson(text);
    JsonNode::FirstError error;
    if (!json)
        error = json.error();
    else if (SceneFile scene = sceneOf(JsonNode(*json, error)); !error)
        return scene;
    error->file = name;
    return *error;
}

} // namespace unprojector::scene_file
