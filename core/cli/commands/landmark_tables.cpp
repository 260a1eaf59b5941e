#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/commands/landmarks_command.h"
#include "core/cli/terminal/refusal.h"
#include "core/curves/measured_sets.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/measures_file.h"
#include "core/landmark_files/repeats_table.h"
#include "core/landmark_files/specimen_table.h"
#include "core/landmarks/protocol.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace unprojector::cli {
using namespace landmarks;
using namespace landmark_files;
using namespace base;
using geometry::Result;
namespace {

/// Reads a folder. Prints reports on stderr, also why there is nothing in it.
LandmarkFolder readFolder(const std::string &name, const LandmarksOptions &options)
{
    std::vector<std::filesystem::path> outputs;
    for (const std::string &output : {options.output, options.errors}) {
        if (output != "-")
            outputs.push_back(pathFromUtf8(output));
    }
    std::error_code error;
    LandmarkFolder folder = readLandmarkFolder(pathFromUtf8(name), outputs, error);
    if (error)
        refuse(folderErrorText(pathFromUtf8(name), error));
    for (const std::string &report : folder.reports)
        complain(report);
    if (folder.sets.empty())
        refuse(folder.fileCount == 0 ? tr("%1: there are no files of landmarks (%2)", name, readWords())
                                     : tr("%1: none of its files of landmarks could be read", name));
    return folder;
}

void addInputs(InputFiles &inputs, const LandmarkFolder &folder)
{
    for (const auto *files : {&folder.tableInputs, &folder.files}) {
        for (const std::filesystem::path &file : *files)
            inputs.push_back(utf8FromPath(file));
    }
    inputs.insert(inputs.end(), folder.badFiles.begin(), folder.badFiles.end());
}

/// Checks that a table may have this name.
/// @param output  empty: there is no such table
/// @param format  that of the table
void checkNameOfTable(const std::string &output, Format format)
{
    if (output.empty() || output == "-")
        return;
    const std::filesystem::path file = pathFromUtf8(output);
    const std::optional<Format> named = landmark_files::formatOf(file);
    if (isModelName(file))
        refuse(tr("%1: this is the name of a model, not of a table; give another name", output));
    if (isMeasuresFile(file) || file.filename() == seriesTemplate({}))
        refuse(tr("%1: this name is kept for the template and the measures of a series; give another name", output));
    if (named && *named != format)
        refuse(tr("%1: this table is a .%2; give it a name that ends so, or another format", output, suffixOf(format)));
}

/// The form of the table: the given one, else the one of its suffix. Checks the names.
TableForm tableForm(const LandmarksOptions &options)
{
    const std::optional<Format> named = landmark_files::formatOf(pathFromUtf8(options.output));
    const TableForm form = options.table.value_or(named == Format::Tps   ? TableForm::Tps
                                                  : named == Format::Nts ? TableForm::Nts
                                                                         : TableForm::Long);
    const Format format = form == TableForm::Tps ? Format::Tps : form == TableForm::Nts ? Format::Nts : Format::Csv;
    checkNameOfTable(options.output, format);
    checkNameOfTable(options.sliders, Format::Csv);
    return form;
}

/// The model file of a specimen: the scan that its file lies beside, else the mesh that the file names.
/// Empty if there is none.
std::filesystem::path modelOf(const LandmarkSet &set, const std::filesystem::path &file)
{
    std::error_code ignored;
    if (std::filesystem::path scan = scanOf(file); std::filesystem::is_regular_file(scan, ignored))
        return scan;
    const std::filesystem::path mesh = file.parent_path() / pathFromUtf8(set.mesh);
    return !set.mesh.empty() && std::filesystem::is_regular_file(mesh, ignored) ? mesh : std::filesystem::path();
}

/// The values of a protocol for each specimen of a folder, and the models read for them.
struct MeasuredFolder {
    std::vector<std::vector<ProtocolValue>> values;
    InputFiles models;
};

MeasuredFolder measured(const LandmarkFolder &folder, const std::vector<KeptMeasure> &measures)
{
    MeasuredFolder found;
    const auto modelAt = [&](std::size_t i) -> Result<std::filesystem::path, std::string> {
        std::filesystem::path model = modelOf(folder.sets[i], folder.files[i]);
        if (model.empty())
            return tr("there is no model beside %1", utf8FromPath(folder.files[i].filename()));
        if (found.models.empty() || found.models.back() != utf8FromPath(model))
            found.models.push_back(utf8FromPath(model));
        return model;
    };
    found.values = *curves::measuredSets(folder.sets, measures, modelAt);
    return found;
}

/// A set to compare, and its file.
struct Placing {
    LandmarkSet set;
    std::string file;
    std::size_t input = 0; ///< index of the given name
};

/// Reads the files and folders with repeated placings.
/// @param inputs  gets the files of folders, also those that an output would replace
std::vector<Placing> readPlacings(const LandmarksOptions &options, InputFiles &inputs, ExitCode &code)
{
    std::vector<Placing> placings;
    for (std::size_t i = 0; i < options.repeats.size(); ++i) {
        const std::string &name = options.repeats[i];
        std::error_code ignored;
        if (name != "-" && std::filesystem::is_directory(pathFromUtf8(name), ignored)) {
            LandmarkFolder folder = readFolder(name, options);
            addInputs(inputs, folder);
            if (!folder.badFiles.empty())
                code = ExitCode::SomeRowsBad;
            for (std::size_t k = 0; k < folder.sets.size(); ++k)
                placings.push_back({std::move(folder.sets[k]), utf8FromPath(folder.files[k]), i});
            continue;
        }
        ReadLandmarks read = readFile(name, formatOf(name, options.from, "--from"));
        for (LandmarkSet &set : read.sets) {
            set.placing = std::max(set.placing, placingOf(pathFromUtf8(name)));
            placings.push_back({std::move(set), name, i});
        }
    }
    return placings;
}

/// Groups sets by specimen. If each file has one set and none lies beside a scan, all are the same
/// specimen, under any name. Otherwise sets of the same name belong together, or, without names, those
/// beside the same scan, or at the same index. Numbers placings of a specimen by their file, where the
/// file does not tell.
std::vector<RepeatedSpecimen> specimensOf(const std::vector<Placing> &placings)
{
    const bool areFiles = std::adjacent_find(placings.begin(), placings.end(),
                                             [](const Placing &a, const Placing &b) { return a.input == b.input; })
                          == placings.end();
    const bool isOne = areFiles && std::all_of(placings.begin(), placings.end(), [](const Placing &placing) {
                           return scanOf(pathFromUtf8(placing.file)).empty();
                       });
    std::vector<RepeatedSpecimen> specimens;
    std::size_t index = 0, input = 0;
    for (const Placing &placing : placings) {
        index = placing.input == input ? index + 1 : 1;
        input = placing.input;
        const std::filesystem::path file = pathFromUtf8(placing.file);
        const bool isNamedByFile = isOne || !scanOf(file).empty();
        const std::string name = !placing.set.name.empty() ? placing.set.name
                                 : isNamedByFile           ? specimenOf(file)
                                                           : std::to_string(index);
        auto known = std::find_if(specimens.begin(), specimens.end(),
                                  [&](const RepeatedSpecimen &specimen) { return isOne || specimen.name == name; });
        if (known == specimens.end())
            known = specimens.insert(known, RepeatedSpecimen{name, {}, {}});
        LandmarkSet set = placing.set;
        if (set.placing == 1 && scanOf(file).empty())
            set.placing = static_cast<int>(placing.input) + 1;
        const auto isTaken = [&known](int number) {
            return std::any_of(known->placings.begin(), known->placings.end(),
                               [number](const LandmarkSet &other) { return other.placing == number; });
        };
        while (isTaken(set.placing))
            ++set.placing;
        known->placings.push_back(std::move(set));
        known->files.push_back(placing.file);
    }
    return specimens;
}

/// Warns about a file given twice, because a set compared with itself has no scatter.
void tellSameFiles(const std::vector<std::string> &files)
{
    std::map<std::filesystem::path, std::string> known;
    for (const std::string &file : files) {
        std::error_code error;
        const auto [first, isNew] = known.emplace(std::filesystem::weakly_canonical(pathFromUtf8(file), error), file);
        if (!isNew && !error)
            complain(
                tr("%1: this is %2 again; the placing counts twice, so the scatter is too small", file, first->second));
    }
}

/// Names the specimens that were placed once.
void tellSingles(const std::vector<RepeatedSpecimen> &specimens)
{
    constexpr std::size_t kMostLines = 3;
    std::vector<std::string> names;
    for (const RepeatedSpecimen &specimen : specimens) {
        if (specimen.placings.size() < 2)
            names.push_back(specimen.name);
    }
    if (names.size() > kMostLines) {
        complain(tr("%1 specimens were placed only once: there is nothing to compare them with", names.size()));
        return;
    }
    for (const std::string &name : names)
        complain(tr("the specimen \"%1\" was placed only once: there is nothing to compare it with", name));
}

} // namespace

