// glTF meshes that Draco packs: the test packs them itself.

#include "tests/support/test.h"

#include "tests/core/mesh/gltf_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

#ifdef UNPROJECTOR_DRACO
#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>
#include <draco/metadata/geometry_metadata.h>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace model_files;

namespace {

constexpr int kSide = 12; ///< vertices along an edge of the sheet
constexpr int kVertices = kSide * kSide;
constexpr int kTriangles = 2 * (kSide - 1) * (kSide - 1);

/// A sheet of squares; each vertex has unique numbers. Its texture coordinates have 0.5 in common.
struct Sheet {
    std::vector<float> positions, normals, texcoords, weights;
    std::vector<quint8> colors, joints;
    std::vector<std::array<quint32, 3>> triangles;

    Sheet()
    {
        for (int v = 0; v < kVertices; ++v) {
            const int x = v % kSide, y = v / kSide;
            for (const float number : {0.25f * float(x), 0.5f * float(y), 0.125f * float((x * 5 + y * 3) % 7)})
                positions.push_back(number);
            for (int axis = 0; axis < 3; ++axis)
                normals.push_back(axis == v % 3 ? 1.0f : 0.0f);
            texcoords.insert(texcoords.end(), {float(x) / 16.0f, float(y) / 16.0f});
            for (const int number : {v, 255 - v, (7 * v) % 256, 255})
                colors.push_back(quint8(number));
            for (const int number : {v % 2, 0, 0, 0})
                joints.push_back(quint8(number));
            weights.insert(weights.end(), {1.0f, 0.0f, 0.0f, 0.0f});
        }
        for (quint32 y = 0; y + 1 < kSide; ++y) {
            for (quint32 x = 0; x + 1 < kSide; ++x) {
                const quint32 a = y * kSide + x;
                triangles.push_back({a, a + 1, a + kSide + 1});
                triangles.push_back({a, a + kSide + 1, a + kSide});
            }
        }
    }
};

/// A corner in the form for comparison: position and colour.
using Corner = std::array<double, 6>;
using Triangle = std::array<Corner, 3>;

/// Rotates the triangle to begin at its smallest corner, so that only its orientation counts.
Triangle begunAtSmallest(Triangle triangle)
{
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    return triangle;
}

std::multiset<Triangle> trianglesOf(const Sheet &sheet)
{
    std::multiset<Triangle> all;
    for (const auto &corners : sheet.triangles) {
        Triangle triangle;
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                triangle[c][axis] = double(sheet.positions[std::size_t{3} * corners[c] + axis]);
                triangle[c][3 + axis] = sheet.colors[std::size_t{4} * corners[c] + axis];
            }
        }
        all.insert(begunAtSmallest(triangle));
    }
    return all;
}

std::multiset<Triangle> trianglesOf(const Mesh &mesh)
{
    std::multiset<Triangle> all;
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
        Triangle triangle;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t vertex = mesh.vertexAt(3 * t + c);
            const glm::dvec3 position = mesh.position(vertex);
            for (int axis = 0; axis < 3; ++axis) {
                triangle[c][std::size_t(axis)] = position[axis];
                triangle[c][std::size_t(axis) + 3] = mesh.colors[vertex][axis];
            }
        }
        all.insert(begunAtSmallest(triangle));
    }
    return all;
}

/// A test's packed data and options.
struct Packing {
    int method = draco::MESH_EDGEBREAKER_ENCODING;
    int positionBits = 0; ///< 0: floats as they are
    bool hasMetadata = false;
};

