// glTF buffer views that meshoptimizer packs: the test packs them itself.

#include "tests/support/test.h"

#include "tests/core/mesh/gltf_builder.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#ifdef UNPROJECTOR_MESHOPTIMIZER
#include <meshoptimizer.h>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace model_files;

namespace {

constexpr int kSide = 20; ///< vertices along an edge of the sheet: more than the codec has in one block of 4 bytes
constexpr int kVertices = kSide * kSide;

std::vector<float> sheetPositions()
{
    std::vector<float> positions;
    for (int v = 0; v < kVertices; ++v) {
        const int x = v % kSide, y = v / kSide;
        for (const float number : {0.25f * float(x), 0.5f * float(y), 0.125f * float((x * 5 + y * 3) % 7)})
            positions.push_back(number);
    }
    return positions;
}

std::vector<unsigned int> sheetIndices()
{
    std::vector<unsigned int> indices;
    for (unsigned int y = 0; y + 1 < kSide; ++y) {
        for (unsigned int x = 0; x + 1 < kSide; ++x) {
            const unsigned int a = y * kSide + x;
            for (const unsigned int corner : {a, a + 1, a + kSide + 1, a, a + kSide + 1, a + kSide})
                indices.push_back(corner);
        }
    }
    return indices;
}

/// A packed buffer view: the numbers of its extension, and the bytes.
struct Packed {
    QByteArray bytes;
    int count = 0;
    int stride = 0;
    QByteArray mode;
    QByteArray filter; ///< or empty
};

QByteArray cutTo(std::vector<unsigned char> buffer, std::size_t size)
{
    return QByteArray(reinterpret_cast<const char *>(buffer.data()), qsizetype(size));
}

Packed packedVertices(const void *vertices, int count, int stride, const QByteArray &filter = {})
{
    std::vector<unsigned char> buffer(meshopt_encodeVertexBufferBound(std::size_t(count), std::size_t(stride)));
    const std::size_t size =
        meshopt_encodeVertexBuffer(buffer.data(), buffer.size(), vertices, std::size_t(count), std::size_t(stride));
    return {cutTo(std::move(buffer), size), count, stride, "ATTRIBUTES", filter};
}

Packed packedPositions()
{
    const std::vector<float> positions = sheetPositions();
    return packedVertices(positions.data(), kVertices, 12);
}

Packed packedTriangles(int stride)
{
    const std::vector<unsigned int> indices = sheetIndices();
    std::vector<unsigned char> buffer(meshopt_encodeIndexBufferBound(indices.size(), kVertices));
    const std::size_t size = meshopt_encodeIndexBuffer(buffer.data(), buffer.size(), indices.data(), indices.size());
    return {cutTo(std::move(buffer), size), int(indices.size()), stride, "TRIANGLES", {}};
}

Packed packedIndices(int stride)
{
    const std::vector<unsigned int> indices = sheetIndices();
    std::vector<unsigned char> buffer(meshopt_encodeIndexSequenceBound(indices.size(), kVertices));
    const std::size_t size = meshopt_encodeIndexSequence(buffer.data(), buffer.size(), indices.data(), indices.size());
    return {cutTo(std::move(buffer), size), int(indices.size()), stride, "INDICES", {}};
}

/// A file whose views are all packed; buffer 1 stands in for their bytes and has none.
class PackedGltf {
public:
    int addView(const Packed &packed)
    {
        m_views << R"({"buffer":1,"byteOffset":)" + QByteArray::number(m_unpackedSize) + R"(,"byteLength":)"
                       + QByteArray::number(packed.count * packed.stride)
                       + (packed.mode == "ATTRIBUTES" ? R"(,"byteStride":)" + QByteArray::number(packed.stride)
                                                      : QByteArray())
                       + R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)"
                       + QByteArray::number(m_buffer.size()) + R"(,"byteLength":)"
                       + QByteArray::number(packed.bytes.size()) + R"(,"byteStride":)"
                       + QByteArray::number(packed.stride) + R"(,"count":)" + QByteArray::number(packed.count)
                       + R"(,"mode":")" + packed.mode + '"'
                       + (packed.filter.isEmpty() ? QByteArray() : R"(,"filter":")" + packed.filter + '"') + "}}}";
        m_buffer += packed.bytes;
        m_unpackedSize += packed.count * packed.stride;
        return int(m_views.size()) - 1;
    }
    void addAccessor(int view, int componentType, int count, const char *type, const QByteArray &more = {})
    {
        m_accessors << R"({"bufferView":)" + QByteArray::number(view) + R"(,"componentType":)"
                           + QByteArray::number(componentType) + R"(,"count":)" + QByteArray::number(count)
                           + R"(,"type":")" + type + '"' + more + '}';
    }
    QByteArray json(const QByteArray &rest) const
    {
        return R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_meshopt_compression"],
            "extensionsRequired":["EXT_meshopt_compression"],"buffers":[{"byteLength":)"
               + QByteArray::number(m_buffer.size()) + R"(,"uri":"data:application/octet-stream;base64,)"
               + m_buffer.toBase64() + R"("},{"byteLength":)" + QByteArray::number(m_unpackedSize)
               + R"(,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}],"bufferViews":[)" + m_views.join(',')
               + R"(],"accessors":[)" + m_accessors.join(',') + ']' + rest + '}';
    }

