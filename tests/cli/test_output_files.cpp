// The command's output files: complete or unchanged; inputs are never overwritten, devices stay
// devices.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/support/patience.h"

#include <QDir>

#include <csignal>

#ifndef Q_OS_WIN
#include <sys/resource.h>
#include <sys/stat.h>
#endif

namespace {

/// The size of the cloud of 800 x 600 depths of 0: as many points of 12 bytes.
constexpr qsizetype kCloudBytes = qsizetype(800) * 600 * 12;
const QString kNumbers = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1  1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0  0 0 400 300";

} // namespace

class TestOutputFiles : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<Folder>();
        QVERIFY(QDir(m_folder->path(".")).mkdir("files"));
        m_scene = m_folder->write("scene.json", kFrustumScene);
        m_depth = m_folder->write("depth.raw", QByteArray(qsizetype(800) * 600 * 4, '\0'));
    }

    void namesAreTaken_data()
    {
        addColumn<QString>("name");
        newRow("plain") << "out";
        newRow("blanks") << "a b  c.out";
        newRow("Chinese") << QStringLiteral("\u70B9\u4E91.out");
        newRow("a dash before") << "./-o.out";
        newRow("long") << QString(180, 'a');
    }

    void namesAreTaken()
    {
        QFETCH(QString, name);
        const QString output = path(name);
        for (int i = 0; i < 2; ++i) { // new, and over the one before
            const Run cloud = runCommand(cloudTo(output));
            QVERIFY2(hasWritten(cloud, output), cloud.errors.constData());
            QVERIFY(read(name).startsWith("ply\n") && read(name).size() > kCloudBytes);
            const Run scene = runCommand({"scene", "--from-matrices", kNumbers, "-o", output});
            QCOMPARE(scene.errors, QByteArray());
            QCOMPARE(scene.exitCode, 0);
            QVERIFY(read(name).startsWith("{\n  \"unprojector\": 1,"));
        }
        QCOMPARE(names(), QStringList(QFileInfo(name).fileName()));
    }

    void namesAreRefused_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("message");
        newRow("a folder") << "folder" << QByteArray("this is a folder; give the name of a file\n");
        newRow("a folder, with a slash") << "folder/" << QByteArray("this is a folder; give the name of a file\n");
        newRow("the folder itself") << "." << QByteArray("this is a folder; give the name of a file\n");
        newRow("no such folder") << "none/out" << QByteArray("there is no such folder; make it or give another name\n");
        newRow("no name") << "none/" << QByteArray("there is no such folder; make it or give another name\n");
        newRow("read-only") << "read-only"
                            << QByteArray("the file is read-only; allow writing to it or give another name\n");
#ifndef Q_OS_WIN
        newRow("too long") << QString(256, 'a') << QByteArray("the file cannot be written (File name too long)\n");
