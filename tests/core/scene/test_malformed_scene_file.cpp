// Any error in a scene file is reported with its position, and soon.

#include "tests/support/test.h"

#include "core/scene_file/scene_file.h"

#include "tests/core/scene_texts.h"
#include "tests/support/data_files.h"

#include <QFile>
#include <QTemporaryDir>

#include <ctime>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;
using namespace scene_texts;

namespace {

QByteArray messageFor(const QByteArray &text)
{
    const auto scene = parseScene(std::string_view(text.constData(), std::size_t(text.size())), "scene.json");
    return scene ? QByteArray("it was read") : QByteArray::fromStdString(scene.error().message());
}

} // namespace

class TestMalformedSceneFile : public QObject {
    Q_OBJECT

private slots:
    void malformedScenesAreRefusedWithTheirPlace_data() { data_files::addCases("scene"); }

    void malformedScenesAreRefusedWithTheirPlace()
    {
        QFETCH(data_files::Case, example);
        QCOMPARE(messageFor(QByteArray::fromStdString(example.text)), QByteArray::fromStdString(example.refused()));
    }

    void deepScenesAreRefused()
    {
        const QByteArray why = ": brackets are nested deeper than 64 levels";
        QCOMPARE(messageFor(QByteArray(10000, '[')), "scene.json:1:65" + why);
        QCOMPARE(messageFor(QByteArray("{\"a\":").repeated(10000)), "scene.json:1:321" + why);
    }

    void noTruncationIsAccepted()
    {
        const QByteArray text(kFullScene);
        for (qsizetype length = 0; length < text.size(); ++length) {
            const QByteArray message = messageFor(text.left(length));
            QVERIFY2(message.startsWith("scene.json:"), message);
        }
    }

    void noByteBroken()
    {
        // The file is either read or rejected if any byte is replaced by any of these.
        const QByteArray text(kFullScene);
        for (qsizetype at = 0; at < text.size(); ++at) {
            for (const char byte : {'\0', '"', '{', ']', ',', '9', '-', 'e', '\xFF', '\\', '\n'}) {
                QByteArray broken = text;
                broken[at] = byte;
                QVERIFY(!messageFor(broken).isEmpty());
            }
        }
    }

    void hugeFilesAreRefused()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("huge.json");
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            QVERIFY(file.resize((qint64{256} << 20) + 1));
        }
        const auto scene = readSceneFile(path.toStdString());
        QVERIFY(!scene);
        QCOMPARE(QByteArray::fromStdString(scene.error().message()),
                 path.toUtf8()
                     + ": a scene may have at most 256 MiB; keep the landmarks in a file of their own (File > "
                       "Export Landmarks), then remove them from the scene");
    }

    void manyKeysTakeLittleTime()
    {
        QByteArray members;
        for (int i = 0; i < 300000; ++i)
            members += "\"k" + QByteArray::number(i) + "\": 0,";
        members.chop(1);
        // The processor's time, which other programs on the machine do not take.
        const std::clock_t start = std::clock();
        QCOMPARE(messageFor(withMember("\"many\": {" + members + "}")), QByteArray("it was read"));
        // A search among the keys before for each key would take minutes.
        QVERIFY((std::clock() - start) / CLOCKS_PER_SEC < 30);
    }
};

UNPROJECTOR_TEST(TestMalformedSceneFile)
#include "test_malformed_scene_file.moc"
