#include "core/cameras/camera_values.h"

#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/node.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace unprojector::cameras {
using base::isListed;
using base::tr;
namespace {

/// Members of a matrix in cv::FileStorage and in ROS's files.
constexpr std::string_view kMembers = " typeid rows cols dt data dims ";

/// Numbers that are read one by one.
constexpr std::string_view kScalars =
    " fx fy flx fly cx cy x0 y0 u0 v0 ppx ppy focallengthx focallengthy principalpointx principalpointy "
    "width height w h k1 k2 k3 p1 p2 skew znear zfar ";

/// Other names of such numbers.
constexpr std::string_view kOtherScalars =
    " imgw imgh f focal focallength focallengthpx focallengthpixels focalx focaly alphac gamma s imagewidth imgwidth "
    "imageheight "
    "imgheight near nearplane nearclip nearclipplane far farplane farclip farclipplane binningx xoffset yoffset x y z "
    "tx ty tz ";

/// Returns whether the last words of a name are in a list.
bool isScalar(const NamedValue &value, std::string_view list = kScalars)
{
    std::string name;
    return std::any_of(value.words.rbegin(), value.words.rend(),
                       [&](const std::string &word) { return isListed(list, name = word + name); });
}

/// Returns whether a number may be a camera's; a text may have many others.
bool mayBeOfCamera(const CameraValue &value, const std::string &name)
{
    return isScalar(value) || isScalar(value, kOtherScalars) || name.find("fov") != name.npos
           || name.find("fieldofview") != name.npos || isScalarOfPart(value.name) || isAngle(value.name);
}

/// Names of a camera's id, and of a reference to it.
constexpr std::string_view kReferences = " cameraid camid intrinsicid intrinsicsid sensorid cameraindex ";

/// "fx fy cx cy" above four numbers: as many names of numbers as numbers.
std::vector<NamedValue> columnsOf(const NamedValue &value)
{
    std::vector<NamedValue> columns;
    const std::size_t count = value.numbers.size(), words = value.words.size();
    for (std::size_t i = 0; count > 1 && count <= words && i < count; ++i) {
        const std::string &name = value.words[words - count + i];
        NamedValue &column = columns.emplace_back(
            NamedValue{{name}, name, value.parent, {}, {value.numbers[i]}, value.line, value.at, value.arithmetic});
        column.unit = value.unit;
        if (!isScalar(column))
            return {};
    }
    return columns;
}

bool fits(Part part, std::size_t count)
{
    // by part; of a list of a quaternion, either end may be w: see add()
    constexpr std::array<std::string_view, kParts> kCounts{" 4 9 ",   " 2 ",  " 2 ", " 3 9 ", "",    " 3 ", " 3 ",
                                                           " 12 16 ", " 12 ", "any", " 2 3 ", " 2 ", " 2 ", "any"};
    const std::string_view counts = kCounts[std::size_t(part)];
    return counts == "any" || isListed(counts, std::to_string(count));
}

/// Returns whether a word is a lens that is no pinhole.
bool isLens(const std::string &word)
{
    constexpr std::string_view kLenses =
        " ds eucm ucm kb kb4 kb8 mei omni omnidirectional fisheye equidistant equi kannalabrandt kannalabrandt8 "
        "doublesphere scaramuzza fov atan equirectangular spherical panorama panoramic cylindrical ";
    return isListed(kLenses, plain(word));
}

/// The role of a value by its name, else by the last word of its name: in "estimated t", only that
/// says a part.
std::optional<Role> roleOf(const CameraValue &value)
{
    const std::string_view name = value.name;
    const std::size_t count = value.numbers.size(), blank = name.find_last_of(" \t");
    auto role = cameras::roleOf(name, count);
    if (blank == name.npos || (role && role->direction))
        return role;
    auto last = cameras::roleOf(name.substr(blank + 1), count);
    constexpr std::array kWFirst{"Quaterniond ", "Quaternionf ", "dquat "}; // of Eigen and GLM
    if (last && std::ranges::any_of(kWFirst, [name](const char *type) { return name.find(type) != name.npos; }))
        last->w = 0;
    return last && (!role || last->direction) ? last : role;
}

/// Returns whether numbers whose name says no part may be one.
bool mayBePart(const CameraValue &value)
{
    const std::size_t count = value.numbers.size();
    constexpr std::size_t kFewest = 4, kMost = 16; // of a camera's parts
    return value.name.empty() || (count >= kFewest && count <= kMost) || (count > 1 && hasPartWord(value.name));
}

/// The text behind a value's name, to the end of the line.
std::string_view behind(std::string_view text, const CameraValue &value, std::size_t longest)
{
    const std::string_view rest = text.substr(std::min(value.at + value.written.size(), text.size()), longest);
    return rest.substr(0, rest.find('\n'));
}

/// Returns whether something stands behind a name and its sign, in its line.
bool isGiven(std::string_view text, const CameraValue &value)
{
    const std::string_view rest = base::trimmed(behind(text, value, 200));
    return (rest.starts_with('=') || rest.starts_with(':')) && rest.find_first_of("([{") != rest.npos
           && rest.find_first_not_of(":= \t\"'{") != rest.npos && !rest.ends_with('{') && !rest.ends_with('[');
}

/// Returns whether source code changes a part behind its name: K[0, 0] = 600, t *= 0.001, R = R.T.
bool isChange(std::string_view text, const CameraValue &value)
{
    const std::string_view rest = behind(text, value, 40);
    const bool isIndexed = rest.starts_with('[') || rest.starts_with('(');
    const std::size_t close = isIndexed ? base::closingBracket(rest, 0) : 0;
    if (close == rest.npos || value.written.empty())
        return false;
    const std::string_view sign = base::trimmed(rest.substr(isIndexed ? close + 1 : 0));
    const bool isAssigned = sign.starts_with('=') && !sign.starts_with("==");
    const std::string_view inside = rest.substr(0, close), given = base::trimmed(sign.substr(isAssigned ? 1 : 0));
    const bool isArray = !given.empty() && std::string_view("{[(").find(given.front()) != given.npos; // K[9] = {600, …
    const bool isEntry =
        isIndexed && isAssigned
        && (inside.find(':') != inside.npos
            || (!isArray && value.numbers.size() < 2 && inside.find_first_of("0123456789") != inside.npos));
    const bool isComputed = isListed(" *= /= += -= ", sign.substr(0, 2))
                            || (!isIndexed && isAssigned && value.numbers.empty()
                                && (given.starts_with(value.name + '.') || given.starts_with('-')));
    return (isEntry || isComputed) && std::ranges::any_of(std::array<std::size_t, 3>{3, 9, 16}, [&](std::size_t count) {
               return cameras::roleOf(value.name, count).has_value();
           });
}

/// Returns whether a number of a camera has no number, or several.
bool isBroken(const CameraValue &value)
{
    constexpr std::string_view kOne = " fx fy cx cy k1 k2 k3 skew ", kOthers = " p1 p2 tx ty tz qx qy qz qw ",
                               kNone = " null none undefined na nan ";
    const std::string name = value.name.substr(value.name.find_last_of(" \t") + 1); // K_3 is a matrix
    return value.numbers.size() != 1 && value.decimal.empty() && !isListed(kNone, plain(value.word))
           && (isListed(kOne, name) || (value.numbers.empty() && isListed(kOthers, name)));
}

/// The name of a file without its folder and suffix.
std::string stemOf(const std::string &path)
{
    const std::string name = path.substr(path.find_last_of("/\\") + 1);
    return name.substr(0, name.rfind('.'));
}

/// The nine numbers of K in a matrix of 3 x 4 or 4 x 4; other numbers unchanged.
std::vector<double> withoutBorder(const std::vector<double> &k)
{
    if (k.size() != 12 && k.size() != 16)
        return k;
    std::vector<double> inner;
    for (std::size_t i = 0; i < k.size(); ++i) {
        const std::size_t row = i / 4, column = i % 4;
        if (row < 3 && column < 3)
            inner.push_back(k[i]);
        else if (k[i] != (row == column ? 1.0 : 0.0))
            return k;
    }
    return inner;
}

} // namespace

