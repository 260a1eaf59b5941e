// glTF and GLB: what of the format is read, what is refused, and what is said about the rest.

#include "imported.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh_import;
using namespace unprojector::scene;
using namespace model_files;

namespace {

/// A glTF file that is put together from parts: accessors get their buffer views, all in one buffer.
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
    /// @param rest  the keys besides those of the buffers, with a comma before each
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

constexpr int kByte = 5120, kUbyte = 5121, kUshort = 5123, kUint = 5125, kFloat = 5126;

const std::vector<float> kQuadCorners{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

/// A mesh of one primitive on a node.
QByteArray shown(const QByteArray &primitive, const QByteArray &node = {}, const QByteArray &more = {})
{
    return R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + node + R"(}],"meshes":[{"primitives":[{)" + primitive
           + "}]}]" + more;
}

/// Two triangles with indices.
QByteArray quad(const QByteArray &node = {}, const QByteArray &more = {}, const QByteArray &primitive = {})
{
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    file.add(std::vector<quint16>{0, 1, 2, 2, 1, 3}, "SCALAR", kUshort);
    return file.json(shown(R"("attributes":{"POSITION":0},"indices":1)" + primitive, node, more));
}

QByteArray glb(QByteArray json, bool isPadded)
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

} // namespace

class TestImportGltf : public QObject {
    Q_OBJECT

private slots:
    void readsTriangles_data();
    void readsTriangles();
    void keepsTheDigitsOfFarNodes();
    void appliesMorphWeights();
    void readsColorsOfAllKinds_data();
    void readsColorsOfAllKinds();
    void movesTextureCoordinates_data();
    void movesTextureCoordinates();
    void pointsAloneArePoints();
    void saysWhatIsLeftOut_data();
    void saysWhatIsLeftOut();
    void refuses_data();
    void refuses();
    void whatCannotBeShownIsNamed();
    void chunksNeedNoPadding_data();
    void chunksNeedNoPadding();
    void manyNodesTakeNoTime();

private:
    auto imported(const QByteArray &content, const QString &name = QStringLiteral("model.gltf"))
    {
        return m_folder.imported(name, content);
    }
    ImportFolder m_folder;
};

void TestImportGltf::readsTriangles_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("indexed") << quad();
    QTest::newRow("a camera on the node") << quad(R"(,"camera":0)", R"(,"cameras":[{"type":"perspective"}])");
    QTest::newRow("a light that is required")
        << quad({}, R"(,"extensionsUsed":["KHR_lights_punctual"],"extensionsRequired":["KHR_lights_punctual"])");
    {
        GltfBuilder file;
        file.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, "VEC3", kFloat);
        QTest::newRow("without indices") << file.json(shown(R"("attributes":{"POSITION":0})"));
    }
    {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        QTest::newRow("a strip") << file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
    }
    {
        GltfBuilder file;
        file.add(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0}, "VEC3", kFloat);
        QTest::newRow("a fan") << file.json(shown(R"("attributes":{"POSITION":0},"mode":6)"));
    }
    {
        GltfBuilder quantized;
        const int view = quantized.addView(std::vector<qint8>{0, 0, 0, 9, 127, 0, 0, 9, 0, 127, 0, 9, 127, 127, 0, 9});
        quantized.addAccessor(view, kByte, 4, "VEC3", R"(,"normalized":true)");
        QByteArray json = quantized.json(
            shown(R"("attributes":{"POSITION":0},"mode":5)", {}, R"(,"extensionsRequired":["KHR_mesh_quantization"])"));
        json.replace(R"("byteLength":16})", R"("byteLength":16,"byteStride":4})");
        QTest::newRow("quantized, four bytes apart") << json;
    }
    {
        GltfBuilder file;
        const int indices = file.addView(std::vector<quint8>{1, 2, 3});
        const int values = file.addView(std::vector<float>{1, 0, 0, 0, 1, 0, 1, 1, 0});
        file.addAccessor(-1, kFloat, 4, "VEC3",
                         R"(,"sparse":{"count":3,"indices":{"bufferView":)" + QByteArray::number(indices)
                             + R"(,"componentType":5121},"values":{"bufferView":)" + QByteArray::number(values) + "}}");
        QTest::newRow("sparse") << file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
    }
    {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        file.add(std::vector<float>{0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", kFloat);
        QTest::newRow("TEXCOORD_1 without TEXCOORD_0")
            << file.json(shown(R"("attributes":{"POSITION":0,"TEXCOORD_1":1},"mode":5)"));
    }
}

void TestImportGltf::readsTriangles()
{
    QFETCH(QByteArray, content);
    const auto result = imported(content);
    REQUIRE_MODEL(result);
    const Model &model = **result;
    QVERIFY(model.notes.empty());
    QCOMPARE(model.triangleCount(), std::size_t(2));
    const Mesh &mesh = model.meshes.front();
    double area = 0.0;
    for (std::size_t t = 0; t < 2; ++t) {
        const glm::dvec3 a = mesh.position(mesh.vertexAt(3 * t));
        const glm::dvec3 normal =
            glm::cross(mesh.position(mesh.vertexAt(3 * t + 1)) - a, mesh.position(mesh.vertexAt(3 * t + 2)) - a);
        QVERIFY2(normal.z > 0.0, "a triangle is turned over");
        area += glm::length(normal) / 2.0;
    }
    QVERIFY(std::abs(area - 1.0) < 1e-6);
}

void TestImportGltf::keepsTheDigitsOfFarNodes()
{
    // Child and parent lie far away, and what is shown has millimetres.
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    const auto result = imported(file.json(
        R"(,"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"translation":[4000000.125,500000.5,300],"children":[1]},
           {"translation":[0.123,0.0007,0],"scale":[0.001,0.001,0.001],"mesh":0}],
           "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}])"));
    REQUIRE_MODEL(result);
    const Mesh &mesh = (*result)->meshes.front();
    const glm::dvec3 corner = mesh.position(3);
    const glm::dvec3 expected(4000000.125 + 0.123 + 0.001, 500000.5 + 0.0007 + 0.001, 300.0);
    QVERIFY2(glm::length(corner - expected) < 2e-9, qPrintable(QString::number(glm::length(corner - expected))));
    QVERIFY(std::abs(glm::length(mesh.position(1) - mesh.position(0)) - 0.001) < 2e-9);
}

