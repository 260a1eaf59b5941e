#include "gui/view/scene_view.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/view/drop_labels.h"
#include "gui/view/highlight_marks.h"
#include "gui/view/lifecycle_timer.h"
#include "gui/view/quantity_marks.h"
#include "gui/view/scene_overlay.h"
#include "gui/view/view_menu.h"
#include "gui/view/view_tool.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

/// A clicking hand trembles: a drag starts at the desktop's drag distance.
bool isDrag(const QPointF &way)
{
    return std::abs(way.x()) + std::abs(way.y()) >= QApplication::startDragDistance();
}

} // namespace

SceneView::SceneView(SceneDocument &document, QWidget *parent)
    : FrameView(parent), m_document(document), m_overlay(std::make_unique<SceneOverlay>()),
      m_hover(*this, document, [this] { return isReady() && !m_isStale && !isCoarse() ? &frame() : nullptr; }),
      m_navigation(document, [this](const WidgetPoint &position) { return pivotAt(position); }), m_crosshair(document)
{
    setAcceptDrops(true);
    setCursor(Qt::CrossCursor);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("3-D view"));
    setAccessibleDescription(
        tr("Click the model, or press Enter, to read the world coordinate of the pixel under the "
           "pointer or the crosshair. Arrow keys turn, with Shift they move, with Ctrl they move the "
           "crosshair; plus and minus zoom"));

    // Its pixel is meaningless in another scene, and the dragged or picked object no longer exists.
    connect(&m_document, &SceneDocument::opened, this, [this] {
        m_crosshair.reset();
        setCrosshairShown(false);
        m_drag = Drag::None;
        m_toolTakesClick = false;
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Objects) // the former pick may be on a removed object
            m_formerPick.reset();
        if (changes & (Change::Setup | Change::Preview))
            setFixedSurface(m_document.scene().windowSize);
        if (changes & (kVisibleChanges | Change::Preview))
            redraw();
        else if (changes
                 & (Change::Pick | Change::GivenPoint | Change::WrongPoints | Change::Ray | Change::Landmarks
                    | Change::LandmarkSelection | Change::Curves))
            update(); // they are drawn over the frame
        if (changes & Change::Snap)
            setMark(std::nullopt);
    });
    connect(&m_hover, &HoverReader::answered, this, &SceneView::hovered);
}

SceneView::~SceneView()
{
    onDestroy();
}

void SceneView::redraw()
{
    m_isStale = true;
    m_navigation.forgetStill();
    m_mark.reset();
    update();
}

void SceneView::setMap(const QImage &map)
{
    if (m_map.isNull() && map.isNull())
        return;
    m_map = map;
    update();
}

void SceneView::setHighlights(const std::set<lessons::Highlight> &highlights)
{
    m_highlights = highlights;
    update();
}

void SceneView::setMarkedTerm(const QString &term)
{
    m_markedTerm = term;
    update();
}

void SceneView::setHasDropLabels(bool hasThem)
{
    m_hasDropLabels = hasThem;
    update();
}

void SceneView::onCreate()
{
    const LifecycleTimer timer;
    if (!createFrame())
        return;
    m_overlay->initialize();
    m_isStale = true;
    emit happened(LifecycleTimer::preCreateWindow(preCreateWindow(), context()->format()));
    emit happened(timer.onCreate());
}

void SceneView::onSize()
{
    const LifecycleTimer timer;
    leaveSurface(); // the view moved below the pointer: its next move tells the pixel
    m_document.setSurface(widgetSurface());
    if (const Result<Drawable> drawn = drawable(m_document.setup()))
        emit happened(timer.onSize(*drawn));
}

void SceneView::onDraw()
{
    if (!isReady())
        return;
    const LifecycleTimer timer;
    const Drawn drawn = updateFrame();
    if (showFrame()) {
        drawOver({});
        finishFrame();
    }
    emit happened(timer.onDraw(drawn != Drawn::Nothing, drawn == Drawn::StandIns));
    m_hover.request();
}

