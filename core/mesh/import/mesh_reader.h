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

/// Thrown, as base::Error and base::Stopped are, inside the import only. importModel says before the
/// text that the file is damaged.
struct Damage : base::Error {};

[[noreturn]] inline void failMalformed(std::string text)
{
    throw Damage{{std::move(text)}};
}
[[noreturn]] void failAtLine(std::size_t line, const std::string &text);
/// For a file that is valid.
[[noreturn]] void failUnsupported(const std::string &text);
/// @param vertex  its number in the file
[[noreturn]] void failNotFinite(std::size_t vertex);
[[noreturn]] void failUnreadable(const std::string &reason = {});
/// For a file with nothing to show.
[[noreturn]] void failEmpty();

/// A model file in memory, with its name and the progress reporter.
struct Source {
    std::filesystem::path file;
    std::string suffix; ///< lower case, without the dot
    std::span<const std::uint8_t> bytes;
    base::Reporter &progress;

    std::string_view text() const { return {reinterpret_cast<const char *>(bytes.data()), bytes.size()}; }
    /// The text without trailing zeros, with which some programs pad files.
    std::string_view unpaddedText() const
    {
        const std::string_view all = text();
        return all.substr(0, all.find_last_not_of('\0') + 1);
    }
};

/// Splits a text into pieces of about a million bytes, to be read in parallel.
/// @param nextEnd  the first place from an offset on where a piece of a text may end
std::vector<std::string_view> textPieces(std::string_view text,
                                         std::size_t (*nextEnd)(std::string_view text, std::size_t from));

std::string lowerCaseSuffix(const std::filesystem::path &file); ///< without the dot
/// The file as UTF-8, converted if it begins with a byte order mark of another UTF; else unchanged.
/// @param converted  holds the text of a file in UTF-16
std::span<const std::uint8_t> withoutByteOrderMark(std::span<const std::uint8_t> bytes, std::string &converted);

/// The readers. Meshes may lack normals; finishModel checks their indices and values.
/// Each throws base::Error, base::Stopped or std::bad_alloc.
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
/// Add a note about what several formats may have, unless its number is 0.
void noteLines(std::vector<base::Note> &notes, std::size_t count); ///< and points
void noteVerticesWithMore(std::vector<base::Note> &notes, std::size_t count);
void noteBytesBehind(std::vector<base::Note> &notes, std::size_t count);
void noteParts(std::vector<base::Note> &notes, std::size_t count, const std::string &name);
/// Adds a note for a file that was read, unless it lies in the model file's folder or below.
void noteIfOutside(std::vector<base::Note> &notes, const std::filesystem::path &modelFile,
                   const std::filesystem::path &file, const std::string &reference);
/// Merges these notes into one: a model may have many images in another folder.
void gatherFilesOutside(std::vector<base::Note> &notes);

} // namespace unprojector::mesh::reader
