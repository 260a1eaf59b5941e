#include <immintrin.h>

#include <cstddef>

namespace unprojector::batch {
namespace {

/// Eight doubles.
struct Pack {
    static constexpr std::size_t kLanes = 8;
    __m512d lanes;

    Pack() = default;
    Pack(__m512d lanes_) : lanes(lanes_) {}
    explicit Pack(double value) : lanes(_mm512_set1_pd(value)) {}
    static Pack loaded(const double *from) { return _mm512_loadu_pd(from); }
    static Pack loaded(const float *from) { return _mm512_maskz_cvtps_pd(kAll, _mm256_loadu_ps(from)); }
    void store(double *to) const { _mm512_storeu_pd(to, lanes); }
    void store(float *to) const { _mm256_storeu_ps(to, asFloats()); }
    void stream(double *to) const { _mm512_stream_pd(to, lanes); }
    void stream(float *to) const { _mm256_stream_ps(to, asFloats()); }
    static void finishStreaming() { _mm_sfence(); }
    friend Pack operator+(Pack a, Pack b) { return _mm512_add_pd(a.lanes, b.lanes); }
    friend Pack operator-(Pack a, Pack b) { return _mm512_sub_pd(a.lanes, b.lanes); }
    friend Pack operator*(Pack a, Pack b) { return _mm512_mul_pd(a.lanes, b.lanes); }
    friend Pack operator/(Pack a, Pack b) { return _mm512_div_pd(a.lanes, b.lanes); }

private:
    static constexpr __mmask8 kAll = 0xff; // GCC 12 warns of its own unmasked conversions: "may be used uninitialized"

    __m256 asFloats() const { return _mm512_maskz_cvtpd_ps(kAll, lanes); }
};

} // namespace
} // namespace unprojector::batch

#define UNPROJECTOR_KERNELS kAvx512Kernels
#include "core/batch/kernels.inl"