FrameView::Drawn SceneView::updateFrame()
{
    // A pixel ratio can change without a change of size.
    m_document.setSurface(widgetSurface());
    if (!m_isStale)
        return Drawn::Nothing;
    m_isStale = false;
    m_hover.renew(m_drag == Drag::None);
    if (std::optional<FrameContents> contents = frameContentsOf(m_document))
        return drawFrame(std::move(*contents));
    tellDrawn(1.0);
    return Drawn::Nothing;
}

void SceneView::onDestroy()
{
    if (!isReady())
        return;
    const LifecycleTimer timer;
    makeCurrent();
    releaseFrame();
    m_overlay->release();
    m_hover.forgetRequest();
    doneCurrent();
    emit happened(timer.onDestroy());
}

double SceneView::cornerShiftPixels()
{
    if (!isReady())
        return kCornerShiftPixels;
    makeCurrent();
    const double shift = frame().cornerShiftPixels();
    doneCurrent();
    return shift;
}

std::optional<PixelClick> SceneView::clickAt(const WidgetPoint &position)
{
    if (!isReady())
        return std::nullopt;
    const LifecycleTimer timer;
    makeCurrent();
    if (updateFrame() != Drawn::Nothing)
        emit happened(timer.onDrawFrame());
    completeFrame();
    std::optional<PixelClick> click;
    if (const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.setup().surface, position)) {
        if (const std::optional<DepthSample> sample = frame().sample(*pixel))
            click = {position, *pixel, withDot(m_document, *sample)};
        else
            emit failed(tr("The depth of this pixel could not be read: OpenGL reported an error."));
    }
    doneCurrent();
    return click;
}

void SceneView::endToolDrag()
{
    if (m_drag == Drag::Tool)
        m_drag = Drag::None;
}

QRectF SceneView::cornerBox() const
{
    if (!m_corner || !m_corner->isVisible())
        return {};
    return surfaceBox(QRect(rect().topRight() - QPoint(m_corner->width(), 0), m_corner->size()));
}

void SceneView::drawOver(const PictureMarks &marks)
{
    const bool isOwn = !isDrawingPicture();
    if (marks.map)
        drawMap();
    m_overlay->draw(m_document, marks, isOwn ? m_crosshair.shown() : std::nullopt, isOwn ? m_mark : std::nullopt);
    drawTexts(marks);
}

void SceneView::drawMap()
{
    const Surface surface = currentSurface();
    const QSize size(surface.widthPixels, surface.heightPixels);
    const QSize same = m_map.size().scaled(size, Qt::KeepAspectRatio); // another shape would not align with the objects
    if (!m_map.isNull() && std::abs(size.width() - same.width()) + std::abs(size.height() - same.height()) <= 1)
        paintOver(1.0, [&](QPainter &painter) { painter.drawImage(QRect(QPoint(), size), m_map); }); // pixel on pixel
}

void SceneView::drawTexts(const PictureMarks &marks)
{
    const bool isPicture = isDrawingPicture();
    HighlightMarks highlights = marks.axes ? highlightsInView(m_document, m_highlights) : HighlightMarks();
    if (!isPicture)
        highlights.add(termInView(m_document, m_markedTerm));
    const bool hasTool = m_tool && marks.landmarks && (isPicture || m_tool->prepareToDraw());
    const bool hasLabels = m_hasDropLabels && marks.pick && m_document.picks().pickedPoint();
    if (!hasTool && !hasLabels && highlights.isEmpty())
        return;
    paintOver(currentSurface().devicePixelRatio, [&](QPainter &painter) {
        std::vector<QRectF> boxes = boxesOf(highlights, painter.font(), surfaceRect(),
                                            takenCorners(m_document, isPicture ? QRectF() : cornerBox()));
        drawHighlights(painter, highlights, boxes);
        if (hasLabels) {
            const std::vector<DropLabel> labels = dropLabels(m_document, painter.font(), boxes);
            drawDropLabels(painter, labels);
            for (const DropLabel &label : labels)
                boxes.push_back(label.box);
        }
        if (hasTool && isPicture)
            m_tool->drawPicture(painter, surfaceRect(), boxes);
        else if (hasTool)
            m_tool->draw(painter, boxes);
    });
}

void SceneView::onLButtonDown(const WidgetPoint &position)
{
    const LifecycleTimer timer;
    const std::optional<PixelClick> click = clickAt(position);
    if (!click)
        return;
    emit happened(timer.onLButtonDown(m_document.setup().surface, *click));
    const Result<Pick> pick = m_document.picks().unprojected(*click);
    m_navigation.setPivot(pivotOf(m_document.setup().camera(), pick));
    m_document.picks().setPick(pick);
}

