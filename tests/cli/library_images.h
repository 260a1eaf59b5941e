#pragma once

#include "tests/cli/depth_files.h"

#include <QFile>

#include <cmath>

#ifdef UNPROJECTOR_TIFF
#include <tiffio.h>
#endif
#ifdef UNPROJECTOR_OPENEXR
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#endif

// Images of 4 x 3 numbers, written by the libraries that read them.

inline constexpr int kWidth = 4, kHeight = 3;

/// A different whole number a pixel.
template <class Number>
QVector<Number> numbers()
{
    QVector<Number> values;
    for (int i = 0; i < kWidth * kHeight; ++i)
        values << Number(2 + 7 * i);
    return values;
}

/// A float of 16 bits: sign, exponent and fraction. For whole numbers from 1 to 2047.
struct Half {
    explicit Half(int number)
    {
        const int exponent = std::ilogb(double(number));
        bits = quint16((exponent + 15) << 10 | (number << (10 - exponent) & 0x3ff));
    }
    quint16 bits = 0;
};

#ifdef UNPROJECTOR_TIFF
/// The kind of a TIFF.
struct TiffKind {
    int bits = 32, format = SAMPLEFORMAT_IEEEFP, compression = COMPRESSION_NONE, orientation = ORIENTATION_TOPLEFT;
    bool isTiled = false;
    int channels = 1;
    const char *mode = "w";
    bool tellsZero = true; ///< has a photometric interpretation
};

template <class Number>
QByteArray tiffOf(const QString &file, const TiffKind &kind)
{
    TIFF *tiff = TIFFOpen(file.toLocal8Bit().constData(), kind.mode);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, kWidth);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, kHeight);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.channels);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind.format);
    if (kind.tellsZero)
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.channels == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, kind.orientation);
    const QVector<Number> values = numbers<Number>();
    if (kind.isTiled) {
        constexpr int kTile = 16;
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kTile);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, kTile);
        QVector<Number> tile(qsizetype(kTile) * kTile, Number(1));
        for (int i = 0; i < values.size(); ++i)
            tile[i / kWidth * kTile + i % kWidth] = values[i];
        TIFFWriteTile(tiff, tile.data(), 0, 0, 0, 0);
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2);
        for (int j = 0; j < kHeight; ++j) {
            const int row = kind.orientation == ORIENTATION_BOTLEFT ? kHeight - 1 - j : j;
            QVector<Number> line;
            for (int i = 0; i < kWidth; ++i)
                line += QVector<Number>(kind.channels, values[row * kWidth + i]);
            TIFFWriteScanline(tiff, line.data(), quint32(j), 0);
        }
    }
    TIFFClose(tiff);
    QFile written(file);
    return written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
}
#endif

#ifdef UNPROJECTOR_OPENEXR
/// @param channels    all with the numbers; those after the first have `difference` more each
/// @param dataWindow  the pixels that the file has; empty: all
inline QByteArray exr(const QString &file, Imf::PixelType type, const QStringList &channels,
                      Imf::Compression compression = Imf::ZIP_COMPRESSION, float difference = 1.0f,
                      const Imath::Box2i &dataWindow = {})
{
    Imf::Header header(kWidth, kHeight);
    header.compression() = compression;
    if (!dataWindow.isEmpty())
        header.dataWindow() = dataWindow;
    Imf::FrameBuffer buffer;
    QVector<QByteArray> planes;
    for (const QString &name : channels) {
        QByteArray plane;
        for (const int number : numbers<int>()) {
            const float value = float(number) + difference * float(planes.size());
            if (type == Imf::FLOAT)
                plane += bytesOf(QVector<float>{value});
            else if (type == Imf::HALF)
                plane += bytesOf(QVector<Imath::half>{Imath::half(value)});
            else
                plane += bytesOf(QVector<quint32>{quint32(value)});
        }
        planes << plane;
        header.channels().insert(name.toStdString(), Imf::Channel(type));
    }
    for (int k = 0; k < planes.size(); ++k) {
        const qsizetype size = planes[k].size() / (qsizetype(kWidth) * kHeight);
        buffer.insert(channels[k].toStdString(),
                      Imf::Slice(type, planes[k].data(), std::size_t(size), std::size_t(size * kWidth)));
    }
    {
        Imf::OutputFile out(file.toLocal8Bit().constData(), header);
        out.setFrameBuffer(buffer);
        out.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
    }
    QFile written(file);
    return written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
}
#endif
