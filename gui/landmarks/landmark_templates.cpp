#include "gui/landmarks/landmark_templates.h"

#include "core/base/path_text.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/name_key.h"
#include "core/landmarks/point_template.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"

#include <nlohmann/json.hpp>

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <system_error>
#include <utility>

namespace unprojector::gui {
namespace {

struct Templates {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::LandmarkTemplates)
};

/// Reads the file in the program's language, else the English one.
std::vector<landmarks::Landmark> pointsOf(const QString &file)
{
    QFile resource(QStringLiteral(":/templates/%1.csv").arg(file));
    if (!resource.open(QIODevice::ReadOnly))
        return {};
    const QByteArray text = resource.readAll();
    auto read = landmark_files::parseLandmarks({text.constData(), static_cast<std::size_t>(text.size())},
                                               landmark_files::Format::Csv, file.toStdString());
    Q_ASSERT(read && read->sets.size() == 1);
    return read ? std::move(read).value().sets.front().landmarks : std::vector<landmarks::Landmark>();
}

} // namespace

LandmarkTemplates::LandmarkTemplates()
{
    const QString source =
        Templates::tr("Definitions in our own words, after Martin and Saller, Lehrbuch der Anthropologie (1957)");
    const QString faceSource =
        Templates::tr("Definitions in our own words, after Farkas, Anthropometry of the Head and Face (1994)");
    m_bundled = {{Templates::tr("Skull (craniometric points)"), source,
                  //: The file of resources/templates with the hints in this language
                  pointsOf(Templates::tr("craniometric"))},
                 {Templates::tr("Face (soft tissue)"), faceSource,
                  //: The file of resources/templates with the hints in this language
                  pointsOf(Templates::tr("facial"))}};
}

bool LandmarkTemplates::isChosen(const QString &name) const
{
    return landmarks::indexOfName(m_chosen, name.toStdString()).has_value();
}

QString LandmarkTemplates::hintFor(const QString &name) const
{
    const std::string wanted = name.toStdString();
    std::string_view hint = landmarks::hintFor(wanted, m_chosen);
    if (hint.empty() && isChosen(name))
        return {};
    for (auto known = m_bundled.begin(); hint.empty() && known != m_bundled.end(); ++known)
        hint = landmarks::hintFor(wanted, known->points);
    return QString::fromUtf8(hint.data(), static_cast<qsizetype>(hint.size()));
}

std::filesystem::path LandmarkTemplates::pictureFor(const QString &name) const
{
    const std::string wanted = name.toStdString();
    const std::string_view picture = landmarks::pictureFor(wanted, m_chosen);
    return picture.empty() ? std::filesystem::path() : m_folder / base::pathFromUtf8(picture);
}

landmarks::LandmarkSet LandmarkTemplates::templateOf(const std::vector<landmarks::Landmark> &names,
                                                     const std::filesystem::path &folder) const
{
    landmarks::LandmarkSet set;
    for (const landmarks::Landmark &landmark : names) {
        landmarks::Landmark named;
        named.name = landmark.name;
        const QString called = QString::fromStdString(landmark.name);
        named.note = hintFor(called).toStdString();
        if (const std::filesystem::path picture = pictureFor(called); !picture.empty()) {
            std::error_code error; // on an error the absolute path is used
            const std::filesystem::path relative = std::filesystem::proximate(picture, folder, error);
            named.extra.edit() = {{landmarks::kPictureColumn, base::utf8FromPath(error ? picture : relative)}};
        }
        set.landmarks.push_back(std::move(named));
    }
    return set;
}

QStringList fillFromTemplate(SceneDocument &document, const std::vector<landmarks::Landmark> &landmarks,
                             const QString &name)
{
    std::vector<landmarks::Landmark> all = landmarks::inTemplateOrder(document.landmarks(), landmarks);
    QStringList removed; // the template's names come first in the list
    const auto others = all.begin() + static_cast<std::ptrdiff_t>(landmarks.size());
    for (auto other = others; other != all.end(); ++other) {
        if (other->isToPlace())
            removed << QString::fromStdString(other->name);
    }
    all.erase(std::remove_if(others, all.end(), [](const landmarks::Landmark &other) { return other.isToPlace(); }),
              all.end());
    static_cast<void>(editLandmarks(document, std::move(all), {Templates::tr("Template %1").arg(name)}));
    document.sceneLandmarks().waitForNext(std::nullopt);
    return removed;
}

} // namespace unprojector::gui