void SceneView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::RightButton && m_drag == Drag::None)
        m_menuPosition = event->position();
    const bool pans = isPan(event->button(), event->modifiers());
    if (m_drag != Drag::None || (!pans && event->button() != Qt::LeftButton))
        return;
    if (!pans && m_tool && m_tool->refuses(*event))
        return;
    m_lastPosition = event->position();
    m_hasMoved = false;
    const QString &mergeKey = m_navigation.beginDrag();
    const WidgetPoint position = widgetPosition(event->position());
    setCrosshairShown(false);
    const ViewTool::Press pressed = pans || !m_tool ? ViewTool::Press::Passed : m_tool->press(*event, mergeKey);
    if (pressed == ViewTool::Press::Drags) {
        m_drag = Drag::Tool;
        return;
    }
    m_toolTakesClick = pressed == ViewTool::Press::Passed && !pans && m_tool && m_tool->takesClicks();
    if (pans || m_toolTakesClick || pressed == ViewTool::Press::Navigates) {
        m_navigation.grab(position);
    } else {
        m_navigation.setPivot(m_document.setup().camera().center); // if nothing can be read
        m_formerPick = m_document.picks().keptPick();
        pickAt(position);
    }
    m_drag = pans ? Drag::Pan : Drag::Orbit;
}

void SceneView::mouseMoveEvent(QMouseEvent *event)
{
    if (m_menuPosition && isDrag(event->position() - *m_menuPosition))
        m_menuPosition.reset();
    const QPointF delta = event->position() - m_lastPosition;
    if (m_drag != Drag::None && !m_hasMoved) {
        if (!isDrag(delta))
            return;
        // It is a drag and not a click: the press's pick is dropped, and the former one is
        // restored.
        if (const std::optional<KeptPick> former = std::exchange(m_formerPick, std::nullopt))
            m_document.picks().putBack(*former);
    }
    m_hasMoved = true;
    m_lastPosition = event->position();
    switch (m_drag) {
    case Drag::None:
        if (event->buttons() != Qt::NoButton)
            return;
        if (!isOnSurface(event->position()))
            return leaveSurface();
        lookAt(widgetPosition(event->position()));
        if (m_tool)
            m_tool->hover(event->position());
        return;
    case Drag::Orbit: m_navigation.orbit(surfaceWay(delta), qRound(surfaceRect().height())); return;
    case Drag::Pan: m_navigation.pan(surfaceWay(delta)); return;
    case Drag::Tool: m_tool->dragTo(event->position()); return;
    }
}

void SceneView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::RightButton) {
        const std::optional<QPointF> position = std::exchange(m_menuPosition, std::nullopt);
        if (position && m_drag == Drag::None)
            openMenu(*position, event->globalPosition().toPoint());
    }
    if (event->buttons() != Qt::NoButton)
        return;
    if (m_tool && m_drag != Drag::None)
        m_tool->release(event->position());
    const bool isClick = std::exchange(m_drag, Drag::None) != Drag::None && !m_hasMoved;
    if (std::exchange(m_toolTakesClick, false) && isClick)
        m_tool->click(event->position());
    m_formerPick.reset();
    if (isOnSurface(event->position()))
        lookAt(widgetPosition(event->position()));
}

void SceneView::lookAt(const WidgetPoint &position)
{
    setMark(snapMarkAt(m_document, position));
    reportHover(position);
}

void SceneView::setMark(const std::optional<SnapMark> &mark)
{
    if (!m_mark && !mark)
        return;
    m_mark = mark;
    update();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (m_drag != Drag::None || event->button() != Qt::LeftButton)
        return;
    if (m_tool && m_tool->takesClicks() && isPan(event->button(), event->modifiers())) {
        mousePressEvent(event);
        return;
    }
    if (m_tool && m_tool->refuses(*event))
        return;
    const std::optional<PixelClick> click = clickAt(widgetPosition(event->position()));
    if (!click || !click->sample.hit())
        return;
    const Result<Pick> pick = m_document.picks().unprojected(*click);
    m_document.picks().setPick(pick);
    setCamera(m_document, recentered(m_document.setup(), pivotOf(m_document.setup().camera(), pick)));
}

