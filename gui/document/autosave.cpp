#include "gui/document/autosave.h"

#include <QDir>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

Autosave::Autosave(QString folder, AutosaveTiming timing, Source source, QObject *parent)
    : QObject(parent), m_folder(std::move(folder)), m_timing(timing), m_source(std::move(source))
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
}

void Autosave::follow(bool isUnsaved)
{
    if (!isUnsaved) {
        discard();
        return;
    }
    m_isBehind = true;
    if (!m_sinceFirstChange.isValid())
        m_sinceFirstChange.start();
    if (m_isHurried)
        return;
    const auto waited = std::chrono::milliseconds(m_sinceFirstChange.elapsed());
    m_timer.start(std::clamp(m_timing.latest - waited, std::chrono::milliseconds(0), m_timing.pause));
}

void Autosave::hurry(HurryTiming timing)
{
    // A larger scene, or a slow disk, would stop the window at each landmark.
    if (!m_isBehind || m_isHurried || m_cost > timing.cheap)
        return;
    m_isHurried = true;
    std::chrono::milliseconds wait(0);
    if (m_sinceWrite.isValid())
        wait = std::max(wait, timing.between - std::chrono::milliseconds(m_sinceWrite.elapsed()));
    m_timer.start(wait);
}

void Autosave::adopt(std::unique_ptr<RecoveryFile> file)
{
    discard();
    m_file = std::move(file);
}

std::unique_ptr<RecoveryFile> Autosave::release()
{
    m_timer.stop();
    m_isHurried = false;
    if (std::exchange(m_isBehind, false)) {
        m_hasFailed = false;
        write();
    }
    return std::move(m_file);
}

void Autosave::discard()
{
    m_timer.stop();
    m_isBehind = m_isHurried = false;
    m_sinceFirstChange.invalidate();
    if (!m_file)
        return;
    m_file->remove();
    m_file.reset();
}

void Autosave::write()
{
    m_sinceFirstChange.invalidate();
    m_isHurried = false;
    m_sinceWrite.start();
    const Kept kept = keep();
    m_cost = std::chrono::milliseconds(m_sinceWrite.elapsed());
    if (kept)
        m_isBehind = m_hasFailed = false;
    else if (!std::exchange(m_hasFailed, true))
        emit failed(kept.error());
}

Kept Autosave::keep()
{
    const auto onDisk = [this](const QString &reason) {
        return QStringLiteral("%1: %2").arg(QDir::toNativeSeparators(m_folder), reason);
    };
    const Result<Content, QString> content = m_source();
    if (!content)
        return content.error();
    if (!m_file) {
        Result<std::unique_ptr<RecoveryFile>, QString> created = RecoveryFile::create(m_folder);
        if (!created)
            return onDisk(created.error());
        m_file = std::move(created).value();
    }
    const Kept written = m_file->write(content->info, content->sceneText);
    return written ? written : onDisk(written.error());
}

} // namespace unprojector::gui
