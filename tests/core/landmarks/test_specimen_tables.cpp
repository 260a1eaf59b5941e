// Tables of several specimens: landmarks match by name, a second placing is no other specimen, and the
// measures of a protocol are columns.

#include "tests/support/test.h"

#include "core/landmark_files/measures_file.h"
#include "core/landmark_files/specimen_table.h"
#include "core/landmarks/distinct_names.h"
#include "core/landmarks/protocol.h"
#include "core/scene_file/scene_file.h"
#include "tests/support/data_files.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace {
using namespace unprojector::geometry;
using namespace unprojector::landmark_files;
using namespace unprojector::landmarks;

Landmark at(const char *name, double x, double y = 0.0, double z = 0.0)
{
    Landmark landmark;
    landmark.name = name;
    landmark.world = WorldPoint(x, y, z);
    landmark.uncertainty = WorldVector(0.5, 0.0, 0.0);
    return landmark;
}

Landmark absent(const char *name, Absence absence)
{
    Landmark landmark;
    landmark.name = name;
    landmark.absence = absence;
    return landmark;
}

LandmarkSet specimen(const char *name, std::vector<Landmark> landmarks, int placing = 1)
{
    LandmarkSet set;
    set.name = name;
    set.landmarks = std::move(landmarks);
    set.placing = placing;
    return set;
}

QString tableText(const std::vector<LandmarkSet> &sets, TableForm form, const ProtocolColumns &protocol = {},
                  const std::vector<Landmark> &names = {})
{
    const auto table = specimenTable(sets, form, protocol, names);
    return QString::fromStdString(table ? table->text : table.error().message());
}

QStringList notesOf(const std::vector<LandmarkSet> &sets, TableForm form)
{
    const auto table = specimenTable(sets, form);
    QStringList notes;
    if (table) {
        for (const auto &note : table->notes)
            notes << QString::fromStdString(note.text());
    }
    return notes;
}

} // namespace

class TestSpecimenTables : public QObject {
    Q_OBJECT

private slots:
    /// s1 has a, b; s2 has b, a in the other order; s3 has a and d.
    void landmarksMatchByName_data()
    {
        addColumn<TableForm>("form");
        addColumn<QString>("text");
        newRow("wide") << TableForm::Wide
                       << QString("specimen,a_x,a_y,a_z,b_x,b_y,b_z,d_x,d_y,d_z\ns1,1,0,0,2,0,0,NA,NA,NA\n"
                                  "s2,3,0,0,4,0,0,NA,NA,NA\ns3,5,0,0,NA,NA,NA,6,0,0\n");
        newRow("long") << TableForm::Long
                       << QString("specimen,name,x,y,z,object,face,u,v,w,note,dx,dy,dz\n"
                                  "s1,a,1,0,0,,,,,,,0.5,0,0\ns1,b,2,0,0,,,,,,,0.5,0,0\ns1,d,NA,NA,NA,,,,,,,,,\n"
                                  "s2,a,3,0,0,,,,,,,0.5,0,0\ns2,b,4,0,0,,,,,,,0.5,0,0\ns2,d,NA,NA,NA,,,,,,,,,\n"
                                  "s3,a,5,0,0,,,,,,,0.5,0,0\ns3,b,NA,NA,NA,,,,,,,,,\ns3,d,6,0,0,,,,,,,0.5,0,0\n");
        newRow("tps") << TableForm::Tps
                      << QString("LM3=3\n1 0 0\n2 0 0\nNA NA NA\nID=s1\n\nLM3=3\n3 0 0\n4 0 0\nNA NA NA\nID=s2\n\n"
                                 "LM3=3\n5 0 0\nNA NA NA\n6 0 0\nID=s3\n\n");
        newRow("nts") << TableForm::Nts
                      << QString("1 3L 9 1 9999 DIM=3\ns1\ns2\ns3\n1 0 0 2 0 0 9999 9999 9999\n"
                                 "3 0 0 4 0 0 9999 9999 9999\n5 0 0 9999 9999 9999 6 0 0\n");
    }

