#include "core/cli/rows/row_stream.h"

#include "core/base/translation.h"

#include <optional>

namespace unprojector::cli {
using namespace scene_file;
using namespace unproject;
using base::tr;

RowStream::RowStream(const SceneFile &scene, const BatchSpace &spaceInIt, const RowOptions &options)
    : setup(setupOf(scene)), space(spaceInIt), inputs(filesOf(scene, options.scene)), source(options.input)
{
    inputs.push_back(options.input);
}

ColumnNames pointColumnsOf(const std::string &method)
{
    return {method + "_x", method + "_y", method + "_z"};
}

std::unique_ptr<RowStream> openRows(const RowOptions &options, const SceneOrClicks &given,
                                    const std::vector<ColumnNames> &columns)
{
    if (options.scene == "-" && options.input == "-") {
        complain(tr("the scene and the points cannot both come from standard input; give a file for one of them"));
        return nullptr;
    }
    const std::optional<SceneFile> scene = sceneOf(given, options.scene);
    if (!scene)
        return nullptr;
    const std::optional<BatchSpace> space = batchSpace(options.space, *scene);
    if (!space)
        return nullptr;
    auto rows = std::make_unique<RowStream>(*scene, *space, options);
    if (!rows->source.isOpen())
        return nullptr;
    const std::optional<NumberColumns> found = readHeader(rows->blocks, rows->source, columns);
    if (!found)
        return nullptr;
    rows->columns = *found;
    return rows;
}

ExitCode runRows(RowStream &rows, const RowOptions &options, const std::vector<std::string> &names,
                 const std::function<BlockWorker()> &worker)
{
    // Output appended to the input would be read as input, endlessly.
    ByteSink sink("-", rows.inputs);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    if (!options.isHeaderless) {
        std::string header;
        RowWriter(options.format, names, header).header();
        sink.write(header);
    }
    return runBlocks(rows.blocks, rows.source, sink, options.threads, worker);
}

} // namespace unprojector::cli
