// OpenCV's and ROS's cameras: a scene of one projects points to the pixels of cv2.projectPoints.

#include "tests/support/test.h"

#include "core/cameras/camera_reader.h"
#include "core/cameras/lens.h"
#include "core/geometry/setup.h"
#include "core/unproject/unprojector.h"
#include "tests/core/cameras/opencv_camera.h"
#include "tests/support/oracle.h"
#include "tests/support/random_scene.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::cameras;
using geometry::Box;

namespace {

const std::string kPlainK = "K = [[800, 0, 319.5], [0, 800, 239.5], [0, 0, 1]]\n";
const std::string kSize = "width = 640\nheight = 480\n";

std::string join(const std::vector<std::string> &sentences)
{
    std::string text;
    for (const std::string &sentence : sentences)
        text += sentence + '\n';
    return text;
}

base::Expected<ForeignCamera, base::Error> read(const std::string &text, const CameraChoices &choices = {})
{
    const auto camera = readCamera(std::vector<NamedText>{{"camera.txt", text}}, choices);
    return camera ? *camera : base::Error{"not recognised"};
}

/// The scene's camera of a text; fails the test where there is none.
SceneCamera sceneOf(const std::string &text, const CameraChoices &choices = {},
                    const std::optional<Box> &objects = std::nullopt)
{
    const auto camera = read(text, choices);
    if (!camera) {
        QTest::qFail(camera.error().message().c_str(), __FILE__, __LINE__);
        return {};
    }
    const auto scene = sceneCamera(*camera, choices, objects);
    if (!scene) {
        QTest::qFail(scene.error().message().c_str(), __FILE__, __LINE__);
        return {};
    }
    return *scene;
}

QString reasonOf(const std::string &text, const CameraChoices &choices = {})
{
    const auto camera = read(text, choices);
    if (!camera)
        return QString::fromStdString(base::Error{camera.error().text, camera.error().subject}.message())
               + QStringLiteral(" @%1").arg(camera.error().line);
    const auto scene = sceneCamera(*camera, choices, std::nullopt);
    return scene ? QString() : QString::fromStdString(scene.error().text);
}

/// The pixel of a world point, counted from the image's top-left corner.
glm::dvec2 pixelOf(const SceneCamera &scene, const glm::dvec3 &world)
{
    const geometry::Surface surface{scene.size.width, scene.size.height, 1.0};
    const geometry::Setup setup{surface, geometry::wholeSurface(surface), {}, scene.projection, scene.eyeFromWorld};
    const auto window = geometry::windowFromWorld(setup, geometry::WorldPoint(world));
    if (!window)
        return glm::dvec2(std::nan(""));
    const geometry::DevicePoint pixel = geometry::deviceFromWindow(surface, *window);
    return pixel.coordinates();
}

double largestMiss(const SceneCamera &scene)
{
    double largest = 0.0;
    for (const auto &point : opencv_camera::kProjected) {
        const double miss = glm::length(pixelOf(scene, point.world) - 0.5 - point.pixel) / glm::length(point.pixel);
        largest = std::max(largest, std::isnan(miss) ? 1e300 : miss);
    }
    return largest;
}

Box boxAround(const glm::dvec3 &centre, double half)
{
    return {centre - half, centre + half};
}

CameraChoices choicesOf(const std::string &image)
{
    CameraChoices choices;
    choices.image = image;
    return choices;
}

CameraChoices undistorted()
{
    CameraChoices choices;
    choices.isUndistorted = true;
    return choices;
}

} // namespace

class TestOpencvCameras : public QObject {
    Q_OBJECT

private slots:
    void pixelsAreThoseOfProjectPoints_data()
    {
        using namespace opencv_camera;
        addColumn<QString>("text");
        addColumn<QString>("image");
        newRow("cv::FileStorage, YAML") << kYaml << QString();
        newRow("cv::FileStorage, XML") << kXml << QString();
        newRow("cv::FileStorage, JSON") << kJson << QString();
        newRow("NumPy, printed") << kNumPy << QString();
        newRow("NumPy, repr, with vectors") << kReprs << QString();
        newRow("C++") << kCpp << QString();
        newRow("cv::Mat, printed") << "size: 640x480\ncamera matrix:\n[812.3456789, 0, 331.25;\n 0, 805.125, "
                                      "236.875;\n 0, 0, 1]\nrvec:\n[0.31;\n "
                                      "-0.52;\n 0.113]\ntvec:\n[0.2;\n -0.1;\n 6.5]\n"
                                   << QString();
        newRow("MATLAB, with a common factor, transposed")
            << "IntrinsicMatrix =\n\n   1.0e+02 *\n\n   8.123456789 0 0\n   0 8.05125 0\n   3.3225 2.37875 "
               "0.01\n\nrvec = "
               "0.31 "
               "-0.52 0.113\ntvec = 0.2 -0.1 6.5\nImageSize = [640 480]\n"
            << QString();
        newRow("fx, fy, cx, cy") << "width: 640 height: 480 fx: 812.3456789 fy: 805.125 ppx: 331.25 ppy: 236.875\n"
                                    "rvec = (0.31, -0.52, 0.113), tvec = (0.2, -0.1, 6.5)\n"
                                 << QString();
        newRow("P = K [R t]") << kMatrixP << QString();
        newRow("OpenCV's calibration, second view") << kCalibration << "1";
    }

