// STL files: welding, colours, and errors.

#include "tests/support/test.h"

#include "tests/core/mesh/imported.h"

#include "core/scene/measures.h"

#include <cmath>

using namespace unprojector;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using namespace model_files;

/// A binary file of `count` triangles, each over one cell of a plane grid that is 1000 wide.
static QByteArray cells(int count, quint16 attribute = 0)
{
    QByteArray bytes(80, ' ');
    bytes += little(quint32(count));
    bytes.reserve(84 + 50 * count);
    for (int i = 0; i < count; ++i) {
        const int column = i % 1000, row = i / 1000;
        const auto x = float(column), y = float(row);
        bytes += QByteArray(12, '\0') + little(x) + little(y) + little(0.0f) + little(x + 1.0f) + little(y)
                 + little(0.0f) + little(x) + little(y + 1.0f) + little(0.0f) + little(attribute);
    }
    return bytes;
}

class TestImportStl : public QObject {
    Q_OBJECT

private slots:
    void textsAreReadOrRefused_data() { data_files::addCases("stl"); }

    void textsAreReadOrRefused()
    {
        QFETCH(data_files::Case, example);
        verifyCase(m_folder.imported("text.stl", QByteArray::fromStdString(example.text)), example);
    }

    void weldsSmallMeshes()
    {
        for (const QByteArray &content : {stlText(), stlBinary()}) {
            const auto result = m_folder.imported("box.stl", content);
            REQUIRE_MODEL(result);
            // Eight corners, each in three directions of its faces.
            QCOMPARE(result.value()->meshes.front().positions.size(), std::size_t{24});
            QCOMPARE(result.value()->meshes.front().indices.size(), std::size_t{36});
        }
    }

    void aVertexOfTwoColoursIsOneOfTheFile()
    {
        QByteArray bytes = stlBinary();
        for (int t = 0; t < 12; ++t)
            bytes.replace(84 + 50 * t + 48, 2, little(quint16(0x8000 | (t % 2 == 0 ? 31 : 31 << 10))));
        const auto result = m_folder.imported("box.stl", bytes);
        REQUIRE_MODEL(result);
        QVERIFY(result.value()->meshes.front().positions.size() > std::size_t{8});
        QCOMPARE(result.value()->fileVertices, std::size_t{8});
    }

    void keepsLargeMeshesAsTheyAre_data()
    {
        addColumn<int>("count");
        addColumn<bool>("isWelded");
        addColumn<bool>("hasColors");
        newRow("300,000 triangles") << 300000 << true << false;
        newRow("300,001 triangles") << 300001 << false << false;
        newRow("300,001 triangles in colour") << 300001 << false << true;
    }

    void keepsLargeMeshesAsTheyAre()
    {
        QFETCH(int, count);
        QFETCH(bool, isWelded);
        QFETCH(bool, hasColors);
        const auto result = m_folder.imported("cells.stl", cells(count, hasColors ? 0x8000 | 31 << 10 : 0));
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(mesh.triangleCount(), std::size_t(count));
        QCOMPARE(!mesh.indices.empty(), isWelded);
        QCOMPARE(!mesh.normals.empty(), isWelded);
        QCOMPARE(mesh.colors.size(), hasColors ? mesh.positions.size() : std::size_t{0});
        QVERIFY(!hasColors || mesh.colors.back() == glm::u8vec4(255, 0, 0, 255));
        for (std::size_t t = 0; t < mesh.triangleCount(); t += 997) {
            const auto column = t % 1000, row = t / 1000;
            const glm::dvec3 first(double(column), double(row), 0.0);
            QVERIFY(mesh.position(mesh.vertexAt(3 * t)) == first);
            QVERIFY(mesh.position(mesh.vertexAt(3 * t + 1)) == first + glm::dvec3(1, 0, 0));
            QVERIFY(mesh.position(mesh.vertexAt(3 * t + 2)) == first + glm::dvec3(0, 1, 0));
        }
        QVERIFY(std::abs(areaOf(mesh) - count / 2.0) < 1e-6 * count);
        QVERIFY(result.value()->bounds.highest == glm::dvec3(1000, (count - 1) / 1000 + 1, 0));
    }

    void aLargeOneHasTheNumbersOfASmallOne()
    {
        const int most = 300000; // which are joined
        const auto joined = m_folder.imported("small.stl", cells(most));
        const auto soup = m_folder.imported("large.stl", cells(most + 1));
        REQUIRE_MODEL(joined);
        REQUIRE_MODEL(soup);
        const Mesh &one = (*joined)->meshes.front(), &other = (*soup)->meshes.front();
        QVERIFY(other.indices.empty());
        const std::size_t vertices = measuresOf({"large", {}, *soup, {}}).vertices;
        for (std::size_t corner = 0; corner < one.indices.size(); ++corner) {
            const std::uint32_t number = (*soup)->vertexNumber(0, corner);
            QCOMPARE(number, (*joined)->vertexNumber(0, one.vertexAt(corner)));
            QVERIFY(number < vertices);
        }
        QCOMPARE(vertices, measuresOf({"small", {}, *joined, {}}).vertices + 1); // of a row of its own
        const auto last = (*soup)->vertexOf(static_cast<std::uint32_t>(vertices - 1));
        QVERIFY(last && other.position(last->vertex) == glm::dvec3(0, 301, 0));
        QVERIFY(!(*soup)->vertexOf(static_cast<std::uint32_t>(vertices)));
    }

