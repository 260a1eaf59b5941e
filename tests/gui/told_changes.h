#pragma once

#include "core/examples/examples.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"

#include <QStringList>

#include <functional>
#include <vector>

/// Helpers that the tests of the document share.
namespace documenttest {

using Verb = std::function<void(unprojector::gui::SceneDocument &)>;

/// The changes that a document has reported, one entry a signal.
class Told {
public:
    explicit Told(unprojector::gui::SceneDocument &document)
    {
        QObject::connect(&document, &unprojector::gui::SceneDocument::changed, &m_context,
                         [this](unprojector::gui::Changes changes) { m_tellings.push_back(changes); });
    }
    unprojector::gui::Changes all() const
    {
        unprojector::gui::Changes all;
        for (const unprojector::gui::Changes &changes : m_tellings)
            all |= changes;
        return all;
    }
    std::size_t count() const { return m_tellings.size(); }
    void forget() { m_tellings.clear(); }

private:
    QObject m_context;
    std::vector<unprojector::gui::Changes> m_tellings;
};

inline const unprojector::gui::EditLabel kLabel{QStringLiteral("edit")};

inline void openScene(unprojector::gui::SceneDocument &document)
{
    document.setSurface({801, 601, 1.0});
    openObjects(document, unprojector::examples::bundledScene());
}

inline unprojector::geometry::LookAt cameraAt(double z)
{
    return {unprojector::geometry::WorldPoint(0.0, 0.0, z),
            unprojector::geometry::WorldPoint(0.0, 0.0, 0.0),
            {0.0, 1.0, 0.0}};
}

inline QStringList namesIn(const unprojector::gui::SceneDocument &document)
{
    QStringList names;
    for (const unprojector::scene::SceneObject &object : document.objects())
        names << QString::fromStdString(object.name);
    return names;
}

} // namespace documenttest
