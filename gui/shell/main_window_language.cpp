// The menu of languages, and what is missing to show one of them.

#include "gui/shell/main_window.h"
#include "gui/shell/overlay_bars.h"
#include "gui/text/translation.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>

#include <algorithm>

namespace unprojector::gui {
namespace {

QString whereToGetFont()
{
#ifdef Q_OS_WIN
    return MainWindow::tr("Add Chinese in Settings > Time & Language > Language.");
#else
    return MainWindow::tr("Install one, such as the package fonts-noto-cjk of Debian and Ubuntu.");
#endif
}

} // namespace

QString missingFontText()
{
    return MainWindow::tr(
               "The program speaks Chinese, but no font here has its characters. %1 Then start the program again.")
        .arg(whereToGetFont());
}

void MainWindow::createLanguageMenu(QMenu &menu)
{
    auto *group = new QActionGroup(&menu);
    menu.setToolTipsVisible(true); // they say why there is no Chinese
    const Language kept = keptLanguage();
    const auto add = [&](Language language, const QString &text, const QString &whatComes) {
        QAction *action = addAction(&menu, text, {}, whatComes, [this, group, language, whatComes] {
            keepLanguage(language);
            const QList<QAction *> choices = group->actions();
            const bool isOfLanguage = std::any_of(choices.begin(), choices.end(), [this](const QAction *choice) {
                return choice->statusTip() == message() || choice->toolTip() == message();
            });
            if (message().isEmpty() || isOfLanguage)
                m_message->showMessage(whatComes);
            else // which has not been read yet
                statusBar()->showMessage(whatComes);
        });
        action->setCheckable(true);
        action->setActionGroup(group);
        action->setChecked(language == kept);
        return action;
    };
    add(Language::System, tr("&System"), tr("The program uses the language of the desktop when it starts next time."));
    // Each name is in its own language, so that its readers find it.
    add(Language::English, QStringLiteral("&English"),
        QStringLiteral("The program uses English when it starts next time."));
    QAction *chinese =
        add(Language::Chinese, QStringLiteral("简体中文(&C)"), QStringLiteral("程序下次启动时使用简体中文。"));
    if (!m_options.translation->hasHanzi()) {
        chinese->setEnabled(false);
        chinese->setText(QStringLiteral("&Chinese, simplified"));
        chinese->setToolTip(
            tr("No font here has Chinese characters. %1 Then start the program again.").arg(whereToGetFont()));
    }
}

void MainWindow::tellOfFont()
{
    const QString key = QStringLiteral("window/fontHintIsShown");
    if (!m_options.remembers || !m_options.translation || !m_options.translation->lacksFont() || !message().isEmpty()
        || QSettings().value(key, false).toBool())
        return;
    m_message->showMessage(missingFontText());
    QSettings().setValue(key, true);
}

} // namespace unprojector::gui
