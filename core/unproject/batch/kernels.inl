// Included by one file for each instruction set, which first defines Pack for that set and, with
// UNPROJECTOR_KERNELS, the table to define. Everything is in an unnamed namespace, and no library
// header that compiles to functions is included: the linker must not use code compiled for a new
// processor as the same function elsewhere.

#include "core/unproject/batch/kernels.h"

#include <cstdint>
#include <limits>

namespace unprojector::unproject::batch {
namespace {

// Each method precomputes its values for a row of the view, which the pixels of an image row share,
// and computes the points on it.

/// p = origin + z (across X + (down Y + ahead))
class Perspective {
public:
    using Constants = ClosedFormConstants;

    Perspective(const Constants &c, Pack py)
    {
        const Pack y = (py - Pack(c.axisY)) - Pack(c.axisYRest);
        for (int k = 0; k < 3; ++k)
            m_direction[k] = Pack(c.down[k]) * y + Pack(c.ahead[k]);
    }
    void unproject(const Constants &c, Pack px, Pack d, Pack (&p)[3]) const
    {
        atDistance(c, px, Pack(c.nearTerm) / ((Pack(c.depthAtFar) - d) + (d - Pack(c.depthAtNear)) * Pack(c.farTerm)),
                   p);
    }
    void atDistance(const Constants &c, Pack px, Pack distance, Pack (&p)[3]) const
    {
        const Pack x = (px - Pack(c.axisX)) - Pack(c.axisXRest);
        for (int k = 0; k < 3; ++k)
            p[k] = Pack(c.origin[k]) + (Pack(c.across[k]) * x + m_direction[k]) * distance;
    }

private:
    Pack m_direction[3];
};

/// p = origin + ((across X + down Y) + z ahead). The origin comes last: it may be large and cancel.
class Box {
public:
    using Constants = ClosedFormConstants;

    Box(const Constants &c, Pack py)
    {
        const Pack y = (py - Pack(c.axisY)) - Pack(c.axisYRest);
        for (int k = 0; k < 3; ++k)
            m_down[k] = Pack(c.down[k]) * y;
    }
    void unproject(const Constants &c, Pack px, Pack d, Pack (&p)[3]) const
    {
        const Pack distance = (Pack(c.depthAtFar) - d) * Pack(c.nearTerm) + (d - Pack(c.depthAtNear)) * Pack(c.farTerm);
        const Pack x = (px - Pack(c.axisX)) - Pack(c.axisXRest);
        for (int k = 0; k < 3; ++k)
            p[k] = Pack(c.origin[k]) + ((Pack(c.across[k]) * x + m_down[k]) + Pack(c.ahead[k]) * distance);
    }

private:
    Pack m_down[3];
};

class Matrix {
public:
    using Constants = MatrixConstants;

    Matrix(const Constants &c, Pack py)
    {
        for (int row = 0; row < 4; ++row)
            m_constant[row] = Pack(c.rows[row][1]) * py + Pack(c.rows[row][3]);
    }
    void unproject(const Constants &c, Pack px, Pack d, Pack (&p)[3]) const
    {
        const auto product = [&](int row) {
            return (Pack(c.rows[row][0]) * px + m_constant[row]) + Pack(c.rows[row][2]) * d;
        };
        const Pack reciprocal = Pack(1.0) / product(3);
        for (int k = 0; k < 3; ++k)
            p[k] = product(k) * reciprocal;
    }

private:
    Pack m_constant[4];
};

template <class Scalar>
std::size_t offsetInLine(const Scalar *p)
{
    return reinterpret_cast<std::uintptr_t>(p) % kCacheLine;
}

/// The address to prefetch: far enough ahead for memory to answer in time. It may lie past the
/// array's end, where a prefetch is harmless.
template <class Scalar>
const char *ahead(const Scalar *p)
{
    constexpr std::uintptr_t kPrefetchBytes = 1024;
    return reinterpret_cast<const char *>(reinterpret_cast<std::uintptr_t>(p) + kPrefetchBytes);
}

/// The loops over the points of six arrays.
template <class Method, class Scalar>
class Loop {
public:
    using Constants = typename Method::Constants;

    Loop(const Constants &constants, const Scalar *px, const Scalar *py, const Scalar *depth, Scalar *x, Scalar *y,
         Scalar *z)
        : m_constants(constants), m_px(px), m_py(py), m_depth(depth), m_x(x), m_y(y), m_z(z)
    {
    }

    void run(std::size_t begin, std::size_t end) const
    {
        const std::size_t stopped = packs<false>(begin, end);
        if (stopped < end)
            rest(stopped, end);
    }

