// Clicks on a picture of a scene: the object that they hit, the position, and the reported details.

#include "tests/support/test.h"

#include "core/geometry/numbers.h"
#include "core/geometry/view_matrix.h"
#include "core/ray/scene_rays.h"
#include "tests/core/ray/ray_meshes.h"

#include "tests/support/cube_sphere.h"
#include "tests/support/oracle.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace ray_meshes;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::ray;
using namespace unprojector::unproject;
using unprojector::scene::SceneObject;

const LookAt kCamera{WorldPoint(1.0, 2.0, 6.0), WorldPoint(0.1, -0.2, 0.3), {0.0, 1.0, 0.1}};

Setup pictureWith(const Lens &lens, const DepthRange &range = {}, const Pose &pose = kCamera)
{
    const Surface surface{640, 480, 1.0};
    return {surface, wholeSurface(surface), range, lens, pose};
}

Setup usualPicture()
{
    return pictureWith(Perspective{radiansFromDegrees(45.0), 4.0 / 3.0, 1.0, 20.0});
}

/// A clicked scene: objects with trees of their own.
struct Clicked {
    std::vector<SceneObject> objects;
    std::vector<glm::dvec4> clipPlanes = {};

    SceneRays rays(const Setup &setup) const
    {
        std::vector<std::shared_ptr<const RayCaster>> casters;
        for (const SceneObject &object : objects)
            casters.push_back(RayCaster::build(object.model, {}));
        return SceneRays(*Unprojector::of(setup), objects, casters, clipPlanes);
    }
    std::optional<SceneHit> at(const DevicePoint &position) const { return *rays(usualPicture()).at(position); }
};

SceneObject objectOf(std::shared_ptr<const Model> model, std::vector<TransformStep> transform = {})
{
    return {"object", {}, std::move(model), std::move(transform)};
}

/// Large, parallel to the picture of kStraight, at a height.
std::shared_ptr<Model> wallAt(float z)
{
    return modelOf({{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}}, {0, 1, 2, 0, 2, 3});
}

/// Looks down -z from z = 5; near 1, far 11: z from 4 to -6.
Setup straightPicture()
{
    return pictureWith(Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 11.0}, {},
                       LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
}

glm::dmat4 reversedInfinite(double nearPlane)
{
    glm::dmat4 m(0.0);
    m[0][0] = 1.8;
    m[1][1] = 2.4;
    m[2][3] = -1.0;
    m[3][2] = nearPlane;
    return m;
}

/// The view turned by 90 degrees, as for a display that is held upright. It has no known form.
glm::dmat4 rolled(const glm::dmat4 &m)
{
    glm::dmat4 result = m;
    for (int column = 0; column < 4; ++column) {
        result[column][0] = -m[column][1];
        result[column][1] = m[column][0];
    }
    return result;
}

/// The matrix with the greater depths in front, for NDC depths from -1 to 1.
glm::dmat4 reversed(glm::dmat4 m)
{
    for (int column = 0; column < 4; ++column)
        m[column][2] = -m[column][2];
    return m;
}

const DevicePoint kMiddle(320.0, 240.0);

} // namespace

namespace {

using Number = oracle::Extended;

/// The exact point of a line of sight on a plane.
oracle::Vector3 onPlane(const oracle::Oracle &exact, const glm::dvec2 &window, const std::array<glm::dvec3, 3> &corners)
{
    const auto minus = [](const oracle::Vector3 &a, const oracle::Vector3 &b) { return oracle::difference(a, b); };
    const auto dot = [](const oracle::Vector3 &a, const oracle::Vector3 &b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const auto placeOf = [](const glm::dvec3 &p) { return oracle::Vector3{p.x, p.y, p.z}; };
    const oracle::Vector3 from = exact.worldUnder({window.x, window.y, 0.0}),
                          along = minus(exact.worldUnder({window.x, window.y, 0.5}), from);
    const oracle::Vector3 a = placeOf(corners[0]), u = minus(placeOf(corners[1]), a), v = minus(placeOf(corners[2]), a);
    const oracle::Vector3 normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const Number t = dot(minus(a, from), normal) / dot(along, normal);
    return {from[0] + t * along[0], from[1] + t * along[1], from[2] + t * along[2]};
}

/// The largest share of a hit's error in its uncertainty, of the three coordinates; and the median
/// of the uncertainty in units of the error.
class Shares {
public:
    void add(const SceneHit &hit, const oracle::Vector3 &truth)
    {
        double largest = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double off = std::abs(static_cast<double>(truth[std::size_t(axis)] - hit.world[axis]));
            m_outside += off <= hit.uncertainty[axis] ? 0 : 1;
            largest = std::max(largest, off);
        }
        m_ratios.push_back(length(hit.uncertainty) / std::max(largest, 1e-300));
    }
    int outside() const { return m_outside; }
    std::size_t hits() const { return m_ratios.size(); }
    double median()
    {
        std::sort(m_ratios.begin(), m_ratios.end());
        return m_ratios.at(m_ratios.size() / 2);
    }

private:
    int m_outside = 0;
    std::vector<double> m_ratios;
};

} // namespace

