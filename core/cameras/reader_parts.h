#pragma once

#include "core/base/angle.h"
#include "core/base/error.h"
#include "core/cameras/node.h"
#include "core/geometry/projection.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Parts of the readers of other programs' cameras.

namespace unprojector::cameras {

/// A camera of a text, with the names that choose it and the nodes of its parts.
struct Found {
    std::string name, id; ///< the name is empty in a text of one camera
    Node pose{}, lens{}, own{};
    glm::dmat4 parent{1.0}; ///< the transform of what the pose is in
    Trail around{};         ///< to an element of XML
};
using Cameras = std::vector<Found>;

/// What the poses of a program are. The default is that of OpenCV.
struct Frame {
    PoseDirection direction = PoseDirection::WorldToCamera;
    EyeAxes axes = EyeAxes::RightDownAhead;
};
inline constexpr Frame kOpenGl{PoseDirection::CameraToWorld, EyeAxes::RightUpBack};

/// A text, its chosen camera, and what a program's reader fills from it. What the reader cannot use, it
/// throws as a base::Error.
class Reading : public Found {
public:
    Reading(const NamedText &given, const CameraChoices &chosen) : text(given), choices(chosen) {}

    const NamedText &text;
    const CameraChoices &choices;
    ForeignCamera camera = {};
    Node file{};                      ///< the whole text
    std::string json{};               ///< its JSON, without comments
    std::span<const NamedText> all{}; ///< the texts given with it

    mutable std::set<std::string, std::less<>> used{}; ///< the plain names that were looked up

    /// The names and values of a printed text, read when they are first asked for.
    std::shared_ptr<const NamedValues> values();

    /// Begins the camera of a program that tells the pose's direction and axes.
    void begin(const char *program, const Frame &frame);

    /// @param line  from 1; 0: the whole file
    [[noreturn]] void fail(std::string reason, std::size_t line = 0) const;
    void say(std::string assumed) { camera.assumed.push_back(std::move(assumed)); }

    /// Sets the image of a camera whose `images` are set; without any, no choice fits but "0". Adds a sentence
    /// where the first of several is taken. A wrong choice fails with a list of the first images.
    /// @param ids  other names of the images, in their order; empty: none. They count where no image has the name.
    void chooseImage(std::span<const std::string> ids = {});

    /// Sets the size of two whole numbers; none for others.
    void setSize(const Node &node, std::string_view keys);
    void setPlanes(const Node &node, std::string_view keys);
    /// Sets the intrinsics: K by rows or by columns, as its last row 0 0 1 tells, or fx, fy, cx and cy.
    void setLens(const Node &node, std::string_view keys, PixelCentres centres);
    /// Sets the pose of a matrix of 12 or 16 numbers, or of a rotation (9; w, x, y, z; angle-axis) at a translation;
    /// 7 are x, y, z, w and the translation.
    /// @param at  a key; empty: the matrix has it, or there is none
    void setPose(const Node &node, std::string_view keys, std::size_t count, std::string_view at = {},
                 bool isByColumns = false);
    /// Sets right, up and back of an eye. Fails where they are no axes.
    void setLooking(const glm::dvec3 &eye, const glm::dvec3 &back, const glm::dvec3 &up);
    /// Sets a lens of this many pixels, with the principal point off the image's centre to the right and
    /// down.
    void setCentred(const ImageSize &image, double fx, double fy, double right = 0.0, double down = 0.0);
    /// Sets a box of this height, as wide as the image has it.
    void setFlat(double height, double nearDistance, double farDistance);

    /// The image's size, by the choices or by the camera's file.
    std::optional<ImageSize> size() const { return choices.size ? choices.size : camera.size; }
    /// The same; fails if neither gives it.
    ImageSize neededSize() const;

    /// Sets the intrinsics of a vertical angle of view, with the principal point in the image's
    /// centre. Fails without a size, or for an angle outside (0, pi).
    /// @param aspect  width / height of the image that the angle belongs to; empty: square pixels
    void setVerticalAngle(double radians, const std::optional<double> &aspect = {});
    /// The same for a horizontal angle.
    void setHorizontalAngle(double radians);
    /// The same in degrees.
    void setDegrees(double degrees, bool isAcross = false)
    {
        const double radians = base::radiansFromDegrees(degrees);
        isAcross ? setHorizontalAngle(radians) : setVerticalAngle(radians);
    }
    /// Sets OpenGL's matrix of a projection. Fails where it has none.
    void setProjection(const geometry::Projection &projection, std::size_t line);

private:
    void setAngle(double radians, int ImageSize::*side);

    std::shared_ptr<const NamedValues> m_values;
};

/// Sets coefficients that are those of Brown and Conrady; refuses other models.
/// @param coefficients  k1, k2, k3, p1, p2, or the first of them; nothing: of another model
void setDistortion(Reading &reading, const std::string &model, std::optional<Numbers> coefficients);

/// The same for a list in OpenCV's order; empty: none.
void setDistortion(Reading &reading, const Numbers &coefficients);

bool areZero(const Numbers &numbers);

/// Fails because the file lacks the chosen image's lens.
[[noreturn]] void failWithoutLens(const Reading &reading);
/// Says that a pose counts as that of a camera without parent.
void sayNoParent(Reading &reading, const char *transform);
/// Negates Unity's z.
void sayUnity(Reading &reading);

/// The size that two numbers give; nothing for anything but whole numbers above 0.
std::optional<ImageSize> sizeOf(std::optional<double> width, std::optional<double> height);
/// The size in a printed text: width and height, resolution, viewport.
std::optional<ImageSize> sizeIn(const Node &text);

/// "800x600", as --size takes it.
std::string sizeText(const ImageSize &size);
/// The reason against a size that neither the file nor the choices give.
std::string noSizeText();
/// The reason against a distortion that is not Brown and Conrady's.
std::string unknownDistortionText(const std::string &model);

/// A matrix of 9 (a rotation), 12 or 16 numbers by rows; nothing for another count.
std::optional<glm::dmat4> matrixByRows(std::span<const double> numbers);
/// A matrix of 16 numbers by columns; nothing for another count.
std::optional<glm::dmat4> matrixByColumns(std::span<const double> numbers);

/// The rotation of a quaternion of any length; nothing for 0.
std::optional<glm::dmat3> rotationOf(double w, double x, double y, double z);
std::optional<glm::dmat3> rotationOfXyzw(const Numbers &xyzw);

/// A rotation about an axis, 0 to 2, counter-clockwise as seen against it.
glm::dmat3 about(int axis, double radians);

/// The transform of a rotation, then a translation.
glm::dmat4 rigid(const glm::dmat3 &rotation, const glm::dvec3 &translation);

/// gluLookAt's camera-to-world transform: right, up and back as columns.
/// @return nothing if the direction is 0 or up is parallel to it
std::optional<glm::dmat4> looking(const glm::dvec3 &eye, const glm::dvec3 &back, const glm::dvec3 &up);

} // namespace unprojector::cameras
