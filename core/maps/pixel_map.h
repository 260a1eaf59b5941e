#pragma once

#include "core/maps/surface_image.h"
#include "core/unproject/other_programs.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace unprojector::maps {

/// What a map shows of each pixel's centre.
enum class Quantity {
    FormulaMatrix, ///< how far the formulas' point is from the inverted matrix's
    FormulaRay,    ///< the formulas' point from where the ray meets the mesh
    MatrixRay,     ///< the inverted matrix's point from there
    Uncertainty,   ///< how far the surface may be from the point: the length of the +- that a click states
    Displacement   ///< how far what another program answers is from the formulas' point
};
inline constexpr std::array kQuantities{Quantity::FormulaMatrix, Quantity::FormulaRay, Quantity::MatrixRay,
                                        Quantity::Uncertainty, Quantity::Displacement};

/// The names that the command calls them by: "formula-matrix", …
std::string_view keyOf(Quantity quantity);
/// Whether it can only be said of surfaces that rays have met.
bool needsRays(Quantity quantity);

enum class Unit {
    World,
    Ulps ///< the spacing of doubles at the largest coordinate of the formulas' point
};

/// A program with one mistake of core/doctor.
struct MistakeMade {
    std::string_view id;
    std::size_t way = 0; ///< its place among the ways that doctor::variants has of it
};

/// Who answers otherwise: a program, a program with a mistake, or this one by another method.
using Other = std::variant<unproject::OtherProgram, MistakeMade, unproject::Method>;

/// A program or a mistake that a map can show, by its name.
struct NamedConvention {
    std::string_view key;
    Other other;
};
/// The programs first, then the mistakes by their ids.
const std::vector<NamedConvention> &namedConventions();
const NamedConvention *conventionNamed(std::string_view key);

struct Question {
    Quantity quantity = Quantity::FormulaMatrix;
    Unit unit = Unit::World;
    Other other = unproject::OtherProgram::Paper; ///< of a displacement
    /// Of an uncertainty: DepthSample::cornerShiftPixels of the renderer whose depths clicks read.
    double cornerShiftPixels = unproject::kCornerShiftPixels;
};

/// That maps leave the points of clouds out, in the language of text::tr().
std::string noCloudsText();

/// A number for each pixel of a picture, rows from the top; NaN where there is none.
struct PixelMap {
    int widthPixels = 0, heightPixels = 0;
    std::vector<float> values;

    std::size_t indexOf(const geometry::DevicePixel &pixel) const
    {
        return static_cast<std::size_t>(pixel.j) * static_cast<std::size_t>(widthPixels)
               + static_cast<std::size_t>(pixel.i);
    }
    float at(const geometry::DevicePixel &pixel) const { return values[indexOf(pixel)]; }
};

/// Computes a map on all cores. Points are those of clicks, to the last digit (ClickBatch); a mistake's is computed by the
/// inverted matrix. A program that reads the depth of a pixel beside reads it in the same image, on the background the far
/// end of the depth range; where it reads outside the window there is no number.
/// @param surfaces  of this picture
/// @param objects   of the scene whose surfaces they are; empty where only a depth was given
/// @param progress  with the share done, on the calling thread; may be empty
/// @return nothing when progress says stop; the errors of ClickBatch::of, doctor::Given::of and, for the uncertainty,
///         byParameters(Setup). Throws std::bad_alloc.
/// @pre surfaces.isMet() where needsRays
geometry::Result<std::optional<PixelMap>> pixelMap(const Question &question, const unproject::Unprojector &unprojector,
                                                   const SurfaceImage &surfaces,
                                                   std::span<const scene::SceneObject> objects,
                                                   const ray::Progress &progress);

/// Where surfaces come from that are not there all at once.
struct SurfaceSource {
    bool areMet = false; ///< SurfaceImage::isMet of them all
    /// Those of rows; nothing when progress says stop.
    std::function<std::optional<SurfaceImage>(const Rows &, const ray::Progress &)> of;
};

/// The same map, with the surfaces of a band of rows at a time: beside the map itself some 20 MB, however large it is.
/// @param source  with surfaces that are met where needsRays
geometry::Result<std::optional<PixelMap>> pixelMap(const Question &question, const unproject::Unprojector &unprojector,
                                                   const SurfaceSource &source,
                                                   std::span<const scene::SceneObject> objects,
                                                   const ray::Progress &progress);

/// What the numbers of a map are like; those that there are.
struct MapStatistics {
    std::size_t count = 0; ///< pixels with a number; the rest means nothing without any
    double least = 0.0, percentile1 = 0.0, median = 0.0, percentile99 = 0.0, greatest = 0.0;
    double leastAboveZero = 0.0; ///< 0 where all are: where a logarithmic scale begins
};
/// @param map  is sorted on the way: what is moved here is not copied
MapStatistics statisticsOf(PixelMap map);

/// A map as a portable float map: "Pf", size, scale -1 (little-endian), rows from the bottom, NaN where there is no number.
/// Source: the format as netpbm's pfm(5) states it.
/// @param write  is given one row after the other
void writePfm(const PixelMap &map, const std::function<void(std::string_view)> &write);
std::string pfmText(const PixelMap &map);

} // namespace unprojector::maps