base::Error CameraValue::error(std::string reason) const
{
    return {std::move(reason), name, file, static_cast<int>(line)};
}

CameraValues::CameraValues(std::span<const NamedText> texts)
{
    for (const NamedText &text : texts)
        addText(text);
    takeLensByForm();
    findCameras();
    if (m_cameras.empty())
        dropElsewhere();
}

void CameraValues::addText(const NamedText &text)
{
    const NamedValues named(text.text);
    m_files.push_back(text.name);
    m_ends.push_back(0);
    m_outlines.emplace_back(text.text);
    m_isXml = isXml(text.text);
    m_isOst = m_isOst || text.text.starts_with("# oST version");
    std::vector<CameraValue> values;
    std::map<std::pair<std::size_t, std::string>, CameraValue> keys; // of parts: their objects and names
    for (const NamedValue &value : named.all()) {
        if (!value.numbers.empty())
            m_ends.back() = value.at;
        if (!values.empty() && isListed(kMembers, value.words.back())) {
            addMember(values.back(), value);
            continue;
        }
        if (const std::vector<NamedValue> columns = columnsOf(value); !columns.empty()) {
            for (const NamedValue &column : columns)
                of(Part::Number).push_back(valueOf(column));
            continue;
        }
        CameraValue added = valueOf(value);
        const bool isGivenBefore = !added.numbers.empty() || std::ranges::any_of(values, [&](const CameraValue &one) {
            return one.name == added.name && !one.numbers.empty();
        });
        if (!m_changed && isGivenBefore && isChange(text.text, added))
            m_changed = added.error(tr("the text changes it here; give its final numbers at once"));
        addNumber(added);
        if (const auto role = added.numbers.empty() ? cameras::roleOf(added.name, 9) : std::nullopt;
            role && isGiven(text.text, added))
            of(Part::Empty).emplace_back(added).role = *role;
        const std::size_t count = added.numbers.size();
        const bool isAside = (count == 1 && added.numbers[0] != 1.0) // a Part::Number; but 1 may be "true"
                             || (count > 1 && !mayBePart(added));
        const bool isPart = isScalar(added) || roleOf(added);
        if (isPart && value.at > 0 && text.text[value.at - 1] == '"' && count > 0) {
            const auto &[first, isNew] = keys.try_emplace({added.node, added.written}, added);
            if (!isNew && first->second.numbers != added.numbers)
                setTwice(added, first->second.line);
        }
        if (!values.empty() && values.back().numbers.empty() && values.back().word.empty() && !values.back().isMatrix)
            values.pop_back(); // a heading
        if (isBroken(added))
            of(Part::Broken).push_back(added);
        if (isPart || !isAside)
            values.push_back(std::move(added));
    }
    addComponents(named);
    for (CameraValue &value : values) {
        const std::optional<Role> role = roleOf(value);
        if (value.isMatrix && value.numbers.empty() && role)
            of(Part::Broken).push_back(value);
        if (role && role->part == Part::Pose && value.isTable && value.numbers.size() % 6 == 0) {
            value.name = "rvec"; // a table with a rotation vector and t in each row
            addEach(Part::Rotation, value, 3, 0, 6);
            value.name = "tvec";
            addEach(Part::Translation, value, 3, 3, 6);
        } else if (value.name.empty()) {
            addUnnamed(std::move(value));
        } else {
            add(std::move(value));
        }
    }
}

