#include "core/cameras/reader_parts.h"

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/lens.h"
#include "core/cameras/node.h"
#include "core/geometry/error_text.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace unprojector::cameras {
using base::shortestText;
using base::tr;
using geometry::kPi;

namespace {

/// The file's name in a path, with or without its suffix. The digits behind a time's point are none.
std::string_view fileName(std::string_view path, bool withSuffix)
{
    const std::size_t slash = path.find_last_of("/\\");
    if (slash != path.npos)
        path.remove_prefix(slash + 1);
    const std::size_t dot = path.rfind('.');
    const bool hasSuffix = dot != path.npos && path.find_first_not_of("0123456789", dot + 1) != path.npos;
    return withSuffix || !hasSuffix ? path : path.substr(0, dot);
}

std::string firstNames(const std::vector<std::string> &images)
{
    constexpr std::size_t kMost = 3;
    std::string list;
    for (std::size_t i = 0; i < std::min(images.size(), kMost); ++i)
        list += (i > 0 ? ", " : "") + images[i];
    return images.size() > kMost ? list + ", …" : list;
}

/// The indexes of the images that the user names: by the whole name, by an id, by the end of the path,
/// by the file's name with or without suffix, or by an index from 0.
std::vector<std::size_t> imageIndexes(std::span<const std::string> images, std::span<const std::string> ids,
                                      const std::string &choice)
{
    const auto isFile = [&](std::size_t i, bool withSuffix) {
        return fileName(images[i], withSuffix) == fileName(choice, withSuffix);
    };
    const std::array<std::function<bool(std::size_t)>, 5> ways{
        [&](std::size_t i) { return images[i] == choice; },
        [&](std::size_t i) { return i < ids.size() && ids[i] == choice; },
        [&](std::size_t i) { return images[i].ends_with('/' + choice); },
        [&](std::size_t i) { return isFile(i, true); }, [&](std::size_t i) { return isFile(i, false); }};
    for (const auto &isIt : ways) {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < images.size(); ++i) {
            if (isIt(i))
                found.push_back(i);
        }
        if (!found.empty())
            return found;
    }
    const auto number = base::integerFromWord(choice);
    if (number && *number >= 0 && *number < static_cast<long long>(images.size()))
        return {std::size_t(*number)};
    return {};
}

} // namespace

std::shared_ptr<const NamedValues> Reading::values()
{
    if (!m_values)
        m_values = std::make_shared<NamedValues>(text.text);
    return m_values;
}

void Reading::begin(const char *program, const Frame &frame)
{
    camera.program = program;
    camera.direction = frame.direction;
    camera.axes = frame.axes;
    camera.isDirectionCertain = camera.areAxesCertain = true;
}

void Reading::fail(std::string reason, std::size_t line) const
{
    throw base::Error{.text = std::move(reason), .file = text.name, .line = static_cast<int>(line)};
}

void Reading::chooseImage(std::span<const std::string> ids)
{
    if (camera.images.empty()) {
        if (!choices.image.empty() && choices.image != "0")
            fail(tr("there is one camera without a name; leave --image out"));
        return;
    }
    const std::vector<std::size_t> found =
        choices.image.empty() ? std::vector<std::size_t>{0} : imageIndexes(camera.images, ids, choices.image);
    if (found.empty())
        fail(tr("there is no image %1 among %2 (%3); give one of their names or an index from 0 with --image",
                base::quoted(choices.image), camera.images.size(), firstNames(camera.images)));
    if (found.size() > 1) {
        std::vector<std::string> names;
        names.reserve(found.size());
        for (const std::size_t index : found)
            names.push_back(camera.images[index]);
        fail(tr("%1 fits %2 images (%3); give more of its path, or its index from 0, with --image",
                base::quoted(choices.image), names.size(), firstNames(names)));
    }
    camera.image = found.front();
    if (choices.image.empty() && camera.images.size() > 1)
        say(tr("The first of %1 images is read, %2; --image NAME reads another.", camera.images.size(),
               camera.images.front()));
}

ImageSize Reading::neededSize() const
{
    if (!size())
        fail(noSizeText());
    return *size();
}

void Reading::setAngle(double radians, int ImageSize::*side)
{
    if (!(radians > 0.0 && radians < kPi))
        fail(tr("the field of view is %1 degrees; it must be greater than 0 and smaller than 180",
                base::significantText(geometry::degreesFromRadians(radians), 6)));
    const ImageSize image = neededSize();
    const double focal = image.*side / (2.0 * std::tan(radians / 2.0));
    setCentred(image, focal, focal);
}

void Reading::setVerticalAngle(double radians, const std::optional<double> &aspect)
{
    setAngle(radians, &ImageSize::height);
    if (!aspect)
        return;
    if (!(*aspect > 0.0))
        fail(tr("the aspect ratio is %1; it must be greater than 0", shortestText(*aspect)));
    const ImageSize image = neededSize();
    const double width = image.width, height = image.height;
    constexpr double kSame = 1e-3; // a printed aspect has few digits
    if (std::abs(*aspect * height / width - 1.0) > kSame) {
        camera.intrinsics->fx = camera.intrinsics->fy * width / (height * *aspect);
        say(tr("The aspect ratio is %1, but the image is %2: pixels are not square. Check the "
               "size; --size says another.",
               shortestText(*aspect), sizeText(image)));
    }
}

