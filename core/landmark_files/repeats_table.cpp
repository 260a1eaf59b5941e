#include "core/landmark_files/repeats_table.h"

#include "core/base/translation.h"
#include "core/landmark_files/lines.h"
#include "core/landmarks/distinct_names.h"
#include "core/landmarks/repeats.h"

#include <optional>
#include <utility>

namespace unprojector::landmark_files {
using base::tr;
using landmarks::RepeatedLandmark;

base::Expected<WrittenLandmarks, base::Error> repeatsTable(std::span<const RepeatedSpecimen> specimens,
                                                           base::CellTexts texts)
{
    return caught([&] {
        Notes notes;
        for (const RepeatedSpecimen &specimen : specimens) {
            checkUnits(specimen.placings, specimen.files, notes);
            addNameNotes(notes, landmarks::distinctNames(specimen.placings), specimen.placings, specimen.files);
        }
        std::string text = "specimen,name,placings,x,y,z,error,farthest\n";
        base::RowWriter row(text, texts);
        for (const RepeatedSpecimen &specimen : specimens) {
            for (const RepeatedLandmark &repeated : landmarks::repeatsOf(specimen.placings)) {
                row.text(specimen.name);
                row.text(repeated.name);
                row.plain(std::to_string(repeated.count));
                for (int axis = 0; axis < 3; ++axis)
                    row.numberOr("", repeated.mean ? std::optional((*repeated.mean)[axis]) : std::nullopt);
                row.numberOr("", repeated.error);
                if (repeated.mean)
                    row.numberOrNothing(repeated.farthest);
                else
                    row.nothing();
                row.endRow();
            }
        }
        return WrittenLandmarks{std::move(text), notes.take()};
    });
}

landmarks::MeasurementError measurementErrorOf(std::span<const RepeatedSpecimen> specimens)
{
    std::vector<std::vector<landmarks::LandmarkSet>> placings;
    for (const RepeatedSpecimen &specimen : specimens)
        placings.push_back(specimen.placings);
    return landmarks::measurementErrorOf(placings);
}

std::vector<std::string> errorRemarks(const landmarks::MeasurementError &error)
{
    std::vector<std::string> remarks;
    if (error.all.specimens == 0)
        remarks.push_back(tr("no landmark was placed twice on a specimen, so there is no error of measurement"));
    else if (error.specimens - error.notAligned < 2)
        remarks.push_back(tr("the intraclass correlation needs two specimens with three landmarks or more that are "
                             "not on a line"));
    else if (error.notAligned > 0)
        remarks.push_back(tr("specimens that cannot be aligned with the others, because they have fewer than three "
                             "landmarks or all on a line: %1; the intraclass correlation leaves them out",
                             error.notAligned));
    return remarks;
}

base::Expected<WrittenLandmarks, base::Error> errorsTable(std::span<const RepeatedSpecimen> specimens,
                                                          base::CellTexts texts)
{
    return caught([&] {
        Notes notes;
        RepeatedSpecimen all; // an error over all specimens has one unit
        for (const RepeatedSpecimen &specimen : specimens) {
            for (const landmarks::LandmarkSet &placing : specimen.placings)
                all.placings.emplace_back().unit = placing.unit;
            all.files.insert(all.files.end(), specimen.files.begin(), specimen.files.end());
        }
        checkUnits(all.placings, all.files, notes);
        const landmarks::MeasurementError found = measurementErrorOf(specimens);
        std::string text = "landmark,specimens,placings,error,icc1,icc2";
        for (const int placing : found.placings)
            text += ",error_" + std::to_string(placing) + ",bias_" + std::to_string(placing);
        text += '\n';
        base::RowWriter row(text, texts);
        const auto append = [&row](const std::string &name, const landmarks::LandmarkError &error) {
            row.text(name);
            row.plain(std::to_string(error.specimens));
            row.plain(std::to_string(error.placings));
            for (const std::optional<double> &value : {error.error, error.icc1, error.icc2})
                row.numberOr("NA", value);
            for (const landmarks::PlacingError &placing : error.byPlacing) {
                row.numberOr("NA", placing.error);
                row.numberOr("NA", placing.bias);
            }
            row.endRow();
        };
        for (const landmarks::LandmarkError &error : found.landmarks)
            append(error.name, error);
        append("(all)", found.all);
        return WrittenLandmarks{std::move(text), notes.take()};
    });
}

} // namespace unprojector::landmark_files
