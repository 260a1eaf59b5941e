#include "tests/support/test.h"

#include "core/base/path_text.h"
#include "tests/core/mesh/imported.h"

#include <QStringConverter>

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace model_files;

static void addFormatRows()
{
    addColumn<QString>("name");
    addColumn<QByteArray>("content");
    newRow("obj") << "box.obj" << objBox();
    newRow("stl-ascii") << "box.stl" << stlText();
    newRow("stl-binary") << "box binary.stl" << stlBinary();
    newRow("ply-ascii") << "box.ply" << plyText();
    newRow("ply-little-endian") << "box little.ply" << plyLittle();
    newRow("ply-big-endian") << "box big.ply" << plyBig();
    newRow("off") << "box.off" << offBox();
    newRow("off-binary") << "box binary.off" << offBinary();
    newRow("gltf") << "box.gltf" << gltfBox();
    newRow("glb") << "box.glb" << glbBox();
}

namespace {

/// A wavy grid with so many points each way that all cores read its text in parts.
constexpr int kGridPoints = 260;

QByteArray gridWords(int i)
{
    const int column = i % kGridPoints, row = i / kGridPoints;
    const double x = column, y = row;
    return QByteArray::number(x * 0.1, 'f', 7) + ' ' + QByteArray::number(y * 0.1, 'f', 7) + ' '
           + QByteArray::number(std::sin(x * 0.2) + std::cos(y * 0.3), 'f', 7);
}

glm::dvec3 gridPoint(int i)
{
    static const std::vector<glm::dvec3> kPoints = [] {
        std::vector<glm::dvec3> points;
        for (int k = 0; k < kGridPoints * kGridPoints; ++k) {
            const QList<QByteArray> words = gridWords(k).split(' ');
            points.emplace_back(words[0].toDouble(), words[1].toDouble(), words[2].toDouble());
        }
        return points;
    }();
    return kPoints[static_cast<std::size_t>(i)];
}

std::vector<std::array<int, 3>> gridTriangles()
{
    std::vector<std::array<int, 3>> triangles;
    for (int y = 0; y + 1 < kGridPoints; ++y) {
        for (int x = 0; x + 1 < kGridPoints; ++x) {
            const int a = y * kGridPoints + x;
            triangles.push_back({a, a + 1, a + kGridPoints + 1});
            triangles.push_back({a, a + kGridPoints + 1, a + kGridPoints});
        }
    }
    return triangles;
}

/// @param lineEnd  and blank lines here and there
QByteArray gridPly(const QByteArray &lineEnd)
{
    const auto triangles = gridTriangles();
    QByteArray text = "ply\nformat ascii 1.0\nelement vertex " + QByteArray::number(kGridPoints * kGridPoints)
                      + "\nproperty double x\nproperty double y\nproperty double z\nelement face "
                      + QByteArray::number(qsizetype(triangles.size()))
                      + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < kGridPoints * kGridPoints; ++i)
        text += gridWords(i) + "\n" + (i % 1000 == 999 ? " \t\n" : "");
    for (const auto &[a, b, c] : triangles)
        text += "3 " + QByteArray::number(a) + ' ' + QByteArray::number(b) + ' ' + QByteArray::number(c) + "\n";
    return lineEnd == "\n" ? text : text.replace("\n", lineEnd);
}

QByteArray gridStl(const QByteArray &lineEnd)
{
    QByteArray text = "solid facet by facet\n";
    for (const auto &triangle : gridTriangles()) {
        text += "  facet normal 0 0 nan\n outer loop\n";
        for (const int i : triangle)
            text += "   vertex " + gridWords(i) + "\n";
        text += " endloop\n endfacet\n";
    }
    text += "endsolid\n";
    return lineEnd == "\n" ? text : text.replace("\n", lineEnd);
}

} // namespace

class TestMeshImport : public QObject {
    Q_OBJECT

