// The doctor on programs with a vision camera, and values that take two or three points. The
// programs' points are computed here, with K and the camera's axes, apart from core.
#include "tests/support/test.h"

#include "core/doctor/diagnosis.h"
#include "core/doctor/frame_fit.h"
#include "core/doctor/report_text.h"
#include "tests/core/doctor/doctor_lines.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

using namespace unprojector;
using namespace unprojector::doctor;
using namespace unprojector::geometry;

namespace {

using glm::dvec2;
using glm::dvec3;

/// An image of 640 x 480 pixels, taken from (3, 2, 5) towards the origin.
struct Camera {
    double fx = 600, fy = 500, cx = 300, cy = 260;
    double nearDistance = 0.1, farDistance = 50.0;
    dvec3 eye{3, 2, 5};

    dvec3 ahead() const { return glm::normalize(-eye); }
    dvec3 right() const { return glm::normalize(glm::cross(ahead(), dvec3(0, 1, 0))); }
    dvec3 down() const { return glm::cross(ahead(), right()); }
    /// The world point of a pixel at a distance.
    dvec3 world(const dvec2 &pixel, double z) const
    {
        return fromAxes((pixel.x - cx) / fx * z, (pixel.y - cy) / fy * z, z);
    }
    dvec3 fromAxes(double x, double y, double z) const { return eye + x * right() + y * down() + z * ahead(); }
    /// The depth in [0, 1].
    double depth(double z) const { return farDistance * (z - nearDistance) / (z * (farDistance - nearDistance)); }
    double distance(double depth) const
    {
        return nearDistance * farDistance / (farDistance - depth * (farDistance - nearDistance));
    }
};

Case caseOf(const Camera &c)
{
    Case result;
    const double n = c.nearDistance;
    result.setup = {{640, 480, 1.0},
                    {0, 0, 640, 480},
                    {},
                    Projection(Frustum{-c.cx / c.fx * n, (640 - c.cx) / c.fx * n, -(480 - c.cy) / c.fy * n,
                                       c.cy / c.fy * n, n, c.farDistance}),
                    LookAt{WorldPoint(c.eye.x, c.eye.y, c.eye.z), WorldPoint(0, 0, 0), {0, 1, 0}}};
    return result;
}

struct Shot {
    dvec2 pixel{};
    double z = 0.0;
};

/// Four clicks; their points lie in no plane.
const std::vector<Shot> kShots{{{110.5, 60.5}, 5.0}, {{500.5, 90.5}, 7.5}, {{420.5, 400.5}, 6.0}, {{80.5, 380.5}, 9.0}};

WrongPoint wrongPoint(const Camera &camera, const Shot &shot, const dvec3 &got)
{
    WrongPoint point;
    point.pixel = DevicePoint(shot.pixel.x, shot.pixel.y);
    point.depth = camera.depth(shot.z);
    for (int axis = 0; axis < 3; ++axis)
        point.got[axis] = std::round(got[axis] * 1e4) / 1e4;
    return point;
}

using Program = std::function<dvec3(const Camera &, const Shot &)>;

Diagnosis diagnosed(const Case &of, const Camera &camera, const Program &program, std::size_t count)
{
    std::vector<WrongPoint> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(wrongPoint(camera, kShots[i], program(camera, kShots[i])));
    return diagnose(of, points).value();
}

const Candidate *named(const Diagnosis &diagnosis, const std::string &id)
{
    const auto found = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                    [&](const Candidate &candidate) { return candidate.id == id; });
    return found == diagnosis.candidates.end() ? nullptr : &*found;
}

std::vector<double> valueOf(const Candidate &candidate, const std::string &name)
{
    for (const SolvedValue &value : candidate.values) {
        if (value.name == name)
            return value.numbers;
    }
    return {};
}

std::string wordOf(const Candidate &candidate, const std::string &name)
{
    for (const SolvedValue &value : candidate.values) {
        if (value.name == name)
            return value.word;
    }
    return {};
}

bool isNear(double value, double expected, double share = 0.01)
{
    return std::abs(value - expected) <= share * std::max(std::abs(expected), 1e-3);
}

