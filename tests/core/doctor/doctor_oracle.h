#pragma once

#include "tests/support/oracle.h"

#include <glm/vec3.hpp>

#include <numbers>

/// The scene of the doctor's tests, for the oracle.
namespace doctor_oracle {

/// The point that the oracle finds in the scene under a window position (y up).
inline glm::dvec3 oracleUnder(double x, double y, double depth)
{
    oracle::Projection projection;
    projection.kind = oracle::RandomKind::Perspective;
    projection.verticalFovRadians = std::numbers::pi / 4;
    projection.aspect = 800.0 / 600.0;
    projection.nearDistance = 1;
    projection.farDistance = 100;
    oracle::Target target;
    target.x = 100;
    target.y = 40;
    target.width = 800;
    target.height = 600;
    const oracle::Oracle judge({{3, 2, 5}, {0, 0, 0}, {0, 1, 0}}, projection, target);
    const oracle::Vector3 world = judge.worldUnder({x, y, depth});
    return {double(world[0]), double(world[1]), double(world[2])};
}

} // namespace doctor_oracle
