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

/// Calls step(from, to, i) for whole packs of arrays from index i on; the last points go through
/// arrays of a pack's length.
template <std::size_t kFrom, std::size_t kTo, class Scalar, class Step>
void inPacks(const Scalar *const (&from)[kFrom], Scalar *const (&to)[kTo], std::size_t begin, std::size_t end,
             const Step &step)
{
    std::size_t i = begin;
    for (; i + Pack::kLanes <= end; i += Pack::kLanes)
        step(from, to, i);
    if (i >= end)
        return;
    Scalar in[kFrom][Pack::kLanes] = {}, out[kTo][Pack::kLanes];
    const Scalar *lastFrom[kFrom];
    Scalar *lastTo[kTo];
    for (std::size_t of = 0; of < kFrom; ++of) {
        for (std::size_t k = i; k < end; ++k)
            in[of][k - i] = from[of][k];
        lastFrom[of] = in[of];
    }
    for (std::size_t of = 0; of < kTo; ++of)
        lastTo[of] = out[of];
    step(lastFrom, lastTo, 0);
    for (std::size_t of = 0; of < kTo; ++of) {
        for (std::size_t k = i; k < end; ++k)
            to[of][k] = out[of][k - i];
    }
}

/// Writes whole cache lines of the three results past the caches, each in one go: a line filled in
/// small packs is written in parts, and takes several times as long.
/// @pre a cache line of each result begins at `begin`
/// @return where it stopped, less than a line before the end
template <class Scalar, class Step>
std::size_t inLines(const Scalar *const (&from)[3], Scalar *const (&to)[3], std::size_t begin, std::size_t end,
                    const Step &step)
{
    constexpr std::size_t kPoints = kCacheLine / sizeof(Scalar);
    alignas(kCacheLine) Scalar line[3][kPoints];
    std::size_t i = begin;
    for (; i + kPoints <= end; i += kPoints) {
        for (const Scalar *of : from)
            Pack::prefetch(ahead(of + i));
        for (std::size_t k = 0; k < kPoints; k += Pack::kLanes) {
            const Scalar *const part[3] = {from[0] + i + k, from[1] + i + k, from[2] + i + k};
            Scalar *const points[3] = {line[0] + k, line[1] + k, line[2] + k};
            step(part, points, 0);
        }
        for (int axis = 0; axis < 3; ++axis) {
            for (std::size_t k = 0; k < kPoints; k += Pack::kLanes)
                Pack::loaded(line[axis] + k).stream(to[axis] + i + k);
        }
    }
    Pack::finishStreaming();
    return i;
}

/// @pre no result overlaps another or an input: the first points are computed twice
template <class Method, class Scalar>
void unproject(const typename Method::Constants &constants, const Scalar *px, const Scalar *py, const Scalar *depth,
               Scalar *x, Scalar *y, Scalar *z, std::size_t count)
{
    const typename Method::Constants c = constants; // no store can change it
    const Scalar *const from[3] = {px, py, depth};
    Scalar *const to[3] = {x, y, z};
    const auto step = [&c](const Scalar *const(&in)[3], Scalar *const(&out)[3], std::size_t i) {
        Pack p[3];
        Method(c, Pack::loaded(in[1] + i)).unproject(c, Pack::loaded(in[0] + i), Pack::loaded(in[2] + i), p);
        for (int k = 0; k < 3; ++k)
            p[k].store(out[k] + i);
    };
    std::size_t done = 0;
    if (const std::size_t offset = offsetInLine(x); 3 * count * sizeof(Scalar) >= kStreamedBytes
                                                    && offset % sizeof(Scalar) == 0 && offsetInLine(y) == offset
                                                    && offsetInLine(z) == offset) {
        // A line's length of points covers the part before the first whole line. inLines writes the rest of them
        // again, all of them at offset 0. One call of inPacks less lets the compiler inline it and keep the constants
        // in registers.
        constexpr std::size_t kPoints = kCacheLine / sizeof(Scalar);
        for (std::size_t i = 0; i < kPoints; i += Pack::kLanes)
            step(from, to, i);
        done = inLines(from, to, (kCacheLine - offset) / sizeof(Scalar) % kPoints, count, step);
    }
    inPacks(from, to, done, count, step);
}

#include "core/unproject/batch/precise.inl"

/// What stands for no number: a depth outside every range, and each coordinate where there is no
/// point. A constant, because a call could compile the library's function for this instruction set.
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

constexpr unsigned kAllLanes = (1u << Pack::kLanes) - 1;

/// The greatest coordinate in double that stays finite in another number type.
template <class Scalar>
constexpr double kGreatest = std::numeric_limits<double>::max();
template <>
constexpr double kGreatest<float> = 0x1.fffffefffffffp127; // the next one rounds to infinity

