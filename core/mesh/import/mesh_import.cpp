#include "core/mesh/import/mesh_import.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/system_error.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"
#include "core/geometry/finite.h"
#include "core/mesh/import/file_bytes.h"
#include "core/mesh/import/file_contents.h"
#include "core/mesh/import/mesh_normals.h"
#include "core/mesh/import/mesh_reader.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>
#include <system_error>

namespace unprojector::mesh {
using namespace base;
using namespace geometry;

namespace reader {

namespace {

/// The number of elements in a task of a few milliseconds.
constexpr std::size_t kElementsInTask = 1 << 18;
/// Larger meshes get no computed normals: that would take a second and a third of the memory, and
/// triangles this small on the screen look no better smooth.
constexpr std::size_t kMostTrianglesToSmooth = 3000000;

bool hasUsableNormals(const Mesh &mesh)
{
    if (mesh.normals.size() != mesh.positions.size())
        return false;
    std::atomic<bool> isUsable = true;
    inParallelRanges(mesh.elementCount(), kElementsInTask, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t element = begin; element < end; ++element) {
            const glm::vec3 &normal = mesh.normals[mesh.vertexAt(element)];
            if (!isFinite(normal) || normal == glm::vec3(0.0f)) {
                isUsable = false;
                return;
            }
        }
    });
    return isUsable;
}

/// Checks the invariants that every reader must keep, so that drawing and ray casting need not.
/// @param firstVertex  of the mesh in the model, for messages
/// @return the bounding box of the shown elements
Box checkMesh(Mesh &mesh, std::size_t firstVertex, const std::function<void(double)> &report)
{
    const std::size_t vertexCount = mesh.positions.size();
    Box bounds;
    std::mutex mutex;
    const auto add = [&](const ShownBox &own) {
        const std::lock_guard lock(mutex);
        bounds.add(own.box());
    };
    const auto half = [&report](double from) { return [&report, from](double share) { report(from + share / 2.0); }; };
    inParallelRanges(vertexCount, kElementsInTask, half(0.0), [&](std::size_t begin, std::size_t end) {
        ShownBox own;
        for (std::size_t v = begin; v < end; ++v) {
            const glm::vec3 &position = mesh.positions[v];
            // A cheap test first: the sum of finite numbers may overflow, but rarely does.
            if (!std::isfinite(position.x + position.y + position.z) && !isFinite(position))
                failNotFinite(firstVertex + v);
            if (mesh.indices.empty())
                own.add(mesh, v);
        }
        add(own);
    });
    inParallelRanges(mesh.indices.size(), kElementsInTask, half(0.5), [&](std::size_t begin, std::size_t end) {
        ShownBox own;
        for (std::size_t i = begin; i < end; ++i) {
            if (mesh.indices[i] >= vertexCount)
                failMalformed(tr("a face refers to vertex %1, the mesh has %2", mesh.indices[i], vertexCount));
            own.add(mesh, mesh.indices[i]);
        }
        add(own);
    });
    if (mesh.colors.size() != vertexCount)
        mesh.colors.clear();
    if (mesh.texcoords.size() != vertexCount)
        mesh.texcoords.clear();
    for (glm::vec2 &texcoord : mesh.texcoords) {
        if (!isFinite(texcoord))
            texcoord = glm::vec2(0.0f);
    }
    return bounds;
}

/// The number of triangles with equal or collinear corners. Differences of floats are exact or
/// nearly so in double, and so are the results computed from them: only triangles without area are
/// counted.
std::size_t flatTriangles(const Mesh &mesh)
{
    std::atomic<std::size_t> count = 0;
    inParallelRanges(mesh.triangleCount(), kElementsInTask / 3, {}, [&](std::size_t begin, std::size_t end) {
        std::size_t own = 0;
        for (std::size_t triangle = begin; triangle < end; ++triangle) {
            const auto corner = [&](std::size_t k) {
                return glm::dvec3(mesh.positions[mesh.vertexAt(3 * triangle + k)]);
            };
            const glm::dvec3 a = corner(0), u = corner(1) - a, v = corner(2) - a;
            own += glm::cross(u, v) == glm::dvec3(0.0) ? 1U : 0U;
        }
        count += own;
    });
    return count;
}

/// Adds notes for valid parts of a model that can be neither seen nor clicked.
void noteWhatIsNotSeen(Model &model)
{
    std::size_t flat = 0;
    for (const Mesh &mesh : model.meshes)
        flat += flatTriangles(mesh);
    addNote(model.notes, flat,
            marked("not drawn: %1 triangle whose corners are equal or on one line in single precision"),
            marked("not drawn: %1 triangles whose corners are equal or on one line in single precision"));
    // Graphics cards flush values below 1.2e-38 to 0; this margin keeps the digits of floats.
    constexpr double kLeastDrawn = 1e-30;
    const glm::dvec3 size = model.bounds.highest - model.bounds.lowest;
    const double largest = std::max({size.x, size.y, size.z});
    if (largest > 0.0 && largest < kLeastDrawn)
        model.notes.push_back(
            {marked("cannot be drawn: graphics cards round %1, which the model measures, to 0 or to few "
                    "digits; scale it up"),
             {shortestText(largest)}});
}

/// Keeps usable normals, and computes missing ones if that pays off.
void finishNormals(Mesh &mesh, const std::function<void(double)> &report)
{
    if (mesh.kind == Mesh::Kind::Triangles && hasUsableNormals(mesh))
        return;
    mesh.normals = {};
    if (mesh.kind == Mesh::Kind::Triangles && !mesh.indices.empty() && mesh.triangleCount() <= kMostTrianglesToSmooth)
        makeNormals(mesh, report);
}

/// Numbers the vertices in their order if the reader has set no numbers.
void numberVertices(Model &model)
{
    if (std::any_of(model.meshes.begin(), model.meshes.end(),
                    [](const Mesh &mesh) { return !mesh.vertexNumbers.empty(); }))
        return;
    std::uint32_t number = 0;
    for (Mesh &mesh : model.meshes) {
        mesh.vertexNumbers.resize(mesh.positions.size());
        std::iota(mesh.vertexNumbers.begin(), mesh.vertexNumbers.end(), number);
        number += static_cast<std::uint32_t>(mesh.positions.size());
    }
}

/// Drops the vertices' numbers if they equal the order of the vertices.
void dropPlainNumbers(Model &model)
{
    std::uint32_t number = 0;
    for (const Mesh &mesh : model.meshes) {
        for (const std::uint32_t own : mesh.vertexNumbers) {
            if (own != number++)
                return;
        }
    }
    for (Mesh &mesh : model.meshes)
        mesh.vertexNumbers = {};
}

void finishModel(Model &model, base::Reporter &progress)
{
    std::erase_if(model.meshes, [](const Mesh &mesh) { return mesh.triangleCount() == 0 && mesh.pointCount() == 0; });
    if (model.meshes.empty())
        failEmpty();
    std::size_t total = 0;
    bool isSoup = false;
    for (const Mesh &mesh : model.meshes) {
        total += mesh.elementCount();
        isSoup = isSoup || (mesh.kind == Mesh::Kind::Triangles && mesh.indices.empty());
    }
    if (model.meshes.size() > 1)
        numberVertices(model);
    std::size_t firstVertex = 0;
    std::size_t done = 0;
    for (Mesh &mesh : model.meshes) {
        const auto reporting = [&](double from, double to) {
            return [&progress, &mesh, done, total, from, to](double share) {
                const double ofMesh = (from + share * (to - from)) * static_cast<double>(mesh.elementCount());
                progress.report((static_cast<double>(done) + ofMesh) / static_cast<double>(total));
            };
        };
        const std::size_t elements = mesh.elementCount();
        model.bounds.add(checkMesh(mesh, firstVertex, reporting(0.0, 0.1)));
        firstVertex += mesh.positions.size();
        finishNormals(mesh, reporting(0.1, 1.0));
        done += elements;
    }
    dropPlainNumbers(model);
    if (model.fileVertices == 0 && !isSoup)
        model.fileVertices = firstVertex;
    noteWhatIsNotSeen(model);
}

using Reader = Model (*)(const Source &);

Reader readerFor(const std::string &suffix)
{
    if (suffix == "stl")
        return readStl;
    if (suffix == "ply")
        return readPly;
    if (suffix == "off")
        return readOff;
    if (suffix == "obj")
        return readObj;
    if (suffix == "gltf" || suffix == "glb")
        return readGltf;
    return nullptr;
}

constexpr std::size_t kStartBytes = 512;

std::string startOf(const std::filesystem::path &file)
{
    std::error_code error;
    std::string start;
    if (!std::filesystem::is_regular_file(file, error))
        return start;
    start.resize(kStartBytes);
    std::ifstream stream(file, std::ios::binary);
    stream.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(stream.gcount()));
    return start;
}

