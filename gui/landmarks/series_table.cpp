#include "gui/landmarks/series_table.h"

#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/curves/measured_sets.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/measures_file.h"
#include "core/landmark_files/specimen_table.h"
#include "core/landmarks/protocol.h"
#include "gui/document/landmark_files.h"
#include "gui/landmarks/scan_series.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace landmarks;

namespace {

using namespace landmark_files;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::SeriesTable)
};

/// A scan's name in tables: without its suffix, if no other scan has that name.
std::string nameIn(const std::vector<Scan> &scans, const Scan &scan)
{
    const auto count = std::count_if(scans.begin(), scans.end(),
                                     [&scan](const Scan &other) { return other.file.stem() == scan.file.stem(); });
    return base::utf8FromPath(count > 1 ? scan.file.filename() : scan.file.stem());
}

/// A scan with the landmarks of one placing as saved; nothing if it has none.
/// @param problems  gets the error if they cannot be read
std::optional<LandmarkSet> savedPlacing(const Scan &scan, int placing, QStringList &problems)
{
    std::error_code error;
    if (!std::filesystem::exists(landmarksBeside(scan.file, placing), error))
        return std::nullopt; // an observer who has not placed this scan
    Scan placed{scan.file, {}, {}};
    readKept(placed, placing);
    if (placed.isDamaged) {
        problems << placed.problem;
        return std::nullopt;
    }
    placed.points.placing = placing;
    return std::move(placed.points);
}

/// The specimens of a table, and the file of each one's scan.
struct Specimens {
    std::vector<LandmarkSet> sets;
    std::vector<std::filesystem::path> scans;
    std::size_t scanCount = 0; ///< with any landmark
};

bool isAnyPlaced(const LandmarkSet &set)
{
    return std::any_of(set.landmarks.begin(), set.landmarks.end(),
                       [](const Landmark &landmark) { return landmark.isPlaced(); });
}

/// @param hasAllPlacings  else only the shown one
Specimens specimensOf(const SeriesContent &content, bool hasAllPlacings, QStringList &problems)
{
    Specimens specimens;
    for (const Scan &scan : content.scans) {
        const std::size_t before = specimens.sets.size();
        for (int placing = 1; placing <= kMostPlacings; ++placing) {
            std::optional<LandmarkSet> set;
            if (placing == content.placing)
                set = scan.points;
            else if (hasAllPlacings)
                set = savedPlacing(scan, placing, problems);
            if (!set || !isAnyPlaced(*set))
                continue;
            set->name = nameIn(content.scans, scan);
            set->placing = placing;
            specimens.sets.push_back(std::move(*set));
            specimens.scans.push_back(scan.file);
        }
        specimens.scanCount += specimens.sets.size() > before ? 1U : 0U;
    }
    return specimens;
}

/// The number of placings, besides the shown one, that hold a landmark.
std::size_t otherPlacings(const SeriesContent &content)
{
    std::size_t count = 0;
    QStringList problems; // a table without them lacks nothing
    for (const Scan &scan : content.scans) {
        for (int placing = 1; placing <= kMostPlacings; ++placing) {
            const auto set = placing != content.placing ? savedPlacing(scan, placing, problems) : std::nullopt;
            count += set && isAnyPlaced(*set) ? 1U : 0U;
        }
    }
    return count;
}

/// The values of the protocol for each specimen; nothing if the user cancelled.
std::optional<std::vector<std::vector<ProtocolValue>>> measured(const Specimens &specimens,
                                                                const SeriesContent &content)
{
    const auto modelOf = [&](std::size_t i) -> Result<std::filesystem::path, std::string> {
        return specimens.scans[i];
    };
    const auto goesOn = [&](std::size_t i) { return !content.goesOn || content.goesOn(i, specimens.sets.size()); };
    return curves::measuredSets(specimens.sets, content.measures, modelOf, goesOn);
}

TableForm formOf(SeriesTable table)
{
    switch (table) {
    case SeriesTable::Long: return TableForm::Long;
    case SeriesTable::Wide: return TableForm::Wide;
    case SeriesTable::Nts: return TableForm::Nts;
    case SeriesTable::Tps:
    case SeriesTable::Repeats:
    case SeriesTable::Errors: break;
    }
    return TableForm::Tps;
}

/// The data missing from a table.
QStringList leftOut(const std::vector<Scan> &scans)
{
    QStringList problems;
    for (const Scan &scan : scans) {
        if (scan.isDamaged)
            problems << scan.problem;
    }
    return problems;
}

/// Returns whether a file is a scan of the series or a file that it keeps.
bool holds(const std::vector<Scan> &scans, const std::filesystem::path &file)
{
    return std::any_of(scans.begin(), scans.end(), [&file](const Scan &scan) {
        bool isIt = base::isSameFile(scan.file, file)
                    || base::isSameFile(scan.file.parent_path() / kSeriesMeasures, file)
                    || base::isSameFile(seriesTemplate(scan.file.parent_path()), file);
        for (int placing = 1; placing <= kMostPlacings && !isIt; ++placing)
            isIt = base::isSameFile(landmarksBeside(scan.file, placing), file);
        return isIt;
    });
}

/// Writes a file.
/// @return why it was not written; empty: no error
QString writtenTo(const std::filesystem::path &file, const std::string &text)
{
    const base::Done written = base::replaceFile(file, text);
    return written ? QString()
                   : QStringLiteral("%1: %2").arg(pathText(file), QString::fromStdString(written.error().text));
}