class TestSceneRays : public QObject {
    Q_OBJECT

private slots:
    void hitsAreSeenWhereTheClickWas_data()
    {
        addColumn<Setup>("picture");
        const Perspective perspective{radiansFromDegrees(40.0), 4.0 / 3.0, 0.5, 50.0};
        const Ortho ortho{-2.0, 2.0, -1.5, 1.5, 0.5, 50.0};
        const auto matrixOf = [](const Projection &projection) {
            return MatrixProjection{*clipFromEye(projection), std::nullopt};
        };
        newRow("perspective") << pictureWith(perspective);
        newRow("off-centre frustum") << pictureWith(Frustum{-0.2, 0.1, -0.1, 0.15, 0.5, 50.0});
        newRow("mirrored frustum") << pictureWith(Frustum{0.2, -0.2, -0.15, 0.15, 0.5, 50.0});
        newRow("ortho") << pictureWith(ortho);
        newRow("ortho, near behind the eye") << pictureWith(Ortho{-2.0, 2.0, -1.5, 1.5, -30.0, 50.0});
        newRow("oblique") << pictureWith(Oblique{ortho, radiansFromDegrees(80.0), radiansFromDegrees(100.0)});
        newRow("reversed depth range") << pictureWith(perspective, {1.0, 0.0});
        newRow("matrix of a perspective") << pictureWith(matrixOf(perspective));
        newRow("matrix of a box") << pictureWith(matrixOf(ortho));
        newRow("matrix, reversed, far at infinity")
            << pictureWith(MatrixProjection{reversedInfinite(0.5), NdcDepth::ZeroToOne});
        newRow("skewed") << pictureWith(Frustum{-0.2, 0.1, -0.1, 0.15, 0.5, 50.0, 0.3});
        newRow("pinhole") << pictureWith(Pinhole{600, 500, 200, 250, 30, 640, 480, 0.5, 50.0, true});
        glm::dmat4 skewed = *clipFromEye(Projection(perspective));
        skewed[1][0] += 0.1;
        const std::pair<const char *, glm::dmat4> matrices[] = {
            {"perspective", *clipFromEye(Projection(perspective))},
            {"skewed", skewed},
            {"rolled", rolled(*clipFromEye(Projection(perspective)))},
            {"box, rolled", rolled(*clipFromEye(Projection(ortho)))},
        };
        for (const auto &[name, matrix] : matrices) {
            addRow("matrix, %s", name) << pictureWith(MatrixProjection{matrix, std::nullopt});
            addRow("matrix, %s, negated", name) << pictureWith(MatrixProjection{-matrix, std::nullopt});
            addRow("matrix, %s, reversed", name) << pictureWith(MatrixProjection{reversed(matrix), std::nullopt});
            addRow("matrix, %s, reversed, negated", name)
                << pictureWith(MatrixProjection{-reversed(matrix), std::nullopt});
        }
        newRow("view by matrix") << pictureWith(perspective, {}, eyeFromWorld(*eyeFrame(kCamera)));
        Setup part = pictureWith(perspective);
        part.viewport = {100.0, 50.0, 320.0, 240.0};
        newRow("viewport in a part of the window") << part;
    }

