#pragma once

#include "unprojector/setup.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>

namespace unprojector {

enum class Method {
    Formula, ///< the inverse formulas (9) to (12) of Weng et al. 2008, without a matrix inversion
    Matrix   ///< the inverted matrix, as in gluUnProject
};

/// The space of points that are unprojected to, or projected from.
enum class Space { World, Eye };

/// The number of digits that a point is computed with.
enum class Digits {
    /// About 30, rounded once: the digits of a click. The formulas give the double nearest to the
    /// truth, at every position. The inverted matrix loses what rounding to its double elements
    /// loses.
    Exact,
    /// Plain double, about twice as fast: 8 units in the last place of the largest coordinate for
    /// 99.99 % of the points of a usual setup.
    Double,
};

/// The format of a depth buffer.
struct DepthBuffer {
    int bits = 24;        ///< 1 to 32; whole steps of 1 / (2^bits - 1)
    bool isFloat = false; ///< single precision; `bits` is ignored
};

struct UnprojectOptions {
    Method method = Method::Formula;
    Space space = Space::World;
    Digits digits = Digits::Exact;
    /// The depths come from such a buffer: uncertainties are for its rounding.
    DepthBuffer depthBuffer;
};

/// Unprojects pixels with their depths, prepared once for a setup. Any thread may call it.
///
/// px, py are device pixels, origin top-left; the centre of pixel (i, j) is (i + 1/2, j + 1/2).
/// Depths are window depths, in the setup's depth range.
///
/// The uncertainty of a coordinate is its error bound for the rounding of the depth in the depth
/// buffer: half a step, extended along the pixel's ray; plus half a unit in the last place, the
/// rounding of Digits::Exact. The errors of a rasteriser, which depend on its triangles, are not
/// included.
class UNPROJECTOR_PUBLIC Unprojection {
public:
    /// @return Value: the matrix has no inverse; the formulas do not apply, since the matrix is no
    ///         known projection; depthBuffer.bits
    static Result<Unprojection> of(const Setup &setup, const UnprojectOptions &options = {});

    /// The point under one pixel.
    /// @return Value: a depth outside the depth range; a number that is not finite; a point at
    ///         infinity
    Result<glm::dvec3> at(const glm::dvec2 &pixel, double depth) const;

    /// The uncertainty of each coordinate of that point, 0 or greater.
    /// @return Value: the errors of `at`; the setup is no perspective, box or sheared box
    Result<glm::dvec3> uncertaintyAt(const glm::dvec2 &pixel, double depth) const;

    /// Unprojects `count` pixels. A point without an answer is (NaN, NaN, NaN): its depth is outside
    /// the range, a number is not finite, or the point is at infinity.
    /// @param px, py, depth   arrays of `count` numbers; float is computed as double
    /// @param points          x, y, z of each point, one point after the other
    /// @param uncertainties   the same for uncertainties; may be null. NaN throughout for a setup
    ///         that has none, see hasUncertainty
    /// @param threads         the maximum number of threads; 0: all cores
    void operator()(const double *px, const double *py, const double *depth, double *points, std::size_t count,
                    double *uncertainties = nullptr, unsigned threads = 1) const;
    void operator()(const float *px, const float *py, const float *depth, double *points, std::size_t count,
                    double *uncertainties = nullptr, unsigned threads = 1) const;

    /// True if the setup is a perspective, a box or a sheared box, also where given as a matrix.
    bool hasUncertainty() const;

private:
    struct Data;
    explicit Unprojection(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

} // namespace unprojector
