#pragma once

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

/// Gives a buffer object that is bound to a target its size, and its bytes where there are any.
/// @return false when the graphics memory does not hold so much
bool fillBuffer(QOpenGLExtraFunctions &gl, unsigned target, std::size_t bytes, const void *data);

/// A mesh in the graphics memory.
struct GpuMesh {
    const mesh::Mesh *source = nullptr; ///< of the model that was uploaded
    QOpenGLVertexArrayObject vertexArray;
    std::vector<std::unique_ptr<QOpenGLBuffer>> buffers;
    GLenum primitives = GL_TRIANGLES;
    std::size_t elementCount = 0; ///< corners of triangles, or points
    bool isIndexed = false;
    GLuint indexBuffer = 0; ///< where it is
    bool isFlat = false;    ///< has no normals
    bool isColored = false; ///< has colours of its vertices
    glm::dvec3 origin{0.0};
    glm::vec4 baseColor{1.0f};
    int texture = -1;
};

/// A model in the graphics memory. It comes there bit by bit, so that nobody has to wait for all of a large one at once.
/// All calls need the OpenGL context current.
class GpuModel : protected QOpenGLExtraFunctions {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::GpuModel)
public:
    /// @param mostTexturePixels  how wide and how high a texture may be; a larger one is scaled down, and so is one that is
    ///                           too large for the driver
    explicit GpuModel(std::shared_ptr<const mesh::Model> source,
                      int mostTexturePixels = std::numeric_limits<int>::max());
    ~GpuModel();

    /// Goes on until all is there or the time is over.
    /// @return whether all is there that will be
    bool uploadOn(const Deadline &deadline);

    /// How much of it is there, in [0, 1].
    double uploadedShare() const;

    /// Those that are there as a whole.
    const std::vector<std::unique_ptr<GpuMesh>> &meshes() const { return m_meshes; }
    QOpenGLTexture &texture(int number) const { return *m_textures[static_cast<std::size_t>(number)]; }

    /// What could not be uploaded since the last call, in sentences for the user.
    QStringList takeFailures();

private:
    /// What is still to be copied into a buffer.
    struct Copy {
        QOpenGLBuffer *buffer;
        const char *bytes;
        std::size_t count;
        std::size_t done = 0;
    };

    void uploadTextures();
    /// @return whether the graphics memory holds it
    bool begin(const mesh::Mesh &mesh);
    /// Some drivers give a buffer its memory only now.
    /// @return false when the graphics memory does not hold it
    bool copyOn(Copy &copy);

    std::shared_ptr<const mesh::Model> m_source;
    int m_mostTexturePixels;
    std::vector<std::unique_ptr<GpuMesh>> m_meshes;
    std::vector<std::unique_ptr<QOpenGLTexture>> m_textures; ///< null where there is no image
    std::unique_ptr<GpuMesh> m_begun;                        ///< the next of m_meshes
    std::vector<Copy> m_copies;                              ///< of it
    std::size_t m_next = 0;                                  ///< mesh of the source
    bool m_areTexturesUploaded = false;
    QStringList m_failures;
};

} // namespace unprojector::gui
