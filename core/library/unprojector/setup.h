#pragma once

#include "unprojector/export.h"
#include "unprojector/result.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace unprojector {

namespace geometry {
struct Setup;
}

/// The arguments of glFrustum, eye units: the window [left, right] x [bottom, top] on the near
/// plane. 0 < near < far.
struct Frustum {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
};

/// The arguments of gluPerspective. The angle is in degrees. 0 < near < far.
struct Perspective {
    double verticalFovDegrees = 45.0;
    std::optional<double> aspect; ///< width / height; empty: the viewport's
    double nearDistance = 1.0, farDistance = 100.0;
};

/// The arguments of glOrtho, eye units. near and far are distances in front of the eye.
struct Ortho {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
};

using Projection = std::variant<Perspective, Frustum, Ortho>;

/// The arguments of gluLookAt, world space.
struct Camera {
    glm::dvec3 eye{0.0, 0.0, 5.0}, center{0.0}, up{0.0, 1.0, 0.0};
};

/// The arguments of glViewport: device pixels, origin at the bottom-left corner.
struct Viewport {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

/// The arguments of glDepthRange: the window depths of the near and the far plane.
struct DepthRange {
    double atNear = 0.0, atFar = 1.0;
};

/// The pixels that a setup maps to.
struct Window {
    int width = 800, height = 600;    ///< device pixels
    std::optional<Viewport> viewport; ///< empty: the whole window
    DepthRange depthRange;
};

/// All that maps the world to pixels: camera, projection, viewport and depth range. A setup is
/// valid and does not change; copies share its data. Any thread may use it.
class UNPROJECTOR_PUBLIC Setup {
public:
    /// Builds a setup by parameters.
    /// @return Value: the first parameter that is out of range
    static Result<Setup> of(const Projection &projection, const Camera &camera, const Window &window);

    int width() const;  ///< device pixels
    int height() const; ///< device pixels

    /// The setup for code inside the library.
    const geometry::Setup &internal() const { return *m_setup; }

private:
    explicit Setup(std::shared_ptr<const geometry::Setup> setup) : m_setup(std::move(setup)) {}

    std::shared_ptr<const geometry::Setup> m_setup;
};

} // namespace unprojector
