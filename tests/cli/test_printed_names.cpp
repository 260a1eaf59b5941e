// The command's text for people has no control characters, even if names and files contain them;
// machine-readable output keeps them.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include "core/base/printable.h"

#include <QJsonDocument>

namespace {

/// A colour, a window's title, the C1 character that begins such a sequence, an override of the
/// text's direction, an isolate.
const QByteArray kName = "\033[31mred\033]0;title\a\u009b2J\u202egpj\u2066x";
const QByteArray kPrinted = "\\x1b[31mred\\x1b]0;title\\x07\\u009b2J\\u202egpj\\u2066x";
const QByteArray kInJson = "\\u001b[31mred\\u001b]0;title\\u0007\u009b2J\u202egpj\u2066x";

QByteArray sceneWith(const QByteArray &object)
{
    return QByteArray(kFrustumScene).replace("\"face\"", '"' + object + '"');
}

bool isPrintable(const QByteArray &text)
{
    return unprojector::base::printableLines(text.toStdString()) == text.toStdString();
}

} // namespace

class TestPrintedNames : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_folder.write("face.obj", "usemtl " + kName + "\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
        m_scene = m_folder.write("scene.json", sceneWith(kInJson));
    }

    void tablesForPeople_data()
    {
        addColumn<QStringList>("words");
        newRow("info") << QStringList{"info"};
        newRow("pick") << QStringList{"pick", "--at=400.5,300.5"};
    }

    void tablesForPeople()
    {
        QFETCH(QStringList, words);
        const Run run = runCommand(words << m_scene);
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(isPrintable(run.output) && isPrintable(run.errors), run.output.constData());
        QVERIFY2(run.output.contains(kPrinted), run.output.constData());
    }

    void aNameIsOneLine()
    {
        const QString scene = m_folder.write("lines.json", sceneWith("face\\nvertices  9"));
        for (const QStringList &words : {QStringList{"info", scene}, {"pick", scene, "--at", "400.5,300.5"}})
            QVERIFY(runCommand(words).output.contains("face\\x0avertices  9"));
    }

    void dataKeepThem()
    {
        const Run rows = runCommand({"pick", m_scene, "-"}, "px,py\n400.5,300.5\n");
        QCOMPARE(rows.exitCode, 0);
        QVERIFY2(rows.output.contains(kName), rows.output.constData());
        const Run info = runCommand({"info", "--json", m_scene});
        const QString name = QJsonDocument::fromJson(info.output)["objects"][0]["name"].toString();
        QCOMPARE(name.toUtf8(), kName);
        const QString points = m_folder.write("points.csv", "name,x,y,z\n" + kName + ",1,2,3\n");
        QVERIFY(runCommand({"landmarks", points, "-", "--to", "csv"}).output.contains(kName));
    }

    void messages_data()
    {
        addColumn<QStringList>("words");
        newRow("an object that is not there")
            << QStringList{"points", "--space", "object:x" + QString::fromUtf8(kName), m_scene, "-"};
        newRow("a command") << QStringList{QString::fromUtf8(kName)};
        newRow("a word too many") << QStringList{"info", m_scene, QString::fromUtf8(kName)};
        newRow("an option") << QStringList{"info", m_scene, "--" + QString::fromUtf8(kName)};
        newRow("a value") << QStringList{"compare", m_scene, "--pixels", QString::fromUtf8(kName)};
        newRow("a file that is not there") << QStringList{"info", QString::fromUtf8(kName) + ".json"};
        newRow("an output's folder") << QStringList{"code",  "--for", "glm",
                                                    m_scene, "-o",    QString::fromUtf8(kName) + "/x"};
        newRow("a landmark's name") << QStringList{
            "landmarks", "--mesh", m_folder.path("face.obj"),
            "--to",      "csv",    m_folder.write("distant.csv", "name,x,y,z\n" + kName + ",900,2,3\n"),
            "-"};
        newRow("a landmark's number") << QStringList{
            "landmarks", "--to", "csv", m_folder.write("bad.csv", "name,x,y,z\na," + kName + ",2,3\n"), "-"};
        newRow("a scene's key") << QStringList{
            "info", m_folder.write("key.json", "{\"unprojector\": 1, \"" + kInJson + "\": 1}")};
        newRow("a model's word") << QStringList{
            "info", m_folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + kName + "\n")};
    }

    void messages()
    {
        QFETCH(QStringList, words);
        const Run run = runCommand(words, "px,py,depth\n1,2,0.5\n");
        QVERIFY(!run.errors.isEmpty());
        QVERIFY2(isPrintable(run.errors), run.errors.constData());
    }

    void namesOfFiles()
    {
#ifdef Q_OS_WIN
        QSKIP("names have no controls here");
#else
        const QString file = m_folder.write(QString::fromUtf8(kName) + ".csv", "name,x,y,z\na,1,2,3\n\n\n");
        const QByteArray depth(qsizetype(800) * 600 * 4, '\0');
        const Run cloud = runCommand(
            {"cloud", "--size", "800x600", m_scene, m_folder.write("depth.raw", depth), "-o", file + ".ply"});
        QCOMPARE(cloud.exitCode, 0);
        QVERIFY2(isPrintable(cloud.errors) && cloud.errors.contains(kPrinted), cloud.errors.constData());
#endif
    }

private:
    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestPrintedNames)
#include "test_printed_names.moc"
