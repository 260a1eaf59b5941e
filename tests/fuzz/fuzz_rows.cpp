// Rows of points: a header and comma-separated values.

#include "core/cli/rows/row_table.h"
#include "tests/fuzz/fuzzing.h"

#include <cmath>
#include <optional>

using namespace unprojector::cli;

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    fuzz::silence();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    RowOptions options;
    options.input = fuzz::fileOf("rows.csv", data, size).string();
    options.isJson = size % 2 == 0;
    std::optional<RowTable> table;
    try {
        table.emplace(options, std::vector<ColumnNames>{{"px", "py", "depth"}}, std::vector<std::string>{"result"});
    } catch (const Refused &) { // the header
        return 0;
    }
    LineBlock block;
    NumberRows rows;
    while (table->blocks().next(block)) {
        std::vector<LineMessage> messages;
        table->read(block, rows, messages);
        fuzz::require(rows.isBad.size() == rows.count(), "each row is good or bad");
        for (const auto &column : rows.values) {
            fuzz::require(column.size() == rows.count(), "a row has three numbers");
            for (const double value : column)
                fuzz::require(std::isfinite(value), "numbers are finite");
        }
        BlockResult result;
        table->write(block, rows, result, [](std::size_t, unprojector::base::RowWriter &writer) {
            writer.text("=1\n");
            return std::string();
        });
        fuzz::require(result.output.empty() == (rows.count() == 0), "each row is written");
    }
    fuzz::require(table->blocks().bytesRead() == size, "everything is read");
    return 0;
}
