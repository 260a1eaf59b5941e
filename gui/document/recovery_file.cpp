#include "gui/document/recovery_file.h"

#include "core/base/system_file.h"

#include "gui/document/portable.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene_file;

namespace {

struct RecoveryTexts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::RecoveryTexts)
};

constexpr int kVersion = 1;
/// The largest size of the first line: more than any path needs.
constexpr qint64 kMostInfoBytes = 1 << 20;

// Suffixes of a recovery file's companions, after its id. QSaveFile writes to the recovery file's
// name with ".XXXXXX".
constexpr QLatin1String kContentSuffix(".recovery");
constexpr QLatin1String kLockSuffix(".lock");
constexpr QLatin1String kDamagedSuffix(".damaged");

std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

QString versionKey()
{
    return QStringLiteral("unprojectorRecovery");
}

/// "1 1234 14695981039346656037"; as text, because JSON's numbers are doubles.
QString stampText(const base::FileStamp &stamp)
{
    return QStringLiteral("%1 %2 %3").arg(stamp.exists ? 1 : 0).arg(stamp.size).arg(stamp.hash);
}

QString reasonText(const std::error_code &error)
{
    return QString::fromLocal8Bit(error.message().c_str());
}

QString textOf(const std::filesystem::path &path)
{
    return QString::fromStdU16String(path.u16string());
}

std::optional<base::FileStamp> stampFromText(const QString &text)
{
    const QStringList numbers = text.split(u' ');
    if (numbers.size() != 3)
        return std::nullopt;
    return base::FileStamp{numbers[0] == QStringLiteral("1"), numbers[1].toULongLong(), numbers[2].toULongLong()};
}

QJsonObject seriesJson(const RecoverySeries &series)
{
    return {{QStringLiteral("folder"), textOf(series.folder)}, {QStringLiteral("scan"), textOf(series.scan)},
            {QStringLiteral("placing"), series.placing},       {QStringLiteral("stamp"), stampText(series.stamp)},
            {QStringLiteral("landmarks"), series.placed},      {QStringLiteral("savedLandmarks"), series.saved}};
}

/// @return nothing if the scene is of no series
std::optional<RecoverySeries> seriesFromJson(const QJsonObject &json)
{
    RecoverySeries series;
    series.folder = pathOf(json.value(QStringLiteral("folder")).toString());
    series.scan = pathOf(json.value(QStringLiteral("scan")).toString());
    series.placing = json.value(QStringLiteral("placing")).toInt(1);
    series.placed = json.value(QStringLiteral("landmarks")).toInt();
    series.saved = json.value(QStringLiteral("savedLandmarks")).toInt();
    const std::optional<base::FileStamp> stamp = stampFromText(json.value(QStringLiteral("stamp")).toString());
    if (!stamp || !series.folder.is_absolute() || !series.scan.is_absolute())
        return std::nullopt;
    series.stamp = *stamp;
    return series;
}

/// Makes files private that earlier versions left readable by others.
void keepAllToOwner(const QString &folder)
{
    if (!QFileInfo(folder).isDir())
        return;
    base::keepToOwner(pathOf(folder));
    for (const QFileInfo &file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden | QDir::NoSymLinks))
        base::keepToOwner(pathOf(file.filePath()));
}

} // namespace

QString RecoveryInfo::shownName() const
{
    if (!series)
        return name;
    std::filesystem::path folder = series->folder;
    if (!folder.has_filename()) // "scans/"
        folder = folder.parent_path();
    return RecoveryTexts::tr("%1 of the series “%2”").arg(name, textOf(folder.filename()));
}

QString RecoveryInfo::lostText() const
{
    return series ? RecoveryTexts::tr("%1 (landmarks placed: %2; in its file: %3)")
                        .arg(shownName())
                        .arg(series->placed)
                        .arg(series->saved)
                  : name;
}

QString RecoveryFile::defaultFolder(const QString &programFolder)
{
    const QString kept = isPortable(programFolder)
                             ? programFolder
                             : QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return kept + QStringLiteral("/recovery");
}

RecoveryFile::RecoveryFile(const QString &folder, const QString &id)
    : m_folder(folder), m_id(id), m_lock(QDir(folder).filePath(id + kLockSuffix))
{
    // A lock is held as long as a window is open: only a dead holder makes it stale, not its age.
    m_lock.setStaleLockTime(0);
}

Result<std::unique_ptr<RecoveryFile>, QString> RecoveryFile::create(const QString &folder)
{
    std::error_code error;
    std::filesystem::create_directories(pathOf(folder), error);
    if (error)
        return reasonText(error);
    base::keepToOwner(pathOf(folder));
    std::unique_ptr<RecoveryFile> file(new RecoveryFile(folder, QUuid::createUuid().toString(QUuid::Id128)));
    if (file->m_lock.tryLock(0)) {
        base::keepToOwner(pathOf(file->m_lock.fileName()));
        return file;
    }
    // No other program has this name: the lock file could not be created.
    const bool isForbidden = file->m_lock.error() == QLockFile::PermissionError;
    return reasonText(std::make_error_code(isForbidden ? std::errc::permission_denied : std::errc::io_error));
}

