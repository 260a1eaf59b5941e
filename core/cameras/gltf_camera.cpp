#include "core/base/translation.h"
#include "core/cameras/camera_json.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/reader_parts.h"
#include "core/geometry/error_text.h"
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

ForeignCamera cameraOf(const char *program)
{
    ForeignCamera camera;
    camera.program = program;
    camera.direction = PoseDirection::CameraToWorld;
    camera.axes = EyeAxes::RightUpBack;
    camera.isDirectionCertain = camera.areAxesCertain = true;
    return camera;
}

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

class GltfReader {
public:
    GltfReader(const NamedText &text, const Json &file, const CameraChoices &choices)
        : m_text(text), m_file(file), m_choices(choices)
    {
    }

    CameraRead read()
    {
        const Json *nodes = memberOf(m_file, "nodes");
        m_cameras = memberOf(m_file, "cameras");
        if (!nodes || !nodes->is_array() || !m_cameras || !m_cameras->is_array())
            return std::nullopt;
        m_nodes = nodes;
        m_parents.assign(nodes->size(), nodes->size());
        std::vector<std::size_t> withCamera;
        for (std::size_t i = 0; i < nodes->size(); ++i) {
            const Json &node = (*nodes)[i];
            if (const Json *children = memberOf(node, "children"); children && children->is_array()) {
                for (const Json &child : *children) {
                    if (const auto index = indexIn(child, nodes->size()))
                        m_parents[*index] = i;
                }
            }
            if (const Json *camera = memberOf(node, "camera"); camera && indexIn(*camera, m_cameras->size())) {
                withCamera.push_back(i);
                m_camera.images.push_back(nameOf(node, i));
            }
        }
        if (withCamera.empty())
            return std::nullopt;
        if (auto error = chooseImage(m_camera, m_choices, m_text.name))
            return *error;
        const std::size_t node = withCamera[m_camera.image];
        if (auto error = readPose(node))
            return *error;
        if (auto error = readLens((*m_cameras)[*indexIn(*memberOf((*nodes)[node], "camera"), m_cameras->size())]))
            return *error;
        return m_camera;
    }

private:
    CameraError fault(std::string reason) const
    {
        return {m_text.name, lineOfKey(m_text.text, "cameras"), std::move(reason)};
    }