QString reasonOf(base::Error error, const std::filesystem::path &file)
{
    error.file = base::utf8FromPath(file);
    return QString::fromStdString(error.message());
}

/// The warning about what a table lacks.
QString warningOf(const std::filesystem::path &file, QStringList problems, const std::vector<base::Note> &notes)
{
    if (!problems.isEmpty())
        problems.prepend(Texts::tr("Missing in %1, because they could not be read:").arg(pathText(file.filename())));
    if (const QString lost = landmarkNotesText(pathText(file.filename()), notes); !lost.isEmpty())
        problems << lost;
    return problems.join(u'\n');
}

Result<WrittenSeries, QString> writeRepeats(const std::filesystem::path &file, SeriesTable table,
                                            const SeriesContent &content)
{
    const SeriesRepeats repeats = repeatsIn(content.scans);
    const auto text = table == SeriesTable::Repeats ? repeatsTable(repeats.specimens) : errorsTable(repeats.specimens);
    if (!text)
        return reasonOf(text.error(), file);
    if (QString reason = writtenTo(file, text->text); !reason.isEmpty())
        return reason;
    return WrittenSeries{
        warningOf(file, repeats.problems, text->notes),
        joinSentences({Texts::tr("Repeats written to %1.").arg(pathText(file.filename())), repeats.summary})};
}

/// Remarks on a table, besides its number of scans.
QStringList remarksOn(const WrittenTable &table, const ProtocolColumns &protocol, const SeriesContent &content)
{
    QStringList remarks;
    if (content.placing > 1)
        remarks << Texts::tr("Placing shown: %1.").arg(content.placing);
    if (const std::string absent = absentText(table.absent); !absent.empty())
        remarks << sentence(absent);
    for (const std::string &text : unmeasuredTexts(protocol))
        remarks << sentence(text);
    return remarks;
}

} // namespace

SeriesRepeats repeatsIn(const std::vector<Scan> &scans)
{
    SeriesRepeats repeats;
    std::size_t repeated = 0;
    int most = 0;
    for (const Scan &scan : scans) {
        RepeatedSpecimen specimen;
        specimen.name = nameIn(scans, scan);
        for (int placing = 1; placing <= kMostPlacings; ++placing) {
            std::optional<LandmarkSet> set = savedPlacing(scan, placing, repeats.problems);
            if (!set || !isAnyPlaced(*set))
                continue;
            most = std::max(most, placing);
            specimen.placings.push_back(std::move(*set));
            specimen.files.push_back(base::utf8FromPath(landmarksBeside(scan.file, placing).filename()));
        }
        if (specimen.placings.size() > 1)
            ++repeated;
        if (!specimen.placings.empty())
            repeats.specimens.push_back(std::move(specimen));
    }
    repeats.summary =
        repeated > 0
            ? Texts::tr("Scans that were placed more than once: %1; placings up to number %2.").arg(repeated).arg(most)
            : Texts::tr(
                "No scan was placed more than once, so there is no scatter: set Placing to 2 and go through the "
                "scans again.");
    return repeats;
}

Result<WrittenSeries, QString> writeSeries(const std::filesystem::path &file, SeriesTable table,
                                           const SeriesContent &content)
{
    if (holds(content.scans, file))
        return Texts::tr("%1: the series uses this file and it would be destroyed. Choose another name.")
            .arg(pathText(file));
    if (table == SeriesTable::Repeats || table == SeriesTable::Errors)
        return writeRepeats(file, table, content);
    const bool hasRows = table == SeriesTable::Wide || table == SeriesTable::Long;
    QStringList problems = leftOut(content.scans);
    const Specimens specimens = specimensOf(content, hasRows, problems);
    if (specimens.sets.empty())
        return Texts::tr("No scan of the series has a landmark yet. Place one first.");
    std::vector<std::vector<ProtocolValue>> values(specimens.sets.size(),
                                                   std::vector<ProtocolValue>(content.measures.size()));
    if (hasRows) {
        auto known = measured(specimens, content);
        if (!known)
            return Texts::tr("The export was cancelled. %1 was not written.").arg(pathText(file.filename()));
        values = std::move(*known);
    }
    const ProtocolColumns protocol{content.measures, values};
    const auto text = specimenTable(specimens.sets, formOf(table), protocol, content.names);
    if (!text)
        return reasonOf(text.error(), file);
    if (QString reason = writtenTo(file, text->text); !reason.isEmpty())
        return reason;
    const std::size_t without = content.scans.size() - specimens.scanCount;
    const QString name = pathText(file.filename());
    const QString written = without > 0 ? Texts::tr("Scans written to %1: %2. Left out, without a landmark: %3.")
                                              .arg(name)
                                              .arg(specimens.scanCount)
                                              .arg(without)
                                        : Texts::tr("Scans written to %1: %2.").arg(name).arg(specimens.scanCount);
    QStringList remarks = remarksOn(*text, hasRows ? protocol : ProtocolColumns(), content);
    const SlidersReport sliders = writeSliders(file, text->sliders);
    QStringList warnings = sliders.lost;
    if (const QString warning = warningOf(file, problems, text->notes); !warning.isEmpty())
        warnings.prepend(warning);
    if (const std::size_t others = hasRows ? 0 : otherPlacings(content); others > 0) // first: a message may be folded
        warnings.prepend(landmarkNotesText(name, {repeatsLeftOut(others)}));
    return WrittenSeries{warnings.join(u'\n'), joinSentences(QStringList{written} + remarks + sliders.said)};
}

} // namespace unprojector::gui
