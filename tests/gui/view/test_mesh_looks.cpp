// The colour of a surface that faces the viewer, for every kind of mesh that has shaders of its
// own.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::mesh;

namespace {

/// Light of a surface whose normal points at the viewer, by the lamps' directions alone.
double lit(double color)
{
    const double diffuse = 0.38 + 0.58 * 0.80 + 0.18 * 0.79;
    const double half = 1.80 / std::sqrt(0.36 * 0.36 + 0.48 * 0.48 + 1.80 * 1.80);
    return std::min(1.0, color * diffuse + 0.12 * std::pow(half, 40.0));
}

/// A square of 4 × 4 about the origin, across the z-axis.
Mesh square()
{
    Mesh mesh;
    mesh.positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.baseColor = {0.8f, 0.6f, 0.4f, 1.0f};
    return mesh;
}

Mesh cloud()
{
    Mesh mesh = square();
    mesh.kind = Mesh::Kind::Points;
    mesh.indices.clear();
    mesh.positions.clear();
    for (int i = 0; i < 400 * 400; ++i)
        mesh.positions.emplace_back(static_cast<float>(i % 400) * 0.01f - 2.0f,
                                    static_cast<float>(i / 400) * 0.01f - 2.0f, 0.0f);
    return mesh;
}

} // namespace

