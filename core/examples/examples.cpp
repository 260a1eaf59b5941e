#include "core/examples/examples.h"

#include "core/examples/solids.h"
#include "core/geometry/matrix_projection.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>

namespace unprojector::examples {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

using Color = glm::u8vec4;

constexpr Color kRed{225, 87, 89, 255};
constexpr Color kGreen{89, 161, 79, 255};
constexpr Color kBlue{78, 121, 167, 255};
constexpr Color kYellow{237, 201, 72, 255};
constexpr Color kTeal{118, 183, 178, 255};
constexpr Color kPurple{176, 122, 161, 255};
constexpr Color kGrey{150, 152, 158, 255};
// The tutorials' colours.
constexpr Color kPureRed{255, 0, 0, 255};
constexpr Color kPureGreen{0, 255, 0, 255};
constexpr Color kPureBlue{0, 0, 255, 255};
constexpr Color kWhite{255, 255, 255, 255};
constexpr Color kFanColor{204, 204, 153, 255};

// ---- shapes -------------------------------------------------------------------------------------

Mesh colored(Mesh mesh, const Color &color)
{
    mesh.baseColor = glm::vec4(color) / 255.0f;
    return mesh;
}

/// Triangles with a normal each; every corner keeps the colour of its vertex. Empty colours: white.
Mesh flatMesh(const std::vector<glm::vec3> &places, const std::vector<Color> &colors,
              const std::vector<std::array<std::size_t, 3>> &triangles)
{
    Mesh mesh;
    mesh.baseColor = glm::vec4(1.0f);
    for (const auto &[a, b, c] : triangles) {
        const glm::vec3 normal = glm::normalize(glm::cross(places[b] - places[a], places[c] - places[a]));
        for (const std::size_t corner : {a, b, c}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(places[corner]);
            mesh.normals.push_back(normal);
            if (!colors.empty())
                mesh.colors.push_back(colors[corner]);
        }
    }
    return mesh;
}

/// A rectangle in the plane z = 0, facing +z.
Mesh rectangle(const glm::vec2 &low, const glm::vec2 &high, const Color &color)
{
    return colored(
        flatMesh({{low.x, low.y, 0.0f}, {high.x, low.y, 0.0f}, {high.x, high.y, 0.0f}, {low.x, high.y, 0.0f}}, {},
                 {{0, 1, 2}, {0, 2, 3}}),
        color);
}

/// A square plate in the plane z = 0: a mark that a click can hit.
Mesh mark(const glm::vec2 &middle, float halfSide)
{
    return rectangle(middle - halfSide, middle + halfSide, kYellow);
}

/// The x axis in red and the y axis in green, from the origin, in the plane z = 0.
std::vector<Mesh> axes(float length, float width)
{
    const float half = width / 2.0f;
    return {rectangle({-half, -half}, {length, half}, kRed), rectangle({-half, half}, {half, length}, kGreen)};
}

/// A letter as strokes in a box of height 1 and its own width.
struct Letter {
    float width;
    std::vector<glm::vec2> strokes; ///< from point to point
};

Letter letterOf(char name)
{
    switch (name) {
    case 'M': return {0.9f, {{0.0f, 0.0f}, {0.0f, 1.0f}, {0.45f, 0.35f}, {0.9f, 1.0f}, {0.9f, 0.0f}}};
    case 'V': return {0.8f, {{0.0f, 1.0f}, {0.4f, 0.0f}, {0.8f, 1.0f}}};
    case 'W': return {1.1f, {{0.0f, 1.0f}, {0.25f, 0.0f}, {0.55f, 0.75f}, {0.85f, 0.0f}, {1.1f, 1.0f}}};
    default: // C
        return {0.75f,
                {{0.75f, 0.85f},
                 {0.5f, 1.0f},
                 {0.25f, 1.0f},
                 {0.0f, 0.7f},
                 {0.0f, 0.3f},
                 {0.25f, 0.0f},
                 {0.5f, 0.0f},
                 {0.75f, 0.15f}}};
    }
}

/// Letters in the plane z = 0, starting at their lower left corner.
/// @param heights  of a letter along x and y: negative where that axis points left or down in the
///         view, so that the letters stay readable
Mesh label(std::string_view letters, const glm::vec2 &corner, const glm::vec2 &heights)
{
    constexpr float kHalfStroke = 0.07f, kGap = 0.3f;
    std::vector<glm::vec3> places;
    std::vector<std::array<std::size_t, 3>> triangles;
    float before = 0.0f;
    for (const char name : letters) {
        const Letter letter = letterOf(name);
        for (std::size_t i = 1; i < letter.strokes.size(); ++i) {
            const glm::vec2 from = letter.strokes[i - 1], to = letter.strokes[i];
            const glm::vec2 along = kHalfStroke * glm::normalize(to - from), across(-along.y, along.x);
            const std::size_t first = places.size();
            for (const glm::vec2 &place : {from - along - across, from - along + across, to + along + across,
                                           to + along - across}) // and a little beyond, so that strokes join
                places.emplace_back(corner + heights * (place + glm::vec2(before, 0.0f)), 0.0f);
            triangles.push_back({first, first + 1, first + 2});
            triangles.push_back({first, first + 2, first + 3});
        }
        before += letter.width + kGap;
    }
    return colored(flatMesh(places, {}, triangles), kGrey);
}

/// The outline of a square about the origin in the plane z = 0.
std::vector<Mesh> squareOutline(float halfSide, float width)
{
    const float inner = halfSide - width;
    return {rectangle({-halfSide, -halfSide}, {halfSide, -inner}, kBlue),
            rectangle({-halfSide, inner}, {halfSide, halfSide}, kBlue),
            rectangle({-halfSide, -inner}, {-inner, inner}, kBlue),
            rectangle({inner, -inner}, {halfSide, inner}, kBlue)};
}

/// A disc in the plane z = 0, facing +z.
Mesh disc(double radius, const Color &color)
{
    constexpr std::size_t kSegments = 96;
    std::vector<glm::vec3> places{glm::vec3(0.0f)};
    std::vector<std::array<std::size_t, 3>> triangles;
    for (std::size_t i = 0; i < kSegments; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kSegments;
        places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        triangles.push_back({0, i + 1, (i + 1) % kSegments + 1});
    }
    return colored(flatMesh(places, {}, triangles), color);
}

Mesh facesColored(Mesh cube)
{
    constexpr std::array<Color, 6> kFaces{kRed, kTeal, kYellow, kPurple, kBlue, kGreen};
    cube.baseColor = glm::vec4(1.0f);
    for (std::size_t vertex = 0; vertex < cube.positions.size(); ++vertex)
        cube.colors.push_back(kFaces[vertex / kVerticesPerCubeFace]);
    return cube;
}

// ---- scenes -------------------------------------------------------------------------------------

SceneObject object(std::string name, std::vector<Mesh> meshes, std::vector<TransformStep> transform = {})
{
    auto model = std::make_shared<Model>();
    model->name = name;
    model->meshes = std::move(meshes);
    model->bounds = boundsOf(model->meshes);
    return {std::move(name), {}, std::move(model), std::move(transform)};
}

SceneObject object(std::string name, Mesh mesh, std::vector<TransformStep> transform = {})
{
    std::vector<Mesh> meshes;
    meshes.push_back(std::move(mesh));
    return object(std::move(name), std::move(meshes), std::move(transform));
}

std::vector<Mesh> joined(std::vector<Mesh> meshes, Mesh another)
{
    meshes.push_back(std::move(another));
    return meshes;
}

Translate movedBy(double x, double y, double z)
{
    return {glm::dvec3(x, y, z)};
}

ViewportRule keepingAspect(double aspect)
{
    ViewportRule rule{ViewportRule::Kind::KeepAspect};
    rule.aspect = aspect;
    return rule;
}

Scene scene(const LookAt &camera, const Projection &projection, const ViewportRule &viewport,
            std::vector<SceneObject> objects)
{
    Scene made;
    made.camera = made.home = camera;
    made.projection = projection;
    made.projectionFollowsViewport = false;
    made.clipDistancesFitObjects = false;
    made.viewport = viewport;
    made.objects = std::move(objects);
    return made;
}

/// gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0), the camera of the zhangci tutorial.
LookAt fromFive()
{
    return {WorldPoint(0, 0, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
}

/// OpenGL's initial camera: eye coordinates are world coordinates.
LookAt fromOrigin()
{
    return {WorldPoint(0, 0, 0), WorldPoint(0, 0, -1), {0, 1, 0}};
}

Scene following(GivenPoint point, Scene scene)
{
    scene.givenPoint = std::move(point);
    return scene;
}

Ortho zhangciOrtho()
{
    return {-10, 10, -10, 10, -10, 10};
}

// ---- zhangci-pipeline ---------------------------------------------------------------------------

/// Figures 2.3 to 2.5 in the plane z = 0. MC = [-1 0 4; 0 1 3; 0 0 1] is a mirror and a
/// translation. VC = [1 0 5; 0 -1 2; 0 0 1] is a mirror in the plane. In space it is a half turn
/// about x: the camera looks along +z with its up downwards. Thus (x, y, z) becomes (x - 5, 2 - y,
/// -z) in eye coordinates.
Scene twoDimensional()
{
    constexpr float kLength = 2.0f, kWidth = 0.12f, kLetter = 0.55f;
    // The world's y points down in this view, and so do its letters.
    const auto named = [](std::string_view name, float left, float low, float right, float up) {
        return joined(axes(kLength, kWidth), label(name, {left, low}, {right * kLetter, up * kLetter}));
    };
    const LookAt camera{WorldPoint(5, 2, 0), WorldPoint(5, 2, 1), {0, -1, 0}};
    constexpr auto kOwn = "MC, with the point (1, 1)";
    return following(
        {ObjectPoint(1, 1, 0), kOwn},
        scene(camera, Ortho{-7, 7, -7, 7, -10, 10}, keepingAspect(1.0),
              {object(kOwn, joined(named("MC", 1.4f, 2.0f, -1.0f, -1.0f), mark({1.0f, 1.0f}, 0.25f)),
                      {movedBy(4, 3, 0), Scale{glm::dvec3(-1, 1, 1)}}),
               object("WC", named("WC", 0.3f, 2.0f, 1.0f, -1.0f)),
               object("VC", named("VC", 0.3f, 1.45f, 1.0f, 1.0f), {movedBy(5, 2, 0), Scale{glm::dvec3(1, -1, 1)}})}));
}

/// Figures 2.6 and 2.7; the program draws only the point (1, 1, 0).
Scene modelView()
{
    constexpr auto kOwn = "MC, with the point (1, 1, 0)";
    return following({ObjectPoint(1, 1, 0), kOwn},
                     scene(fromFive(), zhangciOrtho(), keepingAspect(1.0),
                           {object(kOwn, joined(axes(5.0f, 0.3f), mark({1.0f, 1.0f}, 0.5f)), {movedBy(0, 0, -3)})}));
}

/// Figure 2.10, with a cube of the side length that the tutorial assigns to the volume by mistake.
Scene orthographic()
{
    return scene(fromFive(), zhangciOrtho(), keepingAspect(1.0),
                 {object("Cube of side 10", facesColored(cubeMesh(10.0)))});
}

/// Figure 2.12, with equal cubes at different distances.
Scene perspective()
{
    const auto cube = [](std::string name, double x, double z) {
        return object(std::move(name), facesColored(cubeMesh(1.4)),
                      {movedBy(x, 0, z), Rotate{30.0, glm::dvec3(0, 1, 0)}});
    };
    return scene(fromFive(), Perspective{Angle::fromDegrees(45.0), 1.0, 1, 100}, keepingAspect(1.0),
                 {cube("Cube at 5", -1.0, 0), cube("Cube at 11", 1.5, -6), cube("Cube at 19", 5.5, -14)});
}

/// Section 2.3: the middle of the plate has the NDC (0, 0, 0.5).
Scene viewportTransform(const ViewportRule &viewport)
{
    return following({NdcPoint(0.0, 0.0, 0.5)},
                     scene(fromFive(), zhangciOrtho(), viewport,
                           {object("Plate and outline", joined(squareOutline(8.0f, 0.6f), mark({0.0f, 0.0f}, 2.0f)))}));
}

// ---- projection-derivation ----------------------------------------------------------------------

constexpr double kDerivationNear = 5.0, kDerivationFar = 80000.0;

/// @param projection  projection of the three programs, in their window of 800 x 600
Scene derivation(const Projection &projection)
{
    const Mesh fan = flatMesh({{0, 0, -20}, {30, 20, -40}, {40, 10, -30}}, {}, {{0, 1, 2}});
    return scene(fromOrigin(), projection, keepingAspect(800.0 / 600.0),
                 {object("Triangle fan", colored(fan, kFanColor), {movedBy(0, 0, 10)}),
                  object("Circle of radius 5", disc(5.0, kTeal), {movedBy(-8, 0, -20)})});
}

/// left = -near tan(ViewAngleV / 2), bottom = -near tan(ViewAngleH / 2) with ViewAngleH = 90
/// degrees and tan(ViewAngleV / 2) = height / width. The two names are swapped: the horizontal
/// angle is V.
Frustum derivationFrustum()
{
    constexpr double kAcross = kDerivationNear * 600.0 / 800.0;
    return {-kAcross, kAcross, -kDerivationNear, kDerivationNear, kDerivationNear, kDerivationFar};
}

/// The sixteen numbers that ReSize writes into an array, with the same two angles.
MatrixProjection derivationMatrix()
{
    constexpr double kAspectRatio = 600.0 / 800.0; // height / width
    constexpr double kDepth = kDerivationFar - kDerivationNear;
    const double viewAngleV = 2.0 * std::atan(std::tan(std::numbers::pi / 4.0) * kAspectRatio);
    glm::dmat4 m(0.0);
    m[0][0] = 1.0 / std::tan(viewAngleV / 2.0);                 // m[0]
    m[1][1] = m[0][0] * kAspectRatio;                           // m[5]
    m[2][2] = -(kDerivationFar + kDerivationNear) / kDepth;     // m[10]
    m[2][3] = -1.0;                                             // m[11]
    m[3][2] = -2.0 * kDerivationFar * kDerivationNear / kDepth; // m[14]
    return {m, NdcDepth::MinusOneToOne};
}

/// @param given  a matrix of glFrustum's form
Scene derivation(const MatrixProjection &given)
{
    Scene made = derivation(std::get<Frustum>(recognised(given).value().parameters));
    made.projection = SceneProjection(given, made.projection);
    return made;
}

Perspective derivationPerspective()
{
    return {std::numbers::pi / 2.0, 800.0 / 600.0, kDerivationNear, kDerivationFar};
}

// ---- opencascade-transforms ---------------------------------------------------------------------

/// Figure 4.1: the start of a line, the world's origin, in a window of 300 x 300. The article does
/// not print its camera. With this camera a unit is a pixel.
Scene roundTrip()
{
    const LookAt camera{WorldPoint(0, 0, 100), WorldPoint(0, 0, 0), {0, 1, 0}};
    const glm::vec2 end(90.0f, 60.0f);
    const glm::vec2 across = glm::normalize(glm::vec2(-end.y, end.x)) * 1.5f;
    const Mesh line = flatMesh({{-across, 0.0f}, {end - across, 0.0f}, {end + across, 0.0f}, {across, 0.0f}}, {},
                               {{0, 1, 2}, {0, 2, 3}});
    return following({WorldPoint(0, 0, 0)},
                     scene(camera, Ortho{-150, 150, -150, 150, 1, 200}, {ViewportRule::Kind::Fixed, {0, 0, 300, 300}},
                           {object("Line", {mark({0.0f, 0.0f}, 5.0f), colored(line, kGrey)})}));
}

// ---- parallel-projection ------------------------------------------------------------------------

/// Program 1. `const int SIZE = 4.5` is 4.
Scene parallelOrthographic()
{
    constexpr float kSize = 4.0f;
    const Mesh quad =
        flatMesh({{-kSize, kSize, -kSize}, {kSize, kSize, -kSize}, {kSize, -kSize, -kSize}, {-kSize, -kSize, -kSize}},
                 {kPureRed, kPureGreen, kPureBlue, kWhite}, {{0, 3, 1}, {2, 1, 3}});
    return scene(fromOrigin(), Ortho{-9, 9, -9, 9, 2, 9}, {}, {object("Quad", quad)});
}

/// Program 2, vertices, colours and indices as printed. The angle is 0.78, not pi / 4.
Scene parallelOblique()
{
    constexpr float kSize = 4.5f, kFront = 3.0f;
    const Mesh box = flatMesh({{-kSize, -kSize, -kFront},
                               {-kSize, -kSize, -kSize},
                               {-kSize, kSize, -kFront},
                               {kSize, -kSize, -kFront},
                               {kSize, kSize, -kSize},
                               {-kSize, kSize, -kSize},
                               {kSize, -kSize, -kSize},
                               {kSize, kSize, -kFront}},
                              {kPureRed, kPureGreen, kPureBlue, kWhite, kPureRed, kWhite, kPureBlue, kPureGreen},
                              {{1, 0, 2},
                               {1, 2, 5},
                               {0, 3, 7},
                               {0, 7, 2},
                               {3, 6, 4},
                               {3, 4, 7},
                               {6, 1, 5},
                               {6, 5, 4},
                               {2, 7, 4},
                               {2, 4, 5},
                               {0, 1, 6},
                               {0, 6, 3}});
    return scene(fromOrigin(), Oblique{{-10, 10, -10, 10, 2, 9}, 0.78, 0.78}, {}, {object("Box", box)});
}

} // namespace

std::vector<Example> examples()
{
    const ViewportRule quarter{ViewportRule::Kind::Quarter};
    const ViewportRule fifty{ViewportRule::Kind::Fixed, {0, 0, 50, 50}};
    return {
        {"zhangci-2d", twoDimensional()},
        {"zhangci-model-view", modelView()},
        {"zhangci-ortho", orthographic()},
        {"zhangci-perspective", perspective()},
        {"zhangci-viewport-50", viewportTransform(fifty)},
        {"zhangci-viewport-quarter", viewportTransform(quarter)},
        {"derivation-matrix", derivation(derivationMatrix())},
        {"derivation-perspective", derivation(derivationPerspective())},
        {"derivation-frustum", derivation(derivationFrustum())},
        {"opencascade-round-trip", roundTrip()},
        {"parallel-orthographic", parallelOrthographic()},
        {"parallel-oblique", parallelOblique()},
    };
}

} // namespace unprojector::examples
