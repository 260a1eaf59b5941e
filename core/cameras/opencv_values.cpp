#include "core/cameras/opencv_values.h"

#include "core/base/text_scanner.h"
#include "core/cameras/printed_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace unprojector::cameras {
namespace {

struct PartNames {
    OpenCvPart part;
    std::string_view names; ///< letters and digits in lower case, as in NamedValues
};

constexpr std::array kNames{
    PartNames{OpenCvPart::Intrinsics, "k cameramatrix cammatrix cameramtx mtx intrinsic intrinsics intrinsicmatrix "
                                      "intrinsicsmatrix cameraintrinsics camintr"},
    PartNames{OpenCvPart::Rotation, "r rvec rvecs rot rmat rotation rotationmatrix rotationvector"},
    PartNames{OpenCvPart::Quaternion, "q quat qvec quaternion orientation"},
    PartNames{OpenCvPart::Translation, "t tvec tvecs trans translation translationvector"},
    PartNames{OpenCvPart::Pose, "rt extrinsic extrinsics extrinsicmatrix extrinsicsmatrix extrinsicparameters "
                                "extrinsiccv w2c world2cam worldtocam worldtocamera tcw c2w cam2world cam2worldgl "
                                "camtoworld cameratoworld twc pose camerapose campose"},
    PartNames{OpenCvPart::CameraMatrix, "p projectionmatrix projmatrix"},
    PartNames{OpenCvPart::Distortion, "d dist distcoeffs distcoeff distcoefs coeffs distortion distortioncoeffs "
                                      "distortioncoefficients"},
    PartNames{OpenCvPart::Size, "size imagesize imgsize resolution"},
    PartNames{OpenCvPart::Model, "distortionmodel cameramodel model"},
};

/// Members of a matrix in cv::FileStorage and in ROS's files.
constexpr std::array<std::string_view, 6> kMembers{"typeid", "rows", "cols", "dt", "data", "dims"};

std::optional<OpenCvPart> partOf(const NamedValue &value)
{
    for (const auto &[part, names] : kNames) {
        base::TextScanner scanner(names);
        for (std::string_view name = scanner.nextWord(); !name.empty(); name = scanner.nextWord()) {
            if (value.isNamed(name))
                return part;
        }
    }
    return std::nullopt;
}

bool fits(OpenCvPart part, std::size_t count)
{
    switch (part) {
    case OpenCvPart::Intrinsics: return count == 9 || count == 4;
    case OpenCvPart::Rotation: return count == 9 || count == 3;
    case OpenCvPart::Quaternion: return false; // of a list, either end may be w
    case OpenCvPart::Translation: return count == 3;
    case OpenCvPart::Pose: return count == 12 || count == 16;
    case OpenCvPart::CameraMatrix: return count == 12;
    case OpenCvPart::Distortion: return count >= 1;
    case OpenCvPart::Size: return count == 2;
    case OpenCvPart::Model: return true;
    }
    return false;
}

/// The name as in the text, without its object's: "cameraMatrix" of "calib.cameraMatrix".
std::string nameOf(const NamedValue &value)
{
    return value.written.substr(value.written.find_last_of(".>") + 1);
}

} // namespace

OpenCvValues::OpenCvValues(std::span<const NamedText> texts)
{
    for (const NamedText &text : texts) {
        struct Owned {
            OpenCvValue value;
            std::optional<OpenCvPart> part;
            std::size_t columns = 0;
        };
        std::vector<Owned> values;
        const NamedValues named(withNames(text.text));
        for (const NamedValue &value : named.all()) {
            const auto member = std::find_if(kMembers.begin(), kMembers.end(),
                                             [&](std::string_view name) { return value.isNamed(name); });
            if (member != kMembers.end() && !values.empty()) {
                if (*member == "data")
                    values.back().value.numbers = value.numbers;
                else if (*member == "cols" && value.numbers.size() == 1)
                    values.back().columns = value.numbers[0] == 6.0 ? 6 : 0;
                continue;
            }
            if (value.numbers.size() == 1)
                m_numbers.push_back(value);
            values.push_back({{nameOf(value), value.word, value.numbers, value.line, text.name, value.arithmetic},
                              partOf(value),
                              0});
        }
        addComponents(named, text.name);
        for (Owned &owned : values) {
            OpenCvValue &value = owned.value;
            if (owned.part == OpenCvPart::Pose && owned.columns == 6 && value.numbers.size() % 6 == 0) {
                addPoses(std::move(value));
                continue;
            }
            if (owned.part)
                add(*owned.part, value);
        }
    }
    // Both ROS's messages and its calibration files have a model, K and P; R is then the
    // rectification.
    m_isCameraInfo = !all(OpenCvPart::Model).empty() && !all(OpenCvPart::CameraMatrix).empty()
                     && !all(OpenCvPart::Intrinsics).empty();
}

