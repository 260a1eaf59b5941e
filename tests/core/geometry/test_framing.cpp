// The camera that shows points as large as possible, judged by their positions in its picture.

#include "tests/support/test.h"

#include "core/geometry/camera_motion.h"
#include "core/geometry/framing.h"
#include "core/geometry/numbers.h"
#include "core/scene/scene.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

using namespace unprojector;
using namespace unprojector::geometry;

namespace {

constexpr double kRounding = 1e-9;

/// The visible extent of points: the rectangle around them as shares of the viewport, 0 to 1.
struct Seen {
    glm::dvec2 lowest{1e300}, highest{-1e300};

    glm::dvec2 size() const { return highest - lowest; }
    glm::dvec2 middle() const { return (lowest + highest) / 2.0; }
};

/// @return nothing where a point is behind the eye
std::optional<Seen> seenIn(const Setup &setup, const std::vector<WorldPoint> &points)
{
    const glm::dmat4 matrix = clipFromWorld(setup).value();
    Seen seen;
    for (const WorldPoint &point : points) {
        const glm::dvec4 clip = matrix * glm::dvec4(point.coordinates(), 1.0);
        if (!(clip.w > 0.0))
            return std::nullopt;
        const glm::dvec2 share = (glm::dvec2(clip) / clip.w + 1.0) / 2.0;
        seen.lowest = glm::min(seen.lowest, share);
        seen.highest = glm::max(seen.highest, share);
    }
    return seen;
}

Setup framed(const Setup &setup, const std::vector<WorldPoint> &points)
{
    Framing framing(setup);
    for (const WorldPoint &point : points)
        framing.add(point);
    return framing.setup();
}

std::vector<WorldPoint> cloud(const glm::dvec3 &center, const glm::dvec3 &half)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    std::vector<WorldPoint> points;
    for (int k = 0; k < 200; ++k)
        points.emplace_back(center + half * glm::dvec3(share(random), share(random), share(random)));
    return points;
}

/// Points in the order of a scan, with neighbours close together: a wound ball, then one a little
/// larger.
std::vector<WorldPoint> woundUp(const glm::dvec3 &center, const glm::dvec3 &half, int count, bool isBackwards)
{
    std::vector<WorldPoint> points;
    for (const double size : {0.98, 1.0}) {
        for (int k = 0; k < count; ++k) {
            const double share = (k + 0.5) / count, turn = 40.0 * kPi * share, radius = std::sin(kPi * share);
            const glm::dvec3 place(radius * std::cos(turn), radius * std::sin(turn), std::cos(kPi * share));
            points.emplace_back(center + size * half * (isBackwards ? -place : place));
        }
    }
    return points;
}

Setup pictureWith(const Projection &projection)
{
    return {{1200, 800, 1.5},
            {0.0, 0.0, 1200.0, 800.0},
            {},
            projection,
            LookAt{WorldPoint(5.0, 6.0, 9.0), WorldPoint(1.0, 2.0, 3.0), {0.0, 1.0, 0.0}}};
}

} // namespace

