#include "gui/document/landmark_files.h"

#include "core/base/path_text.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/measures_file.h"
#include "core/landmark_files/sliders.h"
#include "core/landmark_files/specimen_table.h"
#include "core/scene_file/scene_file.h"
#include "gui/document/camera_looks.h"
#include "gui/document/landmark_joining.h"
#include "gui/document/object_names.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"

#include <QCursor>
#include <QGuiApplication>

#include <algorithm>
#include <map>
#include <system_error>
#include <tuple>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

using namespace landmark_files;

/// Shows a busy cursor while it lives.
class Waiting {
public:
    Waiting() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~Waiting() { QGuiApplication::restoreOverrideCursor(); }
    Waiting(const Waiting &) = delete;
    Waiting &operator=(const Waiting &) = delete;
};

/// The distances of moved points, and the largest one.
struct Moved {
    std::size_t count = 0;
    double most = 0.0, share = 0.0; ///< world units, and relative to the object's size
    QString name;

    void add(double distance, double ofSize, const QString &point)
    {
        if (count++ > 0 && distance <= most)
            return;
        most = distance;
        share = ofSize;
        name = point;
    }
};

QString patternOf(Format format)
{
    return QStringLiteral("*.") + QLatin1String(suffixOf(format));
}

/// "“a”, “b”, “c” and 4 more"
QString namesText(const QStringList &names)
{
    constexpr qsizetype kMost = 5;
    QStringList quoted;
    for (const QString &name : names.mid(0, kMost))
        quoted << LandmarkFiles::tr("“%1”").arg(name);
    const QString shown = quoted.join(LandmarkFiles::tr(", ", "between names"));
    return names.size() > kMost ? LandmarkFiles::tr("%1 and %2 more").arg(shown).arg(names.size() - kMost) : shown;
}

/// @param taken  how many of the last curves were points in the file
QString semilandmarksText(const landmarks::LandmarkSet &set, std::size_t taken)
{
    QStringList names;
    std::size_t count = 0;
    for (auto curve = set.curves.end() - static_cast<std::ptrdiff_t>(taken); curve != set.curves.end(); ++curve) {
        names << QString::fromStdString(curve->name).simplified();
        count += curve->semilandmarks.size();
    }
    return LandmarkFiles::tr("Semilandmarks, not imported as landmarks: %1, of %2.")
        .arg(QString::number(count), namesText(names));
}

/// Reports names of a file that match none to place, and names that are still unplaced.
void tellUnmatched(const JoinedLandmarks &joined, const landmarks::LandmarkSet &after, const QString &file,
                   QStringList &notes, QStringList &said)
{
    if (joined.filled > 0)
        said << LandmarkFiles::tr("Names filled: %1.").arg(joined.filled);
    if (joined.unmatched.empty())
        return;
    QStringList unmatched, waiting, sentences;
    for (const std::string &name : joined.unmatched) {
        if (!name.empty())
            unmatched << QString::fromStdString(name).simplified();
    }
    for (const landmarks::Landmark &landmark : after.landmarks) {
        if (!landmark.isPlaced())
            waiting << QString::fromStdString(landmark.name).simplified();
    }
    if (!unmatched.isEmpty())
        sentences << LandmarkFiles::tr("%1: names that are not in the template, appended: %2.")
                         .arg(file, namesText(unmatched));
    if (const qsizetype nameless = static_cast<qsizetype>(joined.unmatched.size()) - unmatched.size(); nameless > 0)
        sentences << LandmarkFiles::tr("%1: landmarks without a name, appended: %2.").arg(file).arg(nameless);
    if (!waiting.isEmpty())
        sentences << LandmarkFiles::tr("Still to place: %1.").arg(namesText(waiting));
    notes << joinSentences(sentences);
}

} // namespace

LandmarkFiles::LandmarkFiles(SceneDocument &document, LandmarkFileQuestions *questions, QObject *parent)
    : QObject(parent), m_document(document), m_questions(questions)
{
}

bool LandmarkFiles::isLandmarkFile(const std::filesystem::path &file)
{
    const std::optional<Format> format = readFormatOf(file);
    const bool isOtherJson =
        format == Format::SlicerJson
        && pathText(file.stem().extension()).compare(QStringLiteral(".mrk"), Qt::CaseInsensitive) != 0;
    if (!format || *format == Format::MeshLabTemplate || isOtherJson || isSlidersFile(file) || isMeasuresFile(file))
        return false;
    return formatOf(file) || !scene_file::isSceneFile(file); // a text may be a scene under another suffix
}

