// Files that are not scenes, through the executable: a message with the file and the position, exit
// code 2, never a crash.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#ifndef Q_OS_WIN
#include <sys/stat.h>
#endif

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>

namespace {

/// Every key that the command reads.
const QByteArray kScene = R"({"unprojector": 1,
 "window": {"width": 8, "height": 6, "devicePixelRatio": 1},
 "viewport": {"x": 0, "y": 0, "width": 8, "height": 6},
 "depthRange": [0, 1],
 "projection": {"type": "oblique", "left": -2, "right": 2, "bottom": -1, "top": 1, "near": 1, "far": 4, "theta": 45, "phi": 60},
 "view": {"eye": [0, 0, 5], "center": [0, 0, 1], "up": [0, 1, 0]},
 "objects": [{"name": "face", "file": "f.obj", "transform": [{"translate": [0, 0, 3]}, {"rotate": [9, 0, 1, 0]}, {"scale": [2, 3, 4]}]}],
 "clipPlanes": [[0, 1, 0, 0]]})";

/// The keys that only other scenes have.
const QByteArray kMatrixScene = R"({"unprojector": 1, "window": {"width": 8, "height": 6},
 "projection": {"type": "matrix", "matrix": [1,0,0,0, 0,1,0,0, 0,0,-2,-1, 0,0,-3,0], "ndcDepth": [-1, 1]},
 "view": {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5,1]},
 "objects": [{"bundled": "Teapot"}]})";
const QByteArray kPerspectiveScene = R"({"unprojector": 1, "window": {"width": 8, "height": 6},
 "projection": {"type": "perspective", "fovy": 45, "aspect": 1.5, "near": 1, "far": 4},
 "view": {"eye": [0, 0, 5], "center": [0, 0, 1], "up": [0, 1, 0]}})";

using Steps = QList<QVariant>; ///< keys and places

QString pathOf(const Steps &steps)
{
    QString path;
    for (const QVariant &step : steps) {
        if (step.typeId() == QMetaType::QString)
            path += (path.isEmpty() ? "" : ".") + step.toString();
        else
            path += '[' + step.toString() + ']';
    }
    return path;
}

/// All values below a value.
void collect(const QJsonValue &value, const Steps &steps, QList<Steps> &all)
{
    if (!steps.isEmpty())
        all.append(steps);
    const QJsonObject object = value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it)
        collect(it.value(), steps + Steps{it.key()}, all);
    const QJsonArray array = value.toArray();
    for (int i = 0; i < array.size(); ++i)
        collect(array[i], steps + Steps{i}, all);
}

QJsonValue valueAt(QJsonValue value, const Steps &steps)
{
    for (const QVariant &step : steps)
        value = step.typeId() == QMetaType::QString ? value[step.toString()] : value[step.toInt()];
    return value;
}

QJsonValue replaced(const QJsonValue &value, const Steps &steps, const QJsonValue &by)
{
    if (steps.isEmpty())
        return by;
    const QJsonValue inner = replaced(valueAt(value, {steps[0]}), steps.mid(1), by);
    if (steps[0].typeId() == QMetaType::QString) {
        QJsonObject object = value.toObject();
        object[steps[0].toString()] = inner;
        return object;
    }
    QJsonArray array = value.toArray();
    array[steps[0].toInt()] = inner;
    return array;
}

/// "LINE:COLUMN" of a place in a text, both counted from 1.
QByteArray lineAndColumn(const QByteArray &text, qsizetype at)
{
    const QByteArray before = text.left(at);
    return QByteArray::number(before.count('\n') + 1) + ':' + QByteArray::number(at - before.lastIndexOf('\n'));
}

} // namespace

class TestSceneInput : public QObject {
    Q_OBJECT

private slots:
    void noTruncationIsRead()
    {
        for (qsizetype length = 0; length < kPerspectiveScene.size(); length += tests::spacing(1)) {
            verifyRefused(kPerspectiveScene.left(length), length == 0 ? ": the file is empty" : ":");
            if (QTest::currentTestFailed())
                return;
        }
    }

    void everyValueHasItsType_data()
    {
        addColumn<QByteArray>("scene");
        addColumn<QByteArray>("message");
        const QList<std::pair<const char *, QJsonValue>> values{{"null", QJsonValue()},   {"true", true},
                                                                {"a number", 7},          {"a text", "seven"},
                                                                {"a list", QJsonArray{}}, {"an object", QJsonObject{}}};
        QSet<QByteArray> known; // keys of one scene are not tried with the next
        for (const QByteArray &scene : {kScene, kMatrixScene, kPerspectiveScene}) {
            const QJsonValue root = QJsonDocument::fromJson(scene).object();
            QList<Steps> all;
            collect(root, {}, all);
            for (const Steps &steps : std::as_const(all)) {
                const QByteArray path = pathOf(steps).toUtf8();
                // A matrix's last number stands for all of them.
                const bool isOneOfMany =
                    valueAt(root, steps.mid(0, steps.size() - 1)).toArray().size() == 16 && steps.last() != 15;
                if (isOneOfMany || known.contains(path))
                    continue;
                known.insert(path);
                for (const auto &[name, value] : values) {
                    if (valueAt(root, steps).type() == value.type())
                        continue;
                    addRow("%s: %s", path.constData(), name)
                        << QJsonDocument(replaced(root, steps, value).toObject()).toJson() << path + ": expected ";
                }
            }
        }
    }