/// Reads a file. If it fails, and the contents match another format than the name, the error says
/// so.
Model readAs(Reader reader, const Source &source)
{
    try {
        return reader(source);
    } catch (Damage &damage) {
        const std::string advice = adviceByContents(source.text().substr(0, kStartBytes), source.suffix);
        if (!advice.empty())
            damage.text += "; " + advice;
        throw;
    }
}

Model import(const std::filesystem::path &file, base::Reporter &progress)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw base::Error{.text = tr("there is no such file; check the name and the folder"),
                          .kind = base::Error::Kind::NoFile};
    if (status.type() == std::filesystem::file_type::directory)
        throw base::Error{.text = tr("this is a folder; give a model file in it"), .kind = base::Error::Kind::File};
    if (error) // links in a circle, for example: nothing is known of the contents
        failUnreadable(base::systemErrorText(error));
    const std::string suffix = lowerCaseSuffix(file);
    const Reader reader = readerFor(suffix);
    if (!reader) {
        const std::string advice = adviceByContents(startOf(file), suffix);
        throw base::Error{
            tr(advice.empty()
                   ? "this is not a model that can be read here; give OBJ, STL, PLY, OFF, glTF or GLB. For a camera, "
                     "use 'unproject scene' or Paste Camera"
                   : "this is not a model that can be read here; give OBJ, STL, PLY, OFF, glTF or GLB; %1",
               advice)};
    }

    progress.beginStage(0.0, 0.1);
    const FileBytes contents(file, &progress);
    if (contents.bytes().empty())
        throw base::Error{tr("the file is empty")};
    progress.beginStage(0.1, 0.7);
    std::string converted;
    const std::span<const std::uint8_t> bytes =
        reader == readGltf ? contents.bytes() : withoutByteOrderMark(contents.bytes(), converted);
    Model model = readAs(reader, Source{file, suffix, bytes, progress});
    gatherFilesOutside(model.notes);
    progress.beginStage(0.7, 1.0);
    finishModel(model, progress);
    model.name = utf8FromPath(file.stem());
    progress.report(1.0);
    return model;
}

} // namespace

