// The cost of importing model files, without the window: time next to reading their bytes in the
// same run, memory, and the longest time between two reports, which is how long a cancel may wait.
//
//   make_models models 913 && bench_loading models/*

#include "core/mesh/import/mesh_import.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

using namespace unprojector;

namespace {

constexpr int kRounds = 5;

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

double secondsToReadBytes(const std::filesystem::path &file)
{
    const Stopwatch watch;
    std::vector<char> block(1 << 20);
    std::ifstream stream(file, std::ios::binary);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size()))) {
    }
    return watch.seconds();
}

/// The peak memory of the process since the last call, in MiB; 0 where the system does not report
/// it.
double peakMebibytes()
{
    double kibibytes = 0.0;
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:"))
            kibibytes = std::stod(line.substr(6));
    }
    std::ofstream("/proc/self/clear_refs") << "5";
    return kibibytes / 1024.0;
}

} // namespace

int main(int argumentCount, char **arguments)
{
    std::printf("%-24s %12s %10s %10s %8s %10s %10s\n", "file", "triangles", "import s", "bytes s", "ratio", "peak MiB",
                "report ms");
    for (int i = 1; i < argumentCount; ++i) {
        const std::filesystem::path file(arguments[i]);
        double best = std::numeric_limits<double>::max();
        double bestOfBytes = best;
        double longestSilence = 0.0;
        std::size_t triangles = 0;
        peakMebibytes();
        for (int round = 0; round < kRounds; ++round) {
            bestOfBytes = std::min(bestOfBytes, secondsToReadBytes(file));
            const Stopwatch watch;
            double last = 0.0;
            double silence = 0.0;
            const auto result = mesh::importModel(file, [&](double) {
                const double now = watch.seconds();
                silence = std::max(silence, now - last);
                last = now;
                return true;
            });
            best = std::min(best, watch.seconds());
            if (!result) {
                std::printf("%s cannot be opened: %s\n", arguments[i], result.error().detail.c_str());
                return 2;
            }
            longestSilence = round == 0 ? silence : std::min(longestSilence, silence);
            triangles = result.value()->triangleCount();
        }
        std::printf("%-24s %12zu %10.3f %10.3f %8.1f %10.0f %10.0f\n", file.filename().string().c_str(), triangles,
                    best, bestOfBytes, best / bestOfBytes, peakMebibytes(), 1000.0 * longestSilence);
    }
    return 0;
}
