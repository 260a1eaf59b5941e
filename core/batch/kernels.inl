// Included by one file for each instruction set, which says before it what a Pack of that set is and, with
// UNPROJECTOR_KERNELS, which table to define. Everything is in an unnamed namespace, and nothing of the library is
// included that compiles to functions: code compiled for a new processor must not be what the linker takes for the
// same function elsewhere.

#include "core/batch/kernels.h"

#include <cstdint>

namespace unprojector::batch {
namespace {

/// The sum of products that ends both closed forms: origin + ((across X + down Y) + ahead Z).
inline void place(const ClosedFormConstants &c, Pack across, Pack down, Pack distance, Pack (&p)[3])
{
    for (int k = 0; k < 3; ++k) {
        p[k] = Pack(c.origin[k])
               + ((Pack(c.across[k]) * across + Pack(c.down[k]) * down) + Pack(c.ahead[k]) * distance);
    }
}

struct Perspective {
    using Constants = ClosedFormConstants;
    static void unproject(const Constants &c, Pack px, Pack py, Pack d, Pack (&p)[3])
    {
        const Pack distance =
            Pack(c.nearTerm) / ((Pack(c.depthAtFar) - d) + (d - Pack(c.depthAtNear)) * Pack(c.farTerm));
        const Pack across = ((px - Pack(c.axisX)) - Pack(c.axisXRest)) * distance;
        const Pack down = ((py - Pack(c.axisY)) - Pack(c.axisYRest)) * distance;
        place(c, across, down, distance, p);
    }
};

struct Box {
    using Constants = ClosedFormConstants;
    static void unproject(const Constants &c, Pack px, Pack py, Pack d, Pack (&p)[3])
    {
        const Pack distance =
            (Pack(c.depthAtFar) - d) * Pack(c.nearTerm) + (d - Pack(c.depthAtNear)) * Pack(c.farTerm);
        place(c, (px - Pack(c.axisX)) - Pack(c.axisXRest), (py - Pack(c.axisY)) - Pack(c.axisYRest), distance, p);
    }
};

struct Matrix {
    using Constants = MatrixConstants;
    static void unproject(const Constants &c, Pack px, Pack py, Pack d, Pack (&p)[3])
    {
        const auto row = [&](const double(&r)[4]) {
            return (Pack(r[0]) * px + Pack(r[1]) * py) + (Pack(r[2]) * d + Pack(r[3]));
        };
        const Pack reciprocal = Pack(1.0) / row(c.rows[3]);
        for (int k = 0; k < 3; ++k)
            p[k] = row(c.rows[k]) * reciprocal;
    }
};

template <class Scalar>
std::size_t offsetInLine(const Scalar *p)
{
    return reinterpret_cast<std::uintptr_t>(p) % kCacheLine;
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

    /// Whether whole cache lines of all three results begin at the same point.
    bool canStream() const
    {
        const std::size_t offset = offsetInLine(m_x);
        return offset % sizeof(Scalar) == 0 && offsetInLine(m_y) == offset && offsetInLine(m_z) == offset;
    }

    /// Past the caches. @pre canStream()
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
    /// Whole packs. @return where it stopped, less than a pack before the end
    template <bool streams>
    std::size_t packs(std::size_t begin, std::size_t end) const
    {
        std::size_t i = begin;
        for (; i + Pack::kLanes <= end; i += Pack::kLanes) {
            Pack p[3];
            Method::unproject(m_constants, Pack::loaded(m_px + i), Pack::loaded(m_py + i), Pack::loaded(m_depth + i), p);
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

    /// Fewer points than a pack has lanes.
    void rest(std::size_t begin, std::size_t end) const
    {
        Scalar in[3][Pack::kLanes] = {}, out[3][Pack::kLanes];
        for (std::size_t i = begin; i < end; ++i) {
            in[0][i - begin] = m_px[i];
            in[1][i - begin] = m_py[i];
            in[2][i - begin] = m_depth[i];
        }
        Pack p[3];
        Method::unproject(m_constants, Pack::loaded(in[0]), Pack::loaded(in[1]), Pack::loaded(in[2]), p);
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

} // namespace

const Kernels UNPROJECTOR_KERNELS{
    {unproject<Perspective, double>, unproject<Box, double>, unproject<Matrix, double>},
    {unproject<Perspective, float>, unproject<Box, float>, unproject<Matrix, float>}};

} // namespace unprojector::batch
