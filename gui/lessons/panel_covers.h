#pragma once

#include "gui/window/workspaces.h"

#include <QString>

#include <map>

class QWidget;

namespace unprojector::gui {

/// Covers with a text for panels that would show the answer to a question. The docks keep their
/// positions and sizes, so nothing moves when a panel is covered or opened.
class PanelCovers {
public:
    /// @param workspaces  outlive the covers
    explicit PanelCovers(Workspaces &workspaces) : m_workspaces(workspaces) {}

    /// Covers these panels, and opens all others.
    /// @param texts  of the covers, by panel
    void set(const std::map<Panel, QString> &texts);

private:
    struct Cover {
        QWidget *panel; ///< the covered content of the dock
        QWidget *widget;
    };
    void open(Panel panel);

    Workspaces &m_workspaces;
    std::map<Panel, Cover> m_covers;
};

} // namespace unprojector::gui
