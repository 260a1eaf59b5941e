#pragma once

#include <cmath>

/// Sums and products together with what rounding dropped from them: where terms nearly cancel, the dropped part is
/// what is left.
namespace unprojector {

/// What the double nearest to a + b leaves out, exactly (Knuth's two-sum).
inline double lostBySum(double a, double b)
{
    const double sum = a + b;
    const double bOfSum = sum - a;
    return (a - (sum - bOfSum)) + (b - bOfSum);
}

/// What the double nearest to a b leaves out, exactly.
inline double lostByProduct(double a, double b)
{
    return std::fma(a, b, -(a * b));
}

/// a b + c d within 1.5 units in the last place, however much the two products cancel.
/// Source: Kahan; Jeannerod, Louvet, Muller 2013, "Further analysis of Kahan's algorithm for the accurate
///         computation of 2 x 2 determinants".
inline double sumOfProducts(double a, double b, double c, double d)
{
    return std::fma(a, b, c * d) + lostByProduct(c, d);
}

} // namespace unprojector
