// PLY files: every way to store the same, points, far coordinates, and errors.

#include "tests/support/test.h"

#include "tests/core/mesh/imported.h"

#include <utility>

using namespace unprojector;
using namespace unprojector::mesh;
using namespace model_files;

static QByteArray surveyHeader(const QByteArray &format)
{
    return "ply\nformat " + format + " 1.0\nelement vertex " + QByteArray::number(kSurveyPoints)
           + "\nproperty double x\nproperty double y\nproperty double z\nelement face 32\n"
             "property list uchar int vertex_indices\nend_header\n";
}

template <class Encode>
static QByteArray surveyBinary(const QByteArray &format, Encode encode)
{
    QByteArray bytes = surveyHeader(format);
    for (int i = 0; i < kSurveyPoints; ++i)
        bytes += encode(surveyPoint(i).x) + encode(surveyPoint(i).y) + encode(surveyPoint(i).z);
    for (const auto &t : surveyTriangles())
        bytes += '\3' + encode(quint32(t[0])) + encode(quint32(t[1])) + encode(quint32(t[2]));
    return bytes;
}

/// A grid of 1000 x rows points in the plane, two triangles a square; large enough to be mapped and
/// read by all cores.
static QByteArray grid(int rows)
{
    QByteArray bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + QByteArray::number(1000 * rows)
                       + "\nproperty float x\nproperty float y\nproperty float z\nelement face "
                       + QByteArray::number(2 * 999 * (rows - 1))
                       + "\nproperty list uchar uint vertex_indices\nend_header\n";
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < 1000; ++column)
            bytes += little(float(column)) + little(float(row)) + little(0.5f);
    }
    for (int row = 0; row + 1 < rows; ++row) {
        for (int column = 0; column < 999; ++column) {
            const auto a = quint32(1000 * row + column);
            bytes += '\3' + little(a) + little(a + 1) + little(a + 1001) + '\3' + little(a) + little(a + 1001)
                     + little(a + 1000);
        }
    }
    return bytes;
}

class TestImportPly : public QObject {
    Q_OBJECT

private slots:
    void textsAreReadOrRefused_data() { data_files::addCases("ply"); }

    void textsAreReadOrRefused()
    {
        QFETCH(data_files::Case, example);
        verifyCase(m_folder.imported("text.ply", QByteArray::fromStdString(example.text)), example);
    }

    void keepsTheMillimetresOfASurvey_data()
    {
        addColumn<QByteArray>("content");
        QByteArray text = surveyHeader("ascii");
        for (int i = 0; i < kSurveyPoints; ++i)
            text += surveyWords(i) + '\n';
        for (const auto &t : surveyTriangles())
            text += QString("3 %1 %2 %3\n").arg(t[0]).arg(t[1]).arg(t[2]).toUtf8();
        newRow("text") << text;
        newRow("text that declares float") << QByteArray(text).replace("double", "float");
        newRow("double, little-endian") << surveyBinary("binary_little_endian", [](auto v) { return little(v); });
        newRow("double, big-endian") << surveyBinary("binary_big_endian", [](auto v) { return big(v); });
    }

    void keepsTheMillimetresOfASurvey()
    {
        QFETCH(QByteArray, content);
        const auto result = m_folder.imported("survey.ply", content);
        REQUIRE_MODEL(result);
        QVERIFY(hasSurveyDetail(result.value()->meshes.front()));
    }

    void readsWhatVerticesHave_data()
    {
        addColumn<QByteArray>("content");
        const QByteArray properties("element vertex 3\nproperty uchar red\nproperty float x\nproperty short unknown\n"
                                    "property double y\nproperty float z\nproperty float nx\nproperty float ny\n"
                                    "property float nz\nproperty uchar green\nproperty uchar blue\nproperty float s\n"
                                    "property float t\n");
        const QByteArray faces("element face 1\nproperty list uchar int vertex_indices\nend_header\n");
        newRow("text") << "ply\nformat ascii 1.0\n" + properties + faces
                              + "1 0 9 0 5 0 0 1 2 3 0.25 0.5\n1 1 9 0 5 0 0 1 2 3 0.25 0.5\n\n"
                                "1 0 9 1 5 0 0 1 2 3 0.25 0.5\n3 0 1 2\n";
        QByteArray vertices;
        for (const auto &[x, y] : {std::pair{0.0f, 0.0}, std::pair{1.0f, 0.0}, std::pair{0.0f, 1.0}})
            vertices += '\1' + little(x) + little(quint16(9)) + little(y) + little(5.0f) + little(0.0f) + little(0.0f)
                        + little(1.0f) + "\2\3" + little(0.25f) + little(0.5f);
        const QByteArray face = '\3' + little(quint32(0)) + little(quint32(1)) + little(quint32(2));
        newRow("binary") << "ply\nformat binary_little_endian 1.0\n" + properties + faces + vertices + face;
        // A list, which is skipped, makes vertices of different sizes.
        QByteArray listed;
        for (int i = 0; i < 3; ++i)
            listed += vertices.mid(i * vertices.size() / 3, vertices.size() / 3) + char(i) + QByteArray(i, 'x');
        newRow("binary with a list") << "ply\nformat binary_little_endian 1.0\n" + properties
                                            + "property list uchar uchar more\n" + faces + listed + face;
    }