class DracoSheet {
public:
    explicit DracoSheet(const Packing &packing)
    {
        const Sheet sheet;
        m_mesh.set_num_points(kVertices);
        for (const auto &[a, b, c] : sheet.triangles)
            m_mesh.AddFace({draco::PointIndex(a), draco::PointIndex(b), draco::PointIndex(c)});
        using Attribute = draco::GeometryAttribute;
        add("POSITION", Attribute::POSITION, draco::DT_FLOAT32, 3, sheet.positions);
        add("NORMAL", Attribute::NORMAL, draco::DT_FLOAT32, 3, sheet.normals);
        add("TEXCOORD_0", Attribute::TEX_COORD, draco::DT_FLOAT32, 2, sheet.texcoords);
        add("COLOR_0", Attribute::COLOR, draco::DT_UINT8, 4, sheet.colors);
        add("JOINTS_0", Attribute::GENERIC, draco::DT_UINT8, 4, sheet.joints);
        add("WEIGHTS_0", Attribute::GENERIC, draco::DT_FLOAT32, 4, sheet.weights);
        if (packing.hasMetadata) {
            auto metadata = std::make_unique<draco::GeometryMetadata>();
            metadata->AddEntryString("maker", "a test");
            m_mesh.AddMetadata(std::move(metadata));
        }
        draco::ExpertEncoder encoder(m_mesh);
        encoder.SetEncodingMethod(packing.method);
        if (packing.positionBits > 0)
            encoder.SetAttributeQuantization(0, packing.positionBits);
        draco::EncoderBuffer buffer;
        if (encoder.EncodeToBuffer(&buffer).ok())
            bytes = QByteArray(buffer.data(), qsizetype(buffer.size()));
    }

    /// @param node  more of the node that shows it
    /// @param vertices  as the file declares them
    QByteArray gltf(const QByteArray &node = {}, const QByteArray &more = {}, int vertices = kVertices,
                    int triangles = kTriangles) const
    {
        return gltfOf(bytes, node, more, vertices, triangles);
    }
    QByteArray gltfOf(const QByteArray &packed, const QByteArray &node = {}, const QByteArray &more = {},
                      int vertices = kVertices, int triangles = kTriangles) const
    {
        GltfBuilder file;
        const int view = file.addView(std::vector<char>(packed.begin(), packed.end()));
        const int indices = file.addAccessor(-1, kUshort, 3 * triangles, "SCALAR");
        QByteArrayList attributes, ids;
        for (const Named &named : m_named) {
            const int accessor = file.addAccessor(-1, named.componentType, vertices, named.type,
                                                  named.isNormalized ? R"(,"normalized":true)" : "");
            attributes << '"' + named.name + "\":" + QByteArray::number(accessor);
            ids << '"' + named.name + "\":" + QByteArray::number(named.id);
        }
        return file.json(shown(R"("indices":)" + QByteArray::number(indices) + R"(,"material":0,"attributes":{)"
                                   + attributes.join(',')
                                   + R"(},"extensions":{"KHR_draco_mesh_compression":{"bufferView":)"
                                   + QByteArray::number(view) + R"(,"attributes":{)" + ids.join(',') + "}}}",
                               node,
                               R"(,"extensionsRequired":["KHR_draco_mesh_compression"],
            "extensionsUsed":["KHR_draco_mesh_compression"],
            "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],
            "images":[{"uri":"data:image/png;base64,iVBORw0KGgo="}])"
                                   + more));
    }

    QByteArray bytes;

private:
    struct Named {
        QByteArray name;
        std::uint32_t id;
        int componentType;
        const char *type;
        bool isNormalized;
    };

    template <class Number>
    void add(const char *name, draco::GeometryAttribute::Type kind, draco::DataType type, int components,
             const std::vector<Number> &numbers)
    {
        const bool isNormalized = kind == draco::GeometryAttribute::COLOR;
        draco::GeometryAttribute attribute;
        attribute.Init(kind, nullptr, std::uint8_t(components), type, isNormalized,
                       std::int64_t(sizeof(Number)) * components, 0);
        const int number = m_mesh.AddAttribute(attribute, true, kVertices);
        for (std::uint32_t v = 0; v < kVertices; ++v)
            m_mesh.attribute(number)->SetAttributeValue(draco::AttributeValueIndex(v),
                                                        &numbers[v * std::size_t(components)]);
        m_named.push_back({name, m_mesh.attribute(number)->unique_id(), sizeof(Number) == 1 ? kUbyte : kFloat,
                           components == 2   ? "VEC2"
                           : components == 3 ? "VEC3"
                                             : "VEC4",
                           isNormalized});
    }

    draco::Mesh m_mesh;
    std::vector<Named> m_named;
};

} // namespace

