#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/doctor/diagnosis.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::doctor {

/// One click of the program, and its right answer.
struct Click {
    geometry::DevicePoint pixel; ///< undistorted
    glm::dvec2 distortedBy{0.0}; ///< from there to the pixel in the image
    double depth = 0.0;
    PointSpace space = PointSpace::World;
    glm::dmat4 worldFromObject{1.0}; ///< of the object in whose space the answer is; the identity for other spaces
    glm::dvec3 eye{0.0};             ///< the right point, eye space
    /// Depths of the pixels above and below, if the scene has a mesh there.
    std::optional<double> depthAbove, depthBelow;
};

/// A given point, and the clicks that programs must answer with it. One click, or two where the
/// depth is not known exactly: then any answer between theirs fits. If the depth is unknown, any
/// answer on their line fits.
struct Target {
    std::vector<Click> clicks; ///< one or two
    bool isLine = false;       ///< the line through the two
    glm::dvec3 got{0.0};
    glm::dvec3 lastDigit{1.0};    ///< the last significant digit
    glm::dvec3 writtenDigit{1.0}; ///< the last given digit
};

/// The input of the wrong program, the setup as plain numbers, computed once; and its points.
struct Given {
    geometry::Surface surface;
    geometry::Viewport viewport;
    geometry::DepthRange depthRange;
    geometry::NdcDepth ndcDepth = geometry::NdcDepth::MinusOneToOne;
    bool isPerspective = true;
    bool isFrustum = false; ///< given by the arguments of glFrustum, whose window is on the near plane
    bool isReversed = false;
    double side = -1.0; ///< direction of view in eye space: z_eye = side * distance
    /// The distances of the near and the far plane, eye units. NaN if the projection is a matrix
    /// without near and far. The far distance is infinity for a far plane at infinity.
    double nearDistance = 1.0, farDistance = 100.0;
    glm::dmat4 clipFromEye{1.0};
    glm::dmat4 eyeFromWorld{1.0};
    glm::dmat4 eyeFromClip{1.0}, worldFromClip{1.0};
    glm::dvec3 eyePosition{0.0};    ///< world space
    cameras::Distortion distortion; ///< of the pixels; only a perspective has it
    std::vector<Target> points;     ///< empty for mistakes of fixed form only

    /// @return the errors of check(setup), clipFromEye and eyeFromWorld; SingularMatrix
    static geometry::Result<Given> of(const geometry::Setup &setup, const cameras::Distortion &distortion = {});

    /// The depth in [0, 1] of one in the depth range.
    double unitDepth(double depth) const
    {
        return (depth - depthRange.atNear) / (depthRange.atFar - depthRange.atNear);
    }
    double ndcZ(double unitDepth) const
    {
        return ndcDepth == geometry::NdcDepth::ZeroToOne ? unitDepth : 2.0 * unitDepth - 1.0;
    }
    /// The share of the way from the near plane to the far plane, for a depth in [0, 1].
    double shareFromNear(double unitDepth) const { return isReversed ? 1.0 - unitDepth : unitDepth; }
};

/// The stages from a click to a point. Each mistake belongs to one stage, so two mistakes of
/// different stages combine in a fixed order. Two of the same stage may come in either order.
enum class Stage {
    Pixel,   ///< position in the framebuffer, flip, viewport
    Window,  ///< the window point's x and y
    Depth,   ///< the depth mapped back to [0, 1]
    Lens,    ///< the numbers of the projection matrix
    Eye,     ///< the eye point of closed formulas
    Factors, ///< projection and view matrix
    Product, ///< the combination of both into one inverse
    Divide,  ///< the product of the inverse with the NDC point, and the division by w
    Point,   ///< the answer itself
};

/// The state of a program between stages: each stage reads it and updates it.
struct Run {
    Run(const Given &toAll, const Click &clicked) : given(toAll), click(clicked) {}

    const Given &given;
    const Click &click;
    /// The numbers of the mistake that is being made, see Variant.
    double parameter = 0.0, second = 0.0;
    const glm::dmat4 *matrix = nullptr;

