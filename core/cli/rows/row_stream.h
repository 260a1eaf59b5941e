#pragma once

#include "core/cli/rows/block_pipeline.h"
#include "core/cli/rows/number_table.h"
#include "core/cli/rows/row_writer.h"
#include "core/cli/rows/scene_input.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace unprojector::cli {

/// What all commands that take rows of numbers through a scene are told.
struct RowOptions {
    std::string scene;           ///< a scene file, or clicks; "-" for stdin
    std::string input = "-";     ///< a CSV file, "-" for stdin
    bool isInputGiven = false;   ///< by name; else clicks are rows themselves
    std::string space = "world"; ///< of the points: "eye", "world" or "object:NAME"
    RowFormat format = RowFormat::Csv;
    bool isSpreadsheetSafe = false; ///< makes CSV RowFormat::SafeCsv
    bool isHeaderless = false;      ///< no header is written, so that results can be put behind each other
    unsigned threads = 2;
};

/// The columns of a point, as a command writes them and another reads them: "formula_x" to "formula_z", in whatever space.
ColumnNames pointColumnsOf(const std::string &method);

/// The setup of a scene, the space in it, and the rows behind a header that has the columns.
struct RowStream {
    RowStream(const scene_file::SceneFile &scene, const unproject::BatchSpace &spaceInIt, const RowOptions &options);

    geometry::Setup setup;
    unproject::BatchSpace space;
    InputFiles inputs; ///< the scene's files and that of the rows
    ByteSource source;
    LineBlocks blocks{source};
    NumberColumns columns;
};

/// Opens all of it; null, with the reason on stderr, where something is unusable.
/// @param given    what options.scene holds
/// @param columns  the names that they may have, see readHeader
std::unique_ptr<RowStream> openRows(const RowOptions &options, const scene_file::SceneOrClicks &given,
                                    const std::vector<ColumnNames> &columns);

/// Takes all rows through workers to stdout.
/// @param names   of the columns written
/// @param worker  makes the worker of a thread
ExitCode runRows(RowStream &rows, const RowOptions &options, const std::vector<std::string> &names,
                 const std::function<BlockWorker()> &worker);

} // namespace unprojector::cli
