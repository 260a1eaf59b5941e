#pragma once

#include "core/doctor/diagnosis.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <string>

namespace unprojector::doctor {

/// What the wrong program was given, whatever it made of it: the picture as plain numbers, worked out once.
struct Given {
    geometry::Surface surface;
    geometry::Viewport viewport;
    geometry::DepthRange depthRange;
    geometry::NdcDepth ndcDepth = geometry::NdcDepth::MinusOneToOne;
    bool isPerspective = true;
    bool isFrustum = false; ///< by the arguments of glFrustum, whose window stands on the near plane
    bool isReversed = false;
    double side = -1.0; ///< of eye space, into which the camera looks: z_eye = side * distance
    /// Eye units; NaN where the projection is a matrix that says nothing about them, infinity for a far plane there.
    double nearDistance = 1.0, farDistance = 100.0;
    glm::dmat4 clipFromEye{1.0};
    glm::dmat4 eyeFromWorld{1.0};
    glm::dvec3 eyePosition{0.0}; ///< world space

    /// @return the errors of check(setup), clipFromEye and eyeFromWorld; SingularMatrix
    static geometry::Result<Given> of(const geometry::Setup &setup);
};

/// One click of the program, and what is right about it.
struct Click {
    geometry::DevicePoint pixel;
    double depth = 0.0;
    PointSpace space = PointSpace::World;
    glm::dmat4 worldFromObject{1.0}; ///< of the object whose space the answer is in; the identity for others
    glm::dvec3 eye{0.0};             ///< the right point, eye space
    /// Depths of the pixels above and below, where the scene has a mesh there.
    std::optional<double> depthAbove, depthBelow;
};

/// The stages of the way from a click to a point. A mistake belongs to one of them, so that two mistakes go together by
/// themselves; where both belong to the same stage, either may come first.
enum class Stage {
    Pixel,   ///< where in the framebuffer, which flip, which viewport
    Window,  ///< the window point's x and y
    Depth,   ///< the depth mapped back to [0, 1]
    Lens,    ///< the numbers of the projection matrix
    Eye,     ///< the eye point, as closed formulas have it
    Factors, ///< projection and view matrix
    Product, ///< how the two become one inverse
    Divide,  ///< the product of that with the point in NDC, and the division by w
    Point,   ///< the answer itself
};

/// A program on its way: each stage reads what is there and leaves it for the next.
struct Run {
    Run(const Given &toAll, const Click &clicked) : given(toAll), click(clicked) {}

    const Given &given;
    const Click &click;

    glm::dvec2 position{0.0}; ///< device pixels, origin top-left
    double flipHeight = 0.0;  ///< y_w = flipHeight - y
    bool isFlipped = true;
    geometry::Viewport viewport;

    glm::dvec2 window{0.0};
    double depth = 0.0; ///< 0 on the plane of the depth range's near end, 1 on the other
    double nearDistance = 0.0, farDistance = 0.0;
    glm::dmat4 clipFromEye{1.0}, eyeFromWorld{1.0};
    glm::dvec3 ndc{0.0}; ///< set after Lens
    glm::dvec3 eye{0.0}; ///< set for Eye

    enum class Order { InverseOfProduct, InverseOfTransposed, InversesInTheOrderOfTheFactors, NotInverted };
    Order order = Order::InverseOfProduct;
    bool isInPlace = false; ///< each coordinate of the product overwrites that of the vector
    int divisions = 1;      ///< by w
    /// The eye point goes straight through the inverse of the view, as closed formulas have it: no projection matrix, and
    /// no division.
    bool isClosedForm = false;

    glm::dmat4 spaceFromClip{1.0}; ///< set after Product, but for closed formulas
    glm::dvec3 point{0.0};
    bool isLost = false; ///< such a program has no answer here

    /// The share of the way from the near plane to the far one, of a depth in [0, 1].
    double shareFromNear(double unitDepth) const { return given.isReversed ? 1.0 - unitDepth : unitDepth; }
    /// The eye point at another distance on its ray.
    void setDistance(double distance);
    double distance() const { return given.side * eye.z; }
};

/// One way to make a mistake.
struct Variant {
    std::size_t mistake = 0; ///< its place in the list of mistakes
    Stage stage = Stage::Pixel;
    void (*apply)(Run &, const Variant &) = nullptr;
    double parameter = 0.0, second = 0.0;
    glm::dmat4 matrix{1.0}; ///< of a model
    VariantName name;       ///< empty where the mistake has one
};

/// A program with these mistakes at its end, with what each stage left; nothing where it has no finite answer.
/// @param given, click  must outlive what is returned
/// @param mistakes      in the order in which those of the same stage are made
/// @param isClosedForm  see Run::isClosedForm; the mistakes are of the stages up to Factors
std::optional<Run> ran(const Given &given, const Click &click, std::span<const Variant *const> mistakes,
                       bool isClosedForm = false);
/// What it answers.
std::optional<glm::dvec3> answer(const Given &given, const Click &click, std::span<const Variant *const> mistakes,
                                 bool isClosedForm = false);

/// Takes the space that a click's point is answered in to the world's.
glm::dmat4 worldFromSpace(const Given &given, const Click &click);

/// Sets the right eye point of a click's pixel and depth.
void setRightEye(const Given &given, Click &click);

/// Where a point of a space lies in the picture, by the right matrices: x, y in device pixels from the top-left corner,
/// depth in the depth range. Nothing in the plane of the eye.
std::optional<glm::dvec3> projected(const Given &given, const Click &click, const glm::dvec3 &point);

} // namespace unprojector::doctor
