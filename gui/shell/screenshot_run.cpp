#include "gui/shell/screenshot_run.h"

#include "core/base/replace_file.h"
#include "core/scene_file/clicks.h"
#include "gui/document/overwriting.h"
#include "gui/document/picks.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/view_resizer.h"
#include "gui/shell/start_window.h"
#include "gui/text/error_text.h"
#include "gui/text/print.h"
#include "gui/view/scene_view.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPixmap>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;
using namespace scene_file;
namespace {

constexpr int kAgainMilliseconds = 20;

std::optional<RayOnMesh> rayOf(const SceneDocument &document)
{
    const PickedRay *ray = document.picks().pickedRay();
    if (!ray || ray->state != PickedRay::State::Answered)
        return std::nullopt;
    RayOnMesh written{{}, {}, ray->edge, ray->edgeObject};
    if (ray->met) {
        written.hit = ray->met->hit;
        written.object = ray->met->objectName;
    }
    return written;
}

} // namespace

ScreenshotRun::ScreenshotRun(StartOptions options) : m_options(std::move(options)) {}

ScreenshotRun::~ScreenshotRun() = default;

void ScreenshotRun::start()
{
    const std::filesystem::path picture(m_options.picture->toStdU16String());
    const auto isPicture = [&](const std::filesystem::path &file) { return base::isSameFile(picture, file); };
    if (std::any_of(m_options.files.begin(), m_options.files.end(), isPicture)) {
        fail(tr("%1 is also opened and would be overwritten; give the image another name.").arg(*m_options.picture));
        return;
    }
    MainWindow::Options options;
    options.smoothEdges = m_options.smoothEdges;
    options.remembers = false;
    m_window = std::make_unique<MainWindow>(options);
    if (m_options.clicks.empty())
        m_window->document().picks().rayCasters().waitUntilAsked();
    connect(m_window.get(), &MainWindow::openFailed, this, &ScreenshotRun::fail);
    const auto finish = [this] { QTimer::singleShot(0, this, &ScreenshotRun::pressAndSave); };
    connect(&m_window->session(), &Session::loadingEnded, this, finish);
    // The window is laid out and drawn only into the image: the run waits for no screen, and no
    // window flashes up.
    m_window->setAttribute(Qt::WA_DontShowOnScreen);
    if (const QString mistake = startWindow(*m_window, m_options); !mistake.isEmpty())
        fail(mistake);
    else if (!m_window->session().isLoading())
        finish();
}

void ScreenshotRun::fail(const QString &reason)
{
    if (m_hasEnded)
        return;
    m_hasEnded = true;
    printMessage(reason);
    emit ended(2);
}

QString ScreenshotRun::savePicture()
{
    // Labels grow with the clicks' texts and push other widgets down. A growing layout notifies its
    // parent, level by level.
    constexpr int kLevels = 8;
    for (int level = 0; level < kLevels; ++level)
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    // The image is encoded first: a name without an image format must not overwrite its file.
    QByteArray bytes;
    QBuffer buffer(&bytes);
    const QByteArray format = QFileInfo(*m_options.picture).suffix().toLatin1();
    // PNG is lossless at any quality: this one takes a quarter of the time, and a few more bytes.
    const int quality = format.toLower() == "png" ? 75 : -1;
    if (!m_window->grab().save(&buffer, format.constData(), quality))
        return tr("%1 is not an image name; end it with .png.").arg(*m_options.picture);
    const std::filesystem::path file(m_options.picture->toStdU16String());
    if (QString refusal = overwritingText(m_window->document(), m_window->session(), file); !refusal.isEmpty())
        return refusal;
    const base::Done written = base::replaceFile(file, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return written ? QString() : *m_options.picture + ": " + QString::fromStdString(written.error().text);
}

void ScreenshotRun::pressAndSave()
{
    if (m_hasEnded)
        return;
    if (!m_window->findChild<ViewResizer *>()->isSettled()) {
        QTimer::singleShot(kAgainMilliseconds, this, &ScreenshotRun::pressAndSave);
        return;
    }
    if (m_options.viewSize && m_window->view().size() != *m_options.viewSize) {
        if (std::exchange(m_isSized, true)) {
            fail(tr("The view is %1 × %2 logical pixels, not %3 × %4: the window cannot have that size here. Try "
                    "--no-panels.")
                     .arg(m_window->view().width())
                     .arg(m_window->view().height())
                     .arg(m_options.viewSize->width())
                     .arg(m_options.viewSize->height()));
            return;
        }
        m_window->setViewSize(*m_options.viewSize);
        QTimer::singleShot(0, this, &ScreenshotRun::pressAndSave);
        return;
    }
    // Clicks and the visibility of landmarks need rays.
    if (!m_options.clicks.empty() || !m_window->document().landmarks().empty())
        m_window->document().picks().rayCasters().complete(m_window->document().objects());
    m_window->document().curves().complete();
    std::vector<Click> clicks;
    for (const WidgetPoint &position : m_options.clicks) {
        SceneView &view = m_window->view();
        SceneDocument &document = m_window->document();
        const Result<DevicePixel> pixel = devicePixelFromWidget(document.setup().surface, position);
        if (!pixel) {
            fail(tr("The click %1,%2 lies outside the view, which is %3 × %4 logical pixels.")
                     .arg(position.x)
                     .arg(position.y)
                     .arg(view.surfaceRect().width())
                     .arg(view.surfaceRect().height()));
            return;
        }
        document.picks().clearPick();
        view.onLButtonDown(position);
        if (!document.picks().pick()) {
            fail(tr("The click %1,%2 could not be read.").arg(position.x).arg(position.y));
            return;
        }
        clicks.push_back(clickOf(*document.picks().pick(), document.scene(), rayOf(document)));
    }
    const base::Expected<std::string, base::Error> text = clicksText(clicks);
    if (!text) {
        fail(QString::fromStdString(text.error().message()));
        return;
    }
    if (const QString problem = savePicture(); !problem.isEmpty()) {
        fail(problem);
        return;
    }
    if (const std::string problem = print(*text); !problem.empty()) {
        fail(tr("The clicks could not be written to standard output: %1.").arg(QString::fromStdString(problem)));
        return;
    }
    m_hasEnded = true;
    m_window->setUpdatesEnabled(false); // further drawing would be invisible
    emit ended(0);
}

} // namespace unprojector::gui
