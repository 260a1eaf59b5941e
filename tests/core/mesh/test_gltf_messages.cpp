// glTF and GLB: errors, and import notes.

#include "tests/support/test.h"

#include "core/mesh/import/draco_mesh.h"
#include "core/mesh/import/meshopt_view.h"
#include "tests/core/mesh/gltf_builder.h"

#include <tuple>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::mesh::reader;
using namespace unprojector::mesh;
using namespace model_files;

class TestGltfMessages : public QObject {
    Q_OBJECT

    auto imported(const QByteArray &content, const QString &name = QStringLiteral("model.gltf"))
    {
        return m_folder.imported(name, content);
    }

private slots:
    void saysWhatIsLeftOut_data()
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
        QTest::newRow("a skin without weights")
            << quad(R"(,"skin":0)", R"(,"skins":[{"joints":[0]}])") << 2 << int(Kind::PartLeftOut) << 1 << "skin";
        for (const QByteArray &extension :
             QByteArray("KHR_texture_ktx KHR_texture_basisu KHR_techniques_webgl GOOGLE_texture_basis EXT_texture_avif "
                        "EXT_lights_image_based EXT_lights_ies KHR_lights_punctual KHR_animation_pointer VRM VRMC_vrm "
                        "EXT_mesh_features EXT_structural_metadata EXT_instance_features MSFT_lod MSFT_texture_dds "
                        "KHR_xmp_json_ld KHR_materials_variants KHR_materials_not_made_yet AGI_articulations "
                        "CESIUM_primitive_outline FB_ngon_encoding")
                 .split(' '))
            QTest::newRow(extension.constData()) << quad({}, ",\"extensionsRequired\":[\"" + extension + "\"]") << 2
                                                 << int(Kind::ExtensionLeftOut) << 0 << QString::fromLatin1(extension);
        QTest::newRow("a packed shape besides") << quad({}, R"(,"extensionsUsed":["KHR_meshopt_compression","ACME_x"])")
                                                << 2 << int(Kind::SubstituteShown) << 0 << "KHR_meshopt_compression";
        {
            QByteArray json = quad(R"(,"children":[1])");
            json.replace(
                R"("children":[1]})",
                R"("children":[1]},{"mesh":0,"children":[2],"extensions":{"KHR_node_visibility":{"visible":false}}},
                     {"mesh":0,"extensions":{"KHR_node_visibility":{"visible":true}}})");
            QTest::newRow("hidden nodes") << json << 2 << int(Kind::MeshesHidden) << 2 << QString();
        }
        QTest::newRow("another scene") << quad()
                                              .replace(R"("meshes":[)", R"("meshes":[{"primitives":[]},)")
                                              .replace(R"({"mesh":0})", R"({"mesh":1},{"mesh":0})")
                                              .replace(R"("scenes":[{"nodes":[0]}])",
                                                       R"("scenes":[{"nodes":[0]},{"nodes":[1]}])")
                                       << 2 << int(Kind::NodesLeftOut) << 1 << QString();
        QTest::newRow("meshes in no scene")
            << quad()
                   .replace(R"("meshes":[)", R"("meshes":[{"primitives":[]},{"primitives":[]},)")
                   .replace(R"({"mesh":0})",
                            R"({"mesh":2},{"children":[2,3,4]},{"mesh":0},{"mesh":0},{"mesh":2},{"mesh":-1})")
            << 2 << int(Kind::NodesLeftOut) << 2 << QString();
        QTest::newRow("a node twice in the scene") << quad().replace(R"("nodes":[0])", R"("nodes":[0,0,0])") << 2
                                                   << int(Kind::NodesListedAgain) << 2 << QString();
        QTest::newRow("all nodes in the scene")
            << quad()
                   .replace(R"("nodes":[0])", R"("nodes":[2,0,1,1])")
                   .replace(R"({"mesh":0})", R"({"children":[1]},{"children":[2]},{"mesh":0})")
            << 2 << int(Kind::NodesListedAgain) << 3 << QString();
        QTest::newRow("a mesh of no node") << quad()
                                                  .replace(R"("meshes":[)", R"("meshes":[{"primitives":[]},)")
                                                  .replace(R"({"mesh":0})", R"({"mesh":1})")
                                           << 2 << int(Kind::NodesLeftOut) << 1 << QString();
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            file.add(std::vector<quint16>{0, 1, 2, 2, 1}, "SCALAR", kUshort);
            QTest::newRow("indices of half a triangle")
                << file.json(shown(R"("attributes":{"POSITION":0},"indices":1)")) << 1 << int(Kind::CornersLeftOut) << 2
                << QString();
            QTest::newRow("vertices of a third") << file.json(shown(R"("attributes":{"POSITION":0})")) << 1
                                                 << int(Kind::CornersLeftOut) << 1 << QString();
        }
        QTest::newRow("animations") << quad({}, R"(,"animations":[{},{}])") << 2 << int(Kind::PartLeftOut) << 2
                                    << "animation";
        QTest::newRow("no scene") << quad().replace(R"("scenes":[{"nodes":[0]}],)", "") << 2 << int(Kind::SceneMissing)
                                  << 0 << QString();
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
            QTest::newRow("lines and points beside triangles")
                << json << 2 << int(Kind::LinesLeftOut) << 7 << QString();
        }
        QTest::newRow("a picture that is not there") << quad(
            {},
            R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],
                "images":[{"uri":"nowhere.png"}])",
            R"(,"material":0)") << 2 << int(Kind::TextureMissing)
                                                     << 0 << "nowhere.png";
    }

    void saysWhatIsLeftOut()
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

    void refuses_data()
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
            << quad().replace(R"("indices":1)", R"("indices":9)") << "index 9";
        QTest::newRow("a translation of two numbers") << quad(R"(,"translation":[1,2])") << "3 numbers";
        QTest::newRow("a matrix that divides") << quad(R"(,"name":"arm","matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2])")
                                               << "the matrix of node 0 \"arm\" has the last row 0 0 0 2";
        QTest::newRow("a matrix of rows") << quad(R"(,"matrix":[1,0,0,5,0,1,0,6,0,0,1,7,0,0,0,1])")
                                          << "the matrix of node 0 has the last row 5 6 7 1";
        QTest::newRow("a matrix and a translation")
            << quad(R"(,"translation":[1,2,3],"matrix":[2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])")
            << "node 0 has both \"matrix\" and \"translation\"";
        QTest::newRow("a child in the scene without its parent")
            << quad()
                   .replace(R"("nodes":[0])", R"("nodes":[2])")
                   .replace(R"({"mesh":0})", R"({"children":[1]},{"children":[2]},{"mesh":0})")
            << "the scene lists node 2, but not node 0 that it is below; list node 0 instead";
        QTest::newRow("a circle in the scene") << quad()
                                                      .replace(R"("nodes":[0])", R"("nodes":[0,1])")
                                                      .replace(R"({"mesh":0})", R"({"children":[1]},{"children":[0]})")
                                               << "the nodes form a circle";
        QTest::newRow("a key twice") << quad(R"(,"scale":[1,1,1],)"
                                             "\n"
                                             R"("scale":[2,2,2])")
                                     << "line 2, column 1: the key \"scale\" occurs twice in one JSON object";
        QTest::newRow("a stride that is too small")
            << quad().replace(R"("byteOffset":0)", R"("byteOffset":0,"byteStride":4)")
            << "\"byteStride\" is 4, less than the 12 bytes of one element";
        QTest::newRow("a view beyond what its buffer declares")
            << quad().replace(R"("buffers":[{"byteLength":60)", R"("buffers":[{"byteLength":52)")
            << "a buffer view goes beyond its buffer of 52 bytes";
        QTest::newRow("a rotation that is none")
            << quad(R"(,"rotation":[0,0,0,0])") << "the rotation of node 0 has the length 0";
        QTest::newRow("instances without a mesh's numbers")
            << quad(R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0,"SCALE":1}}})")
            << "the attribute SCALE of instances does not have 3 numbers for each of 4 instances";
        QTest::newRow("a word for a number")
            << quad(R"(,"translation":[1,"up",3])") << "\"up\" found where a number is expected";
        QTest::newRow("a negative count")
            << quad().replace(R"("count":4)", R"("count":-4)") << "\"count\" is -4, which is not a number in range";
        QTest::newRow("a list for an object") << quad({}, R"(,"extras":1)").replace(R"({"mesh":0})", "[1,2]")
                                              << "[1,2] found where an object with \"children\" is expected";
        QTest::newRow("an object for a list")
            << quad(R"(,"children":{})") << "\"children\" is {}, which is not an array";
        QTest::newRow("a number too large") << quad(R"(,"translation":[1,)"
                                                    "\n 1e400,3]")
                                            << "line 2, column 2: 1e400 is too large for a number";
        QTest::newRow("NaN") << quad(R"(,"translation":[)"
                                     "\n1,NaN,3]")
                             << "line 2, column 3: NaN found where a value is expected";
        QTest::newRow("the end is missing") << quad().chopped(1) << ": the file ends too early";
        QTest::newRow("a bracket too many") << quad().append('}') << ": } follows the end";
        QTest::newRow("no version") << quad().replace(R"("asset":{"version":"2.0"},)", "")
                                    << "\"version\" in \"asset\"";
        QTest::newRow("an extension that is a number")
            << quad({}, R"(,"extensionsRequired":[3])") << "extensionsRequired";
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

    void refuses()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, detail);
        const auto result = imported(content);
        QVERIFY(!result);
        QCOMPARE(int(result.error().code), int(ImportErrorCode::Malformed));
        QVERIFY2(QString::fromStdString(result.error().detail).contains(detail), result.error().detail.c_str());
    }

    void whatCannotBeShownIsNamed_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("name");
        QTest::addColumn<ImportErrorCode>("code");
        QTest::addColumn<QString>("detail");
        const QString gltf = QStringLiteral("model.gltf"), glbName = QStringLiteral("model.glb");
        for (const char *extension : {"KHR_meshopt_compression", "KHR_mesh_primitive_restart",
                                      "KHR_gaussian_splatting_compression_spz_2", "CESIUM_RTC"})
            QTest::newRow(extension) << quad({}, ",\"extensionsRequired\":[\"" + QByteArray(extension) + "\"]") << gltf
                                     << ImportErrorCode::Unsupported
                                     << extension + QStringLiteral(", which is not supported");
        for (const auto &[extension, library, isThere] :
             {std::tuple("KHR_draco_mesh_compression", "Draco", hasDraco()),
              std::tuple("EXT_meshopt_compression", "meshoptimizer", hasMeshopt())}) {
            if (!isThere)
                QTest::newRow(extension)
                    << quad({}, ",\"extensionsRequired\":[\"" + QByteArray(extension) + "\"]") << gltf
                    << ImportErrorCode::Unsupported
                    << QString("%1, and this program was built without the library %2").arg(extension, library);
        }
        for (const char *extension : {"ACME_shape", "KHR_shape", "khr_materials_unlit"})
            QTest::newRow(extension) << quad({}, ",\"extensionsRequired\":[\"" + QByteArray(extension) + "\"]") << gltf
                                     << ImportErrorCode::Unsupported
                                     << extension + QStringLiteral(", which is not known here");
        QTest::newRow("glTF 1.0") << quad().replace("2.0", "1.0") << gltf << ImportErrorCode::Unsupported
                                  << "it is glTF 1.0, and only glTF 2.0 can be read; convert it";
        QTest::newRow("glTF 1.0 that does not say so") << QByteArray(R"({"meshes":{"box":{}},"nodes":{"root":{}}})")
                                                       << gltf << ImportErrorCode::Unsupported << "it is glTF 1.0";
        QTest::newRow("GLB 1.0") << "glTF" + little(quint32(1)) + little(quint32(24)) + little(quint32(4))
                                        + little(quint32(0)) + "{}  "
                                 << glbName << ImportErrorCode::Unsupported << "it is glTF 1.0";
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            QTest::newRow("lines only") << file.json(shown(R"("attributes":{"POSITION":0},"mode":3)")) << gltf
                                        << ImportErrorCode::NoTriangles
                                        << "it holds lines only, and lines are not shown here: 3";
        }
        QTest::newRow("all is hidden") << quad(R"(,"extensions":{"KHR_node_visibility":{"visible":false}})") << gltf
                                       << ImportErrorCode::NoTriangles << "hides all nodes";
        QTest::newRow("an empty scene") << quad().replace(R"("nodes":[0])", R"("nodes":[])") << gltf
                                        << ImportErrorCode::NoTriangles
                                        << "no mesh is in the scene that the file opens with; meshes in the file: 1";
        QTest::newRow("nothing") << QByteArray(R"({"asset":{"version":"2.0"}})") << gltf << ImportErrorCode::NoTriangles
                                 << QString();
    }

    void whatCannotBeShownIsNamed()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, name);
        QFETCH(ImportErrorCode, code);
        QFETCH(QString, detail);
        const auto result = imported(content, name);
        VERIFY_REFUSED(result, code, detail);
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestGltfMessages, threads)
#include "test_gltf_messages.moc"
