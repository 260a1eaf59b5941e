#pragma once

#include "tests/cli/command.h"

#include <QVector>

#include <algorithm>
#include <cstring>

// Depth images that tests write, and the points that the command writes.

/// The bytes of numbers, in this machine's order.
template <class Number>
QByteArray bytesOf(const QVector<Number> &values)
{
    return QByteArray(reinterpret_cast<const char *>(values.constData()), values.size() * qsizetype(sizeof(Number)));
}

/// An .npy file. @param header  the dictionary
inline QByteArray npy(const QByteArray &header, const QByteArray &numbers)
{
    QByteArray text = header;
    while ((10 + text.size() + 1) % 64 != 0)
        text += ' ';
    text += '\n';
    QByteArray bytes("\x93NUMPY\x01\x00", 8);
    bytes += char(text.size() & 0xff);
    bytes += char(text.size() >> 8);
    return bytes + text + numbers;
}

inline QByteArray npyHeader(const char *type, const char *shape, bool isFortranOrder = false)
{
    return QByteArray("{'descr': '") + type + "', 'fortran_order': " + (isFortranOrder ? "True" : "False")
           + ", 'shape': " + shape + ", }";
}

template <class Number>
QByteArray swapped(QVector<Number> values)
{
    for (Number &value : values) {
        auto *bytes = reinterpret_cast<char *>(&value);
        std::reverse(bytes, bytes + sizeof(Number));
    }
    return bytesOf(values);
}

/// The body of a PLY.
inline QByteArray plyBody(const QByteArray &ply)
{
    const QByteArray end("end_header\n");
    return ply.mid(ply.indexOf(end) + end.size());
}

/// The points of a PLY without colors as x, y, z after each other.
template <class Number = float>
QVector<Number> pointsOf(const QByteArray &ply)
{
    const QByteArray body = plyBody(ply);
    QVector<Number> values(body.size() / qsizetype(sizeof(Number)));
    std::memcpy(values.data(), body.constData(), std::size_t(values.size()) * sizeof(Number));
    return values;
}
