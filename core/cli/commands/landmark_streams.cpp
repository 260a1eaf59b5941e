#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/commands/landmarks_command.h"
#include "core/cli/terminal/refusal.h"
#include "core/landmark_files/landmark_folder.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace unprojector::cli {
using namespace landmarks;
using namespace landmark_files;
using namespace base;

namespace {

/// Prints the notes of a file on stderr.
void tell(const std::string &name, const std::vector<Note> &notes)
{
    std::vector<FileNote> ofFile;
    ofFile.reserve(notes.size());
    for (const Note &note : notes)
        ofFile.push_back({name, note});
    for (const std::string &line : noteLines(ofFile))
        complain(line);
}

} // namespace

ReadLandmarks readFile(const std::string &file, Format format)
{
    ByteSource source(file);
    const std::string text = source.readAll(kMostLandmarkBytes);
    Expected<ReadLandmarks, Error> read = parseLandmarks(text, format, source.name());
    if (!read)
        refuse(read.error().message());
    tell(source.name(), read->notes);
    const auto isEmpty = [](const LandmarkSet &set) { return set.landmarks.empty() && set.curves.empty(); };
    if (std::all_of(read->sets.begin(), read->sets.end(), isEmpty))
        complain(tr("%1: there are no points in the file", source.name()));
    return std::move(read).value();
}

ExitCode write(const std::string &file, const Expected<WrittenLandmarks, Error> &text, const InputFiles &inputs)
{
    const std::string name = outputName(file);
    if (!text) {
        Error error = text.error();
        error.file = name;
        refuse(error.message());
    }
    ByteSink sink(file, inputs);
    sink.write(text->text);
    const ExitCode written = sink.finish();
    if (written == ExitCode::Done)
        tell(name, text->notes);
    return written;
}

ExitCode writeSliders(const std::string &file, const Expected<Sliders, Error> &sliders, const InputFiles &inputs,
                      ExitCode written)
{
    if (file.empty() || written == ExitCode::UnusableInput)
        return written;
    if (!sliders || sliders->count == 0) {
        complain(file + ": "
                 + (sliders ? tr("it is not written, because no curve has semilandmarks") : sliders.error().message()));
        return ExitCode::SomeRowsBad;
    }
    ByteSink sink(file, inputs);
    sink.write(sliders->text);
    if (const ExitCode finished = sink.finish(); finished != ExitCode::Done)
        return finished;
    complain(file + ": "
             + tr(sliders->count == 1 ? "%1 slider, for geomorph's gpagen(curves=)"
                                      : "%1 sliders, for geomorph's gpagen(curves=)",
                  sliders->count));
    return written;
}

Format formatOf(const std::string &file, const std::optional<Format> &given, const char *option)
{
    if (given)
        return *given;
    const bool isRead = option == std::string_view("--from");
    const std::optional<Format> format = file == "-" ? std::nullopt
                                         : isRead    ? readFormatOf(pathFromUtf8(file))
                                                     : landmark_files::formatOf(pathFromUtf8(file));
    if (!format)
        refuse(tr("%1: the name does not tell the format; give %2, one of %3",
                  isRead ? inputName(file) : outputName(file), option, isRead ? readWords() : writtenWords()));
    return *format;
}

} // namespace unprojector::cli
