// OFF files: far coordinates, points, and errors.

#include "tests/support/test.h"

#include "tests/core/mesh/imported.h"

using namespace unprojector;
using namespace unprojector::mesh;
using namespace model_files;

class TestImportOff : public QObject {
    Q_OBJECT

private slots:
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
    }

    void readsTheBoxHoweverItIsWritten_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("no number of edges") << offBox().replace("8 6 12", "8 6");
        QTest::newRow("no number of edges, whole numbers") << offBox().replace("8 6 12", "8 6").replace(".0", "");
        QTest::newRow("a comment instead of edges") << offBox().replace("8 6 12", "8 6 # edges");
        QTest::newRow("edges in a line of their own") << offBox().replace("8 6 12", "8 6\n12");
        QTest::newRow("each count in a line of its own") << offBox().replace("8 6 12", "8\n6\n12");
        QTest::newRow("counts behind the word") << offBox().replace("OFF\n# a comment\n8 6 12", "OFF 8 6 12");
        QTest::newRow("counts against the word") << offBox().replace("OFF\n# a comment\n8 6 12", "OFF8 6 12");
        QTest::newRow("a number a line") << "OFF\n8 6 12\n"
                                                + offBox().mid(offBox().indexOf("8 6 12") + 7).replace(' ', '\n');
        QTest::newRow("a comment within a face") << offBox().replace("4 3 0 4 7", "4 3 # and\n\n0 4 7");
        QTest::newRow("no word") << offBox().replace("OFF\n# a comment\n", "");
        QTest::newRow("three dimensions") << offBox("nOFF").replace("8 6 12", "3\n8 6 12");
        QTest::newRow("comments behind vertices") << offBox("OFF", " # a vertex");
        QTest::newRow("zeros behind") << offBox() + QByteArray(7, '\0');
        QByteArray little = "OFF BINARY\n";
        const QByteArray big = offBinary().mid(little.size());
        for (qsizetype i = 0; i < big.size(); ++i)
            little += big[i / 4 * 4 + 3 - i % 4];
        QTest::newRow("binary, little-endian") << little;
        QByteArray bare = "OFF BINARY\n" + big.left(12 + 8 * 12);
        for (qsizetype face = 0; face < 6; ++face)
            bare += big.mid(12 + 8 * 12 + face * 24, 20);
        QTest::newRow("binary, no numbers of colours") << bare;
    }

    void readsTheBoxHoweverItIsWritten()
    {
        QFETCH(QByteArray, content);
        const auto box = m_folder.imported("box.off", content);
        VERIFY_BOX_WITH_NOTES(box, QByteArray());
    }

    void readsColorsThatAreNotDeclared()
    {
        const QByteArray note =
            "the numbers behind the coordinates are used as colours, though the header does not declare any";
        for (const char *color : {" 255 0 0", " 255 0 0 255", " 1.0 0 0 1", " 1 0 0"}) {
            const auto result = m_folder.imported("colours.off", offBox("OFF", color));
            VERIFY_BOX_WITH_NOTES(result, note);
            QVERIFY((*result)->meshes.front().colors.front() == glm::u8vec4(255, 0, 0, 255));
        }
        // One scale for the whole file: 1 is dark beside 255.
        const auto result = m_folder.imported(
            "dark.off", "COFF\n3 1 0\n0 0 0 1 0 0 255\n1 0 0 255 0 0 255\n0 1 0 0 0 0 255\n3 0 1 2\n");
        REQUIRE_MODEL(result);
        QVERIFY((*result)->meshes.front().colors[0] == glm::u8vec4(1, 0, 0, 255));
    }

    void countsTheFilesVertices()
    {
        const auto result = m_folder.imported(
            "faces.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n");
        REQUIRE_MODEL(result);
        QCOMPARE((*result)->fileVertices, std::size_t{4});
        QCOMPARE((*result)->meshes.front().positions.size(), std::size_t{6}); // each corner has its face's colour
    }

    void saysWhatIsLeftOut_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("notes");
        QTest::newRow("nothing") << offBox() + "\n# the end\n\n" << QByteArray();
        QTest::newRow("a face of two corners") << offBox().replace("8 6 12", "8 7 12") + "2 0 1\n"
                                               << QByteArray("1 line or point is not shown");
        QTest::newRow("a number behind a vertex")
            << offBox().replace("\n2 1 2\n", "\n2 1 2 7\n")
            << QByteArray("1 vertex has words behind the coordinates that are not used");
        QTest::newRow("normals that are not declared")
            << offBox("OFF", " 0 0 -1") << QByteArray("8 vertices have words behind the coordinates that are not used");
        QTest::newRow("binary, zeros behind") << offBinary() + QByteArray(4, '\0') << QByteArray();
        QTest::newRow("binary, more behind")
            << offBinary() + "more" << QByteArray("4 bytes behind all that the file declares are not used");
    }

    void saysWhatIsLeftOut()
    {
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, notes);
        const auto result = m_folder.imported("more.off", content);
        VERIFY_BOX_WITH_NOTES(result, notes);
    }

    void saysWhyAFileCannotBeOpened_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<ImportErrorCode>("code");
        QTest::addColumn<QString>("detail");
        using enum ImportErrorCode;
        QTest::newRow("index too large") << offBox().replace("4 3 0 4 7", "4 3 0 4 8") << Malformed
                                         << "face 5 refers to vertex 8";
        QTest::newRow("binary that is text") << offBox().replace("OFF\n", "OFF BINARY\n") << Malformed
                                             << "the first line says BINARY and text follows; remove the word BINARY";
        QTest::newRow("binary of nothing") << QByteArray("OFF BINARY\n") << Malformed << "the file ends";
        QTest::newRow("truncated") << offBox().chopped(4) << Malformed << "face 5 declares 4 corners";
        QTest::newRow("more faces than declared") << offBox().replace("8 6 12", "8 5 12") << Malformed
                                                  << "line 17: \"4\" follows all that the header declares; correct";
        QTest::newRow("a vertex of two numbers") << offBox().replace("\n2 1 2\n", "\n2 1\n") << Malformed
                                                 << "line 10: the line ends where a vertex is expected";
        QTest::newRow("a face without a corner") << offBox().replace("4 3 0 4 7", "4 3 0 4") << Malformed
                                                 << "line 17: the line ends where a face is expected";
        QTest::newRow("a vertex too few")
            << offBox().replace("8 6 12", "7 6 12") << Malformed << "face 0 declares -1 corners";
        QTest::newRow("a vertex too many")
            << offBox().replace("8 6 12", "9 6 12") << Malformed << "the file ends where";
        QTest::newRow("two counts and a word") << offBox().replace("8 6 12", "8 6 twelve") << Malformed
                                               << "line 3: \"twelve\" found where a number of edges is expected";
        QTest::newRow("four dimensions") << offBox("nOFF").replace("8 6 12", "4\n8 6 12") << Unsupported
                                         << "points of 4 dimensions";
        QTest::newRow("no vertices, no faces") << QByteArray("OFF 0 0 0\n") << NoTriangles << "";
        QTest::newRow("infinity") << offBox().replace("\n2 1 2\n", "\n2 inf 2\n") << NotFinite << "6";
        QTest::newRow("too large for a float") << offBox().replace("\n2 1 2\n", "\n2 1e300 2\n") << NotFinite << "6";
        QTest::newRow("garbage") << QByteArray("garbage") << Malformed << "OFF";
    }

    void saysWhyAFileCannotBeOpened()
    {
        QFETCH(QByteArray, content);
        QFETCH(ImportErrorCode, code);
        QFETCH(QString, detail);
        const auto result = m_folder.imported("bad.off", content);
        VERIFY_REFUSED(result, code, detail);
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestImportOff, threads)
#include "test_import_off.moc"
