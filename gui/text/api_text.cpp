#include "gui/text/api_text.h"

#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace unprojector::gui {
using namespace geometry;

namespace {

struct ApiText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::ApiText)
};

} // namespace

QString apiText(geometry::Api api)
{
    using geometry::Api;
    switch (api) {
    case Api::OpenGl:
        return ApiText::tr("The eye looks along −z, y up; NDC from −1 to 1; pixels from the bottom-left corner, y up, "
                           "with their centres at halves.");
    case Api::Vulkan:
        return ApiText::tr(
            "y of NDC points down, z goes from 0 to 1; pixels from the top-left corner. The projection is "
            "GLM's perspectiveRH_ZO with its second row negated.");
    case Api::Direct3d:
        return ApiText::tr(
            "Row vectors; the eye looks along +z (XMMatrixPerspectiveFovLH); z of NDC from 0 to 1; pixels "
            "from the top-left corner. The world stays as it is, so the view mirrors z. Direct3D 10 and "
            "later: 9 has the centres of pixels at whole numbers.");
    case Api::Metal:
    case Api::WebGpu: return ApiText::tr("z of NDC from 0 to 1; pixels from the top-left corner, y down.");
    case Api::ThreeJs:
        return ApiText::tr(
            "Logical (CSS) pixels from the top-left corner, as in clientX and clientY; everything else as in OpenGL.");
    case Api::Unity:
        return ApiText::tr(
            "The world is left-handed: its z is negated. The camera's matrices are OpenGL's, pixels count "
            "from the bottom-left corner. The depth buffer is reversed, 1 at near "
            "(SystemInfo.usesReversedZBuffer; where Unity runs on OpenGL it is not).");
    case Api::OpenCv:
        return ApiText::tr("x right, y down, z forward; pixels from the top-left corner with their centres at whole "
                           "numbers. x / z and y / z replace NDC, z replaces the depth. No lens distortion.");
    case Api::OpenCascade: return ApiText::tr("Row vectors, v · M; pixels from the top-left corner, y down.");
    }
    return {};
}

QString intrinsicsText(const glm::dmat3 &k)
{
    constexpr int kDigits = 7;
    QStringList rows;
    for (int row = 0; row < 3; ++row)
        rows << QStringLiteral("%1 %2 %3")
                    .arg(writtenText(k[0][row], kDigits), writtenText(k[1][row], kDigits),
                         writtenText(k[2][row], kDigits));
    return QStringLiteral("K = [%1]").arg(rows.join(QStringLiteral("; ")));
}

} // namespace unprojector::gui