    glm::dvec2 position{0.0}; ///< device pixels, origin top-left
    double flipHeight = 0.0;  ///< y_w = flipHeight - y
    bool isFlipped = true;
    geometry::Viewport viewport;

    glm::dvec2 window{0.0};
    double depth = 0.0; ///< 0 at the depth range's near end, 1 at the far end
    double nearDistance = 0.0, farDistance = 0.0;
    glm::dmat4 clipFromEye{1.0}, eyeFromWorld{1.0};
    glm::dvec3 ndc{0.0}; ///< set after Lens
    glm::dvec3 eye{0.0}; ///< set for Eye

    enum class Order { InverseOfProduct, InverseOfTransposed, InversesInTheOrderOfTheFactors, NotInverted };
    Order order = Order::InverseOfProduct;
    bool isInPlace = false; ///< each coordinate of the product overwrites the vector's
    int divisions = 1;      ///< by w
    /// The eye point passes through the inverse of the view only, as in closed formulas: no
    /// projection matrix and no division.
    bool isClosedForm = false;

    glm::dmat4 spaceFromClip{1.0}; ///< set after Product, except for closed formulas
    glm::dvec3 point{0.0};
    bool isLost = false; ///< the program has no answer here

    /// Moves the eye point to another distance on its ray.
    void setDistance(double distance);
    double distance() const { return given.side * eye.z; }
};

/// A variant of a mistake.
struct Variant {
    std::size_t mistake = 0; ///< index in the list of mistakes
    Stage stage = Stage::Pixel;
    void (*apply)(Run &) = nullptr;
    double parameter = 0.0, second = 0.0;
    glm::dmat4 matrix{1.0};            ///< of a model, or of another frame
    VariantName name{};                ///< empty if the mistake has one variant
    std::vector<SolvedValue> values{}; ///< see Candidate::values
    /// The number of values that were solved from the given points; 0 for a mistake of fixed form.
    int unknowns = 0;
    bool isAlone = false;    ///< of fixed form, but not tried in pairs
    bool isExpected = false; ///< the solved values are round, or stand in the scene
    /// The chance that arbitrary values are as round as the solved ones, see WrittenValue.
    double coincidence = 1.0;
};

/// The program with these mistakes after its last stage, with each stage's result; empty if it has
/// no finite answer.
/// @param given, click  must outlive the result
/// @param mistakes      in the order of application within a stage
/// @param isClosedForm  see Run::isClosedForm; the mistakes belong to stages up to Factors
std::optional<Run> ran(const Given &given, const Click &click, std::span<const Variant *const> mistakes,
                       bool isClosedForm = false);
/// The answer of the program with these mistakes, see ran(); empty if it has no finite answer.
std::optional<glm::dvec3> answer(const Given &given, const Click &click, std::span<const Variant *const> mistakes,
                                 bool isClosedForm = false);

/// A point divided by its w.
glm::dvec3 transformed(const glm::dmat4 &m, const glm::dvec3 &point);
/// x and y of a window point in NDC.
glm::dvec2 ndcXy(const geometry::Viewport &viewport, const glm::dvec2 &window);
/// The greatest coordinate's size.
double greatestOf(const glm::dvec3 &v);

/// The transform from the space of a click's answer to world space.
glm::dmat4 worldFromSpace(const Given &given, const Click &click);

/// K: focal lengths and centre in device pixels from the top-left corner. @pre isPerspective
cameras::Intrinsics intrinsicsOf(const Given &given);
/// The position in the image that shows an undistorted position, both in device pixels.
glm::dvec2 distorted(const Given &given, const glm::dvec2 &position);
/// Sets a click's pixel, and its right eye point.
/// @param inImage  a position outside the range of the distortion's inverse stays as it is
void setPixel(const Given &given, Click &click, const geometry::DevicePoint &inImage);

/// Sets the right eye point of a click's pixel and depth.
void setRightEye(const Given &given, Click &click);

/// The projection of a point with the right matrices: x, y in device pixels from the top-left
/// corner, depth in the depth range. Empty in the plane of the eye.
std::optional<glm::dvec3> projected(const Given &given, const Click &click, const glm::dvec3 &point);

} // namespace unprojector::doctor
