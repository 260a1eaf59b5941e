// `unproject points` with ten million rows, made while they stream and checked as they come back.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/cli/peak_memory.h"
#include "tests/support/patience.h"

#include <QEventLoop>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string_view>

namespace {

constexpr int kRows = tests::rounds(10000000);

/// A box 1024 x 512 seen from the origin, a unit a pixel: all results are whole numbers.
const QByteArray kScene = R"({"unprojector": 1, "window": {"width": 1024, "height": 512},
  "projection": {"type": "ortho", "left": 0, "right": 1024, "bottom": 0, "top": 512, "near": 1, "far": 9},
  "view": {"eye": [0, 0, 0], "center": [0, 0, -1], "up": [0, 1, 0]}})";

/// A line put together in place: ten million of them are made here twice.
class Line {
public:
    /// Writes the number with the fewest digits that read back: 100000 is 1e+05.
    Line &operator<<(double number)
    {
        m_end = std::to_chars(m_end, m_text.data() + m_text.size(), number).ptr;
        return *this;
    }
    Line &operator<<(std::string_view text)
    {
        m_end = std::copy(text.begin(), text.end(), m_end);
        return *this;
    }
    void appendTo(QByteArray &text) const { text.append(m_text.data(), m_end - m_text.data()); }

private:
    std::array<char, 128> m_text;
    char *m_end = m_text.data();
};

void appendRow(QByteArray &text, int number)
{
    (Line() << number << ",500,0.5\n").appendTo(text);
}

void appendResult(QByteArray &text, int number)
{
    (Line() << number << ",500,0.5," << number << ",12,-5\n").appendTo(text);
}

} // namespace

class TestLongStreams : public QObject {
    Q_OBJECT

private slots:
    void tenMillionRowsKeepTheirOrderInLittleMemory()
    {
        Folder folder;
        QProcess process;
        process.start(QStringLiteral(UNPROJECT_COMMAND),
                      {"points", "--method", "formula", folder.write("scene.json", kScene)});
        QVERIFY(process.waitForStarted(kPatienceMilliseconds));

        QByteArray expected("px,py,depth,formula_x,formula_y,formula_z\n");
        int written = 0, awaited = 0;
        bool isSame = true, isClosed = false;
        qint64 peak = 0;

        QEventLoop loop;
        const auto write = [&] {
            constexpr int kLinesAtATime = 4096;
            constexpr qint64 kMostUnwritten = 1 << 17;
            while (written < kRows && process.bytesToWrite() < kMostUnwritten) {
                QByteArray text;
                for (int i = 0; i < kLinesAtATime && written < kRows; ++i)
                    appendRow(text, written++);
                process.write(text);
            }
        };
        const auto check = [&] {
            const QByteArray output = process.readAllStandardOutput();
            for (qsizetype checked = 0; isSame && checked < output.size();) {
                if (expected.isEmpty()) {
                    for (int i = 0; i < 4096 && awaited < kRows; ++i)
                        appendResult(expected, awaited++);
                    if (expected.isEmpty())
                        isSame = false; // more came than was asked for
                }
                const qsizetype length = std::min(expected.size(), output.size() - checked);
                isSame =
                    isSame && std::memcmp(expected.constData(), output.constData() + checked, std::size_t(length)) == 0;
                expected.remove(0, length);
                checked += length;
            }
            // The rows are through and the command waits for more: its peak memory is known now.
            const bool isThrough = awaited == kRows && expected.isEmpty();
            if ((isThrough || !isSame) && !isClosed) {
                isClosed = true;
                peak = peakMemory(process.processId());
                process.closeWriteChannel();
            }
        };
        connect(&process, &QProcess::bytesWritten, &loop, write);
        connect(&process, &QProcess::readyReadStandardOutput, &loop, check);
        connect(&process, &QProcess::finished, &loop, &QEventLoop::quit);
        process.write("px,py,depth\n");
        write();
        loop.exec();

        QVERIFY2(isSame, "a row is not what it should be");
        QCOMPARE(awaited, kRows);
        QVERIFY(expected.isEmpty());
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(process.readAllStandardError(), QByteArray()); // and no progress bar in a pipe
        if (peak == 0)
            QSKIP("the rows are right; how much memory they took is not known here");
#ifdef UNPROJECTOR_IS_SANITIZED
        constexpr qint64 kMost = 128LL * 1024; // the sanitizer's own memory counts, more with huge pages
#else
        constexpr qint64 kMost = 64LL * 1024;
#endif
        QVERIFY2(peak < kMost, QByteArray::number(peak) + " KiB");
        qInfo("%lld KiB at most", static_cast<long long>(peak));
    }
};

UNPROJECTOR_TEST(TestLongStreams, threads)
#include "test_long_streams.moc"
