#include "gui/landmarks/scan_series.h"

#include "core/files/path_text.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmarks/point_template.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/document/session.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;
using namespace scene;

namespace {

using namespace landmark_files;

bool isScan(const std::filesystem::path &file)
{
    // "Models (*.obj … *.glb)"
    const QString pattern = u'*' + pathText(file.extension()).toLower(), all = modelFileFilter();
    return file.has_extension() && (all.contains(pattern + u' ') || all.contains(pattern + u')'));
}

std::string nameOrNumber(const LandmarkSet &set, std::size_t index)
{
    return set.landmarks[index].name.empty() ? std::to_string(index + 1) : set.landmarks[index].name;
}

/// A scan as in its file.
SceneObject asInItsFile(const std::filesystem::path &file, const SceneObject &shown)
{
    return {files::utf8FromPath(file.filename()), file, shown.model, {}};
}

/// Returns whether a landmark kept its position, up to rounding.
bool isStill(const Landmark &now, const Landmark &was)
{
    constexpr double kRounding = 1e-12;
    if (!now.world || !was.world || now.anchor != was.anchor)
        return false;
    const auto &[a, b] = std::pair(now.world->coordinates(), was.world->coordinates());
    const double size = std::max({std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    return std::abs(a.x - b.x) <= kRounding * size && std::abs(a.y - b.y) <= kRounding * size
           && std::abs(a.z - b.z) <= kRounding * size;
}

} // namespace

std::size_t Scan::placedCount() const
{
    return static_cast<std::size_t>(std::count_if(points.landmarks.begin(), points.landmarks.end(),
                                                  [](const Landmark &landmark) { return landmark.isPlaced(); }));
}

void readKept(Scan &scan, int placing)
{
    const std::filesystem::path file = landmarksBeside(scan.file, placing);
    scan.points = {};
    scan.problem.clear();
    scan.isDamaged = false;
    std::error_code error;
    scan.isKept = std::filesystem::exists(file, error);
    if (!scan.isKept)
        return;
    auto read = readLandmarkFile(file);
    if (!read)
        scan.problem = QString::fromStdString(errorText(read.error()));
    else if (read->sets.size() > 1)
        scan.problem =
            ScanSeries::tr(
                "%1: this file has the landmarks of %2 specimens. A scan is one specimen: put each into its own file.")
                .arg(pathText(file))
                .arg(read->sets.size());
    else
        scan.points = std::move(std::move(read).value().sets.front());
    scan.isDamaged = !scan.problem.isEmpty();
}

ScanSeries::ScanSeries(SceneDocument &document, Session &session, QObject *parent)
    : QObject(parent), m_document(document), m_session(session)
{
    // Handled before the other scene's landmarks are reported, which are not this scan's.
    connect(&m_document, &SceneDocument::opened, this, [this] {
        if (m_inView)
            m_aside = SuspendedScan{*m_inView, m_shown.has_value(), m_placing};
        m_inView = m_shown = std::nullopt;
    });
    connect(&m_session, &Session::opened, this, [this](const QString &lesson, bool isBack) {
        if (isBack && m_aside) {
            comeBack();
            return;
        }
        if (lesson.isEmpty())
            m_aside.reset();
        if (m_isOpening && isBack) { // only to be saved
            if (const auto aside = m_former ? std::exchange(m_former->aside, std::nullopt) : std::nullopt;
                aside && aside->placing == m_former->placing) {
                m_former->inView = aside->inView;
                m_former->shown = aside->isShown ? m_former->inView : std::nullopt;
            }
        } else if (m_isOpening) {
            m_former.reset();
            takeShown();
        } else if (m_current) { // another scene
            m_current = std::nullopt;
            emit changed();
        }
    });
    // Cancelled: the shown scan stays, and its landmarks are kept.
    connect(&m_session, &Session::loadingEnded, this, [this] {
        if (!std::exchange(m_isOpening, false))
            return;
        m_current = m_inView;
        if (m_former && m_wasAsked) // the user did not want to leave the scene
            goBack();
        emit changed();
    });
    connect(&m_session, &Session::failed, this, [this](const QString &reason) {
        if (!m_isOpening || !m_current || m_session.isLoading()) // during loading, something else has failed
            return;
        m_isOpening = false;
        m_scans[*m_current].problem = reason;
        emit changed();
    });
    connect(&m_session, &Session::aboutToSaveOrLeave, this, [this] {
        m_wasAsked = m_isOpening;
        keep();
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (!(changes & Change::Landmarks) || !m_shown)
            return;
        takeLandmarks(m_document.scene().landmarks); // saving waits for the curves
        emit this->changed();
    });
}

bool ScanSeries::open(const std::filesystem::path &folder)
{
    if (!keep())
        return false;
    std::vector<Scan> scans;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        if (isScan(it->path()) && it->is_regular_file(ignored))
            scans.push_back({it->path(), {}, {}});
    }
    if (error || scans.empty()) {
        emit failed(
            error ? QString::fromStdString(landmark_files::folderErrorText(folder, error))
                  : tr("%1: this folder has no model file. Supported: %2.").arg(pathText(folder), modelFileFilter()));
        return false;
    }
    std::sort(scans.begin(), scans.end(), [](const Scan &a, const Scan &b) { return a.file < b.file; });
    PreviousSeries former{m_folder, m_scans, m_names, m_curves, m_inView, m_shown, m_aside, m_placing};
    m_aside.reset();
    m_folder = folder;
    m_scans = std::move(scans);
    m_current = m_inView = m_shown = std::nullopt;
    m_isOpening = false;
    m_placing = 1;
    m_names.clear();
    m_curves.clear();
    for (Scan &scan : m_scans) {
        readKept(scan, m_placing);
        m_names = landmarks::withTemplate(std::move(m_names), scan.points.landmarks);
    }
    openProtocol();
    if (m_names.empty()) // the scene's names to place define the series
        m_names = landmarks::withTemplate({}, m_document.landmarks());
    const auto unfinished = std::find_if(m_scans.begin(), m_scans.end(), [this](const Scan &scan) {
        return !scan.isKept || scan.placedCount() < m_names.size();
    });
    emit changed();
    show(unfinished == m_scans.end() ? 0 : static_cast<std::size_t>(unfinished - m_scans.begin()));
    if (m_isOpening)
        m_former = std::move(former);
    return true;
}

void ScanSeries::openProtocol()
{
    if (const QString problem = m_protocol.open(m_folder, m_document.scene().landmarks.measures); !problem.isEmpty())
        emit warned(problem);
}

bool ScanSeries::close()
{
    if (!keep())
        return false;
    m_folder.clear();
    m_scans.clear();
    m_names.clear();
    m_curves.clear();
    m_protocol.close();
    m_current = m_inView = m_shown = std::nullopt;
    m_former.reset();
    m_aside.reset();
    m_isOpening = false;
    m_placing = 1;
    emit changed();
    return true;
}

void ScanSeries::goBack()
{
    m_folder = std::move(m_former->folder);
    m_scans = std::move(m_former->scans);
    m_names = std::move(m_former->names);
    m_curves = std::move(m_former->curves);
    m_current = m_inView = m_former->inView;
    m_shown = m_former->shown;
    m_aside = m_former->aside;
    m_placing = m_former->placing;
    m_former.reset();
    openProtocol();
}

QStringList ScanSeries::landmarkNames() const
{
    QStringList names;
    for (const Landmark &name : m_names)
        names << QString::fromStdString(name.name);
    for (const Scan &scan : m_scans) {
        for (std::size_t i = 0; i < scan.points.landmarks.size(); ++i) {
            const QString name = QString::fromStdString(nameOrNumber(scan.points, i));
            if (!names.contains(name, Qt::CaseInsensitive))
                names << name;
        }
    }
    return names;
}

void ScanSeries::step(int by)
{
    if (m_scans.empty())
        return;
    const auto count = static_cast<int>(m_scans.size());
    const int from = index() ? static_cast<int>(*index()) : by > 0 ? -1 : count;
    if (const int to = from + by; to >= 0 && to < count)
        show(static_cast<std::size_t>(to));
}

void ScanSeries::show(std::size_t index)
{
    Q_ASSERT(index < m_scans.size());
    if (!keep())
        return;
    if (m_shown || (m_aside && m_aside->isShown)) {
        const landmarks::LandmarkSet &before = m_scans[m_shown.value_or(m_aside ? m_aside->inView : 0)].points;
        m_names = landmarks::withTemplate(std::move(m_names), before.landmarks);
        m_curves = before.curves;
        std::erase_if(m_curves, [](const landmarks::Curve &curve) { return curve.points.empty(); });
    }
    m_isOpening = true;
    m_wasAsked = false;
    m_former.reset();
    m_current = index;
    m_session.openFiles({m_scans[index].file});
    if (m_session.isLoading()) { // the earlier loading was cancelled and reported
        m_isOpening = true;
        m_current = index;
    }
    emit changed();
}

void ScanSeries::takeShown()
{
    m_isOpening = false;
    m_inView = m_current;
    Scan &scan = m_scans[*m_current];
    m_stamp = files::stampOf(landmarksBeside(scan.file, m_placing));
    readKept(scan, m_placing);
    if (scan.isDamaged) { // not overwritten: the user may want to repair it
        emit failed(scan.problem + u'\n'
                    + tr("The file is not overwritten: to keep new landmarks, save the scene. Or repair or move the "
                         "file, and open the scan again."));
        emit changed();
        return;
    }
    const auto &objects = m_document.objects();
    const auto object = std::find_if(objects.begin(), objects.end(), [&](const SceneObject &each) {
        return each.file.filename() == scan.file.filename();
    });
    m_object = object != objects.end() ? *object : objects.empty() ? SceneObject() : objects.front();
    landmarks::LandmarkSet set = scan.points;
    set.landmarks = landmarks::withTemplate(std::move(set.landmarks), m_names);
    for (const landmarks::Curve &curve : m_curves) {
        const auto hasName = [&curve](const landmarks::Curve &other) { return other.name == curve.name; };
        if (std::none_of(set.curves.begin(), set.curves.end(), hasName))
            set.curves.push_back(curve);
    }
    const SceneObject inFile = asInItsFile(scan.file, m_object);
    const auto tie = [&] { // landmarks of this scan follow it
        for (Landmark &landmark : set.landmarks) {
            if (landmark.world && landmark.object.empty())
                landmark.object = inFile.name;
        }
    };
    tie();
    const QString loose = detachStale(set.landmarks, {inFile});
    tie();
    m_kept = set;
    scan.points = set;
    if (std::optional<landmarks::LandmarkSet> placed = transformed(set, inFile, m_object))
        set = std::move(*placed);
    set.measures = m_protocol.measures();
    static_cast<void>(editLandmarkSet(m_document, std::move(set), {tr("Landmarks of the scan")}));
    // The saved landmarks are the starting point: undo goes back no further.
    m_document.undoStack().clear();
    m_document.markSaved();
    m_shown = m_current;
    m_document.sceneLandmarks().waitForNext(std::nullopt);
    if (!loose.isEmpty())
        emit warned(QStringLiteral("%1: %2").arg(pathText(landmarksBeside(scan.file, m_placing).filename()), loose));
    emit changed();
}

void ScanSeries::comeBack()
{
    const SuspendedScan aside = *std::exchange(m_aside, std::nullopt);
    if (aside.placing != m_placing) {
        m_placing = aside.placing;
        for (Scan &scan : m_scans)
            readKept(scan, m_placing);
    }
    m_inView = aside.inView;
    if (!m_isOpening) // else it is restored only to be saved
        m_current = m_inView;
    if (aside.isShown) {
        m_shown = m_inView;
        takeLandmarks(m_document.scene().landmarks);
    }
    emit changed();
}

bool ScanSeries::takeLandmarks(landmarks::LandmarkSet set)
{
    if (const QString problem = m_protocol.take(std::exchange(set.measures, {})); !problem.isEmpty())
        emit failed(problem);
    Scan &scan = m_scans[*m_shown];
    for (const SceneObject &object : m_document.objects()) {
        if (object.file == m_object.file) {
            m_object = object;
            break;
        }
    }
    auto points = transformed(std::move(set), m_object, asInItsFile(scan.file, m_object));
    if (!points)
        return false;
    for (std::size_t i = 0; i < std::min(points->landmarks.size(), m_kept.landmarks.size()); ++i) {
        Landmark &landmark = points->landmarks[i];
        if (isStill(landmark, m_kept.landmarks[i])) { // a transform and its inverse leave rounding
            landmark.world = m_kept.landmarks[i].world;
            landmark.uncertainty = m_kept.landmarks[i].uncertainty;
        }
    }
    scan.points = std::move(*points);
    return true;
}

bool ScanSeries::isScanAlone() const
{
    const Scene &scene = m_document.scene();
    return m_session.file().empty() && scene.clipPlanes.empty() && scene.objects.size() == 1
           && scene.objects.front().transform.empty() && !scene.objects.front().isHidden;
}

bool ScanSeries::isAsKept() const
{
    landmarks::LandmarkSet now = m_scans[*m_shown].points;
    if (!m_scans[*m_shown].isKept || now.curves.size() != m_kept.curves.size())
        return false;
    for (std::size_t i = 0; i < now.curves.size(); ++i) { // they follow from the rest
        if (m_kept.curves[i].semilandmarks.empty())
            return false;
        now.curves[i].semilandmarks = m_kept.curves[i].semilandmarks;
    }
    return now == m_kept;
}

bool ScanSeries::keep()
{
    m_session.commitTyped();
    if (!m_shown)
        return true;
    if (takeLandmarks(m_document.scene().landmarks) && isAsKept()) {
        m_scans[*m_shown].points = m_kept;
        if (isScanAlone())
            m_document.markSaved();
        return true;
    }
    const std::optional<std::size_t> shown = m_shown;
    geometry::Result<landmarks::LandmarkSet, QString> known = m_document.curves().withSemilandmarks();
    if (m_shown != shown) // another scan arrived during the wait, after these were saved
        return true;
    if (!known) {
        emit failed(tr("The landmarks of %1 are not saved yet: %2.")
                        .arg(pathText(m_scans[*m_shown].file.filename()), known.error()));
        return false;
    }
    Scan &scan = m_scans[*m_shown];
    if (!takeLandmarks(std::move(known).value())) {
        emit failed(tr("The landmarks of %1 cannot be saved: because of the object's scale they have no coordinates in "
                       "its file. Reset its glScale.")
                        .arg(pathText(scan.file.filename())));
        return false;
    }
    // A scan without landmarks needs no file.
    if (scan.isKept ? scan.points != m_kept : scan.placedCount() > 0) {
        const std::filesystem::path file = landmarksBeside(scan.file, m_placing);
        std::error_code error;
        if (std::filesystem::exists(file, error) && !files::isAsAt(m_stamp, file)) {
            emit failed(tr("Another window or program has changed %1 since it was read. It is not overwritten; move it "
                           "away to keep the shown landmarks.")
                            .arg(pathText(file)));
            return false;
        }
        const auto written = writeLandmarkFile(file, {&scan.points, 1});
        if (!written) {
            emit failed(QString::fromStdString(errorText(written.error())));
            return false;
        }
        scan.isKept = true;
        m_kept = scan.points;
        m_stamp = files::stampOf(file);
        if (!written->empty())
            emit warned(landmarkNotesText(pathText(file.filename()), *written));
        emit noticed(tr("Landmarks of %1 saved beside it.").arg(pathText(scan.file.filename())));
    }
    // After other changes, the scene still asks about them.
    if (isScanAlone())
        m_document.markSaved();
    return true;
}

void ScanSeries::setPlacing(int placing)
{
    if (placing == m_placing || placing < 1 || placing > kMostPlacings)
        return;
    if (!mayPlaceAs(placing)) {
        emit changed(); // the field for the placing shows the present value again
        return;
    }
    m_placing = placing;
    for (Scan &scan : m_scans)
        readKept(scan, placing);
    m_shown = std::nullopt;
    if (m_inView) {
        m_current = m_inView;
        takeShown();
    }
    emit changed();
}

bool ScanSeries::mayPlaceAs(int placing)
{
    if (!keep())
        return false;
    if (!m_inView)
        return true;
    Scan other{m_scans[*m_inView].file, {}, {}};
    readKept(other, placing);
    if (other.isDamaged) {
        emit failed(other.problem + u'\n'
                    + tr("Placing %1 continues. Repair the file, or move it away.").arg(m_placing));
        return false;
    }
    // Changes that are not saved beside the scan would be lost.
    return m_shown || !m_document.isEdited() || m_session.mayLeave();
}

std::optional<SeriesRepeats> ScanSeries::repeats()
{
    if (!keep())
        return std::nullopt;
    SeriesRepeats found = repeatsIn(m_scans);
    if (const auto table = errorsTable(found.specimens); !table) { // placings in several units
        emit failed(QString::fromStdString(errorText(table.error())));
        return std::nullopt;
    }
    return found;
}

bool ScanSeries::exportTable(const std::filesystem::path &file, Table table)
{
    if (!keep())
        return false;
    const auto written = writeSeries(file, table, {m_scans, m_names, measures(), m_placing, m_waiting});
    if (!written) {
        emit failed(written.error());
        return false;
    }
    if (!written->warning.isEmpty())
        emit warned(written->warning);
    emit noticed(written->notice);
    return true;
}

} // namespace unprojector::gui