class TestMeshLooks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void aMeshHasItsColor_data()
    {
        addColumn<bool>("isCloud");
        addColumn<double>("normal"); // along z; 0: none, the triangles are flat
        addColumn<bool>("isColored");
        addColumn<bool>("isTextured");
        addColumn<bool>("isClipped");
        newRow("flat") << false << 0.0 << false << false << false;
        newRow("with normals") << false << 1.0 << false << false << false;
        newRow("seen from its back") << false << -1.0 << false << false << false;
        newRow("coloured") << false << 1.0 << true << false << false;
        newRow("textured") << false << 1.0 << false << true << false;
        newRow("coloured and textured, flat") << false << 0.0 << true << true << false;
        newRow("cut elsewhere") << false << 1.0 << false << false << true;
        newRow("cut elsewhere, all of it") << false << 1.0 << true << true << true;
        newRow("points") << true << 0.0 << false << false << false;
        newRow("coloured points, cut elsewhere") << true << 0.0 << true << false << true;
    }

    void aMeshHasItsColor()
    {
        QFETCH(bool, isCloud);
        QFETCH(double, normal);
        QFETCH(bool, isColored);
        QFETCH(bool, isTextured);
        QFETCH(bool, isClipped);
        auto model = std::make_shared<Model>();
        Mesh mesh = isCloud ? cloud() : square();
        if (normal < 0.0) { // its corners run the other way round as well
            std::swap(mesh.indices[1], mesh.indices[2]);
            std::swap(mesh.indices[4], mesh.indices[5]);
        }
        if (normal != 0.0)
            mesh.normals.assign(mesh.positions.size(), {0.0f, 0.0f, static_cast<float>(normal)});
        if (isColored)
            mesh.colors.assign(mesh.positions.size(), {51, 255, 102, 255});
        if (isTextured) {
            mesh.texcoords.assign(mesh.positions.size(), {0.5f, 0.5f});
            mesh.texture = 0;
            Texture texture;
            texture.image = std::make_shared<const Image>(Image{1, 1, {204, 102, 255, 255}});
            model->textures.push_back(texture);
        }
        // One of each other kind is next to it: none may take another's program.
        Mesh flat = square(), plain = square();
        for (glm::vec3 &position : flat.positions)
            position.z = -3.0f;
        plain.positions = flat.positions;
        plain.normals.assign(plain.positions.size(), {0.0f, 0.0f, 1.0f});
        model->meshes = {flat, mesh, plain};
        model->bounds = boundsOf(model->meshes);

        SceneDocument document;
        openObjects(document, {{"square", {}, model, {}}}, {WorldPoint(0, 0, 6), WorldPoint(0, 0, 0), {0.0, 1.0, 0.0}});
        if (isClipped)
            setClipPlanes(document, {{1.0, 0.0, 0.0, 1.5}});
        SceneView view(document);
        view.setSmoothEdges(false);
        view.resize(240, 200);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view, kPatienceMilliseconds));
        const QImage picture = view.grabFramebuffer();
        // The pixel is beside the middle, where the axes are drawn.
        const QColor shown = picture.pixelColor(picture.width() * 11 / 20, picture.height() * 9 / 20);
        const std::array<double, 3> base{0.8, 0.6, 0.4};
        const std::array<int, 3> vertexColor{51, 255, 102}, texel{204, 102, 255},
            is{shown.red(), shown.green(), shown.blue()};
        for (std::size_t k = 0; k < 3; ++k) {
            const double color =
                base[k] * (isColored ? vertexColor[k] / 255.0 : 1.0) * (isTextured ? texel[k] / 255.0 : 1.0);
            const int expected = static_cast<int>(std::lround(255.0 * lit(color)));
            constexpr int kRounding = 1;
            QVERIFY2(std::abs(is[k] - expected) <= kRounding,
                     qPrintable(QStringLiteral("channel %1: %2 for %3").arg(k).arg(is[k]).arg(expected)));
        }
    }

    void backSidesAreLeftOutWhereNobodySeesThem_data()
    {
        addColumn<bool>("isClosed");
        addColumn<bool>("isSeenFromItsBack");
        addColumn<std::vector<TransformStep>>("transform");
        addColumn<bool>("isInside");
        addColumn<bool>("isClipped");
        addColumn<bool>("isDrawn");
        const std::vector<TransformStep> none, mirror{Scale{{-1.0, 1.0, 1.0}}};
        newRow("an open surface from its back") << false << true << none << false << false << true;
        newRow("a closed one's front") << true << false << none << false << false << true;
        newRow("a closed one's back") << true << true << none << false << false << false;
        newRow("a closed one's front in a mirror") << true << false << mirror << false << false << true;
        newRow("a closed one's back in a mirror") << true << true << mirror << false << false << false;
        newRow("a closed one's back from inside") << true << true << none << true << false << true;
        newRow("a closed one's back, cut open") << true << true << none << false << true << true;
    }

    void backSidesAreLeftOutWhereNobodySeesThem()
    {
        QFETCH(bool, isClosed);
        QFETCH(bool, isSeenFromItsBack);
        QFETCH(std::vector<TransformStep>, transform);
        QFETCH(bool, isInside);
        QFETCH(bool, isClipped);
        QFETCH(bool, isDrawn);
        auto model = std::make_shared<Model>();
        Mesh mesh = square();
        mesh.isClosed = isClosed; // the square is open, so that a missing part is visible
        if (isSeenFromItsBack)
            mesh.indices = {0, 2, 1, 0, 3, 2};
        model->meshes.push_back(mesh);
        model->bounds = boundsOf(model->meshes);
        if (isInside)
            model->bounds.highest.z = 20.0; // as if there were more of it behind the eye
        for (const bool isOrtho : {false, true}) {
            if (isOrtho && isInside)
                continue; // its near plane goes behind the eye, before everything else
            SceneDocument document;
            openObjects(document, {{"square", {}, model, transform}},
                        {WorldPoint(0, 0, 6), WorldPoint(0, 0, 0), {0.0, 1.0, 0.0}});
            if (isOrtho)
                switchProjection(document);
            if (isClipped)
                setClipPlanes(document, {{1.0, 0.0, 0.0, 1.5}});
            SceneView view(document);
            view.setSmoothEdges(false);
            view.resize(240, 200);
            view.show();
            QVERIFY(QTest::qWaitForWindowExposed(&view, kPatienceMilliseconds));
            const QImage picture = view.grabFramebuffer();
            const QColor shown = picture.pixelColor(picture.width() * 11 / 20, picture.height() * 9 / 20);
            QVERIFY2((shown.red() > shown.blue() + 60) == isDrawn, qPrintable(shown.name()));
        }
    }
};

UNPROJECTOR_TEST(TestMeshLooks, display, colour_ids)
#include "test_mesh_looks.moc"
