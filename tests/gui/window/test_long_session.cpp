// A long session: files opened and reopened, clicks, drags, undo and redo. The memory that it needs
// stops growing. UNPROJECTOR_SESSION_STEPS makes it longer:
//     bash tests/launch.sh --display UNPROJECTOR_SESSION_STEPS=800 -- build/dev/tests/tests_gui_window
//         test_long_session

#include "tests/support/test.h"

#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <random>

using namespace guitest;

namespace {

/// Resident memory of this process, in pages; 0 where the system does not say it so.
double residentPages()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(1).toDouble() : 0.0;
}

/// A ball of 2 n (n - 1) triangles.
QByteArray ball(int n, double radius)
{
    QByteArray text;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double a = 6.283185307179586 * i / n, b = 3.141592653589793 * j / n;
            for (const double x : {std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b)})
                text += (text.endsWith('\n') || text.isEmpty() ? "v " : " ") + QByteArray::number(radius * x, 'g', 9);
            text += '\n';
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * n + i + 1, b = j * n + (i + 1) % n + 1;
            text += "f " + QByteArray::number(a) + ' ' + QByteArray::number(b) + ' ' + QByteArray::number(b + n) + ' '
                    + QByteArray::number(a + n) + '\n';
        }
    }
    return text;
}

} // namespace

class TestLongSession : public QObject {
    Q_OBJECT

private slots:
    void memoryStopsGrowing_data()
    {
        addColumn<bool>("isReopening");
        newRow("one file") << false; // all that was done can be undone
        newRow("files in turn") << true;
    }

    void memoryStopsGrowing()
    {
        QFETCH(bool, isReopening);
#ifdef UNPROJECTOR_IS_SANITIZED
        QSKIP("A sanitizer keeps what is freed");
#endif
        if (residentPages() == 0.0)
            QSKIP("The system does not say how much memory is resident");
        redirectSettings();
        const QTemporaryDir folder;
        std::vector<std::filesystem::path> files;
        for (const double radius : {1.0, 2.0}) {
            QFile file(folder.filePath(QString("ball%1.obj").arg(radius)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(ball(100, radius));
            files.emplace_back(file.fileName().toStdU16String());
        }
        const auto window = windowOfSize(QSize(1000, 700));
        std::mt19937_64 engine(1);
        const auto below = [&engine](int count) { return static_cast<int>(engine() % static_cast<unsigned>(count)); };
        const auto anywhere = [&] { return QPointF(below(window->view().width()), below(window->view().height())); };
        const auto step = [&](int number) {
            switch (number % 8) {
            case 0:
                if (!isReopening && number > 0)
                    break;
                window->session().openFiles({files[static_cast<std::size_t>(number / 8 % 2)]});
                QVERIFY(QTest::qWaitFor([&] { return !window->session().isLoading(); }, kPatienceMilliseconds));
                break;
            case 1:
            case 2: click(window->view(), anywhere()); break;
            case 3: drag(window->view(), anywhere(), anywhere(), Qt::LeftButton); break;
            case 4: turnWheel(window->view(), anywhere(), below(5) - 2); break;
            case 5: window->document().undoStack().undo(); break;
            case 6: window->document().undoStack().redo(); break;
            default: QTest::keyClick(&window->view(), Qt::Key_F); break;
            }
            settle(1);
        };
        // Whole rounds through both files.
        constexpr int kWarmUp = 64, kLeastSteps = 80;
        const int steps = std::max(kLeastSteps, qEnvironmentVariableIntValue("UNPROJECTOR_SESSION_STEPS"));
        for (int i = 0; i < kWarmUp; ++i)
            step(i);
        const double before = residentPages();
        for (int i = 0; i < steps; ++i)
            step(i);
        const double after = residentPages();
        qInfo("%.0f pages before, %.0f after", before, after);
        QVERIFY2(after <= 1.2 * before, qPrintable(QString("%1 times as much").arg(after / before)));
    }
};

UNPROJECTOR_TEST(TestLongSession, display)
#include "test_long_session.moc"
