// The shading of surfaces as the painter draws it: its colours, and the depths and objects of all
// pixels, which it must not touch.

#include "tests/support/test.h"

#include "core/examples/solids.h"
#include "gui/view/frame.h"
#include "gui/view/frame_view.h"
#include "gui/view/painters/mesh_painter.h"
#include "tests/support/cube_sphere.h"
#include "tests/support/mesh_model.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::mesh;
using namespace unprojector::scene;

using Objects = std::vector<SceneObject>;
Q_DECLARE_METATYPE(Objects)

namespace {

constexpr int kWidth = 160, kHeight = 120;
constexpr double kTurn = 6.283185307179586;

/// OpenGL without a window.
struct Context {
    Context()
    {
        context.setFormat(FrameView::preCreateWindow());
        surface.setFormat(FrameView::preCreateWindow());
        surface.create();
        isCurrent = context.create() && context.makeCurrent(&surface);
    }
    QOffscreenSurface surface;
    QOpenGLContext context;
    bool isCurrent = false;
};

/// Every byte of a frame, the lowest row first.
struct Read {
    std::vector<std::uint32_t> colors, objects;
    std::vector<float> depths;
    QStringList failures = {};

    QColor at(int column, int row) const
    {
        const std::uint32_t rgba = colors[static_cast<std::size_t>(row) * kWidth + static_cast<std::size_t>(column)];
        return {static_cast<int>(rgba & 255U), static_cast<int>(rgba >> 8 & 255U), static_cast<int>(rgba >> 16 & 255U)};
    }
    double brightness(int column, int row) const { return static_cast<double>(at(column, row).lightnessF()); }
};

struct Drawing {
    Setup setup;
    Objects objects;
    std::vector<glm::dvec4> clipPlanes = {};
    bool isSoftware = false;
    std::optional<int> milliseconds = {};
    bool areStandIns = false;
};

Read drawn(const Drawing &drawing, const Shading &shading)
{
    Frame frame;
    frame.initialize();
    MeshPainter painter;
    painter.initialize(frame.ids(), drawing.isSoftware);
    painter.setShading(shading);
    FrameContents contents{drawable(drawing.setup).value(), drawing.objects, clipFromWorld(drawing.setup).value(),
                           eyeFromWorld(drawing.setup).value(), drawing.clipPlanes};
    contents.areStandIns = drawing.areStandIns;
    constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;
    Read read{std::vector<std::uint32_t>(kPixels), std::vector<std::uint32_t>(kPixels), std::vector<float>(kPixels)};
    if (!frame.begin(contents.drawn))
        return {};
    frame.beginObjects();
    MeshPainter::Place place;
    while (!painter.drawOn(contents, place, Deadline(drawing.milliseconds))) {
    }
    QOpenGLExtraFunctions &gl = *QOpenGLContext::currentContext()->extraFunctions();
    gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, read.colors.data());
    gl.glReadBuffer(GL_COLOR_ATTACHMENT1);
    if (frame.ids() == ObjectIds::Integers)
        gl.glReadPixels(0, 0, kWidth, kHeight, GL_RED_INTEGER, GL_UNSIGNED_INT, read.objects.data());
    else
        gl.glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, read.objects.data());
    gl.glReadPixels(0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, read.depths.data());
    read.failures = painter.takeFailures();
    frame.end();
    painter.release();
    frame.release();
    return read;
}

Setup seenFrom(const WorldPoint &eye, const WorldPoint &center = {0.0, 0.0, 0.0})
{
    Setup setup;
    setup.surface = {kWidth, kHeight, 1.0};
    setup.viewport = wholeSurface(setup.surface);
    setup.projection() = Perspective{0.8, double(kWidth) / kHeight, 0.1, 100.0};
    setup.camera() = LookAt{eye, center, {0.0, 1.0, 0.0}};
    return setup;
}

