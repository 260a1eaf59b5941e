// OBJ files as programs write them, and the import notes on unused parts.

#include "tests/support/test.h"

#include "tests/core/mesh/imported.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

using namespace unprojector;
using namespace unprojector::mesh;
using namespace model_files;

/// Strips of triangles, some megabytes: each line of vertices followed by its faces.
static QByteArray longObj(int rows, int columns)
{
    QByteArray text;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            text += QString("v %1 %2 0.25\n").arg(column).arg(row).toUtf8();
        if (row % 2 == 0)
            text += "usemtl grey\n";
        for (int column = 0; column + 1 < columns && row > 0; ++column) {
            const int a = row * columns + column + 1;
            // One counted from the start, one back.
            text += QString("f %1 %2 %3\n").arg(a - columns).arg(a + 1 - columns).arg(a + 1).toUtf8();
            text += QString("f %1 %2 %3\n")
                        .arg(-2 * columns + column)
                        .arg(-columns + 1 + column)
                        .arg(-columns + column)
                        .toUtf8();
        }
    }
    return text;
}

class TestImportObj : public QObject {
    Q_OBJECT

private slots:
    void textsAreReadOrRefused_data() { data_files::addCases("obj"); }

    void textsAreReadOrRefused()
    {
        QFETCH(data_files::Case, example);
        verifyCase(m_folder.imported("text.obj", QByteArray::fromStdString(example.text)), example);
    }

    void roundsNumbersCorrectly_data()
    {
        addColumn<QByteArray>("word");
        addColumn<double>("expected");
        newRow("six digits") << QByteArray("0.123457") << 0.123457;
        newRow("an exponent") << QByteArray("1.844674e+19") << 1.844674e+19;
        newRow("a small one") << QByteArray("7.006492e-35") << 7.006492e-35;
        newRow("half way, to even") << QByteArray("9007199254740993") << 9007199254740992.0;
        newRow("all digits") << QByteArray("3.14159265358979323846264338327950288") << 3.141592653589793;
        newRow("too small") << QByteArray("1e-400") << 0.0;
    }

    void roundsNumbersCorrectly()
    {
        QFETCH(QByteArray, word);
        QFETCH(double, expected);
        const auto result =
            m_folder.imported("number.obj", "v " + word + " 0 0\nv -" + word + " 0 0\nv 0 1 0\nf 1 2 3\n");
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QVERIFY(mesh.position(0) == glm::dvec3(expected, 0, 0));
        QVERIFY(mesh.position(1) == glm::dvec3(-expected, 0, 0));
    }

    void readsVertexColors_data()
    {
        addColumn<QByteArray>("vertices");
        addColumn<QVector<int>>("second"); // red, green, blue, alpha
        newRow("rgb") << QByteArray("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 1\nv 0 1 0 0 0 1\n")
                      << QVector<int>{0, 128, 255, 255};
        newRow("rgba") << QByteArray("v 0 0 0 1 0 0 1\nv 1 0 0 0 0.5 1 0.25\nv 0 1 0 0 0 1 1\n")
                       << QVector<int>{0, 128, 255, 64};
        newRow("w and rgba") << QByteArray("v 0 0 0 1 1 0 0 1\nv 1 0 0 1 0 0.5 1 0.25\nv 0 1 0 1 0 0 1 1\n")
                             << QVector<int>{0, 128, 255, 64};
        newRow("of some vertices") << QByteArray("v 0 0 0\nv 1 0 0 0 0.5 1\nv 0 1 0\n")
                                   << QVector<int>{0, 128, 255, 255};
        newRow("beyond the range") << QByteArray("v 0 0 0\nv 1 0 0 -1 0.5 7\nv 0 1 0\n")
                                   << QVector<int>{0, 128, 255, 255};
    }

