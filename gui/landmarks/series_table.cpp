#include "gui/landmarks/series_table.h"

#include "core/files/path_text.h"
#include "core/files/replace_file.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/repeats_table.h"
#include "core/landmarks/point_template.h"
#include "gui/landmarks/scan_series.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>

#include <algorithm>
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

/// The landmarks of all scans with any, all in the same order, as tables of numbers need them.
std::vector<LandmarkSet> alignedSets(const std::vector<Scan> &scans, std::vector<Landmark> names)
{
    for (const Scan &scan : scans)
        names = landmarks::withTemplate(std::move(names), scan.points.landmarks);
    std::vector<LandmarkSet> sets;
    for (const Scan &scan : scans) {
        if (scan.placedCount() == 0)
            continue;
        LandmarkSet set = scan.points;
        set.name = files::utf8FromPath(scan.file.stem());
        if (std::any_of(sets.begin(), sets.end(), [&](const LandmarkSet &other) { return other.name == set.name; }))
            set.name = files::utf8FromPath(scan.file.filename());
        std::vector<Landmark> inOrder;
        std::vector<Landmark> left = std::move(set.landmarks);
        for (const Landmark &name : names) {
            const auto found = std::find_if(left.begin(), left.end(), [&](const Landmark &landmark) {
                return QString::fromStdString(landmark.name)
                           .compare(QString::fromStdString(name.name), Qt::CaseInsensitive)
                       == 0;
            });
            inOrder.push_back(found != left.end() ? *found : name);
            if (found != left.end())
                left.erase(found);
        }
        set.landmarks = std::move(inOrder);
        sets.push_back(std::move(set));
    }
    return sets;
}

/// The scans with their landmarks of every placing.
/// @param problems  read errors
/// @param said      the data in the table, in words
std::vector<RepeatedSpecimen> repeatedScans(const std::vector<Scan> &scans, QStringList &problems, QString &said)
{
    std::size_t repeated = 0;
    int most = 0;
    std::vector<RepeatedSpecimen> specimens;
    for (const Scan &scan : scans) {
        RepeatedSpecimen &specimen = specimens.emplace_back();
        specimen.name = files::utf8FromPath(scan.file.stem());
        std::error_code error;
        for (int placing = 1; placing <= kMostPlacings; ++placing) {
            if (!std::filesystem::exists(landmarksBeside(scan.file, placing), error))
                continue; // an observer who has not placed this scan
            most = std::max(most, placing);
            Scan placed{scan.file, {}, {}};
            readKept(placed, placing);
            if (placed.isDamaged) {
                problems << placed.problem;
                continue;
            }
            specimen.placings.push_back(std::move(placed.points));
            specimen.files.push_back(files::utf8FromPath(landmarksBeside(scan.file, placing).filename()));
        }
        if (specimen.placings.size() > 1)
            ++repeated;
    }
    said =
        repeated > 0
            ? Texts::tr("Scans that were placed more than once: %1; placings up to number %2.").arg(repeated).arg(most)
            : Texts::tr(
                "No scan was placed more than once, so there is no scatter: set Placing to 2 and go through the "
                "scans again.");
    return specimens;
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

/// Returns whether a file is a scan of the series or one of its landmark files.
bool holds(const std::vector<Scan> &scans, const std::filesystem::path &file)
{
    return std::any_of(scans.begin(), scans.end(), [&file](const Scan &scan) {
        bool isIt = files::isSameFile(scan.file, file);
        for (int placing = 1; placing <= kMostPlacings && !isIt; ++placing)
            isIt = files::isSameFile(landmarksBeside(scan.file, placing), file);
        return isIt;
    });
}

} // namespace

Result<WrittenSeries, QString> writeSeries(const std::filesystem::path &file, SeriesTable table,
                                           const std::vector<Scan> &scans, const std::vector<Landmark> &names)
{
    if (holds(scans, file))
        return Texts::tr("%1: the series uses this file and it would be destroyed. Choose another name.")
            .arg(pathText(file));
    const std::vector<LandmarkSet> sets = alignedSets(scans, names);
    if (sets.empty())
        return Texts::tr("No scan of the series has a landmark yet. Place one first.");
    QStringList problems = table == SeriesTable::Repeats ? QStringList() : leftOut(scans);
    QString ofRepeats;
    const auto textOf = [&]() -> Result<WrittenLandmarks, LandmarkFileError> {
        switch (table) {
        case SeriesTable::Long: return landmarksText(sets, Format::Csv);
        case SeriesTable::Wide: return wideTable(sets);
        case SeriesTable::Tps: return landmarksText(sets, Format::Tps);
        case SeriesTable::Nts: return landmarksText(sets, Format::Nts);
        case SeriesTable::Repeats: return repeatsTable(repeatedScans(scans, problems, ofRepeats));
        }
        return WrittenLandmarks{};
    };
    const auto text = textOf();
    if (!text) {
        LandmarkFileError error = text.error();
        error.file = files::utf8FromPath(file);
        return QString::fromStdString(errorText(error));
    }
    if (const files::Written written = files::replaceFile(file, text->text); !written)
        return QStringLiteral("%1: %2").arg(pathText(file),
                                            QString::fromStdString(files::fileErrorText(written.error())));
    if (!problems.isEmpty())
        problems.prepend(Texts::tr("Missing in %1, because they could not be read:").arg(pathText(file.filename())));
    if (const QString lost = landmarkNotesText(pathText(file.filename()), text->notes); !lost.isEmpty())
        problems << lost;
    const QString warning = problems.join(u'\n');
    if (table == SeriesTable::Repeats)
        return WrittenSeries{
            warning, joinSentences({Texts::tr("Repeats written to %1.").arg(pathText(file.filename())), ofRepeats})};
    const std::size_t without = scans.size() - sets.size();
    return WrittenSeries{
        warning, without > 0 ? Texts::tr("Scans written to %1: %2. Left out, without a landmark: %3.")
                                   .arg(pathText(file.filename()))
                                   .arg(sets.size())
                                   .arg(without)
                             : Texts::tr("Scans written to %1: %2.").arg(pathText(file.filename())).arg(sets.size())};
}

} // namespace unprojector::gui
