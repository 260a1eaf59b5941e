#pragma once

#include "unprojector/setup.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace unprojector {

/// An object of a scene.
struct SceneObject {
    std::string name;           ///< UTF-8
    std::filesystem::path file; ///< empty for a bundled model and for arrays
    std::size_t vertices = 0, triangles = 0, points = 0;
    glm::dmat4 worldFromObject{1.0};
    glm::dvec3 lowest{0.0}, highest{0.0}; ///< corners of its box in world space
    bool isHidden = false;                ///< a pick passes through it
    std::vector<std::string> notes;       ///< what the importer changed or dropped, one sentence each
};

/// The target that a pick takes.
enum class Snap {
    Surface, ///< the hit of the pixel's own ray
    Vertex,  ///< the nearest visible vertex within 8 pixels; its exact coordinate
    Edge,    ///< the nearest visible point of an edge within 8 pixels
    Face     ///< the hit of the pixel's own ray, else the nearest visible triangle within 8 pixels
};

/// The result of a pick. Numbers are NaN and indices -1 where there is none.
struct Hit {
    glm::dvec3 world;
    /// The largest deviation of each coordinate from the file's geometry, due to double arithmetic.
    /// It is large where the surface is seen nearly edge on.
    glm::dvec3 uncertainty;
    glm::dvec3 objectPoint; ///< the same point in the object's own space
    glm::dvec3 normal;      ///< world space, length 1
    glm::dvec3 barycentric; ///< of the triangle
    double distance;        ///< from the eye along the ray, world units
    glm::dvec3 vertexWorld; ///< position of `vertex`
    glm::dvec3 edgeWorld;   ///< the nearest point of `edge`
    std::int64_t object;    ///< index in Scene::objects
    std::int64_t triangle;  ///< number in its file
    std::int64_t vertices[3];
    std::int64_t vertex;  ///< the nearest of these; or the point of a point cloud
    std::int64_t edge[2]; ///< the vertices of the nearest edge
    bool isHit;
    bool isOutside;          ///< the pixel lies outside the viewport, or has no ray: no surface was looked for
    std::uint8_t padding[6]; ///< 0: hits can be compared byte by byte
};

/// A scene with its models: casts rays on meshes. It does not change; any thread may use it.
class UNPROJECTOR_PUBLIC Scene {
public:
    /// Opens a scene file, or a model (OBJ, STL, PLY, OFF, glTF, GLB) as the window shows it on
    /// opening. Every model is read.
    /// @return MissingFile, File: the scene or a model; Value: the key or the line that is wrong
    static Result<Scene> load(const std::filesystem::path &file);

    /// The scene of a scene file's text.
    /// @param folder  that relative paths of models start from
    static Result<Scene> parse(std::string_view text, const std::filesystem::path &folder = {});

    /// A scene of one mesh.
    /// @param vertices   x, y, z of each vertex, world space
    /// @param triangles  three indices of vertices each, from 0
    /// @return Value: a coordinate that is not finite, an index out of range, no triangle, a number
    ///         of coordinates or indices that is no multiple of 3
    static Result<Scene> of(const Setup &setup, std::span<const double> vertices,
                            std::span<const std::uint32_t> triangles, const std::string &name = "mesh");

    /// The setup of the scene file; for a model, the setup of the window on opening, 800 x 600.
    const Setup &setup() const;
    /// The setup that the window uses at another size. A scene of arrays keeps the camera and the
    /// projection of its setup.
    /// @return Value: a size below 1 pixel
    Result<Setup> setupAt(int width, int height) const;

    const std::vector<SceneObject> &objects() const;

    /// Writes the scene as a scene file, atomically. Unknown keys of the file that was read are
    /// kept.
    /// @return File; Value: the scene has arrays, which no scene file holds
    Result<std::monostate> save(const std::filesystem::path &file) const;

private:
    friend class Picker;
    friend struct SceneAccess;
    struct Data;
    explicit Scene(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

/// Casts the rays of pixels into a scene, prepared once. Any thread may call it.
class UNPROJECTOR_PUBLIC Picker {
public:
    /// @param setup  of the pixels; empty: the scene's. The search trees of a scene's models are
    ///         built once, for its first picker
    /// @return Value: an object beyond the range of computation
    static Result<Picker> of(const Scene &scene, const std::optional<Setup> &setup = std::nullopt);

    /// @param px, py  device pixels, origin top-left; the centre of pixel (i, j) is (i + 1/2, j + 1/2)
    Hit at(double px, double py, Snap snap = Snap::Surface) const;

    /// The same for `count` pixels.
    /// @param threads  the maximum number of threads; 0: all cores
    void operator()(const double *px, const double *py, Hit *hits, std::size_t count, Snap snap = Snap::Surface,
                    unsigned threads = 1) const;

private:
    struct Data;
    explicit Picker(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

} // namespace unprojector
