#pragma once

#include "core/pipeline/matrix_format.h"

namespace unprojector::gui {

/// The display options of all matrices and points of the pipeline.
struct MatrixView {
    pipeline::MatrixLayout layout = pipeline::MatrixLayout::Column;
    bool isMemoryOrder = false; ///< m[0] to m[15] as glGetFloatv gives them, in two columns of eight
    pipeline::Digits digits = pipeline::Digits::Double;
    bool isWhole = false; ///< all digits, regardless of the room
    friend bool operator==(const MatrixView &, const MatrixView &) = default;
};

} // namespace unprojector::gui
