#pragma once

#include "core/doctor/diagnosis.h"

#include <QComboBox>

#include <cstddef>
#include <optional>
#include <string>

namespace unprojector::gui {

class FollowedObject;
class SceneDocument;

/// The space in which a program expresses its points: the world, the eye or an object. The choice
/// follows its object while objects are added, removed, renamed or moved. An object that was removed
/// stays chosen until the user chooses again, or until the scene has one object of that name.
class SpaceChoice : public QComboBox {
    Q_OBJECT
public:
    struct Space {
        doctor::PointSpace kind = doctor::PointSpace::World;
        std::size_t object = 0; ///< its index, in the space of an object
    };

    explicit SpaceChoice(const SceneDocument &document, QWidget *parent = nullptr);

    /// Lists the present objects. A chosen object that was removed stays chosen, under its last name.
    void refresh();
    /// The chosen space; nothing if its object is not in the scene.
    std::optional<Space> space() const;

private:
    void take(int index);

    const SceneDocument &m_document;
    FollowedObject *m_object;
    std::optional<std::string> m_name; ///< of the chosen object, when it was last in the scene
};

} // namespace unprojector::gui