    void hitsAreSeenWhereTheClickWas()
    {
        QFETCH(Setup, picture);
        const SceneRays rays = Clicked{{objectOf(cubeSphere(40))}}.rays(picture);
        Aim aim(1);
        int hits = 0;
        for (int i = 0; i < tests::rounds(2000); ++i) {
            const DevicePoint click(640.0 * aim.share(), 480.0 * aim.share());
            const auto hit = rays.at(click);
            QVERIFY(hit.hasValue());
            if (!*hit)
                continue;
            ++hits;
            const DevicePoint seen = deviceFromWindow(picture.surface, *windowFromWorld(picture, (*hit)->world));
            QVERIFY2(distance(seen, click) < 1e-9, qPrintable(QString::number(distance(seen, click))));
            // The near side: the surface looks at the eye.
            const Ray<WorldSpace> ray = *rays.rays().at(click);
            QVERIFY(dot((*hit)->triangle->normal, ray.along) < 0.0);
            QVERIFY(dot(ray.along, kCamera.center - kCamera.eye) > 0.0);
        }
        QVERIFY2(hits > tests::rounds(50), qPrintable(QString::number(hits)));
    }

    void placedObjectsAnswerAsTheirTrianglesInTheWorld_data()
    {
        addColumn<std::vector<TransformStep>>("transform");
        const auto row = [](const char *name, const std::vector<TransformStep> &steps) { newRow(name) << steps; };
        row("none", {});
        row("turned and moved", {Translate{{0.5, -0.3, 1.0}}, Rotate{37.0, {1.0, 2.0, 0.5}}});
        row("mirrored", {Scale{{-1.0, 1.0, 1.0}}});
        row("scaled unevenly", {Rotate{20.0, {0.0, 1.0, 1.0}}, Scale{{3.0, 0.2, 1.0}}, Rotate{-50.0, {1.0, 0.0, 0.0}}});
        row("tiny object", {Scale{{1e-6, 1e-6, 1e-6}}, Scale{{1e6, -1e6, 1e6}}});
    }

    void placedObjectsAnswerAsTheirTrianglesInTheWorld()
    {
        QFETCH(std::vector<TransformStep>, transform);
        const auto model = soup(1500, 2);
        const SceneRays rays = Clicked{{objectOf(model, transform)}}.rays(usualPicture());
        const glm::dmat4 m = worldFromObject(transform);
        Aim aim(3);
        int hits = 0;
        for (int i = 0; i < tests::rounds(4000); ++i) {
            const DevicePoint click(640.0 * aim.share(), 480.0 * aim.share());
            const Ray<WorldSpace> ray = *rays.rays().at(click);
            const LineCrossing line(ray.from.coordinates(), ray.along.coordinates());
            std::optional<double> t;
            for (std::uint32_t k = 0; k < model->meshes[0].triangleCount(); ++k) {
                auto corners = cornersOf(model->meshes[0], k);
                for (glm::dvec3 &corner : corners)
                    corner = glm::dvec3(m * glm::dvec4(corner, 1.0));
                const auto crossing = line.with(corners[0], corners[1], corners[2]);
                if (crossing && crossing->t >= 0.0 && crossing->t <= t.value_or(1.0))
                    t = crossing->t;
            }
            const auto hit = *rays.at(click);
            QCOMPARE(hit.has_value(), t.has_value());
            if (!hit)
                continue;
            ++hits;
            QVERIFY(std::abs(hit->t - *t) < 1e-9);
            QVERIFY(distance(hit->world, ray.at(*t)) < 1e-9);
            const glm::dvec3 back(m * glm::dvec4(hit->objectPoint.coordinates(), 1.0));
            QVERIFY(distance(WorldPoint(back), hit->world) < 1e-12);
        }
        QVERIFY2(hits > tests::rounds(50), qPrintable(QString::number(hits)));
    }

    void nearAndFarEndTheRay()
    {
        const auto hitAt = [](float z) {
            return (*Clicked{{objectOf(wallAt(z))}}.rays(straightPicture()).at(kMiddle)).has_value();
        };
        QVERIFY(!hitAt(4.001f));
        QVERIFY(hitAt(4.0f));
        QVERIFY(hitAt(-6.0f));
        QVERIFY(!hitAt(-6.001f));
    }

