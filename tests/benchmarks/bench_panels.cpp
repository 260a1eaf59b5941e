// The processor time of the panels when the mouse moves: all of them shown, their update and their
// painting. The limit is 1 ms a move, together; `of_limit` is the share of it.

#include "core/examples/examples.h"
#include "core/geometry/camera_motion.h"
#include "gui/click/comparison_panel.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/parameters/parameters_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "tests/gui/document_edits.h"

#include <benchmark/benchmark.h>

#include <QApplication>

#include <ctime>

namespace {

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;

constexpr double kLimitSeconds = 1e-3;

/// The panels of the window at the sizes they have in a window of 1280 x 800.
struct Panels {
    SceneDocument document;
    ComparisonPanel comparison{document};
    ParametersPanel parameters{document};
    PipelinePanel pipeline{document};
    ViewportInspector inspector{document};

    Panels()
    {
        document.setSurface(surfaceFromWidget(600, 516, 1.0));
        openObjects(document, examples::bundledScene());
        pickAt(document, WidgetPoint(300.0, 250.0), {0.5, 0, 24});
        comparison.resize(440, 700);
        parameters.resize(240, 700);
        pipeline.resize(440, 700);
        inspector.resize(600, 190);
        for (QWidget *panel : {static_cast<QWidget *>(&comparison), static_cast<QWidget *>(&parameters),
                               static_cast<QWidget *>(&pipeline), static_cast<QWidget *>(&inspector)})
            panel->show();
        QApplication::processEvents();
    }
};

/// Processor time of the loop, measured next to the benchmark's own clock, as a share of the limit.
class Share {
public:
    explicit Share(benchmark::State &state) : m_state(state), m_start(std::clock()) {}
    ~Share()
    {
        const double seconds = static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC;
        m_state.counters["of_limit"] = seconds / static_cast<double>(m_state.iterations()) / kLimitSeconds;
    }

private:
    benchmark::State &m_state;
    std::clock_t m_start;
};

/// The pointer moves over the view: only the inspector has something to show.
void pointerMoves(benchmark::State &state)
{
    Panels panels;
    const Share share(state);
    int step = 0;
    for (auto _ : state) {
        step = (step + 1) % 400;
        panels.inspector.setPointer(WidgetPoint(100.0 + step, 250.5));
        QApplication::processEvents();
    }
}
BENCHMARK(pointerMoves)->Unit(benchmark::kMicrosecond)->MeasureProcessCPUTime();

/// The mouse turns the camera: every matrix and field changes.
void cameraTurns(benchmark::State &state)
{
    Panels panels;
    const Share share(state);
    for (auto _ : state) {
        const LookAt &camera = panels.document.scene().camera;
        setCamera(panels.document, orbited(camera, camera.center, 0.01, 0.0), QStringLiteral("turn"));
        QApplication::processEvents();
    }
}
BENCHMARK(cameraTurns)->Unit(benchmark::kMicrosecond)->MeasureProcessCPUTime();

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
