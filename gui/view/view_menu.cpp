#include "gui/view/view_menu.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/text/number_text.h"
#include "gui/text/ray_text.h"
#include "gui/view/scene_view.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeySequence>
#include <QMenu>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

void showViewMenu(SceneView &view, SceneDocument &document, const WidgetPoint &position, const QPoint &global)
{
    const std::optional<PixelClick> click = view.clickAt(position);
    std::optional<WorldPoint> surface;
    if (click && click->sample.hit())
        surface = pivotOf(document.setup().camera(), document.picks().unprojected(*click));
    const std::optional<std::size_t> object = click ? click->sample.object : std::nullopt;

    auto *menu = new QMenu(&view);
    menu->setObjectName(QStringLiteral("viewMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const auto add = [&view, menu](const char *name, const QString &text, const QKeySequence &key, const QString &tip,
                                   bool isEnabled, auto slot) {
        QAction *action =
            menu->addAction(key.isEmpty() ? text : text + u'\t' + key.toString(QKeySequence::NativeText), &view, slot);
        action->setObjectName(QLatin1String(name));
        action->setToolTip(tip);
        action->setEnabled(isEnabled);
    };
    add("pickHere", SceneView::tr("Pick Here"), Qt::Key_Return,
        SceneView::tr("Read the world coordinate of this pixel"), click.has_value(),
        [&view, position] { view.pickAt(position); });
    const bool isPrepared = document.picks().snap() == ray::Snap::Surface || document.picks().rays();
    add("copyPoint", SceneView::tr("Pick and Copy Point"), {},
        !surface      ? SceneView::tr("Background: no surface here")
        : !isPrepared ? rayPreparingText()
                      : SceneView::tr("Read the world coordinate of this pixel and copy it with all digits"),
        surface && isPrepared, [&view, &document, position] {
            view.pickAt(position);
            if (const std::optional<WorldPoint> point = document.picks().pickedPoint())
                QGuiApplication::clipboard()->setText(
                    QStringLiteral("%1, %2, %3")
                        .arg(shortestText(point->x), shortestText(point->y), shortestText(point->z)));
        });
    add("lookHere", SceneView::tr("Look at This Point"), {},
        SceneView::tr("Centre the view on this point and turn about it"), surface.has_value(),
        [&document, surface] { setCamera(document, recentered(document.setup(), *surface)); });
    menu->addSeparator();
    add("fit", SceneView::tr("Fit"), Qt::Key_F, SceneView::tr("Move the camera until all objects fill the view"), true,
        [&document] { fitAll(document); });
    add("fitObject", SceneView::tr("Fit This Object"), {},
        SceneView::tr("Move the camera so that this object fills the view"), object.has_value(),
        [&document, object] { fitObject(document, *object); });
    add("hideObject", SceneView::tr("Hide This Object"), {},
        SceneView::tr("Hide it from the view and from clicks; the Objects panel shows it again"), object.has_value(),
        [&document, object] { static_cast<void>(setObjectHidden(document, *object, true)); });
    add("showAll", SceneView::tr("Show All Objects"), {}, SceneView::tr("Show the hidden objects again"),
        hasHiddenObjects(document.scene()), [&document] { static_cast<void>(showAllObjects(document)); });
    // The menu refers to objects by index, and to the pick.
    QObject::connect(&document, &SceneDocument::changed, menu, [menu](Changes changes) {
        if (changes & (Change::Objects | Change::Pick))
            menu->close();
    });
    menu->popup(global);
}

} // namespace unprojector::gui
