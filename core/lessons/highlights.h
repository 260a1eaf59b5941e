#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"
#include "core/geometry/spaces.h"
#include "core/geometry/viewport.h"
#include "core/lessons/highlight.h"
#include "core/scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The labels that a step's "highlights" add to the views: letters and their positions. The painter
/// chooses their size.
namespace unprojector::lessons {

/// Their names in files, in the order of Highlight.
inline constexpr std::array kHighlightNames{"axes", "volume", "cube", "viewport"};

/// A letter and its index: x with MC.
struct Letter {
    std::string letter;
    std::string index; ///< may be empty
    friend bool operator==(const Letter &, const Letter &) = default;
};

/// The axes of a coordinate system.
struct NamedAxes {
    std::string name;
    geometry::WorldPoint origin;
    std::array<geometry::WorldVector, 3> directions; ///< of x, y, z: unit vectors; a mirrored system stays mirrored
};

/// The axes of Highlight::Axes: MC of the followed object, else of the first one; WC of the world;
/// VC of the eye, whose z points backwards. If MC equals WC, one entry "MC = WC" replaces both.
/// Source: the names are from Zhang Ci, section 2.1; Weng et al. 2008, figure 2, has WC and VC.
std::vector<NamedAxes> namedAxes(const scene::Scene &scene, const geometry::EyeFrame &eye);

template <class Space>
struct LetterAt {
    Letter letter;
    geometry::Point<Space> at;
};

/// The letters of Highlight::Volume: l, r, b, t, n, f, each in the middle of its side of the view
/// volume.
/// Source: Weng et al. 2008, figures 3 and 4.
/// @pre the projection is valid
std::array<LetterAt<geometry::EyeSpace>, 6> volumeLetters(const geometry::Projection &projection);

/// The letters of Highlight::Cube: −1 and 1 where x, y and z cross the sides of the normalised
/// cube.
std::array<LetterAt<geometry::NdcSpace>, 6> cubeLetters();

/// An arrow in a view, and its letter.
struct LetteredArrow {
    enum class Kind {
        Axis,  ///< an arrow head and the letter at its end
        Length ///< a line from one end to the other, the letter between them
    };
    Kind kind;
    Letter letter;
    geometry::WindowPoint from, to; ///< the depth is 0
};

/// The arrows of Highlight::Viewport: the axes x_v and y_v from the lower left corner of the view;
/// vx and vy from there to the viewport; its width and height; and H, the height of the view, which
/// the paper calls rect.bottom. Lengths of 0 are omitted.
/// Source: Weng et al. 2008, figures 5 and 6, formulas (3), (4), (7), (8).
/// @param inset  distance between an edge and an arrow along it, on the inside, device pixels
/// @pre viewport and surface are valid
std::vector<LetteredArrow> viewportArrows(const geometry::Viewport &viewport, const geometry::Surface &surface,
                                          double inset);

} // namespace unprojector::lessons
