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

} // namespace

class TestPickCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_folder.write("face.obj", kFace);
        m_scene = m_folder.write("scene.json", kFrustumScene);
    }

    void aVertexHasTheDigitsOfTheFile_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("contents");
        const QByteArrayList places{"5.8900111 0.1 -3.3333333", "431234.567 5812345.678 0.1",
                                    "431236.891 5812345.123 1.25", "431234.999 5812347.001 -0.7"};
        for (const qsizetype first : {qsizetype{0}, qsizetype{1}}) {
            const QByteArrayList own =
                first == 0 ? QByteArrayList{places[0], "6.1 0.2 -3.1", "5.9 0.9000000001 -3.2"} : places.mid(1);
            const char *what = first == 0 ? "beside the origin" : "on a map";
            newRow(qPrintable(QString("OBJ, %1").arg(what))) << "places.obj"
                                                             << "v " + own.join("\nv ") + "\nf 1 2 3\n";
            newRow(qPrintable(QString("OFF, %1").arg(what))) << "places.off"
                                                             << "OFF 3 1 0\n" + own.join('\n') + "\n3 0 1 2\n";
            newRow(qPrintable(QString("PLY, %1").arg(what)))
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
        // The pixels whose hits have the largest shares of the corners are the nearest to the vertices.
        QByteArray positions = "px,py\n", nearest = positions;
        for (int y = 1; y < 600; y += 2) {
            for (int x = 1; x < 800; x += 2)
                positions += QByteArray::number(x) + ',' + QByteArray::number(y) + '\n';
        }
        const Run hits = runCommand({"pick", "--size", "800x600", model}, positions);
        VERIFY_SUCCEEDED(hits);
        std::array<std::pair<double, QByteArray>, 3> best;
        for (const QByteArray &line : hits.lines().mid(1)) {
            const QByteArrayList cells = line.split(',');
            for (std::size_t corner = 0; corner < 3 && !cells[2].isEmpty(); ++corner)
                best[corner] = std::max(best[corner], {cells[2 + kColumns.indexOf("u") + qsizetype(corner)].toDouble(),
                                                       cells[0] + ',' + cells[1] + '\n'});
        }
        for (const auto &[share, position] : best)
            nearest += position;
        const Run rows = runCommand({"pick", "--snap", "vertex", "--size", "800x600", model}, nearest);
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

private:
    QJsonObject pick(const QStringList &arguments) const
    {
        const Run run = runCommand(QStringList{"pick", "--json"} + arguments);
        if (!run.errors.isEmpty())
            qWarning("%s", run.errors.constData());
        return QJsonDocument::fromJson(run.output).object();
    }

    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestPickCommand, threads)
#include "test_pick_command.moc"
