// The progress bar: its output to a terminal of the test's own, by a clock of the test's own; and
// that the command has one.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/support/patience.h"

#include "core/cli/terminal/progress_bar.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QProcessEnvironment>
#include <QStandardPaths>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

using namespace unprojector;
using namespace unprojector::cli;
using namespace std::chrono_literals;

namespace {

/// The text that a person sees on the terminal: carriage returns overwrite.
struct Terminal {
    std::string line; ///< that the cursor stands in, blanks at its end left out
    std::vector<std::string> above;
    std::size_t cursor = 0, widest = 0, writes = 0;
    ProgressScreen::Time time{};

    void write(std::string_view text)
    {
        ++writes;
        for (const char c : text) {
            if (c == '\r') {
                cursor = 0;
            } else if (c == '\n') {
                above.push_back(trimmed());
                line.clear();
                cursor = 0;
            } else {
                line.resize(std::max(line.size(), cursor + 1), ' ');
                line[cursor++] = c;
                widest = std::max(widest, cursor);
            }
        }
    }
    std::string trimmed() const { return line.substr(0, line.find_last_not_of(' ') + 1); }
    ProgressScreen screen(std::size_t columns = 80)
    {
        return {columns, [this](std::string_view text) { write(text); }, [this] { return time; }};
    }
};

/// `unproject points` on a terminal that script(1) makes. It gets endless rows until it is asked to
/// finish, then one bad row. The rows also end with the test, however that ends: nothing else would
/// stop the command.
class OnTerminal {
public:
    OnTerminal(const QString &redirection, const Folder &folder) : m_stop(folder.path("stop"))
    {
#ifdef Q_OS_LINUX
        const QString script = QStandardPaths::findExecutable("script");
        m_isPossible = !script.isEmpty();
        if (!m_isPossible)
            return;
        QFile::remove(m_stop);
        const QString scene = folder.write("scene.json", kFrustumScene);
        const QString rows = folder.write("rows", QByteArray("1,2,0.5\n").repeated(1000));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("TERM", "xterm");
        m_process.setProcessEnvironment(environment);
        const QString isWanted = "[ ! -e '" + m_stop + "' ] && kill -0 "
                                 + QString::number(QCoreApplication::applicationPid()) + " 2>/dev/null";
        const QString feed = "(echo px,py,depth; while " + isWanted + "; do cat '" + rows + "'; done; echo a,b,c)";
        m_process.start(script, {"-qefc", feed + " | '" UNPROJECT_COMMAND "' points '" + scene + "' - " + redirection,
                                 "/dev/null"});
#else
        Q_UNUSED(redirection)
#endif
    }

    /// A test that failed in the middle leaves the command running.
    ~OnTerminal()
    {
        if (m_process.state() != QProcess::NotRunning)
            finished();
    }
    OnTerminal(const OnTerminal &) = delete;
    OnTerminal &operator=(const OnTerminal &) = delete;

    bool isPossible() const
    {
        return m_isPossible;
    }

    bool readUntil(const std::function<bool(const QByteArray &)> &isSeen)
    {
        while (!isSeen(m_text)) {
            if (!m_process.waitForReadyRead(kPatienceMilliseconds))
                return false;
            m_text += m_process.readAllStandardOutput();
        }
        return true;
    }

    /// All that was on the terminal.
    QByteArray finished()
    {
        QFile(m_stop).open(QIODevice::WriteOnly);
        m_process.waitForFinished(kPatienceMilliseconds);
        return m_text + m_process.readAllStandardOutput();
    }

private:
    QString m_stop;
    QProcess m_process;
    QByteArray m_text;
    bool m_isPossible = false;
};

} // namespace

class TestProgressBar : public QObject {
    Q_OBJECT

private slots:
    void appearsAfterASecond()
    {
        Terminal terminal;
        ProgressBar bar(1000, ProgressBar::Unit::Points, terminal.screen());
        terminal.time += 999ms;
        bar.advance(500);
        QCOMPARE(terminal.writes, std::size_t(0));
        terminal.time += 1ms;
        bar.advance(0);
        QCOMPARE(terminal.writes, std::size_t(1));
        QVERIFY(terminal.trimmed().starts_with(" 50% ["));
    }

    void isDrawnTenTimesASecondAtMost()
    {
        Terminal terminal;
        ProgressBar bar(std::nullopt, ProgressBar::Unit::Bytes, terminal.screen());
        for (int i = 0; i < 5000; ++i) {
            terminal.time += 1ms;
            bar.advance(1);
        }
        QCOMPARE(terminal.writes, std::size_t(41)); // from 1 s to 5 s, both inside
    }

    void saysHowFarTheWorkIs_data()
    {
        addColumn<qulonglong>("total");
        addColumn<bool>("isBytes");
        addColumn<qulonglong>("done");
        addColumn<int>("seconds");
        addColumn<QByteArray>("text");
        const auto row = [](const char *name, qulonglong total, bool isBytes, qulonglong done, int seconds,
                            const char *text) {
            newRow(name) << total << isBytes << done << seconds << QByteArray(text);
        };
        row("bytes of a file", 1000000000, true, 420000000, 42,
            " 42% [================>                       ] 420 MB of 1.0 GB, 0:58 left");
        row("points", 17408, false, 4352, 3,
            " 25% [==========>                             ] 4352 of 17408, 0:09 left");
        row("nothing yet", 100, false, 0, 5, "  0% [>                                       ] 0 of 100");
        row("all", 100, false, 100, 5, "100% [========================================] 100 of 100, 0:00 left");
        row("hours", 1000000, false, 1, 2,
            "  0% [>                                       ] 1 of 1000000, 99:59:59 left");
        row("a file that grows", 100, true, 150, 5,
            "100% [========================================] 150 B of 100 B, 0:00 left");
        row("a pipe", 0, true, 420000000, 12, "420 MB, 35 MB/s");
        row("a slow pipe", 0, true, 1500, 1000, "1.5 kB, 2 B/s");
    }

