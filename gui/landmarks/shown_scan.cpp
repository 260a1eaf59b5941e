#include "gui/landmarks/shown_scan.h"

#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/point_template.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/document/session.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;
using namespace scene;
using namespace landmark_files;

ShownScan::ShownScan(SceneDocument &document, Session &session, SeriesFiles &files, SeriesProtocol &protocol,
                     std::function<Scan *()> shown)
    : m_document(document), m_session(session), m_files(files), m_protocol(protocol), m_shown(std::move(shown))
{
}

const LandmarkSet &ShownScan::sceneLandmarks() const
{
    return m_document.scene().landmarks;
}

void ShownScan::begin(const std::filesystem::path &scan, const std::filesystem::path &landmarkFile)
{
    m_scan = scan;
    m_dropped.reset();
    m_stamp = base::stampOf(landmarkFile);
    const auto &objects = m_document.objects();
    const auto object = std::find_if(objects.begin(), objects.end(), [&scan](const SceneObject &each) {
        return each.file.filename() == scan.filename();
    });
    m_object = object != objects.end() ? *object : objects.empty() ? SceneObject() : objects.front();
}

QString ShownScan::takeRead(Scan &scan, const std::vector<Landmark> &names, const std::vector<Curve> &curves)
{
    LandmarkSet &set = scan.points;
    set.landmarks = withTemplate(std::move(set.landmarks), names);
    addCurves(set.curves, curves);
    const SceneObject inFile = asInItsFile(m_scan, m_object);
    const auto tie = [&] { // landmarks of this scan follow it
        for (Landmark &landmark : set.landmarks) {
            if (landmark.world && landmark.object.empty())
                landmark.object = inFile.name;
        }
    };
    tie();
    QString loose = detachStale(set.landmarks, {inFile});
    tie();
    m_saved = set;
    return loose;
}

void ShownScan::showSaved()
{
    LandmarkSet set = m_saved;
    if (std::optional<LandmarkSet> placed = transformed(set, asInItsFile(m_scan, m_object), m_object))
        set = *std::move(placed);
    set.measures = m_protocol.measures();
    static_cast<void>(editLandmarkSet(m_document, std::move(set), {tr("Landmarks of the scan")}));
}

bool ShownScan::take(Scan &scan, LandmarkSet set)
{
    if (const QString problem = m_protocol.take(std::exchange(set.measures, {})); !problem.isEmpty())
        emit failed(problem);
    for (const SceneObject &object : m_document.objects()) {
        if (object.file == m_object.file) {
            m_object = object;
            break;
        }
    }
    auto points = transformed(std::move(set), m_object, asInItsFile(m_scan, m_object));
    if (!points)
        return false;
    takeExact(points->landmarks, m_saved.landmarks);
    scan.points = *std::move(points);
    return true;
}

bool ShownScan::isAlone() const
{
    const Scene &scene = m_document.scene();
    return m_session.file().empty() && scene.clipPlanes.empty() && scene.objects.size() == 1
           && scene.objects.front().transform.empty() && !scene.objects.front().isHidden;
}

bool ShownScan::isAsSaved(const Scan &scan) const
{
    LandmarkSet now = scan.points;
    if (!scan.isKept || now.curves.size() != m_saved.curves.size())
        return false;
    for (std::size_t i = 0; i < now.curves.size(); ++i) { // they follow from the rest
        if (m_saved.curves[i].semilandmarks.empty())
            return false;
        now.curves[i].semilandmarks = m_saved.curves[i].semilandmarks;
    }
    return now == m_saved;
}

ShownScan::Kept ShownScan::keep(const std::filesystem::path &landmarkFile, bool isWanted)
{
    Scan *shown = m_shown();
    if (!shown)
        return Kept::AsBefore;
    Scan &scan = *shown;
    if (take(scan) && isAsSaved(scan)) {
        scan.points = m_saved;
        if (isAlone())
            m_document.markSaved();
        return Kept::AsBefore;
    }
    geometry::Result<LandmarkSet, QString> known = m_document.curves().withSemilandmarks();
    if (m_shown() != shown) // another scan arrived during the wait, after these were saved
        return Kept::AsBefore;
    if (!known) {
        emit failed(tr("The landmarks of %1 are not saved yet: %2.").arg(pathText(m_scan.filename()), known.error()));
        return Kept::Failed;
    }
    if (!take(scan, std::move(known).value())) {
        emit failed(tr("The landmarks of %1 cannot be saved: because of the object's scale they have no coordinates in "
                       "its file. Reset its glScale.")
                        .arg(pathText(scan.file.filename())));
        return Kept::Failed;
    }
    // A scan without landmarks needs no file.
    const bool hasChanged = scan.isKept ? scan.points != m_saved : scan.placedCount() + scan.missingCount() > 0;
    const Kept kept = hasChanged ? write(scan, landmarkFile, isWanted) : Kept::AsBefore;
    // After other changes, the scene still asks about them.
    if (kept != Kept::Failed && kept != Kept::Cancelled && isAlone())
        m_document.markSaved();
    return kept;
}

ShownScan::Kept ShownScan::write(Scan &scan, const std::filesystem::path &landmarkFile, bool isWanted)
{
    std::error_code error;
    if (std::filesystem::exists(landmarkFile, error) && !base::isAsAt(m_stamp, landmarkFile)) {
        emit failed(tr("Another window or program has changed %1 since it was read. It is not overwritten; move it "
                       "away to keep the shown landmarks.")
                        .arg(pathText(landmarkFile)));
        return Kept::Failed;
    }
    if (const Kept may = mayReplace(scan, landmarkFile, isWanted); may != Kept::Written)
        return may;
    if (m_shown() != &scan) // another scan arrived during the question, after these were saved
        return Kept::AsBefore;
    if (const SeriesFiles::Done backup = m_files.backUp(landmarkFile); !backup)
        emit warned(backup.error());
    const auto written = writeLandmarkFile(landmarkFile, {&scan.points, 1});
    if (!written) {
        emit failed(QString::fromStdString(written.error().message()));
        return Kept::Failed;
    }
    scan.isKept = true;
    m_saved = scan.points;
    m_stamp = base::stampOf(landmarkFile);
    if (!written->empty())
        emit warned(landmarkNotesText(pathText(landmarkFile.filename()), *written));
    emit noticed(
        tr("Landmarks of %1 saved in %2.").arg(pathText(scan.file.filename()), pathText(landmarkFile.filename())));
    return Kept::Written;
}

ShownScan::Kept ShownScan::mayReplace(const Scan &scan, const std::filesystem::path &landmarkFile, bool isWanted)
{
    const std::size_t saved = scan.isKept ? placedCount(m_saved) : 0, now = scan.placedCount();
    if (2 * now >= saved || !m_session.remembers())
        return Kept::Written;
    if (!isWanted && m_dropped == scan.points) // asked already
        return Kept::Dropped;
    switch (m_session.questions().askFewerLandmarks(landmarkFile, static_cast<int>(saved), static_cast<int>(now))) {
    case SessionQuestions::FewerAnswer::Replace: return Kept::Written;
    case SessionQuestions::FewerAnswer::KeepSaved:
        if (isWanted)
            return Kept::Cancelled;
        m_dropped = scan.points;
        return Kept::Dropped;
    case SessionQuestions::FewerAnswer::Cancel: break;
    }
    return Kept::Cancelled;
}

} // namespace unprojector::gui
