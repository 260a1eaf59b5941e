#pragma once

#include "core/base/json.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/framing.h"
#include "core/geometry/given_point.h"
#include "core/geometry/setup.h"
#include "core/geometry/transform.h"
#include "core/landmarks/landmark.h"
#include "core/mesh/mesh.h"

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
    bool isHidden = false;                          ///< neither drawn nor clicked; all computations stay the same
    base::JsonValue extra = {};                     ///< unknown keys of its file; null or an object
};

/// The part of a window that the viewport takes.
struct ViewportRule {
    enum class Kind {
        WholeWindow,
        Fixed,      ///< `fixed`, for every window size
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

/// The viewport of a rule in a window of this size.
/// @pre check(rule) and check(surface)
geometry::Viewport viewportIn(const ViewportRule &rule, const geometry::Surface &surface);

/// The maximum number of user clip planes: OpenGL guarantees this many.
constexpr std::size_t kMostClipPlanes = 6;

/// A user clip plane that is kept but does not cut.
struct ClipPlaneOff {
    std::size_t index = 0; ///< in the list of all planes, cutting or not
    glm::dvec4 plane{0.0};
    base::JsonValue extra = {}; ///< as in SceneObject
    friend bool operator==(const ClipPlaneOff &, const ClipPlaneOff &) = default;
};

/// Parameters, or an imported matrix with the parameters that show it. Setting other parameters
/// removes the matrix.
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
    /// The imported matrix; null if the parameters define the value.
    const Matrix *matrix() const { return m_matrix ? &*m_matrix : nullptr; }
    /// Returns whether these parameters replaced a matrix.
    bool hadMatrix() const { return m_hadMatrix; }

    friend bool operator==(const Importable &, const Importable &) = default;
    friend bool operator==(const Importable &a, const Parameters &b) { return a.m_parameters == b; }

private:
    Parameters m_parameters;
    std::optional<Matrix> m_matrix;
    bool m_hadMatrix = false;
};

/// The projection, with OpenGL's depth: a reversed matrix is stored with the scene's depth range
/// flipped.
using SceneProjection = Importable<geometry::Projection, geometry::MatrixProjection>;
/// The camera. The matrix is eyeFromWorld.
using SceneCamera = Importable<geometry::LookAt, glm::dmat4>;

/// Parts of a scene's file that are not shown, kept for writing it again.
struct FileKeys {
    bool hasViewport = false;    ///< also for the whole window
    bool hasConventions = false; ///< also for OpenGL
    base::JsonValue extra;       ///< unknown keys, each at its position: {"author": "A", "window": {"title": "T"}}
};

/// The settings that show the objects: everything but the objects and the landmarks.
struct SceneSettings {
    /// The window's size that the user has chosen; none: as large as there is room for it.
    std::optional<geometry::Surface> windowSize;
    SceneCamera camera;
    SceneCamera home; ///< the camera that the scene opened with
    SceneProjection projection;
    bool projectionFollowsViewport = true; ///< takes the viewport's aspect, so that a circle stays a circle
    bool clipDistancesFitObjects = true;   ///< near and far hold the objects tightly
    ViewportRule viewport;
    geometry::DepthRange depthRange;
    bool isDepthRangeTurned = false; ///< by a reversed matrix, which may have been replaced since
    /// (A, B, C, D): objects are drawn only where A x + B y + C z + D >= 0 in world space
    /// (glClipPlane).
    std::vector<glm::dvec4> clipPlanes;
    /// Planes that are switched off, by index. Together with `clipPlanes` at most kMostClipPlanes.
    std::vector<ClipPlaneOff> clipPlanesOff;
    /// A point that the user follows through the pipeline, in addition to the clicked one.
    std::optional<geometry::GivenPoint> givenPoint;
    /// The convention for showing and writing matrices and points. Computations always use
    /// OpenGL's.
    geometry::Api conventions = geometry::Api::OpenGl;
    FileKeys fileKeys;
};

/// The objects and landmarks of a scene, with its settings.
struct Scene : SceneSettings {
    std::vector<SceneObject> objects;
    landmarks::LandmarkSet landmarks; ///< world space
};

/// The axis-aligned box around an object, world space.
geometry::Box boundsOf(const SceneObject &object);
/// The axis-aligned box around all objects that are not hidden, world space; empty without any.
geometry::Box boundsOf(const Scene &scene);

/// Adds the visible parts of an object to a framing: the corners of its triangles.
void add(geometry::Framing &framing, const SceneObject &object);

/// @return the first error of the window's size, camera, projection, viewport rule, depth range,
///         transforms (reachable too); NotFinite and ClipPlaneHasNoNormal (A = B = C = 0) for clip
///         planes; NotFinite for the given point
geometry::Check check(const Scene &scene);

/// The setup of a scene in a window of this size. The viewport follows its rule. If the settings
/// say so, the projection takes the viewport's aspect, and near and far fit the objects. The depth
/// range is OpenGL's, in single precision (see drawable).
/// @param reach  of drawn things other than objects (the ground): it only extends the far plane
/// @return the errors of check(scene), check(surface), drawable
geometry::Result<geometry::Setup> setupOf(const Scene &scene, const geometry::Surface &surface,
                                          const geometry::Box &reach);

} // namespace unprojector::scene
