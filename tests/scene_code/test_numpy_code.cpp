// The NumPy script of a scene: its matrices, its projection and both methods of unprojection give
// core's results. Python runs the script if it has NumPy.

#include "tests/support/test.h"

#include "core/scene_code/scene_code.h"
#include "tests/scene_code/core_clicks.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace unprojector::scene_code;
using namespace unprojector::geometry;
using namespace unprojector::scene_file;

namespace {

/// The program that imports the script, reads clicks, and writes the script's numbers with all
/// digits.
const char *const kAsks = R"(
import json, sys
import scene
answer = {"clip": scene.clip_from_eye.tolist(), "view": scene.eye_from_world.tolist(),
          "models": [v.tolist() for k, v in vars(scene).items() if k.startswith("world_from_")],
          "formula": [], "inverse": [], "screen2world": [], "window": []}
for i, j, depth, *world in json.load(sys.stdin):
    window = scene.window_point(i, j, depth)
    answer["inverse"].append(scene.world_by_inverse(window).tolist())
    if hasattr(scene, "world_by_formula"):
        answer["formula"].append(scene.world_by_formula(window).tolist())
    answer["screen2world"].append(scene.screen2world(i, j, depth).tolist())
    answer["window"].append((scene.project(world) - window).tolist())
json.dump(answer, sys.stdout)
)";

/// A program that exits with 0 if NumPy is available.
const char *const kLooks = "import sys, importlib.util; sys.exit(importlib.util.find_spec('numpy') is None)";

/// The first Python in the search path with NumPy; empty if there is none.
QString pythonWithNumpy()
{
    for (const QString &folder : qEnvironmentVariable("PATH").split(QDir::listSeparator(), Qt::SkipEmptyParts)) {
        for (const char *name : {"python3", "python"}) {
            const QString program = QStandardPaths::findExecutable(QString::fromLatin1(name), {folder});
            if (!program.isEmpty() && QProcess::execute(program, {QStringLiteral("-c"), QLatin1String(kLooks)}) == 0)
                return program;
        }
    }
    return {};
}

void write(const QString &file, const QByteArray &text)
{
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly) && out.write(text) == text.size());
}

glm::dmat4 matrixOf(const QJsonValue &rows)
{
    glm::dmat4 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = rows.toArray().at(row).toArray().at(column).toDouble();
    return matrix;
}

glm::dvec3 pointOf(const QJsonValue &numbers)
{
    const QJsonArray p = numbers.toArray();
    return {p.at(0).toDouble(), p.at(1).toDouble(), p.at(2).toDouble()};
}

} // namespace

