// `unproject scene --from-matrices`: the order in which the numbers of matrices are read.

#include "tests/support/test.h"

#include "tests/cli/command.h"

namespace {

/// The eye is at (0, 0, 5) and looks down -z; near 1, far 3. The columns in brackets are as glam,
/// simd and nalgebra print them.
const QByteArray kViewRows = "1 0 0 0  0 1 0 0  0 0 1 -5  0 0 0 1",
                 kViewColumns = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1";
const QByteArray kLensRows = "1 0 0 0  0 1 0 0  0 0 -2 -3  0 0 -1 0",
                 kLensColumns = "1 0 0 0  0 1 0 0  0 0 -2 -1  0 0 -3 0";
/// A quarter turn about y: the eye is at the origin and looks down -x.
const QByteArray kTurnRows = "0 0 -1 0  0 1 0 0  1 0 0 0  0 0 0 1",
                 kTurnColumns = "0 0 1 0  0 1 0 0  -1 0 0 0  0 0 0 1";
/// Near 1/2, far at infinity: the same by rows and by columns.
const QByteArray kSymmetricLens = "1 0 0 0  0 1 0 0  0 0 -1 -1  0 0 -1 0";

/// The numbers in four brackets of four.
QByteArray nested(const QByteArray &numbers)
{
    const QList<QByteArray> words = numbers.simplified().split(' ');
    QByteArray text = "[";
    for (int i = 0; i < 4; ++i)
        text += '[' + words.mid(4 * i, 4).join(", ") + (i < 3 ? "], " : "]]");
    return text;
}

QByteArray scene(const QByteArray &view, const QByteArray &lens)
{
    return "view " + view + "\nprojection " + lens + "\nviewport 0 0 400 400\n";
}

Run made(const QByteArray &text, const QStringList &options = {})
{
    return runCommand(QStringList{"scene", "--from-matrices", "-"} + options, text);
}

} // namespace

class TestMatrixOrder : public QObject {
    Q_OBJECT

private slots:
    void whatGivesACameraIsTaken_data()
    {
        QTest::addColumn<QByteArray>("view");
        QTest::addColumn<QByteArray>("lens");
        QTest::addColumn<bool>("isSaid");
        QTest::newRow("NumPy's rows") << nested(kViewRows) << nested(kLensRows) << false;
        QTest::newRow("glam's columns") << nested(kViewColumns) << nested(kLensColumns) << true;
        QTest::newRow("glGet's columns") << kViewColumns << kLensColumns << false;
        QTest::newRow("Collada's rows") << kViewRows << kLensRows << true;
        QTest::newRow("one of each") << nested(kViewColumns) << nested(kLensRows) << true;
    }

    void whatGivesACameraIsTaken()
    {
        QFETCH(QByteArray, view);
        QFETCH(QByteArray, lens);
        QFETCH(bool, isSaid);
        const Run expected = made(scene(kViewColumns, kLensColumns), {"--order", "column"});
        VERIFY_SUCCEEDED(expected);
        const Run run = made(scene(view, lens));
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.output, expected.output);
        QCOMPARE(run.errors.contains(
                     "view: is read in the order, by rows or by columns, that makes 0 0 0 1 its last row; read by"),
                 isSaid);
        QVERIFY(!run.errors.contains("transposed"));
        QVERIFY(isSaid || run.errors.isEmpty());
    }

    void aViewThatOnlyTurnsGoesByTheProjection()
    {
        const Run expected = made(scene(kTurnColumns, kLensColumns), {"--order", "column"});
        VERIFY_SUCCEEDED(expected);
        const Run rows = made(scene(nested(kTurnRows), nested(kLensRows)));
        VERIFY_SUCCEEDED(rows);
        QCOMPARE(rows.output, expected.output);
        const Run columns = made(scene(nested(kTurnColumns), nested(kLensColumns)));
        QCOMPARE(columns.exitCode, 0);
        QCOMPARE(columns.output, expected.output);
        QCOMPARE(
            columns.errors,
            QByteArray("stdin: view: has the same form in both orders, and is read in that of the other matrices; "
                       "read by columns, --order row reads it by rows\n"
                       "stdin: projection: is read in the order, by rows or by columns, that makes it a projection; "
                       "read by columns, "
                       "--order row reads it by rows\n"));
    }

    void whatCannotBeToldIsAskedFor()
    {
        const QByteArray text = scene(nested(kTurnRows), nested(kSymmetricLens));
        const Run run = made(text);
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QCOMPARE(run.errors,
                 QByteArray("stdin: view: is a camera's matrix by rows and by columns, a different one in each "
                            "order; give --order row or --order column\n"));
        const Run rows = made(text, {"--order", "row"}), columns = made(text, {"--order", "column"});
        QCOMPARE(rows.exitCode, 0);
        QCOMPARE(columns.exitCode, 0);
        QVERIFY(rows.output != columns.output);
    }

    void aViewportsMatrixIsReadAsWell()
    {
        const QByteArray matrices =
            "view " + nested(kViewColumns) + " projection " + nested(kLensColumns) + " viewport ";
        const Run expected = made(matrices + "0 0 400 300");
        const Run run = made(matrices + nested("200 0 0 0  0 150 0 0  0 0 0.5 0  200 150 0.5 1"));
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.output, expected.output);
        QVERIFY2(run.errors.contains("viewport: is read in the order"), run.errors.constData());
    }
};

UNPROJECTOR_TEST(TestMatrixOrder)
#include "test_matrix_order.moc"