std::vector<std::string_view> textPieces(std::string_view text,
                                         std::size_t (*nextEnd)(std::string_view text, std::size_t from))
{
    constexpr std::size_t kPieceBytes = 1 << 20; // a few milliseconds of work
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        const std::size_t size = text.size() <= kPieceBytes ? text.size() : nextEnd(text, kPieceBytes);
        pieces.push_back(text.substr(0, size));
        text.remove_prefix(size);
    }
    return pieces;
}

std::string lowerCaseSuffix(const std::filesystem::path &file)
{
    const std::string suffix = lowerCase(utf8FromPath(file.extension()));
    return suffix.empty() ? suffix : suffix.substr(1);
}

std::span<const std::uint8_t> withoutByteOrderMark(std::span<const std::uint8_t> bytes, std::string &converted)
{
    const auto begins = [&bytes](std::initializer_list<std::uint8_t> mark) {
        return bytes.size() >= mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin());
    };
    if (begins({0xef, 0xbb, 0xbf}))
        return bytes.subspan(3);
    const bool isLittle = begins({0xff, 0xfe});
    if (!isLittle && !begins({0xfe, 0xff}))
        return bytes;
    converted = base::utf8FromUtf16(bytes.subspan(2), isLittle ? std::endian::little : std::endian::big);
    return {reinterpret_cast<const std::uint8_t *>(converted.data()), converted.size()};
}