    void pixelsAreThoseOfProjectPoints()
    {
        QFETCH(QString, text);
        QFETCH(QString, image);
        const SceneCamera scene = sceneOf(text.toStdString(), choicesOf(image.toStdString()));
        QCOMPARE(scene.size, (ImageSize{640, 480}));
        QVERIFY2(largestMiss(scene) <= 1e-12, qPrintable(QString::number(largestMiss(scene))));
    }

    /// Any scale and sign of P is the same camera.
    void pAloneIsSplit()
    {
        const std::string text = "P = -80 0 -32 -100  0 -80 -24 20  0 0 -0.1 -0.5\n" + kSize;
        const SceneCamera scene = sceneOf(text);
        QVERIFY(glm::length(pixelOf(scene, {0, 0, 0}) - glm::dvec2(200.5, -39.5)) <= 1e-10);
        QVERIFY(glm::determinant(glm::dmat3(scene.eyeFromWorld)) > 0.99);
    }

    /// R and t alone do not tell their direction: a camera at (0, 0, -5) looks along z either way only
    /// if the pose is read right.
    void pMayBeTransposed()
    {
        const std::string rows = "P = [800 0 320 40; 0 800 240 -30; 0 0 1 5]\n",
                          columns = "P = [800 0 0; 0 800 0; 320 240 1; 40 -30 5]\n";
        const SceneCamera asRows = sceneOf(rows + kSize), asColumns = sceneOf(columns + kSize);
        QVERIFY(glm::length(pixelOf(asRows, {1, 2, 4}) - pixelOf(asColumns, {1, 2, 4})) <= 1e-9);
        QVERIFY(join(asRows.assumed).find("transposed") == std::string::npos);
        QVERIFY(join(asColumns.assumed).find("P is transposed, as MATLAB's cameraMatrix is") != std::string::npos);
    }

    /// Only a number with a star is a factor.
    void factorsAreMatlabs()
    {
        const std::string k = "K = 800 0 320 0 800 240 0 0 1\nR = 1 0 0 0 1 0 0 0 1\n";
        const auto shift = [&](const char *t) { return read(k + t).value().pose.value()[3]; };
        QCOMPARE(shift("t =\n\n   1.0e+03 *\n\n   0.0010 0.0020 0.0050\n"), glm::dvec4(1, 2, 5, 1));
        QCOMPARE(shift("t = 0.001 * [1000 2000 5000]'\n"), glm::dvec4(1, 2, 5, 1));
        QCOMPARE(shift("t = [1, 2, 5] # in m / s\n"), glm::dvec4(1, 2, 5, 1));
    }

    /// A megabyte of one line, and of values, is read in linear time.
    void manyValuesAreRead()
    {
        std::string line, values;
        for (int i = 0; i < 100000; ++i) {
            line += "abc [a[";
            values += "K = 1\n";
        }
        QVERIFY(!readCamera(std::vector<NamedText>{{"a.txt", line}}, {}));
        QVERIFY(!readCamera(std::vector<NamedText>{{"a.txt", values}}, {}));
    }

    void poseDirectionIsDecidedByTheObjects()
    {
        const std::string toCamera = kPlainK + kSize + "R = [[1,0,0],[0,1,0],[0,0,1]]\nt = [0, 0, 5]\n",
                          toWorld = kPlainK + kSize + "R = [[1,0,0],[0,1,0],[0,0,1]]\nt = [0, 0, -5]\n";
        const Box box = boxAround({0, 0, 0}, 1.0);
        const SceneCamera usual = sceneOf(toCamera, {}, box), other = sceneOf(toWorld, {}, box);
        QCOMPARE(usual.direction, PoseDirection::WorldToCamera);
        QCOMPARE(other.direction, PoseDirection::CameraToWorld);
        for (const SceneCamera &scene : {usual, other})
            QVERIFY(glm::length(pixelOf(scene, {0, 0, 0}) - glm::dvec2(320, 240)) <= 1e-10);
        const std::string said = join(other.assumed);
        QVERIFY2(said.find("camera-to-world, because only this reading shows the objects; --pose says otherwise")
                     != said.npos,
                 said.c_str());
        CameraChoices choices;
        choices.direction = PoseDirection::WorldToCamera;
        QCOMPARE(sceneOf(toWorld, choices, box).direction, PoseDirection::WorldToCamera);
    }

