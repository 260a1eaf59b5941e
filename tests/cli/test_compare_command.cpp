// `unproject compare`, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include "core/cli/rows/distribution.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

/// Looking away from the origin: next to it the digits of any method are few.
QByteArray sceneWith(const QByteArray &projection)
{
    return "{\"unprojector\": 1, \"window\": {\"width\": 801, \"height\": 601}, \"projection\": " + projection
           + ", \"view\": {\"eye\": [3, 4, 5], \"center\": [13, 24, 35.3], \"up\": [0, 1, 0]}}";
}

/// The ways to compute by their names: "formula double".
QHash<QString, QJsonObject> ways(const QByteArray &json)
{
    QHash<QString, QJsonObject> result;
    for (const QJsonValue way : QJsonDocument::fromJson(json).object()["methods"].toArray())
        result[way["method"].toString() + ' ' + way["precision"].toString()] = way.toObject();
    return result;
}

double largestUlps(const QJsonObject &way)
{
    return way["ulps"].toObject()["largest"].toDouble();
}

} // namespace

class TestCompareCommand : public QObject {
    Q_OBJECT

private slots:
    void formulaHoldsItsPromise_data()
    {
        addColumn<QByteArray>("projection");
        addColumn<double>("matrixUlpsAtLeast");
        newRow("5 : 80000") << QByteArray(R"({"type": "perspective", "fovy": 60, "near": 5, "far": 80000})") << 1e3;
        newRow("0.1 : 10000") << QByteArray(R"({"type": "perspective", "fovy": 60, "near": 0.1, "far": 10000})") << 1e4;
        newRow("off-centre frustum") << QByteArray(
            R"({"type": "frustum", "left": -1, "right": 2, "bottom": -0.5, "top": 1, "near": 1, "far": 100})")
                                     << 10.0;
        newRow("box") << QByteArray(
            R"({"type": "ortho", "left": -1, "right": 2, "bottom": -5, "top": 1, "near": 1, "far": 100})")
                      << 0.5;
        newRow("oblique") << QByteArray(
            R"({"type": "oblique", "left": -1, "right": 2, "bottom": -5, "top": 1, "near": 1, "far": 100,
        "theta": 60, "phi": 70})")
                          << 0.5;
    }

    void formulaHoldsItsPromise()
    {
        QFETCH(QByteArray, projection);
        QFETCH(double, matrixUlpsAtLeast);
        const Run run = runCommand({"compare", "--json", m_folder.write("scene.json", sceneWith(projection))});
        VERIFY_SUCCEEDED(run);
        const QHash<QString, QJsonObject> found = ways(run.output);
        QCOMPARE(found.size(), 4);
        QVERIFY2(found["formula double"]["ulps"].toObject()["percentile99.99"].toDouble() <= 20.0,
                 run.output.constData());
        QVERIFY(largestUlps(found["formula double"]) > 0.0);
        QVERIFY2(largestUlps(found["matrix double"]) >= matrixUlpsAtLeast, run.output.constData());
        for (const char *axis : {"x", "y", "z"}) {
            const double inDouble = found["formula double"][QLatin1String(axis)].toObject()["largest"].toDouble();
            const double inFloat = found["formula float"][QLatin1String(axis)].toObject()["largest"].toDouble();
            QVERIFY2(inFloat >= 1e6 * inDouble, run.output.constData());
        }
    }

    void thePercentileIsThatOfAllNumbers_data()
    {
        addColumn<int>("count");
        addColumn<int>("most");
        newRow("one") << 1 << 1;
        newRow("one of many") << 1 << 100000;
        newRow("fewer than a share") << 99 << 99;
        newRow("many") << 100000 << 100000;
        newRow("fewer than there might be") << 54321 << 100000;
    }

    /// The command keeps only the largest numbers; its percentiles are the same as with all numbers.
    void thePercentileIsThatOfAllNumbers()
    {
        QFETCH(int, count);
        QFETCH(int, most);
        unprojector::cli::Distribution distribution(0.999, std::size_t(most));
        QVERIFY(distribution.isEmpty());
        std::vector<double> all;
        double sum = 0.0;
        for (int i = 0; i < count; ++i) {
            all.push_back(std::fmod(i * 0.6180339887498949, 1.0));
            sum += all.back();
            distribution.add(all.back());
        }
        std::sort(all.begin(), all.end());
        QCOMPARE(distribution.largest(), all.back());
        QCOMPARE(distribution.mean(), sum / count);
        QCOMPARE(distribution.percentile(), all[std::min(std::size_t(0.999 * count), all.size() - 1)]);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestCompareCommand, threads)
#include "test_compare_command.moc"
