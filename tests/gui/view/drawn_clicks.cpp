#include "tests/gui/document_edits.h"

#include "tests/gui/view/drawn_clicks.h"

#include "core/ray/drawn_surface.h"
#include "core/ray/scene_rays.h"
#include "core/unproject/pick.h"
#include "gui/view/corner_shift.h"
#include "gui/view/frame.h"
#include "gui/view/painters/mesh_painter.h"
#include "tests/support/mesh_model.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace drawnclicks {

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

std::shared_ptr<Model> named(const char *name, std::shared_ptr<Model> model)
{
    model->name = name;
    return model;
}

class Random {
public:
    explicit Random(int seed) : m_engine(static_cast<std::uint64_t>(seed)) {}
    double between(double from, double to) { return from + (to - from) * m_share(m_engine); }
    int below(int count) { return static_cast<int>(m_engine() % static_cast<std::uint64_t>(count)); }
    glm::dvec3 direction()
    {
        return glm::normalize(glm::dvec3(m_normal(m_engine), m_normal(m_engine), m_normal(m_engine)));
    }

private:
    std::mt19937_64 m_engine;
    std::uniform_real_distribution<double> m_share;
    std::normal_distribution<double> m_normal;
};

SceneObject placed(const std::shared_ptr<const Model> &model, int number)
{
    SceneObject object{"clicked", {}, model, {}};
    if (number % 2 == 1)
        object.transform = {Rotate{37.0, {1, 2, 3}}, Scale{{1.0, 1.5, 0.7}}};
    return object;
}

Result<Setup> randomPicture(const SceneObject &object, int number, Random &random)
{
    constexpr double kRatios[] = {1.0, 1.25, 2.0};
    constexpr DepthRange kRanges[] = {{0.0, 1.0}, {1.0, 0.0}, {0.2, 0.9}, {0.0, 0.65}};
    constexpr ProjectionKind kKinds[] = {ProjectionKind::Perspective, ProjectionKind::Ortho, ProjectionKind::Frustum,
                                         ProjectionKind::Perspective, ProjectionKind::Oblique};
    const Box bounds = boundsOf(object);
    const double radius = bounds.diagonal() / 2.0;
    const bool isClose = number % 3 != 0;
    const double zoom = isClose ? std::pow(10.0, random.between(0.0, 1.3)) : 1.0;
    const double angle = radiansFromDegrees(random.between(20.0, 70.0));
    const double distance = std::max(1.1, 0.9 / std::sin(angle / 2.0) / std::sqrt(zoom)) * radius;
    const double halfWindow = std::tan(angle / 2.0) / zoom;
    Scene scene;
    scene.objects = {object};
    const glm::dvec3 target = bounds.center() + (isClose ? 0.4 * radius * random.direction() : glm::dvec3(0.0));
    scene.camera = {WorldPoint(bounds.center() + distance * random.direction()), WorldPoint(target), {0.1, 1.0, 0.05}};
    Projection projection = Perspective{2.0 * std::atan(halfWindow), 1.0, distance / 100.0, 3.0 * distance};
    projection = converted(projection, kKinds[number % 5], distance);
    if (auto *frustum = std::get_if<Frustum>(&projection)) {
        const double shift = 0.2 * (frustum->right - frustum->left);
        frustum->left += shift;
        frustum->right += shift;
    }
    scene.projection = projection;
    scene.projectionFollowsViewport = true;
    scene.clipDistancesFitObjects = number % 4 != 3;
    scene.depthRange = kRanges[number / 3 % 4];
    return setupOf(scene, surfaceFromWidget(640, 480, kRatios[number % 3]), Box());
}

} // namespace

struct Stage::Drawing {
    QOffscreenSurface surface;
    QOpenGLContext context;
    Frame frame;
    MeshPainter painter;
    std::shared_ptr<const ray::RayCaster> caster; ///< of the model last drawn
    bool isReady = false;

    /// @return whether it is drawn
    bool draw(const Setup &setup, const SceneObject &object)
    {
        const FrameContents contents{
            drawable(setup).value(), {object}, clipFromWorld(setup).value(), eyeFromWorld(setup).value(), {}};
        if (!frame.begin(contents.drawn))
            return false;
        frame.beginObjects();
        MeshPainter::Place place;
        painter.keepOnly({object.model.get()});
        painter.drawOn(contents, place, Deadline({}));
        frame.end();
        return true;
    }
};

Stage::Stage() : m_drawing(std::make_unique<Drawing>())
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    m_drawing->surface.setFormat(format);
    m_drawing->surface.create();
    m_drawing->context.setFormat(format);
    m_drawing->isReady = m_drawing->context.create() && m_drawing->context.makeCurrent(&m_drawing->surface);
    if (!m_drawing->isReady)
        return;
    m_drawing->frame.initialize();
    m_drawing->painter.initialize(m_drawing->frame.ids(), false);
}

Stage::~Stage()
{
    if (!m_drawing->isReady || !m_drawing->context.makeCurrent(&m_drawing->surface))
        return;
    m_drawing->painter.release();
    m_drawing->frame.release();
}

double Stage::cornerShift(double grid)
{
    return measuredCornerShift(*m_drawing->context.extraFunctions(), grid);
}

