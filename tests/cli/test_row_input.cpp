// Rows as programs and people write them, through the executable.

#include "tests/support/test.h"

#include "tests/cli/command.h"
#include "tests/support/patience.h"

class TestRowInput : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

    void cellsAreFound_data()
    {
        QTest::addColumn<QByteArray>("input");
        QTest::newRow("a comma in quotes before") << QByteArray("name,px,py,depth\n\"a, b\",400,300,0\n");
        QTest::newRow("quotes in quotes before") << QByteArray("name,px,py,depth\n\"a \"\", b\"\"\",400,300,0\n");
        QTest::newRow("a comma in a quoted name") << QByteArray("\"name, first\",px,py,depth\na,400,300,0\n");
        QTest::newRow("a quote in a cell") << QByteArray("size,px,py,depth\n5\",400,300,0\n");
        QTest::newRow("a line break in quotes") << QByteArray("name,px,py,depth\n\"a\n\nb,1,2\",400,300,0\n");
        QTest::newRow("a line break in quotes, CRLF") << QByteArray("name,px,py,depth\r\n\"a\r\nb\",400,300,0\r\n");
        QTest::newRow("a line break in quotes, no line end") << QByteArray("px,py,name,depth\n400,300,\"a\nb\",0");
        QTest::newRow("blank cells beyond the header") << QByteArray("px,py,depth\n400,300,0,, \n");
        QTest::newRow("fewer cells than the header, not ours") << QByteArray("px,py,depth,name,colour\n400,300,0,a\n");
        QTest::newRow("minus zero") << QByteArray("px,py,depth\n400,300,-0\n");
        QTest::newRow("hundreds of digits") << "px,py,depth\n400." + QByteArray(400, '0') + ",300,0\n";
        QTest::newRow("leading zeros") << QByteArray("px,py,depth\n000400,0300,00\n");
        QTest::newRow("smaller than any double") << QByteArray("px,py,depth\n400,300,0e-400\n");
    }

    void cellsAreFound()
    {
        QFETCH(QByteArray, input);
        const Run run = points(input);
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.output.count(",0,0,4\n"), 1); // a row can have line breaks of its own
        QVERIFY2(run.output.endsWith(",0,0,4\n"), run.output.constData());
    }

    void badCells_data()
    {
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QByteArray>("message");
        const QByteArray header("px,py,depth\n");
        const auto row = [](const char *name, const QByteArray &input, const char *message) {
            QTest::newRow(name) << input << QByteArray(message);
        };
        row("decimal commas", header + "400,5,300,5,0,5\n", "stdin:2:11: the row has 6 cells, the header 3");
        row("one cell too many", "px,py,depth,note\n400,300,0,a,b\n", "stdin:2:13: the row has 5 cells, the header 4");
        row("behind a quoted comma", "name,px,py,depth\n\"a, b\",x,300,0\n", "stdin:2:8: px: \"x\" is not a number");
        row("semicolons in a row", header + "400;300;0\n", "stdin:2:1: px: \"400;300;0\" is not a number");
        row("hexadecimal", header + "0x10,300,0\n", "stdin:2:1: px: \"0x10\" is not a number");
        row("two signs", header + "+-4,300,0\n", "stdin:2:1: px: \"+-4\" is not a number");
        row("thousands", header + "1'000,300,0\n", "stdin:2:1: px: \"1'000\" is not a number");
        row("depth in per cent", header + "400,300,50%\n", "stdin:2:9: depth: \"50%\" is not a number");
        row("just outside", header + "400,300,1.0000000000000002\n",
            "stdin:2:9: depth: 1.0000000000000002 lies outside the depth range 0 to 1");
        row("a quote that is not closed", "px,py,depth,name\n400,300,0,\"a\n",
            "stdin:2:11: the quote is not closed; quotes in quotes are doubled");
        row("a quote that is not closed, no line end", "px,py,depth,name\n400,300,0,\"a",
            "stdin:2:11: the quote is not closed; quotes in quotes are doubled");
        row("text behind a closed quote", "px,py,depth,name\n400,300,0,\"a\"b\n",
            "stdin:2:11: the quote is not closed; quotes in quotes are doubled");
        row("behind a line break in quotes", "name,px,py,depth\n\"a\n\nb\",1,2,0\na,x,2,0\n",
            "stdin:5:3: px: \"x\" is not a number");
        row("a zero byte", header + QByteArray("4\0,300,0\n", 9), "stdin:2:1: px: \"4\\x00\" is not a number");
        row("beyond any double", header + "-1e999,300,0\n",
            "stdin:2:1: px: \"-1e999\" is beyond the range of double precision");
        row("the header once more", header + "px,py,depth\n", "stdin:2:1: px: \"px\" is not a number");
    }

    void badCells()
    {
        QFETCH(QByteArray, input);
        QFETCH(QByteArray, message);
        const Run run = points(input);
        QCOMPARE(run.errors, message + '\n');
        QCOMPARE(run.exitCode, 1);
        QVERIFY(run.lines().last().endsWith(",,,"));
    }

    void unusableHeaders_data()
    {
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QByteArray>("message");
        const QByteArray noColumn("stdin:1:1: the header has no column px; the first line must be px,py,depth");
        QTest::newRow("nothing") << QByteArray() << QByteArray("stdin: is empty; its first line must be px,py,depth");
        QTest::newRow("byte order mark alone")
            << QByteArray("\xEF\xBB\xBF") << QByteArray("stdin: is empty; its first line must be px,py,depth");
        QTest::newRow("an empty line") << QByteArray("\npx,py,depth\n1,2,0\n") << noColumn;
        QTest::newRow("no header") << QByteArray("1,2,0\n") << noColumn;
        QTest::newRow("semicolons") << QByteArray("px;py;depth\n1;2;0\n")
                                    << noColumn + "; columns are separated by commas here, not by semicolons";
        QTest::newRow("tabs") << QByteArray("px\tpy\tdepth\n1\t2\t0\n")
                              << noColumn + "; columns are separated by commas here, not by tabs";
        QTest::newRow("capitals") << QByteArray("PX,PY,Depth\n1,2,0\n")
                                  << noColumn + "; \"PX\" is written in small letters";
        QTest::newRow("line ends of old Macs")
            << QByteArray("px,py,depth\r1,2,0\r")
            << QByteArray("stdin:1: the lines end with CR alone, as on old Macs; save the file with LF or CRLF");
        QTest::newRow("a line break in a name")
            << QByteArray("px,py,depth,\"a\nname\"\n1,2,0\n")
            << QByteArray("stdin:1:13: the quote is not closed; the names of the columns must be on one line");
        QTest::newRow("UTF-16") << QByteArray("\xFF\xFEp\0x\0,\0p\0y\0", 12)
                                << noColumn + "; the file is UTF-16, save it as UTF-8";
        QTest::newRow("a column twice") << QByteArray("px,py,depth, py\n1,2,0,2\n")
                                        << QByteArray("stdin:1:14: the header names the column py twice");
        QTest::newRow("without an end") << QByteArray(
            300000, 'x') << QByteArray("stdin:1: the line is longer than 131072 bytes; it must be px,py,depth");
    }

    void unusableHeaders()
    {
        QFETCH(QByteArray, input);
        QFETCH(QByteArray, message);
        const Run run = points(input);
        QCOMPARE(run.errors, message + '\n');
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
    }

    void projectNamesItsColumns()
    {
        const Run run = runCommand({"project", m_scene}, "px,py,depth\n1,2,0\n");
        QCOMPARE(run.errors, QByteArray("stdin:1:1: the header has no column x; the first line must be x,y,z or "
                                        "formula_x,formula_y,formula_z\n"));
        QCOMPARE(run.exitCode, 2);
    }

    /// There are so many rows that a search from the start of the block for each would take minutes.
    void everyRowBad()
    {
        constexpr int kRows = 1000000;
        const Run run = points("px,py,depth\n" + QByteArray("a,b,c\n").repeated(kRows));
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), kRows + 1);
        QCOMPARE(run.errors.count('\n'), kRows);
        QVERIFY(run.errors.endsWith("stdin:1000001:1: px: \"a\" is not a number\n"));
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

    void rowsOnly_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("output");
        QTest::newRow("CSV") << QStringList{} << QByteArray("400,300,0,0,0,4\n");
        QTest::newRow("JSON")
            << QStringList{"--format", "jsonl"}
            << QByteArray("{\"px\":400,\"py\":300,\"depth\":0,\"formula_x\":0,\"formula_y\":0,\"formula_z\":4}\n");
    }

    void rowsOnly()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, output);
        const Run run = points("px,py,depth\n400,300,0\n", QStringList{"--no-header"} + options);
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.output, output);
    }

    void namesBeyondAscii()
    {
        const QString scene = m_folder.write(QString::fromUtf8("面 Szene.json"),
                                             QByteArray(kFrustumScene).replace("face", "Gesicht ü面"));
        const QString rows = m_folder.write(QString::fromUtf8("points ü.csv"), "px,py,depth\n800,600,1\nx,2,0\n");
        const Run run = runCommand({"points", "--space", QString::fromUtf8("object:Gesicht ü面"), scene, rows});
        QCOMPARE(run.errors, rows.toUtf8() + ":3:1: px: \"x\" is not a number\n");
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.lines().at(1).startsWith("800,600,1,2,-1.5,-1,"), run.output.constData());

        const Run none = runCommand({"points", "--space", QString::fromUtf8("object:鼻"), scene, rows});
        QCOMPARE(none.errors, QByteArray("the scene has no object \"鼻\"; it has: Gesicht ü面\n"));
        const QString missing = m_folder.path(QString::fromUtf8("没有.csv"));
        QVERIFY(runCommand({"points", scene, missing}).errors.startsWith(missing.toUtf8() + ": cannot be read"));

        const QString made = m_folder.path(QString::fromUtf8("gemacht é.json"));
        QCOMPARE(
            runCommand({"scene", "--from-matrices",
                        "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0 0 0 40 30", "-o", made})
                .exitCode,
            0);
        QVERIFY(QFile::exists(made));
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
