#include "gui/view/scene_picture.h"

#include "gui/view/scene_view.h"

namespace unprojector::gui {
using namespace geometry;

std::optional<FrameContents> frameContentsOf(const SceneDocument &document)
{
    const Setup &g = document.setup();
    const Result<glm::dmat4> matrix = clipFromWorld(g);
    const Result<EyeFrame> frame = eyeFrame(g.camera());
    const Result<Drawable> drawn = drawable(g);
    if (!matrix || !frame || !drawn)
        return std::nullopt;
    return FrameContents{*drawn, document.objects(), *matrix, eyeFromWorld(*frame), document.scene().clipPlanes};
}

Result<QImage> scenePicture(SceneView &view, const PictureOptions &options)
{
    QImage picture;
    view.makeCurrent();
    const Check drawn = view.m_document.drawAt(options.surface, [&] {
        if (const std::optional<FrameContents> contents = frameContentsOf(view.m_document))
            picture = view.drawnPicture(*contents, options.isTransparent, [&] { view.drawOver(options.marks); });
    });
    view.doneCurrent();
    return drawn ? Result<QImage>(picture) : Result<QImage>(drawn.error());
}

} // namespace unprojector::gui
