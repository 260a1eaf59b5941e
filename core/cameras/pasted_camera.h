#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/cameras/pasted_matrix.h"
#include "core/geometry/api_conventions.h"
#include "core/pipeline/decomposition.h"
#include "core/pipeline/matrix_findings.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::cameras {

/// A correction that a finding offers, chosen by the user.
struct Correction {
    pipeline::MatrixRole role = pipeline::MatrixRole::View;
    pipeline::MatrixFinding finding;
};

/// The choices of the user about a pasted text.
struct PasteChoices {
    CameraChoices camera; ///< of a program's camera; direction and axes, of a view without a name, too
    std::optional<pipeline::MatrixRole> role; ///< of a matrix that is alone in the text
    std::optional<NumberOrder> order;         ///< of all matrices
    std::optional<geometry::NdcDepth> ndcDepth;
    geometry::Api conventions = geometry::Api::OpenGl; ///< of the matrices, which are converted to OpenGL's
    bool areMatrices = false;                          ///< the text is of no program's camera
    /// Projection, view and viewport are needed, or product and viewport; the product need not be decomposable.
    bool isScene = false;
    std::vector<Correction> corrections; ///< in their order
};

/// A matrix of a pasted text, as the scene takes it.
struct ReadMatrix {
    PastedPart part = PastedPart::ModelView;
    pipeline::MatrixRole role = pipeline::MatrixRole::View;
    PastedMatrix given{};
    NumberOrder order = NumberOrder::ByColumns;      ///< the chosen one, else that of the numbers, else the form's
    glm::dmat4 matrix{1.0};                          ///< in this order, in OpenGL's conventions, corrected
    std::optional<geometry::NdcDepth> ndcDepth{};    ///< chosen, or of the API; none: derived from the numbers
    std::vector<pipeline::MatrixFinding> findings{}; ///< of the corrected matrix
};

/// What a pasted text was read as: the camera of a program, or matrices.
struct PastedCamera {
    std::optional<ForeignCamera> foreign; ///< as the program gives it
    std::optional<SceneCamera> scene;     ///< the same, converted
    std::vector<ReadMatrix> matrices;     ///< that count: projection and view, one of them, or their product
    std::vector<std::string> notes;       ///< on what is ignored: its part, then what about it, without a full stop
    bool isRoleByForm = false;            ///< the only matrix has no name that tells its role: its form does
    bool isRoleOpen = false;              ///< and it has the form of another role, too
    /// Of a view by its form alone, whose direction nothing tells: the one it is read in.
    std::optional<PoseDirection> openDirection;
    std::optional<pipeline::Decomposition> apart;   ///< of a product
    std::vector<std::string> aside;                 ///< names whose numbers belong to no matrix: "near", "Mouse"
    std::optional<geometry::Viewport> viewport;     ///< beside matrices; a height below 0: its matrix flips y
    std::optional<ReadMatrix> viewportMatrix;       ///< that gives it
    std::optional<geometry::DepthRange> depthRange; ///< of this matrix
    bool isViewportSet = false;                     ///< by a call: the scene takes it
    bool hasNumbers = true;
    bool isProgram = false;           ///< the text has a known program's form, whether or not it can be read
    std::optional<base::Error> fault; ///< why there is no camera

    std::optional<geometry::Lens> projection; ///< for the scene; none: it keeps its own
    std::optional<glm::dmat4> eyeFromWorld;   ///< as well
};

/// Reads the camera in these texts: that of a program, else matrices and calls.
///
/// A matrix without a name that is alone gets its role from its form: a rotation and translation is
/// a view; else a projection's form counts; else the matrix is a product.
/// @param objects  see sceneCamera
PastedCamera pastedCamera(std::span<const NamedText> texts, const PasteChoices &choices,
                          const std::optional<geometry::Box> &objects);

} // namespace unprojector::cameras