    void saysHowFarTheWorkIs()
    {
        QFETCH(qulonglong, total);
        QFETCH(bool, isBytes);
        QFETCH(qulonglong, done);
        QFETCH(int, seconds);
        QFETCH(QByteArray, text);
        Terminal terminal;
        ProgressBar bar(total == 0 ? std::nullopt : std::optional<std::uint64_t>(total),
                        isBytes ? ProgressBar::Unit::Bytes : ProgressBar::Unit::Points, terminal.screen(120));
        terminal.time += std::chrono::seconds(seconds);
        bar.advance(done);
        QCOMPARE(QByteArray::fromStdString(terminal.trimmed()), text);
    }

    void fitsEveryTerminal()
    {
        for (std::size_t columns = 0; columns <= 200; ++columns) {
            for (const auto total : {std::optional<std::uint64_t>(), std::optional<std::uint64_t>(999999999999999)}) {
                Terminal terminal;
                ProgressBar bar(total, ProgressBar::Unit::Points, terminal.screen(columns));
                terminal.time += 2s;
                bar.advance(123456789);
                QVERIFY(terminal.widest <= (columns == 0 ? 0 : columns - 1));
                QVERIFY(terminal.above.empty());
            }
        }
    }

    void leavesNothingBehind()
    {
        Terminal terminal;
        {
            ProgressBar bar(std::nullopt, ProgressBar::Unit::Bytes, terminal.screen());
            terminal.time += 1s;
            bar.advance(123456);
            QCOMPARE(QByteArray::fromStdString(terminal.trimmed()), QByteArray("123 kB, 123 kB/s"));
            terminal.time += 9999s;
            bar.advance(0);
            QCOMPARE(QByteArray::fromStdString(terminal.trimmed()),
                     QByteArray("123 kB, 12 B/s")); // shorter than before
        }
        QCOMPARE(terminal.trimmed(), std::string());
        QCOMPARE(terminal.cursor, std::size_t(0));
        QVERIFY(terminal.above.empty());
    }

    void makesWayForMessages()
    {
        Terminal terminal;
        ProgressBar bar(1000, ProgressBar::Unit::Bytes, terminal.screen());
        terminal.time += 1s;
        bar.advance(10);
        QVERIFY(!terminal.trimmed().empty());
        withoutProgressBar([&] { terminal.write("a message\n"); });
        QCOMPARE(terminal.above, std::vector<std::string>{"a message"});
        QCOMPARE(terminal.trimmed(), std::string());
        terminal.time += 1s;
        bar.advance(10);
        QVERIFY(terminal.trimmed().starts_with("  2% ["));
        bar.finish();
        bar.advance(10);
        QCOMPARE(terminal.trimmed(), std::string());
        withoutProgressBar([&] { terminal.write("another\n"); });
        QCOMPARE(terminal.above.size(), std::size_t(2));
    }

    void withoutATerminalNothingIsWritten()
    {
        // Its functions are empty: to call one would throw.
        ProgressBar bar(1000, ProgressBar::Unit::Bytes, ProgressScreen{});
        bar.advance(1000);
        bool isWritten = false;
        withoutProgressBar([&] { isWritten = true; });
        QVERIFY(isWritten);
    }

    void everyThreadMayAdvance()
    {
        Terminal terminal;
        terminal.time += 0s;
        ProgressBar bar(40000, ProgressBar::Unit::Points, terminal.screen());
        std::array<std::thread, 4> threads;
        for (std::thread &thread : threads) {
            thread = std::thread([&bar] {
                for (int i = 0; i < 10000; ++i)
                    bar.advance(1);
            });
        }
        for (std::thread &thread : threads)
            thread.join();
        terminal.time += 1s;
        bar.advance(0);
        QVERIFY(QByteArray::fromStdString(terminal.trimmed()).contains("40000 of 40000"));
    }

    void theCommandHasOneOnATerminal()
    {
        OnTerminal command("> '" + m_folder.path("results") + '\'', m_folder);
        if (!command.isPossible())
            QSKIP("needs script(1) of util-linux");
        // The command is fed until its bar is seen, however long that takes.
        QVERIFY(command.readUntil([](const QByteArray &text) { return text.contains("B/s"); }));
        const QByteArray text = command.finished();
        Terminal terminal;
        terminal.write(std::string_view(text.constData(), std::size_t(text.size())));
        QCOMPARE(terminal.above.size(), std::size_t(1)); // the message on the last row, and nothing else
        QVERIFY(terminal.above[0].starts_with("stdin:") && terminal.above[0].ends_with(": px: \"a\" is not a number"));
        QCOMPARE(terminal.trimmed(), std::string());
    }

    void noBarStandsAmongRows()
    {
        OnTerminal command({}, m_folder);
        if (!command.isPossible())
            QSKIP("needs script(1) of util-linux");
        QElapsedTimer timer;
        timer.start();
        // A bar would appear after a second.
        QVERIFY(command.readUntil([&](const QByteArray &) { return timer.elapsed() > 1500; }));
        const QByteArray text = command.finished();
        QVERIFY(text.contains("\r\n1,2,0.5,"));
        QVERIFY(!text.contains("B/s"));
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestProgressBar, threads)
#include "test_progress_bar.moc"
