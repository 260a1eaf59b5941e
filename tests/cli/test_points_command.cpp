// `unproject points`, row by row, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <cmath>

namespace {

const QByteArray kHeader = "px,py,depth,formula_x,formula_y,formula_z,matrix_x,matrix_y,matrix_z,difference";

QList<double> numbers(const QByteArray &row)
{
    QList<double> values;
    for (const QByteArray &cell : row.split(','))
        values.append(cell.toDouble());
    return values;
}

} // namespace

class TestPointsCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

    void literalPoints_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QList<double>>("world");
        QTest::newRow("centre, near plane") << QByteArray("400,300,0") << QList<double>{0, 0, 4};
        QTest::newRow("centre, far plane") << QByteArray("400,300,1") << QList<double>{0, 0, 1};
        QTest::newRow("top-left corner, near plane") << QByteArray("0,0,0") << QList<double>{-1, 0.75, 4};
        QTest::newRow("bottom-right corner, far plane") << QByteArray("800,600,1") << QList<double>{4, -3, 1};
        QTest::newRow("outside the window") << QByteArray("1200,300,0") << QList<double>{2, 0, 4};
    }

    void literalPoints()
    {
        QFETCH(QByteArray, row);
        QFETCH(QList<double>, world);
        const Run run = points("px,py,depth\n" + row + "\n");
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.lines().size(), 2);
        QCOMPARE(run.lines()[0], kHeader);
        QVERIFY(run.lines()[1].startsWith(row + ','));
        const QList<double> cells = numbers(run.lines()[1]);
        QCOMPARE(cells.size(), 10);
        double squares = 0.0;
        for (int k = 0; k < 3; ++k) {
            QVERIFY(std::abs(cells[3 + k] - world[k]) <= 1e-14);
            QVERIFY(std::abs(cells[6 + k] - world[k]) <= 1e-13);
            squares += (cells[3 + k] - cells[6 + k]) * (cells[3 + k] - cells[6 + k]);
        }
        QVERIFY(std::abs(cells[9] - std::sqrt(squares)) <= 1e-20);
    }

    void spaces_data()
    {
        QTest::addColumn<QString>("space");
        QTest::addColumn<QList<double>>("point");
        QTest::newRow("eye") << "eye" << QList<double>{4, -3, -4};
        QTest::newRow("world") << "world" << QList<double>{4, -3, 1};
        QTest::newRow("object") << "object:face" << QList<double>{2, -1.5, -1};
    }

    void spaces()
    {
        QFETCH(QString, space);
        QFETCH(QList<double>, point);
        const Run run = points("px,py,depth\n800,600,1\n", {"--space", space});
        QCOMPARE(run.exitCode, 0);
        const QList<double> cells = numbers(run.lines().at(1));
        for (int k = 0; k < 3; ++k) {
            QVERIFY(std::abs(cells[3 + k] - point[k]) <= 1e-14);
            QVERIFY(std::abs(cells[6 + k] - point[k]) <= 1e-13);
        }
    }

    void numbersAreRead_data()
    {
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<int>("rows");
        QTest::newRow("LF") << QByteArray("px,py,depth\n100,200,0.5\n") << 1;
        QTest::newRow("CRLF") << QByteArray("px,py,depth\r\n100,200,0.5\r\n100,200,0.5\r\n") << 2;
        QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBFpx,py,depth\n100,200,0.5\n") << 1;
        QTest::newRow("blanks") << QByteArray(" px , py ,depth \n  100 ,\t200, 0.5 \n") << 1;
        QTest::newRow("exponents") << QByteArray("px,py,depth\n1e2,2E+2,5e-1\n") << 1;
        QTest::newRow("plus signs") << QByteArray("px,py,depth\n+100,+200,+.5\n") << 1;
        QTest::newRow("no last line end") << QByteArray("px,py,depth\n100,200,0.5") << 1;
        QTest::newRow("quoted") << QByteArray("\"px\",\"py\",\"depth\"\n\"100\",\"200\",\"0.5\"\n") << 1;
        QTest::newRow("empty lines") << QByteArray("px,py,depth\n\n100,200,0.5\n\r\n \n100,200,0.5\n\n") << 2;
        QTest::newRow("header alone") << QByteArray("px,py,depth") << 0;
    }

    void numbersAreRead()
    {
        QFETCH(QByteArray, input);
        QFETCH(int, rows);
        const Run run = points(input);
        VERIFY_SUCCEEDED(run);
        const QByteArray expected = points("px,py,depth\n100,200,0.5\n").lines().at(1);
        QCOMPARE(run.lines(), QList<QByteArray>{kHeader} + QList<QByteArray>(rows, expected));
    }

    void badRowsAreNamedAndTheRestGoesOn_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QByteArray>("message");
        const QByteArray cells(",,,,,,,");
        QTest::newRow("text") << QByteArray("1,two,0.5") << "1,two,0.5" + cells
                              << QByteArray(":3:3: py: \"two\" is not a number");
        QTest::newRow("number and text") << QByteArray("1,2x,0.5") << "1,2x,0.5" + cells
                                         << QByteArray(":3:3: py: \"2x\" is not a number");
        QTest::newRow("missing column") << QByteArray("1,2") << "1,2," + cells << QByteArray(":3:4: depth is missing");
        QTest::newRow("empty cell") << QByteArray("1,,0.5") << "1,,0.5" + cells << QByteArray(":3:3: py is missing");
        QTest::newRow("NaN") << QByteArray("nan,2,0.5") << "nan,2,0.5" + cells
                             << QByteArray(":3:1: px: \"nan\" is not finite");
        QTest::newRow("infinity") << QByteArray("1, -inf,0.5") << "1, -inf,0.5" + cells
                                  << QByteArray(":3:4: py: \"-inf\" is not finite");
        QTest::newRow("1e400") << QByteArray("1e400,2,0.5") << "1e400,2,0.5" + cells
                               << QByteArray(":3:1: px: \"1e400\" is beyond the range of double precision");
        QTest::newRow("depth above 1") << QByteArray("1,2,1.5") << "1,2,1.5" + cells
                                       << QByteArray(":3:5: depth: 1.5 lies outside the depth range 0 to 1");
        QTest::newRow("depth below 0") << QByteArray("1,2,-0.5") << "1,2,-0.5" + cells
                                       << QByteArray(":3:5: depth: -0.5 lies outside the depth range 0 to 1");
    }

    void badRowsAreNamedAndTheRestGoesOn()
    {
        QFETCH(QByteArray, row);
        QFETCH(QByteArray, written);
        QFETCH(QByteArray, message);
        const QString file = m_folder.write("rows.csv", "px,py,depth\n400,300,0\n" + row + "\n400,300,0\n");
        const Run run = runCommand({"points", m_scene, file});
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), 4);
        QVERIFY(run.lines()[1].startsWith("400,300,0,"));
        QCOMPARE(run.lines()[2], written);
        QCOMPARE(run.lines()[3], run.lines()[1]);
        QCOMPARE(QByteArray(run.errors).replace("\r", ""), file.toUtf8() + message + '\n');
    }

    void methodsLeaveColumnsOut_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QByteArray>("header");
        QTest::newRow("both") << "both" << kHeader;
        QTest::newRow("formula") << "formula" << QByteArray("px,py,depth,formula_x,formula_y,formula_z");
        QTest::newRow("matrix") << "matrix" << QByteArray("px,py,depth,matrix_x,matrix_y,matrix_z");
        QTest::newRow("in float") << "matrixInFloat"
                                  << QByteArray("px,py,depth,matrixInFloat_x,matrixInFloat_y,matrixInFloat_z");
        QTest::newRow("all") << "all"
                             << QByteArray("px,py,depth,formula_x,formula_y,formula_z,matrix_x,matrix_y,matrix_z,"
                                           "matrixInFloat_x,matrixInFloat_y,matrixInFloat_z,difference");
    }

    void methodsLeaveColumnsOut()
    {
        QFETCH(QString, method);
        QFETCH(QByteArray, header);
        const Run run = points("px,py,depth\n400,300,0\nx,1,1\n", {"--method", method});
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().at(0), header);
        for (const QByteArray &line : run.lines())
            QCOMPARE(line.count(','), header.count(','));
    }

    /// A view that is not quite rigid: the matrix answers, the formulas' cells are empty. A message
    /// gives the reason and the remedy.
    void aMethodThatDoesNotHoldIsSaid()
    {
        QByteArray scene = kFrustumScene;
        scene.replace(R"({"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})",
                      R"({"matrix": [1.0001, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1]})");
        const QString file = m_folder.write("askew.json", scene);
        const Run run = runCommand({"points", file, "-"}, "px,py,depth\n400,300,1\n");
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.output.contains("\n400,300,1,,,,0,0,1"), run.output);
        QCOMPARE(run.errors.count('\n'), 1);
        QVERIFY2(
            run.errors.startsWith(file.toUtf8() + ": formula: the view matrix is not rotation + translation: row 1 ")
                && run.errors.contains(". Its cells stay empty; 'unproject scene --from-matrices ... --orthonormal' "),
            run.errors);
    }

    void jsonLines()
    {
        const Run run = points("px,py,depth\n400,300,0\nx,1,1\n", {"--format", "jsonl", "--method", "formula"});
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.output,
                 QByteArray(
                     "{\"px\":400,\"py\":300,\"depth\":0,\"formula_x\":0,\"formula_y\":0,\"formula_z\":4}\n"
                     "{\"px\":null,\"py\":1,\"depth\":1,\"formula_x\":null,\"formula_y\":null,\"formula_z\":null}\n"));
    }

    void pixelsMeanTheirCentres()
    {
        const Run centres = points("px,py,depth\n10.5,20.5,0.5\n");
        const Run pixels = points("px,py,depth\n10,20,0.5\n10.5,20,0.5\n", {"--pixel"});
        QCOMPARE(pixels.exitCode, 1);
        QVERIFY(pixels.lines().at(1).startsWith("10,20,0.5,"));
        QCOMPARE(pixels.lines().at(1).mid(sizeof("10,20,0.5,") - 1),
                 centres.lines().at(1).mid(sizeof("10.5,20.5,0.5,") - 1));
        QVERIFY(pixels.errors.contains("stdin:3:1: px: 10.5 is not the index of a pixel"));
    }

    void unusableInput_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QByteArray>("message");
        const QByteArray good("px,py,depth\n1,2,0.5\n");
        const QString missing = m_folder.path("missing");
        QTest::newRow("no scene") << QStringList{"points", missing, "-"} << good << QByteArray("missing");
        QTest::newRow("scene is not JSON")
            << QStringList{"points", m_folder.write("bad.json", "{"), "-"} << good << QByteArray("bad.json:1:");
        QTest::newRow("no points file") << QStringList{"points", m_scene, missing} << QByteArray()
                                        << QByteArray("cannot be read");
        QTest::newRow("points file is a folder")
            << QStringList{"points", m_scene, m_folder.path("")} << QByteArray() << QByteArray("folder");
        QTest::newRow("nothing at all") << QStringList{"points", m_scene} << QByteArray()
                                        << QByteArray("stdin: is empty");
        QTest::newRow("no header") << QStringList{"points", m_scene, "-"} << QByteArray("1,2,3\n")
                                   << QByteArray("stdin:1:1: the header has no column px");
        QTest::newRow("a column twice") << QStringList{"points", m_scene, "-"}
                                        << QByteArray("px,py,depth,px\n1,2,0,3\n")
                                        << QByteArray("names the column px twice");
        QTest::newRow("no such object") << QStringList{"points", "--space", "object:nose", m_scene, "-"} << good
                                        << QByteArray("face");
        QTest::newRow("two objects of one name")
            << QStringList{"points", "--space", "object:face",
                           m_folder.write("alike.json",
                                          QByteArray(kFrustumScene)
                                              .replace("\"objects\": [",
                                                       "\"objects\": [{\"name\": \"face\", \"file\": "
                                                       "\"a.obj\"}, {\"name\": \"b\", \"file\": \"a.obj\"}, ")),
                           "-"}
            << good
            << QByteArray("several objects called \"face\": objects[0], objects[2]; give each a name of its own");
        QTest::newRow("no such space") << QStringList{"points", "--space", "clip", m_scene, "-"} << good
                                       << QByteArray("world, eye or object:NAME");
        QTest::newRow("no such method") << QStringList{"points", "--method", "guess", m_scene, "-"} << good
                                        << QByteArray("both, formula, matrix");
        QTest::newRow("no such option") << QStringList{"points", "--colour", m_scene, "-"} << good
                                        << QByteArray("--colour");
    }

    void unusableInput()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, input);
        QFETCH(QByteArray, message);
        const Run run = runCommand(arguments, input);
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QVERIFY2(run.errors.contains(message), run.errors.constData());
    }

    void columnsAreFoundByName()
    {
        const Run run = points("id,depth,py,px\n7,0.5,200,100\n");
        QCOMPARE(run.exitCode, 0);
        // They stay where they stood.
        const QByteArray results = points("px,py,depth\n100,200,0.5\n").lines().at(1).mid(sizeof("100,200,0.5") - 1);
        QCOMPARE(run.lines().at(0), "id,depth,py,px" + kHeader.mid(sizeof("px,py,depth") - 1));
        QCOMPARE(run.lines().at(1), "7,0.5,200,100" + results);
    }

    void everyDigitReadsBack()
    {
        const Run run = points("px,py,depth\n0.1,599.9000000000001,0.30000000000000004\n1e-300,-0,5e-324\n");
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.lines().at(1).startsWith("0.1,599.9000000000001,0.30000000000000004,"));
        QVERIFY(run.lines().at(2).startsWith("1e-300,-0,5e-324,"));
    }

    void manyRowsKeepTheirOrder_data()
    {
        QTest::addColumn<QString>("threads");
        QTest::newRow("one thread") << "1";
        QTest::newRow("two threads") << "2";
        QTest::newRow("five threads") << "5";
    }

    /// Enough for many blocks; a bad row among them, and a line longer than any block.
    void manyRowsKeepTheirOrder()
    {
        QFETCH(QString, threads);
        constexpr int kRows = 100000, kBad = 70000, kLong = 80000;
        QByteArray input("px,py,depth\n");
        for (int i = 0; i < kRows; ++i) {
            const QByteArray depth = i == kBad ? "deep" : i == kLong ? QByteArray(400000, '1') : QByteArray("0.5");
            input += QByteArray::number(i) + ",7," + depth + '\n';
        }
        const Run run = points(input, {"--threads", threads, "--method", "formula"});
        QCOMPARE(run.exitCode, 1);
        const QList<QByteArray> lines = run.lines();
        QCOMPARE(lines.size(), kRows + 1);
        for (int i = 0; i < kRows; ++i)
            QVERIFY(lines[i + 1].startsWith(i == kLong ? QByteArray(",,") : QByteArray::number(i) + ",7,"));
        QCOMPARE(run.errors.count('\n'), 2);
        QVERIFY(run.errors.contains("stdin:70002:9: depth: \"deep\" is not a number"));
        QVERIFY(run.errors.contains("stdin:80002: the line is longer than"));
    }

private:
    Run points(const QByteArray &input, const QStringList &options = {}) const
    {
        return runCommand(QStringList{"points"} + options + QStringList{m_scene, "-"}, input);
    }

    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestPointsCommand, threads)
#include "test_points_command.moc"