/// Sets what a member of a matrix tells: "rows: 3", "data: [600, …]".
void CameraValues::addMember(CameraValue &owner, const NamedValue &member)
{
    const std::string &name = member.words.back();
    if (name == "data") {
        if (!owner.numbers.empty() && owner.numbers != member.numbers)
            setTwice(valueOf(member), owner.line);
        owner.numbers = member.numbers;
        owner.arithmetic = member.arithmetic;
        owner.unit = member.unit;
    }
    owner.isMatrix = owner.isMatrix || ((name == "rows" || name == "cols") && member.numbers != std::vector{0.0});
    if (name == "cols" && member.numbers.size() == 1)
        owner.isTable = member.numbers[0] == 6.0;
}

void CameraValues::setTwice(const CameraValue &again, std::size_t firstLine)
{
    m_twice = again.error(tr("it stands in one object twice, in lines %1 and %2, with other numbers; leave one out",
                             firstLine, again.line));
}

/// Notes a value of one number, or of one that may have a decimal comma, and an id.
void CameraValues::addNumber(const CameraValue &value)
{
    const std::string name = plain(value.name);
    std::string own = name; // "fx" of "cam_fx"
    for (const std::string_view prefix : {"camera", "cam"}) {
        if (name.starts_with(prefix) && isListed(kScalars, name.substr(prefix.size())))
            own = name.substr(prefix.size());
    }
    const bool isOne = value.numbers.size() == 1;
    if ((isOne && (own != name || mayBeOfCamera(value, name))) || (!value.decimal.empty() && isScalar(value))) {
        CameraValue &added = of(Part::Number).emplace_back(value);
        if (own != name)
            added.words = {own};
    }
    if (value.node > 0 && (name == "id" || isListed(kReferences, name)) && (isOne || !value.word.empty()))
        (name == "id" ? m_ids : m_references)
            .try_emplace({value.text, value.node},
                         value.word.empty() ? base::shortestText(value.numbers[0]) : value.word);
}

