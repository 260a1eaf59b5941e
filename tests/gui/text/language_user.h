#pragma once

#include "tests/gui/window_user.h"

#include "gui/text/translation.h"
#include "gui/view/scene_view.h"

#include <memory>

/// Actions on the window that the tests of the language share.
namespace guitest {

/// A window on the bundled scene, with a pick.
inline std::unique_ptr<unprojector::gui::MainWindow> windowIn(const unprojector::gui::Translation &translation,
                                                              bool remembers = false)
{
    unprojector::gui::MainWindow::Options options;
    options.smoothEdges = false;
    options.remembers = remembers;
    options.translation = &translation;
    auto window = std::make_unique<unprojector::gui::MainWindow>(options);
    window->resize(1180, 760);
    window->session().openBundledScene();
    bringUp(*window);
    window->view().pickPixel({300, 320});
    return window;
}

} // namespace guitest
