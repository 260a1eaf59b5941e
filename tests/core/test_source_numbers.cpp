// The numbers that the originals print, each beside what the program computes, to the digits printed; and their errors,
// each with a number that shows it. The paper of Weng, Huang and Cai prints no number: of it there are errors only.

#include "core/geometry/view_volume.h"
#include "core/matrices/pipeline.h"
#include "core/ray/scene_rays.h"
#include "core/scene/examples.h"
#include "core/unproject/other_programs.h"
#include "tests/support/errata.h"
#include "tests/support/is_near.h"
#include "tests/support/mesh_model.h"
#include "tests/support/unprojecting.h"

#include <QTest>

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::matrices;
using namespace unprojector::unproject;
using unprojector::scene::Scene;
using unprojector::scene::SceneObject;

namespace {

/// A few roundings of numbers of order 1 to 100.
constexpr double kRounding = 1e-12;
/// Coordinates of order 100, taken forward and backward in double.
constexpr double kRoundTrip = 1e-10;
/// The numbers worked out by hand have seven decimals.
constexpr double kPrintedDigits = 5e-7;
constexpr double kRightAngle = std::numbers::pi / 2.0;

/// A number with as many decimals as the one that is printed; 0 without its sign.
std::string asPrinted(double number, const std::string &printed)
{
    const std::size_t point = printed.find('.');
    const int decimals = point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
    const std::string result = text.data();
    return result.find_first_of("123456789") == std::string::npos && result[0] == '-' ? result.substr(1) : result;
}

const Scene &exampleScene(const char *id)
{
    static const std::vector<scene::Example> all = scene::examples();
    const auto found = std::find_if(all.begin(), all.end(), [id](const scene::Example &e) { return e.id == id; });
    if (found == all.end())
        qFatal("There is no example %s.", id);
    return found->scene;
}

/// Of an example's first object, in a window as large as the original's: what the Pipeline panel shows.
Pipeline pipelineOf(const char *id)
{
    const Scene &scene = exampleScene(id);
    return pipeline(pictureOf(scene, {800, 600, 1.0}, {}).value(), worldFromObject(scene.objects.at(0).transform))
        .value();
}

const glm::dmat4 &forward(const Pipeline &pipeline, PipelineStage stage)
{
    return pipeline.matrix(stage, PipelineDirection::Forward);
}

/// A picture that fills a window of 800 x 600 pixels.
Picture pictureBy(const Projection &projection, const LookAt &camera = {})
{
    const Surface surface{800, 600, 1.0};
    return {surface, wholeSurface(surface), DepthRange{}, projection, camera};
}

/// OpenGL numbers a matrix's elements down the columns: m[12..14] is the translation.
double element(const glm::dmat4 &m, int index)
{
    return m[index / 4][index % 4];
}

/// What a click meets of a quadrilateral.
std::optional<ray::SceneHit> hitOn(const std::vector<glm::vec3> &corners, const std::vector<TransformStep> &transform,
                                   const Picture &picture, const DevicePoint &position,
                                   const std::vector<glm::dvec4> &clipPlanes = {})
{
    scene::Mesh mesh;
    mesh.positions = corners;
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const std::array objects{SceneObject{"quadrilateral", {}, modelOf(std::move(mesh)), transform}};
    const std::array casters{ray::RayCaster::build(objects[0].model, {})};
    return ray::SceneRays(Unprojector::of(picture).value(), objects, casters, clipPlanes).at(position).value();
}

/// The eye of the originals' programs, which call no gluLookAt.
const LookAt kFromOrigin{WorldPoint(0, 0, 0), WorldPoint(0, 0, -1), {0, 1, 0}};
const LookAt kFromFive{WorldPoint(0, 0, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
/// Neither at the origin nor along an axis: 13 from where it looks.
const LookAt kFromAside{WorldPoint(3, 4, 12), WorldPoint(0, 0, 0), {0, 1, 0}};

// ---- the numbers ---------------------------------------------------------------------------------------------------

void row(const std::string &place, const char *printed, double computed)
{
    QTest::newRow(place.c_str()) << QByteArray(printed) << computed;
}

void rows(const std::string &place, const std::vector<const char *> &printed, const glm::dvec4 &computed)
{
    for (std::size_t k = 0; k < printed.size(); ++k)
        row(place + ", " + "xyzw"[k], printed[k], computed[int(k)]);
}

/// A debugger's window: m[0] to m[15], each rounded to float as glGetFloatv gives it.
void watched(const std::string &figure, const std::array<const char *, 16> &printed, const glm::dmat4 &computed)
{
    for (int index = 0; index < 16; ++index)
        row(figure + ", m[" + std::to_string(index) + "]", printed[std::size_t(index)],
            double(float(element(computed, index))));
}

/// A matrix as it is printed, row by row. Of a 3 x 3 in the plane: without the row and column of z.
template <std::size_t Count>
void matrix(const std::string &place, const std::array<const char *, Count> &printed, const glm::dmat4 &computed)
{
    constexpr int kSide = Count == 9 ? 3 : 4;
    for (int k = 0; k < int(Count); ++k) {
        const int i = k / kSide, j = k % kSide;
        const auto inSpace = [](int at) { return kSide == 3 && at == 2 ? 3 : at; };
        row(place + ", row " + std::to_string(i + 1) + ", column " + std::to_string(j + 1), printed[std::size_t(k)],
            computed[inSpace(j)][inSpace(i)]);
    }
}

void zhangciInThePlane()
{
    const Pipeline plane = pipelineOf("zhangci-2d");
    matrix<9>("zhangci 2.1 MC", {"-1", "0", "4", "0", "1", "3", "0", "0", "1"},
              forward(plane, PipelineStage::ModelMatrix));
    // The example's camera is a rotation, which changes nothing of the plane but its z.
    matrix<9>("zhangci 2.1 VC", {"1", "0", "5", "0", "-1", "2", "0", "0", "1"},
              plane.matrix(PipelineStage::ViewMatrix, PipelineDirection::Backward));
    matrix<9>("zhangci 2.1 VC^-1", {"1", "0", "-5", "0", "-1", "2", "0", "0", "1"},
              forward(plane, PipelineStage::ViewMatrix));
    matrix<9>("zhangci 2.1 M", {"-1", "0", "-1", "0", "-1", "-1", "0", "0", "1"},
              forward(plane, PipelineStage::ModelviewMatrix));
    const PipelinePoints points = pointsFrom(plane, exampleScene("zhangci-2d").givenPoint.value());
    rows("zhangci 2.1 the point in MC", {"1", "1"}, glm::dvec4(points.object->coordinates(), 1.0));
    rows("zhangci 2.1 the point in WC", {"3", "4"}, glm::dvec4(points.world->coordinates(), 1.0));
    rows("zhangci 2.1 the point in VC", {"-2", "-2"}, glm::dvec4(points.eye->coordinates(), 1.0));
}

void zhangciInSpace()
{
    const Pipeline modelView = pipelineOf("zhangci-model-view");
    matrix<16>("zhangci fig 2.6 MC", {"1", "0", "0", "0", "0", "1", "0", "0", "0", "0", "1", "-3", "0", "0", "0", "1"},
               forward(modelView, PipelineStage::ModelMatrix));
    matrix<16>("zhangci fig 2.6 VC^-1",
               {"1", "0", "0", "0", "0", "1", "0", "0", "0", "0", "1", "-5", "0", "0", "0", "1"},
               forward(modelView, PipelineStage::ViewMatrix));
    matrix<16>("zhangci fig 2.6 M", {"1", "0", "0", "0", "0", "1", "0", "0", "0", "0", "1", "-8", "0", "0", "0", "1"},
               forward(modelView, PipelineStage::ModelviewMatrix));
    watched("zhangci fig 2.7",
            {"1.00000000", "0.00000000", "0.00000000", "0.00000000", "0.00000000", "1.00000000", "0.00000000",
             "0.00000000", "0.00000000", "0.00000000", "1.00000000", "0.00000000", "0.00000000", "0.00000000",
             "-8.00000000", "1.00000000"},
            forward(modelView, PipelineStage::ModelviewMatrix));

    // Onto the plane z = 0, along the view: the window point of (1, 1, 5) taken back with the plane's own depth.
    const Picture box = pictureBy(Ortho{-10, 10, -10, 10, 0, 10}, kFromFive);
    const WindowPoint five = windowFromWorld(box, WorldPoint(1, 1, 5)).value(),
                      zero = windowFromWorld(box, WorldPoint(0, 0, 0)).value();
    rows(
        "zhangci fig 2.8 (1, 1, 5) projected", {"1", "1", "0"},
        glm::dvec4(unprojectedAt(box, WindowPoint(five.x, five.y, zero.z)).world[Method::Formula].value().coordinates(),
                   1.0));

    const glm::dmat4 ortho = forward(pipelineOf("zhangci-ortho"), PipelineStage::ProjectionMatrix);
    matrix<16>("zhangci 2.2.1 M_ortho",
               {"0.1", "0", "0", "0", "0", "0.1", "0", "0", "0", "0", "-0.1", "0", "0", "0", "0", "1"}, ortho);
    watched("zhangci fig 2.10",
            {"0.10000000", "0.00000000", "0.00000000", "0.00000000", "0.00000000", "0.10000000", "0.00000000",
             "0.00000000", "0.00000000", "0.00000000", "-0.10000000", "0.00000000", "0.00000000", "0.00000000",
             "0.00000000", "1.00000000"},
            ortho);
    watched("zhangci fig 2.12",
            {"2.4142137", "0.00000000", "0.00000000", "0.00000000", "0.00000000", "2.4142137", "0.00000000",
             "0.00000000", "0.00000000", "0.00000000", "-1.0202020", "-1.0000000", "0.00000000", "0.00000000",
             "-2.0202019", "0.00000000"},
            forward(pipelineOf("zhangci-perspective"), PipelineStage::ProjectionMatrix));

    // Its depth is among the errors.
    const PipelinePoints middle =
        pointsFrom(pipelineOf("zhangci-viewport-50"), exampleScene("zhangci-viewport-50").givenPoint.value());
    rows("zhangci 2.3 the NDC", {"0", "0", "0.5"}, glm::dvec4(middle.ndc->coordinates(), 1.0));
    rows("zhangci 2.3 in a window of 50 x 50", {"25", "25"}, glm::dvec4(middle.window->coordinates(), 1.0));
    for (const auto &[printed, ndc] : {std::pair("0", -1.0), std::pair("1", 1.0)})
        row(std::string("zhangci 2.3 an end of the depth buffer, ") + printed, printed,
            windowFromNdc(Viewport{0, 0, 50, 50}, DepthRange{}, NdcPoint(0, 0, ndc)).z);
}

void projectionDerivation()
{
    const Pipeline matrix = pipelineOf("derivation-matrix");
    for (const ClipPoint &clip : {ClipPoint(1, 4, 7, 1), ClipPoint(2, 8, 14, 2), ClipPoint(-0.1, -0.4, -0.7, -0.1)})
        rows("derivation homogeneous, w " + std::to_string(clip.w), {"1", "4", "7"},
             glm::dvec4(pointsFrom(matrix, {clip}).ndc.value().coordinates(), 1.0));
    // Two linear scales: half way from 0 to 100 is half way from 5 to 90, as NDC come to a viewport.
    row("derivation the broken thermometer", "47.5", windowFromNdc(Viewport{5, 0, 85, 1}, {}, NdcPoint(0, 0, 0)).x);

    for (const char *id : {"derivation-matrix", "derivation-perspective", "derivation-frustum"}) {
        const Pipeline program = pipelineOf(id);
        rows(std::string(id) + " last row", {"0", "0", "-1", "0"},
             glm::row(forward(program, PipelineStage::ProjectionMatrix), 3));
        row(std::string(id) + " z = -N", "-1", pointsFrom(program, {EyePoint(0, 0, -5)}).ndc.value().z);
        row(std::string(id) + " z = -F", "1", pointsFrom(program, {EyePoint(0, 0, -80000)}).ndc.value().z);
        rows(std::string(id) + " translated by", {"0", "0", "10"}, forward(program, PipelineStage::ModelMatrix)[3]);
    }
}

void openCascade()
{
    const PipelinePoints points =
        pointsFrom(pipelineOf("opencascade-round-trip"), exampleScene("opencascade-round-trip").givenPoint.value());
    rows("opencascade fig 4.1, in the world", {"0", "0", "0"}, glm::dvec4(points.world->coordinates(), 1.0));
    rows("opencascade fig 4.1, on the screen", {"150", "150"}, glm::dvec4(points.window->coordinates(), 1.0));
    const glm::dmat4 viewport = windowFromNdc(Viewport{0, 0, 300, 300}, DepthRange{});
    rows("opencascade 2.3, row 3", {"0", "0", "0.5", "0.5"}, glm::row(viewport, 2));
    rows("opencascade 2.3, row 4", {"0", "0", "0", "1"}, glm::row(viewport, 3));
    // A camera 1 to the right is a scene 1 to the left.
    row("opencascade 2.1, camera +1", "-1",
        eyeFromWorld(eyeFrame({WorldPoint(1, 0, 0), WorldPoint(1, 0, -1), {0, 1, 0}}).value(), WorldPoint(0, 0, 0)).x);
}

void parallelProjection()
{
    // The flat projection of its first matrix, z = 0: what is left of an eye point in the window.
    const Picture box = pictureBy(Ortho{-9, 9, -9, 9, 0, 9}, kFromOrigin);
    const WindowPoint at = windowFromWorld(box, WorldPoint(2, 5, -4)).value();
    rows(
        "parallel diag(1, 1, 0, 1)", {"2", "5", "0"},
        glm::dvec4(unprojectedAt(box, WindowPoint(at.x, at.y, 0.0)).world[Method::Formula].value().coordinates(), 1.0));

    // The side of the CVV, and the corners of the square in it: (4/9, 4/9).
    const Pipeline square = pipelineOf("parallel-orthographic");
    row("parallel side of the CVV", "2",
        pointsFrom(square, {EyePoint(9, 0, -2)}).ndc.value().x
            - pointsFrom(square, {EyePoint(-9, 0, -2)}).ndc.value().x);
    row("parallel the near plane, z", "-2", viewVolumeCorners(square.geometry.projection())[0].z);
    row("parallel the far plane, z", "-9", viewVolumeCorners(square.geometry.projection())[4].z);
    const glm::dmat4 ortho = forward(square, PipelineStage::ProjectionMatrix);
    // From what its text derives, by hand: 2/18, -2/7, -11/7.
    matrix<16>("parallel program 1",
               {"0.1111111", "0", "0", "0", "0", "0.1111111", "0", "0", "0", "0", "-0.2857143", "-1.5714286", "0", "0",
                "0", "1"},
               ortho);
    // By hand: 0.1 cot 0.78; with pi/4 it would be 0.1.
    matrix<16>("parallel program 2",
               {"0.1", "0", "0.1010855", "0", "0", "0.1", "0.1010855", "0", "0", "0", "-0.2857143", "-1.5714286", "0",
                "0", "0", "1"},
               forward(pipelineOf("parallel-oblique"), PipelineStage::ProjectionMatrix));
}

/// What Help works out besides.
void help()
{
    // projection-derivation: 90 degrees across at 800 x 600, right / near = 1, top / near = 3 / 4.
    const Projection wide = Frustum{-5, 5, -3.75, 3.75, 5, 80000};
    row("help, the vertical angle to 90 degrees across", "73.74",
        degreesFromRadians(std::get<Perspective>(converted(wide, ProjectionKind::Perspective, 5)).verticalFovRadians));
    // x + y = 1 under glScale(2, 1, 1): (1/2, 1, 0) of length 1, and not (2, 1, 0).
    const LookAt camera{WorldPoint(8, 8, 0), WorldPoint(1, 0.5, 0), {0, 0, 1}};
    const auto hit = hitOn({{0, 1, -5}, {1, 0, -5}, {1, 0, 5}, {0, 1, 5}}, {Scale{{2, 1, 1}}},
                           pictureBy(Perspective{kRightAngle, 4.0 / 3.0, 1, 100}, camera), DevicePoint(400, 300));
    const WorldVector normal = hit->triangle->normal;
    const double length = std::copysign(std::hypot(0.5, 1.0), normal.x); // either side of the surface
    rows("help, the normal under glScale(2, 1, 1)", {"0.5", "1.0", "0.0"},
         glm::dvec4(normal.coordinates() * length, 0.0));
    // How long an edge into the depth is drawn: cavalier, cabinet, and the program of parallel-projection.
    for (const auto &[printed, angle] : {std::pair("1.00", radiansFromDegrees(54.74)),
                                         std::pair("0.50", radiansFromDegrees(70.53)), std::pair("1.43", 0.78)}) {
        const glm::dmat4 oblique = clipFromEye(Oblique{{-1, 1, -1, 1, 2, 9}, angle, angle}).value();
        row(std::string("help, an oblique edge, ") + printed, printed, glm::length(glm::dvec2(oblique[2])));
    }
}

// ---- the errors ----------------------------------------------------------------------------------------------------

/// An error, by a number that comes out of it.
struct Erratum {
    const char *anchor; ///< in Help
    const char *what;
    double printed;
    double right;
    double computed; ///< by the program
};

struct Errata {
    std::vector<Erratum> all;

    void add(const char *anchor, const char *what, double printed, double right, double computed)
    {
        all.push_back({anchor, what, printed, right, computed});
    }
};

void errorsOfThePaper(Errata &errors)
{
    // Off the middle, so that nothing is 0 or hidden by symmetry.
    const Picture frustum = pictureBy(Frustum{-1, 3, -2, 1, 2, 10}, kFromOrigin);
    const WindowPoint at = windowFromWorld(frustum, WorldPoint(1.5, 0.4, -4)).value();
    const EyePoint eye = unprojectedAt(frustum, at).eye[Method::Formula].value();
    const double zEye = -4;
    errors.add("error-weng-sign", "x by (9) with z of the eye", at.x * 4.0 * zEye / (800.0 * 2.0) + -1.0 * zEye / 2.0,
               1.5, eye.x);
    errors.add("error-weng-sign", "y by (10) with z of the eye", at.y * 3.0 * zEye / (600.0 * 2.0) + -2.0 * zEye / 2.0,
               0.4, eye.y);

    const DevicePixel pixel{10, 20};
    const Surface &surface = frustum.surface;
    errors.add("error-weng-row", "y_v of pixel (10, 20)", 600 - pixel.j, 579.5,
               windowFromDevice(surface, pixelCenter(pixel), 0.5).y);
    errors.add("error-weng-row", "the row whose depth screen2world reads",
               framebufferRow(surface, clickOf(OtherProgram::Screen2World, frustum, pixel).depthFrom), 579,
               framebufferRow(surface, pixel));

    const Picture before = pictureBy(Perspective{kRightAngle, 4.0 / 3.0, 1, 100}, kFromFive);
    errors.add("error-weng-x-axis", "the side of the middle that x lies on", -1, 1,
               std::copysign(1.0, windowFromWorld(before, WorldPoint(1, 0, 0)).value().x - 400));
    errors.add("error-weng-look-at", "z of the direction, from (0, 0, 5) to the origin", 1, -1,
               eyeFrame(kFromFive).value().forward.z);

    // A wall that faces the eye, cut at y = 0: clicked above its middle and below.
    const std::vector<glm::vec3> wall{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
    const std::vector<glm::dvec4> plane{glm::dvec4(0, 1, 0, 0)};
    errors.add("error-weng-clip-plane", "surfaces met above y = 0", 0, 1,
               hitOn(wall, {}, before, DevicePoint(400.5, 200.5), plane) ? 1 : 0);
    errors.add("error-weng-clip-plane", "surfaces met below y = 0", 1, 0,
               hitOn(wall, {}, before, DevicePoint(400.5, 400.5), plane) ? 1 : 0);
    const glm::dmat4 view = eyeFromWorld(eyeFrame(kFromFive).value());
    errors.add("error-weng-clip-plane", "D of z = 0 as OpenGL keeps it, called behind gluLookAt", 0, 5,
               planeInSource(glm::dvec4(0, 0, 1, 0), glm::inverse(view)).w);

    // A rectangle whose top is 40: its height is still 600.
    errors.add("error-weng-bottom", "y_v by the bottom of a rectangle from 40 to 640", 640 - 20.5, 579.5,
               flippedY(surface, 20.5));

    const Picture aside = pictureBy(Perspective{kRightAngle, 4.0 / 3.0, 1, 100}, kFromAside);
    const Unprojected origin = unprojectedAt(aside, windowFromWorld(aside, WorldPoint(0, 0, 0)).value());
    errors.add("error-weng-eye", "z of the world's origin", origin.eye[Method::Formula].value().z, 0,
               origin.world[Method::Formula].value().z);
}

void errorsOfZhangci(Errata &errors)
{
    const Pipeline modelView = pipelineOf("zhangci-model-view");
    errors.add("error-zhangci-product", "m[14]", element(forward(modelView, PipelineStage::ViewMatrix), 14), -8,
               element(forward(modelView, PipelineStage::ModelviewMatrix), 14));

    const Pipeline box = pipelineOf("zhangci-ortho");
    const auto corners = viewVolumeCorners(box.geometry.projection());
    errors.add("error-zhangci-cube", "side of glOrtho(-10 .. 10)", 10, 20, distance(corners[0], corners[1]));
    errors.add("error-zhangci-cube", "side when normalised", 1, 2,
               distance(pointsFrom(box, {corners[0]}).ndc.value(), pointsFrom(box, {corners[1]}).ndc.value()));
    const double n = -10, f = 10;
    errors.add("error-zhangci-ortho", "m[10]", -2 / (n - f), -0.1,
               element(forward(box, PipelineStage::ProjectionMatrix), 10));
    errors.add("error-zhangci-perspective", "m[14]", -2 * 1.0 * 100.0 / (1.0 - 100.0), -200.0 / 99.0,
               element(forward(pipelineOf("zhangci-perspective"), PipelineStage::ProjectionMatrix), 14));
    errors.add("error-zhangci-depth", "depth of the NDC 0.5", 0.5, 0.75,
               windowFromNdc(Viewport{0, 0, 50, 50}, DepthRange{}, NdcPoint(0, 0, 0.5)).z);

    // The figure's point (1, 1, 0), which its translation takes to z = -3 in the world.
    const PipelinePoints back =
        pointsBackward(modelView, pointsForward(modelView, ObjectPoint(1, 1, 0)).window.value());
    const glm::dmat4 clipFromObject =
        forward(modelView, PipelineStage::ProjectionMatrix) * forward(modelView, PipelineStage::ModelviewMatrix);
    errors.add("error-zhangci-object", "z by gluUnProject with GL_MODELVIEW",
               unprojectByInverse<ObjectSpace>(clipFromObject, modelView.geometry.viewport, DepthRange{}, *back.window)
                   .value()
                   .z,
               -3, back.world->z);
}

void errorsOfProjectionDerivation(Errata &errors)
{
    const auto m0 = [](const char *id) { return element(forward(pipelineOf(id), PipelineStage::ProjectionMatrix), 0); };
    errors.add("error-derivation-three", "m[0] of gluPerspective is that of the matrix", m0("derivation-matrix"), 0.75,
               m0("derivation-perspective"));
    errors.add("error-derivation-three", "m[0] of gluPerspective is that of glFrustum", m0("derivation-frustum"), 0.75,
               m0("derivation-perspective"));
    errors.add("error-derivation-translate", "z of the apex", -20, -10,
               pointsForward(pipelineOf("derivation-matrix"), ObjectPoint(0, 0, -20)).eye.value().z);
}

void errorsOfOpenCascade(Errata &errors)
{
    // e = (3, 4, 12), 13 from the origin; u is s here, v is u and n is -f.
    const glm::dmat4 view = eyeFromWorld(eyeFrame(kFromAside).value());
    errors.add("error-opencascade-model-view", "-e u, printed as -ex", -3, 0, element(view, 12));
    errors.add("error-opencascade-model-view", "-e n, printed as -ez", -12, -13, element(view, 14));
    const glm::dmat4 ortho = clipFromEye(Ortho{-1, 3, -2, 1, 2, 10}).value();
    errors.add("error-opencascade-ortho", "m[12]", (3.0 + -1.0) / (3.0 - -1.0), -0.5, element(ortho, 12));
    errors.add("error-opencascade-ortho", "m[13]", (1.0 + -2.0) / (1.0 - -2.0), 1.0 / 3.0, element(ortho, 13));
    const double zNear = -1, zFar = -100; // signed, as it has them
    errors.add("error-opencascade-perspective", "m[14]", 2 * zNear * zFar / (zNear - zFar), -200.0 / 99.0,
               element(clipFromEye(Perspective{kRightAngle, 1, 1, 100}).value(), 14));
    // BuildNorm2ViewportMatrix, and the matrix of the text.
    const double y = 0.5, byTheCode = (0 - 300) / 2.0 * y + (300 + 0) / 2.0;
    errors.add("error-opencascade-viewport", "y in the window of the NDC 0.5", byTheCode, 225,
               windowFromNdc(Viewport{0, 0, 300, 300}, DepthRange{}, NdcPoint(0, y, 0)).y);
    // A row vector times a matrix that is set for columns.
    const glm::dmat4 viewport = windowFromNdc(Viewport{0, 0, 300, 300}, DepthRange{});
    const glm::dvec4 middle(0, 0, 0, 1);
    errors.add("error-opencascade-rows", "x in the window of NDC's middle", (middle * viewport).x, 150,
               (middle * glm::transpose(viewport)).x);
}

void errorsOfParallelProjection(Errata &errors)
{
    const Pipeline square = pipelineOf("parallel-orthographic");
    const glm::dmat4 ortho = forward(square, PipelineStage::ProjectionMatrix);
    glm::dmat4 flip(1.0);
    flip[2][2] = -1.0;
    const glm::dmat4 scaledAndMoved = flip * ortho; // its M = S T
    errors.add("error-parallel-flip", "m[14]", element(scaledAndMoved * flip, 14), -11.0 / 7.0, element(ortho, 14));

    const Pipeline oblique = pipelineOf("parallel-oblique");
    const double cot = 1.0 / std::tan(0.78);
    errors.add("error-parallel-way", "the way along x at z = -3", cot, -3.0 * cot,
               10.0 * pointsForward(oblique, ObjectPoint(4.5, 4.5, -3)).ndc.value().x - 4.5);
    errors.add("error-parallel-size", "SIZE", 4.5, 4,
               double(exampleScene("parallel-orthographic").objects.at(0).model->bounds.highest.x));

    const int n = 2, f = 9, quotient = -(n + f) / (f - n); // as its shader has them
    errors.add("error-parallel-integers", "m[14]", quotient, -11.0 / 7.0, element(ortho, 14));
    errors.add("error-parallel-integers", "z of the square's NDC", -2.0 / (f - n) * -4.0 + quotient, -3.0 / 7.0,
               pointsForward(square, ObjectPoint(4, 4, -4)).ndc.value().z);
    errors.add("error-parallel-cot", "cot 0.78", 1.0, cot, cotangent(0.78));
}

Errata errorsOfAll()
{
    Errata errors;
    errorsOfThePaper(errors);
    errorsOfZhangci(errors);
    errorsOfProjectionDerivation(errors);
    errorsOfOpenCascade(errors);
    errorsOfParallelProjection(errors);
    return errors;
}

/// Forward by matrices, for the vertices of the originals' programs: their model-view matrix is the identity.
WindowPoint windowFromEye(const Projection &projection, const Viewport &viewport, const EyePoint &point)
{
    const glm::dvec4 clip = clipFromEye(projection).value() * glm::dvec4(point.coordinates(), 1.0);
    return windowFromNdc(viewport, DepthRange{}, NdcPoint(glm::dvec3(clip) / clip.w));
}

} // namespace

class TestSourceNumbers : public QObject {
    Q_OBJECT

private slots:
    void whatIsPrintedIsComputed_data();
    void whatIsPrintedIsComputed();
    void anErrorIsOne_data();
    void anErrorIsOne();
    void everyErrorOfHelpIsShown();
    void glOrthoIsThreeSteps();
    void theViewportWithYDownCountsFromTheTop();
    void theWorldOriginIsTheMiddleOfTheWidgetAndBack_data();
    void theWorldOriginIsTheMiddleOfTheWidgetAndBack();
    void threeProjectionsGiveOnePictureOnlyInASquareWindow_data();
    void threeProjectionsGiveOnePictureOnlyInASquareWindow();
    void programVerticesGoToTheirPixelsAndBack_data();
    void programVerticesGoToTheirPixelsAndBack();
};

void TestSourceNumbers::whatIsPrintedIsComputed_data()
{
    QTest::addColumn<QByteArray>("printed");
    QTest::addColumn<double>("computed");
    zhangciInThePlane();
    zhangciInSpace();
    projectionDerivation();
    openCascade();
    parallelProjection();
    help();
}

void TestSourceNumbers::whatIsPrintedIsComputed()
{
    QFETCH(QByteArray, printed);
    QFETCH(double, computed);
    QCOMPARE(QByteArray::fromStdString(asPrinted(computed, printed.toStdString())), printed);
}

void TestSourceNumbers::anErrorIsOne_data()
{
    QTest::addColumn<double>("printed");
    QTest::addColumn<double>("right");
    QTest::addColumn<double>("computed");
    for (const Erratum &error : errorsOfAll().all)
        QTest::addRow("%s: %s", error.anchor, error.what) << error.printed << error.right << error.computed;
}

void TestSourceNumbers::anErrorIsOne()
{
    QFETCH(double, printed);
    QFETCH(double, right);
    QFETCH(double, computed);
    QVERIFY(isNear(computed, right, kRoundTrip));
    QVERIFY2(std::abs(printed - right) > 1e-3, "what is printed is right");
}

void TestSourceNumbers::everyErrorOfHelpIsShown()
{
    const Errata errors = errorsOfAll();
    std::vector<std::string> shown;
    for (const Erratum &error : errors.all) {
        if (shown.empty() || shown.back() != error.anchor)
            shown.emplace_back(error.anchor);
    }
    QVERIFY(shown == std::vector<std::string>(kErrata.begin(), kErrata.end()));
}

/// parallel-projection: moved, scaled, turned round, of a box that is nowhere symmetric.
void TestSourceNumbers::glOrthoIsThreeSteps()
{
    const Ortho box{-1, 3, -2, 1, 2, 10};
    const glm::dmat4 steps = worldFromObject(
        {Scale{{1, 1, -1}}, Scale{{2.0 / 4.0, 2.0 / 3.0, 2.0 / 8.0}}, Translate{{-2.0 / 2.0, 1.0 / 2.0, 12.0 / 2.0}}});
    const glm::dmat4 ortho = clipFromEye(box).value();
    for (int index = 0; index < 16; ++index)
        QVERIFY2(isNear(element(steps, index), element(ortho, index), kRounding), qPrintable(QString::number(index)));
}

/// opencascade-transforms: BuildNorm2ViewportMatrix.
void TestSourceNumbers::theViewportWithYDownCountsFromTheTop()
{
    const Surface surface{300, 200, 1.0};
    const glm::dmat4 yDown{{150, 0, 0, 0}, {0, -100, 0, 0}, {0, 0, 0.5, 0}, {150, 100, 0.5, 1}};
    for (const NdcPoint &ndc : {NdcPoint(0, 0, 0), NdcPoint(0.25, -0.75, 0.5), NdcPoint(-1, 1, -1)}) {
        const glm::dvec4 byMatrix = yDown * glm::dvec4(ndc.coordinates(), 1.0);
        const WindowPoint window = windowFromNdc(wholeSurface(surface), DepthRange{}, ndc);
        const DevicePoint device = deviceFromWindow(surface, window);
        QVERIFY(isNear(glm::dvec3(byMatrix), {device.x, device.y, window.z}, kRounding));
    }
}

void TestSourceNumbers::theWorldOriginIsTheMiddleOfTheWidgetAndBack_data()
{
    QTest::addColumn<Projection>("projection");
    QTest::addColumn<WorldPoint>("eye");
    QTest::addColumn<double>("depth");

    // The origin is 5, or sqrt(3^2 + 4^2 + 12^2) = 13, in front of the eye.
    QTest::newRow("perspective from the front")
        << Projection(Perspective{kRightAngle, 1, 1, 100}) << WorldPoint(0, 0, 5) << 400.0 / 495.0;
    QTest::newRow("perspective from aside")
        << Projection(Perspective{kRightAngle, 1, 1, 100}) << WorldPoint(3, 4, 12) << 1200.0 / 1287.0;
    QTest::newRow("ortho from the front") << Projection(Ortho{-10, 10, -10, 10, 1, 9}) << WorldPoint(0, 0, 5) << 0.5;
    QTest::newRow("ortho from aside") << Projection(Ortho{-10, 10, -10, 10, 3, 33}) << WorldPoint(3, 4, 12)
                                      << 1.0 / 3.0;
}

void TestSourceNumbers::theWorldOriginIsTheMiddleOfTheWidgetAndBack()
{
    QFETCH(Projection, projection);
    QFETCH(WorldPoint, eye);
    QFETCH(double, depth);
    const EyeFrame frame = eyeFrame({eye, WorldPoint(0, 0, 0), {0, 1, 0}}).value();
    const Surface surface = surfaceFromWidget(300, 300, 1.0);
    const Viewport viewport = wholeSurface(surface);

    const WindowPoint window = windowFromEye(projection, viewport, eyeFromWorld(frame, WorldPoint(0, 0, 0)));
    const WidgetPoint widget = widgetFromDevice(surface, deviceFromWindow(surface, window));
    QVERIFY(isNear({widget.x, widget.y, window.z}, {150, 150, depth}, kRoundTrip));

    const WindowPoint clicked = windowFromDevice(surface, deviceFromWidget(surface, WidgetPoint(150, 150)), depth);
    const EyePoint byFormula = unprojectClosedForm(projection, viewport, DepthRange{}, clicked).value();
    QVERIFY(isNear(worldFromEye(frame, byFormula).coordinates(), {0, 0, 0}, kRoundTrip));
    const glm::dmat4 clipFromWorld = clipFromEye(projection).value() * eyeFromWorld(frame);
    QVERIFY(isNear(unprojectByInverse<WorldSpace>(clipFromWorld, viewport, DepthRange{}, clicked).value().coordinates(),
                   {0, 0, 0}, kRoundTrip));
}

void TestSourceNumbers::threeProjectionsGiveOnePictureOnlyInASquareWindow_data()
{
    QTest::addColumn<double>("width");
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("handMade");
    QTest::addColumn<double>("gluPerspective");

    QTest::newRow("800x600: the pictures differ") << 800.0 << 600.0 << 1.3333333 << 0.75;
    QTest::newRow("600x600: the pictures agree") << 600.0 << 600.0 << 1.0 << 1.0;
    QTest::newRow("600x800: the pictures differ the other way") << 600.0 << 800.0 << 0.75 << 1.3333333;
}

void TestSourceNumbers::threeProjectionsGiveOnePictureOnlyInASquareWindow()
{
    QFETCH(double, width);
    QFETCH(double, height);
    QFETCH(double, handMade);
    QFETCH(double, gluPerspective);

    // As the original's program has it: AspectRatio = height / width, ViewAngleV across, ViewAngleH up.
    const double viewAngleH = kRightAngle;
    const double viewAngleV = std::atan(std::tan(viewAngleH / 2.0) * (height / width)) * 2.0;
    const double right = 5.0 * std::tan(viewAngleV / 2.0);
    const double top = 5.0 * std::tan(viewAngleH / 2.0);
    const glm::dmat4 frustum = clipFromEye(Frustum{-right, right, -top, top, 5, 80000}).value();
    QVERIFY(isNear(element(frustum, 0), 1.0 / std::tan(viewAngleV / 2.0), 1e-15));
    QVERIFY(isNear(element(frustum, 0), handMade, kPrintedDigits));
    QVERIFY(isNear(element(frustum, 5), 1.0, kPrintedDigits));

    const glm::dmat4 perspective = clipFromEye(Perspective{kRightAngle, width / height, 5, 80000}).value();
    QVERIFY(isNear(element(perspective, 0), gluPerspective, kPrintedDigits));
    QVERIFY(isNear(element(perspective, 5), 1.0, kPrintedDigits));
    // The depth rows agree: -80005/79995 and -800000/79995.
    for (const glm::dmat4 &m : {frustum, perspective}) {
        QVERIFY(isNear(element(m, 10), -1.0001250, kPrintedDigits));
        QVERIFY(isNear(element(m, 14), -10.0006250, kPrintedDigits));
        QCOMPARE(element(m, 11), -1.0);
    }
}

void TestSourceNumbers::programVerticesGoToTheirPixelsAndBack_data()
{
    QTest::addColumn<Projection>("projection");
    QTest::addColumn<Viewport>("viewport");
    QTest::addColumn<EyePoint>("vertex");
    QTest::addColumn<glm::dvec3>("window");

    // projection-derivation. x_n = x / |z| * 4/3 for the hand-made matrix, * 3/4 for gluPerspective.
    const Viewport wide{0, 0, 800, 600};
    const Projection handMade = Frustum{-3.75, 3.75, -5, 5, 5, 80000};
    const Projection perspective = Perspective{kRightAngle, 800.0 / 600.0, 5, 80000};
    const double at10 = 0.5000312519532471, at20 = 0.7500468779298706, at30 = 0.8333854199220785,
                 at40 = 0.8750546909181824;
    QTest::newRow("fan, hand-made, as printed: apex")
        << handMade << wide << EyePoint(0, 0, -20) << glm::dvec3(400, 300, at20);
    QTest::newRow("fan, hand-made, as printed: second")
        << handMade << wide << EyePoint(30, 20, -40) << glm::dvec3(800, 450, at40);
    QTest::newRow("fan, hand-made, as printed: third, right of the window")
        << handMade << wide << EyePoint(40, 10, -30) << glm::dvec3(400 + 400 * 16.0 / 9.0, 400, at30);
    QTest::newRow("fan, hand-made, translated: apex")
        << handMade << wide << EyePoint(0, 0, -10) << glm::dvec3(400, 300, at10);
    QTest::newRow("fan, hand-made, translated: second")
        << handMade << wide << EyePoint(30, 20, -30) << glm::dvec3(400 + 400 * 4.0 / 3.0, 500, at30);
    QTest::newRow("fan, gluPerspective, as printed: apex")
        << perspective << wide << EyePoint(0, 0, -20) << glm::dvec3(400, 300, at20);
    QTest::newRow("fan, gluPerspective, as printed: second")
        << perspective << wide << EyePoint(30, 20, -40) << glm::dvec3(625, 450, at40);
    QTest::newRow("fan, gluPerspective, as printed: third")
        << perspective << wide << EyePoint(40, 10, -30) << glm::dvec3(800, 400, at30);
    QTest::newRow("fan, gluPerspective, translated: third")
        << perspective << wide << EyePoint(40, 10, -20) << glm::dvec3(1000, 450, at20);

    // parallel-projection 1: SIZE = 4.5 is truncated to 4, so the corners are at 4/9 of the half window.
    const Projection box = Ortho{-9, 9, -9, 9, 2, 9};
    const double left = 400 - 1600.0 / 9.0, right = 400 + 1600.0 / 9.0, below = 300 - 1200.0 / 9.0,
                 above = 300 + 1200.0 / 9.0;
    QTest::newRow("quad A, red") << box << wide << EyePoint(-4, 4, -4) << glm::dvec3(left, above, 2.0 / 7.0);
    QTest::newRow("quad B, green") << box << wide << EyePoint(4, 4, -4) << glm::dvec3(right, above, 2.0 / 7.0);
    QTest::newRow("quad C, blue") << box << wide << EyePoint(4, -4, -4) << glm::dvec3(right, below, 2.0 / 7.0);
    QTest::newRow("quad D, white") << box << wide << EyePoint(-4, -4, -4) << glm::dvec3(left, below, 2.0 / 7.0);
    QTest::newRow("quad on the near plane") << box << wide << EyePoint(9, -9, -2) << glm::dvec3(800, 0, 0);
    QTest::newRow("quad on the far plane") << box << wide << EyePoint(-9, 9, -9) << glm::dvec3(0, 600, 1);

    // parallel-projection 2: x_n = (x - 1.0108550 |z|) / 10. With cot = 1 the front corner would be at 0.15, not 0.1467.
    const Projection sheared = Oblique{{-10, 10, -10, 10, 2, 9}, 0.78, 0.78};
    const Viewport square{0, 0, 600, 600};
    const auto at = [](double ndc) { return 300.0 * (1.0 + ndc); };
    const double front = 1.0 / 7.0, back = 2.5 / 7.0;
    QTest::newRow("box H, front top right") << sheared << square << EyePoint(4.5, 4.5, -3)
                                            << glm::dvec3(at(0.1467434911629235), at(0.1467434911629235), front);
    QTest::newRow("box A, front bottom left") << sheared << square << EyePoint(-4.5, -4.5, -3)
                                              << glm::dvec3(at(-0.7532565088370765), at(-0.7532565088370765), front);
    QTest::newRow("box B, back bottom left") << sheared << square << EyePoint(-4.5, -4.5, -4.5)
                                             << glm::dvec3(at(-0.9048847632556147), at(-0.9048847632556147), back);
    QTest::newRow("box E, back top right") << sheared << square << EyePoint(4.5, 4.5, -4.5)
                                           << glm::dvec3(at(-0.0048847632556147), at(-0.0048847632556147), back);
    QTest::newRow("box G, back bottom right") << sheared << square << EyePoint(4.5, -4.5, -4.5)
                                              << glm::dvec3(at(-0.0048847632556147), at(-0.9048847632556147), back);
}

void TestSourceNumbers::programVerticesGoToTheirPixelsAndBack()
{
    QFETCH(Projection, projection);
    QFETCH(Viewport, viewport);
    QFETCH(EyePoint, vertex);
    QFETCH(glm::dvec3, window);

    QVERIFY(isNear(windowFromEye(projection, viewport, vertex).coordinates(), window, kRoundTrip));

    const WindowPoint clicked(window);
    QVERIFY(isNear(unprojectClosedForm(projection, viewport, DepthRange{}, clicked).value().coordinates(),
                   vertex.coordinates(), kRoundTrip));
    // 5 : 80000 costs the inverse matrix four more digits.
    const glm::dmat4 matrix = clipFromEye(projection).value();
    QVERIFY(isNear(unprojectByInverse<EyeSpace>(matrix, viewport, DepthRange{}, clicked).value().coordinates(),
                   vertex.coordinates(), 1e-9));
}

QTEST_GUILESS_MAIN(TestSourceNumbers)
#include "test_source_numbers.moc"
