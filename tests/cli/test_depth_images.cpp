// `unproject cloud`: depth images of every format, their colors, and damaged ones.

#include "tests/support/test.h"

#include "tests/cli/library_images.h"

#include <QBuffer>
#include <QImage>
#include <QImageWriter>

#include <cmath>
#include <functional>
#include <limits>

namespace {

/// 4 x 3 pixels; eye (0, 0, 5), looking down -z; x = (i - 1.5) z, y = (1 - j) z.
const QByteArray kScene = R"({"unprojector": 1, "window": {"width": 4, "height": 3},
  "projection": {"type": "frustum", "left": -2, "right": 2, "bottom": -1.5, "top": 1.5, "near": 1, "far": 400},
  "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}})";
/// The points of numbers() as distances along the axis.
QVector<double> expectedPoints()
{
    QVector<double> points;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const double z = 2 + 7 * i;
        points << (i % kWidth - 1.5) * z << (1 - i / kWidth) * z << 5 - z;
    }
    return points;
}

template <class Number>
QByteArray npyOf(const char *type, const char *shape = "(3, 4)")
{
    return npy(npyHeader(type, shape), bytesOf(numbers<Number>()));
}

template <class Number>
QByteArray npySwapped(const char *type)
{
    return npy(npyHeader(type, "(3, 4)"), swapped(numbers<Number>()));
}

/// Column after column.
QByteArray npyInFortranOrder()
{
    QVector<float> columns;
    for (int i = 0; i < kWidth; ++i) {
        for (int j = 0; j < kHeight; ++j)
            columns << numbers<float>()[j * kWidth + i];
    }
    return npy(npyHeader("<f4", "(3, 4)", true), bytesOf(columns));
}

QByteArray pgm(int greatest)
{
    QByteArray bytes = "P5\n4 3\n" + QByteArray::number(greatest) + "\n";
    for (const int number : numbers<int>()) {
        if (greatest > 255)
            bytes += '\0';
        bytes += char(number);
    }
    return bytes;
}

/// Returns whether Qt has its plugin for JPEG.
[[maybe_unused]] bool writesJpeg()
{
    return QImageWriter::supportedImageFormats().contains("jpg");
}

QByteArray encoded(const QImage &image, const char *format)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, format))
        qFatal("Qt writes no %s", format);
    return bytes;
}

[[maybe_unused]] QByteArray grayPng(QImage::Format format)
{
    QImage image(kWidth, kHeight, format);
    for (int j = 0; j < kHeight; ++j) {
        for (int i = 0; i < kWidth; ++i) {
            const int number = numbers<int>()[j * kWidth + i];
            if (format == QImage::Format_Grayscale16)
                reinterpret_cast<quint16 *>(image.scanLine(j))[i] = quint16(number);
            else
                image.scanLine(j)[i] = uchar(number);
        }
    }
    return encoded(image, "png");
}

/// The colors (20 i, 30 j, 200).
[[maybe_unused]] QImage colors(int width = kWidth)
{
    QImage image(width, kHeight, QImage::Format_RGB888);
    for (int j = 0; j < kHeight; ++j) {
        for (int i = 0; i < width; ++i)
            image.setPixel(i, j, qRgb(20 * i, 30 * j, 200));
    }
    return image;
}

/// numbers<quint16>() as a PNG of Adam7, by ImageMagick.
const QByteArray kInterlacedPng = QByteArray::fromBase64(
    "iVBORw0KGgoAAAANSUhEUgAAAAQAAAADEAAAAAG2CB3PAAAAJklEQVQI12NgYGJgEGBksGLgY2TgZOBjYbBg4GNkkGNgZ2Bn"
    "YAcADg4A8qfPKcoAAAAASUVORK5CYII=");

} // namespace

