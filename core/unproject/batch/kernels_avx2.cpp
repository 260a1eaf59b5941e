#include <immintrin.h>

#include "core/unproject/batch/interleaved.inl"

#include <cstddef>

namespace unprojector::unproject::batch {
namespace {

/// Four doubles.
struct Pack {
    static constexpr std::size_t kLanes = 4;
    __m256d lanes;

    Pack() = default;
    Pack(__m256d packed) : lanes(packed) {}
    explicit Pack(double value) : lanes(_mm256_set1_pd(value)) {}
    static Pack loaded(const double *from) { return _mm256_loadu_pd(from); }
    static Pack loaded(const float *from) { return _mm256_cvtps_pd(_mm_loadu_ps(from)); }
    void store(double *to) const { _mm256_storeu_pd(to, lanes); }
    void store(float *to) const { _mm_storeu_ps(to, _mm256_cvtpd_ps(lanes)); }
    void stream(double *to) const { _mm256_stream_pd(to, lanes); }
    void stream(float *to) const { _mm_stream_ps(to, _mm256_cvtpd_ps(lanes)); }
    static void prefetch(const char *from) { _mm_prefetch(from, _MM_HINT_T0); }
    static void finishStreaming() { _mm_sfence(); }
    static Pack counted() { return _mm256_set_pd(3, 2, 1, 0); }
    /// The lanes within [low, high], one bit each.
    unsigned within(double low, double high) const
    {
        return static_cast<unsigned>(
            _mm256_movemask_pd(_mm256_and_pd(_mm256_cmp_pd(lanes, _mm256_set1_pd(low), _CMP_GE_OQ),
                                             _mm256_cmp_pd(lanes, _mm256_set1_pd(high), _CMP_LE_OQ))));
    }
    /// x0 y0 z0 x1 y1 z1 ...
    static void storeInterleaved(const Pack (&p)[3], float *to)
    {
        const __m128 x = _mm256_cvtpd_ps(p[0].lanes), y = _mm256_cvtpd_ps(p[1].lanes), z = _mm256_cvtpd_ps(p[2].lanes);
        storeInterleavedFloats(x, y, z, to);
    }
    static void storeInterleaved(const Pack (&p)[3], double *to)
    {
        const __m256d x = p[0].lanes, y = p[1].lanes, z = p[2].lanes;
        const __m256d x0y0x2y2 = _mm256_unpacklo_pd(x, y), y1z1y3z3 = _mm256_unpackhi_pd(y, z);
        const __m256d z0x1z2x3 = _mm256_shuffle_pd(z, x, 0b1010);
        _mm256_storeu_pd(to, _mm256_permute2f128_pd(x0y0x2y2, z0x1z2x3, 0x20));
        _mm256_storeu_pd(to + 4, _mm256_blend_pd(y1z1y3z3, x0y0x2y2, 0b1100));
        _mm256_storeu_pd(to + 8, _mm256_permute2f128_pd(z0x1z2x3, y1z1y3z3, 0x31));
    }
    friend Pack operator+(Pack a, Pack b) { return _mm256_add_pd(a.lanes, b.lanes); }
    friend Pack operator-(Pack a, Pack b) { return _mm256_sub_pd(a.lanes, b.lanes); }
    friend Pack operator*(Pack a, Pack b) { return _mm256_mul_pd(a.lanes, b.lanes); }
    friend Pack operator/(Pack a, Pack b) { return _mm256_div_pd(a.lanes, b.lanes); }
    /// The processor has operations of a product and a sum that round once.
    static constexpr bool kFuses = true;
    static Pack productPlus(Pack a, Pack b, Pack c) { return _mm256_fmadd_pd(a.lanes, b.lanes, c.lanes); }
    static Pack productMinus(Pack a, Pack b, Pack c) { return _mm256_fmsub_pd(a.lanes, b.lanes, c.lanes); }
    friend Pack magnitude(Pack a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.lanes); }
};

} // namespace
} // namespace unprojector::unproject::batch

#define UNPROJECTOR_KERNELS kAvx2Kernels
#include "core/unproject/batch/kernels.inl"
