#include "core/base/byte_order.h"
#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

// cameras.txt: CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]
// images.txt:  IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then a line of 2-D points
// cameras.bin and images.bin have the same fields behind a count, little-endian.
// Source: COLMAP's documentation, "Output Format".

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

/// A model and its count of parameters, in the order of COLMAP's numbers: its sensor/models.h.
struct Model {
    std::string_view name;
    std::size_t parameters;
    bool isRead;
};
constexpr std::array<Model, 18> kModels{{{"SIMPLE_PINHOLE", 3, true},
                                         {"PINHOLE", 4, true},
                                         {"SIMPLE_RADIAL", 4, true},
                                         {"RADIAL", 5, true},
                                         {"OPENCV", 8, true},
                                         {"OPENCV_FISHEYE", 8, false},
                                         {"FULL_OPENCV", 12, true},
                                         {"FOV", 5, false},
                                         {"SIMPLE_RADIAL_FISHEYE", 4, false},
                                         {"RADIAL_FISHEYE", 5, false},
                                         {"THIN_PRISM_FISHEYE", 12, false},
                                         {"RAD_TAN_THIN_PRISM_FISHEYE", 16, false},
                                         {"SIMPLE_DIVISION", 4, false},
                                         {"DIVISION", 5, false},
                                         {"SIMPLE_FISHEYE", 3, false},
                                         {"FISHEYE", 4, false},
                                         {"EUCM", 6, false},
                                         {"EQUIRECTANGULAR", 2, false}}};

const Model *modelOf(std::string_view name)
{
    const auto found =
        std::find_if(kModels.begin(), kModels.end(), [name](const Model &model) { return model.name == name; });
    return found == kModels.end() ? nullptr : &*found;
}

/// A camera or an image, with the file that has it and its line; 0 in a binary file.
struct Entry {
    const NamedText *file = nullptr;
    std::size_t line = 0;

    [[noreturn]] void fail(std::string reason) const
    {
        throw base::Error{.text = std::move(reason), .file = file->name, .line = int(line)};
    }
};
struct Camera : Entry {
    std::string model{};
    double width = 0.0, height = 0.0;
    Numbers parameters{}; ///< of a model that is read
    std::string fault{};  ///< why they are not read
};
struct Image : Entry {
    std::array<double, 7> pose{}; ///< QW QX QY QZ TX TY TZ
    long long camera = 0;
    std::string name{};
};

/// The cameras by their ids, and the images in their order.
struct Reconstruction {
    std::map<long long, Camera> cameras;
    std::vector<Image> images;
};

struct Line {
    std::size_t number; ///< from 1
    Words words;
    std::string_view text;
};