    /// Returns whether whole cache lines of all three results begin at the same point.
    bool canStream() const
    {
        const std::size_t offset = offsetInLine(m_x);
        return offset % sizeof(Scalar) == 0 && offsetInLine(m_y) == offset && offsetInLine(m_z) == offset;
    }

    /// Writes past the caches.
    /// @pre canStream()
    void stream(std::size_t begin, std::size_t end) const
    {
        const std::size_t offset = offsetInLine(m_x + begin);
        const std::size_t firstLine = begin + (offset == 0 ? 0 : (kCacheLine - offset) / sizeof(Scalar));
        run(begin, firstLine);
        const std::size_t stopped = packs<true>(firstLine, end);
        Pack::finishStreaming();
        run(stopped, end);
    }

private:
    /// Processes whole packs.
    /// @return where it stopped, less than a pack before the end
    template <bool streams>
    std::size_t packs(std::size_t begin, std::size_t end) const
    {
        std::size_t i = begin;
        if constexpr (streams && Pack::kLanes * sizeof(Scalar) < kCacheLine / 2)
            i = lines(begin, end);
        for (; i + Pack::kLanes <= end; i += Pack::kLanes) {
            if constexpr (streams)
                prefetch(i);
            Pack p[3];
            unproject(i, p);
            if constexpr (streams) {
                p[0].stream(m_x + i);
                p[1].stream(m_y + i);
                p[2].stream(m_z + i);
            } else {
                p[0].store(m_x + i);
                p[1].store(m_y + i);
                p[2].store(m_z + i);
            }
        }
        return i;
    }

    void prefetch(std::size_t i) const
    {
        Pack::prefetch(ahead(m_px + i));
        Pack::prefetch(ahead(m_py + i));
        Pack::prefetch(ahead(m_depth + i));
    }

    void unproject(std::size_t i, Pack (&p)[3]) const
    {
        Method(m_constants, Pack::loaded(m_py + i))
            .unproject(m_constants, Pack::loaded(m_px + i), Pack::loaded(m_depth + i), p);
    }

    /// Writes whole cache lines past the caches, each in one go: a line filled in small packs is
    /// written in parts, and takes several times as long.
    /// @return where it stopped, less than a line before the end
    std::size_t lines(std::size_t begin, std::size_t end) const
    {
        constexpr std::size_t kPoints = kCacheLine / sizeof(Scalar);
        alignas(kCacheLine) Scalar line[3][kPoints];
        std::size_t i = begin;
        for (; i + kPoints <= end; i += kPoints) {
            prefetch(i);
            for (std::size_t k = 0; k < kPoints; k += Pack::kLanes) {
                Pack p[3];
                unproject(i + k, p);
                p[0].store(line[0] + k);
                p[1].store(line[1] + k);
                p[2].store(line[2] + k);
            }
            Scalar *const to[3] = {m_x + i, m_y + i, m_z + i};
            for (int axis = 0; axis < 3; ++axis) {
                for (std::size_t k = 0; k < kPoints; k += Pack::kLanes)
                    Pack::loaded(line[axis] + k).stream(to[axis] + k);
            }
        }
        return i;
    }

    /// Processes the rest: fewer points than a pack has lanes.
    void rest(std::size_t begin, std::size_t end) const
    {
        Scalar in[3][Pack::kLanes] = {}, out[3][Pack::kLanes];
        for (std::size_t i = begin; i < end; ++i) {
            in[0][i - begin] = m_px[i];
            in[1][i - begin] = m_py[i];
            in[2][i - begin] = m_depth[i];
        }
        Pack p[3];
        Method(m_constants, Pack::loaded(in[1])).unproject(m_constants, Pack::loaded(in[0]), Pack::loaded(in[2]), p);
        for (int k = 0; k < 3; ++k)
            p[k].store(out[k]);
        for (std::size_t i = begin; i < end; ++i) {
            m_x[i] = out[0][i - begin];
            m_y[i] = out[1][i - begin];
            m_z[i] = out[2][i - begin];
        }
    }