    void axesAreDecidedByTheObjects()
    {
        const std::string pose = kPlainK + kSize + "c2w = [[1,0,0,0],[0,1,0,0],[0,0,1,5],[0,0,0,1]]\n";
        QCOMPARE(sceneOf(pose, {}, boxAround({0, 0, 0}, 1.0)).axes, EyeAxes::RightUpBack);
        QCOMPARE(sceneOf(pose, {}, boxAround({0, 0, 9}, 1.0)).axes, EyeAxes::RightDownAhead);
        QCOMPARE(sceneOf(kPlainK + kSize + "cam2world_gl = 1 0 0 0  0 1 0 0  0 0 1 5  0 0 0 1\n").axes,
                 EyeAxes::RightUpBack);
    }

    void ambiguousPosesAreReported()
    {
        const std::string text = kPlainK + kSize + "R = [[1,0,0],[0,1,0],[0,0,1]]\nt = [0, 0, 0]\n";
        const std::string both = join(sceneOf(text, {}, boxAround({0, 0, 5}, 1.0)).assumed);
        QVERIFY2(both.find("Another reading shows them too") != both.npos, both.c_str());
        const std::string without = join(sceneOf(text).assumed);
        QVERIFY2(without.find("No objects decide it; --pose says otherwise") != without.npos, without.c_str());
    }

    void mistakesBehindAnEmptyPictureAreNamed_data()
    {
        addColumn<QString>("pose");
        addColumn<QString>("said");
        newRow("t is the camera's position") << "R = 1 0 0  0 0 -1  0 1 0\nt = 0 -5 0"
                                             << "it would";
        newRow("direction") << "rvec = 0 0 0\ntvec = 0 0 -5"
                            << "with --pose camera-to-world --axes opencv it would";
        newRow("units") << "rvec = 0 0 0\ntvec = 3 0 0.005"
                        << "check the units";
        newRow("elsewhere") << "rvec = 0 0 0\ntvec = 1e9 0 1"
                            << "check the pose and its units";
    }

    void mistakesBehindAnEmptyPictureAreNamed()
    {
        QFETCH(QString, pose);
        QFETCH(QString, said);
        CameraChoices choices;
        choices.direction = PoseDirection::WorldToCamera;
        const std::string text =
            join(sceneOf(kPlainK + kSize + pose.toStdString() + '\n', choices, boxAround({0, 0, 0}, 1.0)).assumed);
        QVERIFY2(text.find("The camera sees none of the objects") != text.npos, text.c_str());
        QVERIFY2(text.find(said.toStdString()) != text.npos, text.c_str());
    }

    void tinyObjectsAreReported()
    {
        const auto saidOf = [](const std::string &t) {
            return join(
                sceneOf(kPlainK + kSize + "rvec = 0 0 0\ntvec = " + t + '\n', {}, boxAround({0, 0, 0}, 1.0)).assumed);
        };
        const std::string said = saidOf("0 0 5000");
        QVERIFY2(said.find("The objects take only 0.067 % of the image: check the units of t.") != said.npos,
                 said.c_str());
        QVERIFY(saidOf("0 0 50").find("The objects take only") == std::string::npos);
    }

    void assumptionsNameTheirOption()
    {
        const std::string said = join(sceneOf(kPlainK).assumed);
        for (const char *sentence :
             {"The image is assumed to be 640x480, twice the principal point; --size says otherwise.",
              "Near 0.1 and far 1000 are assumed, because the file has none; --near and --far say otherwise.",
              "No pose was read"})
            QVERIFY2(said.find(sentence) != said.npos, said.c_str());
        CameraChoices choices;
        choices.size = ImageSize{640, 480};
        choices.nearDistance = 1.0;
        choices.farDistance = 9.0;
        const SceneCamera scene = sceneOf(kPlainK + "rvec = 0 0 0\ntvec = 0 0 0\n", choices);
        QCOMPARE(join(scene.assumed), std::string());
        QVERIFY(scene.projection
                == geometry::Lens(
                    geometry::Projection(geometry::Pinhole{800, 800, 319.5, 239.5, 0, 640, 480, 1, 9, true})));
        const std::string half =
            join(sceneOf("K = 800 0 320  0 800 240  0 0 1\nrvec = 0 0 0\ntvec = 0 0 0\n", choices).assumed);
        QVERIFY2(half.find("--pixel-centers half") != half.npos, half.c_str());
    }

    void nearAndFarHoldTheObjects()
    {
        const SceneCamera scene =
            sceneOf(kPlainK + kSize + "rvec = 0 0 0\ntvec = 0 0 0\n", {}, boxAround({0, 0, 5}, 1.0));
        QCOMPARE(scene.nearDistance.value(), 2.0);
        QCOMPARE(scene.farDistance.value(), 12.0);
        CameraChoices choices;
        choices.nearDistance = 3.0;
        choices.farDistance = 2.0;
        QVERIFY2(reasonOf(kPlainK + kSize, choices).startsWith("near is 3 and far is 2"),
                 qPrintable(reasonOf(kPlainK + kSize, choices)));
    }

