#include "gui/document/point_files.h"

#include "core/files/path_text.h"
#include "core/landmark_files/landmark_file.h"
#include "gui/document/object_names.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"

#include <QCursor>
#include <QGuiApplication>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace unprojector::gui {
namespace {

using namespace landmark_files;

/// Shows that the program is busy while it lives.
class Waiting {
public:
    Waiting() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~Waiting() { QGuiApplication::restoreOverrideCursor(); }
    Waiting(const Waiting &) = delete;
    Waiting &operator=(const Waiting &) = delete;
};

/// How far points were moved, and which one farthest.
struct Moved {
    std::size_t count = 0;
    double most = 0.0, share = 0.0; ///< world units, and of the object's size
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

QString sentences(const QString &file, const std::vector<LandmarkNote> &notes)
{
    QStringList lines;
    for (const LandmarkNote &note : notes)
        lines << QStringLiteral("%1: %2.").arg(file, QString::fromStdString(noteText(note)));
    return lines.join(u'\n');
}

/// The keys of other programs that only one of both has come to it; which of the others are left out.
QStringList addKeys(nlohmann::ordered_json &to, const nlohmann::ordered_json &from)
{
    QStringList leftOut;
    for (auto it = from.begin(); from.is_object() && it != from.end(); ++it) {
        if (!to.is_object() || !to.contains(it.key()))
            to[it.key()] = *it;
        else if (to[it.key()] != *it)
            leftOut << QString::fromStdString(it.key());
    }
    return leftOut;
}

/// What the scene has besides points stays where the file says nothing of it, and units are never changed in silence.
/// @return what is to be said of that
QStringList replace(landmarks::LandmarkSet &set, const landmarks::LandmarkSet &before, const QString &file)
{
    QStringList notes;
    if (set.unit.empty())
        set.unit = before.unit;
    else if (!before.unit.empty() && set.unit != before.unit)
        notes << PointFiles::tr("%1 is in %2: that is the scene's unit now, instead of %3. Nothing is converted.")
                     .arg(file, QString::fromStdString(set.unit), QString::fromStdString(before.unit));
    if (set.name.empty())
        set.name = before.name;
    if (set.mesh.empty())
        set.mesh = before.mesh;
    if (set.curves.empty())
        set.curves = before.curves;   // through points by their names
    addKeys(set.extra, before.extra); // of one key the file's is the newer
    return notes;
}

/// Puts points behind those before; one whose name waits for a place there takes that.
void append(std::vector<landmarks::Landmark> &all, std::vector<landmarks::Landmark> points)
{
    const auto before = static_cast<std::ptrdiff_t>(all.size());
    std::vector<bool> isTaken(all.size(), false);
    for (landmarks::Landmark &point : points) {
        const QString name = QString::fromStdString(point.name);
        const auto waiting = std::find_if(all.begin(), all.begin() + before, [&](const landmarks::Landmark &other) {
            return other.isMissing() && !isTaken[static_cast<std::size_t>(&other - all.data())] && !name.isEmpty()
                   && QString::fromStdString(other.name).compare(name, Qt::CaseInsensitive) == 0;
        });
        if (waiting == all.begin() + before) {
            all.push_back(std::move(point));
            continue;
        }
        isTaken[static_cast<std::size_t>(waiting - all.begin())] = true;
        if (point.note.empty())
            point.note = waiting->note;
        if (!point.color)
            point.color = waiting->color;
        addKeys(point.extra, waiting->extra);
        *waiting = std::move(point);
    }
}

QStringList append(landmarks::LandmarkSet &set, const landmarks::LandmarkSet &before, const QString &file)
{
    QStringList notes;
    landmarks::LandmarkSet all = before;
    append(all.landmarks, std::move(set.landmarks));
    all.curves.insert(all.curves.end(), std::make_move_iterator(set.curves.begin()),
                      std::make_move_iterator(set.curves.end()));
    if (!set.unit.empty() && set.unit != before.unit)
        notes << (before.unit.empty()
                      ? PointFiles::tr("%1 is in %2, and what the scene is in is not known. Nothing is converted.")
                            .arg(file, QString::fromStdString(set.unit))
                      : PointFiles::tr("%1 is in %2, and the scene in %3. Nothing is converted.")
                            .arg(file, QString::fromStdString(set.unit), QString::fromStdString(before.unit)));
    if (const QStringList leftOut = addKeys(all.extra, set.extra); !leftOut.isEmpty())
        notes << PointFiles::tr("%1: the scene has other values of these already, which stay: %2.")
                     .arg(file, leftOut.join(QStringLiteral(", ")));
    set = std::move(all);
    return notes;
}

} // namespace

PointFiles::PointFiles(SceneDocument &document, PointFileQuestions *questions, QObject *parent)
    : QObject(parent), m_document(document), m_questions(questions)
{
}

bool PointFiles::isPointFile(const std::filesystem::path &file)
{
    const std::optional<Format> format = formatOf(file);
    const bool isOtherJson =
        format == Format::SlicerJson
        && pathText(file.stem().extension()).compare(QStringLiteral(".mrk"), Qt::CaseInsensitive) != 0;
    return format && *format != Format::Nts && *format != Format::MeshLabTemplate && !isOtherJson;
}

bool PointFiles::isTemplate(const std::filesystem::path &file)
{
    return formatOf(file) == Format::MeshLabTemplate;
}

QString PointFiles::importFilter()
{
    QStringList patterns;
    for (const Format format : kFormats) {
        if (format != Format::Nts && format != Format::MeshLabTemplate)
            patterns << patternOf(format);
    }
    return tr("Points (%1)").arg(patterns.join(u' '));
}

QString PointFiles::exportFilters()
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

std::vector<ray::TyingTarget> PointFiles::targets() const
{
    std::vector<ray::TyingTarget> targets;
    for (const SceneObject &object : m_document.objects()) {
        if (!object.isHidden && !object.model->bounds.isEmpty())
            targets.push_back(
                {object.name, ray::ClosestPlaces::build(object.model, {}), worldFromObject(object.transform)});
    }
    return targets;
}

std::optional<QString> PointFiles::tieAll(std::vector<landmarks::Landmark> &points)
{
    std::vector<Stray> strays;
    Moved onMesh, farOff; // of those near the mesh, and of the strays
    std::size_t missing = 0, free = 0;
    const Waiting waiting;
    const std::vector<ray::TyingTarget> targets = this->targets();
    for (std::size_t i = 0; i < points.size(); ++i) {
        landmarks::Landmark before = points[i];
        const std::optional<ray::Tied> now = ray::tieToMesh(points[i], targets);
        if (!now) { // beyond all distances, where it has a place
            ++(points[i].isMissing() ? missing : free);
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
        (isStray ? farOff : onMesh).add(now->distance, share, ScenePoints::shownNameOf(points, i));
    }
    if (!strays.empty()) {
        const QString text =
            tr("Points far from every object: %1. “%2” is %3 off, which is %4 % of the object's size. Are they "
               "of another object, or in other axes?")
                .arg(QString::number(strays.size()), farOff.name, readableText(farOff.most),
                     readableText(100.0 * farOff.share));
        QGuiApplication::setOverrideCursor(Qt::ArrowCursor);
        const auto answer = m_questions ? m_questions->askStray(text) : PointFileQuestions::Stray::LeaveFree;
        QGuiApplication::restoreOverrideCursor();
        if (answer == PointFileQuestions::Stray::Cancel)
            return std::nullopt;
        if (answer == PointFileQuestions::Stray::LeaveFree) {
            free += strays.size();
            for (Stray &stray : strays) {
                points[stray.place] = std::move(stray.untied);
                points[stray.place].hold = landmarks::Free{};
            }
        } else {
            onMesh.count += farOff.count;
            if (farOff.most > onMesh.most)
                std::tie(onMesh.most, onMesh.share, onMesh.name) = std::tie(farOff.most, farOff.share, farOff.name);
        }
    }
    QStringList said; // the counts add up to all points
    if (onMesh.count > 0 && onMesh.count < points.size())
        said << tr("On the mesh: %1.").arg(onMesh.count);
    constexpr double kRounding = 1e-12;
    if (onMesh.count > 0)
        said << (onMesh.share > kRounding ? tr("They were moved onto the mesh by at most %1 (%2).")
                                                .arg(readableText(onMesh.most), onMesh.name)
                                          : tr("They lie on the mesh."));
    if (free > 0 && !targets.empty())
        said << tr("Free where they are, far from it: %1.").arg(free);
    if (missing > 0)
        said << tr("Without a place: %1.").arg(missing);
    return said.join(u' ');
}

PointFileQuestions::Join PointFiles::howToJoin(const landmarks::LandmarkSet &coming) const
{
    using Join = PointFileQuestions::Join;
    const std::vector<landmarks::Landmark> &there = m_document.landmarks();
    const auto waiting = std::count_if(there.begin(), there.end(), [](const auto &point) { return point.isMissing(); });
    const auto placed = static_cast<std::ptrdiff_t>(there.size()) - waiting;
    if (placed == 0) // nothing is lost
        return Join::Replace;
    return m_questions ? m_questions->askJoin(
               {static_cast<int>(placed), static_cast<int>(waiting), static_cast<int>(coming.landmarks.size())})
                       : Join::Replace;
}

bool PointFiles::importFrom(const std::filesystem::path &file)
{
    auto result = readLandmarkFile(file);
    if (!result) {
        emit failed(QString::fromStdString(errorText(result.error())));
        return false;
    }
    ReadLandmarks read = std::move(result).value();
    // Whatever comes to an end while a question is open, as the loading of a model, may show another scene below it.
    bool isSameScene = true;
    const auto changed = connect(&m_document, &SceneDocument::changed, this, [&isSameScene](Changes changes) {
        if (changes & (Change::Objects | Change::Landmarks))
            isSameScene = false;
    });
    landmarks::LandmarkSet set = std::move(read.sets.front());
    const PointFileQuestions::Join join = howToJoin(set);
    const std::optional<QString> done = join == PointFileQuestions::Join::Cancel ? std::nullopt : tieAll(set.landmarks);
    disconnect(changed);
    if (!done)
        return false;
    const QString name = pathText(file.filename());
    if (!isSameScene) {
        emit failed(tr("%1: the scene has changed meanwhile. Import the points again.").arg(name));
        return false;
    }
    const std::size_t count = set.landmarks.size();
    const std::vector<landmarks::Landmark> &there = m_document.landmarks();
    if (std::all_of(there.begin(), there.end(), [](const auto &point) { return point.isMissing(); })) {
        std::vector<landmarks::Landmark> filled = there; // names that wait are there for that
        append(filled, std::move(set.landmarks));
        set.landmarks = std::move(filled);
    }
    QStringList notes;
    if (const QString lost = sentences(name, read.notes); !lost.isEmpty())
        notes << lost;
    if (read.sets.size() > 1)
        notes << tr("%1 has %2 specimens; the points of the first are shown.").arg(name).arg(read.sets.size());
    notes << (join == PointFileQuestions::Join::Append ? append(set, m_document.landmarkSet(), name)
                                                       : replace(set, m_document.landmarkSet(), name));
    static_cast<void>(m_document.editLandmarkSet(std::move(set), {tr("Import points")}));
    if (!notes.isEmpty())
        emit warned(notes.join(u'\n'));
    QString said = tr("Points read from %1: %2.").arg(name).arg(count) + u' ' + *done;
    if (m_document.objects().empty()) {
        m_document.fit();
        said += tr("There is no object that they lie on: open their scan together with them.");
    }
    emit noticed(said.trimmed());
    return true;
}

bool PointFiles::exportTo(const std::filesystem::path &file)
{
    std::optional<landmarks::LandmarkSet> known = m_document.curves().withSemilandmarks();
    if (!known) {
        emit noticed(tr("%1 was not written.").arg(pathText(file.filename())));
        return false;
    }
    landmarks::LandmarkSet set = *std::move(known);
    const std::optional<Format> format = formatOf(file);
    const auto model = std::find_if(m_document.objects().begin(), m_document.objects().end(),
                                    [](const SceneObject &object) { return !object.file.empty(); });
    if (model != m_document.objects().end()) {
        if (set.mesh.empty() && format == Format::MeshLab)
            set.mesh = files::utf8FromPath(model->file.filename());
        if (set.name.empty() && (format == Format::Tps || format == Format::Nts))
            set.name = files::utf8FromPath(model->file.stem());
    }
    const auto written = writeLandmarkFile(file, {&set, 1});
    if (!written) {
        emit failed(QString::fromStdString(errorText(written.error())));
        return false;
    }
    const QString name = pathText(file.filename());
    if (!written->empty())
        emit warned(sentences(name, *written));
    emit noticed(tr("Points written to %1: %2.").arg(name).arg(set.landmarks.size()));
    return true;
}

} // namespace unprojector::gui
