#include "core/maps/other_points.h"

#include "core/doctor/variants.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace unprojector::maps {
using namespace geometry;
using namespace unproject;

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The mistakes that a map can show.
constexpr MistakeMade kMistakes[] = {{"y-not-flipped"},
                                     {"flipped-with-viewport-height"},
                                     {"row-above"},
                                     {"pixel-corner", 1}, // the upper left one
                                     {"ratio-logical-in-device"},
                                     {"ratio-logical-both"},
                                     {"viewport-origin-ignored"},
                                     {"viewport-is-window"},
                                     {"depth-not-remapped"},
                                     {"depth-remapped-twice"},
                                     {"depth-reversed"},
                                     {"depth-range-is-planes"},
                                     {"fov-degrees-as-radians"},
                                     {"fov-horizontal"},
                                     {"projection-transposed"},
                                     {"view-transposed"},
                                     {"both-transposed"},
                                     {"product-transposed"},
                                     {"inverse-order"},
                                     {"not-inverted"},
                                     {"view-inverse-as-view"},
                                     {"no-w-divide"},
                                     {"model-left-in"}};

/// The value of the depth buffer: on the background the clear value; outside the window it is
/// unknown.
double depthIn(const SurfaceImage &surfaces, const Setup &setup, const DevicePixel &pixel)
{
    if (pixel.i < 0 || pixel.i >= surfaces.widthPixels || !surfaces.has(pixel.j))
        return kNoNumber;
    const double depth = surfaces.depths[surfaces.indexOf(pixel.i, pixel.j)];
    return std::isnan(depth) ? setup.depthRange.atFar : depth;
}

/// Takes the click's logical pixel, whole as toolkits report it, for a device pixel. The doctor
/// divides by the ratio instead, because the wrong point does not reveal the position within the
/// pixel.
/// @param run  its parameter: whether the height is in logical pixels too
void takeLogicalPixel(doctor::Run &run)
{
    const Surface &surface = run.given.surface;
    const Surface logical{logicalFromDevice(surface, surface.widthPixels),
                          logicalFromDevice(surface, surface.heightPixels), 1.0};
    const Result<DevicePixel> pixel =
        devicePixelFromWidget(logical, widgetFromDevice(surface, DevicePoint(run.position)));
    run.isLost = !pixel;
    if (pixel)
        run.position = pixelCenter(*pixel).coordinates();
    if (run.parameter != 0.0)
        run.flipHeight = logical.heightPixels;
}

/// The variants of a mistake on an object: one, or none if the setup does not allow it.
std::vector<doctor::Variant> variantsOf(const MistakeMade &made, const doctor::Given &given, const Setup &setup,
                                        const glm::dmat4 &worldFromObject)
{
    const bool isBoth = made.id == "ratio-logical-both";
    if (isBoth || made.id == "ratio-logical-in-device")
        return {{0, doctor::Stage::Pixel, takeLogicalPixel, isBoth ? 1.0 : 0.0, 0.0, glm::dmat4(1.0), {}}};
    // A frustum and a matrix have no angle that could be misread.
    const auto *projection = std::get_if<Projection>(&setup.lens);
    if (made.id.starts_with("fov-") && !(projection && kindOf(*projection) == ProjectionKind::Perspective))
        return {};
    doctor::Case scene;
    scene.setup = setup;
    scene.models = {{{}, worldFromObject}};
    std::vector<doctor::Variant> all = doctor::variants(given, scene);
    std::erase_if(all, [&](const auto &variant) { return doctor::mistakes()[variant.mistake].id != made.id; });
    return all.size() > made.way ? std::vector{all[made.way]} : std::vector<doctor::Variant>();
}

Result<OtherPoints> pointsWith(const MistakeMade &made, const Setup &setup, std::span<const scene::SceneObject> objects)
{
    const Result<doctor::Given> given = doctor::Given::of(setup);
    if (!given)
        return given.error();
    std::vector<std::vector<doctor::Variant>> variants; // one list per object
    for (const scene::SceneObject &object : objects)
        variants.push_back(variantsOf(made, *given, setup, geometry::worldFromObject(object.transform)));
    if (objects.empty())
        variants.push_back(variantsOf(made, *given, setup, glm::dmat4(1.0)));
    return OtherPoints([given = *given, variants](const RowPixels &pixels, const SurfaceImage &surfaces) {
        PointArrays points(pixels.pixels.size());
        for (std::size_t k = 0; k < pixels.pixels.size(); ++k) {
            doctor::Click click;
            click.pixel = DevicePoint(pixels.elements.px[k], pixels.elements.py[k]);
            click.depth = pixels.elements.depth[k];
            const std::size_t object = variants.size() > 1 ? surfaces.objects[pixels.places[k]] : 0;
            const doctor::Variant *const first = variants[object].data();
            const glm::dvec3 point =
                doctor::answer(given, click, {&first, variants[object].size()}).value_or(glm::dvec3(kNoNumber));
            points.x[k] = point.x;
            points.y[k] = point.y;
            points.z[k] = point.z;
        }
        return points;
    });
}

} // namespace

const std::vector<NamedConvention> &namedConventions()
{
    static const std::vector<NamedConvention> all = [] {
        std::vector<NamedConvention> named;
        named.reserve(std::size(kOtherPrograms) + std::size(kMistakes) + 1);
        for (const OtherProgram program : kOtherPrograms)
            named.push_back({keyOf(program), program});
        for (const MistakeMade &mistake : kMistakes)
            named.push_back({mistake.id, mistake});
        named.push_back({"single-precision", Method::MatrixInFloat});
        return named;
    }();
    return all;
}

const NamedConvention *conventionNamed(std::string_view key)
{
    const std::vector<NamedConvention> &all = namedConventions();
    const auto found =
        std::find_if(all.begin(), all.end(), [key](const NamedConvention &one) { return one.key == key; });
    return found != all.end() ? &*found : nullptr;
}

Result<OtherPoints> otherPoints(const Other &other, const Setup &setup, std::span<const scene::SceneObject> objects)
{
    if (const auto *made = std::get_if<MistakeMade>(&other))
        return pointsWith(*made, setup, objects);
    const auto *method = std::get_if<Method>(&other);
    const Result<ClickBatch> batch = ClickBatch::of(method ? *method : Method::Matrix, setup, {});
    if (!batch)
        return batch.error();
    if (method)
        return OtherPoints([batch = *batch](const RowPixels &pixels, const SurfaceImage &) {
            return pixels.elements.unprojected(batch);
        });
    return OtherPoints([program = std::get<OtherProgram>(other), batch = *batch, setup](const RowPixels &pixels,
                                                                                        const SurfaceImage &surfaces) {
        ElementArrays elements;
        for (const DevicePixel &pixel : pixels.pixels) {
            const OtherClick click = clickOf(program, setup, pixel);
            elements.add(click.position, depthIn(surfaces, setup, click.depthFrom));
        }
        return elements.unprojected(batch);
    });
}

} // namespace unprojector::maps