/// A value of the last text.
CameraValue CameraValues::valueOf(const NamedValue &named) const
{
    const std::size_t text = m_files.size() - 1;
    return {named,
            {text, m_outlines[text].nodeAt(named.at)},
            named.written.substr(named.written.find_last_of(".>") + 1),
            m_files[text]};
}

/// Takes the only matrix with the form of a K and a name that says nothing as one: "matrix" beside "distortion".
void CameraValues::takeLensByForm()
{
    using enum Part;
    std::vector<CameraValue> &others = of(Other);
    const auto isLens = [](const CameraValue &value) {
        constexpr double kLeast = 10.0; // of a focal length, in pixels
        constexpr std::string_view kNames = " matrix mat calibration calib cameracalibration cam camera ";
        const std::vector<double> &k = value.numbers;
        return k.size() == 9 && isListed(kNames, plain(value.name)) && k[0] > kLeast && k[4] > kLeast && k[2] > 0.0
               && k[5] > 0.0 && k[3] == 0.0 && k[6] == 0.0 && k[7] == 0.0 && k[8] == 1.0;
    };
    if (all(Intrinsics).empty() && all(CameraMatrix).empty() && std::ranges::count_if(others, isLens) == 1) {
        const auto found = std::ranges::find_if(others, isLens);
        of(Intrinsics).push_back(*found);
        of(Intrinsics).back().role.part = Intrinsics;
        others.erase(found);
    }
}

/// ROS's messages and its calibration files have a model, K and P; R is then the rectification.
/// Without the model, P = K' [1 t'] and R without t are the same.
bool CameraValues::isCameraInfo() const
{
    using enum Part;
    if (all(CameraMatrix).empty() || all(Intrinsics).empty())
        return false;
    const std::vector<double> &p = all(CameraMatrix).front().numbers;
    const bool isUpper = p[1] == 0.0 && p[4] == 0.0 && p[8] == 0.0 && p[9] == 0.0;
    return !all(Model).empty() || m_isOst
           || (isUpper && !all(Rotation).empty() && all(Translation).empty() && all(Center).empty());
}

