#include "gui/landmarks/landmark_drawing.h"

#include "gui/document/picks.h"
#include "gui/landmarks/expected_landmarks.h"
#include "gui/landmarks/expected_marks.h"
#include "gui/landmarks/landmark_loupe.h"
#include "gui/landmarks/measure_mark.h"
#include "gui/view/scene_view.h"

#include <QPainter>

#include <utility>

namespace unprojector::gui {
using namespace geometry;

void LandmarkDrawing::setLooks(const LandmarkLooks &looks)
{
    m_looks = looks;
    m_drawn.reset();
    m_view.update();
}

const std::vector<LandmarkMark> &LandmarkDrawing::marks()
{
    if (!m_marks)
        m_marks = landmarkMarks(m_document);
    return *m_marks;
}

bool LandmarkDrawing::hasMarks()
{
    return !marks().empty() || (m_expected && m_expected->isShown() && !m_expected->all().empty());
}

void LandmarkDrawing::forgetMarks()
{
    m_marks.reset();
    m_drawn.reset();
}

void LandmarkDrawing::draw(QPainter &painter, const std::vector<QRectF> &taken, std::vector<QLineF> lines)
{
    const QRectF area = m_view.surfaceRect();
    const double ratio = m_document.setup().surface.devicePixelRatio;
    if (!m_drawn || m_drawn->area != area || m_drawn->ratio != ratio || m_drawn->taken != taken
        || m_drawn->font != painter.font()) {
        m_drawn = {area, ratio, taken, painter.font(), {}};
        m_drawn->image = marksImage(*m_drawn, marks(), std::move(lines));
    }
    painter.drawImage(area.topLeft(), m_drawn->image);
}

QImage LandmarkDrawing::marksImage(const Drawn &drawn, const std::vector<LandmarkMark> &shown,
                                   std::vector<QLineF> lines) const
{
    QImage image((drawn.area.size() * drawn.ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) // too little memory for a large one
        return image;
    image.setDevicePixelRatio(drawn.ratio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setFont(drawn.font);
    painter.translate(-drawn.area.topLeft());
    drawMarks(painter, drawn.area, drawn.taken, shown, std::move(lines));
    return image;
}

void LandmarkDrawing::drawPicture(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken) const
{
    const std::vector<LandmarkMark> shown = landmarkMarks(m_document);
    if (shown.empty())
        return;
    // An image as in the view: OpenGL draws letters slightly differently.
    const QImage image =
        marksImage({area, painter.device()->devicePixelRatioF(), taken, painter.font(), {}}, shown, {});
    if (image.isNull())
        drawMarks(painter, area, taken, shown, {});
    else
        painter.drawImage(area.topLeft(), image);
}

void LandmarkDrawing::drawMarks(QPainter &painter, const QRectF &area, const std::vector<QRectF> &taken,
                                const std::vector<LandmarkMark> &shown, std::vector<QLineF> lines) const
{
    std::vector<QRectF> occupied = taken;
    if (m_expected && m_expected->isShown()) {
        const std::vector<ExpectedMark> expected = expectedMarks(m_document, m_expected->all());
        std::vector<QRectF> marks = taken;
        for (const LandmarkMark &mark : shown)
            marks.emplace_back(mark.at - QPointF(kMarkReach, kMarkReach), QSizeF(2.0 * kMarkReach, 2.0 * kMarkReach));
        const QRectF label = expectedLabelBox(expected, QFontMetricsF(painter.font()), area, marks);
        for (const ExpectedMark &mark : expected) // the next click may go there
            occupied.push_back(boxOf(mark));
        occupied.push_back(label);
        drawExpected(painter, expected, occupied.back());
    }
    const std::optional<MeasureMark> measure = measureMark(m_document);
    std::vector<LandmarkMark> labelled = shown;
    for (LandmarkMark &mark : labelled) { // their marks still keep the measure's label away
        if (!m_looks.hasLabels)
            mark.label.clear();
    }
    if (measure) { // beside its line, and clear of the landmarks' labels
        lines.insert(lines.end(), measure->lines.begin(), measure->lines.end());
        labelled.push_back(measure->label);
    }
    const double radius = radiusOf(m_looks.size);
    std::vector<PlacedLabel> labels =
        placedLabels(labelled, QFontMetricsF(painter.font()), area, lines, occupied, radius);
    std::optional<PlacedLabel> ofMeasure;
    std::erase_if(labels, [&](const PlacedLabel &label) {
        if (label.mark < shown.size())
            return false;
        ofMeasure = label;
        return true;
    });
    if (measure)
        drawMeasure(painter, *measure, ofMeasure);
    drawLandmarks(painter, shown, labels, radius);
}

void LandmarkDrawing::aimLoupe(const std::optional<DevicePoint> &at)
{
    if (!at && !m_loupeAt)
        return;
    m_loupeAt = at;
    m_view.update();
}

void LandmarkDrawing::prepareLoupe()
{
    m_loupe = m_loupeAt ? m_view.pixelsIn(loupePixels(*m_loupeAt)) : QImage();
}

void LandmarkDrawing::drawLoupe(QPainter &painter) const
{
    if (!m_loupeAt)
        return;
    const ray::SceneRays *rays = m_looks.loupeEdges == LoupeEdges::Never ? nullptr : m_document.picks().rays();
    std::vector<QLineF> edges = rays ? loupeEdges(*rays, *m_loupeAt) : std::vector<QLineF>();
    if (m_looks.loupeEdges == LoupeEdges::WhereLong && !leaveSurfaceVisible(edges))
        edges.clear();
    gui::drawLoupe(painter, loupeBox(m_document.setup().surface, *m_loupeAt, m_view.cornerWidth()), *m_loupeAt, m_loupe,
                   edges);
}

} // namespace unprojector::gui
