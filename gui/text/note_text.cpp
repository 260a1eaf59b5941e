#include "gui/text/note_text.h"

#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QImageReader>
#include <QStringList>

namespace unprojector::gui {
namespace {

struct NoteTexts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::NoteTexts)
};

} // namespace

QString noteText(const ModelNote &note)
{
    const QString detail = QString::fromStdString(note.detail);
    const QString count = QString::number(note.count);
    switch (note.kind) {
    case ModelNote::Kind::TextureMissing:
        return NoteTexts::tr("The picture %1 is not there or cannot be read: its surfaces are shown without it.")
            .arg(detail);
    case ModelNote::Kind::TextureUnusable:
        if (!QImageReader::supportedImageFormats().contains("jpeg"))
            return NoteTexts::tr(
                       "The picture %1 is damaged, too large or of a kind that is not known (JPEG is not known "
                       "here: Qt's plugin for it is missing): its surfaces are shown without it. Convert it "
                       "to PNG, or make it smaller.")
                .arg(detail);
        return NoteTexts::tr(
                   "The picture %1 is damaged, too large or of a kind that is not known: its surfaces are shown "
                   "without it. Convert it to PNG or JPEG, or make it smaller.")
            .arg(detail);
    case ModelNote::Kind::TextureScaledDown:
        return NoteTexts::tr("The picture %1 is too large and is shown scaled down to a width of %2 pixels.")
            .arg(detail, count);
    case ModelNote::Kind::MaterialsMissing:
        return NoteTexts::tr(
                   "The materials %1 are not there or cannot be read: their surfaces are shown without colours "
                   "and pictures.")
            .arg(detail);
    case ModelNote::Kind::MaterialUnknown:
        return NoteTexts::tr("No material is called %1: its surfaces are shown in grey.").arg(detail);
    case ModelNote::Kind::LinesLeftOut: return NoteTexts::tr("Lines and points that are not shown: %1.").arg(count);
    case ModelNote::Kind::FacesLeftOut:
        return NoteTexts::tr("Faces that refer to vertices which the file does not have, and are not shown: %1.")
            .arg(count);
    case ModelNote::Kind::TexcoordsLeftOut:
        return NoteTexts::tr(
                   "Faces that refer to texture coordinates which the file does not have, and are shown without "
                   "a picture: %1.")
            .arg(count);
    case ModelNote::Kind::NormalsLeftOut:
        return NoteTexts::tr("Faces that refer to normals which the file does not have, and get computed ones: %1.")
            .arg(count);
    case ModelNote::Kind::NumbersLeftOut:
        return NoteTexts::tr("Vertices with words behind their coordinates that are not used: %1.").arg(count);
    case ModelNote::Kind::ColorsUndeclared:
        return NoteTexts::tr(
            "The numbers behind the coordinates are used as colours, though the header does not declare any.");
    case ModelNote::Kind::WeightsLeftOut:
        return NoteTexts::tr("Vertices with a fourth number, the weight of rational curves, which is not used: %1.")
            .arg(count);
    case ModelNote::Kind::LinesUnknown:
        return NoteTexts::tr(
                   "Lines that begin with a word unknown to the format, and are not used: %1, the first is %2.")
            .arg(count, detail);
    case ModelNote::Kind::BytesLeftOut:
        return NoteTexts::tr("Bytes behind all that the file declares, which are not used: %1.").arg(count);
    case ModelNote::Kind::PartLeftOut:
        return note.count > 1 ? NoteTexts::tr("Not shown: %1 (%2 times).").arg(detail, count)
                              : NoteTexts::tr("Not shown: %1.").arg(detail);
    case ModelNote::Kind::FlatTriangles:
        return NoteTexts::tr("Triangles that are not drawn, because their corners are equal or on one line in single "
                             "precision: %1.")
            .arg(count);
    case ModelNote::Kind::TooSmallToDraw:
        return NoteTexts::tr("The model measures %1, which graphics cards round to 0 or to few digits. Scale it up.")
            .arg(detail);
    case ModelNote::Kind::SceneMissing: return NoteTexts::tr("The file has no scene: all its nodes are shown.");
    case ModelNote::Kind::PositionsMissing:
        return NoteTexts::tr("Parts of meshes that have no positions, and are not shown: %1.").arg(count);
    case ModelNote::Kind::PictureUnknown:
        return NoteTexts::tr("Textures without a PNG or JPEG picture, whose surfaces are shown without it: %1.")
            .arg(count);
    case ModelNote::Kind::ExtensionLeftOut:
        return NoteTexts::tr(
                   "The glTF extension %1, which the file requires, is not applied: the shape is whole without it, "
                   "but colours, light, motion or data may be missing.")
            .arg(detail);
    case ModelNote::Kind::SubstituteShown:
        return NoteTexts::tr("The glTF extension %1 is not supported: the shape that the file has without it is shown.")
            .arg(detail);
    case ModelNote::Kind::SkinsApplied:
        return NoteTexts::tr("Meshes with skins, which are shown where the file's nodes have their joints: %1.")
            .arg(count);
    case ModelNote::Kind::MeshesHidden:
        return NoteTexts::tr("Meshes that the file hides (KHR_node_visibility), and that are not shown: %1.")
            .arg(count);
    case ModelNote::Kind::ElementsLeftOut:
        return NoteTexts::tr("Elements %1 of the file, which are not read: %2.").arg(detail, count);
    case ModelNote::Kind::NodesLeftOut:
        return NoteTexts::tr("Meshes that are not in the scene that the file opens with, and are not shown: %1.")
            .arg(count);
    case ModelNote::Kind::NodesListedAgain:
        return NoteTexts::tr("Nodes that the scene lists twice or beside their parents, and that are shown once: %1.")
            .arg(count);
    case ModelNote::Kind::CornersLeftOut:
        return NoteTexts::tr("Corners at the ends of parts of meshes, which make no whole triangles and are not used: "
                             "%1.")
            .arg(count);
    case ModelNote::Kind::ReadOutside:
        return note.count > 1 ? NoteTexts::tr("Files outside the model's folder were read: %1 and others, %2 in all.")
                                    .arg(detail, count)
                              : NoteTexts::tr("The file %1 outside the model's folder was read.").arg(detail);
    }
    return {};
}

QString notesText(const QString &fileName, const std::vector<ModelNote> &notes)
{
    QStringList sentences;
    for (const ModelNote &note : notes)
        sentences << noteText(note);
    return sentences.isEmpty() ? QString()
                               : NoteTexts::tr("%1: %2", "a file: what is said of it").arg(fileName, inARow(sentences));
}

QString pointNotesText(const QString &fileName, const std::vector<landmark_files::LandmarkNote> &notes)
{
    QStringList lines;
    for (const landmark_files::LandmarkNote &note : notes)
        lines << NoteTexts::tr("%1: %2.", "a file of points: what is said of it, without its full stop")
                     .arg(fileName, QString::fromStdString(landmark_files::noteText(note)));
    return lines.join(u'\n');
}

} // namespace unprojector::gui
