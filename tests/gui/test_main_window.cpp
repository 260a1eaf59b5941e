// The window as a whole: its panels' arrangement at several sizes, what it keeps, and the examples it opens.

#include "gui_scene.h"

#include "core/scene/examples.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/scene_view.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTest>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

QDockWidget *dockOf(const MainWindow &window, const char *name)
{
    return window.findChild<QDockWidget *>(QLatin1String(name));
}

/// The action with this text (without its mnemonic) in any menu.
QAction *actionOf(const MainWindow &window, const QString &text)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (action->text().remove(u'&') == text)
            return action;
    }
    return nullptr;
}

std::unique_ptr<MainWindow> windowOfSize(const QSize &size, bool remembers = false)
{
    MainWindow::Options options;
    options.smoothEdges = false;
    options.remembers = remembers;
    auto window = std::make_unique<MainWindow>(options);
    if (!remembers)
        window->resize(size);
    window->session().openBundledScene();
    window->show();
    if (!QTest::qWaitForWindowExposed(window.get()) || !QTest::qWaitFor([&] { return window->view().isReady(); }))
        qFatal("the window does not come up");
    QTest::qWait(50);
    return window;
}

const char *const kPanels[] = {"parameters", "comparison", "pipeline", "inspector", "lifecycle"};

} // namespace

class TestMainWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void allPanelsStandBesideTheViewInALargeWindow();
    void theViewKeepsItsHalfOfASmallWindow();
    void theViewCanHaveTheWholeWindow();
    void theLayoutIsKeptAndCanBeReset();
    void everyExampleOpensWithItsNote();
    void theViewFromOutsideComesAndGoes();
    void anotherKindOfEdgesKeepsTheScene();
    void aChangeIsUndoneFromTheMenu();
};

void TestMainWindow::allPanelsStandBesideTheViewInALargeWindow()
{
    const auto window = windowOfSize({1280, 800});
    const SceneView &view = window->view();
    const auto leftOf = [&](const QWidget &widget) { return widget.mapTo(window.get(), QPoint(0, 0)).x(); };
    for (const char *name : {"parameters", "comparison", "inspector"})
        QVERIFY2(dockOf(*window, name)->isVisible() && !dockOf(*window, name)->visibleRegion().isEmpty(), name);
    QVERIFY(leftOf(*dockOf(*window, "parameters")) < leftOf(view));
    QVERIFY(leftOf(*dockOf(*window, "comparison")) > leftOf(view));
    QVERIFY(dockOf(*window, "inspector")->mapTo(window.get(), QPoint(0, 0)).y() > view.height());
    QCOMPARE(window->tabifiedDockWidgets(dockOf(*window, "comparison")),
             QList<QDockWidget *>{dockOf(*window, "pipeline")});
    QCOMPARE(window->tabifiedDockWidgets(dockOf(*window, "inspector")),
             QList<QDockWidget *>{dockOf(*window, "lifecycle")});
    QVERIFY(view.width() > 0.45 * window->width() && view.height() > 0.6 * window->height());
}

void TestMainWindow::theViewKeepsItsHalfOfASmallWindow()
{
    const auto window = windowOfSize({1000, 640});
    QVERIFY(2 * window->view().width() >= window->width());
    QVERIFY(2 * window->view().height() >= window->height());
    QVERIFY(!dockOf(*window, "inspector")->isVisible());
    QVERIFY(window->tabifiedDockWidgets(dockOf(*window, "comparison")).contains(dockOf(*window, "parameters")));
}

void TestMainWindow::theViewCanHaveTheWholeWindow()
{
    const auto window = windowOfSize({1280, 800});
    const int before = window->view().width();
    window->hidePanels(true);
    QTRY_COMPARE(window->view().width(), window->width());
    window->hidePanels(false);
    QTRY_COMPARE(window->view().width(), before);
}

void TestMainWindow::theLayoutIsKeptAndCanBeReset()
{
    {
        const auto window = windowOfSize({1280, 800}, true);
        dockOf(*window, "inspector")->hide();
        window->addDockWidget(Qt::LeftDockWidgetArea, dockOf(*window, "comparison"));
        window->close();
    }
    const auto window = windowOfSize({1280, 800}, true);
    QVERIFY(dockOf(*window, "inspector")->isHidden());
    QCOMPARE(window->dockWidgetArea(dockOf(*window, "comparison")), Qt::LeftDockWidgetArea);
    actionOf(*window, QStringLiteral("Reset Layout"))->trigger();
    QVERIFY(!dockOf(*window, "inspector")->isHidden());
    QCOMPARE(window->dockWidgetArea(dockOf(*window, "comparison")), Qt::RightDockWidgetArea);
    for (const char *name : kPanels)
        QVERIFY2(!dockOf(*window, name)->isFloating(), name);
}

void TestMainWindow::everyExampleOpensWithItsNote()
{
    const auto window = windowOfSize({1280, 800});
    QVERIFY(dockOf(*window, "example")->isHidden());
    for (const Example &example : examples()) {
        window->session().openExample(example.id);
        QCOMPARE(window->document().objects().size(), example.scene.objects.size());
        QVERIFY(!dockOf(*window, "example")->isHidden());
        QVERIFY(window->message().isEmpty());
        QVERIFY(!window->view().grabFramebuffer().isNull());
    }
    window->session().openBundledScene();
    QVERIFY(dockOf(*window, "example")->isHidden());
}

void TestMainWindow::theViewFromOutsideComesAndGoes()
{
    const auto window = windowOfSize({1280, 800});
    const int alone = window->view().width();
    QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
    action->trigger();
    QTRY_VERIFY(window->view().width() < 0.7 * alone);
    action->trigger();
    QTRY_COMPARE(window->view().width(), alone);
}

void TestMainWindow::anotherKindOfEdgesKeepsTheScene()
{
    const auto window = windowOfSize({1280, 800});
    click(window->view(), QPointF(window->view().width() / 2.0, window->view().height() / 2.0));
    const std::size_t objects = window->document().objects().size();
    const glm::dvec3 eye = window->document().scene().camera.eye.coordinates();
    actionOf(*window, QStringLiteral("Smooth Edges"))->trigger();
    QVERIFY(window->view().smoothEdges());
    QCOMPARE(window->document().objects().size(), objects);
    QVERIFY(window->document().scene().camera.eye.coordinates() == eye);
    QVERIFY(window->document().pick());
}

void TestMainWindow::aChangeIsUndoneFromTheMenu()
{
    const auto window = windowOfSize({1280, 800});
    const glm::dvec3 eye = window->document().scene().camera.eye.coordinates();
    actionOf(*window, QStringLiteral("Front"))->trigger();
    QVERIFY(window->document().scene().camera.eye.coordinates() != eye);
    QAction *undo = actionOf(*window, QStringLiteral("Undo Camera"));
    QVERIFY(undo && undo->isEnabled());
    undo->trigger();
    QVERIFY(window->document().scene().camera.eye.coordinates() == eye);
}

QTEST_MAIN(TestMainWindow)
#include "test_main_window.moc"