/// OpenCV's radial and tangential distortion.
dvec2 distorted(const cameras::Distortion &d, double x, double y)
{
    const double r2 = x * x + y * y, radial = 1 + d.k1 * r2 + d.k2 * r2 * r2 + d.k3 * r2 * r2 * r2;
    return {x * radial + 2 * d.p1 * x * y + d.p2 * (r2 + 2 * x * x),
            y * radial + d.p1 * (r2 + 2 * y * y) + 2 * d.p2 * x * y};
}

} // namespace

Q_DECLARE_METATYPE(Program)

class TestDoctorCameras : public QObject {
    Q_OBJECT

private slots:
    void aMistakeOfTheCameraIsNamed_data()
    {
        addColumn<QString>("id");
        addColumn<Program>("program");
        const auto row = [](const char *id, Program program) { newRow(id) << QString(id) << program; };
        row("focal-lengths-swapped", [](const Camera &c, const Shot &s) {
            return c.fromAxes((s.pixel.x - c.cx) / c.fy * s.z, (s.pixel.y - c.cy) / c.fx * s.z, s.z);
        });
        row("centre-swapped", [](const Camera &c, const Shot &s) {
            return c.fromAxes((s.pixel.x - c.cy) / c.fx * s.z, (s.pixel.y - c.cx) / c.fy * s.z, s.z);
        });
        row("half-pixel-twice", [](const Camera &c, const Shot &s) { return c.world(s.pixel + 0.5, s.z); });
        row("pixel-corner", [](const Camera &c, const Shot &s) { return c.world(s.pixel - 0.5, s.z); });
        row("opencv-axes", [](const Camera &c, const Shot &s) {
            return c.fromAxes((s.pixel.x - c.cx) / c.fx * s.z, -(s.pixel.y - c.cy) / c.fy * s.z, -s.z);
        });
        // A pose of ROS's body axes: ahead, left, up. The point is K's: right, down, ahead.
        row("camera-axes-differ", [](const Camera &c, const Shot &s) {
            const double x = (s.pixel.x - c.cx) / c.fx * s.z, y = (s.pixel.y - c.cy) / c.fy * s.z;
            return c.fromAxes(-y, -s.z, x); // x ahead, y left, z up
        });
        // COLMAP's w, x, y, z of the view, read as x, y, z, w
        row("quaternion-order", [](const Camera &c, const Shot &s) {
            const glm::dmat3 view = glm::transpose(glm::dmat3(c.right(), c.down(), c.ahead()));
            const glm::dquat q = glm::quat_cast(view);
            const std::array stored{q.w, q.x, q.y, q.z};
            const glm::dmat3 wrong = glm::mat3_cast(glm::dquat(stored[3], stored[0], stored[1], stored[2]));
            const dvec3 p((s.pixel.x - c.cx) / c.fx * s.z, (s.pixel.y - c.cy) / c.fy * s.z, s.z);
            return glm::transpose(wrong) * (p + view * c.eye);
        });
        // Angles of Rz Ry Rx, multiplied as Rx Ry Rz, of the camera's pose in OpenGL's axes
        row("euler-order", [](const Camera &c, const Shot &s) {
            const glm::dmat3 pose(c.right(), -c.down(), -c.ahead());
            const double x = std::atan2(pose[1][2], pose[2][2]), y = std::asin(-pose[0][2]),
                         z = std::atan2(pose[0][1], pose[0][0]);
            const glm::dmat3 wrong =
                glm::mat3_cast(glm::angleAxis(x, dvec3(1, 0, 0)) * glm::angleAxis(y, dvec3(0, 1, 0))
                               * glm::angleAxis(z, dvec3(0, 0, 1)));
            return c.eye + wrong * dvec3((s.pixel.x - c.cx) / c.fx * s.z, -(s.pixel.y - c.cy) / c.fy * s.z, -s.z);
        });
        row("z-as-ray-length",
            [](const Camera &c, const Shot &s) { return c.eye + s.z * glm::normalize(c.world(s.pixel, s.z) - c.eye); });
        // The camera's pose R, C: R^T (p - C) is inverted as R p + R^T C, with the view's t for the eye.
        row("translation-not-inverted", [](const Camera &c, const Shot &s) {
            const dvec3 p = c.world(s.pixel, s.z) - c.eye;
            return p + dvec3(-glm::dot(c.right(), c.eye), glm::dot(c.down(), c.eye), glm::dot(c.ahead(), c.eye));
        });
    }

