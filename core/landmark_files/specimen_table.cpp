#include "core/landmark_files/specimen_table.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/landmark_files/csv_columns.h"
#include "core/landmark_files/lines.h"
#include "core/landmarks/distinct_names.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace unprojector::landmark_files {
using namespace landmarks;
using base::marked;
using base::tr;
namespace {

constexpr const char *kNoteColumn = "measures_note";

/// Returns whether all sets have curves of the same names, each with as many semilandmarks beside its
/// landmarks.
bool haveSameCurves(std::span<const LandmarkSet> sets)
{
    const LandmarkSet &first = sets.front();
    const auto isIn = [&first](const Curve &curve, const LandmarkSet &set) {
        return std::any_of(set.curves.begin(), set.curves.end(), [&](const Curve &other) {
            const CurvePart part = partOf(other, set), wanted = partOf(curve, first);
            return other.name == curve.name && other.semilandmarks.size() == curve.semilandmarks.size()
                   && part.begin == wanted.begin && part.end == wanted.end;
        });
    };
    return std::all_of(sets.begin(), sets.end(), [&](const LandmarkSet &set) {
        return set.curves.size() == first.curves.size()
               && std::all_of(first.curves.begin(), first.curves.end(),
                              [&](const Curve &curve) { return isIn(curve, set); });
    });
}

/// Names a curve with different numbers of semilandmarks: those of a number are not at the same place of the curve
/// then. Empty if there is none. Specimens without semilandmarks don't count.
std::optional<base::Note> differentCounts(std::span<const LandmarkSet> sets)
{
    constexpr std::size_t kMostNamed = 3;                                             // of a number
    std::map<std::string, std::map<std::size_t, std::vector<std::string>>> specimens; // by curve and number
    for (const LandmarkSet &set : sets) {
        for (std::size_t k = 0; k < set.curves.size(); ++k) {
            if (const std::size_t count = set.curves[k].semilandmarks.size(); count > 0)
                specimens[nameOf(set.curves[k], k)][count].push_back(set.name);
        }
    }
    for (const auto &[curve, counts] : specimens) {
        if (counts.size() < 2)
            continue;
        std::string where;
        for (const auto &[count, names] : counts) {
            std::string list;
            for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i)
                list += (i > 0 ? ", " : "") + ('"' + names[i] + '"');
            if (names.size() > kMostNamed)
                list = tr("%1, … (%2 in all)", list, names.size());
            where += (where.empty() ? "" : "; ") + tr("%1 on %2", count, list);
        }
        return base::Note{marked("the curve \"%1\" has different numbers of semilandmarks, so they are not at the same "
                                 "places: %2; give it the same number on all specimens"),
                          {curve, where}};
    }
    return std::nullopt;
}

/// Sorts the curves of each set as in the first one. @pre haveSameCurves
void sortCurves(std::vector<LandmarkSet> &sets)
{
    for (LandmarkSet &set : sets) {
        std::vector<Curve> sorted;
        for (const Curve &first : sets.front().curves)
            sorted.push_back(*std::find_if(set.curves.begin(), set.curves.end(),
                                           [&first](const Curve &curve) { return curve.name == first.name; }));
        set.curves = std::move(sorted);
    }
}

/// Removes all placings of a specimen but its first one.
void removeRepeats(std::vector<LandmarkSet> &sets, Notes &notes)
{
    std::map<std::string, int> first;
    for (const LandmarkSet &set : sets) {
        int &placing = first.try_emplace(set.name, set.placing).first->second;
        placing = std::min(placing, set.placing);
    }
    const std::size_t count = std::erase_if(
        sets, [&first](const LandmarkSet &set) { return !set.name.empty() && set.placing > first[set.name]; });
    const base::Note left = repeatsLeftOut(count);
    notes.add({left.one, left.many}, count);
}

