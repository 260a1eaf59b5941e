#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

// cameras.txt: CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]
// images.txt:  IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then a line of 2-D points
// Source: COLMAP's documentation, "Output Format".

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

struct Model {
    std::string_view name;
    std::size_t parameters;
};
constexpr std::array<Model, 6> kRead{
    {{"SIMPLE_PINHOLE", 3}, {"PINHOLE", 4}, {"SIMPLE_RADIAL", 4}, {"RADIAL", 5}, {"OPENCV", 8}, {"FULL_OPENCV", 12}}};
constexpr std::array<std::string_view, 9> kNotRead{"OPENCV_FISHEYE",        "FOV",
                                                   "SIMPLE_RADIAL_FISHEYE", "RADIAL_FISHEYE",
                                                   "THIN_PRISM_FISHEYE",    "RAD_TAN_THIN_PRISM_FISHEYE",
                                                   "SIMPLE_DIVISION",       "DIVISION",
                                                   "SIMPLE_FISHEYE"};

struct Line {
    std::size_t number; ///< from 1
    std::vector<std::string_view> words;
    std::string_view text;
};

/// The lines of a text. Comments are left out; blank lines stay, because an image without 2-D
/// points has one.
std::vector<Line> linesOf(std::string_view text)
{
    std::vector<Line> lines;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        Line line{++number, {}, text.substr(at, end - at)};
        at = end + 1;
        if (line.text.ends_with('\r'))
            line.text.remove_suffix(1);
        base::TextScanner scanner(line.text);
        constexpr std::size_t kMost = 24; // a line of 2-D points has thousands, which are not read
        for (std::string_view word = scanner.nextWord(); !word.empty() && line.words.size() < kMost;
             word = scanner.nextWord())
            line.words.push_back(word);
        if (line.words.empty() || !line.words.front().starts_with('#'))
            lines.push_back(std::move(line));
    }
    return lines;
}

bool isModel(std::string_view word)
{
    return std::any_of(kRead.begin(), kRead.end(), [word](const Model &model) { return model.name == word; })
           || std::find(kNotRead.begin(), kNotRead.end(), word) != kNotRead.end();
}

bool isCameraLine(const Line &line)
{
    return line.words.size() >= 5 && base::integerFromWord(line.words[0]) && isModel(line.words[1])
           && base::integerFromWord(line.words[2]) && base::integerFromWord(line.words[3]);
}

/// Returns whether a line is of 2-D points: triples of numbers.
bool isPointsLine(const Line &line)
{
    return line.words.size() % 3 == 0 && std::all_of(line.words.begin(), line.words.end(), [](std::string_view word) {
               return base::doubleFromWord(word).has_value();
           });
}

/// The quaternion and translation of an image's line. Words that are no numbers become NaN.
std::array<double, 7> poseIn(const Line &line)
{
    std::array<double, 7> pose{};
    for (std::size_t i = 0; i < pose.size(); ++i)
        pose[i] = base::doubleFromWord(line.words[i + 1]).value_or(std::numeric_limits<double>::quiet_NaN());
    return pose;
}

double quaternionLength(const std::array<double, 7> &pose)
{
    return std::sqrt(pose[0] * pose[0] + pose[1] * pose[1] + pose[2] * pose[2] + pose[3] * pose[3]);
}

/// How far a quaternion printed with few digits may be from the length 1.
constexpr double kUnit = 5e-3;

/// Returns whether a line has an image's form. Its quaternion may be damaged.
bool isImageLine(const Line &line)
{
    return line.words.size() >= 10 && base::integerFromWord(line.words[0]) && base::integerFromWord(line.words[8])
           && !isPointsLine(line);
}

/// Returns whether a line is an image's without doubt: a table of numbers is none.
bool isWholeImageLine(const Line &line)
{
    return isImageLine(line) && std::abs(quaternionLength(poseIn(line)) - 1.0) < kUnit;
}

/// A camera or an image: its line and the file that has it.
struct Found {
    const NamedText *file;
    Line line;
};

/// The cameras by their ids, and the images in their order.
struct Reconstruction {
    std::map<long long, Found> cameras;
    std::vector<Found> images;
    bool hasWholeImage = false;
};

Reconstruction reconstructionOf(std::span<const NamedText> texts)
{
    Reconstruction found;
    for (const NamedText &file : texts) {
        const std::vector<Line> lines = linesOf(file.text);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Line &line = lines[i];
            if (isCameraLine(line)) {
                found.cameras.emplace(*base::integerFromWord(line.words[0]), Found{&file, line});
            } else if (isImageLine(line)) {
                found.images.push_back({&file, line});
                found.hasWholeImage = found.hasWholeImage || isWholeImageLine(line);
                const bool hasPoints =
                    i + 1 < lines.size() && !isImageLine(lines[i + 1]) && !isCameraLine(lines[i + 1]);
                i += hasPoints ? 1 : 0; // the line of its points
            }
        }
    }
    if (found.cameras.empty() && !found.hasWholeImage)
        found.images.clear();
    return found;
}