    void landmarksMatchByName()
    {
        QFETCH(TableForm, form);
        QTEST(tableText({specimen("s1", {at("a", 1), at("b", 2)}), specimen("s2", {at("b", 4), at("a", 3)}),
                         specimen("s3", {at("a", 5), at("d", 6)})},
                        form),
              "text");
    }

    void theSeriesNamesComeFirst()
    {
        QCOMPARE(tableText({specimen("s", {at("a", 1), at("b", 2)})}, TableForm::Wide, {},
                           {absent("c", Absence::NotPlaced), absent("b", Absence::NotPlaced)}),
                 QString("specimen,c_x,c_y,c_z,b_x,b_y,b_z,a_x,a_y,a_z\ns,NA,NA,NA,2,0,0,1,0,0\n"));
    }

    void spellingsOfOneName()
    {
        const std::vector<LandmarkSet> sets{specimen("s1", {at("Eye left", 1), at("b", 2)}),
                                            specimen("s2", {at("B", 4), at("eye_left", 3)})};
        QCOMPARE(tableText(sets, TableForm::Wide),
                 QString("specimen,Eye left_x,Eye left_y,Eye left_z,b_x,b_y,b_z\ns1,1,0,0,2,0,0\ns2,3,0,0,4,0,0\n"));
        const QStringList notes = notesOf(sets, TableForm::Wide);
        QVERIFY(notes.contains("the name \"eye_left\" as \"Eye left\"") && notes.contains("the name \"B\" as \"b\""));
        // A specimen that has both means two landmarks.
        const std::vector<LandmarkSet> both{specimen("s1", {at("a", 1), at("A", 2)}), specimen("s2", {at("A", 3)})};
        QCOMPARE(tableText(both, TableForm::Tps),
                 QString("LM3=2\n1 0 0\n2 0 0\nID=s1\n\nLM3=2\nNA NA NA\n3 0 0\nID=s2\n\n"));
    }

    void placingsAreNoSpecimens()
    {
        const std::vector<LandmarkSet> sets{specimen("s", {at("a", 1)}), specimen("s", {at("a", 2)}, 2)};
        QCOMPARE(tableText(sets, TableForm::Wide), QString("specimen,placing,a_x,a_y,a_z\ns,1,1,0,0\ns,2,2,0,0\n"));
        QCOMPARE(tableText(sets, TableForm::Long),
                 QString("specimen,placing,name,x,y,z,object,face,u,v,w,note,dx,dy,dz\ns,1,a,1,0,0,,,,,,,0.5,0,0\n"
                         "s,2,a,2,0,0,,,,,,,0.5,0,0\n"));
        QCOMPARE(tableText(sets, TableForm::Tps), QString("LM3=1\n1 0 0\nID=s\n\n"));
        QCOMPARE(tableText(sets, TableForm::Nts), QString("1 1L 3 0 DIM=3\ns\n1 0 0\n"));
        for (const TableForm form : {TableForm::Tps, TableForm::Nts})
            QVERIFY(notesOf(sets, form)
                        .contains("1 repeated placing is left out: the format would have it as one more specimen"));
    }

    /// The program's own word for a pixel's edge is told nowhere.
    void theNotesThatMatterComeFirst()
    {
        LandmarkSet first = specimen("s", {at("a", 1)});
        first.landmarks[0].object = "skull";
        first.landmarks[0].note = "worn";
        first.landmarks[0].extra.edit()["pixelEdge"] = true;
        LandmarkSet second = specimen("s", {at("a", 2)}, 2);
        for (const char *key : {"pixelEdge", "sex"})
            second.landmarks[0].extra.edit()[key] = true;
        second.landmarks[0].object = "skull";
        LandmarkSet third = specimen("t", {at("a", 2)});
        third.landmarks[0].extra = second.landmarks[0].extra;
        third.unit = first.unit = second.unit = "mm";
        const std::vector<LandmarkSet> sets{first, second, third};
        QCOMPARE(notesOf(sets, TableForm::Wide), QStringList("the unit, mm, is left out"));
        const QStringList notes = notesOf(sets, TableForm::Tps);
        QVERIFY(notes.size() > 3);
        QVERIFY2(notes[0].startsWith("1 repeated placing is left out"), qPrintable(notes.join('\n')));
        QVERIFY2(notes.indexOf("the unit, mm, is left out") < notes.indexOf("the objects of 1 landmark are left out"),
                 qPrintable(notes.join('\n')));
        QVERIFY2(notes.contains("the other values of 1 landmark are left out: sex"), qPrintable(notes.join('\n')));
    }

