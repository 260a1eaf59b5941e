// Columns that a command does not know, and commands that take each other's rows, through the
// executable.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QJsonDocument>
#include <QJsonObject>

class TestPassedColumns : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

    void otherColumnsStayWhereTheyStood_data()
    {
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QByteArray>("output");
        const auto row = [](const char *name, const char *input, const char *output) {
            QTest::newRow(name) << QByteArray(input) << QByteArray(output);
        };
        row("before", "name,px,py,depth\na,400,300,0\n",
            "name,px,py,depth,formula_x,formula_y,formula_z\na,400,300,0,0,0,4\n");
        row("behind", "px,py,depth,note\n400,300,0,a wall\n",
            "px,py,depth,note,formula_x,formula_y,formula_z\n400,300,0,a wall,0,0,4\n");
        row("between", "px,a,py,b,depth\n400,1.50,300,007,0\n",
            "px,a,py,b,depth,formula_x,formula_y,formula_z\n400,1.50,300,007,0,0,0,4\n");
        row("another order", "depth,px,py\n0,400,300\n",
            "depth,px,py,formula_x,formula_y,formula_z\n0,400,300,0,0,4\n");
        row("quoted, with a comma", "\"name, first\",px,py,depth\n\"a, b\",400,300,0\n",
            "\"name, first\",px,py,depth,formula_x,formula_y,formula_z\n\"a, b\",400,300,0,0,0,4\n");
        row("quotes in quotes", "px,py,depth,name\n400,300,0,\"a \"\"b\"\"\"\n",
            "px,py,depth,name,formula_x,formula_y,formula_z\n400,300,0,\"a \"\"b\"\"\",0,0,4\n");
        row("a line break in quotes", "px,py,depth,name\n400,300,0,\"a\nb, \"\"c\"\"\"\n",
            "px,py,depth,name,formula_x,formula_y,formula_z\n400,300,0,\"a\nb, \"\"c\"\"\",0,0,4\n");
        row("blanks", "px,py,depth, name \n 400 ,300,0,  a b \n",
            "px,py,depth, name ,formula_x,formula_y,formula_z\n400,300,0,  a b ,0,0,4\n");
        row("CRLF", "px,py,depth,name\r\n400,300,0,a\r\n",
            "px,py,depth,name,formula_x,formula_y,formula_z\n400,300,0,a,0,0,4\n");
        row("empty", "px,py,depth,name\n400,300,0,\n",
            "px,py,depth,name,formula_x,formula_y,formula_z\n400,300,0,,0,0,4\n");
        row("fewer cells than the header", "px,py,depth,name,colour\n400,300,0,a\n",
            "px,py,depth,name,colour,formula_x,formula_y,formula_z\n400,300,0,a,,0,0,4\n");
        row("without a name", "px,py,depth,\n400,300,0,a\n",
            "px,py,depth,,formula_x,formula_y,formula_z\n400,300,0,a,0,0,4\n");
        row("two of one name", "n,n,px,py,depth\n1,2,400,300,0\n",
            "n,n,px,py,depth,formula_x,formula_y,formula_z\n1,2,400,300,0,0,0,4\n");
        row("beyond ASCII", "名,px,py,depth\nGr\xC3\xBCn,400,300,0\n",
            "名,px,py,depth,formula_x,formula_y,formula_z\nGr\xC3\xBCn,400,300,0,0,0,4\n");
    }

    void otherColumnsStayWhereTheyStood()
    {
        QFETCH(QByteArray, input);
        QFETCH(QByteArray, output);
        const Run run = points(input);
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.output, output);
    }

    void resultsAreWhatTheyAreWithoutThem()
    {
        const QList<QByteArray> numbers{"0.1,599.9000000000001,0.30000000000000004", "400.5,17.25,0.99"};
        QByteArray plain("px,py,depth\n"), named("px,py,depth,name\n");
        for (const QByteArray &row : numbers) {
            plain += row + '\n';
            named += row + ",a\n";
        }
        for (const char *method : {"both", "all"}) {
            const Run one = runCommand({"points", "--method", method, m_scene, "-"}, plain),
                      other = runCommand({"points", "--method", method, m_scene, "-"}, named);
            for (qsizetype i = 0; i < numbers.size(); ++i)
                QCOMPARE(QByteArray(other.lines().at(i + 1)).replace(numbers[i] + ",a", numbers[i]),
                         one.lines().at(i + 1));
        }
    }

    void badRowsKeepTheirColumns()
    {
        const Run run = points("id,px,py,depth,name\n7,400,300,2,\"a, b\"\n8,x,300,0,c\n9,400\n");
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().mid(1), (QList<QByteArray>{"7,400,300,2,\"a, b\",,,", "8,x,300,0,c,,,", "9,400,,,,,,"}));
        const Run inPlane = project("x,y,z,name\n1,2,5,\"in the plane, of the eye\"\n");
        QCOMPARE(inPlane.exitCode, 1);
        QVERIFY(inPlane.lines().at(1).startsWith("1,2,5,\"in the plane, of the eye\",1,2,0,"));
        // A line that is too long is dropped as a whole.
        const Run overlong = points("name,px,py,depth\n" + QByteArray(200000, 'a') + ",400,300,0\nb,400,300,0\n");
        QCOMPARE(overlong.lines().mid(1), (QList<QByteArray>{",,,,,,", "b,400,300,0,0,0,4"}));
    }

    void badRowsKeepTheirCells_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QByteArray>("json"); // of its three cells
        QTest::newRow("a word") << QByteArray("ab,300,0") << QByteArray("null,300,0");
        QTest::newRow("a word in quotes") << QByteArray("\"ab\",300,0") << QByteArray("null,300,0");
        QTest::newRow("quotes in quotes, a comma") << QByteArray("\"a\"\"b, c\",300,0") << QByteArray("null,300,0");
        QTest::newRow("a line break in quotes") << QByteArray("\"a\nb\",300,0") << QByteArray("null,300,0");
        QTest::newRow("quotes in a word") << QByteArray("a\"b,300,0") << QByteArray("null,300,0");
        QTest::newRow("the others in quotes") << QByteArray("ab,\"300\",\" 0 \"") << QByteArray("null,300,0");
        QTest::newRow("blanks") << QByteArray(" ab , 300,0 ") << QByteArray("null,300,0");
        QTest::newRow("all digits, a depth outside the range")
            << QByteArray("400.50,3e2,2.00") << QByteArray("400.50,3e2,2.00");
        QTest::newRow("nothing") << QByteArray(",300,0") << QByteArray("null,300,0");
    }

    void badRowsKeepTheirCells()
    {
        QFETCH(QByteArray, row);
        QFETCH(QByteArray, json);
        for (const QByteArray &name : {QByteArray(), QByteArray(",name")}) {
            const QByteArray cell = name.isEmpty() ? "" : ",\"a, b\"";
            const Run run = points("px,py,depth" + name + '\n' + row + cell + '\n');
            QCOMPARE(run.exitCode, 1);
            QCOMPARE(run.output.mid(run.output.indexOf('\n') + 1), row + cell + ",,,\n");
        }
        if (!row.contains("2.00")) {
            const Run projected = project("x,y,z\n" + row + '\n');
            QCOMPARE(projected.exitCode, 1);
            QVERIFY2(projected.output.contains('\n' + row + ",,"), projected.output.constData());
        }
        const Run lines = points("px,py,depth\n" + row + '\n', {"--format", "jsonl"});
        const QJsonArray cells = QJsonDocument::fromJson('[' + json + ']').array();
        const QJsonObject line = QJsonDocument::fromJson(lines.output).object();
        QCOMPARE((QJsonArray{line["px"], line["py"], line["depth"]}), cells);
    }

    void asJson_data()
    {
        QTest::addColumn<QByteArray>("cell");
        QTest::addColumn<QByteArray>("json");
        const auto row = [](const char *name, const char *cell, const char *json) {
            QTest::newRow(name) << QByteArray(cell) << QByteArray(json);
        };
        row("text", "a wall", "\"a wall\"");
        row("a number, with all its digits", "0.1000", "0.1000");
        row("a large number", "12345678901234567890123", "12345678901234567890123");
        row("an exponent", "-1.5e+300", "-1.5e+300");
        row("leading zeros are text", "007", "\"007\"");
        row("a plus is text", "+7", "\"+7\"");
        row("a point alone is text", "1.", "\"1.\"");
        row("a minus is text", "-", "\"-\"");
        row("NaN is text", "nan", "\"nan\"");
        row("empty", "", "null");
        row("a quoted number is text", "\"7\"", "\"7\"");
        row("quotes in quotes", "\"a \"\"b\"\", c\"", "\"a \\\"b\\\", c\"");
        row("a line break", "\"a\nb\"", R"("a\nb")");
        row("a backslash", "a\\b", R"("a\\b")");
        row("a tab", "\"a\tb\"", R"("a\tb")");
        row("beyond ASCII", "Gr\xC3\xBCn", "\"Gr\xC3\xBCn\"");
        row("no UTF-8", "Gr\xFCn", "\"Gr\xEF\xBF\xBDn\"");
    }

    void asJson()
    {
        QFETCH(QByteArray, cell);
        QFETCH(QByteArray, json);
        const Run run = points("px,py,depth,\"a \"\"name\"\"\"\n400,300,0," + cell + '\n', {"--format", "jsonl"});
        QCOMPARE(run.errors, QByteArray());
        QCOMPARE(run.output, "{\"px\":400,\"py\":300,\"depth\":0,\"a \\\"\\\"name\\\"\\\"\":" + json
                                 + ",\"formula_x\":0,\"formula_y\":0,\"formula_z\":4}\n");
        QJsonParseError error{};
        QJsonDocument::fromJson(run.output, &error);
        QCOMPARE(error.error, QJsonParseError::NoError);
    }

    void anObjectHasEachKeyOnce_data()
    {
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<QByteArray>("json"); // of cells 1, 2, 3
        QTest::newRow("two") << QByteArray("n,n,m") << QByteArray(R"("n":1,"n_2":2,"m":3)");
        QTest::newRow("three") << QByteArray("n,n,n") << QByteArray(R"("n":1,"n_2":2,"n_3":3)");
        QTest::newRow("one with a number already") << QByteArray("n_2,n,n") << QByteArray(R"("n_2":1,"n":2,"n_3":3)");
        QTest::newRow("quoted") << QByteArray("n,\"n\",m") << QByteArray(R"("n":1,"n_2":2,"m":3)");
    }

    void anObjectHasEachKeyOnce()
    {
        QFETCH(QByteArray, head);
        QFETCH(QByteArray, json);
        const Run run = points(head + ",px,py,depth\n1,2,3,400,300,0\n", {"--format", "jsonl"});
        QCOMPARE(run.errors, QByteArray());
        QCOMPARE(run.output, '{' + json
                                 + ",\"px\":400,\"py\":300,\"depth\":0,\"formula_x\":0,\"formula_y\":0,\"formula_z\":4}"
                                 + '\n');
    }

    void projectTakesWhatPointsHasWritten()
    {
        const Run clicked = runCommand({"points", m_scene}, "name,px,py,depth\na,100.5,200.25,0.5\nb,700,1,0.75\n");
        const Run there = project(clicked.output);
        QCOMPARE(there.errors, QByteArray());
        QCOMPARE(there.exitCode, 0);
        // The points come from the formulas, and the other columns are unchanged, px,py,depth aside.
        QCOMPARE(there.lines().at(0),
                 "name,formula_x,formula_y,formula_z,matrix_x,matrix_y,matrix_z,difference,eye_x,eye_y,"
                 "eye_z,clip_x,clip_y,clip_z,clip_w,ndc_x,ndc_y,ndc_z,window_x,window_y,window_z,"
                 "widget_x,widget_y,px,py,depth");
        for (int i : {1, 2}) {
            const QList<QByteArray> before = clicked.lines().at(i).split(','), after = there.lines().at(i).split(',');
            QCOMPARE(after.size(), 26);
            QCOMPARE(after.first(), before.first());
            QCOMPARE(after.mid(1, 7), before.mid(4, 7));
            for (int k = 0; k < 3; ++k)
                QVERIFY(std::abs(after[23 + k].toDouble() - before[1 + k].toDouble()) < 1e-9);
            const Run typed = project("x,y,z\n" + before.mid(4, 3).join(',') + '\n');
            QCOMPARE(typed.lines().at(1).split(',').mid(3), after.mid(8));
        }
    }

    void projectPrefersPointsOfAPerson()
    {
        const Run run = project("formula_x,x,y,z,formula_y,formula_z\n9,0,0,1,9,9\n");
        QCOMPARE(run.errors, QByteArray());
        QVERIFY(run.lines().at(1).startsWith("9,0,0,1,9,9,0,0,-4,"));
        // Half of both is neither.
        const Run half = project("x,y,formula_z\n0,0,1\n");
        QCOMPARE(half.errors, QByteArray("stdin:1:1: the header has no column z; the first line must be x,y,z or "
                                         "formula_x,formula_y,formula_z\n"));
        QCOMPARE(half.exitCode, 2);
        const Run twice = project("formula_x,formula_y,formula_z,formula_y\n0,0,1,2\n");
        QCOMPARE(twice.errors, QByteArray("stdin:1:31: the header names the column formula_y twice\n"));
    }

    void pointsOfASpaceComeBackFromIt_data()
    {
        QTest::addColumn<QString>("space");
        QTest::newRow("eye") << "eye";
        QTest::newRow("object") << "object:face";
    }

    void pointsOfASpaceComeBackFromIt()
    {
        QFETCH(QString, space);
        const QByteArray row("120.5,33.25,0.75");
        const Run there = points("px,py,depth\n" + row + '\n', {"--space", space});
        QCOMPARE(there.errors, QByteArray());
        QCOMPARE(there.lines().at(0).split(',').at(3), QByteArray("formula_x"));
        const Run back = runCommand({"project", "--space", space, m_scene}, there.output);
        QCOMPARE(back.errors, QByteArray());
        const QList<QByteArray> cells = back.lines().at(1).split(',');
        for (int k = 0; k < 3; ++k)
            QVERIFY(std::abs(cells[cells.size() - 3 + k].toDouble() - row.split(',').at(k).toDouble()) < 1e-9);
    }

    void whatACommandWritesIsWrittenAnew()
    {
        const Run run = points("formula_x,px,note,py,depth,\"formula_z\"\n9,400,a,300,0,9\n");
        QCOMPARE(run.output, QByteArray("px,note,py,depth,formula_x,formula_y,formula_z\n400,a,300,0,0,0,4\n"));
    }

    void thereAndBackAndThereAgain()
    {
        QByteArray rows("name,px,py,depth\n\"a, b\",100.5,200.25,0.5\n");
        for (int round = 0; round < 3; ++round) {
            const Run there = points(rows);
            QCOMPARE(there.exitCode, 0);
            const Run back = project(there.output);
            QCOMPARE(back.errors, QByteArray());
            QCOMPARE(back.exitCode, 0);
            QVERIFY(back.lines().at(1).startsWith("\"a, b\","));
            QCOMPARE(back.lines().at(0).count(','), 21); // no column is there twice
            rows = back.output;
        }
    }

    void manyRowsKeepTheirOwn()
    {
        constexpr int kRows = 50000;
        QByteArray input("id,px,py,depth,name\n");
        for (int i = 0; i < kRows; ++i)
            input += QByteArray::number(i) + ",400,300,0,\"n, " + QByteArray::number(i) + "\n1,2,0,\"\n";
        const QList<QByteArray> lines = points(input, {"--threads", "3"}).lines();
        QCOMPARE(lines.size(), 2 * kRows + 1);
        for (int i = 0; i < kRows; ++i) {
            const QByteArray id = QByteArray::number(i);
            QCOMPARE(lines[2 * i + 1], id + ",400,300,0,\"n, " + id);
            QCOMPARE(lines[2 * i + 2], "1,2,0,\",0,0,4");
        }
    }

    void formulasOfASpreadsheet()
    {
        const QByteArray input(
            "=n,px,py,depth,note\n=1+1,400,300,0,\"@a, \"\"b\"\"\"\n-5,400,300,0,'=c\n-x,no,300,0,+d\n");
        QCOMPARE(points(input).output, QByteArray("=n,px,py,depth,note,formula_x,formula_y,formula_z\n"
                                                  "=1+1,400,300,0,\"@a, \"\"b\"\"\",0,0,4\n-5,400,300,0,'=c,0,0,4\n"
                                                  "-x,no,300,0,+d,,,\n"));
        QCOMPARE(points(input, {"--spreadsheet-safe"}).output,
                 QByteArray("'=n,px,py,depth,note,formula_x,formula_y,formula_z\n"
                            "'=1+1,400,300,0,\"'@a, \"\"b\"\"\",0,0,4\n-5,400,300,0,'=c,0,0,4\n"
                            "'-x,no,300,0,'+d,,,\n"));
        const Run json = points(input, {"--spreadsheet-safe", "--format", "jsonl"});
        QVERIFY2(json.output.startsWith("{\"=n\":\"=1+1\",\"px\":400"), json.output);
    }

private:
    Run points(const QByteArray &input, const QStringList &options = {}) const
    {
        return runCommand(QStringList{"points", "--method", "formula"} + options + QStringList{m_scene, "-"}, input);
    }
    Run project(const QByteArray &input) const { return runCommand({"project", m_scene}, input); }

    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestPassedColumns)
#include "test_passed_columns.moc"