/// Sets the direction that the name around R or t states: "T_cam_imu: {R: …, t: …}".
/// @return false for a part of a transform between two cameras: "depth_to_color: {rotation: …}"
bool CameraValues::setDirectionAround(CameraValue &value) const
{
    using enum Part;
    const Part part = value.role.part;
    if (part != Rotation && part != Quaternion && part != Translation)
        return true;
    for (const std::string &section : sectionsOf(value)) {
        if (isBetweenCameras(section))
            return false;
        const std::optional<Role> around = cameras::roleOf(section, 16);
        if (around && around->part == Pose && around->direction && !value.role.isDirectionStated) {
            const std::size_t w = value.role.w;
            value.role = *around;
            value.role.part = part;
            value.role.w = w;
        }
    }
    return true;
}

void CameraValues::add(CameraValue value)
{
    using enum Part;
    const std::string plainName = plain(value.name);
    const bool isFlag = isListed(" true yes on ", plain(value.word)) || value.numbers == std::vector{1.0};
    if (isFlag && plainName.find("fisheye") != plainName.npos)
        value.word = "fisheye";
    const bool isProjection = plainName.find("projection") != plainName.npos || plainName == "lens";
    if (isLens(value.word) && (isFlag || isProjection || value.word == "fisheye"))
        return of(Model).push_back(std::move(value));
    const std::size_t count = value.numbers.size();
    if (count > 3 && (plainName.ends_with("brownconrady") || isLens(value.name))) { // RealSense's print
        value.word = value.name;
        of(Model).push_back(value);
        return of(Distortion).push_back(std::move(value));
    }
    const std::optional<Role> role = roleOf(value);
    if (!role) {
        if (!mayBePart(value))
            return;
        return of(Other).push_back(std::move(value));
    }
    value.role = *role;
    const Part part = role->part;
    value.camera = cameras::cameraOf(value.name);
    const bool isNone =
        value.word.empty() || (value.name.ends_with("type") && !isLens(value.word)); // "camera_type": "rgb"
    if (part == Model ? isNone : value.numbers.empty())
        return;
    constexpr std::size_t kOfK = 9;
    if (part == Intrinsics && (count == kOfK + 12 || count == kOfK + 16) && value.numbers[8] == 1.0) {
        CameraValue behind = value;
        behind.numbers.erase(behind.numbers.begin(), behind.numbers.begin() + kOfK);
        behind.name = tr("the matrix without a name");
        of(Other).push_back(std::move(behind));
        value.numbers.resize(kOfK);
    }
    if (part == Intrinsics)
        value.numbers = withoutBorder(value.numbers);
    if ((part == Quaternion && count != 4) || !setDirectionAround(value))
        return of(Other).push_back(std::move(value));
    if (part == Quaternion && role->w < 4) {
        if (role->w == 0)
            std::rotate(value.numbers.begin(), value.numbers.begin() + 1, value.numbers.end());
        return of(part).push_back(std::move(value));
    }
    // The vectors of several images: rvecs, tvecs.
    const bool isVectors = (part == Rotation || part == Translation) && count > 3 && count % 3 == 0
                           && value.name.find("vec") != value.name.npos && (count != 9 || value.name.ends_with("vecs"));
    if (isVectors) {
        addEach(part, value, 3);
    } else if (fits(part, value.numbers.size())) {
        of(part).push_back(std::move(value));
    } else {
        of(unfit(part) ? Other : Unfit).push_back(std::move(value));
    }
}

