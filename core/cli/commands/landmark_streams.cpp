#include "core/cli/commands/landmark_streams.h"

#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/base/system_file.h"
#include "core/base/translation.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/measures_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace unprojector::cli {
using namespace landmarks;
using namespace landmark_files;
using namespace base;
using geometry::Result;

base::CellTexts textsOf(const LandmarksOptions &options)
{
    return options.isSpreadsheetSafe ? base::CellTexts::SpreadsheetSafe : base::CellTexts::AsTheyAre;
}

void tell(const std::string &name, const std::vector<LandmarkNote> &notes)
{
    std::vector<FileNote> ofFile;
    ofFile.reserve(notes.size());
    for (const LandmarkNote &note : notes)
        ofFile.push_back({name, note});
    for (const std::string &line : noteLines(ofFile))
        complain(line);
}

std::optional<ReadLandmarks> readFile(const std::string &file, Format format)
{
    ByteSource source(file);
    if (!source.isOpen())
        return std::nullopt;
    std::string text;
    std::array<char, 65536> block;
    std::size_t size = 0;
    do {
        size = source.read(block.data(), block.size());
        text.append(block.data(), size);
    } while (size > 0 && text.size() <= kMostLandmarkBytes);
    if (source.hasFailed()) {
        complain(tr("%1: the file cannot be read to its end", source.name()));
        return std::nullopt;
    }
    Result<ReadLandmarks, LandmarkFileError> read = parseLandmarks(text, format, source.name());
    if (!read) {
        complain(errorText(read.error()));
        return std::nullopt;
    }
    tell(source.name(), read->notes);
    const auto isEmpty = [](const LandmarkSet &set) { return set.landmarks.empty() && set.curves.empty(); };
    if (std::all_of(read->sets.begin(), read->sets.end(), isEmpty))
        complain(tr("%1: there are no points in the file", source.name()));
    return std::move(read).value();
}

ExitCode write(const std::string &file, const Result<WrittenLandmarks, LandmarkFileError> &text,
               const InputFiles &inputs)
{
    const std::string name = file == "-" ? "stdout" : file;
    if (!text) {
        LandmarkFileError error = text.error();
        error.file = name;
        complain(errorText(error));
        return ExitCode::UnusableInput;
    }
    ByteSink sink(file, inputs);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write(text->text);
    const ExitCode written = sink.finish();
    if (written == ExitCode::Done)
        tell(name, text->notes);
    return written;
}

bool isSameOutput(const std::string &a, const std::string &b)
{
    const auto whole = [](const std::string &file) {
        std::error_code ignored;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(pathFromUtf8(file), ignored), ignored);
    };
    if (a.empty() || b.empty() || isStream(pathFromUtf8(a)))
        return false;
    if (a != b && (a == "-" || b == "-" || (whole(a) != whole(b) && !isSameFile(pathFromUtf8(a), pathFromUtf8(b)))))
        return false;
    complain(tr("%1: two results cannot go to one file; give another name for one of them", a == "-" ? "stdout" : a));
    return true;
}

bool isNameOfTable(const std::string &output, Format format)
{
    if (output.empty() || output == "-")
        return true;
    const std::filesystem::path file = pathFromUtf8(output);
    const std::optional<Format> named = landmark_files::formatOf(file);
    if (isModelName(file))
        complain(tr("%1: this is the name of a model, not of a table; give another name", output));
    else if (isMeasuresFile(file) || file.filename() == seriesTemplate({}))
        complain(tr("%1: this name is kept for the template and the measures of a series; give another name", output));
    else if (named && *named != format)
        complain(
            tr("%1: this table is a .%2; give it a name that ends so, or another format", output, suffixOf(format)));
    else
        return true;
    return false;
}

ExitCode writeSliders(const std::string &file, const Result<Sliders, LandmarkFileError> &sliders,
                      const InputFiles &inputs, ExitCode written)
{
    if (file.empty() || written == ExitCode::UnusableInput)
        return written;
    if (!sliders || sliders->count == 0) {
        complain(
            file + ": "
            + (sliders ? tr("it is not written, because no curve has semilandmarks") : errorText(sliders.error())));
        return ExitCode::SomeRowsBad;
    }
    ByteSink sink(file, inputs);
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    sink.write(sliders->text);
    if (const ExitCode finished = sink.finish(); finished != ExitCode::Done)
        return finished;
    complain(file + ": "
             + tr(sliders->count == 1 ? "%1 slider, for geomorph's gpagen(curves=)"
                                      : "%1 sliders, for geomorph's gpagen(curves=)",
                  sliders->count));
    return written;
}

std::optional<Format> formatOf(const std::string &file, const std::optional<Format> &given, const char *option)
{
    if (given)
        return given;
    const bool isRead = option == std::string_view("--from");
    const std::optional<Format> format = file == "-" ? std::nullopt
                                         : isRead    ? readFormatOf(pathFromUtf8(file))
                                                     : landmark_files::formatOf(pathFromUtf8(file));
    if (!format) {
        complain(tr("%1: the name does not tell the format; give %2, one of %3",
                    file != "-"                       ? file
                    : option == std::string("--from") ? "stdin"
                                                      : "stdout",
                    option, isRead ? readWords() : writtenWords()));
    }
    return format;
}

} // namespace unprojector::cli