bool LandmarkFiles::isTemplate(const std::filesystem::path &file)
{
    return formatOf(file) == Format::MeshLabTemplate;
}

QString LandmarkFiles::importFilter()
{
    QStringList patterns;
    for (const Format format : kFormats) {
        if (format != Format::MeshLabTemplate)
            patterns << patternOf(format);
    }
    for (const char *other : {"*.dta", "*.txt", "*.tsv"}) // NTSYS's matrices, and tables
        patterns << QLatin1String(other);
    return tr("Landmarks (%1)").arg(patterns.join(u' '));
}

QString LandmarkFiles::exportFilters()
{
    const std::map<Format, QString> names{{Format::Csv, tr("Table (%1)")},
                                          {Format::MeshLab, tr("MeshLab, picked points (%1)")},
                                          {Format::SlicerJson, tr("3D Slicer, markups (%1)")},
                                          {Format::SlicerCsv, tr("3D Slicer, older markups (%1)")},
                                          {Format::Idav, tr("IDAV Landmark (%1)")},
                                          {Format::Tps, tr("TPS of geomorph and tpsDig (%1)")},
                                          {Format::Nts, tr("NTSYS (%1)")}};
    QStringList filters;
    for (const auto &[format, name] : names)
        filters << name.arg(patternOf(format));
    return filters.join(QStringLiteral(";;"));
}

std::vector<ray::TyingTarget> LandmarkFiles::targets() const
{
    std::vector<ray::TyingTarget> targets;
    for (const SceneObject &object : m_document.objects()) {
        if (!object.isHidden && !object.model->bounds.isEmpty())
            targets.push_back(
                {object.name, ray::ClosestPlaces::build(object.model, {}), worldFromObject(object.transform)});
    }
    return targets;
}

std::optional<QString> LandmarkFiles::tieAll(std::vector<landmarks::Landmark> &landmarks)
{
    std::vector<Stray> strays;
    Moved onMesh, farOff; // of points near the mesh, and of strays
    std::size_t toPlace = 0, missing = 0, free = 0;
    const Waiting waiting;
    const std::vector<ray::TyingTarget> targets = this->targets();
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        landmarks::Landmark before = landmarks[i];
        const std::optional<ray::Tied> now = ray::tieToMesh(landmarks[i], targets);
        if (!now) { // beyond all distances: it keeps its position
            ++(landmarks[i].isPlaced() ? free : landmarks[i].isMissing() ? missing : toPlace);
            continue;
        }
        const ray::TyingTarget &target = targets[now->target];
        Box bounds;
        for (const SceneObject &object : m_document.objects()) {
            if (object.name == target.name)
                bounds = boundsOf(object);
        }
        const double share = now->distance / bounds.diagonal();
        const bool isStray = share > ray::kFarFromMesh;
        if (isStray)
            strays.push_back({i, std::move(before)});
        (isStray ? farOff : onMesh).add(now->distance, share, SceneLandmarks::shownNameOf(landmarks, i));
    }
    if (!strays.empty()) {
        const QString text = tr("Landmarks far from every object: %1. “%2” is %3 away, %4 % of the object's size. Do "
                                "they belong to another object, or use other axes?")
                                 .arg(QString::number(strays.size()), farOff.name, readableText(farOff.most),
                                      readableText(100.0 * farOff.share));
        QGuiApplication::setOverrideCursor(Qt::ArrowCursor);
        const auto answer = m_questions ? m_questions->askStray(text) : LandmarkFileQuestions::Stray::LeaveFree;
        QGuiApplication::restoreOverrideCursor();
        if (answer == LandmarkFileQuestions::Stray::Cancel)
            return std::nullopt;
        if (answer == LandmarkFileQuestions::Stray::LeaveFree) {
            free += strays.size();
            for (Stray &stray : strays) {
                landmarks[stray.index] = std::move(stray.untied);
                landmarks[stray.index].anchor = landmarks::Free{};
            }
        } else {
            onMesh.count += farOff.count;
            if (farOff.most > onMesh.most)
                std::tie(onMesh.most, onMesh.share, onMesh.name) = std::tie(farOff.most, farOff.share, farOff.name);
        }
    }
    QStringList said; // the counts add up to all points
    if (onMesh.count > 0 && onMesh.count < landmarks.size())
        said << tr("On the mesh: %1.").arg(onMesh.count);
    constexpr double kRounding = 1e-12;
    if (onMesh.count > 0)
        said << (onMesh.share > kRounding ? tr("They were moved onto the mesh by at most %1 (%2).")
                                                .arg(readableText(onMesh.most), onMesh.name)
                                          : tr("They lie on the mesh."));
    if (free > 0 && !targets.empty())
        said << tr("Left free, far from the mesh: %1.").arg(free);
    if (toPlace > 0)
        said << tr("Not placed: %1.").arg(toPlace);
    if (missing > 0)
        said << tr("Missing on this specimen: %1.").arg(missing);
    return joinSentences(said);
}