#endif
    }

    void namesAreRefused()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, message);
        QVERIFY(QDir(path(".")).mkdir("folder"));
        QFile readOnly(m_folder->write("files/read-only", "before"));
        QVERIFY(readOnly.setPermissions(QFile::ReadOwner));
        const QString output = path(name);
        for (const QStringList &words : {cloudTo(output), {"scene", "--from-matrices", kNumbers, "-o", output}}) {
            const Run run = runCommand(words);
            QCOMPARE(run.errors, output.toUtf8() + ": " + message);
            QCOMPARE(run.exitCode, 2);
        }
        QCOMPARE(read("read-only"), QByteArray("before"));
        QCOMPARE(names(), QStringList({"folder", "read-only"}));
        QVERIFY(readOnly.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
    }

    void anInputIsNotWrittenOver_data()
    {
        addColumn<QString>("output");
        newRow("the scene") << "scene.json";
        newRow("the depths") << "depth.raw";
        newRow("by another way") << "files/../depth.raw";
        newRow("by a link") << "link";
        newRow("the matrices") << "matrices.txt";
    }

    void anInputIsNotWrittenOver()
    {
        QFETCH(QString, output);
        const QString matrices = m_folder->write("matrices.txt", kNumbers.toUtf8());
        if (output == "link") {
#ifdef Q_OS_WIN
            QSKIP("links are files of their own here");
#endif
            QVERIFY(QFile::link("depth.raw", m_folder->path("link")));
        }
        const QString path = m_folder->path(output);
        const Run run = runCommand(
            output == "matrices.txt" ? QStringList{"scene", "--from-matrices", matrices, "-o", path} : cloudTo(path));
        QVERIFY2(run.errors.startsWith(path.toUtf8() + ": this is the input "), run.errors.constData());
        QVERIFY(run.errors.endsWith(" too and would be destroyed; give another name\n"));
        QCOMPARE(run.exitCode, 2);
        QFile scene(m_scene), depth(m_depth), text(matrices);
        QVERIFY(scene.open(QIODevice::ReadOnly) && depth.open(QIODevice::ReadOnly) && text.open(QIODevice::ReadOnly));
        QCOMPARE(scene.readAll(), kFrustumScene);
        QCOMPARE(depth.size(), qint64(800 * 600 * 4));
        QCOMPARE(text.readAll(), kNumbers.toUtf8());
    }

    /// They would be read again, and again.
    void rowsAreNotAddedToTheirOwnInput()
    {
        if (!QFile::exists("/dev/stdout"))
            QSKIP("stdout has no name here");
        const QByteArray rows = "px,py,depth\n1,2,0.5\n";
        const QString file = m_folder->write("rows.csv", rows);
        for (const bool isStdin : {false, true}) {
            QProcess process;
            process.setStandardOutputFile(file, QIODevice::Append);
            if (isStdin)
                process.setStandardInputFile(file);
            process.start(QStringLiteral(UNPROJECT_COMMAND), {"points", m_scene, isStdin ? "-" : file});
            QVERIFY(process.waitForFinished(kPatienceMilliseconds));
            QCOMPARE(process.readAllStandardError(), "stdout: this is the input " + (isStdin ? "stdin" : file.toUtf8())
                                                         + " too and would be destroyed; give another name\n");
            QCOMPARE(process.exitCode(), 2);
            QFile after(file);
            QVERIFY(after.open(QIODevice::ReadOnly));
            QCOMPARE(after.readAll(), rows);
        }
    }

    void aFullDiskLeavesWhatWasThere()
    {
#ifdef Q_OS_WIN
        QSKIP("no limit to the size of files here");
#else
        m_folder->write("files/cloud.ply", "before");
        QProcess process;
        // The system then refuses to write on, as it does where a disk is full.
        process.setChildProcessModifier([] {
            const rlimit small{100000, 100000};
            setrlimit(RLIMIT_FSIZE, &small);
        });
        process.start(QStringLiteral(UNPROJECT_COMMAND), cloudTo(path("cloud.ply")));
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.readAllStandardError(),
                 path("cloud.ply").toUtf8() + ": the file cannot be written (File too large)\n");
        QCOMPARE(process.exitCode(), 2);
        QCOMPARE(read("cloud.ply"), QByteArray("before"));
        QCOMPARE(names(), QStringList("cloud.ply"));
#endif
    }

    void whatFailsLeavesWhatWasThere()
    {
        m_folder->write("files/cloud.ply", "before");
        m_folder->write("depth.raw", QByteArray(1000, '\0'));
        const Run run = runCommand(cloudTo(path("cloud.ply")));
        QVERIFY(run.errors.contains("the file is too short"));
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(read("cloud.ply"), QByteArray("before"));
        QCOMPARE(names(), QStringList("cloud.ply"));
    }

    void anInterruptionLeavesWhatWasThere_data()
    {
        addColumn<int>("signal");
        newRow("Ctrl+C") << SIGINT;
        newRow("kill") << SIGTERM;
#ifdef SIGHUP
        newRow("closed terminal") << SIGHUP;
#endif
    }

    void anInterruptionLeavesWhatWasThere()
    {
#ifdef Q_OS_WIN
        QSKIP("no signals between programs here");
#else
        QFETCH(int, signal);
        m_folder->write("files/cloud.ply", "before");
        QProcess process;
        process.start(QStringLiteral(UNPROJECT_COMMAND),
                      {"cloud", "--size", "800x600", m_scene, "-", "-o", path("cloud.ply")});
        QVERIFY(process.waitForStarted(kPatienceMilliseconds));
        QTRY_COMPARE_WITH_TIMEOUT(names().size(), qsizetype(2),
                                  kPatienceMilliseconds); // it has begun, and waits for depths
        QCOMPARE(kill(pid_t(process.processId()), signal), 0);
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.exitStatus(), QProcess::CrashExit); // the parent process sees that it was ended
        QCOMPARE(process.exitCode(), signal);
        QCOMPARE(read("cloud.ply"), QByteArray("before"));
        QVERIFY(hasWritten(runCommand(cloudTo(path("next.ply"))), path("next.ply")));
        QCOMPARE(names(), (QStringList{"cloud.ply", "next.ply"})); // the next run has swept the new file
