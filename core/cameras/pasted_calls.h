#pragma once

#include "core/cameras/pasted_matrix.h"

#include <optional>
#include <string>
#include <string_view>

namespace unprojector::cameras {

/// The result of reading the calls of a text.
struct PastedCalls {
    bool hasAny = false; ///< else the text has no such call, and all of this is empty
    /// The projection, the view and the viewport of the first call of each kind. The matrices have
    /// MatrixForm::Call, the NDC depths of their API, and a description of how the call was read.
    PastedScene parts;
    std::string rest; ///< the text, with comments, these calls and number variables blanked out
};

/// Reads the calls that make a projection, a view or a viewport, by their names:
///
///   - gluPerspective, glFrustum, glOrtho, gluOrtho2D, gluLookAt, glViewport
///   - GLM: perspective, perspectiveFov, frustum, ortho, lookAt; with the suffixes LH, RH, ZO
///     and NO, or GLM_FORCE_…
///   - three.js: PerspectiveCamera, OrthographicCamera, and the camera's position, up and lookAt
///   - System.Numerics: CreatePerspectiveFieldOfView, CreatePerspective, CreateOrthographic,
///     …OffCenter, CreateLookAt, and the same names of OpenTK's Matrix4, with OpenGL's NDC depths
///   - DirectXMath: XMMatrixPerspectiveFov, Perspective, Orthographic, …OffCenter, LookAt, LookTo,
///     RH and LH
///   - D3DX: the same with the result as first argument; SharpDX: Matrix.PerspectiveFovLH
///   - QMatrix4x4 and gl-matrix: perspective, frustum, ortho, lookAt
///   - PyBullet: computeViewMatrix, computeProjectionMatrix, computeProjectionMatrixFOV
///   - Android: setLookAtM, perspectiveM, frustumM, orthoM
///   - glam: perspective_rh, orthographic_rh_gl, look_at_rh, look_to_lh
///
/// Angles are in the unit of the API. Matrices are for column vectors in every API.
/// @param aspect  width / height of the image, where an argument for it has no number; empty: it needs one
/// @return the call and the argument that cannot be read
geometry::Result<PastedCalls, PasteError> pastedCalls(std::string_view text, const std::optional<double> &aspect = {});

} // namespace unprojector::cameras
