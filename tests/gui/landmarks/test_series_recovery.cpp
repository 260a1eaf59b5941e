// A series of scans after the program was killed, in the whole window.

#include "tests/support/test.h"

#include "tests/gui/kept_scene.h"
#include "tests/support/patience.h"

#include "gui/document/scene_document.h"
#include "gui/landmarks/scan_series.h"
#include "gui/shell/overlay_bars.h"

#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTimer>

#include <cstdio>

using namespace keeping;
using namespace unprojector;
using namespace unprojector::gui;

namespace {

ScanSeries &seriesOf(MainWindow &window)
{
    return *window.findChild<ScanSeries *>();
}

bool hasLoaded(MainWindow &window)
{
    return QTest::qWaitFor([&window] { return !window.session().isLoading(); }, kPatienceMilliseconds);
}

bool place(MainWindow &window, const char *name, double x)
{
    landmarks::Landmark placed;
    placed.name = name;
    placed.world = geometry::WorldPoint(x, 0.25, 0.0);
    return bool(window.document().sceneLandmarks().place(placed));
}

/// Runs the program until it is killed: places landmarks on the second scan, and goes to the third
/// one if `isGoing`. Reports when that point is reached.
int runUntilKilled(const QString &folder, const QString &recovery, bool isGoing)
{
    const auto window = windowKeepingIn(recovery);
    ScanSeries &series = seriesOf(*window);
    if (!series.open(pathOf(folder)) || !hasLoaded(*window))
        return 3;
    series.next();
    if (!hasLoaded(*window) || !place(*window, "first", 0.125) || !place(*window, "second", 0.5))
        return 4;
    if (!QTest::qWaitFor([&] { return !keptIn(recovery).isEmpty(); }, kPatienceMilliseconds))
        return 5;
    if (isGoing)
        series.next();
    std::printf("there\n");
    std::fflush(stdout);
    return QApplication::exec();
}

QPushButton &buttonOf(MainWindow &window, const QString &text)
{
    for (QPushButton *button : window.findChild<RecoveryBar *>()->findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == text)
            return *button;
    }
    qFatal("no such button");
}

} // namespace

class TestSeriesRecovery : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { guitest::redirectSettings(); }

    void init()
    {
        m_folder = std::make_unique<Folder>();
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("scans")));
        for (const char *name : {"a.obj", "b.obj", "c.obj"})
            write(scans() + u'/' + QLatin1String(name), kTriangle);
    }

    void aKilledSeriesContinues()
    {
        killOne(false);
        QCOMPARE(landmarks("b.obj"), QByteArray()); // they are in no file yet
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().openBundledScene();
        window->session().offerRecovery();
        const auto *text = window->findChild<RecoveryBar *>()->findChild<QLabel *>();
        QVERIFY2(text->text().contains(QStringLiteral("b.obj of the series “scans”")), qPrintable(text->text()));
        buttonOf(*window, QStringLiteral("Recover")).click();
        QVERIFY(hasLoaded(*window));
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        ScanSeries &series = seriesOf(*window);
        QCOMPARE(series.current(), std::optional<std::size_t>(1));
        QCOMPARE(window->document().landmarks().size(), std::size_t(2));
        QVERIFY(place(*window, "third", 0.25));
        series.next();
        QVERIFY(hasLoaded(*window));
        QCOMPARE(series.current(), std::optional<std::size_t>(2));
        for (const char *name : {"first,0.125,", "second,0.5,", "third,0.25,"})
            QVERIFY2(landmarks("b.obj").contains(name), landmarks("b.obj").constData());
        QVERIFY(keptIn(m_folder->recovery()).isEmpty());
        QCOMPARE(window->document().landmarks().size(), std::size_t(3)); // names to place
    }

    void aSeriesKilledOnItsWayHasSaved()
    {
        killOne(true);
        QVERIFY2(landmarks("b.obj").contains("second,0.5,"), landmarks("b.obj").constData());
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().offerRecovery();
        ScanSeries &series = seriesOf(*window);
        if (!window->session().offered().empty()) { // it was killed before it removed what it had kept
            buttonOf(*window, QStringLiteral("Recover")).click();
            QVERIFY(hasLoaded(*window));
            QCOMPARE(series.current(), std::optional<std::size_t>(1));
        } else {
            QVERIFY(series.open(pathOf(scans())));
            QVERIFY(hasLoaded(*window));
            QCOMPARE(series.current(), std::optional<std::size_t>(0));
        }
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        QCOMPARE(series.scans()[1].placedCount(), std::size_t(2));
    }

    void discardingTellsWhatIsLost()
    {
        killOne(false);
        const auto window = windowKeepingIn(m_folder->recovery());
        window->session().offerRecovery();
        QString asked;
        QTimer timer;
        connect(&timer, &QTimer::timeout, &timer, [&] {
            if (auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget())) {
                asked = box->text();
                box->button(QMessageBox::Discard)->click();
            }
        });
        timer.start(10);
        buttonOf(*window, QStringLiteral("Discard")).click();
        QCOMPARE(asked, QStringLiteral(
                            "Delete the unsaved changes to b.obj of the series “scans” (landmarks placed: 2; in its "
                            "file: 0) for good?"));
        QVERIFY(keptIn(m_folder->recovery()).isEmpty());
    }

private:
    QString scans() const { return m_folder->file(QStringLiteral("scans")); }
    QByteArray landmarks(const char *scan) const
    {
        return read(scans() + u'/' + QLatin1String(scan) + QStringLiteral(".points.csv"));
    }
    /// Runs the program until it is killed.
    void killOne(bool isGoing) const
    {
        QProcess program;
        program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        program.start(QCoreApplication::applicationFilePath(),
                      {QStringLiteral("--until-killed"), scans(), m_folder->recovery(),
                       isGoing ? QStringLiteral("going") : QStringLiteral("placing")});
        QVERIFY(program.waitForStarted(kPatienceMilliseconds));
        QByteArray said;
        while (!said.contains("there") && program.waitForReadyRead(kPatienceMilliseconds))
            said += program.readAllStandardOutput();
        QVERIFY2(said.contains("there"), said.constData());
        program.kill();
        QVERIFY(program.waitForFinished(kPatienceMilliseconds));
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);
    }

    std::unique_ptr<Folder> m_folder;
};

namespace {
const tests::Helper untilKilled(QStringLiteral("until-killed"), [](const QStringList &words) {
    guitest::redirectSettings();
    return runUntilKilled(words.at(0), words.at(1), words.at(2) == QStringLiteral("going"));
});
} // namespace

UNPROJECTOR_TEST(TestSeriesRecovery, display)
#include "test_series_recovery.moc"