CurvatureMap curvaturesOf(const Objects &objects)
{
    CurvatureMap curvatures;
    for (const SceneObject &object : objects)
        curvatures[object.model] = std::make_shared<const Curvature>(curvatureOf(*object.model));
    return curvatures;
}

const glm::vec3 kFromTheLeft = glm::normalize(glm::vec3(-1.0f, 0.1f, 0.4f));

/// The shading with each part alone, and with all of them.
std::vector<Shading> shadings(const Objects &objects)
{
    std::vector<Shading> all(5);
    all[0].sideLight = all[4].sideLight = kFromTheLeft;
    all[1].hasColors = all[4].hasColors = false;
    all[2].hasEdges = all[4].hasEdges = true;
    all[3].curvatures = all[4].curvatures = curvaturesOf(objects);
    return all;
}

/// A square of 4 × 4 about the origin across the z axis, in n × n quads, its height a function of x.
Mesh square(
    std::uint32_t n, double (*height)(double) = [](double) { return 0.0; })
{
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            const double x = 4.0 * i / n - 2.0, y = 4.0 * j / n - 2.0;
            mesh.positions.emplace_back(glm::dvec3(x, y, height(x)));
        }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    }
    return mesh;
}

/// A coarse ball that has everything a mesh can have.
std::shared_ptr<Model> richBall()
{
    Mesh ball = examples::sphereMesh(1.0, 2);
    for (const glm::vec3 &position : ball.positions) {
        ball.normals.push_back(position);
        ball.colors.emplace_back(position.x > 0.0f ? 255 : 40, 90, 200, 255);
        ball.texcoords.emplace_back(position.x, position.y);
    }
    ball.normals.resize(ball.positions.size());
    ball.texture = 0;
    auto model = modelOf(ball);
    Texture texture;
    texture.image = std::make_shared<const Image>(Image{1, 1, {204, 102, 255, 255}});
    model->textures.push_back(texture);
    return model;
}

} // namespace

