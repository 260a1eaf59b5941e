#pragma once

#include "document_edits.h"

#include "core/unproject/pick.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "tests/support/unprojecting.h"

#include <QLabel>
#include <QRegularExpression>
#include <QString>
#include <QtGlobal>

/// What the tests of the comparison's panel and of its texts share: picks to show, and a text's look.
namespace comparing {

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

/// 800 x 600, window +-0.828427 x +-0.62132 at n = 2, f = 10, from (0, 0, 5) towards the origin.
inline Picture frustumGeometry()
{
    return {{800, 600, 1.0},
            {0.0, 0.0, 800.0, 600.0},
            {},
            Frustum{-0.8284271247461901, 0.8284271247461901, -0.6213203435596426, 0.6213203435596426, 2.0, 10.0},
            LookAt{WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
}

inline Picture boxGeometry(const Projection &projection)
{
    return {{600, 400, 1.0},
            {0.0, 0.0, 600.0, 400.0},
            {},
            projection,
            LookAt{WorldPoint(10.0, 20.0, 30.0), WorldPoint(10.0, 20.0, 20.0), {0.0, 1.0, 0.0}}};
}

inline Pick picked(const Picture &geometry, double x, double y, double depth, bool hit = true)
{
    const Result<Pick> pick =
        pickAt(geometry, WidgetPoint(x, y), {depth, hit ? std::optional<std::size_t>(0) : std::nullopt, 24});
    if (!pick)
        qFatal("no pick");
    return *pick;
}

/// A pick whose world point is what each method is told to have found, and each coordinate of it off by no more than
/// `radius`.
inline Pick pickWith(const glm::dvec3 &formula, const glm::dvec3 &matrix, const glm::dvec3 &matrixInFloat,
                     double radius)
{
    Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
    pick.point.world = Answers<WorldSpace>::of([&](Method method) {
        return WorldPoint(method == Method::Formula ? formula : method == Method::Matrix ? matrix : matrixInFloat);
    });
    pick.uncertainty.world = {radius, radius, radius};
    return pick;
}

/// A pick without its object's placement and its ray.
inline gui::KeptPick kept(const Pick &pick)
{
    gui::KeptPick result;
    result.pick = pick;
    return result;
}

/// A document, for the panel that is made after it.
struct WithDocument {
    gui::SceneDocument document;
};

/// A panel of a document of its own, which is told its pick.
struct PanelOfPicks : WithDocument, gui::ComparisonPanel {
    PanelOfPicks() : ComparisonPanel(document) {}

    void setPick(const std::optional<Pick> &pick)
    {
        if (pick)
            document.picks().setPick(*pick);
        else
            document.picks().clearPick();
    }
};

inline QLabel *labelNamed(const QWidget &panel, const char *accessibleName)
{
    for (QLabel *label : panel.findChildren<QLabel *>()) {
        if (label->accessibleName() == QLatin1String(accessibleName))
            return label;
    }
    return nullptr;
}

inline QVariant cell(const gui::ComparisonModel &model, int row, int column, int role = Qt::DisplayRole)
{
    return model.index(row, column).data(role);
}

inline bool hasPlaceholder(const QString &text)
{
    return text.contains(QRegularExpression(QStringLiteral("%[0-9n]")));
}

} // namespace comparing
