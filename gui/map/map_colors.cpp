#include "gui/map/map_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
namespace {

using Polynomial = std::array<double, 7>; ///< from the constant term on

constexpr std::array<Polynomial, 3> kViridis{{
    {0.2777273272, 0.1050930431, -0.3308618287, -4.6342304985, 6.2282699363, 4.7763849977, -5.4354558559},
    {0.0054073445, 1.4046135299, 0.2148475595, -5.7991009734, 14.1799333668, -13.7451453777, 4.6458526122},
    {0.3340998053, 1.3845901626, 0.0950951630, -19.3324409563, 56.6905526007, -65.3530326334, 26.3124352496},
}};
constexpr std::array<Polynomial, 3> kCividis{{
    // of 255
    {-4.54, -35.34, 2381.73, -6402.7, 7024.72, -2710.57, 0.0},
    {32.49, 170.73, 52.82, -131.46, 176.58, -67.37, 0.0},
    {81.24, 442.36, -2482.43, 6167.24, -6614.94, 2475.67, 0.0},
}};

double valueOf(const Polynomial &polynomial, double t)
{
    double sum = 0.0;
    for (std::size_t k = polynomial.size(); k-- > 0;)
        sum = sum * t + polynomial[k];
    return sum;
}

double powerOfTen(int exponent)
{
    return std::pow(10.0, exponent);
}

} // namespace

QColor colorAt(ColorMap map, double share)
{
    const double t = std::clamp(share, 0.0, 1.0);
    const auto channel = [&](std::size_t k) {
        const double value = map == ColorMap::Viridis ? valueOf(kViridis[k], t) : valueOf(kCividis[k], t) / 255.0;
        return static_cast<float>(std::clamp(value, 0.0, 1.0));
    };
    return QColor::fromRgbF(channel(0), channel(1), channel(2));
}

LogScale LogScale::of(const maps::MapStatistics &statistics)
{
    if (!(statistics.greatest > 0.0))
        return {};
    LogScale scale{std::max(statistics.percentile1, statistics.leastAboveZero), statistics.greatest};
    const double least = std::pow(10.0, 0.1);
    if (scale.high < least * scale.low) {
        const double middle = std::sqrt(scale.low) * std::sqrt(scale.high);
        scale = {middle / std::sqrt(least), middle * std::sqrt(least)};
    }
    return scale;
}

double LogScale::share(double number) const
{
    if (!(number > low))
        return 0.0;
    return std::min(1.0, std::log(number / low) / std::log(high / low));
}

std::vector<double> LogScale::ticks() const
{
    const int first = static_cast<int>(std::floor(std::log10(low))),
              last = static_cast<int>(std::ceil(std::log10(high)));
    constexpr int kMostPowers = 6;
    const int step = std::max(1, (last - first + kMostPowers - 1) / kMostPowers);
    std::vector<double> ticks;
    const auto add = [&](double number) {
        if (number >= low * (1.0 - 1e-9) && number <= high * (1.0 + 1e-9))
            ticks.push_back(number);
    };
    for (int exponent = first; exponent <= last; exponent += step) {
        add(powerOfTen(exponent));
        if (last - first <= 2) {
            add(2.0 * powerOfTen(exponent));
            add(5.0 * powerOfTen(exponent));
        }
    }
    if (ticks.size() < 2)
        return {low, high};
    return ticks;
}

QImage coloredMap(const maps::PixelMap &map, const LogScale &scale, ColorMap colors)
{
    constexpr std::size_t kColors = 1024;
    std::array<QRgb, kColors> table{};
    for (std::size_t k = 0; k < kColors; ++k)
        table[k] = colorAt(colors, static_cast<double>(k) / (kColors - 1)).rgb();
    QImage image(map.widthPixels, map.heightPixels, QImage::Format_ARGB32_Premultiplied);
    const float low = static_cast<float>(std::log2(scale.low));
    const float perColor = static_cast<float>((kColors - 1) / (std::log2(scale.high) - std::log2(scale.low)));
    const auto width = static_cast<std::size_t>(map.widthPixels);
    for (int j = 0; j < map.heightPixels; ++j) {
        auto *line = reinterpret_cast<QRgb *>(image.scanLine(j));
        for (std::size_t i = 0; i < width; ++i) {
            const float number = map.values[static_cast<std::size_t>(j) * width + i];
            if (std::isnan(number)) {
                line[i] = 0;
                continue;
            }
            const float place = number > 0.0F ? (std::log2(number) - low) * perColor : 0.0F;
            line[i] = table[static_cast<std::size_t>(std::clamp(place + 0.5F, 0.0F, static_cast<float>(kColors - 1)))];
        }
    }
    return image;
}

} // namespace unprojector::gui
