#pragma once

#include "core/matrices/matrix_factors.h"
#include "core/matrices/matrix_findings.h"
#include "core/matrices/pipeline.h"
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

/// What the pipeline panel shows of a document: a point in every space, the picked one or one that the user gives in numbers;
/// the matrices between them, and a sentence. It looks at the document when told to, so that a hidden panel costs nothing.
class PipelineModel : public QObject {
    Q_OBJECT
public:
    /// Whose object space: the index of one of the document's objects, or one of these.
    static constexpr int kAutomaticObject = -1; ///< the one that was drawn at the picked pixel
    static constexpr int kNoObject = -2;        ///< the identity: object coordinates are world coordinates

    explicit PipelineModel(SceneDocument &document, QObject *parent = nullptr);

    /// Takes over the document as it is now.
    void update();

    matrices::PipelineDirection direction() const { return m_direction; }
    void setDirection(matrices::PipelineDirection direction);
    /// A chosen object stays chosen while the list changes around it, until it is removed.
    int object() const;
    void setObject(int object);
    const MatrixView &view() const { return m_view; }
    void setView(const MatrixView &view);

    MatrixModel *matrix(matrices::PipelineStage stage) const { return m_matrices[static_cast<std::size_t>(stage)]; }
    /// The projection's matrix as the file gives it.
    MatrixModel *given() const { return m_given; }
    /// How it was read and what became of it; empty where the projection is not given as a matrix (any more).
    const QString &givenNote() const { return m_givenNote; }
    /// The view's matrix as it is given.
    MatrixModel *givenView() const { return m_givenView; }
    /// What is to be seen of the matrices that are given.
    const std::vector<matrices::MatrixFinding> &givenFindings(matrices::MatrixRole role) const;
    /// Does what a finding offers to the scene.
    void repair(matrices::MatrixRole role, const matrices::MatrixFinding &finding);
    /// The factors of the view's or the projection's matrix as it is shown forward.
    /// @return nothing where it has none: of another stage, and backward
    std::optional<std::vector<matrices::MatrixFactor>> factors(matrices::PipelineStage stage) const;
    PointModel *point(PointModel::Space space) const { return m_points[static_cast<std::size_t>(space)]; }

    /// Whether the given point is shown and not the picked one: since it was given, until the next click.
    bool followsGiven() const;
    /// Shows the one or the other. The given point stays the document's.
    void followGiven(bool follows);
    void removeGiven();

    /// Whether the values at the click are other than those now: the setup has changed since, or the object was moved.
    bool canShowClick() const;
    /// Whether points and matrices are those at the click. A new click shows the values now.
    bool showsClick() const { return m_showsClick && canShowClick(); }
    void setShowsClick(bool shows);
    /// The setup that is shown: that of the click or the document's.
    const geometry::Setup &setup() const;
    /// Whether the view that is shown is given as a matrix, and the projection.
    bool isViewGiven() const;
    bool isProjectionGiven() const;

    /// The object whose space is shown; nothing for the identity.
    std::optional<std::size_t> shownObject() const;
    /// Whose conventions points and matrices have: the scene's.
    geometry::Api api() const { return m_api; }
    /// Undoably.
    void setApi(geometry::Api api);
    /// What is otherwise there than in OpenGL, with the camera's numbers where they are no matrix; empty for OpenGL.
    const QString &apiNote() const { return m_apiNote; }
    /// Whether the window point's depth on the way back is the one that was read at the click; else it is computed.
    bool isDepthRead() const;
    /// Where the points come from, or why there are none.
    const QString &status() const { return m_status; }
    /// Points and matrices with all digits.
    QString text() const;

signals:
    /// Which point is shown, whether there is a given one, or whether the values are those at the click.
    void followedChanged();
    /// What was typed is no point, with the reason.
    void refused(const QString &reason);

private:
    void showGiven();
    /// worldFromObject of the object whose space is shown.
    glm::dmat4 placement() const;
    /// Makes what was typed for a coordinate of a space, or for all of them, the given point.
    void take(PointModel::Space space, int coordinate, const QString &typed);
    void showGivenPoint(const matrices::Pipeline &pipeline);
    void showAll(const matrices::PipelinePoints &points);
    /// How the coordinates of a space follow from those of this program.
    geometry::AxisChange changeOf(PointModel::Space space) const;
    void showApi();
    void showPoints(const matrices::Pipeline &pipeline);
    void clearPoints();

    SceneDocument &m_document;
    bool m_followsGiven = false;
    bool m_showsClick = false;
    matrices::PipelineDirection m_direction = matrices::PipelineDirection::Forward;
    FollowedObject *m_chosen;
    bool m_isIdentity = false;
    MatrixView m_view;
    geometry::Api m_api = geometry::Api::OpenGl;
    geometry::ApiSpaces m_spaces;
    QString m_apiNote;
    std::array<MatrixModel *, matrices::kPipelineStages.size()> m_matrices;
    std::array<PointModel *, PointModel::kSpaces> m_points;
    MatrixModel *m_given;
    MatrixModel *m_givenView;
    std::vector<matrices::MatrixFinding> m_projectionFindings, m_viewFindings;
    QString m_givenNote;
    QString m_status;
};

} // namespace unprojector::gui
