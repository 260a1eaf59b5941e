#pragma once

#include "core/scene/scene.h"
#include "gui/painters/object_ids.h"

#include <QCoreApplication>
#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>
#include <QStringList>

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace unprojector::gui {
using namespace scene;

/// Fills the buffer that is bound to a target.
/// @return false when the graphics memory does not hold so much
bool fillBuffer(QOpenGLExtraFunctions &gl, unsigned target, std::size_t bytes, const void *data);

/// The objects' triangles, lit from the camera, into a Frame: colours, depths, and the object's place in the list as its
/// id. Each model is uploaded when it is first drawn, once, however many objects show it.
/// All calls need the OpenGL context current.
class MeshPainter : protected QOpenGLExtraFunctions {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MeshPainter)
public:
    MeshPainter();
    ~MeshPainter();

    void initialize(ObjectIds ids);
    void release();

    /// @param clipPlanes  world space; what lies on the negative side of one is not drawn. At most 8
    void draw(const std::vector<SceneObject> &objects, const glm::dmat4 &clipFromWorld, const glm::dmat4 &eyeFromWorld,
              const std::vector<glm::dvec4> &clipPlanes);

    /// What could not be uploaded since the last call, in sentences for the user.
    QStringList takeFailures();

private:
    struct GpuMesh;
    struct GpuModel;

    void dropUnshown(const std::vector<SceneObject> &objects);
    const GpuModel &uploaded(const std::shared_ptr<const Model> &model);
    std::unique_ptr<GpuMesh> uploaded(const Mesh &mesh);
    void setClipPlanes(const std::vector<glm::dvec4> &planes, const glm::dmat4 &worldFromUploaded);

    std::unique_ptr<QOpenGLShaderProgram> m_program;
    std::map<const Model *, std::unique_ptr<GpuModel>> m_models;
    QStringList m_failures;
};

} // namespace unprojector::gui
