// Tables of landmarks in the dialects that spreadsheets, R and other programs write, and the
// read-only formats.

#include "tests/support/test.h"

#include "tests/core/landmarks/strict_landmarks.h"

#include <nlohmann/json.hpp>

using namespace strict_landmarks;
using namespace unprojector::geometry;
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

const QString kTurned = QStringLiteral(
    "the file is in RAS; x and y are negated, so that the points lie on a mesh as 3D Slicer reads one (LPS)");
const QString kCommas = QStringLiteral("the numbers have a decimal comma: 1,5 is one and a half");

} // namespace

class TestLandmarkTables : public QObject {
    Q_OBJECT

private slots:
    void tables_data()
    {
        QTest::addColumn<Format>("format");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("points");
        QTest::addColumn<QStringList>("notes");
        const auto csv = [](const char *row, const QByteArray &text, const QStringList &points,
                            const QStringList &notes = {}) {
            QTest::newRow(row) << Format::Csv << text << points << notes;
        };
        const QStringList two{"a 1.5 2 -3 | b 4 5 6"};
        csv("tabs", "name\tx\ty\tz\na\t1.5\t2\t-3\nb\t4\t5\t6\n", two);
        csv("tabs, decimal commas", "name\tx\ty\tz\na\t1,5\t2\t-3\nb\t4\t5\t6\n", two, {kCommas});
        csv("semicolons", "name;x;y;z\na;1.5;2;-3\nb;4;5;6\n", two);
        csv("semicolons, decimal commas, quotes, a byte order mark",
            "\xef\xbb\xbf\"name\";\"x\";\"y\";\"z\"\r\n\"a\";\"1,5\";2,0;-3\r\n\"b\";4;5;6\r\n", two, {kCommas});
        csv("semicolons, names with commas", "name;x;y;z\nSmith, John;1,5;2;-3\n", {"Smith, John 1.5 2 -3"}, {kCommas});
        csv("a line that says the separator", "sep=;\r\nname;x;y;z\r\na;1.5;2;-3\r\nb;4;5;6\r\n", two);
        csv("blanks, as R writes tables", "\"name\" \"x\" \"y\" \"z\"\n\"1\" \"a\" 1.5 2 -3\n\"2\" \"b\" 4 5 6\n", two);
        csv("tabs, as R writes tables", "name\tx\ty\tz\n1\ta\t1.5\t2\t-3\n2\tb\t4\t5\t6\n", two);
        csv("R: row numbers", "\"\",\"name\",\"x\",\"y\",\"z\"\n\"1\",\"a\",1.5,2,-3\n\"2\",\"b\",4,5,6\n", two);
        csv("R: row names are the names", "\"\",\"x\",\"y\",\"z\"\n\"a\",1.5,2,-3\n\"b\",4,5,6\n", two);
        csv("R: other row names", "\"\",\"name\",\"x\",\"y\",\"z\"\n\"p\",\"a\",1.5,2,-3\n\"q\",\"b\",4,5,6\n", two,
            {"2 row names beside the names of the points are left out"});
        csv("R: decimal commas", "\"\";\"name\";\"x\";\"y\";\"z\"\n\"1\";\"a\";1,5;2;-3\n\"2\";\"b\";4;5;6\n", two,
            {kCommas});
        csv("R: row numbers of several specimens",
            "\"\",\"specimen\",\"x\",\"y\",\"z\"\n\"1\",\"s\",1,2,3\n\"2\",\"t\",4,5,6\n", {"s:  1 2 3", "t:  4 5 6"});
        csv("R: NA", "name,x,y,z,note\nNA,NA,NA,NA,NA\nb,4,5,6,NA\n", {"NA missing | b 4 5 6"});
        csv("NaN, null, #N/A", "name,x,y,z\na,NaN,nan,NaN\nb,null,,\nc,#N/A,#N/A,#N/A\n",
            {"a missing | b missing | c missing"});
        csv("padding of a spreadsheet", "name,x,y,z,,,\na,1.5,2,-3,,,\nb,4,5,6,,,\n,,,,,,\n,,,,,,\n", two,
            {"2 empty rows at the end of the table are left out"});
        csv("padding of the rows alone", "name,x,y,z\na,1.5,2,-3,,\nb,4,5,6,,\n", two);
        csv("an empty row among others is a missing point", "name,x,y,z\na,1.5,2,-3\n,,,\nb,4,5,6\n",
            {"a 1.5 2 -3 |  missing | b 4 5 6"});
        csv("apostrophes of a table of others", "name,x,y,z\n'=1,1.5,2,-3\nb,4,5,6\n", {"=1 1.5 2 -3 | b 4 5 6"},
            {"the apostrophe before 1 text is left out; it keeps spreadsheets from computing what follows"});
        csv("lone CR as line ends", "name,x,y,z\ra,1.5,2,-3\rb,4,5,6\r", two);
        csv("a CR inside a row", "name,x,y,z\na,1.5,\r2,-3\nb,4,5,6\r\n", two);
        csv("other words for a name", "Landmark,x,y,z\na,1.5,2,-3\nb,4,5,6\n", two);
        csv("a name beside a label", "label,name,x,y,z\nq,a,1.5,2,-3\nr,b,4,5,6\n", two);
        csv("picks of CloudCompare", "Point #0,1.5,2,-3\nPoint #1,4,5,6\n", {"Point #0 1.5 2 -3 | Point #1 4 5 6"},
            {"the table has no first line that names its columns; they are read as name,x,y,z"});
        csv("barycentric coordinates of four digits", "name,x,y,z,face,u,v,w\na,1.5,2,-3,7,0.3333,0.3333,0.3333\n",
            {"a 1.5 2 -3"});
        QTest::newRow("3D Slicer's, one row that ends early")
            << Format::SlicerCsv
            << QByteArray("# Markups fiducial file version = 5.8\n# CoordinateSystem = LPS\n# columns = "
                          "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n0,1.5,2,-3,0,0,0,1,1,1,0,a,")
            << QStringList{"a 1.5 2 -3"} << QStringList();
        csv("another program's column of curves", "name,x,y,z,curve\n1,1.5,2,-3,0\n2,4,5,6,0\n",
            {"1 1.5 2 -3 | 2 4 5 6"}, {});
        csv("a cloud of CloudCompare", "//X Y Z\n1.5 2 -3\n4 5 6\n", {" 1.5 2 -3 |  4 5 6"}, {});
        csv("a cloud of CloudCompare, with colours", "// X,Y,Z,R\n1.5,2,-3,9\n4,5,6,8\n", {" 1.5 2 -3 |  4 5 6"}, {});
        csv("picks of CloudCompare by index", "0,1.5,2,-3\n1,4,5,6\n", {"0 1.5 2 -3 | 1 4 5 6"},
            {"the table has no first line that names its columns; they are read as name,x,y,z"});
        csv("picks of CloudCompare, as it prints them",
            "Point #0,1.500000000000,2.000000000000,-3.000000000000\nPoint #1,4.000000000000,5.000000000000,"
            "6.000000000000\n",
            {"Point #0 1.5 2 -3 | Point #1 4 5 6"},
            {"the table has no first line that names its columns; they are read as name,x,y,z"});
        csv("picks of CloudCompare by index, whole numbers", "7,1.000000000000,2.000000000000,3.000000000000\n",
            {"7 1 2 3"}, {"the table has no first line that names its columns; they are read as name,x,y,z"});
        csv("picks of CloudCompare by index, all numbers whole", "0,1,2,3\n1,4,5,6\n", {"0 1 2 3 | 1 4 5 6"},
            {"the table has no first line that names its columns; they are read as name,x,y,z"});
        csv("picks with semicolons and decimal commas", "P0;1,5;2,0;-3\nP1;4;5;6\n", {"P0 1.5 2 -3 | P1 4 5 6"},
            {"the table has no first line that names its columns; they are read as name,x,y,z", kCommas});
        csv("coordinates only", "1.5 2 -3\n4 5 6\n", {" 1.5 2 -3 |  4 5 6"},
            {"the table has no first line that names its columns; they are read as x,y,z"});
        csv("3D Slicer's table, LPS",
            "label,l,p,s,defined,selected,visible,locked,description\nF-1,1,2,3,1,1,1,0,\nF-2,0,0,0,0,1,1,0,\n",
            {"F-1 1 2 3 | F-2 missing"});
        csv("3D Slicer's table, RAS", "label,r,a,s,defined,selected,visible,locked,description\nF-1,1,2,3,1,1,1,0,\n",
            {"F-1 -1 -2 3"}, {kTurned});

        const auto fcsv = [](const char *row, const QByteArray &text, const QStringList &points,
                             const QStringList &notes = {}) {
            QTest::newRow(row) << Format::SlicerCsv << text << points << notes;
        };
        const QByteArray head = "# Markups fiducial file version = 5.6\n# CoordinateSystem = LPS\n"
                                "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
        fcsv("fcsv: a CR inside a row",
             head + "1,1.5,2,-3,0,0,0,1,1,1,0,F-1,,\r,2,0\n2,4,5,6,0,0,0,1,1,1,0,F-2,,\r,2,0\n",
             {"F-1 1.5 2 -3 | F-2 4 5 6"});
        fcsv("fcsv: lone CR as line ends",
             QByteArray(head + "1,1.5,2,-3,0,0,0,1,1,1,0,F-1,,,2,0\n").replace('\n', '\r'), {"F-1 1.5 2 -3"});
        fcsv("fcsv: saved by a spreadsheet",
             "# Markups fiducial file version = 4.10,,,,,,,,,,,,,\n# CoordinateSystem = 0,,,,,,,,,,,,,\n"
             "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
             "a,1,2,3,0,0,0,1,1,1,0,F-1,,\n,,,,,,,,,,,,,\n",
             {"F-1 -1 -2 3"}, {kTurned});
        fcsv("fcsv: saved by a spreadsheet with semicolons",
             "# Markups fiducial file version = 4.10;;;\n# CoordinateSystem = 1;;;\n"
             "# columns = id;x;y;z;ow;ox;oy;oz;vis;sel;lock;label;desc;associatedNodeID\n"
             "a;1,5;2;-3;0;0;0;1;1;1;0;F-1, left;;\n",
             {"F-1, left 1.5 2 -3"}, {kCommas});
        fcsv("fcsv: comments in quotes",
             "\"# Markups fiducial file version = 4.10\"\n\"# CoordinateSystem = LPS\"\n\"# columns = "
             "id,x,y,z\"\n\"a\",1.5,2,-3,0,0,0,1,1,1,0,\"F-1\",\"\",\"\"\n",
             {"F-1 1.5 2 -3"});
        fcsv("fcsv: NA", head + "1,NA,NA,NA,0,0,0,1,1,1,0,F-1,NA,\n2,4,5,6,NA,NA,NA,NA,1,1,0,F-2,,\n",
             {"F-1 missing | F-2 4 5 6"});

        const auto json = [](const char *row, const char *position) {
            QTest::newRow(row) << Format::SlicerJson
                               << QByteArray(R"({"markups": [{"type": "Fiducial", "controlPoints": [
                                {"label": "a", "position": [1.5, 2, -3]}, {"label": "b", "position": )")
                                      + position + R"(, "positionStatus": "undefined"}]}]})"
                               << QStringList{"a 1.5 2 -3 | b missing"} << QStringList();
        };
        json("mrk.json: an empty text for a position", R"("")");
        json("mrk.json: an empty list", "[]");
        json("mrk.json: nulls", "[null, null, null]");
        json("mrk.json: NA", R"(["NA", "NA", "NA"])");

        const auto tps = [](const char *row, const QByteArray &text, const QStringList &points,
                            const QStringList &notes) { QTest::newRow(row) << Format::Tps << text << points << notes; };
        const QString
            flat = "3 points have two coordinates; z is 0",
            scaled = "coordinates are multiplied by the SCALE of the file, 0.5",
            isMissing = "1 point has only coordinates of -1, as tpsDig writes a missing point; it has no position here";
        tps("tps: -1 -1 is missing and not scaled", "LM=3\n2 4\n-1 -1\n6 8\nIMAGE=w.jpg\nID=1\nSCALE=0.5\n",
            {"1:  1 2 0 |  missing |  3 4 0"}, {isMissing, flat, scaled});
        tps("tps: with decimals", "LM=3\n2.00000 4.00000\n-1.00000 -1.00000\n6 8\n", {" 2 4 0 |  missing |  6 8 0"},
            {isMissing, flat});
        tps("tps: three times -1", "LM3=2\n2 4 6\n-1 -1 -1\nSCALE=0.5\n", {" 1 2 3 |  missing"}, {isMissing, scaled});
        tps("tps: among negative coordinates it is a point", "LM3=2\n-2 4 6\n-1 -1 -1\n", {" -2 4 6 |  -1 -1 -1"}, {});
        tps("tps: only one of them is -1", "LM=3\n2 4\n-1 3\n6 8\n", {" 2 4 0 |  -1 3 0 |  6 8 0"}, {flat});
        tps("tps: NA", "LM=3\nNA NA\nnan NaN\n6 8\nSCALE=0.5\n", {" missing |  missing |  3 4 0"}, {flat, scaled});
        tps("tps: a picture without landmarks", "LM=0\nIMAGE=a.jpg\nID=a\nLM3=1\n1 2 3\nID=b\n", {"a: ", "b:  1 2 3"},
            {});

        const auto nts = [](const char *row, const QByteArray &text, const QStringList &points,
                            const QStringList &notes = {}) {
            QTest::newRow(row) << Format::Nts << text << points << notes;
        };
        nts("nts: specimens, missing points", "1 2L 6 1 9999 DIM=3\na\nb\n1 2 3 4 5 6\n7 8 9.5 9999 9999 9999\n",
            {"a:  1 2 3 |  4 5 6", "b:  7 8 9.5 |  missing"});
        nts("nts: a row on several lines, small letters", "' IDAV\n1 1l 6 0 dim=3\na\n1 2 3\n4 5 6\n",
            {"a:  1 2 3 |  4 5 6"}, {"1 comment is left out"});
        nts("nts: one specimen of digit.fixed", "\"skull 7\n1 2 3 0 dim=3\n1 2 3\n4 5 6\n",
            {"skull 7:  1 2 3 |  4 5 6"});
        nts("nts: as digit.fixed prints it", "\"skull\n1 2 3 0 dim=3\n1.5  2  -3\nNA  NA  NA\n",
            {"skull:  1.5 2 -3 |  missing"});
        nts("nts: a second comment, as digitsurface prints it",
            "\"skull\n\"2 fixed; 0 sliding\n1 2 3 0 dim=3\n1 2 3\n4 5 6\n", {"skull:  1 2 3 |  4 5 6"},
            {"1 comment is left out"});
        nts("dta: IDAV Landmark, names with blanks",
            "'Saved by Landmark\n1 2L 6 1 9999 DIM=3\n\nskull 7.ply\nthe other skull.ply\n\n1 2 3\n4 5 6\n\n7 8 "
            "9\n9999 "
            "9999 9999\n",
            {"skull 7.ply:  1 2 3 |  4 5 6", "the other skull.ply:  7 8 9 |  missing"}, {"1 comment is left out"});
        nts("nts: as Checkpoint prints it", "1 1L 6 1 9999 Dim=3\r\nskull\r\n1\t2\t3\r\n4\t5\t6\r\n",
            {"skull:  1 2 3 |  4 5 6"});
        nts("nts: several labels in a line", "1 2L 3 0 DIM=3\na b\n1 2 3\n4 5 6\n", {"a:  1 2 3", "b:  4 5 6"});
        nts("nts: labels of the columns", "1 1L 6L 0 DIM=3\na\nN_x N_y N_z Tip.X Tip.Y Tip.Z\n1 2 3 4 5 6\n",
            {"a: N 1 2 3 | Tip 4 5 6"});
        nts("nts: labels in the rows", "1 2B 3 0 DIM=3\na 1 2 3\nb 4 5 6\n", {"a:  1 2 3", "b:  4 5 6"});
        nts("nts: labels behind the rows", "1 2E 3 0 DIM=3\n1 2 3 a\n4 5 6 b\n", {"a:  1 2 3", "b:  4 5 6"});
        nts("nts: two coordinates", "1 1L 4 0 DIM=2\na\n1 2 3 4\n", {"a:  1 2 0 |  3 4 0"},
            {"2 points have two coordinates; z is 0"});

        QTest::newRow("pts: NA") << Format::Idav << QByteArray("Version 1.0\n2\nS0 NA NA NA\nS1 1 2 3\n")
                                 << QStringList{"S0 missing | S1 1 2 3"} << QStringList();
        QTest::newRow("pp: nan") << Format::MeshLab
                                 << QByteArray("<PickedPoints><point x=\"nan\" y=\"nan\" z=\"nan\" active=\"1\" "
                                               "name=\"a\"/></PickedPoints>")
                                 << QStringList{"a missing"} << QStringList();
        QTest::newRow("landmarkAscii")
            << Format::LandmarkAscii
            << QByteArray(
                   "# Avizo 3D ASCII 2.0\r\n\r\n\r\ndefine Markers 2\r\n\r\nParameters {\r\n    NumSets 1,\r\n    "
                   "ContentType \"LandmarkSet\"\r\n}\r\n\r\nMarkers { float[3] Coordinates } @1\r\n\r\n"
                   "# Data section follows\r\n@1\r\n1.500000000000000e+00 2 -3 \r\n4 5 6 \r\n\r\n")
            << QStringList{" 1.5 2 -3 |  4 5 6"} << QStringList();
        QTest::newRow("landmarkAscii: two sets and something else")
            << Format::LandmarkAscii
            << QByteArray("# AmiraMesh 3D ASCII 2.0\ndefine Markers 1\nMarkers { float[3] Coordinates } @1\n"
                          "Markers { int MarkerTypes } @2\nMarkers { float[3] Coordinates2 } = @3\n"
                          "@1\n1 2 3\n@2\n7\n@3\n4 5 6\n")
            << QStringList{" 1 2 3", " 4 5 6"} << QStringList{"other values of 1 specimen are left out: MarkerTypes"};
        QTest::newRow("landmarkAscii: the oldest form")
            << Format::LandmarkAscii
            << QByteArray(
                   "# AmiraMesh ASCII 1.0\n# Created by a script\n\ndefine Markers 2 Parameters {\nContentType "
                   "\"LandmarkSet\",nSets 1\n}\nMarkers { float[3] Coordinates } = @1\n\n@1 # 2 xyz coordinates\n"
                   "1.5 2 -3\n4 5 6\n")
            << QStringList{" 1.5 2 -3 |  4 5 6"} << QStringList();
        QTest::newRow("landmarkAscii: HyperMesh")
            << Format::LandmarkAscii
            << QByteArray(
                   "# HyperMesh 3D ASCII 1.0\n\ndefine Markers 1\n\nParameters {\n   ContentType \"LandmarkSet\",\n "
                   "  NumSets 1 }\n\nMarkers { float[3] Coordinates } @1\n\n# Data section follows\n\n@1\n1 2 3\n")
            << QStringList{" 1 2 3"} << QStringList();
        QTest::newRow("ljson: version 2")
            << Format::Landmarker
            << QByteArray(
                   R"({"version": 2, "labels": [{"label": "all", "mask": [0, 1, 2]}, {"label": "nose", "mask": [0]},
                         {"label": "eye", "mask": [2, 1]}], "landmarks": {"points": [[1.5, 2, -3], [null, null, null],
                         [4, 5, 6]], "connectivity": [[0, 1], [1, 2]]}})")
            << QStringList{"nose 1.5 2 -3 | eye_2 missing | eye_1 4 5 6"}
            << QStringList{"2 lines between points are left out"};
        QTest::newRow("ljson: version 1")
            << Format::Landmarker
            << QByteArray(R"({"version": 1, "groups": [{"label": "nose", "connectivity": [], "landmarks": [
                         {"point": [1, 2, 3]}]}, {"label": "eye", "landmarks": [{"point": [4, 5, 6]},
                         {"point": [null, null, null]}]}]})")
            << QStringList{"nose 1 2 3 | eye_1 4 5 6 | eye_2 missing"} << QStringList();
        QTest::newRow("ljson: version 3")
            << Format::Landmarker
            << QByteArray(R"({"version": 3, "groups": {"LJSON": {"labels": [{"label": "a", "mask": [0]}],
                         "landmarks": {"points": [[1, 2, 3]], "connectivity": []}}}})")
            << QStringList{"a 1 2 3"} << QStringList();
    }

    void tables()
    {
        QFETCH(Format, format);
        QFETCH(QByteArray, text);
        const auto read = parseLandmarks(text.toStdString(), format, "file");
        QVERIFY2(read, read ? "" : errorText(read.error()).c_str());
        QTEST(pointsOf(*read), "points");
        QTEST(noteTexts(read->notes), "notes");
        if (format != Format::Csv)
            return;
        // Our own table of it reads back the same.
        const auto written = landmarksText(read->sets, Format::Csv);
        QVERIFY(written);
        const auto again = parseLandmarks(written->text, Format::Csv, "file");
        QVERIFY(again);
        QCOMPARE(pointsOf(*again), pointsOf(*read));
    }

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
        QCOMPARE(noteTexts(read->notes),
                 (QStringList{kTurned, "1 point is marked as not placed and had coordinates, which are left out"}));
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
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("plain");
        QTest::addColumn<QByteArray>("safe");
        const auto row = [](const char *name, const char *plain, const char *safe) {
            QTest::newRow(name) << QByteArray(name) << QByteArray(plain) << QByteArray(safe);
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
        for (const auto &[texts, cell] : {std::pair(unprojector::text::CellTexts::AsTheyAre, plain),
                                          std::pair(unprojector::text::CellTexts::SpreadsheetSafe, safe)}) {
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
        using Kind = LandmarkNote::Kind;
        std::vector<FileNote> notes;
        for (int i = 0; i < 5; ++i) {
            const std::string file = std::to_string(i) + ".tps";
            notes.push_back({file, {Kind::FlatPoints, 2, {}}});
            notes.push_back({file, {Kind::Scaled, 1, "0." + std::to_string(i)}});
        }
        notes.push_back({"a.csv", {Kind::DecimalCommas, 1, {}}});
        QStringList lines;
        for (const std::string &line : noteLines(notes))
            lines << QString::fromStdString(line);
        QCOMPARE(lines,
                 (QStringList{"5 files: 10 points have two coordinates; z is 0",
                              "0.tps: coordinates are multiplied by the SCALE of the file, 0.0 (and 4 more notes "
                              "like this one)",
                              "a.csv: " + kCommas}));
    }
};

UNPROJECTOR_TEST(TestLandmarkTables)
#include "test_landmark_tables.moc"