/// An image's name: the rest of the line, which may contain blanks.
std::string nameIn(const Line &line)
{
    std::string_view name = line.text.substr(std::size_t(line.words[9].data() - line.text.data()));
    while (name.ends_with(' ') || name.ends_with('\t'))
        name.remove_suffix(1);
    return std::string(name);
}

/// The camera's size, intrinsics and distortion.
void setLens(ForeignCamera &camera, const Found &found)
{
    const Line &line = found.line;
    const auto fault = [&](std::string reason) {
        throw base::Error{.text = std::move(reason), .file = found.file->name, .line = int(line.number)};
    };
    const std::string_view name = line.words[1];
    const auto model = std::find_if(kRead.begin(), kRead.end(), [name](const Model &m) { return m.name == name; });
    if (model == kRead.end())
        fault(tr("the camera model %1 is not read: it is no pinhole with the distortion of Brown and Conrady. "
                 "Undistort the images with COLMAP's image_undistorter",
                 name));
    if (line.words.size() != 4 + model->parameters)
        fault(tr("%1 has %2 parameters; it needs %3", name, line.words.size() - 4, model->parameters));
    std::vector<double> p;
    for (std::size_t i = 4; i < line.words.size(); ++i) {
        const auto number = base::doubleFromWord(line.words[i]);
        if (!number || !std::isfinite(*number))
            fault(tr("%1 is not a finite number", base::quoted(line.words[i])));
        p.push_back(*number);
    }
    camera.size = sizeOf(base::doubleFromWord(line.words[2]), base::doubleFromWord(line.words[3]));
    if (!camera.size)
        fault(tr("width and height are %1 and %2; they must be whole numbers above 0", line.words[2], line.words[3]));
    const bool hasOneFocal = name.starts_with("SIMPLE_") || name == "RADIAL";
    if (hasOneFocal)
        p.insert(p.begin(), p.front()); // fx = fy
    camera.intrinsics = Intrinsics{p[0], p[1], p[2], p[3], 0.0, PixelCentres::AtHalves};
    p.resize(12, 0.0);
    Distortion distortion{p[4], p[5], p[6], p[7], p[8]};
    if (p[9] != 0.0 || p[10] != 0.0 || p[11] != 0.0)
        fault(tr("FULL_OPENCV's k4, k5 and k6 are not read; undistort the images with COLMAP's "
                 "image_undistorter"));
    if (!distortion.isNone())
        camera.distortion = distortion;
}

} // namespace

std::optional<ForeignCamera> readColmap(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        if (text.name.ends_with("cameras.bin") || text.name.ends_with("images.bin"))
            Reading(text, choices)
                .fail(tr("COLMAP's binary files are not read; write text with 'colmap model_converter "
                         "--output_type TXT' and give cameras.txt and images.txt"));
    }
    const Reconstruction found = reconstructionOf(texts);
    if (found.cameras.empty() && found.images.empty())
        return std::nullopt;
    if (found.images.empty())
        Reading(*found.cameras.begin()->second.file, choices)
            .fail(tr("COLMAP's cameras have no poses; give images.txt too"));
    Reading reading(*found.images.front().file, choices);
    ForeignCamera &camera = reading.camera;
    reading.begin("COLMAP", PoseDirection::WorldToCamera, EyeAxes::RightDownAhead);
    for (const Found &image : found.images)
        camera.images.push_back(nameIn(image.line));
    if (found.cameras.empty())
        reading.fail(tr("COLMAP's images have no focal lengths; give cameras.txt too"));
    reading.chooseImage();
    const Line &image = found.images[camera.image].line;
    const std::array<double, 7> v = poseIn(image);
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (!std::isfinite(v[i]))
            reading.fail(tr("%1 is not a finite number", base::quoted(image.words[i + 1])), image.number);
    }
    const auto rotation = rotationOf(v[0], v[1], v[2], v[3]);
    if (!rotation)
        reading.fail(tr("the image's quaternion is 0; a rotation has the length 1"), image.number);
    if (const double length = quaternionLength(v); std::abs(length - 1.0) >= kUnit)
        camera.assumed.push_back(tr("The quaternion of %1 has the length %2 instead of 1; it is divided by it.",
                                    camera.images[camera.image], base::significantText(length, 4)));
    camera.pose = rigid(*rotation, {v[4], v[5], v[6]});
    const auto lens = found.cameras.find(*base::integerFromWord(image.words[8]));
    if (lens == found.cameras.end())
        reading.fail(tr("there is no camera %1 in cameras.txt", image.words[8]), image.number);
    setLens(camera, lens->second);
    for (const NamedText &text : texts) {
        const auto isIt = [&text](const Found &one) { return one.file == &text; };
        const bool isPoints = text.text.starts_with("# 3D point list"); // points3D.txt, which has no camera
        if (isPoints || std::any_of(found.images.begin(), found.images.end(), isIt)
            || std::any_of(found.cameras.begin(), found.cameras.end(),
                           [&](const auto &one) { return isIt(one.second); }))
            camera.files.push_back(text.name);
    }
    return std::move(camera);
}

} // namespace unprojector::cameras
