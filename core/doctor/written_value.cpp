#include "core/doctor/written_value.h"

#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace unprojector::doctor {
namespace {

/// The most significant digits of a round number.
constexpr int kMostDigits = 6;

double power(int exponent)
{
    return std::pow(10.0, exponent);
}

/// The nearest multiple of 10^exponent · count. A division by a power of ten is exact in its last
/// bit, a product with 0.1 is not.
double multiple(double value, int exponent, double count)
{
    const double scale = exponent < 0 ? power(-exponent) / count : 1.0 / (power(exponent) * count);
    return std::round(value * scale) / scale;
}

} // namespace

std::optional<Solution> common(const Solution &a, const Solution &b)
{
    const double low = std::max(a.value - a.unsure, b.value - b.unsure);
    const double high = std::min(a.value + a.unsure, b.value + b.unsure);
    if (!(low <= high))
        return std::nullopt;
    return Solution{(low + high) / 2.0, (high - low) / 2.0};
}

WrittenValue asDetermined(const Solution &solution)
{
    if (!(solution.unsure > 0.0))
        return {solution.value, 1.0};
    return {multiple(solution.value, int(std::floor(std::log10(solution.unsure / 2.0))), 1.0), 1.0};
}

WrittenValue written(const Solution &solution, std::span<const double> known)
{
    const double size = std::abs(solution.value), width = 2.0 * solution.unsure;
    WrittenValue best = asDetermined(solution);
    const auto offer = [&](double value, double chance) {
        if (std::abs(value - solution.value) <= solution.unsure && chance < best.coincidence)
            best = {value, chance};
    };
    if (size > 0.0) {
        const int first = int(std::floor(std::log10(size)));
        for (int exponent = first; exponent > first - kMostDigits; --exponent) {
            offer(multiple(solution.value, exponent, 1.0), width / power(exponent));
            offer(multiple(solution.value, exponent, 0.5), width / (0.5 * power(exponent)));
        }
        for (const double value : known)
            offer(value, value == 0.0 ? width : width * double(known.size()) / size);
    }
    return best;
}

std::string valueText(double value)
{
    return text::shortestText(value, 1e-12 * std::abs(value));
}

} // namespace unprojector::doctor
