#include "gui/view/painters/mesh_painter.h"

#include "core/base/parallel.h"
#include "core/geometry/view_volume.h"
#include "core/scene/point_size.h"
#include "gui/view/painters/mesh_attributes.h"
#include "gui/view/painters/shader.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

// OpenGL's name; QOpenGL's headers contain only the names of OpenGL ES.
#ifndef GL_CLIP_DISTANCE0
#define GL_CLIP_DISTANCE0 0x3000
#endif
#ifndef GL_PROGRAM_POINT_SIZE
#define GL_PROGRAM_POINT_SIZE 0x8642
#endif

/// The number that OpenGL guarantees.
constexpr std::size_t kClipDistances = 8;

/// The colour of surfaces shown without their colours.
constexpr glm::vec4 kGrey(0.8f, 0.8f, 0.8f, 1.0f);

/// Drawn in a few milliseconds by a software renderer. Whole triangles.
constexpr std::size_t kElementsAtOnce = 3 * 50'000;

/// The numbers of elements from which triangles that cover a pixel's centre are gathered: at once,
/// and in one task.
constexpr std::size_t kGatheredAtOnce = 3 * 1'000'000, kGatheredInTask = 3 * 20'000;

/// The largest absolute value of each coordinate of a mesh, from the box around its whole model.
glm::dvec3 reachOf(const Mesh &mesh, const Box &bounds)
{
    return glm::max(glm::abs(bounds.lowest - mesh.origin), glm::abs(bounds.highest - mesh.origin));
}

/// The power of two at a size; 1 for 0.
double powerAt(double size)
{
    return size > 0.0 && std::isfinite(size) ? std::exp2(std::ilogb(size)) : 1.0;
}

double largestEntry(const glm::dmat3 &m)
{
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        largest = std::max({largest, std::abs(m[column].x), std::abs(m[column].y), std::abs(m[column].z)});
    return largest;
}

/// Scales clip coordinates, which are homogeneous, by a power of two: products for very large or
/// very small meshes then stay in the range of single precision. Other meshes stay unchanged.
glm::mat4 withinSingles(const glm::dmat4 &clipFromUploaded, const glm::dvec3 &reach)
{
    double size = 0.0;
    for (int row = 0; row < 4; ++row)
        size =
            std::max(size, std::abs(clipFromUploaded[0][row]) * reach.x + std::abs(clipFromUploaded[1][row]) * reach.y
                               + std::abs(clipFromUploaded[2][row]) * reach.z + std::abs(clipFromUploaded[3][row]));
    constexpr double kLarge = 0x1p60, kWanted = 0x1p30;
    if (size > kLarge)
        return glm::mat4(clipFromUploaded * (kWanted / powerAt(size)));
    if (size < 1.0 / kLarge)
        return glm::mat4(clipFromUploaded * (1.0 / kWanted / powerAt(size)));
    return glm::mat4(clipFromUploaded);
}

} // namespace

struct MeshPainter::Entry {
    std::shared_ptr<const Model> source; ///< keeps the map's key alive
    GpuModel uploaded;
    bool hasCurvature = false;   ///< to be drawn
    bool hasToldOfEdges = false; ///< a mesh is too large for them
};

MeshPainter::MeshPainter() = default;
MeshPainter::~MeshPainter() = default;

void MeshPainter::initialize(ObjectIds ids, bool isSoftware)
{
    initializeOpenGLFunctions();
    m_isSoftware = isSoftware;
    m_coveringBuffer.setUsagePattern(QOpenGLBuffer::StreamDraw);
    m_coveringBuffer.create();
    m_edges.initialize();
    m_ids = ids;
}

void MeshPainter::release()
{
    m_models.clear();
    m_coveringBuffer.destroy();
    m_edges.release();
    m_programs.clear();
}

QStringList MeshPainter::takeFailures()
{
    return std::exchange(m_failures, {});
}

void MeshPainter::keepOnly(const std::set<const Model *> &models)
{
    std::erase_if(m_models, [&models](const auto &entry) { return !models.contains(entry.first); });
}

MeshPainter::Entry &MeshPainter::entryOf(const std::shared_ptr<const Model> &model)
{
    std::unique_ptr<Entry> &entry = m_models[model.get()];
    if (!entry)
        entry.reset(new Entry{model, GpuModel(model)});
    return *entry;
}

