// OFF files: far coordinates, points, and errors.

#include "tests/support/test.h"

#include "core/mesh/import/material.h"
#include "tests/core/mesh/imported.h"

using namespace unprojector;
using namespace unprojector::mesh;
using namespace model_files;

class TestImportOff : public QObject {
    Q_OBJECT

private slots:
    void textsAreReadOrRefused_data() { data_files::addCases("off"); }

    void textsAreReadOrRefused()
    {
        QFETCH(data_files::Case, example);
        verifyCase(m_folder.imported("text.off", QByteArray::fromStdString(example.text)), example);
    }

    void keepsTheMillimetresOfASurvey()
    {
        QByteArray text = "OFF\n" + QByteArray::number(kSurveyPoints) + " 32 0\n";
        for (int i = 0; i < kSurveyPoints; ++i)
            text += surveyWords(i) + '\n';
        for (const auto &t : surveyTriangles())
            text += QString("3 %1 %2 %3\n").arg(t[0]).arg(t[1]).arg(t[2]).toUtf8();
        const auto result = m_folder.imported("survey.off", text);
        REQUIRE_MODEL(result);
        QVERIFY(hasSurveyDetail(result.value()->meshes.front()));
    }

    void showsVerticesWithoutFacesAsPoints()
    {
        const auto result = m_folder.imported("points.off", "COFF\n2 0 0\n0 0 0 255 0 0 255\n1 2 3 0 0 255 255\n");
        REQUIRE_MODEL(result);
        QCOMPARE(result.value()->pointCount(), std::size_t{2});
        const Mesh &mesh = result.value()->meshes.front();
        QCOMPARE(int(mesh.kind), int(Mesh::Kind::Points));
        QVERIFY(mesh.colors[1] == glm::u8vec4(0, 0, 255, 255));
        QVERIFY(mesh.position(1) == glm::dvec3(1, 2, 3));
        const auto plain = m_folder.imported("plain.off", "OFF\n2 0 0\n0 0 0\n1 2 3\n");
        REQUIRE_MODEL(plain);
        const glm::vec4 color = plain.value()->meshes.front().baseColor; // darker than a surface's
        QVERIFY(color == reader::Material{}.baseColorOf(Mesh::Kind::Points, false) && color != Mesh().baseColor);
    }

    void readsBinaryBoxes_data()
    {
        addColumn<QByteArray>("content");
        addColumn<QByteArray>("notes");
        QByteArray little = "OFF BINARY\n";
        const QByteArray big = offBinary().mid(little.size());
        for (qsizetype i = 0; i < big.size(); ++i)
            little += big[i / 4 * 4 + 3 - i % 4];
        newRow("little-endian") << little << QByteArray();
        QByteArray bare = "OFF BINARY\n" + big.left(12 + 8 * 12);
        for (qsizetype face = 0; face < 6; ++face)
            bare += big.mid(12 + 8 * 12 + face * 24, 20);
        newRow("no numbers of colours") << bare << QByteArray();
        newRow("zeros behind") << offBinary() + QByteArray(4, '\0') << QByteArray();
        newRow("more behind") << offBinary() + "more"
                              << QByteArray("4 bytes behind all that the file declares are not used");
    }

    void readsBinaryBoxes()
    {
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, notes);
        const auto box = m_folder.imported("box.off", content);
        VERIFY_BOX_WITH_NOTES(box, notes);
    }

    void readsColorsOfAnyScale()
    {
        for (const char *color : {" 255 0 0", " 255 0 0 255", " 1.0 0 0 1", " 1 0 0"}) {
            const auto result = m_folder.imported("colours.off", offBox("COFF", color));
            VERIFY_BOX_WITH_NOTES(result, QByteArray());
            QVERIFY((*result)->meshes.front().colors.front() == glm::u8vec4(255, 0, 0, 255));
        }
        // One scale for the whole file: 1 is dark beside 255.
        const auto result = m_folder.imported(
            "dark.off", "COFF\n3 1 0\n0 0 0 1 0 0 255\n1 0 0 255 0 0 255\n0 1 0 0 0 0 255\n3 0 1 2\n");
        REQUIRE_MODEL(result);
        QVERIFY((*result)->meshes.front().colors[0] == glm::u8vec4(1, 0, 0, 255));
        // Without a C in the first word, such numbers may be anything.
        const auto undeclared = m_folder.imported("numbers.off", offBox("OFF", " 255 0 0"));
        VERIFY_BOX_WITH_NOTES(undeclared, "8 vertices have words behind the coordinates that are not used");
        QVERIFY((*undeclared)->meshes.front().colors.empty());
    }

    void countsTheFilesVertices()
    {
        const auto result = m_folder.imported(
            "faces.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n");
        REQUIRE_MODEL(result);
        QCOMPARE((*result)->fileVertices, std::size_t{4});
        QCOMPARE((*result)->meshes.front().positions.size(), std::size_t{6}); // each corner has its face's colour
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestImportOff, threads)
#include "test_import_off.moc"
