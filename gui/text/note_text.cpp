#include "gui/text/note_text.h"

#include "core/mesh/import/note_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QImageReader>
#include <QStringList>

#include <algorithm>

namespace unprojector::gui {
using namespace mesh;

namespace {

struct NoteTexts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::NoteTexts)
};

QString ofFile(const QString &fileName, const QString &said)
{
    return NoteTexts::tr("%1: %2", "a file: the message about it").arg(fileName, said);
}

} // namespace

QString notesText(const QString &fileName, const std::vector<ModelNote> &notes)
{
    QStringList sentences;
    for (const ModelNote &note : notes)
        sentences << sentence(mesh::noteText(note));
    const bool isUnusable = std::any_of(notes.begin(), notes.end(), [](const ModelNote &note) {
        return note.kind == ModelNote::Kind::TextureUnusable;
    });
    if (isUnusable && !QImageReader::supportedImageFormats().contains("jpeg"))
        sentences << NoteTexts::tr(
            "JPEG is not supported here: Qt's plugin for it is missing. Convert the file to PNG.");
    return sentences.isEmpty() ? QString() : ofFile(fileName, joinSentences(sentences));
}

QString landmarkNotesText(const QString &fileName, const std::vector<landmark_files::LandmarkNote> &notes)
{
    QStringList lines;
    for (const landmark_files::LandmarkNote &note : notes)
        lines << ofFile(fileName, ended(landmark_files::noteText(note)));
    return lines.join(u'\n');
}

} // namespace unprojector::gui
