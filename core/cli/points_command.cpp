#include "core/cli/points_command.h"

#include "core/cli/clicks_command.h"
#include "core/text/error_text.h"
#include "core/unproject/batch/click_batch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace unprojector::cli {
using namespace unproject;
using namespace text;
namespace {

/// Everything that is the same for all rows.
struct Task {
    PointsOptions options;
    NumberReader reader;
    DepthRange depthRange;
    std::optional<ClickBatch> formula, matrix;
    std::vector<std::string> names; ///< of the columns written
};

/// The scratch memory of a thread.
class Worker {
public:
    explicit Worker(const Task &task) : m_task(task) {}

    void operator()(const LineBlock &block, BlockResult &result)
    {
        m_task.reader.read(block, m_rows, result.messages);
        refuseUnusable(block, result.messages);
        compute();
        write(block, result);
    }

private:
    using Columns = std::array<std::vector<double>, 3>;

    /// Why a row of three numbers means nothing here; empty where it does, else `column` is the one at fault.
    std::string fault(std::size_t row, std::size_t &column) const
    {
        const double low = std::min(m_task.depthRange.atNear, m_task.depthRange.atFar);
        const double high = std::max(m_task.depthRange.atNear, m_task.depthRange.atFar);
        const double depth = m_rows.values[2][row];
        if (!(depth >= low && depth <= high)) {
            column = 2;
            return "depth: " + shortestText(depth) + " lies outside the depth range " + shortestText(low) + " to "
                   + shortestText(high);
        }
        for (column = 0; m_task.options.isPixel && column < 2; ++column) {
            const double index = m_rows.values[column][row];
            if (index != std::floor(index))
                return (column == 0 ? "px: " : "py: ") + shortestText(index)
                       + " is not the index of a pixel: it has a fraction";
        }
        return {};
    }

    void refuseUnusable(const LineBlock &block, std::vector<LineMessage> &messages)
    {
        m_bad.clear();
        auto known = m_rows.bad.begin();
        for (std::size_t i = 0; i < m_rows.count(); ++i) {
            if (known != m_rows.bad.end() && known->row == i) {
                m_bad.push_back(std::move(*known++));
                continue;
            }
            std::size_t column = 0;
            const std::string what = fault(i, column);
            if (what.empty())
                continue;
            m_task.reader.complainOf(block, m_rows.places[i], column, what, messages);
            m_bad.push_back({i,
                             {shortestText(m_rows.values[0][i]), shortestText(m_rows.values[1][i]),
                              shortestText(m_rows.values[2][i])}});
        }
    }

    void compute()
    {
        const std::size_t count = m_rows.count();
        const double *px = m_rows.values[0].data(), *py = m_rows.values[1].data();
        if (m_task.options.isPixel) {
            for (std::size_t k = 0; k < 2; ++k) {
                m_centres[k].resize(count);
                std::transform(m_rows.values[k].begin(), m_rows.values[k].end(), m_centres[k].begin(),
                               [](double index) { return index + kHalfPixel; });
            }
            px = m_centres[0].data();
            py = m_centres[1].data();
        }
        const BatchInput<double> input{px, py, m_rows.values[2].data()};
        const auto run = [&](const std::optional<ClickBatch> &method, Columns &points) {
            if (!method)
                return;
            for (auto &column : points)
                column.resize(count);
            (*method)(input, BatchOutput<double>{points[0].data(), points[1].data(), points[2].data()}, count);
        };
        run(m_task.formula, m_byFormula);
        run(m_task.matrix, m_byMatrix);
    }

    void write(const LineBlock &block, BlockResult &result)
    {
        RowWriter writer(m_task.options.rows.format, m_task.names, result.output);
        result.badRows = m_bad.size();
        auto bad = m_bad.begin();
        for (std::size_t i = 0; i < m_rows.count(); ++i) {
            if (bad != m_bad.end() && bad->row == i) {
                writeBad(*bad++, writer);
                continue;
            }
            for (const auto &column : m_rows.values)
                writer.number(column[i]);
            if (!writeResults(i, writer)) {
                ++result.badRows;
                m_task.reader.complainOf(block, m_rows.places[i], NumberReader::kNoColumn,
                                         errorText(Error{ErrorCode::PointAtInfinity}), result.messages);
            }
            writer.endRow();
        }
    }