LandmarkFileQuestions::Join LandmarkFiles::howToJoin(const landmarks::LandmarkSet &coming) const
{
    using Join = LandmarkFileQuestions::Join;
    const std::vector<landmarks::Landmark> &there = m_document.landmarks();
    const auto waiting = std::count_if(there.begin(), there.end(), [](const auto &point) { return !point.isPlaced(); });
    const auto placed = static_cast<std::ptrdiff_t>(there.size()) - waiting;
    if (placed == 0) // nothing is lost
        return Join::Replace;
    return m_questions ? m_questions->askJoin(
               {static_cast<int>(placed), static_cast<int>(waiting), static_cast<int>(coming.landmarks.size())})
                       : Join::Replace;
}

bool LandmarkFiles::nameAll(std::vector<landmarks::Landmark> &landmarks, LandmarkFileQuestions::Join join,
                            const QString &file, QStringList &notes)
{
    const std::vector<landmarks::Landmark> &there = m_document.landmarks();
    const auto waiting = static_cast<std::size_t>(std::count_if(
        there.begin(), there.end(), [](const auto &point) { return !point.isPlaced() && !point.name.empty(); }));
    const bool isReplacing = join == LandmarkFileQuestions::Join::Replace
                             && std::any_of(there.begin(), there.end(), [](const auto &p) { return p.isPlaced(); });
    if (!areNameless(landmarks) || waiting == 0 || isReplacing)
        return true;
    if (landmarks.size() != waiting) {
        const QString text = tr("%1 has landmarks without names: %2. Names to place: %3. Assign these names in order, "
                                "or append the landmarks without names?")
                                 .arg(file)
                                 .arg(landmarks.size())
                                 .arg(waiting);
        const auto answer = m_questions ? m_questions->askOrder(text) : LandmarkFileQuestions::Order::Behind;
        if (answer == LandmarkFileQuestions::Order::Cancel)
            return false;
        if (answer == LandmarkFileQuestions::Order::Behind)
            return true;
    }
    nameByOrder(landmarks, there);
    notes << tr("%1 has no names: its landmarks took the unplaced names in order. Check that the order is right.")
                 .arg(file);
    return true;
}

