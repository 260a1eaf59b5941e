#pragma once

#include "gui/lessons/lesson_panel.h"
#include "gui/view/scene_view.h"
#include "tests/gui/window_user.h"

#include <QEventLoop>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QTextBrowser>
#include <QTimer>

#include <algorithm>
#include <optional>

/// Actions on the window that the tests of lessons share.
namespace guitest {

inline constexpr QSize kWide(1280, 800);
inline constexpr QSize kLow(1280, 600); ///< a screen that is not high either has room for more

/// Waits until the window has made its last check of the view's size and panels are laid out. It
/// uses a timer of its own, which is late whenever the window's is.
inline void settle(unprojector::gui::MainWindow &window)
{
    constexpr int kLooks = 8; // more, and later ones, than the window's
    constexpr int kMilliseconds = 50;
    for (int look = 0; look < kLooks; ++look) {
        QEventLoop loop;
        QTimer::singleShot(kMilliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
        loop.exec();
        QCoreApplication::sendPostedEvents();
        window.layout()->activate();
    }
}

/// The height of a view that the window has to grow for, in a lesson; empty where the screen has no
/// room for it.
inline std::optional<int> heightToGrowFor(unprojector::gui::MainWindow &window)
{
    constexpr int kMost = 900;
    const int place = window.view().parentWidget()->height();
    const int beside = window.frameGeometry().height() - place;
    const int height = std::min(kMost, window.screen()->availableSize().height() - beside);
    return height > place ? std::optional(height) : std::nullopt;
}

inline unprojector::gui::LessonPanel &panelOf(unprojector::gui::MainWindow &window)
{
    return *window.findChild<unprojector::gui::LessonPanel *>();
}

inline void follow(unprojector::gui::MainWindow &window, const QString &link)
{
    emit panelOf(window).findChild<QTextBrowser *>()->anchorClicked(QUrl(link));
}

inline QPushButton *buttonOf(unprojector::gui::MainWindow &window, const QString &text)
{
    for (QPushButton *button : panelOf(window).findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == text)
            return button;
    }
    return nullptr;
}

/// The panel's verdict on an answer or on the picture: the label with this name or with a link.
inline QString verdictOf(unprojector::gui::MainWindow &window)
{
    for (const QLabel *label : panelOf(window).findChildren<QLabel *>()) {
        if (label->accessibleName() == QStringLiteral("Verdict on your answer"))
            return label->textFormat() == Qt::PlainText ? label->text() : QStringLiteral("markup");
    }
    return {};
}

inline QLabel *hintOf(unprojector::gui::MainWindow &window)
{
    for (QLabel *label : panelOf(window).findChildren<QLabel *>()) {
        if (label->text().contains(QLatin1String("<a href=")))
            return label;
    }
    return nullptr;
}

inline void answer(unprojector::gui::MainWindow &window, const QString &text)
{
    auto *field = panelOf(window).findChild<QLineEdit *>();
    field->setText(text);
    QTest::keyClick(field, Qt::Key_Return);
}

} // namespace guitest