    void pixelCentresShiftThePicture()
    {
        const std::string text = kPlainK + kSize + "rvec = 0 0 0\ntvec = 0 0 0\n";
        CameraChoices choices;
        choices.centres = PixelCentres::AtHalves;
        QVERIFY(glm::length(pixelOf(sceneOf(text), {0, 0, 2}) - glm::dvec2(320.0, 240.0)) <= 1e-10);
        QVERIFY(glm::length(pixelOf(sceneOf(text, choices), {0, 0, 2}) - glm::dvec2(319.5, 239.5)) <= 1e-10);
    }

    void wholePrincipalPointsGiveEvenSides_data()
    {
        addColumn<double>("cx");
        addColumn<int>("width");
        newRow("half of the size") << 320.0 << 640;
        newRow("between the middle pixels") << 319.5 << 640;
        newRow("calibrated") << 321.3 << 644;
    }

    void wholePrincipalPointsGiveEvenSides()
    {
        QFETCH(double, cx);
        QFETCH(int, width);
        const std::string k = "K = 500 0 " + std::to_string(cx) + "  0 500 240  0 0 1\n";
        const SceneCamera scene = sceneOf(k);
        QCOMPARE(scene.size, (ImageSize{width, 480}));
        QVERIFY(join(scene.assumed).find("twice the principal point") != std::string::npos);
        QCOMPARE(join(scene.assumed).find("--pixel-centers half") != std::string::npos, cx == 320.0);
    }

    /// Each K goes with its own pose; equal ones are one camera's.
    void severalCamerasAreChosen()
    {
        const std::string left = "K: 500 0 320 0 500 240 0 0 1\n", right = "K: 600 0 320 0 600 240 0 0 1\n",
                          pose = "rvec: 0 0 0\ntvec: 0 0 0\n";
        const auto focalOf = [](const std::string &text, const char *image) {
            return sceneOf(text, choicesOf(image)).intrinsics->fx;
        };
        QCOMPARE(focalOf(left + pose + right + pose, "0"), 500.0);
        QCOMPARE(focalOf(left + pose + right + pose, "1"), 600.0);
        QCOMPARE(focalOf(left + right, "1"), 600.0);
        QVERIFY(join(sceneOf(left + right).assumed).find("--image NAME reads another") != std::string::npos);
        QCOMPARE(focalOf(left + left + pose, ""), 500.0);
    }

    void quaternionsOfRosAreRead_data()
    {
        addColumn<QString>("pose");
        newRow("a transform")
            << "transform:\n  translation:\n    x: 1.0\n    y: 2.0\n    z: -5.0\n  rotation:\n    x: 0.0\n"
               "    y: 0.0\n    z: 0.6\n    w: 0.8\n";
        newRow("a pose, w first") << "{\"position\": {\"x\": 1, \"y\": 2, \"z\": -5}, \"orientation\": {\"w\": 0.8, "
                                     "\"x\": 0, \"y\": 0, \"z\": 0.6}}\n";
        newRow("t as a list") << "rotation: {x: 0, y: 0, z: 0.6, w: 0.8}\ntranslation: [1, 2, -5]\n";
    }

    /// z = 0.6 and w = 0.8 turn x to (0.28, 0.96, 0).
    void quaternionsOfRosAreRead()
    {
        QFETCH(QString, pose);
        const SceneCamera scene = sceneOf(kPlainK + kSize + pose.toStdString(), {}, boxAround({1, 2, 5}, 1.0));
        QCOMPARE(scene.direction, PoseDirection::CameraToWorld);
        const glm::dvec3 position(1, 2, -5), right(0.28, 0.96, 0.0), ahead(0, 0, 1);
        QVERIFY(glm::length(pixelOf(scene, position + 2.0 * ahead) - glm::dvec2(320, 240)) <= 1e-10);
        QVERIFY(glm::length(pixelOf(scene, position + 2.0 * ahead + 0.5 * right) - glm::dvec2(520, 240)) <= 1e-10);
    }

    /// RealSense names this model for images without distortion.
    void variantsWithoutCoefficientsAreRead()
    {
        const SceneCamera scene =
            sceneOf(kPlainK + kSize + "model: distortion.inverse_brown_conrady\ncoeffs: [0, 0, 0, 0, 0]\n");
        QVERIFY(!scene.distortion);
    }

    void skewIsExact()
    {
        const SceneCamera scene = sceneOf("K = 800 12 319.5  0 700 239.5  0 0 1\nrvec = 0 0 0\ntvec = 0 0 0\n" + kSize);
        // x = (800 * 0.2 + 12 * -0.1) / 2 + 319.5, y = 700 * -0.1 / 2 + 239.5
        QVERIFY(glm::length(pixelOf(scene, {0.2, -0.1, 2.0}) - 0.5 - glm::dvec2(398.9, 204.5)) <= 1e-10);
        QVERIFY(join(scene.assumed).find("skew") == std::string::npos);
    }

    void clicksAreRoundedOnce_data()
    {
        addColumn<double>("farDistance");
        addColumn<double>("skew");
        addColumn<bool>("areCentersWhole");
        for (const double farDistance : {10.0, 1000.0, 10000.0}) {
            addRow("far %g", farDistance) << farDistance << 0.0 << true;
            addRow("far %g, skewed", farDistance) << farDistance << 1.7 << true;
            addRow("far %g, centres at halves", farDistance) << farDistance << 0.0 << false;
        }
    }

