// The words of the command line: the help of every command, and the errors for unknown words.

#include "tests/support/test.h"

#include "tests/cli/depth_files.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QMap>
#include <QRegularExpression>

namespace {

const QList<const char *> kCommands{"points",  "pick", "project",  "info", "scene",     "cloud",
                                    "compare", "map",  "matrices", "code", "landmarks", "doctor"};

/// The texts of a file of resources/help/command by the names in their headings.
QMap<QString, QString> sectionsOf(const QString &file)
{
    QFile texts(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/resources/help/command/") + file);
    if (!texts.open(QIODevice::ReadOnly | QIODevice::Text))
        qFatal("%s cannot be read", qPrintable(texts.fileName()));
    static const QRegularExpression heading(QStringLiteral("\\n\\[([^ \\]]+)[^\\]\\n]*\\]\\n"));
    const QString all = QString::fromUtf8(texts.readAll());
    QMap<QString, QString> sections;
    for (auto it = heading.globalMatch(all); it.hasNext();) {
        const QRegularExpressionMatch found = it.next();
        const qsizetype start = found.capturedEnd(), end = it.hasNext() ? it.peekNext().capturedStart() : all.size();
        for (const QString &name : found.captured(1).split(u','))
            sections[name] = all.mid(start, end - start);
    }
    return sections;
}

/// The options and positionals of a command, as its help lists them, with all their names.
QStringList optionsOf(const char *command)
{
    static const QRegularExpression entry(QStringLiteral("^  ([A-Z]\\S*|-\\S+)"), QRegularExpression::MultilineOption);
    const QString help = QString::fromUtf8(runCommand({command, "--help"}).output);
    QStringList options;
    for (auto it = entry.globalMatch(help.mid(help.indexOf(QStringLiteral("\n\n")))); it.hasNext();)
        options << it.next().captured(1).split(u',');
    options.removeOne(QStringLiteral("-h"));
    options.removeOne(QStringLiteral("--help"));
    return options;
}

} // namespace

class TestCommandLine : public QObject {
    Q_OBJECT

private slots:
    void everyOptionHasItsText_data()
    {
        addColumn<QString>("language");
        newRow("english") << "";
        newRow("chinese") << "_zh_CN";
    }

    /// Each option has a text, each text an option, and the translation the same places for values.
    void everyOptionHasItsText()
    {
        QFETCH(QString, language);
        const auto shared = sectionsOf("shared" + language + ".txt");
        QStringList unused = shared.keys();
        for (const char *name : {"MODEL-OR-SCENE", "bad"}) // under other names
            QVERIFY(unused.removeOne(name));
        for (const char *command : kCommands) {
            const auto texts = sectionsOf(command + language + ".txt"), english = sectionsOf(QString(command) + ".txt");
            QStringList options = optionsOf(command);
            QVERIFY(!options.isEmpty());
            options << "footer";
            for (const QString &option : options) {
                QVERIFY2(!texts.value(option, shared.value(option)).isEmpty(), qPrintable(command + (' ' + option)));
                if (!texts.contains(option))
                    unused.removeOne(option);
            }
            for (auto text = texts.begin(); text != texts.end(); ++text) {
                QVERIFY2(options.contains(text.key()), qPrintable(command + (' ' + text.key())));
                QCOMPARE(text->count("%1"), english[text.key()].count("%1"));
            }
        }
        QCOMPARE(unused, QStringList());
    }

    void helpHasExamplesThatWork_data()
    {
        addColumn<QString>("command");
        for (const char *command :
             {"points", "project", "cloud", "code", "compare", "matrices", "scene", "landmarks", "doctor"})
            newRow(command) << command;
    }

