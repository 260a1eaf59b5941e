#include "unprojector/unproject.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/library/internal.h"
#include "core/unproject/batch/click_batch.h"
#include "core/unproject/certainty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector {
static_assert(int(Method::Matrix) == int(unproject::Method::Matrix));
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/// The arrays of a block fit the processor's first cache.
constexpr std::size_t kBlock = 512;
/// A thread takes this many points at a time: about 0.3 ms.
constexpr std::size_t kTask = std::size_t{1} << 15;

using Block = std::array<double, kBlock>;
using Batch = std::variant<unproject::ClickBatch, unproject::BatchUnprojection>;

Result<Batch> batchOf(const geometry::Setup &setup, const UnprojectOptions &options, Space space)
{
    unproject::BatchSpace target;
    target.kind = space == Space::World ? unproject::BatchSpace::Kind::World : unproject::BatchSpace::Kind::Eye;
    if (options.digits == Digits::Exact) {
        const auto batch = unproject::ClickBatch::of(sameOf<unproject::Method>(options.method), setup, target);
        return batch ? Result<Batch>(*batch) : valueError(batch.error());
    }
    const auto batch = options.method == Method::Formula ? unproject::BatchUnprojection::byFormula(setup, target)
                                                         : unproject::BatchUnprojection::byMatrix(setup, target);
    return batch ? Result<Batch>(*batch) : valueError(batch.error());
}

/// What the error bounds of many points need.
struct Bounds {
    Batch otherSpace; ///< beside the points' own: bounds need both
    unproject::Certainties certainties;
    unproject::DepthFormat format;

    unproject::Uncertainty of(const glm::dvec3 &eye, const glm::dvec3 &world, double depth) const
    {
        const unproject::DepthError error{format.halfStep(depth), 0.0};
        return certainties.of(geometry::EyePoint(eye), geometry::WorldPoint(world), certainties.at(-eye.z, error));
    }
};

std::optional<Bounds> boundsOf(const geometry::Setup &setup, const UnprojectOptions &options)
{
    const Result<Batch> other = batchOf(setup, options, options.space == Space::World ? Space::Eye : Space::World);
    const auto known = geometry::byParameters(setup);
    if (!other || !known)
        return std::nullopt;
    return Bounds{*other, unproject::Certainties(*known),
                  options.depthBuffer.isFloat ? unproject::DepthFormat::floatingPoint()
                                              : unproject::DepthFormat(options.depthBuffer.bits)};
}

} // namespace

struct Unprojection::Data {
    geometry::Setup setup;
    UnprojectOptions options;
    Batch batch;
    double lowest, highest; ///< ends of the depth range

    Data(const geometry::Setup &ofSetup, const UnprojectOptions &givenOptions, const Batch &itsBatch)
        : setup(ofSetup), options(givenOptions), batch(itsBatch),
          lowest(std::min(setup.depthRange.atNear, setup.depthRange.atFar)),
          highest(std::max(setup.depthRange.atNear, setup.depthRange.atFar))
    {
    }

    /// Computed at the first call: most callers need none. Empty where the setup has none.
    const std::optional<Bounds> &bounds() const
    {
        std::call_once(areBoundsComputed, [this] { computedBounds = boundsOf(setup, options); });
        return computedBounds;
    }