    auto imported(const QString &name, const QByteArray &content) { return m_folder.imported(name, content); }

private slots:
    void readsTheBoxOfEveryFormat_data()
    {
        addFormatRows();
        newRow("obj-crlf") << "crlf.obj" << objBox().replace("\n", "\r\n");
        newRow("ply-crlf") << "crlf.ply" << plyText().replace("\n", "\r\n");
        newRow("stl-crlf") << "crlf.stl" << stlText().replace("\n", "\r\n");
        newRow("upper-case-suffix") << "BOX.OBJ" << objBox();
        newRow("non-ascii-name") << QString::fromUtf8("模型 é.obj") << objBox();
        newRow("non-ascii-gltf") << QString::fromUtf8("模型 é.gltf") << gltfBox();
        newRow("no-line-end-at-end") << "chopped.ply" << plyText().chopped(1);
        newRow("obj-negative-indices")
            << "negative.obj" << objBox("f -8 -5 -6 -7\nf -4 -3 -2 -1\n").replace("f 1 4 3 2\nf 5 6 7 8\n", "");
    }

    void readsTheBoxOfEveryFormat()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        const auto result = imported(name, content);
        REQUIRE_MODEL(result);
        const Model &model = **result;
        QCOMPARE(QString::fromStdString(model.name), QFileInfo(name).completeBaseName());
        QCOMPARE(model.triangleCount(), std::size_t{12});
        QCOMPARE(model.meshes.size(), std::size_t{1});
        QVERIFY(model.bounds.lowest == glm::dvec3(-1, 0, 0));
        QVERIFY(model.bounds.highest == glm::dvec3(2, 1, 2));
        const Mesh &mesh = model.meshes.front();
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        const glm::vec3 middle(0.5f, 0.5f, 1.0f);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]];
            const glm::vec3 out = glm::normalize(
                glm::cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a));
            QVERIFY2(glm::dot(out, a - middle) > 0.0f, "a triangle winds the wrong way round");
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY2(glm::dot(mesh.normals[mesh.indices[i + c]], out) > 0.9999f, "a hard edge was smoothed");
        }
    }

    void readsTextInUtf16_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        newRow("obj") << "utf16.obj" << objBox();
        newRow("stl") << "utf16.stl" << stlText();
        newRow("ply") << "utf16.ply" << plyText();
        newRow("off") << "utf16.off" << offBox();
    }

    void readsTextInUtf16()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        const auto marked = imported(name, "\xef\xbb\xbf" + content);
        VERIFY_BOX_WITH_NOTES(marked, QByteArray());
        for (const auto encoding : {QStringConverter::Utf16LE, QStringConverter::Utf16BE}) {
            QStringEncoder encoder(encoding, QStringConverter::Flag::WriteBom);
            const QByteArray encoded = encoder.encode(QString::fromUtf8(content));
            const auto box = imported(name, encoded);
            VERIFY_BOX_WITH_NOTES(box, QByteArray());
        }
    }

    void refusesTextWithZeros()
    {
        // A file without a byte order mark does not show that it is UTF-16.
        QStringEncoder encoder(QStringConverter::Utf16LE);
        const QByteArray encoded = encoder.encode(QString::fromUtf8(objBox()));
        const auto zeros = imported("zeros.obj", encoded);
        VERIFY_REFUSED(zeros, QString("line 1: the text has a byte 0"));
        const auto one = imported("one.obj", objBox() + QByteArray("v 1 \0 2 3\n", 10));
        VERIFY_REFUSED(one, QString("the text has a byte 0"));
    }

    void readsColors_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        addColumn<bool>("ofVertices");
        write("paint box.mtl", "newmtl blue\nKd 0.25 0.5 0.75\n");
        newRow("obj-mtl") << "painted.obj" << objBox("mtllib paint box.mtl\nusemtl blue\n") << false;
        newRow("gltf-factor") << "painted.gltf" << gltfBox() << false;
        newRow("glb-factor") << "painted.glb" << glbBox() << false;
        newRow("ply-vertices") << "painted.ply"
                               << plyText({}, "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                                          " 64 128 191")
                               << true;
        newRow("ply-float-vertices") << "painted.ply"
                                     << plyText({}, "property float red\nproperty float green\nproperty float blue\n",
                                                " 0.25 0.5 0.75")
                                     << true;
        newRow("off-integers") << "painted.off" << offBox("COFF", " 64 128 191 255") << true;
        newRow("off-shares") << "painted.off" << offBox("COFF", " 0.25 0.5 0.75 1.0") << true;
        newRow("off-faces") << "painted.off"
                            << offBox().replace("\n4 ", "\n 4 ").replace("4 1 2 6 5\n", "4 1 2 6 5 64 128 191\n")
                            << false;
        newRow("stl-bits") << "painted.stl" << stlBinary(-1, 0x8000 | 8 << 10 | 16 << 5 | 23) << true;
    }

    void readsColors()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(bool, ofVertices);
        const auto result = imported(name, content);
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        if (QByteArray(QTest::currentDataTag()) == "off-faces") {
            QVERIFY(std::count(mesh.colors.begin(), mesh.colors.end(), glm::u8vec4(64, 128, 191, 255)) == 4);
        } else if (!ofVertices) {
            QVERIFY(mesh.colors.empty());
            QVERIFY(glm::distance(mesh.baseColor, glm::vec4(0.25f, 0.5f, 0.75f, 1.0f)) < 1e-6f);
        } else {
            QVERIFY(mesh.baseColor == glm::vec4(1.0f));
            QCOMPARE(mesh.colors.size(), mesh.positions.size());
            for (const glm::u8vec4 &color : mesh.colors) {
                // Five bits a channel is what STL has.
                QVERIFY(std::abs(color.r - 64) <= 4 && std::abs(color.g - 128) <= 4 && std::abs(color.b - 191) <= 4);
                QCOMPARE(int(color.a), 255);
            }
        }
    }

    void readsTextures_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        write(QString::fromUtf8("my 图.png"), kPicture);
        write("skin.mtl", QByteArray("newmtl skin\nKd 1 1 1\nmap_Kd my 图.png\n"));
        write("windows.mtl", QByteArray("newmtl skin\nKd 1 1 1\nmap_Kd C:\\work\\my 图.png\n"));
        const QByteArray obj = objBox("vt 0.25 0.9\nusemtl skin\n", "/1");
        newRow("obj") << "skin.obj"
                      << "mtllib skin.mtl\n" + obj;
        newRow("obj-crlf") << "skin crlf.obj" << QByteArray("mtllib skin.mtl\n" + obj).replace("\n", "\r\n");
        newRow("obj-path-of-another-disk") << "skin2.obj"
                                           << "mtllib windows.mtl\n" + obj;
        newRow("ply") << "skin.ply"
                      << plyText(QByteArray("comment TextureFile my 图.png\n"), "property float s\nproperty float t\n",
                                 " 0.25 0.9");
        newRow("gltf") << "skin.gltf" << gltfBox({}, QByteArray(R"("uri":"my 图.png")"));
        newRow("gltf-percent") << "skin.gltf" << gltfBox({}, R"("uri":"my%20%E5%9B%BE.png")");
        newRow("gltf-data-uri") << "skin.gltf"
                                << gltfBox({}, "\"uri\":\"data:image/png;base64," + kPicture.toBase64() + '"');
        newRow("glb-embedded") << "skin.glb" << glbBox(R"("bufferView":3,"mimeType":"image/png")");
        newRow("glb-external") << "skin.glb" << glbBox(QByteArray(R"("uri":"my 图.png")"));
    }

    void readsTextures()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        const auto result = imported(name, content);
        REQUIRE_MODEL(result);
        const Model &model = **result;
        QCOMPARE(model.triangleCount(), std::size_t{12});
        QCOMPARE(model.textures.size(), std::size_t{1});
        const std::vector<std::uint8_t> &encoded = model.textures.front().encoded;
        QCOMPARE(bytesOf(encoded.data(), int(encoded.size())), kPicture);
        const Mesh &mesh = model.meshes.front();
        QCOMPARE(mesh.texture, 0);
        QCOMPARE(mesh.texcoords.size(), mesh.positions.size());
        // glTF counts v from the top (0.1), OBJ and PLY from the bottom (0.9).
        for (const glm::vec2 &texcoord : mesh.texcoords)
            QVERIFY(glm::distance(texcoord, glm::vec2(0.25f, 0.9f)) < 1e-6f);
    }

    void keepsTheMeshWhenAPictureIsMissing()
    {
        const auto result = imported("nopicture.gltf", gltfBox({}, R"("uri":"nowhere.png")"));
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->triangleCount(), std::size_t{12});
        QVERIFY(result.value()->textures.front().encoded.empty());
        QVERIFY(glm::distance(result.value()->meshes.front().baseColor, glm::vec4(0.25f, 0.5f, 0.75f, 1.0f)) < 1e-6f);
    }

    void appliesNodeTransforms_data()
    {
        addColumn<QByteArray>("node");
        addColumn<double>("lowestX");
        addColumn<double>("highestX");
        newRow("translation") << QByteArray(R"(,"translation":[10,0,0])") << 9.0 << 12.0;
        newRow("scale") << QByteArray(R"(,"scale":[2,1,1])") << -2.0 << 4.0;
        newRow("mirror") << QByteArray(R"(,"scale":[-1,1,1])") << -2.0 << 1.0;
    }

    void appliesNodeTransforms()
    {
        QFETCH(QByteArray, node);
        QFETCH(double, lowestX);
        QFETCH(double, highestX);
        const auto result = imported("node.gltf", gltfBox(node));
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->bounds.lowest.x, lowestX);
        QCOMPARE(result.value()->bounds.highest.x, highestX);
        const Mesh &mesh = result.value()->meshes.front();
        const glm::dvec3 middle(result.value()->bounds.center());
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = mesh.position(mesh.indices[i]);
            const glm::dvec3 out =
                glm::cross(mesh.position(mesh.indices[i + 1]) - a, mesh.position(mesh.indices[i + 2]) - a);
            QVERIFY2(glm::dot(out, a - middle) > 0.0, "the winding does not follow the mirror");
            QVERIFY(glm::dot(glm::dvec3(mesh.normals[mesh.indices[i]]), out) > 0.0);
        }
    }

    void triangulatesConcavePolygonsAndDropsLines()
    {
        // An arrow head whose fan around the first corner would leave the polygon; area 1.
        const QByteArray corners("0 1 0\n-1 -1 0\n0 0 0\n1 -1 0\n");
        const QByteArray ply =
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_index\nelement edge 1\nproperty int vertex1\n"
            "property int vertex2\nend_header\n"
            + corners + "4 1 2 3 0\n0 1\n";
        QByteArray obj = "v " + corners.trimmed();
        obj.replace("\n", "\nv ");
        obj += "\nl 1 2 3\np 4\nf 2 3 4 1\n";
        for (const auto &[name, content] : {std::pair{"arrow.ply", ply}, std::pair{"arrow.obj", obj},
                                            std::pair{"arrow.off", "OFF 4 1 0\n" + corners + "4 1 2 3 0\n"}}) {
            const auto result = imported(name, content);
            REQUIRE_MODEL(result);
            QCOMPARE(result.value()->triangleCount(), std::size_t{2});
            const Mesh &mesh = result.value()->meshes.front();
            double area = 0.0;
            for (std::size_t i = 0; i < 6; i += 3) {
                const glm::vec3 a = mesh.positions[mesh.indices[i]];
                area += glm::length(glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                               mesh.positions[mesh.indices[i + 2]] - a))
                        / 2.0f;
            }
            QCOMPARE(area, 1.0);
        }
    }

    void readsTriangleStrips()
    {
        // Two strips: a row of two triangles, then one triangle.
        const auto result =
            imported("strips.ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                                   "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                                   "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 0\n8 0 1 2 3 -1 1 4 3\n");
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->meshes.front().indices, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 1, 4, 3}));
        for (const glm::vec3 &normal : result.value()->meshes.front().normals)
            QVERIFY(normal == glm::vec3(0, 0, 1));
    }

    void keepsHardEdgesAndSmoothsRoundOnes()
    {
        // A gable roof over the y axis, its edge turning by the given angle.
        for (const auto &[turnDegrees, isHard] : {std::pair{50.0, false}, std::pair{70.0, true}}) {
            const double slope = qDegreesToRadians(turnDegrees / 2.0);
            const QByteArray x = QByteArray::number(std::cos(slope)), z = QByteArray::number(-std::sin(slope));
            const auto result = imported("roof.off", "OFF 4 2 0\n0 0 0\n0 1 0\n" + x + " 0.5 " + z + "\n-" + x + " 0.5 "
                                                         + z + "\n3 0 2 1\n3 0 1 3\n");
            REQUIRE_MODEL(result);
            QCOMPARE(result.value()->meshes.front().positions.size(), std::size_t(isHard ? 6 : 4));
        }
    }

    void saysWhyAFileCannotBeOpened_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        addColumn<QString>("detail"); // a part of it
        newRow("empty") << "bad.obj" << QByteArray() << "the file is empty";
        newRow("unknown-suffix") << "bad.txt" << objBox() << "its contents look like obj";
        newRow("no-suffix") << "bad" << objBox() << "give it the suffix .obj";
        newRow("gltf-truncated") << "bad.gltf" << gltfBox().chopped(9) << "file ends too early";
        newRow("gltf-buffer-missing") << "bad.gltf" << gltfJson("nowhere.bin") << "nowhere.bin";
        newRow("gltf-accessor-too-long") << "bad.gltf" << gltfBox().replace("\"count\":36", "\"count\":37")
                                         << "37 elements";
        newRow("gltf-sparse-without-count")
            << "bad.gltf" << gltfBox().replace(R"("count":36,)", R"("count":36,"sparse":{},)") << "sparse";
        newRow("gltf-strip-without-corners")
            << "bad.gltf"
            << gltfBox().replace(R"("indices":1)", R"("mode":5,"indices":1)").replace("\"count\":36", "\"count\":0")
            << "neither triangles nor points";
        newRow("gltf-circle") << "bad.gltf" << gltfBox(",\"children\":[0]") << "circle";
        newRow("gltf-nested-deeply") << "bad.gltf" << QByteArray(100000, '[') << "nested";
        newRow("gltf-no-meshes") << "bad.gltf" << QByteArray("{\"asset\":{\"version\":\"2.0\"}}")
                                 << "neither triangles nor points";
        newRow("glb-truncated") << "bad.glb" << glbBox().chopped(7) << "declares";
        newRow("glb-garbage") << "bad.glb" << QByteArray("garbage garbage garbage garbage") << "GLB";
    }

    void saysWhyAFileCannotBeOpened()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, detail);
        const auto result = imported(name, content);
        VERIFY_REFUSED(result, detail);
        QCOMPARE(base::pathFromUtf8(result.error().file).filename(), pathOf(name));
    }

    void reportsNotAFile()
    {
        const std::filesystem::path folder = m_folder.path();
        const auto errorOf = [](const std::filesystem::path &file) { return importModel(file, {}).error(); };
        QCOMPARE(int(errorOf(folder / "nothing here.obj").kind), int(base::Error::Kind::NoFile));
        std::filesystem::create_directory(folder / "folder.obj");
        QCOMPARE(int(errorOf(folder / "folder.obj").kind), int(base::Error::Kind::File));

        std::error_code refused; // some systems have no links
        std::filesystem::create_symlink("circle", folder / "circle", refused);
        if (!refused) {
            const base::Error circle = errorOf(folder / "circle");
            QCOMPARE(int(circle.kind), int(base::Error::Kind::File));
            QVERIFY2(circle.text.find("links") != std::string::npos, circle.text.c_str());
        }

        const std::filesystem::path locked = write("locked.obj", objBox());
        std::filesystem::permissions(locked, std::filesystem::perms::none);
        const std::filesystem::path needsIt = write("needs it.gltf", gltfJson("locked.obj"));
        if (!std::ifstream(locked)) { // administrators, and Windows, read it all the same
            QCOMPARE(int(errorOf(locked).kind), int(base::Error::Kind::File));
            QCOMPARE(int(errorOf(needsIt).kind), int(base::Error::Kind::File));
        }
        std::filesystem::permissions(locked, std::filesystem::perms::owner_all);
    }

    void survivesTruncation_data() { addFormatRows(); }

    void survivesTruncation()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        const int step = std::max(1, int(content.size()) / tests::rounds(150));
        for (int size = 1; size < content.size(); size += step) {
            const auto result = imported("cut " + name, content.left(size));
            if (result) {
                // Text can end early and still be whole; then the part read must be usable.
                for (const Mesh &mesh : result.value()->meshes) {
                    for (const std::uint32_t index : mesh.indices)
                        QVERIFY(index < mesh.positions.size());
                }
            }
        }
    }

    void survivesBeingShortenedWhileItIsRead_data()
    {
        addColumn<double>("share");
        newRow("before") << 0.0;
        newRow("while it is read") << 0.01;
        newRow("while it is looked at") << 0.11;
        newRow("while corners are taken out") << 0.4;
    }

    /// Shortens the file as a program does that writes it anew.
    void survivesBeingShortenedWhileItIsRead()
    {
        QFETCH(double, share);
        constexpr std::size_t kTriangles = 200000;
        QByteArray bytes(80, ' ');
        bytes += little(quint32(kTriangles));
        for (std::size_t t = 0; t < kTriangles; ++t) {
            bytes += QByteArray(12, '\0');
            for (const auto &[y, z] : {std::pair(0.0f, 0.0f), std::pair(1.0f, 0.0f), std::pair(0.0f, 1.0f)})
                bytes += little(float(t)) + little(y) + little(z);
            bytes += little(quint16(0));
        }
        const std::filesystem::path file = write("shortened.stl", bytes);
        bool isShortened = false;
        const auto result = importModel(file, [&](double done) {
            if (!isShortened && done >= share) {
                isShortened = true;
                std::filesystem::resize_file(file, 5000);
            }
            return true;
        });
        QVERIFY(isShortened);
        // The part that was read by then is whole; otherwise the file is rejected.
        if (result)
            QCOMPARE(result.value()->triangleCount(), kTriangles);
        else
            VERIFY_REFUSED(result, "the file is damaged");
        QVERIFY(share < 0.1 || result.hasValue());
    }

    void progressNeverFallsAndCancelStops_data() { addFormatRows(); }

    void progressNeverFallsAndCancelStops()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        const std::filesystem::path file = write(name, content);
        double last = 0.0;
        int calls = 0;
        const auto whole = importModel(file, [&](double share) {
            ++calls;
            const bool rises = share >= last && share <= 1.0;
            last = rises ? share : -1.0;
            return true;
        });
        REQUIRE_MODEL(whole);
        QCOMPARE(last, 1.0);
        for (int stopAt = 1; stopAt <= calls; stopAt += tests::spacing(1)) {
            int call = 0;
            const auto stopped = importModel(file, [&](double) { return ++call < stopAt; });
            QVERIFY(!stopped.hasValue());
            QCOMPARE(int(stopped.error().kind), int(base::Error::Kind::Stopped));
            QCOMPARE(call, stopAt);
        }
    }

    void severalImportsRunAtOnce()
    {
        const std::filesystem::path files[] = {write("t.obj", objBox()), write("t.glb", glbBox()),
                                               write("t.ply", plyLittle())};
        std::atomic<int> good = 0;
        std::vector<std::thread> threads;
        threads.reserve(6);
        for (int i = 0; i < 6; ++i)
            threads.emplace_back([&, i] {
                for (int n = 0; n < 20; ++n) {
                    const auto result = importModel(files[i % 3], {});
                    good += result.hasValue() && result.value()->triangleCount() == 12;
                }
            });
        for (std::thread &thread : threads)
            thread.join();
        QCOMPARE(good.load(), 120);
    }

    void longTextsAreReadAsShortOnes_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        newRow("PLY") << "grid.ply" << gridPly("\n");
        newRow("PLY, CRLF") << "grid.ply" << gridPly("\r\n");
        newRow("PLY, CR") << "grid.ply" << gridPly("\r");
        newRow("STL") << "grid.stl" << gridStl("\n");
        newRow("STL, CRLF") << "grid.stl" << gridStl("\r\n");
    }

    void longTextsAreReadAsShortOnes()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QVERIFY(content.size() > 4 << 20);
        const auto result = imported(name, content);
        REQUIRE_MODEL(result);
        const Mesh &mesh = (*result)->meshes.front();
        const auto triangles = gridTriangles();
        QCOMPARE(mesh.triangleCount(), triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::vec3 expected(gridPoint(triangles[t][c]) - mesh.origin);
                if (mesh.positions[mesh.vertexAt(3 * t + c)] != expected)
                    QFAIL(qPrintable(QStringLiteral("triangle %1").arg(t)));
            }
        }
        if (name.endsWith(".ply")) {
            for (int i = 0; i < kGridPoints * kGridPoints; ++i)
                QVERIFY(mesh.positions[std::size_t(i)] == glm::vec3(gridPoint(i) - mesh.origin));
        }
    }

    void longTextsNameTheLine_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        addColumn<QByteArray>("right");
        addColumn<QByteArray>("wrong");
        // The last of them in the file.
        newRow("a vertex") << "grid.ply" << gridPly("\n") << gridWords(kGridPoints * kGridPoints - 1)
                           << QByteArray("1 2 x");
        newRow("a face") << "grid.ply" << gridPly("\n") << QByteArray("\n3 66000 ") << QByteArray("\n3 66000z ");
        newRow("a corner") << "grid.stl" << gridStl("\n") << QByteArray("vertex " + gridWords(66000))
                           << QByteArray("vertex 1 2");
        newRow("a facet") << "grid.stl" << gridStl("\n") << QByteArray(" endfacet\nendsolid")
                          << QByteArray(" oops\nendsolid");
    }

    void longTextsNameTheLine()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, right);
        QFETCH(QByteArray, wrong);
        const qsizetype at = content.lastIndexOf(right);
        QVERIFY(at > content.size() / 3);
        const auto line = content.left(at).count('\n') + 1 + (right.startsWith('\n') ? 1 : 0);
        const auto result = imported(name, content.replace(at, right.size(), wrong));
        VERIFY_REFUSED(result, QStringLiteral("line %1: ").arg(line));
    }

    /// Singles are added in the order of the faces, on whichever thread.
    void normalsAreTheSameByAllCores()
    {
        const auto result = imported("grid.ply", gridPly("\n"));
        REQUIRE_MODEL(result);
        const Mesh &mesh = (*result)->meshes.front();
        Box box;
        for (const glm::vec3 &position : mesh.positions)
            box.add(glm::dvec3(position));
        std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0.0f));
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
            const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * t + k]]); };
            const double scale = 1.0 / box.diagonal();
            const glm::dvec3 normal = glm::cross((corner(1) - corner(0)) * scale, (corner(2) - corner(0)) * scale);
            const double area = glm::length(normal);
            for (std::size_t k = 0; k < 3; ++k)
                sums[mesh.indices[3 * t + k]] += glm::vec3(normal / area) * static_cast<float>(area);
        }
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        for (std::size_t v = 0; v < sums.size(); ++v) {
            const glm::dvec3 sum(sums[v]);
            QVERIFY2(mesh.normals[v] == glm::vec3(sum / glm::length(sum)), qPrintable(QString::number(v)));
        }
    }

private:
    std::filesystem::path write(const QString &name, const QByteArray &content)
    {
        return m_folder.write(name, content);
    }

    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestMeshImport, threads)
#include "test_mesh_import.moc"
