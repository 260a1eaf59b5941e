#include "gui/view/painters/gpu_model.h"

#include "gui/view/painters/gl_errors.h"
#include "gui/view/painters/mesh_attributes.h"

#include <QImage>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace unprojector::gui {
using namespace mesh;

namespace {

/// Copied in a few milliseconds.
constexpr std::size_t kBytesAtOnce = std::size_t{8} << 20;

/// The image scaled down to fit into a square of this size.
QImage fitting(const Image &image, int mostPixels)
{
    const QImage whole(image.rgba.data(), image.widthPixels, image.heightPixels, QImage::Format_RGBA8888);
    const QSize size = whole.size();
    if (size.width() <= mostPixels && size.height() <= mostPixels)
        return whole;
    const QSize smaller = size.scaled(mostPixels, mostPixels, Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
    return whole.scaled(smaller, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGBA8888);
}

std::unique_ptr<QOpenGLTexture> uploaded(const QImage &image, bool wrapRepeat)
{
    auto result = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
    result->setFormat(QOpenGLTexture::RGBA8_UNorm);
    result->setSize(image.width(), image.height());
    result->setMipLevels(result->maximumMipLevels());
    result->allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8);
    result->setData(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8,
                    image.constBits()); // rows of whole pixels have no gaps
    result->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    result->setWrapMode(wrapRepeat ? QOpenGLTexture::Repeat : QOpenGLTexture::ClampToEdge);
    return result;
}

/// Curvatures as a vertex attribute: the usual value is 0.7, and no value exceeds 1.
std::vector<std::int16_t> shownCurvatures(const std::vector<float> &values, double usual)
{
    std::vector<std::int16_t> shown(values.size());
    for (std::size_t vertex = 0; usual > 0.0 && vertex < values.size(); ++vertex) {
        const double value = static_cast<double>(values[vertex]) / usual;
        shown[vertex] = static_cast<std::int16_t>(std::lround(32767.0 * value / std::sqrt(1.0 + value * value)));
    }
    return shown;
}

} // namespace

bool fillBuffer(QOpenGLExtraFunctions &gl, unsigned target, std::size_t bytes, const void *data)
{
    clearErrors(gl);
    // QOpenGLBuffer counts bytes in int, which ends at 2 GB; glBufferData does not.
    gl.glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    return gl.glGetError() == GL_NO_ERROR;
}

GpuModel::GpuModel(std::shared_ptr<const Model> source, int mostTexturePixels)
    : m_source(std::move(source)), m_mostTexturePixels(mostTexturePixels)
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
    GLint mostOfDriver = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &mostOfDriver);
    for (const Texture &texture : m_source->textures) {
        if (!texture.image) {
            m_textures.push_back(nullptr);
            continue;
        }
        const QImage image = fitting(*texture.image, std::min(mostOfDriver, m_mostTexturePixels));
        if (image.width() != texture.image->widthPixels || image.height() != texture.image->heightPixels)
            m_failures << tr("The image %1 is larger than OpenGL allows here; it is shown scaled down to a width of %2 "
                             "pixels.")
                              .arg(QString::fromStdU16String(texture.file.filename().u16string()))
                              .arg(image.width());
        m_textures.push_back(uploaded(image, texture.wrapRepeat));
    }
    m_areTexturesUploaded = true;
}

bool GpuModel::begin(const Mesh &mesh)
{
    m_begun = std::make_unique<GpuMesh>();
    m_begun->source = &mesh;
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
    m_begun->positionBuffer = m_begun->buffers.empty() ? 0 : m_begun->buffers.back()->bufferId();
    attribute(MeshAttribute::Normal, mesh.normals, 3, GL_FLOAT, GL_FALSE);
    attribute(MeshAttribute::Color, mesh.colors, 4, GL_UNSIGNED_BYTE, GL_TRUE);
    attribute(MeshAttribute::Texcoord, mesh.texcoords, 2, GL_FLOAT, GL_FALSE);
    m_begun->isIndexed = !mesh.indices.empty();
    if (m_begun->isIndexed) {
        buffer(QOpenGLBuffer::IndexBuffer, mesh.indices);
        m_begun->indexBuffer = m_begun->buffers.back()->bufferId();
    }
    m_begun->vertexArray.release();
    m_begun->primitives = mesh.kind == Mesh::Kind::Points ? GL_POINTS : GL_TRIANGLES;
    m_begun->elementCount = mesh.elementCount();
    m_begun->isFlat = mesh.normals.empty();
    m_begun->isColored = !mesh.colors.empty();
    m_begun->origin = mesh.origin;
    m_begun->baseColor = mesh.baseColor;
    const bool isTextured = mesh.texture >= 0 && m_textures[static_cast<std::size_t>(mesh.texture)];
    m_begun->texture = isTextured ? mesh.texture : -1;
    return fits;
}