void MeshPainter::bindProgram(unsigned traits)
{
    std::unique_ptr<QOpenGLShaderProgram> &program = m_programs[traits];
    if (!program) {
        QByteArrayList definitions;
        if (m_ids == ObjectIds::Colors)
            definitions << "OBJECT_IDS_ARE_COLORS";
        constexpr std::array<std::pair<Trait, const char *>, 9> kNames{{{Clipped, "CLIPPED"},
                                                                        {Points, "POINTS"},
                                                                        {Flat, "FLAT"},
                                                                        {Colored, "COLORED"},
                                                                        {Textured, "TEXTURED"},
                                                                        {SideLit, "SIDE_LIT"},
                                                                        {Curved, "CURVED"},
                                                                        {Edges, "EDGES"},
                                                                        {Indexed, "INDEXED"}}};
        for (const auto &[trait, name] : kNames) {
            if (traits & trait)
                definitions << name;
        }
        program = loadProgram(QStringLiteral("mesh"), definitions);
    }
    if (m_program == program.get())
        return;
    m_program = program.get();
    m_program->bind();
}

/// Cuts the model at the planes. Disabling distances is not enough: Mesa's software renderers
/// sometimes use an older set. So unused distances get a plane that cuts nothing.
void MeshPainter::setClipPlanes(const std::vector<glm::dvec4> &planes, const glm::dmat4 &worldFromUploaded)
{
    std::array<glm::vec4, kClipDistances> distances;
    distances.fill(glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    for (std::size_t i = 0; i < std::min(planes.size(), kClipDistances); ++i) {
        // The plane is computed in double, relative to the mesh's origin, so that it cuts exactly
        // far from the origin too.
        const glm::dvec4 plane = planeInSource(planes[i], worldFromUploaded);
        const double length = glm::length(glm::dvec3(plane));
        distances[i] = glm::vec4(length > 0.0 ? plane / length : plane);
    }
    glUniform4fv(m_program->uniformLocation("clipPlanes"), static_cast<GLsizei>(kClipDistances),
                 glm::value_ptr(distances[0]));
}

bool MeshPainter::drawOn(const FrameContents &contents, Place &place, const Deadline &deadline)
{
    const std::size_t planeCount = std::min(contents.clipPlanes.size(), kClipDistances);
    m_program = nullptr;
    glEnable(GL_PROGRAM_POINT_SIZE);
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
    glDisable(GL_PROGRAM_POINT_SIZE);
    glUseProgram(0);
    return isDone;
}

double MeshPainter::shareDone(const FrameContents &contents, const Place &place) const
{
    // Shares of the time with a software renderer.
    constexpr double kUpload = 0.25, kDraw = 1.0 - kUpload;
    double all = 0.0, done = 0.0;
    for (std::size_t number = 0; number < contents.objects.size(); ++number) {
        const SceneObject &object = contents.objects[number];
        if (object.isHidden)
            continue;
        std::size_t size = 0, drawn = 0;
        for (std::size_t mesh = 0; mesh < object.model->meshes.size(); ++mesh) {
            const std::size_t ofMesh = object.model->meshes[mesh].elementCount();
            size += ofMesh;
            if (number < place.object || (number == place.object && mesh < place.mesh))
                drawn += ofMesh;
            else if (number == place.object && mesh == place.mesh)
                drawn += std::min(place.element, ofMesh);
        }
        const auto uploaded = m_models.find(object.model.get());
        all += static_cast<double>(size);
        done += kDraw * static_cast<double>(drawn);
        if (uploaded != m_models.end())
            done += kUpload * uploaded->second->uploaded.uploadedShare() * static_cast<double>(size);
    }
    return all > 0.0 ? std::min(done / all, 1.0) : 1.0;
}

bool MeshPainter::hidesBackSides(const FrameContents &contents, const SceneObject &object) const
{
    if (!contents.clipPlanes.empty() || object.model->bounds.isEmpty())
        return false;
    const Box &box = object.model->bounds;
    const glm::dmat4 clipFromObject = contents.clipFromWorld * worldFromObject(object.transform);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 isHigh(corner & 1, corner & 2, corner & 4);
        const glm::dvec4 clip = clipFromObject * glm::dvec4(glm::mix(box.lowest, box.highest, isHigh), 1.0);
        if (!(clip.w > 0.0 && clip.z > -clip.w))
            return false;
    }
    return true;
}

