#include "core/base/double_double.h"

namespace unprojector::base {

// Taylor's series for a 64th of the angle, doubled six times: sin 2x = 2 sin x cos x, 1 - cos 2x =
// 2 sin^2 x.
SineCosine preciseSineCosine(const DoubleDouble &radians)
{
    constexpr int kDoublings = 6;
    const DoubleDouble x(std::scalbn(radians.value, -kDoublings), std::scalbn(radians.rest, -kDoublings));
    DoubleDouble sine = x, oneMinusCosine = x * x / 2.0, sineTerm = x, cosineTerm = oneMinusCosine;
    for (int k = 2; k < 20; k += 2) {
        sineTerm = -sineTerm * x * x / double(k * (k + 1));
        cosineTerm = -cosineTerm * x * x / double((k + 1) * (k + 2));
        sine = sine + sineTerm;
        oneMinusCosine = oneMinusCosine + cosineTerm;
    }
    for (int i = 0; i < kDoublings; ++i) {
        const DoubleDouble doubled = 2.0 * sine * (1.0 - oneMinusCosine);
        oneMinusCosine = 2.0 * sine * sine;
        sine = doubled;
    }
    return {sine, 1.0 - oneMinusCosine};
}

DoubleDouble preciseTangent(const DoubleDouble &radians)
{
    const auto [sine, cosine] = preciseSineCosine(radians);
    return sine / cosine;
}

} // namespace unprojector::base
