#include "core/mesh/import/obj_materials.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/mesh/import/file_bytes.h"

#include <algorithm>

namespace unprojector::mesh::reader {
using namespace base;

namespace {

/// The diffuse colour of a material without a "Kd".
constexpr glm::vec3 kDiffuseByDefault(0.6f);

} // namespace

bool namesPicture(std::string_view keyword)
{
    constexpr std::string_view kMap = "map_";
    constexpr std::string_view kOthers[] = {"bump", "decal", "disp", "norm", "refl"};
    return keyword.starts_with(kMap) || std::find(std::begin(kOthers), std::end(kOthers), keyword) != std::end(kOthers);
}

PictureOptions pictureOptions(std::string_view rest)
{
    struct Option {
        std::string_view name;
        int least, most; ///< number of arguments
    };
    constexpr Option kOptions[] = {{"-blendu", 1, 1}, {"-blendv", 1, 1}, {"-boost", 1, 1},   {"-mm", 2, 2},
                                   {"-o", 1, 3},      {"-s", 1, 3},      {"-t", 1, 3},       {"-texres", 1, 1},
                                   {"-clamp", 1, 1},  {"-bm", 1, 1},     {"-imfchan", 1, 1}, {"-type", 1, 1},
                                   {"-cc", 1, 1}};
    PictureOptions options;
    TextScanner scanner(rest);
    for (;;) {
        TextScanner ahead = scanner;
        const std::string_view word = ahead.nextWordInLine();
        const Option *found = std::find_if(std::begin(kOptions), std::end(kOptions),
                                           [word](const Option &option) { return option.name == word; });
        if (found == std::end(kOptions)) {
            options.name = scanner.restOfLine();
            return options;
        }
        for (int i = 0; i < found->most; ++i) {
            TextScanner before = ahead;
            const std::string_view value = ahead.nextWordInLine();
            if (i >= found->least && !doubleFromWord(value)) {
                ahead = before;
                break;
            }
            if (found->name == "-clamp")
                options.wrapRepeat = value != "on";
        }
        scanner = ahead;
    }
}

void ObjMaterials::readLibraries(std::string_view names)
{
    if (readLibrary(std::string(names)))
        return;
    std::vector<std::string> missing;
    bool isAnyThere = false;
    TextScanner scanner(names);
    for (std::string_view name = scanner.nextWordInLine(); !name.empty(); name = scanner.nextWordInLine()) {
        if (readLibrary(std::string(name)))
            isAnyThere = true;
        else
            missing.emplace_back(name);
    }
    if (!isAnyThere) {
        // Fallback for a library renamed together with the model, without an update of its name
        // inside.
        if (readLibrary(utf8FromPath(m_source.file.stem()) + ".mtl"))
            return;
        missing.assign(1, std::string(names));
    }
    for (const std::string &name : missing)
        m_model.notes.push_back({marked("the materials \"%1\" are missing or cannot be read: their surfaces are shown "
                                        "without colours and images"),
                                 {name}});
    m_isAnyMissing = m_isAnyMissing || !missing.empty();
}

bool ObjMaterials::readLibrary(const std::string &name)
{
    const std::filesystem::path file = resolveReference(m_source.file, name);
    if (file.empty())
        return false;
    if (m_libraries.contains(file.native()))
        return true;
    try {
        const FileBytes contents(file);
        parse(contents.text());
        m_model.otherFiles.push_back(file);
    } catch (const base::Error &) {
        return false;
    }
    m_libraries.insert(file.native());
    noteIfOutside(m_model.notes, m_source.file, file, name);
    return true;
}

void ObjMaterials::parse(std::string_view text)
{
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    Written *material = nullptr;
    for (TextScanner scanner(text); !scanner.isAtEnd(); scanner.skipLine()) {
        const std::string_view keyword = scanner.nextWordInLine();
        TextScanner rest = scanner;
        if (keyword == "newmtl") {
            material = &m_written[std::string(rest.restOfLine())];
        } else if (!material) {
            continue;
        } else if (keyword == "Kd") {
            glm::vec3 color(0.0f);
            int count = 0;
            for (; count < 3; ++count) {
                const std::optional<float> value = floatFromWord(rest.nextWordInLine());
                if (!value)
                    break;
                color[count] = *value;
            }
            if (count == 1)
                color = glm::vec3(color.x);
            if (count == 1 || count == 3)
                material->diffuse = color;
        } else if (keyword == "d" || keyword == "Tr") {
            std::string_view word = rest.nextWordInLine();
            if (word == "-halo")
                word = rest.nextWordInLine();
            if (const std::optional<float> value = floatFromWord(word))
                material->opacity = keyword == "d" ? *value : 1.0f - *value;
        } else if (keyword == "map_Kd") {
            const PictureOptions options = pictureOptions(rest.restOfLine());
            material->picture = std::string(options.name);
            material->wrapRepeat = options.wrapRepeat;
        }
    }
}

int ObjMaterials::textureNumber(const Written &written)
{
    const auto [known, isNew] = m_textures.try_emplace({written.picture, written.wrapRepeat}, -1);
    if (isNew) {
        known->second = addTexture(m_model, m_source.file, written.picture);
        m_model.textures.back().wrapRepeat = written.wrapRepeat;
    }
    return known->second;
}

std::optional<Material> ObjMaterials::find(std::string_view name)
{
    auto found = m_written.find(name);
    if (found == m_written.end()) {
        // Tries without a comment after the name; some names do contain a "#".
        std::string_view shorter = name.substr(0, name.find('#'));
        while (!shorter.empty() && (shorter.back() == ' ' || shorter.back() == '\t'))
            shorter.remove_suffix(1);
        found = m_written.find(shorter);
    }
    if (found == m_written.end())
        return std::nullopt;
    const Written &written = found->second;
    const glm::vec3 diffuse = written.diffuse.value_or(kDiffuseByDefault);
    Material material;
    material.baseColor = glm::vec4(diffuse, written.opacity);
    material.hasBaseColor = true;
    if (!written.picture.empty()) {
        material.texture = textureNumber(written);
        // Some programs write black beside an image, or nothing, and mean the image alone.
        if (!written.diffuse || diffuse == glm::vec3(0.0f))
            material.baseColor = glm::vec4(1.0f, 1.0f, 1.0f, written.opacity);
    }
    return material;
}

} // namespace unprojector::mesh::reader