    void outsideThePictureNothingIsMet()
    {
        Setup setup = straightPicture();
        setup.viewport = {100.0, 60.0, 320.0, 240.0}; // from the top: 180 to 420
        const SceneRays rays = Clicked{{objectOf(wallAt(0.0f))}}.rays(setup);
        const auto isHit = [&rays](double x, double y) { return (*rays.at(DevicePoint(x, y))).has_value(); };
        QVERIFY(isHit(100.5, 180.5) && isHit(419.5, 419.5));
        QVERIFY(!isHit(99.5, 200.5) && !isHit(420.5, 200.5) && !isHit(200.5, 179.5) && !isHit(200.5, 420.5));
    }

    void clipPlanesCut_data()
    {
        addColumn<std::vector<glm::dvec4>>("planes");
        addColumn<double>("z"); // of the wall that the ray hits; 9: none
        const auto row = [](const char *name, const std::vector<glm::dvec4> &planes, double z) {
            newRow(name) << planes << z;
        };
        row("none", {}, 2.0);
        row("cuts the first wall off", {{0.0, 0.0, -1.0, 1.0}}, 0.0);
        row("goes through the second wall, which stays", {{0.0, 0.0, -1.0, 0.0}}, 0.0);
        row("cuts all but the last off", {{0.0, 0.0, -2.0, -1.0}}, -2.0);
        row("from both sides", {{0.0, 0.0, -1.0, 1.0}, {0.0, 0.0, 1.0, -0.5}}, 9.0);
        row("along the ray, which is outside", {{1.0, 0.0, 0.0, -1.0}}, 9.0);
        row("along the ray, which is inside", {{1.0, 0.0, 0.0, 1.0}}, 2.0);
    }

    void clipPlanesCut()
    {
        QFETCH(std::vector<glm::dvec4>, planes);
        QFETCH(double, z);
        const auto hit = *Clicked{{objectOf(wallAt(2.0f)), objectOf(wallAt(0.0f)), objectOf(wallAt(-2.0f))}, planes}
                              .rays(straightPicture())
                              .at(kMiddle);
        QCOMPARE(hit ? hit->world.z : 9.0, z);
    }

    void hiddenAndUnbuiltObjectsAreNotMet()
    {
        Clicked clicked{{objectOf(wallAt(2.0f)), objectOf(wallAt(1.0f)), objectOf(wallAt(0.0f))}};
        clicked.objects[0].isHidden = true;
        QCOMPARE((*clicked.rays(straightPicture()).at(kMiddle))->object, std::size_t(1));
        const std::vector<std::shared_ptr<const RayCaster>> casters{nullptr, nullptr,
                                                                    RayCaster::build(clicked.objects[2].model, {})};
        const SceneRays rays(*Unprojector::of(straightPicture()), clicked.objects, casters, {});
        QCOMPARE((*rays.at(kMiddle))->object, std::size_t(2));
    }

    void theNearestObjectAnswersAndOfEqualOnesTheFirst()
    {
        const Clicked clicked{{objectOf(wallAt(0.0f)), objectOf(wallAt(1.0f), {Scale{{1.0, 1.0, -1.0}}}),
                               objectOf(wallAt(-1.0f), {Scale{{1.0, 1.0, -1.0}}}), objectOf(wallAt(1.0f))}};
        const auto hit = *clicked.rays(straightPicture()).at(kMiddle);
        QCOMPARE(hit->object, std::size_t(2));
        QCOMPARE(hit->world.z, 1.0);
        QCOMPARE(hit->objectPoint.z, -1.0);
    }

    void normalsLookOut_data()
    {
        addColumn<std::vector<TransformStep>>("transform");
        const auto row = [](const char *name, const std::vector<TransformStep> &steps) { newRow(name) << steps; };
        row("as it is", {});
        row("mirrored", {Scale{{1.0, 1.0, -1.0}}});
        row("flattened", {Rotate{30.0, {0.0, 0.0, 1.0}}, Scale{{1.0, 0.1, 1.0}}});
    }