/// The names of sets in quotes.
std::vector<std::string> quotedNames(std::span<const LandmarkSet> sets)
{
    std::vector<std::string> names;
    for (const LandmarkSet &set : sets)
        names.push_back('"' + set.name + '"');
    return names;
}

/// Checks that no column of a protocol has the name of another column.
void checkColumns(const LandmarkSet &first, TableForm form, const ProtocolColumns &protocol)
{
    std::set<std::string> taken{"specimen", "placing", kNoteColumn};
    for (const Landmark &landmark : first.landmarks) {
        for (const char *axis : {"_x", "_y", "_z"}) {
            if (form == TableForm::Wide)
                taken.insert(landmark.name + axis);
        }
    }
    for (const KeptMeasure &measure : protocol.measures) {
        for (const char *part : {"", "_error"}) {
            if (!taken.insert(measure.name + part).second
                || (form == TableForm::Long && csv::columnOf(measure.name + part) < csv::kWrittenCount))
                fail(0,
                     tr("the measure \"%1\" needs a column \"%2\", and there is another one of that name; rename the "
                        "measure",
                        measure.name, measure.name + part));
        }
    }
}

/// Gives each set the landmarks of all sets, in the same order.
/// @param names  come first
void align(std::vector<LandmarkSet> &sets, std::span<const Landmark> names, Notes &notes)
{
    std::vector<LandmarkSet> all(1);
    for (const Landmark &name : names)
        all.front().landmarks.emplace_back().name = name.name;
    all.insert(all.end(), sets.begin(), sets.end());
    const DistinctNames distinct = distinctNames(all);
    const std::map<std::string, std::string> respelled(distinct.respelled.begin(), distinct.respelled.end());
    std::vector<std::string> shown = quotedNames(all);
    shown.front().clear();
    addNameNotes(notes, distinct, all, shown);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        std::vector<Landmark> aligned(distinct.names.size());
        for (std::size_t k = 0; k < sets[i].landmarks.size(); ++k)
            aligned[distinct.places[i + 1][k]] = std::move(sets[i].landmarks[k]);
        for (std::size_t k = 0; k < aligned.size(); ++k)
            aligned[k].name = distinct.names[k];
        sets[i].landmarks = std::move(aligned);
        for (Curve &curve : sets[i].curves) { // they know their landmarks by name
            for (std::string &point : curve.points) {
                if (const auto other = respelled.find(point); other != respelled.end())
                    point = other->second;
            }
        }
    }
}

AbsentLandmarks absentIn(std::span<const LandmarkSet> sets)
{
    AbsentLandmarks absent;
    for (const LandmarkSet &set : sets) {
        for (const Landmark &landmark : set.landmarks) {
            if (landmark.isPlaced())
                continue;
            ++(landmark.isMissing()                   ? absent.missing
               : landmark.absence == Absence::Skipped ? absent.skipped
                                                      : absent.notPlaced);
        }
    }
    return absent;
}

std::string reasonsOf(const ProtocolColumns &protocol, std::size_t specimen)
{
    std::string reasons;
    for (std::size_t m = 0; m < protocol.measures.size(); ++m) {
        if (const ProtocolValue &value = protocol.values[specimen][m]; !value.measure)
            reasons += (reasons.empty() ? "" : "; ") + protocol.measures[m].name + ": " + value.reason;
    }
    return reasons;
}

/// The numbers of a protocol for a specimen, by their columns.
std::vector<std::pair<std::string, std::optional<double>>> numbersOf(const ProtocolColumns &protocol,
                                                                     std::size_t specimen)
{
    std::vector<std::pair<std::string, std::optional<double>>> numbers;
    for (std::size_t m = 0; m < protocol.measures.size(); ++m) {
        const std::optional<Measure> &measure = protocol.values[specimen][m].measure;
        const std::string &name = protocol.measures[m].name;
        numbers.emplace_back(name, measure ? std::optional(measure->value) : std::nullopt);
        numbers.emplace_back(name + "_error", measure ? measure->error : std::nullopt);
    }
    return numbers;
}

