// The pipeline that takes blocks of lines through workers on several threads, where a worker fails.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/support/patience.h"

#include "core/cli/rows/block_pipeline.h"

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <thread>

using namespace unprojector::cli;

class TestBlockPipeline : public QObject {
    Q_OBJECT

private slots:
    void whatAWorkerThrowsEndsAll_data()
    {
        addColumn<unsigned>("threads");
        addColumn<int>("failing");
        for (const unsigned threads : {1u, 2u, 8u}) {
            addRow("%u threads, the first block", threads) << threads << 0;
            addRow("%u threads, in the middle", threads) << threads << 20;
        }
    }

    void whatAWorkerThrowsEndsAll()
    {
        QFETCH(unsigned, threads);
        QFETCH(int, failing);
        const QByteArray block = QByteArray("0123456789\n").repeated(LineBlocks::kMostBytes / 11);
        const QString rows = m_folder.write("rows", block.repeated(40)), output = m_folder.write("output", "before");
        ByteSource source(rows.toStdString());
        LineBlocks blocks(source);
        ByteSink sink(output.toStdString(), {});
        std::atomic<int> begun = 0, living = 0;
        const auto makeWorker = [&]() -> BlockWorker {
            return [&](const LineBlock &lines, BlockResult &result) {
                ++living;
                if (begun++ == failing) {
                    // The other workers have finished by then and wait for this block to be written
                    // before theirs.
                    std::this_thread::sleep_for(std::chrono::milliseconds(20));
                    --living;
                    throw std::bad_alloc();
                }
                result.output = lines.text;
                --living;
            };
        };
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, runBlocks(blocks, source, sink, threads, makeWorker));
        QCOMPARE(living.load(), 0);
        QVERIFY(begun
                <= failing + 2 * int(threads)); // the blocks before it are written, and no worker goes on for long
        QFile file(output);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("before")); // half of the rows is no result
    }

    void aWorkerThatCannotBeMade()
    {
        ByteSource source(m_folder.write("rows", "1\n2\n").toStdString());
        LineBlocks blocks(source);
        ByteSink sink(m_folder.path("output").toStdString(), {});
        const auto none = []() -> BlockWorker { throw std::runtime_error("none"); };
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, runBlocks(blocks, source, sink, 4, none));
    }

    /// The command itself, with less memory than its threads want.
    void outOfMemoryIsAMessage()
    {
#if !defined(Q_OS_LINUX)
        QSKIP("no limit to the memory here");
#elif defined(UNPROJECTOR_IS_SANITIZED)
        QSKIP("the sanitizers take more than any limit");
#else
        const QString scene = m_folder.write("scene.json", kFrustumScene);
        const QString rows = m_folder.write("rows.csv", "px,py,depth\n" + QByteArray("1,2,0.5\n").repeated(100000));
        int complaints = 0;
        for (int kilobytes = 10000; kilobytes < 60000; kilobytes += 5000) {
            QProcess shell;
            shell.setStandardOutputFile("/dev/null");
            shell.start("sh",
                        {"-c", "ulimit -v " + QString::number(kilobytes) + "; exec '" UNPROJECT_COMMAND "' points '"
                                   + scene + "' '" + rows + "' --threads 8"});
            QVERIFY(shell.waitForFinished(kPatienceMilliseconds));
            const QByteArray errors = shell.readAllStandardError();
            if (shell.exitCode() == 127)
                continue; // not even the program's libraries found room
            QCOMPARE(shell.exitStatus(), QProcess::NormalExit);
            if (shell.exitCode() != 0) {
                QCOMPARE(errors, QByteArray("unproject: out of memory; the results are not complete\n"));
                QCOMPARE(shell.exitCode(), 2);
                ++complaints;
            }
        }
        if (complaints == 0)
            QSKIP("the limit is none here");
#endif
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestBlockPipeline, threads)
#include "test_block_pipeline.moc"