void SceneView::wheelEvent(QWheelEvent *event)
{
    if (event->angleDelta().y() == 0)
        return; // sideways
    setCrosshairShown(false);
    const WidgetPoint position = widgetPosition(event->position());
    m_navigation.zoomByWheel(position, event->angleDelta().y() / 120.0);
    lookAt(position);
    event->accept();
}

WorldPoint SceneView::pivotAt(const WidgetPoint &position)
{
    const std::optional<PixelClick> click = clickAt(position);
    return click ? pivotOf(m_document.setup().camera(), m_document.picks().unprojected(*click))
                 : m_document.setup().camera().center;
}

void SceneView::leaveEvent(QEvent *event)
{
    FrameView::leaveEvent(event);
    leaveSurface();
}

void SceneView::leaveSurface()
{
    setMark(std::nullopt);
    if (m_tool && m_drag == Drag::None)
        m_tool->hover(std::nullopt);
    m_hover.stop();
    emit pointerLeft();
}

void SceneView::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void SceneView::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    emit filesDropped(event->mimeData()->urls());
}

void SceneView::contextMenuEvent(QContextMenuEvent *event)
{
    event->accept();
    if (event->reason() == QContextMenuEvent::Mouse)
        return; // opens on release, if it was no drag
    setCrosshairShown(true);
    const QPointF local = localPosition(m_crosshair.position());
    openMenu(local, mapToGlobal(local).toPoint());
}

void SceneView::openMenu(const QPointF &local, const QPoint &global)
{
    if (!m_tool || !m_tool->showMenu(local, global))
        showViewMenu(*this, m_document, widgetPosition(local), global);
}

void SceneView::setCrosshairShown(bool isShown)
{
    if (m_crosshair.setShown(isShown))
        update();
}

void SceneView::pickAt(const WidgetPoint &position)
{
    m_crosshair.put(position);
    onLButtonDown(position);
}

void SceneView::pickPixel(const DevicePixel &pixel)
{
    const WidgetPoint position = widgetFromDevice(m_document.setup().surface, pixelCenter(pixel));
    m_crosshair.put(position);
    setCrosshairShown(true);
    update();
    onLButtonDown(position);
}

bool SceneView::event(QEvent *event)
{
    // The view's keys come before the window's shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto &key = *static_cast<QKeyEvent *>(event);
        if ((m_tool && m_tool->isKey(key)) || viewKeyOf(key)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip && m_tool && m_tool->showTip(*static_cast<QHelpEvent *>(event)))
        return true;
    return FrameView::event(event);
}

void SceneView::keyPressEvent(QKeyEvent *event)
{
    if (m_tool && m_tool->isKey(*event)) {
        m_tool->pressKey(*event, m_drag != Drag::None);
        return;
    }
    const std::optional<ViewKey> key = viewKeyOf(*event);
    if (!key) {
        FrameView::keyPressEvent(event);
        return;
    }
    if (m_drag != Drag::None)
        return; // the mouse is already turning the view
    setCrosshairShown(true);
    switch (key->kind) {
    case ViewKey::Kind::Turn:
    case ViewKey::Kind::Move:
    case ViewKey::Kind::Zoom: m_navigation.press(*key, m_crosshair.position(), qRound(surfaceRect().height())); return;
    case ViewKey::Kind::Aim:
        m_crosshair.move(key->way);
        lookAt(m_crosshair.position());
        update();
        return;
    case ViewKey::Kind::Pick:
        onLButtonDown(m_crosshair.position());
        // Reported like the pixel under the mouse: the panel with the numbers may be behind
        // another.
        m_hover.readOnce(m_crosshair.position());
        return;
    }
}

void SceneView::focusInEvent(QFocusEvent *event)
{
    FrameView::focusInEvent(event);
    // A user who came by a key continues with keys: the crosshair shows the focus.
    if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
        setCrosshairShown(true);
}

void SceneView::focusOutEvent(QFocusEvent *event)
{
    FrameView::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason)
        setCrosshairShown(false);
}

} // namespace unprojector::gui
