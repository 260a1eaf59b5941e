#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/lens.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <utility>

// Files of numbers whose places, not names, say what they are: lenses, poses and trajectories.

namespace unprojector::cameras {
using base::tr;
using enum PoseDirection;
using enum EyeAxes;

namespace {

struct Row {
    std::string first; ///< its first word
    Numbers numbers;
};

/// The first lines of a text that has only numbers, and comments behind #; empty for another text.
/// @param hasNames  words before the numbers of a line are its first word
std::vector<Row> rowsOf(std::string_view text, bool hasNames = false)
{
    constexpr std::size_t kMost = std::size_t{1} << 20;
    std::vector<Row> rows;
    base::TextScanner scanner(text);
    for (scanner.skipBlankLines(); !scanner.isAtEnd() && rows.size() < kMost; scanner.skipBlankLines()) {
        Row row;
        for (std::string_view word = scanner.nextWordInLine(); !word.empty(); word = scanner.nextWordInLine()) {
            if (row.numbers.empty() && word.starts_with('#'))
                break;
            const auto number = base::doubleFromWord(word);
            if (!number && (!hasNames || !row.numbers.empty()))
                return {};
            if (!number || row.first.empty())
                row.first += (row.first.empty() ? "" : " ") + std::string(word);
            if (number)
                row.numbers.push_back(*number);
        }
        scanner.skipLine();
        if (!row.numbers.empty())
            rows.push_back(std::move(row));
    }
    return rows;
}

/// Returns whether the rows from an index have these counts of numbers.
bool haveCounts(const std::vector<Row> &rows, std::initializer_list<std::size_t> counts, std::size_t from = 0)
{
    return rows.size() >= from + counts.size()
           && std::equal(counts.begin(), counts.end(), rows.begin() + std::ptrdiff_t(from),
                         [](std::size_t count, const Row &row) { return row.numbers.size() == count; });
}

/// The numbers of some rows, one after the other.
Numbers joined(const std::vector<Row> &rows, std::size_t from, std::size_t count)
{
    Numbers numbers;
    for (std::size_t i = from; i < from + count; ++i)
        numbers.insert(numbers.end(), rows[i].numbers.begin(), rows[i].numbers.end());
    return numbers;
}

Intrinsics lensOf(std::span<const double> k, PixelCentres centres = PixelCentres::AtIntegers)
{
    return {k[0], k[4], k[2], k[5], k[1], centres};
}

bool isRotation(const glm::dmat3 &axes)
{
    return glm::determinant(axes) > 0.0 && areOrthonormal(axes);
}

std::string_view fileNameOf(const NamedText &text)
{
    const std::string_view name = text.name;
    return name.substr(name.find_last_of("/\\") + 1);
}

/// Poses from the camera to the world.
struct Poses {
    const char *program = nullptr; ///< null: there are none
    std::vector<std::string> names{};
    std::vector<glm::dmat4> worldFromCamera{};
    std::vector<std::string> files{};
};

/// The poses of a text, one a line: timestamp tx ty tz qx qy qz qw of TUM, [R t] of KITTI, 4 x 4 of
/// Replica; or one in four lines, where the file's name tells 7-Scenes or ScanNet.
/// Sources: "File Formats", RGB-D SLAM benchmark of TUM; KITTI odometry's devkit, readme.txt; NICE-SLAM,
/// src/utils/datasets.py; 7-Scenes, readme.txt; ScanNet, README.md, "Data Organization"
Poses posesOf(const NamedText &text)
{
    const std::vector<Row> rows = rowsOf(text.text);
    const std::string_view name = fileNameOf(text);
    const bool isNumbered = name.find_first_not_of("0123456789") == name.find('.');
    Poses poses;
    if (rows.size() == 4 && haveCounts(rows, {4, 4, 4, 4})) {
        const glm::dmat4 pose = *matrixByRows(joined(rows, 0, 4));
        const bool isSevenScenes = name.find(".pose") != name.npos;
        if ((isSevenScenes || isNumbered) && isRotation(glm::dmat3(pose)))
            poses = {isSevenScenes ? "7-Scenes" : "ScanNet", {text.name}, {pose}, {text.name}};
        return poses;
    }
    const std::size_t count = rows.empty() ? 0 : rows.front().numbers.size();
    const bool isNamed = name.find("traj") != name.npos || name.find("pose") != name.npos;
    if (count != 8 && !(count == 16 && isNamed) && !(count == 12 && (isNamed || isNumbered)))
        return poses;
    for (const Row &row : rows) {
        const Numbers &n = row.numbers;
        if (n.size() != count)
            return {};
        std::optional<glm::dmat4> pose = matrixByRows(n);
        constexpr double kUnit = 5e-3; // how far a quaternion printed with few digits may be from 1
        if (count == 8 && std::abs(std::hypot(std::hypot(n[4], n[5]), std::hypot(n[6], n[7])) - 1.0) < kUnit)
            pose = rigid(*rotationOf(n[7], n[4], n[5], n[6]), {n[1], n[2], n[3]});
        if (!pose || !isRotation(glm::dmat3(*pose)))
            return {};
        poses.names.push_back(count == 8 ? row.first : std::to_string(poses.names.size()));
        poses.worldFromCamera.push_back(*pose);
    }
    poses.program = count == 8 ? "TUM" : count == 12 ? "KITTI" : "Replica";
    poses.files = {text.name};
    return poses;
}

/// A text of names with lines of eight numbers among them, which would be the last name's, as two texts;
/// empty for another text.
std::vector<NamedText> withoutRows(const NamedText &text)
{
    std::vector<NamedText> both{{text.name, {}}, {text.name, {}}};
    for (std::size_t at = 0; at < text.text.size();) {
        const std::size_t end = std::min(text.text.find('\n', at), text.text.size() - 1) + 1;
        const std::string line = text.text.substr(at, end - at);
        both[haveCounts(rowsOf(line), {8}) ? 1 : 0].text += line;
        at = end;
    }
    return both[1].text.empty() || !rowsOf(text.text).empty() ? std::vector<NamedText>() : both;
}

/// The name of the pose at a time: of the nearest one, as the images' times are other than the poses'.
/// @param choice  a time, or a file with this name: 1305031102.175304.png
std::optional<std::string> nearestTime(const std::vector<std::string> &names, const std::string &choice)
{
    constexpr double kMost = 0.02; // seconds, as TUM's associate.py
    std::string_view word = choice;
    word.remove_prefix(word.find_last_of("/\\") + 1);
    const std::size_t end = word.find_last_of("0123456789");
    const auto time = end == word.npos ? std::nullopt : base::doubleFromWord(word.substr(0, end + 1));
    const auto index = base::integerFromWord(word);
    if (!time || (index && *index < static_cast<long long>(names.size())))
        return std::nullopt;
    const auto away = [&](const std::string &name) { return std::abs(*base::doubleFromWord(name) - *time); };
    const auto nearest =
        std::min_element(names.begin(), names.end(), [&](const auto &a, const auto &b) { return away(a) < away(b); });
    return away(*nearest) <= kMost ? std::optional(*nearest) : std::nullopt;
}

/// A lens as named text for readNamedParts.
struct NamedLens {
    std::string text{};
    bool isAlone = false; ///< it is a camera without a pose beside it, too
    glm::dmat4 lensFromPose{1.0};
};

std::string namedText(std::initializer_list<const char *> names, std::span<const double> numbers)
{
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += std::string(names.begin()[i]) + ": ";
        base::appendNumber(text, numbers[i]);
        text += '\n';
    }
    return text;
}

/// DSO's camera.txt: the model with its numbers, the image's size, then what DSO makes of it.
/// Source: DSO, src/util/Undistort.cpp: relative numbers count from the image's corner
NamedLens dsoLens(const NamedText &text, const CameraChoices &choices)
{
    base::TextScanner scanner(text.text);
    std::string_view word = scanner.nextWord();
    const std::string model(base::doubleFromWord(word) ? std::string_view() : word);
    Numbers n;
    for (word = model.empty() ? word : scanner.nextWordInLine(); !word.empty(); word = scanner.nextWordInLine()) {
        const auto number = base::doubleFromWord(word);
        if (!number || n.size() == 8)
            return {};
        n.push_back(*number);
    }
    const auto width = base::doubleFromWord(scanner.nextWord()), height = base::doubleFromWord(scanner.nextWord());
    const bool isSize = scanner.nextWordInLine().empty() && sizeOf(width, height);
    const std::string_view output = scanner.nextWord();
    const bool isOutput =
        base::isListed("crop full none", output) || (base::doubleFromWord(output) && !scanner.nextWordInLine().empty());
    const bool isRadTan = (model.empty() || model == "RadTan") && n.size() == 8,
               isFov = (model.empty() || model == "FOV" || model == "Pinhole") && n.size() == 5;
    const bool isOther = (model == "EquiDistant" || model == "KannalaBrandt") && n.size() == 8;
    if ((!isRadTan && !isFov && !isOther) || !isSize || !isOutput)
        return {};
    const bool isRead = isRadTan || (isFov && n[4] == 0.0);
    if (!isRead && !choices.isUndistorted)
        throw base::Error{.text = unknownDistortionText(isOther ? model : "FOV"), .file = text.name, .line = 1};
    if (n[2] < 1.0 && n[3] < 1.0) {
        n[0] *= *width;
        n[1] *= *height;
        n[2] = n[2] * *width - 0.5;
        n[3] = n[3] * *height - 0.5;
    }
    n.resize(isRead ? 8 : 4, 0.0);
    n.resize(8, 0.0);
    n.insert(n.end(), {*width, *height});
    return {namedText({"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "width", "height"}, n), true};
}

/// The lens of a file beside poses: K of 3 x 3 or ScanNet's 4 x 4, or KITTI's first camera matrix.
NamedLens lensBeside(const NamedText &text)
{
    const std::vector<Row> rows = rowsOf(text.text);
    const bool isWide = rows.size() == 4 && haveCounts(rows, {4, 4, 4, 4});
    if (isWide || (rows.size() == 3 && haveCounts(rows, {3, 3, 3}))) {
        const Numbers &x = rows[0].numbers, &y = rows[1].numbers;
        const bool isLens = x[0] > 1.0 && x[2] > 1.0 && y[0] == 0.0 && y[1] > 1.0 && rows[2].numbers[2] == 1.0;
        return {isLens ? "K:\n" + text.text : std::string()};
    }
    if (text.text.find("P0:") == text.text.npos && text.text.find("P2:") == text.text.npos)
        return {};
    const NamedValues values(text.text);
    Numbers p;
    for (const char *name : {"p0", "p2", "p1", "p3"})
        p = p.empty() ? values.numbers(name, 12) : p;
    const auto parts = p.size() == 12 ? partsOf(p) : std::nullopt;
    if (!parts)
        return {};
    const Intrinsics &k = parts->intrinsics;
    const Numbers numbers{k.fx, k.fy, k.cx, k.cy};
    return {namedText({"fx", "fy", "cx", "cy"}, numbers), false, parts->cameraFromWorld};
}

/// A text that has only matrices of a size, one below the other.
struct Blocks {
    std::vector<Row> rows{};
    std::size_t count = 0, lines = 0; ///< matrices, and the rows of each
    std::string textOf(std::size_t index) const
    {
        std::string text;
        for (std::size_t i = index * lines; i < (index + 1) * lines; ++i) {
            for (const double number : rows[i].numbers) {
                base::appendNumber(text, number);
                text += ' ';
            }
            text += '\n';
        }
        return text;
    }
};

Blocks blocksOf(const NamedText &text, std::size_t lines, std::size_t width)
{
    Blocks blocks{rowsOf(text.text)};
    const bool isIt = !blocks.rows.empty() && blocks.rows.size() % lines == 0
                      && std::ranges::all_of(blocks.rows, [&](const Row &row) { return row.numbers.size() == width; });
    if (!isIt)
        return {};
    blocks.count = blocks.rows.size() / lines;
    blocks.lines = lines;
    return blocks;
}

/// A file of several K and a file of as many poses: the names of the files are those of the matrices.
std::optional<ForeignCamera> readBlocks(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (std::size_t i = 0; i < 2 && texts.size() == 2; ++i) {
        const NamedText &ofLenses = texts[i], &ofPoses = texts[1 - i];
        const Blocks lenses = blocksOf(ofLenses, 3, 3);
        Blocks poses = blocksOf(ofPoses, 4, 4);
        if (poses.count == 0)
            poses = blocksOf(ofPoses, 3, 4);
        if (lenses.count < 2 || lenses.count != poses.count)
            continue;
        Reading reading(ofPoses, choices);
        for (std::size_t one = 0; one < poses.count; ++one)
            reading.camera.images.push_back(std::to_string(one));
        reading.chooseImage();
        const std::size_t image = reading.camera.image;
        const std::string_view name = fileNameOf(ofPoses);
        const std::vector<NamedText> named{
            {ofLenses.name, "K:\n" + lenses.textOf(image)},
            {ofPoses.name, std::string(name.substr(0, name.find('.'))) + ":\n" + poses.textOf(image)}};
        CameraChoices alone = choices;
        alone.image.clear();
        std::optional<ForeignCamera> camera = readNamedParts(named, alone);
        if (!camera)
            return std::nullopt;
        camera->images = std::move(reading.camera.images);
        camera->image = image;
        camera->assumed.insert(camera->assumed.begin(), reading.camera.assumed.begin(), reading.camera.assumed.end());
        return camera;
    }
    return std::nullopt;
}

} // namespace

std::optional<ForeignCamera> readTables(std::span<const NamedText> texts, const CameraChoices &choices)
{
    if (auto camera = readBlocks(texts, choices))
        return camera;
    constexpr std::size_t kMostBytes = std::size_t{1} << 20;
    std::vector<NamedText> both;
    if (texts.size() == 1 && texts[0].text.size() < kMostBytes && !isJson(texts[0].text) && !isXml(texts[0].text))
        both = withoutRows(texts[0]);
    if (!both.empty())
        texts = both;
    Poses poses;
    std::vector<const NamedText *> rest;
    for (const NamedText &text : texts) {
        Poses found = texts.size() > 1 ? posesOf(text) : Poses();
        if (!found.program) {
            rest.push_back(&text);
        } else if (!poses.program) {
            poses = std::move(found);
        } else { // several frames of 7-Scenes or ScanNet
            poses.names.insert(poses.names.end(), found.names.begin(), found.names.end());
            poses.worldFromCamera.insert(poses.worldFromCamera.end(), found.worldFromCamera.begin(),
                                         found.worldFromCamera.end());
            poses.files.push_back(text.name);
        }
    }
    const auto isIntrinsic = [](const NamedText *text) { return fileNameOf(*text).starts_with("intrinsic"); };
    if (poses.program && std::string_view(poses.program) == "ScanNet"
        && std::none_of(rest.begin(), rest.end(), isIntrinsic))
        return std::nullopt;
    std::vector<NamedLens> lenses;
    bool hasDso = false;
    for (const NamedText *text : rest) {
        lenses.push_back(dsoLens(*text, choices));
        hasDso = hasDso || lenses.back().isAlone;
        if (poses.program && !lenses.back().isAlone)
            lenses.back() = lensBeside(*text);
    }
    if (rest.empty() || (!poses.program && !hasDso))
        return std::nullopt;
    std::vector<NamedText> named;
    glm::dmat4 lensFromPose(1.0);
    for (std::size_t i = 0; i < rest.size(); ++i) {
        named.push_back({rest[i]->name, lenses[i].text.empty() ? rest[i]->text : lenses[i].text});
        lensFromPose = lenses[i].lensFromPose * lensFromPose;
    }
    CameraChoices ofLens = choices, ofPose = choices;
    if (poses.program)
        ofLens.image.clear();
    std::optional<ForeignCamera> camera = readNamedParts(named, ofLens);
    if (!camera || !camera->intrinsics || !poses.program || camera->pose) {
        if (camera && !camera->pose)
            camera->program = "DSO";
        return hasDso && !poses.program ? std::move(camera) : std::nullopt;
    }
    if (camera->images.size() > 1)
        throw base::Error{.text = tr("the text has %1 lenses; give the one of the poses", camera->images.size()),
                          .file = rest.front()->name};
    const bool isTimed = std::string_view(poses.program) == "TUM";
    const auto hasFirst = [](const NamedText *text) { return text->text.find("P0:") != std::string::npos; };
    if (poses.program == std::string_view("KITTI") && std::any_of(rest.begin(), rest.end(), hasFirst))
        camera->assumed.push_back(tr("The lens is that of P0. For another camera, give its P alone."));
    if (const auto name = isTimed ? nearestTime(poses.names, choices.image) : std::nullopt)
        ofPose.image = *name;
    const NamedText ofPoses{poses.files.front(), {}};
    Reading reading(ofPoses, ofPose);
    reading.camera = *std::move(camera);
    reading.begin(poses.program, {PoseDirection::CameraToWorld});
    reading.camera.images = poses.names;
    reading.chooseImage();
    if (ofPose.image != choices.image)
        reading.camera.assumed.push_back(tr("The pose at the time %1 is taken, the nearest one.", ofPose.image));
    reading.camera.pose = poses.worldFromCamera[reading.camera.image] * glm::inverse(lensFromPose);
    reading.camera.files.insert(reading.camera.files.end(), poses.files.begin(), poses.files.end());
    reading.camera.assumed.push_back(tr("The poses are read from the camera to the world, with OpenCV's axes, as %1 "
                                        "writes them; --pose and --axes say otherwise.",
                                        poses.program));
    return std::move(reading.camera);
}

namespace {

// Source: Multiface, dataset.py, load_krt: the camera's name, K, distortion and [R t] from the world. Later data
// sets have the image's size beside the name.
constexpr std::size_t kKrtLines = 8;

Cameras krtCameras(Reading &reading, const Node &text)
{
    const std::vector<Row> rows = rowsOf(reading.text.text);
    Cameras cameras;
    for (std::size_t i = 0; i < rows.size(); i += kKrtLines) {
        if (!haveCounts(rows, {1, 3, 3, 3, 5, 4, 4, 4}, i) && !haveCounts(rows, {3, 3, 3, 3, 5, 4, 4, 4}, i))
            return {};
        cameras.push_back({rows[i].first, {}, text, text});
    }
    return cameras;
}

void readKrt(Reading &reading)
{
    const std::vector<Row> rows = rowsOf(reading.text.text);
    const std::size_t at = kKrtLines * reading.camera.image;
    if (const Numbers &head = rows[at].numbers; head.size() == 3)
        reading.camera.size = sizeOf(head[1], head[2]);
    reading.camera.intrinsics = lensOf(joined(rows, at + 1, 3));
    if (const auto distortion = distortionOf(rows[at + 4].numbers); distortion && !distortion->isNone())
        reading.camera.distortion = *distortion;
    reading.camera.pose = matrixByRows(joined(rows, at + 5, 3));
}

// Source: vision.middlebury.edu/stereo/data/scenes2014: cam1 is to the right of cam0, in millimetres
Cameras middleburyCameras(Reading &, const Node &text)
{
    if (text.numbers("cam0", 9).size() != 9 || !text.has("doffs"))
        return {};
    Cameras cameras{{"cam0", {}, text, text}};
    if (text.numbers("cam1", 9).size() == 9 && text.number("baseline"))
        cameras.push_back({"cam1", {}, text, text});
    return cameras;
}

void readMiddlebury(Reading &reading)
{
    reading.setLens(reading.lens, reading.name, PixelCentres::AtIntegers);
    reading.camera.pose =
        rigid(glm::dmat3(1.0), {reading.name == "cam1" ? -reading.lens.needed("baseline") : 0.0, 0.0, 0.0});
    reading.say(tr("The world is that of cam0, in millimetres."));
}

// Source: Bundler's User Manual, "Output format": -z is ahead, pixels count from the image's centre
constexpr std::size_t kBundlerLines = 5;

Cameras bundlerCameras(Reading &reading, const Node &text)
{
    if (!reading.text.text.starts_with("# Bundle file"))
        return {};
    const std::vector<Row> rows = rowsOf(reading.text.text);
    const double count = haveCounts(rows, {2}) ? rows[0].numbers[0] : 0.0;
    Cameras cameras;
    while (double(cameras.size()) < count && haveCounts(rows, {3, 3, 3, 3, 3}, 1 + kBundlerLines * cameras.size()))
        cameras.push_back({std::to_string(cameras.size()), {}, text, text});
    if (cameras.empty() || double(cameras.size()) != count)
        reading.fail(tr("the file ends in the middle of an entry; it is incomplete"));
    return cameras;
}

void readBundler(Reading &reading)
{
    const std::vector<Row> rows = rowsOf(reading.text.text);
    const std::size_t at = 1 + kBundlerLines * reading.camera.image;
    const Numbers &lens = rows[at].numbers;
    reading.setCentred(reading.neededSize(), lens[0], lens[0]);
    if (const Distortion distortion{lens[1], lens[2]}; !distortion.isNone())
        reading.camera.distortion = distortion;
    reading.camera.pose = rigid(glm::dmat3(*matrixByRows(joined(rows, at + 1, 3))), vectorOf(rows[at + 4].numbers));
}

/// The lines below the header: an image's name and size, K, R1 to R3, T1 and T2, t, and R.
std::vector<Row> pix4dRows(std::string_view text)
{
    return rowsOf(text.substr(text.find("-Rt]") + 4), true);
}
constexpr std::size_t kPix4dLines = 10;

Cameras pix4dCameras(Reading &reading, const Node &text)
{
    const std::vector<Row> rows = pix4dRows(reading.text.text);
    Cameras cameras;
    for (std::size_t i = 0; i == 0 || i < rows.size(); i += kPix4dLines) {
        if (!haveCounts(rows, {2, 3, 3, 3, 3, 2, 3, 3, 3, 3}, i))
            reading.fail(tr("the file ends in the middle of an entry; it is incomplete"));
        cameras.push_back({rows[i].first, {}, text, text});
    }
    return cameras;
}

void readPix4d(Reading &reading)
{
    const std::vector<Row> rows = pix4dRows(reading.text.text);
    const std::size_t at = kPix4dLines * reading.camera.image;
    const Numbers &sides = rows[at].numbers;
    reading.camera.size = sizeOf(sides[0], sides[1]);
    reading.camera.intrinsics = lensOf(joined(rows, at + 1, 3), PixelCentres::AtHalves);
    setDistortion(reading, "Pix4D", joined(rows, at + 4, 2));
    reading.camera.center = vectorOf(rows[at + 6].numbers);
    reading.camera.pose = matrixByRows(joined(rows, at + 7, 3));
    reading.say(tr("The world is that of Pix4D's project: *_offset.xyz has its origin in map coordinates."));
}

// Source: vision.middlebury.edu/mview/data, README: the image's name, K, R and t; the projection is K [R t]
constexpr std::size_t kParameters = 21;

Cameras multiViewCameras(Reading &reading, const Node &text)
{
    const std::vector<Row> rows = rowsOf(reading.text.text, true);
    Cameras cameras;
    for (std::size_t i = 1; haveCounts(rows, {1}) && i < rows.size(); ++i) {
        const Numbers &n = rows[i].numbers;
        if (n.size() != kParameters)
            return {};
        if (n[3] != 0.0 || n[6] != 0.0 || n[7] != 0.0 || n[8] != 1.0)
            reading.fail(tr("the camera matrix of %1 has not the rows fx skew cx, 0 fy cy, 0 0 1", rows[i].first));
        cameras.push_back({rows[i].first, {}, text, text});
    }
    if (!cameras.empty() && rows[0].numbers[0] != double(cameras.size()))
        reading.fail(tr("the first line says %1 images, and there are %2", base::shortestText(rows[0].numbers[0]),
                        cameras.size()),
                     1);
    return cameras;
}

void readMultiView(Reading &reading)
{
    const Numbers n = rowsOf(reading.text.text, true)[reading.camera.image + 1].numbers;
    reading.camera.intrinsics = lensOf(n);
    reading.camera.pose = rigid(glm::transpose(glm::make_mat3(&n[9])), vectorOf(n, 18));
}

// Source: VisualSFM's documentation, "Output format": the image's name, focal length, quaternion w x y z, centre,
// distortion, 0; pixels count from the image's middle
std::vector<Row> sfmRows(const Reading &reading)
{
    std::string_view text = reading.text.text, images = text.substr(text.find('\n') + 1);
    base::TextScanner scanner(images);
    const auto count = base::integerFromWord(scanner.nextWord());
    for (long long i = 0; count && i < *count && !scanner.isAtEnd(); ++i) {
        scanner.skipLine();
        scanner.skipBlankLines();
    }
    scanner.skipLine();
    return rowsOf(images.substr(0, scanner.offset()), true);
}

Cameras sfmCameras(Reading &reading, const Node &text)
{
    Cameras cameras;
    if (!reading.text.text.starts_with("NVM_V3"))
        return cameras;
    if (split(reading.text.text, '\n')[0].find_first_of("0123456789", 6) != std::string::npos)
        reading.fail(tr("a fixed calibration of %1 is not read; give fx, fy, cx and cy with the pose", "VisualSFM"), 1);
    const std::vector<Row> rows = sfmRows(reading);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].numbers.size() != 10)
            reading.fail(tr("the file ends in the middle of an entry; it is incomplete"));
        cameras.push_back({rows[i].first, {}, text, text});
    }
    if (rows.empty() || rows[0].numbers[0] != double(cameras.size()))
        reading.fail(tr("the first line says %1 images, and there are %2",
                        rows.empty() ? "?" : base::shortestText(rows[0].numbers[0]), cameras.size()));
    return cameras;
}

void readSfm(Reading &reading)
{
    const Numbers n = sfmRows(reading)[reading.camera.image + 1].numbers;
    reading.setCentred(reading.neededSize(), n[0], n[0]);
    setDistortion(reading, "VisualSFM", n[8] == 0.0 ? std::optional(Numbers()) : std::nullopt);
    const auto turn = rotationOf(n[1], n[2], n[3], n[4]);
    if (!turn)
        reading.fail(tr("the quaternion of %1 is 0", reading.name));
    reading.camera.pose = rigid(*turn, {});
    reading.camera.center = vectorOf(n, 5);
}

constexpr Form kForms[]{
    {"Bundler", "Bundle", {WorldToCamera, RightUpBack}, bundlerCameras, readBundler},

    // Source: MVSNet, README.md, "File Formats": the line below the intrinsics is of depths
    {"MVSNet",
     "",
     {},
     [](Reading &reading, const Node &text) {
         const bool isIt = reading.text.text.starts_with("extrinsic") && text.numbers("extrinsic", 16).size() == 16
                           && !text.numbers("intrinsic", 11).empty(); // without depths, names tell all
         return onlyIf(isIt, text);
     },
     [](Reading &reading) {
         const Numbers k = reading.lens.numbers("intrinsic", 11);
         if (k[3] != 0.0 || k[6] != 0.0 || k[7] != 0.0 || k[8] != 1.0)
             reading.lens.fail(tr("this is no camera matrix; it must have the rows fx skew cx, 0 fy cy, 0 0 1"),
                               "intrinsic");
         reading.camera.intrinsics = lensOf(k);
     },
     {.pose = "extrinsic", .note = base::marked("The line of depths is not used.")}},
    {"Multiface", "", {}, krtCameras, readKrt},
    // Source: the file's header, m = K [R|-Rt] X; support.pix4d.com, 202559089, for the distortion, which is OpenCV's.
    // Where pixels count from is not told there; its .cam files have principal points from the image's middle.
    {"Pix4D",
     "imageWidth [3x3] -Rt]",
     {},
     pix4dCameras,
     readPix4d,
     {.note = base::marked("Pixel centres are assumed at halves; --pixel-centers integer says otherwise.")}},
    {"Middlebury", "cam0 doffs", {}, middleburyCameras, readMiddlebury},
    {"Middlebury", ".png|.jpg|.ppm|.bmp", {}, multiViewCameras, readMultiView},
    {"VisualSFM", "NVM_V3", {}, sfmCameras, readSfm}};

} // namespace

std::span<const Form> fileForms()
{
    return kForms;
}

} // namespace unprojector::cameras
