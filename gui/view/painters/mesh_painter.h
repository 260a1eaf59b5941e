#pragma once

#include "core/geometry/drawable.h"
#include "core/mesh/covering_triangles.h"
#include "core/scene/scene.h"
#include "gui/view/painters/gpu_model.h"
#include "gui/view/painters/object_ids.h"

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QStringList>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace unprojector::gui {

/// What is to be drawn into a Frame.
struct FrameContents {
    geometry::Drawable drawn;
    std::vector<scene::SceneObject> objects;
    glm::dmat4 clipFromWorld{1.0};
    glm::dmat4 eyeFromWorld{1.0};
    std::vector<glm::dvec4> clipPlanes; ///< world space; what lies on the negative side of one is not drawn. At most 8
};

/// The objects' triangles and points, lit from the camera, into a Frame: colours, depths, and the object's place in the
/// list as its id. Each model is uploaded when it is first drawn, once, however many objects show it. All of that can be
/// done bit by bit.
///
/// Without a graphics card OpenGL takes long to find that most triangles of a fine mesh cover no pixel's centre; there,
/// those are not given to it, which is seen of the time only.
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

    /// @param isSoftware  OpenGL draws without a graphics card
    void initialize(ObjectIds ids, bool isSoftware);
    void release();

    /// Draws on from a place, and uploads what is not there yet, until all is done or the time is over.
    /// @return whether all is done
    bool drawOn(const FrameContents &contents, Place &place, const Deadline &deadline);

    /// How much of it is uploaded and drawn when it is drawn up to a place, in [0, 1].
    double shareDone(const FrameContents &contents, const Place &place) const;

    /// Drops every model that is not among these.
    void keepOnly(const std::set<const mesh::Model *> &models);

    /// What could not be uploaded since the last call, in sentences for the user.
    QStringList takeFailures();

private:
    struct Entry;
    /// What a program is made for, in bits.
    enum Trait : unsigned { Clipped = 1, Points = 2, Flat = 4, Colored = 8, Textured = 16 };

    /// Binds the program that draws such meshes.
    void bindProgram(unsigned traits);
    GpuModel &modelOf(const std::shared_ptr<const mesh::Model> &model);
    bool drawObject(const FrameContents &contents, const scene::SceneObject &object, Place &place,
                    const Deadline &deadline);
    bool drawMesh(const GpuMesh &mesh, const mesh::CoveringTriangles *covering, Place &place, const Deadline &deadline);
    void drawCovering(const mesh::CoveringTriangles &covering, std::size_t begin, std::size_t end);
    /// Whether no back side of a closed mesh can be seen: the whole model lies in front of the near plane, and is not cut.
    bool hidesBackSides(const FrameContents &contents, const scene::SceneObject &object) const;
    void setClipPlanes(const std::vector<glm::dvec4> &planes, const glm::dmat4 &worldFromUploaded);

    bool m_isSoftware = false;
    ObjectIds m_ids = ObjectIds::Integers;
    std::map<unsigned, std::unique_ptr<QOpenGLShaderProgram>> m_programs; ///< by traits; made when first needed
    QOpenGLShaderProgram *m_program = nullptr;                            ///< the one of these that is bound
    QOpenGLBuffer m_coveringBuffer{QOpenGLBuffer::IndexBuffer};
    std::map<const mesh::Model *, std::unique_ptr<Entry>> m_models;
    QStringList m_failures;
};

} // namespace unprojector::gui
