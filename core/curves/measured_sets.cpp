#include "core/curves/measured_sets.h"

#include "core/base/translation.h"
#include "core/curves/scan_surface.h"

#include <memory>
#include <utility>

namespace unprojector::curves {
using namespace geometry;
using namespace landmarks;

std::optional<std::vector<std::vector<ProtocolValue>>>
measuredSets(std::span<const LandmarkSet> sets, std::span<const KeptMeasure> measures,
             const std::function<Result<std::filesystem::path, std::string>(std::size_t)> &modelOf,
             const std::function<bool(std::size_t)> &goesOn)
{
    const base::InEnglish english;
    std::vector<std::vector<ProtocolValue>> all;
    std::unique_ptr<ScanSurface> surface;
    bool isCancelled = false;
    for (std::size_t i = 0; i < sets.size() && !isCancelled; ++i) {
        const auto continues = [&](double) {
            isCancelled = isCancelled || (goesOn && !goesOn(i));
            return !isCancelled;
        };
        const auto along = [&](std::span<const Landmark *const> points) -> Result<Measure, std::string> {
            const auto model = modelOf(i);
            if (!model)
                return model.error();
            if (!surface || surface->file() != model.value())
                surface = std::make_unique<ScanSurface>(model.value());
            return surface->length(points, continues);
        };
        std::vector<ProtocolValue> &values = all.emplace_back();
        for (const KeptMeasure &measure : measures)
            values.push_back(valueOf(measure, sets[i], along));
    }
    return isCancelled ? std::nullopt : std::optional(std::move(all));
}

} // namespace unprojector::curves
