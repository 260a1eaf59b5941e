// `unproject landmarks`: from one file of landmarks to another, and tables of folders of them.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QDir>

#include <filesystem>

namespace {

const QByteArray kPicked = "<!DOCTYPE PickedPoints>\n<PickedPoints>\n"
                           " <point x=\"0.1\" y=\"-2\" z=\"3\" active=\"1\" name=\"Nasion\"/>\n"
                           " <point x=\"0\" y=\"0\" z=\"0\" active=\"0\" name=\"gone\"/>\n</PickedPoints>\n";
const QByteArray kTable = "name,x,y,z,object,face,u,v,w,note\nNasion,0.1,-2,3,,,,,,\ngone,,,,,,,,,\n";
const QByteArray kPts = "Version 1.0\n2\nNasion 0.1 -2 3\ngone 9999 9999 9999\n\n";

QByteArray bytesOf(const QString &file)
{
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray("none");
}

} // namespace

class TestLandmarksCommand : public QObject {
    Q_OBJECT

private slots:
    void aFileToAnother()
    {
        const QString input = m_folder.write("a.pp", kPicked), output = m_folder.path("a.PTS");
        VERIFY_SUCCEEDED(runCommand({"landmarks", input, output}));
        QCOMPARE(bytesOf(output), kPts);
        VERIFY_SUCCEEDED(runCommand({"landmarks", output, m_folder.path("a.csv")}));
        QCOMPARE(bytesOf(m_folder.path("a.csv")), kTable);
    }