    void placingsComeBack()
    {
        const std::vector<LandmarkSet> sets{specimen("s", {at("a", 1)}), specimen("s", {at("a", 2)}, 2),
                                            specimen("t", {at("a", 2)}, 12)};
        const auto read = parseLandmarks(tableText(sets, TableForm::Long).toStdString(), Format::Csv, "file");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QCOMPARE(read->sets.size(), sets.size());
        for (std::size_t i = 0; i < sets.size(); ++i) {
            QCOMPARE(read->sets[i].name, sets[i].name);
            QCOMPARE(read->sets[i].placing, sets[i].placing);
            QCOMPARE(read->sets[i].landmarks.size(), std::size_t(1));
        }
        // A placing without the first one keeps its number.
        const QString tps = tableText({sets[2]}, TableForm::Tps);
        QCOMPARE(tps, QString("LM3=1\n2 0 0\nCOMMENT=placing 12\nID=t\n\n"));
        const auto second = parseLandmarks(tps.toStdString(), Format::Tps, "file");
        QVERIFY(second && second->sets.front().placing == 12 && second->sets.front().extra == sets[0].extra);
        const auto bad = parseLandmarks("name,placing,x,y,z\na,0,1,2,3\n", Format::Csv, "f");
        QVERIFY(!bad);
        QCOMPARE(QString::fromStdString(bad.error().message()),
                 QString("f:2: placing is 0; write a whole number from 1 to 99"));
    }

    void absencesAreCounted()
    {
        const auto table = specimenTable(
            std::vector{specimen("s", {at("a", 1), absent("b", Absence::Missing), absent("c", Absence::Skipped)}),
                        specimen("t", {at("a", 2), absent("b", Absence::NotPlaced)})},
            TableForm::Wide);
        QVERIFY(table);
        QCOMPARE(table->absent.missing, std::size_t(1));
        QCOMPARE(table->absent.skipped, std::size_t(1));
        QCOMPARE(table->absent.notPlaced, std::size_t(2)); // t has no c
        QCOMPARE(QString::fromStdString(absentText(table->absent)),
                 QString("4 landmarks have no coordinates (not placed: 2, skipped: 1, missing on their specimens: 1)"));
        QVERIFY(absentText({}).empty());
    }

    void curvesMatchByName()
    {
        const auto curve = [](const char *name, double x) {
            Curve made;
            made.name = name;
            made.semilandmarks = {WorldPoint(x, 0, 0), WorldPoint(x, 1, 0)};
            made.count = 2;
            return made;
        };
        std::vector<LandmarkSet> sets{specimen("s", {at("a", 1)}), specimen("t", {at("a", 2)})};
        sets[0].curves = {curve("brow", 10), curve("jaw", 20)};
        sets[1].curves = {curve("jaw", 40), curve("brow", 30)};
        QVERIFY2(
            tableText(sets, TableForm::Tps).contains("2 0 0\nCURVES=2\nPOINTS=2\n30 0 0\n30 1 0\nPOINTS=2\n40 0 0\n"),
            qPrintable(tableText(sets, TableForm::Tps)));
        sets[1].curves.pop_back(); // t has no brow: its points are NA, as those of landmarks
        QCOMPARE(tableText(sets, TableForm::Tps),
                 QString("LM3=5\n1 0 0\n10 0 0\n10 1 0\n20 0 0\n20 1 0\nID=s\n\n"
                         "LM3=5\n2 0 0\nNA NA NA\nNA NA NA\n40 0 0\n40 1 0\nID=t\n\n"));
    }

