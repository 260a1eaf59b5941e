#include "core/maps/pixel_map.h"

#include "core/base/translation.h"
#include "core/maps/other_points.h"
#include "core/maps/rows_in_parallel.h"
#include "core/maps/uncertainty_row.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace unprojector::maps {
using namespace geometry;
using namespace unproject;

namespace {

/// The displacement of a point; 0 if the other answer equals the inverted matrix's. The remaining
/// difference between the methods is rounding, not an effect of the mistake.
double displacement(const WorldPoint &other, const WorldPoint &matrix, const WorldPoint &formula)
{
    constexpr double kRoundingUlps = 16.0; // of computing the same numbers through two products
    if (distance(other, matrix) <= kRoundingUlps * ulpOfLargest(matrix))
        return 0.0;
    return distance(formula, other);
}

/// Computes one number for each point of a row of a map; NaN where there is none. Any thread may call it.
using RowNumbers = std::function<void(const SurfaceImage &surfaces, const RowPixels &pixels, const PointArrays &formula,
                                      std::vector<double> &numbers)>;

/// @param areMet  whether the surfaces were hit by rays
Result<RowNumbers> rowNumbers(const Question &question, const Unprojector &unprojector, bool areMet,
                              std::span<const scene::SceneObject> objects)
{
    const Setup &setup = unprojector.setup();
    const Quantity quantity = question.quantity;
    if (quantity == Quantity::Uncertainty) {
        const Result<Setup> parameters = byParameters(setup);
        if (!parameters)
            return parameters.error();
        const Result<ClickBatch> eye = ClickBatch::of(Method::Formula, *parameters, {BatchSpace::Kind::Eye, {}});
        if (!eye)
            return eye.error();
        const auto uncertainty =
            std::make_shared<const UncertaintyRow>(*parameters, objects, question.cornerShiftPixels);
        return RowNumbers([eye = *eye, uncertainty](const SurfaceImage &surfaces, const RowPixels &pixels,
                                                    const PointArrays &formula, std::vector<double> &numbers) {
            const PointArrays points = pixels.elements.unprojected(eye);
            for (std::size_t k = 0; k < numbers.size(); ++k)
                numbers[k] = uncertainty->at(surfaces, pixels.pixels[k], points.eye(k), formula.world(k));
        });
    }
    std::optional<ClickBatch> matrix;
    if (quantity != Quantity::FormulaRay) {
        const Result<ClickBatch> batch = ClickBatch::of(Method::Matrix, setup, {});
        if (!batch)
            return batch.error();
        matrix = *batch;
    }
    if (quantity == Quantity::FormulaMatrix)
        return RowNumbers([matrix](const SurfaceImage &, const RowPixels &pixels, const PointArrays &formula,
                                   std::vector<double> &numbers) {
            const PointArrays points = pixels.elements.unprojected(*matrix);
            for (std::size_t k = 0; k < numbers.size(); ++k)
                numbers[k] = distance(formula.world(k), points.world(k));
        });
    if (quantity == Quantity::Displacement) {
        const Result<OtherPoints> other =
            otherPoints(question.other, setup, areMet ? objects : std::span<const scene::SceneObject>());
        if (!other)
            return other.error();
        return RowNumbers([matrix, other = *other](const SurfaceImage &surfaces, const RowPixels &pixels,
                                                   const PointArrays &formula, std::vector<double> &numbers) {
            const PointArrays points = other(pixels, surfaces), right = pixels.elements.unprojected(*matrix);
            for (std::size_t k = 0; k < numbers.size(); ++k)
                numbers[k] = displacement(points.world(k), right.world(k), formula.world(k));
        });
    }
    const Result<PixelRays> rays = PixelRays::of(ray::ClickRays(unprojector));
    if (!rays)
        return rays.error();
    return RowNumbers([matrix, rays = *rays](const SurfaceImage &surfaces, const RowPixels &pixels,
                                             const PointArrays &formula, std::vector<double> &numbers) {
        if (numbers.empty())
            return;
        const PointArrays points = matrix ? pixels.elements.unprojected(*matrix) : formula;
        const std::vector<ray::Ray<WorldSpace>> row = rays.ofRow(pixels.pixels.front().j);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const ray::Ray<WorldSpace> &ray = row[static_cast<std::size_t>(pixels.pixels[k].i)];
            numbers[k] = distance(points.world(k), ray.at(surfaces.ts[pixels.places[k]]));
        }
    });
}

