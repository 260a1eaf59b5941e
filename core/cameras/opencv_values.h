#pragma once

#include "core/cameras/camera_reader.h"
#include "core/cameras/named_values.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// The parts of a camera in OpenCV's terms.
enum class OpenCvPart {
    Intrinsics,   ///< K, nine numbers by rows, or fx, fy, cx, cy
    Rotation,     ///< R, nine numbers by rows, or a rotation vector
    Quaternion,   ///< x, y, z, w, each with its name
    Translation,  ///< t
    Pose,         ///< [R t], twelve or sixteen numbers by rows
    CameraMatrix, ///< P, twelve numbers by rows
    Distortion,   ///< a list of coefficients
    Size,         ///< width, height
    Model         ///< the name of a distortion model
};
inline constexpr std::size_t kOpenCvParts = 9;

/// A part as a text gives it.
struct OpenCvValue {
    std::string name; ///< as words, "camera matrix"
    std::string word; ///< the value, if it is a word
    std::vector<double> numbers;
    std::size_t line = 0;
    std::string file;
    std::string arithmetic{}; ///< as in NamedValue
};

/// The parts that some texts have: printed text, JSON, and the YAML and XML of cv::FileStorage and
/// of ROS.
class OpenCvValues {
public:
    explicit OpenCvValues(std::span<const NamedText> texts);

    /// All values of a part whose count of numbers fits it.
    const std::vector<OpenCvValue> &all(OpenCvPart part) const { return m_parts[std::size_t(part)]; }
    /// A value of the part whose count of numbers does not fit it.
    const std::optional<OpenCvValue> &unfit(OpenCvPart part) const { return m_unfit[std::size_t(part)]; }
    /// A number by its name: "fx", "k1", "width". The first one counts.
    std::optional<double> number(std::initializer_list<std::string_view> names) const;
    /// The first value of one number under a name; null if there is none.
    const NamedValue *find(std::string_view name) const;
    /// Returns whether several numbers under a name differ: they are of several cameras.
    bool differ(std::string_view name) const;
    /// Returns whether a text is ROS's camera_info: its R is the rectification.
    bool isCameraInfo() const { return m_isCameraInfo; }

private:
    void add(OpenCvPart part, OpenCvValue value);
    void addPoses(OpenCvValue value);
    void addComponents(const NamedValues &named, const std::string &file);

    std::array<std::vector<OpenCvValue>, kOpenCvParts> m_parts;
    std::array<std::optional<OpenCvValue>, kOpenCvParts> m_unfit;
    std::vector<NamedValue> m_numbers; ///< values of one number
    bool m_isCameraInfo = false;
};

} // namespace unprojector::cameras
