#include "gui/landmarks/scan_series.h"

#include "core/files/path_text.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmarks/point_template.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;
using namespace scene;

namespace {

using namespace landmark_files;

std::string nameOrNumber(const LandmarkSet &set, std::size_t index)
{
    return set.landmarks[index].name.empty() ? std::to_string(index + 1) : set.landmarks[index].name;
}

} // namespace

ScanSeries::ScanSeries(SceneDocument &document, Session &session, QObject *parent)
    : QObject(parent), m_document(document), m_session(session), m_history(document),
      m_shownScan(document, session, m_files, m_protocol, [this] { return m_shown ? &m_scans[*m_shown] : nullptr; })
{
    m_session.setKeeper(this);
    connect(this, &QObject::destroyed, &m_session, [&session] { session.setKeeper(nullptr); });
    connect(&m_shownScan, &ShownScan::failed, this, &ScanSeries::failed);
    connect(&m_shownScan, &ShownScan::warned, this, &ScanSeries::warned);
    connect(&m_shownScan, &ShownScan::noticed, this, &ScanSeries::noticed);
    connect(&m_history, &SeriesHistory::wanted, this, &ScanSeries::goTo);
    connect(&m_history, &SeriesHistory::refused, this, &ScanSeries::warned);
    // Handled before the other scene's landmarks are reported, which are not this scan's.
    connect(&m_document, &SceneDocument::opened, this, [this] {
        if (m_inView)
            m_aside = SuspendedScan{*m_inView, m_shown.has_value(), m_placing};
        m_inView = m_shown = std::nullopt;
        m_history.setNoneShown();
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
            takeShown(true);
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
        m_target.reset();
        m_passedOver.reset();
        if (m_former && m_wasAsked) // the user did not want to leave the scene
            goBack();
        emit changed();
    });
    connect(&m_session, &Session::failed, this, [this](const QString &reason) {
        if (!m_isOpening || !m_current || m_session.isLoading()) // during loading, something else has failed
            return;
        m_isOpening = false;
        m_target.reset();
        m_scans[*m_current].problem = reason;
        emit changed();
        if (m_passedOver)
            passOver(reason);
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (!(changes & Change::Landmarks) || !m_shown)
            return;
        const std::vector<Landmark> before = m_scans[*m_shown].points.landmarks;
        if (m_shownScan.take(m_scans[*m_shown])) // saving waits for the curves
            dropRemoved(before);
        emit this->changed();
    });
}

bool ScanSeries::open(const std::filesystem::path &folder)
{
    if (!keep())
        return false;
    const std::filesystem::path absolute = absolutePath(folder);
    geometry::Result<std::vector<Scan>, QString> scans = scansIn(absolute);
    if (!scans) {
        emit failed(scans.error());
        return false;
    }
    PreviousSeries former{m_folder, m_scans, m_names, m_curves, m_inView, m_shown, m_aside, m_placing};
    m_aside.reset();
    m_current = m_inView = m_shown = std::nullopt;
    m_isOpening = false;
    takeSeries(absolute, std::move(scans).value(), 1);
    emit changed();
    m_passedOver = QStringList();
    const std::size_t first = firstIncomplete(0);
    for (std::size_t i = first; i > 0 && !m_scans[first].isKept && m_curves.empty(); --i)
        addCurves(m_curves, m_scans[i - 1].points.curves); // a new scan takes them from the one before
    show(first);
    if (m_isOpening)
        m_former = std::move(former);
    return true;
}

void ScanSeries::takeSeries(const std::filesystem::path &folder, std::vector<Scan> scans, int placing)
{
    m_folder = folder;
    m_scans = std::move(scans);
    m_placing = placing;
    m_names.clear();
    m_curves.clear();
    m_target.reset();
    geometry::Result<std::optional<std::vector<Landmark>>, QString> own = m_files.readTemplate(folder);
    const bool hasTemplate = own && *own;
    if (hasTemplate)
        m_names = withTemplate({}, **own);
    for (Scan &scan : m_scans) {
        readKept(scan, m_placing);
        if (!hasTemplate)
            m_names = withTemplate(std::move(m_names), scan.points.landmarks);
    }
    m_toWarn.clear();
    if (const QString problem = openProtocol(); !problem.isEmpty())
        m_toWarn << problem;
    if (m_names.empty()) { // the scene's names to place define the series
        m_names = withTemplate({}, m_document.landmarks());
        addCurves(m_curves, m_document.scene().landmarks.curves);
    }
    for (Scan &scan : m_scans)
        withoutUnwanted(scan.points.landmarks, m_names);
    if (!own)
        m_toWarn << own.error() + u'\n'
                        + tr("Names and hints of the series are not kept. Repair the file or move it away.");
    else if (hasTemplate)
        emit noticed(tr("The series takes its %1 names from %2.")
                         .arg(m_names.size())
                         .arg(pathText(landmark_files::seriesTemplate({}))));
}