    void aMistakeOfTheCameraIsNamed()
    {
        QFETCH(QString, id);
        QFETCH(Program, program);
        const Camera camera;
        const Diagnosis diagnosis = diagnosed(caseOf(camera), camera, program, 1);
        QCOMPARE(QString::fromStdString(diagnosis.verdict), id);
        const QString name = QString::fromStdString(candidateName(diagnosis.candidates.front()));
        if (id == QStringLiteral("quaternion-order"))
            QCOMPARE(name, QStringLiteral("quaternion's order (w x y z read as x y z w, OpenCV's view)"));
        if (id == QStringLiteral("euler-order"))
            QVERIFY2(name.contains("angles for the order zyx, multiplied in the order xyz"), qPrintable(name));
    }

    /// y not flipped about the middle, and z of the eye point positive, are OpenCV's axes by name.
    void opencvAxesAreOneMistake()
    {
        Camera camera;
        camera.cx = 320;
        camera.cy = 240;
        const Program opencv = [](const Camera &c, const Shot &s) {
            return c.fromAxes((s.pixel.x - c.cx) / c.fx * s.z, -(s.pixel.y - c.cy) / c.fy * s.z, -s.z);
        };
        const Diagnosis diagnosis = diagnosed(caseOf(camera), camera, opencv, 1);
        QCOMPARE(QString::fromStdString(diagnosis.verdict), QStringLiteral("opencv-axes"));
        QVERIFY(diagnosis.alike().empty());
    }

    /// They give the same answers if the image is the whole window.
    void kOfAnotherSizeIsOneOfTheRatios()
    {
        const Camera camera;
        const Program half = [](const Camera &c, const Shot &s) { return c.world(2.0 * s.pixel, s.z); };
        const Diagnosis diagnosis = diagnosed(caseOf(camera), camera, half, 1);
        QVERIFY(diagnosis.namesMistake());
        const Candidate *size = named(diagnosis, "intrinsics-of-another-size");
        QVERIFY(size && size->explains);
        QVERIFY(size == &diagnosis.candidates.front() || size->alike == Alike::Always);
    }

    void kOfTheSizeGiven()
    {
        const Camera camera;
        Case of = caseOf(camera);
        of.otherSize = Surface{1600, 1000, 1.0};
        const Program other = [](const Camera &c, const Shot &s) {
            return c.world({s.pixel.x * 640 / 1600, s.pixel.y * 480 / 1000}, s.z);
        };
        const Diagnosis diagnosis = diagnosed(of, camera, other, 1);
        const Candidate *size = named(diagnosis, "intrinsics-of-another-size");
        QVERIFY(size && size->explains);
        QVERIFY(size == &diagnosis.candidates.front() || size->alike == Alike::Always);
    }

    void distortion()
    {
        const Camera c;
        Case of = caseOf(c);
        of.distortion = cameras::Distortion{-0.25, 0.08, 0.001, -0.002, 0.01};
        const double x = -0.31, y = 0.22, z = 6.0; // undistorted
        const auto pixelOf = [&](const dvec2 &direction) {
            return dvec2(c.fx * direction.x + c.cx, c.fy * direction.y + c.cy);
        };
        const dvec2 inImage = pixelOf(distorted(*of.distortion, x, y));
        const auto verdict = [&](const dvec3 &got) {
            const WrongPoint point = wrongPoint(c, {inImage, z}, got);
            return QString::fromStdString(diagnose(of, {&point, 1}).value().verdict);
        };
        QCOMPARE(verdict(c.fromAxes(x * z, y * z, z)), QStringLiteral("right"));
        QCOMPARE(verdict(c.world(inImage, z)), QStringLiteral("distortion-ignored"));
        const dvec2 twice = distorted(*of.distortion, (inImage.x - c.cx) / c.fx, (inImage.y - c.cy) / c.fy);
        QCOMPARE(verdict(c.fromAxes(twice.x * z, twice.y * z, z)), QStringLiteral("distortion-added"));
        // Without the coefficients the right point is another pixel's.
        of.distortion.reset();
        QVERIFY(verdict(c.fromAxes(x * z, y * z, z)) != QStringLiteral("right"));
    }