template <class Scalar>
unsigned finiteLanes(const Pack (&p)[3])
{
    unsigned lanes = kAllLanes;
    for (const Pack &coordinates : p)
        lanes &= coordinates.within(-kGreatest<Scalar>, kGreatest<Scalar>);
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

/// Calls step(values, px, points) for whole packs of a row's values; it returns where the next points
/// go. The last values go through arrays of a pack's length.
/// @return the end of the points
template <class Number, class Scalar, class Step>
Scalar *alongRow(const Number *values, std::size_t count, double firstX, Scalar *points, const Step &step)
{
    Pack px = Pack::counted() + Pack(firstX);
    std::size_t i = 0;
    for (; i + Pack::kLanes <= count; i += Pack::kLanes, px = px + Pack(double(Pack::kLanes)))
        points = step(values + i, px, points);
    if (i == count)
        return points;
    Number rest[Pack::kLanes];
    for (std::size_t lane = 0; lane < Pack::kLanes; ++lane)
        rest[lane] = i + lane < count ? values[i + lane] : static_cast<Number>(kNoNumber);
    Scalar last[3 * Pack::kLanes];
    const Scalar *const end = step(rest, px, last), *const full = last + 3 * (count - i);
    for (const Scalar *from = last; from != end && from != full; ++from)
        *points++ = *from;
    return points;
}

template <class Method, class Scalar>
std::size_t unprojectRow(const typename Method::Constants &constants, const DepthRow &row, Scalar *points)
{
    const typename Method::Constants c = constants; // no store can change it
    const Method method(c, Pack(row.py));
    const Scalar *const end =
        alongRow(row.depth, row.count, row.px, points, [&](const float *depth, Pack px, Scalar *next) {
            const Pack d = Pack::loaded(depth);
            unsigned lanes = d.within(static_cast<double>(row.lowest), static_cast<double>(row.highest));
            if (lanes == 0)
                return next;
            Pack p[3];
            method.unproject(c, px, d, p);
            if (row.canOverflow)
                lanes &= finiteLanes<Scalar>(p);
            return appended(p, lanes, next);
        });
    return static_cast<std::size_t>(end - points) / 3;
}

/// Perspective with known distances instead of depths.
class PerspectiveDistances : public Perspective {
public:
    using Perspective::Perspective;

    void unproject(const Constants &c, Pack px, Pack distance, Pack (&p)[3]) const { atDistance(c, px, distance, p); }
};

/// Writes the points of a pack, NaN for those whose lane is not set.
template <class Scalar>
void storeValid(const Pack (&p)[3], unsigned lanes, Scalar *to)
{
    Pack::storeInterleaved(p, to);
    for (std::size_t lane = 0; lanes != kAllLanes && lane < Pack::kLanes; ++lane) {
        for (int k = 0; (lanes >> lane & 1) == 0 && k < 3; ++k)
            to[3 * lane + static_cast<std::size_t>(k)] = static_cast<Scalar>(kNoNumber);
    }
}

void storeValidPoints(const PointArrays &from, double *points)
{
    const auto pack = [&](const double *x, const double *y, const double *z, const double *depth, double *to) {
        const Pack p[3] = {Pack::loaded(x), Pack::loaded(y), Pack::loaded(z)};
        storeValid(p, Pack::loaded(depth).within(from.lowest, from.highest) & finiteLanes<double>(p), to);
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

template <class Method, class Scalar>
void unprojectLine(const typename Method::Constants &constants, const DepthLine &line, Scalar *points)
{
    const typename Method::Constants c = constants; // no store can change it
    const Method method(c, Pack(line.py));
    alongRow(line.values, line.count, line.px, points, [&](const double *values, Pack px, Scalar *to) {
        Pack p[3];
        method.unproject(c, px, Pack::loaded(values), p);
        Pack::storeInterleaved(p, to);
        return to + 3 * Pack::kLanes;
    });
}

template <class Method, bool divides, class Scalar>
void unprojectFloats(const typename Method::Constants &constants, const FloatLine &line, Scalar *points)
{
    const typename Method::Constants c = constants; // no store can change it
    const Method method(c, Pack(line.py));
    const Pack divisor(line.divisor);
    alongRow(line.values, line.count, line.px, points, [&](const float *values, Pack px, Scalar *to) {
        Pack value = Pack::loaded(values), p[3];
        const unsigned lanes = value.within(static_cast<double>(line.lowest), static_cast<double>(line.highest));
        if constexpr (divides)
            value = value / divisor;
        method.unproject(c, px, value, p);
        storeValid(p, lanes, to);
        return to + 3 * Pack::kLanes;
    });
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
constexpr LineLoops<Scalar, typename Method::Constants> kLine{unprojectLine<Method, Scalar>,
                                                              unprojectFloats<Method, Scalar>};
template <class Method, class Scalar>
constexpr Loops<Scalar, typename Method::Constants> kLoops{unproject<Method, Scalar>, unprojectRow<Method, Scalar>,
                                                           kLine<Method, Scalar>};
template <class Scalar>
constexpr LoopsOf<Scalar> kLoopsOf{kLoops<Perspective, Scalar>, kLoops<Box, Scalar>, kLoops<Matrix, Scalar>,
                                   kLine<PerspectiveDistances, Scalar>};

} // namespace

const Kernels UNPROJECTOR_KERNELS{kLoopsOf<double>,
                                  kLoopsOf<float>,
                                  {unprojectPrecisely<true>, unprojectPrecisely<false>, unproject<ClickMatrix, double>},
                                  storeValidPoints};

} // namespace unprojector::unproject::batch
