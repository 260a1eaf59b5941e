#include "gui/document/object_names.h"

#include "gui/text/bundled_names.h"

namespace unprojector::gui {
using namespace scene;

NameFault faultOf(const std::string &name, std::size_t index, const std::vector<SceneObject> &objects)
{
    if (name.empty())
        return NameFault::Empty;
    const QString asRead = QString::fromStdString(name);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (i != index && (objects[i].name == name || readName(objects[i].name, objects) == asRead))
            return NameFault::Taken;
    }
    return NameFault::None;
}

QString shownName(const std::string &name)
{
    constexpr qsizetype kMost = 200;
    const QString shown = QString::fromStdString(name).simplified();
    return shown.size() > kMost ? shown.left(kMost) + u'…' : shown;
}

QString shownObjectName(const std::string &name, const std::vector<SceneObject> &objects)
{
    return shownName(readName(name, objects).toStdString());
}

std::string freeName(const std::string &name, const std::vector<SceneObject> &objects)
{
    std::string free = name;
    for (int number = 2; faultOf(free, objects.size(), objects) == NameFault::Taken; ++number)
        free = name + " (" + std::to_string(number) + ')';
    return free;
}

} // namespace unprojector::gui
