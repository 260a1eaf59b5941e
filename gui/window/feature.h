#pragma once

#include "core/lessons/link.h"
#include "gui/window/workspaces.h"

#include <QObject>
#include <QVariantMap>

#include <optional>
#include <vector>

class QMenu;
class QSettings;
class QToolBar;

namespace unprojector::gui {

class ScanList;
class ViewTool;

/// The menus that features add to.
enum class MenuKind { File, Edit, View, Help };

/// The window's interface to a feature: Click, Pipeline, Landmarks and the others, each in its own
/// folder. A feature knows the window by gui/window/window.h, and no other feature.
class Feature : public QObject {
public:
    using QObject::QObject;

    /// The panels of the feature; called once.
    virtual std::vector<PanelSpec> panels() { return {}; }
    /// The workspace of the feature, if it has one; called once.
    virtual std::optional<WorkspaceSpec> workspace() { return {}; }
    /// Appends actions to a menu and to the tool bar. Called once a menu, feature after feature,
    /// once the panels are in the window.
    virtual void addActions(MenuKind, QMenu &, QToolBar &) {}
    /// The feature's tool in the view, or null.
    virtual ViewTool *tool() { return nullptr; }
    /// The feature's series of scans, or null.
    virtual ScanList *scans() { return nullptr; }
    /// Follows a link of a lesson.
    /// @return false if the link belongs to another feature
    virtual bool follow(const lessons::Link &) { return false; }

    /// The current state of the switches that a lesson may change.
    virtual QVariantMap state() const { return {}; }
    /// @param state  of state()
    virtual void restore(const QVariantMap &) {}
    // Saves the settings that last from one start of the program to the next.
    virtual void keep(QSettings &) const {}
    virtual void restore(const QSettings &) {}
};

} // namespace unprojector::gui
