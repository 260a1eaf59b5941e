#include "gui/painters/mesh_painter.h"

#include "gui/painters/shader.h"

#include <QImage>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <set>

namespace unprojector::gui {

struct MeshPainter::GpuMesh {
    QOpenGLVertexArrayObject vertexArray;
    std::vector<std::unique_ptr<QOpenGLBuffer>> buffers;
    GLsizei indexCount = 0;
    glm::vec4 baseColor;
    int texture = -1;
};

struct MeshPainter::GpuModel {
    glm::dvec3 center;                   ///< object space; the uploaded positions are relative to it
    std::shared_ptr<const Model> source; ///< keeps the key of the map alive
    std::vector<std::unique_ptr<GpuMesh>> meshes;
    std::vector<std::unique_ptr<QOpenGLTexture>> textures; ///< null where the image could not be decoded
};

namespace {

// OpenGL's name; QOpenGL's headers stop at those of OpenGL ES.
#ifndef GL_CLIP_DISTANCE0
#define GL_CLIP_DISTANCE0 0x3000
#endif

enum Attribute : GLuint { kPosition, kNormal, kColor, kTexcoord };

/// QOpenGLBuffer counts bytes in int, which ends at 2 GB; glBufferData does not.
template <class T>
std::unique_ptr<QOpenGLBuffer> filledBuffer(QOpenGLExtraFunctions &gl, QOpenGLBuffer::Type type,
                                            const std::vector<T> &data)
{
    auto buffer = std::make_unique<QOpenGLBuffer>(type);
    buffer->create();
    buffer->bind();
    gl.glBufferData(type, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
    return buffer;
}

/// The GPU multiplies in float: a model far from its origin would lose its digits there, and the depths with them. About
/// its own centre it keeps them; the way back is part of the matrix, which is made in double.
glm::dvec3 centerOf(const Model &model)
{
    return model.bounds.isEmpty() ? glm::dvec3(0.0) : glm::dvec3(glm::vec3(model.bounds.center()));
}

std::vector<glm::vec3> relativeTo(const glm::dvec3 &center, const std::vector<glm::vec3> &positions)
{
    std::vector<glm::vec3> relative;
    relative.reserve(positions.size());
    for (const glm::vec3 &position : positions)
        relative.emplace_back(position - glm::vec3(center));
    return relative;
}

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

MeshPainter::MeshPainter() = default;
MeshPainter::~MeshPainter() = default;

void MeshPainter::initialize()
{
    initializeOpenGLFunctions();
    m_program = loadProgram(QStringLiteral("mesh"));
}

void MeshPainter::release()
{
    m_models.clear();
    m_program.reset();
}

void MeshPainter::upload(const std::vector<SceneObject> &objects)
{
    std::set<const Model *> shown;
    for (const SceneObject &object : objects)
        shown.insert(object.model.get());
    std::erase_if(m_models, [&shown](const auto &entry) { return !shown.contains(entry.first); });
    for (const SceneObject &object : objects) {
        auto &slot = m_models[object.model.get()];
        if (!slot)
            slot = uploaded(object.model);
    }
}

std::unique_ptr<MeshPainter::GpuModel> MeshPainter::uploaded(const std::shared_ptr<const Model> &model)
{
    auto gpu = std::make_unique<GpuModel>();
    gpu->source = model;
    gpu->center = centerOf(*model);
    for (const Texture &texture : model->textures)
        gpu->textures.push_back(decoded(texture));
    for (const Mesh &mesh : model->meshes) {
        auto target = std::make_unique<GpuMesh>();
        target->vertexArray.create();
        target->vertexArray.bind();
        const auto attribute = [&](GLuint index, const auto &data, GLint size, GLenum type, GLboolean normalized) {
            if (data.empty())
                return;
            target->buffers.push_back(filledBuffer(*this, QOpenGLBuffer::VertexBuffer, data));
            glEnableVertexAttribArray(index);
            glVertexAttribPointer(index, size, type, normalized, 0, nullptr);
        };
        attribute(kPosition, relativeTo(gpu->center, mesh.positions), 3, GL_FLOAT, GL_FALSE);
        attribute(kNormal, mesh.normals, 3, GL_FLOAT, GL_FALSE);
        attribute(kColor, mesh.colors, 4, GL_UNSIGNED_BYTE, GL_TRUE);
        attribute(kTexcoord, mesh.texcoords, 2, GL_FLOAT, GL_FALSE);
        target->buffers.push_back(filledBuffer(*this, QOpenGLBuffer::IndexBuffer, mesh.indices));
        target->vertexArray.release();
        target->indexCount = static_cast<GLsizei>(mesh.indices.size());
        const bool isTextured = mesh.texture >= 0 && gpu->textures[static_cast<std::size_t>(mesh.texture)];
        target->texture = isTextured ? mesh.texture : -1;
        target->baseColor = mesh.baseColor;
        gpu->meshes.push_back(std::move(target));
    }
    return gpu;
}

void MeshPainter::draw(const std::vector<SceneObject> &objects, const glm::dmat4 &clipFromWorld,
                       const glm::dmat4 &eyeFromWorld, const std::vector<glm::dvec4> &clipPlanes)
{
    m_program->bind();
    m_program->setUniformValue("baseTexture", 0);
    const auto location = [this](const char *name) { return m_program->uniformLocation(name); };
    for (std::size_t i = 0; i < clipPlanes.size(); ++i) {
        const glm::vec4 plane(clipPlanes[i]);
        const QByteArray name = "clipPlanes[" + QByteArray::number(static_cast<int>(i)) + "]";
        glUniform4fv(location(name.constData()), 1, glm::value_ptr(plane));
        glEnable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    }
    for (const SceneObject &object : objects) {
        const GpuModel &model = *m_models.at(object.model.get());
        // Products in double: only the final matrix is rounded to what the GPU takes.
        const glm::dmat4 placement = worldFromObject(object.transform);
        const glm::dmat4 worldFromUploaded = placement * glm::translate(glm::dmat4(1.0), model.center);
        const glm::mat4 clipFromObject(clipFromWorld * worldFromUploaded);
        const glm::dmat3 eyeFromObject(eyeFromWorld * placement);
        // A mirror swaps a triangle's sides, and the shader turns the normals of back sides: they must swap along.
        const double handedness = glm::determinant(eyeFromObject) < 0.0 ? -1.0 : 1.0;
        const glm::mat3 normalMatrix(handedness * glm::transpose(glm::inverse(eyeFromObject)));
        glUniformMatrix4fv(location("clipFromObject"), 1, GL_FALSE, glm::value_ptr(clipFromObject));
        glUniformMatrix4fv(location("worldFromObject"), 1, GL_FALSE, glm::value_ptr(glm::mat4(worldFromUploaded)));
        glUniformMatrix3fv(location("eyeNormalFromObject"), 1, GL_FALSE, glm::value_ptr(normalMatrix));
        for (const auto &mesh : model.meshes) {
            m_program->setUniformValue("baseColor", mesh->baseColor.r, mesh->baseColor.g, mesh->baseColor.b,
                                       mesh->baseColor.a);
            m_program->setUniformValue("isTextured", mesh->texture >= 0);
            if (mesh->texture >= 0)
                model.textures[static_cast<std::size_t>(mesh->texture)]->bind(0);
            // A vertex array without colours takes this constant: white.
            glVertexAttrib4f(kColor, 1.0f, 1.0f, 1.0f, 1.0f);
            mesh->vertexArray.bind();
            glDrawElements(GL_TRIANGLES, mesh->indexCount, GL_UNSIGNED_INT, nullptr);
            mesh->vertexArray.release();
        }
    }
    for (std::size_t i = 0; i < clipPlanes.size(); ++i)
        glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    m_program->release();
}

} // namespace unprojector::gui
