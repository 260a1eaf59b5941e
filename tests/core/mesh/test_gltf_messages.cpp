// glTF and GLB: errors, and import notes.

#include "tests/support/test.h"

#include "core/mesh/import/gltf_draco.h"
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
    void textsAreReadOrRefused_data() { data_files::addCases("gltf"); }

    void textsAreReadOrRefused()
    {
        QFETCH(data_files::Case, example);
        verifyCase(m_folder.imported("text.gltf", QByteArray::fromStdString(example.text)), example);
    }

    void saysWhatIsLeftOut_data()
    {
        addColumn<QByteArray>("content");
        addColumn<int>("triangles");
        addColumn<QByteArray>("note");
        for (const int missing : {4, 65535}) { // the first behind the last vertex, too
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            file.add(std::vector<quint16>{0, 1, 2, 2, 1, quint16(missing)}, "SCALAR", kUshort);
            addRow("index %d out of range", missing)
                << file.json(shown(R"("attributes":{"POSITION":0},"indices":1)")) << 1
                << QByteArray("1 face refers to vertices that the file does not have and cannot be shown");
        }
        for (const QByteArray &extension :
             QByteArray("KHR_texture_ktx KHR_texture_basisu KHR_techniques_webgl GOOGLE_texture_basis EXT_texture_avif "
                        "EXT_lights_image_based EXT_lights_ies KHR_lights_punctual NEEDLE_lighting_settings "
                        "KHR_animation_pointer VRM VRMC_vrm "
                        "EXT_mesh_features EXT_structural_metadata EXT_instance_features MSFT_lod MSFT_texture_dds "
                        "KHR_xmp_json_ld KHR_materials_variants KHR_materials_not_made_yet AGI_articulations "
                        "CESIUM_primitive_outline FB_ngon_encoding KHR_interactivity KHR_gaussian_splatting "
                        "MSFT_packing_occlusionRoughnessMetallic EXT_mesh_manifold NEEDLE_components OMI_seat "
                        "KHR_environment_map EXT_blend KHR_XMP EXT_textureInfo_extend MAXAR_collision_geometry "
                        "DRACO_animation_compression")
                 .split(' '))
            newRow(extension.constData()) << quad({}, ",\"extensionsRequired\":[\"" + extension + "\"]") << 2
                                          << "the glTF extension \"" + extension
                                                 + "\", which the file requires, is not applied: the shape is whole "
                                                   "without it, but colours, light, motion or data may be missing";
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            file.add(std::vector<quint16>{0, 1, 2, 2, 1}, "SCALAR", kUshort);
            newRow("indices of half a triangle")
                << file.json(shown(R"("attributes":{"POSITION":0},"indices":1)")) << 1
                << QByteArray("2 corners at the ends of parts of meshes make no whole triangles and are not used");
            newRow("vertices of a third")
                << file.json(shown(R"("attributes":{"POSITION":0})")) << 1
                << QByteArray("1 corner at the end of a part of a mesh makes no whole triangle and is not used");
        }
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            QByteArray json = file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
            json.replace(R"("mode":5})", R"("mode":5},{"attributes":{}})");
            newRow("a part without positions")
                << json << 2 << QByteArray("1 part of a mesh has no positions and is not shown");
        }
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            QByteArray json = file.json(shown(R"("attributes":{"POSITION":0},"mode":5)"));
            json.replace(R"("mode":5})",
                         R"("mode":5},{"attributes":{"POSITION":0},"mode":3},{"attributes":{"POSITION":0},"mode":0})");
            newRow("lines and points beside triangles") << json << 2 << QByteArray("7 lines and points are not shown");
        }
    }

    void saysWhatIsLeftOut()
    {
        QFETCH(QByteArray, content);
        QFETCH(int, triangles);
        QFETCH(QByteArray, note);
        const auto result = imported(content);
        REQUIRE_MODEL(result);
        QCOMPARE(int((*result)->triangleCount()), triangles);
        QCOMPARE(notesOf(**result), note);
    }

    void refuses_data()
    {
        addColumn<QByteArray>("content");
        addColumn<QString>("detail");
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            file.add(std::vector<float>{0, 1, 2}, "SCALAR", kFloat);
            newRow("indices that are floats")
                << file.json(shown(R"("attributes":{"POSITION":0},"indices":1)")) << "integers";
            file.addAccessor(-1, kFloat, 1 << 20, "VEC3");
            newRow("many vertices out of nothing")
                << file.json(shown(R"("attributes":{"POSITION":2})")) << "without any bytes";
        }
        {
            GltfBuilder file;
            file.addAccessor(-1, kFloat, 1 << 14, "VEC3");
            QByteArrayList nodes, roots;
            for (int i = 0; i < 4097; ++i) {
                nodes << R"({"mesh":0})";
                roots << QByteArray::number(i);
            }
            newRow("too many vertices") << file.json(R"(,"scenes":[{"nodes":[)" + roots.join(',') + R"(]}],"nodes":[)"
                                                     + nodes.join(',')
                                                     + R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])")
                                        << "at most";
        }
    }

    void refuses()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, detail);
        const auto result = imported(content);
        VERIFY_REFUSED(result, "the file is damaged: ");
        VERIFY_REFUSED(result, detail);
    }

    void whatCannotBeShownIsNamed_data()
    {
        addColumn<QByteArray>("content");
        addColumn<QString>("name");
        addColumn<QString>("detail");
        const QString gltf = QStringLiteral("model.gltf"), glbName = QStringLiteral("model.glb");
        for (const char *extension :
             {"KHR_meshopt_compression", "KHR_mesh_primitive_restart", "KHR_gaussian_splatting_compression_spz_2",
              "CESIUM_RTC", "ACME_shape", "ACME_lightweight_mesh", "EXT_geometry_image", "EXT_mesh_explode",
              "KHR_texture_displacement", "FB_ngon_mesh", "ACME_mesh_compression_metadata", "ACME_explode",
              "ACME_lighter", "OMI_mesh", "KHR_materials_Displacement"})
            newRow(extension) << quad({}, ",\"extensionsRequired\":[\"" + QByteArray(extension) + "\"]") << gltf
                              << extension + QStringLiteral(", which is not supported");
        for (const auto &[extension, library, isThere] :
             {std::tuple("KHR_draco_mesh_compression", "Draco", hasDraco()),
              std::tuple("EXT_meshopt_compression", "meshoptimizer", hasMeshopt())}) {
            if (!isThere)
                newRow(extension)
                    << quad({}, ",\"extensionsRequired\":[\"" + QByteArray(extension) + "\"]") << gltf
                    << QString("%1, and this program was built without the library %2").arg(extension, library);
        }
        newRow("GLB 1.0") << "glTF" + little(quint32(1)) + little(quint32(24)) + little(quint32(4)) + little(quint32(0))
                                 + "{}  "
                          << glbName << "it is glTF 1.0";
        {
            GltfBuilder file;
            file.add(kQuadCorners, "VEC3", kFloat);
            newRow("lines only") << file.json(shown(R"("attributes":{"POSITION":0},"mode":3)")) << gltf
                                 << "it holds lines only, and lines are not shown here: 3";
        }
    }

    void whatCannotBeShownIsNamed()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, name);
        QFETCH(QString, detail);
        const auto result = imported(content, name);
        VERIFY_REFUSED(result, "the file cannot be shown: ");
        VERIFY_REFUSED(result, detail);
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestGltfMessages, threads)
#include "test_gltf_messages.moc"
