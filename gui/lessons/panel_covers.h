#pragma once

#include "gui/window/workspaces.h"

#include <QString>

#include <map>

class QWidget;

namespace unprojector::gui {

/// Texts in the place of panels that would show the answer to a question. The docks stay where they are and keep their sizes, so
/// nothing moves when a panel is covered or opened.
class PanelCovers {
public:
    /// @param workspaces  outlive the covers
    explicit PanelCovers(Workspaces &workspaces) : m_workspaces(workspaces) {}

    /// Covers these panels, and opens all others.
    /// @param texts  what the covers say, by their panels
    void set(const std::map<Panel, QString> &texts);

private:
    struct Cover {
        QWidget *panel; ///< what the dock shows without it
        QWidget *widget;
    };
    void open(Panel panel);

    Workspaces &m_workspaces;
    std::map<Panel, Cover> m_covers;
};

} // namespace unprojector::gui