    void theNextClickIsInTheDistortedImage()
    {
        const Camera c;
        Case of = caseOf(c);
        of.distortion = cameras::Distortion{-0.25, 0.08, 0.001, -0.002, 0.01};
        const WrongPoint point = wrongPoint(c, kShots[0], c.world(kShots[0].pixel, kShots[0].z));
        const Diagnosis diagnosis = diagnose(of, {&point, 1}).value();
        QCOMPARE(QString::fromStdString(diagnosis.verdict), QStringLiteral("distortion-ignored"));
        QVERIFY(diagnosis.next);
        QCOMPARE(diagnosis.next->x - std::floor(diagnosis.next->x), 0.5); // a pixel's centre
        QCOMPARE(diagnosis.next->y - std::floor(diagnosis.next->y), 0.5);
    }

    /// One point is explained by near or by far; two of different depths by both only.
    void nearAndFarTakeTwoPoints()
    {
        const Camera camera;
        const Program program = [](const Camera &c, const Shot &s) {
            Camera other = c;
            other.nearDistance = 0.5;
            other.farDistance = 20.0;
            return c.world(s.pixel, other.distance(c.depth(s.z)));
        };
        const Diagnosis one = diagnosed(caseOf(camera), camera, program, 1);
        QVERIFY(!named(one, "near-far-differ"));
        for (const std::size_t count : {2, 3, 4}) {
            const Diagnosis several = diagnosed(caseOf(camera), camera, program, count);
            QCOMPARE(QString::fromStdString(several.verdict), QStringLiteral("near-far-differ"));
            QCOMPARE(valueOf(several.candidates.front(), "near"), std::vector{0.5});
            QCOMPARE(valueOf(several.candidates.front(), "far"), std::vector{20.0});
        }
    }

    void valuesOfSeveralPoints_data()
    {
        addColumn<QString>("id");
        addColumn<Program>("program");
        addColumn<QList<QPair<QString, double>>>("values");
        using Values = QList<QPair<QString, double>>;
        newRow("shift and scale") << QStringLiteral("pixel-scaled-and-moved")
                                  << Program([](const Camera &c, const Shot &s) {
                                         return c.world(1.25 * s.pixel + dvec2(12, -7), s.z);
                                     })
                                  << Values{{"dx", 12}, {"dy", -7}, {"scale", 1.25}};
        newRow("shift") << QStringLiteral("pixel-shifted")
                        << Program([](const Camera &c, const Shot &s) { return c.world(s.pixel + dvec2(31, 9), s.z); })
                        << Values{{"dx", 31}, {"dy", 9}};
        // A viewport (40, 25, 800, 450) of OpenGL with this K's projection: NDC as there.
        newRow("rectangle") << QStringLiteral("viewport-size-differs") << Program([](const Camera &c, const Shot &s) {
            const double x = (s.pixel.x - 40) / 800 * 640;
            const double y = 480 - (480 - s.pixel.y - 25) / 450 * 480;
            return c.world({x, y}, s.z);
        }) << Values{{"width", 800}, {"height", 450}, {"x", 40}, {"y", 25}};
        newRow("focal lengths") << QStringLiteral("focal-lengths-differ")
                                << Program([](const Camera &c, const Shot &s) {
                                       Camera other = c;
                                       other.fx = 525;
                                       other.fy = 480;
                                       return other.world(s.pixel, s.z);
                                   })
                                << Values{{"fx", 525}, {"fy", 480}};
        newRow("one focal length") << QStringLiteral("focal-lengths-differ")
                                   << Program([](const Camera &c, const Shot &s) {
                                          Camera other = c;
                                          other.fy = 437.31;
                                          return other.world(s.pixel, s.z);
                                      })
                                   << Values{{"fx", 600}, {"fy", 437.31}};
    }

    void valuesOfSeveralPoints()
    {
        QFETCH(QString, id);
        QFETCH(Program, program);
        using Values = QList<QPair<QString, double>>;
        QFETCH(Values, values);
        const Camera camera;
        for (const std::size_t count : {3, 4}) {
            const Diagnosis diagnosis = diagnosed(caseOf(camera), camera, program, count);
            QCOMPARE(QString::fromStdString(diagnosis.verdict), id);
            QCOMPARE(doctor_lines::faultsOf(diagnosis), QString());
            const Candidate &first = diagnosis.candidates.front();
            for (const auto &[name, expected] : values) {
                const std::vector<double> found = valueOf(first, name.toStdString());
                QVERIFY2(found.size() == 1 && isNear(found.front(), expected), qPrintable(name));
            }
        }
    }

