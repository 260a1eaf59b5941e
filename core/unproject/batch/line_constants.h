#pragma once

#include "core/geometry/precise_matrix.h"
#include "core/geometry/setup.h"
#include "core/unproject/batch/kernels.h"

#include <glm/mat4x4.hpp>

namespace unprojector::unproject {

/// The space of a batch's results: eye or world space, or an object's.
struct BatchSpace {
    enum class Kind { Eye, World, Object };
    Kind kind = Kind::World;
    geometry::PreciseMatrix worldFromObject = {}; ///< for Kind::Object, affine
};

/// The lines behind the positions of the view, by the formulas.
struct LineConstants {
    batch::ClosedFormConstants numbers{};
    bool perspective = true;
};

/// See BatchUnprojection::byFormula, also for the errors.
geometry::Result<LineConstants> lineConstants(const geometry::Setup &setup, const BatchSpace &space);

/// The inverted matrix of BatchUnprojection::byMatrix: (x, y, z, w) of a space from
/// (px, py, depth, 1).
/// @return the errors of byMatrix
geometry::Result<glm::dmat4> spaceFromDevice(const geometry::Setup &setup, const BatchSpace &space);

} // namespace unprojector::unproject
