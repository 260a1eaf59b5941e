// `unproject matrices`, as a script runs it.

#include "tests/cli/command.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <limits>

class TestMatricesCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }
    void entriesAreThoseOfOpenGL();
    void rowsAreColumnsTransposed();
    void textsAreForTheirReaders_data();
    void textsAreForTheirReaders();
    void unusableInput();

private:
    QJsonObject json(const QStringList &options = {}) const
    {
        const Run run = runCommand(QStringList{"matrices", "--format", "json", m_scene} + options);
        return QJsonDocument::fromJson(run.output).object();
    }

    Folder m_folder;
    QString m_scene;
};

namespace {

double entry(const QJsonObject &matrices, const QString &name, int row, int column)
{
    return matrices[name].toArray()[row].toArray()[column].toDouble(std::numeric_limits<double>::quiet_NaN());
}

} // namespace

void TestMatricesCommand::entriesAreThoseOfOpenGL()
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

void TestMatricesCommand::rowsAreColumnsTransposed()
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

void TestMatricesCommand::textsAreForTheirReaders_data()
{
    QTest::addColumn<QString>("format");
    QTest::addColumn<QByteArray>("part");
    QTest::newRow("text") << "text"
                          << QByteArray("# view: eye from world\n1  0  0   0\n0  1  0   0\n0  0  1  -5\n0  0  0   1\n");
    QTest::newRow("c") << "c" << QByteArray("const double modelview_face[16] = {");
    QTest::newRow("numpy") << "numpy" << QByteArray("import numpy as np\n");
    QTest::newRow("latex") << "latex" << QByteArray("\\begin{bmatrix}");
}

void TestMatricesCommand::textsAreForTheirReaders()
{
    QFETCH(QString, format);
    QFETCH(QByteArray, part);
    const Run run = runCommand({"matrices", "--format", format, m_scene});
    QCOMPARE(run.exitCode, 0);
    QVERIFY2(run.output.contains(part), run.output.constData());
}

void TestMatricesCommand::unusableInput()
{
    QCOMPARE(runCommand({"matrices", m_folder.path("missing")}).exitCode, 2);
    QCOMPARE(runCommand({"matrices", "--format", "xml", m_scene}).exitCode, 2);
    QCOMPARE(runCommand({"matrices"}).exitCode, 2);
}

QTEST_GUILESS_MAIN(TestMatricesCommand)
#include "test_matrices_command.moc"
