// Loading on a thread of its own, without a window: the thread sanitizer can follow this.

#include "tests/support/test.h"

#include "gui/document/scene_opener.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <filesystem>
#include <vector>

using namespace unprojector;
using namespace unprojector::gui;

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

Opening asked(const std::vector<std::filesystem::path> &models)
{
    Opening opening;
    opening.models = models;
    return opening;
}

} // namespace

class TestSceneOpener : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_large = file("large.stl", manyTriangles(20000));
        m_small = file("small.stl", manyTriangles(2));
        m_broken = file("broken.off", "OFF\n1 1 0\n");
    }

    void theGoodFilesComeInOrderAndTheOthersSayWhy()
    {
        SceneOpener opener;
        QSignalSpy opened(&opener, &SceneOpener::opened);
        QSignalSpy progressed(&opener, &SceneOpener::progressed);
        opener.load(asked({m_large, m_broken, m_small}));
        QVERIFY(opener.isLoading());
        QVERIFY(opened.wait(kPatienceMilliseconds));
        QVERIFY(!opener.isLoading());

        const auto result = opened[0][0].value<Opened>();
        QCOMPARE(result.objects.size(), std::size_t(2));
        QCOMPARE(result.objects[0].model->triangleCount(), std::size_t(20000));
        QCOMPARE(result.objects[1].model->triangleCount(), std::size_t(2));
        QCOMPARE(result.errors.size(), 1);
        QVERIFY2(result.errors[0].contains("broken.off"), qPrintable(result.errors[0]));
        double last = 0.0;
        for (const QList<QVariant> &report : progressed) {
            QVERIFY(report[1].toDouble() >= last);
            last = report[1].toDouble();
        }
        QCOMPARE(last, 1.0);
    }

    void nothingComesAfterACancel()
    {
        SceneOpener opener;
        QSignalSpy ended(&opener, &SceneOpener::ended);
        QSignalSpy opened(&opener, &SceneOpener::opened);
        QSignalSpy progressed(&opener, &SceneOpener::progressed);
        opener.load(asked({m_large, m_large}));
        opener.cancel();
        QCOMPARE(ended.size(), 1);
        QVERIFY(!opener.isLoading());
        QVERIFY(!opened.wait(200));
        QCOMPARE(progressed.size(), 0);
    }

    void aSecondLoadingTakesTheFirstOnesPlace()
    {
        SceneOpener opener;
        QSignalSpy ended(&opener, &SceneOpener::ended);
        QSignalSpy opened(&opener, &SceneOpener::opened);
        opener.load(asked({m_large}));
        opener.load(asked({m_small}));
        QCOMPARE(ended.size(), 1);
        QVERIFY(opened.wait(kPatienceMilliseconds));
        QCOMPARE(opened.size(), 1);
        const auto result = opened[0][0].value<Opened>();
        QCOMPARE(result.objects.size(), std::size_t(1));
        QVERIFY(result.objects[0].file == m_small);
    }

    /// A caller that waits for the end waits for the last opening's.
    void anOpeningThatStartsTheNextHasNotEnded()
    {
        SceneOpener opener;
        QSignalSpy ended(&opener, &SceneOpener::ended);
        int opened = 0;
        qsizetype endedBetween = -1;
        connect(&opener, &SceneOpener::opened, this, [&] {
            if (++opened == 1)
                opener.load(asked({m_small}));
            else
                endedBetween = ended.size();
        });
        opener.load(asked({m_small}));
        QTRY_COMPARE_WITH_TIMEOUT(opened, 2, kPatienceMilliseconds);
        QCOMPARE(endedBetween, 0);
        QCOMPARE(ended.size(), 1);
    }

    void anOpenerMayGoWhileItLoads()
    {
        for (int i = 0; i < 5; ++i) {
            SceneOpener opener;
            opener.load(asked({m_large, m_small}));
            QTest::qWait(i);
        }
    }

private:
    std::filesystem::path file(const char *name, const QByteArray &content) const
    {
        QFile written(m_folder.filePath(QLatin1String(name)));
        if (!written.open(QIODevice::WriteOnly) || written.write(content) != content.size())
            qFatal("%s cannot be written", name);
        return std::filesystem::path(written.fileName().toStdU16String());
    }

    QTemporaryDir m_folder;
    std::filesystem::path m_large, m_small, m_broken;
};

UNPROJECTOR_TEST(TestSceneOpener, threads)
#include "test_scene_opener.moc"