/// @return whether all of it is drawn
bool MeshPainter::drawObject(const FrameContents &contents, const SceneObject &object, Place &place,
                             const Deadline &deadline)
{
    Entry &entry = entryOf(object.model);
    GpuModel &model = entry.uploaded;
    const bool isUploaded = model.uploadOn(deadline);
    if (isUploaded) {
        const auto curvature = m_shading.curvatures.find(object.model);
        entry.hasCurvature = curvature != m_shading.curvatures.end() && model.uploadCurvature(curvature->second);
    }
    m_failures << model.takeFailures();
    if (!isUploaded)
        return false;
    const glm::dmat4 placement = worldFromObject(object.transform);
    const glm::dmat3 eyeFromObject(contents.eyeFromWorld * placement);
    // A mirror swaps a triangle's sides, and the shader flips the normals of back sides: both must
    // agree.
    const double handedness = glm::determinant(eyeFromObject) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 eyeNormalFromObject = handedness * glm::transpose(glm::inverse(eyeFromObject));
    // Only directions matter, and squares of lengths must stay in single precision.
    const glm::mat3 normalMatrix(eyeNormalFromObject / powerAt(largestEntry(eyeNormalFromObject)));
    const bool areBackSidesHidden = hidesBackSides(contents, object);
    // The winding of triangles in the view: a mirror in object or projection swaps it.
    const glm::dmat4 clipFromEye = contents.clipFromWorld * glm::inverse(contents.eyeFromWorld);
    const double turn = handedness * glm::determinant(glm::dmat2(clipFromEye));
    for (; place.mesh < model.meshes().size(); ++place.mesh, place.element = 0) {
        const GpuMesh &mesh = *model.meshes()[place.mesh];
        const bool isPoints = mesh.primitives == GL_POINTS;
        const glm::dvec3 reach = reachOf(*mesh.source, object.model->bounds);
        // A software renderer spends a fifth of the time on clip distances, enabled or not.
        unsigned traits = isPoints ? unsigned{Points} : mesh.isFlat ? unsigned{Flat} : 0U;
        traits |= contents.clipPlanes.empty() ? 0U : unsigned{Clipped};
        if (m_shading.hasColors) {
            traits |= mesh.isColored ? unsigned{Colored} : 0U;
            traits |= mesh.texture >= 0 ? unsigned{Textured} : 0U;
        }
        const Drawable &drawn = contents.drawn;
        const auto pixels = static_cast<std::size_t>(drawn.width) * static_cast<std::size_t>(drawn.height);
        const bool isCovering =
            m_isSoftware && !isPoints && mesh.elementCount / 3 > pixels && !object.model->bounds.isEmpty();
        if (!isPoints)
            traits |= shadingTraits(contents, entry, mesh);
        if ((traits & Edges) && (mesh.isIndexed || isCovering))
            traits |= Indexed;
        bindProgram(traits);
        const auto location = [this](const char *name) { return m_program->uniformLocation(name); };
        glUniform1ui(location("object"), static_cast<GLuint>(place.object + 1));
        if (isPoints)
            glUniform1f(location("pointPixels"), static_cast<float>(pointPixels(contents.drawn.setup.surface)));
        else if (mesh.isFlat) {
            const double size = largestEntry(eyeFromObject) * std::max({reach.x, reach.y, reach.z});
            // Keeps the matrix and its products with positions in the range of single precision.
            const double wanted = size > 1.0 ? 0x1p30 : 1.0;
            const glm::mat3 eyeMatrix(eyeFromObject * (wanted / powerAt(size)));
            glUniformMatrix3fv(location("eyeFromObject"), 1, GL_FALSE, glm::value_ptr(eyeMatrix));
        } else
            glUniformMatrix3fv(location("eyeNormalFromObject"), 1, GL_FALSE, glm::value_ptr(normalMatrix));
        // Products in double: only the final matrix is rounded to float, in which the GPU
        // multiplies. A mesh far from its object's origin would lose digits, and its depths with
        // them; relative to its own origin it keeps them.
        const glm::dmat4 worldFromUploaded = glm::translate(placement, mesh.origin);
        const glm::mat4 clipFromUploaded = withinSingles(contents.clipFromWorld * worldFromUploaded, reach);
        glUniformMatrix4fv(location("clipFromObject"), 1, GL_FALSE, glm::value_ptr(clipFromUploaded));
        if (!contents.clipPlanes.empty())
            setClipPlanes(contents.clipPlanes, worldFromUploaded);
        const glm::vec4 &color = m_shading.hasColors ? mesh.baseColor : kGrey;
        m_program->setUniformValue("baseColor", color.r, color.g, color.b, color.a);
        setShadingValues(traits, contents, mesh, turn >= 0.0);
        if (traits & Textured) {
            m_program->setUniformValue("baseTexture", 0);
            model.texture(mesh.texture).bind(0);
        }
        std::optional<CoveringTriangles> covering;
        if (isCovering)
            covering.emplace(*mesh.source, clipFromUploaded, glm::ivec4(drawn.x, drawn.y, drawn.width, drawn.height),
                             reach);
        // else all vertices would be transformed for a few triangles
        if (covering && mesh.isIndexed && deadline.isNever())
            covering->placeVertices();
        // A software renderer spends more than half the time of a closed mesh on back sides.
        const bool isHalfDrawn = areBackSidesHidden && mesh.source->isClosed && turn != 0.0;
        if (isHalfDrawn) {
            glEnable(GL_CULL_FACE);
            glCullFace(turn > 0.0 ? GL_BACK : GL_FRONT);
        }
        const bool isDone = drawMesh(mesh, covering ? &*covering : nullptr, (traits & Edges) != 0, place, deadline);
        if (isHalfDrawn)
            glDisable(GL_CULL_FACE);
        if (!isDone)
            return false;
    }
    return true;
}

