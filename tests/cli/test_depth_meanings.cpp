// `unproject cloud`: distances and disparities against formulas of their own, and what is left out.

#include "tests/support/test.h"

#include "tests/cli/depth_files.h"

#include <array>
#include <cmath>
#include <limits>

namespace {

using Vector = std::array<long double, 3>;

Vector operator-(const Vector &a, const Vector &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector &a, const Vector &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector &a)
{
    const long double size = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    return {a[0] / size, a[1] / size, a[2] / size};
}

constexpr int kWidth = 64, kHeight = 48;
const Vector kEye{3, -4, 5}, kCenter{-1, 2, 0.5L}, kUp{0, 0, 1};
constexpr long double kLeft = -1.25L, kRight = 0.75L, kBottom = -0.5L, kTop = 1, kNear = 1.5L;

/// A scene of 64 x 48 pixels. @param projection  its type and its angles
QByteArray sceneOf(const QByteArray &projection)
{
    return R"({"unprojector": 1, "window": {"width": 64, "height": 48}, "projection": {)" + projection
           + R"(, "left": -1.25, "right": 0.75, "bottom": -0.5, "top": 1, "near": 1.5, "far": 2000},
  "view": {"eye": [3, -4, 5], "center": [-1, 2, 0.5], "up": [0, 0, 1]}})";
}

/// The point at x, y, z of eye space, z ahead.
Vector world(long double x, long double y, long double z)
{
    const Vector ahead = unit(kCenter - kEye), side = unit(cross(ahead, kUp)), up = cross(side, ahead);
    Vector point{};
    for (std::size_t k = 0; k < 3; ++k)
        point[k] = kEye[k] + x * side[k] + y * up[k] + z * ahead[k];
    return point;
}

/// From 3.6 to about 1900, on each pixel another.
double numberOf(int pixel)
{
    return 3.6 + 0.618 * pixel;
}

enum class Kind { Frustum, Ortho, Oblique };

/// The point of a pixel whose number means z, a distance or a disparity.
Vector pointOf(Kind kind, const QString &meaning, int pixel, long double number)
{
    const long double i = pixel % kWidth + 0.5L, j = pixel / kWidth + 0.5L;
    const long double across = kLeft + (kRight - kLeft) * i / kWidth, up = kTop - (kTop - kBottom) * j / kHeight;
    const long double fx = kWidth * kNear / (kRight - kLeft);
    if (kind == Kind::Frustum) {
        const long double x = across / kNear, y = up / kNear;
        const long double z = meaning == "disparity"  ? fx * 0.125L / number
                              : meaning == "distance" ? number / std::sqrt(1 + x * x + y * y)
                                                      : number;
        return world(x * z, y * z, z);
    }
    // Angles of 60 and 45 degrees: points move by their cotangents with the distance.
    const long double a = kind == Kind::Oblique ? 1 / std::sqrt(3.0L) : 0, b = kind == Kind::Oblique ? 1 : 0;
    const long double z = meaning == "distance" ? number / std::sqrt(1 + a * a + b * b) : number;
    return world(across + a * z, up + b * z, z);
}

} // namespace

class TestDepthMeanings : public QObject {
    Q_OBJECT

private slots:
    void pointsLieOnThePixelsRay_data()
    {
        addColumn<QByteArray>("projection");
        addColumn<int>("kind");
        addColumn<QString>("meaning");
        addColumn<QString>("method");
        struct Lens {
            const char *name, *json;
            Kind kind;
        };
        for (const Lens &lens :
             {Lens{"frustum", R"("type": "frustum")", Kind::Frustum}, Lens{"ortho", R"("type": "ortho")", Kind::Ortho},
              Lens{"oblique", R"("type": "oblique", "theta": 60, "phi": 45)", Kind::Oblique}}) {
            for (const char *method : {"formula", "matrix"}) {
                for (const char *meaning : {"z", "distance", "disparity"}) {
                    if (lens.kind == Kind::Frustum || qstrcmp(meaning, "disparity") != 0)
                        addRow("%s, %s, %s", lens.name, meaning, method)
                            << QByteArray(lens.json) << int(lens.kind) << QString(meaning) << QString(method);
                }
            }
        }
    }

