// Fine meshes, drawn with all their triangles and with only the triangles that can cover a pixel's
// centre: the same picture, bit for bit. Most triangles must be left out, or the optimization would
// be pointless.

#include "tests/support/test.h"

#include "core/mesh/covering_triangles.h"
#include "gui/view/frame.h"
#include "gui/view/frame_view.h"
#include "gui/view/painters/mesh_painter.h"
#include "tests/support/cube_sphere.h"
#include "tests/support/mesh_model.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include <glm/geometric.hpp>

#include <cstring>
#include <optional>
#include <random>
#include <vector>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::mesh;

Q_DECLARE_METATYPE(std::shared_ptr<unprojector::mesh::Model>)

namespace {

constexpr int kWidth = 160, kHeight = 120;

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

/// Every byte of a frame.
struct Read {
    std::vector<std::uint32_t> colors, objects;
    std::vector<float> depths;
    friend bool operator==(const Read &, const Read &) = default;
};

Read readBoundFrame()
{
    QOpenGLExtraFunctions &gl = *QOpenGLContext::currentContext()->extraFunctions();
    constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;
    Read read{std::vector<std::uint32_t>(kPixels), std::vector<std::uint32_t>(kPixels), std::vector<float>(kPixels)};
    gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, read.colors.data());
    gl.glReadBuffer(GL_COLOR_ATTACHMENT1);
    gl.glReadPixels(0, 0, kWidth, kHeight, GL_RED_INTEGER, GL_UNSIGNED_INT, read.objects.data());
    gl.glReadPixels(0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, read.depths.data());
    return read;
}

/// The frame of an object drawn in a picture.
std::optional<Read> drawn(const Setup &setup, const std::vector<SceneObject> &objects,
                          const std::vector<glm::dvec4> &planes, bool isSoftware, std::optional<int> milliseconds)
{
    Frame frame;
    frame.initialize();
    MeshPainter painter;
    painter.initialize(frame.ids(), isSoftware);
    const FrameContents contents{drawable(setup).value(), objects, clipFromWorld(setup).value(),
                                 eyeFromWorld(setup).value(), planes};
    if (frame.ids() != ObjectIds::Integers || !frame.begin(contents.drawn))
        return std::nullopt;
    frame.beginObjects();
    MeshPainter::Place place;
    while (!painter.drawOn(contents, place, Deadline(milliseconds))) {
    }
    const Read read = readBoundFrame();
    frame.end();
    painter.release();
    frame.release();
    return read;
}

Setup setupOf(const WorldPoint &eye, const WorldPoint &center, const Projection &projection)
{
    Setup setup;
    setup.surface = {kWidth, kHeight, 1.0};
    setup.viewport = wholeSurface(setup.surface);
    setup.projection() = projection;
    setup.camera() = LookAt{eye, center, {0.0, 1.0, 0.0}};
    return setup;
}

/// Triangles of all shapes and sizes around a point, from slivers to triangles that fill the
/// picture.
std::shared_ptr<Model> litter(const glm::dvec3 &place)
{
    Mesh mesh;
    mesh.origin = place;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> share(-1.0f, 1.0f), size(-5.0f, 0.0f);
    const auto any = [&] { return glm::vec3(share(random), share(random), share(random)); };
    for (int i = 0; i < 60'000; ++i) {
        const glm::vec3 middle = any();
        for (int k = 0; k < 3; ++k)
            mesh.positions.push_back(middle + 0.2f * std::pow(10.0f, size(random)) * any());
    }
    return modelOf(std::move(mesh));
}

} // namespace

