#pragma once

#include "window_user.h"

#include "gui/text/translation.h"
#include "gui/view/scene_view.h"

#include <memory>

/// What the tests of the language do with the window.
namespace guitest {

inline constexpr QSize kSize(1180, 760), kViewSize(600, 480);
inline constexpr DevicePixel kPixel{300, 320};

/// A window on the bundled scene, with a pick.
inline std::unique_ptr<MainWindow> windowIn(Translation &translation, bool remembers = false)
{
    MainWindow::Options options;
    options.smoothEdges = false;
    options.remembers = remembers;
    options.translation = &translation;
    auto window = std::make_unique<MainWindow>(options);
    window->resize(kSize);
    window->session().openBundledScene();
    bringUp(*window);
    window->view().pickPixel(kPixel);
    return window;
}

inline void choose(MainWindow &window, const QString &language)
{
    actionOf(window, language)->trigger();
    QCoreApplication::sendPostedEvents();
    settle();
}
inline void chooseChinese(MainWindow &window)
{
    choose(window, QStringLiteral("简体中文(C)"));
}
inline void chooseEnglish(MainWindow &window)
{
    choose(window, QStringLiteral("English"));
}

} // namespace guitest