    void normalsLookOut()
    {
        QFETCH(std::vector<TransformStep>, transform);
        const auto model = cubeSphere(30, 0.0);
        const SceneRays rays = Clicked{{objectOf(model, transform)}}.rays(usualPicture());
        const glm::dmat3 normalMatrix = glm::inverse(glm::transpose(glm::dmat3(worldFromObject(transform))));
        Aim aim(4);
        for (int i = 0; i < tests::rounds(500); ++i) {
            const auto hit = *rays.at(DevicePoint(640.0 * aim.share(), 480.0 * aim.share()));
            if (!hit)
                continue;
            const glm::dvec3 &normal = hit->triangle->normal.coordinates();
            QVERIFY(std::abs(glm::length(normal) - 1.0) < 1e-15);
            // The ball's own normal there points from its middle.
            const glm::dvec3 expected = glm::normalize(normalMatrix * hit->objectPoint.coordinates());
            QVERIFY(glm::dot(normal, expected) > 0.98);
        }
    }

    void distances()
    {
        const Clicked clicked{{objectOf(wallAt(2.0f))}};
        const DevicePoint corner(0.0, 0.0);
        const auto hit = *clicked.rays(straightPicture()).at(corner);
        QVERIFY(std::abs(hit->distance - std::sqrt(9.0 + 9.0 + 81.0 / 16.0)) < 1e-14); // from (0, 0, 5) to (-3, 9/4, 2)
        Setup box = straightPicture();
        box.lens = Ortho{-1.0, 1.0, -1.0, 1.0, 1.0, 11.0};
        QCOMPARE((*clicked.rays(box).at(corner))->distance, 2.0); // from the near plane, z = 4
    }

    void nearestVertexAndEdge()
    {
        // The second mesh's triangle: its vertices are counted behind the four of the first.
        auto model = std::make_shared<Model>(*wallAt(-3.0f));
        Mesh second;
        second.positions = {{9, 9, 9}, {-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}};
        second.indices = {1, 2, 3};
        model->meshes.push_back(second);
        model->bounds = boundsOf(model->meshes);
        const SceneRays rays = Clicked{{objectOf(model, {Scale{{2.0, 2.0, 2.0}}})}}.rays(straightPicture());
        // The world point (-1.6, -1.2, 0), seen at 5 in front of the eye where the picture is 10 wide.
        const auto hit = *rays.at(DevicePoint(320.0 - 1.6 * 64.0, 240.0 + 1.2 * 64.0));
        QVERIFY(hit.has_value());
        QCOMPARE(hit->triangle->triangle, 2u);
        QCOMPARE(hit->triangle->ids[0], 5u);
        QVERIFY(distance(hit->world, WorldPoint(-1.6, -1.2, 0.0)) < 1e-14);
        QCOMPARE(hit->vertex.id, 5u);
        QCOMPARE(hit->vertex.world, WorldPoint(-2.0, -2.0, 0.0));
        QVERIFY(std::abs(hit->vertex.distance - std::sqrt(0.16 + 0.64)) < 1e-14);
        QCOMPARE(hit->triangle->edge.ids[0], 7u);
        QCOMPARE(hit->triangle->edge.ids[1], 5u);
        QVERIFY(distance(hit->triangle->edge.world, WorldPoint(-2.0, -1.2, 0.0)) < 1e-14);
        QVERIFY(std::abs(hit->triangle->edge.distance - 0.4) < 1e-14);
    }