    const Constants m_constants; // a copy, which no store can change
    const Scalar *m_px, *m_py, *m_depth;
    Scalar *m_x, *m_y, *m_z;
};

template <class Method, class Scalar>
void unproject(const typename Method::Constants &constants, const Scalar *px, const Scalar *py, const Scalar *depth,
               Scalar *x, Scalar *y, Scalar *z, std::size_t count)
{
    const Loop<Method, Scalar> loop(constants, px, py, depth, x, y, z);
    if (3 * count * sizeof(Scalar) >= kStreamedBytes && loop.canStream())
        loop.stream(0, count);
    else
        loop.run(0, count);
}

/// A value outside every range of depths. A constant, because a call could compile the library's
/// function for this instruction set.
constexpr float kNoDepth = std::numeric_limits<float>::quiet_NaN();

constexpr unsigned kAllLanes = (1u << Pack::kLanes) - 1;

/// The bound for coordinates in double that stay finite in another number type.
template <class Scalar>
constexpr double kTooLarge = std::numeric_limits<double>::infinity();
template <>
constexpr double kTooLarge<float> = 0x1.ffffffp127; // the first that rounds to infinity

template <class Scalar>
unsigned finiteLanes(const Pack (&p)[3])
{
    unsigned lanes = kAllLanes;
    for (const Pack &coordinates : p)
        lanes &= coordinates.between(-kTooLarge<Scalar>, kTooLarge<Scalar>);
    return lanes;
}

/// Appends the points of some lanes.
template <class Scalar>
Scalar *appended(const Pack (&p)[3], unsigned lanes, Scalar *next)
{
    if (lanes == kAllLanes) {
        Pack::storeInterleaved(p, next);
        return next + 3 * Pack::kLanes;
    }
    Scalar of[3][Pack::kLanes];
    for (int k = 0; k < 3; ++k)
        p[k].store(of[k]);
    for (std::size_t i = 0; i < Pack::kLanes; ++i) {
        for (int k = 0; k < 3; ++k)
            next[k] = of[k][i];
        next += 3 * (lanes >> i & 1);
    }
    return next;
}

template <class Method, class Scalar>
std::size_t unprojectRow(const typename Method::Constants &constants, const DepthRow &row, Scalar *points)
{
    const typename Method::Constants c = constants; // no store can change it
    const Method method(c, Pack(row.py));
    const auto addPoints = [&](const float *depth, Pack px, Scalar *next) {
        unsigned lanes = Pack::between(depth, row.lowest, row.highest);
        if (lanes == 0)
            return next;
        Pack p[3];
        method.unproject(c, px, Pack::loaded(depth), p);
        if (row.canOverflow)
            lanes &= finiteLanes<Scalar>(p);
        return appended(p, lanes, next);
    };
    Scalar *next = points;
    Pack px = Pack::counted() + Pack(row.px);
    std::size_t i = 0;
    for (; i + Pack::kLanes <= row.count; i += Pack::kLanes, px = px + Pack(double(Pack::kLanes)))
        next = addPoints(row.depth + i, px, next);
    if (i < row.count) {
        float depth[Pack::kLanes];
        Scalar last[3 * Pack::kLanes];
        for (std::size_t lane = 0; lane < Pack::kLanes; ++lane)
            depth[lane] = i + lane < row.count ? row.depth[i + lane] : kNoDepth;
        const Scalar *end = addPoints(depth, px, last);
        for (const Scalar *from = last; from != end; ++from)
            *next++ = *from;
    }
    return static_cast<std::size_t>(next - points) / 3;
}

/// Perspective with known distances instead of depths.
class PerspectiveDistances : public Perspective {
public:
    using Perspective::Perspective;
    void unproject(const Constants &c, Pack px, Pack distance, Pack (&p)[3]) const { atDistance(c, px, distance, p); }
};

template <class Method, class Scalar>
void unprojectLine(const typename Method::Constants &constants, const DepthLine &line, Scalar *points)
{
    const typename Method::Constants c = constants; // no store can change it
    const Method method(c, Pack(line.py));
    Pack px = Pack::counted() + Pack(line.px);
    std::size_t i = 0;
    for (; i + Pack::kLanes <= line.count; i += Pack::kLanes, px = px + Pack(double(Pack::kLanes))) {
        Pack p[3];
        method.unproject(c, px, Pack::loaded(line.values + i), p);
        Pack::storeInterleaved(p, points);
        points += 3 * Pack::kLanes;
    }
    if (i == line.count)
        return;
    double values[Pack::kLanes] = {};
    for (std::size_t lane = 0; i + lane < line.count; ++lane)
        values[lane] = line.values[i + lane];
    Pack p[3];
    method.unproject(c, px, Pack::loaded(values), p);
    Scalar last[3 * Pack::kLanes];
    Pack::storeInterleaved(p, last);
    for (std::size_t k = 0; k < 3 * (line.count - i); ++k)
        points[k] = last[k];
}

/// The point of a pixel without one.
constexpr double kNoCoordinate = std::numeric_limits<double>::quiet_NaN();

/// Writes the points of a pack, NaN for those whose lane is not set.
template <class Scalar>
void storeValid(const Pack (&p)[3], unsigned lanes, Scalar *to)
{
    Pack::storeInterleaved(p, to);
    for (std::size_t lane = 0; lanes != kAllLanes && lane < Pack::kLanes; ++lane) {
        for (int k = 0; (lanes >> lane & 1) == 0 && k < 3; ++k)
            to[3 * lane + static_cast<std::size_t>(k)] = static_cast<Scalar>(kNoCoordinate);
    }
}

void storeValidPoints(const PointArrays &from, double *points)
{
    const auto pack = [&](const double *x, const double *y, const double *z, const double *depth, double *to) {
        const Pack p[3] = {Pack::loaded(x), Pack::loaded(y), Pack::loaded(z)};
        storeValid(p, Pack::between(depth, from.lowest, from.highest) & finiteLanes<double>(p), to);
    };
    std::size_t i = 0;
    for (; i + Pack::kLanes <= from.count; i += Pack::kLanes)
        pack(from.x + i, from.y + i, from.z + i, from.depth + i, points + 3 * i);
    if (i == from.count)
        return;
    double in[4][Pack::kLanes] = {}, last[3 * Pack::kLanes];
    for (std::size_t k = i; k < from.count; ++k) {
        in[0][k - i] = from.x[k];
        in[1][k - i] = from.y[k];
        in[2][k - i] = from.z[k];
        in[3][k - i] = from.depth[k];
    }
    pack(in[0], in[1], in[2], in[3], last);
    for (std::size_t k = 3 * i; k < 3 * from.count; ++k)
        points[k] = last[k - 3 * i];
}

template <class Method, bool divides, class Scalar>
void unprojectFloats(const typename Method::Constants &constants, const FloatLine &line, Scalar *points)
{
    const typename Method::Constants c = constants; // no store can change it
    const Method method(c, Pack(line.py));
    const Pack divisor(line.divisor);
    const auto addPoints = [&](const float *values, Pack px, Scalar *to) {
        const unsigned lanes = Pack::between(values, line.lowest, line.highest);
        Pack value = Pack::loaded(values), p[3];
        if constexpr (divides)
            value = value / divisor;
        method.unproject(c, px, value, p);
        storeValid(p, lanes, to);
        return to + 3 * Pack::kLanes;
    };
    Pack px = Pack::counted() + Pack(line.px);
    std::size_t i = 0;
    for (; i + Pack::kLanes <= line.count; i += Pack::kLanes, px = px + Pack(double(Pack::kLanes)))
        points = addPoints(line.values + i, px, points);
    if (i == line.count)
        return;
    float values[Pack::kLanes] = {};
    for (std::size_t lane = 0; i + lane < line.count; ++lane)
        values[lane] = line.values[i + lane];
    Scalar last[3 * Pack::kLanes];
    addPoints(values, px, last);
    for (std::size_t k = 0; k < 3 * (line.count - i); ++k)
        points[k] = last[k];
}

template <class Method, class Scalar>
void unprojectFloats(const typename Method::Constants &constants, const FloatLine &line, Scalar *points)
{
    if (line.divisor == 1.0)
        unprojectFloats<Method, false>(constants, line, points);
    else
        unprojectFloats<Method, true>(constants, line, points);
}

template <class Method, class Scalar>
constexpr LineKernel<Scalar, typename Method::Constants> kLine{unprojectLine<Method, Scalar>,
                                                               unprojectFloats<Method, Scalar>};
template <class Scalar>
constexpr LineKernelsOf<Scalar> kLines{kLine<Perspective, Scalar>, kLine<Box, Scalar>, kLine<Matrix, Scalar>,
                                       kLine<PerspectiveDistances, Scalar>};

#include "core/unproject/batch/precise.inl"

} // namespace

const Kernels UNPROJECTOR_KERNELS{
    {unproject<Perspective, double>, unproject<Box, double>, unproject<Matrix, double>},
    {unproject<Perspective, float>, unproject<Box, float>, unproject<Matrix, float>},
    {unprojectRow<Perspective, double>, unprojectRow<Box, double>, unprojectRow<Matrix, double>},
    {unprojectRow<Perspective, float>, unprojectRow<Box, float>, unprojectRow<Matrix, float>},
    kLines<double>,
    kLines<float>,
    {unprojectPrecisely<true>, unprojectPrecisely<false>, unproject<ClickMatrix, double>},
    storeValidPoints};

} // namespace unprojector::unproject::batch
