#pragma once

#include "core/doctor/remedies.h"

/// The code changes for mistakes of vision cameras and of axes, for the table of remedies.cpp. In
/// the code K, R, t, dist are OpenCV's, and C is the camera's position.
namespace unprojector::doctor {

inline constexpr CodeChange kAxesDiffer[] = {
    {"GLU", "p = (otherAxes); // of the right x, y, z", "p = (x, y, z);"},
    {"GLM", "p = glm::dvec3(otherAxes); // of the right x, y, z", "p = glm::dvec3(x, y, z);"},
    {"Qt", "p = QVector3D(otherAxes); // of the right x, y, z", "p = QVector3D(x, y, z);"},
    {"three.js", "p.set(otherAxes); // of the right x, y, z", "p.set(x, y, z);"},
    {"NumPy", "p = np.array([otherAxes])  # of the right x, y, z", "p = np.array([x, y, z])"},
};
inline constexpr CodeChange kAxesDifferAndMoved[] = {
    {"GLU", "p = otherScale * (otherAxes) + (otherTranslation); // of the right x, y, z", "p = (x, y, z);"},
    {"GLM", "p = otherScale * glm::dvec3(otherAxes) + glm::dvec3(otherTranslation); // of the right x, y, z",
     "p = glm::dvec3(x, y, z);"},
    {"Qt", "p = otherScale * QVector3D(otherAxes) + QVector3D(otherTranslation); // of the right x, y, z",
     "p = QVector3D(x, y, z);"},
    {"three.js",
     "p.set(otherAxes).multiplyScalar(otherScale).add(new THREE.Vector3(otherTranslation)); // of the right x, y, z",
     "p.set(x, y, z);"},
    {"NumPy", "p = otherScale * np.array([otherAxes]) + [otherTranslation]  # of the right x, y, z",
     "p = np.array([x, y, z])"},
};
inline constexpr CodeChange kOpenCvAxes[] = {
    {"GLU", "gluLookAt(…); // and a point with y down, z ahead", "glScaled(1, -1, -1); gluLookAt(…);"},
    {"GLM", "p = glm::inverse(view) * glm::dvec4(x, y, z, 1);", "p = glm::inverse(view) * glm::dvec4(x, -y, -z, 1);"},
    {"Qt", "p = view.inverted().map(QVector3D(x, y, z));", "p = view.inverted().map(QVector3D(x, -y, -z));"},
    {"three.js", "p.set(x, y, z).applyMatrix4(camera.matrixWorld);",
     "p.set(x, -y, -z).applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "p = cam2world @ [x, y, z, 1]  # x, y, z by K; cam2world of NeRF or Blender",
     "p = cam2world @ np.diag([1, -1, -1, 1]) @ [x, y, z, 1]"},
    {"NumPy", "pose = inv(view)  # OpenGL's view, for OpenCV", "pose = inv(np.diag([1, -1, -1, 1]) @ view)"},
};
inline constexpr CodeChange kCameraAxesDiffer[] = {
    {"GLM", "p = glm::inverse(view) * glm::dvec4(otherAxes, 1); // of x right, y up, z back",
     "p = glm::inverse(view) * glm::dvec4(x, y, z, 1);"},
    {"Qt", "p = view.inverted().map(QVector3D(otherAxes)); // of x right, y up, z back",
     "p = view.inverted().map(QVector3D(x, y, z));"},
    {"NumPy", "p = cam2world @ [otherAxes, 1]  # of x right, y up, z back", "p = cam2world @ [x, y, z, 1]"},
};
inline constexpr CodeChange kTranslationNotInverted[] = {
    {"GLM", "p = glm::transpose(R) * p_eye + t;", "p = glm::transpose(R) * (p_eye - t);"},
    {"Qt", "p = R.transposed().map(p_eye) + t;", "p = R.transposed().map(p_eye - t);"},
    {"three.js", "camera.position.copy(t);", "camera.position.copy(t).applyMatrix3(Rt).negate(); // Rt: R transposed"},
    {"NumPy", "p = R.T @ p_eye + t", "p = R.T @ (p_eye - t)"},
    {"NumPy", "view = np.block([[R.T, C], [0, 0, 0, 1]])  # of a camera pose R, C",
     "view = np.block([[R.T, -R.T @ C], [0, 0, 0, 1]])"},
};
inline constexpr CodeChange kQuaternionOrder[] = {
    {"GLM", "glm::dquat q(x, y, z, w);", "glm::dquat q(w, x, y, z);"},
    {"Qt", "QQuaternion q(x, y, z, w);", "QQuaternion q(w, x, y, z);"},
    {"three.js", "q.set(w, x, y, z);", "q.set(x, y, z, w);"},
    {"NumPy", "R = Rotation.from_quat([qw, qx, qy, qz]).as_matrix()  # SciPy wants x, y, z, w",
     "R = Rotation.from_quat([qx, qy, qz, qw]).as_matrix()"},
};
inline constexpr CodeChange kEulerOrder[] = {
    {"GLM", "R = glm::eulerAngleXYZ(a, b, c);", "R = glm::eulerAngleZYX(c, b, a); // the order of the angles' source"},
    {"Qt", "Rx * Ry * Rz", "Rz * Ry * Rx // the order of the angles' source"},
    {"three.js", "camera.rotation.set(a, b, c); // order XYZ", "camera.rotation.set(a, b, c, \"ZYX\");"},
    {"NumPy", "R = Rotation.from_euler('XYZ', [a, b, c]).as_matrix()",
     "R = Rotation.from_euler('xyz', [a, b, c]).as_matrix()  # lower case: about fixed axes, Rz Ry Rx"},
};
inline constexpr CodeChange kEulerDegrees[] = {
    {"GLM", "glm::rotate(m, a, x) // a in degrees", "glm::rotate(m, glm::radians(a), x)"},
    {"Qt", "m.rotate(a, x); // a in radians", "m.rotate(qRadiansToDegrees(a), x);"},
    {"three.js", "camera.rotation.x = a; // in degrees", "camera.rotation.x = THREE.MathUtils.degToRad(a);"},
    {"NumPy", "R = Rotation.from_euler('xyz', [a, b, c]).as_matrix()  # in degrees",
     "R = Rotation.from_euler('xyz', [a, b, c], degrees=True).as_matrix()"},
};
inline constexpr CodeChange kFocalLengthsSwapped[] = {
    {"GLM", "p = z * glm::dvec3((u - cx) / fy, (v - cy) / fx, 1);",
     "p = z * glm::dvec3((u - cx) / fx, (v - cy) / fy, 1);"},
    {"Qt", "p = z * QVector3D((u - cx) / fy, (v - cy) / fx, 1);",
     "p = z * QVector3D((u - cx) / fx, (v - cy) / fy, 1);"},
    {"three.js", "p.set((u - cx) / fy, (v - cy) / fx, 1);", "p.set((u - cx) / fx, (v - cy) / fy, 1);"},
    {"NumPy", "K = np.array([[fy, 0, cx], [0, fx, cy], [0, 0, 1]])",
     "K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])"},
};
inline constexpr CodeChange kCentreSwapped[] = {
    {"GLM", "p = z * glm::dvec3((u - cy) / fx, (v - cx) / fy, 1);",
     "p = z * glm::dvec3((u - cx) / fx, (v - cy) / fy, 1);"},
    {"Qt", "p = z * QVector3D((u - cy) / fx, (v - cx) / fy, 1);",
     "p = z * QVector3D((u - cx) / fx, (v - cy) / fy, 1);"},
    {"three.js", "p.set((u - cy) / fx, (v - cx) / fy, 1);", "p.set((u - cx) / fx, (v - cy) / fy, 1);"},
    {"NumPy", "h, w = image.shape[1], image.shape[0]; cx, cy = w / 2, h / 2",
     "h, w = image.shape[:2]; cx, cy = w / 2, h / 2"},
};
inline constexpr CodeChange kIntrinsicsOfAnotherSize[] = {
    {"GLM", "d = glm::inverse(K) * glm::dvec3(u, v, 1);",
     "d = glm::inverse(K) * glm::dvec3(s * u, s * v, 1); // s = size of K / size of the image"},
    {"Qt", "p = z * QVector3D((u - cx) / fx, (v - cy) / fy, 1);",
     "p = z * QVector3D((s * u - cx) / fx, (s * v - cy) / fy, 1); // s = size of K / size of the image"},
    {"NumPy", "image = cv2.resize(image, None, fx=s, fy=s)  # and K as before",
     "image = cv2.resize(image, None, fx=s, fy=s); K = np.diag([s, s, 1]) @ K"},
};
inline constexpr CodeChange kHalfPixelTwice[] = {
    {"GLU", "gluUnProject(x + 0.5, H - y + 0.5, …); // x, y have their half", "gluUnProject(x, H - y, …);"},
    {"GLM", "glm::unProject(glm::dvec3(x + 0.5, H - y + 0.5, d), …)", "glm::unProject(glm::dvec3(x, H - y, d), …)"},
    {"Qt", "QVector3D(x + 0.5, H - y + 0.5, d).unproject(…)", "QVector3D(x, H - y, d).unproject(…)"},
    {"NumPy", "u, v = i + 0.5, j + 0.5  # for a K with cx = (w - 1) / 2", "u, v = i, j"},
};
inline constexpr CodeChange kDistortionIgnored[] = {
    {"GLM", "d = glm::inverse(K) * glm::dvec3(u, v, 1);", "cv::undistortPoints(pixels, directions, K, dist);"},
    {"Qt", "d = QVector3D((u - cx) / fx, (v - cy) / fy, 1);", "cv::undistortPoints(pixels, directions, K, dist);"},
    {"NumPy", "d = inv(K) @ [u, v, 1]", "d = cv2.undistortPoints(np.array([[[u, v]]]), K, dist)[0, 0]"},
};
inline constexpr CodeChange kDistortionAdded[] = {
    {"GLM", "cv::projectPoints(directions, zero, zero, K, dist, pixels);",
     "cv::undistortPoints(pixels, directions, K, dist);"},
    {"Qt", "x *= 1 + k1 * r2 + k2 * r2 * r2;", "// solve x * (1 + k1 * r2 + k2 * r2 * r2) = x of the pixel"},
    {"NumPy", "x = x * (1 + k1 * r2 + k2 * r2**2)", "x, y = cv2.undistortPoints(np.array([[[u, v]]]), K, dist)[0, 0]"},
};
inline constexpr CodeChange kWOfAnotherPoint[] = {
    {"GLM", "b.x /= b.w; b.y /= b.w; b.z = a.z / b.w;", "a /= a.w; b /= b.w;"},
    {"Qt", "b = QVector3D(b.x() / b.w(), b.y() / b.w(), a.z() / b.w());", "b = b.toVector3DAffine();"},
    {"NumPy", "b[:2] /= b[3]; b[2] = a[2] / b[3]", "a, b = a / a[3], b / b[3]"},
};
inline constexpr CodeChange kNearFarDiffer[] = {
    {"GLU", "gluPerspective(fovy, aspect, otherNear, otherFar);",
     "gluPerspective(fovy, aspect, n, f); // as the image was drawn"},
    {"GLM", "glm::perspective(fovy, aspect, otherNear, otherFar)",
     "glm::perspective(fovy, aspect, n, f) // as the image was drawn"},
    {"Qt", "projection.perspective(fovy, aspect, otherNear, otherFar);",
     "projection.perspective(fovy, aspect, n, f); // as the image was drawn"},
    {"three.js", "z = n * f / (f - d * (f - n)); // otherNear, otherFar",
     "z = n * f / (f - d * (f - n)); // with camera.near, camera.far"},
    {"NumPy", "z = n * f / (f - d * (f - n))  # otherNear, otherFar",
     "z = n * f / (f - d * (f - n))  # near, far as the image was drawn"},
};
inline constexpr CodeChange kPrincipalPointDiffers[] = {
    {"GLM", "d.x = (u - otherCx) / fx; d.y = (v - otherCy) / fy;", "d.x = (u - cx) / fx; d.y = (v - cy) / fy;"},
    {"Qt", "QVector3D((u - otherCx) / fx, (v - otherCy) / fy, 1)", "QVector3D((u - cx) / fx, (v - cy) / fy, 1)"},
    {"NumPy", "K[:2, 2] = otherCx, otherCy", "K[:2, 2] = cx, cy  # of the calibration"},
};
inline constexpr CodeChange kFocalLengthsDiffer[] = {
    {"GLM", "d.x = (u - cx) / otherFx; d.y = (v - cy) / otherFy;", "d.x = (u - cx) / fx; d.y = (v - cy) / fy;"},
    {"Qt", "QVector3D((u - cx) / otherFx, (v - cy) / otherFy, 1)", "QVector3D((u - cx) / fx, (v - cy) / fy, 1)"},
    {"NumPy", "K[0, 0], K[1, 1] = otherFx, otherFy", "K[0, 0], K[1, 1] = fx, fy  # of the calibration"},
};
inline constexpr CodeChange kFrameDiffers[] = {
    {"GLM", "p = glm::dvec3(v) / v.w; // in the frame of another view",
     "p = glm::dmat3(otherRotation) * (glm::dvec3(v) / v.w - glm::dvec3(otherTranslation)) / otherScale;"},
    {"Qt", "p = v.toVector3DAffine(); // in the frame of another view",
     "const float r[] = {otherRotation}; p = QMatrix4x4(QMatrix3x3(r)).transposed().map(v.toVector3DAffine() - "
     "QVector3D(otherTranslation)) / otherScale;"},
    {"three.js", "p.unproject(camera); // a camera inside a moved group",
     "p.unproject(camera).sub(new THREE.Vector3(otherTranslation)).divideScalar(otherScale); "
     "p.applyMatrix3(new THREE.Matrix3().set(otherRotation).transpose());"},
    {"NumPy", "p = v[:3] / v[3]  # in the frame of another pose",
     "p = np.reshape([otherRotation], (3, 3)).T @ (v[:3] / v[3] - [otherTranslation]) / otherScale"},
};

} // namespace unprojector::doctor