class TestFraming : public QObject {
    Q_OBJECT

private slots:
    void pointsFillThePicture_data()
    {
        addColumn<Setup>("picture");
        addColumn<glm::dvec3>("half");
        const Ortho box{-4.0, 8.0, -3.0, 5.0, -2.0, 40.0};
        for (const auto &[shape, half] :
             {std::pair("ball", glm::dvec3(2.0)), std::pair("wide", glm::dvec3(9.0, 1.0, 0.5)),
              std::pair("high", glm::dvec3(0.2, 7.0, 0.4)), std::pair("deep", glm::dvec3(0.5, 0.4, 30.0)),
              std::pair("tiny", glm::dvec3(1e-4, 1e-4, 1e-4))}) {
            const auto row = [shape = shape, half = half](const char *name, const Setup &setup) {
                addRow("%s, %s", name, shape) << setup << half;
            };
            row("frustum", pictureWith(Frustum{-0.6, 0.6, -0.4, 0.4, 1.0, 100.0}));
            row("frustum, off-centre", pictureWith(Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0}));
            row("frustum, mirrored", pictureWith(Frustum{0.6, -0.6, -0.4, 0.4, 1.0, 100.0}));
            row("frustum, skewed", pictureWith(Frustum{-0.6, 0.6, -0.4, 0.4, 1.0, 100.0, 0.3}));
            row("perspective", pictureWith(Perspective{kPi / 4.0, 1.5, 0.1, 100.0}));
            row("ortho, off-centre", pictureWith(box));
            row("oblique", pictureWith(Oblique{box, kPi / 3.0, 2.0 * kPi / 3.0}));
        }
    }

    void pointsFillThePicture()
    {
        QFETCH(Setup, picture);
        QFETCH(glm::dvec3, half);
        const std::vector<WorldPoint> points = cloud({10.0, -4.0, 2.0}, half);
        for (const StandardView side : {StandardView::Front, StandardView::Left, StandardView::Top}) {
            for (const bool isTurned : {false, true}) {
                Setup before = picture;
                if (!isTurned)
                    before.camera() = seenFrom(before.camera(), side);
                const Setup after = framed(before, points);
                QVERIFY(check(after));
                const std::optional<Seen> seen = seenIn(after, points);
                QVERIFY(seen);
                const glm::dvec2 size = seen->size(), middle = seen->middle();
                // Only a slender object, seen from its end, could be seen from closer.
                const bool isSlender = glm::length(half) > 6.0;
                QVERIFY2(std::abs(std::max(size.x, size.y) - Framing::kFilled) < 1e-6 || isSlender,
                         qPrintable(QStringLiteral("%1 x %2").arg(size.x).arg(size.y)));
                QVERIFY(size.x <= Framing::kFilled + 1e-6 && size.y <= Framing::kFilled + 1e-6);
                // Across the pair of rims that is touched exactly, along the other about: it is nearer
                // there than here.
                for (int axis = 0; axis < 2; ++axis)
                    QVERIFY2(std::abs(middle[axis] - 0.5) < (size[axis] > Framing::kFilled - 1e-5 ? 1e-5 : 0.2),
                             qPrintable(QString::number(middle[axis], 'g', 12)));
                const LookAt &camera = after.camera();
                const auto direction = [](const LookAt &c) { return normalized(c.center - c.eye).coordinates(); };
                QVERIFY(glm::length(direction(camera) - direction(before.camera())) < kRounding);
                // The centre, about which the mouse turns, is at the depth of the shown points.
                QVERIFY(
                    std::abs(dot(camera.center - WorldPoint(10.0, -4.0, 2.0), normalized(camera.center - camera.eye)))
                    < 0.2 * glm::length(half));
            }
        }
    }

    void itDoesNotMatterWhereTheCameraIs()
    {
        const std::vector<WorldPoint> points = cloud({1.0, 2.0, 3.0}, {1.0, 2.0, 0.5});
        const Setup one = pictureWith(Frustum{-0.2, 1.0, -0.7, 0.1, 1.0, 100.0});
        Setup other = one;
        other.camera() = moved(one.camera(), {300.0, -20.0, 70.0});
        const LookAt a = framed(one, points).camera(), b = framed(other, points).camera();
        QVERIFY(distance(a.eye, b.eye) < kRounding && distance(a.center, b.center) < kRounding);
        // Again it stays.
        const LookAt again = framed(framed(one, points), points).camera();
        QVERIFY(distance(a.eye, again.eye) < kRounding && distance(a.center, again.center) < kRounding);
    }

    void aModelIsFramedByItsTriangles_data()
    {
        addColumn<int>("count");
        addColumn<bool>("isSoup");
        for (const int count : {3, 200, 3000, 30000}) {
            addRow("%d", count) << count << false;
            addRow("%d, a soup", count) << count << true;
        }
    }

    void aModelIsFramedByItsTriangles()
    {
        QFETCH(int, count);
        QFETCH(bool, isSoup);
        const std::vector<WorldPoint> points = woundUp({1.0, 2.0, 3.0}, {1.0, 2.0, 0.5}, count, isSoup);
        auto model = std::make_shared<mesh::Model>();
        mesh::Mesh &mesh = model->meshes.emplace_back();
        for (const WorldPoint &point : points) {
            if (!isSoup && mesh.positions.size() % 500 == 2)
                mesh.positions.emplace_back(1000.0f, 0.0f, 0.0f); // of no triangle
            if (!isSoup)
                mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.emplace_back((point.coordinates() - glm::dvec3(1.0, 2.0, 3.0)) / 4.0);
        }
        const scene::SceneObject object{"cloud", {}, model, {Translate{{1.0, 2.0, 3.0}}, Scale{{4.0, 4.0, 4.0}}}};
        const Setup setup = pictureWith(Perspective{kPi / 4.0, 1.5, 0.1, 100.0});
        Framing framing(setup);
        add(framing, object);
        // Positions are in single precision.
        QVERIFY(distance(framing.setup().camera().eye, framed(setup, points).camera().eye) < 1e-5);
    }

    void littleIsShownWithItsSurroundings_data()
    {
        addColumn<Setup>("picture");
        newRow("frustum") << pictureWith(Frustum{-0.6, 0.6, -0.4, 0.4, 1.0, 100.0});
        newRow("ortho") << pictureWith(Ortho{-4.0, 8.0, -3.0, 5.0, -2.0, 40.0});
    }

    void littleIsShownWithItsSurroundings()
    {
        QFETCH(Setup, picture);
        for (const std::vector<WorldPoint> &points : {std::vector<WorldPoint>{},
                                                      {WorldPoint(7.0, 8.0, 9.0)},
                                                      {WorldPoint(7.0, 8.0, 9.0), WorldPoint(7.0, 8.0, 9.0)}}) {
            const Setup after = framed(picture, points);
            QVERIFY(check(after));
            const WorldPoint shown = points.empty() ? WorldPoint() : points.front();
            const Seen seen = seenIn(after, {shown}).value();
            QVERIFY(glm::length(seen.middle() - glm::dvec2(0.5)) < 0.1);
            // One unit fills the picture, or nearly.
            const Seen unit =
                seenIn(after, {shown - WorldVector(0.0, 0.5, 0.0), shown + WorldVector(0.0, 0.5, 0.0)}).value();
            QVERIFY(unit.size().y > 0.4 && unit.size().y < 1.0);
        }
    }

    void aNeedleAtTheEyeIsNotPiercedByIt()
    {
        for (const Projection &projection : {Projection(Frustum{-0.6, 0.6, -0.4, 0.4, 1.0, 100.0}),
                                             Projection(Ortho{-4.0, 8.0, -3.0, 5.0, -2.0, 40.0})}) {
            Setup setup = pictureWith(projection);
            setup.camera() = {WorldPoint(0.0, 0.0, 9.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
            Setup after = framed(setup, {WorldPoint(0.0, 0.0, -2.0), WorldPoint(0.0, 0.0, 2.0)});
            QVERIFY(check(after));
            if (isPerspective(projection))
                QVERIFY(std::abs(after.camera().eye.z - 2.08) < kRounding); // a fiftieth of its length before its point
            Box needle;
            needle.add(glm::dvec3(0.0, 0.0, -2.0));
            needle.add(glm::dvec3(0.0, 0.0, 2.0));
            after.projection() = withFittedClipDistances(after, needle, {});
            QVERIFY(check(after));
            const NdcPoint tip =
                ndcFromWindow(after.viewport, after.depthRange, windowFromWorld(after, WorldPoint(0, 0, 2)).value());
            QVERIFY(std::abs(tip.z) <= 1.0);
        }
    }
};

UNPROJECTOR_TEST(TestFraming)
#include "test_framing.moc"