/// The functions that compute a map's rows.
struct Prepared {
    ClickBatch formula;
    RowNumbers numbers;
};

Result<Prepared> prepared(const Question &question, const Unprojector &unprojector, bool areMet,
                          std::span<const scene::SceneObject> objects)
{
    const Result<ClickBatch> formula = ClickBatch::of(Method::Formula, unprojector.setup(), {});
    if (!formula)
        return formula.error();
    const Result<RowNumbers> numbers = rowNumbers(question, unprojector, areMet, objects);
    if (!numbers)
        return numbers.error();
    return Prepared{*formula, *numbers};
}

/// The number of surfaces in memory at a time: 12 MB, and some hundred milliseconds on a core.
constexpr int kBandPixels = 1 << 19;

PixelMap emptyMap(const Setup &setup)
{
    PixelMap map{setup.surface.widthPixels, setup.surface.heightPixels, {}};
    map.values.assign(map.indexOf({0, map.heightPixels}), std::numeric_limits<float>::quiet_NaN());
    return map;
}

/// The rows whose surfaces are needed: the uncertainty's slopes and other programs read
/// neighbouring pixels.
Rows rowsRead(const Question &question, const Setup &setup, const Rows &rows)
{
    Rows read = rows;
    const auto *program = std::get_if<OtherProgram>(&question.other);
    for (const int row : rows) {
        if (question.quantity == Quantity::Uncertainty)
            read.insert(read.end(), {row - 1, row + 1});
        if (question.quantity == Quantity::Displacement && program != nullptr)
            read.push_back(clickOf(*program, setup, {0, row}).depthFrom.j);
    }
    std::sort(read.begin(), read.end());
    read.erase(std::unique(read.begin(), read.end()), read.end());
    std::erase_if(read, [&setup](int row) { return row < 0 || row >= setup.surface.heightPixels; });
    return read;
}

/// Computes rows of a map.
/// @param surfaces  of rowsRead
/// @return false if progress requests a stop
bool setRows(PixelMap &map, const Rows &rows, const Question &question, const Prepared &shared,
             const SurfaceImage &surfaces, const ray::Progress &progress)
{
    return rowsInParallel(rows, map.widthPixels, progress, [&](std::span<const int> some) {
        for (const int j : some) {
            const RowPixels pixels(surfaces, j);
            const PointArrays formula = pixels.elements.unprojected(shared.formula);
            std::vector<double> numbers(pixels.places.size());
            shared.numbers(surfaces, pixels, formula, numbers);
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                const double unit = question.unit == Unit::Ulps ? ulpOfLargest(formula.world(k)) : 1.0;
                const auto number = static_cast<float>(numbers[k] / unit);
                if (std::isfinite(number))
                    map.values[map.indexOf(pixels.pixels[k])] = number;
            }
        }
    });
}

} // namespace

std::string_view keyOf(Quantity quantity)
{
    constexpr const char *kKeys[] = {"formula-matrix", "formula-ray", "matrix-ray", "uncertainty", "displacement"};
    static_assert(std::size(kKeys) == static_cast<std::size_t>(Quantity::Displacement) + 1);
    return kKeys[static_cast<std::size_t>(quantity)];
}

bool needsRays(Quantity quantity)
{
    return quantity == Quantity::FormulaRay || quantity == Quantity::MatrixRay || quantity == Quantity::Uncertainty;
}

std::string noCloudsText()
{
    return base::tr("the points of clouds are left out; maps show surfaces");
}

RowPixels::RowPixels(const SurfaceImage &surfaces, int row)
{
    for (int i = 0; i < surfaces.widthPixels; ++i) {
        const std::size_t index = surfaces.indexOf(i, row);
        if (std::isnan(surfaces.depths[index]))
            continue;
        elements.add(pixelCenter({i, row}), surfaces.depths[index]);
        pixels.push_back({i, row});
        places.push_back(index);
    }
}

