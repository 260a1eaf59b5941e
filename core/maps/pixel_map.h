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

/// The quantity that a map shows at each pixel's centre.
enum class Quantity {
    FormulaMatrix, ///< distance of the formulas' point from the inverted matrix's
    FormulaRay,    ///< distance of the formulas' point from the hit of the ray
    MatrixRay,     ///< distance of the inverted matrix's point from the hit
    Uncertainty,   ///< greatest distance of the surface from the point: the length of a click's ±
    Displacement   ///< distance of another program's answer from the formulas' point
};
inline constexpr std::array kQuantities{Quantity::FormulaMatrix, Quantity::FormulaRay, Quantity::MatrixRay,
                                        Quantity::Uncertainty, Quantity::Displacement};

/// The quantity's name in the command: "formula-matrix", …
std::string_view keyOf(Quantity quantity);
/// True if the quantity exists only for surfaces hit by rays.
bool needsRays(Quantity quantity);

enum class Unit {
    World,
    Ulps ///< the spacing of doubles at the largest coordinate of the formulas' point
};

/// A program with one mistake of core/doctor.
struct MistakeMade {
    std::string_view id;
    std::size_t way = 0; ///< index of the variant among the mistake's doctor::variants
};

/// The other answer: a program's, a program's with a mistake, or this program's by another method.
using Other = std::variant<unproject::OtherProgram, MistakeMade, unproject::Method>;

/// A program or a mistake that a map can show, with its name.
struct NamedConvention {
    std::string_view key;
    Other other;
};
/// All of them: the programs first, then the mistakes in the order of their ids.
const std::vector<NamedConvention> &namedConventions();
const NamedConvention *conventionNamed(std::string_view key);

struct Question {
    Quantity quantity = Quantity::FormulaMatrix;
    Unit unit = Unit::World;
    Other other = unproject::OtherProgram::Paper; ///< for a displacement
    /// The DepthSample::cornerShiftPixels of the renderer whose depths clicks read; for an
    /// uncertainty.
    double cornerShiftPixels = unproject::kCornerShiftPixels;
};

/// The note that maps omit the points of point clouds, in the language of base::tr().
std::string noCloudsText();

/// A number for each pixel of a view, rows from the top; NaN where there is none.
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

/// Computes a map on all cores. Points equal clicks' points to the last digit (ClickBatch); a
/// mistake's point is computed with the inverted matrix. A program that reads a neighbouring
/// pixel's depth reads it in the same image; on the background it gets the far end of the depth
/// range. Outside the window it has no number.
/// @param surfaces  of this view
/// @param objects   of the scene that the surfaces belong to; empty if only a depth was given
/// @param progress  called with the share done, on the calling thread; may be empty
/// @return empty if progress requests a stop; the errors of ClickBatch::of, doctor::Given::of and,
///         for the uncertainty, byParameters(Setup). Throws std::bad_alloc.
/// @pre surfaces.isMet() where needsRays
geometry::Result<std::optional<PixelMap>> pixelMap(const Question &question, const unproject::Unprojector &unprojector,
                                                   const SurfaceImage &surfaces,
                                                   std::span<const scene::SceneObject> objects,
                                                   const ray::Progress &progress);

/// A source that computes surfaces in parts.
struct SurfaceSource {
    bool areMet = false; ///< SurfaceImage::isMet of all parts
    /// The surfaces of rows; empty if progress requests a stop.
    std::function<std::optional<SurfaceImage>(const Rows &, const ray::Progress &)> of;
};

/// Computes the same map from a band of rows at a time. It needs some 20 MB beyond the map itself,
/// for any size.
/// @param source  with isMet surfaces where needsRays
geometry::Result<std::optional<PixelMap>> pixelMap(const Question &question, const unproject::Unprojector &unprojector,
                                                   const SurfaceSource &source,
                                                   std::span<const scene::SceneObject> objects,
                                                   const ray::Progress &progress);

/// Statistics of a map's numbers, without NaN.
struct MapStatistics {
    std::size_t count = 0; ///< pixels with a number; if 0, the rest is meaningless
    double least = 0.0, percentile1 = 0.0, median = 0.0, percentile99 = 0.0, greatest = 0.0;
    double leastAboveZero = 0.0; ///< start of a logarithmic scale; 0 if all are 0
};
/// @param map  is sorted in place: pass it by move to avoid a copy
MapStatistics statisticsOf(PixelMap map);

/// Writes a map as a portable float map: "Pf", size, scale -1 (little-endian), rows from the
/// bottom, NaN where there is no number.
/// Source: the format in netpbm's pfm(5).
/// @param write  receives one row after the other
void writePfm(const PixelMap &map, const std::function<void(std::string_view)> &write);
std::string pfmText(const PixelMap &map);

} // namespace unprojector::maps
