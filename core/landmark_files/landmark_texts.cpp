// All wording of the notes and errors but what a reader says of a line.

#include "core/landmark_files/landmark_file.h"

namespace unprojector::landmark_files {
namespace {

std::string counted(std::size_t count, const char *one, const char *many)
{
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// "the notes of 3 points are left out"
std::string left(const char *what, std::size_t count)
{
    return std::string("the ") + what + " of " + counted(count, "point", "points") + " are left out";
}

std::string suffixList()
{
    std::string list;
    for (const Format format : kFormats)
        list += (list.empty() ? "." : format == kFormats.back() ? " or ." : ", .") + std::string(suffixOf(format));
    return list;
}

std::string sentence(const LandmarkFileError &error)
{
    switch (error.code) {
    case LandmarkFileError::Code::NotFound: return "there is no such file";
    case LandmarkFileError::Code::IsDirectory: return "this is a folder, not a file of landmarks";
    case LandmarkFileError::Code::NotReadable: return "the file cannot be read; look at its permissions";
    case LandmarkFileError::Code::UnknownFormat: return "the name must end in " + suffixList();
    case LandmarkFileError::Code::TooLarge:
        return "a file of landmarks may have at most " + std::to_string(kMostLandmarkBytes >> 20)
               + " MiB (8 MiB of JSON)";
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
    const auto specimens = [&note] { return counted(note.count, "specimen", "specimens"); };
    switch (note.kind) {
    case Kind::NamesLeftOut: return left("names", note.count) + "; only their order is kept";
    case Kind::PositionsLeftOut: return left("coordinates", note.count);
    case Kind::ObjectsLeftOut: return left("objects", note.count);
    case Kind::HoldsLeftOut: return left("triangles, vertices or edges", note.count);
    case Kind::UncertaintiesLeftOut: return left("uncertainties", note.count);
    case Kind::NotesLeftOut: return left("notes", note.count);
    case Kind::ColorsLeftOut: return left("colours", note.count);
    case Kind::HiddenLeftOut:
        return counted(note.count, "hidden point is", "hidden points are") + " written as any other";
    case Kind::KeysLeftOut: return left("other values", note.count) + ": " + note.detail;
    case Kind::SpecimenKeysLeftOut: return "other values of " + specimens() + " are left out: " + note.detail;
    case Kind::SpecimenNameLeftOut: return "the name of the specimen, \"" + note.detail + "\", is left out";
    case Kind::MeshLeftOut: return "the name of the mesh, \"" + note.detail + "\", is left out";
    case Kind::UnitLeftOut: return "the unit, " + note.detail + ", is left out";
    case Kind::NameChanged: return "the name " + note.detail;
    case Kind::NoteChanged: return "the note of \"" + note.detail + "\" is written without line breaks and #";
    case Kind::EmptySpecimenLeftOut: return "the specimen \"" + note.detail + "\" has no points and is left out";
    case Kind::LooksMissing:
        return "\"" + note.detail + "\" has a coordinate of 9999, which readers take for a missing point";
    case Kind::MissingAtOrigin:
        return counted(note.count, "missing point is", "missing points are")
               + " written at 0, 0, 0 with a field that older readers pass over";
    case Kind::AxesTurned:
        return "the file is in RAS; x and y are negated, so that the points lie on a mesh as 3D Slicer reads one (LPS)";
    case Kind::FlatPoints: return counted(note.count, "point has", "points have") + " two coordinates; z is 0";
    case Kind::Scaled: return "coordinates are multiplied by the SCALE of the file, " + note.detail;
    case Kind::CurvesLeftOut:
        return counted(note.count, "point", "points") + " of curves are left out: a curve has two at least";
    case Kind::CurveCellsLeftOut:
        return counted(note.count, "row of a curve says", "rows of curves say")
               + " more than where a semilandmark is, which is left out";
    case Kind::CurvesAsPoints:
        return counted(note.count, "semilandmark is", "semilandmarks are")
               + " written as points behind the others, named by their curve; what the curves go through is left out";
    case Kind::CurvesUnnamed:
        return "the names of " + counted(note.count, "curve", "curves") + " and what they go through are left out";
    case Kind::CurveUnknown:
        return "the curve \"" + note.detail
               + "\" has no semilandmarks and is left out: where it goes is worked out where its mesh is open";
    case Kind::MissingHadPosition:
        return counted(note.count, "point is", "points are")
               + " marked as not placed and had coordinates, which are left out";
    case Kind::BlanksLeftOut:
        return "the blanks around " + counted(note.count, "text", "texts") + " are left out; quotes keep them";
    case Kind::CommentsLeftOut: return counted(note.count, "comment is", "comments are") + " left out";
    }
    return {};
}

std::string errorText(const LandmarkFileError &error)
{
    std::string place = error.file;
    if (error.line > 0)
        place += ':' + std::to_string(error.line);
    return place.empty() ? sentence(error) : place + ": " + sentence(error);
}

} // namespace unprojector::landmark_files