void Reading::setHorizontalAngle(double radians)
{
    setAngle(radians, &ImageSize::width);
}

void Reading::setSize(const Node &node, std::string_view keys)
{
    const Numbers sides = node.numbers(keys, 2);
    camera.size = sides.size() == 2 ? sizeOf(sides[0], sides[1]) : std::nullopt;
}

void Reading::setPlanes(const Node &node, std::string_view keys)
{
    if (const std::size_t blank = keys.find(' '); blank != keys.npos) {
        camera.nearDistance = node.number(keys.substr(0, blank));
        camera.farDistance = node.number(keys.substr(blank + 1));
    } else if (const Numbers range = node.numbers(keys, 2); range.size() == 2) {
        camera.nearDistance = range[0];
        camera.farDistance = range[1];
    }
}

void Reading::setLens(const Node &node, std::string_view keys, PixelCentres centres)
{
    const bool isK = keys.find(' ') == keys.npos;
    const Numbers k = node.needed(keys, isK ? 9 : 4);
    const bool isByColumns = isK && k[2] == 0.0 && k[5] == 0.0;
    if (isK && (k[8] != 1.0 || (isByColumns ? k[1] != 0.0 : k[3] != 0.0 || k[6] != 0.0 || k[7] != 0.0)))
        node.fail(tr("this is no camera matrix; it must have the rows fx skew cx, 0 fy cy, 0 0 1"), keys);
    camera.intrinsics = !isK          ? Intrinsics{k[0], k[1], k[2], k[3], 0.0, centres}
                        : isByColumns ? Intrinsics{k[0], k[4], k[6], k[7], k[3], centres}
                                      : Intrinsics{k[0], k[4], k[2], k[5], k[1], centres};
}

void Reading::setPose(const Node &node, std::string_view keys, std::size_t count, std::string_view at, bool isByColumns)
{
    const bool isShort = count == 16 && !isByColumns && node.numbers(keys, 12).size() == 12;
    const Numbers n = node.needed(keys, isShort ? 12 : count);
    if (count == 3) {
        camera.pose = rotationOf(vectorOf(n));
    } else if (count == 4 || count == 7) {
        const auto turn = count == 4 ? rotationOf(n[0], n[1], n[2], n[3]) : rotationOfXyzw(n);
        if (!turn)
            node.fail(tr("the image's quaternion is 0; a rotation has the length 1"), keys);
        camera.pose = count == 4 ? glm::dmat4(*turn) : rigid(*turn, vectorOf(n, 4));
    } else {
        camera.pose = matrixByRows(n);
    }
    if (isByColumns)
        camera.pose = glm::transpose(*camera.pose);
    if (!at.empty())
        (*camera.pose)[3] = glm::dvec4(node.vector(at), 1.0);
}

void Reading::setLooking(const glm::dvec3 &eye, const glm::dvec3 &back, const glm::dvec3 &up)
{
    camera.pose = looking(eye, back, up);
    if (!camera.pose)
        fail(tr("forward and up are parallel or 0; they give no axes"));
}

void Reading::setCentred(const ImageSize &image, double fx, double fy, double right, double down)
{
    camera.intrinsics =
        Intrinsics{fx, fy, image.width / 2.0 + right, image.height / 2.0 + down, 0.0, PixelCentres::AtHalves, true};
}

void Reading::setFlat(double height, double nearDistance, double farDistance)
{
    const ImageSize image = neededSize();
    const double y = height / 2.0, x = y * image.width / image.height;
    setProjection(geometry::Ortho{-x, x, -y, y, nearDistance, farDistance}, 0);
}

void Reading::setProjection(const geometry::Projection &projection, std::size_t line)
{
    const geometry::Result<glm::dmat4> clip = clipFromEye(projection);
    if (!clip)
        fail(geometry::errorText(clip.error()), line);
    camera.projection = geometry::MatrixProjection{*clip, geometry::NdcDepth::MinusOneToOne};
}

void setDistortion(Reading &reading, const std::string &model, std::optional<Numbers> coefficients)
{
    if (!coefficients) {
        if (!reading.choices.isUndistorted)
            reading.fail(tr("the camera model %1 is not read: it is no pinhole with the distortion of Brown "
                            "and Conrady. Undistort the images first, then give --undistorted",
                            model));
        return;
    }
    coefficients->resize(5, 0.0);
    const Numbers &c = *coefficients;
    if (const Distortion distortion{c[0], c[1], c[3], c[4], c[2]}; !distortion.isNone())
        reading.camera.distortion = distortion;
}

