#include "core/base/translation.h"
#include "core/mesh/import/file_bytes.h"
#include "core/mesh/import/mesh_reader.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

namespace unprojector::mesh::reader {
using namespace base;

namespace {

constexpr std::string_view kOutside = marked("the file \"%1\" outside the model's folder was read");

std::string percentDecoded(const std::string &text)
{
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned char code = 0;
        const char *digits = text.data() + i + 1;
        if (text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
            decoded.push_back(static_cast<char>(code));
            i += 2;
        } else {
            decoded.push_back(text[i]);
        }
    }
    return decoded;
}

} // namespace

std::filesystem::path resolveReference(const std::filesystem::path &modelFile, const std::string &reference)
{
    const std::filesystem::path folder = modelFile.parent_path();
    std::string slashed = reference;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    for (const std::string &candidate : {reference, slashed, percentDecoded(slashed)}) {
        const std::filesystem::path relative = pathFromUtf8(candidate);
        // Many files contain a path on the author's disk; the image then often lies beside the
        // model.
        for (const std::filesystem::path &file : {folder / relative, folder / relative.filename()}) {
            std::error_code error;
            if (std::filesystem::is_regular_file(file, error))
                return file;
        }
    }
    return {};
}

Texture readTexture(const std::filesystem::path &modelFile, const std::string &reference)
{
    Texture texture;
    texture.file = resolveReference(modelFile, reference);
    if (texture.file.empty()) {
        texture.file = modelFile.parent_path() / pathFromUtf8(reference);
        return texture;
    }
    try {
        const FileBytes contents(texture.file);
        texture.encoded.assign(contents.bytes().begin(), contents.bytes().end());
    } catch (const base::Error &) {
        // The model is shown untextured without a readable image.
        texture.encoded.clear();
    }
    return texture;
}

void noteIfOutside(std::vector<base::Note> &notes, const std::filesystem::path &modelFile,
                   const std::filesystem::path &file, const std::string &reference)
{
    // Compares names only: the owner of the model's folder is responsible for links in it.
    const auto normal = [](const std::filesystem::path &path) {
        std::error_code error;
        const std::filesystem::path absolute = std::filesystem::absolute(path, error);
        return (error ? path : absolute).lexically_normal();
    };
    const std::filesystem::path fromFolder = normal(file).lexically_relative(normal(modelFile).parent_path());
    if (!fromFolder.empty() && *fromFolder.begin() != "..")
        return;
    Note note{kOutside, {reference}};
    if (std::find(notes.begin(), notes.end(), note) == notes.end())
        notes.push_back(std::move(note));
}

void gatherFilesOutside(std::vector<Note> &notes)
{
    const auto isOutside = [](const Note &note) { return note.one == kOutside; };
    const auto first = std::find_if(notes.begin(), notes.end(), isOutside);
    const auto others = std::count_if(first, notes.end(), isOutside) - 1;
    if (others < 1)
        return;
    first->one = marked(others == 1 ? "the file \"%1\" and %2 other one outside the model's folder were read"
                                    : "the file \"%1\" and %2 other ones outside the model's folder were read");
    first->values.push_back(std::to_string(others));
    notes.erase(std::remove_if(first + 1, notes.end(), isOutside), notes.end());
}

int addTexture(Model &model, const std::filesystem::path &modelFile, const std::string &reference)
{
    model.textures.push_back(readTexture(modelFile, reference));
    if (model.textures.back().encoded.empty())
        model.notes.push_back(
            {marked("the image \"%1\" is missing or cannot be read: its surfaces are shown without it"), {reference}});
    else
        noteIfOutside(model.notes, modelFile, model.textures.back().file, reference);
    return static_cast<int>(model.textures.size()) - 1;
}

} // namespace unprojector::mesh::reader