    /// Largest error: 1e-12 of the point's size. A detour through window depths of near 1.5 and far
    /// 2000 would lose four digits.
    void pointsLieOnThePixelsRay()
    {
        QFETCH(QByteArray, projection);
        QFETCH(int, kind);
        QFETCH(QString, meaning);
        QFETCH(QString, method);
        QVector<double> numbers;
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel)
            numbers << (meaning == "disparity" ? 6.0 / numberOf(pixel) : numberOf(pixel));
        QStringList words{"cloud",
                          m_folder.write("scene.json", sceneOf(projection)),
                          m_folder.write("depth.npy", npy(npyHeader("<f8", "(48, 64)"), bytesOf(numbers))),
                          "-o",
                          "-",
                          "--precision",
                          "double",
                          "--depth-is",
                          meaning,
                          "--method",
                          method};
        if (meaning == "disparity")
            words << "--baseline"
                  << "0.125";
        const Run run = runCommand(words);
        QCOMPARE(run.errors, QByteArray());
        const QVector<double> points = pointsOf<double>(run.output);
        QCOMPARE(points.size(), 3 * numbers.size());
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
            const Vector expected = pointOf(Kind(kind), meaning, pixel, numbers[pixel]);
            const Vector fromEye = expected - kEye;
            const long double size = std::hypot(fromEye[0], fromEye[1], fromEye[2]) + 10;
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY2(std::abs(points[3 * pixel + axis] - expected[std::size_t(axis)]) < 1e-12L * size,
                         qPrintable(QString::number(pixel)));
        }
    }

    /// Floats are doubles: the same points to the last digit.
    void floatsAreExact()
    {
        QVector<float> floats;
        QVector<double> doubles;
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
            floats << float(numberOf(pixel));
            doubles << double(floats.back());
        }
        const QString scene = m_folder.write("scene.json", sceneOf(R"("type": "frustum")"));
        const QString ofFloats = m_folder.write("a.npy", npy(npyHeader("<f4", "(48, 64)"), bytesOf(floats))),
                      ofDoubles = m_folder.write("b.npy", npy(npyHeader("<f8", "(48, 64)"), bytesOf(doubles)));
        const QStringList options{"-o", "-", "--precision", "double", "--depth-is", "z"};
        const Run run = runCommand(QStringList{"cloud", scene, ofFloats} + options);
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.output, runCommand(QStringList{"cloud", scene, ofDoubles} + options).output);
    }

    /// Millimetres of 16 bits.
    void scaleDividesTheNumbers()
    {
        QVector<quint16> millimetres;
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel)
            millimetres << quint16(1600 + 20 * pixel);
        const Run run = runCommand({"cloud", m_folder.write("scene.json", sceneOf(R"("type": "frustum")")),
                                    m_folder.write("mm.npy", npy(npyHeader("<u2", "(48, 64)"), bytesOf(millimetres))),
                                    "-o", "-", "--precision", "double", "--depth-is", "z", "--depth-scale", "1000"});
        QCOMPARE(run.errors, QByteArray());
        const QVector<double> points = pointsOf<double>(run.output);
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
            const Vector expected = pointOf(Kind::Frustum, "z", pixel, millimetres[pixel] / 1000.0L);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(std::abs(points[3 * pixel + axis] - expected[std::size_t(axis)]) < 1e-12L * 100);
        }
    }

    /// As in the sets of Middlebury, whose second camera has another cx. Disparities below 0 have points, too.
    void anOffsetIsAddedToDisparities()
    {
        QVector<float> sixteenths;
        QVector<long double> sums;
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
            sixteenths << float(16.0 * (6.0 / numberOf(pixel) - 3.2));
            sums << sixteenths.back() / 16.0L + 3.2L;
        }
        const Run run = runCommand({"cloud", m_folder.write("scene.json", sceneOf(R"("type": "frustum")")),
                                    m_folder.write("d.npy", npy(npyHeader("<f4", "(48, 64)"), bytesOf(sixteenths))),
                                    "-o", "-", "--precision", "double", "--depth-is", "disparity", "--baseline",
                                    "0.125", "--depth-scale", "16", "--disparity-offset", "3.2"});
        QCOMPARE(run.errors, QByteArray());
        const QVector<double> points = pointsOf<double>(run.output);
        QCOMPARE(points.size(), qsizetype(3 * kWidth * kHeight));
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
            const Vector expected = pointOf(Kind::Frustum, "disparity", pixel, sums[pixel]);
            // The sum keeps the rounding of its terms, and the point is that of its reciprocal.
            const long double tolerance = 1e-12L * 2000 / (sums[pixel] / 3.2L);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY2(std::abs(points[3 * pixel + axis] - expected[std::size_t(axis)]) < tolerance,
                         qPrintable(QString::number(pixel)));
        }
    }

    void theGreatestNumberIsANote_data()
    {
        addColumn<QStringList>("options");
        addColumn<int>("count"); // of pixels with the greatest number
        addColumn<bool>("isByte");
        addColumn<QByteArray>("message");
        const QStringList z{"--depth-is", "z", "--depth-scale", "1000"};
        const QByteArray why(" Many cameras write it where they measure nothing: --no-data ");
        newRow("two of 16 bits") << z << 2 << false
                                 << "2 pixels have a point by the greatest possible number, 65535." + why
                                        + "65535 leaves them out\n";
        newRow("one of 8 bits") << QStringList{"--depth-is", "distance", "--depth-scale", "2"} << 1 << true
                                << "1 pixel has a point by the greatest possible number, 255." + why
                                       + "255 leaves it out\n";
        newRow("none") << z << 0 << false << QByteArray();
        newRow("behind the far plane") << QStringList{"--depth-is", "z"} << 2 << false
                                       << QByteArray("left out: 2 on the far plane (2000) or behind it\n");
        newRow("named") << z + QStringList{"--no-data", "65535"} << 2 << false
                        << QByteArray("left out: 2 with a number that means no measurement\n");
    }

    void theGreatestNumberIsANote()
    {
        QFETCH(QStringList, options);
        QFETCH(int, count);
        QFETCH(bool, isByte);
        QFETCH(QByteArray, message);
        constexpr int kPixels = kWidth * kHeight;
        QVector<quint16> words(kPixels, 1900);
        QVector<quint8> bytes(kPixels, 100);
        std::fill_n(words.begin() + 70, count, quint16(65535));
        std::fill_n(bytes.begin() + 70, count, quint8(255));
        const QString depth = m_folder.write("depth.npy", isByte ? npy(npyHeader("|u1", "(48, 64)"), bytesOf(bytes))
                                                                 : npy(npyHeader("<u2", "(48, 64)"), bytesOf(words)));
        const Run run = runCommand(
            QStringList{"cloud", m_folder.write("scene.json", sceneOf(R"("type": "frustum")")), depth, "-o", "-"}
            + options);
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.errors, message.isEmpty() ? message : depth.toUtf8() + ": " + message);
        QCOMPARE(pointsOf(run.output).size(), qsizetype(3 * (kPixels - (message.startsWith("left out") ? count : 0))));
    }

    void theOtherByteOrderIsANote_data()
    {
        addColumn<QString>("numbers");
        addColumn<bool>("isSwapped"); // against the format's byte order
        addColumn<bool>("isRaw");
        addColumn<QString>("named"); // by the note
        newRow("PGM") << "surface" << false << false << "";
        newRow("PGM, little-endian") << "surface" << true << false << "little";
        newRow("PGM, noise") << "noise" << false << false << "";
        newRow("PGM, 8 bits in the upper byte") << "upper" << false << false << "";
        newRow("PGM, 255 in the lower byte") << "upper and 255" << false << false << "";
        newRow("PGM, one number") << "flat" << true << false << "";
        newRow("raw") << "surface" << false << true << "";
        newRow("raw, big-endian") << "surface" << true << true << "big";
        newRow("raw, noise") << "noise" << false << true << "";
    }

    /// The depths of a floor and of a box before it, in millimetres, some without a measurement.
    void theOtherByteOrderIsANote()
    {
        QFETCH(QString, numbers);
        QFETCH(bool, isSwapped);
        QFETCH(bool, isRaw);
        QFETCH(QString, named);
        QVector<quint16> words;
        QVector<float> floats;
        quint32 random = 1;
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
            const int i = pixel % kWidth, j = pixel / kWidth;
            random = random * 1664525u + 1013904223u;
            const bool isBox = i > 20 && i < 40 && j > 10 && j < 30;
            const int surface = (isBox ? 1700 : 2500) + 6 * i - 9 * j + int(random >> 30);
            const int upper = (100 + i + j / 2) << 8;
            int number = numbers == "noise"           ? int(random >> 16) | 1
                         : numbers == "upper"         ? upper
                         : numbers == "upper and 255" ? upper | 255
                         : numbers == "flat"          ? 2500
                         : pixel % 37 == 0            ? 0
                         : pixel % 41 == 0 && !isRaw  ? 65535
                                                      : surface;
            words << quint16(number);
            floats << float(number) / 1000;
        }
        const QByteArray bytes = isRaw ? (isSwapped ? swapped(floats) : bytesOf(floats))
                                       : "P5 64 48 65535\n" + (isSwapped ? bytesOf(words) : swapped(words));
        const QString depth = m_folder.write("depth", bytes);
        QStringList given{"cloud",       m_folder.write("scene.json", sceneOf(R"("type": "frustum")")),
                          depth,         "-o",
                          "-",           "--depth-is",
                          "z",           "--no-data",
                          "65535,65.535"};
        if (isRaw)
            given << "--size"
                  << "64x48";
        else
            given << "--depth-scale"
                  << "1000";
        const QByteArray note =
            "depth: in the other byte order the image is far smoother; if the depths are wrong, give ";
        const Run run = runCommand(given);
        QCOMPARE(run.errors.contains(note), !named.isEmpty());
        if (named.isEmpty())
            return;
        QVERIFY2(run.errors.contains(note + named.toUtf8() + " by --byte-order\n"), run.errors.constData());
        const Run turned = runCommand(given + QStringList{"--byte-order", named});
        QVERIFY2(!turned.errors.contains("byte order"), turned.errors.constData());
        const QString right = m_folder.write("right.npy", isRaw ? npy(npyHeader("<f4", "(48, 64)"), bytesOf(floats))
                                                                : npy(npyHeader("<u2", "(48, 64)"), bytesOf(words)));
        given[2] = right;
        QCOMPARE(turned.output, runCommand(given).output);
        QVERIFY(pointsOf(turned.output).size() > 2 * kWidth * kHeight);
    }

    void whatHasNoPointIsCounted_data()
    {
        constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(),
                        kInfinity = std::numeric_limits<float>::infinity();
        addColumn<QStringList>("options");
        addColumn<QVector<float>>("bad");
        addColumn<QByteArray>("message");
        const QVector<float> all{0, 0, kNaN, kInfinity, -kInfinity, -3, 1.25f, 2000, 2001, 1.5f};
        newRow("z") << QStringList{"--depth-is", "z"} << all
                    << QByteArray("2 with 0, 1 with NaN, 2 infinite, 1 below 0, 1 before the near plane (1.5), 2 on "
                                  "the far plane (2000) or behind it\n");
        newRow("distance") << QStringList{"--depth-is", "distance"} << QVector<float>{0, 1, 4000}
                           << QByteArray("1 with 0, 1 before the near plane (1.5), 1 on the far plane (2000) or "
                                         "behind it\n");
        newRow("disparity") << QStringList{"--depth-is", "disparity", "--baseline", "0.125"}
                            << QVector<float>{0, -1, kInfinity, 100, 0.001f}
                            << QByteArray("1 with 0, 1 infinite, 1 below 0, 1 before the near plane (1.5), 1 on the "
                                          "far plane (2000) or behind it\n");
        newRow("buffer") << QStringList{} << QVector<float>{kNaN, -0.5f, 1.5f, -kInfinity, 1, 1}
                         << QByteArray("1 with NaN, 1 infinite, 2 outside the depth range, 2 with the background's "
                                       "depth\n");
        newRow("range") << QStringList{"--depth-is", "range"} << QVector<float>{1.5f, 1}
                        << QByteArray("1 outside the depth range, 1 with the background's depth\n");
        newRow("disparity with an offset")
            << QStringList{"--depth-is", "disparity", "--baseline", "0.125", "--disparity-offset", "1"}
            << QVector<float>{0, -1.5f, -0.999f}
            << QByteArray("1 with 0, 1 below 0, 1 on the far plane (2000) or behind it\n");
        newRow("no data, z") << QStringList{"--depth-is", "z", "--no-data", "-9999,0.1,7"}
                             << QVector<float>{7, -9999, 0.1f, 0, 7, -3}
                             << QByteArray("4 with a number that means no measurement, 1 with 0, 1 below 0\n");
        newRow("no data, buffer") << QStringList{"--no-data", "0.1"} << QVector<float>{0.1f, 1}
                                  << QByteArray("1 with a number that means no measurement, 1 with the background's "
                                                "depth\n");
        newRow("background alone") << QStringList{} << QVector<float>{1, 1} << QByteArray();
    }

    void whatHasNoPointIsCounted()
    {
        QFETCH(QStringList, options);
        QFETCH(QVector<float>, bad);
        QFETCH(QByteArray, message);
        const bool isOfWindow = !options.contains("--depth-is") || options.contains("range");
        const float good = isOfWindow ? 0.5f : options.contains("disparity") ? 2.0f : 4.0f;
        QVector<float> values(qsizetype(kWidth) * kHeight, good);
        std::copy(bad.begin(), bad.end(), values.begin() + 100);
        qsizetype kept = values.size();
        for (const float value : bad)
            kept -= options.value(1) == "z" && value == 1.5f ? 0 : 1; // the near plane itself
        const QString scene = m_folder.write("scene.json", sceneOf(R"("type": "frustum")")),
                      depth = m_folder.write("depth", bytesOf(values));
        for (const QString method : {"formula", "matrix"}) {
            const Run run = runCommand(
                QStringList{"cloud", scene, depth, "--size", "64x48", "-o", "-", "--method", method} + options);
            QCOMPARE(run.exitCode, 0);
            QCOMPARE(run.errors, message.isEmpty() ? message : depth.toUtf8() + ": left out: " + message);
            QCOMPARE(pointsOf(run.output).size(), 3 * kept);
        }
    }

    /// Millimetres taken for world units.
    void anEmptyCloudNamesTheScale()
    {
        const QVector<quint16> values(qsizetype(kWidth) * kHeight, quint16(2400));
        const Run run = runCommand({"cloud", m_folder.write("scene.json", sceneOf(R"("type": "frustum")")),
                                    m_folder.write("mm.npy", npy(npyHeader("<u2", "(48, 64)"), bytesOf(values))), "-o",
                                    "-", "--depth-is", "z"});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.errors.contains("mm.npy: no pixel has a point: the scene shows distances from 1.5 to 2000; check "
                                     "--depth-is and --depth-scale\n"),
                 run.errors.constData());
    }

    void anAssumedMeaningIsSaid()
    {
        const QString scene = m_folder.write("scene.json", sceneOf(R"("type": "frustum")"));
        const QVector<quint16> whole(qsizetype(kWidth) * kHeight, quint16(2400));
        const QString file = m_folder.write("mm.npy", npy(npyHeader("<u2", "(48, 64)"), bytesOf(whole)));
        const QStringList words{"cloud", scene, file, "-o", "-"};
        QCOMPARE(
            runCommand(words).errors,
            file.toUtf8()
                + ": the whole numbers are taken for depths of the window, as shares of 65535 (--depth-is buffer); for "
                  "distances give --depth-is z or distance\n");
        QCOMPARE(runCommand(words + QStringList{"--depth-is", "buffer"}).errors, QByteArray());
        const QString metres = m_folder.write("metres", bytesOf(QVector<float>(kWidth * kHeight, 2.5f)));
        const Run run = runCommand({"cloud", scene, metres, "--size", "64x48", "-o", "-"});
        QCOMPARE(run.errors, metres.toUtf8() + ": left out: 3072 outside the depth range\n" + metres.toUtf8()
                                 + ": no pixel has a point: depths of the window lie from 0 to 1; for distances give "
                                   "--depth-is z or distance\n");
    }

    void optionsThatContradict_data()
    {
        addColumn<QStringList>("options");
        addColumn<QByteArray>("message");
        newRow("scale of depths") << QStringList{"--depth-scale", "1000"} << QByteArray("--depth-scale goes with");
        newRow("no baseline") << QStringList{"--depth-is", "disparity"} << QByteArray("needs --baseline");
        newRow("baseline of z") << QStringList{"--depth-is", "z", "--baseline", "1"}
                                << QByteArray("--baseline goes with --depth-is disparity");
        newRow("offset of z") << QStringList{"--depth-is", "z", "--disparity-offset", "1"}
                              << QByteArray("--disparity-offset goes with --depth-is disparity");
        newRow("no data, a word") << QStringList{"--depth-is", "z", "--no-data", "0,none"}
                                  << QByteArray("\"none\" is not a finite number");
        newRow("scale 0") << QStringList{"--depth-is", "z", "--depth-scale", "0"}
                          << QByteArray("\"0\" is not a number above 0");
        newRow("no such meaning") << QStringList{"--depth-is", "metres"}
                                  << QByteArray("buffer, disparity, distance, range, z");
        newRow("disparity of a box") << QStringList{"--depth-is", "disparity", "--baseline", "1"}
                                     << QByteArray("a parallel projection has no disparities");
    }

    void optionsThatContradict()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, message);
        const QString scene = m_folder.write("scene.json", sceneOf(R"("type": "ortho")")),
                      depth = m_folder.write("depth", bytesOf(QVector<float>(kWidth * kHeight, 2.0f)));
        const Run run = runCommand(QStringList{"cloud", scene, depth, "--size", "64x48", "-o", "-"} + options);
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QVERIFY2(run.errors.contains(message), run.errors.constData());
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestDepthMeanings)
#include "test_depth_meanings.moc"