    bool writeResults(std::size_t row, RowWriter &writer) const
    {
        bool isFinite = true;
        const auto add = [&](double value) {
            isFinite = isFinite && std::isfinite(value);
            writer.numberOrNothing(value);
        };
        const auto addPoint = [&](bool isWanted, const std::optional<ClickBatch> &method, const Columns &points) {
            for (std::size_t k = 0; isWanted && k < 3; ++k) {
                if (method)
                    add(points[k][row]);
                else
                    writer.nothing();
            }
        };
        const Methods methods = m_task.options.methods;
        addPoint(methods != Methods::Matrix, m_task.formula, m_byFormula);
        addPoint(methods != Methods::Formula, m_task.matrix, m_byMatrix);
        if (methods != Methods::Both)
            return isFinite;
        if (m_task.formula && m_task.matrix) {
            double squares = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double difference = m_byFormula[k][row] - m_byMatrix[k][row];
                squares += difference * difference;
            }
            add(std::sqrt(squares));
        } else {
            writer.nothing();
        }
        return isFinite;
    }

    void writeBad(const BadRow &bad, RowWriter &writer) const
    {
        for (const std::string &cell : bad.cells)
            writer.asWritten(cell);
        for (std::size_t k = bad.cells.size(); k < m_task.names.size(); ++k)
            writer.nothing();
        writer.endRow();
    }

    const Task &m_task;
    NumberRows m_rows;
    std::vector<BadRow> m_bad;
    std::array<std::vector<double>, 2> m_centres;
    Columns m_byFormula, m_byMatrix;
};

/// A method prepared for the scene, where it is wanted. One that does not hold for it says why, and its cells stay empty.
void prepare(std::optional<ClickBatch> &target, bool isWanted, const char *name, const Result<ClickBatch> &method,
             const std::string &scene)
{
    if (!isWanted)
        return;
    if (method)
        target = *method;
    else
        complain(scene + ": " + name + ": " + errorText(method.error()));
}

} // namespace

std::vector<std::string> pointColumns(Methods methods)
{
    std::vector<std::string> names{"px", "py", "depth"};
    if (methods != Methods::Matrix)
        names.insert(names.end(), {"formula_x", "formula_y", "formula_z"});
    if (methods != Methods::Formula)
        names.insert(names.end(), {"matrix_x", "matrix_y", "matrix_z"});
    if (methods == Methods::Both)
        names.emplace_back("difference");
    return names;
}

ExitCode runPoints(const PointsOptions &options)
{
    const std::optional<SceneOrClicks> given = sceneOrClicks(options.rows.scene);
    if (!given)
        return ExitCode::UnusableInput;
    if (const auto *clicks = std::get_if<std::vector<Click>>(&*given); clicks && options.rows.input == "-")
        return runClicks(options, *clicks);
    const std::unique_ptr<RowStream> rows = openRows(options.rows, *given, {"px", "py", "depth"});
    if (!rows)
        return ExitCode::UnusableInput;
    const Picture &geometry = rows->scene.geometry;
    Task task{options,
              NumberReader(rows->source.name(), rows->columns),
              geometry.depthRange,
              {},
              {},
              pointColumns(options.methods)};
    prepare(task.formula, options.methods != Methods::Matrix, "formula", ClickBatch::byFormula(geometry, rows->space),
            options.rows.scene);
    prepare(task.matrix, options.methods != Methods::Formula, "matrix", ClickBatch::byMatrix(geometry, rows->space),
            options.rows.scene);
    if (!task.formula && !task.matrix)
        return ExitCode::UnusableInput;

    return runRows(*rows, options.rows, task.names, [&] { return BlockWorker(Worker(task)); });
}

} // namespace unprojector::cli