std::string Stage::rendererName()
{
    if (!m_drawing->isReady)
        return {};
    return reinterpret_cast<const char *>(m_drawing->context.functions()->glGetString(GL_RENDERER));
}

std::shared_ptr<Model> roughTerrain(std::uint32_t n)
{
    Random random(3);
    std::vector<glm::dvec3> places;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            const double x = 2.0 * i / n - 1.0, z = 2.0 * j / n - 1.0;
            const double hills = 0.25 * std::sin(3.0 * x + 1.0) * std::cos(4.0 * z);
            places.emplace_back(x, hills + random.between(-1.0, 1.0) / n, z);
        }
    }
    Mesh mesh;
    setPositions(mesh, glm::dvec3(0.0), places);
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
        }
    }
    return named("rough terrain", modelOf(std::move(mesh)));
}

std::shared_ptr<Model> slivers(std::uint32_t n)
{
    std::vector<glm::dvec3> places;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 8.0 * std::atan(1.0) * i / n, radius = 1.0 + 0.2 * std::sin(5.0 * angle);
        places.emplace_back(radius * std::cos(angle), -1.5, radius * std::sin(angle));
        places.emplace_back(0.6 * radius * std::cos(angle + 0.3), 1.5, 0.6 * radius * std::sin(angle + 0.3));
    }
    Mesh mesh;
    setPositions(mesh, glm::dvec3(0.0), places);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = 2 * i, b = a + 1, c = 2 * ((i + 1) % n), d = c + 1;
        mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
    return named("slivers", modelOf(std::move(mesh)));
}

std::shared_ptr<Model> movedFarAway(const Model &model)
{
    auto moved = std::make_shared<Model>(model);
    moved->name += ", far from the origin";
    for (Mesh &mesh : moved->meshes) {
        Box box;
        std::vector<glm::dvec3> places;
        for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
            places.push_back(mesh.position(vertex) + glm::dvec3(4.5e5, 5.4e6, 300.0));
            box.add(places.back());
        }
        setPositions(mesh, originFor(box), places);
    }
    moved->bounds = boundsOf(moved->meshes);
    return moved;
}

std::optional<Shares> Stage::clicked(const std::shared_ptr<const Model> &model, int number, int clicks)
{
    Random random(number);
    const SceneObject object = placed(model, number);
    const Result<Setup> asked = randomPicture(object, number, random);
    if (!m_drawing->isReady || !asked || !m_drawing->draw(*asked, object))
        return std::nullopt;
    const Setup &setup = *m_drawing->frame.setup();
    const Unprojector unprojector = Unprojector::of(setup).value();
    const EyeFrame axes = eyeFrame(setup.camera()).value();
    std::shared_ptr<const ray::RayCaster> &caster = m_drawing->caster;
    if (!caster || &caster->model() != model.get())
        caster = ray::RayCaster::build(std::const_pointer_cast<Model>(model), {});
    const ray::SceneRays rays(unprojector, std::span(&object, 1), std::span(&caster, 1), {});

    Shares shares;
    const int most = 8 * clicks; // where little of the model is seen
    for (int i = 0; i < most && static_cast<int>(shares.byTriangle.count()) < clicks; ++i) {
        const DevicePixel pixel{random.below(setup.surface.widthPixels), random.below(setup.surface.heightPixels)};
        const DevicePoint centre = pixelCenter(pixel);
        const std::optional<DepthSample> sample = m_drawing->frame.sample(pixel);
        if (!sample)
            return std::nullopt;
        if (!sample->hit())
            continue;
        const std::optional<ray::SceneHit> hit = rays.at(centre).value();
        if (!hit) {
            shares.byTriangle.addMiss();
            shares.byNeighbours.addMiss();
            continue;
        }
        // The point is computed on the ray itself: combined from a thin triangle's corners, its
        // last digits would leave the ray sideways.
        const WorldPoint onMesh = rays.rays().at(centre).value().at(hit->t);
        const Pick asRead = pickAt(unprojector, {{}, pixel, *sample}).value();
        const auto shareOf = [&](const DrawnSurface &surface) {
            const Pick pick = refined(asRead, surface);
            // The error of the ray's own arithmetic in double.
            const auto rounding = [](const Components<3> &a, const Components<3> &b) {
                return 16.0 * 0x1p-53 * (glm::abs(a.coordinates()) + glm::abs(b.coordinates()));
            };
            const WorldPoint &world = *pick.point.world[Method::Formula];
            const EyePoint &eye = *pick.point.eye[Method::Formula], eyeOnMesh = eyeFromWorld(axes, onMesh);
            const glm::dvec3 inWorld = rounding(world, axes.eye);
            const double inEye = glm::length(inWorld);
            return std::max(
                InsideShare::shareOf((onMesh - world).coordinates(), pick.uncertainty.world.coordinates() + inWorld),
                InsideShare::shareOf((eyeOnMesh - eye).coordinates(), pick.uncertainty.eye.coordinates() + inEye));
        };
        shares.byNeighbours.add(shareOf(ray::drawnSurface(object, *asRead.point.world[Method::Formula])));
        shares.byTriangle.add(shareOf(ray::drawnSurface(object, *hit)));
    }
    return shares;
}

} // namespace drawnclicks
