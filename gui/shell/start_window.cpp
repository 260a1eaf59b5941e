#include "gui/shell/start_window.h"

#include "gui/lessons/lesson_player.h"
#include "gui/shell/main_window.h"
#include "gui/shell/start_options.h"

namespace unprojector::gui {

QString startWindow(MainWindow &window, const StartOptions &options)
{
    if (options.windowSize)
        window.resize(*options.windowSize);
    if (options.workspace)
        window.workspaces().enter(*options.workspace);
    if (!options.hasPanels)
        window.workspaces().hidePanels(true);
    if (options.files.empty())
        window.session().openBundledScene();
    else
        window.session().openFiles(options.files);
    window.session().offerRecovery();
    window.show();
    if (options.lesson) {
        if (QString mistake = window.findChild<LessonPlayer *>()->startAt(*options.lesson); !mistake.isEmpty())
            return mistake;
    }
    if (options.viewSize)
        window.setViewSize(*options.viewSize);
    return {};
}

} // namespace unprojector::gui
