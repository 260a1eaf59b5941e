// `unproject map`: a number for each pixel.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/cli/peak_memory.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <cstring>

namespace {

/// A square of side 2; kFrustumScene doubles it and puts it to z = 3. That is 2 in front of the
/// eye, where a pixel is 1/200 wide; the square fills the picture's width and all of its height.
const QByteArray kFace = "v -1 -0.5 0\nv 1 -0.5 0\nv 1 0.5 0\nv -1 0.5 0\nf 1 2 3 4\n";

/// The number of a pixel of a float map, counted from the top.
float valueAt(const QByteArray &map, const QByteArray &header, int width, int height, int i, int j)
{
    float value = 0.0F;
    const int index = (height - 1 - j) * width + i;
    std::memcpy(&value, map.constData() + header.size() + 4 * index, sizeof value);
    return value;
}

} // namespace

class TestMapCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_model = m_folder.write("face.obj", kFace);
        m_scene = m_folder.write("scene.json", kFrustumScene);
        m_map = m_folder.path("map.pfm");
    }

    void aMapOfADisplacement()
    {
        const Run run = runCommand({"map", m_scene, "--what", "displacement", "--convention", "open3d", "-o", "-"});
        QCOMPARE(run.exitCode, 0);
        const QByteArray header = "Pf\n800 600\n-1.0\n";
        QVERIFY(run.output.startsWith(header));
        QCOMPARE(run.output.size(), header.size() + 4 * 800 * 600);
        // Half a pixel left and up; the square's height takes the middle 400 rows.
        const double half = std::sqrt(0.5) / 200;
        QVERIFY(std::abs(double(valueAt(run.output, header, 800, 600, 123, 300)) - half) < 1e-6);
        QVERIFY(std::isnan(valueAt(run.output, header, 800, 600, 123, 99)));
        QVERIFY(!std::isnan(valueAt(run.output, header, 800, 600, 123, 100)));
        QVERIFY(run.errors.startsWith("displacement of open3d, world units: 320000 of 480000 pixels; least 0.00354"));
        const Run small = runCommand({"map", m_model, "--what", "formula-matrix", "--size", "30x20", "-o", "-"});
        QVERIFY(small.output.startsWith("Pf\n30 20\n"));
    }

    /// MeshLab reads the depth of the row above: at the upper edge of the square that is the far
    /// plane's, 4 in front of the eye.
    void whatIsNotSeenHasNoNumber()
    {
        const Run run = runCommand({"map", m_scene, "--what", "displacement", "--convention", "meshlab", "-o", "-"});
        const QByteArray header = "Pf\n800 600\n-1.0\n";
        QVERIFY(double(valueAt(run.output, header, 800, 600, 400, 100)) > 1.99);
        QVERIFY(double(valueAt(run.output, header, 800, 600, 400, 101)) < 0.01);
    }

    void theStatistics()
    {
        const Run run = runCommand({"map", "--json", m_scene, "--what", "formula-ray", "--unit", "ulp", "-o", m_map});
        VERIFY_SUCCEEDED(run);
        const QJsonObject said = QJsonDocument::fromJson(run.output).object();
        QCOMPARE(said.keys(), QStringList({"count", "max", "median", "min", "p99", "size", "unit", "what"}));
        QCOMPARE(said["what"].toString(), QString("formula-ray"));
        QCOMPARE(said["unit"].toString(), QString("ulp"));
        QCOMPARE(said["size"].toArray(), QJsonArray({800, 600}));
        QCOMPARE(said["count"].toInt(), 320000);
        QVERIFY(said["min"].toDouble() <= said["median"].toDouble());
        QVERIFY(said["median"].toDouble() <= said["p99"].toDouble());
        QVERIFY(said["p99"].toDouble() <= said["max"].toDouble() && said["max"].toDouble() > 1.0);
        QFile file(m_map);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.size(), qint64(16 + 4 * 800 * 600));
    }

    void aLargePictureTakesLittleMemory_data()
    {
        addColumn<QStringList>("what");
        newRow("uncertainty") << QStringList{"uncertainty"};
        newRow("displacement") << QStringList{"displacement", "--convention", "screen2world"};
    }

    /// The memory is the one of a small picture, plus a float a pixel, which the statistics need.
    void aLargePictureTakesLittleMemory()
    {
#ifdef UNPROJECTOR_IS_SANITIZED
        QSKIP("sanitizers take memory of their own");
#endif
        QFETCH(QStringList, what);
        constexpr int kPixels = 2500;
        QProcess process;
        process.start(QStringLiteral(UNPROJECT_COMMAND),
                      QStringList{"map", m_scene, "--size", QStringLiteral("%1x%1").arg(kPixels), "-o", "-", "--what"}
                          + what);
        // The first output is complete: the numbers are written when all are there, and are more than a
        // pipe holds.
        QVERIFY(process.waitForReadyRead(2 * kPatienceMilliseconds));
        const qint64 peak = peakMemory(process.processId());
        QByteArray map = process.readAllStandardOutput();
        while (process.waitForReadyRead(kPatienceMilliseconds))
            map += process.readAllStandardOutput();
        QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.exitCode(), 0);
        map += process.readAllStandardOutput();
        QCOMPARE(map.size(), qsizetype(std::strlen("Pf\n2500 2500\n-1.0\n")) + 4 * kPixels * kPixels);
        if (peak == 0)
            QSKIP("how much memory it took is not known here");
        constexpr qint64 kMapKiB = 4 * kPixels * kPixels / 1024, kOtherKiB = 48 * 1024;
        QVERIFY2(peak < kMapKiB + kOtherKiB, QByteArray::number(peak) + " KiB");
        qInfo("%lld KiB at most", static_cast<long long>(peak));
    }

private:
    Folder m_folder;
    QString m_scene, m_model, m_map;
};

UNPROJECTOR_TEST(TestMapCommand, threads)
#include "test_map_command.moc"
