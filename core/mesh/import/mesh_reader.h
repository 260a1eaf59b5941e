#pragma once

#include "core/base/path_text.h"
#include "core/mesh/import/mesh_import.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Shared code of the format readers behind importModel. Not for use elsewhere.
namespace unprojector::mesh::reader {

/// Thrown inside the import only; importModel converts it to an ImportError.
struct Failure : std::exception {
    explicit Failure(ImportErrorCode failureCode, std::string failureDetail = {}, std::size_t failureIndex = 0)
        : code(failureCode), detail(std::move(failureDetail)), index(failureIndex)
    {
    }
    const char *what() const noexcept override { return detail.c_str(); }

    ImportErrorCode code;
    std::string detail;
    std::size_t index;
};

[[noreturn]] inline void failMalformed(std::string detail)
{
    throw Failure(ImportErrorCode::Malformed, std::move(detail));
}

/// Forwards the share done to the callback; it never decreases.
class ProgressReporter {
public:
    explicit ProgressReporter(const ImportProgress &callback) : m_callback(callback) {}

    /// Begins a stage: the range of the whole that the following reports fill from 0 to 1.
    void beginStage(double from, double to);
    /// @param share  of the stage, in [0, 1]
    /// Throws Failure (Cancelled) when the callback returns false, then and at every later call.
    void report(double share);
    bool isCancelled() const { return m_cancelled; }

private:
    const ImportProgress &m_callback;
    double m_from = 0.0;
    double m_to = 1.0;
    double m_last = 0.0;
    bool m_cancelled = false;
};

/// A model file in memory, with its name and the progress reporter.
struct Source {
    std::filesystem::path file;
    std::string suffix; ///< lower case, without the dot
    std::span<const std::uint8_t> bytes;
    ProgressReporter &progress;

    std::string_view text() const { return {reinterpret_cast<const char *>(bytes.data()), bytes.size()}; }
    /// The text without trailing zeros, with which some programs pad files.
    std::string_view unpaddedText() const
    {
        const std::string_view all = text();
        return all.substr(0, all.find_last_not_of('\0') + 1);
    }
};

std::string lowerCaseSuffix(const std::filesystem::path &file); ///< without the dot
/// The file as UTF-8, converted if it begins with a byte order mark of another UTF; else unchanged.
/// @param converted  holds the text of a file in UTF-16
std::span<const std::uint8_t> withoutByteOrderMark(std::span<const std::uint8_t> bytes, std::string &converted);

/// The readers. Meshes may lack normals; finishModel checks their indices and values.
/// Each throws Failure, or std::bad_alloc.
Model readStl(const Source &source);
Model readPly(const Source &source);
Model readOff(const Source &source);
Model readObj(const Source &source);
/// glTF and GLB.
Model readGltf(const Source &source);

/// The number of bytes that follow the declared content of a binary file. Returns 0 if all are
/// padding: zeros, blanks, line breaks or 0x1A.
std::size_t bytesThatMean(std::span<const std::uint8_t> bytes);

/// The texture that a model file refers to, read from disk; `encoded` stays empty if the file is
/// missing.
/// @param reference  UTF-8, as written in the file: relative to the model file's folder, with
///         either slash, perhaps with %20 for a blank
Texture readTexture(const std::filesystem::path &modelFile, const std::string &reference);
/// Reads a texture and adds it to the model's textures, with a note if the file is missing.
/// @return its index
int addTexture(Model &model, const std::filesystem::path &modelFile, const std::string &reference);
/// The file that a reference names, or an empty path.
std::filesystem::path resolveReference(const std::filesystem::path &modelFile, const std::string &reference);
/// Adds a note for a file that was read, unless it lies in the model file's folder or below, or
/// already has one.
void noteIfOutside(std::vector<ModelNote> &notes, const std::filesystem::path &modelFile,
                   const std::filesystem::path &file, const std::string &reference);

} // namespace unprojector::mesh::reader
