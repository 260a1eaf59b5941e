#include "core/mesh/import/note_text.h"

#include "core/base/translation.h"

namespace unprojector::mesh {
using base::tr;
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
    return tr("\"%1\"", printable(note.detail));
}

} // namespace

std::string noteText(const ModelNote &note)
{
    switch (note.kind) {
    case ModelNote::Kind::TextureMissing:
        return tr("the image %1 is missing or cannot be read: its surfaces are shown without it", quotedDetail(note));
    case ModelNote::Kind::TextureUnusable:
        return tr("the image %1 is damaged, too large or of an unknown format: its surfaces are shown without it; "
                  "convert it to PNG or JPEG, or make it smaller",
                  quotedDetail(note));
    case ModelNote::Kind::TextureScaledDown:
        return tr(note.count == 1 ? "the image %1 is too large and is shown with a width of %2 pixel"
                                  : "the image %1 is too large and is shown with a width of %2 pixels",
                  quotedDetail(note), note.count);
    case ModelNote::Kind::MaterialsMissing:
        return tr("the materials %1 are missing or cannot be read: their surfaces are shown without colours and images",
                  quotedDetail(note));
    case ModelNote::Kind::MaterialUnknown:
        return note.count > 1 ? tr(
                   note.count == 2
                       ? "no material is called %1 or by %2 other name of the file: its surfaces are shown in grey"
                       : "no material is called %1 or by %2 other names of the file: its surfaces are shown in grey",
                   quotedDetail(note), note.count - 1)
                              : tr("no material is called %1: its surfaces are shown in grey", quotedDetail(note));
    case ModelNote::Kind::LinesLeftOut:
        return tr(note.count == 1 ? "%1 line or point is not shown" : "%1 lines and points are not shown", note.count);
    case ModelNote::Kind::FacesLeftOut:
        return tr(note.count == 1 ? "%1 face refers to vertices that the file does not have and cannot be shown"
                                  : "%1 faces refer to vertices that the file does not have and cannot be shown",
                  note.count);
    case ModelNote::Kind::TexcoordsLeftOut:
        return tr(note.count == 1
                      ? "%1 face refers to texture coordinates that the file does not have: shown without an image"
                      : "%1 faces refer to texture coordinates that the file does not have: shown without an image",
                  note.count);
    case ModelNote::Kind::NormalsLeftOut:
        return tr(note.count == 1 ? "%1 face refers to normals that the file does not have: they are computed instead"
                                  : "%1 faces refer to normals that the file does not have: they are computed instead",
                  note.count);
    case ModelNote::Kind::NumbersLeftOut:
        return tr(note.count == 1 ? "%1 vertex has words behind the coordinates that are not used"
                                  : "%1 vertices have words behind the coordinates that are not used",
                  note.count);
    case ModelNote::Kind::ColorsUndeclared:
        return tr("the numbers behind the coordinates are used as colours, though the header does not declare any");
    case ModelNote::Kind::WeightsLeftOut:
        return tr(note.count == 1 ? "%1 vertex has a fourth number, the weight of rational curves: it is not used"
                                  : "%1 vertices have a fourth number, the weight of rational curves: it is not used",
                  note.count);
    case ModelNote::Kind::LinesUnknown:
        return tr(note.count == 1 ? "not used: %1 line that begins with a word unknown to the format, %2"
                                  : "not used: %1 lines that begin with words unknown to the format, the first is %2",
                  note.count, printable(note.detail));
    case ModelNote::Kind::BytesLeftOut:
        return tr(note.count == 1 ? "%1 byte behind all that the file declares is not used"
                                  : "%1 bytes behind all that the file declares are not used",
                  note.count);
    case ModelNote::Kind::PartLeftOut:
        return note.count > 1 ? tr("%1 is not shown (%2 times)", quotedDetail(note), note.count)
                              : tr("%1 is not shown", quotedDetail(note));
    case ModelNote::Kind::FlatTriangles:
        return tr(note.count == 1
                      ? "not drawn: %1 triangle whose corners are equal or on one line in single precision"
                      : "not drawn: %1 triangles whose corners are equal or on one line in single precision",
                  note.count);
    case ModelNote::Kind::TooSmallToDraw:
        return tr(
            "cannot be drawn: graphics cards round %1, which the model measures, to 0 or to few digits; scale it up",
            note.detail);
    case ModelNote::Kind::SceneMissing: return tr("the file has no scene: all its nodes are shown");
    case ModelNote::Kind::PositionsMissing:
        return tr(note.count == 1 ? "%1 part of a mesh has no positions and is not shown"
                                  : "%1 parts of meshes have no positions and are not shown",
                  note.count);
    case ModelNote::Kind::PictureUnknown:
        return tr(note.count == 1
                      ? "%1 texture has neither a PNG nor a JPEG image: its surfaces are shown without it"
                      : "%1 textures have neither PNG nor JPEG images: their surfaces are shown without them",
                  note.count);
    case ModelNote::Kind::ExtensionLeftOut:
        return tr("the glTF extension %1, which the file requires, is not applied: the shape is whole without it, but "
                  "colours, light, motion or data may be missing",
                  quotedDetail(note));
    case ModelNote::Kind::SubstituteShown:
        return tr("the glTF extension %1 is not supported: the shape that the file has without it is shown",
                  quotedDetail(note));
    case ModelNote::Kind::SkinsApplied:
        return tr(note.count == 1 ? "%1 mesh has a skin: it is shown where the file's nodes have its joints"
                                  : "%1 meshes have skins: they are shown where the file's nodes have their joints",
                  note.count);
    case ModelNote::Kind::MeshesHidden:
        return tr(note.count == 1 ? "%1 mesh is hidden by the file (KHR_node_visibility) and is not shown"
                                  : "%1 meshes are hidden by the file (KHR_node_visibility) and are not shown",
                  note.count);
    case ModelNote::Kind::ElementsLeftOut:
        return tr(note.count == 1 ? "%1 element %2 of the file is not read" : "%1 elements %2 of the file are not read",
                  note.count, quotedDetail(note));
    case ModelNote::Kind::NodesLeftOut:
        return tr(note.count == 1 ? "%1 mesh is not in the scene that the file opens with and is not shown"
                                  : "%1 meshes are not in the scene that the file opens with and are not shown",
                  note.count);
    case ModelNote::Kind::NodesListedAgain:
        return tr(note.count == 1 ? "the scene lists %1 node twice or beside its parent: it is shown once"
                                  : "the scene lists %1 nodes twice or beside their parents: each is shown once",
                  note.count);
    case ModelNote::Kind::CornersLeftOut:
        return tr(note.count == 1
                      ? "%1 corner at the end of a part of a mesh makes no whole triangle and is not used"
                      : "%1 corners at the ends of parts of meshes make no whole triangles and are not used",
                  note.count);
    case ModelNote::Kind::ReadOutside:
        return note.count > 1
                   ? tr(note.count == 2 ? "the file %1 and %2 other one outside the model's folder were read"
                                        : "the file %1 and %2 other ones outside the model's folder were read",
                        quotedDetail(note), note.count - 1)
                   : tr("the file %1 outside the model's folder was read", quotedDetail(note));
    }
    return {};
}

} // namespace unprojector::mesh