    /// A centre (320, 240) instead of K's: the same answers as a shift, but better known.
    void aCentreInTheMiddleComesFirst()
    {
        const Camera camera;
        const auto withCentre = [](double cx, double cy) {
            return Program([cx, cy](const Camera &c, const Shot &s) {
                Camera other = c;
                other.cx = cx;
                other.cy = cy;
                return other.world(s.pixel, s.z);
            });
        };
        const Diagnosis middle = diagnosed(caseOf(camera), camera, withCentre(320, 240), 3);
        QVERIFY(middle.verdict == "frustum-centred" || middle.verdict == "principal-point-differs");
        const Diagnosis other = diagnosed(caseOf(camera), camera, withCentre(311.7, 244.4), 3);
        QCOMPARE(QString::fromStdString(other.verdict), QStringLiteral("pixel-shifted"));
        const Candidate *centre = named(other, "principal-point-differs");
        QVERIFY(centre && centre->alike == Alike::Always);
        QVERIFY(isNear(valueOf(*centre, "cx").at(0), 311.7) && isNear(valueOf(*centre, "cy").at(0), 244.4));
        QCOMPARE(doctor_lines::faultsOf(other), QString());
    }

    void everyPermutationIsNamedFromOnePoint()
    {
        const Camera camera;
        QCOMPARE(axisPermutations().size(), std::size_t(48));
        for (const AxisPermutation &permutation : axisPermutations().subspan(1)) {
            const Program program = [&](const Camera &c, const Shot &s) {
                return permutation.matrix * c.world(s.pixel, s.z);
            };
            const Diagnosis diagnosis = diagnosed(caseOf(camera), camera, program, 1);
            QCOMPARE(QString::fromStdString(diagnosis.verdict), QStringLiteral("axes-differ"));
            QCOMPARE(wordOf(diagnosis.candidates.front(), "axes"), permutation.axes);
        }
        const Program zUp = [](const Camera &c, const Shot &s) {
            const dvec3 p = c.world(s.pixel, s.z);
            return dvec3(p.x, -p.z, p.y);
        };
        QCOMPARE(candidateName(diagnosed(caseOf(camera), camera, zUp, 1).candidates.front()),
                 std::string("other axes (x,-z,y: z up given for y up)"));
    }

    void permutationsWithScaleAndTranslation()
    {
        const Camera camera;
        const auto program = [](double scale, const dvec3 &moved) {
            return Program([scale, moved](const Camera &c, const Shot &s) {
                const dvec3 p = c.world(s.pixel, s.z);
                return scale * dvec3(p.z, -p.x, -p.y) + moved;
            });
        };
        const Diagnosis scaled = diagnosed(caseOf(camera), camera, program(1000, {}), 2);
        QCOMPARE(QString::fromStdString(scaled.verdict), QStringLiteral("axes-differ"));
        QCOMPARE(wordOf(scaled.candidates.front(), "axes"), std::string("z,-x,-y"));
        const std::vector<double> scale = valueOf(scaled.candidates.front(), "scale");
        QVERIFY(scale.size() == 1 && std::abs(scale.front() - 1000.0) < 1e-9);
        QVERIFY(valueOf(scaled.candidates.front(), "translation").empty());
        const Diagnosis moved = diagnosed(caseOf(camera), camera, program(1, {0.5, 0, 1.25}), 2);
        QCOMPARE(QString::fromStdString(moved.verdict), QStringLiteral("axes-differ"));
        QCOMPARE(valueOf(moved.candidates.front(), "translation"), (std::vector{0.5, 0.0, 1.25}));
        QVERIFY(valueOf(moved.candidates.front(), "scale").empty());
        const Diagnosis both = diagnosed(caseOf(camera), camera, program(0.3048, {0.5, 0, 1.25}), 3);
        QCOMPARE(QString::fromStdString(both.verdict), QStringLiteral("axes-differ"));
        QCOMPARE(wordOf(both.candidates.front(), "axes"), std::string("z,-x,-y"));
        QVERIFY(isNear(valueOf(both.candidates.front(), "scale").at(0), 0.3048, 1e-3));
        QVERIFY(isNear(valueOf(both.candidates.front(), "translation").at(2), 1.25, 1e-3));
        for (const Diagnosis &diagnosis : {scaled, moved, both})
            QCOMPARE(doctor_lines::faultsOf(diagnosis), QString());
    }

