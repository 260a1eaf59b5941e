#pragma once

#include "tests/core/mesh/imported.h"

#include <QByteArray>
#include <QByteArrayList>

#include <vector>

/// glTF files put together in tests.
namespace model_files {

/// A glTF file built from parts: each accessor gets its own buffer view, all in one buffer.
class GltfBuilder {
public:
    /// @return the accessor's number
    template <class Number>
    int add(const std::vector<Number> &numbers, const char *type, int componentType, const QByteArray &more = {})
    {
        const int components = QByteArray(type) == "SCALAR" ? 1 : type[3] - '0';
        return addAccessor(addView(numbers), componentType, int(numbers.size()) / components, type, more);
    }
    template <class Number>
    int addView(const std::vector<Number> &numbers)
    {
        const qsizetype bytes = qsizetype(numbers.size()) * qsizetype(sizeof(Number));
        m_views << R"({"buffer":0,"byteOffset":)" + QByteArray::number(m_buffer.size()) + R"(,"byteLength":)"
                       + QByteArray::number(bytes) + '}';
        m_buffer.append(reinterpret_cast<const char *>(numbers.data()), bytes);
        m_buffer.append((4 - m_buffer.size() % 4) % 4, '\0');
        return int(m_views.size()) - 1;
    }
    int addAccessor(int view, int componentType, int count, const char *type, const QByteArray &more = {})
    {
        m_accessors << (view < 0 ? QByteArray("{") : R"({"bufferView":)" + QByteArray::number(view) + ',')
                           + R"("componentType":)" + QByteArray::number(componentType) + R"(,"count":)"
                           + QByteArray::number(count) + ",\"type\":\"" + type + '"' + more + '}';
        return int(m_accessors.size()) - 1;
    }
    /// @param rest  the other keys, after the buffers' keys, with a comma before each
    QByteArray json(const QByteArray &rest) const
    {
        return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + QByteArray::number(m_buffer.size())
               + R"(,"uri":"data:application/octet-stream;base64,)" + m_buffer.toBase64() + "\"}],\"bufferViews\":["
               + m_views.join(',') + R"(],"accessors":[)" + m_accessors.join(',') + ']' + rest + '}';
    }

private:
    QByteArray m_buffer;
    QByteArrayList m_views, m_accessors;
};

inline constexpr int kByte = 5120, kUbyte = 5121, kUshort = 5123, kUint = 5125, kFloat = 5126;

inline const std::vector<float> kQuadCorners{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

/// A mesh of one primitive on a node.
inline QByteArray shown(const QByteArray &primitive, const QByteArray &node = {}, const QByteArray &more = {})
{
    return R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + node + R"(}],"meshes":[{"primitives":[{)" + primitive
           + "}]}]" + more;
}

/// Two triangles with indices.
inline QByteArray quad(const QByteArray &node = {}, const QByteArray &more = {})
{
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    file.add(std::vector<quint16>{0, 1, 2, 2, 1, 3}, "SCALAR", kUshort);
    return file.json(shown(R"("attributes":{"POSITION":0},"indices":1)", node, more));
}

inline QByteArray glb(QByteArray json, bool isPadded)
{
    const QByteArray buffer = QByteArray(reinterpret_cast<const char *>(kQuadCorners.data()), 48);
    if (isPadded)
        json.append((4 - json.size() % 4) % 4, ' ');
    else if (json.size() % 4 == 0)
        json.append(' ');
    return "glTF" + little(quint32(2)) + little(quint32(28 + json.size() + buffer.size()))
           + little(quint32(json.size())) + "JSON" + json + little(quint32(buffer.size())) + QByteArray("BIN\0", 4)
           + buffer;
}

} // namespace model_files
