#include <immintrin.h>

#include <cstddef>

namespace unprojector::unproject::batch {
namespace {

/// Eight doubles.
struct Pack {
    static constexpr std::size_t kLanes = 8;
    __m512d lanes;

    Pack() = default;
    Pack(__m512d packed) : lanes(packed) {}
    explicit Pack(double value) : lanes(_mm512_set1_pd(value)) {}
    static Pack loaded(const double *from) { return _mm512_loadu_pd(from); }
    static Pack loaded(const float *from) { return _mm512_maskz_cvtps_pd(kAll, _mm256_loadu_ps(from)); }
    void store(double *to) const { _mm512_storeu_pd(to, lanes); }
    void store(float *to) const { _mm256_storeu_ps(to, asFloats()); }
    void stream(double *to) const { _mm512_stream_pd(to, lanes); }
    void stream(float *to) const { _mm256_stream_ps(to, asFloats()); }
    static void prefetch(const char *from) { _mm_prefetch(from, _MM_HINT_T0); }
    static void finishStreaming() { _mm_sfence(); }
    static Pack counted() { return _mm512_set_pd(7, 6, 5, 4, 3, 2, 1, 0); }
    /// The lanes within [low, high], one bit each.
    unsigned within(double low, double high) const
    {
        const __mmask8 above = _mm512_cmp_pd_mask(lanes, _mm512_set1_pd(low), _CMP_GE_OQ);
        return _mm512_mask_cmp_pd_mask(above, lanes, _mm512_set1_pd(high), _CMP_LE_OQ);
    }
    /// x0 y0 z0 x1 y1 z1 ...
    static void storeInterleaved(const Pack (&p)[3], float *to)
    {
        const __m512 xy = _mm512_insertf32x8(_mm512_castps256_ps512(p[0].asFloats()), p[1].asFloats(), 1);
        const __m512 z = _mm512_castps256_ps512(p[2].asFloats());
        const __m512i first = _mm512_set_epi32(5, 20, 12, 4, 19, 11, 3, 18, 10, 2, 17, 9, 1, 16, 8, 0);
        const __m512i second = _mm512_set_epi32(0, 0, 0, 0, 0, 0, 0, 0, 23, 15, 7, 22, 14, 6, 21, 13);
        _mm512_storeu_ps(to, _mm512_permutex2var_ps(xy, first, z));
        _mm512_mask_storeu_ps(to + 16, 0xff, _mm512_permutex2var_ps(xy, second, z));
    }
    static void storeInterleaved(const Pack (&p)[3], double *to)
    {
        const __m512d x = p[0].lanes, y = p[1].lanes, z = p[2].lanes;
        const auto store = [&](__m512i ofXY, __m512i withZ, double *at) {
            _mm512_storeu_pd(at, _mm512_permutex2var_pd(_mm512_permutex2var_pd(x, ofXY, y), withZ, z));
        };
        // 0 to 7: a lane of the first register; from 8 on, of the second.
        store(_mm512_set_epi64(10, 2, 0, 9, 1, 0, 8, 0), _mm512_set_epi64(7, 6, 9, 4, 3, 8, 1, 0), to);
        store(_mm512_set_epi64(5, 0, 12, 4, 0, 11, 3, 0), _mm512_set_epi64(7, 12, 5, 4, 11, 2, 1, 10), to + 8);
        store(_mm512_set_epi64(0, 15, 7, 0, 14, 6, 0, 13), _mm512_set_epi64(15, 6, 5, 14, 3, 2, 13, 0), to + 16);
    }
    friend Pack operator+(Pack a, Pack b) { return _mm512_add_pd(a.lanes, b.lanes); }
    friend Pack operator-(Pack a, Pack b) { return _mm512_sub_pd(a.lanes, b.lanes); }
    friend Pack operator*(Pack a, Pack b) { return _mm512_mul_pd(a.lanes, b.lanes); }
    friend Pack operator/(Pack a, Pack b) { return _mm512_div_pd(a.lanes, b.lanes); }
    /// The processor has operations of a product and a sum that round once.
    static constexpr bool kFuses = true;
    static Pack productPlus(Pack a, Pack b, Pack c) { return _mm512_fmadd_pd(a.lanes, b.lanes, c.lanes); }
    static Pack productMinus(Pack a, Pack b, Pack c) { return _mm512_fmsub_pd(a.lanes, b.lanes, c.lanes); }
    friend Pack magnitude(Pack a) { return _mm512_andnot_pd(_mm512_set1_pd(-0.0), a.lanes); }

private:
    static constexpr __mmask8 kAll = 0xff; // GCC 12 warns of its own unmasked conversions: "may be used uninitialized"

    __m256 asFloats() const { return _mm512_maskz_cvtpd_ps(kAll, lanes); }
};

} // namespace
} // namespace unprojector::unproject::batch

#define UNPROJECTOR_KERNELS kAvx512Kernels
#include "core/unproject/batch/kernels.inl"