ExitCode makeTable(const LandmarksOptions &options)
{
    const TableForm form = tableForm(options);
    const LandmarkFolder folder = readFolder(options.folder, options);
    InputFiles inputs;
    addInputs(inputs, folder);
    checkNotInput(options.output, inputs);
    checkNotInput(options.sliders, inputs);
    std::vector<KeptMeasure> measures;
    MeasuredFolder found;
    if (!options.measures.empty()) {
        auto read = readMeasures(pathFromUtf8(options.measures));
        if (!read)
            refuse(read.error().message());
        measures = std::move(read).value();
        if (measures.empty())
            complain(tr("%1: there are no measures in the file", options.measures));
        found = measured(folder, measures);
        inputs.push_back(options.measures);
        inputs.insert(inputs.end(), found.models.begin(), found.models.end());
    }
    const std::string name = outputName(options.output);
    const auto table = specimenTable(folder.sets, form, {measures, found.values}, {}, options.texts());
    const ExitCode written = table ? write(options.output, WrittenLandmarks{table->text, table->notes}, inputs)
                                   : write(options.output, table.error(), inputs);
    if (written != ExitCode::Done)
        return written;
    if (const std::string absent = absentText(table->absent); !absent.empty())
        complain(name + ": " + absent);
    if (form == TableForm::Wide || form == TableForm::Long) {
        for (const std::string &text : unmeasuredTexts({measures, found.values}))
            complain(name + ": " + text);
    }
    inputs.push_back(options.output);
    return std::max(writeSliders(options.sliders, table->sliders, inputs, written),
                    folder.badFiles.empty() ? ExitCode::Done : ExitCode::SomeRowsBad);
}