    void everyValueHasItsType()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QByteArray, message);
        const QByteArray place = placeIn(with(scene).errors);
        QVERIFY(!place.isEmpty());
        verifyRefused(scene, ':' + place + ": " + message);
    }

    void noKeyStandsTwice_data()
    {
        addColumn<QByteArray>("scene");
        addColumn<QByteArray>("message");
        QRegularExpressionMatchIterator keys = QRegularExpression("\"(\\w+)\":").globalMatch(QString::fromUtf8(kScene));
        while (keys.hasNext()) {
            const QRegularExpressionMatch key = keys.next();
            const QByteArray name = key.captured(1).toUtf8(), once = '"' + name + "\": [], ";
            const QByteArray scene = QByteArray(kScene).insert(key.capturedStart(), once);
            addRow("%s at %d", name.constData(), int(key.capturedStart()))
                << scene
                << ':' + lineAndColumn(scene, key.capturedStart() + once.size()) + ": the key \"" + name
                       + "\" is here for the second time\n";
        }
    }

    void noKeyStandsTwice()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QByteArray, message);
        verifyRefused(scene, message);
    }

    void noNumberIsTooLarge_data()
    {
        addColumn<QByteArray>("scene");
        addColumn<QByteArray>("message");
        QRegularExpressionMatchIterator numbers =
            QRegularExpression("(?<=[ \\[,])-?[0-9.]+(?=[,\\]}])").globalMatch(QString::fromUtf8(kScene));
        while (numbers.hasNext()) {
            const QRegularExpressionMatch number = numbers.next();
            const QByteArray scene =
                QByteArray(kScene).replace(number.capturedStart(), number.capturedLength(), "-1e400");
            addRow("at %d", int(number.capturedStart()))
                << scene << ':' + lineAndColumn(scene, number.capturedStart()) + ": -1e400 is too large for a number\n";
        }
    }

    void noNumberIsTooLarge()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QByteArray, message);
        verifyRefused(scene, message);
    }

    void endlessBrackets_data()
    {
        addColumn<QByteArray>("scene");
        addColumn<QByteArray>("message");
        const QByteArray open(10000, '['), deep("brackets are nested deeper than 64 levels\n");
        newRow("lists") << open << ":1:65: " + deep;
        newRow("lists, closed") << open + QByteArray(10000, ']') << ":1:65: " + deep;
        newRow("objects") << QByteArray("{\"a\":").repeated(10000) << ":1:321: " + deep;
        newRow("under an unknown key") << QByteArray(kScene).replace("\"window\"", "\"x\": " + open + ", \"window\"")
                                       << QByteArray(":2:");
    }

    void endlessBrackets()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QByteArray, message);
        verifyRefused(scene, message);
    }

    void aHugeFile()
    {
        const QString path = m_folder.path("huge.json");
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            QVERIFY(file.resize((qint64{256} << 20) + 1)); // zeros, which take no room on most disks
        }
        const Run run = runCommand({"points", path}, "px,py,depth\n4,3,0.5\n");
        QFile::remove(path);
        QCOMPARE(run.errors,
                 path.toUtf8()
                     + ": a scene may have at most 256 MiB; keep the landmarks in a file of their own (File > Export "
                       "Landmarks), then remove them from the scene\n");
        QCOMPARE(run.output, QByteArray());
        QCOMPARE(run.exitCode, 2);
    }

    void aNamedPipeIsNotWaitedFor()
    {
#ifdef Q_OS_WIN
        QSKIP("no named pipes among the files");
#else
        const QString pipe = m_folder.path("pipe.json");
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        for (const QString &path : {pipe, QStringLiteral("/dev/zero")}) {
            const Run run = runCommand({"matrices", path});
            QCOMPARE(run.errors, path.toUtf8() + ": this is a pipe or a device, not a scene file\n");
            QCOMPARE(run.exitCode, 2);
        }
#endif
    }

    /// The pipe is open already, and its writer exists.
    void aPipeOfTheShellIsRead()
    {
        if (!QFile::exists("/dev/stdin"))
            QSKIP("stdin has no name here");
        const Run run = runCommand({"matrices", "/dev/stdin"}, kScene);
        QCOMPARE(run.errors, QByteArray());
        QCOMPARE(run.output, runCommand({"matrices", m_folder.write("plain", kScene)}).output);
        QCOMPARE(run.exitCode, 0);
    }

private:
    /// Runs a command that reads the scene; its points are in order.
    Run with(const QByteArray &scene) const
    {
        return runCommand({"points", m_folder.write("scene.json", scene)}, "px,py,depth\n4,3,0.5\n");
    }
    /// The line and the column in a message about the scene.
    QByteArray placeIn(const QByteArray &message) const
    {
        static const QRegularExpression place("^:(\\d+:\\d+): ");
        return place.match(QString::fromUtf8(message.mid(m_folder.path("scene.json").toUtf8().size())))
            .captured(1)
            .toUtf8();
    }
    /// @param message  the text after the file's name
    void verifyRefused(const QByteArray &scene, const QByteArray &message) const
    {
        const Run run = with(scene);
        const QByteArray expected = m_folder.path("scene.json").toUtf8() + message;
        QVERIFY2(run.errors.startsWith(expected), "expected\n" + expected + "\nfound\n" + run.errors);
        QCOMPARE(run.errors.count('\n'), 1);
        QCOMPARE(run.output, QByteArray());
        QCOMPARE(run.exitCode, 2);
    }

    Folder m_folder;
};

UNPROJECTOR_TEST(TestSceneInput)
#include "test_scene_input.moc"