private:
    QByteArray m_buffer;
    int m_unpackedSize = 0;
    QByteArrayList m_views, m_accessors;
};

QByteArray sheet(const Packed &positions, const Packed &indices)
{
    PackedGltf file;
    file.addAccessor(file.addView(positions), kFloat, kVertices, "VEC3");
    file.addAccessor(file.addView(indices), indices.stride == 2 ? kUshort : kUint, indices.count, "SCALAR");
    return file.json(shown(R"("attributes":{"POSITION":0},"indices":1)"));
}

} // namespace

class TestGltfMeshopt : public QObject {
    Q_OBJECT

    auto imported(const QByteArray &content) { return m_folder.imported(QStringLiteral("model.gltf"), content); }

private slots:
    void initTestCase()
    {
        // The version of glTF's extension; the library writes an earlier one otherwise.
        meshopt_encodeIndexVersion(1);
    }

    void unpacksIndices_data()
    {
        addColumn<bool>("areTriangles");
        addColumn<int>("stride");
        newRow("triangles of 16 bits") << true << 2;
        newRow("triangles of 32 bits") << true << 4;
        newRow("a sequence of 16 bits") << false << 2;
        newRow("a sequence of 32 bits") << false << 4;
    }

    void unpacksIndices()
    {
        QFETCH(bool, areTriangles);
        QFETCH(int, stride);
        const auto result =
            imported(sheet(packedPositions(), areTriangles ? packedTriangles(stride) : packedIndices(stride)));
        REQUIRE_MODEL(result);
        const Model &model = **result;
        QVERIFY(model.notes.empty());
        const Mesh &mesh = model.meshes.front();
        const std::vector<float> positions = sheetPositions();
        const std::vector<unsigned int> indices = sheetIndices();
        QCOMPARE(mesh.elementCount(), indices.size());
        const auto expectedAt = [&](std::size_t corner) {
            const std::size_t v = indices[corner];
            return glm::dvec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
        };
        // The codec may begin a triangle at another of its corners.
        for (std::size_t t = 0; t < indices.size(); t += 3) {
            std::size_t turn = 0;
            while (turn < 3 && mesh.position(mesh.vertexAt(t)) != expectedAt(t + turn))
                ++turn;
            QVERIFY(turn < 3);
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY(mesh.position(mesh.vertexAt(t + c)) == expectedAt(t + (turn + c) % 3));
        }
    }