void ScanSeries::read(Scan &scan)
{
    const QString unreadable = scan.isDamaged ? QString() : scan.problem; // the scan itself
    readKept(scan, m_placing);
    if (scan.problem.isEmpty())
        scan.problem = unreadable;
    withoutUnwanted(scan.points.landmarks, m_names);
}

void ScanSeries::readAgain()
{
    for (std::size_t i = 0; i < m_scans.size(); ++i) {
        if (i != m_shown)
            read(m_scans[i]);
    }
    emit changed();
}

void ScanSeries::keepChosenTemplate()
{
    m_files.setChosen();
    keepTemplate();
}

std::size_t ScanSeries::firstIncomplete(std::size_t from) const
{
    for (std::size_t i = from; i < m_scans.size(); ++i) {
        const Scan &scan = m_scans[i];
        if (scan.problem.isEmpty() && (!scan.isKept || !scan.isComplete(m_names)))
            return i;
    }
    const auto readable =
        std::find_if(m_scans.begin(), m_scans.end(), [](const Scan &scan) { return scan.problem.isEmpty(); });
    return readable != m_scans.end() ? static_cast<std::size_t>(readable - m_scans.begin()) : 0;
}

void ScanSeries::passOver(const QString &reason)
{
    *m_passedOver << reason;
    const std::size_t index = firstIncomplete(*m_current + 1);
    if (!m_scans[index].problem.isEmpty()) {
        m_passedOver.reset();
        return;
    }
    std::optional<PreviousSeries> former = std::move(m_former);
    show(index);
    if (m_isOpening)
        m_former = std::move(former);
}

QString ScanSeries::openProtocol()
{
    return m_protocol.open(m_folder, m_document.scene().landmarks.measures);
}

