// Landmarks without a position through files: not placed yet, skipped, or missing on the specimen.

#include "tests/support/test.h"

#include "core/landmark_files/landmark_file.h"
#include "tests/core/landmarks/strict_landmarks.h"
#include "tests/core/parsed_scenes.h"
#include "tests/core/scene_texts.h"

#include <nlohmann/json.hpp>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::landmark_files;
using namespace unprojector::landmarks;
using namespace strict_landmarks;

namespace {

Landmark absent(const char *name, Absence absence)
{
    Landmark landmark;
    landmark.name = name;
    landmark.absence = absence;
    return landmark;
}

/// One landmark that is placed, and absent ones.
LandmarkSet setWith(const std::vector<Absence> &absences)
{
    LandmarkSet set;
    set.landmarks.push_back(absent("placed", Absence::NotPlaced));
    set.landmarks[0].world = WorldPoint(1, 2, 3);
    for (const Absence absence : absences)
        set.landmarks.push_back(absent(("p" + std::to_string(set.landmarks.size())).c_str(), absence));
    return set;
}

const std::vector<Absence> kAll{Absence::NotPlaced, Absence::Skipped, Absence::Missing};

} // namespace

class TestAbsentLandmarks : public QObject {
    Q_OBJECT

private slots:
    void reasonsComeBack_data()
    {
        addColumn<Format>("format");
        addColumn<bool>("hasSkipped");
        addColumn<bool>("hasMissing");
        newRow("csv") << Format::Csv << true << true;
        newRow("mrk.json") << Format::SlicerJson << false << true;
        newRow("fcsv") << Format::SlicerCsv << false << true;
        newRow("pp") << Format::MeshLab << false << false;
        newRow("pts") << Format::Idav << false << false;
        newRow("tps") << Format::Tps << false << false;
        newRow("nts") << Format::Nts << false << false;
    }

    void reasonsComeBack()
    {
        QFETCH(Format, format);
        QFETCH(bool, hasSkipped);
        QFETCH(bool, hasMissing);
        const LandmarkSet set = setWith(kAll);
        const auto text = landmarksText({&set, 1}, format);
        QVERIFY(text);
        const auto read = parseLandmarks(text->text, format, "p");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        const std::vector<Landmark> &back = read->sets.front().landmarks;
        QCOMPARE(back.size(), std::size_t(4));
        QVERIFY(back[0].isPlaced() && back[0].absence == Absence::NotPlaced);
        for (std::size_t i = 1; i < back.size(); ++i)
            QVERIFY(!back[i].isPlaced());
        QVERIFY(back[1].absence == Absence::NotPlaced);
        QVERIFY(back[2].absence == (hasSkipped ? Absence::Skipped : Absence::NotPlaced));
        QVERIFY(back[3].absence == (hasMissing ? Absence::Missing : Absence::NotPlaced));
        const QList<StrictPoint> strict = strictPoints(QByteArray::fromStdString(text->text), format);
        for (qsizetype i = 0; i < strict.size(); ++i)
            QCOMPARE(strict[i].isMissing, i > 0);
    }

    void reasonsThatAreLostAreReported_data()
    {
        addColumn<Format>("format");
        addColumn<QString>("note");
        const QString alike =
                          "3 points have no position, for different reasons (not placed: 1, skipped: 1, missing: 1); "
                          "the reasons are left out",
                      skipped = "1 skipped point is written as not placed";
        newRow("csv") << Format::Csv << QString();
        newRow("pptpl") << Format::MeshLabTemplate << QString();
        newRow("mrk.json") << Format::SlicerJson << skipped;
        newRow("fcsv") << Format::SlicerCsv << skipped;
        for (const Format format : {Format::MeshLab, Format::Idav, Format::Tps, Format::Nts})
            newRow(suffixOf(format)) << format << alike;
    }

    void reasonsThatAreLostAreReported()
    {
        QFETCH(Format, format);
        QFETCH(QString, note);
        const LandmarkSet set = setWith(kAll);
        const auto text = landmarksText({&set, 1}, format);
        QVERIFY(text);
        QStringList notes = noteTexts(text->notes);
        notes.removeIf([](const QString &other) {
            return other.contains("the names") || other.contains("coordinates") || other.contains("0, 0, 0")
                   || other.contains("the name \"\"");
        });
        QCOMPARE(notes, note.isEmpty() ? QStringList() : QStringList(note));
    }

    /// NA is the word of these formats for a missing landmark.
    void equalReasonsLoseNothing()
    {
        for (const Absence absence : kAll) {
            const LandmarkSet set = setWith({absence, absence});
            for (const Format format : {Format::MeshLab, Format::Idav}) {
                const auto text = landmarksText({&set, 1}, format);
                QVERIFY(text);
                QCOMPARE(noteTexts(text->notes), QStringList());
            }
        }
    }

    void theWordsOfTheFormats()
    {
        const LandmarkSet set = setWith(kAll);
        const auto textOf = [&set](Format format) { return landmarksText({&set, 1}, format).value().text; };
        QCOMPARE(textOf(Format::Csv),
                 std::string("name,x,y,z,object,face,u,v,w,note,absence\nplaced,1,2,3,,,,,,,\np1,,,,,,,,,,\n"
                             "p2,,,,,,,,,,skipped\np3,,,,,,,,,,missing\n"));
        const std::string fcsv = textOf(Format::SlicerCsv);
        QCOMPARE(fcsv.substr(fcsv.find("NodeID\n") + 7),
                 std::string("0,1,2,3,0,0,0,1,1,1,0,placed,,,2,0\n1,0,0,0,0,0,0,1,1,1,0,p1,,,0,0\n"
                             "2,0,0,0,0,0,0,1,1,1,0,p2,,,0,0\n3,0,0,0,0,0,0,1,1,1,0,p3,,,3,0\n"));
        const QJsonArray points = QJsonDocument::fromJson(QByteArray::fromStdString(textOf(Format::SlicerJson)))
                                      .object()["markups"][0]["controlPoints"]
                                      .toArray();
        QStringList statuses;
        for (const QJsonValue point : points)
            statuses << point["positionStatus"].toString();
        QCOMPARE(statuses, (QStringList{"defined", "undefined", "undefined", "missing"}));
        // A table without the column is an older one, or another program's.
        const auto older = parseLandmarks("name,x,y,z\na,,,\n", Format::Csv, "p");
        QVERIFY(older && older->sets[0].landmarks[0].absence == Absence::NotPlaced);
    }

    void ofAScene()
    {
        scene_file::SceneFile scene = scene_texts::parsed(scene_texts::kFullScene);
        scene.landmarks = setWith(kAll);
        const auto text = scene_file::sceneText(scene);
        QVERIFY(text);
        const QJsonArray points = QJsonDocument::fromJson(QByteArray::fromStdString(*text))
                                      .object()["landmarks"]
                                      .toObject()["points"]
                                      .toArray();
        QStringList words;
        for (const QJsonValue point : points)
            words << (point.toObject().contains("absence") ? point["absence"].toString() : QString("-"));
        QCOMPARE(words, (QStringList{"-", "-", "skipped", "missing"}));
        const auto read = scene_file::parseScene(*text, "s");
        QVERIFY(read);
        QVERIFY(read->landmarks == scene.landmarks);
    }
};

UNPROJECTOR_TEST(TestAbsentLandmarks)
#include "test_absent_landmarks.moc"
