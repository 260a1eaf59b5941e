// A reader of the command's output may go away at any time, as head does: that is no error and
// causes no message.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/support/patience.h"

#ifdef Q_OS_WIN
#include <qt_windows.h>
#else
#include <unistd.h>
#endif

namespace {

/// A pipe whose reading end no child inherits: while a child had it open, the pipe would not count
/// as closed.
class Pipe {
public:
#ifdef Q_OS_WIN
    Pipe()
    {
        SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
        if (!CreatePipe(&m_read, &m_write, &inherited, 0))
            qFatal("no pipe");
        SetHandleInformation(m_read, HANDLE_FLAG_INHERIT, 0);
    }
    void takeOutputOf(QProcess &process)
    {
        process.setCreateProcessArgumentsModifier(
            [this](QProcess::CreateProcessArguments *arguments) { arguments->startupInfo->hStdOutput = m_write; });
    }
    void closeWrite()
    {
        CloseHandle(m_write);
    }
    void closeRead()
    {
        CloseHandle(m_read);
    }
    QByteArray read()
    {
        QByteArray bytes(100, '\0');
        DWORD count = 0;
        ReadFile(m_read, bytes.data(), DWORD(bytes.size()), &count, nullptr);
        return bytes.left(int(count));
    }

private:
    HANDLE m_read = nullptr, m_write = nullptr;
#else
    Pipe()
    {
        if (pipe(m_ends) != 0)
            qFatal("no pipe");
    }
    void takeOutputOf(QProcess &process)
    {
        process.setChildProcessModifier([this] {
            dup2(m_ends[1], STDOUT_FILENO);
            close(m_ends[0]);
            close(m_ends[1]);
        });
    }
    void closeWrite()
    {
        close(m_ends[1]);
    }
    void closeRead()
    {
        close(m_ends[0]);
    }
    QByteArray read()
    {
        QByteArray bytes(100, '\0');
        return bytes.left(qMax(qsizetype(0), qsizetype(::read(m_ends[0], bytes.data(), std::size_t(bytes.size())))));
    }

private:
    int m_ends[2] = {-1, -1};
#endif
};

} // namespace

class TestClosedPipe : public QObject {
    Q_OBJECT

private slots:
    void endsQuietly_data()
    {
        addColumn<QStringList>("arguments");
        addColumn<bool>("isRead");
        const QString scene = m_folder.write("scene.json", kFrustumScene);
        const QString points = m_folder.write("points.csv", "px,py,depth\n" + QByteArray("1,2,0.5\n").repeated(200000));
        const QString places = m_folder.write("places.csv", "x,y,z\n" + QByteArray("1,2,0.5\n").repeated(200000));
        const QString depth = m_folder.write("depth", QByteArray(qsizetype(800) * 600 * 4, '\0'));
        const QString matrices =
            m_folder.write("matrices.txt", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 "
                                           "-3 0 0 0 400 300");
        for (const bool isRead : {true, false}) {
            const auto row = [&](const char *name, const QStringList &arguments) {
                addRow("%s, %s", name, isRead ? "after a line" : "at once") << arguments << isRead;
            };
            row("points", {"points", scene, points});
            row("points, one thread", {"points", "--threads", "1", scene, points});
            row("points, bad rows",
                {"points", scene, m_folder.write("bad.csv", "px,py,depth\n" + QByteArray("1,2,3\n").repeated(200000))});
            row("project", {"project", scene, places});
            row("cloud", {"cloud", "--size", "800x600", scene, depth, "-o", "-"});
            row("matrices", {"matrices", scene});
            row("compare", {"compare", "--pixels", "1", scene});
            row("scene", {"scene", "--from-matrices", matrices});
        }
    }

    void endsQuietly()
    {
        QFETCH(QStringList, arguments);
        QFETCH(bool, isRead);
        Pipe pipe;
        QProcess process;
        pipe.takeOutputOf(process);
        process.start(QStringLiteral(UNPROJECT_COMMAND), arguments);
        QVERIFY(process.waitForStarted(kPatienceMilliseconds));
        pipe.closeWrite();
        if (isRead)
            QVERIFY(!pipe.read().isEmpty());
        pipe.closeRead();
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        const QByteArray errors = process.readAllStandardError();
        if (arguments.contains(m_folder.path("bad.csv"))) {
            // The command may have reported some rows before; it has ended with the results it had.
            QVERIFY(!errors.contains("written"));
            QVERIFY(process.exitCode() == 0 || process.exitCode() == 1);
            return;
        }
        QCOMPARE(errors, QByteArray());
        QCOMPARE(process.exitCode(), 0);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestClosedPipe, threads)
#include "test_closed_pipe.moc"
