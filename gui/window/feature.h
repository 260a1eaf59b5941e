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

class ViewTool;

/// The menus that features add to.
enum class MenuKind { File, Edit, View, Help };

/// What the window knows of a feature: Click, Pipeline, Landmarks and the others, each in a folder of its own. A feature knows the
/// window by gui/window/window.h, and no other feature.
class Feature : public QObject {
public:
    using QObject::QObject;

    /// The panels of the feature; called once.
    virtual std::vector<PanelSpec> panels() { return {}; }
    /// The workspace of the feature, if it has one; called once.
    virtual std::optional<WorkspaceSpec> workspace() { return {}; }
    /// Adds actions to the end of a menu and of the tool bar; called once a menu, feature after feature, once the panels are in
    /// the window.
    virtual void addActions(MenuKind, QMenu &, QToolBar &) {}
    /// What does the feature's work in the view, if anything does.
    virtual ViewTool *tool() { return nullptr; }
    /// Does what a link of a lesson says.
    /// @return false where the link is none of the feature's
    virtual bool follow(const lessons::Link &) { return false; }

    /// The switches that a lesson may change, as they are now.
    virtual QVariantMap state() const { return {}; }
    /// @param state  of state()
    virtual void restore(const QVariantMap &) {}
    // What lasts from one start of the program to the next.
    virtual void keep(QSettings &) const {}
    virtual void restore(const QSettings &) {}
};

} // namespace unprojector::gui