/// Puts the values into columns of their own, which are the same in each row of a specimen.
void addProtocol(std::vector<LandmarkSet> &sets, const ProtocolColumns &protocol, Notes &notes)
{
    for (std::size_t i = 0; i < sets.size() && !protocol.measures.empty(); ++i) {
        base::Json columns;
        for (const auto &[name, number] : numbersOf(protocol, i)) {
            base::Json &cell = columns[name]; // null, which is written as NA, for none
            if (!number)
                continue;
            std::string text;
            base::appendNumber(text, *number);
            cell = text;
        }
        columns[kNoteColumn] = reasonsOf(protocol, i);
        for (Landmark &landmark : sets[i].landmarks) {
            for (auto it = columns.begin(); it != columns.end(); ++it) {
                if (landmark.extra.json().contains(it.key())) // another program's column of that name
                    notes.addKeys(it.key());
            }
            landmark.extra.edit().update(columns);
        }
    }
}

std::string wideText(std::span<const LandmarkSet> sets, const ProtocolColumns &protocol, base::CellTexts texts,
                     Notes &notes)
{
    // A row per specimen has names and coordinates by design: there are no notes about the rest.
    addLosses(notes, sets, ~HeldUnit);
    const bool hasPlacings = hasSeveralPlacings(sets);
    std::string text;
    base::RowWriter row(text, texts);
    row.plain(hasPlacings ? "specimen,placing" : "specimen");
    for (const Landmark &landmark : sets.front().landmarks) {
        for (const char *axis : {"_x", "_y", "_z"})
            row.text(landmark.name + axis);
    }
    for (const auto &[name, number] : numbersOf(protocol, 0))
        row.text(name);
    if (!protocol.measures.empty())
        row.plain(kNoteColumn);
    row.endRow();
    for (std::size_t i = 0; i < sets.size(); ++i) {
        row.text(sets[i].name);
        if (hasPlacings)
            row.plain(std::to_string(sets[i].placing));
        for (const Landmark &landmark : sets[i].landmarks) {
            for (int axis = 0; axis < 3; ++axis)
                row.numberOr("NA", landmark.world ? std::optional((*landmark.world)[axis]) : std::nullopt);
        }
        for (const auto &[name, number] : numbersOf(protocol, i))
            row.numberOr("NA", number);
        if (!protocol.measures.empty())
            row.text(reasonsOf(protocol, i));
        row.endRow();
    }
    return text;
}

} // namespace

std::string absentText(const AbsentLandmarks &absent)
{
    if (absent.all() == 0)
        return {};
    return tr(absent.all() == 1
                  ? "%1 landmark has no coordinates (not placed: %2, skipped: %3, missing on its specimen: %4)"
                  : "%1 landmarks have no coordinates (not placed: %2, skipped: %3, missing on their specimens: %4)",
              absent.all(), absent.notPlaced, absent.skipped, absent.missing);
}

std::vector<std::string> unmeasuredTexts(const ProtocolColumns &protocol)
{
    std::vector<std::string> texts;
    for (std::size_t m = 0; m < protocol.measures.size(); ++m) {
        const auto lacks = [m](const std::vector<ProtocolValue> &values) { return !values[m].measure; };
        if (const auto count = std::count_if(protocol.values.begin(), protocol.values.end(), lacks); count > 0)
            texts.push_back(tr("the measure \"%1\" is NA for %2 of %3 specimens; the column measures_note has the "
                               "reasons",
                               protocol.measures[m].name, count, protocol.values.size()));
    }
    return texts;
}

base::Note repeatsLeftOut(std::size_t count)
{
    return {marked("%1 repeated placing is left out: the format would have it as one more specimen"),
            {},
            marked("%1 repeated placings are left out: the format would have them as more specimens"),
            count};
}

