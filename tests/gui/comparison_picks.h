#pragma once

#include "tests/gui/document_edits.h"

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

/// Helpers that the tests of the comparison's panel and texts share: picks to show, and a text's
/// look.
namespace comparing {

/// 800 x 600, window +-0.828427 x +-0.62132 at n = 2, f = 10, from (0, 0, 5) towards the origin.
inline unprojector::geometry::Setup frustumGeometry()
{
    return {{800, 600, 1.0},
            {0.0, 0.0, 800.0, 600.0},
            {},
            unprojector::geometry::Frustum{-0.8284271247461901, 0.8284271247461901, -0.6213203435596426,
                                           0.6213203435596426, 2.0, 10.0},
            unprojector::geometry::LookAt{unprojector::geometry::WorldPoint(0.0, 0.0, 5.0),
                                          unprojector::geometry::WorldPoint(0.0, 0.0, 0.0),
                                          {0.0, 1.0, 0.0}}};
}

inline unprojector::geometry::Setup boxGeometry(const unprojector::geometry::Projection &projection)
{
    return {{600, 400, 1.0},
            {0.0, 0.0, 600.0, 400.0},
            {},
            projection,
            unprojector::geometry::LookAt{unprojector::geometry::WorldPoint(10.0, 20.0, 30.0),
                                          unprojector::geometry::WorldPoint(10.0, 20.0, 20.0),
                                          {0.0, 1.0, 0.0}}};
}

inline unprojector::unproject::Pick picked(const unprojector::geometry::Setup &setup, double x, double y, double depth,
                                           bool hit = true)
{
    const unprojector::geometry::Result<unprojector::unproject::Pick> pick =
        pickAt(setup, unprojector::geometry::WidgetPoint(x, y),
               {depth, hit ? std::optional<std::size_t>(0) : std::nullopt, 24});
    if (!pick)
        qFatal("no pick");
    return *pick;
}

/// A pick with these world points, one for each method; the uncertainty of each coordinate is at
/// most `radius`.
inline unprojector::unproject::Pick pickWith(const glm::dvec3 &formula, const glm::dvec3 &matrix,
                                             const glm::dvec3 &matrixInFloat, double radius)
{
    unprojector::unproject::Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
    pick.point.world = unprojector::unproject::Answers<unprojector::geometry::WorldSpace>::of(
        [&](unprojector::unproject::Method method) {
            return unprojector::geometry::WorldPoint(method == unprojector::unproject::Method::Formula ? formula
                                                     : method == unprojector::unproject::Method::Matrix
                                                         ? matrix
                                                         : matrixInFloat);
        });
    pick.uncertainty.world = {radius, radius, radius};
    return pick;
}

/// A pick without its object's placement and its ray.
inline unprojector::gui::KeptPick kept(const unprojector::unproject::Pick &pick)
{
    unprojector::gui::KeptPick result;
    result.pick = pick;
    return result;
}

/// A document, for the panel that is constructed after it.
struct WithDocument {
    unprojector::gui::SceneDocument document;
};

/// A panel with a document of its own, for given picks.
struct PanelOfPicks : WithDocument, unprojector::gui::ComparisonPanel {
    PanelOfPicks() : ComparisonPanel(document) {}

    void setPick(const std::optional<unprojector::unproject::Pick> &pick)
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

inline QVariant cell(const unprojector::gui::ComparisonModel &model, int row, int column, int role = Qt::DisplayRole)
{
    return model.index(row, column).data(role);
}

inline bool hasPlaceholder(const QString &text)
{
    return text.contains(QRegularExpression(QStringLiteral("%[0-9n]")));
}

} // namespace comparing
