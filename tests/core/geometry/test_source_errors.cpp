// The errors of the originals, each with a number that shows it.

#include "tests/support/test.h"

#include "core/geometry/view_volume.h"
#include "core/unproject/other_programs.h"
#include "tests/core/geometry/source_examples.h"
#include "tests/support/errata.h"
#include "tests/support/is_near.h"

#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

using namespace source_examples;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::unproject;

namespace {

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

// The printed parts of programs whose text is wrong.

/// The third program's glFrustum, in its ReSize().
constexpr std::string_view kThirdProgram = R"(GLdouble left =-nearz*tan(ViewAngleV/2);
    GLdouble right =nearz*tan(ViewAngleV/2);
    GLdouble bottom =-nearz*tan(ViewAngleH/2);
    GLdouble top =nearz*tan(ViewAngleH/2);
    glFrustum(left,right,bottom,top,nearz,farz);
)";
/// The declarations of the first program's ReSize().
constexpr std::string_view kDeclarations = R"(float nearz =5.0;
    float farz =80000;
    float AspectRatio =float(m_view_height)/ float(m_view_width);
    float ViewAngleH =90 * (PI / 180);
    float ViewAngleV = atan(tan(ViewAngleH/2) * AspectRatio)* 2;
)";
constexpr std::string_view kInitApp = "void initApp\n const int SIZE = 4.5;\n}\n";
constexpr std::string_view kFragmentShader = R"(#version 430
in vec4 fColor;
void main(){
 gl_FragColor=fColor;
}
)";

int countOf(std::string_view text, std::string_view what)
{
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + what.size()))
        ++count;
    return count;
}

std::string withInstead(std::string_view text, std::string_view from, std::string_view to)
{
    std::string changed(text);
    return changed.replace(changed.find(from), from.size(), to);
}

/// The number of the third program's names in a text that does not declare them.
int undeclaredIn(const std::string &text)
{
    int count = 0;
    for (const std::string name : {"nearz", "farz", "ViewAngleH", "ViewAngleV"})
        count += countOf(text, name) > 0 && countOf(text, "float " + name) == 0 ? 1 : 0;
    return count;
}

void errorsOfThePaper(Errata &errors)
{
    // Off the middle, so that nothing is 0 or hidden by symmetry.
    const Setup frustum = pictureBy(Frustum{-1, 3, -2, 1, 2, 10}, kFromOrigin);
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

    const Setup before = pictureBy(Perspective{kRightAngle, 4.0 / 3.0, 1, 100}, kFromFive);
    errors.add("error-weng-x-axis", "the side of the middle that x lies on", -1, 1,
               std::copysign(1.0, windowFromWorld(before, WorldPoint(1, 0, 0)).value().x - 400));
    const WindowPoint foot = windowFromWorld(before, WorldPoint(0, 0, 0)).value(),
                      tip = windowFromWorld(before, WorldPoint(0, 1, 0)).value();
    errors.add("error-weng-y-axis", "how far up a unit of the y axis leads, over its length", 0, 1,
               (tip.y - foot.y) / std::hypot(tip.x - foot.x, tip.y - foot.y));
    errors.add("error-weng-look-at", "z of the direction, from (0, 0, 5) to the origin", 1, -1,
               eyeFrame(kFromFive).value().forward.z);

    const EyePoint projected = unprojectedAt(frustum, {at.x, at.y, 0.0}).eye[Method::Formula].value();
    errors.add("error-weng-near", "z of the point on the near plane, n = 2", 2, -2, projected.z);

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

    // Expected by hand: (13) solved for d, 10 (4 - 2) / (4 (10 - 2)).
    errors.add("error-weng-depth", "depth of z = -4 between 2 and 10", 0, 0.625, at.z);
    // A point straight ahead of the eye, whose axes figure 2 shows, is at 0; the viewport's origin,
    // of figure 5, is a corner.
    const auto ndcX = [&before](const WindowPoint &point) { return ndcFromWindow(before.viewport, {}, point).x; };
    errors.add("error-weng-figure", "NDC x of where x_v = 0",
               ndcX(windowFromWorld(before, WorldPoint(0, 0, 0)).value()), -1, ndcX(WindowPoint(0, 0, 0)));

    // A rectangle whose top is 40: its height is still 600.
    errors.add("error-weng-bottom", "y_v by the bottom of a rectangle from 40 to 640", 640 - 20.5, 579.5,
               flippedY(surface, 20.5));

    const Setup aside = pictureBy(Perspective{kRightAngle, 4.0 / 3.0, 1, 100}, kFromAside);
    const Unprojected origin = unprojectedAt(aside, windowFromWorld(aside, WorldPoint(0, 0, 0)).value());
    errors.add("error-weng-eye", "z of the world's origin", origin.eye[Method::Formula].value().z, 0,
               origin.world[Method::Formula].value().z);

    // A view whose upper left corner is 200 below the screen's.
    errors.add("error-weng-client", "y_v by the position on the screen", flippedY(surface, 200 + 20.5), 579.5,
               flippedY(surface, 20.5));
}