class TestGltfDraco : public QObject {
    Q_OBJECT

    auto imported(const QByteArray &content) { return m_folder.imported(QStringLiteral("model.gltf"), content); }

private slots:
    void unpacksEveryVertex_data()
    {
        addColumn<int>("method");
        addColumn<bool>("hasMetadata");
        newRow("sequential") << int(draco::MESH_SEQUENTIAL_ENCODING) << false;
        newRow("edgebreaker") << int(draco::MESH_EDGEBREAKER_ENCODING) << false;
        newRow("sequential, with metadata") << int(draco::MESH_SEQUENTIAL_ENCODING) << true;
        newRow("edgebreaker, with metadata") << int(draco::MESH_EDGEBREAKER_ENCODING) << true;
    }

    void unpacksEveryVertex()
    {
        QFETCH(int, method);
        QFETCH(bool, hasMetadata);
        const DracoSheet packed({method, 0, hasMetadata});
        QVERIFY(!packed.bytes.isEmpty());
        const auto result = imported(packed.gltf());
        REQUIRE_MODEL(result);
        const Model &model = **result;
        QCOMPARE(model.meshes.size(), std::size_t(1));
        const Mesh &mesh = model.meshes.front();
        QCOMPARE(model.fileVertices, std::size_t(kVertices));
        QVERIFY(trianglesOf(mesh) == trianglesOf(Sheet()));
        // Each vertex has the normal and the texture coordinates of its place.
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        QCOMPARE(mesh.texcoords.size(), mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::dvec3 position = mesh.position(v);
            const int x = int(position.x / 0.25), y = int(position.y / 0.5);
            QCOMPARE(mesh.normals[v][(y * kSide + x) % 3], 1.0f);
            QCOMPARE(mesh.texcoords[v].x, float(x) / 16.0f);
            QCOMPARE(mesh.texcoords[v].y, 1.0f - float(y) / 16.0f);
        }
    }

