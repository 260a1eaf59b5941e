#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/cameras/named_values.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Parts of the readers of other programs' cameras.

namespace unprojector::cameras {

/// The first text with a property; null if there is none.
template <class Property>
const NamedText *firstWith(std::span<const NamedText> texts, const Property &property)
{
    for (const NamedText &text : texts) {
        if (property(text.text))
            return &text;
    }
    return nullptr;
}

/// The index of the image that the user names: by its whole name, by its file's name with or
/// without suffix, or by an index from 0. The first if no image is named.
/// @return nothing if there is no such image
std::optional<std::size_t> imageIndex(const std::vector<std::string> &images, const std::string &choice);

/// Sets the image of a camera whose `images` are set. Adds a sentence where the first of several
/// is taken.
/// @return the error of a wrong choice, which lists the first images
std::optional<CameraError> chooseImage(ForeignCamera &camera, const CameraChoices &choices, const std::string &file);

/// The image's size, by the choices or by the camera's file.
std::optional<ImageSize> sizeOf(const ForeignCamera &camera, const CameraChoices &choices);

/// The size that two numbers give; nothing for anything but whole numbers above 0.
std::optional<ImageSize> sizeOf(std::optional<double> width, std::optional<double> height);
/// The size among named values: width and height, resolution, viewport.
std::optional<ImageSize> sizeIn(const NamedValues &values);

/// "800x600", as --size takes it.
std::string sizeText(const ImageSize &size);
/// The error of a size that neither the file nor the choices give.
CameraError noSize(const std::string &file);

/// Sets the intrinsics of a vertical angle of view, with the principal point in the image's
/// centre.
/// @param aspect  width / height of the image that the angle belongs to; empty: square pixels
/// @return the error of a missing size or an angle outside (0, pi)
std::optional<CameraError> setVerticalAngle(ForeignCamera &camera, const CameraChoices &choices, double radians,
                                            const std::optional<double> &aspect, const std::string &file);
/// The same for a horizontal angle.
std::optional<CameraError> setHorizontalAngle(ForeignCamera &camera, const CameraChoices &choices, double radians,
                                              const std::string &file);

/// A matrix of 9 (a rotation), 12 or 16 numbers by rows; nothing for another count.
std::optional<glm::dmat4> matrixByRows(std::span<const double> numbers);
/// A matrix of 16 numbers by columns; nothing for another count.
std::optional<glm::dmat4> matrixByColumns(std::span<const double> numbers);

/// The rotation of a quaternion of any length; nothing for 0.
std::optional<glm::dmat3> rotationOf(double w, double x, double y, double z);

/// A rotation about an axis, 0 to 2, counter-clockwise as seen against it.
glm::dmat3 about(int axis, double radians);

/// The transform of a rotation, then a translation.
glm::dmat4 rigid(const glm::dmat3 &rotation, const glm::dvec3 &translation);

/// gluLookAt's camera-to-world transform: right, up and back as columns.
/// @return nothing if the direction is 0 or up is parallel to it
std::optional<glm::dmat4> looking(const glm::dvec3 &eye, const glm::dvec3 &back, const glm::dvec3 &up);

} // namespace unprojector::cameras
