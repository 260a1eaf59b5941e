#include "gui/painters/mesh_painter.h"

#include "core/geometry/view_volume.h"
#include "gui/painters/mesh_attributes.h"
#include "gui/painters/shader.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace unprojector::gui {
namespace {

// OpenGL's name; QOpenGL's headers stop at those of OpenGL ES.
#ifndef GL_CLIP_DISTANCE0
#define GL_CLIP_DISTANCE0 0x3000
#endif

/// OpenGL guarantees as many.
constexpr std::size_t kClipDistances = 8;

/// Drawn in a few milliseconds without a graphics card. Whole triangles.
constexpr std::size_t kElementsAtOnce = 3 * 50'000;

} // namespace

struct MeshPainter::Entry {
    std::shared_ptr<const Model> source; ///< keeps the key of the map alive
    GpuModel uploaded;
};

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

void MeshPainter::keepOnly(const std::set<const Model *> &models)
{
    std::erase_if(m_models, [&models](const auto &entry) { return !models.contains(entry.first); });
}

GpuModel &MeshPainter::modelOf(const std::shared_ptr<const Model> &model)
{
    std::unique_ptr<Entry> &entry = m_models[model.get()];
    if (!entry)
        entry.reset(new Entry{model, GpuModel(model)});
    return entry->uploaded;
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

bool MeshPainter::drawOn(const FrameContents &contents, Place &place, const Deadline &deadline)
{
    m_program->bind();
    m_program->setUniformValue("baseTexture", 0);
    const std::size_t planeCount = std::min(contents.clipPlanes.size(), kClipDistances);
    for (std::size_t i = 0; i < planeCount; ++i)
        glEnable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    bool isDone = true;
    while (isDone && place.object < contents.objects.size()) {
        const SceneObject &object = contents.objects[place.object];
        isDone = object.isHidden || drawObject(contents, object, place, deadline);
        if (isDone)
            place = {place.object + 1};
    }
    for (std::size_t i = 0; i < planeCount; ++i)
        glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    m_program->release();
    return isDone;
}

/// @return whether all of it is drawn
bool MeshPainter::drawObject(const FrameContents &contents, const SceneObject &object, Place &place,
                             const Deadline &deadline)
{
    GpuModel &model = modelOf(object.model);
    const bool isUploaded = model.uploadOn(deadline);
    m_failures << model.takeFailures();
    if (!isUploaded)
        return false;
    const auto location = [this](const char *name) { return m_program->uniformLocation(name); };
    const glm::dmat4 placement = worldFromObject(object.transform);
    const glm::dmat3 eyeFromObject(contents.eyeFromWorld * placement);
    // A mirror swaps a triangle's sides, and the shader turns the normals of back sides: they must swap along.
    const double handedness = glm::determinant(eyeFromObject) < 0.0 ? -1.0 : 1.0;
    const glm::mat3 normalMatrix(handedness * glm::transpose(glm::inverse(eyeFromObject)));
    glUniformMatrix3fv(location("eyeNormalFromObject"), 1, GL_FALSE, glm::value_ptr(normalMatrix));
    glUniformMatrix3fv(location("eyeFromObject"), 1, GL_FALSE, glm::value_ptr(glm::mat3(eyeFromObject)));
    glUniform1ui(location("object"), static_cast<GLuint>(place.object + 1));
    for (; place.mesh < model.meshes().size(); ++place.mesh, place.element = 0) {
        const GpuMesh &mesh = *model.meshes()[place.mesh];
        // Products in double: only the final matrix is rounded to what the GPU takes, which multiplies in float. A mesh
        // far from its object's origin would lose its digits there, and the depths with them; about its own origin it
        // keeps them.
        const glm::dmat4 worldFromUploaded = glm::translate(placement, mesh.origin);
        const glm::mat4 clipFromUploaded(contents.clipFromWorld * worldFromUploaded);
        glUniformMatrix4fv(location("clipFromObject"), 1, GL_FALSE, glm::value_ptr(clipFromUploaded));
        setClipPlanes(contents.clipPlanes, worldFromUploaded);
        m_program->setUniformValue("baseColor", mesh.baseColor.r, mesh.baseColor.g, mesh.baseColor.b, mesh.baseColor.a);
        m_program->setUniformValue("isTextured", mesh.texture >= 0);
        if (mesh.texture >= 0)
            model.texture(mesh.texture).bind(0);
        if (!drawMesh(mesh, place, deadline))
            return false;
    }
    return true;
}

/// @return whether all of it is drawn
bool MeshPainter::drawMesh(const GpuMesh &mesh, Place &place, const Deadline &deadline)
{
    m_program->setUniformValue("isFlat", mesh.isFlat);
    m_program->setUniformValue("isPoint", mesh.primitives == GL_POINTS);
    // A vertex array without colours takes this constant: white.
    glVertexAttrib4f(MeshAttribute::Color, 1.0f, 1.0f, 1.0f, 1.0f);
    QOpenGLVertexArrayObject::Binder bound(const_cast<QOpenGLVertexArrayObject *>(&mesh.vertexArray));
    while (place.element < mesh.elementCount) {
        if (deadline.isOver())
            return false;
        const std::size_t left = mesh.elementCount - place.element;
        // Whoever waits for all of it waits less for one large piece.
        const auto count = static_cast<GLsizei>(deadline.isNever() ? left : std::min(left, kElementsAtOnce));
        if (mesh.isIndexed)
            glDrawElements(mesh.primitives, count, GL_UNSIGNED_INT,
                           reinterpret_cast<const void *>(place.element * sizeof(std::uint32_t)));
        else
            glDrawArrays(mesh.primitives, static_cast<GLint>(place.element), count);
        if (!deadline.isNever())
            glFinish(); // or the pieces would only be queued, and be waited for all together
        place.element += static_cast<std::size_t>(count);
    }
    return true;
}

} // namespace unprojector::gui
