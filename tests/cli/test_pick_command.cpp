// `unproject pick`: from positions in a picture to the hits of their rays.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace {

/// A square of side 2 in the plane z = 0; kFrustumScene doubles it and puts it to z = 3. That is 2
/// in front of the eye, 4 wide where the picture is 4 wide and 3 high.
const QByteArray kFace = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
const QStringList kColumns{"x",        "y",        "z",         "object",   "triangle", "u",        "v",
                           "w",        "object_x", "object_y",  "object_z", "normal_x", "normal_y", "normal_z",
                           "distance", "vertex",   "edge_from", "edge_to",  "dx",       "dy",       "dz"};

QList<double> numbers(const QJsonValue &array)
{
    QList<double> values;
    for (const QJsonValue value : array.toArray())
        values << value.toDouble();
    return values;
}

bool isNear(const QList<double> &a, const QList<double> &b)
{
    for (int k = 0; k < b.size(); ++k) {
        if (a.size() != b.size() || !(std::abs(a[k] - b[k]) < 1e-12))
            return false;
    }
    return true;
}

} // namespace

class TestPickCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_model = m_folder.write("face.obj", kFace);
        m_scene = m_folder.write("scene.json", kFrustumScene);
    }

    void aHitInJson()
    {
        const QJsonObject hit = pick({m_scene, "--at", "500,150"});
        QCOMPARE(hit.keys(), QStringList({"barycentric", "distance", "edge", "hit", "normal", "object", "objectPoint",
                                          "pixel", "triangle", "uncertainty", "vertex", "world"}));
        QCOMPARE(numbers(hit["pixel"]), QList<double>({500, 150}));
        QVERIFY(hit["hit"].toBool());
        QCOMPARE(hit["object"].toString(), QString("face"));
        QCOMPARE(hit["triangle"].toInt(), 1);
        // 100 pixels right of the middle and 150 above it, 200 pixels a unit.
        QVERIFY(isNear(numbers(hit["world"]), {0.5, 0.75, 3.0}));
        QVERIFY(isNear(numbers(hit["objectPoint"]), {0.25, 0.375, 0.0}));
        QVERIFY(isNear(numbers(hit["barycentric"]), {0.3125, 0.625, 0.0625}));
        QVERIFY(isNear(numbers(hit["normal"]), {0, 0, 1}));
        QVERIFY(std::abs(hit["distance"].toDouble() - std::sqrt(0.25 + 0.5625 + 4.0)) < 1e-14);
        QCOMPARE(hit["vertex"]["id"].toInt(), 2);
        QCOMPARE(numbers(hit["vertex"]["world"]), QList<double>({2, 2, 3}));
        QCOMPARE(numbers(hit["edge"]["ids"]), QList<double>({0, 2}));
        QVERIFY(isNear(numbers(hit["edge"]["world"]), {0.625, 0.625, 3.0}));
        for (const double uncertainty : numbers(hit["uncertainty"]))
            QVERIFY(uncertainty > 0.0 && uncertainty < 1e-6);
    }

    void positionsAnswerInTheirOrder()
    {
        const Run run = runCommand({"pick", "--json", m_scene, "--at", "400,300", "--at", "799.5,599.5", "--at=-1,2"});
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), 3);
        QVERIFY(run.lines()[0].startsWith("{\"pixel\": [400, 300], \"hit\": true, \"object\": \"face\""));
        QVERIFY(run.lines()[1].startsWith("{\"pixel\": [799.5, 599.5], \"hit\": true"));
        QCOMPARE(run.lines()[2], QByteArray("{\"pixel\": [-1, 2], \"hit\": false}"));
        QVERIFY(run.errors.contains("--at -1,2: lies outside the viewport of the view of 800x600"));
    }

    void pixelsOutsideThePictureAreCounted()
    {
        const Run run = runCommand({"pick", m_scene, "-"}, "px,py\n400,300\n900,1\n-1,2\n");
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), 4);
        QVERIFY2(run.errors.contains("2 pixels lie outside the viewport of the view of 800x600"), run.errors);
        const Run inside = runCommand({"pick", m_scene, "-"}, "px,py\n400,300\n");
        QVERIFY(inside.errors.isEmpty() && inside.exitCode == 0);
    }

    void aModelIsSeenAsTheWindowStarts()
    {
        // The centre of the framed objects is in the middle of the view at any size.
        for (const QStringList &size :
             {QStringList{"--at", "400,300"}, QStringList{"--size", "300x500", "--at", "150,250"}}) {
            const QJsonObject hit = pick(QStringList{m_model} + size);
            QVERIFY(hit["hit"].toBool());
            QCOMPARE(hit["object"].toString(), QString("face.obj"));
            const QList<double> world = numbers(hit["world"]);
            QVERIFY(std::abs(world[0]) < 0.2 && std::abs(world[1]) < 0.2);
            QVERIFY(std::abs(world[2]) < 1e-15);
        }
        QVERIFY(!pick({m_model, "--at", "5,5"})["hit"].toBool());
    }

    void aSceneHasItsOwnPictureOrTheSizeGiven()
    {
        // Half the size keeps the projection: half the pixels.
        QVERIFY(isNear(numbers(pick({m_scene, "--size", "400x300", "--at", "250,75"})["world"]), {0.5, 0.75, 3.0}));
        QVERIFY(!pick({m_scene, "--size", "400x300", "--at", "500,150"})["hit"].toBool());
    }

    void whatIsInReachIsTaken_data()
    {
        QTest::addColumn<QString>("snap");
        QTest::addColumn<QString>("at");
        QTest::addColumn<QList<double>>("world"); // empty: nothing
        // The face from (-1, -1, 3) to (1, 1, 3), 200 pixels a unit: its upper right corner is at (600,
        // 100).
        QTest::newRow("surface") << "surface"
                                 << "603,97" << QList<double>();
        QTest::newRow("vertex") << "vertex"
                                << "603,97" << QList<double>{1, 1, 3};
        QTest::newRow("vertex, too far") << "vertex"
                                         << "609,97" << QList<double>();
        QTest::newRow("edge") << "edge"
                              << "603,250" << QList<double>{1, 0.25, 3};
        QTest::newRow("face") << "face"
                              << "599,150" << QList<double>{0.995, 0.75, 3};
    }

    void whatIsInReachIsTaken()
    {
        QFETCH(QString, snap);
        QFETCH(QString, at);
        QFETCH(QList<double>, world);
        const QString scene = m_folder.write("small.json", QByteArray(kFrustumScene).replace("[2, 2, 2]", "[1, 1, 1]"));
        const QJsonObject one = pick({"--snap", snap, scene, "--at", at});
        const Run rows =
            runCommand({"pick", "--format", "jsonl", "--snap", snap, scene}, "px,py\n" + at.toLatin1() + '\n');
        VERIFY_SUCCEEDED(rows);
        const QJsonObject row = QJsonDocument::fromJson(rows.lines()[0]).object();
        QCOMPARE(one["hit"].toBool(), !world.isEmpty());
        QCOMPARE(row["x"].isDouble(), !world.isEmpty());
        if (world.isEmpty())
            return;
        QVERIFY(isNear(numbers(one["world"]), world));
        QVERIFY(isNear({row["x"].toDouble(), row["y"].toDouble(), row["z"].toDouble()}, world));
    }

    void aVertexHasTheDigitsOfTheFile_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("contents");
        const QByteArrayList places{"5.8900111 0.1 -3.3333333", "431234.567 5812345.678 0.1",
                                    "431236.891 5812345.123 1.25", "431234.999 5812347.001 -0.7"};
        for (const qsizetype first : {qsizetype{0}, qsizetype{1}}) {
            const QByteArrayList own =
                first == 0 ? QByteArrayList{places[0], "6.1 0.2 -3.1", "5.9 0.9000000001 -3.2"} : places.mid(1);
            const char *what = first == 0 ? "beside the origin" : "on a map";
            QTest::newRow(qPrintable(QString("OBJ, %1").arg(what))) << "places.obj"
                                                                    << "v " + own.join("\nv ") + "\nf 1 2 3\n";
            QTest::newRow(qPrintable(QString("OFF, %1").arg(what))) << "places.off"
                                                                    << "OFF 3 1 0\n" + own.join('\n') + "\n3 0 1 2\n";
            QTest::newRow(qPrintable(QString("PLY, %1").arg(what)))
                << "places.ply"
                << "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
                   "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                       + own.join('\n') + "\n3 0 1 2\n";
        }
    }

    void aVertexHasTheDigitsOfTheFile()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, contents);
        const QString model = m_folder.write(name, contents);
        QByteArray positions = "px,py\n";
        for (int y = 5; y < 600; y += 10) {
            for (int x = 5; x < 800; x += 10)
                positions += QByteArray::number(x) + ',' + QByteArray::number(y) + '\n';
        }
        const Run rows = runCommand({"pick", "--snap", "vertex", "--size", "800x600", model}, positions);
        VERIFY_SUCCEEDED(rows);
        QMap<int, QByteArray> found;
        for (const QByteArray &line : rows.lines().mid(1)) {
            const QByteArrayList cells = line.split(',');
            const qsizetype x = 2, vertex = x + kColumns.indexOf("vertex");
            if (!cells[x].isEmpty())
                found[cells[vertex].toInt()] = cells[x] + ' ' + cells[x + 1] + ' ' + cells[x + 2];
        }
        QCOMPARE(found.size(), 3);
        for (auto vertex = found.begin(); vertex != found.end(); ++vertex)
            QVERIFY2(contents.contains(vertex.value() + '\n'), vertex.value().constData());
        // The text output agrees.
        const Run words = runCommand({"info", model});
        VERIFY_SUCCEEDED(words);
        for (const QByteArray &number : contents.contains("5.8900111")
                                            ? QByteArrayList{"5.8900111", "0.9000000001"}
                                            : QByteArrayList{"431234.567", "5812347.001", "-0.7"})
            QVERIFY2(words.output.contains(number), words.output.constData());
    }

    void rowsGoThrough()
    {
        const Run run = runCommand({"pick", m_scene, "-"}, "name,px,py,x\n\"a, b\",500,150,7\nmiss,-1,0,8\n");
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), 3);
        QCOMPARE(run.lines()[0], ("name,px,py," + kColumns.join(',')).toUtf8());
        QVERIFY(
            run.lines()[1].startsWith("\"a, b\",500,150,0.5,0.75,3,face,1,0.3125,0.625,0.0625,0.25,0.375,0,0,0,1,"));
        QCOMPARE(run.lines()[1].count(','), run.lines()[0].count(',') + 1);
        QCOMPARE(run.lines()[2], QByteArray("miss,-1,0" + QByteArray(kColumns.size(), ',')));
    }

    void edgesInPixelsAreTold()
    {
        // A row of pixels over a cube: the ray hits it between two outlines.
        QByteArray input = "px,py\n";
        for (int x = 0; x < 200; ++x)
            input += QByteArray::number(x + 0.5) + ",75.5\n";
        const QString cube = m_folder.write(
            "cube.obj", "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n");
        const Run run = runCommand({"pick", "--edges", "--size", "200x150", cube, "-"}, input);
        QCOMPARE(run.exitCode, 0);
        const QList<QByteArray> names = run.lines()[0].split(',');
        QCOMPARE(names.mid(names.size() - 3), (QList<QByteArray>{"pixel_edge", "beyond_edge", "behind"}));
        QList<int> edges, changes;
        for (int x = 0; x < 200; ++x) {
            const QList<QByteArray> cells = run.lines()[x + 1].split(',');
            if (cells[names.indexOf("pixel_edge")] == "1")
                edges << x;
            if (x > 0 && cells[2].isEmpty() != run.lines()[x].split(',')[2].isEmpty())
                changes << x;
        }
        QCOMPARE(changes.size(), 2);
        QCOMPARE(edges.size(), 2); // its other edges face the eye on one side
        for (int k = 0; k < 2; ++k)
            QVERIFY(edges[k] == changes[k] || edges[k] == changes[k] - 1);
        const QString position = QStringLiteral("%1.5,75.5").arg(edges[0]);
        const QJsonObject json = pick({"--size", "200x150", cube, "--at", position});
        QVERIFY(json.contains("pixelEdge"));
        QVERIFY(runCommand({"pick", "--size", "200x150", cube, "--at", position}).output.contains("pixel edge"));
        QVERIFY(!pick({"--size", "200x150", cube, "--at", "100.5,75.5"}).contains("pixelEdge"));
    }

    void jsonLines()
    {
        const Run run = runCommand({"pick", "--format", "jsonl", m_scene}, "px,py\n500,150\n-1,0\n");
        QCOMPARE(run.exitCode, 1);
        const QJsonObject hit = QJsonDocument::fromJson(run.lines()[0]).object();
        QCOMPARE(hit["object"].toString(), QString("face"));
        QVERIFY(std::abs(hit["y"].toDouble() - 0.75) < 1e-14);
        const QJsonObject miss = QJsonDocument::fromJson(run.lines()[1]).object();
        QVERIFY(miss["object"].isNull() && miss["x"].isNull());
        QCOMPARE(miss["px"].toDouble(), -1.0);
    }

    void manyRowsKeepTheirOrder()
    {
        QByteArray input = "px,py,number\n";
        for (int i = 0; i < 60000; ++i)
            input += QByteArray::number(i % 800) + ".5," + QByteArray::number(i % 599) + ".5," + QByteArray::number(i)
                     + '\n';
        const Run one = runCommand({"pick", "--threads", "1", m_scene}, input);
        const Run four = runCommand({"pick", "--threads", "4", m_scene}, input);
        QCOMPARE(one.lines().size(), 60001);
        QVERIFY(one.lines()[60000].contains(",59999,"));
        QVERIFY(one.output == four.output);
    }

    void badRowsAreNamed()
    {
        const Run run = runCommand({"pick", m_scene}, "py,px\n150,500\n1,foo\n2\n150,500\n");
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.errors.contains("stdin:3:3: px: \"foo\" is not a number"), run.errors.constData());
        QVERIFY2(run.errors.contains("stdin:4") && run.errors.contains("px is missing"), run.errors.constData());
        QCOMPARE(run.lines().size(), 5);
        QVERIFY(run.lines()[4].startsWith("150,500,0.5,"));
        QVERIFY(run.lines()[2].startsWith("1,foo,,"));
    }

    void words()
    {
        const Run run = runCommand({"pick", m_scene, "--at", "500,150", "--at", "-1,0"});
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.output.contains("object       face\n"), run.output.constData());
        QVERIFY(run.output.contains("no hit"));
        const Run snapped = runCommand({"pick", m_scene, "--snap", "vertex", "--at", "500,150"});
        QVERIFY2(snapped.output.contains("no vertex is visible within 8 pixels"), snapped.output.constData());
    }

    /// Noise behind the digits that are certain is left to JSON.
    void wordsHaveNoNoise()
    {
        const QString model =
            m_folder.write("digits.obj", "v -0.1 -0.2 0.009036\nv 0.3 -0.2 0.009036\nv 0.1 0.7 0.009036\n"
                                         "f 1 2 3\n");
        const Run run = runCommand({"pick", model, "--at", "400,300"});
        QCOMPARE(run.exitCode, 0);
        const auto valuesOf = [&run](const QByteArray &name) {
            for (const QByteArray &line : run.lines()) {
                if (line.trimmed().startsWith(name + ' '))
                    return line.trimmed().mid(name.size()).simplified().split(' ');
            }
            return QList<QByteArray>();
        };
        const QList<QByteArray> vertex = valuesOf("vertex").mid(2, 3);
        QCOMPARE(vertex.size(), 3);
        QVERIFY2(QList<QByteArray>({"-0.1", "0.3", "0.1"}).contains(vertex[0]), vertex[0]);
        QCOMPARE(vertex[2], QByteArray("0.009036,"));

        const QJsonObject exact = pick({model, "--at", "400,300"});
        const QList<double> world = numbers(exact["world"]), uncertainty = numbers(exact["uncertainty"]);
        const QList<QByteArray> told = valuesOf("world"), bounds = valuesOf("+-");
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY2(told[axis].size() <= 18, told[axis]);
            QVERIFY2(bounds[axis].size() <= 7, bounds[axis]); // "2.3e-09"
            // The printed number is within its printed uncertainty.
            QVERIFY(std::abs(told[axis].toDouble() - world[axis]) + uncertainty[axis] <= bounds[axis].toDouble());
            QVERIFY(bounds[axis].toDouble() < 1.3 * uncertainty[axis]);
        }
        QCOMPARE(numbers(exact["vertex"]["world"])[2], 0.009036);
    }

    void bundledModels()
    {
        const QString scene = m_folder.write(
            "bundled.json", QByteArray(kFrustumScene).replace("\"file\": \"face.obj\"", "\"bundled\": \"Cube\""));
        QVERIFY(pick({scene, "--at", "400,300"})["hit"].toBool());
    }

    /// A user may start no more threads here; the administrator has no such limit.
    void answersWithoutThreads()
    {
#ifndef Q_OS_LINUX
        QSKIP("no limit to threads here");
#elif defined(UNPROJECTOR_IS_SANITIZED)
        QSKIP("the leak sanitizer needs a thread of its own");
#else
        QByteArray model; // so large that the tree over it is built by all cores
        constexpr int kSide = 300;
        for (int i = 0; i < kSide * kSide; ++i)
            model += "v " + QByteArray::number(i / kSide) + ' ' + QByteArray::number(i % kSide) + " 0\n";
        for (int i = 1; i < kSide * (kSide - 1); ++i) {
            if (i % kSide != 0)
                model += "f " + QByteArray::number(i) + ' ' + QByteArray::number(i + 1) + ' '
                         + QByteArray::number(i + kSide) + '\n';
        }
        const QString file = m_folder.write("grid.obj", model);
        QVERIFY(QFile::setPermissions(QFileInfo(file).path(), QFile::Permissions(0x7755)));
        QProcess shell;
        shell.start("sh", {"-c", "[ $(id -u) -ne 0 ] || other='setpriv --reuid=65534 --regid=65534 --clear-groups'; "
                                 "exec prlimit --nproc=1 --core=0 $other '" UNPROJECT_COMMAND "' pick '"
                                     + file + "' --at 380.3,280.2"});
        QVERIFY(shell.waitForFinished(kPatienceMilliseconds));
        const QByteArray errors = shell.readAllStandardError();
        if (shell.exitStatus() == QProcess::NormalExit && (shell.exitCode() == 126 || shell.exitCode() == 127))
            QSKIP("another user cannot run the command here");
        QVERIFY2(shell.exitStatus() == QProcess::NormalExit && shell.exitCode() == 0, errors.constData());
        const QByteArray answer = shell.readAllStandardOutput();
        QVERIFY2(answer.contains("triangle "), answer.constData());
        QCOMPARE(answer, runCommand({"pick", file, "--at", "380.3,280.2"}).output);
#endif
    }

    void unusable_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("reason");
        const auto row = [](const char *name, const QStringList &arguments, const char *reason) {
            QTest::newRow(name) << arguments << QByteArray(reason);
        };
        row("no scene", {}, "SCENE is required");
        row("no such scene", {"gone.json", "--at", "1,2"}, "gone.json");
        row("no such model", {"gone.stl", "--at", "1,2"}, "gone.stl: there is no such file");
        row("a position that is none", {"SCENE", "--at", "1;2"}, "--at 1;2: give device pixels");
        row("a position without an end", {"SCENE", "--at", "1,2,3"}, "--at 1,2,3");
        row("a position that is not finite", {"SCENE", "--at", "1,nan"}, "--at 1,nan");
        row("a size that is none", {"SCENE", "--at", "1,2", "--size", "800"}, "--size 800: give width and height");
        row("a size of nothing", {"SCENE", "--at", "1,2", "--size", "0x5"}, "--size 0x5");
        row("a snap that is none", {"SCENE", "--at", "1,2", "--snap", "corner"}, "\"corner\" is not one of");
        row("both ways", {"SCENE", "rows.csv", "--at", "1,2"}, "PIXELS rows.csv and --at 1,2 exclude each other");
        row("rows' format for a position", {"SCENE", "--at", "1,2", "--format", "jsonl"},
            "--at 1,2 and --format jsonl exclude each other");
        row("an object farther away than can be computed", {"far.json", "--at", "1,2"},
            "far.json: face: an object reaches to -1e+300, farther than can be computed");
        row("an object smaller than can be computed", {"small.json", "--at", "1,2"},
            "small.json: face: an object measures");
        row("all from stdin", {"-"}, "cannot both come from standard input");
    }

    void unusable()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, reason);
        arguments.replaceInStrings("SCENE", m_scene);
        for (const auto &[name, scale] : {std::pair("far.json", "1e300"), std::pair("small.json", "1e-300")})
            arguments.replaceInStrings(
                name, m_folder.write(name, QByteArray(kFrustumScene)
                                               .replace("[2, 2, 2]", QByteArray("[S, S, S]").replace("S", scale))
                                               .replace("{\"translate\": [0, 0, 3]}, ", "")));
        const Run run = runCommand(QStringList{"pick"} + arguments);
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QVERIFY2(run.errors.contains(reason), run.errors.constData());
    }

private:
    QJsonObject pick(const QStringList &arguments) const
    {
        const Run run = runCommand(QStringList{"pick", "--json"} + arguments);
        if (!run.errors.isEmpty())
            qWarning("%s", run.errors.constData());
        return QJsonDocument::fromJson(run.output).object();
    }

    Folder m_folder;
    QString m_scene, m_model;
};

UNPROJECTOR_TEST(TestPickCommand, threads)
#include "test_pick_command.moc"
