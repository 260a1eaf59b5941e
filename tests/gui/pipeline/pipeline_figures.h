#pragma once

#include "core/scene_file/scene_file.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/pipeline_model.h"

#include <QTest>

#include <cmath>
#include <initializer_list>
#include <memory>

/// The pipeline of the originals' figures, and how its numbers are read.
namespace pipelinetest {
using Space = unprojector::gui::PointModel::Space;
using Stage = unprojector::pipeline::PipelineStage;

/// Coordinates of order 10 through the whole pipeline in double.
inline constexpr double kRounding = 1e-11;

inline unprojector::scene::SceneObject boxObject(const char *name, double halfSide,
                                                 std::vector<unprojector::geometry::TransformStep> transform)
{
    auto model = std::make_shared<unprojector::mesh::Model>();
    model->bounds.add(glm::dvec3(-halfSide));
    model->bounds.add(glm::dvec3(halfSide));
    unprojector::scene::SceneObject object;
    object.name = name;
    object.model = model;
    object.transform = std::move(transform);
    return object;
}

/// Opens figures 2.7 and 2.10 in a window of 50 x 50: from (0, 0, 5), glTranslate(0, 0, -3),
/// glOrtho(-10, …, 10).
inline void openFigures(unprojector::gui::SceneDocument &document)
{
    unprojector::scene::Scene scene;
    scene.camera = scene.home = {
        unprojector::geometry::WorldPoint(0, 0, 5), unprojector::geometry::WorldPoint(0, 0, 0), {0, 1, 0}};
    scene.projection = unprojector::geometry::Ortho{-10, 10, -10, 10, -10, 10};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    scene.objects = {boxObject("small", 5, {unprojector::geometry::Translate{{0, 0, -3}}}),
                     boxObject("large", 9, {unprojector::geometry::Scale{{2, 2, 2}}})};
    document.setSurface(unprojector::geometry::surfaceFromWidget(50, 50, 1.0));
    QVERIFY(document.open(scene));
}

inline double value(const unprojector::gui::NumberGridModel *model, int row, int column)
{
    const QVariant value = model->index(row, column).data(unprojector::gui::NumberGridModel::kValueRole);
    return value.isValid() ? value.toDouble() : std::nan("");
}

inline double coordinate(const unprojector::gui::PointModel *model, int which)
{
    const QVariant value = model->indexOf(which).data(unprojector::gui::NumberGridModel::kValueRole);
    return value.isValid() ? value.toDouble() : std::nan("");
}

inline bool isPoint(const unprojector::gui::PointModel *model, std::initializer_list<double> expected)
{
    int column = 0;
    for (const double number : expected) {
        if (!(std::abs(coordinate(model, column) - number) <= kRounding)) {
            qWarning("%s: %s", qPrintable(model->name()), qPrintable(model->fullText()));
            return false;
        }
        ++column;
    }
    return true;
}

inline bool isBlank(const unprojector::gui::PipelineModel &model)
{
    for (int i = 0; i < unprojector::gui::PointModel::kSpaces; ++i) {
        if (model.point(static_cast<Space>(i))->fullText() != QStringLiteral("–"))
            return false;
    }
    return true;
}

inline QString cell(const unprojector::gui::NumberGridModel *model, int row, int column)
{
    return model->index(row, column).data().toString().replace(QChar::Nbsp, u' ').trimmed();
}

} // namespace pipelinetest
