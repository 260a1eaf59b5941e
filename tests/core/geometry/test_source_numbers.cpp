// The numbers that the originals print, each with the program's own, to the digits printed. The
// paper of Weng, Huang and Cai prints none. Errors of the originals are in test_source_errors.

#include "tests/support/test.h"

#include "core/geometry/view_volume.h"
#include "core/pipeline/matrix_factors.h"
#include "tests/core/geometry/source_examples.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace source_examples;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::unproject;

namespace {

/// A number with as many decimals as the printed one. A debugger's 0 has a sign, one that is set
/// has none.
std::string asPrinted(double number, const std::string &printed)
{
    constexpr int kDebugger = 7; // decimals, at least
    const std::size_t point = printed.find('.');
    const int decimals = point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
    const std::string result = text.data();
    const bool isMinusZero = result.find_first_of("123456789") == std::string::npos && result[0] == '-';
    return isMinusZero && decimals < kDebugger ? result.substr(1) : result;
}

void row(const std::string &place, const char *printed, double computed)
{
    newRow(place.c_str()) << QByteArray(printed) << computed;
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

/// A matrix as printed, row by row. For a 3 x 3 matrix of the plane, the row and column of z are
/// left out.
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

/// A mesh's corners in the order that its indices are printed in, each as its vertex is printed.
void vertices(const std::string &place, const char *example, const std::vector<std::vector<const char *>> &printed,
              const std::vector<std::size_t> &indices)
{
    const std::vector<glm::vec3> &corners = sceneOfExample(example).objects.at(0).model->meshes.at(0).positions;
    if (corners.size() != indices.size())
        qFatal("%s has %zu corners and not %zu.", example, corners.size(), indices.size());
    for (std::size_t k = 0; k < indices.size(); ++k)
        rows(place + ", corner " + std::to_string(k) + ", vertex " + std::to_string(indices[k]), printed[indices[k]],
             glm::dvec4(corners[k], 1.0));
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
    const PipelinePoints points = pointsFrom(plane, sceneOfExample("zhangci-2d").givenPoint.value());
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

    // Onto the plane z = 0, along the view: the window point of (1, 1, 5) taken back with the
    // plane's own depth.
    const Setup box = pictureBy(Ortho{-10, 10, -10, 10, 0, 10}, kFromFive);
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
             "0.00000000", "0.00000000", "0.00000000", "-0.10000000", "0.00000000", "-0.00000000", "-0.00000000",
             "-0.00000000", "1.00000000"},
            ortho);
    watched("zhangci fig 2.12",
            {"2.4142137", "0.00000000", "0.00000000", "0.00000000", "0.00000000", "2.4142137", "0.00000000",
             "0.00000000", "0.00000000", "0.00000000", "-1.0202020", "-1.0000000", "0.00000000", "0.00000000",
             "-2.0202019", "0.00000000"},
            forward(pipelineOf("zhangci-perspective"), PipelineStage::ProjectionMatrix));

    // Its depth is among the errors.
    const PipelinePoints middle =
        pointsFrom(pipelineOf("zhangci-viewport-50"), sceneOfExample("zhangci-viewport-50").givenPoint.value());
    rows("zhangci 2.3 the NDC", {"0", "0", "0.5"}, glm::dvec4(middle.ndc->coordinates(), 1.0));
    rows("zhangci 2.3 in a window of 50 x 50", {"25", "25"}, glm::dvec4(middle.window->coordinates(), 1.0));
    for (const auto &[printed, ndc] : {std::pair("0", -1.0), std::pair("1", 1.0)})
        row(std::string("zhangci 2.3 an end of the depth buffer, ") + printed, printed,
            windowFromNdc(Viewport{0, 0, 50, 50}, DepthRange{}, NdcPoint(0, 0, ndc)).z);
    const glm::dmat4 viewport = forward(pipelineOf("zhangci-viewport-50"), PipelineStage::ViewportMatrix);
    rows("zhangci 2.3 M_viewport, row 3", {"0", "0", "0.5", "0.5"}, glm::row(viewport, 2));
    rows("zhangci 2.3 M_viewport, row 4", {"0", "0", "0", "1"}, glm::row(viewport, 3));
    const Viewport quarter = pipelineOf("zhangci-viewport-quarter").setup.viewport;
    rows("zhangci fig 2.13 glViewport(width/2, 0, width/2, height/2) of 800 x 600", {"400", "0", "400", "300"},
         {quarter.x, quarter.y, quarter.width, quarter.height});
}

