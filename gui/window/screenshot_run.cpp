#include "gui/window/screenshot_run.h"

#include "core/scene_file/pick_json.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"
#include "gui/view/scene_view.h"

#include <QPixmap>
#include <QTimer>

#include <cstdio>

namespace unprojector::gui {
using namespace scene_file;

ScreenshotRun::ScreenshotRun(Request request) : m_request(std::move(request)) {}

ScreenshotRun::~ScreenshotRun() = default;

void ScreenshotRun::start()
{
    MainWindow::Options options;
    options.samples = m_request.samples;
    options.remembers = false;
    m_window = std::make_unique<MainWindow>(options);
    connect(m_window.get(), &MainWindow::openFailed, this, &ScreenshotRun::fail);
    m_window->resize(m_request.windowSize);
    if (m_request.files.empty())
        m_window->openBundledScene();
    else
        m_window->openFiles(m_request.files);

    // A picture that was composed after the loading ended is one that shows the model at its final size.
    connect(&m_window->view(), &SceneView::frameSwapped, this, [this] {
        if (!m_window->isLoading())
            QTimer::singleShot(0, this, &ScreenshotRun::pressAndSave);
    });
    connect(m_window.get(), &MainWindow::loadingEnded, this, [this] { m_window->view().update(); });
    m_window->show();
}

void ScreenshotRun::fail(const QString &reason)
{
    if (m_hasEnded)
        return;
    m_hasEnded = true;
    std::fprintf(stderr, "unprojector: %s\n", reason.toLocal8Bit().constData());
    emit ended(2);
}

void ScreenshotRun::pressAndSave()
{
    if (m_hasEnded)
        return;
    nlohmann::ordered_json clicks = nlohmann::ordered_json::array();
    for (const WidgetPoint &position : m_request.clicks) {
        SceneView &view = m_window->view();
        SceneDocument &document = m_window->document();
        const Result<DevicePixel> pixel = devicePixelFromWidget(document.geometry().surface, position);
        if (!pixel) {
            fail(tr("The click %1,%2 lies outside the view, which is %3 × %4 logical pixels.")
                     .arg(position.x)
                     .arg(position.y)
                     .arg(view.width())
                     .arg(view.height()));
            return;
        }
        document.clearPick();
        view.onLButtonDown(position);
        if (!document.pick()) {
            fail(tr("The click %1,%2 could not be read.").arg(position.x).arg(position.y));
            return;
        }
        clicks.push_back(toJson(*document.pick()));
    }
    if (!m_window->grab().save(m_request.picture)) {
        fail(tr("%1 could not be written. Check the folder, and that the name ends in .png.").arg(m_request.picture));
        return;
    }
    m_hasEnded = true;
    const std::string text = clicks.dump(2) + '\n';
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
    emit ended(0);
}

} // namespace unprojector::gui