class TestNumpyCode : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_python = pythonWithNumpy(); }
    void itHasBothWaysBack_data() { sceneRows(); }

    /// This test needs no Python.
    void itHasBothWaysBack()
    {
        QFETCH(QString, projection);
        QFETCH(bool, hasFormula);
        const QString text =
            QString::fromStdString(sceneCode(core_clicks::sceneNamed(QTest::currentDataTag()), CodeDialect::NumPy));
        QVERIFY2(text.contains(projection), qPrintable(text));
        for (const char *part : {"import numpy as np\n", "def project(world):", "def world_by_inverse(window):",
                                 "def screen2world(i, j, depth):", "if __name__ == \"__main__\":"})
            QVERIFY2(text.contains(QLatin1String(part)), part);
        QCOMPARE(text.contains(QLatin1String("def world_by_formula(window):")), hasFormula);
        QVERIFY(!text.contains(QLatin1String("//")) && !text.contains(u'\t'));
    }

    void itsNumbersAreCores_data() { sceneRows(); }

    void itsNumbersAreCores()
    {
        QFETCH(bool, hasFormula);
        if (m_python.isEmpty())
            QSKIP("NOT RUN: no Python of the search path has NumPy (Debian, Ubuntu: python3-numpy)");
        const SceneFile scene = core_clicks::sceneNamed(QTest::currentDataTag());
        const Setup setup = setupOf(scene);
        const std::vector<core_clicks::Click> clicks = core_clicks::hundredClicks(scene);
        QJsonArray asked;
        for (const core_clicks::Click &click : clicks)
            asked.append(QJsonArray{click.i, click.j, click.depth, click.world.x, click.world.y, click.world.z});

        const QTemporaryDir folder;
        write(folder.filePath(QStringLiteral("scene.py")),
              QByteArray::fromStdString(sceneCode(scene, CodeDialect::NumPy)));
        write(folder.filePath(QStringLiteral("asks.py")), kAsks);
        QProcess python;
        python.setWorkingDirectory(folder.path());
        python.start(m_python, {QStringLiteral("asks.py")});
        python.write(QJsonDocument(asked).toJson());
        python.closeWriteChannel();
        QVERIFY(python.waitForFinished(-1));
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError());
        const QJsonObject answer = QJsonDocument::fromJson(python.readAllStandardOutput()).object();

        constexpr double kShare = 1e-14;
        core_clicks::compareMatrices(matrixOf(answer["clip"]), *clipFromEye(setup), kShare);
        core_clicks::compareMatrices(matrixOf(answer["view"]), *eyeFromWorld(setup), kShare);
        const QJsonArray models = answer["models"].toArray();
        QCOMPARE(std::size_t(models.size()), scene.objects.size());
        for (int i = 0; i < models.size(); ++i)
            core_clicks::compareMatrices(matrixOf(models.at(i)),
                                         worldFromObject(scene.objects[std::size_t(i)].transform), kShare);

        // The error from a depth's rounding grows with the square of the distance. An error of half a
        // pixel would be 1e9 times as large.
        constexpr double kWorld = 1e-11, kPixel = 1e-9;
        QCOMPARE(answer["formula"].toArray().isEmpty(), !hasFormula);
        for (int k = 0; k < int(clicks.size()); ++k) {
            const glm::dvec3 expected = clicks[std::size_t(k)].world;
            for (const char *way : {"formula", "inverse", "screen2world"}) {
                const QJsonArray found = answer[QLatin1String(way)].toArray();
                if (found.isEmpty())
                    continue;
                const double off = glm::distance(pointOf(found.at(k)), expected);
                QVERIFY2(off <= kWorld * (10.0 + glm::length(expected)),
                         qPrintable(QStringLiteral("%1, click %2: off by %3").arg(QLatin1String(way)).arg(k).arg(off)));
            }
            const double off = glm::length(pointOf(answer["window"].toArray().at(k)));
            QVERIFY2(off <= kPixel, qPrintable(QStringLiteral("projected again: off by %1").arg(off)));
        }

        // Run as a program, it prints a click by both methods.
        python.start(m_python, {QStringLiteral("scene.py")});
        QVERIFY(python.waitForFinished(-1));
        const QByteArray printed = python.readAllStandardOutput();
        QVERIFY2(python.exitCode() == 0 && printed.contains("world by inverse:"),
                 python.readAllStandardError() + printed);
        QCOMPARE(printed.contains("world by formula:"), hasFormula);
    }

private:
    static void sceneRows()
    {
        addColumn<QString>("projection");
        addColumn<bool>("hasFormula");
        newRow("frustum") << "# glFrustum" << true;
        newRow("general_matrix") << "clip_from_eye = np.array([" << false;
        newRow("matrices") << "z = m[2, 3] / (" << true;
        newRow("oblique") << "cot_theta, cot_phi = " << true;
        newRow("off_centre") << "# glFrustum" << true;
        newRow("ortho") << "# glOrtho" << true;
        newRow("perspective") << "# gluPerspective" << true;
        newRow("ortho_matrix") << "z = (m[3, 3] * z_ndc" << true;
        newRow("perspective_matrix") << "z = m[2, 3] / (" << true;
    }

    QString m_python;
};

UNPROJECTOR_TEST(TestNumpyCode)
#include "test_numpy_code.moc"
