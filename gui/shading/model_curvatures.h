#pragma once

#include "core/mesh/mesh.h"
#include "gui/document/background.h"
#include "gui/view/shading.h"

#include <QObject>

#include <memory>
#include <vector>

namespace unprojector::gui {

/// The curvature of models, computed in the background, one model after the other. It keeps no
/// model alive.
class ModelCurvatures : public QObject {
    Q_OBJECT
public:
    using ModelList = std::vector<std::shared_ptr<const mesh::Model>>;

    /// Computes the missing curvatures of these models, in this order. Cancels the others.
    void prepare(const ModelList &models);
    /// Cancels everything that is not computed yet.
    void cancel();
    bool isComputing() const { return m_background.isRunning(); }
    /// The curvatures computed so far.
    const CurvatureMap &all() const { return m_all; }

signals:
    /// Emitted when another model's curvature is computed, and when the last one has failed.
    void changed();
    /// @param share  of the triangles of all models being prepared, in [0, 1]
    void progressed(double share);
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    void begin(const std::shared_ptr<const mesh::Model> &model);

    CurvatureMap m_all;
    std::vector<std::weak_ptr<const mesh::Model>> m_waiting; ///< under way or to come
    double m_size = 0.0, m_done = 0.0;                       ///< triangles
    Background m_background;
};

} // namespace unprojector::gui