    void throughPipes()
    {
        const Run run = runCommand({"landmarks", "--from", "pp", "--to", "pts", "-", "-"}, kPicked);
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.output, kPts);
        const Run named =
            runCommand({"landmarks", "--from", "pp", m_folder.write("points.txt", kPicked), "-", "--to", "csv"});
        VERIFY_SUCCEEDED(named);
        QCOMPARE(named.output, kTable);
    }

    void whatIsLostIsSaid()
    {
        const Run run =
            runCommand({"landmarks", "--from", "csv", "--to", "tps", "-", "-"}, "name,x,y,z,note\nN,1,2,3,worn\n");
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.output, QByteArray("LM3=1\n1 2 3\n\n"));
        QCOMPARE(run.errors, QByteArray("stdout: the names of 1 landmark are left out; only their order is kept\n"
                                        "stdout: the notes of 1 landmark are left out\n"));
    }

    /// An empty table is never an expected result.
    void aFileWithoutPoints()
    {
        const QString input = m_folder.write("none.fcsv", "# Markups fiducial file version = 4.11\n");
        const Run run = runCommand({"landmarks", input, "-", "--to", "csv"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.errors, (input + ": there are no points in the file\n").toUtf8());
    }

    void ontoAMesh()
    {
        const QString mesh = m_folder.write("roof.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 2 3\nf 1 3 4\n");
        const Run run = runCommand({"landmarks", "--from", "csv", "--to", "csv", "--mesh", mesh, "-", "-"},
                                   "name,x,y,z\non,1,1,0\nabove,1,2,0.01\ngone,,,\ncorner,-0.01,4.01,0\n");
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.errors, mesh.toUtf8() + ": 3 points moved onto the mesh, by at most 0.0141 (\"corner\")\n");
        QCOMPARE(run.output,
                 QByteArray("name,x,y,z,object,face,u,v,w,note,mesh\non,1,1,0,roof.obj,0,0.5,0.25,0.25,,roof.obj\n"
                            "above,1,2,0,roof.obj,0,0.25,0.25,0.5,,roof.obj\ngone,,,,,,,,,,roof.obj\n"
                            "corner,0,4,0,roof.obj,0,0,0,1,,roof.obj\n"));
    }

    /// The roof's two triangles unfold into a plane, where the curve is straight.
    void curvesAreLedOnTheMesh()
    {
        const QString mesh = m_folder.write("roof.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 2 3\nf 1 3 4\n");
        const QByteArray points = "name,x,y,z,curve,curvePoints,curveKind,curveCount\nA,1,1,0,,,,\nB,0,1,1,,,,\n";
        const auto led = [&](const QByteArray &row) {
            return runCommand({"landmarks", "--from", "csv", "--to", "csv", "--mesh", mesh, "-", "-"}, points + row);
        };
        const Run run = led(",,,,rim,\"[\"\"A\"\",\"\"B\"\"]\",geodesic,3\n");
        QCOMPARE(run.exitCode, 0);
        QList<QList<double>> places;
        for (const QByteArray &line : run.lines()) {
            const QList<QByteArray> cells = line.split(',');
            if (line.contains("rim"))
                places << QList<double>{cells[1].toDouble(), cells[2].toDouble(), cells[3].toDouble()};
        }
        QCOMPARE(places, QList<QList<double>>({{0, 1, 0}})); // its ends are the landmarks
        const Run unknown = led(",7,7,7,rim,\"[\"\"A\"\",\"\"Z\"\"]\",geodesic,2\n,7,7,7,rim,,,\n");
        QVERIFY2(unknown.errors.contains("the curve \"rim\" has no semilandmarks: some of its landmarks are missing"),
                 unknown.errors);
        QVERIFY(!unknown.output.contains("7,7,7"));
        const Run given = led(",7,7,7,rim,,,\n,8,8,8,rim,,,\n");
        QVERIFY2(given.errors.contains("the curve \"rim\" is not moved"), given.errors);
    }

    /// A point in RAS on a mesh in LPS, say.
    void ontoAMeshOfOthers()
    {
        const QString mesh = m_folder.write("face.obj", "v 1 1 0\nv 4 1 0\nv 1 5 0\nf 1 2 3\n");
        const Run run = runCommand({"landmarks", "--from", "csv", "--to", "pts", "--mesh", mesh, "-", "-"},
                                   "name,x,y,z\n,-2,1,0\nN,2,1,0.04\n");
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(
            run.errors.startsWith(mesh.toUtf8()
                                  + ": point 1 was 3 from the mesh, 60 % of its size; do the points belong to another "
                                    "mesh, or use other axes?\n"
                                  + mesh.toUtf8() + ": 2 points moved onto the mesh, by at most 3 (point 1)\n"),
            run.errors.constData());
        QVERIFY(run.output.contains("\nN 2 1 0\n"));
        const Run beyond = runCommand({"landmarks", "--from", "csv", "--to", "pts", "--mesh", mesh, "-", "-"},
                                      "name,x,y,z\nN,1e160,1,0\nP,2,1,0\n");
        QCOMPARE(beyond.exitCode, 0);
        QVERIFY2(beyond.errors.startsWith(
                     mesh.toUtf8() + ": \"N\" is not moved: its distance from the mesh is not a finite number\n"),
                 beyond.errors.constData());
        QVERIFY(beyond.output.contains("\nN 1e+160 1 0\n"));
        const Run none =
            runCommand({"landmarks", "--from", "csv", "--to", "csv", "--mesh", m_folder.path("none.obj"), "-", "-"},
                       "x,y,z\n1,2,3\n");
        QCOMPARE(none.exitCode, 2);
        QVERIFY(none.errors.contains("none.obj"));
    }

    void slidersOfSemilandmarks()
    {
        const QByteArray
            rows = "A,0,0,0,,,,\nB,3,0,0,,,,\nc:02,1,0,0,c,\"[\"\"A\"\",\"\"B\"\"]\",geodesic,4\nc:03,2,0,0,c,,,\n",
            table = "name,x,y,z,curve,curvePoints,curveKind,curveCount\n" + rows;
        const QString input = m_folder.write("curve.csv", table), sliders = m_folder.path("curve.sliders.csv");
        const Run run = runCommand({"landmarks", input, m_folder.path("curve.tps"), "--sliders", sliders});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.errors.endsWith(sliders.toUtf8() + ": 2 sliders, for geomorph's gpagen(curves=)\n"), run.errors);
        QCOMPARE(bytesOf(sliders), QByteArray("before,slide,after\n1,3,4\n3,4,2\n"));
        QCOMPARE(bytesOf(m_folder.path("curve.tps")),
                 QByteArray("LM3=2\n0 0 0\n3 0 0\nCURVES=1\nPOINTS=2\n1 0 0\n2 0 0\n\n"));

        // The wide table's columns have the landmarks of all files, then their semilandmarks.
        QVERIFY(QDir(m_folder.path(".")).mkdir("skulls"));
        m_folder.write("skulls/a.csv", table);
        m_folder.write("skulls/b.csv", "name,x,y,z\nC,7,7,7\nB,1,1,1\n");
        m_folder.write("skulls/old.sliders.csv", "before,slide,after\n1,2,3\n"); // no landmarks, and no error
        const auto made = [&](const char *format) {
            return runCommand({"landmarks", "--table", m_folder.path("skulls"), "-o", m_folder.path("all.csv"),
                               "--format", format, "--sliders", sliders});
        };
        QCOMPARE(made("wide").exitCode, 0);
        QVERIFY(bytesOf(m_folder.path("all.csv")).startsWith("specimen,A_x,A_y,A_z,B_x,B_y,B_z,C_x,C_y,C_z,c:02_x,"));
        QCOMPARE(bytesOf(sliders), QByteArray("before,slide,after\n1,4,5\n4,5,2\n"));

        // What has no sliders is reported.
        const Run none = runCommand({"landmarks", "--from", "csv", "--to", "tps", "-", "-", "--sliders", sliders},
                                    "name,x,y,z\nA,1,2,3\n");
        QCOMPARE(none.exitCode, 1);
        QVERIFY2(none.errors.endsWith("it is not written, because no curve has semilandmarks\n"), none.errors);
        const Run json = runCommand({"landmarks", input, m_folder.path("c.mrk.json"), "--sliders", sliders});
        QCOMPARE(json.exitCode, 2);
        QVERIFY2(json.errors.contains(".mrk.json has no numbers for semilandmarks; write .csv, .tps or .nts"),
                 json.errors);
        const Run over = runCommand({"landmarks", input, m_folder.path("c.tps"), "--sliders", input});
        QCOMPARE(over.exitCode, 2);
        QCOMPARE(bytesOf(input), table);
    }

    /// A hundred files, one of them broken.
    void aFolderToATable()
    {
        QVERIFY(QDir().mkpath(m_folder.path("many")));
        for (int i = 0; i < 100; ++i) {
            const QString name = QString("many/skull%1").arg(i, 2, 10, QLatin1Char('0'));
            if (i == 42)
                m_folder.write(name + ".pts", "Version 1.0\n2\nNasion 1 2\n");
            else if (i % 3 == 0)
                m_folder.write(name + ".pp", kPicked);
            else if (i % 3 == 1)
                m_folder.write(name + ".pts", kPts);
            else
                m_folder.write(name + ".mrk.json",
                               R"({"markups": [{"controlPoints": [{"label": "Nasion", "position": [0.1, -2, 3]},
                           {"label": "gone", "positionStatus": "undefined"}]}]})");
        }
        m_folder.write("many/readme.txt", "no landmarks");
        m_folder.write("many/scene.json", "{\"unprojector\": 1}");
        const QString output = m_folder.path("many/all.csv");
        for (int time = 0; time < 2;
             ++time) { // the table lies in the folder itself: the second time it is not one of the files
            const Run run = runCommand({"landmarks", "--table", m_folder.path("many"), "-o", output});
            QCOMPARE(run.exitCode, 1);
            QCOMPARE(run.errors,
                     m_folder.path("many/skull42.pts").toUtf8()
                         + ":3: \"Nasion 1 2\" is not a point; write its name, x, y and z\n" + output.toUtf8()
                         + ": 99 landmarks have no coordinates (not placed: 99, skipped: 0, missing on their "
                           "specimens: 0)\n");
            const QList<QByteArray> lines = bytesOf(output).trimmed().split('\n');
            QCOMPARE(lines.size(), 1 + 2 * 99);
            QCOMPARE(lines[0], QByteArray("specimen,name,x,y,z,object,face,u,v,w,note"));
            for (int i = 0, row = 1; i < 100; ++i) {
                if (i == 42)
                    continue;
                const QByteArray name = "skull" + QByteArray::number(i).rightJustified(2, '0');
                QCOMPARE(lines[row++], name + ",Nasion,0.1,-2,3,,,,,,");
                QCOMPARE(lines[row++], name + ",gone,NA,NA,NA,,,,,,");
            }
        }
    }

    void tablesOfAllKinds()
    {
        QVERIFY(QDir().mkpath(m_folder.path("two")));
        m_folder.write("two/a.pp", kPicked);
        m_folder.write("two/A.MRK.JSON",
                       "{\"markups\": [{\"controlPoints\": [{\"label\": \"Nasion\", \"position\": [1, 1, "
                       "1]}, {\"label\": \"gone\"}]}]}");
        m_folder.write("two/other.json", "{}");
        m_folder.write("two/b.tps", "LM3=2\n1 2 3\n4 5 6\nID=late\n\nLM3=2\n7 8 9\n10 11 12\n");
        const auto table = [&](const char *format) {
            return runCommand({"landmarks", "--table", m_folder.path("two"), "-o", "-", "--format", format});
        };
        const Run wide = table("wide");
        QCOMPARE(wide.exitCode, 0);
        QCOMPARE(wide.errors,
                 QByteArray("stdout: 10 landmarks have no coordinates (not placed: 10, skipped: 0, missing on "
                            "their specimens: 0)\n"));
        QCOMPARE(wide.output,
                 QByteArray("specimen,Nasion_x,Nasion_y,Nasion_z,gone_x,gone_y,gone_z,1_x,1_y,1_z,2_x,2_y,2_z\n"
                            "A,1,1,1,NA,NA,NA,NA,NA,NA,NA,NA,NA\na,0.1,-2,3,NA,NA,NA,NA,NA,NA,NA,NA,NA\n"
                            "late,NA,NA,NA,NA,NA,NA,1,2,3,4,5,6\nb_2,NA,NA,NA,NA,NA,NA,7,8,9,10,11,12\n"));
        // Landmarks without names are no named ones.
        const QByteArray none = "NA NA NA\n";
        QCOMPARE(table("tps").output, "LM3=4\n1 1 1\n" + none + none + none + "ID=A\n\nLM3=4\n0.1 -2 3\n" + none + none
                                          + none + "ID=a\n\nLM3=4\n" + none + none + "1 2 3\n4 5 6\nID=late\n\nLM3=4\n"
                                          + none + none + "7 8 9\n10 11 12\nID=b_2\n\n");
        QCOMPARE(
            table("nts").output,
            QByteArray("1 4L 12 1 9999 DIM=3\nA\na\nlate\nb_2\n1 1 1 9999 9999 9999 9999 9999 9999 9999 9999 9999\n"
                       "0.1 -2 3 9999 9999 9999 9999 9999 9999 9999 9999 9999\n"
                       "9999 9999 9999 9999 9999 9999 1 2 3 4 5 6\n9999 9999 9999 9999 9999 9999 7 8 9 10 11 12\n"));
    }

    /// A data set whose file is not there is no smaller data set.
    void aLinkToNothingIsReported()
    {
        QVERIFY(QDir().mkpath(m_folder.path("links")));
        m_folder.write("links/a.csv", kTable);
        std::error_code error;
        std::filesystem::create_symlink("gone.csv",
                                        std::filesystem::path(m_folder.path("links/b.csv").toStdU16String()), error);
        if (error)
            QSKIP("this system lets the test make no links");
        const Run run = runCommand({"landmarks", "--table", m_folder.path("links"), "-o", "-", "--format", "wide"});
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.errors.startsWith(m_folder.path("links/b.csv").toUtf8() + ": "), run.errors.constData());
    }

    /// a.pp beside a.pts, and a file whose specimens have one name: each is a specimen of its own.
    void specimensOfOneName()
    {
        QVERIFY(QDir().mkpath(m_folder.path("same")));
        m_folder.write("same/a.pts", kPts);
        m_folder.write("same/a.csv", kTable);
        const Run table = runCommand({"landmarks", "--table", m_folder.path("same"), "-o", "-", "--format", "wide"});
        QCOMPARE(table.exitCode, 0);
        QCOMPARE(table.output,
                 QByteArray("specimen,Nasion_x,Nasion_y,Nasion_z,gone_x,gone_y,gone_z\na,0.1,-2,3,NA,NA,NA\n"
                            "a (a.pts),0.1,-2,3,NA,NA,NA\n"));
        const Run csv = runCommand({"landmarks", "--from", "tps", "--to", "csv", "-", "-"},
                                   "LM3=1\n1 2 3\nLM3=1\n4 5 6\nID=2\nLM3=0\n");
        QCOMPARE(csv.exitCode, 0);
        QCOMPARE(csv.output,
                 QByteArray("specimen,name,x,y,z,object,face,u,v,w,note\n1,,1,2,3,,,,,,\n2,,4,5,6,,,,,,\n"));
        QCOMPARE(csv.errors, QByteArray("stdout: the name \"\" as \"1\"\nstdout: the name \"\" as \"3\"\n"
                                        "stdout: the specimen \"3\" has no points and is left out\n"));
    }

    /// s2 has the landmarks in another order, s3 lacks one and has a further one.
    void namesAlignEveryTable()
    {
        QVERIFY(QDir().mkpath(m_folder.path("orders")));
        m_folder.write("orders/s1.csv", "name,x,y,z\na,1,0,0\nb,2,0,0\nc,3,0,0\n");
        m_folder.write("orders/s2.csv", "name,x,y,z\nc,6,0,0\na,4,0,0\nb,5,0,0\n");
        m_folder.write("orders/s3.csv", "name,x,y,z\na,7,0,0\nd,8,0,0\n");
        const auto table = [&](const char *format) {
            const Run run =
                runCommand({"landmarks", "--table", m_folder.path("orders"), "-o", "-", "--format", format});
            return run.exitCode == 0 ? run.output : run.errors;
        };
        QCOMPARE(table("tps"), QByteArray("LM3=4\n1 0 0\n2 0 0\n3 0 0\nNA NA NA\nID=s1\n\nLM3=4\n4 0 0\n5 0 0\n6 0 0\n"
                                          "NA NA NA\nID=s2\n\nLM3=4\n7 0 0\nNA NA NA\nNA NA NA\n8 0 0\nID=s3\n\n"));
        QVERIFY2(
            table("nts").endsWith("\n4 0 0 5 0 0 6 0 0 9999 9999 9999\n7 0 0 9999 9999 9999 9999 9999 9999 8 0 0\n"),
            table("nts"));
        QVERIFY2(table("wide").contains("\ns3,7,0,0,NA,NA,NA,NA,NA,NA,8,0,0\n"), table("wide"));
        QVERIFY2(table("long").contains("\ns3,b,NA,NA,NA,"), table("long"));
    }

    void aSecondPlacingIsNoSpecimen()
    {
        QVERIFY(QDir().mkpath(m_folder.path("placed")));
        m_folder.write("placed/s01.obj.points.csv", "name,x,y,z\na,1,0,0\n");
        m_folder.write("placed/s01.obj.points-2.csv", "name,x,y,z\na,2,0,0\n");
        m_folder.write("placed/s01.ply.points-2.csv", "name,x,y,z\na,3,0,0\n"); // another scan of that name
        m_folder.write("placed/s02.obj.points-3.csv", "name,x,y,z\na,4,0,0\n");
        const auto table = [&](const char *format) {
            return runCommand({"landmarks", "--table", m_folder.path("placed"), "-o", "-", "--format", format});
        };
        QCOMPARE(table("wide").output, QByteArray("specimen,placing,a_x,a_y,a_z\ns01,1,1,0,0\ns01,2,2,0,0\n"
                                                  "s01 (s01.ply),2,3,0,0\ns02,3,4,0,0\n"));
        QVERIFY2(table("long").output.startsWith("specimen,placing,name,x,y,z,object,face,u,v,w,note\ns01,1,a,1,0,0,"),
                 table("long").output);
        const Run tps = table("tps");
        QCOMPARE(tps.output.count("LM3="), 3);
        QVERIFY2(tps.errors.contains("1 repeated placing is left out: the format would have it as one more specimen"),
                 tps.errors);
    }

    /// The rows of the specimens are in other orders, and TPS knows no names.
    void aTableOfSpecimensToTps()
    {
        const Run run = runCommand({"landmarks", "--from", "csv", "--to", "tps", "-", "-"},
                                   "specimen,name,x,y,z\ns,a,1,0,0\ns,b,2,0,0\nt,b,4,0,0\nt,a,3,0,0\n");
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.output, QByteArray("LM3=2\n1 0 0\n2 0 0\nID=s\n\nLM3=2\n3 0 0\n4 0 0\nID=t\n\n"));
    }

    /// Two scans are squares of another size; the way along the surface is found on each one's own mesh.
    void aProtocol()
    {
        QVERIFY(QDir().mkpath(m_folder.path("measured")));
        const auto square = [](const QByteArray &size) {
            return "v 0 0 0\nv " + size + " 0 0\nv " + size + " " + size + " 0\nv 0 " + size + " 0\nf 1 2 3 4\n";
        };
        m_folder.write("measured/s1.obj", square("3"));
        m_folder.write("measured/s2.obj", square("6"));
        m_folder.write("measured/s1.obj.points.csv", "name,x,y,z\na,0,0,0\nb,3,0,0\nc,3,3,0\n");
        m_folder.write("measured/s2.obj.points.csv", "name,x,y,z\nb,6,0,0\na,0,0,0\nc,,,\n");
        m_folder.write("measured/alone.csv", "name,x,y,z\na,0,0,0\nb,0,0,1\nc,0,1,0\n");
        const QString protocol = m_folder.write("measured/my.measures.csv", "name,kind,landmarks\nwidth,distance,a,b\n"
                                                                            "corner,angle,a,b,c\nway,surface,a,c\n");
        const auto table = [&](const char *format) {
            return runCommand({"landmarks", "--table", m_folder.path("measured"), "--measures", protocol, "-o", "-",
                               "--format", format});
        };
        const Run wide = table("wide");
        QCOMPARE(wide.exitCode, 0);
        const QList<QByteArray> lines = wide.lines();
        QCOMPARE(lines.size(), 4);
        QVERIFY2(lines[0].endsWith(",c_z,width,width_error,corner,corner_error,way,way_error,measures_note"), lines[0]);
        QVERIFY2(lines[1].endsWith(",1,NA,45,NA,NA,NA,way: there is no model beside alone.csv"), lines[1]);
        QVERIFY2(lines[2].endsWith(",3,NA,90,NA,4.242640687119285,NA,"), lines[2]);
        QVERIFY2(lines[3].endsWith(
                     ",6,NA,NA,NA,NA,NA,\"corner: \"\"c\"\" has no position yet; way: \"\"c\"\" has no position yet\""),
                 lines[3]);
        QVERIFY2(
            wide.errors.contains("stdout: the measure \"way\" is NA for 2 of 3 specimens; the column measures_note has "
                                 "the reasons\n"),
            wide.errors);
        QVERIFY2(table("long").output.contains("s2,a,0,0,0,,,,,,,6,NA,NA,NA,NA,NA,"), table("long").output);
        QVERIFY2(table("tps").errors.contains("3 measures of the protocol are left out"), table("tps").errors);
    }

    void repeatsOfAFolder()
    {
        QVERIFY(QDir().mkpath(m_folder.path("twice")));
        m_folder.write("twice/s1.obj.points.csv", "name,x,y,z\na,0,0,0\nb,9,0,0\nc,0,9,0\n");
        m_folder.write("twice/s1.obj.points-2.csv", "name,x,y,z\nb,9,0,0\nc,0,9,0\na,2,0,0\n");
        m_folder.write("twice/s2.obj.points.csv", "name,x,y,z\na,1,0,0\nb,8,0,0\nc,0,7,0\n");
        m_folder.write("twice/s2.obj.points-2.csv", "name,x,y,z\na,1,0,0\nb,8,0,0\nc,0,7,0\n");
        const QString errors = m_folder.path("twice/errors.csv");
        for (int time = 0; time < 2; ++time) { // the second time, the table lies in the folder
            const Run run = runCommand({"landmarks", "--repeats", m_folder.path("twice"), "--errors", errors});
            VERIFY_SUCCEEDED(run);
            const QByteArray table = bytesOf(errors);
            QVERIFY2(
                table.startsWith("landmark,specimens,placings,error,icc1,icc2,error_1,bias_1,error_2,bias_2\na,2,4,1,"),
                table);
            QVERIFY2(table.contains("\n(all),2,4,0.57735026918962"), table);
        }
        // The files one by one are the same specimens.
        const Run files =
            runCommand({"landmarks", "--repeats", m_folder.path("twice/s1.obj.points.csv"),
                        m_folder.path("twice/s1.obj.points-2.csv"), m_folder.path("twice/s2.obj.points.csv"),
                        m_folder.path("twice/s2.obj.points-2.csv"), "-o", "-"});
        VERIFY_SUCCEEDED(files);
        QVERIFY2(files.output.contains("\ns1,a,2,1,0,0,1.414213562373095")
                     && files.output.contains("\ns2,a,2,1,0,0,0,0\n"),
                 files.output);
        // So is one table of all placings.
        QVERIFY(QFile::remove(errors));
        const QString table = m_folder.path("placings.csv");
        VERIFY_SUCCEEDED(runCommand({"landmarks", "--table", m_folder.path("twice"), "-o", table}));
        const Run again = runCommand({"landmarks", "--repeats", table, "-o", "-"});
        VERIFY_SUCCEEDED(again);
        QCOMPARE(again.output, files.output);
    }

    void repeatedPlacings()
    {
        const QString first = m_folder.write("skull.csv", "name,x,y,z\nN,1,2,3\nonce,5,5,5\nnever,,,\n");
        const QString second = m_folder.write("again.pts", "Version 1.0\n2\nnever 9999 9999 9999\nN 3 2 3\n");
        const Run run = runCommand({"landmarks", "--repeats", first, second, "-o", "-"});
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.output, QByteArray("specimen,name,placings,x,y,z,error,farthest\n"
                                        "skull,N,2,2,2,3,1.4142135623730951,1\n"
                                        "skull,once,1,5,5,5,,0\nskull,never,0,,,,,\n"));
        const QString table = m_folder.path("error.csv");
        const Run same = runCommand({"landmarks", "-o", table, "--repeats", first, second, first});
        QCOMPARE(same.exitCode, 0);
        QCOMPARE(same.errors,
                 (first + ": this is " + first + " again; the placing counts twice, so the scatter is too small\n")
                     .toUtf8());
        QVERIFY(bytesOf(table).contains("\nskull,N,3,1.6666666666666665,2,3,"));
    }

    void repeatsInOtherUnits()
    {
        const QString mm = m_folder.write("mm.csv", "name,x,y,z,unit\nN,10,20,30,mm\n"),
                      cm = m_folder.write("cm.csv", "name,x,y,z,unit\nN,1,2,3,cm\n"),
                      none = m_folder.write("none.csv", "name,x,y,z\nN,10,20,30\n");
        const Run run = runCommand({"landmarks", "--repeats", none, mm, cm, "-o", "-"});
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.errors,
                 ("stdout: " + mm + " is in mm and " + cm + " in cm; write both in the same unit first\n").toUtf8());
        QCOMPARE(run.output, QByteArray());
        const Run noted = runCommand({"landmarks", "--repeats", none, mm, mm, "-o", "-"});
        QCOMPARE(noted.exitCode, 0);
        QVERIFY2(noted.errors.contains(("stdout: " + mm + " is in mm, and " + none
                                        + " does not say its unit; its coordinates are read in that unit\n")
                                           .toUtf8()),
                 noted.errors.constData());
        QVERIFY(noted.output.contains("none,N,3,10,20,30,0,0\n"));
    }

    void repeatedSpecimens()
    {
        const QString first = m_folder.write("first.tps", "LM3=1\n1 2 3\nID=b\n\nLM3=1\n1 1 1\nID=a\n");
        const QString second =
            m_folder.write("second.tps", "LM3=1\n1 1 3\nID=a\n\nLM3=1\n1 2 3\nID=b\n\nLM3=1\n0 0 0\nID=c\n");
        const Run run = runCommand({"landmarks", "--repeats", first, second, "-o", "-"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.output, QByteArray("specimen,name,placings,x,y,z,error,farthest\nb,1,2,1,2,3,0,0\n"
                                        "a,1,2,1,1,2,1.4142135623730951,1\nc,1,1,0,0,0,,0\n"));
        QCOMPARE(run.errors,
                 QByteArray("the specimen \"c\" was placed only once: there is nothing to compare it with\n"));
    }

    /// All that a folder's commands make may lie in it.
    void resultsAreNoSpecimens()
    {
        QVERIFY(QDir().mkpath(m_folder.path("kept")));
        m_folder.write("kept/s1.ply.points.csv", "name,x,y,z\na,0,0,0\nb,9,0,0\nc,0,9,0\n");
        m_folder.write("kept/s1.ply.points-2.csv", "name,x,y,z\na,2,0,0\nb,9,0,0\nc,0,9,0\n");
        m_folder.write("kept/s2.ply.points.csv", "name,x,y,z\na,1,0,0\nb,8,0,0\nc,0,7,0\n");
        const QString folder = m_folder.path("kept");
        const Run first = runCommand({"landmarks", "--table", folder, "-o", "-", "--format", "wide"});
        QCOMPARE(first.exitCode, 0);
        for (const char *name : {"all.tps", "all.nts", "long.csv"})
            QCOMPARE(runCommand({"landmarks", "--table", folder, "-o", folder + '/' + name}).exitCode, 0);
        QCOMPARE(runCommand({"landmarks", "--table", folder, "-o", folder + "/wide.csv", "--format", "wide"}).exitCode,
                 0);
        QCOMPARE(runCommand({"landmarks", "--repeats", folder, "-o", folder + "/r.csv", "--errors", folder + "/e.csv"})
                     .exitCode,
                 0);
        m_folder.write("kept/sheet.csv",
                       "\xef\xbb\xbf\"specimen\";placing;\"a b_x\";\"a b_y\";\"a b_z\"\r\ns1;1;1,5;2;3\r\n");
        const Run again = runCommand({"landmarks", "--table", folder, "-o", "-", "--format", "wide"});
        QVERIFY2(again.exitCode == 0, again.errors);
        QCOMPARE(again.output, first.output);
        for (const char *name : {"wide.csv", "r.csv", "e.csv", "sheet.csv"})
            QVERIFY2(
                again.errors.contains((folder + '/' + name).toUtf8()
                                      + ": this is a table that this program made of other files; it is left out\n"),
                again.errors);
        for (const char *name : {"all.tps", "all.nts", "long.csv"})
            QVERIFY2(again.errors.contains(
                         (folder + '/' + name).toUtf8()
                         + ": it has several specimens, and other files lie beside their scans; it is left out\n"),
                     again.errors);
    }

    void theSuffixDecides()
    {
        QVERIFY(QDir().mkpath(m_folder.path("suffixes")));
        m_folder.write("suffixes/s1.csv", "name,x,y,z\na,1,2,3\n");
        m_folder.write("suffixes/s2.csv", "name,x,y,z\na,4,5,6\n");
        const QString folder = m_folder.path("suffixes");
        const auto made = [&](const QString &name, const QStringList &more = {}) {
            const Run run = runCommand(QStringList{"landmarks", "--table", folder, "-o", m_folder.path(name)} + more);
            return run.exitCode == 0 ? bytesOf(m_folder.path(name)) : run.errors;
        };
        QVERIFY2(made("t.tps").startsWith("LM3=1\n1 2 3\n"), made("t.tps"));
        QVERIFY2(made("t.nts").startsWith("1 2L 3 0 DIM=3\n"), made("t.nts"));
        QVERIFY2(made("t.dta").startsWith("1 2L 3 0 DIM=3\n"), made("t.dta"));
        QVERIFY2(made("t.csv").startsWith("specimen,name,x"), made("t.csv"));
        QVERIFY2(made("t.txt", {"--format", "tps"}).startsWith("LM3=1\n"), made("t.txt"));
        for (const auto &[name, form] :
             {std::pair("u.tps", "wide"), std::pair("u.csv", "nts"), std::pair("u.pp", "long")})
            QVERIFY2(made(name, {"--format", form}).contains("; give it a name that ends so, or another format\n"),
                     made(name));
        QVERIFY2(made("s1.PLY").contains(": this is the name of a model, not of a table"), made("s1.PLY"));
        for (const char *name : {"series-template.csv", "series.measures.csv"})
            QVERIFY2(made(name).contains(": this name is kept for the template and the measures of a series"),
                     made(name));
        const auto repeated = [&](const QStringList &more) {
            return runCommand(QStringList{"landmarks", "--repeats", folder + "/s1.csv", folder + "/s2.csv"} + more);
        };
        for (const QStringList &more : {QStringList{"-o", "r.tps"}, QStringList{"--errors", "r.stl"}})
            QCOMPARE(repeated(more).exitCode, 2);
        // Two results in one file would be one.
        const QString both = m_folder.path("both.csv");
        for (const QStringList &more : {QStringList{"-o", both, "--errors", both},
                                        QStringList{"-o", both, "--errors", m_folder.path("./both.csv")},
                                        QStringList{"-o", "-", "--errors", "-"}}) {
            const Run run = repeated(more);
            QCOMPARE(run.exitCode, 2);
            QVERIFY2(run.errors.contains(": two results cannot go to one file"), run.errors);
            QCOMPARE(run.output, QByteArray());
            QVERIFY(!QFile::exists(both));
        }
        QVERIFY2(made("both.csv", {"--sliders", both}).contains("two results cannot go to one file"), "sliders");
    }

    void namesThatAreNotClear()
    {
        QVERIFY(QDir().mkpath(m_folder.path("names")));
        m_folder.write("names/s1.csv", "name,x,y,z\na,1,0,0\nb,2,0,0\n");
        m_folder.write("names/s2.csv", "name,x,y,z\nA,3,0,0\nb,4,0,0\n");
        m_folder.write("names/s4.csv", "name,x,y,z\na,5,0,0\nA,6,0,0\nb,7,0,0\nb,8,0,0\n");
        const QString protocol = m_folder.write("names.measures.csv", "name,kind,landmarks\nd,distance,a,b\n");
        const Run run = runCommand(
            {"landmarks", "--table", m_folder.path("names"), "-o", "-", "--format", "wide", "--measures", protocol});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(
            run.errors.contains("stdout: \"s4\" has both \"a\" and \"A\", so they are two landmarks in all specimens; "
                                "rename one if they are the same\n"),
            run.errors);
        QVERIFY2(run.errors.contains("stdout: \"s4\" has several landmarks named \"b\"; the table numbers them\n"),
                 run.errors);
        QVERIFY2(run.output.contains(",NA,NA,\"d: several landmarks have the name \"\"b\"\"\"\n"), run.output);
        const auto named = [&](const char *name) {
            const QString file = m_folder.write("equal.measures.csv", "name,kind,landmarks\nd,distance,a,a\n"
                                                                          + QByteArray(name) + ",distance,a,a\n");
            return runCommand(
                {"landmarks", "--table", m_folder.path("names"), "-o", "-", "--format", "wide", "--measures", file});
        };
        for (const char *name : {"a_x", "specimen", "d_error", "measures_note"}) {
            QCOMPARE(named(name).exitCode, 2);
            QVERIFY2(named(name).errors.contains("and there is another one of that name; rename the measure\n"),
                     named(name).errors);
        }
        QCOMPARE(named("e").exitCode, 0);
        // Repeats go by names too.
        const QString s1 = m_folder.path("names/s1.csv"), s4 = m_folder.path("names/s4.csv");
        const Run repeats = runCommand({"landmarks", "--repeats", s1, s4, "-o", "-"});
        QCOMPARE(repeats.exitCode, 0);
        QVERIFY2(repeats.errors.contains(("stdout: " + s4 + " has both \"a\" and \"A\", so they are").toUtf8()),
                 repeats.errors);
        QVERIFY2(repeats.errors.contains(("stdout: " + s4 + " has several landmarks named \"b\"; the table").toUtf8()),
                 repeats.errors);
    }

    void twoFilesOfOnePlacing()
    {
        QVERIFY(QDir().mkpath(m_folder.path("double")));
        for (const char *name : {"s1.ply.points-02", "s1.ply.points-2", "s2.ply.points", "s2.ply.points-1"})
            m_folder.write(QStringLiteral("double/%1.csv").arg(name), "name,x,y,z\na,1,0,0\n");
        const Run run = runCommand({"landmarks", "--table", m_folder.path("double"), "-o", "-"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.errors.count("; it counts as another specimen\n"), 2);
        QVERIFY2(run.errors.contains("this is placing 2 of s1.ply, as s1.ply.points-"), run.errors);
        QVERIFY2(run.errors.contains("this is placing 1 of s2.ply, as s2.ply.points"), run.errors);
    }

    void tablesHaveOneUnit()
    {
        QVERIFY(QDir().mkpath(m_folder.path("units")));
        m_folder.write("units/s1.csv", "name,x,y,z,unit\na,1,2,3,mm\n");
        m_folder.write("units/s2.csv", "name,x,y,z,unit\na,1,2,3,cm\n");
        m_folder.write("units/s3.csv", "name,x,y,z\na,1,2,3\n");
        const auto table = [&](const char *format) {
            return runCommand({"landmarks", "--table", m_folder.path("units"), "-o", "-", "--format", format});
        };
        QCOMPARE(table("long").exitCode, 0); // it has a column for units
        for (const char *format : {"wide", "tps", "nts"}) {
            QCOMPARE(table(format).exitCode, 2);
            QVERIFY2(
                table(format).errors.contains("\"s1\" is in mm and \"s2\" in cm; write both in the same unit first"),
                table(format).errors);
        }
        QVERIFY(QFile::remove(m_folder.path("units/s2.csv")));
        QCOMPARE(table("wide").exitCode, 0);
        QVERIFY2(table("wide").errors.contains("\"s1\" is in mm, and \"s3\" does not say its unit"),
                 table("wide").errors);
    }

    void formulasOfASpreadsheet()
    {
        const QByteArray table("name,x,y,z,object,face,u,v,w,note\n=A1,1,2,3,,,,,,@b\n");
        const QString file = m_folder.write("=A1.csv", table), safe = m_folder.path("safe.csv");
        VERIFY_SUCCEEDED(runCommand({"landmarks", "--spreadsheet-safe", file, safe}));
        QCOMPARE(bytesOf(safe), QByteArray(table).replace("=A1", "'=A1").replace("@b", "'@b"));
        VERIFY_SUCCEEDED(runCommand({"landmarks", safe, m_folder.path("back.csv")}));
        QCOMPARE(bytesOf(m_folder.path("back.csv")), table);
        const Run repeats = runCommand({"landmarks", "--spreadsheet-safe", "--repeats", file, safe, "-o", "-"});
        QVERIFY2(repeats.output.contains("'=A1,'=A1,2,1,2,3,0,0"), repeats.output);
    }

    void refused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("message");
        const QString input = m_folder.write("in.pp", kPicked);
        QTest::newRow("nothing") << QStringList() << "IN (or --table) is required";
        QTest::newRow("no output") << QStringList{input} << "OUT (or --table) is required";
        QTest::newRow("a table to nowhere") << QStringList{"--table", m_folder.path(".")} << "-o,--output is required";
        QTest::newRow("a pipe that says nothing")
            << QStringList{"-", "a.csv"} << "stdin: the name does not tell the format; give --from";
        QTest::newRow("another suffix") << QStringList{input, m_folder.path("a.xyz")}
                                        << "a.xyz: the name does not tell the format; give --to";
        QTest::newRow("another format") << QStringList{"--to", "xyz", input, "-"}
                                        << "\"xyz\" is not one of csv, pp, pptpl";
        QTest::newRow("over itself") << QStringList{input, input} << "in.pp";
        QTest::newRow("no file") << QStringList{m_folder.path("none.pp"), "-", "--to", "csv"} << "none.pp";
        QTest::newRow("no folder") << QStringList{"--table", m_folder.path("none"), "-o", "-"}
                                   << "none: the folder cannot be read: ";
        QVERIFY(QDir().mkpath(m_folder.path("empty")));
        QTest::newRow("one placing") << QStringList{"--repeats", input, "-o", "-"}
                                     << "no specimen was placed more than once";
        QTest::newRow("measures of no table") << QStringList{"--measures", input, input, "-"} << "--measures";
        QTest::newRow("errors of no repeats") << QStringList{"--errors", input, input, "-"} << "--errors";
        QTest::newRow("no list of measures")
            << QStringList{"--table", m_folder.path("."), "--measures", input, "-o", "-"}
            << "this is no list of measures";
        QTest::newRow("repeats to nowhere") << QStringList{"--repeats", input, input} << "-o,--output is required";
        QTest::newRow("repeats and a file") << QStringList{"--repeats", input, input, "--to", "csv", "-o", "-"}
                                            << "exclude each other; leave one of them out";
        QTest::newRow("repeats over a placing") << QStringList{"--repeats", input, input, "-o", input} << "in.pp";
        QTest::newRow("an output without a table") << QStringList{input, "-", "-o", "a.csv"} << "--table or --repeats";
        QTest::newRow("an empty folder") << QStringList{"--table", m_folder.path("empty"), "-o", "-"}
                                         << "there are no files of landmarks";
    }

    void refused()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, message);
        const Run run = runCommand(QStringList{"landmarks"} + arguments);
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.errors.contains(message.toUtf8()), run.errors.constData());
        QCOMPARE(run.output, QByteArray());
        QCOMPARE(bytesOf(m_folder.path("in.pp")), kPicked);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestLandmarksCommand)
#include "test_landmarks_command.moc"
