#ifdef UNPROJECTOR_WIDE_KERNELS // x86-64
#include <emmintrin.h>

#include "core/unproject/batch/interleaved.inl"
#endif
#include <cstddef>

namespace unprojector::unproject::batch {
namespace {

#ifdef UNPROJECTOR_WIDE_KERNELS

/// Four doubles in two SSE2 registers, which every x86-64 has, so that loads and stores of four
/// floats fill a register. Half a register can bypass the caches too, but takes more than ten times
/// as long.
struct Pack {
    static constexpr std::size_t kLanes = 4;
    static constexpr bool kFuses = false;
    __m128d low, high;

    Pack() = default;
    Pack(__m128d first, __m128d second) : low(first), high(second) {}
    explicit Pack(double value) : low(_mm_set1_pd(value)), high(low) {}
    static Pack loaded(const double *from) { return {_mm_loadu_pd(from), _mm_loadu_pd(from + 2)}; }
    static Pack loaded(const float *from)
    {
        const __m128 floats = _mm_loadu_ps(from);
        return {_mm_cvtps_pd(floats), _mm_cvtps_pd(_mm_movehl_ps(floats, floats))};
    }
    void store(double *to) const
    {
        _mm_storeu_pd(to, low);
        _mm_storeu_pd(to + 2, high);
    }
    void store(float *to) const { _mm_storeu_ps(to, asFloats()); }
    void stream(double *to) const
    {
        _mm_stream_pd(to, low);
        _mm_stream_pd(to + 2, high);
    }
    void stream(float *to) const { _mm_stream_ps(to, asFloats()); }
    static void prefetch(const char *from) { _mm_prefetch(from, _MM_HINT_T0); }
    static void finishStreaming() { _mm_sfence(); }
    static Pack counted() { return {_mm_set_pd(1, 0), _mm_set_pd(3, 2)}; }
    /// The lanes within [lowest, highest], one bit each.
    unsigned within(double lowest, double highest) const
    {
        const __m128d from = _mm_set1_pd(lowest), to = _mm_set1_pd(highest);
        const auto bits = [&](__m128d two) {
            return static_cast<unsigned>(_mm_movemask_pd(_mm_and_pd(_mm_cmpge_pd(two, from), _mm_cmple_pd(two, to))));
        };
        return bits(low) | bits(high) << 2;
    }
    /// x0 y0 z0 x1 y1 z1 ...
    static void storeInterleaved(const Pack (&p)[3], float *to)
    {
        const __m128 x = p[0].asFloats(), y = p[1].asFloats(), z = p[2].asFloats();
        storeInterleavedFloats(x, y, z, to);
    }
    static void storeInterleaved(const Pack (&p)[3], double *to)
    {
        const auto store = [](__m128d x, __m128d y, __m128d z, double *at) {
            _mm_storeu_pd(at, _mm_unpacklo_pd(x, y));
            _mm_storeu_pd(at + 2, _mm_shuffle_pd(z, x, 0b10));
            _mm_storeu_pd(at + 4, _mm_unpackhi_pd(y, z));
        };
        store(p[0].low, p[1].low, p[2].low, to);
        store(p[0].high, p[1].high, p[2].high, to + 6);
    }
    friend Pack operator+(Pack a, Pack b) { return {_mm_add_pd(a.low, b.low), _mm_add_pd(a.high, b.high)}; }
    friend Pack operator-(Pack a, Pack b) { return {_mm_sub_pd(a.low, b.low), _mm_sub_pd(a.high, b.high)}; }
    friend Pack operator*(Pack a, Pack b) { return {_mm_mul_pd(a.low, b.low), _mm_mul_pd(a.high, b.high)}; }
    friend Pack operator/(Pack a, Pack b) { return {_mm_div_pd(a.low, b.low), _mm_div_pd(a.high, b.high)}; }
    friend Pack magnitude(Pack a)
    {
        const __m128d sign = _mm_set1_pd(-0.0);
        return {_mm_andnot_pd(sign, a.low), _mm_andnot_pd(sign, a.high)};
    }

private:
    __m128 asFloats() const { return _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high)); }
};

#else

/// One double, for processors without wider loops; the compiler may vectorize it.
struct Pack {
    static constexpr std::size_t kLanes = 1;
    static constexpr bool kFuses = false;
    double lane;

    Pack() = default;
    explicit Pack(double value) : lane(value) {}
    template <class Scalar>
    static Pack loaded(const Scalar *from)
    {
        return Pack(static_cast<double>(*from));
    }
    template <class Scalar>
    void store(Scalar *to) const
    {
        *to = static_cast<Scalar>(lane);
    }
    template <class Scalar>
    void stream(Scalar *to) const
    {
        store(to);
    }
    static void prefetch(const char *) {}
    static void finishStreaming() {}
    static Pack counted() { return Pack(0.0); }
    unsigned within(double low, double high) const { return lane >= low && lane <= high; }
    template <class Scalar>
    static void storeInterleaved(const Pack (&p)[3], Scalar *to)
    {
        for (int k = 0; k < 3; ++k)
            p[k].store(to + k);
    }
    friend Pack operator+(Pack a, Pack b) { return Pack(a.lane + b.lane); }
    friend Pack operator-(Pack a, Pack b) { return Pack(a.lane - b.lane); }
    friend Pack operator*(Pack a, Pack b) { return Pack(a.lane * b.lane); }
    friend Pack operator/(Pack a, Pack b) { return Pack(a.lane / b.lane); }
    friend Pack magnitude(Pack a) { return Pack(a.lane < 0.0 ? -a.lane : a.lane); }
};

#endif

} // namespace
} // namespace unprojector::unproject::batch

#define UNPROJECTOR_KERNELS kBaselineKernels
#include "core/unproject/batch/kernels.inl"
