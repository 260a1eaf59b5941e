#include "gui/shell/language_menu.h"

#include "gui/shell/overlay_bars.h"
#include "gui/text/translation.h"
#include "gui/window/actions.h"
#include "gui/window/window.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>

#include <algorithm>

namespace unprojector::gui {
namespace {

/// The texts of the menu.
struct LanguageMenu {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::LanguageMenu)
};

QString whereToGetFont()
{
#ifdef Q_OS_WIN
    return LanguageMenu::tr("Add Chinese in Settings > Time & Language > Language.");
#else
    return LanguageMenu::tr("Install one, such as the package fonts-noto-cjk of Debian and Ubuntu.");
#endif
}

} // namespace

QString missingFontText()
{
    return LanguageMenu::tr(
               "The program speaks Chinese, but no font here has its characters. %1 Then start the program again.")
        .arg(whereToGetFont());
}

void tellOfFont(Window &window, const Translation &translation)
{
    const QString key = QStringLiteral("window/fontHintIsShown");
    if (!window.remembers() || !translation.lacksFont() || QSettings().value(key, false).toBool())
        return;
    window.showMessage(missingFontText());
    QSettings().setValue(key, true);
}

void fillLanguageMenu(QMenu &menu, Window &window, const Translation &translation, MessageBar &messages)
{
    auto *group = new QActionGroup(&menu);
    menu.setToolTipsVisible(true); // they say why there is no Chinese
    const Language kept = keptLanguage();
    const auto add = [&](Language language, const QString &text, const QString &whatComes) {
        QAction *action = addAction(menu, text, {}, whatComes, [&window, &messages, group, language, whatComes] {
            keepLanguage(language);
            const QString shown = messages.isHidden() ? QString() : messages.text();
            const QList<QAction *> choices = group->actions();
            const bool isOfLanguage = std::any_of(choices.begin(), choices.end(), [&shown](const QAction *choice) {
                return choice->statusTip() == shown || choice->toolTip() == shown;
            });
            if (shown.isEmpty() || isOfLanguage)
                window.showMessage(whatComes);
            else // the file has not been read yet
                window.statusBar()->showMessage(whatComes);
        });
        action->setCheckable(true);
        action->setActionGroup(group);
        action->setChecked(language == kept);
        return action;
    };
    add(Language::System, LanguageMenu::tr("&System"),
        LanguageMenu::tr("The program uses the language of the desktop when it starts next time."));
    // Each name is in its own language, so that its readers find it.
    add(Language::English, QStringLiteral("&English"),
        QStringLiteral("The program uses English when it starts next time."));
    QAction *chinese =
        add(Language::Chinese, QStringLiteral("简体中文(&C)"), QStringLiteral("程序下次启动时使用简体中文。"));
    if (!translation.hasHanzi()) {
        chinese->setEnabled(false);
        chinese->setText(QStringLiteral("&Chinese, simplified"));
        chinese->setToolTip(LanguageMenu::tr("No font here has Chinese characters. %1 Then start the program again.")
                                .arg(whereToGetFont()));
    }
}

} // namespace unprojector::gui