unsigned MeshPainter::shadingTraits(const FrameContents &contents, Entry &entry, const GpuMesh &mesh)
{
    unsigned traits = m_shading.sideLight ? unsigned{SideLit} : 0U;
    traits |= entry.hasCurvature ? unsigned{Curved} : 0U;
    if (!m_shading.hasEdges || contents.areStandIns)
        return traits;
    if (m_edges.canTake(mesh))
        return traits | Edges;
    if (!std::exchange(entry.hasToldOfEdges, true))
        m_failures << m_edges.refusal(QString::fromStdString(entry.source->name));
    return traits;
}

void MeshPainter::setShadingValues(unsigned traits, const FrameContents &contents, const GpuMesh &mesh,
                                   bool isFrontOutside)
{
    if (traits & SideLit)
        m_program->setUniformValue("sideLight", m_shading.sideLight->x, m_shading.sideLight->y, m_shading.sideLight->z);
    if (traits & Curved)
        m_program->setUniformValue("ridgeSign", isFrontOutside ? 1.0f : -1.0f);
    if (traits & Edges) {
        const Drawable &drawn = contents.drawn;
        m_edges.begin(*m_program, mesh, glm::vec4(drawn.x, drawn.y, drawn.width, drawn.height),
                      drawn.setup.surface.devicePixelRatio);
    }
}

/// Draws these triangles of a bound mesh.
/// @param begin, end  corners
void MeshPainter::drawCovering(const CoveringTriangles &covering, bool hasEdges, std::size_t begin, std::size_t end)
{
    std::vector<std::vector<std::uint32_t>> parts((end - begin + kGatheredInTask - 1) / kGatheredInTask);
    base::inParallel(parts.size(), {}, [&](std::size_t number) {
        const std::size_t first = begin + number * kGatheredInTask;
        covering.append(first, std::min(end, first + kGatheredInTask), parts[number]);
    });
    for (std::size_t i = 1; i < parts.size(); ++i)
        parts[0].insert(parts[0].end(), parts[i].begin(), parts[i].end());
    if (parts.empty() || parts[0].empty())
        return;
    if (!fillBuffer(*this, GL_ELEMENT_ARRAY_BUFFER, parts[0].size() * sizeof(std::uint32_t), parts[0].data()))
        return;
    if (hasEdges)
        m_edges.setPart(*m_program, m_coveringBuffer.bufferId(), 0);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(parts[0].size()), GL_UNSIGNED_INT, nullptr);
}

/// @param covering  nothing: all triangles are drawn
/// @return whether all of it is drawn
bool MeshPainter::drawMesh(const GpuMesh &mesh, const CoveringTriangles *covering, bool hasEdges, Place &place,
                           const Deadline &deadline)
{
    QOpenGLVertexArrayObject::Binder bound(const_cast<QOpenGLVertexArrayObject *>(&mesh.vertexArray));
    if (covering)
        m_coveringBuffer.bind();
    while (place.element < mesh.elementCount) {
        if (deadline.isOver())
            break;
        const std::size_t left = mesh.elementCount - place.element;
        // Large pieces are faster without a deadline.
        const std::size_t count = std::min(left, !deadline.isNever() ? kElementsAtOnce
                                                 : covering          ? kGatheredAtOnce
                                                                     : mesh.elementCount);
        if (hasEdges && !covering)
            m_edges.setPart(*m_program, mesh.indexBuffer, place.element / 3);
        if (covering)
            drawCovering(*covering, hasEdges, place.element, place.element + count);
        else if (mesh.isIndexed)
            glDrawElements(mesh.primitives, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                           reinterpret_cast<const void *>(place.element * sizeof(std::uint32_t)));
        else
            glDrawArrays(mesh.primitives, static_cast<GLint>(place.element), static_cast<GLsizei>(count));
        if (!deadline.isNever())
            glFinish(); // the pieces would otherwise only be queued and run together later
        place.element += count;
    }
    if (covering)
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indexBuffer); // it is part of the vertex array
    if (hasEdges)
        m_edges.end();
    return place.element >= mesh.elementCount;
}

} // namespace unprojector::gui
