#pragma once

#include "core/cameras/pasted_camera.h"

#include <string>
#include <vector>

// A pasted text without a scene, and one of its matrices.

namespace unprojector::cameras {

inline PastedCamera pasted(const std::string &text, const PasteChoices &choices = {})
{
    return pastedCamera(std::vector<NamedText>{{"", text}}, choices, std::nullopt);
}

/// @return null without a matrix in this role
inline const ReadMatrix *matrixOf(const PastedCamera &camera, pipeline::MatrixRole role)
{
    for (const ReadMatrix &one : camera.matrices) {
        if (one.role == role)
            return &one;
    }
    return nullptr;
}

} // namespace unprojector::cameras
