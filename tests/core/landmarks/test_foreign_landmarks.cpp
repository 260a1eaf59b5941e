// Files of landmarks as the other programs write them, each with a trap of its format, and files
// that are broken.

#include "tests/support/test.h"

#include "tests/core/landmarks/strict_landmarks.h"

using namespace strict_landmarks;
using namespace unprojector::landmark_files;

class TestForeignLandmarks : public QObject {
    Q_OBJECT

private slots:
    void filesOfOtherPrograms_data()
    {
        QTest::addColumn<Format>("format");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("asCsv");
        QTest::addColumn<QStringList>("notes");
        const QByteArray head = "name,x,y,z,object,face,u,v,w,note", empty = ",,,,,,\n";
        const QString turned = QStringLiteral(
            "the file is in RAS; x and y are negated, so that the points lie on a mesh as 3D Slicer reads one (LPS)");

        QTest::newRow("MeshLab: CRLF, a date, a user, a point that is not placed")
            << Format::MeshLab
            << QByteArray(
                   "<!DOCTYPE PickedPoints>\r\n<PickedPoints>\r\n <DocumentData>\r\n  <DateTime time=\"12:00:00\" "
                   "date=\"2026-10-01\"/>"
                   "\r\n  <User name=\"\"/>\r\n  <DataFileName name=\"face.ply\"/>\r\n  <templateName "
                   "name=\"\"/>\r\n </DocumentData>\r\n"
                   " <point x=\"-1.5\" y=\"2\" z=\"3e-2\" active=\"1\" name=\"A &amp; B\"/>\r\n"
                   " <point active=\"0\" x=\"0\" y=\"0\" z=\"0\" name=\"gone\"/>\r\n</PickedPoints>\r\n")
            << head + ",mesh\nA & B,-1.5,2,0.03,,,,,,,face.ply\ngone,,,,,,,,,,face.ply\n"
            << QStringList();
        QTest::newRow("MeshLab: all on one line, a comment, coordinates of a point that is not placed")
            << Format::MeshLab
            << QByteArray(
                   "<?xml version='1.0'?><PickedPoints><!-- <point/> --><point z='3' y='2' x='1' name='it&#39;s'/>"
                   "<point x='9' y='9' z='9' active='0' name=''/></PickedPoints>")
            << head + "\nit's,1,2,3" + empty + "\"\",,,,,,,,,\n"
            << QStringList{"1 comment is left out",
                           "1 point is marked as not placed and had coordinates, which are left out"};
        QTest::newRow("MeshLab template")
            << Format::MeshLabTemplate
            << QByteArray("<!DOCTYPE PickPointsTemplate>\n<PickPointsTemplate>\n <point name=\"N\"/>\n"
                          " <point name=\"0x10\"/>\n</PickPointsTemplate>\n")
            << head + "\nN,,,,,,,,,\n0x10,,,,,,,,,\n"
            << QStringList();
        QTest::newRow("Slicer JSON: least, no axes")
            << Format::SlicerJson
            << QByteArray(
                   R"({"markups": [{"type": "Fiducial", "controlPoints": [{"label": "F-1", "position": [1, -2, 3.25]}]}]})")
            << head + "\nF-1,1,-2,3.25" + empty << QStringList();
        QTest::newRow("Slicer JSON: RAS, undefined, hidden, a note")
            << Format::SlicerJson
            << QByteArray(
                   R"({"@schema": "s", "markups": [{"type": "Fiducial", "coordinateSystem": "RAS", "coordinateUnits": "mm",
             "locked": false, "labelFormat": "%N-%d", "controlPoints": [
             {"id": "1", "label": "a,b", "description": "d", "associatedNodeID": "", "position": [1, -2, 3],
              "orientation": [1,0,0,0,1,0,0,0,1], "selected": true, "locked": false, "visibility": false, "positionStatus": "defined"},
             {"id": "2", "label": "u", "position": [0, 0, 0], "positionStatus": "undefined"},
             {"id": "9", "label": "m", "position": null, "positionStatus": "missing"}]}]})")
            << QByteArray("name,x,y,z,object,face,u,v,w,note,hidden,absence,unit,id\n\"a,b\",-1,2,3,,,,,,d,1,,mm,\n"
                          "u,,,,,,,,,,,,mm,\nm,,,,,,,,,,,missing,mm,9\n")
            << QStringList{turned, "other values of 1 specimen are left out: locked, labelFormat"};
        // Slicer moves a preview with the mouse until it is placed.
        QTest::newRow("Slicer JSON: a preview")
            << Format::SlicerJson
            << QByteArray(R"({"markups": [{"type": "Fiducial", "controlPoints": [{"label": "p", "position": [1, 2, 3],
             "positionStatus": "preview"}]}]})")
            << head + "\np,,,,,,,,,\n"
            << QStringList{"1 point is a preview, which was not placed in 3D Slicer; it has no position here"};
        QTest::newRow("Slicer CSV: a preview")
            << Format::SlicerCsv
            << QByteArray("# Markups fiducial file version = 5.8\n# CoordinateSystem = LPS\n"
                          "0,1,2,3,0,0,0,1,1,1,0,p,,,1,0\n1,1,2,3,0,0,0,1,1,1,0,q,,,2,0\n")
            << head + "\np,,,,,,,,,\nq,1,2,3" + empty
            << QStringList{"1 point is a preview, which was not placed in 3D Slicer; it has no position here"};
        QTest::newRow("NTSYS: values are missing, by no number")
            << Format::Nts << QByteArray("1 2 3 1 dim=3\n1 2 3\n9999 9999 9999\n")
            << head + "\n,1,2,3" + empty + ",9999,9999,9999" + empty
            << QStringList{
                   "the parameters say that values are missing, and not by which number; every number is read as a "
                   "coordinate"};
        QTest::newRow("Slicer CSV: LPS, a comma in a label, newer fields")
            << Format::SlicerCsv
            << QByteArray(
                   "# Markups fiducial file version = 5.8\n# CoordinateSystem = LPS\n"
                   "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
                   "0,-19.9,13.9,29.4,0,0,0,1,1,1,0,\"F \"\"1\"\", left\",,,2,0\n1,0,0,0,0,0,0,1,0,1,0,gone,,,0,0\n")
            << head + ",hidden\n\"F \"\"1\"\", left\",-19.9,13.9,29.4,,,,,,,\ngone,,,,,,,,,,1\n"
            << QStringList();
        QTest::newRow("Slicer CSV: the axes as a number, RAS")
            << Format::SlicerCsv
            << QByteArray("# Markups fiducial file version = 4.4\r\n# CoordinateSystem = 0\r\n# columns = id,x,y,z\r\n"
                          "vtkMRMLMarkupsFiducialNode_0,1,2,3,0,0,0,1,1,0,1,F-1,desc,\r\n")
            << QByteArray("name,x,y,z,object,face,u,v,w,note,id,selected,locked\nF-1,-1,-2,3,,,,,,desc,"
                          "vtkMRMLMarkupsFiducialNode_0,false,true\n")
            << QStringList{turned};
        QTest::newRow("Slicer CSV: the axes as a number, LPS")
            << Format::SlicerCsv
            << QByteArray(
                   "# Markups fiducial file version = 4.4\n# CoordinateSystem = 1\n0,1,2,3,0,0,0,1,1,1,0,F-1,,\n")
            << head + "\nF-1,1,2,3" + empty << QStringList();
        QTest::newRow("Slicer CSV: Slicer 3")
            << Format::SlicerCsv
            << QByteArray(
                   "# Fiducial List file old.fcsv\n# numPoints = 1\n# columns = label,x,y,z,sel,vis\nL1,1,2,3,1,1\n")
            << head + "\nL1,-1,-2,3" + empty << QStringList{"2 comments are left out", turned};
        QTest::newRow("IDAV: missing, tabs, no blank line at the end")
            << Format::Idav << QByteArray("Version 1.0\n3\nS000 1 2 3\nS001\t9999\t9999\t9999\nleft eye 4 5 6")
            << head + "\nS000,1,2,3" + empty + "S001,,,,,,,,,\nleft eye,4,5,6" + empty << QStringList();
        QTest::newRow("IDAV: names that look like numbers, a coordinate that really is 9999")
            << Format::Idav << QByteArray("Version 1.0\n2\n0x1F 9.999e3 2 3\n12 -1 1e5 +3\n\n")
            << head + "\n0x1F,9999,2,3" + empty + "12,-1,1e+05,3" + empty << QStringList();
        QTest::newRow("TPS: small letters, SCALE, IMAGE, curves")
            << Format::Tps
            << QByteArray(
                   "lm3=2\n1 2 3\nNA NA NA\nCURVES=1\nPOINTS=2\n7 7 7\n8 8 8\nIMAGE=a b.ply\nSCALE=0.5\nID = s 1\n")
            << "specimen," + head
                   + ",mesh,curve,curveKind,curveCount\ns 1,,0.5,1,1.5,,,,,,,a b.ply,,,\ns 1,,,,,,,,,,,a b.ply,,,\n"
                     "s 1,curve 1:01,3.5,3.5,3.5,,,,,,,a b.ply,curve 1,geodesic,2\n"
                     "s 1,curve 1:02,4,4,4,,,,,,,a b.ply,curve 1,geodesic,2\n"
            << QStringList{"coordinates are multiplied by the SCALE of the file, 0.5"};
        QTest::newRow("TPS: two coordinates, several specimens")
            << Format::Tps << QByteArray("LM=1\n1 2\nID=a\n\nLM=1\n3 4\nID=b\n")
            << "specimen," + head + "\na,,1,2,0" + empty + "b,,3,4,0" + empty
            << QStringList{"2 points have two coordinates; z is 0"};
        QTest::newRow("CSV: a byte order mark, other columns, capitals, CRLF, a line break in a name")
            << Format::Csv
            << QByteArray("\xef\xbb\xbf"
                          "Name,X,Y,Z,observer\r\n\"a\r\nb\",1,2,3,\"K, L\"\r\n\r\nc,,,,\r\n")
            << head + ",observer\n\"a\r\nb\",1,2,3,,,,,,,\"K, L\"\nc,,,,,,,,,,\n"
            << QStringList();
        QTest::newRow("CSV: the mark of a missing point")
            << Format::Csv
            << QByteArray(
                   "name,x,y,z\na,9999,9999,9999.0\nb,1,2,3\nc,-9999,-9999,-9999\nd,9999,9999,5\ne,9999,-9999,9999\n")
            << head + "\na,,,,,,,,,\nb,1,2,3" + empty + "c,,,,,,,,,\nd,9999,9999,5" + empty + "e,9999,-9999,9999"
                   + empty
            << QStringList{
                   "2 points have only coordinates of 9999 or -9999, the mark of missing points; they have no position "
                   "here"};
        QTest::newRow("CSV: the same coordinates, written by this program")
            << Format::Csv << QByteArray(head + "\na,9999,9999,9999" + empty)
            << QByteArray(head + "\na,9999,9999,9999" + empty) << QStringList();
    }

    void filesOfOtherPrograms()
    {
        QFETCH(Format, format);
        QFETCH(QByteArray, text);
        const auto read = parseLandmarks(text.toStdString(), format, "file");
        QVERIFY2(read, read ? "" : errorText(read.error()).c_str());
        const auto csv = landmarksText(read->sets, Format::Csv);
        QVERIFY(csv);
        QTEST(QByteArray::fromStdString(csv->text), "asCsv");
        QFETCH(QStringList, notes);
        QStringList told = noteTexts(read->notes) + noteTexts(csv->notes);
        told.removeIf([](const QString &note) { return note.contains("DocumentData"); }); // a table has no room for it
        QCOMPARE(told, notes);
    }

    void badFilesAreRefusedWithTheirLine_data()
    {
        QTest::addColumn<Format>("format");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto add = [](const char *row, Format format, const QByteArray &text, const char *message) {
            QTest::newRow(row) << format << text << QString(message);
        };
        add("csv: empty", Format::Csv, "",
            "f:1: the file is empty; the first line names the columns, name,x,y,z at least");
        add("csv: no z", Format::Csv, "name,x,y\na,1,2\n",
            "f:1: there is no column z; the first line names the columns, name,x,y,z at least");
        add("csv: decimal commas and points", Format::Csv, "name;x;y;z\na;1,5;2;3\nb;1.5;2;3\n",
            "f:2: x is \"1,5\"; write a number with a decimal point");
        add("csv: thousands", Format::Csv, "name\tx\ty\tz\na\t1,234.5\t2\t3\n",
            "f:2: x is \"1,234.5\"; write a number with a decimal point");
        add("csv: a decimal comma", Format::Csv, "name,x,y,z\na,\"1,5\",2,3\n",
            "f:2: x is \"1,5\"; write a number with a decimal point");
        add("csv: half a point", Format::Csv, "name,x,y,z\na,1,,3\n",
            "f:2: y is empty and its neighbours are not; give all three, or none");
        add("csv: too many cells", Format::Csv, "name,x,y,z\na,b,1,2,3\n",
            "f:2: this row has 5 cells, and the first line names 4 columns; put a cell that has the separator in it in "
            "quotes");
        add("csv: an open quote", Format::Csv, "name,x,y,z\na,1,2,3\n\"b,1,2,3\n",
            "f:3: a quote is opened here and never closed; close it, or double it within quotes");
        add("csv: not finite", Format::Csv, "name,x,y,z\n\na,nan,2,3\n",
            "f:3: x is \"nan\" and its neighbours are numbers; give all three, or none");
        add("csv: half a point is NA", Format::Csv, "name,x,y,z\na,1,2,NA\n",
            "f:2: z is \"NA\" and its neighbours are numbers; give all three, or none");
        add("csv: no column v", Format::Csv, "x,y,z,face,u\n1,2,3,7,0.5\n",
            "f:2: v is empty and its neighbours are not; give all three, or none");
        add("csv: infinite", Format::Csv, "name,x,y,z\na,inf,2,3\n", "f:2: x is \"inf\"; write a number");
        add("csv: four numbers that may be anything", Format::Csv, "1,2,3,4\n2,2,3,4\n",
            "f:1: there is no column x; the first line names the columns, name,x,y,z at least");
        add("csv: a face without its place", Format::Csv, "name,x,y,z,face\na,1,2,3,7\n",
            "f:2: face and u, v, w belong together; give all of them, or none");
        add("csv: a colour", Format::Csv, "x,y,z,color\n1,2,3,red\n", "f:2: color is \"red\"; write it as #rrggbb");
        add("csv: a column twice", Format::Csv, "x,y,z,X\n1,2,3,4\n",
            "f:1: the column \"X\" is there twice; rename one of them");
        add("csv: a cell of no column", Format::Csv, "x,y,z,\n1,2,3,5\n",
            "f:2: the cell \"5\" is in a column without a name; give it one in the first line");
        add("tps: SCALE twice", Format::Tps, "LM3=1\n1 2 3\nSCALE=2\nscale=2\n",
            "f:4: SCALE is here for the second time in a specimen; remove one of them");
        add("csv: no barycentric coordinates", Format::Csv, "x,y,z,face,u,v,w\n1,2,3,7,0.25,0.25,1\n",
            "f:2: the sum of u, v and w is 1.5; it must be 1");
        add("tps: SCALE of 0", Format::Tps, "LM3=1\n1 2 3\nSCALE=0\n", "f:3: SCALE is 0; it must be greater than 0");
        add("tps: SCALE that is 0 in double precision", Format::Tps, "LM3=1\n1 2 3\nSCALE=1e-400\n", "f:3: SCALE is ");
        add("tps: SCALE that mirrors", Format::Tps, "LM3=1\n1 2 3\nSCALE=-2\n",
            "f:3: SCALE is -2; it must be greater than 0");
        add("csv: UTF-16", Format::Csv, QByteArray("\xff\xfen\0a\0", 6),
            "f: this is not a text in UTF-8; save it as UTF-8");
        add("csv: Latin-1", Format::Csv, "name,x,y,z\na,1,2,3\n\xe9t\xe9,1,2,3\n",
            "f:3: this is not UTF-8; save the file as UTF-8");
        add("pts: overlong", Format::Idav, "Version 1.0\n1\n\xc0\x81 1 2 3\n",
            "f:3: this is not UTF-8; save the file as UTF-8");
        add("pp: a surrogate", Format::MeshLab, "<PickedPoints>\n<point name=\"\xed\xa0\x80\"/>",
            "f:2: this is not UTF-8; save the file as UTF-8");
        add("tps: cut within a letter", Format::Tps, "LM3=1\n1 2 3\nID=\xe9\xbc",
            "f:3: this is not UTF-8; save the file as UTF-8");
        add("pp: no XML", Format::MeshLab, "<PickedPoints>\n<point x=\"1\"\n", "f:3: this is not XML: ");
        add("pp: another document", Format::MeshLab, "<MeshLabProject/>",
            "f:1: there is no <PickedPoints>, which holds the points of MeshLab; is it another file?");
        add("pp: not a number", Format::MeshLab,
            "<PickedPoints>\n<!-- <point>\n-->\n<point x=\"1\" y=\"2\" z=\"3\" name=\"a\"/>\n<point x=\"1\" y=\"2,5\" "
            "z=\"3\" name=\"N\"/>\n</PickedPoints>",
            "f:5: y of point 2 (\"N\") is \"2,5\"; write a number with a decimal point");
        add("pp: too deep", Format::MeshLab, QByteArray("<a>").repeated(100000),
            "f:1: elements are nested deeper than 64 levels; ");
        add("mrk.json: no JSON", Format::SlicerJson, "{\"markups\": [\n}", "f:2: ");
        add("mrk.json: another document", Format::SlicerJson, "{\"unprojector\": 1}",
            "f:1: there is no list \"markups\"");
        add("mrk.json: two coordinates", Format::SlicerJson,
            R"({"markups": [{"controlPoints": [{"position": [1, 2]}]}]})",
            "f: markups[0].controlPoints[0].position: has 2 elements; it must have 3");
        add("mrk.json: other axes", Format::SlicerJson,
            R"({"markups": [{"coordinateSystem": "IJK", "controlPoints": []}]})",
            "f: markups[0].coordinateSystem: \"IJK\" must be LPS or RAS");
        add("fcsv: a comma in a label", Format::SlicerCsv,
            "# Markups fiducial file version = 5.8\n# CoordinateSystem = LPS\n0,1,2,3,0,0,0,1,1,1,0,F-1, left,,,2,0\n",
            "f:3: \"0,1,2,3,0,0,0,1,1,1,0,F-1, left,,,2,0\" is not a point; write id,x,y,z");
        add("fcsv: other axes", Format::SlicerCsv, "# Markups fiducial file version = 5.8\n# CoordinateSystem = IJK\n",
            "f:2: the coordinate system is \"IJK\"; it must be LPS or RAS (1 or 0)");
        const QByteArray fiducials = "# Markups fiducial file version = 5.8\n# CoordinateSystem = LPS\n";
        add("fcsv: another order", Format::SlicerCsv, fiducials + "# columns = id,y,x,z\n0,1,2,3,0,0,0,1,1,1,0,a,,\n",
            "f:3: the columns are \"id,y,x,z\"; put them in the order id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,"
            "associatedNodeID");
        add("fcsv: two axes", Format::SlicerCsv, fiducials + "# CoordinateSystem = RAS\n0,1,2,3,0,0,0,1,1,1,0,a,,\n",
            "f:3: the coordinate system is \"RAS\" here and another one before; keep one such line, before the points");
        add("fcsv: axes behind points", Format::SlicerCsv,
            "# Markups fiducial file version = 5.8\n0,1,2,3,0,0,0,1,1,1,0,a,,\n# CoordinateSystem = 1\n",
            "f:3: the coordinate system is \"1\" here and another one before");
        add("fcsv: cut off", Format::SlicerCsv, fiducials + "0,1,2,3,0,0,0,1,1,1,0,a,,,2,0\n1,1,2,3,0,0,0,1,1,1,0,b,,",
            "f:4: the file ends within this row, which has 14 of 16 cells; is it cut off?");
        add("fcsv: cut off in the only row", Format::SlicerCsv,
            fiducials + "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n0,1,2,3,0,0",
            "f:4: the file ends within this row, which has 6 of 14 cells; is it cut off?");
        add("pts: another version", Format::Idav, "Version 2.0\n1\na 1 2 3\n",
            "f:1: this .pts begins with \"Version 2.0\", and only \"Version 1.0\" is known; write that there if its "
            "rows "
            "are "
            "name, x, y and z");
        add("pts: four numbers", Format::Idav, "Version 1.0\n1\nb 4 5 6 7\n",
            "f:3: \"b 4 5 6 7\" has more than three numbers behind its name; write name, x, y and z, and _ for a blank "
            "in "
            "a "
            "name that ends in a number");
        add("pts: half a point", Format::Idav, "Version 1.0\n1\na 9999 5 9999\n",
            "f:3: some coordinates of a point are missing and some are not; a point is missing as a whole");
        add("pts: dlib", Format::Idav, "version: 1\nn_points: 68\n{\n1 2\n}\n",
            "f:1: this is a .pts of dlib, points in an image; only those of IDAV Landmark, which begin with \"Version "
            "1.0\", are points in space");
        add("pts: a point cloud", Format::Idav, "3\n1 2 3\n1 2 3\n1 2 3\n",
            "f:1: this .pts begins with \"3\", not with \"Version 1.0\" as those of IDAV Landmark do; a point cloud of "
            "a "
            "scanner is not read: save it as .ply, and open that as a model");
        add("pts: cut off", Format::Idav, "Version 1.0\n3\nS0 1 2 3\nS1 1 2 3\n",
            "f:4: the file ends after 2 of 3 points; is it cut off?");
        add("pts: one more", Format::Idav, "Version 1.0\n1\nS0 1 2 3\nS1 1 2 3\n",
            "f:4: line 2 says 1 points, and here is one more; write the right number there");
        add("pts: no name", Format::Idav, "Version 1.0\n1\n1 2 3\n",
            "f:3: \"1 2 3\" is not a point; write its name, x, y and z");
        add("tps: a row is missing", Format::Tps, "LM3=2\n1 2 3\nID=a\n",
            "f:3: \"ID=a\" is not a row of 3 numbers, which line 1 announces; write the right number of points there");
        add("tps: a row too many", Format::Tps, "LM3=1\n1 2 3\n4 5 6\n", "f:3: \"4 5 6\" belongs to nothing; ");
        add("tps: half missing", Format::Tps, "LM3=1\n1 NA 3\n",
            "f:2: some coordinates are NA and some are not; a point is missing as a whole");
        add("tps: cut off", Format::Tps, "LM3=4000000000\n1 2 3\n",
            "f:2: the file ends within the points that line 1 announces; is it cut off?");
        add("nts: no DIM", Format::Nts, "1 1L 3 0\na\n1 2 3\n",
            "f:1: \"1 1L 3 0\" has no DIM=3; this is not a matrix of landmarks");
        add("nts: cut off", Format::Nts, "1 2L 3 0 DIM=3\na\nb\n1 2 3\n4 5",
            "f:5: the file ends within the matrix that the parameters announce; is it cut off?");
        add("nts: more", Format::Nts, "1 1L 3 0 DIM=3\na\n1 2 3\n4\n",
            "f:4: \"4\" follows the matrix; write the right numbers of rows and columns into the parameters");
        add("nts: labels of two words and a number too many", Format::Nts, "1 1L 3 0 DIM=3\nskull 7\n1 2 3 4\n",
            "f:3: \"3\" follows the matrix; write ");
        add("csv: an unknown reason", Format::Csv, "name,x,y,z,absence\na,,,,broken\n",
            "f:2: absence is \"broken\"; write skipped or missing, or leave the cell empty");
        add("csv: missing, with coordinates", Format::Csv, "name,x,y,z,absence\na,1,2,3,Missing\n",
            "f:2: this landmark is marked as missing and has coordinates; empty the one or the other");
        add("nts: half missing", Format::Nts, "1 1L 3 1 9999 DIM=3\na\n1 9999 3\n",
            "f:3: some coordinates of a point are missing and some are not; a point is missing as a whole");
        add("nts: distances", Format::Nts, "2 3L 3 0 DIM=3\n",
            "f:1: \"2 3L 3 0 DIM=3\" is not a line of parameters; a matrix of landmarks begins with one like 1 12L 63 "
            "1 "
            "9999 DIM=3");
        add("landmarkAscii: binary", Format::LandmarkAscii, "# AmiraMesh BINARY-LITTLE-ENDIAN 2.1\n",
            "f:1: this file is binary; save it as \"LandmarkSet Ascii\" in Amira or Avizo");
        add("landmarkAscii: another", Format::LandmarkAscii, "1 2 3\n",
            "f:1: the first line is \"1 2 3\"; Amira and Avizo begin the file with \"# Avizo 3D ASCII 2.0\"");
        add("landmarkAscii: cut off", Format::LandmarkAscii,
            "# Avizo 3D ASCII 2.0\ndefine Markers 2\nMarkers { float[3] Coordinates } @1\n@1\n1 2 3\n",
            "f:5: here are 1 of the 2 points that \"define Markers\" announces; is the file cut off?");
        add("landmarkAscii: more", Format::LandmarkAscii,
            "# Avizo 3D ASCII 2.0\ndefine Markers 1\nMarkers { float[3] Coordinates } @1\n@1\n1 2 3\n4 5 6\n",
            "f:6: \"4 5 6\" follows the points; write the right number behind \"define Markers\"");
        add("ljson: a picture", Format::Landmarker, R"({"version": 2, "landmarks": {"points": [[1, 2]]}})",
            "f: landmarks.points[0] has two coordinates: these are points in an image, not in space");
        add("ljson: a label of no point", Format::Landmarker,
            R"({"version": 2, "labels": [{"label": "a", "mask": [1]}], "landmarks": {"points": [[1, 2, 3]]}})",
            "f: labels[0].mask names point 1, and there are 1, counted from 0");
        add("ljson: another document", Format::Landmarker, "{\"markups\": []}",
            "f: there are neither \"landmarks\" nor \"groups\", which hold the points of landmarker.io; is it another "
            "file?");
        add("tps: a curve with a missing point", Format::Tps, "LM=1\n1 2\nCURVES=1\nPOINTS=2\n1 1\n-1 -1\n",
            "f:6: a point of a curve is -1 -1, which means a missing one; a curve has all its points");
    }

    void badFilesAreRefusedWithTheirLine()
    {
        QFETCH(Format, format);
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        const auto read = parseLandmarks(text.toStdString(), format, "f");
        QVERIFY(!read);
        const QString said = QString::fromStdString(errorText(read.error()));
        QCOMPARE(said.left(message.size()), message);
        QVERIFY(said.size() > 10);
    }
};

UNPROJECTOR_TEST(TestForeignLandmarks)
#include "test_foreign_landmarks.moc"