bool ScanSeries::close()
{
    if (!keep())
        return false;
    keepTemplate();
    m_history.forget();
    m_folder.clear();
    m_scans.clear();
    m_names.clear();
    m_curves.clear();
    m_protocol.close();
    m_current = m_inView = m_shown = std::nullopt;
    m_former.reset();
    m_aside.reset();
    m_look.reset();
    m_passedOver.reset();
    m_target.reset();
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
    static_cast<void>(m_files.readTemplate(m_folder)); // chooses its hints again; its names are known
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

std::size_t ScanSeries::wantedCount(const Scan &scan) const
{
    std::vector<Landmark> all = withTemplate(scan.points.landmarks, m_names);
    if (m_shown) // what is added there is wanted on every scan
        all = withTemplate(std::move(all), m_scans[*m_shown].points.landmarks);
    return all.size();
}

QString ScanSeries::progressText(const Scan &scan) const
{
    const std::size_t placed = scan.placedCount(), wanted = wantedCount(scan), missing = scan.missingCount();
    return missing > 0 ? tr("%1 of %2, %3 missing").arg(placed).arg(wanted).arg(missing)
                       : tr("%1 of %2").arg(placed).arg(wanted);
}

void ScanSeries::step(int by)
{
    if (m_scans.empty())
        return;
    m_target.reset();
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
        const LandmarkSet &before = m_scans[m_shown.value_or(m_aside ? m_aside->inView : 0)].points;
        m_names = withTemplate(std::move(m_names), before.landmarks);
        m_curves = before.curves;
        std::erase_if(m_curves, [this](const Curve &curve) { return m_isReadOnly || curve.points.empty(); });
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

void ScanSeries::takeShown(bool isLoaded)
{
    m_isOpening = false;
    m_inView = m_current;
    Scan &scan = m_scans[*m_current];
    if (isLoaded && m_look)
        fitAllFrom(m_document, m_look->first, m_look->second);
    if (const QStringList passed = std::exchange(m_passedOver, std::nullopt).value_or(QStringList()); passed.size() > 1)
        m_toWarn << passed;
    if (const QStringList texts = std::exchange(m_toWarn, {}); !texts.isEmpty())
        emit warned(texts.join(u'\n'));
    m_shownScan.begin(scan.file, landmarksBeside(scan.file, m_placing));
    scan.problem.clear();
    read(scan);
    if (scan.isDamaged) { // not overwritten: the user may want to repair it
        putHistoryBack();
        emit failed(scan.problem + u'\n'
                    + tr("The file is not overwritten: to keep new landmarks, save the scene. Or repair or move the "
                         "file, and open the scan again."));
        emit changed();
        return;
    }
    const QString loose = m_shownScan.takeRead(scan, m_names, m_curves);
    m_shownScan.showSaved();
    putHistoryBack();
    m_document.markSaved();
    m_shown = m_current;
    m_document.sceneLandmarks().waitForNext(std::nullopt);
    if (!loose.isEmpty())
        emit warned(QStringLiteral("%1: %2").arg(pathText(landmarksBeside(scan.file, m_placing).filename()), loose));
    emit changed();
    runTarget();
}

ScanPlacing ScanSeries::shownPlacing() const
{
    return {m_scans[*m_inView].file, m_placing};
}

void ScanSeries::putHistoryBack()
{
    m_history.putBack(shownPlacing(), [this](const std::filesystem::path &file) {
        return std::any_of(m_scans.begin(), m_scans.end(), [&file](const Scan &scan) { return scan.file == file; });
    });
}

void ScanSeries::goTo(const std::shared_ptr<const ScanStep> &step, bool isRedo)
{
    const auto scan = std::find_if(m_scans.begin(), m_scans.end(),
                                   [&step](const Scan &each) { return each.file == step->where.scan; });
    if (scan == m_scans.end() || m_isOpening)
        return;
    const auto index = static_cast<std::size_t>(scan - m_scans.begin());
    m_target = {step, isRedo};
    if (step->where.placing != m_placing)
        setPlacing(step->where.placing);
    if (!m_target || step->where.placing != m_placing) { // done, or refused with a reason
        m_target.reset();
        return;
    }
    show(index);
    if (!m_isOpening)
        m_target.reset();
}

void ScanSeries::runTarget()
{
    if (!m_target || m_target->step->where != shownPlacing())
        return;
    const SeriesHistory::Wanted target = *std::exchange(m_target, std::nullopt);
    if (m_history.run(target.step, target.isRedo))
        emit noticed((target.isRedo ? tr("Redone on %1: %2.") : tr("Undone on %1: %2."))
                         .arg(pathText(target.step->where.scan.filename()), target.step->text));
}

void ScanSeries::comeBack()
{
    const SuspendedScan aside = *std::exchange(m_aside, std::nullopt);
    if (aside.placing != m_placing) {
        m_placing = aside.placing;
        for (Scan &scan : m_scans)
            read(scan);
    }
    m_inView = aside.inView;
    if (!m_isOpening) // else it is restored only to be saved
        m_current = m_inView;
    if (aside.isShown) {
        m_shown = m_inView;
        m_shownScan.take(m_scans[*m_shown]);
    }
    putHistoryBack();
    emit changed();
}

void ScanSeries::dropRemoved(const std::vector<Landmark> &before)
{
    std::vector<Landmark> removed = before;
    std::erase_if(removed, [this](const Landmark &landmark) {
        return !landmark.isToPlace() || has(m_scans[*m_shown].points.landmarks, landmark.name);
    });
    if (removed.empty())
        return;
    std::erase_if(m_names, [&removed](const Landmark &name) { return has(removed, name.name); });
    for (std::size_t i = 0; i < m_scans.size(); ++i) {
        if (i != *m_shown)
            std::erase_if(m_scans[i].points.landmarks, [&removed](const Landmark &landmark) {
                return landmark.isToPlace() && has(removed, landmark.name);
            });
    }
}

bool ScanSeries::keep()
{
    const ShownScan::Kept kept = keepShown(false);
    return kept != ShownScan::Kept::Failed && kept != ShownScan::Kept::Cancelled;
}

bool ScanSeries::keepBeforeLeaving()
{
    m_wasAsked = m_isOpening;
    if (m_inView)
        m_look = {*m_document.scene().camera, *m_document.scene().projection};
    const ShownScan::Kept kept = keepShown(false);
    if (m_shown)
        m_history.collect(shownPlacing());
    if (kept != ShownScan::Kept::Cancelled)
        keepTemplate();
    return kept != ShownScan::Kept::Cancelled;
}

std::optional<bool> ScanSeries::save()
{
    if (!m_shown)
        return std::nullopt;
    const ShownScan::Kept kept = keepShown(true);
    const Scan &scan = m_scans[*m_shown];
    const QString name = pathText(scan.file.filename()),
                  file = pathText(landmarksBeside(scan.file, m_placing).filename());
    if (kept == ShownScan::Kept::AsBefore)
        emit noticed(scan.isKept ? tr("The landmarks of %1 are saved in %2 already.").arg(name, file)
                                 : tr("%1 has no landmark yet, so there is nothing to save.").arg(name));
    const bool isSaved = kept == ShownScan::Kept::Written || kept == ShownScan::Kept::AsBefore;
    if (isSaved && m_session.hasUnsavedChanges())
        emit warned(tr("The landmarks of %1 are saved. Other changes of the scene are not: choose File > Save Scene As "
                       "to save them.")
                        .arg(name));
    if (isSaved)
        keepTemplate();
    return isSaved;
}

ShownScan::Kept ScanSeries::keepShown(bool isWanted)
{
    m_session.commitTyped();
    if (!m_shown || m_isReadOnly)
        return ShownScan::Kept::AsBefore;
    const ShownScan::Kept kept = m_shownScan.keep(landmarksBeside(m_scans[*m_shown].file, m_placing), isWanted);
    if (const QString problem = m_protocol.keep(kept == ShownScan::Kept::Written); !problem.isEmpty())
        emit failed(problem);
    return kept;
}

void ScanSeries::keepTemplate()
{
    if (!isOpen())
        return;
    const std::vector<Landmark> names = m_shown ? withTemplate(m_names, m_scans[*m_shown].points.landmarks) : m_names;
    const geometry::Result<bool, QString> kept = m_files.keepTemplate(m_folder, names);
    if (!kept)
        emit warned(kept.error());
}

std::optional<RecoverySeries> ScanSeries::series() const
{
    if (!m_shown)
        return std::nullopt;
    const Scan &scan = m_scans[*m_shown];
    return RecoverySeries{m_folder,
                          absolutePath(scan.file),
                          m_placing,
                          m_shownScan.stamp(),
                          static_cast<int>(scan.placedCount()),
                          scan.isKept ? static_cast<int>(placedCount(m_shownScan.saved())) : 0};
}

void ScanSeries::resume(const RecoverySeries &series)
{
    geometry::Result<std::vector<Scan>, QString> scans = scansIn(series.folder);
    const auto isIt = [&series](const Scan &scan) { return scan.file == series.scan; };
    const bool isThere = scans && std::any_of(scans->begin(), scans->end(), isIt);
    if (!isThere) {
        emit failed((scans ? QString() : scans.error() + u'\n')
                    + tr("The series cannot continue at %1. Its landmarks are shown as a scene: export them to keep "
                         "them.")
                          .arg(pathText(series.scan)));
        return;
    }
    m_former.reset();
    m_aside.reset();
    m_isOpening = false;
    takeSeries(series.folder, std::move(scans).value(), series.placing);
    m_current = m_inView =
        static_cast<std::size_t>(std::find_if(m_scans.begin(), m_scans.end(), isIt) - m_scans.begin());
    Scan &scan = m_scans[*m_current];
    const std::filesystem::path file = landmarksBeside(scan.file, m_placing);
    m_shownScan.begin(scan.file, file);
    if (scan.isDamaged) {
        emit failed(scan.problem);
        emit changed();
        emit resumed();
        return;
    }
    const QString loose = m_shownScan.takeRead(scan, m_names, m_curves);
    if (!loose.isEmpty())
        emit warned(QStringLiteral("%1: %2").arg(pathText(file.filename()), loose));
    m_shown = m_current;
    if (LandmarkSet set = m_document.scene().landmarks; set.measures != m_protocol.measures()) {
        set.measures = m_protocol.measures(); // the folder's file is written at each change
        m_document.restoreLandmarks(std::move(set));
    }
    const LandmarkSet &saved = m_shownScan.saved();
    const bool isSaved = m_shownScan.take(scan) && holds(saved.landmarks, scan.points.landmarks);
    if (m_shownScan.stamp() == series.stamp) {
        emit noticed(tr("The series continues at %1.").arg(pathText(scan.file.filename())));
    } else if (isSaved) { // just before the end
        m_shownScan.showSaved();
        emit noticed(tr("The series continues at %1. Its landmarks were saved in %2.")
                         .arg(pathText(scan.file.filename()), pathText(file.filename())));
        keep();
    } else {
        m_shownScan.setStamp(series.stamp); // it is not overwritten
        emit warned(tr("%1 has changed since the landmarks were recovered from the crash: placed in the file: %2; "
                       "recovered: %3. The file is not overwritten; move it away to keep the recovered ones.")
                        .arg(pathText(file))
                        .arg(placedCount(saved))
                        .arg(scan.placedCount()));
    }
    if (const QStringList texts = std::exchange(m_toWarn, {}); !texts.isEmpty())
        emit warned(texts.join(u'\n'));
    m_document.sceneLandmarks().waitForNext(std::nullopt);
    emit changed();
    emit resumed();
}

void ScanSeries::setPlacing(int placing)
{
    if (placing == m_placing || placing < 1 || placing > kMostPlacings)
        return;
    if (!mayPlaceAs(placing)) {
        emit changed(); // the field for the placing shows the present value again
        return;
    }
    if (m_shown) {
        m_history.collect(shownPlacing());
        m_names = withTemplate(std::move(m_names), m_scans[*m_shown].points.landmarks);
    }
    m_placing = placing;
    for (Scan &scan : m_scans)
        read(scan);
    m_shown = std::nullopt;
    if (m_inView) {
        m_current = m_inView;
        takeShown(false);
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
    readAgain();
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
    readAgain();
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