class TestDepthImages : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kScene); }

    void everyFormatGivesTheNumbers_data()
    {
        addColumn<QByteArray>("image");
        newRow("raw") << bytesOf(numbers<float>());
        newRow("PGM, 8 bits") << pgm(255);
        newRow("PGM, 16 bits") << pgm(65535);
        newRow("COLMAP") << "4&3&1&" + bytesOf(numbers<float>());
        newRow("npy, floats") << npyOf<float>("<f4");
        newRow("npy, doubles") << npyOf<double>("<f8");
        newRow("npy, halves") << npyOf<Half>("<f2");
        newRow("npy, 8 bits") << npyOf<quint8>("|u1");
        newRow("npy, 8 bits, signed") << npyOf<qint8>("|i1");
        newRow("npy, 16 bits") << npyOf<quint16>("<u2");
        newRow("npy, 16 bits, signed") << npyOf<qint16>("<i2");
        newRow("npy, 32 bits") << npyOf<quint32>("<u4");
        newRow("npy, 32 bits, signed") << npyOf<qint32>("<i4");
        newRow("npy, 64 bits") << npyOf<quint64>("<u8");
        newRow("npy, 64 bits, signed") << npyOf<qint64>("<i8");
        newRow("npy, floats, big-endian") << npySwapped<float>(">f4");
        newRow("npy, doubles, big-endian") << npySwapped<double>(">f8");
        newRow("npy, 16 bits, big-endian") << npySwapped<quint16>(">u2");
        newRow("npy, Fortran order") << npyInFortranOrder();
        newRow("npy, (H, W, 1)") << npyOf<float>("<f4", "(3, 4, 1)");
        newRow("npy, (1, H, W)") << npyOf<float>("<f4", "(1, 3, 4)");
        QByteArray second = npyOf<float>("<f4"); // a length of four bytes
        second[6] = 2;
        second.insert(10, QByteArray(2, '\0'));
        newRow("npy, version 2") << second;
        const auto withHeader = [](const char *header) { return npy(header, bytesOf(numbers<float>())); };
        newRow("npy, blanks before commas")
            << withHeader("{'descr': '<f4' , 'fortran_order' : False , 'shape': (3 , 4) , }");
        newRow("npy, no blanks, other order")
            << withHeader("{\"shape\":(3,4),\"fortran_order\":False,\"descr\":\"<f4\"}");
        addLibraryFormats();
    }

    void everyFormatGivesTheNumbers()
    {
        QFETCH(QByteArray, image);
        const Run run = cloud(image, {"--depth-is", "z", "--precision", "double", "--size", "4x3"});
        QCOMPARE(run.errors, QByteArray());
        QCOMPARE(pointsOf<double>(run.output), expectedPoints());
    }

    void wholeNumbersAreSharesOfTheGreatest_data()
    {
        addColumn<QByteArray>("image");
        addColumn<double>("greatest");
        newRow("npy, 8 bits") << npyOf<quint8>("|u1") << 255.0;
        newRow("npy, 16 bits") << npyOf<quint16>("<u2") << 65535.0;
        newRow("npy, 32 bits") << npyOf<quint32>("<u4") << 4294967295.0;
        newRow("PGM") << pgm(100) << 100.0;
#ifdef UNPROJECTOR_PNG
        newRow("PNG, 16 bits") << grayPng(QImage::Format_Grayscale16) << 65535.0;
        newRow("PNG, 8 bits") << grayPng(QImage::Format_Grayscale8) << 255.0;
#endif
    }

    void wholeNumbersAreSharesOfTheGreatest()
    {
        QFETCH(QByteArray, image);
        QFETCH(double, greatest);
        const Run run = cloud(image, {"--precision", "double", "--depth-is", "buffer"});
        VERIFY_SUCCEEDED(run);
        const QVector<double> points = pointsOf<double>(run.output);
        QCOMPARE(points.size(), qsizetype(36));
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const double depth = numbers<double>()[i] / greatest, z = 400.0 / (400.0 - 399.0 * depth);
            QVERIFY(std::abs(points[3 * i + 2] - (5.0 - z)) < 1e-12 * (5.0 + z));
        }
    }

    void floatsAreNoShares()
    {
#ifdef UNPROJECTOR_TIFF
        const QStringList options{"--depth-is", "buffer"};
        const Run npy = cloud(npyOf<Half>("<f2"), options),
                  tiff = cloud(tiffOf<Half>(m_folder.path("made.tiff"), {.bits = 16}), options);
        QCOMPARE(tiff.exitCode, npy.exitCode);
        QCOMPARE(tiff.errors, npy.errors);
        QCOMPARE(tiff.output, npy.output);
#else
        QSKIP("built without TIFF");
#endif
    }

    void depthsAreFoundAmongChannels_data()
    {
        addColumn<QStringList>("channels"); // the first has the numbers
        addColumn<bool>("areSame");
        addColumn<bool>("isFound");
        const auto row = [](const char *name, const QStringList &channels, bool areSame, bool isFound) {
            newRow(name) << channels << areSame << isFound;
        };
        const QStringList normal{"View.Normal.X", "View.Normal.Y", "View.Normal.Z"};
        row("beside colors", {"View.Depth.Z", "B", "G", "R", "A"}, false, true);
        row("beside a vector", QStringList{"View.Depth.Z"} + normal, false, true);
        row("V, beside a vector", QStringList{"View.Depth.V", "B", "G", "R"} + normal, false, true);
        row("small letters", {"depth", "b", "g", "r"}, false, true);
        row("Z, beside a position", {"Z", "P.X", "P.Y", "P.Z"}, false, true);
        row("beside mist", {"View.Depth.Z", "View.Mist.Z", "View.IndexOB.X"}, false, true);
        row("before another depth", {"View.Depth.Z", "View.Denoising Depth.Z"}, false, true);
        row("in a longer name", {"Main_WorldDepth.R", "B", "G", "R"}, false, true);
        row("Z of a layer", {"pass.Z", "pass.X", "R"}, false, true);
        row("gray", {"R", "G", "B"}, true, true);
        row("gray with opacity", {"Y", "A"}, false, true);
        row("gray depth", {"Depth.R", "Depth.G", "Depth.B"}, true, true);
        row("colors", {"R", "G", "B"}, false, false);
        row("any names", {"one", "two"}, false, false);
        row("a vector alone", normal, false, false);
        row("a vector and colors", normal + QStringList{"R", "G", "B"}, false, false);
        row("mist and colors", {"View.Mist.Z", "R", "G", "B"}, false, false);
        row("two depths", {"left.Depth.Z", "right.Depth.Z"}, false, false);
    }

    void depthsAreFoundAmongChannels()
    {
#ifdef UNPROJECTOR_OPENEXR
        QFETCH(QStringList, channels);
        QFETCH(bool, areSame);
        QFETCH(bool, isFound);
        const QByteArray image =
            exr(m_folder.path("made.exr"), Imf::FLOAT, channels, Imf::ZIP_COMPRESSION, areSame ? 0.0f : 1.0f);
        const Run run = cloud(image, {"--depth-is", "z", "--precision", "double"});
        const QByteArray used = channels.front().toUtf8();
        std::sort(channels.begin(), channels.end()); // as EXR has them
        const QByteArray all = channels.join(", ").toUtf8();
        if (isFound) {
            QVERIFY2(run.errors.endsWith("depth: of the channels " + all + ", " + used + " is used\n"),
                     run.errors.constData());
            QCOMPARE(pointsOf<double>(run.output), expectedPoints());
        } else {
            QCOMPARE(run.exitCode, 2);
            QVERIFY2(run.errors.endsWith("has the channels " + all + "; give the one of depth by --channel\n"),
                     run.errors.constData());
        }
#else
        QSKIP("built without OpenEXR");
#endif
    }

    /// The display window is the image.
    void pixelsOutsideTheDataWindowHaveNoDepth()
    {
#ifdef UNPROJECTOR_OPENEXR
        const QByteArray image =
            exr(m_folder.path("made.exr"), Imf::FLOAT, {"Z"}, Imf::ZIP_COMPRESSION, 1.0f, Imath::Box2i({1, 1}, {3, 1}));
        const Run run = cloud(image, {"--depth-is", "z", "--precision", "double"});
        QVERIFY2(run.errors.contains("pixels only in a part of its frame; the others are NaN\n")
                     && run.errors.contains("left out: 9 with NaN\n"),
                 run.errors.constData());
        QCOMPARE(pointsOf<double>(run.output), expectedPoints().mid(3 * (kWidth + 1), 9));
#else
        QSKIP("built without OpenEXR");
#endif
    }

    void channelsAreChosen()
    {
        const QStringList options{"--depth-is", "z", "--precision", "double", "--channel", "A"};
        const Run other = cloud(npyOf<float>("<f4"), options);
        QCOMPARE(other.exitCode, 2);
        QVERIFY2(other.errors.contains("--channel is for OpenEXR"), other.errors.constData());
#ifdef UNPROJECTOR_OPENEXR
        const QString name = m_folder.path("made.exr");
        const Run chosen = cloud(exr(name, Imf::FLOAT, {"A", "Z"}), options);
        QCOMPARE(chosen.errors, QByteArray());
        QCOMPARE(pointsOf<double>(chosen.output), expectedPoints());
        const Run missing = cloud(exr(name, Imf::FLOAT, {"Y", "Z"}), options);
        QCOMPARE(missing.exitCode, 2);
        QVERIFY2(missing.errors.contains("has the channels Y, Z, not A\n"), missing.errors.constData());
#endif
    }

    void untoldZeroIsANote()
    {
#ifdef UNPROJECTOR_TIFF
        const Run run = cloud(tiffOf<float>(m_folder.path("made.tiff"), {.tellsZero = false}),
                              {"--depth-is", "z", "--precision", "double"});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.errors.contains("the TIFF does not tell the meaning of 0"), run.errors.constData());
        QCOMPARE(pointsOf<double>(run.output), expectedPoints());