    static std::optional<std::size_t> indexIn(const Json &value, std::size_t count)
    {
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count)
            return std::nullopt;
        return std::size_t(value.get<std::uint64_t>());
    }

    static std::string nameOf(const Json &node, std::size_t index)
    {
        const Json *name = memberOf(node, "name");
        return name && name->is_string() ? name->get<std::string>() : std::to_string(index);
    }

    /// The node's own transform: its matrix, or translation, rotation and scale.
    std::optional<glm::dmat4> transformOf(const Json &node) const
    {
        const auto numbers = [&node](const char *key, std::vector<double> otherwise) {
            const Json *member = memberOf(node, key);
            return member ? numbersOf(*member).value_or(std::vector<double>()) : std::move(otherwise);
        };
        if (memberOf(node, "matrix"))
            return matrixByColumns(numbers("matrix", {}));
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

    std::optional<CameraError> readPose(std::size_t node)
    {
        glm::dmat4 worldFromCamera(1.0);
        std::size_t steps = 0;
        for (std::size_t i = node; i < m_nodes->size(); i = m_parents[i]) {
            const std::optional<glm::dmat4> own = transformOf((*m_nodes)[i]);
            if (!own)
                return fault(tr("the transform of the node %1 is incomplete; it needs 16 numbers of a matrix, or "
                                "translation, rotation and scale",
                                nameOf((*m_nodes)[i], i)));
            worldFromCamera = *own * worldFromCamera;
            if (++steps > m_nodes->size())
                return fault(tr("the node %1 is its own parent", nameOf((*m_nodes)[node], node)));
        }
        m_camera.pose = worldFromCamera;
        return std::nullopt;
    }

    std::optional<CameraError> readLens(const Json &lens)
    {
        if (const Json *perspective = memberOf(lens, "perspective")) {
            const auto angle = numberOf(*perspective, "yfov");
            if (!angle)
                return fault(tr("the camera has no yfov"));
            m_camera.nearDistance = numberOf(*perspective, "znear");
            m_camera.farDistance = numberOf(*perspective, "zfar");
            return setVerticalAngle(m_camera, m_choices, *angle, numberOf(*perspective, "aspectRatio"), m_text.name);
        }
        const Json *box = memberOf(lens, "orthographic");
        const auto number = [box](const char *key) { return box ? numberOf(*box, key) : std::nullopt; };
        const auto x = number("xmag"), y = number("ymag"), n = number("znear"), f = number("zfar");
        if (!x || !y || !n || !f)
            return fault(tr("the camera needs perspective with yfov, or orthographic with xmag, ymag, znear and zfar"));
        const Result<glm::dmat4> clip = clipFromEye(Projection(Ortho{-*x, *x, -*y, *y, *n, *f}));
        if (!clip)
            return fault(geometry::errorText(clip.error()));
        m_camera.projection = MatrixProjection{*clip, NdcDepth::MinusOneToOne};
        return std::nullopt;
    }

    const NamedText &m_text;
    const Json &m_file;
    const CameraChoices &m_choices;
    const Json *m_nodes = nullptr, *m_cameras = nullptr;
    std::vector<std::size_t> m_parents; ///< of each node; the number of nodes for a root
    ForeignCamera m_camera = cameraOf("glTF");
};

} // namespace

CameraRead readGltf(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        const NamedText part{text.name, jsonOf(text.text)};
        if (!isJson(part.text) || part.text.find("\"cameras\"") == part.text.npos
            || part.text.find("\"asset\"") == part.text.npos)
            continue;
        const auto json = parsedJson(part);
        if (!json)
            return json.error();
        if (CameraRead read = GltfReader(part, *json, choices).read())
            return read;
    }
    return std::nullopt;
}

CameraRead readPyrender(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        const NamedValues values(text.text);
        const bool isTrimesh = values.has({"cameratransform"}) && values.has({"fov"});
        const auto matrix = values.numbers({"cameratransform", "camerapose", "pose", "matrix", "transform"}, 1);
        if (!isTrimesh && (!values.has({"yfov"}) || matrix.empty()))
            continue;
        ForeignCamera camera = cameraOf(isTrimesh ? "trimesh" : "pyrender");
        camera.pose = matrix.size() == 16 ? matrixByRows(matrix) : std::nullopt;
        if (!camera.pose)
            return CameraError{text.name, 0, tr("%1 needs %2 numbers; it has %3", "camera_pose", 16, matrix.size())};
        camera.size = sizeIn(values);
        camera.nearDistance = values.number({"znear"});
        camera.farDistance = values.number({"zfar"});
        if (isTrimesh) {
            const std::vector<double> angles = values.numbers({"fov"}, 2); // across and down, degrees
            if (angles.size() != 2)
                return CameraError{text.name, 0, tr("%1 needs %2 numbers; it has %3", "fov", 2, angles.size())};
            if (auto error = setVerticalAngle(camera, choices, radiansFromDegrees(angles[1]),
                                              std::tan(radiansFromDegrees(angles[0]) / 2.0)
                                                  / std::tan(radiansFromDegrees(angles[1]) / 2.0),
                                              text.name))
                return *error;
            return camera;
        }
        const auto angle = values.number({"yfov"});
        if (!angle)
            return CameraError{text.name, 0, tr("yfov has no number; give it in radians")};
        if (auto error = setVerticalAngle(camera, choices, *angle, values.number({"aspectratio"}), text.name))
            return *error;
        return camera;
    }
    return std::nullopt;
}

} // namespace unprojector::cameras
