// The time from a move of the pointer to the next frame, while landmarks are placed on a mesh of a
// million triangles: without landmarks and with 500. Both the loupe and the marks are drawn. A frame
// of 60 a second takes 16.7 ms.
// - `cpu_ms` is the time on all cores together, which other load of the machine changes less.
//
//   xvfb-run -s "-screen 0 1280x1024x24 +extension GLX" bench_hover

#include "core/geometry/camera_motion.h"
#include "gui/document/camera_looks.h"
#include "gui/document/landmark_placing.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/landmark_tool.h"
#include "gui/shell/main_window.h"
#include "gui/view/scene_view.h"
#include "tests/support/hills.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMouseEvent>

#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using landmarks::Landmark;

/// @return whether it came true within two minutes
bool waitFor(const std::function<bool()> &isTrue)
{
    QElapsedTimer clock;
    clock.start();
    while (!isTrue() && clock.elapsed() < 120'000)
        QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 10);
    return isTrue();
}

/// A window that shows the hills with named landmarks; null if it cannot be shown.
std::unique_ptr<MainWindow> windowWith(std::size_t count)
{
    MainWindow::Options options;
    options.remembers = false;
    auto window = std::make_unique<MainWindow>(options);
    window->resize(1280, 800);
    window->show();
    if (!waitFor([&] { return window->view().isReady(); }))
        return nullptr;
    SceneDocument &document = window->document();
    openObjects(document, {{"hills", {}, hills(), {}}},
                {WorldPoint(0.0, -4.5, 3.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 0.0, 1.0}});
    document.picks().rayCasters().complete(document.objects());
    std::mt19937 random(1);
    const Surface surface = document.setup().surface;
    std::vector<Landmark> landmarks;
    while (landmarks.size() < count) {
        const DevicePoint at(double(random() % unsigned(surface.widthPixels)) + 0.5,
                             double(random() % unsigned(surface.heightPixels)) + 0.5);
        if (std::optional<Landmark> there = landmarkOnSurface(document, at)) {
            there->name = "landmark " + std::to_string(landmarks.size());
            landmarks.push_back(*there);
        }
    }
    static_cast<void>(editLandmarks(document, std::move(landmarks), {QStringLiteral("landmarks")}));
    QElapsedTimer clock;
    clock.start();
    waitFor([&] { return clock.elapsed() > 3000 && !window->view().isCoarse(); });
    return window;
}

/// @param move  does the i-th step, after which the view paints
void measure(benchmark::State &state, MainWindow &window, const std::function<void(int)> &move)
{
    bool isSwapped = false;
    QObject::connect(&window.view(), &QOpenGLWidget::frameSwapped, &window, [&] { isSwapped = true; });
    int step = 0;
    const std::clock_t begin = std::clock(); // of all threads
    for (auto _ : state) {
        isSwapped = false;
        move(++step);
        waitFor([&] { return isSwapped; });
    }
    state.counters["cpu_ms"] =
        static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC * 1e3 / static_cast<double>(step);
}

void hover(benchmark::State &state)
{
    const std::unique_ptr<MainWindow> window = windowWith(static_cast<std::size_t>(state.range(0)));
    if (!window) {
        state.SkipWithError("the window is not seen");
        return;
    }
    window->findChild<LandmarkTool *>()->setPlacing(true);
    SceneView &view = window->view();
    measure(state, *window, [&view](int step) {
        const QPointF at(double(view.width()) / 2.0 + step % 97, double(view.height()) / 2.0 + step % 31);
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &move);
    });
}

/// Turns the view by small steps.
void turn(benchmark::State &state)
{
    const std::unique_ptr<MainWindow> window = windowWith(static_cast<std::size_t>(state.range(0)));
    if (!window) {
        state.SkipWithError("the window is not seen");
        return;
    }
    SceneDocument &document = window->document();
    measure(state, *window, [&document](int) {
        const LookAt camera = *document.scene().camera;
        setCamera(document, orbited(camera, camera.center, 0.005, 0.0), QStringLiteral("turn"));
    });
}

} // namespace

BENCHMARK(hover)->Arg(0)->Arg(500)->Unit(benchmark::kMillisecond)->Iterations(100)->UseRealTime();
BENCHMARK(turn)->Arg(0)->Arg(500)->Unit(benchmark::kMillisecond)->Iterations(100)->UseRealTime();

int main(int argc, char **argv)
{
    QSurfaceFormat::setDefaultFormat(FrameView::preCreateWindow());
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
