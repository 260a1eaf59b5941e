#pragma once

#include "core/mesh/import/gltf_file.h"

#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

/// The effect of a glTF extension on the shape of a file that requires it.
enum class GltfExtension {
    Read,         ///< applied
    Unpacked,     ///< applied if the program is built with the library that unpacks it
    LeavesShape,  ///< not applied, and moves no vertex: materials, textures, lights, data, sound, animation
    ChangesShape, ///< not applied, and the shape is incomplete without it
    Unknown,
};

/// Classifies an extension, by the public registry of glTF extensions and by other extensions that
/// programs write.
GltfExtension gltfExtension(std::string_view name);

/// The value of an object's extension, or null.
const Json *extensionOf(const Json &object, const char *name);

/// Throws base::Error: the program is built without the library that unpacks an
/// extension.
/// @pre  gltfExtension(name) is Unpacked
[[noreturn]] void failWithoutLibrary(std::string_view name);

/// Adds a note for each required extension that is not applied, and for each optional one that
/// changes the shape.
/// Throws base::Error if a required one changes the shape, or may, or needs a missing
/// library.
void checkExtensions(const GltfFile &file, std::vector<base::Note> &notes);

} // namespace unprojector::mesh::reader
