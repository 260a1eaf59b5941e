// `unproject points` next to reading and writing the same numbers without computing, one thread
// each.

#include "core/base/number_text.h"
#include "core/cli/rows/row_table.h"
#include "core/unproject/batch/click_batch.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>

using namespace unprojector;
using namespace unprojector::cli;
using namespace unprojector::geometry;
using namespace unprojector::base;
using namespace unprojector::unproject;

namespace {

constexpr std::size_t kRows = 4000; // about one block

Setup setup()
{
    Setup g;
    g.surface = {800, 600, 1.0};
    g.viewport = wholeSurface(g.surface);
    g.lens = Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 100.0};
    g.pose = LookAt{};
    return g;
}

LineBlock block()
{
    std::mt19937_64 random(1);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    LineBlock result;
    for (std::size_t i = 0; i < kRows; ++i) {
        for (const double value : {unit() * 800, unit() * 600, unit()}) {
            appendNumber(result.text, value);
            result.text += ',';
        }
        result.text.back() = '\n';
    }
    return result;
}

/// Three numbers in, ten out; the seven results are what `unproject points` would have computed.
void rows(benchmark::State &state, bool isComputing)
{
    const LineBlock text = block();
    const std::string header = (std::filesystem::temp_directory_path() / "bench_rows.csv").string();
    std::ofstream(header) << "px,py,depth\n";
    const RowTable table({.input = header}, {{"px", "py", "depth"}}, std::vector<std::string>(7, "name"));
    const ClickBatch formula = *ClickBatch::of(Method::Formula, setup(), {});
    const ClickBatch matrix = *ClickBatch::of(Method::Matrix, setup(), {});
    NumberRows numbers;
    std::vector<LineMessage> messages;
    std::array<std::vector<double>, 7> results;
    for (auto &column : results)
        column.resize(kRows);
    BlockResult output;
    const auto compute = [&] {
        const BatchInput<double> input{numbers.values[0].data(), numbers.values[1].data(), numbers.values[2].data()};
        formula(input, BatchOutput<double>{results[0].data(), results[1].data(), results[2].data()}, kRows);
        matrix(input, BatchOutput<double>{results[3].data(), results[4].data(), results[5].data()}, kRows);
        for (std::size_t i = 0; i < kRows; ++i) {
            double squares = 0.0;
            for (std::size_t k = 0; k < 3; ++k)
                squares += (results[k][i] - results[k + 3][i]) * (results[k][i] - results[k + 3][i]);
            results[6][i] = std::sqrt(squares);
        }
    };
    table.read(text, numbers, messages);
    compute();
    for (auto _ : state) {
        output.output.clear();
        table.read(text, numbers, messages);
        if (isComputing)
            compute();
        table.write(text, numbers, output, [&results](std::size_t row, RowWriter &writer) {
            for (const auto &column : results)
                writer.numberOrNothing(column[row]);
            return std::string();
        });
        benchmark::DoNotOptimize(output.output.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kRows));
}

BENCHMARK_CAPTURE(rows, read and write, false);
BENCHMARK_CAPTURE(rows, read compute and write, true);

} // namespace

BENCHMARK_MAIN();
