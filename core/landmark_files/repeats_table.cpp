#include "core/landmark_files/repeats_table.h"

#include "core/landmark_files/lines.h"
#include "core/landmarks/repeats.h"
#include "core/text/number_text.h"
#include "core/text/translation.h"

#include <cmath>
#include <optional>
#include <utility>

namespace unprojector::landmark_files {
using landmarks::RepeatedLandmark;
using text::tr;
namespace {

/// True for equal units; "mm" and " MM" are equal.
bool isSameUnit(const std::string &a, const std::string &b)
{
    return lowerCase(trimmed(a)) == lowerCase(trimmed(b));
}

/// Checks the units, because a mean of coordinates in several units has none. Throws Failure.
void checkUnits(const RepeatedSpecimen &specimen, Notes &notes)
{
    const auto unitOf = [&specimen](std::size_t i) { return specimen.placings[i].unit; };
    std::optional<std::size_t> with, without;
    for (std::size_t i = 0; i < specimen.placings.size(); ++i) {
        std::optional<std::size_t> &first = unitOf(i).empty() ? without : with;
        first = first.value_or(i);
        if (!unitOf(i).empty() && !isSameUnit(unitOf(i), unitOf(*with)))
            throw Failure{0,
                          tr("%1 is in %2 and %3 in %4; write both in the same unit first", specimen.files[*with],
                             unitOf(*with), specimen.files[i], unitOf(i)),
                          LandmarkFileError::Code::CannotHold};
    }
    if (with && without)
        notes.add(LandmarkNote::Kind::UnitUnknown, 1,
                  tr("%1 is in %2, and %3 does not say its unit", specimen.files[*with], unitOf(*with),
                     specimen.files[*without]));
}

} // namespace

geometry::Result<WrittenLandmarks, LandmarkFileError> repeatsTable(std::span<const RepeatedSpecimen> specimens,
                                                                   text::CellTexts texts)
{
    Notes notes;
    try {
        for (const RepeatedSpecimen &specimen : specimens)
            checkUnits(specimen, notes);
    } catch (const Failure &failure) {
        return LandmarkFileError{failure.code, {}, failure.line, failure.text};
    }
    std::string text = "specimen,name,placings,x,y,z,error,farthest\n";
    for (const RepeatedSpecimen &specimen : specimens) {
        for (const RepeatedLandmark &repeated : landmarks::repeatsOf(specimen.placings)) {
            appendCell(text, specimen.name, texts);
            text += ',';
            appendCell(text, repeated.name, texts);
            text += ',' + std::to_string(repeated.count);
            for (int axis = 0; axis < 3; ++axis) {
                text += ',';
                if (repeated.mean)
                    text::appendNumber(text, (*repeated.mean)[axis]);
            }
            text += ',';
            if (repeated.error)
                text::appendNumber(text, *repeated.error);
            text += ',';
            if (repeated.mean && std::isfinite(repeated.farthest))
                text::appendNumber(text, repeated.farthest);
            text += '\n';
        }
    }
    return WrittenLandmarks{std::move(text), notes.take()};
}

} // namespace unprojector::landmark_files
