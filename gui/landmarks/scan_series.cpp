#include "gui/landmarks/scan_series.h"

#include "core/base/path_text.h"
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
using namespace landmark_files;

ScanSeries::ScanSeries(SceneDocument &document, Session &session, QObject *parent)
    : QObject(parent), m_document(document), m_session(session), m_history(document),
      m_shownScan(document, session, m_files, m_protocol, [this] { return m_now.shownScan(); })
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
        if (m_now.inView)
            m_now.aside = SuspendedScan{*m_now.inView, m_now.shown.has_value(), m_now.placing};
        m_now.inView = m_now.shown = std::nullopt;
        m_history.setNoneShown();
    });
    connect(&m_session, &Session::opened, this, [this](const QString &lesson, bool isBack) {
        if (isBack && m_now.aside) {
            comeBack();
            return;
        }
        if (lesson.isEmpty())
            m_now.aside.reset();
        if (m_isOpening && isBack) { // only to be saved
            if (const auto aside = m_former ? std::exchange(m_former->aside, std::nullopt) : std::nullopt;
                aside && aside->placing == m_former->placing) {
                m_former->inView = aside->inView;
                m_former->shown = aside->isShown ? m_former->inView : std::nullopt;
            }
        } else if (m_isOpening) {
            m_former.reset();
            takeShown(true);
        } else if (m_now.current) { // another scene
            m_now.current = std::nullopt;
            emit changed();
        }
    });
    // Cancelled: the shown scan stays, and its landmarks are kept.
    connect(&m_session, &Session::loadingEnded, this, [this] {
        if (!std::exchange(m_isOpening, false))
            return;
        m_now.current = m_now.inView;
        m_target.reset();
        m_passedOver.reset();
        if (m_former && m_wasAsked) // the user did not want to leave the scene
            goBack();
        emit changed();
    });
    connect(&m_session, &Session::failed, this, [this](const QString &reason) {
        if (!m_isOpening || !m_now.current || m_session.isLoading()) // during loading, something else has failed
            return;
        m_isOpening = false;
        m_target.reset();
        m_now.scans[*m_now.current].problem = reason;
        emit changed();
        if (m_passedOver)
            passOver(reason);
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (!(changes & Change::Landmarks) || !m_now.shown)
            return;
        const std::vector<Landmark> before = m_now.scans[*m_now.shown].points.landmarks;
        const std::vector<KeptMeasure> measures = m_protocol.measures();
        if (m_shownScan.take(m_now.scans[*m_now.shown])) // saving waits for the curves
            m_now.dropRemoved(before);
        if (const QString text = leftBehindText(measures, m_protocol.measures(), m_now.scans, *m_now.shown);
            !text.isEmpty())
            emit warned(text);
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
    keepTemplate();
    SeriesState former = std::exchange(m_now, {});
    m_isOpening = false;
    takeSeries(absolute, std::move(scans).value(), 1);
    emit changed();
    m_passedOver = QStringList();
    const std::size_t first = m_now.firstIncomplete(0);
    for (std::size_t i = first; i > 0 && !m_now.scans[first].isKept && m_now.curves.empty(); --i)
        addCurves(m_now.curves, m_now.scans[i - 1].points.curves); // a new scan takes them from the one before
    show(first);
    if (m_isOpening)
        m_former = std::move(former);
    return true;
}

void ScanSeries::takeSeries(const std::filesystem::path &folder, std::vector<Scan> scans, int placing)
{
    m_now = {};
    m_now.folder = folder;
    m_now.scans = std::move(scans);
    m_now.placing = placing;
    m_target.reset();
    geometry::Result<std::optional<std::vector<Landmark>>, QString> own = m_files.readTemplate(folder);
    const bool hasTemplate = own && *own;
    if (hasTemplate)
        m_now.names.add(**own);
    for (Scan &scan : m_now.scans) {
        readKept(scan, m_now.placing);
        if (!hasTemplate)
            m_now.names.add(scan.points.landmarks);
    }
    m_toWarn.clear();
    if (const QString problem = openProtocol(); !problem.isEmpty())
        m_toWarn << problem;
    if (m_now.names.all().empty()) { // the scene's names to place define the series
        m_now.names.add(m_document.landmarks());
        addCurves(m_now.curves, m_document.scene().landmarks.curves);
    }
    for (Scan &scan : m_now.scans)
        withoutUnwanted(scan.points.landmarks, m_now.names.all());
    if (!own)
        m_toWarn << own.error() + u'\n'
                        + tr("Names and hints of the series are not kept. Repair the file or move it away.");
    else if (hasTemplate)
        m_toNotice << tr("The series takes its %1 names from %2.")
                          .arg(m_now.names.all().size())
                          .arg(pathText(seriesTemplate({})));
}

void ScanSeries::readAgain()
{
    for (std::size_t i = 0; i < m_now.scans.size(); ++i) {
        if (i != m_now.shown)
            m_now.read(m_now.scans[i]);
    }
    emit changed();
}

void ScanSeries::keepChosenTemplate()
{
    m_files.setChosen();
    keepTemplate();
}

void ScanSeries::passOver(const QString &reason)
{
    *m_passedOver << reason;
    const std::size_t index = m_now.firstIncomplete(*m_now.current + 1);
    if (!m_now.scans[index].problem.isEmpty()) {
        m_passedOver.reset();
        return;
    }
    std::optional<SeriesState> former = std::move(m_former);
    show(index);
    if (m_isOpening)
        m_former = std::move(former);
}

QString ScanSeries::openProtocol()
{
    return m_protocol.open(m_now.folder, m_document.scene().landmarks.measures);
}

bool ScanSeries::close()
{
    if (!keep())
        return false;
    keepTemplate();
    m_history.forget();
    m_now = {};
    m_protocol.close();
    m_former.reset();
    m_look.reset();
    m_passedOver.reset();
    m_target.reset();
    m_isOpening = false;
    emit changed();
    return true;
}

void ScanSeries::goBack()
{
    m_now = *std::exchange(m_former, std::nullopt);
    m_now.current = m_now.inView;
    static_cast<void>(m_files.readTemplate(m_now.folder)); // chooses its hints again; its names are known
    openProtocol();
}

void ScanSeries::step(int by)
{
    if (m_now.scans.empty())
        return;
    m_target.reset();
    const auto count = static_cast<int>(m_now.scans.size());
    const std::optional<std::size_t> index = m_now.index();
    const int from = index ? static_cast<int>(*index) : by > 0 ? -1 : count;
    if (const int to = from + by; to >= 0 && to < count)
        show(static_cast<std::size_t>(to));
}

void ScanSeries::show(std::size_t index)
{
    Q_ASSERT(index < m_now.scans.size());
    emit leaving();
    if (const QStringList texts = std::exchange(m_toNotice, {}); !texts.isEmpty())
        emit noticed(texts.join(u' '));
    if (!keep())
        return;
    if (const Scan *before = m_now.lastShown()) {
        m_now.names.add(m_now.names.with(before));
        m_now.curves = before->points.curves;
        std::erase_if(m_now.curves, [this](const Curve &curve) { return m_isReadOnly || curve.points.empty(); });
    }
    m_isOpening = true;
    m_wasAsked = false;
    m_former.reset();
    m_now.current = index;
    m_session.openFiles({m_now.scans[index].file});
    if (m_session.isLoading()) { // the earlier loading was cancelled and reported
        m_isOpening = true;
        m_now.current = index;
    }
    emit changed();
}

void ScanSeries::takeShown(bool isLoaded)
{
    m_isOpening = false;
    m_now.inView = m_now.current;
    Scan &scan = m_now.scans[*m_now.current];
    if (isLoaded && m_look)
        fitAllFrom(m_document, m_look->first, m_look->second);
    if (const QStringList passed = std::exchange(m_passedOver, std::nullopt).value_or(QStringList()); passed.size() > 1)
        m_toWarn << passed;
    if (const QStringList texts = std::exchange(m_toWarn, {}); !texts.isEmpty())
        emit warned(texts.join(u'\n'));
    m_shownScan.begin(scan.file, landmarksBeside(scan.file, m_now.placing));
    scan.problem.clear();
    m_now.read(scan);
    m_now.names.begin(scan);
    if (scan.isDamaged) { // not overwritten: the user may want to repair it
        putHistoryBack();
        emit failed(scan.problem + u'\n'
                    + tr("The file is not overwritten: to keep new landmarks, save the scene. Or repair or move the "
                         "file, and open the scan again.")
                    + nextScanText());
        emit changed();
        return;
    }
    const QString loose = m_shownScan.takeRead(scan, m_now.names.all(), m_now.curves);
    m_shownScan.showSaved();
    putHistoryBack();
    m_document.markSaved();
    m_now.shown = m_now.current;
    m_document.sceneLandmarks().waitForNext(std::nullopt);
    if (!loose.isEmpty())
        emit warned(
            QStringLiteral("%1: %2").arg(pathText(landmarksBeside(scan.file, m_now.placing).filename()), loose));
    emit changed();
    emit scanShown();
    runTarget();
}

QString ScanSeries::nextScanText() const
{
    return hasNext() ? u'\n' + tr("Press Ctrl+PgDown for the next scan.") : QString();
}

ScanPlacing ScanSeries::shownPlacing() const
{
    return {m_now.scans[*m_now.inView].file, m_now.placing};
}

void ScanSeries::putHistoryBack()
{
    m_history.putBack(shownPlacing(),
                      [this](const std::filesystem::path &file) { return m_now.indexOf(file).has_value(); });
}

void ScanSeries::goTo(const std::shared_ptr<const ScanStep> &step, bool isRedo)
{
    const std::optional<std::size_t> index = m_now.indexOf(step->where.scan);
    if (!index || m_isOpening)
        return;
    m_target = {step, isRedo};
    if (step->where.placing != m_now.placing)
        setPlacing(step->where.placing);
    if (!m_target || step->where.placing != m_now.placing) { // done, or refused with a reason
        m_target.reset();
        return;
    }
    show(*index);
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
    const SuspendedScan aside = *std::exchange(m_now.aside, std::nullopt);
    if (aside.placing != m_now.placing) {
        m_now.placing = aside.placing;
        for (Scan &scan : m_now.scans)
            m_now.read(scan);
    }
    m_now.inView = aside.inView;
    if (!m_isOpening) // else it is restored only to be saved
        m_now.current = m_now.inView;
    if (aside.isShown) {
        m_now.shown = m_now.inView;
        m_shownScan.take(m_now.scans[*m_now.shown]);
    }
    putHistoryBack();
    emit changed();
    emit scanShown();
}

bool ScanSeries::keep()
{
    const ShownScan::Kept kept = keepShown(false);
    return kept != ShownScan::Kept::Failed && kept != ShownScan::Kept::Cancelled;
}

bool ScanSeries::keepBeforeLeaving()
{
    m_wasAsked = m_isOpening;
    if (m_now.inView)
        m_look = {*m_document.scene().camera, *m_document.scene().projection};
    const ShownScan::Kept kept = keepShown(false);
    if (m_now.shown)
        m_history.collect(shownPlacing());
    if (kept != ShownScan::Kept::Cancelled)
        keepTemplate();
    return kept != ShownScan::Kept::Cancelled;
}

std::optional<bool> ScanSeries::save()
{
    if (!m_now.shown)
        return std::nullopt;
    const ShownScan::Kept kept = keepShown(true);
    const Scan &scan = m_now.scans[*m_now.shown];
    const QString name = pathText(scan.file.filename()),
                  file = pathText(landmarksBeside(scan.file, m_now.placing).filename());
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
    if (!m_now.shown || m_isReadOnly)
        return ShownScan::Kept::AsBefore;
    const ShownScan::Kept kept =
        m_shownScan.keep(landmarksBeside(m_now.scans[*m_now.shown].file, m_now.placing), isWanted);
    if (const QString problem = m_protocol.keep(kept == ShownScan::Kept::Written); !problem.isEmpty())
        emit failed(problem);
    return kept;
}

void ScanSeries::keepTemplate()
{
    if (!isOpen())
        return;
    const auto kept = m_files.keepTemplate(m_now.folder, m_now.names.with(m_now.lastShown()));
    if (!kept)
        emit warned(kept.error());
}

std::optional<RecoverySeries> ScanSeries::series() const
{
    if (!m_now.shown)
        return std::nullopt;
    const Scan &scan = m_now.scans[*m_now.shown];
    return RecoverySeries{m_now.folder,
                          absolutePath(scan.file),
                          m_now.placing,
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
    m_isOpening = false;
    takeSeries(series.folder, std::move(scans).value(), series.placing);
    m_now.current = m_now.inView = m_now.indexOf(series.scan);
    Scan &scan = m_now.scans[*m_now.current];
    const std::filesystem::path file = landmarksBeside(scan.file, m_now.placing);
    m_shownScan.begin(scan.file, file);
    if (scan.isDamaged) {
        emit failed(scan.problem + nextScanText());
        emit changed();
        emit resumed();
        return;
    }
    m_now.names.begin(scan);
    const QString loose = m_shownScan.takeRead(scan, m_now.names.all(), m_now.curves);
    if (!loose.isEmpty())
        emit warned(QStringLiteral("%1: %2").arg(pathText(file.filename()), loose));
    m_now.shown = m_now.current;
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
    m_toNotice.clear(); // the message about the scan is shown
    m_document.sceneLandmarks().waitForNext(std::nullopt);
    emit changed();
    emit scanShown();
    emit resumed();
}

void ScanSeries::setPlacing(int placing)
{
    if (placing == m_now.placing || placing < 1 || placing > kMostPlacings)
        return;
    if (!mayPlaceAs(placing)) {
        emit changed(); // the field for the placing shows the present value again
        return;
    }
    if (m_now.shown) {
        m_history.collect(shownPlacing());
        m_now.names.add(m_now.names.with(m_now.shownScan()));
    }
    m_now.placing = placing;
    for (Scan &scan : m_now.scans)
        m_now.read(scan);
    m_now.shown = std::nullopt;
    if (m_now.inView) {
        m_now.current = m_now.inView;
        takeShown(false);
    }
    emit changed();
}

bool ScanSeries::mayPlaceAs(int placing)
{
    if (!keep())
        return false;
    if (!m_now.inView)
        return true;
    Scan other{m_now.scans[*m_now.inView].file, {}, {}};
    readKept(other, placing);
    if (other.isDamaged) {
        emit failed(other.problem + u'\n'
                    + tr("Placing %1 continues. Repair the file, or move it away.").arg(m_now.placing));
        return false;
    }
    // Changes that are not saved beside the scan would be lost.
    return m_now.shown || !m_document.isEdited() || m_session.mayLeave();
}

std::optional<SeriesRepeats> ScanSeries::repeats()
{
    if (!keep())
        return std::nullopt;
    readAgain();
    SeriesRepeats found = repeatsIn(m_now.scans);
    if (const auto table = errorsTable(found.specimens); !table) { // placings in several units
        emit failed(QString::fromStdString(table.error().message()));
        return std::nullopt;
    }
    return found;
}

bool ScanSeries::exportTable(const std::filesystem::path &file, Table table)
{
    if (!keep())
        return false;
    readAgain();
    const auto written =
        writeSeries(file, table, {m_now.scans, m_now.names.all(), measures(), m_now.placing, m_waiting});
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