    /// K, near and far are exact, so a click is within half a unit in the last place of its largest
    /// coordinate. The truth is computed with 50 digits from the pinhole's equations.
    void clicksAreRoundedOnce()
    {
        QFETCH(double, farDistance);
        QFETCH(double, skew);
        QFETCH(bool, areCentersWhole);
        using oracle::Extended;
        constexpr double kNear = 0.1, kFx = 611.2, kFy = 609.9, kCx = 318.7, kCy = 243.1;
        CameraChoices choices;
        choices.nearDistance = kNear;
        choices.farDistance = farDistance;
        choices.centres = areCentersWhole ? PixelCentres::AtIntegers : PixelCentres::AtHalves;
        const SceneCamera scene =
            sceneOf("K = 611.2 " + std::to_string(skew)
                        + " 318.7  0 609.9 243.1  0 0 1\nrvec = 0 0 0\ntvec = 0.1 0.2 0.3\n" + kSize,
                    choices);
        const geometry::Surface surface{640, 480, 1.0};
        const auto unprojector = unproject::Unprojector::of(
            {surface, geometry::wholeSurface(surface), {}, scene.projection, scene.eyeFromWorld});
        QVERIFY(unprojector);
        oracle::Random random(5);
        double worst = 0.0;
        for (int i = 0; i < 1500; ++i) {
            const double u = std::floor(random.uniform(0.0, 640.0)),
                         v = std::floor(random.uniform(0.0, 480.0)); // whole
            const double depth = 1.0 - std::pow(10.0, random.uniform(-6.0, 0.0));
            const auto world = unprojector->worldAt(unproject::Method::Formula,
                                                    geometry::WindowPoint(u + 0.5, 480.0 - v - 0.5, depth));
            QVERIFY(world);
            const Extended n = kNear, f = farDistance, d = depth, toHalf = areCentersWhole ? 0.0 : 0.5;
            const Extended z = n * f / (f * (1 - d) + n * d), y = (v + toHalf - kCy) / kFy * z;
            const oracle::Vector3 truth{((u + toHalf - kCx) * z - skew * y) / kFx - 0.1, y - 0.2, z - 0.3};
            const double largest = static_cast<double>(oracle::maxNorm(truth));
            const double unit = std::nextafter(largest, 1e300) - largest;
            for (int k = 0; k < 3; ++k)
                worst = std::max(worst, std::abs(static_cast<double>(truth[std::size_t(k)] - (*world)[k])) / unit);
        }
        QVERIFY2(worst <= 0.5001, qPrintable(QString::number(worst)));
    }

    /// K is of the raw image, P of the rectified one.
    void rawAndRectifiedPicturesOfRos()
    {
        const std::string info = R"(header:
  seq: 7
  stamp:
    secs: 12
    nsecs: 500
  frame_id: "camera_optical_frame"
height: 480
width: 640
distortion_model: "plumb_bob"
D: [0.1, -0.2, 0.001, 0.002, 0.0]
K: [800.0, 0.0, 319.5, 0.0, 810.0, 239.5, 0.0, 0.0, 1.0]
R: [0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
P: [700.0, 0.0, 300.0, -70.0, 0.0, 700.0, 200.0, 0.0, 0.0, 0.0, 1.0, 0.0]
binning_x: 0
binning_y: 0
roi:
  x_offset: 0
  y_offset: 0
  height: 0
  width: 0
  do_rectify: False
)";
        const SceneCamera raw = sceneOf(info), rectified = sceneOf(info, undistorted());
        QCOMPARE(raw.size, (ImageSize{640, 480}));
        QCOMPARE(raw.distortion.value(), (Distortion{0.1, -0.2, 0.001, 0.002, 0.0}));
        QVERIFY(!rectified.distortion);
        // In the optical frame (1, 2, 4): K gives the raw pixel; R turns it to (2, -1, 4),
        // P adds -70 / 4.
        QVERIFY(glm::length(pixelOf(raw, {1, 2, 4}) - 0.5 - glm::dvec2(519.5, 644.5)) <= 1e-9);
        QVERIFY(glm::length(pixelOf(rectified, {1, 2, 4}) - 0.5 - glm::dvec2(632.5, 25.0)) <= 1e-9);
        QVERIFY(join(raw.assumed).find("K counts; --undistorted takes P") != std::string::npos);

        const std::string file = R"(image_width: 640
image_height: 480
camera_name: head
camera_matrix:
  rows: 3
  cols: 3
  data: [800, 0, 319.5, 0, 810, 239.5, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.1, -0.2, 0.001, 0.002, 0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]
projection_matrix:
  rows: 3
  cols: 4
  data: [700, 0, 300, 0, 0, 700, 200, 0, 0, 0, 1, 0]
)";
        QVERIFY(glm::length(pixelOf(sceneOf(file), {1, 2, 4}) - 0.5 - glm::dvec2(519.5, 644.5)) <= 1e-9);
        QVERIFY(glm::length(pixelOf(sceneOf(file, undistorted()), {1, 2, 4}) - 0.5 - glm::dvec2(475.0, 550.0)) <= 1e-9);