void setDistortion(Reading &reading, const Numbers &coefficients)
{
    if (coefficients.empty())
        return;
    const auto lens = distortionOf(coefficients);
    if (!lens && !reading.choices.isUndistorted)
        reading.fail(lens.error());
    if (lens && !lens->isNone())
        reading.camera.distortion = *lens;
}

bool areZero(const Numbers &numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == 0.0; });
}

void failWithoutLens(const Reading &reading)
{
    const std::vector<std::string> &images = reading.camera.images;
    reading.fail(tr("%1 has no intrinsics in the file; give a file that has them",
                    images.empty() ? tr("the camera") : images[reading.camera.image]));
}

void sayNoParent(Reading &reading, const char *transform)
{
    reading.say(tr("%1 counts as the camera's pose in the world, as for a camera without parent.", transform));
}

void sayUnity(Reading &reading)
{
    reading.camera.rightHandedFromWorld[2][2] = -1.0;
    reading.say(tr("Unity's world is left-handed. The scene has its z negated: the point (x, y, z) of Unity is "
                   "(x, y, -z) here."));
}

std::optional<ImageSize> sizeOf(std::optional<double> width, std::optional<double> height)
{
    constexpr double kMost = 1e6;
    const auto isWhole = [](const std::optional<double> &side) {
        return side && *side >= 1.0 && *side <= kMost && *side == std::floor(*side);
    };
    if (!isWhole(width) || !isWhole(height))
        return std::nullopt;
    return ImageSize{static_cast<int>(*width), static_cast<int>(*height)};
}

std::optional<ImageSize> sizeIn(const Node &text)
{
    const auto size = sizeOf(text.number("pixelwidth|viewportwidth|imagewidth|screenwidth|width|sizex|w"),
                             text.number("pixelheight|viewportheight|imageheight|screenheight|height|sizey|h"));
    for (const char *name : {"resolution", "imagesize", "viewportsize", "size", "screen", "viewport"}) {
        const Numbers n = text.numbers(name);
        if (!size && (n.size() == 2 || (n.size() == 4 && name == std::string_view("viewport")))) // x, y, width, height
            return sizeOf(n.end()[-2], n.end()[-1]);
    }
    return size;
}

std::string sizeText(const ImageSize &size)
{
    return std::to_string(size.width) + 'x' + std::to_string(size.height);
}

std::string noSizeText()
{
    return tr("the size of the image is not given; give it with --size 800x600");
}

std::string unknownDistortionText(const std::string &model)
{
    return tr("the distortion is %1; only k1, k2, p1, p2 and k3 of Brown and Conrady are known. Undistort the image "
              "with its own program, then give --undistorted",
              model);
}

std::optional<glm::dmat4> matrixByRows(std::span<const double> numbers)
{
    const std::size_t count = numbers.size();
    if (count != 9 && count != 12 && count != 16)
        return std::nullopt;
    const std::size_t columns = count == 9 ? 3 : 4;
    glm::dmat4 m(1.0);
    for (std::size_t i = 0; i < count; ++i)
        m[int(i % columns)][int(i / columns)] = numbers[i];
    return m;
}

std::optional<glm::dmat4> matrixByColumns(std::span<const double> numbers)
{
    const auto rows = numbers.size() == 16 ? matrixByRows(numbers) : std::nullopt;
    return rows ? std::optional(glm::transpose(*rows)) : std::nullopt;
}

std::optional<glm::dmat3> rotationOf(double w, double x, double y, double z)
{
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    if (!(length > 0.0) || !std::isfinite(length))
        return std::nullopt;
    w /= length;
    x /= length;
    y /= length;
    z /= length;
    return glm::dmat3(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y), 2.0 * (x * y - w * z),
                      1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x), 2.0 * (x * z + w * y), 2.0 * (y * z - w * x),
                      1.0 - 2.0 * (x * x + y * y));
}

std::optional<glm::dmat3> rotationOfXyzw(const Numbers &q)
{
    return rotationOf(q[3], q[0], q[1], q[2]);
}

glm::dmat3 about(int axis, double radians)
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    glm::dmat3 m(1.0);
    m[a][a] = m[b][b] = std::cos(radians);
    m[a][b] = std::sin(radians);
    m[b][a] = -m[a][b];
    return m;
}

glm::dmat4 rigid(const glm::dmat3 &rotation, const glm::dvec3 &translation)
{
    glm::dmat4 m(rotation);
    m[3] = glm::dvec4(translation, 1.0);
    return m;
}

std::optional<glm::dmat4> looking(const glm::dvec3 &eye, const glm::dvec3 &back, const glm::dvec3 &up)
{
    const glm::dvec3 right = glm::cross(up, back);
    if (!(glm::length(back) > 0.0) || !(glm::length(right) > 0.0))
        return std::nullopt;
    const glm::dvec3 x = glm::normalize(right), z = glm::normalize(back);
    return rigid(glm::dmat3(x, glm::cross(z, x), z), eye);
}

} // namespace unprojector::cameras