    void unpacksExponents()
    {
        const std::vector<float> positions = sheetPositions();
        std::vector<float> filtered(positions.size());
        meshopt_encodeFilterExp(filtered.data(), kVertices, 12, 24, positions.data());
        const auto result =
            imported(sheet(packedVertices(filtered.data(), kVertices, 12, "EXPONENTIAL"), packedTriangles(2)));
        REQUIRE_MODEL(result);
        // The sheet's numbers are eighths, which 24 bits hold.
        const Mesh &mesh = (*result)->meshes.front();
        for (std::size_t v = 0; v < kVertices; ++v)
            QVERIFY(mesh.position(v) == glm::dvec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]));
    }

    void unpacksDirections_data()
    {
        addColumn<int>("stride");
        addColumn<int>("componentType");
        addColumn<double>("tolerance");
        newRow("8 bits") << 4 << kByte << 0.02;
        newRow("16 bits") << 8 << 5122 << 0.0001;
    }

    void unpacksDirections()
    {
        QFETCH(int, stride);
        QFETCH(int, componentType);
        QFETCH(double, tolerance);
        std::vector<glm::vec3> directions;
        std::vector<float> fourEach;
        for (int v = 0; v < kVertices; ++v) {
            directions.push_back(glm::normalize(glm::vec3(v % 7 - 3, v % 5 - 2, v % 11 - 4.5f)));
            for (const float number : {directions.back().x, directions.back().y, directions.back().z, 0.0f})
                fourEach.push_back(number);
        }
        std::vector<unsigned char> filtered(std::size_t(kVertices * stride));
        meshopt_encodeFilterOct(filtered.data(), kVertices, std::size_t(stride), stride * 2, fourEach.data());
        PackedGltf file;
        file.addAccessor(file.addView(packedPositions()), kFloat, kVertices, "VEC3");
        file.addAccessor(file.addView(packedTriangles(2)), kUshort, int(sheetIndices().size()), "SCALAR");
        file.addAccessor(file.addView(packedVertices(filtered.data(), kVertices, stride, "OCTAHEDRAL")), componentType,
                         kVertices, "VEC3", R"(,"normalized":true)");
        const auto result = imported(file.json(shown(R"("attributes":{"POSITION":0,"NORMAL":2},"indices":1)")));
        REQUIRE_MODEL(result);
        const Mesh &mesh = (*result)->meshes.front();
        QCOMPARE(mesh.normals.size(), std::size_t(kVertices));
        for (std::size_t v = 0; v < kVertices; ++v)
            QVERIFY(double(glm::distance(mesh.normals[v], directions[v])) < tolerance);
    }

    /// Instances turned about z: packed quaternions place them.
    void unpacksRotations()
    {
        constexpr int kInstances = 16;
        constexpr double kStep = 0.3;
        std::vector<float> quaternions;
        for (int i = 0; i < kInstances; ++i) {
            for (const double number : {0.0, 0.0, std::sin(kStep * i / 2.0), std::cos(kStep * i / 2.0)})
                quaternions.push_back(float(number));
        }
        std::vector<unsigned char> filtered(std::size_t{kInstances} * 8);
        meshopt_encodeFilterQuat(filtered.data(), kInstances, 8, 16, quaternions.data());
        PackedGltf file;
        const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
        file.addAccessor(file.addView(packedVertices(corners.data(), 3, 12)), kFloat, 3, "VEC3");
        file.addAccessor(file.addView(packedVertices(filtered.data(), kInstances, 8, "QUATERNION")), 5122, kInstances,
                         "VEC4", R"(,"normalized":true)");
        const auto result =
            imported(file.json(shown(R"("attributes":{"POSITION":0})",
                                     R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"ROTATION":1}}})")));
        REQUIRE_MODEL(result);
        const Mesh &mesh = (*result)->meshes.front();
        QCOMPARE(mesh.triangleCount(), std::size_t(kInstances));
        for (int i = 0; i < kInstances; ++i) {
            const glm::dvec3 expected(std::cos(kStep * i), std::sin(kStep * i), 0.0);
            QVERIFY(glm::distance(mesh.position(mesh.vertexAt(std::size_t(3 * i + 1))), expected) < 2e-4);
        }
    }

    void refusesWhatContradictsTheFile_data()
    {
        addColumn<QByteArray>("content");
        addColumn<QString>("detail");
        const auto changed = [](const char *before, const char *after) {
            return sheet(packedPositions(), packedTriangles(2)).replace(before, after);
        };
        newRow("a mode that does not exist") << changed("ATTRIBUTES", "STRIPS") << "in the mode \"STRIPS\"";
        newRow("a filter that does not exist")
            << changed(R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"WAVELET")")
            << "the filter \"WAVELET\"";
        newRow("filtered indices") << changed(R"("mode":"TRIANGLES")", R"("mode":"TRIANGLES","filter":"QUATERNION")")
                                   << "in the mode \"TRIANGLES\" with the filter \"QUATERNION\"";
        newRow("directions of 12 bytes") << changed(R"("mode":"ATTRIBUTES")",
                                                    R"("mode":"ATTRIBUTES","filter":"OCTAHEDRAL")")
                                         << "the filter \"OCTAHEDRAL\" has elements of 12 bytes";
        newRow("a mode that is a number") << changed(R"("mode":"ATTRIBUTES")", R"("mode":3)") << "is not a text";
        newRow("another count") << changed(R"("count":400,"mode")", R"("count":399,"mode")")
                                << "399 times 12 bytes is declared as 4800 bytes";
        newRow("far more than the bytes hold")
            << changed(R"("count":400,"mode")", R"("count":40000000,"mode")")
                   .replace(R"("byteLength":4800,"byteStride")", R"("byteLength":480000000,"byteStride")")
            << "declares 40000000 elements";
        newRow("triangles with a corner too many") << changed(R"("count":2166,"mode")", R"("count":2165,"mode")")
                                                          .replace(R"("byteLength":4332)", R"("byteLength":4330)")
                                                   << "packed as triangles has 2165 indices";
        newRow("indices of 12 bytes") << changed(R"("mode":"ATTRIBUTES")", R"("mode":"INDICES")")
                                      << "has elements of 12 bytes";
        newRow("bytes beyond the buffer") << changed(R"("EXT_meshopt_compression":{"buffer":0,"byteOffset":0)",
                                                     R"("EXT_meshopt_compression":{"buffer":0,"byteOffset":9000000)")
                                          << "beyond its buffer";
        Packed later = packedPositions();
        later.bytes[0] = char(0xaf);
        newRow("a later version") << sheet(later, packedTriangles(2)) << "by a later version of meshoptimizer than";
    }

    void refusesWhatContradictsTheFile()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, detail);
        VERIFY_REFUSED(imported(content), detail);
    }

    void damagedDataGiveAMessage_data()
    {
        addColumn<int>("part");
        newRow("vertices") << 0;
        newRow("triangles") << 1;
        newRow("a sequence") << 2;
    }

    /// Bytes changed, and the data cut off: a model of other numbers, or a message.
    void damagedDataGiveAMessage()
    {
        QFETCH(int, part);
        const Packed whole = part == 0 ? packedPositions() : part == 1 ? packedTriangles(2) : packedIndices(2);
        int refused = 0;
        const auto tryOut = [&](const QByteArray &bytes) {
            Packed damaged = whole;
            damaged.bytes = bytes;
            const auto result =
                imported(part == 0 ? sheet(damaged, packedTriangles(2)) : sheet(packedPositions(), damaged));
            if (result)
                return;
            ++refused;
            QVERIFY(result.error().text.starts_with("the file is damaged")
                    || result.error().text.starts_with("vertex"));
        };
        for (qsizetype i = 0; i < whole.bytes.size(); i += i < 64 ? 1 : 7) {
            for (const int change : {1, 0x80, 0xff}) {
                QByteArray bytes = whole.bytes;
                bytes[i] = char(bytes[i] ^ change);
                tryOut(bytes);
            }
            tryOut(whole.bytes.left(i));
        }
        QVERIFY(refused > 100);
    }

private:
    ImportFolder m_folder;
};

#else

class TestGltfMeshopt : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QSKIP("built without meshoptimizer"); }
};

#endif

UNPROJECTOR_TEST(TestGltfMeshopt, threads)
#include "test_gltf_meshopt.moc"
