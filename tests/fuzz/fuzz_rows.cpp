// Rows of points: a header and comma-separated values.

#include "core/cli/rows/row_table.h"
#include "tests/fuzz/fuzzing.h"

#include <cmath>

using namespace unprojector::cli;

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    fuzz::silence();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ByteSource source(fuzz::fileOf("rows.csv", data, size).string());
    LineBlocks blocks(source);
    RowOptions options;
    options.isJson = size % 2 == 0;
    const auto table = RowTable::of(blocks, source, {{"px", "py", "depth"}}, {"result"}, options);
    if (!table)
        return 0;
    LineBlock block;
    NumberRows rows;
    while (blocks.next(block)) {
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
    fuzz::require(blocks.bytesRead() == size, "everything is read");
    return 0;
}
