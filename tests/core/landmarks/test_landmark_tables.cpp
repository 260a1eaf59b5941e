// What tables of landmarks say besides the points, and names that spreadsheets would compute.

#include "tests/support/test.h"

#include "tests/core/landmarks/strict_landmarks.h"

#include <nlohmann/json.hpp>

using namespace strict_landmarks;
using namespace unprojector::geometry;
using namespace unprojector::landmark_files;
using namespace unprojector::landmarks;

namespace {

const QString kAxesFlipped = QStringLiteral(
    "the file is in RAS; x and y are negated, so that the points lie on a mesh as 3D Slicer reads one (LPS)");
const QString kCommas = QStringLiteral("the numbers have a decimal comma: 1,5 is one and a half");

} // namespace

class TestLandmarkTables : public QObject {
    Q_OBJECT

private slots:
    void whatSlicersTableSaysBesides()
    {
        const auto read = parseLandmarks("label,r,a,s,defined,selected,visible,locked,description\n"
                                         "\"a, b\",1,2,3,1,0,0,1,worn\nc,9,9,9,0,1,1,0,\n",
                                         Format::Csv, "f");
        QVERIFY(read);
        const LandmarkSet &set = read->sets.front();
        QVERIFY(set.axes == Axes::Ras);
        QCOMPARE(set.landmarks[0].note, std::string("worn"));
        QVERIFY(set.landmarks[0].isHidden && !set.landmarks[1].isHidden);
        QCOMPARE(set.landmarks[0].extra.json().dump(), std::string(R"({"selected":false,"locked":true})"));
        QVERIFY(set.landmarks[1].extra.json().is_null());
        QCOMPARE(
            noteTexts(read->notes),
            (QStringList{kAxesFlipped, "1 point is marked as not placed and had coordinates, which are left out"}));
        const auto fcsv = landmarksText({&set, 1}, Format::SlicerCsv);
        QVERIFY(fcsv && fcsv->text.find("0,1,2,3,0,0,0,1,0,0,1,\"a, b\",worn,") != std::string::npos);
    }

    void whatIsNothingStaysNothing()
    {
        LandmarkSet set;
        set.landmarks.resize(3);
        set.landmarks[0].name = set.landmarks[0].note = set.landmarks[0].object = "NA";
        set.landmarks[0].world = WorldPoint(1, 2, 3);
        const auto csv = landmarksText({&set, 1}, Format::Csv);
        QVERIFY(csv);
        QCOMPARE(csv->text, std::string("name,x,y,z,object,face,u,v,w,note\n\"NA\",1,2,3,\"NA\",,,,,\"NA\"\n"
                                        "\"\",,,,,,,,,\n\"\",,,,,,,,,\n"));
        const auto read = parseLandmarks(csv->text, Format::Csv, "f");
        QVERIFY(read && read->notes.empty());
        QVERIFY(read->sets.front() == set);
    }

    void namesThatAreFormulas_data()
    {
        addColumn<QByteArray>("name");
        addColumn<QByteArray>("plain");
        addColumn<QByteArray>("safe");
        const auto row = [](const char *name, const char *plain, const char *safe) {
            newRow(name) << QByteArray(name) << QByteArray(plain) << QByteArray(safe);
        };
        row("=SUM(A1:A9)", "=SUM(A1:A9)", "'=SUM(A1:A9)");
        row("=\"a\",1", "\"=\"\"a\"\",1\"", "\"'=\"\"a\"\",1\"");
        row("@home", "@home", "'@home");
        row("+x", "+x", "'+x");
        row("-x", "-x", "'-x");
        row("-", "-", "'-");
        row("-1-2", "-1-2", "'-1-2");
        row("-1.5e-3", "-1.5e-3", "-1.5e-3"); // stays what it is in a spreadsheet
        row("+5", "+5", "+5");
        row("a=b", "a=b", "a=b");
        row("'quoted'", "'quoted'", "'quoted'");
        row("'=x", "''=x", "''=x"); // an apostrophe that is the name's own
        row("''=x", "'''=x", "'''=x");
    }

    void namesThatAreFormulas()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, plain);
        QFETCH(QByteArray, safe);
        LandmarkSet set;
        set.landmarks.resize(1);
        set.landmarks[0].name = set.landmarks[0].note = set.landmarks[0].object = name.toStdString();
        set.landmarks[0].world = WorldPoint(-1, 2, 3);
        set.landmarks[0].extra.edit()["=" + name.toStdString()] = "kept";
        for (const auto &[texts, cell] : {std::pair(unprojector::base::CellTexts::ReadBack, plain),
                                          std::pair(unprojector::base::CellTexts::SpreadsheetSafe, safe)}) {
            const auto csv = landmarksText({&set, 1}, Format::Csv, texts);
            QVERIFY(csv);
            QCOMPARE(QByteArray::fromStdString(csv->text).split('\n')[1],
                     cell + ",-1,2,3," + cell + ",,,,," + cell + ",kept");
            const auto read = parseLandmarks(csv->text, Format::Csv, "f");
            QVERIFY(read && read->notes.empty());
            QVERIFY(read->sets.front() == set);
        }
    }

    void aPointAtMinusOnePassesThroughTps()
    {
        LandmarkSet set;
        set.landmarks.resize(2);
        set.landmarks[0].world = WorldPoint(-1, -1, -1);
        set.landmarks[1].world = WorldPoint(1, 1, 1);
        const auto text = landmarksText({&set, 1}, Format::Tps);
        QVERIFY(text);
        const auto read = parseLandmarks(text->text, Format::Tps, "f");
        QVERIFY(read && read->notes.empty());
        QVERIFY(read->sets.front() == set);
    }

    void notesOfManyFilesAreGrouped()
    {
        std::vector<FileNote> notes;
        for (int i = 0; i < 5; ++i) {
            const std::string file = std::to_string(i) + ".tps";
            notes.push_back({file, {"%1 point has two coordinates", {}, "%1 points have two coordinates", 2}});
            notes.push_back({file, {"multiplied by %1", {"0." + std::to_string(i)}}});
        }
        notes.push_back({"a.csv", {"a decimal comma"}});
        QStringList lines;
        for (const std::string &line : noteLines(notes))
            lines << QString::fromStdString(line);
        QCOMPARE(lines,
                 (QStringList{"5 files: 10 points have two coordinates",
                              "0.tps: multiplied by 0.0 (and 4 more notes like this one)", "a.csv: a decimal comma"}));
    }
};

UNPROJECTOR_TEST(TestLandmarkTables)
#include "test_landmark_tables.moc"
