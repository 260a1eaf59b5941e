// OFF files: far coordinates, points, and what is refused.

#include "imported.h"

using namespace unprojector;
using namespace unprojector::mesh_import;
using namespace unprojector::scene;
using namespace model_files;

class TestImportOff : public QObject {
    Q_OBJECT

private slots:
    void keepsTheMillimetresOfASurvey();
    void showsVerticesWithoutFacesAsPoints();
    void saysWhatIsLeftOut_data();
    void saysWhatIsLeftOut();
    void saysWhyAFileCannotBeOpened_data();
    void saysWhyAFileCannotBeOpened();

private:
    ImportFolder m_folder;
};

void TestImportOff::keepsTheMillimetresOfASurvey()
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

void TestImportOff::showsVerticesWithoutFacesAsPoints()
{
    const auto result = m_folder.imported("points.off", "COFF\n2 0 0\n0 0 0 255 0 0 255\n1 2 3 0 0 255 255\n");
    REQUIRE_MODEL(result);
    QCOMPARE(result.value()->pointCount(), std::size_t{2});
    const Mesh &mesh = result.value()->meshes.front();
    QCOMPARE(int(mesh.kind), int(Mesh::Kind::Points));
    QVERIFY(mesh.colors[1] == glm::u8vec4(0, 0, 255, 255));
    QVERIFY(mesh.position(1) == glm::dvec3(1, 2, 3));
}

void TestImportOff::saysWhatIsLeftOut_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("notes");
    QTest::newRow("nothing") << offBox() + "\n# the end\n\n" << QByteArray();
    QTest::newRow("a face of two corners") << offBox().replace("8 6 12", "8 7 12") + "2 0 1\n"
                                           << QByteArray("1 line or point is not shown");
    QTest::newRow("binary, zeros behind") << offBinary() + QByteArray(4, '\0') << QByteArray();
    QTest::newRow("binary, more behind") << offBinary() + "more"
                                         << QByteArray("4 bytes behind all that the file declares are not used");
}

void TestImportOff::saysWhatIsLeftOut()
{
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, notes);
    const auto result = m_folder.imported("more.off", content);
    VERIFY_BOX_WITH_NOTES(result, notes);
}

void TestImportOff::saysWhyAFileCannotBeOpened_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<ImportErrorCode>("code");
    QTest::addColumn<QString>("detail");
    using enum ImportErrorCode;
    QTest::newRow("index too large") << offBox().replace("4 3 0 4 7", "4 3 0 4 8") << Malformed
                                     << "face 5 refers to vertex 8";
    QTest::newRow("truncated") << offBox().chopped(4) << Malformed << "too short";
    QTest::newRow("more faces than declared") << offBox().replace("8 6 12", "8 5 12") << Malformed
                                              << "line 17: \"4\" follows all that the header declares; correct";
    QTest::newRow("no vertices, no faces") << QByteArray("OFF 0 0 0\n") << NoTriangles << "";
    QTest::newRow("infinity") << offBox().replace("\n2 1 2\n", "\n2 inf 2\n") << NotFinite << "6";
    QTest::newRow("too large for a float") << offBox().replace("\n2 1 2\n", "\n2 1e300 2\n") << NotFinite << "6";
    QTest::newRow("garbage") << QByteArray("garbage") << Malformed << "OFF";
}

void TestImportOff::saysWhyAFileCannotBeOpened()
{
    QFETCH(QByteArray, content);
    QFETCH(ImportErrorCode, code);
    QFETCH(QString, detail);
    const auto result = m_folder.imported("bad.off", content);
    VERIFY_REFUSED(result, code, detail);
}

QTEST_GUILESS_MAIN(TestImportOff)
#include "test_import_off.moc"
