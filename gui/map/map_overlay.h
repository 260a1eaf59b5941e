#pragma once

#include "gui/map/map_colors.h"
#include "gui/map/map_maker.h"

#include <QImage>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace unprojector::gui {

class MapPanel;
class SceneView;

/// A map over the view, off at first. It disappears when the view changes, and returns when that
/// rests.
class MapOverlay : public QObject {
    Q_OBJECT
public:
    /// @param view  of the document; draws the colours below points and crosshair
    MapOverlay(SceneDocument &document, SceneView &view);
    ~MapOverlay() override;

    void setShown(bool isShown);
    /// The panel for a corner of the view; hidden while the map is off. The caller makes it the
    /// child of a widget that owns it.
    MapPanel &panel() { return *m_panel; }
    /// The shown map; null while it is being made.
    const MadeMap *map() const { return m_map.get(); }
    /// The shown colours.
    const QImage &image() const { return m_image; }

    /// Shows the number under the pointer.
    void setPointer(const std::optional<geometry::WidgetPoint> &position);
    /// Writes the map as PFM or PNG, by the suffix.
    /// @return the error, or nothing
    QString exportTo(const std::filesystem::path &file) const;

signals:
    void closeRequested();

private:
    void ask();
    void drop();
    void show(const std::shared_ptr<const MadeMap> &map);
    void paintMap();
    void tellValue();
    QImage withScale() const;

    SceneDocument &m_document;
    SceneView &m_view;
    MapMaker m_maker;
    MapPanel *m_panel;
    QTimer m_rest;
    std::shared_ptr<const MadeMap> m_map;
    LogScale m_scale;
    QImage m_image;
    std::optional<geometry::WidgetPoint> m_pointer;
    bool m_isShown = false;
};

} // namespace unprojector::gui
