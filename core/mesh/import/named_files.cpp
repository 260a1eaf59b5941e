#include "core/mesh/import/named_files.h"

#include "core/base/text_scanner.h"
#include "core/mesh/import/file_bytes.h"
#include "core/mesh/import/gltf_file.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/obj_materials.h"

#include <exception>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace unprojector::mesh {
using namespace base;
namespace reader {
namespace {

/// Collects the files that one model file names.
class NamedFiles {
public:
    explicit NamedFiles(std::filesystem::path modelFile) : m_modelFile(std::move(modelFile)) {}

    std::vector<std::filesystem::path> take() { return std::move(m_files); }

    void ofObj(std::string_view text)
    {
        for (const std::string_view keyword : {"mtllib", "maplib", "call", "shadow_obj", "trace_obj"}) {
            for (std::size_t at = text.find(keyword); at != text.npos; at = text.find(keyword, at + keyword.size())) {
                const std::size_t before = at == 0 ? text.npos : text.find_last_not_of(" \t", at - 1);
                TextScanner line(text, at);
                const bool isStatement = before == text.npos || text[before] == '\n' || text[before] == '\r';
                if (!isStatement || line.nextWordInLine() != keyword)
                    continue;
                if (keyword == "mtllib")
                    addLibraries(line.restOfLine());
                else
                    addEach(line.restOfLine());
            }
        }
    }

    void ofPly(std::string_view text)
    {
        for (TextScanner scanner(text); !scanner.isAtEnd(); scanner.skipLine()) {
            TextScanner line = scanner;
            const std::string_view word = line.nextWordInLine();
            if (word == "end_header")
                return;
            if (word == "comment" && line.nextWordInLine() == "TextureFile")
                add(line.restOfLine());
        }
    }

    void ofGltf(const Json &value)
    {
        for (const auto &[key, own] : value.items()) {
            if (value.is_object() && key == "uri" && own.is_string() && !isData(own.get_ref<const std::string &>()))
                add(own.get_ref<const std::string &>());
            if (own.is_structured())
                ofGltf(own);
        }
    }

private:
    static bool isData(std::string_view uri) { return uri.starts_with("data:"); }

    bool add(std::string_view name)
    {
        const std::filesystem::path file = resolveReference(m_modelFile, std::string(name));
        if (file.empty())
            return false;
        if (m_known.insert(file.native()).second)
            m_files.push_back(file);
        return true;
    }

    void addEach(std::string_view names)
    {
        add(names);
        TextScanner scanner(names);
        for (std::string_view name = scanner.nextWordInLine(); !name.empty(); name = scanner.nextWordInLine())
            add(name);
    }

    /// Resolves libraries as ObjMaterials does: one name with blanks, or several, or the model's
    /// own.
    void addLibraries(std::string_view names)
    {
        if (addLibrary(names))
            return;
        bool isAnyThere = false;
        TextScanner scanner(names);
        for (std::string_view name = scanner.nextWordInLine(); !name.empty(); name = scanner.nextWordInLine())
            isAnyThere = addLibrary(name) || isAnyThere;
        if (!isAnyThere)
            addLibrary(utf8FromPath(m_modelFile.stem()) + ".mtl");
    }

    bool addLibrary(std::string_view name)
    {
        if (!add(name))
            return false;
        const std::filesystem::path file = resolveReference(m_modelFile, std::string(name));
        if (!m_libraries.insert(file.native()).second)
            return true;
        try {
            const FileBytes contents(file);
            for (TextScanner scanner(contents.text()); !scanner.isAtEnd(); scanner.skipLine()) {
                TextScanner line = scanner;
                if (namesPicture(line.nextWordInLine()))
                    add(pictureOptions(line.restOfLine()).name);
            }
        } catch (const base::Error &) {
            return true; // kept even if unreadable
        }
        return true;
    }

    using Paths = std::set<std::filesystem::path::string_type>;

    std::filesystem::path m_modelFile;
    std::vector<std::filesystem::path> m_files;
    Paths m_known;     ///< the files in m_files
    Paths m_libraries; ///< material libraries already read
};

} // namespace
} // namespace reader

std::vector<std::filesystem::path> namedFiles(const std::filesystem::path &modelFile)
{
    using namespace reader;
    NamedFiles named(modelFile);
    const std::string suffix = lowerCaseSuffix(modelFile);
    const bool isGltf = suffix == "gltf" || suffix == "glb";
    if (!isGltf && suffix != "obj" && suffix != "ply")
        return {};
    try {
        const FileBytes contents(modelFile);
        std::string converted;
        const Progress silent;
        Reporter progress(silent);
        std::vector<base::Note> notes;
        Source source{modelFile, suffix, contents.bytes(), progress};
        if (!isGltf)
            source.bytes = withoutByteOrderMark(source.bytes, converted);
        if (isGltf)
            named.ofGltf(GltfFile(source, notes).root());
        else if (suffix == "obj")
            named.ofObj(source.text());
        else
            named.ofPly(source.text());
    } catch (const base::Error &) {
        // The commands that import the model report its error.
    } catch (const std::exception &) {
    }
    return named.take();
}

} // namespace unprojector::mesh
