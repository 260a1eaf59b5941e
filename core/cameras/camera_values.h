#pragma once

#include "core/base/error.h"
#include "core/cameras/named_values.h"
#include "core/cameras/outline.h"
#include "core/cameras/roles.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace unprojector::cameras {

class Reading;

/// Where a value stands.
struct Spot {
    std::size_t text = 0, node = 0; ///< its text, and its place in the outline of that
    std::string camera{};           ///< which of several cameras its name says
    friend bool operator==(const Spot &, const Spot &) = default;
    friend bool operator<(const Spot &a, const Spot &b)
    {
        return std::tie(a.text, a.node, a.camera) < std::tie(b.text, b.node, b.camera);
    }
};

/// A part as a text gives it.
struct CameraValue : NamedValue, Spot {
    std::string name{}; ///< as in the text, without its object's: "cameraMatrix" of "calib.cameraMatrix"
    std::string file{};
    Role role{};
    bool isMatrix = false; ///< has rows and columns, as those of cv::FileStorage and of ROS
    bool isTable = false;  ///< has six columns
    base::Error error(std::string reason) const;
};

/// The parts that some texts have: printed text, JSON, and the YAML and XML of cv::FileStorage and
/// of ROS.
class CameraValues {
public:
    explicit CameraValues(std::span<const NamedText> texts);

    /// All values of a kind; those of a part have a count of numbers that fits it.
    const std::vector<CameraValue> &all(Part part) const { return m_parts[std::size_t(part)]; }
    /// A value of the part whose count of numbers does not fit it; null if there is none.
    const CameraValue *unfit(Part part) const;
    /// The first value of one number under the first of some names, "fx focallengthx"; null if there is
    /// none.
    const CameraValue *find(std::string_view names) const;
    /// The first value of one number whose name has a coefficient's among words of a lens: "k1",
    /// "radial_k1"; null if there is none.
    const CameraValue *coefficient(std::string_view name) const;
    /// Returns whether other numbers have the name of a value: they are of several cameras.
    bool differs(const CameraValue &value) const;
    /// Returns whether a text is ROS's camera_info: its R is the rectification.
    bool isCameraInfo() const;
    /// Returns whether a file has any part, or a number with a name.
    bool hasAny(const std::string &file) const;
    /// The names of the parts of a text that have a lens each: "cam0", "cam1". Empty: one camera, or
    /// several that no names tell apart.
    const std::vector<std::string> &cameras() const { return m_cameras; }
    /// Returns whether a value is of one of cameras().
    bool isOfCamera(const Spot &value) const { return m_cameraNames.contains(cameraOf(value)); }
    /// Drops the values of all cameras but one of cameras().
    /// @param image  a part of the text that stays, whatever its name
    void keepCamera(const std::string &name, const Spot &image = {});
    /// An image with a pose that names its camera: "camera_id: 2".
    struct Image {
        std::string name, camera;
        Spot place;
    };
    /// The images that name one of cameras(), in their order.
    std::vector<Image> images() const;
    /// Drops the values of other images and of other cameras than the one that an image names.
    /// @return false if there is no such camera
    bool keepImage(const Image &image);
    const Outline &outline(std::size_t text) const { return m_outlines[text]; }
    /// The last value of a text if it is a camera's; else null.
    const CameraValue *lastPart(std::size_t text) const;
    /// The error of a part that stands twice in one object with other numbers, or that source code changes.
    const std::optional<base::Error> &fault() const { return m_twice ? m_twice : m_changed; }

private:
    void addText(const NamedText &text);
    void addMember(CameraValue &owner, const NamedValue &member);
    void add(CameraValue value);
    void addUnnamed(CameraValue value);
    void addEach(Part part, CameraValue value, std::size_t count, std::size_t first = 0, std::size_t step = 0);
    void addNumber(const CameraValue &value);
    void addComponents(const NamedValues &named);
    void setTwice(const CameraValue &again, std::size_t firstLine);
    bool setDirectionAround(CameraValue &value) const;
    CameraValue valueOf(const NamedValue &value) const;
    std::vector<CameraValue> &of(Part part) { return m_parts[std::size_t(part)]; }

    void takeLensByForm();
    void findCameras();
    void dropElsewhere();
    std::vector<Spot> lenses() const;
    bool isOfOtherThan(const Spot &lens, const Spot &value) const;
    std::vector<std::size_t> pathTo(const Spot &spot) const { return m_outlines[spot.text].pathTo(spot.node); }
    std::vector<std::string> sectionsOf(const Spot &value) const;
    std::string cameraOf(const Spot &value) const;
    std::string idOf(const Spot &lens) const;
    using Ids = std::map<Spot, std::string>; ///< of parts of a text
    const Ids::value_type *idAround(const Spot &value, const Ids &ids) const;

    std::array<std::vector<CameraValue>, kKinds> m_parts;
    Ids m_ids, m_references; ///< of parts of a text, and those of the cameras they name
    std::optional<base::Error> m_twice, m_changed;
    std::vector<std::string> m_cameras;
    std::set<std::string> m_cameraNames; ///< the same
    std::size_t m_depth = 0;             ///< of their sections in the outline; 0: the ends of names tell them apart
    std::vector<std::string> m_files;    ///< of the texts
    std::vector<std::size_t> m_ends;     ///< where their last names with numbers stand
    std::vector<Outline> m_outlines;
    bool m_isXml = false; ///< the last text
    bool m_isOst = false; ///< a text of ROS's calibrator
};

/// Sets the images of a text with several cameras or poses, and drops the values of those that are not read.
void chooseCamera(Reading &reading, CameraValues &values);

} // namespace unprojector::cameras