    /// Unprojects at most kBlock pixels.
    void block(const double *px, const double *py, const double *depth, double *points, double *ofPoints,
               std::size_t count) const
    {
        std::array<Block, 3> results, others;
        run(batch, px, py, depth, results, count);
        const bool hasBounds = ofPoints != nullptr && bounds().has_value();
        if (hasBounds)
            run(bounds()->otherSpace, px, py, depth, others, count);
        unproject::batch::kernelsOf(unproject::availableInstructionSets().back())
            .validPoints({results[0].data(), results[1].data(), results[2].data(), depth, count, lowest, highest},
                         points);
        for (std::size_t i = 0; ofPoints != nullptr && i < count; ++i) {
            const glm::dvec3 point(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
            const glm::dvec3 bound = hasBounds && !std::isnan(point.x)
                                         ? boundOf(point, {others[0][i], others[1][i], others[2][i]}, depth[i])
                                         : glm::dvec3(kNaN);
            for (std::size_t k = 0; k < 3; ++k)
                ofPoints[3 * i + k] = bound[static_cast<glm::length_t>(k)];
        }
    }

    /// Unprojects pixels block by block. Floats are copied into doubles first.
    template <class Number>
    void all(const Number *px, const Number *py, const Number *depth, double *points, std::size_t count,
             double *ofPoints, unsigned threads) const
    {
        base::inParallelRanges(
            count, kTask, {},
            [&](std::size_t begin, std::size_t end) {
                std::array<Block, 3> copies;
                const auto doubles = [&](const Number *numbers, std::size_t size, Block &copy) -> const double * {
                    if constexpr (std::is_same_v<Number, double>)
                        return numbers + begin;
                    std::copy_n(numbers + begin, size, copy.begin());
                    return copy.data();
                };
                for (; begin < end; begin += kBlock) {
                    const std::size_t size = std::min(kBlock, end - begin);
                    block(doubles(px, size, copies[0]), doubles(py, size, copies[1]), doubles(depth, size, copies[2]),
                          points + 3 * begin, ofPoints == nullptr ? nullptr : ofPoints + 3 * begin, size);
                }
            },
            threads);
    }

    glm::dvec3 boundOf(const glm::dvec3 &point, const glm::dvec3 &other, double depth) const
    {
        if (options.space == Space::World)
            return bounds()->of(other, point, depth).world.coordinates();
        return bounds()->of(point, other, depth).eye.coordinates();
    }

    mutable std::once_flag areBoundsComputed;
    mutable std::optional<Bounds> computedBounds;

    static void run(const Batch &batch, const double *px, const double *py, const double *depth,
                    std::array<Block, 3> &results, std::size_t count)
    {
        std::visit(
            [&](const auto &unprojection) {
                unprojection(unproject::BatchInput<double>{px, py, depth},
                             unproject::BatchOutput<double>{results[0].data(), results[1].data(), results[2].data()},
                             count);
            },
            batch);
    }
};

Result<Unprojection> Unprojection::of(const Setup &setup, const UnprojectOptions &options)
{
    const DepthBuffer &buffer = options.depthBuffer;
    constexpr int kMostBits = 32;
    if (!buffer.isFloat && (buffer.bits < 1 || buffer.bits > kMostBits))
        return valueError(base::tr("a depth buffer of %1 bits; give 1 to 32 bits, or a float buffer", buffer.bits));
    const Result<Batch> batch = batchOf(SetupAccess::of(setup), options, options.space);
    if (!batch)
        return batch.error();
    return Unprojection(std::make_shared<const Data>(SetupAccess::of(setup), options, *batch));
}

Result<glm::dvec3> Unprojection::at(const glm::dvec2 &pixel, double depth) const
{
    // A batch has no reasons: a click names them.
    const auto unprojector = unproject::Unprojector::of(m_data->setup);
    if (!unprojector)
        return valueError(unprojector.error());
    const glm::dvec2 window(pixel.x, geometry::flippedY(m_data->setup.surface, pixel.y));
    const geometry::WindowPoint click(window.x, window.y, depth);
    const unproject::Method method = sameOf<unproject::Method>(m_data->options.method);
    if (m_data->options.space == Space::World) {
        if (const auto point = unprojector->worldAt(method, click); !point)
            return valueError(point.error());
    } else if (const auto point = unprojector->eyeAt(method, click); !point) {
        return valueError(point.error());
    }
    glm::dvec3 result;
    m_data->block(&pixel.x, &pixel.y, &depth, &result.x, nullptr, 1);
    return result;
}

Result<glm::dvec3> Unprojection::uncertaintyAt(const glm::dvec2 &pixel, double depth) const
{
    const Result<glm::dvec3> point = at(pixel, depth);
    if (!point)
        return point.error();
    if (!hasUncertainty())
        return valueError(
            base::tr("the matrix is no perspective and no parallel projection: its points have no uncertainty"));
    glm::dvec3 ignored, result;
    m_data->block(&pixel.x, &pixel.y, &depth, &ignored.x, &result.x, 1);
    return result;
}

bool Unprojection::hasUncertainty() const
{
    return m_data->bounds().has_value();
}

void Unprojection::operator()(const double *px, const double *py, const double *depth, double *points,
                              std::size_t count, double *uncertainties, unsigned threads) const
{
    m_data->all(px, py, depth, points, count, uncertainties, threads);
}

void Unprojection::operator()(const float *px, const float *py, const float *depth, double *points, std::size_t count,
                              double *uncertainties, unsigned threads) const
{
    m_data->all(px, py, depth, points, count, uncertainties, threads);
}

} // namespace unprojector
