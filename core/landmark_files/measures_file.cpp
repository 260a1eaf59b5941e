#include "core/landmark_files/measures_file.h"

#include "core/base/csv.h"
#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"
#include "core/landmarks/protocol.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace unprojector::landmark_files {
using namespace landmarks;
using base::CsvRow;
using base::Error;
using base::Expected;
using base::tr;
namespace {

std::string kindWords()
{
    std::string words;
    for (const char *kind : kMeasureKinds)
        words += (words.empty() ? "" : ", ") + std::string(kind);
    return words;
}

/// The measure of a row.
KeptMeasure measureOf(CsvRow &row)
{
    while (!row.cells.empty() && row.cells.back().text.empty()) // padding of a spreadsheet
        row.cells.pop_back();
    KeptMeasure measure;
    measure.name = row.text(0);
    if (measure.name.empty())
        fail(row.line, tr("the measure has no name; write one into the first cell"));
    const std::string kind = lowerCase(row.text(1));
    const auto known = std::find(kMeasureKinds.begin(), kMeasureKinds.end(), kind);
    if (known == kMeasureKinds.end())
        fail(row.line, tr("\"%1\" is no kind of measure; write one of %2", kind, kindWords()));
    measure.kind = static_cast<MeasureKind>(known - kMeasureKinds.begin());
    for (std::size_t i = 2; i < row.cells.size(); ++i) {
        if (row.cells[i].text.empty())
            fail(row.line, tr("there is an empty cell between the landmarks of \"%1\"; remove it", measure.name));
        measure.landmarks.emplace_back(row.cells[i].text);
    }
    const MeasureSize size = sizeOf(measure.kind);
    const std::size_t count = measure.landmarks.size();
    if (count < size.fewest || count > size.most)
        fail(row.line, tr(size.most == size.fewest ? "a measure of the kind %1 has %2 landmarks, and \"%3\" has %4"
                                                   : "a measure of the kind %1 has %2 landmarks or more, and "
                                                     "\"%3\" has %4",
                          kind, size.fewest, measure.name, count));
    return measure;
}

} // namespace

bool isMeasuresFile(const std::filesystem::path &file)
{
    constexpr std::string_view kSuffix = ".measures.csv";
    return lowerCase(base::utf8FromPath(file.filename())).ends_with(kSuffix);
}

Expected<std::vector<KeptMeasure>, Error> parseMeasures(std::string_view text, const std::string &name)
{
    const auto parse = [&] {
        checkText(text);
        const std::optional<char> separator = base::takeSeparatorLine(text);
        const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
        base::CsvReader reader(text, separator.value_or(base::csvSeparatorOf(first)));
        const bool hasHeader =
            reader.next() && lowerCase(reader.row().text(0)) == "name" && lowerCase(reader.row().text(1)) == "kind";
        if (!hasHeader && !reader.error())
            fail(1, tr("this is no list of measures; its first line is name,kind,landmarks"));
        std::vector<KeptMeasure> measures;
        std::set<std::string> names;
        while (reader.next()) {
            if (reader.row().isPadding())
                continue;
            measures.push_back(measureOf(reader.row()));
            if (!names.insert(measures.back().name).second)
                fail(reader.row().line,
                     tr("the measure \"%1\" is there twice; rename one of them", measures.back().name));
        }
        if (reader.error())
            fail(reader.error()->line, reader.error()->text);
        return measures;
    };
    return caught(parse, name);
}

Expected<std::vector<KeptMeasure>, Error> readMeasures(const std::filesystem::path &file)
{
    const Expected<std::string, Error> text = readText(file);
    if (!text)
        return text.error();
    return parseMeasures(*text, base::utf8FromPath(file));
}

std::string measuresText(std::span<const KeptMeasure> measures)
{
    std::string text = "name,kind,landmarks\n";
    base::RowWriter row(text);
    for (const KeptMeasure &measure : measures) {
        row.text(measure.name);
        row.plain(kMeasureKinds[static_cast<std::size_t>(measure.kind)]);
        std::for_each(measure.landmarks.begin(), measure.landmarks.end(), [&row](const auto &name) { row.text(name); });
        row.endRow();
    }
    return text;
}

} // namespace unprojector::landmark_files