void TestImportGltf::appliesMorphWeights()
{
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    file.add(std::vector<float>{0, 0, 4, 0, 0, 4, 0, 0, 4, 0, 0, 4}, "VEC3", kFloat);
    const QByteArray primitive = R"("attributes":{"POSITION":0},"mode":5,"targets":[{"POSITION":1}])";
    const auto ofNode = imported(file.json(shown(primitive, R"(,"weights":[0.25])")));
    REQUIRE_MODEL(ofNode);
    QCOMPARE((*ofNode)->bounds.lowest.z, 1.0);
    const auto without = imported(file.json(shown(primitive)));
    REQUIRE_MODEL(without);
    QCOMPARE((*without)->bounds.highest.z, 0.0);
}

void TestImportGltf::readsColorsOfAllKinds_data()
{
    QTest::addColumn<QByteArray>("content");
    const auto row = [](const char *name, const auto &numbers, const char *type, int componentType, bool normalized) {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        file.add(numbers, type, componentType, normalized ? QByteArray(R"(,"normalized":true)") : QByteArray());
        QTest::newRow(name) << file.json(shown(R"("attributes":{"POSITION":0,"COLOR_0":1},"mode":5)"));
    };
    row("three floats", std::vector<float>{1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0}, "VEC3", kFloat, false);
    row("four bytes", std::vector<quint8>{255, 128, 0, 255, 255, 128, 0, 255, 255, 128, 0, 255, 255, 128, 0, 255},
        "VEC4", kUbyte, true);
    row("four shorts",
        std::vector<quint16>{65535, 32896, 0, 65535, 65535, 32896, 0, 65535, 65535, 32896, 0, 65535, 65535, 32896, 0,
                             65535},
        "VEC4", kUshort, true);
}

void TestImportGltf::readsColorsOfAllKinds()
{
    QFETCH(QByteArray, content);
    const auto result = imported(content);
    REQUIRE_MODEL(result);
    const Mesh &mesh = (*result)->meshes.front();
    QVERIFY(mesh.baseColor == glm::vec4(1.0f));
    QCOMPARE(mesh.colors.size(), std::size_t(4));
    for (const glm::u8vec4 &color : mesh.colors)
        QVERIFY(color == glm::u8vec4(255, 128, 0, 255));
}

void TestImportGltf::movesTextureCoordinates_data()
{
    QTest::addColumn<QByteArray>("transform");
    QTest::addColumn<double>("u");
    QTest::addColumn<double>("v");
    // Of (1/4, 1/2), v down, by translation * rotation * scale; the columns of the extension's rotation are (cos, -sin) and
    // (sin, cos).
    const double root = std::sqrt(3.0) / 2.0; // cos 30 degrees
    QTest::newRow("nothing") << QByteArray() << 0.25 << 0.5;
    QTest::newRow("scaled and moved") << QByteArray(R"("offset":[0.125,0.25],"scale":[2,0.5],)") << 0.625 << 0.5;
    QTest::newRow("turned") << QByteArray(R"("rotation":1.5707963267948966,)") << 0.5 << -0.25;
    QTest::newRow("turned by 30 degrees")
        << QByteArray(R"("rotation":0.5235987755982988,)") << 0.25 * root + 0.25 << -0.125 + 0.5 * root;
    // Scaled to (1/2, 1/4), turned to (1/4, -1/2), moved.
    QTest::newRow("all of it") << QByteArray(R"("offset":[0.125,0.25],"scale":[2,0.5],"rotation":1.5707963267948966,)")
                               << 0.375 << -0.25;
}