Result<std::optional<PixelMap>> pixelMap(const Question &question, const Unprojector &unprojector,
                                         const SurfaceImage &surfaces, std::span<const scene::SceneObject> objects,
                                         const ray::Progress &progress)
{
    const Result<Prepared> shared = prepared(question, unprojector, surfaces.isMet(), objects);
    if (!shared)
        return shared.error();
    const Setup &setup = unprojector.setup();
    PixelMap map = emptyMap(setup);
    if (!setRows(map, allRows(setup), question, *shared, surfaces, progress))
        return std::optional<PixelMap>();
    return std::optional(std::move(map));
}

Result<std::optional<PixelMap>> pixelMap(const Question &question, const Unprojector &unprojector,
                                         const SurfaceSource &source, std::span<const scene::SceneObject> objects,
                                         const ray::Progress &progress)
{
    const Result<Prepared> shared = prepared(question, unprojector, source.areMet, objects);
    if (!shared)
        return shared.error();
    const Setup &setup = unprojector.setup();
    PixelMap map = emptyMap(setup);
    const int atATime = std::max(1, kBandPixels / map.widthPixels);
    for (int begin = 0; begin < map.heightPixels; begin += atATime) {
        Rows rows(static_cast<std::size_t>(std::min(atATime, map.heightPixels - begin)));
        std::iota(rows.begin(), rows.end(), begin);
        // The first half of a band's progress is the computation of its surfaces.
        const auto partFrom = [&](double start) -> ray::Progress {
            if (!progress)
                return {};
            return [&, start](double share) {
                const double done = begin + (start + share / 2.0) * static_cast<double>(rows.size());
                return progress(done / map.heightPixels);
            };
        };
        const std::optional<SurfaceImage> surfaces = source.of(rowsRead(question, setup, rows), partFrom(0.0));
        if (!surfaces || !setRows(map, rows, question, *shared, *surfaces, partFrom(0.5)))
            return std::optional<PixelMap>();
    }
    return std::optional(std::move(map));
}

MapStatistics statisticsOf(PixelMap map)
{
    std::vector<float> &numbers = map.values;
    std::erase_if(numbers, [](float number) { return std::isnan(number); });
    MapStatistics statistics;
    statistics.count = numbers.size();
    if (numbers.empty())
        return statistics;
    const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
    statistics.least = static_cast<double>(*least);
    statistics.greatest = static_cast<double>(*greatest);
    statistics.leastAboveZero = statistics.greatest;
    for (const float number : numbers) {
        if (number > 0.0F)
            statistics.leastAboveZero = std::min(statistics.leastAboveZero, static_cast<double>(number));
    }
    const auto rank = [&numbers](double share) {
        const auto place = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(numbers.size()))) - 1;
        const auto at = numbers.begin() + std::max<std::ptrdiff_t>(place, 0);
        std::nth_element(numbers.begin(), at, numbers.end());
        return static_cast<double>(*at);
    };
    statistics.percentile1 = rank(0.01);
    statistics.median = rank(0.5);
    statistics.percentile99 = rank(0.99);
    return statistics;
}

void writePfm(const PixelMap &map, const std::function<void(std::string_view)> &write)
{
    write("Pf\n" + std::to_string(map.widthPixels) + ' ' + std::to_string(map.heightPixels) + "\n-1.0\n");
    std::string row;
    for (int j = map.heightPixels - 1; j >= 0; --j) {
        row.clear();
        for (int i = 0; i < map.widthPixels; ++i) {
            const auto bits = std::bit_cast<std::uint32_t>(map.at({i, j}));
            for (int shift = 0; shift < 32; shift += 8)
                row += static_cast<char>(static_cast<unsigned char>(bits >> shift));
        }
        write(row);
    }
}

std::string pfmText(const PixelMap &map)
{
    std::string text;
    writePfm(map, [&text](std::string_view part) { text += part; });
    return text;
}

} // namespace unprojector::maps