/// Adds the numbers of a text without names: the file's name stands for theirs. Several matrices are
/// the poses of several images.
void CameraValues::addUnnamed(CameraValue value)
{
    using enum Part;
    const std::size_t count = value.numbers.size();
    bool are16 = count % 16 == 0; // several have the last row 0 0 0 1
    for (std::size_t i = 0; i < count && are16 && count > 16; ++i)
        are16 = i % 16 < 12 || value.numbers[i] == (i % 16 == 15 ? 1.0 : 0.0);
    const std::size_t entries = are16 ? 16 : 12;
    if (count == 7 || count == 8) { // t and a quaternion, behind a time
        value.name = tr("the numbers without a name");
        return of(Other).push_back(std::move(value));
    }
    if (count < 9 || (count != 9 && count % entries != 0))
        return;
    value.name = stemOf(value.file);
    const std::optional<Role> role = cameras::roleOf(value.name, std::min(count, entries));
    if (role && role->part == Intrinsics)
        return add(std::move(value));
    if (count == 9)
        return;
    value.role = role && role->part == Pose ? *role : Role{};
    addEach(Pose, value, entries);
}

/// Adds the parts that stand in one list.
/// @param step  from one to the next; 0: the count
void CameraValues::addEach(Part part, CameraValue value, std::size_t count, std::size_t first, std::size_t step)
{
    const std::vector<double> numbers = std::move(value.numbers);
    for (std::size_t i = first; i + count <= numbers.size(); i += step > 0 ? step : count) {
        const auto at = numbers.begin() + std::ptrdiff_t(i);
        value.numbers.assign(at, at + std::ptrdiff_t(count));
        of(part).push_back(value);
    }
}

/// Adds vectors and quaternions whose components have names: ROS's "translation: {x: 1, y: 2, z: 3}",
/// "orientation: {x: 0, y: 0, z: 0, w: 1}"; and tx, ty, tz, qx, qy, qz, qw.
void CameraValues::addComponents(const NamedValues &named)
{
    using enum Part;
    const std::vector<NamedValue> &values = named.all();
    struct Component {
        std::string prefix, parent; ///< "q" of qx, or "orientation" above x
        std::size_t node, axis;     ///< the axis 0 to 3: x, y, z, w
        bool isBeside(const Component &other) const
        {
            return prefix == other.prefix && parent == other.parent && node == other.node;
        }
    };
    const auto componentOf = [&](const NamedValue &value) -> std::optional<Component> {
        const std::string &word = value.words.back();
        const bool hasPrefix = word.size() == 2 && (word[0] == 'q' || word[0] == 't');
        const std::size_t axis = word.size() == (hasPrefix ? 2 : 1) ? std::string_view("xyzw").find(word.back()) : 4;
        if (value.numbers.size() != 1 || axis > 3)
            return std::nullopt;
        const Outline &outline = m_outlines.back();
        const std::size_t node = outline.nodeAt(value.at);
        return Component{word.substr(0, hasPrefix ? 1 : 0), hasPrefix ? "" : value.parent,
                         m_isXml ? outline.node(node).parent : node, axis};
    };
    std::vector<std::optional<Component>> components;
    std::ranges::transform(values, std::back_inserter(components), componentOf);
    // Alone, tx, ty and tz may be another thing's.
    const bool hasTurn = std::ranges::any_of(values, [](const NamedValue &value) {
        const auto role = cameras::roleOf(value.written, value.numbers.size());
        return value.words.back() == "qw" || (role && (role->part == Rotation || role->part == Quaternion));
    });
    const bool hasWhole = std::ranges::any_of(values, [](const NamedValue &value) { // t itself
        const auto role = value.numbers.size() == 3 ? cameras::roleOf(value.written, 3) : std::nullopt;
        return role && role->part == Translation;
    });
    std::vector<CameraValue> found;
    std::vector<bool> isTaken(values.size());
    std::set<std::size_t> read; // places in the text
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!components[i])
            continue;
        const std::string &prefix = components[i]->prefix;
        constexpr std::size_t kMost = 16; // lines between qx and qw
        std::vector<std::size_t> places;
        std::set<std::size_t> axes;
        for (std::size_t k = i; k < std::min(i + kMost, values.size()); ++k) {
            const auto &next = components[k];
            const bool isNext = next && !isTaken[k] && next->isBeside(*components[i]) && axes.insert(next->axis).second;
            if (isNext)
                places.push_back(k);
            else if (prefix.empty())
                break;
        }
        const std::size_t count = places.size();
        if (count < 3 || axes.contains(3) != (count == 4) || (prefix == "t" && (!hasTurn || hasWhole)))
            continue;
        const auto role = prefix.empty() ? cameras::roleOf(values[i].parent, count)
                                         : std::optional(Role{count == 4 ? Quaternion : Translation});
        for (const std::size_t k : places)
            isTaken[k] = true;
        if (!role || (prefix == "q" && count == 3))
            continue;
        CameraValue &added = found.emplace_back(valueOf(values[i]));
        added.name = prefix.empty() ? values[i].parent : values[i].written;
        added.role = *role;
        added.numbers.assign(count, 0.0);
        for (const std::size_t k : places) {
            added.numbers[components[k]->axis] = values[k].numbers[0];
            added.arithmetic += values[k].arithmetic;
            if (!isListed(' ' + added.unit + ' ', values[k].unit))
                added.unit += (added.unit.empty() ? "" : " ") + values[k].unit;
            if (!prefix.empty())
                read.insert(values[k].at);
        }
    }
    std::erase_if(of(Number), [&](const CameraValue &number) {
        return number.text + 1 == m_files.size() && read.contains(number.at);
    });
    const auto isTurn = [](const CameraValue &value) {
        return value.role.part == Quaternion && value.numbers.size() == 4;
    };
    // A position beside a quaternion is a pose; alone, it may be another thing's.
    const bool isPose = std::ranges::any_of(found, isTurn);
    for (CameraValue &value : found) {
        if (isPose && value.role.part == Center)
            value.role = {Translation};
        const bool isShift = value.numbers.size() == 3 && (value.role.part == Translation || value.role.part == Center);
        const bool isRead = (isTurn(value) || isShift) && setDirectionAround(value);
        of(isRead ? value.role.part : Other).push_back(std::move(value));
    }
}

