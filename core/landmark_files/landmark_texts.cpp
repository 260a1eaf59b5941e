// All wording of notes and errors, except a reader's messages about a line.

#include "core/landmark_files/landmark_file.h"

#include "core/base/translation.h"

#include <algorithm>
#include <map>

namespace unprojector::landmark_files {
using base::marked;
using base::tr;
namespace {

/// A sentence with a number, in singular or plural.
std::string counted(std::size_t count, const char *one, const char *many)
{
    return count == 1 ? tr(one, count) : tr(many, count);
}

/// The suffixes of formats: ".csv, .pp or .tps".
template <class Is>
std::string suffixList(const Is &is)
{
    std::string list, last;
    for (const Format format : kFormats) {
        if (!is(format))
            continue;
        if (!last.empty())
            list += (list.empty() ? "" : ", ") + last;
        last = '.' + std::string(suffixOf(format));
    }
    return tr("%1 or %2", list, last);
}

std::string sentence(const LandmarkFileError &error)
{
    switch (error.code) {
    case LandmarkFileError::Code::NotFound: return tr("there is no such file");
    case LandmarkFileError::Code::IsDirectory: return tr("this is a folder, not a file of landmarks");
    case LandmarkFileError::Code::NotReadable: return tr("the file cannot be read; check its permissions");
    case LandmarkFileError::Code::UnknownFormat:
        return tr("the name must end in %1", suffixList([](Format) { return true; }));
    case LandmarkFileError::Code::NotWritten: return tr("the name must end in %1", suffixList(isWritten));
    case LandmarkFileError::Code::TooLarge:
        return tr("a file of landmarks may have at most %1 MiB", kMostLandmarkBytes >> 20);
    case LandmarkFileError::Code::NotWritable:
    case LandmarkFileError::Code::Malformed:
    case LandmarkFileError::Code::CannotHold: return error.detail;
    }
    return {};
}

} // namespace

std::string noteText(const LandmarkNote &note)
{
    using Kind = LandmarkNote::Kind;
    const auto said = [&note](const char *one, const char *many) { return counted(note.count, one, many); };
    switch (note.kind) {
    case Kind::NamesLeftOut:
        return said(marked("the names of %1 landmark are left out; only their order is kept"),
                    marked("the names of %1 landmarks are left out; only their order is kept"));
    case Kind::PositionsLeftOut:
        return said(marked("the coordinates of %1 landmark are left out"),
                    marked("the coordinates of %1 landmarks are left out"));
    case Kind::ObjectsLeftOut:
        return said(marked("the objects of %1 landmark are left out"),
                    marked("the objects of %1 landmarks are left out"));
    case Kind::HoldsLeftOut:
        return said(marked("the anchor of %1 landmark (triangle, vertex or edge) is left out"),
                    marked("the anchors of %1 landmarks (triangles, vertices or edges) are left out"));
    case Kind::UncertaintiesLeftOut:
        return said(marked("the uncertainties of %1 landmark are left out"),
                    marked("the uncertainties of %1 landmarks are left out"));
    case Kind::NotesLeftOut:
        return said(marked("the notes of %1 landmark are left out"), marked("the notes of %1 landmarks are left out"));
    case Kind::ColorsLeftOut:
        return said(marked("the colours of %1 landmark are left out"),
                    marked("the colours of %1 landmarks are left out"));
    case Kind::HiddenLeftOut:
        return said(marked("%1 hidden landmark is written as any other"),
                    marked("%1 hidden landmarks are written as any other"));
    case Kind::KeysLeftOut:
        return said(marked("the other values of %1 landmark are left out"),
                    marked("the other values of %1 landmarks are left out"))
               + ": " + note.detail;
    case Kind::SpecimenKeysLeftOut:
        return said(marked("other values of %1 specimen are left out"),
                    marked("other values of %1 specimens are left out"))
               + ": " + note.detail;
    case Kind::SpecimenNameLeftOut: return tr("the name of the specimen, \"%1\", is left out", note.detail);
    case Kind::MeshLeftOut: return tr("the name of the mesh, \"%1\", is left out", note.detail);
    case Kind::UnitLeftOut: return tr("the unit, %1, is left out", note.detail);
    case Kind::PlacingsLeftOut:
        return said(marked("the placing of %1 specimen, which is not its first, is left out"),
                    marked("the placings of %1 specimens, which are not their first, are left out"));
    case Kind::RepeatsLeftOut:
        return said(marked("%1 repeated placing is left out: the format would have it as one more specimen"),
                    marked("%1 repeated placings are left out: the format would have them as more specimens"));
    case Kind::MeasuresLeftOut:
        return said(marked("%1 measure of the protocol is left out; save the protocol in a file of its own"),
                    marked("%1 measures of the protocol are left out; save the protocol in a file of its own"));
    case Kind::NameChanged: return tr("the name %1", note.detail);
    case Kind::NameTwice: return tr("%1; the table numbers them", note.detail);
    case Kind::SpellingsKept:
        return tr("%1, so they are two landmarks in all specimens; rename one if they are the same", note.detail);
    case Kind::NoteChanged: return tr("the note of \"%1\" is written without line breaks and #", note.detail);
    case Kind::AbsencesLeftOut:
        return tr("%1 points have no position, for different reasons (%2); the reasons are left out", note.count,
                  note.detail);
    case Kind::SkippedLeftOut:
        return said(marked("%1 skipped point is written as not placed"),
                    marked("%1 skipped points are written as not placed"));
    case Kind::UnitOfOthers:
        return tr("3D Slicer takes coordinates for mm, and these are in %1; they are not converted", note.detail);
    case Kind::EmptySpecimenLeftOut: return tr("the specimen \"%1\" has no points and is left out", note.detail);
    case Kind::LooksMissing:
        return tr("\"%1\" has a coordinate of 9999, which readers take for a missing point", note.detail);
    case Kind::MissingAtOrigin:
        return said(
            marked("%1 point without a position is written as 0, 0, 0 with a status field, which older readers ignore"),
            marked("%1 points without a position are written as 0, 0, 0 with a status field, which older readers "
                   "ignore"));
    case Kind::AxesTurned:
        return tr(
            "the file is in RAS; x and y are negated, so that the points lie on a mesh as 3D Slicer reads one (LPS)");
    case Kind::FlatPoints:
        return said(marked("%1 point has two coordinates; z is 0"), marked("%1 points have two coordinates; z is 0"));
    case Kind::Scaled: return tr("coordinates are multiplied by the SCALE of the file, %1", note.detail);
    case Kind::CurvesLeftOut:
        return said(marked("%1 point of curves are left out: a curve needs at least two"),
                    marked("%1 points of curves are left out: a curve needs at least two"));
    case Kind::CurveCellsLeftOut:
        return said(marked("%1 semilandmark has more than a name and a position, which is left out"),
                    marked("%1 semilandmarks have more than a name and a position, which is left out"));
    case Kind::CurvesAsPoints:
        return said(
            marked("%1 semilandmark is written as points behind the others, named by their curve; what the curves go "
                   "through is left out"),
            marked("%1 semilandmarks are written as points behind the others, named by their curve; what the curves "
                   "go through is left out"));
    case Kind::CurveEndsShared:
        return said(marked("%1 end of a curve is a landmark and is not written again"),
                    marked("%1 ends of curves are landmarks and are not written again"));
    case Kind::CurvesUnnamed:
        return said(marked("the names of %1 curve and what they go through are left out"),
                    marked("the names of %1 curves and what they go through are left out"));
    case Kind::CurveUnknown:
        return tr("the curve \"%1\" has no semilandmarks and is left out: its path is computed when its mesh is open",
                  note.detail);
    case Kind::CurveCountsDiffer: return note.detail;
    case Kind::UnitUnknown: return tr("%1; its coordinates are read in that unit", note.detail);
    case Kind::MissingHadPosition:
        return said(marked("%1 point is marked as not placed and had coordinates, which are left out"),
                    marked("%1 points are marked as not placed and had coordinates, which are left out"));
    case Kind::BlanksLeftOut:
        return said(marked("the blanks around %1 cell text are removed; put the text in quotes to keep them"),
                    marked("the blanks around %1 cell texts are removed; put the texts in quotes to keep them"));
    case Kind::HeaderMissing:
        return tr("the table has no first line that names its columns; they are read as %1", note.detail);
    case Kind::DecimalCommas: return tr("the numbers have a decimal comma: 1,5 is one and a half");
    case Kind::EmptyRowsLeftOut:
        return said(marked("%1 empty row at the end of the table is left out"),
                    marked("%1 empty rows at the end of the table are left out"));
    case Kind::RowNamesLeftOut:
        return said(marked("%1 row name beside the names of the points is left out"),
                    marked("%1 row names beside the names of the points are left out"));
    case Kind::ApostrophesLeftOut:
        return said(
            marked("the apostrophe before %1 text is left out; it keeps spreadsheets from computing what follows"),
            marked("the apostrophes before %1 texts are left out; they keep spreadsheets from computing what follows"));
    case Kind::NegativeIsMissing:
        return said(marked("%1 point has only coordinates of -1, as tpsDig writes a missing point; it has no position "
                           "here"),
                    marked("%1 points have only coordinates of -1, as tpsDig writes missing points; they have no "
                           "position here"));
    case Kind::CodeIsMissing:
        return said(marked("%1 point has only coordinates of 9999 or -9999, the mark of a missing point; it has no "
                           "position here"),
                    marked("%1 points have only coordinates of 9999 or -9999, the mark of missing points; they have no "
                           "position here"));
    case Kind::MissingCodeUnknown:
        return tr("the parameters say that values are missing, and not by which number; every number is read as a "
                  "coordinate");
    case Kind::PreviewsLeftOut:
        return said(marked("%1 point is a preview, which was not placed in 3D Slicer; it has no position here"),
                    marked("%1 points are previews, which were not placed in 3D Slicer; they have no position here"));
    case Kind::LinksLeftOut:
        return said(marked("%1 line between two points is left out"), marked("%1 lines between points are left out"));
    case Kind::CommentsLeftOut: return said(marked("%1 comment is left out"), marked("%1 comments are left out"));
    }
    return {};
}

namespace {

/// True for notes of which each names another landmark.
bool isListed(LandmarkNote::Kind kind)
{
    using Kind = LandmarkNote::Kind;
    return kind == Kind::NameChanged || kind == Kind::NameTwice || kind == Kind::SpellingsKept;
}

} // namespace

std::vector<std::string> noteLines(const std::vector<FileNote> &notes)
{
    constexpr std::size_t kMostLines = 3;
    std::vector<LandmarkNote::Kind> kinds;
    std::map<LandmarkNote::Kind, std::vector<const FileNote *>> groups;
    for (const FileNote &note : notes) {
        std::vector<const FileNote *> &group = groups[note.note.kind];
        if (group.empty())
            kinds.push_back(note.note.kind);
        group.push_back(&note);
    }
    std::vector<std::string> lines;
    for (const LandmarkNote::Kind kind : kinds) {
        const std::vector<const FileNote *> &group = groups[kind];
        const FileNote &first = *group.front();
        LandmarkNote sum = first.note;
        sum.count = 0;
        for (const FileNote *each : group)
            sum.count += each->note.count;
        if (group.size() <= kMostLines || isListed(kind)) {
            for (const FileNote *each : group)
                lines.push_back(each->file + ": " + noteText(each->note));
        } else if (std::all_of(group.begin(), group.end(),
                               [&first](const FileNote *each) { return each->note.detail == first.note.detail; })) {
            lines.push_back(tr("%1 files: %2", group.size(), noteText(sum)));
        } else {
            lines.push_back(
                tr("%1: %2 (and %3 more notes like this one)", first.file, noteText(first.note), group.size() - 1));
        }
    }
    return lines;
}

std::string errorText(const LandmarkFileError &error)
{
    std::string place = error.file;
    if (error.line > 0)
        place += ':' + std::to_string(error.line);
    return place.empty() ? sentence(error) : place + ": " + sentence(error);
}

} // namespace unprojector::landmark_files
