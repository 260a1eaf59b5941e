// `unproject info`: the contents of a model or a scene.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>

#include <bit>
#include <cmath>

namespace {

/// A box of 1 x 2 x 3 from (1, 0, 0), its sides counter-clockwise from outside.
const QByteArray kBox = "v 1 0 0\nv 2 0 0\nv 2 2 0\nv 1 2 0\nv 1 0 3\nv 2 0 3\nv 2 2 3\nv 1 2 3\n"
                        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

QJsonValue jsonOf(const Run &run)
{
    return QJsonValue(QJsonDocument::fromJson(run.output).object());
}

QList<double> numbers(const QJsonValue &array)
{
    QList<double> values;
    for (const QJsonValue value : array.toArray())
        values << value.toDouble();
    return values;
}

} // namespace

class TestInfoCommand : public QObject {
    Q_OBJECT

private slots:
    void aModel()
    {
        const Run run = runCommand({"info", "--json", m_folder.write("box.obj", kBox)});
        VERIFY_SUCCEEDED(run);
        const QJsonObject all = jsonOf(run).toObject();
        QCOMPARE(all.keys(), QStringList({"area", "box", "notes", "objects", "triangles", "vertices", "volume"}));
        QCOMPARE(all["vertices"].toInt(), 8);
        QCOMPARE(all["triangles"].toInt(), 12);
        QCOMPARE(all["area"].toDouble(), 22.0);
        QCOMPARE(all["volume"].toDouble(), 6.0);
        QCOMPARE(numbers(all["box"]["min"]), QList<double>({1, 0, 0}));
        QCOMPARE(numbers(all["box"]["max"]), QList<double>({2, 2, 3}));
        QCOMPARE(all["objects"].toArray().size(), 1);
        QJsonObject object = all["objects"].toArray()[0].toObject();
        QCOMPARE(object.take("name").toString(), QString("box.obj"));
        QCOMPARE(object.keys(), QStringList({"area", "box", "triangles", "vertices", "volume"}));
        QCOMPARE(object["volume"].toDouble(), 6.0);
        QCOMPARE(all["notes"].toArray().size(), 0);
    }

