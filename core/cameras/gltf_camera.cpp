#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

// The cameras of glTF files, and those of pyrender and trimesh, which take glTF's.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

/// The JSON of a .glb file; the text itself for any other.
std::string jsonOf(const std::string &text)
{
    constexpr std::size_t kHeader = 20; // magic, version, length; the chunk's length and type
    if (!text.starts_with("glTF") || text.size() < kHeader)
        return text;
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
        length |= std::size_t(static_cast<unsigned char>(text[12 + i])) << (8 * i);
    return text.substr(kHeader, length);
}

std::optional<std::size_t> indexIn(const Json &value, std::size_t count)
{
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count)
        return std::nullopt;
    return std::size_t(value.get<std::uint64_t>());
}

/// The node's own transform: its matrix, or translation, rotation and scale.
std::optional<glm::dmat4> transformOf(const Json &node)
{
    if (memberOf(node, "matrix"))
        return matrixByColumns(numbersOf(node, "matrix"));
    const auto numbers = [&node](const char *key, std::vector<double> otherwise) {
        return memberOf(node, key) ? numbersOf(node, key) : std::move(otherwise);
    };
    const std::vector<double> t = numbers("translation", {0, 0, 0}), q = numbers("rotation", {0, 0, 0, 1}),
                              s = numbers("scale", {1, 1, 1});
    if (t.size() != 3 || q.size() != 4 || s.size() != 3)
        return std::nullopt;
    const auto rotation = rotationOf(q[3], q[0], q[1], q[2]);
    if (!rotation)
        return std::nullopt;
    glm::dmat4 m = rigid(*rotation, {t[0], t[1], t[2]});
    for (int i = 0; i < 3; ++i)
        m[i] *= s[std::size_t(i)];
    return m;
}

/// @param parents  of each node; the number of nodes for a root
/// @param line     of the cameras
glm::dmat4 worldFromNode(const Reading &reading, const Json &nodes, const std::vector<std::size_t> &parents,
                         std::size_t node, std::size_t line)
{
    glm::dmat4 worldFromCamera(1.0);
    std::size_t steps = 0;
    for (std::size_t i = node; i < nodes.size(); i = parents[i]) {
        const std::optional<glm::dmat4> own = transformOf(nodes[i]);
        if (!own)
            reading.fail(tr("the transform of the node %1 is incomplete; it needs 16 numbers of a matrix, or "
                            "translation, rotation and scale",
                            nameOf(nodes[i], "name", i)),
                         line);
        worldFromCamera = *own * worldFromCamera;
        if (++steps > nodes.size())
            reading.fail(tr("the node %1 is its own parent", nameOf(nodes[node], "name", node)), line);
    }
    return worldFromCamera;
}

void readLens(Reading &reading, const Json &lens, std::size_t line)
{
    if (const Json *perspective = memberOf(lens, "perspective")) {
        const auto angle = numberOf(*perspective, "yfov");
        if (!angle)
            reading.fail(tr("the camera has no yfov"), line);
        reading.camera.nearDistance = numberOf(*perspective, "znear");
        reading.camera.farDistance = numberOf(*perspective, "zfar");
        reading.setVerticalAngle(*angle, numberOf(*perspective, "aspectRatio"));
        return;
    }
    const Json *box = memberOf(lens, "orthographic");
    const auto number = [box](const char *key) { return box ? numberOf(*box, key) : std::nullopt; };
    const auto x = number("xmag"), y = number("ymag"), n = number("znear"), f = number("zfar");
    if (!x || !y || !n || !f)
        reading.fail(tr("the camera needs perspective with yfov, or orthographic with xmag, ymag, znear and zfar"),
                     line);
    reading.setProjection(Ortho{-*x, *x, -*y, *y, *n, *f}, line);
}

} // namespace

bool readGltf(Reading &reading)
{
    const NamedText text{reading.text.name, jsonOf(reading.text.text)};
    if (!isJson(text.text) || text.text.find("\"cameras\"") == text.text.npos
        || text.text.find("\"asset\"") == text.text.npos)
        return false;
    const Json file = parsedJson(text);
    const Json *nodes = memberOf(file, "nodes"), *cameras = memberOf(file, "cameras");
    if (!nodes || !nodes->is_array() || !cameras || !cameras->is_array())
        return false;
    ForeignCamera &camera = reading.camera;
    std::vector<std::size_t> parents(nodes->size(), nodes->size()), withCamera;
    for (std::size_t i = 0; i < nodes->size(); ++i) {
        const Json &node = (*nodes)[i];
        if (const Json *children = memberOf(node, "children"); children && children->is_array()) {
            for (const Json &child : *children) {
                if (const auto index = indexIn(child, nodes->size()))
                    parents[*index] = i;
            }
        }
        if (const Json *lens = memberOf(node, "camera"); lens && indexIn(*lens, cameras->size())) {
            withCamera.push_back(i);
            camera.images.push_back(nameOf(node, "name", i));
        }
    }
    if (withCamera.empty())
        return false;
    reading.begin("glTF", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    reading.chooseImage();
    const std::size_t node = withCamera[camera.image], line = lineOfKey(text.text, "cameras");
    camera.pose = worldFromNode(reading, *nodes, parents, node, line);
    readLens(reading, (*cameras)[*indexIn((*nodes)[node]["camera"], cameras->size())], line);
    return true;
}

bool readPyrender(Reading &reading)
{
    const NamedValues &values = reading.values();
    const bool isTrimesh = values.has({"cameratransform"}) && values.has({"fov"});
    const auto matrix = values.numbers({"cameratransform", "camerapose", "pose", "matrix", "transform"}, 1);
    if (!isTrimesh && (!values.has({"yfov"}) || matrix.empty()))
        return false;
    ForeignCamera &camera = reading.camera;
    reading.begin(isTrimesh ? "trimesh" : "pyrender", PoseDirection::CameraToWorld, EyeAxes::RightUpBack);
    camera.pose = matrix.size() == 16 ? matrixByRows(matrix) : std::nullopt;
    if (!camera.pose)
        reading.fail(tr("%1 needs %2 numbers; it has %3", "camera_pose", 16, matrix.size()));
    camera.size = sizeIn(values);
    camera.nearDistance = values.number({"znear"});
    camera.farDistance = values.number({"zfar"});
    if (isTrimesh) {
        const std::vector<double> angles = values.numbers({"fov"}, 2); // across and down, degrees
        if (angles.size() != 2)
            reading.fail(tr("%1 needs %2 numbers; it has %3", "fov", 2, angles.size()));
        reading.setVerticalAngle(radiansFromDegrees(angles[1]), std::tan(radiansFromDegrees(angles[0]) / 2.0)
                                                                    / std::tan(radiansFromDegrees(angles[1]) / 2.0));
        return true;
    }
    const auto angle = values.number({"yfov"});
    if (!angle)
        reading.fail(tr("yfov has no number; give it in radians"));
    reading.setVerticalAngle(*angle, values.number({"aspectratio"}));
    return true;
}

} // namespace unprojector::cameras
