#include "gui/widgets/contrast.h"

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

double luminance(const QColor &color)
{
    const auto linear = [](double share) {
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

} // namespace

QColor mixed(const QColor &a, const QColor &b, double shareOfB)
{
    const auto mix = [shareOfB](int from, int to) {
        return static_cast<int>(std::lround(from + (to - from) * shareOfB));
    };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

double contrast(const QColor &a, const QColor &b)
{
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

QColor quietInk(const QColor &ink, const QColor &base)
{
    QColor quiet = mixed(ink, ink, 0.0);
    constexpr int kSteps = 64;
    for (int step = 1; step < kSteps; ++step) {
        const QColor next = mixed(ink, base, double(step) / kSteps);
        if (contrast(next, base) < kReadableContrast)
            break;
        quiet = next;
    }
    return quiet;
}

} // namespace unprojector::gui
