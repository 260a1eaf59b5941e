#include "core/doctor/written_value.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace unprojector::doctor {
namespace {

/// The most significant digits of a round number.
constexpr int kMostDigits = 4;

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

/// The number of values in a range of a factor e; at least 1.
/// @param values  not 0
double densityOf(std::span<const double> values)
{
    double low = 0.0, high = 0.0, count = 0.0;
    for (const double value : values) {
        const double place = std::log(std::abs(value));
        low = count == 0.0 ? place : std::min(low, place);
        high = count == 0.0 ? place : std::max(high, place);
        ++count;
    }
    return std::max(1.0, count / std::max(1.0, high - low));
}

} // namespace

WrittenValue asDetermined(const Solution &solution)
{
    if (!(solution.unsure > 0.0))
        return {solution.value, 1.0};
    return {multiple(solution.value, int(std::floor(std::log10(solution.unsure / 2.0))), 1.0), 1.0};
}

std::vector<WrittenValue> roundValues(const Solution &solution, std::span<const double> known)
{
    const double size = std::abs(solution.value), width = 2.0 * solution.unsure, density = densityOf(known);
    std::vector<WrittenValue> values;
    const auto offer = [&](double value, double chance) {
        if (std::abs(value - solution.value) <= solution.unsure && chance < 1.0)
            values.push_back({value, chance});
    };
    if (size > 0.0) {
        const int first = int(std::floor(std::log10(size)));
        // There is one power of ten in each decade.
        offer(std::copysign(power(int(std::lround(std::log10(size)))), solution.value), width / size);
        for (int exponent = first; exponent > first - kMostDigits; --exponent) {
            offer(multiple(solution.value, exponent, 1.0), width / power(exponent));
            offer(multiple(solution.value, exponent, 0.5), width / (0.5 * power(exponent)));
        }
        for (const double value : known)
            offer(value, width / size * density);
    }
    return values;
}

WrittenValue written(const Solution &solution, std::span<const double> known)
{
    if (std::abs(solution.ofScene - solution.value) <= solution.unsure)
        return {solution.ofScene, 1.0};
    const std::vector<WrittenValue> values = roundValues(solution, known);
    const auto best = std::min_element(values.begin(), values.end(), [](const WrittenValue &a, const WrittenValue &b) {
        return a.coincidence < b.coincidence;
    });
    return best == values.end() ? asDetermined(solution) : *best;
}

double withoutNoise(double value)
{
    constexpr int kDigits = 12;
    const double size = std::abs(value);
    return size > 0.0 && std::isfinite(size) ? multiple(value, int(std::floor(std::log10(size))) - kDigits + 1, 1.0)
                                             : value;
}

std::string valueText(double value)
{
    return base::shortestText(value, 1e-7 * std::abs(value));
}

} // namespace unprojector::doctor