class TestCoveringTriangles : public QObject {
    Q_OBJECT

private slots:
    void thePictureIsTheSame_data()
    {
        addColumn<std::shared_ptr<Model>>("model");
        addColumn<Setup>("picture");
        addColumn<bool>("isClipped");
        const Projection perspective = Perspective{0.8, double(kWidth) / kHeight, 0.1, 100.0};
        const Projection box = Ortho{-1.6, 1.6, -1.2, 1.2, 0.1, 10.0};
        const WorldPoint middle(0.0, 0.0, 0.0);
        const auto sphere = cubeSphere(90);
        const auto soup = modelOf(soupOf(sphere->meshes[0]));
        const auto row = [](const char *name, const std::shared_ptr<Model> &model, const Setup &setup,
                            bool isClipped = false) { newRow(name) << model << setup << isClipped; };
        row("sphere", sphere, setupOf({1.0, 2.0, 3.0}, middle, perspective));
        row("soup", soup, setupOf({1.0, 2.0, 3.0}, middle, perspective));
        row("clipped", sphere, setupOf({1.0, 2.0, 3.0}, middle, perspective), true);
        row("box", sphere, setupOf({1.0, 2.0, 3.0}, middle, box));
        row("oblique", sphere,
            setupOf({1.0, 2.0, 3.0}, middle, Oblique{Ortho{-4.0, 4.0, -3.0, 3.0, 0.1, 10.0}, 1.1, 0.8}));
        row("from within", sphere, setupOf({0.1, 0.2, 0.3}, {1.0, 0.0, 0.0}, perspective));
        row("through the eye", sphere, setupOf({0.0, 0.0, 1.0}, middle, Perspective{1.9, 4.0 / 3.0, 1e-4, 100.0}));
        row("small", sphere, setupOf({12.0, 8.0, 16.0}, middle, perspective));
        row("beside the picture", sphere, setupOf({1.0, 2.0, 3.0}, {1.2, 0.3, 0.0}, perspective));
        row("litter", litter({}), setupOf({1.0, 0.5, 2.0}, middle, perspective));
        row("litter from within", litter({}), setupOf({0.1, 0.2, 0.3}, middle, perspective));
        const glm::dvec3 place(4e6, 5e5, 300.0);
        row("far from the origin", litter(place),
            setupOf(WorldPoint(place + glm::dvec3(1.0, 0.5, 2.0)), WorldPoint(place), perspective));
        Setup inset = setupOf({1.0, 2.0, 3.0}, middle, perspective);
        inset.viewport = {20.0, 30.0, 120.0, 70.0};
        row("a part of the surface", sphere, inset);
        inset.viewport = {-30.0, -20.0, 200.0, 150.0};
        row("more than the surface", sphere, inset);
    }

    void thePictureIsTheSame()
    {
        QFETCH(std::shared_ptr<Model>, model);
        QFETCH(Setup, picture);
        QFETCH(bool, isClipped);
        Context gl;
        QVERIFY(gl.isCurrent);
        std::vector<glm::dvec4> planes;
        if (isClipped)
            planes.emplace_back(1.0, 0.2, -0.3, 0.1);
        const std::vector<SceneObject> objects{
            {"one", {}, model, {}}, {"mirrored", {}, model, {Scale{{-0.5, 0.7, 0.9}}, Translate{{0.4, 0.1, 0.2}}}}};
        const std::optional<Read> all = drawn(picture, objects, planes, false, std::nullopt);
        QVERIFY(all);
        const auto surfaces =
            std::count_if(all->objects.begin(), all->objects.end(), [](std::uint32_t id) { return id > 0; });
        QVERIFY2(surfaces > 100, qPrintable(QString::number(surfaces)));
        QVERIFY(*all == *drawn(picture, objects, planes, true, std::nullopt));
        QVERIFY(*all == *drawn(picture, objects, planes, true, 2)); // bit by bit
    }

    void mostOfAFineMeshAreLeftOut()
    {
        const auto model = cubeSphere(300); // of a million triangles
        const Mesh &mesh = model->meshes.front();
        const Setup setup =
            setupOf({1.0, 2.0, 3.0}, {0.0, 0.0, 0.0}, Perspective{0.8, double(kWidth) / kHeight, 0.1, 100.0});
        std::vector<std::uint32_t> vertices;
        CoveringTriangles(mesh, glm::mat4(clipFromWorld(setup).value()), {0, 0, kWidth, kHeight}, glm::dvec3(1.1))
            .append(0, mesh.indices.size(), vertices);
        // Front and back, each pixel of it is covered twice.
        QVERIFY2(vertices.size() / 3 > 10'000 && vertices.size() / 3 < 100'000,
                 qPrintable(QString::number(vertices.size())));
    }
};

UNPROJECTOR_TEST(TestCoveringTriangles, display)
#include "test_covering_triangles.moc"