    void readsWhatVerticesHave()
    {
        QFETCH(QByteArray, content);
        const auto result = m_folder.imported("vertices.ply", content);
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
        const glm::dvec3 expected[] = {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}};
        for (std::size_t v = 0; v < 3; ++v) {
            QVERIFY(mesh.position(v) == expected[v]);
            QVERIFY(mesh.normals[v] == glm::vec3(0, 0, 1));
            QVERIFY(mesh.colors[v] == glm::u8vec4(1, 2, 3, 255));
            QVERIFY(mesh.texcoords[v] == glm::vec2(0.25f, 0.5f));
        }
    }

    void readsPolygonsAmongTriangles()
    {
        // Triangles first, then a square: the file only begins like triangles of one size.
        QByteArray bytes = plyHeader("binary_little_endian", {}, {}, 5);
        for (const auto &c : kCorners)
            bytes += little(c[0]) + little(c[1]) + little(c[2]);
        const auto polygon = [&bytes](std::initializer_list<quint32> corners) {
            bytes += char(corners.size());
            for (const quint32 corner : corners)
                bytes += little(corner);
        };
        polygon({0, 3, 2});
        polygon({0, 2, 1});
        polygon({4, 5, 6, 7});
        polygon({0, 1});
        polygon({0, 1, 5});
        const auto result = m_folder.imported("mixed.ply", bytes);
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->triangleCount(), std::size_t{5});
        QVERIFY(std::abs(areaOf(result.value()->meshes.front()) - (3.0 + 3.0 + 3.0)) < 1e-6);
        QCOMPARE(notesOf(**result), QByteArray("1 line or point is not shown"));
    }

    void readsFacesBeforeVertices()
    {
        // An arrow head: only the right diagonal stays inside.
        const auto result = m_folder.imported(
            "faces first.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\n"
                               "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                               "4 1 2 3 0\n0 1 0\n-1 -1 0\n0 0 0\n1 -1 0\n");
        REQUIRE_MODEL(result);
        QCOMPARE(areaOf(result.value()->meshes.front()), 1.0);
        QCOMPARE(notesOf(**result), QByteArray());
    }

    void showsVerticesWithoutFacesAsPoints_data()
    {
        addColumn<QByteArray>("content");
        QByteArray header(
            "ply\nformat FORMAT 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n");
        const QByteArray text = header.replace("FORMAT", "ascii");
        const QByteArray faces("element face 0\nproperty list uchar int vertex_indices\n");
        const QByteArray end("end_header\n");
        const QByteArray words("0 0 0 255 0 0\n1 2 3 0 0 255\n");
        newRow("text") << text + end + words;
        newRow("text, no faces declared") << text + faces + end + words;
        newRow("binary") << QByteArray(text).replace("ascii", "binary_little_endian") + end + little(0.0f)
                                + little(0.0f) + little(0.0f) + QByteArray("\xff\0\0", 3) + little(1.0f) + little(2.0f)
                                + little(3.0f) + QByteArray("\0\0\xff", 3);
    }

    void showsVerticesWithoutFacesAsPoints()
    {
        QFETCH(QByteArray, content);
        const auto result = m_folder.imported("points.ply", content);
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->pointCount(), std::size_t{2});
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(int(mesh.kind), int(Mesh::Kind::Points));
        QVERIFY(mesh.colors[1] == glm::u8vec4(0, 0, 255, 255));
        QVERIFY(mesh.baseColor == glm::vec4(1.0f));
        QVERIFY(mesh.position(1) == glm::dvec3(1, 2, 3));
        QVERIFY(result.value()->bounds.highest == glm::dvec3(1, 2, 3));
    }

    void readsLargeFiles()
    {
        const int rows = 200;
        const auto result = m_folder.imported("grid.ply", grid(rows));
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.positions.size(), std::size_t(1000 * rows));
        for (std::size_t v = 0; v < mesh.positions.size(); v += 89) {
            const std::size_t column = v % 1000, row = v / 1000;
            QVERIFY(mesh.position(v) == glm::dvec3(double(column), double(row), 0.5));
        }
        QCOMPARE(mesh.triangleCount(), std::size_t(2 * 999 * (rows - 1)));
        QVERIFY(std::abs(areaOf(mesh) - 999.0 * (rows - 1)) < 1e-6);
        QVERIFY(std::all_of(mesh.normals.begin(), mesh.normals.end(),
                            [](const glm::vec3 &normal) { return normal == glm::vec3(0, 0, 1); }));

        QByteArray wrong = grid(rows);
        wrong.replace(wrong.size() - 4, 4, little(quint32(200000)));
        const auto refused = m_folder.imported("grid.ply", wrong);
        VERIFY_REFUSED(refused, QString("face 397601 refers to vertex 200000, the file has 200000"));
    }

    void leavesVeryLargeMeshesFlat()
    {
        const int faces = 3000001;
        QByteArray bytes =
            "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face "
            + QByteArray::number(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
        for (const float value : {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f})
            bytes += little(value);
        bytes += ('\3' + little(quint32(0)) + little(quint32(1)) + little(quint32(2))).repeated(faces);
        const auto result = m_folder.imported("many.ply", bytes);
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->triangleCount(), std::size_t(faces));
        QVERIFY(result.value()->meshes.front().normals.empty());
    }

    void saysWhatIsBehindABinaryFile()
    {
        const auto zeros = m_folder.imported("more.ply", plyLittle() + QByteArray(5, '\0'));
        VERIFY_BOX_WITH_NOTES(zeros, QByteArray());
        const auto more = m_folder.imported("more.ply", plyLittle() + "more");
        VERIFY_BOX_WITH_NOTES(more, QByteArray("4 bytes behind all that the file declares are not used"));
        const auto less = m_folder.imported("less.ply", plyLittle().chopped(1));
        VERIFY_REFUSED(less, QString("ends within face 5 of 6"));
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestImportPly, threads)
#include "test_import_ply.moc"
