#pragma once

#include "core/pipeline/matrix_factors.h"
#include "core/pipeline/matrix_findings.h"
#include "core/pipeline/pipeline.h"
#include "gui/document/followed_object.h"
#include "gui/pipeline/matrix_model.h"
#include "gui/pipeline/point_model.h"

#include <QObject>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// The contents of the pipeline panel: a point in every space, picked or given by the user; the
/// matrices between them, and a sentence. It reads the document only in update(), so that a hidden
/// panel costs nothing.
class PipelineModel : public QObject {
    Q_OBJECT
public:
    /// The object whose space is shown: the index of one of the document's objects, or one of
    /// these.
    static constexpr int kAutomaticObject = -1; ///< the object that was drawn at the picked pixel
    static constexpr int kNoObject = -2;        ///< the identity: object coordinates are world coordinates

    explicit PipelineModel(SceneDocument &document, QObject *parent = nullptr);

    /// Reads the current document.
    void update();

    pipeline::PipelineDirection direction() const { return m_direction; }
    void setDirection(pipeline::PipelineDirection direction);
    /// The chosen object stays chosen while the list changes, until it is removed.
    int object() const;
    void setObject(int object);
    const MatrixView &view() const { return m_view; }
    void setView(const MatrixView &view);

    MatrixModel *matrix(pipeline::PipelineStage stage) const { return m_matrices[static_cast<std::size_t>(stage)]; }
    /// The projection's matrix as in the file.
    MatrixModel *given() const { return m_given; }
    /// Describes how it was interpreted and converted; empty if the projection is not given as a
    /// matrix (any more).
    const QString &givenNote() const { return m_givenNote; }
    /// The view's matrix as given.
    MatrixModel *givenView() const { return m_givenView; }
    /// The findings about the given matrices.
    const std::vector<pipeline::MatrixFinding> &givenFindings(pipeline::MatrixRole role) const;
    /// Applies a finding's fix to the scene.
    void repair(pipeline::MatrixRole role, const pipeline::MatrixFinding &finding);
    /// The factors of the view's or the projection's matrix in forward direction.
    /// @return nothing for another stage, and backward
    std::optional<std::vector<pipeline::MatrixFactor>> factors(pipeline::PipelineStage stage) const;
    PointModel *point(PointModel::Space space) const { return m_points[static_cast<std::size_t>(space)]; }

    /// Returns whether the user's point is shown instead of the pick: from its entry until the next
    /// click.
    bool followsGiven() const;
    /// Selects which of both is shown. The document keeps the user's point.
    void followGiven(bool follows);
    void removeGiven();

    /// Returns whether the values at the click differ from the current ones: the setup has changed
    /// or the object was moved. False while the user's point is shown.
    bool canShowClick() const;
    /// Returns whether points and matrices are the ones at the click. A new click returns to the
    /// current values.
    bool showsClick() const { return m_showsClick && canShowClick(); }
    void setShowsClick(bool shows);
    /// The displayed setup: the click's or the document's.
    const geometry::Setup &setup() const;
    /// Returns whether the displayed view is given as a matrix.
    bool isViewGiven() const;
    bool isProjectionGiven() const;

    /// The object whose space is shown; nothing for the identity.
    std::optional<std::size_t> shownObject() const;
    /// The conventions of points and matrices: the scene's.
    geometry::Api api() const { return m_api; }
    /// Sets the conventions, undoably.
    void setApi(geometry::Api api);
    /// The differences from OpenGL, with the camera's numbers if they are no matrix; empty for
    /// OpenGL.
    const QString &apiNote() const { return m_apiNote; }
    /// Returns whether the window point's depth on the way back was read at the click; else it is
    /// computed.
    bool isDepthRead() const;
    /// The origin of the points, or why there are none.
    const QString &status() const { return m_status; }
    /// Points and matrices with all digits.
    QString text() const;

signals:
    /// Emitted when another point is shown, when the user's point is added or removed, and on a
    /// switch between the values at the click and the current ones.
    void followedChanged();
    /// Emitted when the typed text is no point, with the reason.
    void refused(const QString &reason);

private:
    void showGiven();
    /// worldFromObject of the object whose space is shown.
    glm::dmat4 placement() const;
    /// Parses the text for one coordinate of a space, or for all of them, and makes it the user's
    /// point.
    void take(PointModel::Space space, int coordinate, const QString &typed);
    void showGivenPoint(const pipeline::Pipeline &pipeline);
    void showAll(const pipeline::PipelinePoints &points);
    /// The conversion of a space's coordinates from this program's.
    geometry::AxisChange changeOf(PointModel::Space space) const;
    void showApi();
    void showPoints(const pipeline::Pipeline &pipeline);
    void clearPoints();

    SceneDocument &m_document;
    bool m_followsGiven = false;
    bool m_showsClick = false;
    pipeline::PipelineDirection m_direction = pipeline::PipelineDirection::Forward;
    FollowedObject *m_chosen;
    bool m_isIdentity = false;
    MatrixView m_view;
    geometry::Api m_api = geometry::Api::OpenGl;
    geometry::ApiSpaces m_spaces;
    QString m_apiNote;
    std::array<MatrixModel *, pipeline::kPipelineStages.size()> m_matrices;
    std::array<PointModel *, PointModel::kSpaces> m_points;
    MatrixModel *m_given;
    MatrixModel *m_givenView;
    std::vector<pipeline::MatrixFinding> m_projectionFindings, m_viewFindings;
    QString m_givenNote;
    QString m_status;
};

} // namespace unprojector::gui
