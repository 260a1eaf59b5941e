#pragma once

#include "core/examples/bundled_scene.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"

#include <QStringList>

#include <functional>
#include <vector>

/// What the tests of the document share.
namespace documenttest {
using namespace unprojector;
using namespace unprojector::gui;

using Verb = std::function<void(SceneDocument &)>;

/// What a document has told, one entry a telling.
class Told {
public:
    explicit Told(SceneDocument &document)
    {
        QObject::connect(&document, &SceneDocument::changed, &m_context,
                         [this](Changes changes) { m_tellings.push_back(changes); });
    }
    Changes all() const
    {
        Changes all;
        for (const Changes &changes : m_tellings)
            all |= changes;
        return all;
    }
    std::size_t count() const { return m_tellings.size(); }
    void forget() { m_tellings.clear(); }

private:
    QObject m_context;
    std::vector<Changes> m_tellings;
};

inline const EditLabel kLabel{QStringLiteral("edit")};

inline void openScene(SceneDocument &document)
{
    document.setSurface({801, 601, 1.0});
    openObjects(document, examples::bundledScene());
}

inline LookAt cameraAt(double z)
{
    return {WorldPoint(0.0, 0.0, z), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
}

inline QStringList namesIn(const SceneDocument &document)
{
    QStringList names;
    for (const SceneObject &object : document.objects())
        names << QString::fromStdString(object.name);
    return names;
}

} // namespace documenttest
