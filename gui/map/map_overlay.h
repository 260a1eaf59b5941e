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

/// A map over the view, off at first. It goes as soon as the view shows anything else, and comes back when that rests.
class MapOverlay : public QObject {
    Q_OBJECT
public:
    /// @param view  shows the document's picture; the colours are drawn in it, below points and crosshair
    MapOverlay(SceneDocument &document, SceneView &view);
    ~MapOverlay() override;

    void setShown(bool isShown);
    /// Stands in a corner over the view; hidden while no map is wanted. Whoever puts it somewhere owns it.
    MapPanel &panel() { return *m_panel; }
    /// The map that is on show; null while it is being made.
    const MadeMap *map() const { return m_map.get(); }
    /// The colours that are on show.
    const QImage &image() const { return m_image; }

    /// Tells the number under the pointer.
    void setPointer(const std::optional<geometry::WidgetPoint> &position);
    /// Writes it, by the suffix as PFM or PNG.
    /// @return what went wrong, or nothing
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
