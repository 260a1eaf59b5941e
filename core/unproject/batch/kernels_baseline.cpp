#ifdef UNPROJECTOR_WIDE_KERNELS // x86-64
#include <emmintrin.h>
#endif
#include <cstddef>

namespace unprojector::unproject::batch {
namespace {

#ifdef UNPROJECTOR_WIDE_KERNELS

/// Two doubles: SSE2, which every x86-64 has.
struct Pack {
    static constexpr std::size_t kLanes = 2;
    __m128d lanes;

    Pack() = default;
    Pack(__m128d packed) : lanes(packed) {}
    explicit Pack(double value) : lanes(_mm_set1_pd(value)) {}
    static Pack loaded(const double *from) { return _mm_loadu_pd(from); }
    static Pack loaded(const float *from)
    {
        return _mm_cvtps_pd(_mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i *>(from))));
    }
    void store(double *to) const { _mm_storeu_pd(to, lanes); }
    void store(float *to) const { _mm_storel_epi64(reinterpret_cast<__m128i *>(to), asFloats()); }
    void stream(double *to) const { _mm_stream_pd(to, lanes); }
    void stream(float *to) const { _mm_stream_si64(reinterpret_cast<long long *>(to), _mm_cvtsi128_si64(asFloats())); }
    static void prefetch(const char *from) { _mm_prefetch(from, _MM_HINT_T0); }
    static void finishStreaming() { _mm_sfence(); }
    static Pack counted() { return _mm_set_pd(1, 0); }
    /// One bit a lane.
    unsigned between(double low, double high) const
    {
        return static_cast<unsigned>(
            _mm_movemask_pd(_mm_and_pd(_mm_cmpgt_pd(lanes, _mm_set1_pd(low)), _mm_cmplt_pd(lanes, _mm_set1_pd(high)))));
    }
    /// The ends included.
    static unsigned between(const float *values, float low, float high)
    {
        return unsigned(values[0] >= low && values[0] <= high) | unsigned(values[1] >= low && values[1] <= high) << 1;
    }
    /// x0 y0 z0 x1 y1 z1
    static void storeInterleaved(const Pack (&p)[3], float *to)
    {
        float of[3][2];
        for (int k = 0; k < 3; ++k)
            p[k].store(of[k]);
        for (int i = 0; i < 6; ++i)
            to[i] = of[i % 3][i / 3]; // NOLINT(clang-analyzer-core.uninitialized.Assign): the store filled it
    }
    friend Pack operator+(Pack a, Pack b) { return _mm_add_pd(a.lanes, b.lanes); }
    friend Pack operator-(Pack a, Pack b) { return _mm_sub_pd(a.lanes, b.lanes); }
    friend Pack operator*(Pack a, Pack b) { return _mm_mul_pd(a.lanes, b.lanes); }
    friend Pack operator/(Pack a, Pack b) { return _mm_div_pd(a.lanes, b.lanes); }
    friend Pack magnitude(Pack a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a.lanes); }

private:
    __m128i asFloats() const { return _mm_castps_si128(_mm_cvtpd_ps(lanes)); }
};

#else

/// One double, for processors that we have no wider loops for; the compiler may find some.
struct Pack {
    static constexpr std::size_t kLanes = 1;
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
    unsigned between(double low, double high) const { return lane > low && lane < high; }
    static unsigned between(const float *value, float low, float high) { return *value >= low && *value <= high; }
    static void storeInterleaved(const Pack (&p)[3], float *to)
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