    void framesWithTheirHandedness()
    {
        const Camera camera;
        const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(dvec3(1, -2, 0.5))));
        for (const double mirror : {1.0, -1.0}) {
            for (const double scale : {1.0, 2.5}) {
                const Program program = [&](const Camera &c, const Shot &s) {
                    return scale * (mirror * turn * c.world(s.pixel, s.z)) + dvec3(4, -1, 2);
                };
                const Diagnosis diagnosis = diagnosed(caseOf(camera), camera, program, 4);
                QCOMPARE(QString::fromStdString(diagnosis.verdict), QStringLiteral("frame-differs"));
                const Candidate &first = diagnosis.candidates.front();
                // 0.7 radians about (1, -2, 0.5); the scale and the translation have more digits than the program's.
                const std::string name = candidateName(first);
                QVERIFY2(name.find("turned by 40.11 degrees about 0.4364, -0.8729, 0.2182, scaled by ") != name.npos
                             && name.find(", moved by ") != name.npos,
                         name.c_str());
                QVERIFY(isNear(valueOf(first, "scale").at(0), scale, 1e-3));
                for (std::size_t i = 0; i < 9; ++i)
                    QVERIFY(std::abs(valueOf(first, "rotation").at(i) - mirror * turn[int(i % 3)][int(i / 3)]) < 1e-3);
                QVERIFY(isNear(valueOf(first, "translation").at(0), 4, 1e-2));
                // Four decimals over some units determine at most seven decimals.
                for (const double number : valueOf(first, "rotation"))
                    QVERIFY(std::abs(number * 1e7 - std::round(number * 1e7)) < 1e-6);
                QCOMPARE(candidateName(first).find("mirrored") != std::string::npos, mirror < 0.0);
            }
        }
    }

    void threePointsLeaveTheHandednessOpen()
    {
        const Camera camera;
        const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(dvec3(1, -2, 0.5))));
        const Program program = [&](const Camera &c, const Shot &s) {
            return turn * c.world(s.pixel, s.z) + dvec3(4, -1, 2);
        };
        const Diagnosis diagnosis = diagnosed(caseOf(camera), camera, program, 3);
        QCOMPARE(QString::fromStdString(diagnosis.verdict), QStringLiteral("frame-differs"));
        QVERIFY(candidateName(diagnosis.candidates.front()).find("a mirror image fits too") != std::string::npos);
        for (std::size_t i = 0; i < 9; ++i)
            QVERIFY(std::abs(valueOf(diagnosis.candidates.front(), "rotation").at(i) - turn[int(i % 3)][int(i / 3)])
                    < 1e-3);
    }

    void pointsThatDetermineTooLittle()
    {
        const Camera c;
        const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(dvec3(1, -2, 0.5))));
        std::vector<WrongPoint> points;
        // On a line parallel to the image, so at one depth.
        for (const double x : {100.5, 250.5, 480.5}) {
            const Shot shot{{x, 200.5}, 6.0};
            points.push_back(wrongPoint(c, shot, turn * c.world(shot.pixel, shot.z) + dvec3(4, -1, 2)));
        }
        const Diagnosis onLine = diagnose(caseOf(c), points).value();
        QCOMPARE(QString::fromStdString(onLine.verdict), QStringLiteral("unknown"));
        QVERIFY(!named(onLine, "frame-differs"));
        QCOMPARE(onLine.lacking, (std::vector{Lack::OtherDepth, Lack::Plane}));
        QVERIFY(verdictSentence(onLine).find("lie on a line") != std::string::npos);
        // Other near and far planes at one depth.
        points.clear();
        for (const Shot &shot : {Shot{{100.5, 60.5}, 6.0}, Shot{{500.5, 90.5}, 6.0}, Shot{{420.5, 400.5}, 6.0}}) {
            Camera other = c;
            other.nearDistance = 0.0173;
            other.farDistance = 331.7;
            points.push_back(wrongPoint(c, shot, c.world(shot.pixel, other.distance(c.depth(shot.z)))));
        }
        QVERIFY(!named(diagnose(caseOf(c), points).value(), "near-far-differ"));
    }

    void theFitOfAFrame()
    {
        const std::vector<dvec3> from{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, 1}};
        const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(2.1, glm::normalize(dvec3(1, 2, 3))));
        const auto mapped = [&](double mirror, double scale, std::span<const dvec3> points) {
            std::vector<dvec3> to;
            for (const dvec3 &p : points)
                to.push_back(scale * (mirror * turn * p) + dvec3(100, -50, 7));
            return to;
        };
        const auto turned = fittedFrame(from, mapped(1, 2, from), true),
                   mirrored = fittedFrame(from, mapped(-1, 2, from), true);
        QVERIFY(turned && !turned->isMirrored() && turned->isHandednessKnown && turned->residual < 1e-12);
        QVERIFY(mirrored && mirrored->isMirrored() && mirrored->residual < 1e-12);
        QVERIFY(std::abs(turned->scale - 2.0) < 1e-12);
        // Without a scale a scaled figure leaves a residual.
        QVERIFY(fittedFrame(from, mapped(1, 2, from), false)->residual > 0.5);
        const auto plane = std::span(from).first(3);
        QVERIFY(!fittedFrame(plane, mapped(-1, 1, plane), true)->isHandednessKnown);
        QVERIFY(fittedFrame(plane, mapped(-1, 1, plane), true)->residual < 1e-12);
        const std::vector<dvec3> line{{0, 0, 0}, {1, 1, 1}, {3, 3, 3.01}};
        QVERIFY(extentOf(line) == Extent::Line && !fittedFrame(line, mapped(1, 1, line), true));
        QVERIFY(extentOf(plane) == Extent::Plane && extentOf(from) == Extent::Space);
        QVERIFY(!fittedFrame(std::span(from).first(2), mapped(1, 1, std::span(from).first(2)), true));
    }

    /// Wrong points of programs in public questions, remade: 1024 x 768 pixels, 60 degrees, near 0.1, far
    /// 50. The right point of the click is (0.5, 0.75, -0.25).
    void publicQuestions_data()
    {
        addColumn<dvec3>("got");
        addColumn<QString>("verdict");
        newRow("focal length H/2") << dvec3(0.7649, 1.2316, -0.6016) << QStringLiteral("fovy-differs");
        newRow("P[0][0] as focal length, z ahead, y down")
            << dvec3(310.0089, -332.9363, -37.9808) << QStringLiteral("opencv-axes+focal-length-not-in-pixels");
        newRow("unproject(x, z, ...)") << dvec3(0.0663, 3.2070, -0.9728) << QStringLiteral("y-is-depth");
        newRow("another point's w") << dvec3(-18.2566, -8.6283, 2455.3611) << QStringLiteral("w-of-another-point");
        newRow("the eye") << dvec3(3, 2, 5) << QStringLiteral("known-point");
        // One point leaves near and far open: the candidates are told with their values.
        newRow("near 0.01, far 1000") << dvec3(2.7174, 1.8587, 4.4066) << QStringLiteral("unknown");
    }

    void publicQuestions()
    {
        QFETCH(dvec3, got);
        QFETCH(QString, verdict);
        Case of;
        of.setup = {{1024, 768, 1.0},
                    {0, 0, 1024, 768},
                    {},
                    Projection(Perspective{std::numbers::pi / 3, 1024.0 / 768.0, 0.1, 50}),
                    LookAt{WorldPoint(3, 2, 5), WorldPoint(0, 0, 0), {0, 1, 0}}};
        WrongPoint point;
        point.pixel = DevicePoint(575.040, 305.334);
        point.depth = 0.984965;
        point.depthLastDigit = 1e-6;
        point.got = got;
        const Diagnosis diagnosis = diagnose(of, {&point, 1}).value();
        QCOMPARE(QString::fromStdString(diagnosis.verdict), verdict);
        if (verdict == QStringLiteral("fovy-differs"))
            QCOMPARE(valueOf(diagnosis.candidates.front(), "fovy"), std::vector{90.0});
        if (verdict == QStringLiteral("unknown")) {
            QVERIFY(diagnosis.candidates.front().explains && diagnosis.chance > 0.5);
            QVERIFY(isNear(valueOf(*named(diagnosis, "near-differs"), "near").at(0), 0.0101));
        }
    }
};

UNPROJECTOR_TEST(TestDoctorCameras)
#include "test_doctor_cameras.moc"
