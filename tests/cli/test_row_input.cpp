// Rows as programs and people write them, through the executable.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/support/patience.h"

class TestRowInput : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

    void aHeaderWithoutAnEnd()
    {
        const Run run = points(QByteArray(300000, 'x'));
        QCOMPARE(run.errors, QByteArray("stdin:1: the line is longer than 131072 bytes; it must be px,py,depth\n"));
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
    }

    /// There are so many rows that a search from the start of the block for each would take minutes.
    void everyRowBad()
    {
        constexpr int kRows = tests::rounds(1000000);
        const Run run = points("px,py,depth\n" + QByteArray("a,b,c\n").repeated(kRows));
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), kRows + 1);
        QCOMPARE(run.errors.count('\n'), kRows);
        QVERIFY(run.errors.endsWith("stdin:" + QByteArray::number(kRows + 1) + ":1: px: \"a\" is not a number\n"));
    }

    /// A program that asks row by row gets each answer at once, before any buffer is full.
    void aRowIsAnsweredAtOnce()
    {
        QProcess process;
        process.start(QStringLiteral(UNPROJECT_COMMAND), {"points", "--method", "formula", m_scene});
        QVERIFY(process.waitForStarted(kPatienceMilliseconds));
        process.write("px,py,depth\n");
        QByteArray output;
        for (const QByteArray &row : {QByteArray("400,300,0\n"), QByteArray("400,300,1\n")}) {
            process.write(row);
            const QByteArray answer = row.chopped(1) + (row.contains(",0\n") ? ",0,0,4\n" : ",0,0,1\n");
            while (!output.endsWith(answer)) {
                QVERIFY2(process.waitForReadyRead(kPatienceMilliseconds), output.constData());
                output += process.readAllStandardOutput();
            }
        }
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.exitCode(), 0);
    }

    void aPipeInPieces()
    {
        const QByteArray input("\xEF\xBB\xBFpx,py,depth\r\n400,300,0\r\n400,300,1\r\n\"400\",\"300\",1");
        QProcess process;
        process.start(QStringLiteral(UNPROJECT_COMMAND), {"points", "--method", "formula", m_scene});
        QVERIFY(process.waitForStarted(kPatienceMilliseconds));
        for (const char byte : input) {
            process.write(&byte, 1);
            QVERIFY(process.waitForBytesWritten(kPatienceMilliseconds));
        }
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(process.readAllStandardError(), QByteArray());
        QCOMPARE(process.readAllStandardOutput(), points(input).output);
        QCOMPARE(points(input).lines().size(), 4);
    }

    /// No following row is lost, and no part of it passes for the cell.
    void linesBehindAnOpenQuoteAreRows()
    {
        // The rows are longer than one read, so that the end of the file is out of sight.
        constexpr int kRows = 20000;
        const Run run = points("px,py,depth,name\n1,2,0,\"a\n" + QByteArray("400,300,0,b\n").repeated(kRows));
        QCOMPARE(run.errors, QByteArray("stdin:2:7: the quote is not closed; quotes in quotes are doubled\n"));
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), kRows + 2);
        QCOMPARE(run.lines().at(1), QByteArray("1,2,0,\"\"\"a\",,,"));
        QCOMPARE(run.lines().last(), QByteArray("400,300,0,b,0,0,4"));
    }

private:
    Run points(const QByteArray &input, const QStringList &options = {}) const
    {
        return runCommand(QStringList{"points", "--method", "formula"} + options + QStringList{m_scene, "-"}, input);
    }

    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestRowInput, threads)
#include "test_row_input.moc"
