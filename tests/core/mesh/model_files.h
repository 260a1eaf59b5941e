#pragma once

#include <QByteArray>
#include <QString>
#include <QtEndian>

#include <array>
#include <bit>
#include <filesystem>

/// The same box as a file of every format, and the bits they are made of.
namespace model_files {

// A box of 3 x 1 x 2 next to the origin: mixing up two axes is always noticed.
inline constexpr float kCorners[8][3] = {{-1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {-1, 1, 0},
                                         {-1, 0, 2}, {2, 0, 2}, {2, 1, 2}, {-1, 1, 2}};
inline constexpr int kQuads[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                     {2, 3, 7, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}};

// The importer passes a picture's bytes on unread, so any will do.
inline const QByteArray kPicture("\x89PNG\r\n\x1a\n not really a picture");

inline QByteArray bytesOf(const void *data, int size)
{
    return QByteArray(static_cast<const char *>(data), size);
}

template <class T>
inline QByteArray little(T value)
{
    value = qToLittleEndian(value);
    return bytesOf(&value, sizeof value);
}
inline QByteArray little(float value)
{
    return little(std::bit_cast<quint32>(value));
}
inline QByteArray little(double value)
{
    return little(std::bit_cast<quint64>(value));
}

inline QByteArray big(quint32 value)
{
    value = qToBigEndian(value);
    return bytesOf(&value, sizeof value);
}
inline QByteArray big(float value)
{
    return big(std::bit_cast<quint32>(value));
}

inline QByteArray big(double value)
{
    const quint64 bits = qToBigEndian(std::bit_cast<quint64>(value));
    return bytesOf(&bits, sizeof bits);
}

inline QByteArray corner(int i, char separator = ' ')
{
    return QByteArray::number(kCorners[i][0]) + separator + QByteArray::number(kCorners[i][1]) + separator
           + QByteArray::number(kCorners[i][2]);
}

/// @param tail  what follows each vertex number of a face
inline QByteArray objBox(const QByteArray &beforeFaces = {}, const QByteArray &tail = {})
{
    QByteArray text("# a box\n");
    for (int i = 0; i < 8; ++i)
        text += "v " + corner(i) + '\n';
    text += beforeFaces;
    for (const auto &quad : kQuads) {
        text += 'f';
        for (const int i : quad)
            text += ' ' + QByteArray::number(i + 1) + tail;
        text += '\n';
    }
    return text;
}

inline QByteArray stlText()
{
    QByteArray text("solid box\n");
    for (const auto &q : kQuads) {
        for (const auto &t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}})
            text += "facet normal 0 0 0\nouter loop\nvertex " + corner(t[0]) + "\nvertex " + corner(t[1]) + "\nvertex "
                    + corner(t[2]) + "\nendloop\nendfacet\n";
    }
    return text + "endsolid box\n";
}

/// @param declared  -1: as many as there are
inline QByteArray stlBinary(qint64 declared = -1, quint16 colorBits = 0, float firstX = kCorners[0][0])
{
    QByteArray bytes("solid, but binary all the same");
    bytes.append(80 - bytes.size(), ' ');
    bytes += little(static_cast<quint32>(declared < 0 ? 12 : declared));
    for (const auto &q : kQuads) {
        for (const auto &t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
            bytes += QByteArray(12, '\0');
            for (const int i : t)
                bytes += little(i == 0 ? firstX : kCorners[i][0]) + little(kCorners[i][1]) + little(kCorners[i][2]);
            bytes += little(colorBits);
        }
    }
    return bytes;
}

