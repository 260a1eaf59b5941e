// glTF and GLB: the parts of the format that the importer reads.

#include "tests/support/test.h"

#include "tests/core/mesh/gltf_builder.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace model_files;

class TestImportGltf : public QObject {
    Q_OBJECT

    auto imported(const QByteArray &content, const QString &name = QStringLiteral("model.gltf"))
    {
        return m_folder.imported(name, content);
    }

private slots:
    void readsTriangles_data()
    {
        addColumn<QByteArray>("content");
        {
            GltfBuilder file;
            file.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, "VEC3", kFloat);
            newRow("without indices") << file.json(shown(R"("attributes":{"POSITION":0})"));
        }
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            newRow("a strip") << file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
        }
        {
            GltfBuilder file;
            file.add(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0}, "VEC3", kFloat);
            newRow("a fan") << file.json(shown(R"("attributes":{"POSITION":0},"mode":6)"));
        }
        {
            GltfBuilder quantized;
            const int view =
                quantized.addView(std::vector<qint8>{0, 0, 0, 9, 127, 0, 0, 9, 0, 127, 0, 9, 127, 127, 0, 9});
            quantized.addAccessor(view, kByte, 4, "VEC3", R"(,"normalized":true)");
            QByteArray json = quantized.json(shown(R"("attributes":{"POSITION":0},"mode":5)", {},
                                                   R"(,"extensionsRequired":["KHR_mesh_quantization"])"));
            json.replace("\"byteLength\":16}", "\"byteLength\":16,\"byteStride\":4}");
            newRow("quantized, four bytes apart") << json;
        }
        {
            GltfBuilder file;
            const int indices = file.addView(std::vector<quint8>{1, 2, 3});
            const int values = file.addView(std::vector<float>{1, 0, 0, 0, 1, 0, 1, 1, 0});
            file.addAccessor(-1, kFloat, 4, "VEC3",
                             ",\"sparse\":{\"count\":3,\"indices\":{\"bufferView\":" + QByteArray::number(indices)
                                 + R"(,"componentType":5121},"values":{"bufferView":)" + QByteArray::number(values)
                                 + "}}");
            newRow("sparse") << file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
        }
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            file.add(std::vector<float>{0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", kFloat);
            newRow("TEXCOORD_1 without TEXCOORD_0")
                << file.json(shown(R"("attributes":{"POSITION":0,"TEXCOORD_1":1},"mode":5)"));
        }
    }

    void readsTriangles()
    {
        QFETCH(QByteArray, content);
        const auto result = imported(content);
        REQUIRE_MODEL(result);
        const Model &model = **result;
        QVERIFY(model.notes.empty());
        verifyQuad(model);
    }

    void placesByWhatSaysSomething()
    {
        const auto result = imported(quad(R"(,"translation":[1,2,3],"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])"));
        REQUIRE_MODEL(result);
        QVERIFY((*result)->bounds.lowest == glm::dvec3(1.0, 2.0, 3.0));
    }

    void keepsTheDigitsOfFarNodes()
    {
        // Child and parent lie far away, and the mesh has millimetres.
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

    void appliesMorphWeights()
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

    void showsInstances()
    {
        // A quad, at first turned by 180 degrees about z, then moved by 2 and three times as large;
        // both on a node that is moved.
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        file.add(std::vector<float>{0, 0, 0, 2, 0, 0}, "VEC3", kFloat);
        file.addAccessor(file.addView(std::vector<qint8>{0, 0, 127, 0, 0, 0, 0, 127}), kByte, 2, "VEC4",
                         R"(,"normalized":true)");
        file.add(std::vector<float>{1, 1, 1, 3, 3, 3}, "VEC3", kFloat);
        const QByteArray node = R"(,"translation":[10,0,0],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{
        "TRANSLATION":1,"ROTATION":2,"SCALE":3,"_ID":1}}})";
        const auto result = imported(file.json(shown(R"("attributes":{"POSITION":0},"mode":5)", node,
                                                     R"(,"extensionsRequired":["EXT_mesh_gpu_instancing"])")));
        REQUIRE_MODEL(result);
        QVERIFY((*result)->notes.empty());
        QCOMPARE((*result)->triangleCount(), std::size_t(4));
        const Mesh &mesh = (*result)->meshes.front();
        QVERIFY(glm::distance(mesh.position(3), glm::dvec3(9, -1, 0)) < 1e-6);
        QVERIFY(glm::distance(mesh.position(7), glm::dvec3(15, 3, 0)) < 1e-6);
    }

    void readsColorsOfAllKinds_data()
    {
        addColumn<QByteArray>("content");
        const auto row = [](const char *name, const auto &numbers, const char *type, int componentType,
                            bool normalized) {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            file.add(numbers, type, componentType, normalized ? QByteArray(R"(,"normalized":true)") : QByteArray());
            newRow(name) << file.json(shown(R"("attributes":{"POSITION":0,"COLOR_0":1},"mode":5)"));
        };
        row("three floats", std::vector<float>{1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0}, "VEC3", kFloat, false);
        row("four bytes", std::vector<quint8>{255, 128, 0, 255, 255, 128, 0, 255, 255, 128, 0, 255, 255, 128, 0, 255},
            "VEC4", kUbyte, true);
        row("four shorts",
            std::vector<quint16>{65535, 32896, 0, 65535, 65535, 32896, 0, 65535, 65535, 32896, 0, 65535, 65535, 32896,
                                 0, 65535},
            "VEC4", kUshort, true);
    }

    void readsColorsOfAllKinds()
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

    void movesTextureCoordinates_data()
    {
        addColumn<QByteArray>("transform");
        addColumn<double>("u");
        addColumn<double>("v");
        // The point (1/4, 1/2), v down, by translation * rotation * scale; the columns of the
        // extension's rotation are (cos, -sin) and (sin, cos).
        const double root = std::sqrt(3.0) / 2.0; // cos 30 degrees
        newRow("nothing") << QByteArray() << 0.25 << 0.5;
        newRow("scaled and moved") << QByteArray(R"("offset":[0.125,0.25],"scale":[2,0.5],)") << 0.625 << 0.5;
        newRow("turned") << QByteArray(R"("rotation":1.5707963267948966,)") << 0.5 << -0.25;
        newRow("turned by 30 degrees") << QByteArray(R"("rotation":0.5235987755982988,)") << 0.25 * root + 0.25
                                       << -0.125 + 0.5 * root;
        // Scaled to (1/2, 1/4), turned to (1/4, -1/2), moved.
        newRow("all of it") << QByteArray(R"("offset":[0.125,0.25],"scale":[2,0.5],"rotation":1.5707963267948966,)")
                            << 0.375 << -0.25;
    }

    void movesTextureCoordinates()
    {
        QFETCH(QByteArray, transform);
        QFETCH(double, u);
        QFETCH(double, v);
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        file.add(std::vector<float>{0.25f, 0.5f, 0.25f, 0.5f, 0.25f, 0.5f, 0.25f, 0.5f}, "VEC2", kFloat);
        const auto result = imported(file.json(shown(
            R"("attributes":{"POSITION":0,"TEXCOORD_1":1},"mode":5,"material":0)", {},
            ",\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":\n"
            "                        {\"KHR_texture_transform\":{"
                + transform
                + "\"texCoord\":1}}}}}],\n"
                  "                        \"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"data:image/png;base64,"
                + kPicture.toBase64() + "\"}]")));
        REQUIRE_MODEL(result);
        const Mesh &mesh = (*result)->meshes.front();
        QCOMPARE(mesh.texture, 0);
        QCOMPARE(mesh.texcoords.size(), std::size_t(4));
        QVERIFY(glm::distance(mesh.texcoords.front(), glm::vec2(glm::dvec2(u, 1.0 - v))) < 1e-6f);
    }

    void pointsAloneArePoints()
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

    void chunksNeedNoPadding_data()
    {
        addColumn<bool>("isPadded");
        newRow("padded") << true;
        newRow("not padded") << false;
    }

    void chunksNeedNoPadding()
    {
        QFETCH(bool, isPadded);
        const QByteArray json =
            QByteArray(
                "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":48}],\"bufferViews\":[{\"buffer\":0,\n"
                "           "
                "\"byteLength\":48}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":"
                "\"VEC3\"}]")
            + shown(R"("attributes":{"POSITION":0},"mode":5)") + '}';
        const QByteArray whole = glb(json, isPadded);
        const auto result = imported(whole, QStringLiteral("model.glb"));
        REQUIRE_MODEL(result);
        QCOMPARE((*result)->triangleCount(), std::size_t(2));
        QCOMPARE(notesOf(**result), QByteArray());

        const auto longer = imported(whole + "more", QStringLiteral("model.glb"));
        REQUIRE_MODEL(longer);
        QCOMPARE(notesOf(**longer), QByteArray("4 bytes behind all that the file declares are not used"));

        const auto shorter = imported(QByteArray(whole).replace(8, 4, little(quint32(whole.size() - 4))), "model.glb");
        VERIFY_REFUSED(
            shorter, QString("the header declares %1 bytes, the file has %2").arg(whole.size() - 4).arg(whole.size()));
    }

    void manyNodesTakeNoTime()
    {
        GltfBuilder file;
        file.add(kQuadCorners, "VEC3", kFloat);
        QByteArrayList nodes{R"({"mesh":0})"}, roots{"0"};
        for (int i = 1; i < 100000; ++i) {
            nodes << "{}";
            roots << QByteArray::number(i);
        }
        const auto result =
            imported(file.json(",\"scenes\":[{\"nodes\":[" + roots.join(',') + "]}],\"nodes\":[" + nodes.join(',')
                               + "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":5}]}]"));
        REQUIRE_MODEL(result);
        QCOMPARE((*result)->triangleCount(), std::size_t(2));
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestImportGltf, threads)
#include "test_import_gltf.moc"
