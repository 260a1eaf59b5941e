#pragma once

#include "core/mesh/import/material.h"
#include "core/mesh/import/mesh_reader.h"

#include <glm/vec4.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

/// Returns whether the words after a keyword of a material library name an image, as after
/// "map_Kd".
bool namesPicture(std::string_view keyword);

/// The arguments of an image statement, as in "map_Kd -o 1 2 -clamp on my picture.png".
struct PictureOptions {
    std::string_view name;
    bool wrapRepeat = true;
};
PictureOptions pictureOptions(std::string_view rest);

/// The materials of an OBJ file's libraries. Reads images and adds notes to the model.
class ObjMaterials {
public:
    ObjMaterials(const Source &source, Model &model) : m_source(source), m_model(model) {}

    /// Reads the libraries named after "mtllib": one file whose name may contain blanks, or several
    /// files.
    void readLibraries(std::string_view names);
    /// The material after "usemtl"; nothing if no library has it.
    std::optional<Material> find(std::string_view name);
    /// Returns whether a library was not found.
    bool isAnyMissing() const { return m_isAnyMissing; }

private:
    /// A material as written in the library.
    struct Written {
        std::optional<glm::vec3> diffuse;
        float opacity = 1.0f;
        std::string picture;
        bool wrapRepeat = true;
    };

    bool readLibrary(const std::string &name);
    void parse(std::string_view text);
    int textureNumber(const Written &written);

    const Source &m_source;
    Model &m_model;
    std::map<std::string, Written, std::less<>> m_written;
    std::map<std::pair<std::string, bool>, int> m_textures;
    std::set<std::filesystem::path::string_type> m_libraries; ///< already read
    bool m_isAnyMissing = false;
};

} // namespace unprojector::mesh::reader