void errorsOfZhangci(Errata &errors)
{
    const Pipeline modelView = pipelineOf("zhangci-model-view");
    errors.add("error-zhangci-product", "m[14]", element(forward(modelView, PipelineStage::ViewMatrix), 14), -8,
               element(forward(modelView, PipelineStage::ModelviewMatrix), 14));

    const Pipeline box = pipelineOf("zhangci-ortho");
    const auto corners = viewVolumeCorners(box.setup.projection());
    errors.add("error-zhangci-cube", "side of glOrtho(-10 .. 10)", 10, 20, distance(corners[0], corners[1]));
    errors.add("error-zhangci-cube", "side when normalised", 1, 2,
               distance(pointsFrom(box, {corners[0]}).ndc.value(), pointsFrom(box, {corners[1]}).ndc.value()));
    const double n = -10, f = 10;
    errors.add("error-zhangci-ortho", "m[10]", -2 / (n - f), -0.1,
               element(forward(box, PipelineStage::ProjectionMatrix), 10));
    // Its third row ends in a term of the second row, and in no fraction of f - n.
    const double low = -2, high = 1, nearZ = 2, farZ = 10;
    errors.add("error-zhangci-ortho", "m[14] of glOrtho(-1, 3, -2, 1, 2, 10)", (high - low) / (farZ + nearZ), -1.5,
               element(clipFromEye(Ortho{-1, 3, low, high, nearZ, farZ}).value(), 14));
    errors.add("error-zhangci-perspective", "m[14]", -2 * 1.0 * 100.0 / (1.0 - 100.0), -200.0 / 99.0,
               element(forward(pipelineOf("zhangci-perspective"), PipelineStage::ProjectionMatrix), 14));
    errors.add("error-zhangci-depth", "depth of the NDC 0.5", 0.5, 0.75,
               windowFromNdc(Viewport{0, 0, 50, 50}, DepthRange{}, NdcPoint(0, 0, 0.5)).z);

    // Figure 2.13's own viewport, 400 x 300 at (400, 0) of 800 x 600, clicked at its middle: from
    // the top, row 450.
    const Setup quarter = pipelineOf("zhangci-viewport-quarter").setup;
    const DevicePixel pixel{600, 450};
    const OtherClick click = clickOf(OtherProgram::Screen2World, quarter, pixel);
    errors.add("error-zhangci-height", "winY", windowFromDevice(quarter.surface, click.position, 0.0).y, 150,
               windowFromDevice(quarter.surface, DevicePoint(pixel.i, pixel.j), 0.0).y);
    errors.add("error-zhangci-height", "the row whose depth screen2world reads",
               framebufferRow(quarter.surface, click.depthFrom), 149, framebufferRow(quarter.surface, pixel));

    // The figure's point (1, 1, 0), which its translation takes to z = -3 in the world.
    const PipelinePoints back =
        pointsBackward(modelView, pointsForward(modelView, ObjectPoint(1, 1, 0)).window.value());
    const glm::dmat4 clipFromObject =
        forward(modelView, PipelineStage::ProjectionMatrix) * forward(modelView, PipelineStage::ModelviewMatrix);
    errors.add(
        "error-zhangci-object", "z by gluUnProject with GL_MODELVIEW",
        unprojectByInverse<ObjectSpace>(clipFromObject, modelView.setup.viewport, DepthRange{}, *back.window).value().z,
        -3, back.world->z);
}