const CameraValue *CameraValues::unfit(Part part) const
{
    const auto found = std::ranges::find(all(Part::Unfit), part, [](const CameraValue &one) { return one.role.part; });
    return found == all(Part::Unfit).end() ? nullptr : &*found;
}

const CameraValue *CameraValues::find(std::string_view names) const
{
    base::TextScanner scanner(names);
    for (std::string_view name = scanner.nextWord(); !name.empty(); name = scanner.nextWord()) {
        for (const CameraValue &number : all(Part::Number)) {
            if (number.isNamed(name))
                return &number;
        }
    }
    return nullptr;
}

const CameraValue *CameraValues::coefficient(std::string_view name) const
{
    const CameraValue *exact = find(name);
    for (const CameraValue &number : all(Part::Number)) {
        if (!exact && coefficientOf(number.name) == name)
            return &number;
    }
    return exact;
}

const CameraValue *CameraValues::lastPart(std::size_t text) const
{
    for (std::size_t kind = 0; kind <= std::size_t(Part::Number); ++kind) {
        for (const CameraValue &value : m_parts[kind]) {
            if (value.text == text && value.at == m_ends[text])
                return kind < kParts || isScalar(value) ? &value : nullptr;
        }
    }
    return nullptr;
}

bool CameraValues::differs(const CameraValue &value) const
{
    return std::ranges::any_of(all(Part::Number), [&](const CameraValue &number) {
        return number.words == value.words && number.numbers != value.numbers;
    });
}

bool CameraValues::hasAny(const std::string &file) const
{
    for (std::size_t kind = 0; kind <= std::size_t(Part::Number); ++kind) {
        if (std::ranges::any_of(m_parts[kind], [&](const CameraValue &value) {
                return value.file == file && (kind < kParts || isScalar(value));
            }))
            return true;
    }
    return false;
}

} // namespace unprojector::cameras
