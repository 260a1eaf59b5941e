// The "?" button of each panel, and the equivalent key.

#include "tests/support/test.h"

#include "tests/gui/window_user.h"

#include "gui/lessons/manual_window.h"
#include "gui/text/help_anchors.h"

#include <QLineEdit>
#include <QTabBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>

namespace unprojector::gui {
using namespace guitest;
namespace {

/// The visible "?" of a panel: in its title bar or beside its tab.
QToolButton *helpOf(const MainWindow &window, const QDockWidget &dock)
{
    for (QToolButton *button : window.findChildren<QToolButton *>(QStringLiteral("manualOfPanel"))) {
        const auto *tabs = qobject_cast<QTabBar *>(button->parentWidget());
        const bool isOwn =
            button->parentWidget() == &dock || (tabs && tabs->tabText(tabs->currentIndex()) == dock.windowTitle());
        if (isOwn && button->isVisible())
            return button;
    }
    return nullptr;
}

QString placeShown(const MainWindow &window)
{
    auto *manual = window.findChild<ManualWindow *>();
    if (!manual || !manual->isVisible())
        return {};
    const QString name = manual->currentPage().name + QStringLiteral(".md");
    const QTreeWidgetItem *item = manual->contents().currentItem();
    return item->parent() ? name + u'#' + headingSlug(item->text(0)) : name;
}

} // namespace

class TestPanelHelp : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void everyPanelOpensItsPage()
    {
        const auto window = windowOfSize({1600, 1000});
        for (int id = 0; id <= static_cast<int>(Panel::Lesson); ++id) {
            const auto panel = static_cast<Panel>(id);
            window->workspaces().show(panel);
            settle();
            const QDockWidget &dock = window->workspaces().dock(panel);
            QVERIFY2(window->workspaces().isFront(dock), nameOf(panel));
            QToolButton *button = helpOf(*window, dock);
            QVERIFY2(button, nameOf(panel));
            QVERIFY2(button->parentWidget()->rect().contains(button->geometry()), nameOf(panel));
            QVERIFY2(button->accessibleName().contains(dock.windowTitle()), nameOf(panel));
            QVERIFY(!button->toolTip().isEmpty() && (button->focusPolicy() & Qt::TabFocus));
            QTest::keyClick(button, Qt::Key_Space);
            QCOMPARE(placeShown(*window), manualPlaceOf(panel));
        }
    }

    void theFrontTabHasIt()
    {
        const auto window = windowOfSize({1280, 800});
        const QDockWidget &comparison = window->workspaces().dock(Panel::Comparison),
                          &objects = window->workspaces().dock(Panel::Objects);
        QVERIFY(helpOf(*window, comparison) && !helpOf(*window, objects));
        auto *tabs = qobject_cast<QTabBar *>(helpOf(*window, comparison)->parentWidget());
        QVERIFY(tabs);
        tabs->setCurrentIndex(1 - tabs->currentIndex()); // like a click on the other tab
        QVERIFY(!helpOf(*window, comparison));
        QToolButton *button = helpOf(*window, objects);
        QVERIFY(button && button->accessibleName().contains(objects.windowTitle()));
        button->click();
        QCOMPARE(placeShown(*window), manualPlaceOf(Panel::Objects));
    }

    void aFullRowOfTabsKeepsItsRoom()
    {
        const auto window = windowOfSize({640, 480});
        for (const Workspace workspace : {Workspace::Click, Workspace::Pipeline, Workspace::Doctor}) {
            window->workspaces().enter(workspace);
            settle();
            for (const QToolButton *button : window->findChildren<QToolButton *>(QStringLiteral("manualOfPanel"))) {
                const auto *tabs = qobject_cast<QTabBar *>(button->parentWidget());
                for (int tab = 0; tabs && button->isVisible() && tab < tabs->count(); ++tab)
                    QVERIFY2(!tabs->tabRect(tab).intersects(button->geometry()), qPrintable(tabs->tabText(tab)));
            }
        }
    }

    void theKeyOpensThePageOfThePanelWithTheFocus_data()
    {
        addColumn<Workspace>("workspace");
        addColumn<QString>("focused");
        addColumn<Panel>("panel");
        newRow("a field") << Workspace::Pipeline << "parameters" << Panel::Parameters;
        newRow("the view in Pipeline") << Workspace::Pipeline << QString() << Panel::Pipeline;
        newRow("the view in Click") << Workspace::Click << QString() << Panel::Comparison;
    }

    void theKeyOpensThePageOfThePanelWithTheFocus()
    {
        QFETCH(Workspace, workspace);
        QFETCH(QString, focused);
        QFETCH(Panel, panel);
        const auto window = windowOfSize({1280, 800});
        window->workspaces().enter(workspace);
        settle();
        QWidget *focus = &window->view();
        if (!focused.isEmpty())
            focus = dockOf(*window, qPrintable(focused))->findChild<QLineEdit *>();
        focus->setFocus();
        QAction *action = actionOf(*window, QStringLiteral("Manual of This Panel"));
        QCOMPARE(action->shortcut(), QKeySequence(Qt::SHIFT | Qt::Key_F1));
        action->trigger(); // the key needs an active window, hence a window manager
        QCOMPARE(placeShown(*window), manualPlaceOf(panel));
    }

    void theMenuOpensTheManual()
    {
        const auto window = windowOfSize({700, 500});
        actionOf(*window, QStringLiteral("Manual"))->trigger();
        QCOMPARE(placeShown(*window), QStringLiteral("index.md"));
        QVERIFY(!window->findChild<ManualWindow *>()->isModal());
    }
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestPanelHelp, display)
#include "test_panel_help.moc"
