// Loading on a thread of its own, without a window: what the thread sanitizer can follow.

#include "gui/document/model_loader.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <vector>

using namespace unprojector;
using namespace unprojector::gui;
using unprojector::mesh::ImportError;

namespace {

QByteArray manyTriangles(int count)
{
    QByteArray text = "solid many\n";
    for (int i = 0; i < count; ++i) {
        const QByteArray x = QByteArray::number(i);
        text += "facet normal 0 0 1\nouter loop\nvertex " + x + " 0 0\nvertex " + x + ".5 0 0\nvertex " + x
                + " 0.5 0\nendloop\nendfacet\n";
    }
    return text + "endsolid many\n";
}

} // namespace

class TestModelLoader : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void theGoodFilesComeInOrderAndTheOthersSayWhy();
    void nothingComesAfterACancel();
    void aSecondLoadingTakesTheFirstOnesPlace();
    void aLoaderMayGoWhileItLoads();

private:
    std::filesystem::path file(const char *name, const QByteArray &content) const;

    QTemporaryDir m_folder;
    std::filesystem::path m_large, m_small, m_broken;
};

std::filesystem::path TestModelLoader::file(const char *name, const QByteArray &content) const
{
    QFile written(m_folder.filePath(QLatin1String(name)));
    if (!written.open(QIODevice::WriteOnly) || written.write(content) != content.size())
        qFatal("%s cannot be written", name);
    return std::filesystem::path(written.fileName().toStdU16String());
}

void TestModelLoader::initTestCase()
{
    QVERIFY(m_folder.isValid());
    m_large = file("large.stl", manyTriangles(20000));
    m_small = file("small.stl", manyTriangles(2));
    m_broken = file("broken.off", "OFF\n1 1 0\n");
}

void TestModelLoader::theGoodFilesComeInOrderAndTheOthersSayWhy()
{
    opening::ModelFiles files;
    ModelLoader loader(files);
    QSignalSpy finished(&loader, &ModelLoader::finished);
    QSignalSpy progressed(&loader, &ModelLoader::progressed);
    loader.load({m_large, m_broken, m_small});
    QVERIFY(loader.isLoading());
    QVERIFY(finished.wait(kPatienceMilliseconds));
    QVERIFY(!loader.isLoading());

    const auto models = finished[0][0].value<std::vector<LoadedModel>>();
    const auto errors = finished[0][1].value<std::vector<ImportError>>();
    QCOMPARE(models.size(), std::size_t(2));
    QCOMPARE(models[0].model->triangleCount(), std::size_t(20000));
    QCOMPARE(models[1].model->triangleCount(), std::size_t(2));
    QCOMPARE(errors.size(), std::size_t(1));
    QVERIFY(errors[0].file == m_broken);
    double last = 0.0;
    for (const QList<QVariant> &report : progressed) {
        QVERIFY(report[1].toDouble() >= last);
        last = report[1].toDouble();
    }
    QCOMPARE(last, 1.0);
}

void TestModelLoader::nothingComesAfterACancel()
{
    opening::ModelFiles files;
    ModelLoader loader(files);
    QSignalSpy cancelled(&loader, &ModelLoader::cancelled);
    QSignalSpy finished(&loader, &ModelLoader::finished);
    QSignalSpy progressed(&loader, &ModelLoader::progressed);
    loader.load({m_large, m_large});
    loader.cancel();
    QCOMPARE(cancelled.size(), 1);
    QVERIFY(!loader.isLoading());
    QVERIFY(!finished.wait(200));
    QCOMPARE(progressed.size(), 0);
}

void TestModelLoader::aSecondLoadingTakesTheFirstOnesPlace()
{
    opening::ModelFiles files;
    ModelLoader loader(files);
    QSignalSpy cancelled(&loader, &ModelLoader::cancelled);
    QSignalSpy finished(&loader, &ModelLoader::finished);
    loader.load({m_large});
    loader.load({m_small});
    QCOMPARE(cancelled.size(), 1);
    QVERIFY(finished.wait(kPatienceMilliseconds));
    QCOMPARE(finished.size(), 1);
    const auto models = finished[0][0].value<std::vector<LoadedModel>>();
    QCOMPARE(models.size(), std::size_t(1));
    QVERIFY(models[0].file == m_small);
}

void TestModelLoader::aLoaderMayGoWhileItLoads()
{
    for (int i = 0; i < 5; ++i) {
        opening::ModelFiles files;
        ModelLoader loader(files);
        loader.load({m_large, m_small});
        QTest::qWait(i);
    }
}

QTEST_GUILESS_MAIN(TestModelLoader)
#include "test_model_loader.moc"
