#pragma once

#include "core/cameras/pasted_matrix.h"

#include <optional>
#include <string>
#include <string_view>

/// The names that stand before numbers in a pasted text.
namespace unprojector::cameras {

struct NamedPart {
    std::optional<PastedPart> part{};
    bool isInverse = false; ///< the name is of the part's inverse: "projectionMatrixInverse", "cameraToWorld"
};

/// The part that names tell: "gl_ModelViewMatrix", "model view", "P*V". The last name of a path
/// counts, if it tells one: "cam.viewProjection" is a product.
std::optional<NamedPart> namedBy(std::string_view names);

/// The letters of a name, in lower case.
std::string lettersOf(std::string_view names);

/// Returns whether a name is of numbers that people paste beside matrices, which belong to none.
/// @param letters  see lettersOf
bool isAside(const std::string &letters);

/// Returns whether a name is of an image's width and height, together.
/// @param letters  see lettersOf
bool isSize(const std::string &letters);

} // namespace unprojector::cameras