    /// The examples are extracted from the help and run unchanged.
    void helpHasExamplesThatWork()
    {
        QFETCH(QString, command);
        const Run help = runCommand({command, "--help"});
        QCOMPARE(help.exitCode, 0);
        QCOMPARE(help.errors, QByteArray());
        const qsizetype at = help.output.indexOf("\nExample");
        QVERIFY(at > 0);
        QByteArray examples = help.output.mid(help.output.indexOf('\n', at + 1) + 1);
        examples.truncate(examples.contains("\n\n") ? examples.indexOf("\n\n") : examples.size());
        QVERIFY(examples.contains("unproject " + command.toUtf8()));
#ifdef Q_OS_UNIX
        m_folder.write("scene.json", kFrustumScene);
        m_folder.write("clicks.csv", "px,py,depth\n1.5,2.5,0.5\n");
        m_folder.write("pixels.csv", "px,py,depth\n1,2,0.5\n");
        m_folder.write("many.csv", "px,py,depth\n1,2,0.5\n");
        m_folder.write("points.csv", "x,y,z\n0,0,2\n");
        m_folder.write("clicks.json", "[{\"window\": [400.5, 300.5, 0.5], \"scene\": " + kFrustumScene + "}]");
        m_folder.write("depth.pfm", "Pf\n800 600\n-1\n" + QByteArray(qsizetype(800) * 600 * 4, '\0'));
        m_folder.write("depth.npy", npy(npyHeader("<u2", "(600, 800)"), QByteArray("\xd0\x07").repeated(800 * 600)));
        m_folder.write("depth.raw", QByteArray(qsizetype(1920) * 1080 * 4, '\0'));
        m_folder.write("matrices.txt",
                       "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1  1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0  0 0 400 300");
        m_folder.write("camera.yml",
                       "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\nK: !!opencv-matrix\n   rows: 3\n"
                       "   cols: 3\n   dt: d\n   data: [ 800., 0., 319.5, 0., 800., 239.5, 0., 0., 1. ]\n"
                       "rvec: [ 0., 0., 0. ]\ntvec: [ 0., 0., 5. ]\n");
        m_folder.write("wrong.csv", "px,py,depth,x,y,z\n400,300,0.5,0.1,0.2,3.4\n");
        m_folder.write("scan.ply",
                       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                       "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                       "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        const QByteArray skull = "<PickedPoints><point x=\"1\" y=\"2\" z=\"3\" name=\"N\"/></PickedPoints>";
        for (const char *file : {"skull.pp", "monday.pp", "tuesday.pp"})
            m_folder.write(file, skull);
        m_folder.write("points.fcsv",
                       "# Markups fiducial file version = 5.8\n# CoordinateSystem = LPS\n0,1,2,3,0,0,0,1,1,1,0,N,,\n");
        QVERIFY(QDir().mkpath(m_folder.path("skulls")));
        m_folder.write("skulls/1.pp", skull);
        m_folder.write("skulls/2.pts", "Version 1.0\n1\nN 1 2 3\n\n");
        m_folder.write("protocol.csv", "name,kind,landmarks\nwidth,length,N,N\n");
        QVERIFY(QDir().mkpath(m_folder.path("scans")));
        for (const char *file : {"1.ply.points.csv", "1.ply.points-2.csv", "2.ply.points.csv", "2.ply.points-2.csv"})
            m_folder.write(QStringLiteral("scans/") + QLatin1String(file), "name,x,y,z\na,0,0,0\nb,1,0,0\nc,0,1,0\n");
        examples.replace("\n      ", " "); // a long one goes on in the next line
        for (const QByteArray &line : examples.trimmed().split('\n')) {
            const QByteArray example = line.trimmed();
            if (example.startsWith("parallel ") || example.contains("1920x1080"))
                continue; // another program's; another window's
            QProcess shell;
            shell.setWorkingDirectory(m_folder.path("."));
            shell.start("sh", {"-c", "unproject() { '" UNPROJECT_COMMAND "' \"$@\"; }; " + QString::fromUtf8(example)});
            QVERIFY(shell.waitForFinished(kPatienceMilliseconds));
            const QByteArray errors = shell.readAllStandardError();
            const bool saysWhatItWrote = command == "cloud" && errors == "cloud.ply: 480000 points of 480000 pixels\n";
            QVERIFY2((errors.isEmpty() || saysWhatItWrote) && shell.exitCode() == 0,
                     (example + '\n' + errors).constData());
            // The examples of `scene` write the scene of the others.
            m_folder.write("scene.json", kFrustumScene);
        }
#endif
    }

    void resultsThatCannotBeWritten_data()
    {
        addColumn<QStringList>("words");
        const QString scene = m_folder.write("scene.json", kFrustumScene);
        const QString rows = m_folder.write("rows.csv", "px,py,depth\n" + QByteArray("1,2,0.5\n").repeated(100000));
        const QString places = m_folder.write("places.csv", "x,y,z\n1,2,0.5\n");
        const QString depth = m_folder.write("depth.raw", QByteArray(qsizetype(800) * 600 * 4, '\0'));
        const QString numbers = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1  1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0  0 0 400 300";
        newRow("help") << QStringList{"--help"};
        newRow("help of a command") << QStringList{"points", "--help"};
        newRow("version") << QStringList{"--version"};
        newRow("points") << QStringList{"points", scene, rows};
        newRow("points, one thread") << QStringList{"points", "--threads", "1", scene, rows};
        newRow("project") << QStringList{"project", scene, places};
        newRow("matrices") << QStringList{"matrices", scene};
        newRow("compare") << QStringList{"compare", "--pixels", "2", scene};
        newRow("compare as JSON") << QStringList{"compare", "--json", "--pixels", "2", scene};
        newRow("cloud") << QStringList{"cloud", "--size", "800x600", scene, depth, "-o", "-"};
        newRow("scene") << QStringList{"scene", "--from-matrices", numbers};
    }

    void resultsThatCannotBeWritten()
    {
        QFETCH(QStringList, words);
        if (!QFile::exists("/dev/full"))
            QSKIP("no device that is always full");
        QProcess process;
        process.setStandardOutputFile("/dev/full");
        process.start(QStringLiteral(UNPROJECT_COMMAND), words);
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.readAllStandardError(), QByteArray("stdout: cannot be written: No space left on device\n"));
        QCOMPARE(process.exitCode(), 2);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestCommandLine)
#include "test_command_line.moc"