    void aSceneInTheWorld()
    {
        m_folder.write("box.obj", kBox);
        const QString scene =
            m_folder.write("scene.json", R"({"unprojector": 1, "window": {"width": 800, "height": 600},
      "projection": {"type": "ortho", "left": -9, "right": 9, "bottom": -9, "top": 9, "near": 1, "far": 40},
      "view": {"eye": [0, 0, 20], "center": [0, 0, 0], "up": [0, 1, 0]},
      "objects": [{"name": "mirrored", "file": "box.obj", "transform": [{"scale": [-2, 1, 1]}]},
                  {"name": "turned", "file": "box.obj", "transform": [{"rotate": [45, 0, 0, 1]}], "hidden": true}]})");
        const Run run = runCommand({"info", "--json", scene});
        QCOMPARE(run.errors, QByteArray());
        const QJsonObject all = jsonOf(run).toObject();
        QCOMPARE(all["triangles"].toInt(), 24);
        const QJsonObject mirrored = all["objects"].toArray()[0].toObject(),
                          turned = all["objects"].toArray()[1].toObject();
        QCOMPARE(mirrored["name"].toString(), QString("mirrored"));
        QCOMPARE(mirrored["volume"].toDouble(), 12.0);
        QCOMPARE(mirrored["area"].toDouble(), 2.0 * (2 * 2 + 2 * 3 + 2 * 3));
        QCOMPARE(numbers(mirrored["box"]["min"]), QList<double>({-4, 0, 0}));
        QVERIFY(std::abs(turned["volume"].toDouble() - 6.0) < 1e-14);
        // Around its corners, not around its box's: (1, 2) is turned to x = -sqrt(1/2).
        QVERIFY(std::abs(numbers(turned["box"]["min"])[0] + std::sqrt(0.5)) < 1e-15);
        QVERIFY(std::abs(all["volume"].toDouble() - 18.0) < 1e-13);
        QCOMPARE(numbers(all["box"]["min"])[0], -4.0);
    }

    void aFarModelKeepsItsVolume()
    {
        QByteArray distant;
        for (const QByteArray &line : kBox.split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            if (words[0] == "v")
                distant += "v " + QByteArray::number(4e6 + words[1].toDouble(), 'f', 1) + ' '
                           + QByteArray::number(5e5 + words[2].toDouble(), 'f', 1) + ' ' + words[3] + '\n';
            else
                distant += line + '\n';
        }
        const QJsonValue all = jsonOf(runCommand({"info", "--json", m_folder.write("far.obj", distant)}));
        QCOMPARE(all["volume"].toDouble(), 6.0);
        QCOMPARE(all["area"].toDouble(), 22.0);
        QCOMPARE(numbers(all["box"]["max"]), QList<double>({4000002, 500002, 3}));
    }

    void pointsAndNotes()
    {
        const Run points = runCommand({"info", "--json", m_folder.write("points.obj", "v 0 0 0\nv 1 2 3\n")});
        QCOMPARE(points.errors, QByteArray());
        QCOMPARE(jsonOf(points)["vertices"].toInt(), 2);
        QCOMPARE(jsonOf(points)["triangles"].toInt(), 0);
        QCOMPARE(numbers(jsonOf(points)["box"]["max"]), QList<double>({1, 2, 3}));
        const Run lines = runCommand({"info", "--json", m_folder.write("lines.obj", kBox + "l 1 2 3\n")});
        QCOMPARE(jsonOf(lines)["notes"].toArray().size(), 1);
        QVERIFY(jsonOf(lines)["notes"].toArray()[0].toString().contains("line"));
    }

    /// The enclosed volume of an open surface depends on the origin.
    void anOpenSurfaceHasNoVolume()
    {
        QVERIFY(jsonOf(runCommand({"info", "--json", m_folder.write("box.obj", kBox)}))["notes"].toArray().isEmpty());
        const QByteArray lid = kBox.left(kBox.lastIndexOf("f "));
        const QJsonArray notes =
            jsonOf(runCommand({"info", "--json", m_folder.write("lidless.obj", lid)}))["notes"].toArray();
        QCOMPARE(notes.size(), 1);
        QVERIFY(notes[0].toString().contains("the surface is open"));
    }

    void words()
    {
        const Run run = runCommand({"info", m_folder.write("box.obj", kBox)});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.output.contains("volume     6\n"));
        QVERIFY(run.output.contains("box        1 0 0  to  2 2 3\n"));
    }

    void wordsHaveTheDigitsOfTheFile_data()
    {
        QTest::addColumn<QByteArray>("model");
        QTest::addColumn<QByteArray>("box");
        QByteArray floats("ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                          "property float z\nend_header\n");
        for (const float value : {0.1f, 0.2f, 0.3f, 0.7f, 0.8f, 0.9f}) {
            const quint32 bits = qToLittleEndian(std::bit_cast<quint32>(value));
            floats.append(reinterpret_cast<const char *>(&bits), sizeof bits);
        }
        QTest::newRow("floats") << floats << QByteArray("0.1 0.2 0.3  to  0.7 0.8 0.9");
        QTest::newRow("near the origin") << QByteArray(
            "v 0.009036 0.1 -3.3333333\nv 1.1 0.2 7e-9\nv 0.5 0.3 1\nf 1 2 3\n")
                                         << QByteArray("0.009036 0.1 -3.3333333  to  1.1 0.3 1");
        QTest::newRow("far from it") << QByteArray(
            "v 4000000.123 500000.1 300.7\nv 4000001.3 500001.2 300.9\nv 4000000.7 500000.6 301.1\nf 1 2 3\n")
                                     << QByteArray("4000000.123 500000.1 300.7  to  4000001.3 500001.2 301.1");
        QTest::newRow("points") << QByteArray("v 0.1 0.2 0.3\nv 0.7 0.8 0.9\n")
                                << QByteArray("0.1 0.2 0.3  to  0.7 0.8 0.9");
    }

    /// Floats have noise behind the intended digits. JSON keeps all of it, so that it reads back to the
    /// same numbers.
    void wordsHaveTheDigitsOfTheFile()
    {
        QFETCH(QByteArray, model);
        QFETCH(QByteArray, box);
        const bool areFloats = model.startsWith("ply");
        const QString file = m_folder.write(areFloats ? "digits.ply" : "digits.obj", model);
        const Run words = runCommand({"info", file});
        QVERIFY2(words.output.contains("box        " + box + '\n'), words.output.constData());
        const QJsonValue exact = jsonOf(runCommand({"info", "--json", file}));
        const QList<QByteArray> ends = box.split(' ');
        for (int axis = 0; axis < 3; ++axis) {
            const double lowest = numbers(exact["box"]["min"])[axis], told = ends[axis].toDouble();
            QCOMPARE(lowest, areFloats ? double(float(told)) : told);
        }
    }

    /// JSON has neither infinity nor NaN.
    void whatADoubleDoesNotHoldIsMissing()
    {
        m_folder.write("box.obj", kBox);
        const QString scene = m_folder.write(
            "huge.json", QByteArray(kFrustumScene)
                             .replace("face.obj", "box.obj")
                             .replace("\"scale\": [2, 2, 2]",
                                      "\"scale\": [1e200, 1e200, 1e200]}, {\"scale\": [1e200, 1e200, 1e200]"));
        const Run run = runCommand({"info", "--json", scene});
        VERIFY_SUCCEEDED(run);
        const QJsonObject all = jsonOf(run).toObject();
        QVERIFY(all["area"].isNull() && all["volume"].isNull());
        QCOMPARE(all["triangles"].toInt(), 12);
        QVERIFY(all["notes"].toArray().last().toString().contains("beyond the range of a double"));
        const Run table = runCommand({"info", scene});
        VERIFY_SUCCEEDED(table);
        QVERIFY2(table.output.contains("missing") && !table.output.contains("nan"), table.output.constData());
    }

    void refused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("no such file") << "" << QByteArray() << QByteArray("missing.obj: there is no such file");
        QTest::newRow("a format of others") << "a.xyz" << QByteArray("1 2 3\n") << QByteArray("OBJ, STL, PLY");
        QTest::newRow("damaged") << "a.off" << QByteArray("OFF\n3 1 0\n0 0\n")
                                 << QByteArray("a.off: the file is damaged");
        QTest::newRow("empty") << "a.obj" << QByteArray() << QByteArray("a.obj: the file is empty");
        QTest::newRow("a bad scene") << "a.json" << QByteArray("{\"unprojector\": 1}") << QByteArray("a.json");
        QTest::newRow("a scene whose model is not there")
            << "b.json" << QByteArray(kFrustumScene).replace("face.obj", "gone.obj")
            << QByteArray("gone.obj: there is no such file");
        QTest::newRow("which object's model is not there")
            << "d.json" << QByteArray(kFrustumScene).replace("face.obj", "gone.obj") << QByteArray("d.json: face: ");
        QTest::newRow("another format's contents") << "ply.obj" << QByteArray("ply\nformat ascii 1.0\n")
                                                   << QByteArray("its contents look like ply: give it the suffix .ply");
        QTest::newRow("no suffix") << "model" << QByteArray("solid a\nfacet normal 0 0 1\n")
                                   << QByteArray("its contents look like stl: give it the suffix .stl");
        QTest::newRow("OBJ called text") << "a.txt" << QByteArray("# made by hand\nv 0 0 0\n")
                                         << QByteArray("look like obj");
        QTest::newRow("compressed") << "a.ply.gz" << QByteArray("\x1f\x8b\x08\x00") << QByteArray("unpack it first");
        QTest::newRow("GLB that ends early")
            << "a.glb" << QByteArray("glTF\x02") << QByteArray("ends within the header");
        QTest::newRow("a model called a scene") << "text.json" << QByteArray("v 0 0 0\n")
                                                << QByteArray("text.json: is not a scene; its contents look like obj");
        QTest::newRow("a scene that ends early")
            << "cut.json" << QByteArray(kFrustumScene).left(200) << QByteArray("cut.json:5:");
        QTest::newRow("a scene with an unknown bundled model")
            << "c.json" << QByteArray(kFrustumScene).replace("\"file\": \"face.obj\"", "\"bundled\": \"nobody\"")
            << QByteArray("no bundled model \"nobody\"");
    }

    void refused()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, reason);
        const Run run =
            runCommand({"info", "--json", name.isEmpty() ? m_folder.path("missing.obj") : m_folder.write(name, text)});
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QVERIFY2(run.errors.contains(reason), run.errors.constData());
        QCOMPARE(run.errors.count('\n'), 1);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestInfoCommand)
#include "test_info_command.moc"
