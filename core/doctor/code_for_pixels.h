#pragma once

#include "core/doctor/remedies.h"

/// The code changes for mistakes of the pixel, the viewport and the lens, for the table of
/// remedies.cpp.
namespace unprojector::doctor {

inline constexpr CodeChange kYNotFlipped[] = {
    {"GLU", "gluUnProject(x, y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, y, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 2 * y / H - 1;", "ndc.y = 1 - 2 * y / H;"},
    {"NumPy", "y_n = 2 * (y - vy) / h - 1", "y_n = 2 * (H - y - vy) / h - 1"},
};
inline constexpr CodeChange kRowAbove[] = {
    {"GLU", "glReadPixels(i, H - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"GLU", "gluUnProject(i + 0.5, H - j + 0.5, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(i + 0.5, H - j - 0.5, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(i + 0.5, H - j + 0.5, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(i + 0.5, H - j - 0.5, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(i + 0.5, H - j + 0.5, d).unproject(view, projection, viewport);",
     "p = QVector3D(i + 0.5, H - j - 0.5, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 1 - 2 * (j - 0.5) / H;", "ndc.y = 1 - 2 * (j + 0.5) / H;"},
    {"NumPy", "y_w = H - j + 0.5", "y_w = H - j - 0.5"},
};
inline constexpr CodeChange kRowBelow[] = {
    {"GLU", "gluUnProject(x, H - 1 - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - 1 - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - 1 - y, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 1 - 2 * (y + 1) / H;", "ndc.y = 1 - 2 * y / H;"},
    {"NumPy", "y_w = H - 1 - y", "y_w = H - y"},
};
inline constexpr CodeChange kPixelCorner[] = {
    {"GLU", "gluUnProject(i, H - 1 - j, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(i + 0.5, H - j - 0.5, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(i, H - 1 - j, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(i + 0.5, H - j - 0.5, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(i, H - 1 - j, d).unproject(view, projection, viewport);",
     "p = QVector3D(i + 0.5, H - j - 0.5, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.x = 2 * i / W - 1;", "ndc.x = 2 * (i + 0.5) / W - 1;"},
    {"NumPy", "x_w, y_w = i, H - 1 - j", "x_w, y_w = i + 0.5, H - j - 0.5"},
    {"NumPy", "cx, cy = w / 2, h / 2  # for pixels i, j counted from 0", "cx, cy = (w - 1) / 2, (h - 1) / 2"},
};
inline constexpr CodeChange kRatioLogicalInDevice[] = {
    {"GLU", "glfwGetCursorPos(window, &x, &y);", "glfwGetCursorPos(window, &x, &y); x *= otherRatio; y *= otherRatio;"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x * otherRatio, H - y * otherRatio, d), view, projection, viewport);"},
    {"Qt", "const QPointF at = event->position();",
     "const QPointF at = event->position() * devicePixelRatioF(); // by otherRatio"},
    {"three.js", "ndc.x = 2 * event.offsetX / canvas.width - 1;",
     "ndc.x = 2 * event.offsetX / canvas.clientWidth - 1; // canvas.width / otherRatio"},
    {"NumPy", "x_w, y_w = x, H - y", "x_w, y_w = x * otherRatio, H - y * otherRatio"},
};
inline constexpr CodeChange kRatioLogicalBoth[] = {
    {"GLU", "gluUnProject(x, logicalHeight - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x * otherRatio, H - y * otherRatio, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, logicalHeight - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x * otherRatio, H - y * otherRatio, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(at.x(), height() - at.y(), d).unproject(view, projection, viewport);",
     "at *= devicePixelRatioF(); p = QVector3D(at.x(), H - at.y(), d).unproject(view, projection, viewport); // by "
     "otherRatio"},
    {"three.js", "ndc.y = 1 - 2 * event.offsetY / canvas.height;",
     "ndc.y = 1 - 2 * event.offsetY / canvas.clientHeight; // canvas.height / otherRatio"},
    {"NumPy", "x_w, y_w = x, H / otherRatio - y", "x_w, y_w = x * otherRatio, H - y * otherRatio"},
};
inline constexpr CodeChange kRatioDeviceInLogical[] = {
    {"GLU", "glfwGetWindowSize(window, &w, &h); // for the viewport",
     "glfwGetFramebufferSize(window, &w, &h); // otherRatio times as large"},
    {"GLM", "const glm::dvec4 viewport(0, 0, W / otherRatio, H / otherRatio);",
     "const glm::dvec4 viewport(0, 0, W, H);"},
    {"Qt", "const QRect viewport(0, 0, width(), height()); // W / otherRatio, H / otherRatio",
     "const QRect viewport(0, 0, qRound(width() * devicePixelRatioF()), qRound(height() * devicePixelRatioF()));"},
    {"three.js", "ndc.x = 2 * event.offsetX * otherRatio / canvas.clientWidth - 1;",
     "ndc.x = 2 * event.offsetX / canvas.clientWidth - 1;"},
    {"NumPy", "x_n = 2 * x / (w / otherRatio) - 1", "x_n = 2 * (x - vx) / w - 1"},
};
inline constexpr CodeChange kViewportOriginIgnored[] = {
    {"GLU", "GLint viewport[4] = {0, 0, w, h};", "glGetIntegerv(GL_VIEWPORT, viewport); // vx, vy, w, h"},
    {"GLM", "const glm::dvec4 viewport(0, 0, w, h);", "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(0, 0, w, h);", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "ndc.x = 2 * event.clientX / rect.width - 1;",
     "ndc.x = 2 * (event.clientX - rect.left) / rect.width - 1;"},
    {"NumPy", "x_n, y_n = 2 * x_w / w - 1, 2 * y_w / h - 1",
     "x_n, y_n = 2 * (x_w - vx) / w - 1, 2 * (y_w - vy) / h - 1"},
};
inline constexpr CodeChange kViewportYFromTop[] = {
    {"GLU", "GLint viewport[4] = {vx, yFromTop, w, h};", "GLint viewport[4] = {vx, H - yFromTop - h, w, h};"},
    {"GLM", "const glm::dvec4 viewport(vx, yFromTop, w, h);", "const glm::dvec4 viewport(vx, H - yFromTop - h, w, h);"},
    {"Qt", "const QRect viewport(vx, yFromTop, w, h);", "const QRect viewport(vx, H - yFromTop - h, w, h);"},
    {"three.js", "renderer.getViewport(v); ndc.y = 1 - 2 * (y - v.y) / v.w;",
     "renderer.getViewport(v); ndc.y = 2 * (H - y - v.y) / v.w - 1;"},
    {"NumPy", "y_n = 2 * (y_w - y_from_top) / h - 1", "y_n = 2 * (y_w - (H - y_from_top - h)) / h - 1"},
};
inline constexpr CodeChange kFlippedWithViewportHeight[] = {
    {"GLU", "gluUnProject(x, viewport[3] - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, viewport[3] - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, viewport[3] - y, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 2 * (h - y - vy) / h - 1;", "ndc.y = 2 * (H - y - vy) / h - 1;"},
    {"NumPy", "y_w = h - y", "y_w = H - y"},
};
inline constexpr CodeChange kViewportIsWindow[] = {
    {"GLU", "GLint viewport[4] = {0, 0, W, H};", "glGetIntegerv(GL_VIEWPORT, viewport); // vx, vy, w, h"},
    {"GLM", "const glm::dvec4 viewport(0, 0, W, H);", "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(QPoint(), size());", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "ndc.x = 2 * event.clientX / window.innerWidth - 1;",
     "ndc.x = 2 * (event.clientX - rect.left) / rect.width - 1;"},
    {"NumPy", "x_n, y_n = 2 * x_w / W - 1, 2 * y_w / H - 1",
     "x_n, y_n = 2 * (x_w - vx) / w - 1, 2 * (y_w - vy) / h - 1"},
};
inline constexpr CodeChange kXySwapped[] = {
    {"GLU", "gluUnProject(y, x, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(y, x, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(y, x, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.set(y_n, x_n, z_n);", "ndc.set(x_n, y_n, z_n);"},
    {"NumPy", "d = depth[x, y]", "d = depth[y, x]  # rows first"},
};
inline constexpr CodeChange kAspectInteger[] = {
    {"GLU", "gluPerspective(fovy, w / h, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, w / h, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, w / h, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = Math.floor(w / h);", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = w // h", "aspect = w / h"},
};
inline constexpr CodeChange kAspectInverted[] = {
    {"GLU", "gluPerspective(fovy, double(h) / w, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, double(h) / w, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, double(h) / w, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = h / w;", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = h / w", "aspect = w / h"},
};
inline constexpr CodeChange kAspectOfWindow[] = {
    {"GLU", "gluPerspective(fovy, double(W) / H, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, double(W) / H, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, double(W) / H, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = window.innerWidth / window.innerHeight;",
     "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = W / H", "aspect = w / h"},
};
inline constexpr CodeChange kAspectLeftOut[] = {
    {"GLU", "gluPerspective(fovy, 1.0, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, 1.0, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, 1.0, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = 1;", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = 1", "aspect = w / h"},
};
inline constexpr CodeChange kAspectStale[] = {
    {"GLU", "gluPerspective(fovy, 4.0 / 3.0, n, f); // once",
     "gluPerspective(fovy, double(w) / h, n, f); // whenever the size changes"},
    {"GLM", "projection = glm::perspective(fovy, 4.0 / 3.0, n, f); // once",
     "projection = glm::perspective(fovy, double(w) / h, n, f); // whenever the size changes"},
    {"Qt", "void initializeGL() { projection.perspective(fovy, aspect, n, f); }",
     "void resizeGL(int w, int h) { projection.setToIdentity(); projection.perspective(fovy, float(w) / h, n, f); }"},
    {"three.js", "camera.aspect = w / h;", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = 4 / 3", "aspect = w / h"},
};
inline constexpr CodeChange kViewportStale[] = {
    {"GLU", "static GLint viewport[4]; // read once", "glGetIntegerv(GL_VIEWPORT, viewport); // at every click"},
    {"GLM", "static const glm::dvec4 viewport(0, 0, 640, 480);", "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(0, 0, 640, 480);", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "const rect = canvas.getBoundingClientRect(); // once",
     "const rect = canvas.getBoundingClientRect(); // at every click"},
    {"NumPy", "W, H = 640, 480", "W, H = image.shape[1], image.shape[0]"},
};
inline constexpr CodeChange kFovDegreesAsRadians[] = {
    {"GLM", "glm::perspective(fovyDegrees, aspect, n, f)", "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"three.js", "const t = Math.tan(camera.fov / 2);",
     "const t = Math.tan(THREE.MathUtils.degToRad(camera.fov) / 2);"},
    {"NumPy", "t = np.tan(fovy_degrees / 2)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
inline constexpr CodeChange kFovRadiansAsDegrees[] = {
    {"GLU", "gluPerspective(fovyRadians, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(fovyRadians), aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(fovyRadians, aspect, n, f);", "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = fovyRadians;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovy_radians) / 2)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
inline constexpr CodeChange kFovHalf[] = {
    {"GLU", "gluPerspective(fovyDegrees / 2, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(fovyDegrees) / 2.0, aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(fovyDegrees / 2, aspect, n, f);",
     "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = fovyDegrees / 2;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovy_degrees) / 4)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
inline constexpr CodeChange kFovDouble[] = {
    {"GLU", "gluPerspective(2 * fovyDegrees, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(2.0 * fovyDegrees), aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(2 * fovyDegrees, aspect, n, f);",
     "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = 2 * fovyDegrees;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovy_degrees))", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
inline constexpr CodeChange kFovHorizontal[] = {
    {"GLU", "gluPerspective(fovxDegrees, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(fovxDegrees), aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(fovxDegrees, aspect, n, f);", "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = fovxDegrees;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovx_degrees) / 2)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
inline constexpr CodeChange kFrustumCentred[] = {
    {"GLU", "gluPerspective(fovy, aspect, n, f);", "glFrustum(l, r, b, t, n, f);"},
    {"GLM", "glm::perspective(fovy, aspect, n, f)", "glm::frustum(l, r, b, t, n, f)"},
    {"Qt", "projection.perspective(fovy, aspect, n, f);", "projection.frustum(l, r, b, t, n, f);"},
    {"three.js", "x_e = ndc.x * r * z / n;", "x_e = (l + (ndc.x + 1) * (r - l) / 2) * z / n;"},
    {"NumPy", "x_e = x_n * r * z / n", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
};

inline constexpr CodeChange kYIsDepth[] = {
    {"GLU", "gluUnProject(p[0], p[2], p[2], modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(p[0], p[1], p[2], modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "glm::unProject(glm::dvec3(w.x, w.z, w.z), view, projection, viewport)",
     "glm::unProject(glm::dvec3(w.x, w.y, w.z), view, projection, viewport)"},
    {"Qt", "QVector3D(w.x(), w.z(), w.z()).unproject(view, projection, viewport)",
     "QVector3D(w.x(), w.y(), w.z()).unproject(view, projection, viewport)"},
    {"NumPy", "x_w, y_w = window[0], window[2]", "x_w, y_w = window[0], window[1]"},
};
inline constexpr CodeChange kPixelInSizeMinusOne[] = {
    {"GLM", "x_n = 2.0 * i / (W - 1) - 1.0;", "x_n = 2.0 * (i + 0.5) / W - 1.0;"},
    {"three.js", "ndc.x = 2 * i / (W - 1) - 1;", "ndc.x = 2 * (i + 0.5) / W - 1;"},
    {"NumPy", "x_n = np.linspace(-1, 1, W)", "x_n = 2 * (np.arange(W) + 0.5) / W - 1"},
};
inline constexpr CodeChange kFocalLengthNotInPixels[] = {
    {"GLM", "focal = projection[0][0];", "focal = projection[1][1] * h / 2;"},
    {"three.js", "focal = camera.projectionMatrix.elements[0];",
     "focal = camera.projectionMatrix.elements[5] * h / 2;"},
    {"NumPy", "fx = fy = projection[0, 0]", "fx, fy = projection[0, 0] * w / 2, projection[1, 1] * h / 2"},
};
inline constexpr CodeChange kFovyDiffers[] = {
    {"GLU", "gluPerspective(otherFovy, aspect, n, f);", "gluPerspective(fovy, aspect, n, f); // as the view was drawn"},
    {"GLM", "glm::perspective(glm::radians(otherFovy), aspect, n, f)",
     "glm::perspective(glm::radians(fovy), aspect, n, f) // as the view was drawn"},
    {"Qt", "projection.perspective(otherFovy, aspect, n, f);",
     "projection.perspective(fovy, aspect, n, f); // as the view was drawn"},
    {"three.js", "camera.fov = otherFovy;",
     "camera.fov = fovy; camera.updateProjectionMatrix(); // zoom changes it too"},
    {"NumPy", "focal = h / 2 / np.tan(np.radians(otherFovy) / 2)", "focal = h / 2 / np.tan(np.radians(fovy) / 2)"},
};
inline constexpr CodeChange kBoxSizeDiffers[] = {
    {"GLU", "top = otherHeight / 2; right = top * aspect; glOrtho(-right, right, -top, top, n, f);",
     "top = height / 2; right = top * aspect; glOrtho(-right, right, -top, top, n, f); // as the view was drawn"},
    {"GLM", "top = otherHeight / 2; glm::ortho(-top * aspect, top * aspect, -top, top, n, f)",
     "top = height / 2; glm::ortho(-top * aspect, top * aspect, -top, top, n, f) // as the view was drawn"},
    {"Qt", "top = otherHeight / 2; projection.ortho(-top * aspect, top * aspect, -top, top, n, f);",
     "top = height / 2; projection.ortho(-top * aspect, top * aspect, -top, top, n, f); // as the view was drawn"},
    {"three.js", "camera.top = otherHeight / 2;",
     "camera.top = height / 2; camera.updateProjectionMatrix(); // zoom changes it too"},
    {"NumPy", "top = otherHeight / 2", "top = height / 2"},
};
inline constexpr CodeChange kPixelShifted[] = {
    {"GLU", "GetCursorPos(&at); // in the screen, off by otherDx, otherDy",
     "GetCursorPos(&at); ScreenToClient(window, &at);"},
    {"GLM", "SDL_GetGlobalMouseState(&x, &y); // in the screen, off by otherDx, otherDy", "SDL_GetMouseState(&x, &y);"},
    {"Qt", "const QPointF at = event->globalPosition(); // off by otherDx, otherDy",
     "const QPointF at = event->position();"},
    {"three.js", "x = event.clientX; y = event.clientY; // off by otherDx, otherDy",
     "x = event.clientX - rect.left; y = event.clientY - rect.top;"},
    {"NumPy", "x, y = pyautogui.position()", "x, y = x - otherDx, y - otherDy  # without frame and title bar"},
};
inline constexpr CodeChange kPixelScaledAndMoved[] = {
    {"GLU", "SDL_GetMouseState(&x, &y); // in the letterboxed window",
     "SDL_GetMouseState(&x, &y); x = (x - otherDx) / otherScale; y = (y - otherDy) / otherScale;"},
    {"GLM", "const glm::dvec2 pixel(x, y); // in the letterboxed window",
     "const glm::dvec2 pixel((x - otherDx) / otherScale, (y - otherDy) / otherScale);"},
    {"Qt", "const QPointF at = event->position(); // in the letterboxed window",
     "const QPointF at = (event->position() - QPointF(otherDx, otherDy)) / otherScale;"},
    {"three.js", "x = event.offsetX; y = event.offsetY;",
     "x = (event.offsetX - otherDx) / otherScale; y = (event.offsetY - otherDy) / otherScale;"},
    {"NumPy", "x_w, y_w = x, H - y", "x_w, y_w = (x - otherDx) / otherScale, H - (y - otherDy) / otherScale"},
};
inline constexpr CodeChange kPixelScaledMovedAndFlipped[] = {
    {"GLU", "gluUnProject(x, otherFlipHeight - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject((x - otherDx) / otherScale, H - (y - otherDy) / otherScale, d, modelview, projection, viewport, &X, "
     "&Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, otherFlipHeight - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3((x - otherDx) / otherScale, H - (y - otherDy) / otherScale, d), view, projection, "
     "viewport);"},
    {"Qt", "p = QVector3D(x, otherFlipHeight - y, d).unproject(view, projection, viewport);",
     "p = QVector3D((x - otherDx) / otherScale, H - (y - otherDy) / otherScale, d).unproject(view, projection, "
     "viewport);"},
    {"three.js", "ndc.set(2 * x / w - 1, 2 * (otherFlipHeight - y) / h - 1);",
     "ndc.set(2 * (x - otherDx) / otherScale / w - 1, 1 - 2 * (y - otherDy) / otherScale / h);"},
    {"NumPy", "x_w, y_w = x, otherFlipHeight - y",
     "x_w, y_w = (x - otherDx) / otherScale, H - (y - otherDy) / otherScale"},
};
inline constexpr CodeChange kViewportSizeDiffers[] = {
    {"GLU", "GLint viewport[4] = {vx, vy, otherWidth, otherHeight};",
     "GLint viewport[4]; glGetIntegerv(GL_VIEWPORT, viewport);"},
    {"GLM", "const glm::dvec4 viewport(vx, vy, otherWidth, otherHeight);", "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(vx, vy, otherWidth, otherHeight);", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "ndc.set(2 * x / otherWidth - 1, 1 - 2 * y / otherHeight);",
     "ndc.set(2 * x / canvas.clientWidth - 1, 1 - 2 * y / canvas.clientHeight);"},
    {"NumPy", "w, h = otherWidth, otherHeight", "w, h = image.shape[1], image.shape[0]"},
};
inline constexpr CodeChange kViewportRectangleDiffers[] = {
    {"GLU", "GLint viewport[4] = {otherX, otherY, otherWidth, otherHeight};",
     "GLint viewport[4]; glGetIntegerv(GL_VIEWPORT, viewport);"},
    {"GLM", "const glm::dvec4 viewport(otherX, otherY, otherWidth, otherHeight);",
     "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(otherX, otherY, otherWidth, otherHeight);", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "v.set(otherX, otherY, otherWidth, otherHeight); ndc.x = 2 * (x - v.x) / v.z - 1;",
     "renderer.getViewport(v); ndc.x = 2 * (x - v.x) / v.z - 1;"},
    {"NumPy", "vx, vy, w, h = otherX, otherY, otherWidth, otherHeight", "vx, vy, w, h = glGetIntegerv(GL_VIEWPORT)"},
};

} // namespace unprojector::doctor