class TestMeshShading : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_gl.isCurrent); }

    void depthsAndObjectsStay_data()
    {
        addColumn<Objects>("objects");
        addColumn<bool>("isClipped");
        addColumn<bool>("isSoftware");
        addColumn<int>("milliseconds"); // -1: no deadline
        const auto smooth = modelOf(examples::sphereMesh(1.0, 3));
        const auto flat = modelOf(soupOf(examples::sphereMesh(1.0, 3)));
        const Objects two{{"one", {}, smooth, {}},
                          {"mirrored", {}, smooth, {Scale{{-0.5, 0.7, 0.9}}, Translate{{0.8, 0.1, 0.2}}}}};
        newRow("smooth") << two << false << false << -1;
        newRow("clipped") << two << true << false << -1;
        newRow("flat") << Objects{{"flat", {}, flat, {}}} << false << false << -1;
        newRow("coloured and textured") << Objects{{"rich", {}, richBall(), {}}} << false << false << -1;
        const Objects fine{{"fine", {}, cubeSphere(90), {}}};
        newRow("fine") << fine << false << false << -1;
        newRow("fine, without a graphics card") << fine << false << true << -1;
        newRow("fine, bit by bit") << fine << true << true << 2;
        Mesh cloud;
        cloud.kind = Mesh::Kind::Points;
        cloud.positions = examples::sphereMesh(1.0, 4).positions;
        newRow("with points") << Objects{{"points", {}, modelOf(cloud), {}}, two[1]} << false << false << -1;
    }

    void depthsAndObjectsStay()
    {
        QFETCH(Objects, objects);
        QFETCH(bool, isClipped);
        QFETCH(bool, isSoftware);
        QFETCH(int, milliseconds);
        Drawing drawing{seenFrom({1.0, 2.0, 3.0}), objects};
        if (isClipped)
            drawing.clipPlanes.emplace_back(1.0, 0.2, -0.3, 0.1);
        drawing.isSoftware = isSoftware;
        if (milliseconds >= 0)
            drawing.milliseconds = milliseconds;
        const Read plain = drawn(drawing, {});
        QVERIFY(std::count_if(plain.objects.begin(), plain.objects.end(), [](std::uint32_t id) { return id > 0; })
                > 500);
        for (const Shading &shading : shadings(objects)) {
            const Read shaded = drawn(drawing, shading);
            QVERIFY(shaded.objects == plain.objects);
            QVERIFY(shaded.depths == plain.depths);
            QVERIFY2(shaded.failures.isEmpty(), qPrintable(shaded.failures.join(u' ')));
        }
        QVERIFY(drawn(drawing, shadings(objects).back()).colors != plain.colors);
    }

    void theLightComesFromItsSide()
    {
        const Drawing drawing{seenFrom({0.0, 0.0, 4.0}), {{"ball", {}, modelOf(examples::sphereMesh(1.0, 4)), {}}}};
        Shading shading;
        const auto leftAndRight = [&] {
            const Read read = drawn(drawing, shading);
            return std::pair(read.brightness(kWidth / 2 - 25, kHeight / 2),
                             read.brightness(kWidth / 2 + 25, kHeight / 2));
        };
        const auto [plainLeft, plainRight] = leftAndRight();
        QVERIFY(std::abs(plainLeft - plainRight) < 0.25);
        shading.sideLight = kFromTheLeft;
        const auto [left, right] = leftAndRight();
        QVERIFY2(left > right + 0.4, qPrintable(QStringLiteral("%1, %2").arg(left).arg(right)));
        QVERIFY(right > 0.05); // not black
        shading.sideLight = glm::vec3(-1.0f, 1.0f, 1.0f) * kFromTheLeft;
        const auto [leftNow, rightNow] = leftAndRight();
        QVERIFY(rightNow > leftNow + 0.4);
    }

    void ridgesAreLightAndValleysDark_data()
    {
        addColumn<std::vector<TransformStep>>("transform");
        addColumn<bool>("isFromBehind");
        const std::vector<TransformStep> none, mirror{Scale{{-1.0, 1.0, 1.0}}};
        newRow("from in front") << none << false;
        newRow("from behind") << none << true;
        newRow("mirrored") << mirror << false;
        newRow("mirrored, from behind") << mirror << true;
    }

    void ridgesAreLightAndValleysDark()
    {
        QFETCH(std::vector<TransformStep>, transform);
        QFETCH(bool, isFromBehind);
        // A wave with its crest at x = 0 and valleys at x = ±1; all three face the viewer.
        const auto wave = modelOf(square(120, [](double x) { return 0.05 * std::cos(kTurn / 2.0 * x); }));
        for (const bool isFlat : {true, false}) {
            auto model = std::make_shared<Model>(*wave);
            if (!isFlat)
                model->meshes[0].normals.assign(model->meshes[0].positions.size(), {0.0f, 0.0f, 1.0f});
            const Drawing drawing{seenFrom({0.0, 0.0, isFromBehind ? -4.0 : 4.0}), {{"wave", {}, model, transform}}};
            Shading shading;
            const auto at = [](const Read &read, double x) {
                return read.brightness(
                    kWidth / 2 + static_cast<int>(std::lround(x * kHeight / 2.0 / 4.0 / std::tan(0.4))), kHeight / 2);
            };
            const Read plain = drawn(drawing, shading);
            QVERIFY(std::abs(at(plain, 0.0) - at(plain, 1.0)) < 0.05);
            shading.curvatures = curvaturesOf(drawing.objects);
            const Read curved = drawn(drawing, shading);
            const double sign = isFromBehind ? -1.0 : 1.0;
            for (const double valley : {-1.0, 1.0})
                QVERIFY2(sign * (at(curved, 0.0) - at(curved, valley)) > 0.4,
                         qPrintable(QStringLiteral("%1, %2").arg(at(curved, 0.0)).arg(at(curved, valley))));
        }
    }

    void aModelWithoutCurvatureIsDrawnAsUsual()
    {
        const auto ball = modelOf(examples::sphereMesh(1.0, 3));
        const auto other = modelOf(examples::sphereMesh(1.0, 3));
        const Drawing drawing{seenFrom({0.0, 0.0, 4.0}), {{"ball", {}, ball, {}}}};
        Shading shading;
        shading.curvatures = curvaturesOf({{"other", {}, other, {}}});
        QVERIFY(drawn(drawing, shading).colors == drawn(drawing, {}).colors);
        shading.curvatures = curvaturesOf({{"ball", {}, ball, {}}});
        QVERIFY(drawn(drawing, shading).colors != drawn(drawing, {}).colors);
    }

    void withoutColoursEverythingIsGrey()
    {
        Mesh painted = square(1);
        painted.baseColor = {0.9f, 0.2f, 0.1f, 1.0f};
        const Objects objects{{"rich", {}, richBall(), {}}, {"painted", {}, modelOf(painted), {Translate{{0, 0, -2}}}}};
        const Drawing drawing{seenFrom({0.5, 0.5, 6.0}), objects};
        Shading shading;
        const auto colorful = [&] {
            const Read read = drawn(drawing, shading);
            int count = 0;
            for (int row = 0; row < kHeight; ++row) {
                for (int column = 0; column < kWidth; ++column) {
                    const QColor color = read.at(column, row);
                    const std::size_t pixel = static_cast<std::size_t>(row) * kWidth + static_cast<std::size_t>(column);
                    if (read.objects[pixel] == 0)
                        continue; // the background
                    count += color.red() != color.green() || color.green() != color.blue();
                }
            }
            return count;
        };
        QVERIFY(colorful() > 1000);
        shading.hasColors = false;
        QCOMPARE(colorful(), 0);
        // The same as a model that never had any.
        Mesh plain = richBall()->meshes[0];
        plain.colors.clear();
        plain.texcoords.clear();
        plain.texture = -1;
        const Objects plainObjects{{"plain", {}, modelOf(plain), {}},
                                   {"painted", {}, modelOf(square(1)), {Translate{{0, 0, -2}}}}};
        QVERIFY(drawn(drawing, shading).colors == drawn({drawing.setup, plainObjects}, {}).colors);
    }

    void edgesAreLinesOnTheSurface_data()
    {
        addColumn<std::shared_ptr<Model>>("model");
        addColumn<glm::dvec3>("place");
        newRow("with vertex numbers") << modelOf(square(1)) << glm::dvec3(0.0);
        newRow("soup") << modelOf(soupOf(square(1))) << glm::dvec3(0.0);
        Mesh distant = square(1);
        const glm::dvec3 place(4e6, 5e5, 300.0);
        distant.origin = place;
        newRow("elsewhere") << modelOf(distant) << place;
    }

    void edgesAreLinesOnTheSurface()
    {
        QFETCH(std::shared_ptr<Model>, model);
        QFETCH(glm::dvec3, place);
        const Drawing drawing{seenFrom(WorldPoint(place + glm::dvec3(0.0, 0.0, 6.0)), WorldPoint(place)),
                              {{"square", {}, model, {}}}};
        Shading shading;
        shading.hasEdges = true;
        const Read plain = drawn(drawing, {}), lined = drawn(drawing, shading);
        // One pixel is 12 tan(0.4) / 120 wide. The diagonal goes through the middle, up to the right.
        const double pixels = kHeight / (12.0 * std::tan(0.4));
        const auto darker = [&](double x, double y) {
            const int column = static_cast<int>(std::floor(kWidth / 2.0 + x * pixels)),
                      row = static_cast<int>(std::floor(kHeight / 2.0 + y * pixels));
            return plain.brightness(column, row) - lined.brightness(column, row);
        };
        for (const double t : {-1.5, -0.5, 0.3, 1.2})
            QVERIFY2(darker(t, t) > 0.15, qPrintable(QString::number(darker(t, t))));
        for (const auto &[x, y] : {std::pair(-1.0, 1.0), {1.0, -1.0}, {0.4, -0.4}, {1.7, -0.2}})
            QVERIFY2(darker(x, y) == 0.0, qPrintable(QString::number(darker(x, y))));
        // The line is thin: few pixels of the surface change.
        int changed = 0, surface = 0;
        for (std::size_t i = 0; i < plain.colors.size(); ++i) {
            changed += plain.colors[i] != lined.colors[i];
            surface += plain.objects[i] > 0;
        }
        QVERIFY2(changed > 100 && changed < surface / 8, qPrintable(QString::number(changed)));
    }

    void edgesOfSmallTrianglesFade()
    {
        // Quads of 1 pixel: lines would cover everything.
        const Drawing drawing{seenFrom({0.0, 0.0, 6.0}), {{"square", {}, modelOf(square(95)), {}}}};
        Shading shading;
        shading.hasEdges = true;
        QVERIFY(drawn(drawing, shading).colors == drawn(drawing, {}).colors);
        const Drawing closer{seenFrom({0.0, 0.0, 0.4}), drawing.objects};
        QVERIFY(drawn(closer, shading).colors != drawn(closer, {}).colors);
    }

    void standInsHaveNoEdges()
    {
        Drawing drawing{seenFrom({0.0, 0.0, 6.0}), {{"square", {}, modelOf(square(2)), {}}}};
        Shading shading;
        shading.hasEdges = true;
        QVERIFY(drawn(drawing, shading).colors != drawn(drawing, {}).colors);
        drawing.areStandIns = true;
        QVERIFY(drawn(drawing, shading).colors == drawn(drawing, {}).colors);
    }

    void leavingOutTrianglesKeepsTheEdges()
    {
        // Close to a fine ball, its triangles are large in the view; most lie beside it.
        const auto ball = cubeSphere(90);
        for (const bool isSoup : {false, true}) {
            Drawing drawing{seenFrom({0.0, 0.0, 1.1}),
                            {{"ball", {}, isSoup ? modelOf(soupOf(ball->meshes[0])) : ball, {}}}};
            Shading shading;
            shading.hasEdges = true;
            const Read all = drawn(drawing, shading);
            QVERIFY(all.colors != drawn(drawing, {}).colors);
            drawing.isSoftware = true;
            QVERIFY(drawn(drawing, shading).colors == all.colors);
            drawing.milliseconds = 2;
            QVERIFY(drawn(drawing, shading).colors == all.colors);
            drawing.isSoftware = false;
            QVERIFY(drawn(drawing, shading).colors == all.colors);
        }
    }

    void edgesThroughTheEyeAreNoTrouble()
    {
        // A floor that begins behind the eye: two of its corners have no place in the view.
        Mesh floor;
        floor.positions = {{-50, -1, 50}, {50, -1, 50}, {0, -1, -50}};
        const Drawing drawing{seenFrom({0.0, 0.0, 0.0}, {0.0, -0.3, -1.0}), {{"floor", {}, modelOf(floor), {}}}};
        Shading shading;
        shading.hasEdges = true;
        const Read plain = drawn(drawing, {}), lined = drawn(drawing, shading);
        int changed = 0, surface = 0;
        for (std::size_t i = 0; i < plain.colors.size(); ++i) {
            changed += plain.colors[i] != lined.colors[i];
            surface += plain.objects[i] > 0;
        }
        QVERIFY(surface > 3000);
        QVERIFY2(changed > 20 && changed < surface / 10, qPrintable(QString::number(changed)));
    }

private:
    Context m_gl;
};

UNPROJECTOR_TEST(TestMeshShading, display, colour_ids)
#include "test_mesh_shading.moc"