bool GpuModel::copyOn(Copy &copy)
{
    clearErrors(*this);
    const std::size_t bytes = std::min(kBytesAtOnce, copy.count - copy.done);
    // Not the index target, which belongs to a vertex array.
    glBindBuffer(GL_COPY_WRITE_BUFFER, copy.buffer->bufferId());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(copy.done), static_cast<GLsizeiptr>(bytes),
                    copy.bytes + copy.done);
    const bool isThere = glGetError() == GL_NO_ERROR;
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    copy.done += bytes;
    return isThere;
}

bool GpuModel::uploadCurvature(const std::shared_ptr<const Curvature> &curvature)
{
    if (m_curvature == curvature)
        return m_hasCurvature;
    m_curvature = curvature;
    m_hasCurvature = true;
    for (const std::unique_ptr<GpuMesh> &mesh : m_meshes) {
        const std::vector<float> &values =
            curvature->meshes[static_cast<std::size_t>(mesh->source - m_source->meshes.data())];
        if (values.empty())
            continue; // points
        const std::vector<std::int16_t> shown = shownCurvatures(values, curvature->usual);
        QOpenGLVertexArrayObject::Binder bound(&mesh->vertexArray);
        mesh->buffers.push_back(std::make_unique<QOpenGLBuffer>(QOpenGLBuffer::VertexBuffer));
        mesh->buffers.back()->create();
        mesh->buffers.back()->bind();
        m_hasCurvature =
            m_hasCurvature && fillBuffer(*this, GL_ARRAY_BUFFER, shown.size() * sizeof(shown[0]), shown.data());
        glEnableVertexAttribArray(MeshAttribute::Curvature);
        glVertexAttribPointer(MeshAttribute::Curvature, 1, GL_SHORT, GL_TRUE, 0, nullptr);
    }
    if (!m_hasCurvature)
        m_failures << tr("The graphics memory is too small for the curvature of %1.")
                          .arg(QString::fromStdString(m_source->name));
    return m_hasCurvature;
}

double GpuModel::uploadedShare() const
{
    std::size_t all = 0, there = 0;
    for (std::size_t mesh = 0; mesh < m_source->meshes.size(); ++mesh) {
        const std::size_t size = m_source->meshes[mesh].elementCount();
        all += size;
        there += mesh < m_next ? size : 0;
    }
    double share = all > 0 ? static_cast<double>(there) / static_cast<double>(all) : 1.0;
    if (m_begun && all > 0) {
        // Ignores buffers that are already uploaded, so progress is slightly too low.
        const double ofMesh = static_cast<double>(m_begun->elementCount) / static_cast<double>(all);
        const double left = m_begun->buffers.empty()
                                ? 0.0
                                : static_cast<double>(m_copies.size()) / static_cast<double>(m_begun->buffers.size());
        share += ofMesh * (1.0 - left);
    }
    return share;
}

bool GpuModel::uploadOn(const Deadline &deadline)
{
    if (!m_areTexturesUploaded)
        uploadTextures();
    while (m_begun || m_next < m_source->meshes.size()) {
        bool fits = m_begun || begin(m_source->meshes[m_next]);
        while (fits && !m_copies.empty()) {
            if (deadline.isOver())
                return false;
            fits = copyOn(m_copies.back());
            if (m_copies.back().done == m_copies.back().count)
                m_copies.pop_back();
        }
        if (!fits) {
            m_failures << tr("The graphics memory is too small for %1: parts of it are not drawn. Close other "
                             "programs, or open a smaller model.")
                              .arg(QString::fromStdString(m_source->name));
            m_begun.reset();
            m_copies.clear();
            m_next = m_source->meshes.size();
            return true;
        }
        m_meshes.push_back(std::move(m_begun));
        ++m_next;
    }
    return true;
}

} // namespace unprojector::gui
