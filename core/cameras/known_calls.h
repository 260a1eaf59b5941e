#pragma once

#include "core/base/source_text.h"
#include "core/geometry/viewport.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

enum class CallKind {
    Perspective,
    Orthographic,
    View,
    Viewport,
    Window ///< its viewport, if no call sets another one
};

/// What a call makes, and of what.
struct CallShape {
    CallKind kind;
    std::string_view parameters; ///< separated by commas, some with a default: "fov=50, aspect=1"
};

/// The conventions of a library, which its calls may change by their names.
struct CallConventions {
    bool isLeftHanded = false;
    geometry::NdcDepth ndcDepth = geometry::NdcDepth::MinusOneToOne;
    bool areDegrees = false;
    bool dropsRest = true;   ///< whole numbers are divided without the remainder, as in C and C#
    std::size_t skipped = 0; ///< first arguments that are no parameter: the result, in gl-matrix
};

/// The meaning of a call that makes a projection, a view or a viewport.
struct KnownCall : CallShape, CallConventions {};

/// The known call with the names and the number of arguments of a call; nothing for other calls.
/// @param program  the whole text with its comments: it may name the library, and set GLM's
///         defaults
std::optional<KnownCall> knownCall(const base::SourceCall &call, std::string_view program);

struct CallArgument {
    std::string_view parameter; ///< "fov", "eye"
    std::string_view text;      ///< not empty
    bool isVector;              ///< else a number
};

/// The arguments in the order of the parameters, sorted by the keywords "fov=60" of Python and "fieldOfView: 1" of
/// C#, with the defaults. Drops PyBullet's physicsClientId, which names no number of a matrix.
/// Fails for an unknown keyword, an argument that is given twice, and another number of arguments.
std::vector<CallArgument> callArguments(const base::SourceCall &call, const KnownCall &known);

/// Throws a PasteError.
/// @param text  what the call has wrong; names the call
[[noreturn]] void failCall(std::string text);
[[noreturn]] void failCount(const base::SourceCall &call, std::size_t found, std::size_t wanted);

} // namespace unprojector::cameras
