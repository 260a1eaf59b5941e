#pragma once

#include "core/cameras/call_text.h"
#include "core/geometry/viewport.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace unprojector::cameras {

/// The meaning of a call's arguments.
enum class CallShape {
    FieldOfView,       ///< fovy, aspect, near, far
    FieldOfViewOfSize, ///< fovy, width, height, near, far
    Size,              ///< width, height, near, far
    Edges,             ///< left, right, bottom, top, near, far
    EdgesTopFirst,     ///< left, right, top, bottom, near, far
    EdgesOnly,         ///< left, right, bottom, top
    LookAtNumbers,     ///< eye, center and up, nine numbers
    LookAtPoints,      ///< eye, center and up, three vectors
    LookTo,            ///< eye, direction and up, three vectors
    Viewport           ///< x, y, width, height
};

/// The conventions that an API applies to a call.
struct CallSignature {
    CallShape shape = CallShape::FieldOfView;
    bool isPerspective = true;
    bool isLeftHanded = false;
    geometry::NdcDepth ndcDepth = geometry::NdcDepth::MinusOneToOne;
    bool areDegrees = false;
    bool dropsRest = true;         ///< whole numbers are divided without the remainder, as in C and C#
    std::size_t firstArgument = 0; ///< 1 in gl-matrix, whose first argument is the result
};

bool isProjection(CallShape shape);
std::size_t argumentCount(CallShape shape);

/// The signature of a call that makes a projection, a view or a viewport; nothing for other calls.
/// @param program  the whole text with its comments: it may name the library, and set GLM's
///         defaults
std::optional<CallSignature> signatureOf(const CallText &call, std::string_view program);

} // namespace unprojector::cameras