#else
        QSKIP("built without TIFF");
#endif
    }

    void colorsFollowTheirPoints_data()
    {
        addColumn<QByteArray>("colors");
        addColumn<int>("tolerance");
#ifdef UNPROJECTOR_PNG
        newRow("PNG") << encoded(colors(), "png") << 0;
        newRow("PNG with opacity") << encoded(colors().convertToFormat(QImage::Format_ARGB32), "png") << 0;
        newRow("PNG, 64 bits") << encoded(colors().convertToFormat(QImage::Format_RGBA64), "png") << 0;
        newRow("PNG with a palette") << encoded(colors().convertToFormat(QImage::Format_Indexed8), "png") << 0;
        newRow("PNG, gray") << encoded(colors().convertToFormat(QImage::Format_Grayscale8), "png") << 0;
#endif
#ifdef UNPROJECTOR_JPEG
        if (writesJpeg())
            newRow("JPEG") << encoded(colors(), "jpg") << 1;
#endif
    }

    void colorsFollowTheirPoints()
    {
        QFETCH(QByteArray, colors);
        QFETCH(int, tolerance);
        const QImage decoded = QImage::fromData(colors);
        QVector<float> values = numbers<float>();
        values[1] = 0.0f; // without a point
        const QString file = m_folder.write("colors", colors);
        const Run run = cloud(bytesOf(values), {"--size", "4x3", "--depth-is", "z", "--color", file});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.output.contains(
            "element vertex 11\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
            "red\nproperty uchar green\nproperty uchar blue\nend_header\n"));
        const QByteArray body = plyBody(run.output);
        constexpr int kRecord = 15;
        QCOMPARE(body.size(), qsizetype(11 * kRecord));
        const QVector<double> points = expectedPoints();
        for (int k = 0; k < 11; ++k) {
            const int pixel = k < 1 ? 0 : k + 1;
            float point[3];
            std::memcpy(point, body.constData() + k * kRecord, sizeof(point));
            for (int axis = 0; axis < 3; ++axis)
                QCOMPARE(point[axis], float(points[3 * pixel + axis]));
            const auto *color = reinterpret_cast<const uchar *>(body.constData() + k * kRecord + 12);
            const QRgb qt = decoded.pixel(pixel % kWidth, pixel / kWidth);
            const int expected[]{qRed(qt), qGreen(qt), qBlue(qt)};
            for (int channel = 0; channel < 3; ++channel)
                QVERIFY2(std::abs(color[channel] - expected[channel]) <= tolerance,
                         qPrintable(QString::number(color[channel])));
        }
        // Window depths have colors too, and the same points as without.
        const QByteArray depths = bytesOf(QVector<float>(12, 0.5f));
        const QByteArray colored = plyBody(cloud(depths, {"--size", "4x3", "--color", file}).output),
                         plain = plyBody(cloud(depths, {"--size", "4x3"}).output);
        QCOMPARE(colored.size(), qsizetype(12 * kRecord));
        for (int k = 0; k < 12; ++k)
            QCOMPARE(colored.mid(k * kRecord, 12), plain.mid(12 * k, 12));
    }

    void colorsMustFit()
    {
#ifdef UNPROJECTOR_PNG
        const QByteArray depths = bytesOf(numbers<float>());
        const QString wide = m_folder.write("wide.png", encoded(colors(5), "png"));
        const Run size = cloud(depths, {"--size", "4x3", "--depth-is", "z", "--color", wide});
        QCOMPARE(size.exitCode, 2);
        QVERIFY2(size.errors.contains("the colors have 5x3 pixels, the depths 4x3 pixels"), size.errors.constData());
        const Run kind = cloud(depths, {"--size", "4x3", "--color", m_folder.write("colors", "GIF89a")});
        QCOMPARE(kind.exitCode, 2);
        QVERIFY2(kind.errors.contains("colors: this is neither PNG nor JPEG"), kind.errors.constData());
        const Run cut =
            cloud(depths, {"--size", "4x3", "--color", m_folder.write("colors", encoded(colors(), "png").chopped(20))});
        QCOMPARE(cut.exitCode, 2);
        QVERIFY2(cut.errors.contains("colors: the file is too short for 4x3 pixels"), cut.errors.constData());
#endif
#ifdef UNPROJECTOR_JPEG
        if (!writesJpeg())
            QSKIP("Qt writes no JPEG");
        const Run short_ =
            cloud(bytesOf(numbers<float>()),
                  {"--size", "4x3", "--color", m_folder.write("colors", encoded(colors(), "jpg").chopped(12))});
        QCOMPARE(short_.exitCode, 2);
        QVERIFY2(short_.errors.contains("colors: the file is"), short_.errors.constData());
        const QByteArray closed = encoded(colors(), "jpg").chopped(12) + "\xff\xd9"; // libjpeg only warns
        const Run gray =
            cloud(bytesOf(numbers<float>()), {"--size", "4x3", "--color", m_folder.write("colors", closed)});
        QCOMPARE(gray.exitCode, 2);
        QVERIFY2(gray.errors.contains("colors: the file is damaged (Corrupt JPEG data: premature end"),
                 gray.errors.constData());
#endif
    }

    void faultsOfJpegAreNotes_data()
    {
        addColumn<QByteArray>("inserted"); // behind the first segment
        addColumn<QByteArray>("note");
        const QByteArray exif("Exif\0\0", 6);
        const auto segment = [](const QByteArray &content) {
            return QByteArray("\xff\xe1") + '\0' + char(content.size() + 2) + content;
        };
        newRow("sound") << QByteArray() << QByteArray();
        newRow("bytes before a segment") << QByteArray("\x01\x02\x03") << QByteArray("the JPEG has a fault (");
        newRow("turned") << segment(exif
                                    + QByteArray("II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0", 26))
                         << QByteArray("turned or mirrored (Exif orientation 6)");
        newRow("mirrored, big-endian") << segment(
            exif + QByteArray("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x02\0\0\0\0\0\0", 26))
                                       << QByteArray("turned or mirrored (Exif orientation 2)");
        newRow("upright") << segment(
            exif + QByteArray("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x01\0\0\0\0\0\0", 26))
                          << QByteArray();
        newRow("Exif that ends early") << segment(exif + "MM") << QByteArray();
        newRow("Exif that points behind its end")
            << segment(exif + QByteArray("MM\0*\xff\xff\xff\xff", 8)) << QByteArray();
    }

    void faultsOfJpegAreNotes()
    {
#ifdef UNPROJECTOR_JPEG
        if (!writesJpeg())
            QSKIP("Qt writes no JPEG");
        QFETCH(QByteArray, inserted);
        QFETCH(QByteArray, note);
        const QByteArray sound = encoded(colors(), "jpg");
        constexpr int kFirstSegment = 20; // SOI and JFIF
        QByteArray jpeg = sound;
        jpeg.insert(kFirstSegment, inserted);
        const auto colored = [this](const QByteArray &bytes) {
            return cloud(bytesOf(numbers<float>()),
                         {"--size", "4x3", "--depth-is", "z", "--color", m_folder.write("colors", bytes)});
        };
        const Run run = colored(jpeg);
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(note.isEmpty() ? run.errors.isEmpty() : run.errors.contains(note), run.errors.constData());
        QCOMPARE(run.output, colored(sound).output);
#else
        QSKIP("built without JPEG");
#endif
    }

    void unusableImages_data()
    {
        addColumn<QByteArray>("image");
        addColumn<QByteArray>("message");
        const QByteArray floats = npyOf<float>("<f4");
        newRow("npy, other size") << npyOf<float>("<f4", "(4, 3)") << QByteArray("3x4 pixels, the scene's window 4x3");
        newRow("npy, enormous") << npyOf<float>("<f4", "(3000000000, 3000000000)")
                                << QByteArray("65536 a side is the most");
        newRow("npy, beyond all numbers")
            << npyOf<float>("<f4", "(99999999999999999999999, 4)") << QByteArray("header is damaged");
        newRow("npy, one dimension") << npyOf<float>("<f4", "(12,)")
                                     << QByteArray("the shape (12,); give one number a pixel");
        newRow("npy, colors") << npyOf<float>("<f4", "(3, 4, 3)") << QByteArray("the shape (3, 4, 3)");
        newRow("npy, complex") << npyOf<float>("<c8") << QByteArray("numbers of type <c8");
        newRow("npy, structured") << npy("{'descr': [('z', '<f4')], 'fortran_order': False, 'shape': (3, 4)}", {})
                                  << QByteArray("numbers of type [('z', '<f4')]");
        newRow("npy, too long") << floats + '\0' << QByteArray("too long");
        newRow("npy, no header") << QByteArray("\x93NUMPY\x01\x00\x03\x00{a}", 13) << QByteArray("header is damaged");
        newRow("npy, a field named shape")
            << npy("{'descr': [('shape', '<f4'), ('z', '<f4')], 'fortran_order': False, 'shape': (3, 4)}", {})
            << QByteArray("numbers of type [('shape', '<f4'), ('z', '<f4')]");
        for (const char *header :
             {"'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }",
              "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), ",
              "{'descr': '<f42, 'fortran_order': False, 'shape': (3, 4), }",
              "{'descr': '<f4\", 'fortran_order': False, 'shape': (3, 4), }",
              "{'descr': '<f4'x, 'fortran_order': False, 'shape': (3, 4), }",
              "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 4}", "{'descr': '<f4', 'fortran_order': False}",
              "{'descr': '<f4', 'shape': (3, 4)}", "{'fortran_order': False, 'shape': (3, 4)}"})
            newRow(header) << npy(header, bytesOf(numbers<float>())) << QByteArray("header is damaged");
        newRow("npy, a header of 4 GiB") << QByteArray("\x93NUMPY\x02\x00\xff\xff\xff\xff", 12)
                                         << QByteArray("header is damaged");
        newRow("npy, a header beyond the most")
            << QByteArray("\x93NUMPY\x02\x00\x01\x00\x01\x00", 12) << QByteArray("header is damaged");
        newRow("npy, version 4") << floats.left(6) + '\x04' + floats.mid(7) << QByteArray("header is damaged");
        newRow("npz") << QByteArray("PK\x03\x04xxxx") << QByteArray("an archive (.npz or .zip)");
        newRow("JPEG") << QByteArray("\xff\xd8\xff\xe0\x00\x10JFIF", 10)
                       << QByteArray("a JPEG image holds no exact numbers");
        newRow("text") << QByteArray("depth of a scene")
                       << QByteArray("neither PNG, .npy, OpenEXR, TIFF, PFM, PGM nor COLMAP's .bin");
        newRow("COLMAP, normals") << "4&3&3&" + bytesOf(numbers<float>())
                                  << QByteArray("the map of COLMAP has 3 numbers a pixel");
        newRow("COLMAP, another size") << "3&4&1&" + bytesOf(numbers<float>())
                                       << QByteArray("3x4 pixels, the scene's window 4x3");
        newRow("COLMAP, too long") << "4&3&1&" + bytesOf(numbers<float>()) + '\0' << QByteArray("too long");
#ifdef UNPROJECTOR_PNG
        newRow("PNG of colors") << encoded(colors(), "png") << QByteArray("the PNG has red, green and blue");
        newRow("PNG with opacity") << encoded(colors().convertToFormat(QImage::Format_ARGB32), "png")
                                   << QByteArray("the PNG has red, green, blue and opacity");
        newRow("PNG with a palette") << encoded(colors().convertToFormat(QImage::Format_Indexed8), "png")
                                     << QByteArray("the PNG has a palette of colors");
        newRow("PNG of 1 bit") << encoded(colors().convertToFormat(QImage::Format_Mono), "png")
                               << QByteArray("the PNG has ");
        newRow("PNG of another size") << encoded(QImage(5, 3, QImage::Format_Grayscale16), "png")
                                      << QByteArray("5x3 pixels, the scene's window 4x3");
        QByteArray damaged = grayPng(QImage::Format_Grayscale16);
        damaged[damaged.size() - 20] = char(damaged[damaged.size() - 20] ^ 0x55);
        newRow("PNG, damaged") << damaged << QByteArray("the file is damaged (");
        QByteArray huge = grayPng(QImage::Format_Grayscale16);
        huge[16] = '\x7f'; // the width; its checksum is wrong then too
        newRow("PNG, huge") << huge << QByteArray("the file is damaged (");
#else
        newRow("PNG") << QByteArray("\x89PNG\r\n\x1a\n")
                      << QByteArray("this is PNG, which this program was built without");
#endif
#ifdef UNPROJECTOR_TIFF
        const QString file = m_folder.path("made.tiff");
        newRow("TIFF of colors") << tiffOf<quint8>(file, {.bits = 8, .format = SAMPLEFORMAT_UINT, .channels = 3})
                                 << QByteArray("the TIFF has 3 channels");
        newRow("TIFF, 64 bits of whole numbers")
            << tiffOf<quint64>(file, {.bits = 64, .format = SAMPLEFORMAT_UINT})
            << QByteArray("numbers of 64 bits; give floats, or whole numbers of 8, 16 or 32 bits");
        newRow("TIFF, mirrored") << tiffOf<float>(file, {.orientation = ORIENTATION_TOPRIGHT})
                                 << QByteArray("orientation 2");
        newRow("TIFF, damaged")
            << tiffOf<float>(file, {.compression = COMPRESSION_ADOBE_DEFLATE}).replace(9, 6, "xxxxxx")
            << QByteArray("the file is damaged (");
#else
        newRow("TIFF") << QByteArray("II*\0", 4) << QByteArray("this is TIFF, which this program was built without");
#endif
#ifndef UNPROJECTOR_OPENEXR
        newRow("OpenEXR") << QByteArray("\x76\x2f\x31\x01", 4)
                          << QByteArray("this is OpenEXR, which this program was built without");
#endif
    }

    void unusableImages()
    {
        QFETCH(QByteArray, image);
        QFETCH(QByteArray, message);
        const Run run = cloud(image, {"--depth-is", "z"});
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QVERIFY2(run.errors.contains("depth: ") && run.errors.contains(message), run.errors.constData());
    }

    void everyShorterFileIsRefused_data()
    {
        addColumn<QByteArray>("image");
        newRow("npy") << npyOf<float>("<f4");
        newRow("COLMAP") << "4&3&1&" + bytesOf(numbers<float>());
        addLibraryFormats();
    }

    void everyShorterFileIsRefused()
    {
        QFETCH(QByteArray, image);
        constexpr int kFiles = 12; // a run of the command each
        for (int k = 0; k < kFiles; ++k) {
            const Run run = cloud(image.left(image.size() * k / kFiles), {"--depth-is", "z"});
            QCOMPARE(run.exitCode, 2);
            QCOMPARE(run.output, QByteArray());
            QVERIFY2(run.errors.startsWith(m_folder.path("depth").toUtf8() + ": "), run.errors.constData());
        }
    }

