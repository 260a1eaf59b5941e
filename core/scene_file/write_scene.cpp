#include "core/files/path_text.h"
#include "core/geometry/angle.h"
#include "core/scene_file/json_text.h"
#include "core/scene_file/scene_file.h"

namespace unprojector::scene_file {
using namespace geometry;
using namespace files;
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json vectorJson(const Vector &v)
{
    Json json = Json::array();
    for (int i = 0; i < v.length(); ++i)
        json.push_back(jsonNumber(v[i]));
    return json;
}

Json matrixJson(const glm::dmat4 &m)
{
    Json json = Json::array();
    for (int i = 0; i < 16; ++i)
        json.push_back(jsonNumber(m[i / 4][i % 4]));
    return json;
}

Json viewportJson(const Viewport &v)
{
    return {{"x", jsonNumber(v.x)},
            {"y", jsonNumber(v.y)},
            {"width", jsonNumber(v.width)},
            {"height", jsonNumber(v.height)}};
}

Json viewJson(const LookAt &view)
{
    return {{"eye", vectorJson(view.eye.coordinates())},
            {"center", vectorJson(view.center.coordinates())},
            {"up", vectorJson(view.up)}};
}

Json viewJson(const glm::dmat4 &eyeFromWorld)
{
    return {{"matrix", matrixJson(eyeFromWorld)}};
}

/// Adds the keys that this version does not know.
Json with(Json json, const Json &extra)
{
    if (extra.is_object()) {
        for (auto it = extra.begin(); it != extra.end(); ++it) {
            if (!json.contains(it.key()))
                json[it.key()] = *it;
        }
    }
    return json;
}

template <class Box>
Json boxJson(const char *type, const Box &b)
{
    return {{"type", type},
            {"left", jsonNumber(b.left)},
            {"right", jsonNumber(b.right)},
            {"bottom", jsonNumber(b.bottom)},
            {"top", jsonNumber(b.top)},
            {"near", jsonNumber(b.nearDistance)},
            {"far", jsonNumber(b.farDistance)}};
}

Json angleJson(double radians)
{
    return jsonNumber(degreesFromRadians(radians));
}

Json projectionJson(const SceneFile &scene)
{
    struct Visitor {
        bool aspectFromViewport;
        Json operator()(const Projection &p) const { return std::visit(*this, p); }
        Json operator()(const MatrixProjection &p) const
        {
            Json json = {{"type", "matrix"}, {"matrix", matrixJson(p.clipFromEye)}};
            if (p.ndcDepth)
                json["ndcDepth"] = {*p.ndcDepth == NdcDepth::ZeroToOne ? 0 : -1, 1};
            return json;
        }
        Json operator()(const Frustum &p) const { return boxJson("frustum", p); }
        Json operator()(const Ortho &p) const { return boxJson("ortho", p); }
        Json operator()(const Perspective &p) const
        {
            Json json = {{"type", "perspective"}, {"fovy", angleJson(p.verticalFovRadians)}};
            if (!aspectFromViewport)
                json["aspect"] = jsonNumber(p.aspect);
            json["near"] = jsonNumber(p.nearDistance);
            json["far"] = jsonNumber(p.farDistance);
            return json;
        }
        Json operator()(const Oblique &p) const
        {
            Json json = boxJson("oblique", p.box);
            json["theta"] = angleJson(p.thetaRadians);
            json["phi"] = angleJson(p.phiRadians);
            return json;
        }
    };
    return std::visit(Visitor{scene.aspectFromViewport}, scene.projection);
}

Json stepJson(const TransformStep &step)
{
    struct Visitor {
        Json operator()(const Translate &s) const { return {{"translate", vectorJson(s.offset)}}; }
        Json operator()(const Rotate &s) const
        {
            return {{"rotate", vectorJson(glm::dvec4(s.degrees, s.axis.x, s.axis.y, s.axis.z))}};
        }
        Json operator()(const Scale &s) const { return {{"scale", vectorJson(s.factors)}}; }
    };
    return std::visit(Visitor{}, step);
}

Json objectJson(const SceneFileObject &object)
{
    Json json = Json::object();
    json["name"] = object.name;
    if (object.file.empty())
        json["bundled"] = object.bundled;
    else
        json["file"] = utf8FromPath(object.file);
    json["transform"] = Json::array();
    for (const TransformStep &step : object.transform)
        json["transform"].push_back(stepJson(step));
    return with(std::move(json), object.extra);
}

Json uiJson(const SceneFileUi &ui)
{
    Json json = Json::object();
    if (ui.viewportRule) {
        const char *kind = "wholeWindow";
        switch (ui.viewportRule->kind) {
        case ViewportRule::Kind::WholeWindow: break;
        case ViewportRule::Kind::Fixed: kind = "fixed"; break;
        case ViewportRule::Kind::KeepAspect: kind = "keepAspect"; break;
        case ViewportRule::Kind::Quarter: kind = "quarter"; break;
        }
        json["viewportRule"] = {{"kind", kind},
                                {"aspect", jsonNumber(ui.viewportRule->aspect)},
                                {"fixed", viewportJson(ui.viewportRule->fixed)}};
    }
    if (ui.projectionFollowsViewport)
        json["projectionFollowsViewport"] = *ui.projectionFollowsViewport;
    if (ui.clipDistancesFitObjects)
        json["clipDistancesFitObjects"] = *ui.clipDistancesFitObjects;
    if (ui.home)
        json["home"] = viewJson(*ui.home);
    for (const ClipPlaneOff &off : ui.clipPlanesOff)
        json["clipPlanesOff"].push_back({{"place", off.place}, {"plane", vectorJson(off.plane)}});
    return json;
}

Json documentJson(const SceneFile &scene)
{
    Json json = Json::object();
    json["unprojector"] = 1;
    json["window"] = with({{"width", scene.windowWidth},
                           {"height", scene.windowHeight},
                           {"devicePixelRatio", jsonNumber(scene.devicePixelRatio)}},
                          scene.extra.window);
    if (scene.viewport)
        json["viewport"] = with(viewportJson(*scene.viewport), scene.extra.viewport);
    json["depthRange"] = vectorJson(glm::dvec2(scene.depthRange.atNear, scene.depthRange.atFar));
    json["projection"] = with(projectionJson(scene), scene.extra.projection);
    json["view"] = with(std::visit([](const auto &view) { return viewJson(view); }, scene.view), scene.extra.view);
    json["objects"] = Json::array();
    for (const SceneFileObject &object : scene.objects)
        json["objects"].push_back(objectJson(object));
    json["clipPlanes"] = Json::array();
    for (const glm::dvec4 &plane : scene.clipPlanes)
        json["clipPlanes"].push_back(vectorJson(plane));
    if (Json ui = with(uiJson(scene.ui), scene.extra.ui); !ui.empty())
        json["ui"] = std::move(ui);
    return with(std::move(json), scene.extra.document);
}

bool isUtf8(const std::string &text)
{
    try {
        static_cast<void>(Json(text).dump());
        return true;
    } catch (const Json::type_error &) {
        return false;
    }
}

/// The key of the first name that is not UTF-8: of what a scene holds, only names come from outside JSON.
std::string keyOfBadName(const SceneFile &scene)
{
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const std::string object = "objects[" + std::to_string(i) + "]";
        if (!isUtf8(scene.objects[i].name))
            return object + ".name";
        if (!isUtf8(utf8FromPath(scene.objects[i].file)))
            return object + ".file";
        if (!isUtf8(scene.objects[i].bundled))
            return object + ".bundled";
    }
    return {};
}

} // namespace

Result<std::string, SceneFileError> sceneText(const SceneFile &scene)
{
    SceneFileError error;
    try {
        std::string text = readableJson(documentJson(scene));
        if (text.size() <= kMostSceneBytes)
            return text;
        error.code = SceneFileErrorCode::TooLarge;
        error.limit = double(kMostSceneBytes);
    } catch (const Json::type_error &) {
        error.code = SceneFileErrorCode::NotUtf8;
        error.keyPath = keyOfBadName(scene);
    }
    return error;
}

} // namespace unprojector::scene_file
