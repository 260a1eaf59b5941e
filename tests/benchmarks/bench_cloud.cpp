// A depth image of 3840 x 2160 to world points on one core: the computing next to OpenCV's
// depthTo3d and transform, and the command next to the writing of the same bytes. Compare only
// numbers of one run.

#include "core/cli/command_line.h"
#include "core/clouds/depth_cloud.h"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>
#ifdef UNPROJECTOR_OPENCV
#include <opencv2/core.hpp>
#include <opencv2/rgbd.hpp>
#endif

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

using namespace unprojector;
using namespace unprojector::clouds;
using namespace unprojector::geometry;
using namespace unprojector::base;
using namespace unprojector::unproject;

namespace {

constexpr std::size_t kWidth = 3840, kHeight = 2160;
constexpr double kNear = 1.0, kFar = 100.0;

Setup setup()
{
    Setup g;
    g.surface = {kWidth, kHeight, 1.0};
    g.viewport = wholeSurface(g.surface);
    g.lens = Frustum{-1.0, 1.0, -0.5625, 0.5625, kNear, kFar};
    g.pose = LookAt{WorldPoint(3, 4, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
    return g;
}

/// Waves without background, so that every program computes all points.
images::NumberImage waves()
{
    images::NumberImage image;
    image.size = {kWidth, kHeight};
    auto depths = std::make_unique_for_overwrite<float[]>(kWidth * kHeight);
    for (std::size_t j = 0; j < kHeight; ++j) {
        for (std::size_t i = 0; i < kWidth; ++i) {
            depths[j * kWidth + i] =
                static_cast<float>(0.9 + 0.09 * std::sin(double(i) * 0.01) * std::cos(double(j) * 0.013));
        }
    }
    image.numbers = std::move(depths);
    return image;
}

const float *floatsOf(const images::NumberImage &image)
{
    return std::get<std::unique_ptr<float[]>>(image.numbers).get();
}

void finish(benchmark::State &state)
{
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kWidth * kHeight));
}

/// Computes as the command does: into a buffer of some rows that is written out and used again.
void computing(benchmark::State &state, const Result<BatchUnprojection> &unprojection, std::size_t bufferRows)
{
    const images::NumberImage image = waves();
    const DepthCloud<float> cloud(*unprojection, setup(), image);
    std::vector<float> points(3 * kWidth * bufferRows);
    for (auto _ : state) {
        std::size_t count = 0;
        for (std::size_t j = 0; j < kHeight; ++j) {
            if (j % bufferRows == 0)
                count = 0;
            count += cloud.row(j, points.data() + 3 * count);
        }
        benchmark::DoNotOptimize(count);
        benchmark::ClobberMemory();
    }
    finish(state);
}

#ifdef UNPROJECTOR_OPENCV
/// OpenCV takes distances from the eye plane, not depths of the depth buffer. It gets the
/// distances, which spares it that step.
void openCv(benchmark::State &state)
{
    cv::setNumThreads(1);
    const images::NumberImage image = waves();
    cv::Mat distances(kHeight, kWidth, CV_32F);
    for (std::size_t i = 0; i < kWidth * kHeight; ++i) {
        const double d = floatsOf(image)[i];
        distances.ptr<float>()[i] = static_cast<float>(kNear * kFar / (kFar * (1.0 - d) + kNear * d));
    }
    const double focal = kWidth / 2.0;
    const cv::Matx33f camera(float(focal), 0, kWidth / 2.0f, 0, float(focal), kHeight / 2.0f, 0, 0, 1);
    const EyeFrame frame = eyeFrame(std::get<LookAt>(setup().pose)).value();
    cv::Matx34f worldFromCamera; // OpenCV's y points down, its z ahead
    for (int row = 0; row < 3; ++row) {
        worldFromCamera(row, 0) = float(frame.side[row]);
        worldFromCamera(row, 1) = float(-frame.upward[row]);
        worldFromCamera(row, 2) = float(frame.forward[row]);
        worldFromCamera(row, 3) = float(frame.eye[row]);
    }
    cv::Mat inCamera, inWorld;
    for (auto _ : state) {
        cv::rgbd::depthTo3d(distances, camera, inCamera);
        cv::transform(inCamera, inWorld, worldFromCamera);
        benchmark::ClobberMemory();
    }
    finish(state);
}
#endif

/// A scene and a depth image on the disk, and where the cloud goes.
class Files {
public:
    Files() : m_folder(std::filesystem::temp_directory_path() / "unprojector_bench_cloud")
    {
        std::filesystem::create_directories(m_folder);
        const nlohmann::json scene{
            {"unprojector", 1},
            {"window", {{"width", kWidth}, {"height", kHeight}}},
            {"projection",
             {{"type", "frustum"},
              {"left", -1},
              {"right", 1},
              {"bottom", -0.5625},
              {"top", 0.5625},
              {"near", kNear},
              {"far", kFar}}},
            {"view", {{"eye", {3, 4, 5}}, {"center", {0, 0, 0}}, {"up", {0, 1, 0}}}},
        };
        std::ofstream(m_folder / "scene.json") << scene;
        const images::NumberImage image = waves();
        std::ofstream(m_folder / "depth.raw", std::ios::binary)
            .write(reinterpret_cast<const char *>(floatsOf(image)), kWidth * kHeight * sizeof(float));
    }
    ~Files()
    {
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    std::string path(const char *name) const { return (m_folder / name).string(); }

private:
    std::filesystem::path m_folder;
};

void command(benchmark::State &state)
{
    const Files files;
    const std::string output = files.path("cloud.ply");
    const std::vector<std::string> words{"unproject",
                                         "cloud",
                                         files.path("scene.json"),
                                         files.path("depth.raw"),
                                         "--size",
                                         std::to_string(kWidth) + 'x' + std::to_string(kHeight),
                                         "-o",
                                         output};
    for (auto _ : state) {
        if (cli::runCommandLine(words) != cli::ExitCode::Done)
            state.SkipWithError("the command failed");
        state.PauseTiming();
        std::filesystem::remove(output); // writing over a file is another thing
        state.ResumeTiming();
    }
    finish(state);
}

void writing(benchmark::State &state)
{
    const Files files;
    const std::string file = files.path("same.bytes");
    const std::vector<char> block(std::size_t{1} << 18, 'x');
    for (auto _ : state) {
        std::FILE *out = std::fopen(file.c_str(), "wb");
        for (std::size_t left = kWidth * kHeight * 12; left > 0;) {
            const std::size_t size = std::min(left, block.size());
            std::fwrite(block.data(), 1, size, out);
            left -= size;
        }
        std::fclose(out);
        state.PauseTiming();
        std::filesystem::remove(file);
        state.ResumeTiming();
    }
    finish(state);
}

} // namespace

#ifdef UNPROJECTOR_OPENCV
BENCHMARK(openCv)->Name("computing/OpenCV depthTo3d + transform")->Unit(benchmark::kMillisecond);
#endif
constexpr std::size_t kRowsOfTheCommand = 5;
BENCHMARK_CAPTURE(computing, formula, BatchUnprojection::byFormula(setup(), {}), kRowsOfTheCommand)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(computing, matrix, BatchUnprojection::byMatrix(setup(), {}), kRowsOfTheCommand)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(computing, formula kept whole, BatchUnprojection::byFormula(setup(), {}), kHeight)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(writing)->Name("whole/writing the same bytes")->Unit(benchmark::kMillisecond);
BENCHMARK(command)->Name("whole/unproject cloud")->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
