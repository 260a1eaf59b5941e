// The speed of turning the view around a model in a file, in the window with its panels.
// - `of_limit` is the share of the goal without a GPU: 20 frames a second for 10 million triangles
//   and 30 for a million.
// - `cpu_ms` is the time of a frame on all cores together, which other load of the machine changes
//   less.
// - `whole_again_ms` is the time that the view rests until the model itself is drawn again.
//
//   make_models models 913 &&
//   xvfb-run -s "-screen 0 1280x1024x24 +extension GLX" bench_orbit models/*.ply

#include "core/geometry/camera_motion.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/shell/main_window.h"
#include "gui/view/scene_view.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

/// @return whether it came true within two minutes
bool waitFor(const std::function<bool()> &isTrue)
{
    QElapsedTimer clock;
    clock.start();
    while (!isTrue() && clock.elapsed() < 120'000)
        QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 10);
    return isTrue();
}

/// A window that shows all of a model; null if it cannot be shown.
std::unique_ptr<MainWindow> windowWith(const std::filesystem::path &file)
{
    MainWindow::Options options;
    options.remembers = false;
    auto window = std::make_unique<MainWindow>(options);
    window->resize(1280, 800);
    window->session().openFiles({file});
    window->show();
    const bool isSeen = waitFor([&] {
        return !window->session().isLoading() && window->view().isReady()
               && !window->document().scene().objects.empty();
    });
    if (!isSeen)
        return nullptr;
    // Stand-ins are made in parallel to the first picture.
    QElapsedTimer clock;
    clock.start();
    waitFor([&] { return clock.elapsed() > 3000 && !window->view().isCoarse(); });
    return window;
}

std::size_t trianglesOf(const SceneDocument &document)
{
    std::size_t count = 0;
    for (const SceneObject &object : document.scene().objects)
        count += object.model->triangleCount();
    return count;
}

void orbit(benchmark::State &state, const std::filesystem::path &file)
{
    const std::unique_ptr<MainWindow> window = windowWith(file);
    if (!window) {
        state.SkipWithError("the model is not seen");
        return;
    }
    bool isSwapped = false;
    QObject::connect(&window->view(), &QOpenGLWidget::frameSwapped, window.get(), [&] { isSwapped = true; });
    std::vector<double> seconds;
    const std::clock_t begin = std::clock(); // of all threads
    for (auto _ : state) {
        QElapsedTimer clock;
        clock.start();
        isSwapped = false;
        const LookAt &camera = window->document().scene().camera;
        setCamera(window->document(), orbited(camera, camera.center, 0.02, 0.0), QStringLiteral("turn"));
        waitFor([&] { return isSwapped; });
        seconds.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-9);
    }
    const double cpuSeconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::sort(seconds.begin(), seconds.end());
    double sum = 0.0;
    for (const double s : seconds)
        sum += s;
    const double perSecond = static_cast<double>(seconds.size()) / sum;
    const std::size_t triangles = trianglesOf(window->document());
    state.counters["triangles"] = static_cast<double>(triangles);
    state.counters["frames_a_second"] = perSecond;
    state.counters["of_limit"] = perSecond / (triangles > 3'000'000 ? 20.0 : 30.0);
    state.counters["cpu_ms"] = cpuSeconds * 1e3 / static_cast<double>(seconds.size());
    state.counters["slowest_ms"] = seconds.back() * 1e3;

    QElapsedTimer rest;
    rest.start();
    waitFor([&] { return !window->view().isCoarse(); });
    state.counters["whole_again_ms"] = static_cast<double>(rest.elapsed());
}

} // namespace

int main(int argc, char **argv)
{
    QSurfaceFormat::setDefaultFormat(FrameView::preCreateWindow());
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        const std::filesystem::path file(argv[i]);
        benchmark::RegisterBenchmark(file.filename().string().c_str(),
                                     [file](benchmark::State &state) { orbit(state, file); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(100)
            ->UseRealTime();
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
