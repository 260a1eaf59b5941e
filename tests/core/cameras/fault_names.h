#pragma once

#include "core/pipeline/matrix_findings.h"

#include <string_view>

// The rows of the tests name faults by these words.

namespace unprojector::pipeline {

inline std::string_view idOf(MatrixFault fault)
{
    switch (fault) {
    case MatrixFault::Transposed: return "transposed";
    case MatrixFault::Inverse: return "inverse";
    case MatrixFault::Exchanged: return "exchanged";
    case MatrixFault::UnknownForm: return "unknown-form";
    case MatrixFault::DepthZeroToOne: return "depth-zero-to-one";
    case MatrixFault::DepthReversed: return "depth-reversed";
    case MatrixFault::FarAtInfinity: return "far-at-infinity";
    case MatrixFault::YDown: return "y-down";
    case MatrixFault::Mirrored: return "mirrored";
    case MatrixFault::LeftHanded: return "left-handed";
    case MatrixFault::Negated: return "negated";
    case MatrixFault::Rounded: return "rounded";
    case MatrixFault::OtherOrder: return "other-order";
    case MatrixFault::OrderOfOthers: return "order-of-others";
    case MatrixFault::OrderOpen: return "order-open";
    case MatrixFault::Scaled: break;
    }
    return "scaled";
}

} // namespace unprojector::pipeline
