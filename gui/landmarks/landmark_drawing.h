#pragma once

#include "gui/document/scene_document.h"
#include "gui/landmarks/landmark_looks.h"
#include "gui/landmarks/landmark_marks.h"

#include <QFont>
#include <QImage>
#include <QLineF>
#include <QRectF>

#include <optional>
#include <vector>

class QPainter;

namespace unprojector::gui {

class ExpectedLandmarks;
class SceneView;

/// The drawing of landmarks over the view: marks with their labels, expected places, the chosen
/// measure and the loupe.
class LandmarkDrawing {
public:
    /// @param document, view  outlive it
    LandmarkDrawing(SceneDocument &document, SceneView &view) : m_document(document), m_view(view) {}

    /// Sets the expected places that are drawn with the marks.
    /// @param expected  outlives it
    void setExpected(ExpectedLandmarks &expected) { m_expected = &expected; }
    const LandmarkLooks &looks() const { return m_looks; }
    void setLooks(const LandmarkLooks &looks);

    /// The marks in the present view.
    const std::vector<LandmarkMark> &marks();
    /// Returns whether there are marks to draw, of landmarks or of expected places.
    bool hasMarks();
    /// The marks must be computed again.
    void forgetMarks();
    /// The marks must be drawn again.
    void forgetImage() { m_drawn.reset(); }

    /// Draws the marks in the present view. They are kept as an image: a move of the pointer changes
    /// only the loupe, and 500 labels take longer than a frame.
    /// @param lines  that no label may cover
    void draw(QPainter &painter, const std::vector<QRectF> &taken, std::vector<QLineF> lines);
    /// Draws the marks into an image of another size.
    void drawPicture(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken) const;

    /// Shows a position in the loupe.
    /// @param at  device pixels; nothing: hides it
    void aimLoupe(const std::optional<geometry::DevicePoint> &at);
    bool hasLoupe() const { return m_loupeAt.has_value(); }
    /// Reads the loupe's pixels. OpenGL's context is current, and the frame is drawn.
    void prepareLoupe();
    void drawLoupe(QPainter &painter) const;

private:
    /// The marks with their labels as an image, and what they depend on.
    struct Drawn {
        QRectF area;
        double ratio = 1.0;
        std::vector<QRectF> taken;
        QFont font;
        QImage image;
    };

    /// Draws marks with their labels, and the chosen measure.
    void drawMarks(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken,
                   const std::vector<LandmarkMark> &shown, std::vector<QLineF> lines) const;
    /// The image for that area; null if there is too little memory.
    QImage marksImage(const Drawn &drawn, const std::vector<LandmarkMark> &shown, std::vector<QLineF> lines) const;

    SceneDocument &m_document;
    SceneView &m_view;
    ExpectedLandmarks *m_expected = nullptr;
    LandmarkLooks m_looks;
    std::optional<std::vector<LandmarkMark>> m_marks; ///< nothing: must be computed
    std::optional<Drawn> m_drawn;                     ///< nothing: they must be drawn
    std::optional<geometry::DevicePoint> m_loupeAt;
    QImage m_loupe; ///< the pixels around it
};

} // namespace unprojector::gui
