#pragma once

#include "core/cameras/named_values.h"
#include "core/cameras/outline.h"
#include "core/cameras/roles.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::cameras {

/// A part as a text gives it.
struct CameraValue : NamedValue {
    std::string name{}; ///< as in the text, without its object's: "cameraMatrix" of "calib.cameraMatrix"
    std::string file{};
    Role role{};
    std::size_t text = 0, node = 0; ///< its text, and its place in the outline of that
    std::string camera{};           ///< which of several cameras its name says
};

/// The parts that some texts have: printed text, JSON, and the YAML and XML of cv::FileStorage and
/// of ROS.
class CameraValues {
public:
    explicit CameraValues(std::span<const NamedText> texts);

    /// All values of a part whose count of numbers fits it.
    const std::vector<CameraValue> &all(Part part) const { return m_parts[std::size_t(part)]; }
    /// A value of the part whose count of numbers does not fit it.
    const std::optional<CameraValue> &unfit(Part part) const { return m_unfit[std::size_t(part)]; }
    /// The number under the first of some names: "znear nearplane".
    std::optional<double> number(std::string_view names) const;
    /// All values of one number.
    const std::vector<CameraValue> &numbers() const { return m_numbers; }
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
    /// The values that look like a camera's, but whose name says no part.
    const std::vector<CameraValue> &others() const { return m_others; }
    /// Returns whether a file has any part, or a number with a name.
    bool hasAny(const std::string &file) const;
    /// The names of the parts of a text that have a lens each: "cam0", "cam1". Empty: one camera, or
    /// several that no names tell apart.
    const std::vector<std::string> &cameras() const { return m_cameras; }
    /// Drops the values of all cameras but one of cameras().
    /// @param image  a part of the text that stays, whatever its name
    void keepCamera(const std::string &name, std::pair<std::size_t, std::size_t> image = {});
    /// An image with a pose that names its camera: "camera_id: 2".
    struct Image {
        std::string name, camera;
        std::pair<std::size_t, std::size_t> place; ///< its text, and its node in the outline of that
    };
    /// The images that name one of cameras(), in their order.
    std::vector<Image> images() const;
    /// Drops the values of other images and of other cameras than the one that an image names.
    /// @return false if there is no such camera
    bool keepImage(const Image &image);
    /// What the part of the text around a value calls itself; empty: nothing.
    std::string labelOf(const CameraValue &value) const;
    /// A part that stands twice in one object, with other numbers, and the line of the first.
    const std::optional<std::pair<std::size_t, CameraValue>> &twice() const { return m_twice; }
    /// Returns whether a text ends inside of a bracket.
    bool isUnclosed(std::size_t text) const { return m_outlines[text].isUnclosed(); }
    /// The last value of a text if it is a camera's; else null.
    const CameraValue *lastPart(std::size_t text) const;
    /// Returns whether a text closes a bracket that is not open.
    bool isOverclosed(std::size_t text) const { return m_outlines[text].isOverclosed(); }
    /// A number of a camera whose name has another count of numbers, or a matrix without data.
    const std::vector<CameraValue> &broken() const { return m_broken; }
    /// Names of a pose's parts that have something else than numbers.
    const std::vector<CameraValue> &empty() const { return m_empty; }
    /// A part that source code changes behind its name.
    const std::optional<CameraValue> &changed() const { return m_changed; }
    /// Returns whether a value is of one of cameras().
    bool isOfCamera(const CameraValue &value) const;

private:
    void add(CameraValue value);
    void addUnnamed(CameraValue value);
    void addPoses(CameraValue value);
    void addNumber(const CameraValue &value);
    void addComponents(const NamedValues &named);
    void addEach(Part part, CameraValue value, std::size_t entries);
    CameraValue valueOf(const NamedValue &value) const;
    std::vector<std::string> sectionsOf(const CameraValue &value) const;
    std::string cameraOf(const CameraValue &value) const;
    bool setDirectionAround(CameraValue &value) const;
    void dropElsewhere();
    std::vector<CameraValue> lenses() const;
    bool isOfOtherThan(const CameraValue &lens, const CameraValue &value) const;
    std::string idOf(const CameraValue &lens) const;
    std::vector<CameraValue> &of(Part part) { return m_parts[std::size_t(part)]; }

    std::array<std::vector<CameraValue>, kParts> m_parts;
    std::array<std::optional<CameraValue>, kParts> m_unfit;
    std::vector<CameraValue> m_others;
    void findCameras();

    std::vector<CameraValue> m_numbers;                ///< values of one number
    using Place = std::pair<std::size_t, std::size_t>; ///< a text and a node of its outline
    std::string idAround(const CameraValue &value, const std::map<Place, std::string> &ids, Place &place) const;
    std::map<Place, std::string> m_ids, m_references; ///< of parts of a text, and those of the cameras they name
    std::optional<std::pair<std::size_t, CameraValue>> m_twice;
    std::vector<CameraValue> m_broken, m_empty;
    std::optional<CameraValue> m_changed;
    std::vector<std::string> m_cameras;
    std::size_t m_depth = 0;          ///< of their sections in the outline; 0: the ends of names tell them apart
    std::vector<std::string> m_files; ///< of the texts
    std::vector<std::size_t> m_ends;  ///< where their last names with numbers stand
    std::vector<Outline> m_outlines;
    bool m_isXml = false; ///< the last text
};

} // namespace unprojector::cameras
