#include "gui/shell/series_pictures.h"

#include "core/base/replace_file.h"
#include "core/geometry/camera_motion.h"
#include "gui/document/camera_looks.h"
#include "gui/document/overwriting.h"
#include "gui/document/picks.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"
#include "gui/text/print.h"
#include "gui/view/scene_picture.h"
#include "gui/view/scene_view.h"
#include "gui/window/scan_list.h"

#include <QBuffer>
#include <QPixmap>
#include <QTimer>

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr QSize kMostTile(320, 240);
const QString kSheet = QStringLiteral("contact-sheet.png");

} // namespace

SeriesPictures::SeriesPictures(StartOptions options)
    : m_options(std::move(options)), m_folder(m_options.pictures->toStdU16String()),
      m_sheet(*m_options.windowSize, kMostTile)
{
}

SeriesPictures::~SeriesPictures() = default;

void SeriesPictures::start()
{
    std::error_code error;
    std::filesystem::create_directories(m_folder, error);
    if (!std::filesystem::is_directory(m_folder, error)) {
        fail(tr("%1 is not a folder and cannot be created. Give --screenshots another folder.")
                 .arg(*m_options.pictures));
        return;
    }
    MainWindow::Options options;
    options.smoothEdges = m_options.smoothEdges;
    options.remembers = false;
    m_window = std::make_unique<MainWindow>(options);
    m_window->setAttribute(Qt::WA_DontShowOnScreen); // as a screenshot run
    m_window->resize(*m_options.windowSize);
    m_window->workspaces().hidePanels(true);
    m_window->show();
    static_cast<void>(m_window->grab()); // starts OpenGL
    QString problem;
    const bool isOpen =
        m_window->scans().openReadOnly(std::filesystem::path(m_options.series->toStdU16String()), problem);
    m_window->session().cancelLoading(); // the images begin with the first scan
    if (!isOpen) {
        fail(problem);
        return;
    }
    if (!problem.isEmpty()) // the template is damaged
        printMessage(problem);
    // Queued: the series notes a problem of the scan first.
    connect(&m_window->session(), &Session::loadingEnded, this, &SeriesPictures::take, Qt::QueuedConnection);
    showNext();
}

void SeriesPictures::fail(const QString &reason)
{
    if (std::exchange(m_hasEnded, true))
        return;
    printMessage(reason);
    emit ended(2);
}

void SeriesPictures::showNext()
{
    if (m_next < m_window->scans().count())
        m_window->scans().show(m_next);
    else
        finish();
}

void SeriesPictures::take()
{
    if (m_hasEnded || m_window->session().isLoading())
        return;
    const auto &[name, problem, progress] = m_window->scans().report(m_next);
    ++m_next;
    QString text = problem.isEmpty() ? progress : problem;
    if (!problem.isEmpty()) {
        ++m_bad;
        m_sheet.addProblem(problem, name);
    } else {
        SceneDocument &document = m_window->document();
        if (m_options.side)
            fitAllFrom(document, geometry::seenFrom(*document.scene().camera, *m_options.side),
                       *document.scene().projection);
        document.picks().rayCasters().complete(document.objects()); // tells which landmarks are visible
        document.curves().complete();
        PictureMarks marks;
        marks.pick = marks.grid = marks.axes = false;
        const QSize size = *m_options.windowSize;
        const geometry::Result<QImage> picture =
            scenePicture(m_window->view(), {{size.width(), size.height(), 1.0}, marks, false});
        if (!picture || picture->isNull()) {
            fail(picture ? tr("OpenGL has no memory for an image of %1 × %2 pixels. Choose a smaller --size.")
                               .arg(size.width())
                               .arg(size.height())
                         : errorText(picture.error()));
            return;
        }
        if (const QString reason = write(*picture, name + QStringLiteral(".png")); !reason.isEmpty()) {
            fail(reason);
            return;
        }
        m_sheet.add(*picture, name + QStringLiteral("  ") + text);
    }
    printMessage(tr("%1 of %2: %3: %4").arg(m_next).arg(m_window->scans().count()).arg(name, text));
    QTimer::singleShot(0, this, &SeriesPictures::showNext);
}

QString SeriesPictures::write(const QImage &picture, const QString &name) const
{
    const std::filesystem::path file = m_folder / name.toStdU16String();
    if (QString refusal = overwritingText(m_window->document(), m_window->session(), file); !refusal.isEmpty())
        return refusal;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (picture.isNull() || !picture.save(&buffer, "png"))
        return tr("There is no memory for the image %1.").arg(name);
    const base::Done written = base::replaceFile(file, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return written ? QString() : pathText(file) + ": " + QString::fromStdString(written.error().text);
}

void SeriesPictures::finish()
{
    if (const QString problem = write(m_sheet.image(), kSheet); !problem.isEmpty()) {
        fail(problem);
        return;
    }
    m_hasEnded = true;
    printMessage(tr("Images of %1 scans and %2 written to %3. Scans that could not be read: %4.")
                     .arg(static_cast<int>(m_window->scans().count()) - m_bad)
                     .arg(kSheet, *m_options.pictures)
                     .arg(m_bad));
    emit ended(m_bad > 0 ? 1 : 0);
}

} // namespace unprojector::gui