void failAtLine(std::size_t line, const std::string &text)
{
    failMalformed(tr("line %1: %2", line, text));
}

void failUnsupported(const std::string &text)
{
    throw base::Error{tr("the file cannot be shown: %1", text)};
}

void failNotFinite(std::size_t vertex)
{
    throw base::Error{tr("vertex %1 is NaN, infinite, or beyond 3.4e38", vertex)};
}

void failUnreadable(const std::string &reason)
{
    throw base::Error{.text = tr(reason.empty() ? "the file cannot be read; check its permissions"
                                                : "the file cannot be read; check its permissions (%1)",
                                 reason),
                      .kind = base::Error::Kind::File};
}

void failEmpty()
{
    throw base::Error{tr("the file holds neither triangles nor points")};
}

void noteLines(std::vector<Note> &notes, std::size_t count)
{
    addNote(notes, count, marked("%1 line or point is not shown"), marked("%1 lines and points are not shown"));
}

void noteVerticesWithMore(std::vector<Note> &notes, std::size_t count)
{
    addNote(notes, count, marked("%1 vertex has words behind the coordinates that are not used"),
            marked("%1 vertices have words behind the coordinates that are not used"));
}

void noteBytesBehind(std::vector<Note> &notes, std::size_t count)
{
    addNote(notes, count, marked("%1 byte behind all that the file declares is not used"),
            marked("%1 bytes behind all that the file declares are not used"));
}

void noteParts(std::vector<Note> &notes, std::size_t count, const std::string &name)
{
    if (count > 0)
        notes.push_back({marked(count == 1 ? "\"%1\" is not shown" : "\"%1\" is not shown (%2 times)"),
                         {name, std::to_string(count)}});
}

std::size_t bytesThatMean(std::span<const std::uint8_t> bytes)
{
    const bool isFilling = std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) {
        return byte == 0 || byte == ' ' || byte == '\n' || byte == '\r' || byte == '\t' || byte == 0x1a;
    });
    return isFilling ? 0 : bytes.size();
}

} // namespace reader

base::Error stoppedReading(const std::filesystem::path &file)
{
    return {.text = tr("reading was stopped"), .file = utf8FromPath(file), .kind = base::Error::Kind::Stopped};
}

base::Error tooLargeForMemory(const std::filesystem::path &file)
{
    return {.text = tr("the file is too large for the memory of this computer"),
            .file = utf8FromPath(file),
            .kind = base::Error::Kind::OutOfMemory};
}

Expected<std::shared_ptr<Model>, base::Error> importModel(const std::filesystem::path &file, const Progress &progress)
{
    Reporter reporter(progress);
    base::Error error;
    try {
        try {
            return std::make_shared<Model>(reader::import(file, reporter));
        } catch (const std::system_error &failure) {
            reader::failUnreadable(systemErrorText(failure.code()));
        }
    } catch (const reader::Damage &damage) {
        error.text = tr("the file is damaged: %1", damage.text);
    } catch (const base::Error &other) {
        error = other;
    } catch (const Stopped &) {
        return stoppedReading(file);
    } catch (const std::bad_alloc &) {
        return tooLargeForMemory(file);
    } catch (const std::length_error &) {
        return tooLargeForMemory(file);
    } catch (const std::exception &) {
        error.text = tr("the file is damaged: %1", tr("its reader failed, which is an error of this program"));
    }
    error.file = utf8FromPath(file);
    return error;
}

} // namespace unprojector::mesh