void TestImportGltf::movesTextureCoordinates()
{
    QFETCH(QByteArray, transform);
    QFETCH(double, u);
    QFETCH(double, v);
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    file.add(std::vector<float>{0.25f, 0.5f, 0.25f, 0.5f, 0.25f, 0.5f, 0.25f, 0.5f}, "VEC2", kFloat);
    const auto result =
        imported(file.json(shown(R"("attributes":{"POSITION":0,"TEXCOORD_1":1},"mode":5,"material":0)", {},
                                 R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":
                        {"KHR_texture_transform":{)"
                                     + transform + R"("texCoord":1}}}}}],
                        "textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)"
                                     + kPicture.toBase64() + "\"}]")));
    REQUIRE_MODEL(result);
    const Mesh &mesh = (*result)->meshes.front();
    QCOMPARE(mesh.texture, 0);
    QCOMPARE(mesh.texcoords.size(), std::size_t(4));
    QVERIFY(glm::distance(mesh.texcoords.front(), glm::vec2(glm::dvec2(u, 1.0 - v))) < 1e-6f);
}

void TestImportGltf::pointsAloneArePoints()
{
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    file.add(std::vector<quint32>{3, 1}, "SCALAR", kUint);
    const auto result = imported(file.json(shown(R"("attributes":{"POSITION":0},"indices":1,"mode":0)")));
    REQUIRE_MODEL(result);
    const Mesh &mesh = (*result)->meshes.front();
    QVERIFY(mesh.kind == Mesh::Kind::Points);
    QCOMPARE((*result)->pointCount(), std::size_t(2));
    QVERIFY(mesh.position(0) == glm::dvec3(1.0, 1.0, 0.0) && mesh.position(1) == glm::dvec3(1.0, 0.0, 0.0));
}

void TestImportGltf::saysWhatIsLeftOut_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("count");
    QTest::addColumn<QString>("detail");
    using Kind = ModelNote::Kind;
    {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        file.add(std::vector<quint16>{0, 1, 2, 2, 1, 4, 0, 1, 65535}, "SCALAR", kUshort);
        QTest::newRow("indices out of range") << file.json(shown(R"("attributes":{"POSITION":0},"indices":1)")) << 1
                                              << int(Kind::FacesLeftOut) << 2 << QString();
    }
    QTest::newRow("a skin") << quad(R"(,"skin":0)", R"(,"skins":[{"joints":[0]}])") << 2 << int(Kind::PartLeftOut) << 1
                            << "skin";
    QTest::newRow("animations") << quad({}, R"(,"animations":[{},{}])") << 2 << int(Kind::PartLeftOut) << 2
                                << "animation";
    QTest::newRow("instances that are not required")
        << quad(R"(,"extensions":{"EXT_mesh_gpu_instancing":{}})", R"(,"extensionsUsed":["EXT_mesh_gpu_instancing"])")
        << 2 << int(Kind::PartLeftOut) << 1 << "EXT_mesh_gpu_instancing";
    QTest::newRow("no scene") << quad().replace(R"("scenes":[{"nodes":[0]}],)", "") << 2 << int(Kind::SceneMissing) << 0
                              << QString();
    QTest::newRow("a picture of an unknown kind")
        << quad({}, R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{}])",
                R"(,"material":0)")
        << 2 << int(Kind::PictureUnknown) << 1 << QString();
    {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        QByteArray json = file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
        json.replace(R"("mode":5})", R"("mode":5},{"attributes":{}})");
        QTest::newRow("a part without positions") << json << 2 << int(Kind::PositionsMissing) << 1 << QString();
    }
    {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        QByteArray json = file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
        json.replace(R"("mode":5})",
                     R"("mode":5},{"attributes":{"POSITION":0},"mode":3},{"attributes":{"POSITION":0},"mode":0})");
        QTest::newRow("lines and points beside triangles") << json << 2 << int(Kind::LinesLeftOut) << 7 << QString();
    }
    QTest::newRow("a picture that is not there")
        << quad({},
                R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],
                "images":[{"uri":"nowhere.png"}])",
                R"(,"material":0)")
        << 2 << int(Kind::TextureMissing) << 0 << "nowhere.png";
}

