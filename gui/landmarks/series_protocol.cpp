#include "gui/landmarks/series_protocol.h"

#include "core/base/replace_file.h"
#include "core/landmark_files/measures_file.h"
#include "gui/document/object_names.h"
#include "gui/text/error_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::SeriesProtocol)
};

} // namespace

QString SeriesProtocol::open(const std::filesystem::path &folder, const std::vector<landmarks::KeptMeasure> &ofScene)
{
    m_file = folder / landmark_files::kSeriesMeasures;
    m_stamp = base::stampOf(m_file);
    m_isDamaged = m_isUnsaved = false;
    m_measures.clear();
    std::error_code error;
    m_isNew = !std::filesystem::exists(m_file, error) && !ofScene.empty();
    if (m_isNew)
        m_measures = ofScene;
    if (!std::filesystem::exists(m_file, error))
        return {};
    auto read = landmark_files::readMeasures(m_file);
    m_isDamaged = !read;
    if (!read)
        return QString::fromStdString(read.error().message());
    m_measures = std::move(read).value();
    return {};
}

void SeriesProtocol::close()
{
    *this = {};
}

QString SeriesProtocol::take(std::vector<landmarks::KeptMeasure> measures)
{
    if (m_file.empty() || measures == m_measures)
        return {};
    m_measures = std::move(measures);
    return write();
}

QString SeriesProtocol::keep(bool areLandmarksWritten)
{
    return m_isUnsaved || (m_isNew && areLandmarksWritten) ? write() : QString();
}

QString SeriesProtocol::write()
{
    m_isNew = false;
    m_isUnsaved = true;
    std::error_code error;
    if (m_isDamaged)
        return Texts::tr("%1 could not be read and is not overwritten. Repair it or move it away to keep the measures.")
            .arg(pathText(m_file));
    if (std::filesystem::exists(m_file, error) && !base::isAsAt(m_stamp, m_file))
        return Texts::tr("Another window or program has changed %1 since it was read. It is not overwritten; move it "
                         "away to keep the measures.")
            .arg(pathText(m_file));
    if (const base::Done written = base::replaceFile(m_file, landmark_files::measuresText(m_measures)); !written)
        return QStringLiteral("%1: %2").arg(pathText(m_file), QString::fromStdString(written.error().text));
    m_stamp = base::stampOf(m_file);
    m_isUnsaved = false;
    return {};
}

QString leftBehindText(const std::vector<landmarks::KeptMeasure> &before,
                       const std::vector<landmarks::KeptMeasure> &after, const std::vector<Scan> &scans,
                       std::size_t renamedOn)
{
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
        const std::vector<std::string> &was = before[i].landmarks, &is = after[i].landmarks;
        if (before[i].name != after[i].name || was.size() != is.size())
            continue;
        const auto [from, to] = std::mismatch(was.begin(), was.end(), is.begin());
        if (from == was.end())
            continue;
        std::size_t left = 0;
        for (std::size_t scan = 0; scan < scans.size(); ++scan)
            left +=
                scan != renamedOn && has(scans[scan].points.landmarks, *from) && !has(scans[scan].points.landmarks, *to)
                    ? 1U
                    : 0U;
        if (left > 0)
            return Texts::tr("The protocol now measures “%1” instead of “%2”. Scans that still have “%2”: %3. Rename "
                             "it there too.")
                .arg(shownName(*to), shownName(*from))
                .arg(left);
    }
    return {};
}

} // namespace unprojector::gui
