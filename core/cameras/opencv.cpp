// OpenCV's cameras and ROS's camera_info.

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/lens.h"
#include "core/cameras/opencv_values.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unprojector::cameras {
using base::shortestText;
using base::significantText;
using base::tr;
using geometry::Result;
namespace {

[[noreturn]] void fail(const OpenCvValue &value, std::string reason)
{
    throw base::Error{std::move(reason), value.name, value.file, static_cast<int>(value.line)};
}

bool isNear(double value, double wanted, double scale)
{
    return std::abs(value - wanted) <= 1e-9 * scale;
}

/// K by its nine numbers, or fx, fy, cx, cy.
/// @param isTransposed  set if the numbers are by columns
Intrinsics intrinsicsOf(const OpenCvValue &value, std::vector<std::string> &assumed, bool &isTransposed)
{
    std::vector<double> k = value.numbers;
    if (k.size() == 4) {
        assumed.push_back(tr("The four numbers of %1 are read as fx, fy, cx, cy.", value.name));
        return {k[0], k[1], k[2], k[3], 0.0, PixelCentres::AtIntegers};
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
        fail(value, tr("this is no camera matrix; it must have the rows fx skew cx, 0 fy cy, 0 0 1"));
    if (k[8] != 1.0) {
        assumed.push_back(tr("The last number of %1 is %2 instead of 1; all its numbers are divided by it.", value.name,
                             shortestText(k[8])));
        for (double &number : k)
            number /= k[8];
    }
    return {k[0], k[4], k[2], k[5], k[1], PixelCentres::AtIntegers};
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

class Reader {
public:
    Reader(std::span<const NamedText> texts, const CameraChoices &choices)
        : m_values(texts), m_reading(texts.front(), choices)
    {
    }

    bool isRecognised() const
    {
        const auto has = [this](OpenCvPart part) { return !m_values.all(part).empty(); };
        const bool hasFocal = m_values.number({"fx"}) && m_values.number({"fy"});
        // In other texts, a letter K may stand before a number.
        const auto isNamed = [](const auto &value, const char *name) {
            return value && value->numbers.size() >= 3 && plain(value->name) == name;
        };
        const bool hasVectors = !m_values.all(OpenCvPart::Rotation).empty()
                                && plain(m_values.all(OpenCvPart::Rotation).front().name).starts_with("rvec");
        return has(OpenCvPart::Intrinsics) || has(OpenCvPart::CameraMatrix) || hasFocal || hasVectors
               || isNamed(m_values.unfit(OpenCvPart::Intrinsics), "k")
               || isNamed(m_values.unfit(OpenCvPart::Intrinsics), "cameramatrix");
    }

    ForeignCamera read()
    {
        m_reading.begin(m_values.isCameraInfo() ? "ROS camera_info" : "OpenCV", PoseDirection::WorldToCamera,
                        EyeAxes::RightDownAhead);
        countImages();
        readSize();
        readIntrinsics();
        readPose();
        readDistortion();
        readClipDistances();
        return std::move(m_camera);
    }

private:
    /// The value of the chosen image, or the one that all images share; null if there is none.
    const OpenCvValue *valueOf(OpenCvPart part) const
    {
        const std::vector<OpenCvValue> &values = m_values.all(part);
        if (values.empty())
            return nullptr;
        const OpenCvValue &value = values[std::min(m_camera.image, values.size() - 1)];
        refuseComputed(part, value);
        return &value;
    }

    /// Fails if a value's numbers are not those that it stands for: the text computes with them, or
    /// one is not finite.
    static void refuseComputed(OpenCvPart part, const OpenCvValue &value)
    {
        const bool isVector = part == OpenCvPart::Distortion || part == OpenCvPart::Size || value.numbers.size() == 3;
        if (!value.arithmetic.empty() && !(isVector && value.arithmetic == ".T"))
            fail(value,
                 tr("the text computes with it (%1), and only numbers are read; write the result", value.arithmetic));
        if (!std::all_of(value.numbers.begin(), value.numbers.end(),
                         [](double number) { return std::isfinite(number); }))
            fail(value, tr("a number is not finite"));
    }

    /// Fails if the only values of a part have another count of numbers.
    void refuseUnfit(OpenCvPart part, const std::string &wanted) const
    {
        const auto &unfit = m_values.unfit(part);
        if (!unfit || !m_values.all(part).empty())
            return;
        refuseComputed(part, *unfit);
        fail(*unfit, tr("it has %1 numbers; %2", unfit->numbers.size(), wanted));
    }

    void countImages()
    {
        std::size_t count = 1;
        for (const OpenCvPart part : {OpenCvPart::Rotation, OpenCvPart::Quaternion, OpenCvPart::Translation,
                                      OpenCvPart::Pose, OpenCvPart::CameraMatrix})
            count = std::max(count, m_values.all(part).size());
        if (hasSeveralLenses()) {
            refuseMixed();
            count = std::max(count, m_values.all(OpenCvPart::Intrinsics).size());
        }
        if (m_values.isCameraInfo())
            count = m_values.all(OpenCvPart::Intrinsics).size();
        for (std::size_t i = 0; count > 1 && i < count; ++i)
            m_camera.images.push_back(std::to_string(i));
        if (count == 1 && (m_reading.choices.image.empty() || m_reading.choices.image == "0"))
            return;
        if (count == 1)
            m_reading.fail(tr("there is one camera without a name; leave --image out"));
        m_reading.chooseImage();
    }

    /// Returns whether the text has several K that differ.
    bool hasSeveralLenses() const
    {
        const std::vector<OpenCvValue> &all = m_values.all(OpenCvPart::Intrinsics);
        return std::any_of(all.begin(), all.end(),
                           [&all](const OpenCvValue &k) { return k.numbers != all.front().numbers; });
    }

    /// Fails if several K stand beside fewer or more parts of another kind: nothing tells which
    /// belong together.
    void refuseMixed() const
    {
        const std::size_t count = m_values.all(OpenCvPart::Intrinsics).size();
        for (const OpenCvPart part : {OpenCvPart::Rotation, OpenCvPart::Quaternion, OpenCvPart::Translation,
                                      OpenCvPart::Pose, OpenCvPart::Distortion}) {
            const std::vector<OpenCvValue> &values = m_values.all(part);
            if (!values.empty() && values.size() != count)
                fail(values.front(), tr("the text has %1 camera matrices, but %2 of this. Give the text of one camera",
                                        count, values.size()));
        }
    }

    void readSize()
    {
        if (const OpenCvValue *size = valueOf(OpenCvPart::Size))
            m_camera.size = sizeOf(size->numbers[0], size->numbers[1]);
        else
            m_camera.size = sizeOf(m_values.number({"imagewidth", "imgwidth", "width", "w"}),
                                   m_values.number({"imageheight", "imgheight", "height", "h"}));
    }

    void readIntrinsics()
    {
        refuseUnfit(OpenCvPart::Intrinsics, tr("a camera matrix has nine, by rows"));
        if (const OpenCvValue *k = valueOf(OpenCvPart::Intrinsics)) {
            m_camera.intrinsics = intrinsicsOf(*k, m_camera.assumed, m_isTransposed);
        } else if (const auto fx = m_values.number({"fx"}), fy = m_values.number({"fy"}); fx && fy) {
            for (const char *name : {"fx", "fy", "cx", "cy", "ppx", "ppy"}) {
                if (m_values.differ(name))
                    m_reading.fail(tr("%1 has several values. Give the text of one camera", name),
                                   m_values.find(name)->line);
            }
            for (const char *name : {"fx", "fy", "cx", "cy", "ppx", "ppy"}) {
                const NamedValue *value = m_values.find(name);
                if (value && !value->arithmetic.empty())
                    m_reading.fail(tr("%1: the text computes with it (%2), and only numbers are read; write the result",
                                      name, value->arithmetic),
                                   value->line);
            }
            const auto cx = m_values.number({"cx", "ppx"}), cy = m_values.number({"cy", "ppy"});
            if (!cx || !cy)
                m_reading.fail(tr("fx and fy are given without cx and cy; give all four"));
            m_camera.intrinsics =
                Intrinsics{*fx, *fy, *cx, *cy, m_values.number({"skew"}).value_or(0.0), PixelCentres::AtIntegers};
        } else if (m_values.all(OpenCvPart::CameraMatrix).empty()) {
            m_reading.fail(tr("there is a pose, but no camera matrix; give K, nine numbers by rows"));
        }
    }

    void readPose()
    {
        const OpenCvValue *matrix = valueOf(OpenCvPart::CameraMatrix);
        if (m_values.isCameraInfo())
            readRectification(*matrix);
        else if (matrix)
            readCameraMatrix(*matrix);
        else if (const OpenCvValue *pose = valueOf(OpenCvPart::Pose))
            readPoseMatrix(*pose);
        else
            readParts();
    }

    /// P = K [R t].
    void readCameraMatrix(const OpenCvValue &value)
    {
        std::optional<CameraParts> parts = partsOf(value.numbers);
        if (const auto turned = partsOf(transposedP(value.numbers)); turned && isTurned(parts, *turned)) {
            parts = turned;
            m_camera.assumed.push_back(
                tr("%1 is transposed, as MATLAB's cameraMatrix is: its columns are read as rows.", value.name));
        }
        if (!parts)
            fail(value, tr("its first three columns have no inverse; a camera's P has one"));
        const bool hasOthers = m_camera.intrinsics || !m_values.all(OpenCvPart::Rotation).empty()
                               || !m_values.all(OpenCvPart::Pose).empty();
        if (hasOthers)
            m_camera.assumed.push_back(
                tr("%1 is K [R t]: it counts, and K, R and t beside it are ignored.", value.name));
        m_camera.intrinsics = parts->intrinsics;
        m_camera.pose = parts->cameraFromWorld;
        // Rounding leaves a skew that no camera has.
        double &skew = m_camera.intrinsics->skew;
        if (skew != 0.0 && std::abs(skew) <= 1e-6 * m_camera.intrinsics->fx) {
            if (std::abs(skew) > 1e-12 * m_camera.intrinsics->fx)
                m_camera.assumed.push_back(
                    tr("%1 has a skew of %2 pixels, as rounded numbers make it; it is taken as 0.", value.name,
                       significantText(skew, 2)));
            skew = 0.0;
        }
    }

    void readPoseMatrix(const OpenCvValue &value)
    {
        m_camera.pose = *matrixByRows(value.numbers);
        const std::string name = plain(value.name);
        const auto ends = [&name](std::initializer_list<const char *> with) {
            return std::any_of(with.begin(), with.end(), [&](const char *end) { return name.ends_with(end); });
        };
        const bool isToWorld = ends({"c2w", "cam2world", "cam2worldgl", "camtoworld", "cameratoworld", "twc"}),
                   isToCamera = ends({"w2c", "world2cam", "worldtocam", "worldtocamera", "tcw"});
        if (isToWorld || ends({"pose"}))
            m_camera.direction = PoseDirection::CameraToWorld;
        m_camera.isDirectionCertain = isToWorld || isToCamera;
        m_camera.areAxesCertain = ends({"gl", "cv", "rt"});
        if (ends({"gl"}))
            m_camera.axes = EyeAxes::RightUpBack;
        if (!m_values.all(OpenCvPart::Rotation).empty())
            m_camera.assumed.push_back(tr("%1 counts; R and t beside it are ignored.", value.name));
    }

    void readParts()
    {
        refuseUnfit(OpenCvPart::Rotation, tr("a rotation has nine, by rows, or three of a rotation vector"));
        refuseUnfit(OpenCvPart::Translation, tr("a translation has three"));
        refuseUnfit(OpenCvPart::Pose, tr("a pose has twelve or sixteen, by rows"));
        const OpenCvValue *rotation = valueOf(OpenCvPart::Rotation), *translation = valueOf(OpenCvPart::Translation),
                          *quaternion = rotation ? nullptr : valueOf(OpenCvPart::Quaternion);
        if (const auto &list = m_values.unfit(OpenCvPart::Quaternion); list && !rotation && !quaternion)
            fail(*list, tr("the order of a quaternion's four numbers is not known; name them, {x: 0, y: 0, z: 0, w: "
                           "1}, or give R"));
        if (!rotation && !quaternion && !translation)
            return;
        glm::dmat3 turn(1.0);
        if (quaternion) {
            const std::vector<double> &q = quaternion->numbers;
            const auto turned = rotationOf(q[3], q[0], q[1], q[2]);
            if (!turned)
                fail(*quaternion, tr("x, y, z and w are 0; give a quaternion"));
            turn = *turned;
            // A pose is the camera's in its parent; a transform may be either.
            m_camera.program = "ROS";
            m_camera.direction = PoseDirection::CameraToWorld;
            m_camera.isDirectionCertain = false;
            rotation = quaternion;
        } else if (!rotation) {
            m_camera.assumed.push_back(tr("There is no rotation beside %1: none is assumed.", translation->name));
        } else if (rotation->numbers.size() == 3) {
            turn = rotationOf(glm::dvec3(rotation->numbers[0], rotation->numbers[1], rotation->numbers[2]));
        } else {
            turn = glm::dmat3(*matrixByRows(rotation->numbers));
            if (m_isTransposed) {
                turn = glm::transpose(turn);
                m_camera.assumed.push_back(tr("%1 is read by columns, too.", rotation->name));
            }
            if (glm::determinant(turn) < 0.0)
                fail(*rotation, tr("its determinant is %1: it mirrors. Check the sign of a row or a column",
                                   significantText(glm::determinant(turn), 3)));
            // solvePnP's vectors go from the world to the camera; R and t may be either.
            m_camera.isDirectionCertain = false;
        }
        glm::dvec3 shift(0.0);
        if (translation)
            shift = {translation->numbers[0], translation->numbers[1], translation->numbers[2]};
        else
            m_camera.assumed.push_back(tr("There is no translation beside %1: it is taken as 0.", rotation->name));
        m_camera.pose = rigid(turn, shift);
    }

    /// ROS: the raw image is K's, with D; the rectified one is P's, turned by R.
    void readRectification(const OpenCvValue &p)
    {
        const std::optional<CameraParts> parts = partsOf(p.numbers);
        const std::optional<double> binning = m_values.number({"binningx"}), left = m_values.number({"xoffset"}),
                                    top = m_values.number({"yoffset"});
        if (binning.value_or(0.0) > 1.0 || left.value_or(0.0) != 0.0 || top.value_or(0.0) != 0.0)
            m_camera.assumed.push_back(
                tr("Binning and region of interest are not applied: pixels are those of the full "
                   "image."));
        if (const OpenCvValue *pose = valueOf(OpenCvPart::Pose))
            readPoseMatrix(*pose);
        if (!m_reading.choices.isUndistorted) {
            m_camera.assumed.push_back(tr("Pixels are those of the raw image, so K counts; --undistorted takes P, for "
                                          "the rectified one."));
            return;
        }
        if (!parts || m_camera.pose) {
            m_camera.assumed.push_back(tr("P cannot be used here: K counts for the rectified image."));
            return;
        }
        m_camera.assumed.push_back(tr("Pixels are those of the rectified image, so P and R count; K is ignored."));
        m_camera.intrinsics = parts->intrinsics;
        m_camera.intrinsics->skew = 0.0;
        const OpenCvValue *rectification = valueOf(OpenCvPart::Rotation);
        const bool hasTurn = rectification && rectification->numbers.size() == 9;
        m_camera.pose = parts->cameraFromWorld * (hasTurn ? *matrixByRows(rectification->numbers) : glm::dmat4(1.0));
    }

    void readDistortion()
    {
        const std::optional<OpenCvValue> list = coefficients();
        if (const auto model = unknownModel(list)) {
            if (!m_reading.choices.isUndistorted)
                fail(*model, tr("the distortion is %1; only k1, k2, p1, p2 and k3 of Brown and Conrady are known. "
                                "Undistort the image with its own program, then give --undistorted",
                                model->word));
            m_camera.assumed.push_back(
                tr("The distortion %1 is dropped: pixels are those of the undistorted image.", model->word));
            return;
        }
        if (!list)
            return;
        const Result<Distortion, std::string> lens = distortionOf(list->numbers);
        if (lens)
            m_camera.distortion = *lens;
        else if (!m_reading.choices.isUndistorted)
            fail(*list, lens.error());
        else
            m_camera.assumed.push_back(tr("The distortion coefficients are dropped: pixels are those of the "
                                          "undistorted image."));
    }

    /// The coefficients in OpenCV's order: a list, or numbers with their names.
    std::optional<OpenCvValue> coefficients() const
    {
        if (const OpenCvValue *list = valueOf(OpenCvPart::Distortion))
            return *list;
        OpenCvValue named{{}, {}, {}, 0, m_reading.text.name};
        for (const char *name : {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"}) {
            const NamedValue *value = m_values.find(name);
            named.numbers.push_back(value ? value->numbers[0] : 0.0);
            if (value && (named.line == 0 || value->numbers[0] != 0.0)) {
                named.name = name;
                named.line = value->line;
            }
        }
        return named.line > 0 ? std::optional(named) : std::nullopt;
    }

    /// The first model whose coefficients are not read; nothing if there is none.
    std::optional<OpenCvValue> unknownModel(const std::optional<OpenCvValue> &list) const
    {
        for (const OpenCvValue &model : m_values.all(OpenCvPart::Model)) {
            if (!isKnown(model, list))
                return model;
        }
        for (const char *name : {"fisheyemodel", "isfisheye"}) { // OpenCV's calibration sample, NeRF
            const NamedValue *flag = m_values.find(name);
            if (flag && flag->numbers[0] != 0.0)
                return OpenCvValue{name, "fisheye", {}, flag->line, m_reading.text.name};
        }
        return std::nullopt;
    }

    /// Returns whether the coefficients of a model are Brown and Conrady's, as OpenCV has them.
    static bool isKnown(const OpenCvValue &model, const std::optional<OpenCvValue> &coefficients)
    {
        const std::string name = plain(std::string_view(model.word).substr(model.word.rfind('.') + 1));
        if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end())
            return true;
        // RealSense's other models are pinholes where all coefficients are 0.
        const bool isVariant = name == "inversebrownconrady" || name == "modifiedbrownconrady";
        return isVariant && coefficients
               && std::all_of(coefficients->numbers.begin(), coefficients->numbers.end(),
                              [](double number) { return number == 0.0; });
    }

    void readClipDistances()
    {
        m_camera.nearDistance = m_values.number({"znear", "nearplane", "nearclip", "nearclipplane"});
        m_camera.farDistance = m_values.number({"zfar", "farplane", "farclip", "farclipplane"});
    }

    /// Models of a pinhole, and names of its distortion.
    static constexpr std::array<std::string_view, 13> kKnown{
        "pinhole",  "perspective", "pinholeradtan",    "simplepinhole", "opencv", "fullopencv",        "none",
        "plumbbob", "radtan",      "radialtangential", "brownconrady",  "brown",  "rationalpolynomial"};

    OpenCvValues m_values;
    Reading m_reading;
    ForeignCamera &m_camera = m_reading.camera;
    bool m_isTransposed = false; ///< K is MATLAB's, so R is
};

/// Fails for a text with the two camera matrices of a stereo pair and no other.
void refuseStereo(std::span<const NamedText> texts, const CameraChoices &choices)
{
    for (const NamedText &text : texts) {
        Reading reading(text, choices);
        for (const char *name : {"k1", "k2", "cameramatrix1", "cameramatrix2", "mtx1", "mtx2", "m1", "m2"}) {
            const NamedValue *value = reading.values().find({name});
            if (value && value->numbers.size() == 9)
                reading.fail(tr("%1 is of a stereo pair; give one camera, its matrix under the name K", name),
                             value->line);
        }
    }
}

} // namespace

std::optional<ForeignCamera> readOpenCv(std::span<const NamedText> texts, const CameraChoices &choices)
{
    Reader reader(texts, choices);
    if (reader.isRecognised())
        return reader.read();
    refuseStereo(texts, choices);
    return std::nullopt;
}

} // namespace unprojector::cameras
