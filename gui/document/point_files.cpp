#include "gui/document/point_files.h"

#include "core/files/path_text.h"
#include "core/landmark_files/landmark_file.h"
#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"

#include <QCursor>
#include <QGuiApplication>

#include <algorithm>
#include <map>
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

QString PointFiles::suffixOfFilter(const QString &filter)
{
    for (const Format format : kFormats) {
        if (filter.contains(u'(' + patternOf(format) + u')'))
            return QLatin1String(suffixOf(format));
    }
    return QLatin1String(suffixOf(Format::Csv));
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
    QString farthestName;
    double farthest = 0.0, farthestShare = 0.0;
    int tied = 0;
    const Waiting waiting;
    const std::vector<ray::TyingTarget> targets = this->targets();
    for (std::size_t i = 0; i < points.size(); ++i) {
        landmarks::Landmark before = points[i];
        const std::optional<ray::Tied> now = ray::tieToMesh(points[i], targets);
        if (!now)
            continue;
        const ray::TyingTarget &target = targets[now->target];
        Box bounds;
        for (const SceneObject &object : m_document.objects()) {
            if (object.name == target.name)
                bounds = boundsOf(object);
        }
        const double share = now->distance / bounds.diagonal();
        if (share > ray::kFarFromMesh)
            strays.push_back({i, now->distance, std::move(before)});
        if (tied++ == 0 || now->distance > farthest) {
            farthest = now->distance;
            farthestShare = share;
            farthestName = ScenePoints::shownNameOf(points, i);
        }
    }
    if (!strays.empty()) {
        const QString text =
            tr("Points far from every object: %1. “%2” is %3 off, which is %4 % of the object's size. Are they "
               "of another object, or in other axes?")
                .arg(QString::number(strays.size()), farthestName, readableText(farthest),
                     readableText(100.0 * farthestShare));
        QGuiApplication::setOverrideCursor(Qt::ArrowCursor);
        const auto answer = m_questions ? m_questions->askStray(text) : PointFileQuestions::Stray::LeaveFree;
        QGuiApplication::restoreOverrideCursor();
        if (answer == PointFileQuestions::Stray::Cancel)
            return std::nullopt;
        if (answer == PointFileQuestions::Stray::LeaveFree) {
            for (Stray &stray : strays) {
                points[stray.place] = std::move(stray.untied);
                points[stray.place].hold = landmarks::Free{};
                --tied;
            }
            return tr("On the mesh: %1. Free where they are, far from it: %2.").arg(tied).arg(strays.size());
        }
    }
    if (tied == 0)
        return QString();
    return farthest > 0.0
               ? tr("They were moved onto the mesh by at most %1 (%2).").arg(readableText(farthest), farthestName)
               : tr("They lie on the mesh.");
}

bool PointFiles::importFrom(const std::filesystem::path &file)
{
    auto result = readLandmarkFile(file);
    if (!result) {
        emit failed(QString::fromStdString(errorText(result.error())));
        return false;
    }
    ReadLandmarks read = std::move(result).value();
    const std::vector<landmarks::Landmark> &there = m_document.landmarks();
    landmarks::LandmarkSet set = std::move(read.sets.front());
    const auto join = there.empty() || !m_questions ? PointFileQuestions::Join::Replace
                                                    : m_questions->askJoin(static_cast<int>(there.size()),
                                                                           static_cast<int>(set.landmarks.size()));
    if (join == PointFileQuestions::Join::Cancel)
        return false;
    const std::optional<QString> done = tieAll(set.landmarks);
    if (!done)
        return false;
    const QString name = pathText(file.filename());
    const std::size_t count = set.landmarks.size();
    QStringList notes;
    if (const QString lost = sentences(name, read.notes); !lost.isEmpty())
        notes << lost;
    if (read.sets.size() > 1)
        notes << tr("%1 has %2 specimens; the points of the first are shown.").arg(name).arg(read.sets.size());
    if (join == PointFileQuestions::Join::Append) {
        landmarks::LandmarkSet all = m_document.landmarkSet();
        all.landmarks.insert(all.landmarks.end(), std::make_move_iterator(set.landmarks.begin()),
                             std::make_move_iterator(set.landmarks.end()));
        set = std::move(all);
    }
    static_cast<void>(m_document.editLandmarkSet(std::move(set), {tr("Import points")}));
    if (!notes.isEmpty())
        emit warned(notes.join(u'\n'));
    emit noticed((tr("Points read from %1: %2.").arg(name).arg(count) + u' ' + *done).trimmed());
    return true;
}

bool PointFiles::exportTo(const std::filesystem::path &file)
{
    landmarks::LandmarkSet set = m_document.landmarkSet();
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

bool PointFiles::takeKept(const std::filesystem::path &file)
{
    auto result = readLandmarkFile(file);
    if (!result) {
        emit failed(QString::fromStdString(errorText(result.error())));
        return false;
    }
    static_cast<void>(
        m_document.editLandmarkSet(std::move(std::move(result).value().sets.front()), {tr("Points of the scan")}));
    return true;
}

} // namespace unprojector::gui