void errorsOfProjectionDerivation(Errata &errors)
{
    const auto m0 = [](const char *id) { return element(forward(pipelineOf(id), PipelineStage::ProjectionMatrix), 0); };
    errors.add("error-derivation-three", "m[0] of gluPerspective is that of the matrix", m0("derivation-matrix"), 0.75,
               m0("derivation-perspective"));
    errors.add("error-derivation-three", "m[0] of gluPerspective is that of glFrustum", m0("derivation-frustum"), 0.75,
               m0("derivation-perspective"));
    // The circle of radius 5 around (-8, 0, -20).
    const auto widthOverHeight = [](const char *id) {
        const Setup setup = pipelineOf(id).setup;
        const auto at = [&setup](double x, double y) { return windowFromWorld(setup, WorldPoint(x, y, -20)).value(); };
        return (at(-3, 0).x - at(-13, 0).x) / (at(-8, 5).y - at(-8, -5).y);
    };
    for (const char *id : {"derivation-matrix", "derivation-frustum"})
        errors.add("error-derivation-three", "width over height of the circle, as by gluPerspective",
                   widthOverHeight("derivation-perspective"), 16.0 / 9.0, widthOverHeight(id));
    const auto degrees = [](double tangentOfHalf) { return 2.0 * std::atan(tangentOfHalf) * 180.0 / std::numbers::pi; };
    const double angleH = 90, angleV = degrees(std::tan(kRightAngle / 2.0) * 600.0 / 800.0); // as the program has them
    const auto frustum = std::get<Frustum>(*sceneOfExample("derivation-frustum").projection);
    errors.add("error-derivation-three", "the horizontal angle, called H", angleH, degrees(0.75),
               degrees(frustum.right / frustum.nearDistance));
    errors.add("error-derivation-three", "the vertical angle, called V", angleV, 90,
               degrees(frustum.top / frustum.nearDistance));
    errors.add("error-derivation-translate", "z of the apex", -20, -10,
               pointsForward(pipelineOf("derivation-matrix"), ObjectPoint(0, 0, -20)).eye.value().z);
    errors.add("error-derivation-undeclared", "names that nothing declares", undeclaredIn(std::string(kThirdProgram)),
               0, undeclaredIn(std::string(kDeclarations) + std::string(kThirdProgram)));
}

void errorsOfOpenCascade(Errata &errors)
{
    // e = (3, 4, 12), 13 from the origin; u is s here, v is u and n is -f.
    const glm::dmat4 view = eyeFromWorld(eyeFrame(kFromAside).value());
    errors.add("error-opencascade-model-view", "-e u, printed as -ex", -3, 0, element(view, 12));
    errors.add("error-opencascade-model-view", "-e n, printed as -ez", -12, -13, element(view, 14));
    const Pipeline modelView = pipelineOf("zhangci-model-view");
    const glm::dvec4 world(1, 1, -3, 1);
    errors.add("error-opencascade-world", "z of (1, 1, -3) for the eye",
               (forward(modelView, PipelineStage::ModelviewMatrix) * world).z, -8,
               (forward(modelView, PipelineStage::ViewMatrix) * world).z);
    const glm::dmat4 ortho = clipFromEye(Ortho{-1, 3, -2, 1, 2, 10}).value();
    errors.add("error-opencascade-ortho", "m[12]", (3.0 + -1.0) / (3.0 - -1.0), -0.5, element(ortho, 12));
    errors.add("error-opencascade-ortho", "m[13]", (1.0 + -2.0) / (1.0 - -2.0), 1.0 / 3.0, element(ortho, 13));
    const double zNear = -1, zFar = -100; // signed, as it has them
    errors.add("error-opencascade-perspective", "m[14]", 2 * zNear * zFar / (zNear - zFar), -200.0 / 99.0,
               element(clipFromEye(Perspective{kRightAngle, 1, 1, 100}).value(), 14));
    // Its fourth row repeats the third's denominators: (z_near - z_far)/-1 and, over 0, no number.
    errors.add("error-opencascade-perspective", "m[11]", (zNear - zFar) / -1.0, -1,
               element(clipFromEye(Perspective{kRightAngle, 1, 1, 100}).value(), 11));
    errors.add("error-opencascade-perspective", "m[15]", std::numeric_limits<double>::infinity(), 0,
               element(clipFromEye(Perspective{kRightAngle, 1, 1, 100}).value(), 15));
    // BuildNorm2ViewportMatrix, and the matrix of the text.
    const double y = 0.5, byTheCode = (0 - 300) / 2.0 * y + (300 + 0) / 2.0;
    errors.add("error-opencascade-viewport", "y in the window of the NDC 0.5", byTheCode, 225,
               windowFromNdc(Viewport{0, 0, 300, 300}, DepthRange{}, NdcPoint(0, y, 0)).y);
    // A row vector times a matrix that is set for columns.
    const glm::dmat4 viewport = windowFromNdc(Viewport{0, 0, 300, 300}, DepthRange{});
    const glm::dvec4 middle(0, 0, 0, 1);
    errors.add("error-opencascade-rows", "x in the window of NDC's middle", (middle * viewport).x, 150,
               (middle * glm::transpose(viewport)).x);
    // Figure 4.1's pixel with the near plane's depth: 1 from the eye, which our example has at (0,
    // 0, 100). Seen from aside, x differs as well: 3 - 3/13.
    errors.add("error-opencascade-depth", "z of the pixel (150, 150) with the depth 0", 0, 99,
               pointsBackward(pipelineOf("opencascade-round-trip"), WindowPoint(150, 150, 0)).world.value().z);
    const Setup aside = pictureBy(Perspective{kRightAngle, 4.0 / 3.0, 1, 100}, kFromAside);
    errors.add("error-opencascade-depth", "x of the origin's pixel with the depth 0, from aside", 0, 36.0 / 13.0,
               unprojectedAt(aside, WindowPoint(400, 300, 0)).world[Method::Formula].value().x);
}

