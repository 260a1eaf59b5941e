#include <immintrin.h>

#include <cstddef>

namespace unprojector::batch {
namespace {

/// Four doubles.
struct Pack {
    static constexpr std::size_t kLanes = 4;
    __m256d lanes;

    Pack() = default;
    Pack(__m256d lanes_) : lanes(lanes_) {}
    explicit Pack(double value) : lanes(_mm256_set1_pd(value)) {}
    static Pack loaded(const double *from) { return _mm256_loadu_pd(from); }
    static Pack loaded(const float *from) { return _mm256_cvtps_pd(_mm_loadu_ps(from)); }
    void store(double *to) const { _mm256_storeu_pd(to, lanes); }
    void store(float *to) const { _mm_storeu_ps(to, _mm256_cvtpd_ps(lanes)); }
    void stream(double *to) const { _mm256_stream_pd(to, lanes); }
    void stream(float *to) const { _mm_stream_ps(to, _mm256_cvtpd_ps(lanes)); }
    static void finishStreaming() { _mm_sfence(); }
    friend Pack operator+(Pack a, Pack b) { return _mm256_add_pd(a.lanes, b.lanes); }
    friend Pack operator-(Pack a, Pack b) { return _mm256_sub_pd(a.lanes, b.lanes); }
    friend Pack operator*(Pack a, Pack b) { return _mm256_mul_pd(a.lanes, b.lanes); }
    friend Pack operator/(Pack a, Pack b) { return _mm256_div_pd(a.lanes, b.lanes); }
};

} // namespace
} // namespace unprojector::batch

#define UNPROJECTOR_KERNELS kAvx2Kernels
#include "core/batch/kernels.inl"