/// The lines of a text. Comments are left out; blank lines stay, because an image without 2-D
/// points has one.
std::vector<Line> linesOf(std::string_view text)
{
    std::vector<Line> lines;
    std::size_t number = 0;
    for (std::string_view whole : split(text, '\n')) {
        Line line{++number, {}, whole.substr(0, whole.size() - (whole.ends_with('\r') ? 1 : 0))};
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

bool isCameraLine(const Line &line)
{
    return line.words.size() >= 5 && base::integerFromWord(line.words[0]) && modelOf(line.words[1])
           && base::integerFromWord(line.words[2]) && base::integerFromWord(line.words[3]);
}

/// Returns whether a line has an image's form, and is no line of 2-D points. Its quaternion may be
/// damaged.
bool isImageLine(const Line &line)
{
    const bool isPoints = line.words.size() % 3 == 0
                          && std::all_of(line.words.begin(), line.words.end(),
                                         [](std::string_view word) { return base::doubleFromWord(word).has_value(); });
    return line.words.size() >= 10 && base::integerFromWord(line.words[0]) && base::integerFromWord(line.words[8])
           && !isPoints;
}

Camera cameraIn(const Line &line, const NamedText &file)
{
    Camera camera{{&file, line.number}, std::string(line.words[1])};
    camera.width = base::doubleFromWord(line.words[2]).value_or(0.0);
    camera.height = base::doubleFromWord(line.words[3]).value_or(0.0);
    for (std::size_t i = 4; i < line.words.size(); ++i) {
        const auto number = base::doubleFromWord(line.words[i]);
        if (camera.fault.empty() && !(number && std::isfinite(*number)))
            camera.fault = tr("%1 is not a finite number", base::quoted(line.words[i]));
        camera.parameters.push_back(number.value_or(0.0));
    }
    return camera;
}

double quaternionLength(const std::array<double, 7> &pose)
{
    return glm::length(glm::dvec4(pose[0], pose[1], pose[2], pose[3]));
}

/// How far a quaternion printed with few digits may be from the length 1.
constexpr double kUnit = 5e-3;

/// Words that are no numbers become NaN: see readColmap.
Image imageIn(const Line &line, const NamedText &file)
{
    Image image{{&file, line.number}};
    for (std::size_t i = 0; i < image.pose.size(); ++i)
        image.pose[i] = base::doubleFromWord(line.words[i + 1]).value_or(std::numeric_limits<double>::quiet_NaN());
    image.camera = *base::integerFromWord(line.words[8]);
    // The name is the rest of the line, which may contain blanks.
    image.name = base::trimmed(line.text.substr(std::size_t(line.words[9].data() - line.text.data())));
    return image;
}

void readText(const NamedText &file, Reconstruction &found)
{
    const std::vector<Line> lines = linesOf(file.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (isCameraLine(lines[i])) {
            found.cameras.emplace(*base::integerFromWord(lines[i].words[0]), cameraIn(lines[i], file));
        } else if (isImageLine(lines[i])) {
            found.images.push_back(imageIn(lines[i], file));
            const bool hasPoints = i + 1 < lines.size() && !isImageLine(lines[i + 1]) && !isCameraLine(lines[i + 1]);
            i += hasPoints ? 1 : 0; // the line of its points
        }
    }
}

/// The values of a binary file, in their order.
class Bytes {
public:
    explicit Bytes(const NamedText &file) : m_entry{&file} {}

    template <class Value>
    Value next()
    {
        const std::string_view bytes = take(sizeof(Value));
        return base::numberAt<Value>(reinterpret_cast<const std::uint8_t *>(bytes.data()));
    }
    std::string nextName()
    {
        const std::string &text = m_entry.file->text;
        std::string name(take(std::min(text.find('\0', m_at), text.size()) - m_at));
        take(1); // its end
        return name;
    }
    void skip(std::uint64_t count, std::size_t size)
    {
        if (count > m_entry.file->text.size())
            take(m_entry.file->text.size());
        take(std::size_t(count) * size);
    }
    const Entry &entry() const { return m_entry; }

private:
    std::string_view take(std::size_t count)
    {
        const std::string_view rest = std::string_view(m_entry.file->text).substr(m_at);
        if (count > rest.size())
            m_entry.fail(tr("the file ends in the middle of an entry; it is incomplete"));
        m_at += count;
        return rest.substr(0, count);
    }

    Entry m_entry;
    std::size_t m_at = 0;
};

void readBinaryCameras(const NamedText &file, Reconstruction &found)
{
    Bytes bytes(file);
    for (auto count = bytes.next<std::uint64_t>(); count > 0; --count) {
        const auto id = bytes.next<std::int32_t>();
        const auto number = bytes.next<std::int32_t>();
        if (number < 0 || std::size_t(number) >= kModels.size())
            bytes.entry().fail(tr("camera %1 has the model number %2, which is not known", id, number));
        const Model &model = kModels[std::size_t(number)];
        Camera camera{bytes.entry(), std::string(model.name)};
        camera.width = double(bytes.next<std::uint64_t>());
        camera.height = double(bytes.next<std::uint64_t>());
        for (std::size_t i = 0; i < model.parameters; ++i)
            camera.parameters.push_back(bytes.next<double>());
        found.cameras.emplace(id, std::move(camera));
    }
}

void readBinaryImages(const NamedText &file, Reconstruction &found)
{
    constexpr std::size_t kPoint = 24; // x, y and the id of a point
    Bytes bytes(file);
    for (auto count = bytes.next<std::uint64_t>(); count > 0; --count) {
        bytes.next<std::int32_t>(); // its id
        Image image{bytes.entry()};
        for (double &number : image.pose)
            number = bytes.next<double>();
        image.camera = bytes.next<std::int32_t>();
        image.name = bytes.nextName();
        bytes.skip(bytes.next<std::uint64_t>(), kPoint);
        found.images.push_back(std::move(image));
    }
}

Reconstruction reconstructionOf(std::span<const NamedText> texts)
{
    Reconstruction found;
    bool isBinary = false;
    for (const NamedText &file : texts) {
        const bool areCameras = file.name.ends_with("cameras.bin"), areImages = file.name.ends_with("images.bin");
        isBinary = isBinary || areImages;
        areCameras ? readBinaryCameras(file, found) : areImages ? readBinaryImages(file, found) : readText(file, found);
    }
    // A line alone is an image's without doubt only where its quaternion is one: a table of numbers
    // is none.
    const bool hasUnit = std::any_of(found.images.begin(), found.images.end(), [](const Image &image) {
        return std::abs(quaternionLength(image.pose) - 1.0) < kUnit;
    });
    if (found.cameras.empty() && !hasUnit && !isBinary)
        found.images.clear();
    return found;
}

void setPose(Reading &reading, const Image &image)
{
    const std::array<double, 7> &v = image.pose;
    for (const double number : v) {
        if (!std::isfinite(number))
            image.fail(tr("a number of the pose of %1 is not finite", image.name));
    }
    const auto rotation = rotationOf(v[0], v[1], v[2], v[3]);
    if (!rotation)
        image.fail(tr("the image's quaternion is 0; a rotation has the length 1"));
    if (const double length = quaternionLength(v); std::abs(length - 1.0) >= kUnit)
        reading.say(tr("The quaternion of %1 has the length %2 instead of 1; it is divided by it.", image.name,
                       base::significantText(length, 4)));
    reading.camera.pose = rigid(*rotation, {v[4], v[5], v[6]});
}

/// The camera's size, intrinsics and distortion.
void setLens(ForeignCamera &camera, const Camera &found)
{
    const Model *model = modelOf(found.model);
    if (!model || !model->isRead)
        found.fail(tr("the camera model %1 is not read: it is no pinhole with the distortion of Brown and Conrady. "
                      "Undistort the images with COLMAP's image_undistorter",
                      found.model));
    Numbers p = found.parameters;
    if (p.size() != model->parameters)
        found.fail(tr("%1 has %2 parameters; it needs %3", found.model, p.size(), model->parameters));
    if (!found.fault.empty())
        found.fail(found.fault);
    camera.size = sizeOf(found.width, found.height);
    if (!camera.size)
        found.fail(tr("width and height are %1 and %2; they must be whole numbers above 0",
                      base::shortestText(found.width), base::shortestText(found.height)));
    const bool hasOneFocal = model->name.starts_with("SIMPLE_") || model->name == "RADIAL";
    if (hasOneFocal)
        p.insert(p.begin(), p.front()); // fx = fy
    camera.intrinsics = Intrinsics{p[0], p[1], p[2], p[3], 0.0, PixelCentres::AtHalves};
    p.resize(12, 0.0);
    const Distortion distortion{p[4], p[5], p[6], p[7], p[8]};
    if (!areZero({p[9], p[10], p[11]}))
        found.fail(tr("FULL_OPENCV's k4, k5 and k6 are not read; undistort the images with COLMAP's "
                      "image_undistorter"));
    if (!distortion.isNone())
        camera.distortion = distortion;
}

// Source: COLMAP, src/colmap/geometry/rigid3.cc and src/colmap/scene/camera.cc, operator<<
Cameras printedPoses(Reading &reading, const Node &text)
{
    if (text.numbers("params", 3).empty() || !sizeIn(text))
        return {};
    Cameras poses = sections(reading, text, "Rigid3d(", "Rigid3d(");
    for (Found &one : poses) {
        one.lens = text;
        if (one.pose.numbers("rotationxyzw", 4).size() != 4 || one.pose.numbers("translation", 3).size() != 3)
            return {};
    }
    return poses;
}

void readPrinted(Reading &reading)
{
    const NamedValues &values = reading.lens.values();
    const Numbers p = reading.lens.numbers("params", 3), q = reading.pose.numbers("rotationxyzw", 4),
                  t = reading.pose.numbers("translation", 3);
    const ImageSize size = *sizeIn(reading.lens);
    std::string model = reading.lens.word("model");
    model.erase(0, model.rfind('.') + 1); // CameraModelId.PINHOLE
    const bool isUnknown = model.empty() || model == "Camera";
    if (isUnknown) { // older versions print no model
        const bool hasOneFocal = 2.0 * p[1] == size.width && 2.0 * p[2] == size.height;
        model = p.size() == 3   ? "SIMPLE_PINHOLE"
                : p.size() == 8 ? "OPENCV"
                : p.size() == 5 ? "RADIAL"
                : hasOneFocal   ? "SIMPLE_RADIAL"
                                : "PINHOLE";
    }
    if (!modelOf(model))
        reading.fail(tr("the camera model %1 is not known", model));
    const Entry entry{&reading.text, values.find({"params"}, 3)->line};
    setPose(reading, Image{entry, {q[3], q[0], q[1], q[2], t[0], t[1], t[2]}, 1, "image"});
    Camera camera{entry, model, double(size.width), double(size.height), p};
    if (!std::all_of(p.begin(), p.end(), [](double number) { return std::isfinite(number); }))
        camera.fault = tr("%1 is not a finite number", base::quoted("nan"));
    setLens(reading.camera, camera);
    const std::string &text = reading.text.text;
    if (text.find("cam_from_world") == text.npos && text.find("world_from_cam") != text.npos)
        reading.camera.direction = PoseDirection::CameraToWorld;
    if (isUnknown)
        reading.say(tr("The camera model is taken as %1, because the text names none.", model));
}

std::optional<ForeignCamera> readColmap(std::span<const NamedText> texts, const CameraChoices &choices)
{
    const Reconstruction found = reconstructionOf(texts);
    if (found.cameras.empty() && found.images.empty())
        return std::nullopt;
    if (found.images.empty())
        found.cameras.begin()->second.fail(tr("COLMAP's cameras have no poses; give images.txt or images.bin, too"));
    Reading reading(*found.images.front().file, choices);
    ForeignCamera &camera = reading.camera;
    reading.begin("COLMAP", {});
    for (const Image &image : found.images)
        camera.images.push_back(image.name);
    if (found.cameras.empty())
        reading.fail(tr("COLMAP's images have no focal lengths; give cameras.txt or cameras.bin, too"));
    reading.chooseImage();
    const Image &image = found.images[camera.image];
    setPose(reading, image);
    const auto lens = found.cameras.find(image.camera);
    if (lens == found.cameras.end())
        image.fail(tr("there is no camera %1 among COLMAP's cameras", image.camera));
    setLens(camera, lens->second);
    for (const NamedText &text : texts) {
        const auto isOf = [&text](const Entry &entry) { return entry.file == &text; };
        // points3D.txt has no camera.
        if (text.text.starts_with("# 3D point list") || text.name.ends_with("points3D.bin")
            || std::any_of(found.images.begin(), found.images.end(), isOf)
            || std::any_of(found.cameras.begin(), found.cameras.end(),
                           [&](const auto &one) { return isOf(one.second); }))
            camera.files.push_back(text.name);
    }
    return std::move(camera);
}

constexpr Form kForms[]{{.program = "COLMAP", .readAll = readColmap},
                        {"COLMAP", "Rigid3d( params", {}, printedPoses, readPrinted}};

} // namespace

std::span<const Form> colmapForms()
{
    return kForms;
}

} // namespace unprojector::cameras
