#include "gui/text/note_text.h"

#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QStringList>

namespace unprojector::gui {
namespace {

struct NoteTexts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::NoteTexts)
};

QString ofFile(const QString &fileName, const QString &said)
{
    return NoteTexts::tr("%1: %2", "a file: the message about it").arg(fileName, said);
}

} // namespace

QString notesText(const QString &fileName, const std::vector<base::Note> &notes)
{
    QStringList sentences;
    for (const base::Note &note : notes)
        sentences << sentence(note.text());
    return sentences.isEmpty() ? QString() : ofFile(fileName, joinSentences(sentences));
}

QString landmarkNotesText(const QString &fileName, const std::vector<base::Note> &notes)
{
    QStringList lines;
    for (const base::Note &note : notes)
        lines << ofFile(fileName, ended(note.text()));
    return lines.join(u'\n');
}

} // namespace unprojector::gui