void errorsOfParallelProjection(Errata &errors)
{
    const Pipeline square = pipelineOf("parallel-orthographic");
    const glm::dmat4 ortho = forward(square, PipelineStage::ProjectionMatrix);
    const auto corners = viewVolumeCorners(square.setup.projection());
    errors.add("error-parallel-range", "z of the box's middle", (2.0 + 9.0) / 2.0, -5.5,
               (corners[0].z + corners[4].z) / 2.0);
    glm::dmat4 flip(1.0);
    flip[2][2] = -1.0;
    const glm::dmat4 scaledAndMoved = flip * ortho; // its M = S T
    errors.add("error-parallel-flip", "m[14]", element(scaledAndMoved * flip, 14), -11.0 / 7.0, element(ortho, 14));

    const Pipeline oblique = pipelineOf("parallel-oblique");
    const double cot = 1.0 / std::tan(0.78);
    errors.add("error-parallel-way", "the way along x at z = -3", cot, -3.0 * cot,
               10.0 * pointsForward(oblique, ObjectPoint(4.5, 4.5, -3)).ndc.value().x - 4.5);
    errors.add("error-parallel-init", "braces that close, without one that opens",
               countOf(kInitApp, "}") - countOf(kInitApp, "{"), 0, [] {
                   const std::string right = withInstead(kInitApp, "initApp", "initApp() {");
                   return countOf(right, "}") - countOf(right, "{");
               }());
    const double size = 4.5;
    errors.add("error-parallel-size", "SIZE", size, static_cast<int>(size),
               double(sceneOfExample("parallel-orthographic").objects.at(0).model->bounds.highest.x));

    const int n = 2, f = 9, quotient = -(n + f) / (f - n); // as its shader has them
    errors.add("error-parallel-integers", "m[14]", quotient, -11.0 / 7.0, element(ortho, 14));
    errors.add("error-parallel-integers", "z of the square's NDC", -2.0 / (f - n) * -4.0 + quotient, -3.0 / 7.0,
               pointsForward(square, ObjectPoint(4, 4, -4)).ndc.value().z);
    const std::string shader = withInstead(withInstead(kFragmentShader, "gl_FragColor", "color"), "in vec4 fColor;",
                                           "in vec4 fColor;\nout vec4 color;");
    errors.add("error-parallel-output", "outputs that the fragment shader declares",
               countOf(kFragmentShader, "out vec4"), 1, countOf(shader, "out vec4"));
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

} // namespace

class TestSourceErrors : public QObject {
    Q_OBJECT

private slots:
    void anErrorIsOne_data()
    {
        addColumn<double>("printed");
        addColumn<double>("right");
        addColumn<double>("computed");
        for (const Erratum &error : errorsOfAll().all)
            addRow("%s: %s", error.anchor, error.what) << error.printed << error.right << error.computed;
    }

    void anErrorIsOne()
    {
        QFETCH(double, printed);
        QFETCH(double, right);
        QFETCH(double, computed);
        QVERIFY(isNear(computed, right, kRoundTrip));
        QVERIFY2(std::abs(printed - right) > 1e-3, "what is printed is right");
    }

    void everyErrorOfHelpIsShown()
    {
        const Errata errors = errorsOfAll();
        std::vector<std::string> shown;
        for (const Erratum &error : errors.all) {
            if (shown.empty() || shown.back() != error.anchor)
                shown.emplace_back(error.anchor);
        }
        QVERIFY(shown == std::vector<std::string>(kErrata.begin(), kErrata.end()));
    }
};

UNPROJECTOR_TEST(TestSourceErrors)
#include "test_source_errors.moc"