    void farWorldsKeepTheirMillimetres()
    {
        const auto model = cubeSphere(40);
        const glm::dvec3 place(4e6, 5e5, 300.0);
        model->meshes[0].origin = place;
        model->bounds = boundsOf(model->meshes);
        Setup distant = usualPicture();
        distant.camera() = {WorldPoint(place + glm::dvec3(1, 2, 6)), WorldPoint(place + glm::dvec3(0.1, -0.2, 0.3)),
                            kCamera.up};
        const SceneRays farRays = Clicked{{objectOf(model)}}.rays(distant);
        // Moved back by its transform, the model is where it would be without an origin.
        const SceneRays backRays = Clicked{{objectOf(model, {Translate{-place}})}}.rays(usualPicture());
        const SceneRays nearRays = Clicked{{objectOf(cubeSphere(40))}}.rays(usualPicture());
        Aim aim(5);
        int hits = 0;
        for (int i = 0; i < tests::rounds(1000); ++i) {
            const DevicePoint click(640.0 * aim.share(), 480.0 * aim.share());
            const auto farHit = *farRays.at(click), backHit = *backRays.at(click), hit = *nearRays.at(click);
            if (!hit || !farHit || !backHit)
                continue;
            ++hits;
            // The eye's own digits end at 1e-9 there, and grazing rays make more of it.
            const WorldVector uncertainty = farHit->uncertainty + hit->uncertainty;
            const glm::dvec3 off = farHit->world.coordinates() - place - hit->world.coordinates();
            QVERIFY(glm::all(glm::lessThanEqual(glm::abs(off), uncertainty.coordinates() + 1e-9)));
            const glm::dvec3 backOff = backHit->world.coordinates() - hit->world.coordinates();
            QVERIFY(glm::all(glm::lessThanEqual(glm::abs(backOff), backHit->uncertainty.coordinates())));
            // The point lies on the triangle, relative to the origin.
            const auto corners = cornersOf(model->meshes[0], backHit->triangle->triangle);
            const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            QVERIFY(std::abs(glm::dot(backHit->world.coordinates() - corners[0], normal)) < 1e-12);
        }
        QVERIFY2(hits > tests::rounds(50), qPrintable(QString::number(hits)));
    }

    void uncertaintyHoldsWhatIsRounded_data()
    {
        addColumn<double>("offset");
        addColumn<double>("thickness");
        newRow("about the origin") << 0.0 << 0.3;
        newRow("beside it") << 100.0 << 0.3;
        newRow("far away") << 1e7 << 0.3;
        newRow("thin") << 0.0 << 1e-5;
        newRow("very thin") << 100.0 << 1e-11;
    }

