#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace unprojector::base {

/// The rounding error of a + b in double, exactly (Knuth's two-sum).
inline double lostBySum(double a, double b)
{
    const double sum = a + b;
    const double bOfSum = sum - a;
    return (a - (sum - bOfSum)) + (b - bOfSum);
}

/// A double as the sum of two of 26 bits each, whose products are exact (Veltkamp).
struct Halves {
    double high, low;

    explicit Halves(double number)
    {
        constexpr double kLarge = 0x1p996, kShrink = 0x1p-28, kGrow = 0x1p28, kSplitter = 0x1p27 + 1.0;
        const bool isLarge = std::abs(number) > kLarge; // the product with the splitter would overflow
        const double scaled = isLarge ? number * kShrink : number;
        const double product = kSplitter * scaled;
        const double top = product - (product - scaled);
        high = isLarge ? top * kGrow : top;
        low = isLarge ? (scaled - top) * kGrow : scaled - top;
    }
};

/// The rounding error of a b in double, exactly unless it underflows (Dekker). std::fma would do it
/// in one step, but not every library rounds it correctly: MinGW's goes through 64 bits.
inline double lostByProduct(double a, double b)
{
    const Halves x(a), y(b);
    return x.low * y.low - (((a * b - x.high * y.high) - x.low * y.high) - x.high * y.low);
}

/// A number as the unevaluated sum of the nearest double and its rounding error: about 32 digits.
/// Each operation costs some twenty processor operations. Use it for work done once per click,
/// where rounding must not drop digits that are needed after a later cancellation.
///
/// Within 2^-100 of the result for sums of one sign, products, quotients and roots. A difference is
/// within 2^-100 of the larger operand. The range is the same as a double's: beyond it `value` is
/// infinite or NaN.
/// Source: Dekker 1971; Joldes, Muller, Popescu 2017, "Tight and rigorous error bounds for basic
///         building blocks of double-word arithmetic".
struct DoubleDouble {
    double value = 0.0;
    double rest = 0.0; ///< at most half a unit in the last place of `value`

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double number) : value(number) {} // every double is one
    constexpr DoubleDouble(double nearest, double leftOut) : value(nearest), rest(leftOut) {}

    friend bool operator==(const DoubleDouble &, const DoubleDouble &) = default;

    friend DoubleDouble operator-(const DoubleDouble &a) { return {-a.value, -a.rest}; }
    friend DoubleDouble operator+(const DoubleDouble &a, const DoubleDouble &b)
    {
        const double high = a.value + b.value, low = a.rest + b.rest;
        const DoubleDouble sum = renormalised(high, lostBySum(a.value, b.value) + low);
        return renormalised(sum.value, sum.rest + lostBySum(a.rest, b.rest));
    }
    friend DoubleDouble operator-(const DoubleDouble &a, const DoubleDouble &b) { return a + -b; }
    friend DoubleDouble operator*(const DoubleDouble &a, const DoubleDouble &b)
    {
        const double high = a.value * b.value;
        return renormalised(high, lostByProduct(a.value, b.value) + (a.value * b.rest + a.rest * b.value));
    }
    friend DoubleDouble operator/(const DoubleDouble &a, const DoubleDouble &b)
    {
        const double quotient = a.value / b.value;
        const DoubleDouble remainder = a - b * quotient;
        return renormalised(quotient, remainder.value / b.value);
    }
    friend DoubleDouble sqrt(const DoubleDouble &a)
    {
        if (a.value == 0.0)
            return a;
        const double root = std::sqrt(a.value);
        const DoubleDouble remainder = a - DoubleDouble(root) * root;
        return renormalised(root, remainder.value / (2.0 * root));
    }

private:
    /// The sum high + low, with `value` the double nearest to the sum. @pre |low| <= |high|, or
    /// high is 0
    static DoubleDouble renormalised(double high, double low)
    {
        const double sum = high + low;
        return {sum, low - (sum - high)};
    }
};

inline constexpr DoubleDouble kPrecisePi(3.14159265358979323846, 1.2246467991473532e-16);

struct SineCosine {
    DoubleDouble sine, cosine;
};
/// Sine and cosine of an angle in radians, inside (-pi, pi).
SineCosine preciseSineCosine(const DoubleDouble &radians);
/// Tangent of an angle in radians, inside (-pi, pi).
DoubleDouble preciseTangent(const DoubleDouble &radians);

using DoubleDouble3 = std::array<DoubleDouble, 3>;

inline DoubleDouble dot(const DoubleDouble3 &a, const DoubleDouble3 &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline DoubleDouble3 cross(const DoubleDouble3 &a, const DoubleDouble3 &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline DoubleDouble length(const DoubleDouble3 &v)
{
    return sqrt(dot(v, v));
}

} // namespace unprojector::base
