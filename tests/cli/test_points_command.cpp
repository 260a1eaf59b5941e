// `unproject points`, row by row, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <cmath>

class TestPointsCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

    void theDifferenceIsTheDistance()
    {
        const QList<QByteArray> cells = points("px,py,depth\n800,600,1\n").lines().at(1).split(',');
        double squares = 0.0;
        for (int k = 3; k < 6; ++k)
            squares += std::pow(cells[k].toDouble() - cells[k + 3].toDouble(), 2);
        QVERIFY(squares > 0.0);
        QVERIFY(std::abs(cells[9].toDouble() - std::sqrt(squares)) <= 1e-20);
    }

    void manyRowsKeepTheirOrder_data()
    {
        addColumn<QString>("threads");
        newRow("one thread") << "1";
        newRow("two threads") << "2";
        newRow("five threads") << "5";
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
