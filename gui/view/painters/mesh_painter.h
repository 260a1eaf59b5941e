#pragma once

#include "core/geometry/drawable.h"
#include "core/mesh/covering_triangles.h"
#include "core/scene/scene.h"
#include "gui/view/painters/gpu_model.h"
#include "gui/view/painters/mesh_edges.h"
#include "gui/view/painters/object_ids.h"
#include "gui/view/shading.h"

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QStringList>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace unprojector::gui {

/// The content to draw into a Frame.
struct FrameContents {
    geometry::Drawable drawn;
    std::vector<scene::SceneObject> objects;
    glm::dmat4 clipFromWorld{1.0};
    glm::dmat4 eyeFromWorld{1.0};
    std::vector<glm::dvec4> clipPlanes; ///< world space; points on the negative side of one are not drawn. At most 8
    bool areStandIns = false;           ///< the objects' edges are not those of their models, and are not drawn
};

/// Draws the objects' triangles and points, lit from the camera, into a Frame: colours, depths, and
/// the object's index as its id. Each model is uploaded once, at its first drawing, even if several
/// objects show it. All of that can be done piece by piece.
///
/// A software OpenGL needs long to discard the triangles of a fine mesh that cover no pixel's
/// centre. For it the painter leaves them out, which changes only the time. All calls need the
/// OpenGL context current.
class MeshPainter : protected QOpenGLExtraFunctions {
public:
    /// The progress of a drawing.
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

    /// Sets the options of the colours.
    void setShading(Shading shading) { m_shading = std::move(shading); }

    /// Continues drawing from a position, and uploads missing models, until all is done or the time
    /// is over.
    /// @return whether all is done
    bool drawOn(const FrameContents &contents, Place &place, const Deadline &deadline);

    /// The uploaded and drawn share at a position of the drawing, in [0, 1].
    double shareDone(const FrameContents &contents, const Place &place) const;

    /// Drops every model that is not among these.
    void keepOnly(const std::set<const mesh::Model *> &models);

    /// The failures since the last call, in sentences for the user.
    QStringList takeFailures();

private:
    struct Entry;
    /// The features of a shader program, as bits.
    enum Trait : unsigned {
        Clipped = 1,
        Points = 2,
        Flat = 4,
        Colored = 8,
        Textured = 16,
        SideLit = 32,
        Curved = 64,
        Edges = 128,
        Indexed = 256 ///< with Edges: vertices have numbers
    };

    /// Binds the program for meshes with these traits.
    void bindProgram(unsigned traits);
    Entry &entryOf(const std::shared_ptr<const mesh::Model> &model);
    bool drawObject(const FrameContents &contents, const scene::SceneObject &object, Place &place,
                    const Deadline &deadline);
    /// @param hasEdges  the bound program draws them
    bool drawMesh(const GpuMesh &mesh, const mesh::CoveringTriangles *covering, bool hasEdges, Place &place,
                  const Deadline &deadline);
    void drawCovering(const mesh::CoveringTriangles &covering, bool hasEdges, std::size_t begin, std::size_t end);
    /// Returns whether no back side of a closed mesh is visible: the whole model lies in front of
    /// the near plane and is not cut.
    bool hidesBackSides(const FrameContents &contents, const scene::SceneObject &object) const;
    void setClipPlanes(const std::vector<glm::dvec4> &planes, const glm::dmat4 &worldFromUploaded);
    /// The traits that the shading adds to a mesh of triangles.
    unsigned shadingTraits(const FrameContents &contents, Entry &entry, const GpuMesh &mesh);
    /// Sets the shading's values in the bound program.
    /// @param isFrontOutside  front sides in the view are those of the model
    void setShadingValues(unsigned traits, const FrameContents &contents, const GpuMesh &mesh, bool isFrontOutside);

    bool m_isSoftware = false;
    ObjectIds m_ids = ObjectIds::Integers;
    std::map<unsigned, std::unique_ptr<QOpenGLShaderProgram>> m_programs; ///< by traits; created on demand
    QOpenGLShaderProgram *m_program = nullptr;                            ///< the bound one of these
    QOpenGLBuffer m_coveringBuffer{QOpenGLBuffer::IndexBuffer};
    std::map<const mesh::Model *, std::unique_ptr<Entry>> m_models;
    Shading m_shading;
    MeshEdges m_edges;
    QStringList m_failures;
};

} // namespace unprojector::gui
