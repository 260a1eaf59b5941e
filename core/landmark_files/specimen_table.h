#pragma once

#include "core/base/csv.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/sliders.h"
#include "core/landmarks/landmark.h"
#include "core/landmarks/protocol.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmark_files {

enum class TableForm {
    Long, ///< a row a landmark, as this program's files
    Wide, ///< a row a specimen: specimen,A_x,A_y,A_z,B_x,…
    Tps,
    Nts,
};

/// A protocol as columns of a table.
struct ProtocolColumns {
    std::span<const landmarks::KeptMeasure> measures;
    /// The values of each specimen, one per measure.
    std::span<const std::vector<landmarks::ProtocolValue>> values;
};

/// The number of landmarks without coordinates in a table, by Absence.
struct AbsentLandmarks {
    std::size_t notPlaced = 0, skipped = 0, missing = 0;
    std::size_t all() const { return notPlaced + skipped + missing; }
};
/// "12 landmarks have no coordinates: 9 not placed, 1 skipped, 2 missing on their specimens"; empty
/// for none.
std::string absentText(const AbsentLandmarks &absent);

/// A sentence without a full stop for each measure that some specimens lack.
std::vector<std::string> unmeasuredTexts(const ProtocolColumns &protocol);

struct WrittenTable {
    std::string text;
    std::vector<base::Note> notes;
    AbsentLandmarks absent;
    /// The sliders of the table's points; an error where the specimens have different curves.
    base::Expected<Sliders, base::Error> sliders = Sliders{};
};

/// A table of several specimens. Landmarks belong together by name, see distinctNames: each specimen
/// has the landmarks of all, in the order of first appearance, with NA (in NTSYS a number) for
/// coordinates that it lacks. So do curves. Where the curves differ, TPS has semilandmarks as
/// landmarks. A curve has the same number of semilandmarks on all specimens, except in Long.
///
/// If a specimen was placed several times, the tables have a column "placing". TPS and NTSYS have its
/// first placing only.
/// The columns of a protocol are "NAME" and "NAME_error", and "measures_note" with the reasons for
/// NA; TPS and NTSYS have none.
/// @param names  landmarks whose names come first; may be empty
/// @return an error, as landmarksText; specimens of several units, or curves with several numbers of
///         semilandmarks, except in Long; a measure with the name of another column
base::Expected<WrittenTable, base::Error> specimenTable(std::span<const landmarks::LandmarkSet> specimens,
                                                        TableForm form, const ProtocolColumns &protocol = {},
                                                        std::span<const landmarks::Landmark> names = {},
                                                        base::CellTexts texts = base::CellTexts::ReadBack);

/// A specimen with the landmarks of a list first, in its order, as in a table of specimens. Those
/// that it lacks have no position.
/// @param names  the list; only names count
landmarks::LandmarkSet inOrderOf(landmarks::LandmarkSet specimen, std::span<const landmarks::Landmark> names);

/// The text of a file in a format, for landmarks that come from another file. In TPS and NTSYS,
/// named landmarks of several specimens belong together by name, see specimenTable; else as
/// landmarksText.
/// @param source  name of specimens without a name, in NTSYS; empty: they stay without
/// @return the errors of specimenTable and landmarksText
base::Expected<WrittenTable, base::Error> convertedText(std::vector<landmarks::LandmarkSet> sets, Format to,
                                                        const std::string &source,
                                                        base::CellTexts texts = base::CellTexts::ReadBack);

} // namespace unprojector::landmark_files
