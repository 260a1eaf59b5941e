#pragma once

#include "core/geometry/drawable.h"
#include "core/scene/scene.h"
#include "gui/painters/gpu_model.h"
#include "gui/painters/object_ids.h"

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QStringList>

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace unprojector::gui {
using namespace scene;

/// What is to be drawn into a Frame.
struct FrameContents {
    Drawable drawn;
    std::vector<SceneObject> objects;
    glm::dmat4 clipFromWorld{1.0};
    glm::dmat4 eyeFromWorld{1.0};
    std::vector<glm::dvec4> clipPlanes; ///< world space; what lies on the negative side of one is not drawn. At most 8
};

/// The objects' triangles and points, lit from the camera, into a Frame: colours, depths, and the object's place in the
/// list as its id. Each model is uploaded when it is first drawn, once, however many objects show it. All of that can be
/// done bit by bit.
/// All calls need the OpenGL context current.
class MeshPainter : protected QOpenGLExtraFunctions {
public:
    /// How far a drawing has come.
    struct Place {
        std::size_t object = 0;
        std::size_t mesh = 0;
        std::size_t element = 0; ///< corner of a triangle, or point
    };

    MeshPainter();
    ~MeshPainter();

    void initialize(ObjectIds ids);
    void release();

    /// Draws on from a place, and uploads what is not there yet, until all is done or the time is over.
    /// @return whether all is done
    bool drawOn(const FrameContents &contents, Place &place, const Deadline &deadline);

    /// Drops every model that is not among these.
    void keepOnly(const std::set<const Model *> &models);

    /// What could not be uploaded since the last call, in sentences for the user.
    QStringList takeFailures();

private:
    struct Entry;

    GpuModel &modelOf(const std::shared_ptr<const Model> &model);
    bool drawObject(const FrameContents &contents, const SceneObject &object, Place &place, const Deadline &deadline);
    bool drawMesh(const GpuMesh &mesh, Place &place, const Deadline &deadline);
    void setClipPlanes(const std::vector<glm::dvec4> &planes, const glm::dmat4 &worldFromUploaded);

    std::unique_ptr<QOpenGLShaderProgram> m_program;
    std::map<const Model *, std::unique_ptr<Entry>> m_models;
    QStringList m_failures;
};

} // namespace unprojector::gui