inline QByteArray plyHeader(const QByteArray &format, const QByteArray &comment = {}, const QByteArray &extra = {},
                            int faces = 6)
{
    return "ply\nformat " + format + " 1.0\n" + comment
           + "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n" + extra + "element face "
           + QByteArray::number(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline QByteArray plyText(const QByteArray &comment = {}, const QByteArray &extra = {}, const QByteArray &values = {})
{
    QByteArray text = plyHeader("ascii", comment, extra);
    for (int i = 0; i < 8; ++i)
        text += corner(i) + values + '\n';
    for (const auto &q : kQuads)
        text += QString("4 %1 %2 %3 %4\n").arg(q[0]).arg(q[1]).arg(q[2]).arg(q[3]).toUtf8();
    return text;
}

template <class Encode>
inline QByteArray plyBinary(const QByteArray &format, Encode encode)
{
    QByteArray bytes = plyHeader(format);
    for (const auto &c : kCorners)
        bytes += encode(c[0]) + encode(c[1]) + encode(c[2]);
    for (const auto &q : kQuads)
        bytes += '\4' + encode(quint32(q[0])) + encode(quint32(q[1])) + encode(quint32(q[2])) + encode(quint32(q[3]));
    return bytes;
}
inline QByteArray plyLittle()
{
    return plyBinary("binary_little_endian", [](auto value) { return little(value); });
}
inline QByteArray plyBig()
{
    return plyBinary("binary_big_endian", [](auto value) { return big(value); });
}

inline QByteArray offBox(const QByteArray &word = "OFF", const QByteArray &color = {})
{
    QByteArray text = word + "\n# a comment\n8 6 12\n";
    for (int i = 0; i < 8; ++i)
        text += corner(i) + color + '\n';
    for (const auto &q : kQuads)
        text += QString("4 %1 %2 %3 %4\n").arg(q[0]).arg(q[1]).arg(q[2]).arg(q[3]).toUtf8();
    return text;
}

inline QByteArray offBinary()
{
    QByteArray bytes = "OFF BINARY\n" + big(8u) + big(6u) + big(12u);
    for (const auto &c : kCorners)
        bytes += big(c[0]) + big(c[1]) + big(c[2]);
    for (const auto &q : kQuads)
        bytes += big(4u) + big(quint32(q[0])) + big(quint32(q[1])) + big(quint32(q[2])) + big(quint32(q[3])) + big(0u);
    return bytes;
}

inline QByteArray gltfBuffer()
{
    QByteArray bytes;
    for (const auto &c : kCorners)
        bytes += little(c[0]) + little(c[1]) + little(c[2]);
    for (const auto &q : kQuads) {
        for (const int i : {q[0], q[1], q[2], q[0], q[2], q[3]})
            bytes += little(quint16(i));
    }
    for (int i = 0; i < 8; ++i)
        bytes += little(0.25f) + little(0.1f);
    return bytes + kPicture;
}

/// @param bufferUri  empty: the buffer is GLB's binary chunk @param image  the members of the
/// image, empty: no texture
inline QByteArray gltfJson(const QByteArray &bufferUri, const QByteArray &node = {}, const QByteArray &image = {})
{
    QByteArray json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0NODE}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0}]}],
        "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.25,0.5,0.75,1.0]TEXTURE}}],IMAGES
        "buffers":[{"byteLength":BYTESURI}],
        "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},
            {"buffer":0,"byteOffset":168,"byteLength":64},{"buffer":0,"byteOffset":232,"byteLength":PICTURE}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,0,0],"max":[2,1,2]},
            {"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"},
            {"bufferView":2,"componentType":5126,"count":8,"type":"VEC2"}]})";
    json.replace("NODE", node);
    json.replace("TEXTURE", image.isEmpty() ? "" : R"(,"baseColorTexture":{"index":0})");
    json.replace("IMAGES", image.isEmpty() ? "" : R"("textures":[{"source":0}],"images":[{)" + image + "}],");
    json.replace("BYTES", QByteArray::number(gltfBuffer().size()));
    json.replace("PICTURE", QByteArray::number(kPicture.size()));
    json.replace("URI", bufferUri.isEmpty() ? "" : R"(,"uri":")" + bufferUri + '"');
    return json;
}

inline QByteArray gltfBox(const QByteArray &node = {}, const QByteArray &image = {})
{
    return gltfJson("data:application/octet-stream;base64," + gltfBuffer().toBase64(), node, image);
}

inline QByteArray glbBox(const QByteArray &image = {})
{
    QByteArray json = gltfJson({}, {}, image);
    json.append((4 - json.size() % 4) % 4, ' ');
    QByteArray binary = gltfBuffer();
    binary.append((4 - binary.size() % 4) % 4, '\0');
    return "glTF" + little(quint32(2)) + little(quint32(28 + json.size() + binary.size()))
           + little(quint32(json.size())) + "JSON" + json + little(quint32(binary.size())) + QByteArray("BIN\0", 4)
           + binary;
}

inline std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

} // namespace model_files