    void keepsThePositionsThatDracoMakes()
    {
        constexpr int kBits = 6;
        const DracoSheet packed({draco::MESH_EDGEBREAKER_ENCODING, kBits, false});
        const auto result = imported(packed.gltf());
        REQUIRE_MODEL(result);
        draco::DecoderBuffer buffer;
        buffer.Init(packed.bytes.constData(), std::size_t(packed.bytes.size()));
        const auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer).value();
        const draco::PointAttribute *positions = mesh->GetNamedAttribute(draco::GeometryAttribute::POSITION);
        Box box;
        for (std::uint32_t v = 0; v < mesh->num_points(); ++v) {
            std::array<float, 3> place;
            positions->GetMappedValue(draco::PointIndex(v), place.data());
            box.add(glm::dvec3(glm::vec3(place[0], place[1], place[2])));
        }
        QVERIFY((*result)->bounds.lowest == box.lowest && (*result)->bounds.highest == box.highest);
        // A step of the sheet's length in 6 bits is the most that the packing moves a vertex.
        const Mesh &read = (*result)->meshes.front();
        const double step = 0.5 * (kSide - 1) / ((1 << kBits) - 1);
        QCOMPARE((*result)->triangleCount(), std::size_t(kTriangles));
        for (std::size_t v = 0; v < read.positions.size(); ++v) {
            const glm::dvec3 position = read.position(v);
            QVERIFY(std::abs(position.x / 0.25 - std::round(position.x / 0.25)) <= step / 0.25);
        }
    }

    void skinsGoWithTheirJoints()
    {
        const DracoSheet packed({});
        QByteArray json = packed.gltf(R"(,"skin":0)", R"(,"skins":[{"joints":[1,2]}])");
        json.replace(R"("nodes":[{"mesh":0)", R"("nodes":[{"children":[1,2],"mesh":0)");
        json.replace(R"("skin":0}])", R"("skin":0},{},{"translation":[0,0,100]}])");
        const auto result = imported(json);
        REQUIRE_MODEL(result);
        const Mesh &mesh = (*result)->meshes.front();
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::dvec3 position = mesh.position(v);
            const int vertex = int(position.y / 0.5) * kSide + int(position.x / 0.25);
            QCOMPARE(position.z > 50.0, vertex % 2 == 1);
        }
    }

    void unpacksEachMeshOnce()
    {
        QByteArray json = DracoSheet({}).gltf();
        json.replace(R"("nodes":[0]}],"nodes":[{"mesh":0}])",
                     R"("nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"translation":[0,0,9]}])");
        const auto result = imported(json);
        REQUIRE_MODEL(result);
        QCOMPARE((*result)->triangleCount(), std::size_t(2 * kTriangles));
        QCOMPARE((*result)->bounds.highest.z, 9.0 + 0.125 * 6);
    }

    void refusesWhatContradictsTheFile_data()
    {
        addColumn<QByteArray>("content");
        addColumn<QString>("detail");
        const DracoSheet packed({});
        const QByteArray json = packed.gltf();
        newRow("fewer triangles") << packed.gltf({}, {}, kVertices, 9)
                                  << QString("have %1 triangles, and the file declares 9").arg(kTriangles);
        newRow("more triangles")
            << packed.gltf({}, {}, kVertices, kTriangles + 1)
            << QString("have %1 triangles, and the file declares %2").arg(kTriangles).arg(kTriangles + 1);
        newRow("fewer vertices") << packed.gltf({}, {}, 100)
                                 << QString("have %1 vertices, and the file declares 100").arg(kVertices);
        newRow("more vertices") << packed.gltf({}, {}, 200)
                                << QString("have %1 vertices, and the file declares 200").arg(kVertices);
        newRow("an attribute that is not there") << QByteArray(json).replace(
            R"("attributes":{"POSITION":0,"NORMAL":1)", R"("attributes":{"POSITION":0,"NORMAL":77)")
                                                 << "have no attribute 77";
        newRow("no positions") << QByteArray(json).replace(R"("attributes":{"POSITION":0,)", R"("attributes":{)")
                               << "lacks its positions or its indices";
        newRow("lines") << QByteArray(json).replace(R"("material":0,)", R"("material":0,"mode":1,)")
                        << "has the mode 1, which is not one of triangles";
        newRow("no view") << QByteArray(json).replace(R"("KHR_draco_mesh_compression":{"bufferView":0)",
                                                      R"("KHR_draco_mesh_compression":{"bufferView":5)")
                          << "index 5";
        {
            DracoSheet old(Packing{});
            old.bytes[6] = 1;
            newRow("an old version") << old.gltf() << "are of version 2.1, and glTF has version 2.2";
        }
        {
            DracoSheet cloud(Packing{});
            cloud.bytes[7] = 0;
            newRow("points") << cloud.gltf() << "hold points, and not triangles";
        }
        {
            DracoSheet none(Packing{});
            none.bytes = "no data of Draco";
            newRow("other values") << none.gltf() << "are damaged";
        }
    }

    void refusesWhatContradictsTheFile()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, detail);
        VERIFY_REFUSED(imported(content), detail);
    }

    void damagedDataGiveAMessage_data() { unpacksEveryVertex_data(); }

    /// Bytes changed, and the data cut off: a model of other numbers, or a message.
    void damagedDataGiveAMessage()
    {
        QFETCH(int, method);
        QFETCH(bool, hasMetadata);
        const DracoSheet whole({method, 8, hasMetadata});
        int refused = 0;
        const auto tryOut = [&](const QByteArray &bytes) {
            const auto result = imported(whole.gltfOf(bytes));
            if (result)
                return;
            ++refused;
            QVERIFY(result.error().text.starts_with("the file is damaged")
                    || result.error().text.starts_with("vertex"));
        };
        // The whole beginning, which holds the counts, and a sample of the rest.
        for (qsizetype i = 0; i < whole.bytes.size(); i += i < 64 ? 1 : 37) {
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

class TestGltfDraco : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QSKIP("built without Draco"); }
};

#endif

UNPROJECTOR_TEST(TestGltfDraco, threads)
#include "test_gltf_draco.moc"