void projectionDerivation()
{
    const Pipeline matrix = pipelineOf("derivation-matrix");
    for (const ClipPoint &clip : {ClipPoint(1, 4, 7, 1), ClipPoint(2, 8, 14, 2), ClipPoint(-0.1, -0.4, -0.7, -0.1)})
        rows("derivation homogeneous, w " + std::to_string(clip.w), {"1", "4", "7"},
             glm::dvec4(pointsFrom(matrix, {clip}).ndc.value().coordinates(), 1.0));
    rows("derivation (1, 4, 7, 0), a vector, translated", {"1", "4", "7", "0"},
         forward(matrix, PipelineStage::ModelMatrix) * glm::dvec4(1, 4, 7, 0));
    // Two linear scales: half way from 0 to 100 is half way from 5 to 90, as NDC come to a
    // viewport.
    row("derivation the broken thermometer", "47.5", windowFromNdc(Viewport{5, 0, 85, 1}, {}, NdcPoint(0, 0, 0)).x);

    for (const char *id : {"derivation-matrix", "derivation-perspective", "derivation-frustum"}) {
        const Pipeline program = pipelineOf(id);
        rows(std::string(id) + " last row", {"0", "0", "-1", "0"},
             glm::row(forward(program, PipelineStage::ProjectionMatrix), 3));
        row(std::string(id) + " z = -N", "-1", pointsFrom(program, {EyePoint(0, 0, -5)}).ndc.value().z);
        row(std::string(id) + " z = -F", "1", pointsFrom(program, {EyePoint(0, 0, -80000)}).ndc.value().z);
        rows(std::string(id) + " translated by", {"0", "0", "10"}, forward(program, PipelineStage::ModelMatrix)[3]);
        vertices(std::string(id) + " fan", id, {{"0", "0", "-20"}, {"30", "20", "-40"}, {"40", "10", "-30"}},
                 {0, 1, 2});
        const ProjectionWindow window = projectionWindow(program.setup.projection());
        row(std::string(id) + " nearz", "5.0", window.nearDistance);
        row(std::string(id) + " farz", "80000", window.farDistance);
        const Projection symmetric = converted(program.setup.projection(), ProjectionKind::Perspective, 5);
        row(std::string(id) + " angle", "90.0", std::get<Perspective>(symmetric).verticalFov.degrees());
    }
    // Expected by hand for 800 x 600: 1 / tan(ViewAngleV / 2) = 4/3, times AspectRatio = 3/4;
    // -80005/79995; -800000/79995.
    for (const auto &[id, m0] :
         {std::pair("derivation-matrix", "1.3333333"), std::pair("derivation-frustum", "1.3333333"),
          std::pair("derivation-perspective", "0.7500000")}) {
        const glm::dmat4 projection = forward(pipelineOf(id), PipelineStage::ProjectionMatrix);
        for (const auto &[index, printed] : {std::pair(0, m0), std::pair(5, "1.0000000"), std::pair(10, "-1.0001250"),
                                             std::pair(11, "-1.0000000"), std::pair(14, "-10.0006250")})
            row(std::string(id) + " m[" + std::to_string(index) + "]", printed, element(projection, index));
    }

    // "1, 640/480": a square is none in the CVV, whose sides are equal, and is one again in a
    // viewport of that aspect.
    const Setup wide{
        {640, 480, 1.0}, {0, 0, 640, 480}, {}, Perspective{kRightAngle, 640.0 / 480.0, 5, 80000}, kFromOrigin};
    const Pipeline unturned = pipelineOf(wide, glm::dmat4(1.0)).value();
    const PipelinePoints low = pointsFrom(unturned, {EyePoint(-1, -1, -10)}),
                         high = pointsFrom(unturned, {EyePoint(1, 1, -10)});
    const auto aspectOf = [](const auto &from, const auto &to) { return (to.y - from.y) / (to.x - from.x); };
    row("derivation 640/480, a square in the CVV", "1.3333333", aspectOf(*low.ndc, *high.ndc));
    row("derivation 640/480, a square in the viewport", "1.0000000", aspectOf(*low.window, *high.window));
}

