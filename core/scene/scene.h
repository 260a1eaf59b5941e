#pragma once

#include "core/geometry/api_conventions.h"
#include "core/geometry/framing.h"
#include "core/geometry/given_point.h"
#include "core/geometry/setup.h"
#include "core/geometry/transform.h"
#include "core/landmarks/landmark.h"
#include "core/mesh/mesh.h"
#include "core/text/json_value.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::scene {

/// One model placed in the world.
struct SceneObject {
    std::string name;           ///< UTF-8
    std::filesystem::path file; ///< empty for a bundled object
    std::shared_ptr<const mesh::Model> model;
    std::vector<geometry::TransformStep> transform; ///< worldFromObject, step by step
    bool isHidden = false;      ///< neither drawn nor clicked; all that is computed with it stays the same
    text::JsonValue extra = {}; ///< keys of its file that are not ours; null or an object
};

/// Which part of a window the viewport takes.
struct ViewportRule {
    enum class Kind {
        WholeWindow,
        Fixed,      ///< `fixed`, whatever the window's size
        KeepAspect, ///< the largest centred rectangle of `aspect`, in whole pixels (letterbox)
        Quarter     ///< glViewport(width/2, 0, width/2, height/2), as in the zhangci tutorial
    };
    Kind kind = Kind::WholeWindow;
    geometry::Viewport fixed{0.0, 0.0, 640.0, 480.0};
    double aspect = 4.0 / 3.0; ///< width / height
    friend bool operator==(const ViewportRule &, const ViewportRule &) = default;
};

/// @return EmptyViewport, NotFinite (fixed); AspectNotPositive, NotFinite (keep aspect)
geometry::Check check(const ViewportRule &rule);

/// The viewport that a rule gives in a window of this size.
/// @pre check(rule) and check(surface)
geometry::Viewport viewportIn(const ViewportRule &rule, const geometry::Surface &surface);

/// At most so many user clip planes, as OpenGL guarantees.
constexpr std::size_t kMostClipPlanes = 6;

/// A user clip plane that is kept but does not cut.
struct ClipPlaneOff {
    std::size_t index = 0; ///< in the list of all planes, those that cut and those that do not
    glm::dvec4 plane{0.0};
    text::JsonValue extra = {}; ///< as of an object
    friend bool operator==(const ClipPlaneOff &, const ClipPlaneOff &) = default;
};

/// Parameters, or the matrix of another program with the parameters that show it. Setting other parameters ends the matrix.
template <class Parameters, class Matrix>
class Importable {
public:
    Importable() = default;
    Importable(const Matrix &matrix, const Parameters &shownBy) : m_parameters(shownBy), m_matrix(matrix) {}

    Importable &operator=(const Parameters &parameters)
    {
        if (!(parameters == m_parameters)) {
            m_parameters = parameters;
            m_hadMatrix = hadMatrix() || matrix();
            m_matrix.reset();
        }
        return *this;
    }

    const Parameters &operator*() const { return m_parameters; }
    const Parameters *operator->() const { return &m_parameters; }
    operator const Parameters &() const { return m_parameters; }
    /// Null where the parameters stand for themselves.
    const Matrix *matrix() const { return m_matrix ? &*m_matrix : nullptr; }
    /// Whether there was a matrix before these parameters were set.
    bool hadMatrix() const { return m_hadMatrix; }

    friend bool operator==(const Importable &, const Importable &) = default;
    friend bool operator==(const Importable &a, const Parameters &b) { return a.m_parameters == b; }

private:
    Parameters m_parameters;
    std::optional<Matrix> m_matrix;
    bool m_hadMatrix = false;
};

/// Of OpenGL's depth: a reversed matrix is one with the scene's depth range turned round.
using SceneProjection = Importable<geometry::Projection, geometry::MatrixProjection>;
/// The matrix is eyeFromWorld.
using SceneCamera = Importable<geometry::LookAt, glm::dmat4>;

/// What a scene's file says that is not shown, to be written again.
struct FileKeys {
    bool hasViewport = false;    ///< also of one that is the whole window
    bool hasConventions = false; ///< also of OpenGL's
    text::JsonValue extra; ///< keys that are not ours, each where it stood: {"author": "A", "window": {"title": "T"}}
};

/// How the objects are shown: everything but the objects and the landmarks.
struct SceneSettings {
    /// The window's size, where the user has chosen it; none: as large as there is room for it.
    std::optional<geometry::Surface> windowSize;
    SceneCamera camera;
    SceneCamera home; ///< the camera that the scene opened with
    SceneProjection projection;
    bool projectionFollowsViewport = true; ///< takes the viewport's aspect, so that a circle stays a circle
    bool clipDistancesFitObjects = true;   ///< near and far hold the objects tightly
    ViewportRule viewport;
    geometry::DepthRange depthRange;
    bool isDepthRangeTurned = false; ///< by a reversed matrix, which may have ended since
    /// (A, B, C, D): of the objects only what has A x + B y + C z + D >= 0 in world space is drawn (glClipPlane).
    std::vector<glm::dvec4> clipPlanes;
    /// Planes that are switched off, by place. With `clipPlanes` no more than kMostClipPlanes.
    std::vector<ClipPlaneOff> clipPlanesOff;
    /// A point that the user follows through the pipeline besides what is clicked.
    std::optional<geometry::GivenPoint> givenPoint;
    geometry::Api conventions = geometry::Api::
        OpenGl; ///< whose conventions matrices and points are shown and written in; nothing is computed by them
    FileKeys fileKeys;
};

/// What is shown and how.
struct Scene : SceneSettings {
    std::vector<SceneObject> objects;
    landmarks::LandmarkSet landmarks; ///< world space
};

/// The axis-aligned box around an object, world space.
geometry::Box boundsOf(const SceneObject &object);
/// The axis-aligned box around all objects that are not hidden, world space; empty without any.
geometry::Box boundsOf(const Scene &scene);

/// Adds what is seen of an object: the corners of its triangles.
void add(geometry::Framing &framing, const SceneObject &object);

/// @return the first error of the window's size, camera, projection, viewport rule, depth range, transforms (reachable too); NotFinite and
///         ClipPlaneHasNoNormal (A = B = C = 0) for clip planes; NotFinite for the given point
geometry::Check check(const Scene &scene);

/// The picture of a scene in a window of this size: the viewport by its rule, the projection with the viewport's aspect
/// where it follows it, near and far fitted where they are to.
/// @param reach  of what is drawn besides the objects (the ground): it only stretches the far plane
/// Its depth range is the one that OpenGL has, in single precision (see drawable).
/// @return the errors of check(scene), check(surface), drawable
geometry::Result<geometry::Setup> setupOf(const Scene &scene, const geometry::Surface &surface,
                                          const geometry::Box &reach);

} // namespace unprojector::scene
