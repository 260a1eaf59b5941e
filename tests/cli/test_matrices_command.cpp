// `unproject matrices`, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <limits>

namespace {

double entry(const QJsonObject &matrices, const QString &name, int row, int column)
{
    return matrices[name].toArray()[row].toArray()[column].toDouble(std::numeric_limits<double>::quiet_NaN());
}

} // namespace

class TestMatricesCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

    void entriesAreThoseOfOpenGL()
    {
        const QJsonObject m = json();
        QCOMPARE(m["layout"].toString(), "column");
        QCOMPARE(entry(m, "view", 2, 3), -5.0);
        QCOMPARE(entry(m, "projection", 0, 0), 1.0);
        QCOMPARE(entry(m, "projection", 1, 1), 1.0 / 0.75);
        QCOMPARE(entry(m, "projection", 2, 2), -5.0 / 3.0);
        QCOMPARE(entry(m, "projection", 2, 3), -8.0 / 3.0);
        QCOMPARE(entry(m, "projection", 3, 2), -1.0);
        QCOMPARE(entry(m, "viewport", 0, 3), 400.0);
        QCOMPARE(entry(m, "viewport", 1, 1), 300.0);
        QCOMPARE(entry(m, "viewport", 2, 2), 0.5);
        QCOMPARE(entry(m, "model_face", 0, 0), 2.0);
        QCOMPARE(entry(m, "modelview_face", 2, 3), -2.0);
        QCOMPARE(entry(m, "mvp_face", 3, 3), 2.0);
    }

    void rowsAreColumnsTransposed()
    {
        const QJsonObject columns = json(), rows = json({"--layout", "row"});
        QCOMPARE(rows["layout"].toString(), "row");
        QCOMPARE(columns.keys(), rows.keys());
        for (const QString &name : columns.keys()) {
            for (int row = 0; row < 4 && name != "layout"; ++row) {
                for (int column = 0; column < 4; ++column)
                    QCOMPARE(entry(rows, name, row, column), entry(columns, name, column, row));
            }
        }
    }

    void textsAreForTheirReaders_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("part");
        QTest::newRow("text") << "text"
                              << QByteArray(
                                     "# view: eye from world\n1  0  0   0\n0  1  0   0\n0  0  1  -5\n0  0  0   1\n");
        QTest::newRow("c") << "c" << QByteArray("const double modelview_face[16] = {");
        QTest::newRow("numpy") << "numpy" << QByteArray("import numpy as np\n");
        QTest::newRow("latex") << "latex" << QByteArray("\\begin{bmatrix}");
    }

    void textsAreForTheirReaders()
    {
        QFETCH(QString, format);
        QFETCH(QByteArray, part);
        const Run run = runCommand({"matrices", "--format", format, m_scene});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.output.contains(part), run.output.constData());
    }

    void conventionsOfOtherApis()
    {
        const QJsonObject direct3d = json({"--conventions", "direct3d"});
        QCOMPARE(direct3d["conventions"].toString(), "direct3d");
        QCOMPARE(direct3d["layout"].toString(), "row");
        QCOMPARE(entry(direct3d, "view", 3, 2), 5.0); // the world's origin lies in front, along +z
        QCOMPARE(entry(direct3d, "projection", 2, 2), 4.0 / 3.0);
        QCOMPARE(entry(direct3d, "projection", 2, 3), 1.0);
        QCOMPARE(entry(direct3d, "projection", 3, 2), -4.0 / 3.0);
        QCOMPARE(entry(direct3d, "viewport", 1, 1), -300.0);
        const QJsonObject vulkan = json({"--conventions", "vulkan"}), columns = json();
        QCOMPARE(entry(vulkan, "projection", 1, 1), -1.0 / 0.75);
        QCOMPARE(entry(vulkan, "viewport", 1, 1), 300.0);
        QVERIFY(vulkan["view"] == columns["view"]);
        const QJsonObject unity = json({"--conventions", "unity"});
        QCOMPARE(entry(unity, "model_face", 2, 3), -3.0);
        QVERIFY(unity["modelview_face"] == columns["modelview_face"]);

        // The scene's own conventions apply without an option.
        const QByteArray text = QByteArray(kFrustumScene).replace("1,\n", "1, \"conventions\": \"vulkan\",\n");
        const Run run = runCommand({"matrices", "--format", "json", m_folder.write("vulkan.json", text)});
        QVERIFY(QJsonDocument::fromJson(run.output).object() == vulkan);
        // The scene does not use the conventions of a left-handed world.
        const QByteArray mirrored = QByteArray(text).replace("vulkan", "unity");
        const Run said = runCommand({"project", m_folder.write("unity.json", mirrored)}, "x,y,z\n0,0,0\n");
        QVERIFY2(said.errors.contains("unity.json: conventions: Unity's own world has z negated"), said.errors);
    }

    void openCvHasRotationTranslationAndCameraMatrix()
    {
        const QJsonObject m = json({"--conventions", "opencv"});
        QVERIFY(!m.contains("projection") && !m.contains("mvp_face"));
        QCOMPARE(entry(m, "K", 0, 0), 400.0);
        QCOMPARE(entry(m, "K", 0, 2), 399.5);
        QCOMPARE(entry(m, "K", 1, 2), 299.5);
        QCOMPARE(entry(m, "R", 1, 1), -1.0);
        QCOMPARE(entry(m, "t", 2, 0), 5.0);
        const Run c = runCommand({"matrices", "--conventions", "opencv", "--format", "c", m_scene});
        QVERIFY2(c.output.contains("const double K[9] = {\n400, 0, 399.5,\n0, 400, 299.5,\n0, 0, 1,\n};\n"), c.output);
    }

    /// The numbers behind equal names skip what other objects are called.
    void eachObjectHasItsOwnNames()
    {
        QByteArray objects;
        for (int i = 0; i < 7; ++i) {
            const QByteArray name = QList<QByteArray>{"face", "face", "a b", "face_3", "face", "face_3", "a.b"}[i];
            objects += (i > 0 ? ", " : "")
                       + QByteArray(R"({"name": "%1", "file": "face.obj", "transform": [{"translate": [%2, 0, 0]}]})")
                             .replace("%1", name)
                             .replace("%2", QByteArray::number(i));
        }
        const QByteArray start = QByteArray(kFrustumScene).first(kFrustumScene.indexOf("\"objects\""));
        const QString scene = m_folder.write("names.json", start + "\"objects\": [" + objects + "]}");
        const Run run = runCommand({"matrices", "--format", "json", scene});
        VERIFY_SUCCEEDED(run);
        const QJsonObject m = QJsonDocument::fromJson(run.output).object();
        int i = 0;
        for (const char *name : {"face", "face_2", "a_b", "face_3", "face_4", "face_3_2", "a_b_2"}) {
            QVERIFY2(m.contains(QStringLiteral("mvp_") + name), name);
            QCOMPARE(entry(m, QStringLiteral("model_") + name, 0, 3), double(i++));
        }
        QCOMPARE(m.size(), qsizetype(1 + 5 + 4 * 7));
    }

    void unusableInput()
    {
        const Run unknown = runCommand({"matrices", "--conventions", "glide", m_scene});
        QCOMPARE(unknown.exitCode, 2);
        QVERIFY2(unknown.errors.contains("\"glide\" is not one of direct3d, metal,"), unknown.errors);
        QCOMPARE(runCommand({"matrices", m_folder.path("missing")}).exitCode, 2);
        QCOMPARE(runCommand({"matrices", "--format", "xml", m_scene}).exitCode, 2);
        QCOMPARE(runCommand({"matrices"}).exitCode, 2);
    }

private:
    QJsonObject json(const QStringList &options = {}) const
    {
        const Run run = runCommand(QStringList{"matrices", "--format", "json", m_scene} + options);
        return QJsonDocument::fromJson(run.output).object();
    }

    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestMatricesCommand)
#include "test_matrices_command.moc"
