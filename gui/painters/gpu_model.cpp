#include "gui/painters/gpu_model.h"

#include "gui/painters/gl_errors.h"
#include "gui/painters/mesh_attributes.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

/// Copied in a few milliseconds.
constexpr std::size_t kBytesAtOnce = std::size_t{8} << 20;

std::unique_ptr<QOpenGLTexture> uploaded(const Image &image, bool wrapRepeat)
{
    auto result = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
    result->setFormat(QOpenGLTexture::RGBA8_UNorm);
    result->setSize(image.widthPixels, image.heightPixels);
    result->setMipLevels(result->maximumMipLevels());
    result->allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8);
    result->setData(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, image.rgba.data());
    result->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    result->setWrapMode(wrapRepeat ? QOpenGLTexture::Repeat : QOpenGLTexture::ClampToEdge);
    return result;
}

} // namespace

bool fillBuffer(QOpenGLExtraFunctions &gl, unsigned target, std::size_t bytes, const void *data)
{
    clearErrors(gl);
    // QOpenGLBuffer counts bytes in int, which ends at 2 GB; glBufferData does not.
    gl.glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    return gl.glGetError() == GL_NO_ERROR;
}

GpuModel::GpuModel(std::shared_ptr<const Model> source) : m_source(std::move(source))
{
    initializeOpenGLFunctions();
}

GpuModel::~GpuModel() = default;

QStringList GpuModel::takeFailures()
{
    return std::exchange(m_failures, {});
}

void GpuModel::uploadTextures()
{
    for (const Texture &texture : m_source->textures)
        m_textures.push_back(texture.image ? uploaded(*texture.image, texture.wrapRepeat) : nullptr);
    m_areTexturesUploaded = true;
}

bool GpuModel::begin(const Mesh &mesh)
{
    m_begun = std::make_unique<GpuMesh>();
    m_begun->vertexArray.create();
    m_begun->vertexArray.bind();
    bool fits = true;
    const auto buffer = [&](QOpenGLBuffer::Type type, const auto &data) {
        m_begun->buffers.push_back(std::make_unique<QOpenGLBuffer>(type));
        QOpenGLBuffer &made = *m_begun->buffers.back();
        made.create();
        made.bind();
        const std::size_t bytes = data.size() * sizeof(data[0]);
        const bool isSmall = bytes <= kBytesAtOnce;
        fits = fits && fillBuffer(*this, type, bytes, isSmall ? data.data() : nullptr);
        if (!isSmall)
            m_copies.push_back({&made, reinterpret_cast<const char *>(data.data()), bytes});
    };
    const auto attribute = [&](GLuint index, const auto &data, GLint size, GLenum type, GLboolean normalized) {
        if (data.empty())
            return;
        buffer(QOpenGLBuffer::VertexBuffer, data);
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, size, type, normalized, 0, nullptr);
    };
    attribute(MeshAttribute::Position, mesh.positions, 3, GL_FLOAT, GL_FALSE);
    attribute(MeshAttribute::Normal, mesh.normals, 3, GL_FLOAT, GL_FALSE);
    attribute(MeshAttribute::Color, mesh.colors, 4, GL_UNSIGNED_BYTE, GL_TRUE);
    attribute(MeshAttribute::Texcoord, mesh.texcoords, 2, GL_FLOAT, GL_FALSE);
    m_begun->isIndexed = !mesh.indices.empty();
    if (m_begun->isIndexed)
        buffer(QOpenGLBuffer::IndexBuffer, mesh.indices);
    m_begun->vertexArray.release();
    m_begun->primitives = mesh.kind == Mesh::Kind::Points ? GL_POINTS : GL_TRIANGLES;
    m_begun->elementCount = mesh.elementCount();
    m_begun->isFlat = mesh.normals.empty();
    m_begun->origin = mesh.origin;
    m_begun->baseColor = mesh.baseColor;
    const bool isTextured = mesh.texture >= 0 && m_textures[static_cast<std::size_t>(mesh.texture)];
    m_begun->texture = isTextured ? mesh.texture : -1;
    return fits;
}

void GpuModel::copyOn(Copy &copy)
{
    const std::size_t bytes = std::min(kBytesAtOnce, copy.count - copy.done);
    // Not into the target of indices, which belongs to a vertex array.
    glBindBuffer(GL_COPY_WRITE_BUFFER, copy.buffer->bufferId());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(copy.done), static_cast<GLsizeiptr>(bytes),
                    copy.bytes + copy.done);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    copy.done += bytes;
}

bool GpuModel::uploadOn(const Deadline &deadline)
{
    if (!m_areTexturesUploaded)
        uploadTextures();
    while (m_begun || m_next < m_source->meshes.size()) {
        if (!m_begun && !begin(m_source->meshes[m_next])) {
            m_failures << tr("The graphics memory does not hold %1, which is not drawn whole. Close other programs, or "
                             "open a smaller model.")
                              .arg(QString::fromStdString(m_source->name));
            m_begun.reset();
            m_copies.clear();
            m_next = m_source->meshes.size();
            return true;
        }
        while (!m_copies.empty()) {
            if (deadline.isOver())
                return false;
            copyOn(m_copies.back());
            if (m_copies.back().done == m_copies.back().count)
                m_copies.pop_back();
        }
        m_meshes.push_back(std::move(m_begun));
        ++m_next;
    }
    return true;
}

} // namespace unprojector::gui
