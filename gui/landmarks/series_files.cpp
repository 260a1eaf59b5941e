#include "gui/landmarks/series_files.h"

#include "core/base/system_error.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "gui/landmarks/landmark_templates.h"
#include "gui/text/error_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;
using namespace landmark_files;

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::SeriesFiles)
};

/// A template in the form that its file gives back.
LandmarkSet asRead(const LandmarkSet &set)
{
    const auto text = landmarksText({&set, 1}, Format::Csv);
    auto read = text ? parseLandmarks(text->text, Format::Csv, "template")
                     : base::Expected<ReadLandmarks, base::Error>(text.error());
    return read && !read->sets.empty() ? std::move(read).value().sets.front() : set;
}

} // namespace

SeriesFiles::Done SeriesFiles::backUp(const std::filesystem::path &file)
{
    std::error_code error;
    if (m_backedUp.contains(file))
        return std::monostate{};
    if (std::filesystem::exists(file, error)) {
        std::filesystem::path backup = file;
        backup += "~";
        std::filesystem::copy_file(file, backup, std::filesystem::copy_options::overwrite_existing, error);
        if (error)
            return Texts::tr("%1 has no backup: %2.")
                .arg(pathText(file.filename()), QString::fromStdString(base::systemErrorText(error)));
    }
    m_backedUp.insert(file); // a new file has no earlier state in this run
    return std::monostate{};
}

geometry::Result<std::optional<std::vector<Landmark>>, QString>
SeriesFiles::readTemplate(const std::filesystem::path &folder)
{
    const std::filesystem::path file = seriesTemplate(folder);
    std::error_code error;
    m_template.reset();
    m_isDamaged = m_isChosen = false;
    if (!std::filesystem::exists(file, error))
        return std::optional<std::vector<Landmark>>();
    auto read = readLandmarkFile(file);
    m_isDamaged = !read || read->sets.size() != 1;
    if (!read)
        return QString::fromStdString(read.error().message());
    if (m_isDamaged)
        return Texts::tr("%1: this file is no template: it has the landmarks of several specimens.")
            .arg(pathText(file));
    m_template = std::move(read).value().sets.front();
    if (m_templates)
        m_templates->choose(m_template->landmarks, folder);
    return std::optional(m_template->landmarks);
}

geometry::Result<bool, QString> SeriesFiles::keepTemplate(const std::filesystem::path &folder,
                                                          const std::vector<Landmark> &names)
{
    if (!m_templates || m_isDamaged)
        return false;
    const std::filesystem::path file = seriesTemplate(folder);
    const bool isWritten =
        std::any_of(m_backedUp.begin(), m_backedUp.end(), [&file](const std::filesystem::path &written) {
            return written.parent_path() == file.parent_path();
        });
    if (!m_template && !isWritten && !m_isChosen) // the user only looks around
        return false;
    const LandmarkSet set = asRead(m_templates->templateOf(names, folder));
    if (m_template && m_template->landmarks == set.landmarks)
        return false;
    if (!m_template && set.landmarks.empty())
        return false;
    if (const Done backup = backUp(file); !backup)
        return backup.error();
    if (set.landmarks.empty()) {
        std::error_code error;
        std::filesystem::remove(file, error);
        m_template.reset();
        return true;
    }
    const auto written = writeLandmarkFile(file, {&set, 1});
    if (!written)
        return QString::fromStdString(written.error().message());
    m_template = set;
    return true;
}

} // namespace unprojector::gui
