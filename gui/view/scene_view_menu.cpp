// What a right click in the view, or the menu key, offers for the pixel there.

#include "gui/view/scene_view.h"

#include "gui/document/camera_looks.h"
#include "gui/document/scene_edits.h"
#include "gui/text/number_text.h"
#include "gui/text/ray_text.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeySequence>
#include <QMenu>

namespace unprojector::gui {

void SceneView::contextMenuEvent(QContextMenuEvent *event)
{
    event->accept();
    if (event->reason() == QContextMenuEvent::Mouse)
        return; // at the release, where it was no drag
    setCrosshairShown(true);
    const WidgetPoint position = widgetFromDevice(m_document.geometry().surface, pixelCenter(crosshair()));
    showMenu(position, mapToGlobal(QPointF(position.x, position.y).toPoint()));
}

void SceneView::showMenu(const WidgetPoint &position, const QPoint &global)
{
    const std::optional<DepthSample> sample = sampleAt(position);
    std::optional<WorldPoint> surface;
    if (sample && sample->hit())
        surface = pivotOf(m_document.geometry().camera(), m_document.unprojected(position, *sample));
    const std::optional<std::size_t> object = sample ? sample->object : std::nullopt;

    auto *menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("viewMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const auto add = [this, menu](const char *name, const QString &text, const QKeySequence &key, const QString &tip,
                                  bool isEnabled, auto slot) {
        QAction *action =
            menu->addAction(key.isEmpty() ? text : text + u'\t' + key.toString(QKeySequence::NativeText), this, slot);
        action->setObjectName(QLatin1String(name));
        action->setToolTip(tip);
        action->setEnabled(isEnabled);
    };
    add("pickHere", tr("Pick Here"), Qt::Key_Return, tr("Read the world coordinate of this pixel"), sample.has_value(),
        [this, position] {
            putCrosshair(position);
            onLButtonDown(position);
        });
    const bool isPrepared = m_document.snap() == ray::Snap::Surface || m_document.rays();
    add("copyPoint", tr("Pick and Copy Point"), {},
        !surface      ? tr("Background: no surface here")
        : !isPrepared ? rayPreparingText()
                      : tr("Read the world coordinate of this pixel and copy it, all its digits"),
        surface && isPrepared, [this, position] {
            putCrosshair(position);
            onLButtonDown(position);
            if (const std::optional<WorldPoint> point = m_document.pickedPoint())
                QGuiApplication::clipboard()->setText(
                    QStringLiteral("%1, %2, %3")
                        .arg(shortestText(point->x), shortestText(point->y), shortestText(point->z)));
        });
    add("lookHere", tr("Look at This Point"), {}, tr("Bring it to the middle; the view turns about it"),
        surface.has_value(), [this, surface] { setCamera(m_document, recentered(m_document.geometry(), *surface)); });
    menu->addSeparator();
    add("fit", tr("Fit"), Qt::Key_F, tr("Move the camera until all objects fill the view"), true,
        [this] { fitAll(m_document); });
    add("fitObject", tr("Fit This Object"), {}, tr("Look at this object: it fills the view"), object.has_value(),
        [this, object] { fitObject(m_document, *object); });
    add("hideObject", tr("Hide This Object"), {}, tr("Neither draw nor click it; the Objects panel shows it again"),
        object.has_value(), [this, object] { static_cast<void>(setObjectHidden(m_document, *object, true)); });
    add("showAll", tr("Show All Objects"), {}, tr("Those that are hidden as well"),
        hasHiddenObjects(m_document.scene()), [this] { static_cast<void>(showAllObjects(m_document)); });
    // It speaks of objects by their places, and of a point that is picked.
    connect(&m_document, &SceneDocument::changed, menu, [menu](Changes changes) {
        if (changes & (Change::Objects | Change::Pick))
            menu->close();
    });
    menu->popup(global);
}

} // namespace unprojector::gui
