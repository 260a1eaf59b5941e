// The whole window at the fonts of the desktops, in both languages, on usual screens: nothing is
// cut off, nothing overlaps, no bar scrolls sideways, and the view stands still.

#include "tests/support/test.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/gui_scene.h"

#include "gui/click/pick_strip.h"
#include "gui/text/translation.h"
#include "gui/view/scene_view.h"
#include "gui/window/workspaces.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QScreen>
#include <QScrollBar>
#include <QSet>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

constexpr QSize kLeast(800, 600);

/// The faults of the window's visible widgets, each in words. @param looked  receives the visible
/// panels
QStringList faultsOf(MainWindow &window, QSet<QString> &looked)
{
    // Panels may scroll in the least window.
    const bool hasRoom = window.width() > kLeast.width();
    QStringList faults;
    for (const QDockWidget *dock : window.findChildren<QDockWidget *>()) {
        if (!hasRoom || !window.workspaces().isFront(*dock))
            continue;
        looked << dock->objectName();
        for (const QString &text : cutTexts(*dock->widget()))
            faults << QStringLiteral("%1: %2").arg(dock->objectName(), text);
        for (const QScrollBar *bar : dock->findChildren<QScrollBar *>()) {
            if (bar->orientation() == Qt::Horizontal && bar->isVisible() && bar->maximum() > 0)
                faults << QStringLiteral("%1: scrolls sideways, %2 of %3")
                              .arg(dock->objectName())
                              .arg(bar->maximum())
                              .arg(dock->width());
        }
    }
    for (const QTabBar *tabs : window.findChildren<QTabBar *>()) {
        for (int tab = 0; !tabs->visibleRegion().isEmpty() && tab < tabs->count(); ++tab) {
            if (tabs->fontMetrics().horizontalAdvance(tabs->tabText(tab)) > tabs->tabRect(tab).width())
                faults << QStringLiteral("the tab %1 is cut").arg(tabs->tabText(tab));
        }
    }
    for (const QToolButton *button :
         window.findChild<QToolBar *>(QStringLiteral("tools"))->findChildren<QToolButton *>()) {
        if (button->objectName() == QStringLiteral("qt_toolbar_ext_button") && button->isVisible())
            faults << QStringLiteral("the tool bar has no room");
    }
    const QList<QAction *> menus = window.menuBar()->actions();
    if (window.menuBar()->actionGeometry(menus.last()).right() > window.menuBar()->width())
        faults << QStringLiteral("the menus have no room");
    for (const QString &text : cutTexts(*window.statusBar()))
        faults << QStringLiteral("status bar: %1").arg(text);
    return faults;
}

} // namespace

class TestWindowGrid : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theWindowStartsWithinTheScreen()
    {
        MainWindow::Options options;
        options.remembers = false;
        const MainWindow window(options);
        const QSize screen = window.screen()->availableSize();
        QVERIFY(window.width() < screen.width() && window.height() < screen.height());
    }

    void everythingFits_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<QString>("language");
        for (const int points : {9, 10, 11, 13}) {
            for (const QString &language : {QStringLiteral("en"), QStringLiteral("zh_CN")})
                QTest::addRow("%d pt, %s", points, qPrintable(language)) << points << language;
        }
    }

    void everythingFits()
    {
        QFETCH(int, points);
        QFETCH(QString, language);
        const bool isScaled = qApp->devicePixelRatio() != 1.0;
        const QList<QSize> sizes = isScaled ? QList<QSize>{{1280, 800}}
                                            : QList<QSize>{kLeast, {1280, 800}, {1366, 768}, {1600, 900}, {1920, 1080}};
        const QFont before = QApplication::font();
        QFont font = before;
        font.setPointSize(points);
        QApplication::setFont(font);
        bool wasLookedAt = false;
        {
            const Translation translation({language});
            MainWindow::Options options;
            options.smoothEdges = false;
            options.remembers = false;
            MainWindow window(options);
            window.session().openBundledScene();
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMilliseconds)
                    && QTest::qWaitFor([&] { return window.view().isReady(); }, kPatienceMilliseconds));
            QStringList all;
            for (const QSize &size : sizes) {
                window.resize(size);
                settle(10);
                // Windows makes no window larger than the screen.
                if (window.size() != size
                    && !QRect(QPoint(), window.screen()->size()).contains(QRect(QPoint(), size))) {
                    qInfo("The screen has no room for %d x %d.", size.width(), size.height());
                    continue;
                }
                wasLookedAt = true;
                // The tables of landmarks have more columns than a panel is wide.
                for (const char *place : {"click", "pipeline", "doctor"}) {
                    enter(window, place);
                    window.workspaces().reset(); // as it starts at this size
                    settle(10);
                    QStringList shown;
                    for (const QDockWidget *dock : window.findChildren<QDockWidget *>()) {
                        if (!dock->isHidden())
                            shown << dock->objectName();
                    }
                    QVERIFY(shown.size() >= 2);
                    QCOMPARE(window.size(), size);
                    const QSize viewSize = window.view().size();
                    // The view, with its pick in every space below it, has most of the window.
                    const int height = viewSize.height() + part<PickStrip>(window).height();
                    if (qstrcmp(place, "click") == 0 && size == QSize(1280, 800) && points <= 10)
                        QVERIFY2(viewSize.width() * height >= 0.55 * size.width() * size.height(),
                                 qPrintable(QStringLiteral("%1 x %2").arg(viewSize.width()).arg(viewSize.height())));
                    QSet<QString> looked;
                    QStringList faults = faultsOf(window, looked);
                    for (const QPointF &share : {QPointF(0.5, 0.55), QPointF(0.01, 0.01)}) {
                        click(window.view(), QPointF(share.x() * viewSize.width(), share.y() * viewSize.height()));
                        settle(10);
                        faults += faultsOf(window, looked);
                        QCOMPARE(window.view().size(), viewSize);
                    }
                    // Tabs behind others count as well.
                    for (const QDockWidget *dock : window.findChildren<QDockWidget *>()) {
                        if (dock->isHidden() || window.workspaces().isFront(*dock))
                            continue;
                        window.workspaces().show(panelNamed(dock->objectName()));
                        QTest::qWait(1);
                        faults += faultsOf(window, looked);
                        QCOMPARE(window.view().size(), viewSize);
                    }
                    if (size.width() > kLeast.width())
                        QCOMPARE(looked, (QSet<QString>(shown.begin(), shown.end())));
                    faults.removeDuplicates();
                    for (const QString &fault : std::as_const(faults))
                        all << QStringLiteral("%1 x %2, %3").arg(size.width()).arg(size.height()).arg(fault);
                }
            }
            QVERIFY2(all.isEmpty(), qPrintable(all.join(QStringLiteral("\n"))));
        }
        QApplication::setFont(before);
        if (!wasLookedAt)
            QSKIP("the screen has no room for any of the sizes");
    }
};

UNPROJECTOR_TEST(TestWindowGrid, layout, display, at 1.25, at 1.5, at 2, fonts)
#include "test_window_grid.moc"