    void protocolIsColumns()
    {
        const std::vector<LandmarkSet> sets{specimen("s", {at("a", 0), at("b", 3, 4)}),
                                            specimen("t", {at("a", 1), absent("b", Absence::Missing)})};
        const std::vector<KeptMeasure> measures{{"width, outer", MeasureKind::Distance, {"a", "b"}}};
        std::vector<std::vector<ProtocolValue>> values;
        for (const LandmarkSet &set : sets)
            values.push_back({valueOf(measures.front(), set, {})});
        const ProtocolColumns protocol{measures, values};
        // 0.5 along x at both ends, and x is 3/5 of the direction.
        QCOMPARE(tableText(sets, TableForm::Wide, protocol),
                 QString("specimen,a_x,a_y,a_z,b_x,b_y,b_z,\"width, outer\",\"width, outer_error\",measures_note\n"
                         "s,0,0,0,3,4,0,5,0.6,\n"
                         "t,1,0,0,NA,NA,NA,NA,NA,\"width, outer: \"\"b\"\" is missing on this specimen\"\n"));
        const QString rows = tableText(sets, TableForm::Long, protocol);
        QVERIFY2(rows.contains("dx,dy,dz,absence,\"width, outer\",\"width, outer_error\",measures_note\n"),
                 qPrintable(rows));
        QVERIFY2(rows.contains("0.5,0,0,,5,0.6,\n"), qPrintable(rows));
        QVERIFY2(rows.contains("missing,NA,NA,\"width, outer: \"\"b\"\" is missing on this specimen\"\n"),
                 qPrintable(rows));
        const auto tps = specimenTable(sets, TableForm::Tps, protocol);
        QVERIFY(tps);
        QCOMPARE(tps->notes.front().text(),
                 std::string("1 measure of the protocol is left out; save the protocol in a file of its own"));
    }

    void valuesOfMeasures_data()
    {
        addColumn<KeptMeasure>("measure");
        addColumn<double>("value");
        addColumn<QString>("reason");
        using N = std::vector<std::string>;
        const double none = 0.0;
        const auto row = [](const char *name, MeasureKind kind, const N &landmarks, double value,
                            const QString &reason) {
            newRow(name) << KeptMeasure{name, kind, landmarks} << value << reason;
        };
        row("distance", MeasureKind::Distance, N{"o", "x"}, 3.0, {});
        row("angle at the second", MeasureKind::Angle, N{"x", "o", "y"}, 90.0, {});
        row("angle at another", MeasureKind::Angle, N{"o", "x", "y"}, 53.130102354155978, {});
        row("height", MeasureKind::Height, N{"o", "x", "y", "up"}, 7.0, {});
        row("height, the plane the other way round", MeasureKind::Height, N{"o", "y", "x", "up"}, -7.0, {});
        row("length", MeasureKind::Length, N{"x", "o", "y"}, 7.0, {});
        row("along the surface", MeasureKind::Surface, N{"x", "y"}, 42.0, {});
        row("another spelling", MeasureKind::Distance, N{"O ", "X"}, 3.0, {});
        row("skipped", MeasureKind::Distance, N{"o", "later"}, none, "\"later\" is skipped and not placed yet");
        row("missing", MeasureKind::Surface, N{"o", "gone"}, none, "\"gone\" is missing on this specimen");
        row("not placed", MeasureKind::Distance, N{"o", "wait"}, none, "\"wait\" has no position yet");
        row("no such landmark", MeasureKind::Distance, N{"o", "q"}, none, "no landmark has the name \"q\"");
        row("one position", MeasureKind::Angle, N{"o", "o", "y"}, none,
            "two of its landmarks are at the same position");
        row("on a line", MeasureKind::Height, N{"o", "x", "o", "up"}, none,
            "its first three landmarks may lie on one line");
        row("too few", MeasureKind::Angle, N{"o", "x"}, none, "it has the wrong number of landmarks");
    }

