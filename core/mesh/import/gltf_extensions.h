#pragma once

#include "core/mesh/import/gltf_file.h"

#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

/// What a glTF extension means for the shape of a file that requires it.
enum class GltfExtension {
    Read,        ///< it is applied
    Unpacked,    ///< it is applied where the program is built with the library that unpacks it
    LeavesShape, ///< it is not applied, and no vertex moves for it: materials, textures, lights, data, sound, animation
    ChangesShape, ///< it is not applied, and the shape is not whole without it
    Unknown,
};

/// By the public registry of glTF extensions, and by the extensions that programs write besides.
GltfExtension gltfExtension(std::string_view name);

/// The value of an object's extension, or null.
const Json *extensionOf(const Json &object, const char *name);

/// Throws Failure (Unsupported): the program is built without the library that unpacks an extension.
/// @pre  gltfExtension(name) is Unpacked
[[noreturn]] void failWithoutLibrary(std::string_view name);

/// Adds a note for each extension that a file requires and that is not applied, and for each one that changes the shape and
/// that it can do without.
/// Throws Failure (Unsupported) where a required one changes the shape, or may, or needs a library that is missing.
void checkExtensions(const GltfFile &file, std::vector<ModelNote> &notes);

} // namespace unprojector::mesh::reader
