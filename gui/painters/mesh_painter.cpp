#include "gui/painters/mesh_painter.h"

#include "core/geometry/view_volume.h"
#include "gui/painters/gl_errors.h"
#include "gui/painters/shader.h"

#include <QImage>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace unprojector::gui {

struct MeshPainter::GpuMesh {
    QOpenGLVertexArrayObject vertexArray;
    std::vector<std::unique_ptr<QOpenGLBuffer>> buffers;
    GLenum primitives = GL_TRIANGLES;
    GLsizei elementCount = 0;
    bool isIndexed = false;
    bool isFlat = false;
    glm::dvec3 origin; ///< object space; the positions are relative to it
    glm::vec4 baseColor;
    int texture = -1;
};

struct MeshPainter::GpuModel {
    std::shared_ptr<const Model> source; ///< keeps the key of the map alive
    std::vector<std::unique_ptr<GpuMesh>> meshes;
    std::vector<std::unique_ptr<QOpenGLTexture>> textures; ///< null where the image could not be decoded
};

namespace {

// OpenGL's name; QOpenGL's headers stop at those of OpenGL ES.
#ifndef GL_CLIP_DISTANCE0
#define GL_CLIP_DISTANCE0 0x3000
#endif

enum Attribute : GLuint { Position, Normal, Color, Texcoord };

/// OpenGL guarantees as many.
constexpr std::size_t kClipDistances = 8;

std::unique_ptr<QOpenGLTexture> decoded(const Texture &texture)
{
    const QByteArray bytes = QByteArray::fromRawData(reinterpret_cast<const char *>(texture.encoded.data()),
                                                     static_cast<qsizetype>(texture.encoded.size()));
    const QImage image = QImage::fromData(bytes);
    if (image.isNull())
        return nullptr;
    // Mesh::texcoords has its origin at the image's bottom-left, where OpenGL expects the first row.
    auto result = std::make_unique<QOpenGLTexture>(image.mirrored(), QOpenGLTexture::GenerateMipMaps);
    result->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    result->setWrapMode(texture.wrapRepeat ? QOpenGLTexture::Repeat : QOpenGLTexture::ClampToEdge);
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

MeshPainter::MeshPainter() = default;
MeshPainter::~MeshPainter() = default;

void MeshPainter::initialize(ObjectIds ids)
{
    initializeOpenGLFunctions();
    m_program = loadProgram(QStringLiteral("mesh"),
                            ids == ObjectIds::Colors ? QByteArrayLiteral("OBJECT_IDS_ARE_COLORS") : QByteArray());
}

void MeshPainter::release()
{
    m_models.clear();
    m_program.reset();
}

QStringList MeshPainter::takeFailures()
{
    return std::exchange(m_failures, {});
}

/// Drops the models that no object shows any more.
void MeshPainter::dropUnshown(const std::vector<SceneObject> &objects)
{
    std::set<const Model *> shown;
    for (const SceneObject &object : objects)
        shown.insert(object.model.get());
    std::erase_if(m_models, [&shown](const auto &entry) { return !shown.contains(entry.first); });
}

const MeshPainter::GpuModel &MeshPainter::uploaded(const std::shared_ptr<const Model> &model)
{
    std::unique_ptr<GpuModel> &slot = m_models[model.get()];
    if (slot)
        return *slot;
    slot = std::make_unique<GpuModel>();
    slot->source = model;
    for (const Texture &texture : model->textures) {
        slot->textures.push_back(decoded(texture));
        if (!slot->textures.back() && !texture.encoded.empty())
            m_failures
                << tr("A texture of %1 could not be decoded and is not shown. Convert it to PNG or JPEG, or make "
                      "it smaller.")
                       .arg(QString::fromStdString(model->name));
    }
    for (const Mesh &mesh : model->meshes) {
        std::unique_ptr<GpuMesh> target = uploaded(mesh);
        if (!target) {
            m_failures << tr("The graphics memory does not hold %1, which is not drawn whole. Close other programs, or "
                             "open a smaller model.")
                              .arg(QString::fromStdString(model->name));
            break;
        }
        const bool isTextured = mesh.texture >= 0 && slot->textures[static_cast<std::size_t>(mesh.texture)];
        target->texture = isTextured ? mesh.texture : -1;
        slot->meshes.push_back(std::move(target));
    }
    return *slot;
}

/// @return null when the graphics memory does not hold it
std::unique_ptr<MeshPainter::GpuMesh> MeshPainter::uploaded(const Mesh &mesh)
{
    auto target = std::make_unique<GpuMesh>();
    target->vertexArray.create();
    target->vertexArray.bind();
    bool fits = true;
    const auto buffer = [&](QOpenGLBuffer::Type type, const auto &data) {
        target->buffers.push_back(std::make_unique<QOpenGLBuffer>(type));
        target->buffers.back()->create();
        target->buffers.back()->bind();
        fits = fits && fillBuffer(*this, type, data.size() * sizeof(data[0]), data.data());
    };
    const auto attribute = [&](GLuint index, const auto &data, GLint size, GLenum type, GLboolean normalized) {
        if (data.empty())
            return;
        buffer(QOpenGLBuffer::VertexBuffer, data);
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, size, type, normalized, 0, nullptr);
    };
    attribute(Position, mesh.positions, 3, GL_FLOAT, GL_FALSE);
    attribute(Normal, mesh.normals, 3, GL_FLOAT, GL_FALSE);
    attribute(Color, mesh.colors, 4, GL_UNSIGNED_BYTE, GL_TRUE);
    attribute(Texcoord, mesh.texcoords, 2, GL_FLOAT, GL_FALSE);
    target->isIndexed = !mesh.indices.empty();
    if (target->isIndexed)
        buffer(QOpenGLBuffer::IndexBuffer, mesh.indices);
    target->vertexArray.release();
    target->primitives = mesh.kind == Mesh::Kind::Points ? GL_POINTS : GL_TRIANGLES;
    target->elementCount = static_cast<GLsizei>(mesh.elementCount());
    target->isFlat = mesh.normals.empty();
    target->origin = mesh.origin;
    target->baseColor = mesh.baseColor;
    return fits ? std::move(target) : nullptr;
}

/// Cuts the model at the planes. Which distances are enabled is not enough: Mesa's software renderers were seen to go by
/// an older set of them. So the distances that no plane needs are those of a plane that cuts nothing.
void MeshPainter::setClipPlanes(const std::vector<glm::dvec4> &planes, const glm::dmat4 &worldFromUploaded)
{
    std::array<glm::vec4, kClipDistances> distances;
    distances.fill(glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    for (std::size_t i = 0; i < std::min(planes.size(), kClipDistances); ++i) {
        // In double, and about the mesh's origin, so that a plane cuts where it says far from the origin too.
        const glm::dvec4 plane = planeInSource(planes[i], worldFromUploaded);
        const double length = glm::length(glm::dvec3(plane));
        distances[i] = glm::vec4(length > 0.0 ? plane / length : plane);
    }
    glUniform4fv(m_program->uniformLocation("clipPlanes"), static_cast<GLsizei>(kClipDistances),
                 glm::value_ptr(distances[0]));
}

void MeshPainter::draw(const std::vector<SceneObject> &objects, const glm::dmat4 &clipFromWorld,
                       const glm::dmat4 &eyeFromWorld, const std::vector<glm::dvec4> &clipPlanes)
{
    dropUnshown(objects);
    m_program->bind();
    m_program->setUniformValue("baseTexture", 0);
    const auto location = [this](const char *name) { return m_program->uniformLocation(name); };
    const std::size_t planeCount = std::min(clipPlanes.size(), kClipDistances);
    for (std::size_t i = 0; i < planeCount; ++i)
        glEnable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const SceneObject &object = objects[i];
        if (object.isHidden)
            continue;
        const GpuModel &model = uploaded(object.model);
        const glm::dmat4 placement = worldFromObject(object.transform);
        const glm::dmat3 eyeFromObject(eyeFromWorld * placement);
        // A mirror swaps a triangle's sides, and the shader turns the normals of back sides: they must swap along.
        const double handedness = glm::determinant(eyeFromObject) < 0.0 ? -1.0 : 1.0;
        const glm::mat3 normalMatrix(handedness * glm::transpose(glm::inverse(eyeFromObject)));
        glUniformMatrix3fv(location("eyeNormalFromObject"), 1, GL_FALSE, glm::value_ptr(normalMatrix));
        glUniformMatrix3fv(location("eyeFromObject"), 1, GL_FALSE, glm::value_ptr(glm::mat3(eyeFromObject)));
        glUniform1ui(location("object"), static_cast<GLuint>(i + 1));
        for (const auto &mesh : model.meshes) {
            // Products in double: only the final matrix is rounded to what the GPU takes, which multiplies in float. A
            // mesh far from its object's origin would lose its digits there, and the depths with them; about its own
            // origin it keeps them.
            const glm::dmat4 worldFromUploaded = glm::translate(placement, mesh->origin);
            const glm::mat4 clipFromUploaded(clipFromWorld * worldFromUploaded);
            glUniformMatrix4fv(location("clipFromObject"), 1, GL_FALSE, glm::value_ptr(clipFromUploaded));
            setClipPlanes(clipPlanes, worldFromUploaded);
            m_program->setUniformValue("baseColor", mesh->baseColor.r, mesh->baseColor.g, mesh->baseColor.b,
                                       mesh->baseColor.a);
            m_program->setUniformValue("isTextured", mesh->texture >= 0);
            if (mesh->texture >= 0)
                model.textures[static_cast<std::size_t>(mesh->texture)]->bind(0);
            m_program->setUniformValue("isFlat", mesh->isFlat);
            m_program->setUniformValue("isPoint", mesh->primitives == GL_POINTS);
            // A vertex array without colours takes this constant: white.
            glVertexAttrib4f(Color, 1.0f, 1.0f, 1.0f, 1.0f);
            mesh->vertexArray.bind();
            if (mesh->isIndexed)
                glDrawElements(mesh->primitives, mesh->elementCount, GL_UNSIGNED_INT, nullptr);
            else
                glDrawArrays(mesh->primitives, 0, mesh->elementCount);
            mesh->vertexArray.release();
        }
    }
    for (std::size_t i = 0; i < planeCount; ++i)
        glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    m_program->release();
}

} // namespace unprojector::gui
