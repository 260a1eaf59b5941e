#pragma once

#include "core/scene/scene.h"

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>

#include <map>
#include <memory>
#include <vector>

namespace unprojector::gui {
using namespace scene;

/// The objects' triangles, lit from the camera. Each model is uploaded once, however many objects show it.
/// All calls need the OpenGL context current.
class MeshPainter : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// Uploads the models that are new and drops those that no object shows any more.
    void upload(const std::vector<SceneObject> &objects);

    /// @param clipPlanes  world space; what lies on the negative side of one is not drawn
    void draw(const std::vector<SceneObject> &objects, const glm::dmat4 &clipFromWorld, const glm::dmat4 &eyeFromWorld,
              const std::vector<glm::dvec4> &clipPlanes);

private:
    struct GpuMesh;
    struct GpuModel;

    std::unique_ptr<GpuModel> uploaded(const std::shared_ptr<const Model> &model);

    std::unique_ptr<QOpenGLShaderProgram> m_program;
    std::map<const Model *, std::unique_ptr<GpuModel>> m_models;

public:
    MeshPainter();
    ~MeshPainter();
};

} // namespace unprojector::gui
