#include "core/mesh_import/mesh_import.h"

#include "core/geometry/finite.h"
#include "core/mesh_import/mesh_normals.h"
#include "core/mesh_import/mesh_reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>
#include <stdexcept>
#include <system_error>

namespace unprojector::mesh_import {
using namespace geometry;

namespace mesh_reader {

namespace {

constexpr std::size_t kReadChunkBytes = 1 << 20;

bool hasUsableNormals(const Mesh &mesh)
{
    if (mesh.normals.size() != mesh.positions.size())
        return false;
    return std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](std::uint32_t index) {
        const glm::vec3 &normal = mesh.normals[index];
        return isFinite(normal) && normal != glm::vec3(0.0f);
    });
}

/// Checks what every reader must keep, so that drawing and ray casting need not; makes missing normals.
void finishModel(Model &model, ProgressReporter &progress)
{
    std::size_t firstVertex = 0;
    for (Mesh &mesh : model.meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (!isFinite(mesh.positions[v]))
                throw Failure(ImportErrorCode::NotFinite, {}, firstVertex + v);
        }
        const auto outside = std::find_if(mesh.indices.begin(), mesh.indices.end(),
                                          [&](std::uint32_t index) { return index >= mesh.positions.size(); });
        if (outside != mesh.indices.end())
            failMalformed("a face refers to vertex " + std::to_string(*outside) + ", the mesh has "
                          + std::to_string(mesh.positions.size()));
        if (mesh.colors.size() != mesh.positions.size())
            mesh.colors.clear();
        if (mesh.texcoords.size() != mesh.positions.size())
            mesh.texcoords.clear();
        for (glm::vec2 &texcoord : mesh.texcoords) {
            if (!isFinite(texcoord))
                texcoord = glm::vec2(0.0f);
        }
        firstVertex += mesh.positions.size();
    }
    std::erase_if(model.meshes, [](const Mesh &mesh) { return mesh.indices.empty(); });
    if (model.meshes.empty())
        throw Failure(ImportErrorCode::NoTriangles);

    const auto total = static_cast<double>(model.triangleCount());
    std::size_t done = 0;
    for (Mesh &mesh : model.meshes) {
        const auto report = [&](double share) {
            progress.report((static_cast<double>(done) + share * static_cast<double>(mesh.triangleCount())) / total);
        };
        report(0.0);
        if (!hasUsableNormals(mesh))
            makeNormals(mesh, 0.5f, report);
        done += mesh.triangleCount();
    }
    model.bounds = boundsOf(model.meshes);
}

std::string lowerCaseSuffix(const std::filesystem::path &file)
{
    std::string suffix = utf8FromPath(file.extension());
    if (!suffix.empty())
        suffix.erase(0, 1);
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return suffix;
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
    if (suffix == "obj" || suffix == "gltf" || suffix == "glb")
        return readWithAssimp;
    return nullptr;
}

Model import(const std::filesystem::path &file, ProgressReporter &progress)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw Failure(ImportErrorCode::NotFound);
    if (status.type() == std::filesystem::file_type::directory)
        throw Failure(ImportErrorCode::IsDirectory);
    const std::string suffix = lowerCaseSuffix(file);
    const Reader reader = readerFor(suffix);
    if (!reader)
        throw Failure(ImportErrorCode::UnknownFormat, suffix);

    progress.beginStage(0.0, 0.1);
    const std::vector<std::uint8_t> bytes = readFile(file, &progress);
    if (bytes.empty())
        throw Failure(ImportErrorCode::EmptyFile);
    progress.beginStage(0.1, 0.7);
    Model model = reader(Source{file, suffix, bytes, progress});
    progress.beginStage(0.7, 1.0);
    finishModel(model, progress);
    model.name = utf8FromPath(file.stem());
    progress.report(1.0);
    return model;
}

} // namespace

void ProgressReporter::beginStage(double from, double to)
{
    m_from = from;
    m_to = to;
    report(0.0);
}

void ProgressReporter::report(double share)
{
    m_last = std::max(m_last, m_from + (m_to - m_from) * std::clamp(share, 0.0, 1.0));
    if (!m_cancelled && m_callback)
        m_cancelled = !m_callback(std::min(m_last, 1.0));
    if (m_cancelled)
        throw Failure(ImportErrorCode::Cancelled);
}

std::vector<std::uint8_t> readFile(const std::filesystem::path &file, ProgressReporter *progress)
{
    std::error_code error;
    // A pipe or a device has no size and may never end.
    if (!std::filesystem::is_regular_file(file, error))
        throw Failure(ImportErrorCode::NotReadable);
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream)
        throw Failure(ImportErrorCode::NotReadable);

    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    for (std::size_t done = 0; done < bytes.size();) {
        const std::size_t chunk = std::min(kReadChunkBytes, bytes.size() - done);
        if (!stream.read(reinterpret_cast<char *>(bytes.data() + done), static_cast<std::streamsize>(chunk)))
            throw Failure(ImportErrorCode::NotReadable);
        done += chunk;
        if (progress)
            progress->report(static_cast<double>(done) / static_cast<double>(bytes.size()));
    }
    return bytes;
}

} // namespace mesh_reader

Result<std::shared_ptr<const Model>, ImportError> importModel(const std::filesystem::path &file,
                                                              const ImportProgress &progress)
{
    mesh_reader::ProgressReporter reporter(progress);
    ImportError error{ImportErrorCode::Malformed, file, {}, 0};
    try {
        return std::shared_ptr<const Model>(std::make_shared<Model>(mesh_reader::import(file, reporter)));
    } catch (const mesh_reader::Failure &failure) {
        error.code = failure.code;
        error.detail = failure.detail;
        error.index = failure.index;
    } catch (const std::bad_alloc &) {
        error.code = ImportErrorCode::OutOfMemory;
    } catch (const std::length_error &) {
        error.code = ImportErrorCode::OutOfMemory;
    } catch (const std::exception &exception) {
        error.detail = exception.what();
    }
    return error;
}

} // namespace unprojector::mesh_import