void TestImportGltf::saysWhatIsLeftOut()
{
    QFETCH(QByteArray, content);
    QFETCH(int, triangles);
    QFETCH(int, kind);
    QFETCH(int, count);
    QFETCH(QString, detail);
    const auto result = imported(content);
    REQUIRE_MODEL(result);
    QCOMPARE(int((*result)->triangleCount()), triangles);
    QCOMPARE((*result)->notes.size(), std::size_t(1));
    const ModelNote &note = (*result)->notes.front();
    QCOMPARE(int(note.kind), kind);
    QCOMPARE(int(note.count), count);
    QCOMPARE(QString::fromStdString(note.detail), detail);
}

void TestImportGltf::refuses_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("detail");
    QTest::newRow("a mode that does not exist") << quad({}, {}, R"(,"mode":7)") << "mode 7";
    {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        file.add(std::vector<float>{0, 1, 2}, "SCALAR", kFloat);
        QTest::newRow("indices that are floats")
            << file.json(shown(R"("attributes":{"POSITION":0},"indices":1)")) << "integers";
        file.addAccessor(-1, kFloat, 1 << 20, "VEC3");
        QTest::newRow("many vertices out of nothing")
            << file.json(shown(R"("attributes":{"POSITION":2})")) << "without any bytes";
    }
    QTest::newRow("an accessor that does not exist")
        << quad().replace(R"("indices":1)", R"("indices":9)") << "number 9";
    QTest::newRow("a translation of two numbers") << quad(R"(,"translation":[1,2])") << "3 numbers";
    QTest::newRow("a buffer without bytes")
        << QByteArray(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":48}],"bufferViews":[{"buffer":0,
           "byteLength":48}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}])")
               + shown(R"("attributes":{"POSITION":0},"mode":5)") + '}'
        << "has no bytes";
    QTest::newRow("broken base64") << quad().replace("base64,", "base64,?") << "base64";
    {
        GltfBuilder file;
        file.addAccessor(-1, kFloat, 1 << 14, "VEC3");
        QByteArrayList nodes, roots;
        for (int i = 0; i < 4097; ++i) {
            nodes << R"({"mesh":0})";
            roots << QByteArray::number(i);
        }
        QTest::newRow("too many vertices")
            << file.json(R"(,"scenes":[{"nodes":[)" + roots.join(',') + R"(]}],"nodes":[)" + nodes.join(',')
                         + R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])")
            << "at most";
    }
}

void TestImportGltf::refuses()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, detail);
    const auto result = imported(content);
    QVERIFY(!result);
    QCOMPARE(int(result.error().code), int(ImportErrorCode::Malformed));
    QVERIFY2(QString::fromStdString(result.error().detail).contains(detail), result.error().detail.c_str());
}

void TestImportGltf::whatCannotBeShownIsNamed()
{
    for (const char *extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"}) {
        const auto result = imported(quad({}, ",\"extensionsRequired\":[\"" + QByteArray(extension) + "\"]"));
        QVERIFY(!result);
        QCOMPARE(int(result.error().code), int(ImportErrorCode::Unsupported));
        QVERIFY2(result.error().detail.find(extension) != std::string::npos, result.error().detail.c_str());
    }
}

void TestImportGltf::chunksNeedNoPadding_data()
{
    QTest::addColumn<bool>("isPadded");
    QTest::newRow("padded") << true;
    QTest::newRow("not padded") << false;
}

void TestImportGltf::chunksNeedNoPadding()
{
    QFETCH(bool, isPadded);
    const QByteArray json =
        QByteArray(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":48}],"bufferViews":[{"buffer":0,
           "byteLength":48}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}])")
        + shown(R"("attributes":{"POSITION":0},"mode":5)") + '}';
    const auto result = imported(glb(json, isPadded), QStringLiteral("model.glb"));
    REQUIRE_MODEL(result);
    QCOMPARE((*result)->triangleCount(), std::size_t(2));
}

void TestImportGltf::manyNodesTakeNoTime()
{
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    QByteArrayList nodes{R"({"mesh":0})"}, roots{"0"};
    for (int i = 1; i < 100000; ++i) {
        nodes << "{}";
        roots << QByteArray::number(i);
    }
    const auto result =
        imported(file.json(R"(,"scenes":[{"nodes":[)" + roots.join(',') + R"(]}],"nodes":[)" + nodes.join(',')
                           + R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}])"));
    REQUIRE_MODEL(result);
    QCOMPARE((*result)->triangleCount(), std::size_t(2));
}

QTEST_GUILESS_MAIN(TestImportGltf)
#include "test_import_gltf.moc"