void openCascade()
{
    const PipelinePoints points =
        pointsFrom(pipelineOf("opencascade-round-trip"), sceneOfExample("opencascade-round-trip").givenPoint.value());
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
    // The flat projection of its first matrix, z = 0: the part of an eye point that reaches the
    // window.
    const Setup box = pictureBy(Ortho{-9, 9, -9, 9, 0, 9}, kFromOrigin);
    const WindowPoint at = windowFromWorld(box, WorldPoint(2, 5, -4)).value();
    rows(
        "parallel diag(1, 1, 0, 1)", {"2", "5", "0"},
        glm::dvec4(unprojectedAt(box, WindowPoint(at.x, at.y, 0.0)).world[Method::Formula].value().coordinates(), 1.0));

    // Its two example rows: the shares of x, y, z and w in the new x.
    for (const auto &[name, printed, numbers] :
         {std::tuple("(2, 5, 0.5, 2)", std::vector{"2", "5", "0.5", "2"}, glm::dvec4(2, 5, 0.5, 2)),
          std::tuple("(0, 1, 0, 0)", std::vector{"0", "1", "0", "0"}, glm::dvec4(0, 1, 0, 0))}) {
        glm::dmat4 given(1.0);
        given[0][1] = 1.0; // of y: so that it has an inverse
        for (int column = 0; column < 4; ++column)
            given[column][0] = numbers[column];
        const Pipeline byMatrix = pipelineOf(box, given).value();
        const auto x = [&byMatrix](double ox, double oy, double oz) {
            return pointsForward(byMatrix, ObjectPoint(ox, oy, oz)).world.value().x;
        };
        const double w = x(0, 0, 0);
        rows(std::string("parallel the row ") + name, printed,
             glm::dvec4(x(1, 0, 0) - w, x(0, 1, 0) - w, x(0, 0, 1) - w, w));
    }

    // The side of the CVV, and the corners of the square in it: (4/9, 4/9).
    const Pipeline square = pipelineOf("parallel-orthographic");
    row("parallel side of the CVV", "2",
        pointsFrom(square, {EyePoint(9, 0, -2)}).ndc.value().x
            - pointsFrom(square, {EyePoint(-9, 0, -2)}).ndc.value().x);
    row("parallel the near plane, z", "-2", viewVolumeCorners(square.setup.projection())[0].z);
    row("parallel the far plane, z", "-9", viewVolumeCorners(square.setup.projection())[4].z);
    const glm::dmat4 ortho = forward(square, PipelineStage::ProjectionMatrix);
    // The elements of its T and S, by hand: (near + far)/2, 2/18 and 2/7.
    for (const MatrixFactor &factor : factors(square.setup.projection()).value()) {
        if (factor.step == MatrixStep::MoveBox)
            rows("parallel program 1, T", {"0", "0", "5.5"}, factor.matrix[3]);
        else if (factor.step == MatrixStep::ScaleBox)
            rows("parallel program 1, S", {"0.1111111", "0.1111111", "0.2857143"},
                 {factor.matrix[0][0], factor.matrix[1][1], factor.matrix[2][2], 1.0});
    }
    vertices("parallel program 1", "parallel-orthographic",
             {{"-4", "4", "-4"}, {"4", "4", "-4"}, {"4", "-4", "-4"}, {"-4", "-4", "-4"}}, {0, 3, 1, 2, 1, 3});
    vertices(
        "parallel program 2", "parallel-oblique",
        {{"-4.5", "-4.5", "-3"},
         {"-4.5", "-4.5", "-4.5"},
         {"-4.5", "4.5", "-3"},
         {"4.5", "-4.5", "-3"},
         {"4.5", "4.5", "-4.5"},
         {"-4.5", "4.5", "-4.5"},
         {"4.5", "-4.5", "-4.5"},
         {"4.5", "4.5", "-3"}},
        {1, 0, 2, 1, 2, 5, 0, 3, 7, 0, 7, 2, 3, 6, 4, 3, 4, 7, 6, 1, 5, 6, 5, 4, 2, 7, 4, 2, 4, 5, 0, 1, 6, 0, 6, 3});
    // The elements that its text derives, by hand: 2/18, -2/7, -11/7.
    matrix<16>("parallel program 1",
               {"0.1111111", "0", "0", "0", "0", "0.1111111", "0", "0", "0", "0", "-0.2857143", "-1.5714286", "0", "0",
                "0", "1"},
               ortho);
    // Expected by hand: 0.1 cot 0.78; with pi/4 it would be 0.1.
    matrix<16>("parallel program 2",
               {"0.1", "0", "0.1010855", "0", "0", "0.1", "0.1010855", "0", "0", "0", "-0.2857143", "-1.5714286", "0",
                "0", "0", "1"},
               forward(pipelineOf("parallel-oblique"), PipelineStage::ProjectionMatrix));
}