ExitCode makeRepeats(const LandmarksOptions &options)
{
    checkNameOfTable(options.output, Format::Csv);
    checkNameOfTable(options.errors, Format::Csv);
    InputFiles inputs = options.repeats;
    const auto checkOutputs = [&] {
        checkNotInput(options.output, inputs);
        checkNotInput(options.errors, inputs);
    };
    checkOutputs();
    ExitCode code = ExitCode::Done;
    const std::vector<Placing> placings = readPlacings(options, inputs, code);
    checkOutputs();
    tellSameFiles(options.repeats);
    const std::vector<RepeatedSpecimen> specimens = specimensOf(placings);
    tellSingles(specimens);
    if (std::all_of(specimens.begin(), specimens.end(),
                    [](const RepeatedSpecimen &specimen) { return specimen.placings.size() < 2; }))
        refuse(tr("no specimen was placed more than once, so there are no repeats to compare"));
    if (!options.output.empty()) {
        const ExitCode written = write(options.output, repeatsTable(specimens, options.texts()), inputs);
        if (written != ExitCode::Done)
            return written;
    }
    if (!options.errors.empty()) {
        const ExitCode written = write(options.errors, errorsTable(specimens, options.texts()), inputs);
        if (written != ExitCode::Done)
            return written;
        for (const std::string &remark : errorRemarks(measurementErrorOf(specimens)))
            complain(outputName(options.errors) + ": " + remark);
    }
    return code;
}

} // namespace unprojector::cli
