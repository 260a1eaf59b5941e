// The tables of a series: of all its scans, and of how their points scatter.

#include "core/files/path_text.h"
#include "core/files/replace_file.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmarks/point_template.h"
#include "gui/landmarks/scan_series.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/text/sentences.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {

using namespace landmark_files;

/// Each with all names in the same order, as tables of numbers have them.
std::vector<landmarks::LandmarkSet> ScanSeries::alignedSets() const
{
    std::vector<Landmark> names = m_names;
    for (const Scan &scan : m_scans)
        names = landmarks::withTemplate(std::move(names), scan.points.landmarks);
    std::vector<landmarks::LandmarkSet> sets;
    for (const Scan &scan : m_scans) {
        if (scan.placedCount() == 0)
            continue;
        landmarks::LandmarkSet set = scan.points;
        set.name = files::utf8FromPath(scan.file.stem());
        if (std::any_of(sets.begin(), sets.end(), [&](const LandmarkSet &other) { return other.name == set.name; }))
            set.name = files::utf8FromPath(scan.file.filename());
        std::vector<Landmark> inOrder;
        std::vector<Landmark> left = std::move(set.landmarks);
        for (const Landmark &name : names) {
            const auto found = std::find_if(left.begin(), left.end(), [&](const Landmark &point) {
                return QString::fromStdString(point.name)
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

std::vector<RepeatedSpecimen> ScanSeries::repeatedScans(QStringList &problems, QString &said) const
{
    std::size_t repeated = 0;
    int most = 0;
    std::vector<RepeatedSpecimen> specimens;
    for (const Scan &scan : m_scans) {
        RepeatedSpecimen &specimen = specimens.emplace_back();
        specimen.name = files::utf8FromPath(scan.file.stem());
        std::error_code error;
        for (int placing = 1; placing <= kMostPlacings; ++placing) {
            if (!std::filesystem::exists(landmarksBeside(scan.file, placing), error))
                continue; // an observer who has not come so far
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
    said = repeated > 0
               ? tr("Scans that were placed more than once: %1; placings up to number %2.").arg(repeated).arg(most)
               : tr("No scan was placed more than once, so there is no scatter: set Placing to 2 and go through the "
                    "scans again.");
    return specimens;
}

QStringList ScanSeries::leftOut() const
{
    QStringList problems;
    for (const Scan &scan : m_scans) {
        if (scan.isDamaged)
            problems << scan.problem;
    }
    return problems;
}

bool ScanSeries::holds(const std::filesystem::path &file) const
{
    return std::any_of(m_scans.begin(), m_scans.end(), [&file](const Scan &scan) {
        bool isIt = files::isSameFile(scan.file, file);
        for (int placing = 1; placing <= kMostPlacings && !isIt; ++placing)
            isIt = files::isSameFile(landmarksBeside(scan.file, placing), file);
        return isIt;
    });
}

bool ScanSeries::exportTable(const std::filesystem::path &file, Table table)
{
    if (!keep())
        return false;
    if (holds(file)) {
        emit failed(
            tr("%1: the series has this file, which would be destroyed. Give another name.").arg(pathText(file)));
        return false;
    }
    const std::vector<landmarks::LandmarkSet> sets = alignedSets();
    if (sets.empty()) {
        emit failed(tr("On no scan of the series is a point yet."));
        return false;
    }
    QStringList problems = table == Table::Repeats ? QStringList() : leftOut();
    QString ofRepeats;
    const auto textOf = [&]() -> Result<WrittenLandmarks, LandmarkFileError> {
        switch (table) {
        case Table::Long: return landmarksText(sets, Format::Csv);
        case Table::Wide: return wideTable(sets);
        case Table::Tps: return landmarksText(sets, Format::Tps);
        case Table::Nts: return landmarksText(sets, Format::Nts);
        case Table::Repeats: return repeatsTable(repeatedScans(problems, ofRepeats));
        }
        return WrittenLandmarks{};
    };
    const auto text = textOf();
    if (!text) {
        LandmarkFileError error = text.error();
        error.file = files::utf8FromPath(file);
        emit failed(QString::fromStdString(errorText(error)));
        return false;
    }
    if (const files::Written written = files::replaceFile(file, text->text); !written) {
        emit failed(QStringLiteral("%1: %2").arg(pathText(file),
                                                 QString::fromStdString(files::fileErrorText(written.error()))));
        return false;
    }
    if (!problems.isEmpty())
        problems.prepend(tr("Not in %1, since they could not be read:").arg(pathText(file.filename())));
    if (const QString lost = pointNotesText(pathText(file.filename()), text->notes); !lost.isEmpty())
        problems << lost;
    if (!problems.isEmpty())
        emit warned(problems.join(u'\n'));
    if (table == Table::Repeats) {
        emit noticed(inARow({tr("Repeats written to %1.").arg(pathText(file.filename())), ofRepeats}));
        return true;
    }
    const std::size_t without = m_scans.size() - sets.size();
    emit noticed(without > 0 ? tr("Scans written to %1: %2. Not in it, without a point: %3.")
                                   .arg(pathText(file.filename()))
                                   .arg(sets.size())
                                   .arg(without)
                             : tr("Scans written to %1: %2.").arg(pathText(file.filename())).arg(sets.size()));
    return true;
}

} // namespace unprojector::gui
