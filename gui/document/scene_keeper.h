#pragma once

#include "gui/document/recovery_file.h"

#include <optional>

namespace unprojector::gui {

/// Keeps a part of the scene in files of its own: a series keeps the landmarks of a scan beside it.
/// A session asks it before the scene is saved or left.
class SceneKeeper {
public:
    virtual ~SceneKeeper() = default;

    /// Saves its part before the scene is saved or left.
    /// @return false if the user wants to stay. A part that could not be saved stays unsaved
    virtual bool keepBeforeLeaving() = 0;
    /// Saves its part for File > Save.
    /// @return whether it is on the disk; nothing if the scene has no such part
    virtual std::optional<bool> save() = 0;
    /// Returns whether save() saves something.
    virtual bool canSave() const = 0;
    /// The series that the scene belongs to, for crash recovery; nothing if there is none.
    virtual std::optional<RecoverySeries> series() const = 0;
    /// Continues the series of a recovered scene, which is shown with unsaved changes.
    virtual void resume(const RecoverySeries &series) = 0;
};

} // namespace unprojector::gui
