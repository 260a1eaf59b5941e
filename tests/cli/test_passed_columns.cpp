// Columns that a command does not know, and commands that take each other's rows, through the
// executable.

#include "tests/support/test.h"

#include "tests/cli/command.h"

class TestPassedColumns : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

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

    void aLineThatIsTooLongIsDroppedAsAWhole()
    {
        const Run overlong = points("name,px,py,depth\n" + QByteArray(200000, 'a') + ",400,300,0\nb,400,300,0\n");
        QCOMPARE(overlong.lines().mid(1), (QList<QByteArray>{",,,,,,", "b,400,300,0,0,0,4"}));
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
