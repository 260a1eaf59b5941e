#pragma once

#include "core/geometry/setup.h"

#include <QPixmap>
#include <QWidget>

#include <optional>

namespace unprojector::gui {

/// Two drawings, each to scale: the window with the viewport in it, and the projection window
/// [left, right] x [bottom, top]; with the pointer in both, and a circle of the projection window
/// as the viewport shows it. The projection window is drawn as in the view: its left limit at the
/// left, even if left > right.
class ViewportDrawing : public QWidget {
    Q_OBJECT
public:
    explicit ViewportDrawing(QWidget *parent = nullptr);

    /// @pre the setup is valid
    void setSetup(const geometry::Setup &setup);
    /// Window position; nothing: no pointer.
    void setPointer(const std::optional<geometry::WindowPoint> &pointer);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    /// Everything but the pointer.
    void paintStill();
    /// @return the rectangle of the drawn window
    QRectF paintWindow(QPainter &painter, const QRectF &area) const;
    QRectF paintProjectionWindow(QPainter &painter, const QRectF &area) const;
    void paintPointer(QPainter &painter, const QRectF &within, const QPointF &position) const;
    /// The region that the pointer covers: small, so that following it is cheap.
    QRegion pointerRegion() const;
    QPointF pointerInWindow() const;
    QPointF pointerInProjectionWindow() const;
    double captionHeight() const;

    geometry::Setup m_geometry;
    std::optional<geometry::WindowPoint> m_pointer;
    QPixmap m_still; ///< null: must be repainted
    QRectF m_windowRect;
    QRectF m_projectionRect;
};

} // namespace unprojector::gui