void OpenCvValues::add(OpenCvPart part, OpenCvValue value)
{
    const bool isWord = part == OpenCvPart::Model;
    if (isWord ? value.word.empty() : value.numbers.empty())
        return;
    if (part == OpenCvPart::Rotation && value.numbers.size() == 4)
        part = OpenCvPart::Quaternion;
    if (part == OpenCvPart::Quaternion && value.numbers.size() != 4)
        return;
    std::vector<OpenCvValue> &values = m_parts[std::size_t(part)];
    // The vectors of several images: rvecs, tvecs.
    const std::size_t count = value.numbers.size();
    const bool isVectors = (part == OpenCvPart::Rotation || part == OpenCvPart::Translation) && count > 3
                           && count % 3 == 0 && (count != 9 || value.name.ends_with("vecs"));
    if (isVectors) {
        const std::vector<double> numbers = std::move(value.numbers);
        for (std::size_t i = 0; i + 3 <= count; i += 3) {
            value.numbers = {numbers[i], numbers[i + 1], numbers[i + 2]};
            values.push_back(value);
        }
    } else if (part == OpenCvPart::Translation && fits(OpenCvPart::Pose, count)) {
        m_parts[std::size_t(OpenCvPart::Pose)].push_back(std::move(value)); // T = [R t; 0 0 0 1]
    } else if (fits(part, count)) {
        values.push_back(std::move(value));
    } else if (!m_unfit[std::size_t(part)]) {
        m_unfit[std::size_t(part)] = std::move(value);
    }
}

/// Adds the poses of a table with a rotation vector and t in each row.
void OpenCvValues::addPoses(OpenCvValue value)
{
    const std::vector<double> numbers = std::move(value.numbers);
    for (std::size_t i = 0; i + 6 <= numbers.size(); i += 6) {
        value.numbers = {numbers[i], numbers[i + 1], numbers[i + 2]};
        value.name = "rvec";
        m_parts[std::size_t(OpenCvPart::Rotation)].push_back(value);
        value.numbers = {numbers[i + 3], numbers[i + 4], numbers[i + 5]};
        value.name = "tvec";
        m_parts[std::size_t(OpenCvPart::Translation)].push_back(value);
    }
}

/// Adds ROS's transforms and poses: "translation: {x: 1, y: 2, z: 3}",
/// "orientation: {x: 0, y: 0, z: 0, w: 1}".
void OpenCvValues::addComponents(const NamedValues &named, const std::string &file)
{
    const std::vector<NamedValue> &values = named.all();
    const auto addOf = [&](OpenCvPart part, std::span<const std::string_view> names,
                           std::span<const std::string_view> components) {
        for (std::size_t i = 0; i + components.size() <= values.size(); ++i) {
            const std::string &parent = values[i].parent;
            if (std::find(names.begin(), names.end(), parent) == names.end())
                continue;
            std::vector<double> numbers;
            for (const std::string_view component : components) {
                for (std::size_t k = i; k < i + components.size(); ++k) {
                    if (values[k].parent == parent && values[k].isNamed(component) && values[k].numbers.size() == 1)
                        numbers.push_back(values[k].numbers[0]);
                }
            }
            if (numbers.size() != components.size())
                continue;
            m_parts[std::size_t(part)].push_back({parent, {}, std::move(numbers), values[i].line, file});
            i += components.size() - 1;
        }
    };
    static constexpr std::array<std::string_view, 3> kTurns{"rotation", "orientation", "quaternion"};
    static constexpr std::array<std::string_view, 3> kShifts{"translation", "t", "position"};
    static constexpr std::array<std::string_view, 4> kXyzw{"x", "y", "z", "w"};
    const std::size_t before = all(OpenCvPart::Quaternion).size();
    addOf(OpenCvPart::Quaternion, kTurns, kXyzw);
    // A position alone may be another thing's.
    const bool isPose = all(OpenCvPart::Quaternion).size() > before;
    addOf(OpenCvPart::Translation, std::span(kShifts).first(isPose ? 3 : 2), std::span(kXyzw).first(3));
}

std::optional<double> OpenCvValues::number(std::initializer_list<std::string_view> names) const
{
    for (const std::string_view name : names) {
        if (const NamedValue *value = find(name))
            return value->numbers[0];
    }
    return std::nullopt;
}

const NamedValue *OpenCvValues::find(std::string_view name) const
{
    const auto found = std::find_if(m_numbers.begin(), m_numbers.end(),
                                    [name](const NamedValue &value) { return value.isNamed(name); });
    return found == m_numbers.end() ? nullptr : &*found;
}

bool OpenCvValues::differ(std::string_view name) const
{
    const NamedValue *first = find(name);
    return std::any_of(m_numbers.begin(), m_numbers.end(),
                       [&](const NamedValue &value) { return value.isNamed(name) && value.numbers != first->numbers; });
}

} // namespace unprojector::cameras
