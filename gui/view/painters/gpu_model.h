#pragma once

#include "core/mesh/curvature.h"
#include "core/mesh/mesh.h"
#include "gui/view/painters/deadline.h"

#include <QCoreApplication>
#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>
#include <QStringList>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace unprojector::gui {

/// Sets the size of a bound buffer object, and its bytes if given.
/// @return false if the graphics memory is too small
bool fillBuffer(QOpenGLExtraFunctions &gl, unsigned target, std::size_t bytes, const void *data);

/// A mesh in the graphics memory.
struct GpuMesh {
    const mesh::Mesh *source = nullptr; ///< of the uploaded model
    QOpenGLVertexArrayObject vertexArray;
    std::vector<std::unique_ptr<QOpenGLBuffer>> buffers;
    GLenum primitives = GL_TRIANGLES;
    std::size_t elementCount = 0; ///< corners of triangles, or points
    bool isIndexed = false;
    GLuint positionBuffer = 0; ///< its name
    GLuint indexBuffer = 0;    ///< its name
    bool isFlat = false;       ///< has no normals
    bool isColored = false;    ///< has vertex colours
    glm::dvec3 origin{0.0};
    glm::vec4 baseColor{1.0f};
    int texture = -1;
};

/// A model in the graphics memory. It is uploaded piece by piece, so that a large one doesn't block
/// the window. All calls need the OpenGL context current.
class GpuModel : protected QOpenGLExtraFunctions {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::GpuModel)
public:
    /// @param mostTexturePixels  the largest width and height of a texture; a larger one is scaled
    /// down, and so is one that is too large for the driver
    explicit GpuModel(std::shared_ptr<const mesh::Model> source,
                      int mostTexturePixels = std::numeric_limits<int>::max());
    ~GpuModel();

    /// Continues until all is uploaded or the time is over.
    /// @return whether all that can be uploaded is
    bool uploadOn(const Deadline &deadline);

    /// The uploaded share, in [0, 1].
    double uploadedShare() const;

    /// Uploads the curvature of the vertices, unless it is uploaded already. Adds to the failures
    /// if the graphics memory is too small.
    /// @pre all of the model is uploaded
    /// @return whether the meshes have it, scaled so that the usual value is 0.7 and none exceeds 1
    bool uploadCurvature(const std::shared_ptr<const mesh::Curvature> &curvature);

    /// The completely uploaded meshes.
    const std::vector<std::unique_ptr<GpuMesh>> &meshes() const { return m_meshes; }
    QOpenGLTexture &texture(int number) const { return *m_textures[static_cast<std::size_t>(number)]; }

    /// The failures since the last call, in sentences for the user.
    QStringList takeFailures();

private:
    /// The rest of a copy into a buffer.
    struct Copy {
        QOpenGLBuffer *buffer;
        const char *bytes;
        std::size_t count;
        std::size_t done = 0;
    };

    void uploadTextures();
    /// @return whether it fits into the graphics memory
    bool begin(const mesh::Mesh &mesh);
    /// Some drivers allocate a buffer's memory only now.
    /// @return false if it doesn't fit into the graphics memory
    bool copyOn(Copy &copy);

    std::shared_ptr<const mesh::Model> m_source;
    int m_mostTexturePixels;
    std::vector<std::unique_ptr<GpuMesh>> m_meshes;
    std::vector<std::unique_ptr<QOpenGLTexture>> m_textures; ///< null if there is no image
    std::unique_ptr<GpuMesh> m_begun;                        ///< the next of m_meshes
    std::vector<Copy> m_copies;                              ///< for m_begun
    std::size_t m_next = 0;                                  ///< index of a mesh of the source
    bool m_areTexturesUploaded = false;
    std::shared_ptr<const mesh::Curvature> m_curvature; ///< the last one that was to be uploaded
    bool m_hasCurvature = false;
    QStringList m_failures;
};

} // namespace unprojector::gui
