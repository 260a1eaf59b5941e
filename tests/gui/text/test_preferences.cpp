// The dialog of the settings that last from one start to the next, and the menu's Copy.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/text/language_user.h"

#include "gui/document/picks.h"
#include "gui/lessons/first_steps.h"
#include "gui/shell/appearance.h"
#include "gui/shell/preferences_dialog.h"
#include "gui/text/number_text.h"
#include "tests/support/patience.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QSettings>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace guitest;

namespace {

PreferencesDialog *opened(MainWindow &window)
{
    actionOf(window, QStringLiteral("Preferences…"))->trigger();
    return window.findChild<PreferencesDialog *>();
}

QComboBox *boxNamed(const QWidget &dialog, const char *name)
{
    for (QComboBox *box : dialog.findChildren<QComboBox *>()) {
        if (box->accessibleName() == QLatin1String(name))
            return box;
    }
    return nullptr;
}

void choose(QComboBox &box, int index)
{
    box.setCurrentIndex(index);
    emit box.activated(index);
}

void press(const QWidget &dialog, const char *text)
{
    for (QPushButton *button : dialog.findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == QLatin1String(text)) {
            button->click();
            return;
        }
    }
    QFAIL(text);
}

} // namespace

class TestPreferences : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init() { QSettings().clear(); }
    void cleanup() { setAppearance(Appearance::Desktop); }

    void theFormShowsTheMenusChoices()
    {
        const Translation translation(QStringList{QStringLiteral("en")});
        const auto window = windowIn(translation, true);
        actionOf(*window, QStringLiteral("Dark"))->trigger();
        actionOf(*window, QStringLiteral("Smooth Edges"))->setChecked(false);
        const PreferencesDialog *dialog = opened(*window);
        QCOMPARE(boxNamed(*dialog, "Colours")->currentText(), QStringLiteral("Dark"));
        QCOMPARE(boxNamed(*dialog, "Colours")->count(), 3);
        QCOMPARE(boxNamed(*dialog, "Language")->currentText(), QStringLiteral("System"));
        QVERIFY(!dialog->findChild<QCheckBox *>()->isChecked());
    }

    void aChoiceCountsAtOnceAndLasts()
    {
        const Translation translation(QStringList{QStringLiteral("en")});
        const auto window = windowIn(translation, true);
        const PreferencesDialog *dialog = opened(*window);
        choose(*boxNamed(*dialog, "Colours"), 2);
        QVERIFY(currentAppearance() == Appearance::Dark);
        QCOMPARE(QSettings().value(QStringLiteral("window/appearance")).toString(), QStringLiteral("dark"));
        QVERIFY(actionOf(*window, QStringLiteral("Dark"))->isChecked());
        choose(*boxNamed(*dialog, "Language"), 1);
        QVERIFY(keptLanguage() == Language::English);
        QCheckBox *smooth = dialog->findChild<QCheckBox *>();
        smooth->toggle();
        QCOMPARE(window->hasSmoothEdges(), smooth->isChecked());
        QCOMPARE(actionOf(*window, QStringLiteral("Smooth Edges"))->isChecked(), smooth->isChecked());
    }

    void aWindowThatRemembersNothingAsksForNoLanguage()
    {
        const auto window = windowOfSize({1180, 760});
        const PreferencesDialog *dialog = opened(*window);
        QVERIFY(boxNamed(*dialog, "Colours"));
        QVERIFY(!boxNamed(*dialog, "Language"));
    }

    void theFirstStepsComeAgain()
    {
        const Translation translation(QStringList{QStringLiteral("en")});
        const auto window = windowIn(translation, true);
        emit window->findChild<FirstSteps *>()->closeRequested();
        QVERIFY(QSettings().value(QStringLiteral("firstSteps/areDone")).toBool());
        press(*opened(*window), "Show First Steps Again");
        QVERIFY(window->findChild<FirstSteps *>()->isVisible());
        QVERIFY(!QSettings().value(QStringLiteral("firstSteps/areDone")).toBool());
    }

    void theLayoutOfEveryWorkspaceIsReset()
    {
        const auto window = windowOfSize({1280, 800});
        window->workspaces().enter(Workspace::Pipeline);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "parameters"), kPatienceMilliseconds);
        dockOf(*window, "parameters")->toggleViewAction()->trigger();
        QVERIFY(dockOf(*window, "parameters")->isHidden());
        window->workspaces().enter(Workspace::Click);
        dockOf(*window, "comparison")->toggleViewAction()->trigger();
        press(*opened(*window), "Reset Layout");
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "comparison"), kPatienceMilliseconds);
        window->workspaces().enter(Workspace::Pipeline);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "parameters"), kPatienceMilliseconds);
    }

    void thePickIsCopiedFromTheMenu()
    {
        const auto window = windowOfSize({1280, 800});
        window->document().picks().clearPick();
        QAction *copy = window->findChild<QAction *>(QStringLiteral("copyPick"));
        QVERIFY(!copy->isEnabled());
        QVERIFY2(copy->toolTip().startsWith(QStringLiteral("There is no pick")), qPrintable(copy->toolTip()));
        window->view().pickPixel({300, 320});
        QVERIFY(copy->isEnabled());
        const std::optional<WorldPoint> point = window->document().picks().pickedPoint();
        QVERIFY(point.has_value());
        window->activateWindow();
        window->view().setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(window->view().hasFocus(), kPatienceMilliseconds);
        QTest::keyClick(&window->view(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(
            QGuiApplication::clipboard()->text(),
            QStringLiteral("%1, %2, %3").arg(shortestText(point->x), shortestText(point->y), shortestText(point->z)));
    }
};

UNPROJECTOR_TEST(TestPreferences, display)
#include "test_preferences.moc"
