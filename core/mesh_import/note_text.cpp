#include "core/mesh_import/note_text.h"

namespace unprojector::mesh_import {
namespace {

std::string printable(const std::string &text)
{
    std::string line = text;
    for (char &c : line) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f)
            c = '?';
    }
    return line;
}

std::string quotedDetail(const ModelNote &note)
{
    return '"' + printable(note.detail) + '"';
}

/// "1 face is", "2 faces are".
std::string counted(std::size_t count, const char *one, const char *many)
{
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

} // namespace

std::string noteText(const ModelNote &note)
{
    switch (note.kind) {
    case ModelNote::Kind::TextureMissing:
        return "the picture " + quotedDetail(note)
               + " is not there or cannot be read: its surfaces are shown without it";
    case ModelNote::Kind::TextureUnusable:
        return "the picture " + quotedDetail(note)
               + " is damaged, too large or neither PNG nor JPEG: its surfaces are shown without it";
    case ModelNote::Kind::TextureScaledDown:
        return "the picture " + quotedDetail(note) + " is too large and is shown with a width of "
               + counted(note.count, "pixel", "pixels");
    case ModelNote::Kind::MaterialsMissing:
        return "the materials " + quotedDetail(note)
               + " are not there or cannot be read: their surfaces are shown without colours and pictures";
    case ModelNote::Kind::MaterialUnknown:
        return "no material is called " + quotedDetail(note)
               + (note.count > 1 ? " or by " + counted(note.count - 1, "other name", "other names") + " of the file"
                                 : std::string())
               + ": its surfaces are shown in grey";
    case ModelNote::Kind::LinesLeftOut:
        return counted(note.count, "line or point is not shown", "lines and points are not shown");
    case ModelNote::Kind::FacesLeftOut:
        return counted(note.count, "face refers", "faces refer")
               + " to vertices that the file does not have and cannot be shown";
    case ModelNote::Kind::TexcoordsLeftOut:
        return counted(note.count, "face refers", "faces refer")
               + " to texture coordinates that the file does not have: shown without a picture";
    case ModelNote::Kind::NormalsLeftOut:
        return counted(note.count, "face refers", "faces refer")
               + " to normals that the file does not have: they are computed instead";
    case ModelNote::Kind::NumbersLeftOut:
        return counted(note.count, "vertex has", "vertices have") + " words behind the coordinates that are not used";
    case ModelNote::Kind::BytesLeftOut:
        return counted(note.count, "byte", "bytes") + " behind all that the file declares "
               + (note.count == 1 ? "is" : "are") + " not used";
    case ModelNote::Kind::PartLeftOut: {
        const std::string howOften = note.count > 1 ? " (" + std::to_string(note.count) + " times)" : std::string();
        return quotedDetail(note) + " is not shown" + howOften;
    }
    case ModelNote::Kind::PartUnusable: return "not used: " + printable(note.detail);
    }
    return {};
}

} // namespace unprojector::mesh_import