/// The additional examples of Help.
void help()
{
    // projection-derivation: 90 degrees across at 800 x 600, right / near = 1, top / near = 3 / 4.
    const Projection wide = Frustum{-5, 5, -3.75, 3.75, 5, 80000};
    row("help, the vertical angle to 90 degrees across", "73.74",
        std::get<Perspective>(converted(wide, ProjectionKind::Perspective, 5)).verticalFov.degrees());
    // x + y = 1 under glScale(2, 1, 1): (1/2, 1, 0) of length 1, and not (2, 1, 0).
    const LookAt camera{WorldPoint(8, 8, 0), WorldPoint(1, 0.5, 0), {0, 0, 1}};
    const auto hit = hitOn({{0, 1, -5}, {1, 0, -5}, {1, 0, 5}, {0, 1, 5}}, {Scale{{2, 1, 1}}},
                           pictureBy(Perspective{kRightAngle, 4.0 / 3.0, 1, 100}, camera), DevicePoint(400, 300));
    const WorldVector normal = hit->triangle->normal;
    const double length = std::copysign(std::hypot(0.5, 1.0), normal.x); // either side of the surface
    rows("help, the normal under glScale(2, 1, 1)", {"0.5", "1.0", "0.0"},
         glm::dvec4(normal.coordinates() * length, 0.0));
    // The drawn length of an edge into the depth: cavalier, cabinet, and the program of
    // parallel-projection.
    for (const auto &[printed, angle] : {std::pair("1.00", radiansFromDegrees(54.74)),
                                         std::pair("0.50", radiansFromDegrees(70.53)), std::pair("1.43", 0.78)}) {
        const glm::dmat4 oblique = clipFromEye(Oblique{{-1, 1, -1, 1, 2, 9}, angle, angle}).value();
        row(std::string("help, an oblique edge, ") + printed, printed, glm::length(glm::dvec2(oblique[2])));
    }
}

} // namespace

class TestSourceNumbers : public QObject {
    Q_OBJECT

private slots:
    void whatIsPrintedIsComputed_data()
    {
        addColumn<QByteArray>("printed");
        addColumn<double>("computed");
        zhangciInThePlane();
        zhangciInSpace();
        projectionDerivation();
        openCascade();
        parallelProjection();
        help();
    }

    void whatIsPrintedIsComputed()
    {
        QFETCH(QByteArray, printed);
        QFETCH(double, computed);
        QCOMPARE(QByteArray::fromStdString(asPrinted(computed, printed.toStdString())), printed);
    }
};

UNPROJECTOR_TEST(TestSourceNumbers)
#include "test_source_numbers.moc"