    void keepsTheMillimetresOfASurvey()
    {
        QByteArray text("solid survey\n");
        for (const auto &t : surveyTriangles())
            text += "facet normal 0 0 1\nouter loop\nvertex " + surveyWords(t[0]) + "\nvertex " + surveyWords(t[1])
                    + "\nvertex " + surveyWords(t[2]) + "\nendloop\nendfacet\n";
        const auto result = m_folder.imported("survey.stl", text + "endsolid survey\n");
        REQUIRE_MODEL(result);
        QVERIFY(hasSurveyDetail(result.value()->meshes.front()));
    }

    void keepsFloatsThatLieFarAway()
    {
        // The exact values of these floats, to the last bit.
        QByteArray bytes(80, ' ');
        bytes += little(quint32(surveyTriangles().size()));
        for (const auto &t : surveyTriangles()) {
            bytes += QByteArray(12, '\0');
            for (const int i : t) {
                const int column = i % 5, row = i / 5;
                bytes += little(4000000.0f + 0.25f * float(column)) + little(500000.0f + 0.03125f * float(row))
                         + little(300.0f);
            }
            bytes += little(quint16(0));
        }
        const auto result = m_folder.imported("far.stl", bytes);
        REQUIRE_MODEL(result);
        const Mesh &mesh = result.value()->meshes.front();
        QVERIFY(mesh.origin.x > 3.9e6);
        const auto triangles = surveyTriangles();
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t c = 0; c < 3; ++c) {
                const int i = triangles[t][c], column = i % 5, row = i / 5;
                QVERIFY(mesh.position(mesh.vertexAt(3 * t + c))
                        == glm::dvec3(4000000.0 + 0.25 * column, 500000.0 + 0.03125 * row, 300.0));
            }
        }
    }

    void saysWhatIsBehindTheTriangles_data()
    {
        addColumn<QByteArray>("more");
        addColumn<QByteArray>("notes");
        newRow("nothing") << QByteArray() << QByteArray();
        newRow("a few zeros") << QByteArray(3, '\0') << QByteArray();
        newRow("zeros up to a whole block") << QByteArray(428, '\0') << QByteArray();
        newRow("a line end") << QByteArray("\r\n") << QByteArray();
        newRow("a few letters") << QByteArray("made by me")
                                << QByteArray("10 bytes behind all that the file declares are not used");
    }

    void saysWhatIsBehindTheTriangles()
    {
        QFETCH(QByteArray, more);
        QFETCH(QByteArray, notes);
        const auto result = m_folder.imported("more.stl", stlBinary() + more);
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->triangleCount(), std::size_t{12});
        QCOMPARE(notesOf(**result), notes);
    }

    void readsTextWithComments()
    {
        QByteArray text = "# made by hand\n; of a box\n\n" + stlText();
        text.replace("; of a box\n", "").replace("outer loop\nvertex 2 1 2", "# a loop\nouter loop\nvertex 2 1 2");
        const auto box = m_folder.imported("comments.stl", text + QByteArray(3, '\0'));
        VERIFY_BOX_WITH_NOTES(box, QByteArray());
    }

    void saysWhyABinaryFileCannotBeOpened_data()
    {
        addColumn<QByteArray>("content");
        addColumn<QString>("detail");
        newRow("truncated") << stlBinary().chopped(51) << "declares 12 triangles, the file ends after 10";
        newRow("more triangles than declared")
            << stlBinary(10) << "declares 10 triangles, the file is long enough for 12; correct the number";
        newRow("none declared") << stlBinary(0) << "declares 0 triangles, the file is long enough for 12";
        newRow("four billion") << stlBinary(0xffffffff) << "declares 4294967295";
        newRow("no triangles") << QByteArray(84, '\0') << "neither triangles nor points";
        newRow("infinity") << stlBinary(-1, 0, INFINITY) << QString(kNotFinite).arg(0);
        newRow("infinity in a large one")
            << cells(300001).replace(84 + 50 * 200000 + 12, 4, little(INFINITY)) << QString(kNotFinite).arg(600000);
    }

    void saysWhyABinaryFileCannotBeOpened()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, detail);
        const auto result = m_folder.imported("bad.stl", content);
        VERIFY_REFUSED(result, detail);
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestImportStl, threads)
#include "test_import_stl.moc"
