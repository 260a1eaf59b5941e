// Rows of points: a header and comma-separated values.

#include "core/cli/rows/number_table.h"
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
    const auto columns = readHeader(blocks, source, {{"px", "py", "depth"}});
    if (!columns)
        return 0;
    const NumberReader reader(source.name(), *columns);
    LineBlock block;
    NumberRows rows;
    while (blocks.next(block)) {
        std::vector<LineMessage> messages;
        reader.read(block, rows, messages);
        fuzz::require(rows.bad.size() <= rows.count(), "a bad row is one of the rows");
        for (const auto &column : rows.values) {
            fuzz::require(column.size() == rows.count(), "a row has three numbers");
            for (const double value : column)
                fuzz::require(std::isfinite(value), "numbers are finite");
        }
        for (const std::size_t bad : rows.bad)
            fuzz::require(bad < rows.count(), "a bad row is one of the rows");
    }
    fuzz::require(blocks.bytesRead() == size, "everything is read");
    return 0;
}
