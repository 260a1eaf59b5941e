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

/// The options shared by all commands that take rows of numbers through a scene.
struct RowOptions {
    std::string scene;           ///< a scene file, or clicks; "-" for stdin
    std::string input = "-";     ///< a CSV file, "-" for stdin
    bool isInputGiven = false;   ///< input has a name; else clicks serve as rows
    std::string space = "world"; ///< space of the points: "eye", "world" or "object:NAME"
    RowFormat format = RowFormat::Csv;
    bool isHeaderless = false;      ///< writes no header, so that results can be concatenated
    unsigned threads = 2;
};

/// The columns of a point, as one command writes them and another reads them: "formula_x" to
/// "formula_z", in any space.
ColumnNames pointColumnsOf(const std::string &method);

/// The setup of a scene, the space in it, and the rows after a header with the columns.
struct RowStream {
    RowStream(const scene_file::SceneFile &scene, const unproject::BatchSpace &spaceInIt, const RowOptions &options);

    geometry::Setup setup;
    unproject::BatchSpace space;
    InputFiles inputs; ///< the scene's files and the rows' file
    ByteSource source;
    LineBlocks blocks{source};
    NumberColumns columns;
};

/// Opens the stream; returns null and prints the reason on stderr if something is unusable.
/// @param given    the content of options.scene
/// @param columns  the accepted names, see readHeader
std::unique_ptr<RowStream> openRows(const RowOptions &options, const scene_file::SceneOrClicks &given,
                                    const std::vector<ColumnNames> &columns);

/// Processes all rows with workers and writes them to stdout.
/// @param names   names of the columns written
/// @param worker  makes the worker of a thread
ExitCode runRows(RowStream &rows, const RowOptions &options, const std::vector<std::string> &names,
                 const std::function<BlockWorker()> &worker);

} // namespace unprojector::cli
