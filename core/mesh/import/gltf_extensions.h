#pragma once

#include "core/mesh/import/gltf_file.h"

#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

/// Returns whether this program applies an extension.
bool isReadExtension(std::string_view name);

/// The value of an object's extension, or null.
const Json *extensionOf(const Json &object, const char *name);

/// Throws base::Error: the program is built without the library that unpacks an extension, Draco's
/// or meshoptimizer's.
[[noreturn]] void failWithoutLibrary(std::string_view name);

/// Adds a note for each extension that is not applied, except for optional ones whose names say that
/// they move no vertex.
/// Throws base::Error if a required one may move vertices, or needs a missing library.
void checkExtensions(const GltfFile &file, std::vector<base::Note> &notes);

} // namespace unprojector::mesh::reader