        const std::string blocks =
            "height: 480\nwidth: 640\ndistortion_model: plumb_bob\nd:\n- 0.1\n- -0.2\n- 0.001\n- "
            "0.002\n- 0.0\nk:\n- 800.0\n- 0.0\n- 319.5\n- 0.0\n- 810.0\n- 239.5\n- 0.0\n- 0.0\n- "
            "1.0\nr:\n- 1.0\n- 0.0\n- 0.0\n- 0.0\n- 1.0\n- 0.0\n- 0.0\n- 0.0\n- 1.0\np:\n- 700.0\n- "
            "0.0\n- 300.0\n- 0.0\n- 0.0\n- 700.0\n- 200.0\n- 0.0\n- 0.0\n- 0.0\n- 1.0\n- 0.0\n";
        QVERIFY(glm::length(pixelOf(sceneOf(blocks), {1, 2, 4}) - 0.5 - glm::dvec2(519.5, 644.5)) <= 1e-9);
        QCOMPARE(sceneOf(blocks).distortion.value().k2, -0.2);
    }

    void coefficientsAreReadFromEachForm_data()
    {
        addColumn<QString>("text");
        newRow("a list") << "dist = [[-0.3, 0.1, 0.001, -0.002, 0.05]]";
        newRow("eight, the last ones 0") << "distCoeffs: [-0.3, 0.1, 0.001, -0.002, 0.05, 0, 0, 0]";
        newRow("names") << "k1 = -0.3, k2 = 0.1, p1 = 0.001, p2 = -0.002, k3 = 0.05";
        newRow("JSON") << "\"distortion_coefficients\": [-0.3, 0.1, 0.001, -0.002, 0.05]";
        newRow("names of a lens")
            << "radial_k1 = -0.3, radial_k2 = 0.1, dist.p1 = 0.001, dist.p2 = -0.002, lens_k3 = 0.05";
    }

    void coefficientsAreReadFromEachForm()
    {
        QFETCH(QString, text);
        const std::string whole = kPlainK + kSize + text.toStdString() + '\n';
        QCOMPARE(sceneOf(whole).distortion.value(), (Distortion{-0.3, 0.1, 0.001, -0.002, 0.05}));
        const SceneCamera dropped = sceneOf(whole, undistorted());
        QVERIFY(!dropped.distortion);
        QVERIFY(join(dropped.assumed).find("coefficients are dropped") != std::string::npos);
    }

    void unknownLensesAreNamed_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("reason");
        newRow("rational") << "D: [0.1, 0.2, 0, 0, 0.3, 0.4, 0, 0.6]"
                           << "k4 = 0.4, k6 = 0.6";
        newRow("thin prism") << "D: [0.1, 0.2, 0, 0, 0, 0, 0, 0, 0.01, 0, 0, 0]"
                             << "s1 = 0.01";
        newRow("fisheye") << "distortion_model: equidistant\nD: [0.1, 0, 0, 0]"
                          << "equidistant";
        newRow("Kalibr's, a pinhole before it") << "camera_model: pinhole\ndistortion_model: equidistant\n"
                                                   "distortion_coeffs: [0.1, 0, 0, 0]"
                                                << "equidistant";
        newRow("a name that is not known") << "distortion_model: double_sphere\nD: [0.1, 0, 0, 0]"
                                           << "double_sphere";
        newRow("RealSense's inverse") << "model: distortion.inverse_brown_conrady\ncoeffs: [0.1, 0, 0, 0, 0]"
                                      << "distortion.inverse_brown_conrady";
        newRow("a flag") << "fisheye_model: 1\nD: [0.1, 0, 0, 0]"
                         << "fisheye";
        newRow("another flag") << "is_fisheye: true\nD: [0.1, 0, 0, 0]"
                               << "fisheye";
        newRow("named k4 and k6") << "k1 = 0.1, k2 = 0.2, k3 = 0.3, k4 = 0.4, k6 = 0.6"
                                  << "k4 = 0.4, k6 = 0.6";
        newRow("too few") << "D: [0.1, 0.2]"
                          << "there are 2 distortion coefficients";
    }

    void unknownLensesAreNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, reason);
        const std::string whole = kPlainK + kSize + text.toStdString() + '\n';
        QVERIFY2(reasonOf(whole).contains(reason), qPrintable(reasonOf(whole)));
        QVERIFY(!reasonOf(whole).endsWith("@0"));
        const SceneCamera scene = sceneOf(whole, undistorted());
        QVERIFY(!scene.distortion);
        QVERIFY2(join(scene.assumed).find("dropped") != std::string::npos, join(scene.assumed).c_str());
    }

    void faultsNameValueAndLine_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("reason");
        newRow("eight numbers") << "\nK = 800 0 320 0 800 240 0 0\n"
                                << "K: it has 8 numbers; a camera matrix has nine, by rows @2";
        newRow("no camera matrix")
            << "K = 800 0 320 5 800 240 0 0 1\n"
            << "K: this is no camera matrix; it must have the rows fx skew cx, 0 fy cy, 0 0 1 @1";
        newRow("R mirrors") << "K = 800 0 320 0 800 240 0 0 1\nR = 1 0 0 0 1 0 0 0 -1\nt = 0 0 5\n"
                            << "R: its determinant is -1: it mirrors. Check the sign of a row or a column @2";
        newRow("R has seven") << "K = 800 0 320 0 800 240 0 0 1\nR = 1 0 0 0 1 0 0\n"
                              << "R: it has 7 numbers; a rotation has nine, by rows, or three of a rotation vector @2";
        newRow("t has two") << "K = 800 0 320 0 800 240 0 0 1\nt = 1 0\n"
                            << "t: it has 2 numbers; a translation has three @2";
        newRow("no rotation") << "K = 800 0 320 0 800 240 0 0 1\nR = 1 0.5 0 0 1 0 0 0 1\nt = 0 0 5\n"
                              << "the pose's axes are not perpendicular and of equal length: off by 0.5; give a "
                                 "rotation";
        newRow("no K") << "rvec = 0 0 0\ntvec = 0 0 5\n"
                       << "there is a pose, but no camera matrix; give K, nine numbers by rows @0";
        newRow("P is flat") << "P = 1 0 0 0 0 1 0 0 1 1 0 0\n"
                            << "P: its first three columns have no inverse; a camera's P has one @1";
        newRow("fx alone") << "fx = 800\nfy = 800\n"
                           << "fx and fy are given without cx and cy; give all four @0";
        newRow("two K, one R") << "{\"left\": {\"K\": [500, 0, 320, 0, 500, 240, 0, 0, 1]},\n\"right\": {\"K\": [600, "
                                  "0, 320, 0, 600, 240, 0, 0, 1]}, \"R\": [1, 0, 0, 0, 1, 0, 0, 0, 1], \"T\": [0.1, 0, "
                                  "0]}\n"
                               << "R: the text has 2 camera matrices, but 1 of this. Give the text of one camera @2";
        newRow("two fx") << "fx: 500\nfy: 500\ncx: 320\ncy: 240\nfx: 600\n"
                         << "fx has several values. Give the text of one camera @1";
        newRow("a quaternion without names") << "K = 800 0 320 0 800 240 0 0 1\nq = [0, 0, 0, 1]\nt = 0 0 5\n"
                                             << "q: the order of a quaternion's four numbers is not known; name "
                                                "them, {x: 0, y: 0, z: 0, w: 1}, or give R "
                                                "@2";
        newRow("a quaternion of 0")
            << "K = 800 0 320 0 800 240 0 0 1\nrotation: {x: 0, y: 0, z: 0, w: 0}\ntranslation: {x: 0, y: 0, z: 5}\n"
            << "rotation: x, y, z and w are 0; give a quaternion @2";
        newRow("t has four, the first a power of ten") << "K = 800 0 320 0 800 240 0 0 1\nt = [10, 2, 5, 1]\n"
                                                       << "t: it has 4 numbers; a translation has three @2";
        newRow("a quaternion as rotation")
            << "K = 800 0 320 0 800 240 0 0 1\nrotation = [1, .1, .2, .3]\nt = 0 0 5\n"
            << "rotation: the order of a quaternion's four numbers is not known; name them, {x: 0, y: 0, z: 0, w: 1}, "
               "or "
               "give R @2";
        const auto computed = [](const char *name, const char *line, const char *what) {
            newRow(line) << QStringLiteral("K = 800 0 320 0 800 240 0 0 1\n%1\n").arg(QLatin1String(line))
                         << QStringLiteral("%1: the text computes with it (%2), and only numbers are read; write "
                                           "the result @2")
                                .arg(QLatin1String(name), QLatin1String(what));
        };
        computed("t", "t = np.array([1000, 2000, 5000]) / 1000", "/ 1000");
        computed("t", "t = np.array([1000, 2000, 5000]) * 0.001", "* 0.001");
        computed("t", "t = [1, 2, 5] + [1, 1, 1]", "+ [1, 1, 1]");
        computed("t", "t = -np.array([1, 2, 5])", "-");
        computed("t", "t = scale * np.array([1, 2, 5])", "scale *");
        computed("t", "t = -R @ np.array([1, 2, 5])", "-");
        computed("R", "R = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]).T", ".T");
        computed("R", "R = np.linalg.inv(np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]))", "inv");
        newRow("nan") << "K = 800 0 320 0 nan 240 0 0 1\n"
                      << "K: a number is not finite @1";
        newRow("YAML's nan") << "K: [800, 0, 320, 0, 800, 240, 0, 0, 1]\nD: [.Nan, 0.1, 0, 0, 0]\n"
                             << "D: a number is not finite @2";
        newRow("one coefficient") << "K = 800 0 320 0 800 240 0 0 1\nD: [0.1]\n"
                                  << "D: there is 1 distortion coefficient; give four or five: k1, k2, p1, p2, k3 "
                                     "@2";
        newRow("a focal length below 0") << "K = 800 0 320 0 -800 240 0 0 1\n"
                                         << "the focal length fy is -800; it must be greater than 0 @0";
        newRow("normalized") << "K = 1.2 0 0.5 0 1.6 0.5 0 0 1\nsize = 640x480\n"
                             << "fx 1.2, fy 1.6, cx 0.5, cy 0.5 are no pixels; they look normalized. Multiply fx "
                                "and cx by the image's width, fy and cy by its height @0";
        newRow("focal length 0") << "fx = 0, fy = 800, cx = 320, cy = 240\n"
                                 << "the focal lengths are 0 and 800; they must be finite and not 0";
    }

    void faultsNameValueAndLine()
    {
        QFETCH(QString, text);
        QFETCH(QString, reason);
        QCOMPARE(reasonOf(text.toStdString()), reason);
    }

    void otherTextsAreLeftToOthers_data()
    {
        addColumn<QString>("text");
        newRow("empty") << "";
        newRow("matrices")
            << "modelview 1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 projection 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0";
        newRow("a projection named P") << "P = 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0 V = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
        newRow("words") << "R and t are lost";
        newRow("a letter before a number") << "K = 3\nR = 8\n";
    }

    void otherTextsAreLeftToOthers()
    {
        QFETCH(QString, text);
        QVERIFY(!readCamera(std::vector<NamedText>{{"a.txt", text.toStdString()}}, {}));
    }

    void pixelsAreDistortedAsByProjectPoints()
    {
        const SceneCamera scene = sceneOf(opencv_camera::kLensYaml);
        QVERIFY(scene.distortion.has_value());
        for (const auto &point : opencv_camera::kProjected) {
            const glm::dvec2 pixel = distortedPixel(*scene.distortion, *scene.intrinsics, pixelOf(scene, point.world));
            QVERIFY(glm::length(pixel - 0.5 - point.distorted) <= 1e-10);
        }
    }

    void distortionIsUndone_data()
    {
        addColumn<double>("k1");
        addColumn<double>("k2");
        addColumn<double>("p1");
        addColumn<double>("p2");
        addColumn<double>("k3");
        newRow("barrel") << -0.28 << 0.11 << 0.0012 << -0.0007 << 0.02;
        newRow("pincushion") << 0.4 << 0.2 << -0.01 << 0.02 << 0.1;
        newRow("strong barrel") << -0.5 << 0.3 << 0.0 << 0.0 << 0.0;
        newRow("tangential only") << 0.0 << 0.0 << 0.05 << -0.03 << 0.0;
    }

    /// The coefficients' polynomial is written apart: by angle and radius for its radial part, by
    /// powers for the rest.
    void distortionIsUndone()
    {
        QFETCH(double, k1);
        QFETCH(double, k2);
        QFETCH(double, p1);
        QFETCH(double, p2);
        QFETCH(double, k3);
        const Distortion lens{k1, k2, p1, p2, k3};
        for (int ring = 0; ring < 15; ++ring) {
            for (int ray = 0; ray < 9; ++ray) {
                const double radius = 0.05 * ring, angle = 0.7 * ray;
                const double x = radius * std::cos(angle), y = radius * std::sin(angle);
                const double longer =
                    radius + k1 * std::pow(radius, 3) + k2 * std::pow(radius, 5) + k3 * std::pow(radius, 7);
                const glm::dvec2 expected(longer * std::cos(angle) + p1 * radius * radius * std::sin(2.0 * angle)
                                              + p2 * (3.0 * x * x + y * y),
                                          longer * std::sin(angle) + p1 * (x * x + 3.0 * y * y)
                                              + p2 * radius * radius * std::sin(2.0 * angle));
                QVERIFY(glm::length(distorted(lens, {x, y}) - expected) <= 1e-15);
                const auto back = undistorted(lens, expected);
                QVERIFY(back.has_value());
                QVERIFY(glm::length(*back - glm::dvec2(x, y)) <= 1e-13);
            }
        }
    }

    /// x (1 - 0.5 x^2) rises to 0.544 at x = 0.816: no position has an image beyond.
    void foldsHaveNoPosition()
    {
        const Distortion lens{-0.5, 0.0, 0.0, 0.0, 0.0};
        QVERIFY(undistorted(lens, {0.54, 0.0}).has_value());
        QVERIFY(!undistorted(lens, {0.55, 0.0}).has_value());
        QVERIFY(!undistorted(lens, {1.0, 1.0}).has_value());
        QVERIFY(!undistorted(lens, {std::nan(""), 0.0}).has_value());
    }
};

UNPROJECTOR_TEST(TestOpencvCameras)
#include "test_opencv_cameras.moc"