    void valuesOfMeasures()
    {
        QFETCH(KeptMeasure, measure);
        QFETCH(double, value);
        QFETCH(QString, reason);
        const LandmarkSet set =
            specimen("s", {at("o", 0), at("x", 3), at("y", 0, 4), at("up", 1, 1, 7), absent("later", Absence::Skipped),
                           absent("gone", Absence::Missing), absent("wait", Absence::NotPlaced)});
        const auto along = [](std::span<const Landmark *const> points) -> Result<Measure, std::string> {
            return Measure{points.size() == 2 && points[1]->name == "y" ? 42.0 : 0.0, std::nullopt};
        };
        const ProtocolValue found = valueOf(measure, set, along);
        QCOMPARE(QString::fromStdString(found.reason), reason);
        QCOMPARE(found.measure.has_value(), reason.isEmpty());
        if (found.measure)
            QCOMPARE(found.measure->value, value);
        if (measure.kind == MeasureKind::Surface && found.measure)
            QCOMPARE(QString::fromStdString(valueOf(measure, set, {}).reason), QString("the mesh is not open"));
    }

    void measuresFiles()
    {
        const std::vector<KeptMeasure> measures{{"height, nose", MeasureKind::Distance, {"nasion", "sub \"n\""}},
                                                {"a", MeasureKind::Angle, {"a", "b", "c"}},
                                                {"h", MeasureKind::Height, {"a", "b", "c", "d"}},
                                                {"l", MeasureKind::Length, {"a", "b", "c", "d", "e"}},
                                                {"s", MeasureKind::Surface, {"a", "NA"}}};
        const std::string text = measuresText(measures);
        QVERIFY(text.starts_with(
            "name,kind,landmarks\n\"height, nose\",distance,nasion,\"sub \"\"n\"\"\"\na,angle,a,b,c\n"));
        const auto read = parseMeasures(text, "f");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QVERIFY(*read == measures);
        // As a spreadsheet writes it.
        const auto padded = parseMeasures("\xef\xbb\xbfName;Kind;landmarks;;\r\nw;Distance;a;b;\r\n;;;;\r\n", "f");
        QVERIFY(padded && padded->size() == 1 && padded->front().landmarks == (std::vector<std::string>{"a", "b"}));
        QVERIFY(isMeasuresFile("dir/x.Measures.csv") && isMeasuresFile(kSeriesMeasures)
                && !isMeasuresFile("measures.csv"));
    }

    void badMeasuresFiles_data() { data_files::addCases("measures"); }

    void badMeasuresFiles()
    {
        QFETCH(data_files::Case, example);
        const auto read = parseMeasures(example.text, "f");
        QVERIFY(!read);
        QCOMPARE(QString::fromStdString(read.error().message()), QString::fromStdString(example.refused()));
    }

    void aSceneKeepsItsMeasures()
    {
        using namespace unprojector::scene_file;
        const char *text =
            R"({"unprojector": 1, "window": {"width": 8, "height": 8}, "projection": {"type": "perspective",
        "fovy": 60, "near": 1, "far": 9}, "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
        "landmarks": {"points": [], "measures": [{"name": "w", "kind": "angle", "landmarks": ["a", "b", "c"]}]}})";
        const auto scene = parseScene(text, "f");
        QVERIFY(scene);
        const std::vector<KeptMeasure> expected{{"w", MeasureKind::Angle, {"a", "b", "c"}}};
        QVERIFY(scene->landmarks.measures == expected);
        const auto written = sceneText(*scene);
        QVERIFY(written);
        const auto again = parseScene(*written, "f");
        QVERIFY(again && again->landmarks.measures == expected);
    }
};

UNPROJECTOR_TEST(TestSpecimenTables)
#include "test_specimen_tables.moc"
