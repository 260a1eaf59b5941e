// Files of landmarks as the other programs write them, each with a trap of its format, tables in the
// dialects of spreadsheets and R, and files that are broken.

#include "tests/support/test.h"

#include "tests/core/landmarks/strict_landmarks.h"
#include "tests/support/data_files.h"

using namespace strict_landmarks;
using namespace unprojector::landmark_files;
using namespace unprojector::landmarks;

namespace {

/// "Nasion 1 2 3 | tip missing", a line a specimen, as a person reads it off a file.
QStringList pointsOf(const ReadLandmarks &read)
{
    QStringList specimens;
    for (const LandmarkSet &set : read.sets) {
        QStringList points;
        for (const Landmark &landmark : set.landmarks) {
            QString text = QString::fromStdString(landmark.name);
            text +=
                landmark.world
                    ? QStringLiteral(" %1 %2 %3").arg(landmark.world->x).arg(landmark.world->y).arg(landmark.world->z)
                    : QStringLiteral(" missing");
            points << text;
        }
        specimens << (set.name.empty() ? QString() : QString::fromStdString(set.name) + ": ") + points.join(" | ");
    }
    return specimens;
}

QStringList told(const data_files::Case &example, const char *word)
{
    QStringList texts;
    for (const std::string &text : example.all(word))
        texts << QString::fromStdString(text);
    return texts;
}

} // namespace

class TestForeignLandmarks : public QObject {
    Q_OBJECT

private slots:
    void textsAreReadOrRefused_data()
    {
        addColumn<Format>("format");
        addColumn<data_files::Case>("example");
        for (const Format format : kFormats) {
            for (const data_files::Case &example : data_files::cases(suffixOf(format)))
                addRow("%s: %s", suffixOf(format), example.name.c_str()) << format << example;
        }
        newRow("pp: too deep") << Format::MeshLab
                               << data_files::Case{"",
                                                   QByteArray("<a>").repeated(100000).toStdString(),
                                                   {{"refused", "f:1: elements are nested deeper than 64 levels; …"}}};
    }

    /// Words of the cases: "refused", where … stands for more, or "points" of each specimen or the
    /// lines of our own table of it, "csv"; each "note" of the reading and "csv note" of the table.
    void textsAreReadOrRefused()
    {
        QFETCH(Format, format);
        QFETCH(data_files::Case, example);
        const auto read = parseLandmarks(example.text, format, "f");
        if (const QString refused = told(example, "refused").value(0); !refused.isEmpty()) {
            QCOMPARE(example.told.size(), std::size_t(1));
            QVERIFY(!read);
            const QString said = QString::fromStdString(read.error().message());
            const QString shown = refused.endsWith(u'…') ? said.left(refused.size() - 1) + u'…' : said;
            QCOMPARE(shown, refused);
            QVERIFY(said.size() > 10);
            return;
        }
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QCOMPARE(noteTexts(read->notes), told(example, "note"));
        const auto csv = landmarksText(read->sets, Format::Csv);
        QVERIFY(csv);
        const QStringList points = told(example, "points"), lines = told(example, "csv"),
                          csvNotes = told(example, "csv note");
        QCOMPARE(std::size_t(points.size() + lines.size() + csvNotes.size() + told(example, "note").size()),
                 example.told.size()); // there are no other words
        QVERIFY(points.isEmpty() != lines.isEmpty());
        if (!points.isEmpty())
            QCOMPARE(pointsOf(*read), points);
        if (!points.isEmpty() && format == Format::Csv) {
            // Our own table of it reads back the same.
            const auto again = parseLandmarks(csv->text, Format::Csv, "f");
            QVERIFY(again);
            QCOMPARE(pointsOf(*again), points);
        }
        if (lines.isEmpty())
            return;
        QCOMPARE(QString::fromStdString(csv->text), lines.join(u'\n') + u'\n');
        QStringList notes = noteTexts(csv->notes);
        notes.removeIf([](const QString &note) { return note.contains("DocumentData"); }); // a table has no room for it
        QCOMPARE(notes, csvNotes);
    }
};

UNPROJECTOR_TEST(TestForeignLandmarks)
#include "test_foreign_landmarks.moc"
