// The cost of 500 placed points on a mesh of a million triangles. The sum must stay below a frame,
// 16.7 ms; the mesh itself is not drawn again for them.
//
//   QT_QPA_PLATFORM=offscreen bench_points

#include "gui/document/camera_looks.h"
#include "gui/document/landmark_placing.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/landmark_marks.h"
#include "tests/support/hills.h"

#include <benchmark/benchmark.h>

#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace {

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using landmarks::Landmark;

constexpr int kWidth = 1280, kHeight = 800;
constexpr std::size_t kPoints = 500;

/// The hills with their points, made once.
SceneDocument &document()
{
    static SceneDocument *made = [] {
        auto *fresh = new SceneDocument(qApp);
        fresh->setSurface({kWidth, kHeight, 1.0});
        openObjects(*fresh, {{"hills", {}, hills(), {}}},
                    {WorldPoint(0.0, -4.5, 3.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 0.0, 1.0}});
        fresh->picks().rayCasters().complete(fresh->objects());
        std::mt19937 random(1);
        std::vector<Landmark> landmarks;
        while (landmarks.size() < kPoints) {
            const auto at =
                landmarkOnSurface(*fresh, {double(random() % kWidth) + 0.5, double(random() % kHeight) + 0.5});
            if (at)
                landmarks.push_back(*at);
        }
        const Check placed = editLandmarks(*fresh, std::move(landmarks), {QStringLiteral("points")});
        Q_ASSERT(placed.hasValue());
        return fresh;
    }();
    return *made;
}

/// Decides which points are behind the surface, after the camera has moved.
void marks(benchmark::State &state)
{
    SceneDocument &points = document();
    for (auto _ : state)
        benchmark::DoNotOptimize(landmarkMarks(points));
}

void labels(benchmark::State &state)
{
    const std::vector<LandmarkMark> shown = landmarkMarks(document());
    const QFontMetricsF metrics{QFont()};
    for (auto _ : state)
        benchmark::DoNotOptimize(placedLabels(shown, metrics, QRectF(0, 0, kWidth, kHeight)));
}

/// Draws by the processor alone; the view has the graphics card do it.
void drawing(benchmark::State &state)
{
    const std::vector<LandmarkMark> shown = landmarkMarks(document());
    const std::vector<PlacedLabel> placed = placedLabels(shown, QFontMetricsF{QFont()}, QRectF(0, 0, kWidth, kHeight));
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    for (auto _ : state) {
        QPainter painter(&image);
        drawLandmarks(painter, shown, placed);
    }
}

/// One step of a drag: onto the mesh, into the document, with the undo stack.
void drag(benchmark::State &state)
{
    SceneDocument &points = document();
    int step = 0;
    for (auto _ : state) {
        ++step;
        const DevicePoint to(double(kWidth / 2 + step % 100), double(kHeight / 2 + step % 37));
        if (const auto there = landmarkOnMesh(points, to))
            static_cast<void>(points.sceneLandmarks().move(0, *there, QStringLiteral("drag")));
    }
}

BENCHMARK(marks)->Unit(benchmark::kMillisecond);
BENCHMARK(labels)->Unit(benchmark::kMillisecond);
BENCHMARK(drawing)->Unit(benchmark::kMillisecond);
BENCHMARK(drag)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char **argv)
{
    const QGuiApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