bool LandmarkFiles::importFrom(const std::filesystem::path &file)
{
    auto result = readLandmarkFile(file);
    if (!result) {
        emit failed(QString::fromStdString(result.error().message()));
        return false;
    }
    ReadLandmarks read = std::move(result).value();
    // An event such as the end of a loading may show another scene while a question is open.
    bool isSameScene = true;
    const auto changed = connect(&m_document, &SceneDocument::changed, this, [&isSameScene](Changes changes) {
        if (changes & (Change::Objects | Change::Landmarks))
            isSameScene = false;
    });
    landmarks::LandmarkSet set = std::move(read.sets.front());
    const QString name = pathText(file.filename());
    const std::size_t taken = set.curves.empty() ? takeSemilandmarks(set) : 0;
    const LandmarkFileQuestions::Join join = howToJoin(set);
    QStringList notes;
    const bool isGoing = join != LandmarkFileQuestions::Join::Cancel && nameAll(set.landmarks, join, name, notes);
    const std::optional<QString> done = isGoing ? tieAll(set.landmarks) : std::nullopt;
    disconnect(changed);
    if (!done)
        return false;
    if (!isSameScene) {
        emit failed(tr("%1: the scene has changed meanwhile. Import the landmarks again.").arg(name));
        return false;
    }
    const std::size_t count = set.landmarks.size();
    QStringList said{tr("Landmarks read from %1: %2.").arg(name).arg(count), *done};
    if (taken > 0)
        said << semilandmarksText(set, taken);
    const landmarks::LandmarkSet &before = m_document.scene().landmarks;
    if (const QString lost = landmarkNotesText(name, read.notes); !lost.isEmpty())
        notes << lost;
    if (read.sets.size() > 1)
        notes << tr("%1 has %2 specimens; the landmarks of the first are shown.").arg(name).arg(read.sets.size());
    JoinedLandmarks joined;
    if (join == LandmarkFileQuestions::Join::Append) {
        joined = appendLandmarks(set, before, taken, name);
    } else {
        const bool areAllWaiting = std::all_of(before.landmarks.begin(), before.landmarks.end(),
                                               [](const auto &point) { return !point.isPlaced(); });
        if (areAllWaiting) // names to place are there to be filled
            joined = fillLandmarks(set, before.landmarks);
        joined.notes << replaceLandmarks(set, before, taken, name).notes;
    }
    notes << joined.notes;
    tellUnmatched(joined, set, name, notes, said);
    static_cast<void>(editLandmarkSet(m_document, std::move(set), {tr("Import landmarks")}));
    if (!notes.isEmpty())
        emit warned(notes.join(u'\n'));
    if (m_document.objects().empty()) {
        fitAll(m_document);
        said << tr("No object is under them: open their scan together with them.");
    }
    emit noticed(joinSentences(said));
    return true;
}

bool LandmarkFiles::exportTo(const std::filesystem::path &file, std::span<const landmarks::Landmark> names)
{
    geometry::Result<landmarks::LandmarkSet, QString> known = m_document.curves().withSemilandmarks();
    if (!known) {
        emit noticed(tr("%1 was not written: %2.").arg(pathText(file.filename()), known.error()));
        return false;
    }
    landmarks::LandmarkSet set = std::move(known).value();
    const std::optional<Format> format = formatOf(file);
    if (!names.empty() && (format == Format::Tps || format == Format::Nts)) // their rows have no names
        set = inOrderOf(std::move(set), names);
    const auto model = std::find_if(m_document.objects().begin(), m_document.objects().end(),
                                    [](const SceneObject &object) { return !object.file.empty(); });
    if (model != m_document.objects().end()) {
        if (set.mesh.empty() && format == Format::MeshLab)
            set.mesh = base::utf8FromPath(model->file.filename());
        if (set.name.empty() && (format == Format::Tps || format == Format::Nts))
            set.name = base::utf8FromPath(model->file.stem());
    }
    const auto written = writeLandmarkFile(file, {&set, 1});
    if (!written) {
        emit failed(QString::fromStdString(written.error().message()));
        return false;
    }
    const QString name = pathText(file.filename());
    QStringList lost, said{tr("Landmarks written to %1: %2.").arg(name).arg(set.landmarks.size())};
    if (!written->empty())
        lost << landmarkNotesText(name, *written);
    if (format != Format::SlicerJson && format != Format::MeshLabTemplate) { // the others number semilandmarks
        const SlidersReport sliders = writeSliders(file, slidersOf({&set, 1}));
        said << sliders.said;
        lost << sliders.lost;
    }
    if (!lost.isEmpty())
        emit warned(lost.join(u'\n'));
    emit noticed(joinSentences(said));
    return true;
}

SlidersReport writeSliders(const std::filesystem::path &table, const base::Expected<Sliders, base::Error> &sliders)
{
    SlidersReport report;
    const auto written = writeSlidersBeside(table, sliders);
    if (!written)
        report.lost << QString::fromStdString(written.error().message());
    else if (*written)
        report.said << LandmarkFiles::tr("The sliders of the semilandmarks, for geomorph's gpagen(curves=), are in %1.")
                           .arg(pathText((*written)->filename()));
    std::error_code error;
    if (const std::filesystem::path older = slidersBeside(table);
        (!written || !*written) && std::filesystem::exists(older, error))
        report.lost << LandmarkFiles::tr("%1 is of an earlier export and does not fit %2. Remove it.")
                           .arg(pathText(older.filename()), pathText(table.filename()));
    return report;
}

} // namespace unprojector::gui
