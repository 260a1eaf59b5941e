// OpenCV's cameras and ROS's camera_info.

#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/camera_values.h"
#include "core/cameras/lens.h"
#include "core/geometry/numbers.h"
#include "core/pipeline/printed_digits.h"

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace unprojector::cameras {
using base::shortestText;
using base::significantText;
using base::tr;
using geometry::Result;
namespace {

bool isNear(double value, double wanted, double scale)
{
    return std::abs(value - wanted) <= 1e-9 * scale;
}

/// K by its nine numbers, or fx, fy, cx, cy.
/// @param isTransposed  set if the numbers are by columns
Intrinsics intrinsicsOf(const CameraValue &value, std::vector<std::string> &assumed, bool &isTransposed)
{
    std::vector<double> k = value.numbers;
    if (k.size() == 4) {
        assumed.push_back(tr("The four numbers of %1 are read as fx, fy, cx, cy.", value.name));
        return {k[0], k[1], k[2], k[3]};
    }
    const double scale = std::max(std::abs(k[0]), std::abs(k[4]));
    isTransposed = (k[6] != 0.0 || k[7] != 0.0) && k[2] == 0.0 && k[5] == 0.0;
    if (isTransposed) {
        std::swap(k[1], k[3]);
        std::swap(k[2], k[6]);
        std::swap(k[5], k[7]);
        assumed.push_back(
            tr("%1 is transposed, as MATLAB's IntrinsicMatrix is: its columns are read as rows.", value.name));
    }
    if (!isNear(k[3], 0.0, scale) || !isNear(k[6], 0.0, scale) || !isNear(k[7], 0.0, scale) || k[8] == 0.0)
        throw value.error(tr("this is no camera matrix; it must have the rows fx skew cx, 0 fy cy, 0 0 1"));
    if (k[8] != 1.0) {
        assumed.push_back(tr("The last number of %1 is %2 instead of 1; all its numbers are divided by it.", value.name,
                             shortestText(k[8])));
        for (double &number : k)
            number /= k[8];
    }
    return {k[0], k[4], k[2], k[5], k[1]};
}

/// The rows of a P whose numbers are by columns.
std::vector<double> transposedP(const std::vector<double> &p)
{
    std::vector<double> rows;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            rows.push_back(p[3 * column + row]);
    }
    return rows;
}

/// Returns whether only the transposed P is a camera's: its pixels are rectangles, without a skew.
bool isTurned(const std::optional<CameraParts> &asWritten, const CameraParts &turned)
{
    const auto slant = [](const Intrinsics &k) { return std::abs(k.skew) / k.fx; };
    return slant(turned.intrinsics) < 1e-3 && (!asWritten || slant(asWritten->intrinsics) > 1e-2);
}

/// Returns whether a camera is turned against the world.
bool isTurnedAway(const CameraParts &parts)
{
    return pipeline::largestDifference(glm::dmat3(parts.cameraFromWorld), glm::dmat3(1.0)) > 1e-9;
}

/// Names of one focal length for both axes.
constexpr std::string_view kFocal = "f focal focallength focallengthpx focallengthpixels";

constexpr std::string_view kFx = "fx flx focallengthx focalx", kFy = "fy fly focallengthy focaly",
                           kCx = "cx ppx principalpointx x0 u0", kCy = "cy ppy principalpointy y0 v0";

constexpr const char *kNoNumber = base::marked("it has no number; give it, or leave the name out");

class Reader : Reading {
    using enum Part;

public:
    Reader(std::span<const NamedText> texts, const CameraChoices &chosen)
        : Reading(texts.front(), chosen), m_values(texts)
    {
        Reading::all = texts;
    }

    bool isRecognised() const
    {
        const bool hasFocal = (m_values.find(kFx) && m_values.find(kFy)) || hasFocalAndPrincipal() || hasOneFocal();
        // In other texts, a letter K may stand before a number.
        const CameraValue *unfit = m_values.unfit(Intrinsics);
        const bool isUnfit =
            unfit && unfit->numbers.size() >= 3 && base::isListed(" k cameramatrix ", plain(unfit->name));
        const bool hasVectors = has(Rotation) && plain(all(Rotation).front().name).starts_with("rvec");
        const bool hasAngles = hasAngle() && (has(Pose) || has(Rotation) || has(Quaternion));
        return has(Intrinsics) || has(CameraMatrix) || hasFocal || hasVectors || isUnfit || hasAngles || loneP();
    }

    /// The only matrix of 3 x 4 in a text, if it is K [R t] by its numbers; else null.
    const CameraValue *loneP() const
    {
        const std::vector<CameraValue> &poses = all(Pose), &others = all(Other);
        if (poses.size() + others.size() != 1)
            return nullptr;
        const CameraValue &value = poses.empty() ? others.front() : poses.front();
        const auto parts = value.numbers.size() == 12 ? partsOf(value.numbers) : std::nullopt;
        if (!parts || !value.arithmetic.empty())
            return nullptr;
        const auto &k = parts->intrinsics;
        constexpr double kLeast = 10.0, kMostSkew = 1e-3, kMostAspect = 2.0; // of a camera, in pixels
        const bool isLens = k.fx > kLeast && k.fy > kLeast && std::abs(k.skew) < kMostSkew * k.fx && k.cx > 0.0
                            && k.cy > 0.0 && k.fx < kMostAspect * k.fy && k.fy < kMostAspect * k.fx;
        return isLens ? &value : nullptr;
    }

    ForeignCamera read()
    {
        for (const NamedText &one : Reading::all) {
            if (m_values.hasAny(one.name))
                camera.files.push_back(one.name);
        }
        begin(m_values.isCameraInfo() ? "ROS camera_info" : "OpenCV", {});
        refuseBroken();
        chooseCamera(*this, m_values);
        if (has(Broken)) {
            const CameraValue &broken = all(Broken).front();
            throw broken.error(broken.numbers.empty() ? tr(kNoNumber)
                                                      : tr("it has %1 numbers; give one", broken.numbers.size()));
        }
        readIntrinsics();
        readSize();
        if (!camera.intrinsics && !has(CameraMatrix) && !loneP())
            readAngles();
        readPose();
        readDistortion();
        readClipDistances();
        reportUnused();
        for (const CameraValue *value : m_used) {
            if (std::ranges::find(camera.files, value->file) == camera.files.end())
                camera.files.push_back(value->file);
        }
        return std::move(camera);
    }

private:
    const std::vector<CameraValue> &all(Part part) const { return m_values.all(part); }
    bool has(Part part) const { return !all(part).empty(); }

    /// The value of the chosen image, or the one that all images share; null if there is none. It
    /// counts as used, and so do those of the other images.
    const CameraValue *valueOf(Part part)
    {
        const std::vector<CameraValue> &values = all(part);
        if (values.empty())
            return nullptr;
        const std::size_t images = m_values.cameras().empty() ? camera.images.size() : 0;
        const bool isOfImage = images > 1 && values.size() == images;
        if (isOfPose(part) && images > 1 && values.size() > 1 && !isOfImage)
            throw values.front().error(
                tr("the text has %1 of this, but %2 images; nothing tells which belong together. Give the text of one "
                   "camera",
                   values.size(), images));
        const CameraValue &value = values[isOfImage ? camera.image : 0];
        refuseComputed(part, value);
        note(part, value);
        if (isOfImage)
            setUsed({part});
        return &value;
    }

    /// Fails for a part that stands twice in one object, and for JSON that was cut off.
    void refuseBroken()
    {
        if (m_values.fault())
            throw *m_values.fault();
        for (std::size_t i = 0; i < Reading::all.size(); ++i) {
            const NamedText &one = Reading::all[i];
            const auto failHere = [&one](std::string reason, const CameraValue *at = nullptr) {
                throw base::Error{std::move(reason), at ? at->name : std::string(), one.name,
                                  at ? static_cast<int>(at->line) : 0};
            };
            if (one.text.find("PerspectiveCameras(") != std::string::npos) // x left, y up, row vectors
                failHere(tr("PyTorch3D's cameras are not read; convert them by its opencv_from_cameras_projection, "
                            "and give R, t and K"));
            const std::string_view whole = base::trimmed(one.text);
            if (whole.starts_with("<?xml") || whole.starts_with("<opencv_storage"))
                parsedXml(one); // throws
            const bool isJson = whole.starts_with('{') || whole.starts_with("[{");
            const Outline &outline = m_values.outline(i);
            if (outline.isOverclosed() && isJson)
                failHere(tr("a bracket closes that was not opened; one may be missing before it"));
            if (outline.isOverclosed())
                say(tr("A bracket closes that was not opened."));
            if (!outline.isUnclosed())
                continue;
            const bool isList = std::string_view(")]}").find(whole.back()) != whole.npos; // that ends
            if (const CameraValue *last = isList ? nullptr : m_values.lastPart(i); last || isJson)
                failHere(tr("the text ends before its brackets are closed; its last number may be cut off. Give the "
                            "whole text"),
                         last);
            say(tr("The text ends before its brackets are closed."));
        }
    }

    /// Notes a value as used, and what it gave.
    void note(Part part, const CameraValue &value)
    {
        using enum ReadValue::Of;
        static constexpr std::array<ReadValue::Of, kParts> kOf{Lens,       Lens,       Lens,  Pose,      Pose,
                                                               Pose,       Pose,       Pose,  Lens,      Distortion,
                                                               Distortion, Distortion, Image, Distortion};
        if (m_used.insert(&value).second)
            camera.read.push_back({kOf[std::size_t(part)], value.name, value.line});
    }

    void setUsed(std::initializer_list<Part> parts)
    {
        for (const Part part : parts) {
            for (const CameraValue &value : all(part))
                m_used.insert(&value);
        }
    }

    /// Names what looks like a part of a camera and was not used.
    void reportUnused()
    {
        constexpr std::size_t kMost = 5;
        std::vector<std::string> names;
        const auto report = [&](const CameraValue &value) {
            const bool isOne = value.numbers.size() == 1;
            if (value.numbers.empty() || m_used.contains(&value)
                || (isOne && (value.numbers[0] == 0.0 || !isScalarOfPart(value.name))))
                return;
            std::string said = isOne ? value.name + " = " + shortestText(value.numbers[0])
                                     : tr("%1 (%2 numbers)", value.name, value.numbers.size());
            if (std::ranges::count(names, said) == 0 && names.size() <= kMost)
                names.push_back(std::move(said));
        };
        for (std::size_t i = 0; i < kParts; ++i) {
            for (const CameraValue &value : all(Part(i)))
                report(value);
            if (const CameraValue *unfit = m_values.unfit(Part(i)))
                report(*unfit);
        }
        for (const Part part : {Other, Number})
            std::ranges::for_each(all(part), report);
        std::string list;
        for (std::size_t i = 0; i < names.size(); ++i)
            list += (i > 0 ? ", " : "") + (i < kMost ? names[i] : "…");
        if (!list.empty())
            say(tr("Not used: %1.", list));
    }

    /// Fails if a value's numbers are not those that it stands for: the text computes with them, one is
    /// not finite, or they have another unit.
    void refuseComputed(Part part, const CameraValue &value)
    {
        const bool isOfWorld =
            part >= Translation && part <= Pose && base::isListed(" mm cm m km inch inches ft um ", value.unit);
        if (!isOfWorld && !(part == Rotation && isInAngles(value)))
            refuseUnit(value);
        if (isOfWorld)
            sayUnit(value);
        const bool isVector = part == Distortion || part == Size || value.numbers.size() == 3;
        if (!value.arithmetic.empty() && !(isVector && value.arithmetic == ".T"))
            throw value.error(value.computedError().text);
        refuseNotFinite(value, value.numbers);
    }

    static void refuseNotFinite(const CameraValue &value, const std::vector<double> &numbers)
    {
        if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
            throw value.error(tr("a number is not finite"));
    }

    static bool isInAngles(const CameraValue &value)
    {
        return value.unit.starts_with("deg") || value.unit.starts_with("rad");
    }

    static void refuseUnit(const CameraValue &value)
    {
        if (!value.unit.empty())
            throw value.error(tr("its unit is %1, which is not known here; give numbers without a unit", value.unit));
    }

    void sayUnit(const CameraValue &value)
    {
        if (!value.unit.empty() && value.unit != "m")
            say(tr("%1 is in %2: this is the scene's unit.", value.name, value.unit));
    }

    /// Fails if the only values of a part have another count of numbers.
    void refuseUnfit(Part part, const std::string &wanted)
    {
        const CameraValue *unfit = m_values.unfit(part);
        if (!unfit || has(part))
            return;
        refuseComputed(part, *unfit);
        if (!unfit->decimal.empty())
            use(*unfit, false);
        throw unfit->error(tr("it has %1 numbers; %2", unfit->numbers.size(), wanted));
    }

    void readSize()
    {
        const CameraValue *given = valueOf(Size);
        std::optional<double> first, second;
        if (given) {
            first = given->numbers[0];
            second = given->numbers[1];
        } else {
            first = scalar("imagewidth imgwidth imgw width w", false);
            second = scalar("imageheight imgheight imgh height h", false);
        }
        const bool isHeightFirst = given && isHeightBefore(*given, *first, *second);
        camera.size = isHeightFirst ? sizeOf(second, first) : sizeOf(first, second);
        if (first && second && !camera.size && !choices.size) {
            std::string reason = tr("%1 and %2 are no size of an image; they must be whole numbers from 1 to 1000000",
                                    shortestText(*first), shortestText(*second));
            given ? throw given->error(std::move(reason)) : fail(std::move(reason));
        }
        if (first.has_value() != second.has_value())
            say(tr("The text gives only one side of the image, %1.", shortestText(first ? *first : *second)));
        if (isHeightFirst && camera.size && *first != *second)
            say(tr("%1 is read as height, width: the image is %2.", given->name, sizeText(*camera.size)));
    }

    /// Returns whether two sides are height, width: as twice the principal point tells where it is clear,
    /// else as the name tells.
    bool isHeightBefore(const CameraValue &value, double first, double second) const
    {
        if (!camera.intrinsics || camera.intrinsics->isCentreComputed)
            return value.role.areRowsFirst;
        const auto miss = [this](double width, double height) {
            return std::abs(2.0 * camera.intrinsics->cx / width - 1.0)
                   + std::abs(2.0 * camera.intrinsics->cy / height - 1.0);
        };
        constexpr double kClear = 3.0;
        const double asWritten = miss(first, second), turned = miss(second, first);
        return kClear * turned < asWritten || (value.role.areRowsFirst && !(kClear * asWritten < turned));
    }

    void readIntrinsics()
    {
        refuseUnfit(Intrinsics, tr("a camera matrix has nine, by rows"));
        if (const CameraValue *k = valueOf(Intrinsics)) {
            camera.intrinsics = intrinsicsOf(*k, camera.assumed, m_isTransposed);
            const CameraValue *fx = m_values.find("fx");
            if (fx && std::abs(fx->numbers[0] - camera.intrinsics->fx) > 1e-3)
                say(tr("%1 counts; fx, fy, cx and cy beside it are ignored.", k->name));
            countFromOne(k->name);
        } else if (const auto fx = scalar(kFx), fy = scalar(kFy); fx && fy) {
            const auto cx = scalar(kCx), cy = scalar(kCy);
            if (!cx || !cy)
                fail(tr("fx and fy are given without cx and cy; give all four"));
            setPinhole(*fx, *fy, *cx, *cy);
        } else if (hasFocalAndPrincipal()) {
            const CameraValue *focal = valueOf(Focal), *principal = valueOf(Principal);
            setPinhole(focal->numbers[0], focal->numbers[1], principal->numbers[0], principal->numbers[1]);
            countFromOne(principal->name);
        } else if (hasOneFocal()) {
            readOneFocal();
        } else if (!has(CameraMatrix) && !hasAngle() && !loneP()) {
            fail(tr("there is a pose, but no camera matrix; give K, nine numbers by rows"));
        }
    }

    void setPinhole(double fx, double fy, double cx, double cy)
    {
        camera.intrinsics = cameras::Intrinsics{fx, fy, cx, cy, skewBeside(fx)};
    }

    /// Words before a name in source code.
    static constexpr std::string_view kTypes = " double float const auto var let camera cam ";

    /// The skew under one of its names; of alpha_c, it is a factor of fx. A large number is another thing's.
    double skewBeside(double fx)
    {
        constexpr double kMost = 0.1; // of fx
        for (const char *known : {"skew", "alphac", "gamma", "s"}) {
            const CameraValue *value = m_values.find(known);
            const bool isOwn = value && (value->words.size() == 1 || base::isListed(kTypes, value->words.front()));
            if (!isOwn)
                continue;
            const double skew = use(*value, false) * (value->isNamed("alphac") ? fx : 1.0);
            if (!(std::abs(skew) <= kMost * fx)) {
                m_used.erase(value);
                continue;
            }
            if (skew != 0.0 && !value->isNamed("skew"))
                say(tr("%1 is read as the skew: %2 pixels.", value->name, significantText(skew, 6)));
            return skew;
        }
        return 0.0;
    }

    bool hasFocalAndPrincipal() const { return has(Focal) && has(Principal); }
    bool hasOneFocal() const
    {
        return m_values.find(kFocal) && !m_values.find(kFx) && !m_values.find(kFy)
               && (has(Principal) || (m_values.find(kCx) && m_values.find(kCy)));
    }

    /// One focal length for both axes, beside the principal point.
    void readOneFocal()
    {
        const CameraValue &value = *m_values.find(kFocal);
        const double focal = use(value);
        const CameraValue *principal = valueOf(Principal);
        const double cx = principal ? principal->numbers[0] : *scalar(kCx),
                     cy = principal ? principal->numbers[1] : *scalar(kCy);
        constexpr double kShort = 0.2; // of the image's half; in millimetres, it would be less
        if (!(focal > kShort * std::max(cx, cy)))
            throw value.error(
                tr("%1 is no focal length in pixels beside a principal point (%2, %3); give fx and fy in pixels",
                   shortestText(focal), shortestText(cx), shortestText(cy)));
        say(tr("%1 is read as fx and fy, in pixels.", value.name));
        setPinhole(focal, focal, cx, cy);
    }

    bool hasAngle() const { return angle("x") || angle("y"); }

    /// The angle of view along an axis of the image, "fov_x", "vfov_deg"; null if there is none.
    const CameraValue *angle(std::string_view axis) const
    {
        const bool isX = axis == "x";
        for (const CameraValue &value : all(Number)) {
            std::string axisName = plain(value.name);
            for (const std::string_view ending : {"degrees", "degree", "deg", "radians", "radian", "rad"}) {
                if (axisName.ends_with(ending))
                    axisName.resize(axisName.size() - ending.size());
            }
            if (base::isListed(isX ? " fovx xfov hfov fovh horizontalfov fovhorizontal horizontalfieldofview "
                                   : " fovy yfov vfov fovv verticalfov fovvertical verticalfieldofview ",
                               axisName))
                return &value;
        }
        return nullptr;
    }

    /// An angle in radians: in the unit that its name or the text tells, else by its size.
    double radians(const CameraValue &value)
    {
        const std::string told = plain(value.name) + value.unit;
        if (!isInAngles(value))
            refuseUnit(value);
        const double number = use(value, true, true);
        if (!(number > 0.0))
            throw value.error(tr("it is %1; an angle of view is greater than 0", shortestText(number)));
        camera.read.push_back({ReadValue::Of::Lens, value.name, value.line});
        if (told.find("rad") != told.npos)
            return number;
        const bool isInDegrees = told.find("deg") != told.npos;
        const bool areDegrees = isInDegrees || number > geometry::kPi;
        if (!isInDegrees)
            say(tr(areDegrees ? "%1 is read in degrees." : "%1 is read in radians.", value.name));
        return areDegrees ? geometry::radiansFromDegrees(number) : number;
    }

    void readAngles()
    {
        const CameraValue *across = angle("x"), *down = angle("y");
        if (across && down) {
            const double x = radians(*across), y = radians(*down);
            setVerticalAngle(y, std::tan(x / 2.0) / std::tan(y / 2.0));
        } else if (across) {
            setHorizontalAngle(radians(*across));
        } else {
            setVerticalAngle(radians(*down));
        }
    }

    /// MATLAB's pixels count from 1.
    void countFromOne(const std::string &given)
    {
        if (given != "IntrinsicMatrix" && given != "PrincipalPoint")
            return;
        camera.intrinsics->cx -= 1.0;
        camera.intrinsics->cy -= 1.0;
        say(tr("%1 is MATLAB's, whose pixels count from 1: here the principal point is (%2, %3).", given,
               shortestText(camera.intrinsics->cx), shortestText(camera.intrinsics->cy)));
    }

    /// A value's one number. Fails where the text computes with it, has others under a name, or gives it in
    /// another unit than pixels.
    /// @param isOfOne  the text has no other number with its name
    double use(const CameraValue &value, bool isOfOne = true, bool hasUnit = false)
    {
        if (!value.unit.empty() && !hasUnit)
            throw value.error(tr("it is in %1; give pixels", value.unit));
        const double number = value.number();
        refuseNotFinite(value, {number});
        if (isOfOne && m_values.differs(value))
            fail(tr("%1 has several values. Give the text of one camera", value.words.back()), value.line);
        m_used.insert(&value);
        return number;
    }

    /// The number under the first of some names, see use().
    std::optional<double> scalar(std::string_view names, bool isOfOne = true)
    {
        const CameraValue *value = m_values.find(names);
        return value ? std::optional(use(*value, isOfOne)) : std::nullopt;
    }

    void readPose()
    {
        const CameraValue *matrix = valueOf(CameraMatrix);
        if (!matrix && !camera.intrinsics && (matrix = loneP())) {
            note(CameraMatrix, *matrix);
            say(tr("The 12 numbers are read as P = K [R t]: they have the form of one."));
        }
        if (m_values.isCameraInfo())
            readRectification(*matrix);
        else if (matrix && !isOfRectified(*matrix))
            readCameraMatrix(*matrix);
        else
            readPoseOrParts();
        if (!camera.pose)
            readOther();
    }

    /// Takes the only rigid transform whose name says nothing as the pose: sceneCamera() asks for its
    /// direction.
    void readOther()
    {
        const CameraValue *found = nullptr;
        for (const CameraValue &value : all(Other)) {
            const auto matrix = value.numbers.size() == 9 ? std::nullopt : matrixByRows(value.numbers);
            const bool isRigid = matrix && (*matrix)[0][3] == 0.0 && (*matrix)[1][3] == 0.0 && (*matrix)[2][3] == 0.0
                                 && areOrthonormal(glm::dmat3(*matrix));
            if (!isRigid || hasPartWord(value.name))
                continue;
            if (found)
                throw value.error(
                    tr("it may be the pose, and so may %1; name the pose \"pose\" or \"extrinsic\"", found->name));
            found = &value;
        }
        if (!found)
            return;
        refuseComputed(Pose, *found);
        readPoseMatrix(*found);
        camera.isDirectionOpen = true;
        note(Part::Pose, *found);
    }

    void readPoseOrParts()
    {
        const std::vector<CameraValue> &poses = all(Pose);
        const bool hasParts = has(Rotation) && has(Translation);
        // Beside R and t, a view is OpenGL's matrix of the same pose.
        const bool isView = !poses.empty() && poses.front().role.axes && !poses.front().role.areAxesStated;
        if (!poses.empty() && !(isView && hasParts))
            readPoseMatrix(*valueOf(Pose));
        else
            readParts();
    }

    /// Returns whether a P beside K has no rotation and another lens, and says that K counts.
    bool isOfRectified(const CameraValue &value)
    {
        const std::optional<CameraParts> parts = partsOf(value.numbers);
        if (!camera.intrinsics || !parts || isTurnedAway(*parts))
            return false;
        const auto &k = *camera.intrinsics, &other = parts->intrinsics;
        const auto isSame = [&](double a, double b) { return std::abs(a - b) <= 1e-3 * k.fx; };
        if (isSame(k.fx, other.fx) && isSame(k.fy, other.fy) && isSame(k.cx, other.cx) && isSame(k.cy, other.cy))
            return false;
        say(tr("%1 has no rotation and another lens than K: it is of the rectified image, and K counts.", value.name));
        return true;
    }

    /// P = K [R t]. Where R is 1, P is of a rectified image, and another pose stands beside it.
    void readCameraMatrix(const CameraValue &value)
    {
        std::optional<CameraParts> parts = partsOf(value.numbers);
        if (const auto turned = partsOf(transposedP(value.numbers)); turned && isTurned(parts, *turned)) {
            parts = turned;
            say(tr("%1 is transposed, as MATLAB's cameraMatrix is: its columns are read as rows.", value.name));
        }
        if (!parts)
            throw value.error(tr("its first three columns have no inverse; a camera's P has one"));
        const bool hasPose = (has(Pose) && &value != all(Pose).data()) || has(Rotation) || has(Quaternion);
        const bool isRectified = hasPose && !isTurnedAway(*parts);
        if ((camera.intrinsics || hasPose) && !isRectified) {
            say(tr("%1 is K [R t]: it counts, and K, R and t beside it are ignored.", value.name));
            setUsed({Rotation, Translation, Pose});
        }
        camera.intrinsics = parts->intrinsics;
        camera.pose = parts->cameraFromWorld;
        // Rounding leaves a skew that no camera has.
        double &skew = camera.intrinsics->skew;
        if (skew != 0.0 && std::abs(skew) <= 1e-6 * camera.intrinsics->fx) {
            if (std::abs(skew) > 1e-12 * camera.intrinsics->fx)
                say(tr("%1 has a skew of %2 pixels, as rounded numbers make it; it is taken as 0.", value.name,
                       significantText(skew, 2)));
            skew = 0.0;
        }
        if (isRectified)
            readPoseBeside(value, glm::dvec3(parts->cameraFromWorld[3]));
    }

    /// Takes K from a P = K [1 t], and the pose from the values beside it.
    void readPoseBeside(const CameraValue &value, const glm::dvec3 &shift)
    {
        camera.pose.reset();
        readPoseOrParts();
        say(tr("%1 has no rotation: it gives K, and the pose beside it counts.", value.name));
        if (glm::length(shift) > 1e-9)
            say(tr("The shift of %1 by (%2, %3, %4) is not applied.", value.name, significantText(shift.x, 6),
                   significantText(shift.y, 6), significantText(shift.z, 6)));
    }

    void readPoseMatrix(const CameraValue &value)
    {
        camera.pose = *matrixByRows(value.numbers);
        setDirection(value, value.role);
        camera.isDirectionOpen = !value.role.direction;
        camera.areAxesCertain = value.role.areAxesStated;
        if (value.role.axes)
            camera.axes = *value.role.axes;
        if (has(Rotation)) {
            say(tr("%1 counts; R and t beside it are ignored.", value.name));
            setUsed({Rotation, Translation});
        }
    }

    /// Sets the pose's direction as a name tells or suggests it.
    void setDirection(const CameraValue &value, const Role &role)
    {
        camera.direction = role.direction.value_or(camera.direction);
        camera.isDirectionCertain = role.isDirectionStated;
        if (role.direction)
            camera.poseName = value.name;
        else
            camera.poseName.clear();
        if (!role.world.empty())
            say(tr("The scene's world is the frame \"%1\" of %2.", role.world, value.name));
    }

    void readParts()
    {
        refuseUnfit(Rotation, tr("a rotation has nine, by rows, or three of a rotation vector"));
        refuseUnfit(Translation, tr("a translation has three"));
        refuseUnfit(Pose, tr("a pose has twelve or sixteen, by rows"));
        const CameraValue *rotation = m_values.isCameraInfo() ? nullptr : valueOf(Rotation),
                          *translation = valueOf(Translation);
        if (!rotation)
            rotation = valueOf(Quaternion);
        const CameraValue *center = translation || !rotation ? nullptr : valueOf(Center),
                          *shift = translation ? translation : center;
        if (!rotation) {
            if (const CameraValue *list = m_values.unfit(Quaternion))
                throw list->error(tr("the order of a quaternion's four numbers is not known; name them, {x: 0, y: 0, "
                                     "z: 0, w: 1}, or give R"));
            refuseAngles();
            refuseEmpty({Rotation, Quaternion});
            if (!translation)
                return;
            say(tr("There is no rotation beside %1: none is assumed.", translation->name));
        }
        const glm::dmat3 turn = rotation ? turnOf(*rotation, translation) : glm::dmat3(1.0);
        setDirectionOfParts(rotation, shift);
        if (!shift)
            takeNoTranslation(*rotation);
        const glm::dvec3 at = shift ? vectorOf(shift->numbers) : glm::dvec3(0.0);
        camera.pose = rigid(turn, translation ? at : glm::dvec3(0.0));
        if (center) {
            camera.center = at;
            say(tr("%1 is the camera's position in the world.", center->name));
        }
    }

    glm::dmat3 turnOf(const CameraValue &rotation, const CameraValue *translation)
    {
        if (rotation.role.part == Quaternion)
            return turnOfQuaternion(rotation);
        if (rotation.numbers.size() == 3)
            return turnOfVector(rotation);
        auto turn = glm::dmat3(*matrixByRows(rotation.numbers));
        const bool isPrint = has(Principal) && all(Principal).front().name == "p";
        const bool isRealSense =
            (isPrint || m_values.find("ppx")) && plain(rotation.name) == "rotation"; // rs2_extrinsics
        const CameraValue *across = angle("x"), *down = angle("y");
        const bool isSplatting = across && down && (down->name == "FovY" || down->name == "FoVy")
                                 && (across->name == "FovX" || across->name == "FoVx") && translation
                                 && translation->name == "T"; // CameraInfo, Camera
        if (isRealSense || isSplatting || m_isTransposed) {
            turn = glm::transpose(turn);
            say(tr(isRealSense   ? "%1 is read by columns, as RealSense's rs2_extrinsics has it."
                   : isSplatting ? "%1 is read by columns, as the cameras of 3-D Gaussian splatting have it."
                                 : "%1 is read by columns, too.",
                   rotation.name));
        }
        if (glm::determinant(turn) < 0.0)
            throw rotation.error(tr("its determinant is %1: it mirrors. Check the sign of a row or a column",
                                    significantText(glm::determinant(turn), 3)));
        // solvePnP's vectors go from the world to the camera; R and t may be either.
        camera.isDirectionCertain = isSplatting;
        return turn;
    }

    glm::dmat3 turnOfQuaternion(const CameraValue &quaternion)
    {
        const auto turn = rotationOfXyzw(quaternion.numbers);
        if (!turn)
            throw quaternion.error(tr("x, y, z and w are 0; give a quaternion"));
        // A pose is the camera's in its parent; a transform may be either.
        camera.program = "ROS";
        camera.direction = PoseDirection::CameraToWorld;
        camera.isDirectionCertain = false;
        return *turn;
    }

    glm::dmat3 turnOfVector(const CameraValue &rotation)
    {
        const bool isVector = rotation.name.find("vec") != std::string::npos;
        const bool areDegrees =
            rotation.unit.starts_with("deg") || plain(rotation.name).find("deg") != std::string::npos;
        if (areDegrees && plain(rotation.name).find("vec") == std::string::npos)
            failAngles(rotation);
        const glm::dvec3 axis = (areDegrees ? geometry::radiansFromDegrees(1.0) : 1.0) * vectorOf(rotation.numbers);
        constexpr double kMostTurn = 6.2832; // 2 pi
        if (glm::length(axis) > kMostTurn)
            throw rotation.error(tr("its length is %1; a rotation vector in radians has at most 2 pi. Give R",
                                    significantText(glm::length(axis), 4)));
        if (!isVector)
            say(tr("The three numbers of %1 are read as a rotation vector, in radians.", rotation.name));
        return rotationOf(axis);
    }

    /// Takes 0, unless three numbers may be the translation.
    void takeNoTranslation(const CameraValue &rotation)
    {
        for (const CameraValue &value : all(Other)) {
            if (value.numbers.size() == 3 && hasPartWord(value.name))
                throw value.error(
                    tr("it may be the translation beside %1, but its name says more; name it t, in the world's "
                       "unit, or leave it out",
                       rotation.name));
        }
        for (const CameraValue &value : all(Number)) {
            if (base::isListed(" x y z tx ty tz ", plain(value.name)) && value.node == rotation.node
                && value.text == rotation.text && value.numbers[0] != 0.0)
                throw value.error(
                    tr("it may belong to the translation beside %1; give t or the camera's position C by its name",
                       rotation.name));
        }
        refuseEmpty({Translation, Center});
        say(tr("There is no translation beside %1: it is taken as 0.", rotation.name));
    }

    /// Fails for a name of a part that has something else than numbers: "R = f(x)", "R: [3x3 double]".
    void refuseEmpty(std::initializer_list<Part> parts) const
    {
        for (const CameraValue &value : all(Empty)) {
            if (std::ranges::find(parts, value.role.part) != parts.end())
                throw value.error(tr(kNoNumber));
        }
    }

    [[noreturn]] static void failAngles(const CameraValue &value)
    {
        throw value.error(
            tr("the rotation is given as angles, whose order and axes programs write differently; give a matrix "
               "or a quaternion"));
    }

    /// Fails for a position beside angles: without them, it would be the pose of a camera that is not
    /// turned.
    void refuseAngles() const
    {
        constexpr std::size_t kMost = 4; // numbers of a rotation
        const bool hasPosition = has(Translation) || has(Center);
        for (const Part part : {Other, Number}) {
            for (const CameraValue &value : all(part)) {
                const std::vector<double> &numbers = value.numbers;
                const std::vector<std::string> words = wordsOf(value.name);
                const auto hasAny = [&words](std::string_view list) {
                    return std::ranges::any_of(words,
                                               [list](const std::string &word) { return base::isListed(list, word); });
                };
                if (hasAny(" pixel dot sensor "))
                    continue;
                const bool isOfPose = hasPosition || hasAny(" pitch yaw roll rpy ypr euler eulers ");
                if (isOfPose && isAngle(value.name) && numbers.size() <= kMost
                    && std::ranges::any_of(numbers, [](double angle) { return angle != 0.0; }))
                    failAngles(value);
            }
        }
    }

    /// Sets the direction that the names of R and of t or C state. Fails where they state two.
    void setDirectionOfParts(const CameraValue *rotation, const CameraValue *shift)
    {
        const auto stated = [](const CameraValue *value) { // a position has no direction
            return value && value->role.isDirectionStated && value->role.part != Center;
        };
        if (stated(rotation) && stated(shift) && rotation->role.direction != shift->role.direction)
            throw shift->error(
                tr("its direction is not that of %1 beside it; give both in one direction", rotation->name));
        if (stated(rotation) || stated(shift))
            setDirection(stated(rotation) ? *rotation : *shift, stated(rotation) ? rotation->role : shift->role);
        else if (rotation && rotation->role.direction)
            setDirection(*rotation, rotation->role);
        else if (rotation && std::ranges::count(wordsOf(rotation->name), "ext") > 0) // camera_ext_R
            camera.isDirectionOpen = true;
        else if (shift && shift->role.part == Center)
            camera.direction = shift->role.direction.value_or(camera.direction);
    }

    /// ROS: the raw image is K's, with D; the rectified one is P's, turned by R.
    void readRectification(const CameraValue &p)
    {
        const std::optional<CameraParts> parts = partsOf(p.numbers);
        const auto number = [this](const char *of) {
            const CameraValue *value = m_values.find(of);
            return value ? value->number() : 0.0;
        };
        const double binning = number("binningx"), left = number("xoffset"), top = number("yoffset");
        if (binning > 1.0 || left != 0.0 || top != 0.0)
            say(tr("Binning and region of interest are not applied: pixels are those of the full "
                   "image."));
        setUsed({Rotation, CameraMatrix});
        if (const CameraValue *matrix = valueOf(Pose))
            readPoseMatrix(*matrix);
        else if (has(Quaternion))
            readParts();
        if (!choices.isUndistorted) {
            say(tr("Pixels are those of the raw image, so K counts; --undistorted takes P, for "
                   "the rectified one."));
            return;
        }
        if (!parts || camera.pose) {
            say(tr("P cannot be used here: K counts for the rectified image."));
            return;
        }
        say(tr("Pixels are those of the rectified image, so P and R count; K is ignored."));
        camera.intrinsics = parts->intrinsics;
        camera.intrinsics->skew = 0.0;
        const CameraValue *rectification = valueOf(Rotation);
        const bool hasTurn = rectification && rectification->numbers.size() == 9;
        camera.pose = parts->cameraFromWorld * (hasTurn ? *matrixByRows(rectification->numbers) : glm::dmat4(1.0));
    }

    void readDistortion()
    {
        const std::optional<CameraValue> list = coefficients(), model = unknownModel(list);
        if (!model && !list)
            return;
        const Result<cameras::Distortion, std::string> known =
            model ? unknownDistortionText(model->word) : distortionOf(list->numbers);
        if (known)
            camera.distortion = *known;
        else if (!choices.isUndistorted)
            throw(model ? *model : *list).error(known.error());
        else
            say(model ? tr("The distortion %1 is dropped: pixels are those of the undistorted image.", model->word)
                      : tr("The distortion coefficients are dropped: pixels are those of the undistorted image."));
    }

    /// The coefficients in OpenCV's order: a list, or numbers with their names.
    std::optional<CameraValue> coefficients()
    {
        if (const CameraValue *list = valueOf(Distortion))
            return *list;
        const CameraValue *radial = valueOf(Radial), *tangential = valueOf(Tangential);
        if (radial || tangential) { // MATLAB's
            CameraValue list = radial ? *radial : *tangential;
            std::vector<double> k = radial ? radial->numbers : std::vector<double>(),
                                p = tangential ? tangential->numbers : std::vector<double>();
            k.resize(3);
            p.resize(2);
            list.numbers = {k[0], k[1], p[0], p[1], k[2]};
            return list;
        }
        CameraValue list;
        list.file = text.name;
        for (const char *one : std::span(kCoefficients).first(8)) {
            const CameraValue *value = m_values.coefficient(one);
            list.numbers.push_back(value ? use(*value) : 0.0);
            if (value && (list.line == 0 || value->numbers[0] != 0.0)) {
                list.name = one;
                list.line = value->line;
            }
        }
        return list.line > 0 ? std::optional(list) : std::nullopt;
    }

    /// The first model whose coefficients are not read, or such a coefficient; nothing if there is none.
    std::optional<CameraValue> unknownModel(const std::optional<CameraValue> &list) const
    {
        for (const CameraValue &model : all(Model)) {
            if (!isKnown(model, list))
                return model;
        }
        for (const CameraValue &value : all(Number)) {
            if (value.numbers[0] == 0.0 || m_used.contains(&value) || coefficientOf(value.name).empty())
                continue;
            // The list's own, once more.
            const auto known = std::span(kCoefficients).first(5);
            const auto place = std::size_t(
                std::ranges::find_if(known, [&](const char *one) { return value.isNamed(one); }) - known.begin());
            if (list && place < std::min(known.size(), list->numbers.size())
                && list->numbers[place] == value.numbers[0])
                continue;
            CameraValue named = value;
            named.word = value.name + " = " + shortestText(value.numbers[0]);
            return named;
        }
        return std::nullopt;
    }

    /// Returns whether the coefficients of a model are Brown and Conrady's, as OpenCV has them.
    static bool isKnown(const CameraValue &model, const std::optional<CameraValue> &coefficients)
    {
        std::string name = plain(std::string_view(model.word).substr(model.word.rfind('.') + 1));
        if (name.starts_with("lensmodel")) // mrcal
            name.erase(0, std::string_view("lensmodel").size());
        if (base::isListed(kKnown, name))
            return true;
        // RealSense's other models are pinholes where all coefficients are 0.
        const bool isVariant = name == "inversebrownconrady" || name == "modifiedbrownconrady";
        return isVariant && coefficients
               && std::ranges::all_of(coefficients->numbers, [](double number) { return number == 0.0; });
    }

    void readClipDistances()
    {
        for (const auto &[names, distance] :
             {std::pair("znear near nearplane nearclip nearclipplane", &camera.nearDistance),
              std::pair("zfar far farplane farclip farclipplane", &camera.farDistance)}) {
            const CameraValue *value = m_values.find(names);
            if (!value)
                continue;
            *distance = value->number();
            sayUnit(*value);
        }
    }

    /// Models of a pinhole, and names of its distortion.
    static constexpr std::string_view kKnown =
        " pinhole perspective pinholeradtan simplepinhole opencv opencv4 opencv5 fullopencv none plumbbob radtan "
        "radialtangential brownconrady brown rationalpolynomial ";

    CameraValues m_values;
    bool m_isTransposed = false; ///< K is MATLAB's, so R is
    std::set<const CameraValue *> m_used;
};

} // namespace

std::optional<ForeignCamera> readNamedParts(std::span<const NamedText> texts, const CameraChoices &choices)
{
    Reader reader(texts, choices);
    if (!reader.isRecognised())
        return std::nullopt;
    return reader.read();
}

} // namespace unprojector::cameras