    void readsVertexColors()
    {
        QFETCH(QByteArray, vertices);
        QFETCH(QVector<int>, second);
        const auto result = m_folder.imported("colors.obj", vertices + "f 1 2 3\n");
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.colors.size(), std::size_t{3});
        QVERIFY(mesh.position(1) == glm::dvec3(1, 0, 0));
        for (int channel = 0; channel < 4; ++channel)
            QCOMPARE(int(mesh.colors[1][channel]), second[channel]);
        QVERIFY(mesh.baseColor == glm::vec4(1.0f));
        QCOMPARE(notesOf(**result), QByteArray());
    }

    void keepsTheFilesVertexNumbers()
    {
        // The first vertex is of no face, the third repeats the second.
        const auto result = m_folder.imported(
            "numbers.obj",
            "v 9 9 9\nv 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 5//1 2//1 4//1\nf 3//1 4//1 5//1\n");
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.positions.size(), std::size_t{5});
        QCOMPARE(mesh.indices, (std::vector<std::uint32_t>{4, 1, 3, 2, 3, 4}));
        QVERIFY(result.value()->bounds.highest == glm::dvec3(1, 1, 0));
    }

    void splitsVerticesByTexcoordsAndNormals()
    {
        m_folder.write("red.mtl", "newmtl red\nKd 1 0 0\nmap_Kd red.png\n");
        m_folder.write("red.png", kPicture);
        const auto result =
            m_folder.imported("split.obj", "mtllib red.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 0.5 1\n"
                                           "vn 0 0 1\nvn 0 0 -1\nf 1/1/1 2/1/1 3/1/1\nf 3/1/2 2/1/2 1/2/1\n"
                                           "f 1/2/1 2/1/2 3/1/1\n");
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 5, 4, 2}));
        QVERIFY(mesh.normals[3] == glm::vec3(0, 0, -1) && mesh.normals[5] == glm::vec3(0, 0, 1));
        QVERIFY(mesh.texcoords[5] == glm::vec2(0.5f, 1.0f) && mesh.texcoords[0] == glm::vec2(0.0f));
        QVERIFY(mesh.position(3) == glm::dvec3(0, 1, 0) && mesh.position(5) == glm::dvec3(0, 0, 0));
    }

    void readsMaterials_data()
    {
        addColumn<QByteArray>("library");
        addColumn<QByteArray>("use");
        addColumn<QVector<float>>("color");
        addColumn<bool>("hasPicture");
        addColumn<bool>("repeats");
        const auto row = [](const char *name, const char *library, const char *use, const QVector<float> &color,
                            bool hasPicture = false, bool repeats = true) {
            newRow(name) << QByteArray(library) << QByteArray(use) << color << hasPicture << repeats;
        };
        row("Kd", "newmtl m\nKd 0.25 0.5 0.75\n", "usemtl m", {0.25f, 0.5f, 0.75f, 1.0f});
        row("Kd of one number", "newmtl m\nKd 0.25\n", "usemtl m", {0.25f, 0.25f, 0.25f, 1.0f});
        row("no Kd", "newmtl m\nNs 10\n", "usemtl m", {0.6f, 0.6f, 0.6f, 1.0f});
        row("d", "newmtl m\nKd 1 0 0\nd 0.25\n", "usemtl m", {1.0f, 0.0f, 0.0f, 0.25f});
        row("Tr", "newmtl m\nKd 1 0 0\nTr 0.25\n", "usemtl m", {1.0f, 0.0f, 0.0f, 0.75f});
        row("d -halo", "newmtl m\nKd 1 0 0\nd -halo 0.25\n", "usemtl m", {1.0f, 0.0f, 0.0f, 0.25f});
        row("indented, CRLF, a mark", "\xef\xbb\xbf\tnewmtl m\r\n\t\tKd 1 0 0\r\n", "usemtl m",
            {1.0f, 0.0f, 0.0f, 1.0f});
        row("a name of two words", "newmtl my red\nKd 1 0 0\n", "usemtl my red", {1.0f, 0.0f, 0.0f, 1.0f});
        row("a name with a hash", "newmtl m#1\nKd 1 0 0\nnewmtl m\nKd 0 0 1\n", "usemtl m#1", {1.0f, 0.0f, 0.0f, 1.0f});
        row("a comment behind the name", "newmtl m\nKd 1 0 0\n", "usemtl m # red", {1.0f, 0.0f, 0.0f, 1.0f});
        row("the last of several", "newmtl a\nKd 0 1 0\nnewmtl m\nKd 1 0 0\n", "usemtl a\nusemtl m",
            {1.0f, 0.0f, 0.0f, 1.0f});
        row("a picture", "newmtl m\nKd 0.5 0.5 0.5\nmap_Kd my 图.png\n", "usemtl m", {0.5f, 0.5f, 0.5f, 1.0f}, true);
        row("a picture beside black", "newmtl m\nKd 0 0 0\nmap_Kd my 图.png\n", "usemtl m", {1.0f, 1.0f, 1.0f, 1.0f},
            true);
        row("a picture without Kd", "newmtl m\nmap_Kd my 图.png\n", "usemtl m", {1.0f, 1.0f, 1.0f, 1.0f}, true);
        row("a picture with options", "newmtl m\nKd 1 0 0\nmap_Kd -s 1 1 -o 0.5 -bm 1 -mm 0 1 -clamp on my 图.png\n",
            "usemtl m", {1.0f, 0.0f, 0.0f, 1.0f}, true, false);
    }

    void readsMaterials()
    {
        QFETCH(QByteArray, library);
        QFETCH(QByteArray, use);
        QFETCH(QVector<float>, color);
        QFETCH(bool, hasPicture);
        QFETCH(bool, repeats);
        m_folder.write(QString::fromUtf8("my 图.png"), kPicture);
        m_folder.write("the library.mtl", library);
        for (const char *names : {"the library.mtl", "nowhere.mtl"}) {
            // The second: a library that is missing is looked for by the model's own name.
            const QString model = names[0] == 't' ? "materials.obj" : "the library.obj";
            const auto result =
                m_folder.imported(model, QByteArray("mtllib ") + names + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n" + use
                                             + "\nf 1/1 2/1 3/1\n");
            REQUIRE_MODEL(result);
            QCOMPARE(notesOf(**result), QByteArray());
            const Mesh &mesh = result.value()->meshes.front();
            for (int channel = 0; channel < 4; ++channel)
                QCOMPARE(mesh.baseColor[channel], color[channel]);
            QCOMPARE(mesh.texture, hasPicture ? 0 : -1);
            QCOMPARE(mesh.texcoords.size(), std::size_t(hasPicture ? 3 : 0));
            QCOMPARE(result.value()->textures.size(), std::size_t(hasPicture));
            if (hasPicture)
                QCOMPARE(result.value()->textures.front().wrapRepeat, repeats);
        }
    }

    void makesOneMeshForEachMaterial()
    {
        m_folder.write("a.mtl", "newmtl a\nKd 1 0 0\n");
        m_folder.write("b.mtl", "newmtl b\nKd 0 1 0\nmap_Kd nowhere.png\n");
        const auto result = m_folder.imported(
            "two.obj",
            "mtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 2 0\nvt 0.5 0.5\nf 1 2 3\nusemtl b\n"
            "f 2/1 4/1 3/1\nusemtl a\nf 2 4 3\nf 2 4 5\nusemtl b\nf 4/1 5/1 3/1\nf 4 5 2\n");
        REQUIRE_MODEL(result);
        const std::vector<Mesh> &meshes = result.value()->meshes;
        QCOMPARE(meshes.size(), std::size_t{4});
        QCOMPARE(meshes[0].triangleCount(), std::size_t{1});
        QVERIFY(meshes[0].baseColor == glm::vec4(0.8f, 0.8f, 0.8f, 1.0f));
        QCOMPARE(meshes[1].triangleCount(), std::size_t{2});
        QCOMPARE(meshes[1].positions.size(), std::size_t{4});
        QCOMPARE(meshes[1].texture, 0);
        QVERIFY(meshes[1].baseColor == glm::vec4(0, 1, 0, 1));
        QVERIFY(meshes[1].texcoords == std::vector<glm::vec2>(4, glm::vec2(0.5f)));
        QVERIFY(meshes[2].baseColor == glm::vec4(1, 0, 0, 1));
        QCOMPARE(meshes[2].triangleCount(), std::size_t{2});
        QVERIFY(meshes[2].position(meshes[2].vertexAt(5)) == glm::dvec3(2, 2, 0));
        QCOMPARE(meshes[3].texture, -1);
        QCOMPARE(
            notesOf(**result),
            QByteArray("the image \"nowhere.png\" is missing or cannot be read: its surfaces are shown without it"));
    }

    void cutsPolygonsInPlace()
    {
        // A triangle, an arrow head whose fan around the first corner would leave it, a convex
        // pentagon, a triangle.
        const auto result = m_folder.imported(
            "polygons.obj",
            "v 0 1 0\nv -1 -1 0\nv 0 0 0\nv 1 -1 0\nv 5 0 0\nv 6 0 0\nv 7 1 0\nv 6 2 0\nv 5 2 0\nvn 0 0 1\n"
            "f 1 2 3\nf 2 3 4 1\nf 5 6 7 8 9\nf 3 4 1\n");
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.triangleCount(), std::size_t{7});
        QCOMPARE(std::vector(mesh.indices.begin(), mesh.indices.begin() + 3), (std::vector<std::uint32_t>{0, 1, 2}));
        QCOMPARE(std::vector(mesh.indices.begin() + 9, mesh.indices.end()),
                 (std::vector<std::uint32_t>{4, 5, 6, 4, 6, 7, 4, 7, 8, 2, 3, 0}));
        QCOMPARE(areaOf(mesh), 0.5 + 1.0 + 3.0 + 0.5);
    }

    void showsVerticesWithoutFacesAsPoints()
    {
        for (const auto &[text, notes] :
             {std::pair{"", ""}, std::pair{"p 1 2\n", ""}, std::pair{"l 1 2\n", "1 line or point is not shown"}}) {
            const auto result =
                m_folder.imported("points.obj", QByteArray("v 0 0 0 1 0 0\nv 1 0 2 0 0 1\nvn 0 0 1\n") + text);
            REQUIRE_MODEL(result);
            const Mesh &mesh = result.value()->meshes.front();
            QCOMPARE(int(mesh.kind), int(Mesh::Kind::Points));
            QCOMPARE(result.value()->pointCount(), std::size_t{2});
            QCOMPARE(result.value()->triangleCount(), std::size_t{0});
            QVERIFY(mesh.colors[1] == glm::u8vec4(0, 0, 255, 255));
            QVERIFY(mesh.indices.empty() && mesh.normals.empty());
            QVERIFY(result.value()->bounds.highest == glm::dvec3(1, 0, 2));
            QCOMPARE(notesOf(**result), QByteArray(notes));
        }
    }

    void keepsTheMillimetresOfASurvey()
    {
        QByteArray text;
        for (int i = 0; i < kSurveyPoints; ++i)
            text += "v " + surveyWords(i) + '\n';
        for (const auto &t : surveyTriangles())
            text += QString("f %1 %2 %3\n").arg(t[0] + 1).arg(t[1] + 1).arg(t[2] + 1).toUtf8();
        const auto result = m_folder.imported("survey.obj", text);
        REQUIRE_MODEL(result);
        QVERIFY(hasSurveyDetail(result.value()->meshes.front()));
        QVERIFY(std::abs(result.value()->bounds.highest.x - 4000000.004) < 1e-5);
    }

    void readsFilesOfSeveralChunks()
    {
        const std::size_t rows = 200, columns = 400;
        const QByteArray text = longObj(int(rows), int(columns));
        QVERIFY(text.size() > 3 << 20);
        const auto result = m_folder.imported("long.obj", text);
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.triangleCount(), 2 * (rows - 1) * (columns - 1));
        QCOMPARE(mesh.positions.size(), rows * columns);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const std::size_t row = v / columns, column = v % columns;
            QVERIFY(mesh.position(v) == glm::dvec3(double(column), double(row), 0.25));
        }
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
            const std::size_t row = t / (2 * (columns - 1)), column = t / 2 % (columns - 1);
            const auto a = std::uint32_t(row * columns + column), b = a + std::uint32_t(columns);
            const std::uint32_t expected[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
            QVERIFY(std::equal(expected[t % 2], expected[t % 2] + 3, mesh.indices.begin() + std::ptrdiff_t(3 * t)));
        }
        QVERIFY(std::abs(areaOf(mesh) - double((rows - 1) * (columns - 1))) < 1e-6);
    }

    void namesTheLineInAnyChunk()
    {
        const QByteArray text = longObj(200, 400);
        const int lines = int(text.count('\n'));
        QCOMPARE(QString::fromStdString(m_folder.imported("long.obj", text + "f 1 2 999999\n" + text).error().text),
                 QString("the file is damaged: line %1: a face refers to vertex 999999, the file has 160000")
                     .arg(lines + 1));
        QCOMPARE(
            QString::fromStdString(m_folder.imported("long.obj", text + "f 1 x 3\nv 1 2 oops\n" + text).error().text),
            QString("the file is damaged: line %1: \"x\" is not a corner of a face").arg(lines + 1));
        const auto notFinite = m_folder.imported("long.obj", text + "v 0 0 nan\n" + text);
        VERIFY_REFUSED(notFinite, QString(kNotFinite).arg(80000));
    }

    void takesTimeInProportionToGroups()
    {
        for (const QByteArray statement : {"g", "o", "usemtl"}) {
            // The processor's time, not the clock's: other work on the machine does not count.
            const auto timeOf = [&](int groups) {
                QByteArray library, text("mtllib things.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
                for (int i = 0; i < groups; ++i)
                    library += "newmtl thing" + QByteArray::number(i) + "\nKd 1 0 0\n";
                m_folder.write("things.mtl", library);
                for (int i = 0; i < groups; ++i)
                    text += statement + " thing" + QByteArray::number(i) + "\nf 1 2 3\n";
                std::clock_t least = std::numeric_limits<std::clock_t>::max();
                for (int attempt = 0; attempt < 2; ++attempt) {
                    const std::clock_t start = std::clock();
                    const auto result = m_folder.imported("groups.obj", text);
                    least = std::min(least, std::clock() - start);
                    if (!result || result.value()->triangleCount() != static_cast<std::size_t>(groups))
                        return std::optional<double>();
                }
                return std::optional(static_cast<double>(least));
            };
            const auto few = timeOf(10000), many = timeOf(40000);
            QVERIFY(few && many);
            // Work for each group that grows with the file would make it 16 times.
            QVERIFY2(*many < 10.0 * *few + 0.01 * CLOCKS_PER_SEC,
                     qPrintable(QStringLiteral("%1: %2 and %3").arg(QString(statement)).arg(*few).arg(*many)));
        }
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestImportObj, threads)
#include "test_import_obj.moc"
