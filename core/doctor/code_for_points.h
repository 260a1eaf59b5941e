#pragma once

#include "core/doctor/remedies.h"

/// The code changes for mistakes of the depth, the formulas and the matrices, for the table of
/// remedies.cpp.
namespace unprojector::doctor {

inline constexpr CodeChange kDepthNotRemapped[] = {
    {"GLM", "const glm::dvec4 ndc(x_n, y_n, d, 1);", "const glm::dvec4 ndc(x_n, y_n, 2 * d - 1, 1);"},
    {"GLM", "glm::unProjectZO(glm::dvec3(x, H - y, d), view, projection, viewport)",
     "glm::unProjectNO(glm::dvec3(x, H - y, d), view, projection, viewport)"},
    {"Qt", "const QVector4D ndc(x_n, y_n, d, 1);", "const QVector4D ndc(x_n, y_n, 2 * d - 1, 1);"},
    {"three.js", "const p = new THREE.Vector3(x_n, y_n, d).unproject(camera);",
     "const p = new THREE.Vector3(x_n, y_n, 2 * d - 1).unproject(camera);"},
    {"NumPy", "ndc = np.array([x_n, y_n, d, 1])", "ndc = np.array([x_n, y_n, 2 * d - 1, 1])"},
};
inline constexpr CodeChange kDepthRemappedTwice[] = {
    {"GLU", "gluUnProject(x, H - y, 2 * d - 1, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, 2 * d - 1), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, 2 * d - 1).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "p.set(x_n, y_n, 2 * (2 * d - 1) - 1).unproject(camera);",
     "p.set(x_n, y_n, 2 * d - 1).unproject(camera);"},
    {"NumPy", "z_n = 2 * d - 1  # a matrix for 0 to 1", "z_n = d"},
};
inline constexpr CodeChange kDepthLinear[] = {
    {"GLU", "gluUnProject(x, H - y, (z - n) / (f - n), modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, f * (z - n) / (z * (f - n)), modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, (z - n) / (f - n)), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, f * (z - n) / (z * (f - n))), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, (z - n) / (f - n)).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, f * (z - n) / (z * (f - n))).unproject(view, projection, viewport);"},
    {"three.js", "const z = n + d * (f - n);", "const z = n * f / (f - d * (f - n));"},
    {"NumPy", "z = n + d * (f - n)", "z = n * f / (f - d * (f - n))"},
};
inline constexpr CodeChange kDepthZero[] = {
    {"GLU",
     "GLfloat d = 0; glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d); // fails: no context, or "
     "several samples",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d); // after binding a buffer of one sample; "
     "then check glGetError()"},
    {"GLM", "glm::unProject(glm::dvec3(x, H - y, 0), view, projection, viewport) // on the near plane",
     "glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport)"},
    {"Qt", "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);",
     "makeCurrent(); glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d); // a multisampled framebuffer "
     "first into one of a single sample"},
    {"three.js", "const p = new THREE.Vector3(x_n, y_n, -1).unproject(camera);",
     "const p = new THREE.Vector3(x_n, y_n, 2 * d - 1).unproject(camera);"},
    {"NumPy", "z_n = -1", "z_n = 2 * d - 1"},
};
inline constexpr CodeChange kDepthOne[] = {
    {"GLU", "SwapBuffers(dc); glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d); SwapBuffers(dc); // before the buffers are "
     "swapped"},
    {"GLM", "glm::unProject(glm::dvec3(x, H - y, 1), view, projection, viewport) // on the far plane",
     "glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport)"},
    {"Qt", "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d); // of a buffer cleared meanwhile",
     "// read it in paintGL, after drawing: glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"three.js", "const p = new THREE.Vector3(x_n, y_n, 1).unproject(camera);",
     "const p = new THREE.Vector3(x_n, y_n, 2 * d - 1).unproject(camera);"},
    {"NumPy", "z_n = 1", "z_n = 2 * d - 1"},
};
inline constexpr CodeChange kDepthIsEyeDistance[] = {
    {"GLU", "gluUnProject(x, H - y, z, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, f * (z - n) / (z * (f - n)), modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, z), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, f * (z - n) / (z * (f - n))), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, z).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, f * (z - n) / (z * (f - n))).unproject(view, projection, viewport);"},
    {"three.js", "const z = d;", "const z = n * f / (f - d * (f - n));"},
    {"NumPy", "z = d", "z = n * f / (f - d * (f - n))"},
};
inline constexpr CodeChange kDepthReversed[] = {
    {"GLU", "gluUnProject(x, H - y, 1 - d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, 1 - d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, 1 - d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "z_n = 1 - d;", "z_n = d; // as the projection matrix has it"},
    {"NumPy", "d = 1 - d", "# d as it is: the projection matrix goes by it"},
};
inline constexpr CodeChange kDepthRangeIsPlanes[] = {
    {"GLU", "gluUnProject(x, H - y, (d - n) / (f - n), modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, (d - n) / (f - n)), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, (d - n) / (f - n)).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.z = 2 * (d - camera.near) / (camera.far - camera.near) - 1;", "ndc.z = 2 * d - 1;"},
    {"NumPy", "z_n = 2 * (d - n) / (f - n) - 1", "z_n = 2 * d - 1"},
};
inline constexpr CodeChange kDepthRounded[] = {
    {"GLU", "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"GLM", "const std::uint8_t d = image[j * W + i];", "const float d = depth[j * W + i];"},
    {"Qt", "format.setDepthBufferSize(16);", "format.setDepthBufferSize(24);"},
    {"three.js", "target.depthTexture.type = THREE.UnsignedShortType;", "target.depthTexture.type = THREE.FloatType;"},
    {"NumPy", "d = np.uint8(d * 255) / 255", "d = np.float64(d)"},
};
inline constexpr CodeChange kDepthRangeIgnored[] = {
    {"GLU", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"GLM", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"Qt", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"three.js", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"NumPy", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
};
inline constexpr CodeChange kDepthOfAnotherRow[] = {
    {"GLU", "glReadPixels(i, H - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"GLM", "d = depth[(H - j) * W + i];", "d = depth[(H - 1 - j) * W + i];"},
    {"Qt", "glReadPixels(i, H - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"three.js", "renderer.readRenderTargetPixels(target, i, H - j, 1, 1, buffer);",
     "renderer.readRenderTargetPixels(target, i, H - 1 - j, 1, 1, buffer);"},
    {"NumPy", "d = depth[H - j, i]", "d = depth[H - 1 - j, i]"},
};
inline constexpr CodeChange kNearDiffers[] = {
    {"GLU", "gluPerspective(fovy, aspect, otherNear, f);",
     "gluPerspective(fovy, aspect, n, f); // as the image was drawn"},
    {"GLM", "glm::perspective(fovy, aspect, otherNear, f)",
     "glm::perspective(fovy, aspect, n, f) // as the image was drawn"},
    {"Qt", "projection.perspective(fovy, aspect, otherNear, f);",
     "projection.perspective(fovy, aspect, n, f); // as the image was drawn"},
    {"three.js", "z = n * f / (f - d * (f - n)); // otherNear, f",
     "z = n * f / (f - d * (f - n)); // with camera.near, camera.far"},
    {"NumPy", "n, f = otherNear, f", "n, f = near, far  # as the image was drawn"},
};
inline constexpr CodeChange kFarDiffers[] = {
    {"GLU", "gluPerspective(fovy, aspect, n, otherFar);",
     "gluPerspective(fovy, aspect, n, f); // as the image was drawn"},
    {"GLM", "glm::perspective(fovy, aspect, n, otherFar)",
     "glm::perspective(fovy, aspect, n, f) // as the image was drawn"},
    {"Qt", "projection.perspective(fovy, aspect, n, otherFar);",
     "projection.perspective(fovy, aspect, n, f); // as the image was drawn"},
    {"three.js", "z = n * f / (f - d * (f - n)); // n, otherFar",
     "z = n * f / (f - d * (f - n)); // with camera.near, camera.far"},
    {"NumPy", "n, f = n, otherFar", "n, f = near, far  # as the image was drawn"},
};
inline constexpr CodeChange kRayLengthAsZ[] = {
    {"GLU", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"GLM", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"Qt", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"three.js", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"NumPy", "p = eye + direction / dot(direction, forward) * length", "p = eye + direction * length"},
};
inline constexpr CodeChange kZAsRayLength[] = {
    {"GLU", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"GLM", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"Qt", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"three.js", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"NumPy", "p = eye + direction * z", "p = eye + direction / dot(direction, forward) * z"},
};
inline constexpr CodeChange kLinearAngle[] = {
    {"GLU", "direction = (tan(x_n * fovx / 2), tan(y_n * fovy / 2), -1)",
     "direction = (x_n * tan(fovx / 2), y_n * tan(fovy / 2), -1)"},
    {"GLM", "direction = (glm::tan(x_n * fovx / 2), glm::tan(y_n * fovy / 2), -1)",
     "direction = (x_n * glm::tan(fovx / 2), y_n * glm::tan(fovy / 2), -1)"},
    {"Qt", "direction = (qTan(x_n * fovx / 2), qTan(y_n * fovy / 2), -1)",
     "direction = (x_n * qTan(fovx / 2), y_n * qTan(fovy / 2), -1)"},
    {"three.js", "direction = (Math.tan(x_n * fovx / 2), Math.tan(y_n * fovy / 2), -1)",
     "direction = (x_n * Math.tan(fovx / 2), y_n * Math.tan(fovy / 2), -1)"},
    {"NumPy", "direction = (np.tan(x_n * fovx / 2), np.tan(y_n * fovy / 2), -1)",
     "direction = (x_n * np.tan(fovx / 2), y_n * np.tan(fovy / 2), -1)"},
};
inline constexpr CodeChange kOrthoFormula[] = {
    {"GLU", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"GLM", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"Qt", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"three.js", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"NumPy", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
};
inline constexpr CodeChange kDividedByFar[] = {
    {"GLU", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"GLM", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"Qt", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"three.js", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"NumPy", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
};
inline constexpr CodeChange kPerspectiveFormula[] = {
    {"GLU", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"GLM", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"Qt", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"NumPy", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"three.js", "raycaster.set(camera.position, direction);", "raycaster.setFromCamera(ndc, camera);"},
};
inline constexpr CodeChange kNoWDivide[] = {
    {"GLU", "X = v[0]; Y = v[1]; Z = v[2];", "X = v[0] / v[3]; Y = v[1] / v[3]; Z = v[2] / v[3];"},
    {"GLM", "p = glm::dvec3(inverse * ndc);", "const glm::dvec4 v = inverse * ndc; p = glm::dvec3(v) / v.w;"},
    {"Qt", "p = (inverse * QVector4D(ndc, 1)).toVector3D();", "p = (inverse * QVector4D(ndc, 1)).toVector3DAffine();"},
    {"three.js", "v4.applyMatrix4(inverse); p.set(v4.x, v4.y, v4.z);",
     "p.set(x_n, y_n, z_n).applyMatrix4(inverse); // divides by w"},
    {"NumPy", "p = (inverse @ ndc)[:3]", "v = inverse @ ndc; p = v[:3] / v[3]"},
};
inline constexpr CodeChange kWDividedTwice[] = {
    {"GLU", "X = v[0] / v[3] / v[3];", "X = v[0] / v[3];"},
    {"GLM", "p = glm::dvec3(v / v.w) / v.w;", "p = glm::dvec3(v) / v.w;"},
    {"Qt", "p = v.toVector3DAffine() / v.w();", "p = v.toVector3DAffine();"},
    {"three.js", "p.applyMatrix4(inverse).divideScalar(w);", "p.applyMatrix4(inverse); // divides by w"},
    {"NumPy", "p = v[:3] / v[3] / v[3]", "p = v[:3] / v[3]"},
};
inline constexpr CodeChange kProjectionTransposed[] = {
    {"GLU", "glLoadMatrixd(projection); // rows", "glLoadTransposeMatrixd(projection);"},
    {"GLM", "glm::make_mat4(projection) // rows", "glm::transpose(glm::make_mat4(projection))"},
    {"Qt", "QMatrix4x4(projection) // takes rows; these are columns", "QMatrix4x4(projection).transposed()"},
    {"three.js", "matrix.fromArray(projection); // rows", "matrix.fromArray(projection).transpose();"},
    {"NumPy", "projection = np.array(m).reshape(4, 4)  # OpenGL's columns", "projection = np.array(m).reshape(4, 4).T"},
};
inline constexpr CodeChange kViewTransposed[] = {
    {"GLU", "glLoadMatrixd(view); // rows", "glLoadTransposeMatrixd(view);"},
    {"GLM", "glm::make_mat4(view) // rows", "glm::transpose(glm::make_mat4(view))"},
    {"Qt", "QMatrix4x4(view) // takes rows; these are columns", "QMatrix4x4(view).transposed()"},
    {"three.js", "matrix.fromArray(view); // rows", "matrix.fromArray(view).transpose();"},
    {"NumPy", "view = np.array(m).reshape(4, 4)  # OpenGL's columns", "view = np.array(m).reshape(4, 4).T"},
};
inline constexpr CodeChange kBothTransposed[] = {
    {"GLU", "glLoadMatrixd(view); // rows // and projection", "glLoadTransposeMatrixd(view); // both"},
    {"GLM", "glm::make_mat4(view) // rows // and projection", "glm::transpose(glm::make_mat4(view)) // both"},
    {"Qt", "QMatrix4x4(view) // takes rows; these are columns // and projection",
     "QMatrix4x4(view).transposed() // both"},
    {"three.js", "matrix.fromArray(view); // rows // and projection", "matrix.fromArray(view).transpose(); // both"},
    {"NumPy", "view = np.array(m).reshape(4, 4)  # OpenGL's columns", "view = np.array(m).reshape(4, 4).T  # both"},
};
inline constexpr CodeChange kProductTransposed[] = {
    {"GLU", "glLoadMatrixd(viewProjection); // rows", "glLoadTransposeMatrixd(viewProjection);"},
    {"GLM", "glm::make_mat4(viewProjection) // rows", "glm::transpose(glm::make_mat4(viewProjection))"},
    {"Qt", "QMatrix4x4(viewProjection) // takes rows; these are columns", "QMatrix4x4(viewProjection).transposed()"},
    {"three.js", "matrix.fromArray(viewProjection); // rows", "matrix.fromArray(viewProjection).transpose();"},
    {"NumPy", "viewProjection = np.array(m).reshape(4, 4)  # OpenGL's columns",
     "viewProjection = np.array(m).reshape(4, 4).T"},
};
inline constexpr CodeChange kInverseOrder[] = {
    {"GLU", "inverse = product(inverted(projection), inverted(modelview));",
     "inverse = product(inverted(modelview), inverted(projection));"},
    {"GLM", "glm::inverse(projection) * glm::inverse(view) * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "projection.inverted() * view.inverted() * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.applyMatrix4(camera.matrixWorld).applyMatrix4(camera.projectionMatrixInverse);",
     "p.applyMatrix4(camera.projectionMatrixInverse).applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "inv(projection) @ inv(view) @ ndc", "inv(projection @ view) @ ndc"},
};
inline constexpr CodeChange kNotInverted[] = {
    {"GLU", "gluProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "projection * view * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "projection * view * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.project(camera);", "p.unproject(camera);"},
    {"NumPy", "projection @ view @ ndc", "inv(projection @ view) @ ndc"},
};
inline constexpr CodeChange kViewInverseAsView[] = {
    {"GLU", "glLoadMatrixd(cameraMatrix);", "glLoadMatrixd(inverseOfCameraMatrix);"},
    {"GLM", "glm::unProject(w, camera, projection, viewport)",
     "glm::unProject(w, glm::inverse(camera), projection, viewport)"},
    {"Qt", "w.unproject(camera, projection, viewport)", "w.unproject(camera.inverted(), projection, viewport)"},
    {"three.js", "const view = camera.matrixWorld;", "const view = camera.matrixWorldInverse;"},
    {"NumPy", "view = camera_pose", "view = inv(camera_pose)"},
};
inline constexpr CodeChange kViewLeftOut[] = {
    {"GLU", "gluUnProject(x, H - y, d, identity, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "glm::inverse(projection) * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "projection.inverted() * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.applyMatrix4(camera.projectionMatrixInverse);",
     "p.applyMatrix4(camera.projectionMatrixInverse).applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "inv(projection) @ ndc", "inv(projection @ view) @ ndc"},
};
inline constexpr CodeChange kProjectionLeftOut[] = {
    {"GLU", "gluUnProject(x, H - y, d, modelview, identity, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "glm::inverse(view) * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "view.inverted() * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.applyMatrix4(camera.matrixWorld);",
     "p.applyMatrix4(camera.projectionMatrixInverse).applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "inv(view) @ ndc", "inv(projection @ view) @ ndc"},
};
inline constexpr CodeChange kOverwrittenInPlace[] = {
    {"GLU", "for (i = 0; i < 4; ++i) v[i] = m[i] * v[0] + m[4 + i] * v[1] + m[8 + i] * v[2] + m[12 + i] * v[3];",
     "for (i = 0; i < 4; ++i) r[i] = m[i] * v[0] + m[4 + i] * v[1] + m[8 + i] * v[2] + m[12 + i] * v[3];"},
    {"GLM", "v.x = dot(row(m, 0), v); v.y = dot(row(m, 1), v); …", "v = m * v;"},
    {"Qt", "v.setX(QVector4D::dotProduct(m.row(0), v)); …", "v = m * v;"},
    {"three.js", "v.x = e[0] * v.x + …; v.y = e[1] * v.x + …;", "v.applyMatrix4(m);"},
    {"NumPy", "for i in range(4): v[i] = m[i] @ v", "v = m @ v"},
};
inline constexpr CodeChange kModelLeftIn[] = {
    {"GLU", "gluUnProject(x, H - y, d, viewTimesModel, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, view, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "glm::unProject(w, view * model, projection, viewport)", "glm::unProject(w, view, projection, viewport)"},
    {"Qt", "w.unproject(view * model, projection, viewport)", "w.unproject(view, projection, viewport)"},
    {"three.js", "mesh.worldToLocal(p);", "// p is in world space already"},
    {"NumPy", "inv(projection @ view @ model) @ ndc", "inv(projection @ view) @ ndc"},
};
inline constexpr CodeChange kModelLeftOut[] = {
    {"GLU", "gluUnProject(x, H - y, d, view, projection, viewport, &X, &Y, &Z); // for the object's coordinates",
     "gluUnProject(x, H - y, d, viewTimesModel, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::dvec3(model * glm::dvec4(p, 1)); // of a point in world space", "// p is in world space already"},
    {"Qt", "p = model.map(p); // of a point in world space", "// p is in world space already"},
    {"three.js", "mesh.localToWorld(p);", "// p is in world space already"},
    {"NumPy", "p = (model @ np.append(p, 1))[:3]", "# p is in world space already"},
};
inline constexpr CodeChange kEyeAdded[] = {
    {"GLM", "p = eye + glm::unProject(w, view, projection, viewport);",
     "p = glm::unProject(w, view, projection, viewport);"},
    {"Qt", "p = eye + w.unproject(view, projection, viewport);", "p = w.unproject(view, projection, viewport);"},
    {"three.js", "p.unproject(camera).add(camera.position);", "p.unproject(camera);"},
    {"NumPy", "p = eye + v[:3] / v[3]", "p = v[:3] / v[3]"},
};
inline constexpr CodeChange kEyeSubtracted[] = {
    {"GLM", "p = glm::transpose(glm::dmat3(view)) * eyePoint;",
     "p = glm::transpose(glm::dmat3(view)) * eyePoint + eye;"},
    {"Qt", "p = view.inverted().mapVector(eyePoint);", "p = view.inverted().map(eyePoint);"},
    {"three.js", "p.transformDirection(camera.matrixWorld);", "p.applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "p = view[:3, :3].T @ p_eye", "p = view[:3, :3].T @ p_eye + eye"},
};
inline constexpr CodeChange kEyeZPositive[] = {
    {"GLU", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},   {"GLM", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},
    {"Qt", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},    {"three.js", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},
    {"NumPy", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},
};
inline constexpr CodeChange kEyeXyMirrored[] = {
    {"GLU", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"GLM", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"Qt", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"three.js", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"NumPy", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
};

inline constexpr CodeChange kScaled[] = {
    {"GLU", "X *= otherFactor; Y *= otherFactor; Z *= otherFactor;", "// X, Y, Z are in the scene's unit already"},
    {"GLM", "p = otherFactor * glm::unProject(w, view, projection, viewport);",
     "p = glm::unProject(w, view, projection, viewport); // in the scene's unit"},
    {"Qt", "p = otherFactor * w.unproject(view, projection, viewport);",
     "p = w.unproject(view, projection, viewport); // in the scene's unit"},
    {"three.js", "p.unproject(camera).multiplyScalar(otherFactor);", "p.unproject(camera); // in the scene's unit"},
    {"NumPy", "p = otherFactor * v[:3] / v[3]", "p = v[:3] / v[3]  # in the scene's unit"},
};
inline constexpr CodeChange kScaledFromEye[] = {
    {"GLU", "p = eye + direction * distance;", "p = eye + direction * distance / otherFactor;"},
    {"GLM", "p = eye + direction * distance;", "p = eye + direction * distance / otherFactor;"},
    {"Qt", "p = eye + direction * distance;", "p = eye + direction * distance / otherFactor;"},
    {"three.js", "raycaster.ray.at(distance, p);", "raycaster.ray.at(distance / otherFactor, p);"},
    {"NumPy", "z = depth_image[j, i]  # in another unit", "z = depth_image[j, i] / otherFactor"},
};
inline constexpr CodeChange kDepthScaled[] = {
    {"GLU", "d = otherFactor * d; // as d16 / 65536.0 does",
     "// d as glReadPixels() gives it: GL_DEPTH_COMPONENT, GL_FLOAT"},
    {"GLM", "d = otherFactor * (d16 / 65535.0); // as d16 / 65536.0 does", "d = d16 / 65535.0;"},
    {"Qt", "d = otherFactor * (d16 / 65535.0f); // as d16 / 65536.0f does", "d = d16 / 65535.0f;"},
    {"NumPy", "d = otherFactor * depth[j, i] / 255  # as depth[j, i] / 256 does", "d = depth[j, i] / 255"},
};

} // namespace unprojector::doctor
