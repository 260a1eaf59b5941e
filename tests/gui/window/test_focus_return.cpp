// The keyboard focus after controls that were used by mouse, and messages in the status bar.

#include "tests/support/test.h"

#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/landmarks_table.h"
#include "gui/landmarks/scan_series.h"
#include "gui/landmarks/series_panel.h"
#include "gui/shell/overlay_bars.h"
#include "gui/shell/status_bar.h"
#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QFile>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>
#include <QTreeView>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace guitest;

namespace {

QToolButton *buttonNamed(const QWidget &widget, const char *text)
{
    for (QToolButton *button : widget.findChildren<QToolButton *>()) {
        if (button->text().remove(u'&') == QString::fromUtf8(text))
            return button;
    }
    return nullptr;
}

QPoint upArrowOf(const QSpinBox &box)
{
    QStyleOptionSpinBox option;
    option.initFrom(&box);
    option.subControls = QStyle::SC_All;
    option.buttonSymbols = box.buttonSymbols();
    option.frame = box.hasFrame();
    return box.style()->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxUp, &box).center();
}

} // namespace

class TestFocusReturn : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    /// A series of two scans, with both panels in the window.
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        for (const char *name : {"a.obj", "b.obj"}) {
            QFile out(m_folder->filePath(QLatin1String(name)));
            QVERIFY(out.open(QIODevice::WriteOnly));
            QVERIFY(out.write("v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nf 1 3 4\n") > 0);
        }
        m_window = windowOfSize({1280, 800});
        QVERIFY(part<ScanSeries>(*m_window).open(m_folder->path().toStdU16String()));
        QTRY_COMPARE_WITH_TIMEOUT(m_window->document().objects().size(), std::size_t(1), kPatienceMilliseconds);
        m_window->workspaces().show(Panel::Landmarks);
        m_window->workspaces().show(Panel::Series);
        landmarks::Landmark first, second;
        first.name = "first";
        first.world = WorldPoint(1.0, 2.0, 0.0);
        second.name = "second";
        second.world = WorldPoint(3.0, 2.0, 0.0);
        QVERIFY(editLandmarks(m_window->document(), {first, second}, {QStringLiteral("put")}));
        m_window->document().sceneLandmarks().select({0, 1});
        settle();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kPatienceMilliseconds));
    }

    void cleanup() { m_window.reset(); }

    void aSpinBoxsArrowLeavesKeysToTheView()
    {
        QTest::mouseClick(&placing(), Qt::LeftButton, {}, upArrowOf(placing()));
        QCOMPARE(placing().value(), 2);
        QVERIFY(viewGetsFocus());
        const LookAt camera = m_window->document().scene().camera;
        QTest::keyClick(m_window->focusWidget(), Qt::Key_3);
        QVERIFY(m_window->document().scene().camera != camera); // from the right
        QCOMPARE(part<ScanSeries>(*m_window).placing(), 2);
    }

    void aFieldKeepsTheFocusUntilEnter_data()
    {
        addColumn<Qt::Key>("key");
        addColumn<int>("placing");
        newRow("Enter") << Qt::Key_Return << 3;
        newRow("Enter of the keypad") << Qt::Key_Enter << 3;
        newRow("Esc") << Qt::Key_Escape << -1;
    }

    void aFieldKeepsTheFocusUntilEnter()
    {
        QFETCH(Qt::Key, key);
        QFETCH(int, placing);
        auto *field = this->placing().findChild<QLineEdit *>();
        QTest::mouseDClick(field, Qt::LeftButton);
        this->placing().setFocus(Qt::MouseFocusReason);
        settle();
        QVERIFY(this->placing().hasFocus());
        this->placing().selectAll();
        QTest::keyClick(&this->placing(), Qt::Key_3);
        settle();
        QVERIFY(this->placing().hasFocus());
        QTest::keyClick(&this->placing(), key);
        QVERIFY(viewGetsFocus());
        if (placing > 0)
            QCOMPARE(part<ScanSeries>(*m_window).placing(), placing);
    }

    void buttonsGiveTheFocusBack()
    {
        QToolButton *next = buttonNamed(part<SeriesPanel>(*m_window), "Next");
        next->setFocus(Qt::MouseFocusReason);
        QTest::mouseClick(next, Qt::LeftButton); // the last scan: the button is disabled then
        QTRY_COMPARE_WITH_TIMEOUT(m_window->document().objects()[0].name, std::string("b.obj"), kPatienceMilliseconds);
        QVERIFY(viewGetsFocus());
        m_window->document().sceneLandmarks().selectOnly(0);
        QToolButton *down = buttonNamed(*dockOf(*m_window, "points"), "Down");
        QVERIFY(down && down->isEnabled());
        down->setFocus(Qt::MouseFocusReason);
        QTest::mouseClick(down, Qt::LeftButton);
        QVERIFY(viewGetsFocus());
        // A message over the view.
        m_window->showMessage(QStringLiteral("A message"));
        auto *bar = m_window->findChild<MessageBar *>();
        placing().setFocus();
        QTest::mouseClick(buttonNamed(*bar, "×"), Qt::LeftButton);
        QVERIFY(viewGetsFocus());
    }

    void aButtonReachedByTabKeepsIt()
    {
        QAbstractButton *sides = nullptr;
        for (QAbstractButton *button : dockOf(*m_window, "points")->findChildren<QAbstractButton *>()) {
            if (button->text() == QLatin1String("Left and Right"))
                sides = button;
        }
        QVERIFY(sides && !sides->isChecked());
        sides->setFocus(Qt::TabFocusReason);
        QTest::keyClick(sides, Qt::Key_Space);
        settle();
        QVERIFY(sides->isChecked() && sides->hasFocus());
        QTest::mouseClick(sides, Qt::LeftButton);
        QVERIFY(viewGetsFocus());
    }

    void menusAndComboBoxesGiveItBack()
    {
        auto *unit = dockOf(*m_window, "points")->findChild<QComboBox *>();
        QVERIFY(unit && unit->isVisible());
        unit->setFocus(Qt::MouseFocusReason);
        unit->showPopup();
        settle();
        QVERIFY(!hasView());
        QTest::keyClick(unit->view(), Qt::Key_Down);
        QTest::keyClick(unit->view(), Qt::Key_Return);
        QVERIFY(viewGetsFocus());
        QVERIFY(!m_window->document().scene().landmarks.unit.empty());

        QToolButton *names = buttonNamed(*dockOf(*m_window, "points"), "Template");
        names->setFocus(Qt::MouseFocusReason);
        QTimer::singleShot(100, names, [names] { names->menu()->close(); });
        names->showMenu();
        QVERIFY(viewGetsFocus());
    }

    void listsKeepItForArrowsUntilEscape()
    {
        auto *table = m_window->findChild<LandmarksTable *>();
        const QRect row = table->visualRect(table->model()->index(0, 1));
        table->setFocus(Qt::MouseFocusReason);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, row.center());
        settle();
        QVERIFY(table->hasFocus());
        QTest::keyClick(table, Qt::Key_Down);
        QVERIFY(m_window->document().sceneLandmarks().current() == 1u);
        const LookAt camera = m_window->document().scene().camera;
        QTest::keyClick(table, Qt::Key_3);
        QVERIFY(m_window->document().scene().camera != camera); // a number is a view, not a row
        QTest::keyClick(table, Qt::Key_Escape);
        QVERIFY(viewGetsFocus());
    }

    void aDoubleClickedRowIsDone()
    {
        auto *scans = part<SeriesPanel>(*m_window).findChild<QTreeView *>();
        scans->setFocus(Qt::MouseFocusReason);
        const QPoint row = scans->visualRect(scans->model()->index(1, 0)).center();
        QTest::mouseClick(scans->viewport(), Qt::LeftButton, {}, row);
        QTest::mouseDClick(scans->viewport(), Qt::LeftButton, {}, row);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->document().objects()[0].name, std::string("b.obj"), kPatienceMilliseconds);
        QVERIFY(viewGetsFocus());
    }

    void anEditorOfANameKeepsIt()
    {
        auto *table = m_window->findChild<LandmarksTable *>();
        table->setFocus(Qt::MouseFocusReason);
        const QPoint row = table->visualRect(table->model()->index(0, 1)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, row);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, row);
        settle();
        auto *editor = table->viewport()->findChild<QLineEdit *>();
        QVERIFY(editor && editor->hasFocus());
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("bregma"));
        settle();
        QVERIFY(editor->hasFocus());
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->document().landmarks()[0].name, std::string("bregma"),
                                  kPatienceMilliseconds);
    }

    void theToolBarTakesItFromAField()
    {
        placing().setFocus(Qt::MouseFocusReason);
        auto *bar = m_window->findChild<QToolBar *>(QStringLiteral("tools"));
        auto *fit = qobject_cast<QToolButton *>(bar->widgetForAction(actionOf(*m_window, QStringLiteral("Fit"))));
        QVERIFY(fit);
        QTest::mouseClick(fit, Qt::LeftButton);
        QVERIFY(viewGetsFocus());
    }

    void longMessagesEndInDots()
    {
        auto *bar = qobject_cast<StatusBar *>(m_window->statusBar());
        QVERIFY(bar);
        const QString message = QString(QStringLiteral("The file has a name. ")).repeated(30);
        m_window->notice(message);
        settle();
        QCOMPARE(bar->currentMessage(), message);
        QVERIFY(bar->shownMessage().endsWith(QChar(0x2026)));
        QVERIFY(bar->messageRoom().width() > bar->width() / 3);
        QVERIFY(bar->fontMetrics().horizontalAdvance(bar->shownMessage()) <= bar->messageRoom().width());
        for (const QWidget *widget : bar->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly))
            QVERIFY(widget->isHidden() || !widget->geometry().intersects(bar->messageRoom()));
        const auto tip = [bar] {
            QToolTip::hideText();
            QHelpEvent help(QEvent::ToolTip, bar->messageRoom().center(),
                            bar->mapToGlobal(bar->messageRoom().center()));
            QCoreApplication::sendEvent(bar, &help);
            return QToolTip::text();
        };
        QVERIFY(tip().contains(message.trimmed()));
        m_window->notice(QStringLiteral("Short"));
        QCOMPARE(bar->shownMessage(), QStringLiteral("Short"));
        QVERIFY(!tip().contains(QStringLiteral("Short")));
    }

private:
    bool hasView() const { return m_window->focusWidget() == &m_window->view(); }
    /// Goes on once all consequences of a click are processed.
    bool viewGetsFocus() const
    {
        return QTest::qWaitFor([this] { return hasView(); }, kPatienceMilliseconds);
    }
    QSpinBox &placing() const { return *part<SeriesPanel>(*m_window).findChild<QSpinBox *>(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

UNPROJECTOR_TEST(TestFocusReturn, display)
#include "test_focus_return.moc"