#endif
    }

    void whatAKilledCommandLeftGoesWithTheNextWrite()
    {
        QProcess killed, living;
        for (auto *process : {&killed, &living}) {
            const QString output = path(process == &killed ? "killed.ply" : "living.ply");
            process->start(QStringLiteral(UNPROJECT_COMMAND),
                           {"cloud", "--size", "800x600", m_scene, "-", "-o", output});
            QVERIFY(process->waitForStarted(kPatienceMilliseconds));
        }
        QTRY_COMPARE_WITH_TIMEOUT(names().size(), qsizetype(2), kPatienceMilliseconds); // both wait for depths
        killed.kill();
        QVERIFY(killed.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(names().size(), qsizetype(2));
        QVERIFY(hasWritten(runCommand(cloudTo(path("next.ply"))), path("next.ply")));
        QCOMPARE(names().size(), qsizetype(2)); // that of the living one stays
        QVERIFY(names().contains("next.ply"));
        living.write(QByteArray(qsizetype(800) * 600 * 4, '\0'));
        living.closeWriteChannel();
        QVERIFY(living.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(living.exitCode(), 0);
        QCOMPARE(names(), (QStringList{"living.ply", "next.ply"}));
    }

    void devicesAreWrittenTo()
    {
#ifdef Q_OS_WIN
        QVERIFY(hasWritten(runCommand(cloudTo("NUL")), "NUL"));
#else
        QVERIFY(hasWritten(runCommand(cloudTo("/dev/null")), "/dev/null"));
        struct stat status {};
        QVERIFY(stat("/dev/null", &status) == 0 && S_ISCHR(status.st_mode));
        if (QFile::exists("/dev/full")) {
            const Run full = runCommand(cloudTo("/dev/full"));
            QCOMPARE(full.errors, QByteArray("/dev/full: cannot be written: No space left on device\n"));
            QCOMPARE(full.exitCode, 2);
        }
#endif
    }

    void standardOutputByItsName()
    {
        if (!QFile::exists("/dev/stdout"))
            QSKIP("stdout has no name here");
        QCOMPARE(runCommand(cloudTo("/dev/stdout")).output, runCommand(cloudTo("-")).output);
        // The file behind it belongs to the process that opened it: it stays the same file, and its
        // contents stay too.
        const QStringList words{"scene", "--from-matrices", kNumbers, "-o", "/dev/stdout"};
        m_folder->write("files/out", "before\n");
        QFile reader(path("out"));
        QVERIFY(reader.open(QIODevice::ReadOnly));
        QProcess process;
        process.setStandardOutputFile(path("out"), QIODevice::Append);
        process.start(QStringLiteral(UNPROJECT_COMMAND), words);
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(reader.readAll(), "before\n" + runCommand(words).output);
    }

    void aNamedPipeIsWrittenTo()
    {
#ifdef Q_OS_WIN
        QSKIP("no named pipes among the files");
#else
        QCOMPARE(mkfifo(qPrintable(path("pipe")), 0600), 0);
        QProcess reader;
        reader.setStandardOutputFile(m_folder->path("read"));
        reader.start("cat", {path("pipe")});
        QVERIFY(reader.waitForStarted(kPatienceMilliseconds));
        QVERIFY(hasWritten(runCommand(cloudTo(path("pipe"))), path("pipe")));
        QVERIFY(reader.waitForFinished(kPatienceMilliseconds));
        QFile file(m_folder->path("read"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), runCommand(cloudTo("-")).output);
        QCOMPARE(names(), QStringList("pipe"));
#endif
    }

private:
    QString path(const QString &name) const
    {
        return QDir(m_folder->path("files")).filePath(name);
    }
    QByteArray read(const QString &name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    }
    /// The names in the folder of the output, hidden ones included.
    QStringList names() const
    {
        return QDir(path(".")).entryList(QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    QStringList cloudTo(const QString &output) const
    {
        return {"cloud", "--size", "800x600", m_scene, m_depth, "-o", output};
    }

    /// Returns whether the cloud is complete and its message is the only one.
    static bool hasWritten(const Run &cloud, const QString &output)
    {
        return cloud.exitCode == 0 && cloud.errors == output.toUtf8() + ": 480000 points of 480000 pixels\n";
    }

    std::unique_ptr<Folder> m_folder;
    QString m_scene, m_depth;
};

UNPROJECTOR_TEST(TestOutputFiles)
#include "test_output_files.moc"