private:
    Run cloud(const QByteArray &image, const QStringList &options)
    {
        return runCommand(QStringList{"cloud", m_scene, m_folder.write("depth", image), "-o", "-"} + options);
    }

    void addLibraryFormats()
    {
#ifdef UNPROJECTOR_PNG
        newRow("PNG, 16 bits") << grayPng(QImage::Format_Grayscale16);
        newRow("PNG, 8 bits") << grayPng(QImage::Format_Grayscale8);
        newRow("PNG, interlaced") << kInterlacedPng;
#endif
#ifdef UNPROJECTOR_TIFF
        const QString file = m_folder.path("made.tiff");
        newRow("TIFF, floats") << tiffOf<float>(file, {});
        newRow("TIFF, halves") << tiffOf<Half>(file, {.bits = 16});
        newRow("TIFF, big-endian") << tiffOf<float>(file, {.mode = "wb"});
        newRow("TIFF, BigTIFF") << tiffOf<float>(file, {.mode = "w8"});
        newRow("TIFF, doubles, from the bottom")
            << tiffOf<double>(file, {.bits = 64, .orientation = ORIENTATION_BOTLEFT});
        newRow("TIFF, 16 bits, LZW") << tiffOf<quint16>(
            file, {.bits = 16, .format = SAMPLEFORMAT_UINT, .compression = COMPRESSION_LZW});
        newRow("TIFF, 8 bits, deflate") << tiffOf<quint8>(
            file, {.bits = 8, .format = SAMPLEFORMAT_UINT, .compression = COMPRESSION_ADOBE_DEFLATE});
        newRow("TIFF, signed, tiles") << tiffOf<qint16>(file,
                                                        {.bits = 16, .format = SAMPLEFORMAT_INT, .isTiled = true});
        newRow("TIFF, floats, tiles, deflate")
            << tiffOf<float>(file, {.compression = COMPRESSION_ADOBE_DEFLATE, .isTiled = true});
#endif
#ifdef UNPROJECTOR_OPENEXR
        const QString name = m_folder.path("made.exr");
        newRow("OpenEXR, floats") << exr(name, Imf::FLOAT, {"Z"});
        newRow("OpenEXR, halves") << exr(name, Imf::HALF, {"Y"}, Imf::PIZ_COMPRESSION);
        newRow("OpenEXR, whole numbers") << exr(name, Imf::UINT, {"depth"}, Imf::NO_COMPRESSION);
        newRow("OpenEXR, any name") << exr(name, Imf::FLOAT, {"Metres"});
#endif
    }

    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestDepthImages)
#include "test_depth_images.moc"
