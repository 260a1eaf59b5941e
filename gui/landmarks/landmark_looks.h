#pragma once

#include "gui/landmarks/landmark_loupe.h"

#include <QObject>

class QAction;
class QActionGroup;
class QMenu;
class QSettings;

namespace unprojector::gui {

class LandmarkTool;

enum class MarkSize { Small, Medium, Large };

/// The radius of a mark, logical pixels.
double radiusOf(MarkSize size);

/// The user's choices for the marks in the view.
struct LandmarkLooks {
    bool hasLabels = true;
    MarkSize size = MarkSize::Medium;
    LoupeEdges loupeEdges = LoupeEdges::WhereLong;
};

/// The menu of these choices, which last from one start of the program to the next.
class LandmarkLooksMenu : public QObject {
    Q_OBJECT
public:
    explicit LandmarkLooksMenu(LandmarkTool &tool);

    /// Appends the choices to a menu; called once.
    void addTo(QMenu &menu);
    void keep(QSettings &settings) const;
    void restore(const QSettings &settings);

private:
    LandmarkTool &m_tool;
    QAction *m_labels = nullptr;
    QActionGroup *m_sizes = nullptr; ///< in the order of MarkSize
    QActionGroup *m_edges = nullptr; ///< in the order of LoupeEdges
};

} // namespace unprojector::gui