base::Expected<WrittenTable, base::Error> specimenTable(std::span<const LandmarkSet> specimens, TableForm form,
                                                        const ProtocolColumns &protocol,
                                                        std::span<const Landmark> names, base::CellTexts texts)
{
    return caught([&] {
        Notes notes;
        std::vector<LandmarkSet> sets(specimens.begin(), specimens.end());
        const bool hasRows = form == TableForm::Long || form == TableForm::Wide;
        if (sets.empty())
            fail(0, tr("there are no specimens"));
        for (LandmarkSet &set : sets)
            set.measures.clear(); // `protocol` has them
        if (!hasRows)
            removeRepeats(sets, notes);
        if (const auto differ = differentCounts(sets)) {
            if (form != TableForm::Long) // it has the number of each curve
                fail(0, differ->text());
            notes.add({differ->one}, 1, differ->values);
        }
        align(sets, names, notes);
        const bool keepsCurves = form == TableForm::Long || (form == TableForm::Tps && haveSameCurves(sets));
        const std::vector<LandmarkSet> withCurves = sets;
        if (keepsCurves && form == TableForm::Tps) {
            sortCurves(sets);
        } else if (!keepsCurves) {
            sets = withCurvesAsPoints(sets, notes);
            align(sets, {}, notes);
        }
        auto sliders = keepsCurves ? slidersOf(sets) : slidersOf(withCurves, writtenNames(sets.front()));
        if (form != TableForm::Long)
            checkUnits(sets, quotedNames(sets), notes); // the table does not keep them
        if (hasRows)
            checkColumns(sets.front(), form, protocol);
        const AbsentLandmarks absent = absentIn(sets);
        std::string text;
        if (form == TableForm::Wide) {
            text = wideText(sets, protocol, texts, notes);
        } else if (form == TableForm::Long) {
            addProtocol(sets, protocol, notes);
            text = textOf(sets, Format::Csv, texts, notes, "NA");
        } else {
            notes.add(kMeasuresLeftOut, protocol.measures.size());
            for (LandmarkSet &set : sets) { // `absent` has the reasons
                for (Landmark &landmark : set.landmarks)
                    landmark.absence = Absence::NotPlaced;
            }
            text = textOf(sets, form == TableForm::Tps ? Format::Tps : Format::Nts, texts, notes);
        }
        checkSize(text.size());
        std::vector<base::Note> taken = notes.take(); // those that matter most first
        std::stable_partition(taken.begin(), taken.end(), [](const base::Note &note) { return !isOfEveryTable(note); });
        return WrittenTable{std::move(text), std::move(taken), absent, std::move(sliders)};
    });
}

LandmarkSet inOrderOf(LandmarkSet specimen, std::span<const Landmark> names)
{
    Notes unused;
    std::vector<LandmarkSet> sets{std::move(specimen)};
    align(sets, names, unused);
    return std::move(sets.front());
}

base::Expected<WrittenTable, base::Error> convertedText(std::vector<LandmarkSet> sets, Format to,
                                                        const std::string &source, base::CellTexts texts)
{
    // NTSYS rows are specimens by name.
    if (to == Format::Nts && !source.empty()) {
        for (std::size_t i = 0; i < sets.size(); ++i) {
            if (sets[i].name.empty())
                sets[i].name = source + (sets.size() > 1 ? '_' + std::to_string(i + 1) : "");
        }
    }
    const auto isNamed = [](const LandmarkSet &set) {
        return std::any_of(set.landmarks.begin(), set.landmarks.end(),
                           [](const Landmark &landmark) { return !landmark.name.empty(); });
    };
    if ((to == Format::Tps || to == Format::Nts) && sets.size() > 1 && std::any_of(sets.begin(), sets.end(), isNamed))
        return specimenTable(sets, to == Format::Tps ? TableForm::Tps : TableForm::Nts);
    const base::Expected<WrittenLandmarks, base::Error> text = landmarksText(sets, to, texts);
    if (!text)
        return text.error();
    return WrittenTable{text->text, text->notes, {}, slidersOf(sets)};
}

} // namespace unprojector::landmark_files
