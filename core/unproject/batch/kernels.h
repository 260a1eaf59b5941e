#pragma once

#include <cstddef>

/// The arithmetic of core/unproject/batch, compiled once for each instruction set from
/// batch/kernels.inl. It uses only additions, subtractions, products and quotients, each rounded
/// once and none fused, so every instruction set gives the same digits. The loops of
/// ClickKernels may fuse: `doubt` marks the points whose digits that could change, and slower code
/// computes those.
namespace unprojector::unproject::batch {

/// A closed form from eye to target space: p = origin + z (X across + Y down + ahead), or for a box
/// p = origin + X across + Y down + z ahead, with X and Y in pixels from the view axis.
struct ClosedFormConstants {
    double axisX, axisY;         ///< device position of the view axis
    double axisXRest, axisYRest; ///< its digits beyond the doubles above
    double depthAtNear, depthAtFar;
    /// Perspective: z = nearTerm / ((df - d) + (d - dn) farTerm). Box: z = nearTerm (df - d) +
    /// farTerm (d - dn).
    double nearTerm, farTerm;
    double origin[3], ahead[3], across[3], down[3];
};

/// Rows of targetFromDevice: (x', y', z', w') = rows * (px, py, depth, 1).
struct MatrixConstants {
    double rows[4][4];
};

/// A number with about 32 digits, value + rest, and its value as the sum of two numbers of 26 bits
/// each.
struct Twofold {
    double value, rest, highHalf, lowHalf;
};

/// The closed forms as in ClosedFormConstants, with Y counted upwards, for about 30 digits.
struct PreciseConstants {
    Twofold axisX, axisY; ///< device position of the view axis
    double depthAtNear, depthAtFar;
    Twofold nearTerm, farTerm;
    Twofold origin[3], ahead[3], across[3], up[3];
    /// The sizes of the terms of the sum: originSize + (reach + |X| acrossSize + |Y| upSize), and
    /// for a perspective the bracket times z.
    double originSize, reach, acrossSize, upSize;
};

/// The error bound of numbers with about 30 digits, a click's and those here together, as a share
/// of the largest terms.
constexpr double kPreciseError = 0x1p-90;

/// The map from a window position to NDC, and the rows of spaceFromClip.
struct ClickMatrixConstants {
    double surfaceHeight;
    double x, y, width, height;                             ///< of the viewport
    double depthAtNear, depthSize, depthScale, depthOffset; ///< z_n = scale (d - dn) / size - offset
    double rows[4][4];
};

/// The size of results above which they are written past the caches (non-temporal stores): they
/// would be evicted before use, and a wholly overwritten cache line need not be read first. It is
/// more than the second-level cache of a core, and less than the arrays that a program may have
/// many of.
constexpr std::size_t kStreamedBytes = std::size_t{16} << 20;
constexpr std::size_t kCacheLine = 64;

template <class Scalar, class Constants>
using Kernel = void (*)(const Constants &, const Scalar *px, const Scalar *py, const Scalar *depth, Scalar *x,
                        Scalar *y, Scalar *z, std::size_t count);

/// @param doubt  0 if x, y and z are exactly a click's; else they are invalid, and slower code must
///         compute them
using PreciseKernel = void (*)(const PreciseConstants &, const double *px, const double *py, const double *depth,
                               double *x, double *y, double *z, double *doubt, std::size_t count);

struct ClickKernels {
    PreciseKernel perspective, box;
    Kernel<double, ClickMatrixConstants> matrix;
};

/// A row of a depth image: depth[i] belongs to the device position (px + i, py).
struct DepthRow {
    const float *depth;
    std::size_t count;
    double px, py;
    float lowest, highest; ///< depths outside (NaN too) are skipped
    bool canOverflow;      ///< whether points may leave the range of their numbers; those are skipped too
};

/// A row of pixels with their window depths, or with their distances from the plane of the eye:
/// values[i] belongs to the device position (px + i, py). The point of a NaN is NaN.
struct DepthLine {
    const double *values;
    std::size_t count;
    double px, py;
};

/// The same of numbers in single precision. The point of a number outside [lowest, highest] is NaN;
/// the others are divided.
struct FloatLine {
    const float *values;
    std::size_t count;
    double px, py;
    float lowest, highest;
    double divisor = 1.0;
};

/// @param points  x, y, z of each pixel, one after the other
template <class Scalar, class Constants>
struct LineLoops {
    void (*ofDoubles)(const Constants &, const DepthLine &, Scalar *points);
    void (*ofFloats)(const Constants &, const FloatLine &, Scalar *points);

    void operator()(const Constants &constants, const DepthLine &line, Scalar *points) const
    {
        ofDoubles(constants, line, points);
    }
    void operator()(const Constants &constants, const FloatLine &line, Scalar *points) const
    {
        ofFloats(constants, line, points);
    }
};

/// The loops of a method.
template <class Scalar, class Constants>
struct Loops {
    Kernel<Scalar, Constants> arrays;
    /// @param points  room for count of them, x, y, z one after the other; the rest after the results
    ///         is scratch
    /// @return the number of points written
    std::size_t (*row)(const Constants &, const DepthRow &, Scalar *points);
    LineLoops<Scalar, Constants> line;
};
template <class Scalar>
struct LoopsOf {
    Loops<Scalar, ClosedFormConstants> perspective, box;
    Loops<Scalar, MatrixConstants> matrix;
    LineLoops<Scalar, ClosedFormConstants> perspectiveDistances;
};

/// Points with an array for each coordinate, and the depths that they were computed from.
struct PointArrays {
    const double *x, *y, *z, *depth;
    std::size_t count;
    double lowest, highest; ///< ends of the depth range
};

/// Writes x, y, z of each point, one after the other: NaN if its depth is outside the range or a
/// coordinate is not finite.
using PointsKernel = void (*)(const PointArrays &, double *points);

/// The loops of one instruction set. They compute in double for every array type.
struct Kernels {
    LoopsOf<double> ofDoubles;
    LoopsOf<float> ofFloats;
    ClickKernels clicks;
    PointsKernel validPoints;
};

extern const Kernels kBaselineKernels;
#ifdef UNPROJECTOR_WIDE_KERNELS
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;
#endif

} // namespace unprojector::unproject::batch