    /// The truth is computed with 50 digits.
    void uncertaintyHoldsWhatIsRounded()
    {
        QFETCH(double, offset);
        QFETCH(double, thickness);
        using Place = std::array<Number, 3>;
        const auto minus = [](const Place &a, const Place &b) { return Place{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
        const auto dot = [](const Place &a, const Place &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
        const auto cross = [](const Place &a, const Place &b) {
            return Place{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        };
        const auto placeOf = [](const glm::dvec3 &p) { return Place{p.x, p.y, p.z}; };
        Aim aim(6);
        std::vector<glm::dvec3> exact;
        Box box;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 center = glm::dvec3(offset, 0.0, 0.0) + 2.0 * aim.share() * aim.direction();
            const glm::dvec3 along = 0.3 * aim.direction();
            for (const glm::dvec3 &corner :
                 {center, center + along, center + 0.5 * along + thickness * aim.direction()}) {
                exact.push_back(corner);
                box.add(corner);
            }
        }
        Mesh mesh;
        setPositions(mesh, originFor(box), exact);
        QVERIFY(!mesh.remainders.empty());
        const auto model = modelOf(std::move(mesh));
        Setup setup = usualPicture();
        setup.camera() = {WorldPoint(offset, 0.0, 9.0), WorldPoint(offset, 0.0, 0.0), kCamera.up};
        const SceneRays rays = Clicked{{objectOf(model)}}.rays(setup);
        int hits = 0, outside = 0;
        std::vector<double> ratios;
        const auto click = [&](const DevicePoint &position) {
            const auto hit = *rays.at(position);
            if (!hit)
                return;
            const Ray<WorldSpace> ray = *rays.rays().at(position);
            const std::size_t first = std::size_t{3} * hit->triangle->triangle;
            const Place a = placeOf(exact[first]), from = placeOf(ray.from.coordinates()),
                        along = placeOf(ray.along.coordinates());
            const Place normal = cross(minus(placeOf(exact[first + 1]), a), minus(placeOf(exact[first + 2]), a));
            const Number t = dot(minus(a, from), normal) / dot(along, normal);
            ++hits;
            bool isInside = true;
            glm::dvec3 off(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                const auto k = static_cast<std::size_t>(axis);
                off[axis] = static_cast<double>(abs(Number(from[k] + t * along[k] - hit->world[axis])));
                isInside = isInside && off[axis] <= hit->uncertainty.coordinates()[axis];
            }
            ratios.push_back(length(hit->uncertainty) / glm::length(off));
            outside += isInside ? 0 : 1;
        };
        for (int i = 0; i < tests::rounds(20000); ++i)
            click(DevicePoint(200.0 + 240.0 * aim.share(), 120.0 + 240.0 * aim.share()));
        // Thin ones have to be aimed at.
        for (std::size_t i = 0; i < exact.size(); i += 3) {
            const glm::dvec3 middle = (exact[i] + exact[i + 1] + exact[i + 2]) / 3.0;
            const auto seen = windowFromWorld(setup, WorldPoint(middle));
            if (seen)
                click(deviceFromWindow(setup.surface, *seen));
        }
        std::sort(ratios.begin(), ratios.end());
        QVERIFY2(hits > (thickness < 1e-3 ? 50 : tests::rounds(2000)), qPrintable(QString::number(hits)));
        QCOMPARE(outside, 0);
        QVERIFY2(ratios[ratios.size() / 2] < 1000.0, qPrintable(QString::number(ratios[ratios.size() / 2])));
    }

    void distancesCountFromTheEyeOfAnyMatrix()
    {
        const Projection frustum = Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 11.0};
        for (const glm::dmat4 &matrix : {rolled(*clipFromEye(frustum)), -reversed(rolled(*clipFromEye(frustum)))}) {
            Setup setup = straightPicture();
            setup.lens = MatrixProjection{matrix, std::nullopt};
            const SceneRays rays = Clicked{{objectOf(wallAt(0.0f))}}.rays(setup);
            const auto hit = *rays.at(DevicePoint(400.5, 200.5));
            QVERIFY(hit && std::abs(hit->distance - distance(hit->world, WorldPoint(0.0, 0.0, 5.0))) < 1e-13);
        }
        Setup box = straightPicture();
        box.lens = MatrixProjection{rolled(*clipFromEye(Ortho{-2.0, 2.0, -1.5, 1.5, 1.0, 11.0})), std::nullopt};
        const auto hit = *Clicked{{objectOf(wallAt(0.0f))}}.rays(box).at(DevicePoint(400.5, 200.5));
        QVERIFY(hit && std::abs(hit->distance - 4.0) < 1e-13); // from the near plane
    }

    /// The ray of such a matrix comes from its inverse, whose error grows with far : near and with the
    /// distance from the world's origin.
    void uncertaintyHoldsForMatricesOfNoKnownForm()
    {
        Aim aim(7);
        const auto anyOf = [&](double from, double to) { return from * std::pow(to / from, aim.share()); };
        Shares shares;
        for (int i = 0; i < tests::rounds(1600); ++i) {
            const double n = anyOf(0.01, 10.0), f = n * anyOf(2.0, i % 4 == 0 ? 1e12 : 1e5);
            glm::dmat4 matrix =
                *clipFromEye(Frustum{-n * anyOf(0.2, 1.0), n * anyOf(0.2, 1.0), -0.4 * n, 0.5 * n, n, f});
            matrix = i % 2 == 0 ? rolled(matrix) : matrix;
            if (i % 2 != 0)
                matrix[0][2] = 0.1 * aim.share(); // a tilted near plane
            if (i % 3 == 0)
                matrix = -reversed(matrix);
            const double away = anyOf(0.1, 1e5);
            const WorldPoint eye(away * aim.direction());
            const WorldVector ahead(aim.direction());
            const glm::dmat4 view = eyeFromWorld(*eyeFrame({eye, eye + ahead, {0.1, 0.2, 1.0}}));
            const double distance = n * anyOf(1.5, std::min(100.0, f / n));
            std::vector<glm::vec3> corners;
            std::array<glm::dvec3, 3> exact;
            for (std::size_t k = 0; k < 3; ++k) {
                corners.emplace_back((eye + ahead * distance).coordinates() + 0.3 * distance * aim.direction());
                exact[k] = glm::dvec3(corners[k]);
            }
            Setup setup = pictureWith(MatrixProjection{matrix, NdcDepth::MinusOneToOne}, {}, view);
            QVERIFY(!recognised(std::get<MatrixProjection>(setup.lens)));
            std::array<double, 16> lens{}, pose{};
            for (std::size_t k = 0; k < 16; ++k) {
                lens[k] = matrix[int(k / 4)][int(k % 4)];
                pose[k] = view[int(k / 4)][int(k % 4)];
            }
            const oracle::Oracle oracle(pose, lens, {0.0, 0.0, 640.0, 480.0, 0.0, 1.0}, false);
            const SceneRays rays = Clicked{{objectOf(modelOf(corners))}}.rays(setup);
            for (int k = 0; k < 20; ++k) {
                const DevicePoint click{640.0 * aim.share(), std::floor(480.0 * aim.share()) + 0.5}; // in this order
                if (const auto hit = rays.at(click); hit && *hit)
                    shares.add(**hit, onPlane(oracle, {click.x, 480.0 - click.y}, exact));
            }
        }
        QVERIFY2(shares.hits() > tests::rounds(800), qPrintable(QString::number(shares.hits())));
        qInfo("%d hits, the uncertainty is %.3g times the error in the median", int(shares.hits()), shares.median());
        QCOMPARE(shares.outside(), 0);
        QVERIFY2(shares.median() < 1000.0, qPrintable(QString::number(shares.median())));
    }

    /// Triangles in a box that is far deeper than wide are seen nearly edge on.
    void uncertaintyHoldsInDeepBoxes()
    {
        Aim aim(8);
        const auto within = [&](double size) { return size * (2.0 * aim.share() - 1.0); };
        Shares shares;
        for (int i = 0; i < tests::rounds(200); ++i) {
            const double depth = std::pow(10.0, 9.0 + i % 4);
            const Ortho box{-1.3, 1.4, -1.0, 1.1, -depth, depth};
            const LookAt camera{WorldPoint{within(1.0), within(1.0), within(1.0)}, // in this order
                                WorldPoint{within(5.0), within(5.0), within(5.0)},
                                {0.0, 1.0, 0.0}};
            const auto three = [](const auto &p) { return std::array{p.x, p.y, p.z}; };
            const oracle::Oracle oracle({three(camera.eye), three(camera.center), three(camera.up)},
                                        {oracle::RandomKind::Ortho, box.left, box.right, box.bottom, box.top,
                                         box.nearDistance, box.farDistance},
                                        {0.0, 0.0, 640.0, 480.0, 0.0, 1.0});
            std::array<glm::dvec3, 3> exact;
            Box bounds;
            constexpr std::array<glm::dvec2, 3> kWindow{{{32.0, 24.0}, {608.0, 48.0}, {320.0, 456.0}}};
            for (std::size_t k = 0; k < 3; ++k) {
                const oracle::Vector3 corner = oracle.worldUnder({kWindow[k].x, kWindow[k].y, 0.5 + within(0.25)});
                exact[k] = {double(corner[0]), double(corner[1]), double(corner[2])};
                bounds.add(exact[k]);
            }
            Mesh mesh;
            setPositions(mesh, originFor(bounds), exact);
            Setup setup = pictureWith(box);
            setup.pose = camera;
            const SceneRays rays = Clicked{{objectOf(modelOf(std::move(mesh)))}}.rays(setup);
            for (int k = 0; k < 10; ++k) {
                const DevicePoint click{std::floor(240.0 + 160.0 * aim.share()) + 0.5,
                                        std::floor(200.0 + 80.0 * aim.share()) + 0.5};
                if (const auto hit = rays.at(click); hit && *hit)
                    shares.add(**hit, onPlane(oracle, {click.x, 480.0 - click.y}, exact));
            }
        }
        QVERIFY2(shares.hits() > tests::rounds(500), qPrintable(QString::number(shares.hits())));
        qInfo("%d hits, the uncertainty is %.3g times the error in the median", int(shares.hits()), shares.median());
        QCOMPARE(shares.outside(), 0);
    }
};

UNPROJECTOR_TEST(TestSceneRays)
#include "test_scene_rays.moc"