std::vector<std::unique_ptr<RecoveryFile>> RecoveryFile::abandonedIn(const QString &folder)
{
    keepAllToOwner(folder);
    QStringList ids;
    const QStringList filters{QStringLiteral("*.recovery"), QStringLiteral("*.recovery.*"), QStringLiteral("*.lock")};
    for (const QString &name : QDir(folder).entryList(filters, QDir::Files | QDir::Hidden))
        ids << name.section(u'.', 0, 0);
    ids.removeDuplicates();

    using Dated = std::pair<QDateTime, std::unique_ptr<RecoveryFile>>;
    std::vector<Dated> found;
    for (const QString &id : std::as_const(ids)) {
        std::unique_ptr<RecoveryFile> file(new RecoveryFile(folder, id));
        if (!file->m_lock.tryLock(0))
            continue;
        base::keepToOwner(pathOf(file->m_lock.fileName()));
        file->clearRests();
        if (!QFile::exists(file->path()))
            continue;
        const std::optional<RecoveryInfo> info = file->info();
        found.emplace_back(info ? info->time : QDateTime(), std::move(file));
    }
    std::stable_sort(found.begin(), found.end(), [](const Dated &a, const Dated &b) { return a.first > b.first; });
    std::vector<std::unique_ptr<RecoveryFile>> files;
    files.reserve(found.size());
    for (Dated &dated : found)
        files.push_back(std::move(dated.second));
    return files;
}

QString RecoveryFile::path() const
{
    return QDir(m_folder).filePath(m_id + kContentSuffix);
}

void RecoveryFile::clearRests() const
{
    QDir folder(m_folder);
    for (const QString &name : folder.entryList({m_id + QStringLiteral(".recovery.*")}, QDir::Files | QDir::Hidden))
        folder.remove(name);
}

Kept RecoveryFile::write(const RecoveryInfo &info, const std::string &sceneText)
{
    QJsonObject json{{versionKey(), kVersion},
                     {QStringLiteral("name"), info.name},
                     {QStringLiteral("time"), info.time.toUTC().toString(Qt::ISODateWithMs)}};
    if (!info.sceneFile.empty())
        json.insert(QStringLiteral("sceneFile"), textOf(info.sceneFile));
    if (info.stamp)
        json.insert(QStringLiteral("sceneStamp"), stampText(*info.stamp));
    if (info.series)
        json.insert(QStringLiteral("series"), seriesJson(*info.series));
    QSaveFile file(path());
    if (!file.open(QIODevice::WriteOnly))
        return file.errorString();
#ifndef Q_OS_WIN
    file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner); // before it has any content
#endif
    file.write(QJsonDocument(json).toJson(QJsonDocument::Compact));
    file.write("\n");
    file.write(sceneText.data(), static_cast<qint64>(sceneText.size()));
    if (!file.commit()) // fails if a write failed
        return file.errorString();
    return std::monostate{};
}

std::optional<RecoveryInfo> RecoveryFile::info() const
{
    QFile file(path());
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QJsonObject json = QJsonDocument::fromJson(file.readLine(kMostInfoBytes)).object();
    if (json.value(versionKey()).toInt() != kVersion)
        return std::nullopt;
    RecoveryInfo info;
    info.name = json.value(QStringLiteral("name")).toString();
    info.sceneFile = std::filesystem::path(json.value(QStringLiteral("sceneFile")).toString().toStdU16String());
    info.time = QDateTime::fromString(json.value(QStringLiteral("time")).toString(), Qt::ISODateWithMs).toLocalTime();
    info.stamp = stampFromText(json.value(QStringLiteral("sceneStamp")).toString());
    info.series = seriesFromJson(json.value(QStringLiteral("series")).toObject());
    if (info.name.isEmpty() || !info.time.isValid() || (!info.sceneFile.empty() && !info.sceneFile.is_absolute()))
        return std::nullopt;
    return info;
}

SceneOrError RecoveryFile::scene() const
{
    const std::string name = QFileInfo(path()).fileName().toStdString();
    QFile file(path());
    if (!file.open(QIODevice::ReadOnly))
        return notReadable(name);
    file.readLine(kMostInfoBytes);
    const QByteArray text = file.readAll();
    const auto size = static_cast<std::size_t>(text.size());
    return parseScene({text.constData(), size}, name, size); // a scene that cannot be saved is kept too
}

void RecoveryFile::remove()
{
    QFile::remove(path());
}

QString RecoveryFile::putAside()
{
    const QString aside = QDir(m_folder).filePath(m_id + kDamagedSuffix);
    return QFile::rename(path(), aside) ? aside : path();
}

} // namespace unprojector::gui
