#pragma once

#include "core/geometry/picture.h"
#include "core/geometry/spaces.h"

namespace unprojector::unproject {
using namespace geometry;

/// How a program gets from a click to a point: every step that programs do differently, as a value. What a member is by
/// default is this program's own path; every other value is a mistake that somebody makes, and an Unprojector with it
/// answers what that somebody's program answers. Mistakes can be combined.
///
/// Those up to `fovAxis` change the pixel, the viewport, the depth or the lens and so both methods; the others belong to
/// the inverted matrix and leave the formulas alone.
struct Conventions {
    /// The y flip of (8), y_w = H - py.
    enum class Flip {
        ByFramebufferHeight,
        Left,            ///< y_w = py
        ByViewportHeight ///< y_w = h - py, with h the viewport's height
    };
    Flip flip = Flip::ByFramebufferHeight;

    /// What of a pixel is unprojected.
    enum class PixelPart {
        Centre,
        Corner,  ///< its top-left corner: no half pixel
        RowAbove ///< x of the centre, y of the centre of the row above: H - j for H - 1 - j
    };
    PixelPart pixelPart = PixelPart::Centre;

    /// Logical pixels to device pixels.
    enum class PixelRatio {
        Applied,
        Forgotten,          ///< logical position, flipped with the height in device pixels
        ForgottenInFlipToo, ///< logical position, flipped with the height in logical pixels
        AppliedTwice
    };
    PixelRatio pixelRatio = PixelRatio::Applied;

    /// The rectangle that NDC is spread over.
    enum class ViewportOffset {
        Taken,
        Forgotten,  ///< (0, 0, width, height)
        WholeWindow ///< the framebuffer instead of the viewport
    };
    ViewportOffset viewportOffset = ViewportOffset::Taken;

    /// From the depth, mapped back to d in [0, 1], to z_n.
    enum class NdcDepthTaken {
        ByThePicture,
        AsItIs,   ///< z_n = d, where the matrix goes by [-1, 1]
        Stretched ///< z_n = 2 d - 1, where the matrix goes by [0, 1]
    };
    NdcDepthTaken ndcDepth = NdcDepthTaken::ByThePicture;

    bool reversed = false; ///< 1 - d for d: reversed depths taken for ordinary ones, or the other way round

    /// The unit of gluPerspective's angle.
    enum class AngleUnit {
        Radians,
        DegreesTakenForRadians ///< tan(45) for tan(45 degrees)
    };
    AngleUnit angleUnit = AngleUnit::Radians;

    enum class FovAxis {
        Vertical,
        VerticalTakenForHorizontal ///< the angle spans the width
    };
    FovAxis fovAxis = FovAxis::Vertical;

    /// Rows taken for columns.
    enum class Transposed { None, View, Projection, Both, Product };
    Transposed transposed = Transposed::None;

    /// The order of the factors.
    enum class Order {
        InverseOfProduct,              ///< inverse(P V)
        InversesInTheOrderOfTheFactors ///< inverse(P) inverse(V) for inverse(V) inverse(P)
    };
    Order order = Order::InverseOfProduct;

    enum class Inverse {
        Taken,
        Forgotten,        ///< P V itself
        ViewInvertedTwice ///< the camera's matrix, worldFromEye, passed for the view
    };
    Inverse inverse = Inverse::Taken;

    enum class W { Divided, Ignored };
    W w = W::Divided;

    /// The model matrix of the object that was hit.
    enum class Model {
        Apart,       ///< world coordinates are world coordinates
        LeftIn,      ///< what is called world is the object's own space
        AppliedAgain ///< what is called world has gone through the model matrix once more
    };
    Model model = Model::Apart;

    bool singlePrecision = false; ///< the matrix method in float throughout

    friend bool operator==(const Conventions &, const Conventions &) = default;
};

/// The window point that a program with these conventions takes a click for.
/// @param widget  logical pixels, origin top-left
/// @param depth   in the picture's depth range
/// @return the errors of devicePixelFromWidget
Result<WindowPoint> windowOfClick(const Picture &picture, const Conventions &conventions, const WidgetPoint &widget,
                                  double depth);

/// The picture as a program with these conventions has it: its viewport, the ends of its depth range, its lens.
Picture misread(const Picture &picture, const Conventions &conventions);

} // namespace unprojector::unproject
