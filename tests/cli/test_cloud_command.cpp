// `unproject cloud`, as a script runs it: the same picture in every format that is read.

#include "tests/support/test.h"

#include "tests/cli/depth_files.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// 4 x 3 pixels of a scene seen by a frustum; eye (0, 0, 5), looking down -z.
const QByteArray kScene = R"({"unprojector": 1, "window": {"width": 4, "height": 3},
  "projection": {"type": "frustum", "left": -2, "right": 2, "bottom": -1.5, "top": 1.5, "near": 1, "far": 4},
  "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}})";

constexpr int kWidth = 4, kHeight = 3;

/// Background except for two pixels: the second of the top row, on the near plane, and the last of
/// the bottom row, at 2/3.
QVector<float> depths()
{
    QVector<float> values(qsizetype(kWidth) * kHeight, 1.0f);
    values[1] = 0.0f;
    values[11] = 2.0f / 3.0f;
    return values;
}

bool isClose(const QVector<float> &values, const QVector<float> &expected)
{
    if (values.size() != expected.size())
        return false;
    for (int i = 0; i < values.size(); ++i) {
        if (!(std::abs(values[i] - expected[i]) <= 1e-5f))
            return false;
    }
    return true;
}

/// The points of `depths`: at the distances 1 and 2, x and y at pixel centres.
const QVector<float> kPoints{-0.5f, 1.0f, 4.0f, 3.0f, -2.0f, 3.0f};

QByteArray pfm(const QVector<float> &values, bool isLittleEndian)
{
    QByteArray bytes = isLittleEndian ? "Pf\n4 3\n-1.0\n" : "Pf\n# from the bottom\n4 3\n1.0\n";
    for (int row = kHeight - 1; row >= 0; --row) {
        for (int i = 0; i < kWidth; ++i) {
            QByteArray number = bytesOf(QVector<float>{values[row * kWidth + i]});
            if (!isLittleEndian)
                std::reverse(number.begin(), number.end());
            bytes += number;
        }
    }
    return bytes;
}

QByteArray pgm(const QVector<float> &values)
{
    QByteArray bytes("P5\n4 3\n65535\n");
    for (const float value : values) {
        const int rounded = int(std::lround(value * 65535.0f));
        bytes += char(rounded >> 8);
        bytes += char(rounded & 0xff);
    }
    return bytes;
}

} // namespace

class TestCloudCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kScene); }

    void everyFormatGivesTheSamePoints_data()
    {
        addColumn<QByteArray>("image");
        addColumn<QStringList>("options");
        newRow("raw floats") << bytesOf(depths()) << QStringList{"--size", "4x3"};
        newRow("raw floats, by the matrix") << bytesOf(depths()) << QStringList{"--size", "4x3", "--method", "matrix"};
        newRow("PFM, little-endian") << pfm(depths(), true) << QStringList{};
        newRow("PFM, big-endian") << pfm(depths(), false) << QStringList{};
        newRow("PFM, size given too") << pfm(depths(), true) << QStringList{"--size", "4x3"};
        newRow("PGM, 16 bits") << pgm(depths()) << QStringList{"--depth-is", "buffer"};
    }

    void everyFormatGivesTheSamePoints()
    {
        QFETCH(QByteArray, image);
        QFETCH(QStringList, options);
        const QString output = m_folder.path("out.ply");
        const Run run =
            runCommand(QStringList{"cloud", m_scene, m_folder.write("depth", image), "-o", output} + options);
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.errors, output.toUtf8() + ": 2 points of 12 pixels\n"); // the others are background
        QFile file(output);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray ply = file.readAll();
        QVERIFY(ply.startsWith("ply\nformat binary_little_endian 1.0\n"));
        QVERIFY(ply.contains("element vertex 2\n"));
        // 16 bits tell depths apart by 1/65535, which near 2/3 is 5e-5 of the distance.
        if (image.startsWith("P5"))
            QCOMPARE(pointsOf(ply).size(), kPoints.size());
        else
            QVERIFY(isClose(pointsOf(ply), kPoints));
    }

    void numbersMeanTheSameInEveryFormat_data()
    {
        addColumn<QByteArray>("range");
        addColumn<float>("number");
        addColumn<QStringList>("options");
        addColumn<float>("share"); // of the way from the near plane's depth to the far plane's
        newRow("depths of the window") << QByteArray("[0, 0.5]") << 0.25f << QStringList{} << 0.5f;
        newRow("so they are called") << QByteArray("[0, 0.5]") << 0.25f << QStringList{"--depth-is", "buffer"} << 0.5f;
        newRow("reversed") << QByteArray("[0.5, 0]") << 0.4f << QStringList{} << 0.2f;
        newRow("over the range") << QByteArray("[0, 0.5]") << 0.25f << QStringList{"--depth-is", "range"} << 0.25f;
        newRow("over a range that begins later")
            << QByteArray("[0.5, 1]") << 0.25f << QStringList{"--depth-is", "range"} << 0.25f;
        newRow("over a reversed range") << QByteArray("[0.5, 0]") << 0.25f << QStringList{"--depth-is", "range"}
                                        << 0.75f;
    }

    void numbersMeanTheSameInEveryFormat()
    {
        QFETCH(QByteArray, range);
        QFETCH(float, number);
        QFETCH(QStringList, options);
        QFETCH(float, share);
        QByteArray scene = kScene;
        scene.replace("\"window\"", "\"depthRange\": " + range + ", \"window\"");
        const QString file = m_folder.write("range.json", scene);
        const QVector<float> values(qsizetype(kWidth) * kHeight, number);
        const float distance = 4.0f / (4.0f - 3.0f * share); // n f / (f - d (f - n))
        for (const QByteArray &image : {bytesOf(values), pfm(values, true), pfm(values, false), pgm(values)}) {
            const QString depth = m_folder.write("depth", image);
            const Run run = runCommand(QStringList{"cloud", "--size", "4x3", file, depth, "-o", "-"} + options);
            QCOMPARE(run.exitCode, 0); // of whole numbers the assumed meaning is reported
            const QVector<float> points = pointsOf(run.output);
            QCOMPARE(points.size(), 3 * values.size());
            QVERIFY2(std::abs(points[2] - (5.0f - distance)) < 1e-3f,
                     qPrintable(QString::number(points[2]))); // 16 bits
        }
    }

    void backgroundAndNonsenseAreLeftOut()
    {
        QVector<float> values = depths();
        values[0] = std::numeric_limits<float>::quiet_NaN();
        values[2] = -0.5f;
        values[3] = 1.5f;
        values[4] = std::numeric_limits<float>::infinity();
        const QString image = m_folder.write("depth", bytesOf(values));
        const Run run = runCommand({"cloud", "--size", "4x3", m_scene, image, "-o", "-"});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(isClose(pointsOf(run.output), kPoints));
    }

    /// Floats of the size of a map's coordinates are half a metre apart.
    void aLargeWorldNeedsDoubles()
    {
        QByteArray scene = kScene;
        scene.replace("[0, 0, 5]", "[5000000, 0, 5]").replace("[0, 0, 0]", "[5000000, 0, 0]");
        const QString file = m_folder.write("map.json", scene), image = m_folder.write("depth", pfm(depths(), true));
        const Run run = runCommand({"cloud", "--precision", "double", file, image, "-o", "-"});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.output.contains("\nproperty double x\nproperty double y\nproperty double z\n"));
        const QVector<double> points = pointsOf<double>(run.output);
        QCOMPARE(points.size(), qsizetype(6));
        QCOMPARE(points[0], 5000000.0 - 0.5);
        QVERIFY(std::abs(points[3] - 5000003.0) < 1e-6
                && std::abs(points[5] - 3.0) < 1e-6); // the depth is a float's 2/3
    }

    void whatFloatsRoundIsSaid()
    {
        QByteArray scene = kScene;
        scene.replace("[0, 0, 5]", "[5000000, 0, 5]").replace("[0, 0, 0]", "[5000000, 0, 0]");
        const QString file = m_folder.write("map.json", scene), image = m_folder.write("depth", pfm(depths(), true));
        const Run run = runCommand({"cloud", file, image, "-o", "-"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.errors, image.toUtf8()
                                 + ": so far from the origin single precision rounds coordinates by up to 0.25; "
                                   "--precision double keeps them\n");
        const Run piped = runCommand({"cloud", file, "-", "-o", "-"}, pfm(depths(), true));
        QVERIFY2(piped.errors.startsWith("stdin: so far from the origin"), piped.errors.constData());
        QCOMPARE(runCommand({"cloud", "--precision", "double", file, image, "-o", "-"}).errors, QByteArray());
        QCOMPARE(runCommand({"cloud", m_scene, image, "-o", "-"}).errors, QByteArray());
    }

    void whatIsBeyondFloatsIsSaid()
    {
        QByteArray scene = kScene;
        scene.replace("\"left\": -2, \"right\": 2", "\"left\": -2e39, \"right\": 2e39");
        const QString file = m_folder.write("wide.json", scene), image = m_folder.write("depth", pfm(depths(), true));
        const Run run = runCommand({"cloud", file, image, "-o", "-"});
        QCOMPARE(run.exitCode, 1);
        QVERIFY(run.errors.contains("2 points lie beyond the range of single precision"));
        QVERIFY(run.output.contains("element vertex 0\n"));
        const Run piped = runCommand({"cloud", file, "-", "-o", "-"}, pfm(depths(), true));
        QVERIFY2(piped.errors.contains("stdin: 2 points lie beyond the range"), piped.errors.constData());
        const Run inDouble = runCommand({"cloud", "--precision", "double", file, image, "-o", "-"});
        QCOMPARE(inDouble.exitCode, 0);
        QCOMPARE(pointsOf<double>(inDouble.output).value(0), -5e38);
    }

    void standardStreams()
    {
        const Run run = runCommand({"cloud", m_scene, "-", "-o", "-"}, pfm(depths(), true));
        QCOMPARE(run.exitCode, 0);
        QVERIFY(isClose(pointsOf(run.output), kPoints));
    }

    void aScaleIsNotApplied()
    {
        const QByteArray image = pfm(depths(), true);
        const Run one = runCommand({"cloud", m_scene, m_folder.write("one.pfm", image), "-o", "-"});
        const QString scaled = m_folder.write("scaled.pfm", QByteArray(image).replace("-1.0", "-2.5"));
        const Run other = runCommand({"cloud", m_scene, scaled, "-o", "-"});
        QCOMPARE(one.errors, QByteArray());
        QCOMPARE(other.errors,
                 scaled.toUtf8()
                     + ": the header has the scale 2.5, which is not applied: the depths are used unchanged\n");
        QCOMPARE(other.output, one.output);
        QCOMPARE(other.exitCode, 0);
    }

    void unusableInput_data()
    {
        addColumn<QByteArray>("image");
        addColumn<QStringList>("options");
        addColumn<QByteArray>("message");
        const QByteArray raw = bytesOf(depths());
        newRow("raw without a size") << raw << QStringList{} << QByteArray("--size");
        newRow("no size") << raw << QStringList{"--size", "4by3"} << QByteArray("as in 800x600");
        newRow("no pixels") << raw << QStringList{"--size", "0x3"} << QByteArray("at least 1 pixel");
        newRow("other size than the window") << raw << QStringList{"--size", "3x4"} << QByteArray("window 4x3");
        newRow("too short") << raw.chopped(1) << QStringList{"--size", "4x3"} << QByteArray("too short");
        newRow("too long") << raw + '\0' << QStringList{"--size", "4x3"} << QByteArray("too long");
        newRow("empty") << QByteArray() << QStringList{"--size", "4x3"} << QByteArray("too short");
        newRow("broken header") << QByteArray("Pf\n4 x\n-1\n") << QStringList{} << QByteArray("header");
        newRow("PFM of scale 0") << QByteArray("Pf\n4 3\n0\n") << QStringList{} << QByteArray("header");
        newRow("PGM with more than the greatest value")
            << QByteArray("P5\n4 3\n100\n") + QByteArray(6, '\x64') + '\x65' + QByteArray(5, '\0') << QStringList{}
            << QByteArray(
                   "depth: the pixel in column 2 and row 1 has the value 101, and the header says that 100 is the "
                   "greatest");
        newRow("enormous") << QByteArray("P5\n65000 65000\n65535\n") << QStringList{} << QByteArray("window 4x3");
        newRow("size against the header")
            << pfm(depths(), true) << QStringList{"--size", "3x4"} << QByteArray("not 3x4");
        newRow("both methods") << raw << QStringList{"--size", "4x3", "--method", "both"}
                               << QByteArray("formula, matrix");
    }

    void unusableInput()
    {
        QFETCH(QByteArray, image);
        QFETCH(QStringList, options);
        QFETCH(QByteArray, message);
        const Run run = runCommand(QStringList{"cloud", m_scene, m_folder.write("depth", image), "-o", "-"} + options);
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QVERIFY2(run.errors.contains(message), run.errors.constData());
    }

private:
    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestCloudCommand)
#include "test_cloud_command.moc"
