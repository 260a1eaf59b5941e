#include "core/doctor/remedies.h"

#include "core/text/translation.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace unprojector::doctor {
using text::marked;
namespace {

constexpr CodeChange kYNotFlipped[] = {
    {"GLU", "gluUnProject(x, y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, y, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 2 * y / H - 1;", "ndc.y = 1 - 2 * y / H;"},
    {"NumPy", "y_n = 2 * (y - vy) / h - 1", "y_n = 2 * (H - y - vy) / h - 1"},
};
constexpr CodeChange kRowAbove[] = {
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
constexpr CodeChange kRowBelow[] = {
    {"GLU", "gluUnProject(x, H - 1 - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - 1 - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - 1 - y, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 1 - 2 * (y + 1) / H;", "ndc.y = 1 - 2 * y / H;"},
    {"NumPy", "y_w = H - 1 - y", "y_w = H - y"},
};
constexpr CodeChange kPixelCorner[] = {
    {"GLU", "gluUnProject(i, H - 1 - j, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(i + 0.5, H - j - 0.5, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(i, H - 1 - j, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(i + 0.5, H - j - 0.5, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(i, H - 1 - j, d).unproject(view, projection, viewport);",
     "p = QVector3D(i + 0.5, H - j - 0.5, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.x = 2 * i / W - 1;", "ndc.x = 2 * (i + 0.5) / W - 1;"},
    {"NumPy", "x_w, y_w = i, H - 1 - j", "x_w, y_w = i + 0.5, H - j - 0.5"},
};
constexpr CodeChange kRatioLogicalInDevice[] = {
    {"GLU", "glfwGetCursorPos(window, &x, &y);", "glfwGetCursorPos(window, &x, &y); x *= ratio; y *= ratio;"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x * ratio, H - y * ratio, d), view, projection, viewport);"},
    {"Qt", "const QPointF at = event->position();", "const QPointF at = event->position() * devicePixelRatioF();"},
    {"three.js", "ndc.x = 2 * event.offsetX / canvas.width - 1;",
     "ndc.x = 2 * event.offsetX / canvas.clientWidth - 1;"},
    {"NumPy", "x_w, y_w = x, H - y", "x_w, y_w = x * ratio, H - y * ratio"},
};
constexpr CodeChange kRatioLogicalBoth[] = {
    {"GLU", "gluUnProject(x, logicalHeight - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x * ratio, H - y * ratio, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, logicalHeight - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x * ratio, H - y * ratio, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(at.x(), height() - at.y(), d).unproject(view, projection, viewport);",
     "at *= devicePixelRatioF(); p = QVector3D(at.x(), H - at.y(), d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 1 - 2 * event.offsetY / canvas.height;",
     "ndc.y = 1 - 2 * event.offsetY / canvas.clientHeight;"},
    {"NumPy", "x_w, y_w = x, H / ratio - y", "x_w, y_w = x * ratio, H - y * ratio"},
};
constexpr CodeChange kRatioDeviceInLogical[] = {
    {"GLU", "glfwGetWindowSize(window, &w, &h); // for the viewport", "glfwGetFramebufferSize(window, &w, &h);"},
    {"GLM", "const glm::dvec4 viewport(0, 0, logicalWidth, logicalHeight);", "const glm::dvec4 viewport(0, 0, W, H);"},
    {"Qt", "const QRect viewport(0, 0, width(), height());",
     "const QRect viewport(0, 0, qRound(width() * devicePixelRatioF()), qRound(height() * devicePixelRatioF()));"},
    {"three.js", "ndc.x = 2 * event.offsetX * devicePixelRatio / canvas.clientWidth - 1;",
     "ndc.x = 2 * event.offsetX / canvas.clientWidth - 1;"},
    {"NumPy", "x_n = 2 * x / (w / ratio) - 1", "x_n = 2 * (x - vx) / w - 1"},
};
constexpr CodeChange kViewportOriginIgnored[] = {
    {"GLU", "GLint viewport[4] = {0, 0, w, h};", "glGetIntegerv(GL_VIEWPORT, viewport); // vx, vy, w, h"},
    {"GLM", "const glm::dvec4 viewport(0, 0, w, h);", "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(0, 0, w, h);", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "ndc.x = 2 * event.clientX / rect.width - 1;",
     "ndc.x = 2 * (event.clientX - rect.left) / rect.width - 1;"},
    {"NumPy", "x_n, y_n = 2 * x_w / w - 1, 2 * y_w / h - 1",
     "x_n, y_n = 2 * (x_w - vx) / w - 1, 2 * (y_w - vy) / h - 1"},
};
constexpr CodeChange kViewportYFromTop[] = {
    {"GLU", "GLint viewport[4] = {vx, yFromTop, w, h};", "GLint viewport[4] = {vx, H - yFromTop - h, w, h};"},
    {"GLM", "const glm::dvec4 viewport(vx, yFromTop, w, h);", "const glm::dvec4 viewport(vx, H - yFromTop - h, w, h);"},
    {"Qt", "const QRect viewport(vx, yFromTop, w, h);", "const QRect viewport(vx, H - yFromTop - h, w, h);"},
    {"three.js", "renderer.getViewport(v); ndc.y = 1 - 2 * (y - v.y) / v.w;",
     "renderer.getViewport(v); ndc.y = 2 * (H - y - v.y) / v.w - 1;"},
    {"NumPy", "y_n = 2 * (y_w - y_from_top) / h - 1", "y_n = 2 * (y_w - (H - y_from_top - h)) / h - 1"},
};
constexpr CodeChange kFlippedWithViewportHeight[] = {
    {"GLU", "gluUnProject(x, viewport[3] - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, viewport[3] - y, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, viewport[3] - y, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.y = 2 * (h - y - vy) / h - 1;", "ndc.y = 2 * (H - y - vy) / h - 1;"},
    {"NumPy", "y_w = h - y", "y_w = H - y"},
};
constexpr CodeChange kViewportIsWindow[] = {
    {"GLU", "GLint viewport[4] = {0, 0, W, H};", "glGetIntegerv(GL_VIEWPORT, viewport); // vx, vy, w, h"},
    {"GLM", "const glm::dvec4 viewport(0, 0, W, H);", "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(QPoint(), size());", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "ndc.x = 2 * event.clientX / window.innerWidth - 1;",
     "ndc.x = 2 * (event.clientX - rect.left) / rect.width - 1;"},
    {"NumPy", "x_n, y_n = 2 * x_w / W - 1, 2 * y_w / H - 1",
     "x_n, y_n = 2 * (x_w - vx) / w - 1, 2 * (y_w - vy) / h - 1"},
};
constexpr CodeChange kXySwapped[] = {
    {"GLU", "gluUnProject(y, x, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(y, x, d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(y, x, d).unproject(view, projection, viewport);",
     "p = QVector3D(x, y, d).unproject(view, projection, viewport);"},
    {"three.js", "ndc.set(y_n, x_n, z_n);", "ndc.set(x_n, y_n, z_n);"},
    {"NumPy", "d = depth[x, y]", "d = depth[y, x]  # rows first"},
};
constexpr CodeChange kAspectInteger[] = {
    {"GLU", "gluPerspective(fovy, w / h, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, w / h, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, w / h, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = Math.floor(w / h);", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = w // h", "aspect = w / h"},
};
constexpr CodeChange kAspectInverted[] = {
    {"GLU", "gluPerspective(fovy, double(h) / w, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, double(h) / w, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, double(h) / w, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = h / w;", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = h / w", "aspect = w / h"},
};
constexpr CodeChange kAspectOfWindow[] = {
    {"GLU", "gluPerspective(fovy, double(W) / H, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, double(W) / H, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, double(W) / H, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = window.innerWidth / window.innerHeight;",
     "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = W / H", "aspect = w / h"},
};
constexpr CodeChange kAspectLeftOut[] = {
    {"GLU", "gluPerspective(fovy, 1.0, n, f);", "gluPerspective(fovy, double(w) / h, n, f);"},
    {"GLM", "glm::perspective(fovy, 1.0, n, f)", "glm::perspective(fovy, double(w) / h, n, f)"},
    {"Qt", "projection.perspective(fovy, 1.0, n, f);", "projection.perspective(fovy, float(w) / h, n, f);"},
    {"three.js", "camera.aspect = 1;", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = 1", "aspect = w / h"},
};
constexpr CodeChange kAspectStale[] = {
    {"GLU", "gluPerspective(fovy, 4.0 / 3.0, n, f); // once",
     "gluPerspective(fovy, double(w) / h, n, f); // whenever the size changes"},
    {"GLM", "projection = glm::perspective(fovy, 4.0 / 3.0, n, f); // once",
     "projection = glm::perspective(fovy, double(w) / h, n, f); // whenever the size changes"},
    {"Qt", "void initializeGL() { projection.perspective(fovy, aspect, n, f); }",
     "void resizeGL(int w, int h) { projection.setToIdentity(); projection.perspective(fovy, float(w) / h, n, f); }"},
    {"three.js", "camera.aspect = w / h;", "camera.aspect = w / h; camera.updateProjectionMatrix();"},
    {"NumPy", "aspect = 4 / 3", "aspect = w / h"},
};
constexpr CodeChange kViewportStale[] = {
    {"GLU", "static GLint viewport[4]; // read once", "glGetIntegerv(GL_VIEWPORT, viewport); // at every click"},
    {"GLM", "static const glm::dvec4 viewport(0, 0, 640, 480);", "const glm::dvec4 viewport(vx, vy, w, h);"},
    {"Qt", "const QRect viewport(0, 0, 640, 480);", "const QRect viewport(vx, vy, w, h);"},
    {"three.js", "const rect = canvas.getBoundingClientRect(); // once",
     "const rect = canvas.getBoundingClientRect(); // at every click"},
    {"NumPy", "W, H = 640, 480", "W, H = image.shape[1], image.shape[0]"},
};
constexpr CodeChange kFovDegreesAsRadians[] = {
    {"GLM", "glm::perspective(fovyDegrees, aspect, n, f)", "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"three.js", "const t = Math.tan(camera.fov / 2);",
     "const t = Math.tan(THREE.MathUtils.degToRad(camera.fov) / 2);"},
    {"NumPy", "t = np.tan(fovy_degrees / 2)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
constexpr CodeChange kFovRadiansAsDegrees[] = {
    {"GLU", "gluPerspective(fovyRadians, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(fovyRadians), aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(fovyRadians, aspect, n, f);", "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = fovyRadians;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovy_radians) / 2)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
constexpr CodeChange kFovHalf[] = {
    {"GLU", "gluPerspective(fovyDegrees / 2, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(fovyDegrees) / 2.0, aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(fovyDegrees / 2, aspect, n, f);",
     "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = fovyDegrees / 2;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovy_degrees) / 4)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
constexpr CodeChange kFovDouble[] = {
    {"GLU", "gluPerspective(2 * fovyDegrees, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(2.0 * fovyDegrees), aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(2 * fovyDegrees, aspect, n, f);",
     "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = 2 * fovyDegrees;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovy_degrees))", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
constexpr CodeChange kFovHorizontal[] = {
    {"GLU", "gluPerspective(fovxDegrees, aspect, n, f);", "gluPerspective(fovyDegrees, aspect, n, f);"},
    {"GLM", "glm::perspective(glm::radians(fovxDegrees), aspect, n, f)",
     "glm::perspective(glm::radians(fovyDegrees), aspect, n, f)"},
    {"Qt", "projection.perspective(fovxDegrees, aspect, n, f);", "projection.perspective(fovyDegrees, aspect, n, f);"},
    {"three.js", "camera.fov = fovxDegrees;", "camera.fov = fovyDegrees; camera.updateProjectionMatrix();"},
    {"NumPy", "t = np.tan(np.radians(fovx_degrees) / 2)", "t = np.tan(np.radians(fovy_degrees) / 2)"},
};
constexpr CodeChange kFrustumCentred[] = {
    {"GLU", "gluPerspective(fovy, aspect, n, f);", "glFrustum(l, r, b, t, n, f);"},
    {"GLM", "glm::perspective(fovy, aspect, n, f)", "glm::frustum(l, r, b, t, n, f)"},
    {"Qt", "projection.perspective(fovy, aspect, n, f);", "projection.frustum(l, r, b, t, n, f);"},
    {"three.js", "x_e = ndc.x * r * z / n;", "x_e = (l + (ndc.x + 1) * (r - l) / 2) * z / n;"},
    {"NumPy", "x_e = x_n * r * z / n", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
};
constexpr CodeChange kDepthNotRemapped[] = {
    {"GLM", "const glm::dvec4 ndc(x_n, y_n, d, 1);", "const glm::dvec4 ndc(x_n, y_n, 2 * d - 1, 1);"},
    {"GLM", "glm::unProjectZO(glm::dvec3(x, H - y, d), view, projection, viewport)",
     "glm::unProjectNO(glm::dvec3(x, H - y, d), view, projection, viewport)"},
    {"Qt", "const QVector4D ndc(x_n, y_n, d, 1);", "const QVector4D ndc(x_n, y_n, 2 * d - 1, 1);"},
    {"three.js", "const p = new THREE.Vector3(x_n, y_n, d).unproject(camera);",
     "const p = new THREE.Vector3(x_n, y_n, 2 * d - 1).unproject(camera);"},
    {"NumPy", "ndc = np.array([x_n, y_n, d, 1])", "ndc = np.array([x_n, y_n, 2 * d - 1, 1])"},
};
constexpr CodeChange kDepthRemappedTwice[] = {
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
constexpr CodeChange kDepthLinear[] = {
    {"GLU", "gluUnProject(x, H - y, (z - n) / (f - n), modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, f * (z - n) / (z * (f - n)), modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, (z - n) / (f - n)), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, f * (z - n) / (z * (f - n))), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, (z - n) / (f - n)).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, f * (z - n) / (z * (f - n))).unproject(view, projection, viewport);"},
    {"three.js", "const z = n + d * (f - n);", "const z = n * f / (f - d * (f - n));"},
    {"NumPy", "z = n + d * (f - n)", "z = n * f / (f - d * (f - n))"},
};
constexpr CodeChange kDepthZero[] = {
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
constexpr CodeChange kDepthOne[] = {
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
constexpr CodeChange kDepthIsEyeDistance[] = {
    {"GLU", "gluUnProject(x, H - y, z, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, f * (z - n) / (z * (f - n)), modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, z), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, f * (z - n) / (z * (f - n))), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, z).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, f * (z - n) / (z * (f - n))).unproject(view, projection, viewport);"},
    {"three.js", "const z = d;", "const z = n * f / (f - d * (f - n));"},
    {"NumPy", "z = d", "z = n * f / (f - d * (f - n))"},
};
constexpr CodeChange kDepthReversed[] = {
    {"GLU", "gluUnProject(x, H - y, 1 - d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::unProject(glm::dvec3(x, H - y, 1 - d), view, projection, viewport);",
     "p = glm::unProject(glm::dvec3(x, H - y, d), view, projection, viewport);"},
    {"Qt", "p = QVector3D(x, H - y, 1 - d).unproject(view, projection, viewport);",
     "p = QVector3D(x, H - y, d).unproject(view, projection, viewport);"},
    {"three.js", "z_n = 1 - d;", "z_n = d; // as the projection matrix has it"},
    {"NumPy", "d = 1 - d", "# d as it is: the projection matrix goes by it"},
};
constexpr CodeChange kDepthRounded[] = {
    {"GLU", "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"GLM", "const std::uint8_t d = image[j * W + i];", "const float d = depth[j * W + i];"},
    {"Qt", "format.setDepthBufferSize(16);", "format.setDepthBufferSize(24);"},
    {"three.js", "target.depthTexture.type = THREE.UnsignedShortType;", "target.depthTexture.type = THREE.FloatType;"},
    {"NumPy", "d = np.uint8(d * 255) / 255", "d = np.float64(d)"},
};
constexpr CodeChange kDepthRangeIgnored[] = {
    {"GLU", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"GLM", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"Qt", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"three.js", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
    {"NumPy", "z_n = 2 * d - 1", "z_n = 2 * (d - dn) / (df - dn) - 1"},
};
constexpr CodeChange kDepthOfAnotherRow[] = {
    {"GLU", "glReadPixels(i, H - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"GLM", "d = depth[(H - j) * W + i];", "d = depth[(H - 1 - j) * W + i];"},
    {"Qt", "glReadPixels(i, H - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);",
     "glReadPixels(i, H - 1 - j, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &d);"},
    {"three.js", "renderer.readRenderTargetPixels(target, i, H - j, 1, 1, buffer);",
     "renderer.readRenderTargetPixels(target, i, H - 1 - j, 1, 1, buffer);"},
    {"NumPy", "d = depth[H - j, i]", "d = depth[H - 1 - j, i]"},
};
constexpr CodeChange kNearDiffers[] = {
    {"GLU", "gluPerspective(fovy, aspect, otherNear, f);",
     "gluPerspective(fovy, aspect, n, f); // as the picture was drawn"},
    {"GLM", "glm::perspective(fovy, aspect, otherNear, f)",
     "glm::perspective(fovy, aspect, n, f) // as the picture was drawn"},
    {"Qt", "projection.perspective(fovy, aspect, otherNear, f);",
     "projection.perspective(fovy, aspect, n, f); // as the picture was drawn"},
    {"three.js", "z = n * f / (f - d * (f - n)); // otherNear, f",
     "z = n * f / (f - d * (f - n)); // with camera.near, camera.far"},
    {"NumPy", "n, f = otherNear, f", "n, f = near, far  # as the picture was drawn"},
};
constexpr CodeChange kFarDiffers[] = {
    {"GLU", "gluPerspective(fovy, aspect, n, otherFar);",
     "gluPerspective(fovy, aspect, n, f); // as the picture was drawn"},
    {"GLM", "glm::perspective(fovy, aspect, n, otherFar)",
     "glm::perspective(fovy, aspect, n, f) // as the picture was drawn"},
    {"Qt", "projection.perspective(fovy, aspect, n, otherFar);",
     "projection.perspective(fovy, aspect, n, f); // as the picture was drawn"},
    {"three.js", "z = n * f / (f - d * (f - n)); // n, otherFar",
     "z = n * f / (f - d * (f - n)); // with camera.near, camera.far"},
    {"NumPy", "n, f = n, otherFar", "n, f = near, far  # as the picture was drawn"},
};
constexpr CodeChange kRayLengthAsZ[] = {
    {"GLU", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"GLM", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"Qt", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"three.js", "p = eye + direction / dot(direction, forward) * length;", "p = eye + direction * length;"},
    {"NumPy", "p = eye + direction / dot(direction, forward) * length", "p = eye + direction * length"},
};
constexpr CodeChange kZAsRayLength[] = {
    {"GLU", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"GLM", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"Qt", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"three.js", "p = eye + direction * z;", "p = eye + direction / dot(direction, forward) * z;"},
    {"NumPy", "p = eye + direction * z", "p = eye + direction / dot(direction, forward) * z"},
};
constexpr CodeChange kLinearAngle[] = {
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
constexpr CodeChange kOrthoFormula[] = {
    {"GLU", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"GLM", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"Qt", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"three.js", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"NumPy", "x_e = l + (x_n + 1) * (r - l) / 2", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
};
constexpr CodeChange kDividedByFar[] = {
    {"GLU", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"GLM", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"Qt", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"three.js", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
    {"NumPy", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / f", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n"},
};
constexpr CodeChange kPerspectiveFormula[] = {
    {"GLU", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"GLM", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"Qt", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"NumPy", "x_e = (l + (x_n + 1) * (r - l) / 2) * z / n", "x_e = l + (x_n + 1) * (r - l) / 2"},
    {"three.js", "raycaster.set(camera.position, direction);", "raycaster.setFromCamera(ndc, camera);"},
};
constexpr CodeChange kNoWDivide[] = {
    {"GLU", "X = v[0]; Y = v[1]; Z = v[2];", "X = v[0] / v[3]; Y = v[1] / v[3]; Z = v[2] / v[3];"},
    {"GLM", "p = glm::dvec3(inverse * ndc);", "const glm::dvec4 v = inverse * ndc; p = glm::dvec3(v) / v.w;"},
    {"Qt", "p = (inverse * QVector4D(ndc, 1)).toVector3D();", "p = (inverse * QVector4D(ndc, 1)).toVector3DAffine();"},
    {"three.js", "v4.applyMatrix4(inverse); p.set(v4.x, v4.y, v4.z);",
     "p.set(x_n, y_n, z_n).applyMatrix4(inverse); // divides by w"},
    {"NumPy", "p = (inverse @ ndc)[:3]", "v = inverse @ ndc; p = v[:3] / v[3]"},
};
constexpr CodeChange kWDividedTwice[] = {
    {"GLU", "X = v[0] / v[3] / v[3];", "X = v[0] / v[3];"},
    {"GLM", "p = glm::dvec3(v / v.w) / v.w;", "p = glm::dvec3(v) / v.w;"},
    {"Qt", "p = v.toVector3DAffine() / v.w();", "p = v.toVector3DAffine();"},
    {"three.js", "p.applyMatrix4(inverse).divideScalar(w);", "p.applyMatrix4(inverse); // divides by w"},
    {"NumPy", "p = v[:3] / v[3] / v[3]", "p = v[:3] / v[3]"},
};
constexpr CodeChange kProjectionTransposed[] = {
    {"GLU", "glLoadMatrixd(projection); // rows", "glLoadTransposeMatrixd(projection);"},
    {"GLM", "glm::make_mat4(projection) // rows", "glm::transpose(glm::make_mat4(projection))"},
    {"Qt", "QMatrix4x4(projection) // takes rows; these are columns", "QMatrix4x4(projection).transposed()"},
    {"three.js", "matrix.fromArray(projection); // rows", "matrix.fromArray(projection).transpose();"},
    {"NumPy", "projection = np.array(m).reshape(4, 4)  # OpenGL's columns", "projection = np.array(m).reshape(4, 4).T"},
};
constexpr CodeChange kViewTransposed[] = {
    {"GLU", "glLoadMatrixd(view); // rows", "glLoadTransposeMatrixd(view);"},
    {"GLM", "glm::make_mat4(view) // rows", "glm::transpose(glm::make_mat4(view))"},
    {"Qt", "QMatrix4x4(view) // takes rows; these are columns", "QMatrix4x4(view).transposed()"},
    {"three.js", "matrix.fromArray(view); // rows", "matrix.fromArray(view).transpose();"},
    {"NumPy", "view = np.array(m).reshape(4, 4)  # OpenGL's columns", "view = np.array(m).reshape(4, 4).T"},
};
constexpr CodeChange kBothTransposed[] = {
    {"GLU", "glLoadMatrixd(view); // rows // and projection", "glLoadTransposeMatrixd(view); // both"},
    {"GLM", "glm::make_mat4(view) // rows // and projection", "glm::transpose(glm::make_mat4(view)) // both"},
    {"Qt", "QMatrix4x4(view) // takes rows; these are columns // and projection",
     "QMatrix4x4(view).transposed() // both"},
    {"three.js", "matrix.fromArray(view); // rows // and projection", "matrix.fromArray(view).transpose(); // both"},
    {"NumPy", "view = np.array(m).reshape(4, 4)  # OpenGL's columns", "view = np.array(m).reshape(4, 4).T  # both"},
};
constexpr CodeChange kProductTransposed[] = {
    {"GLU", "glLoadMatrixd(viewProjection); // rows", "glLoadTransposeMatrixd(viewProjection);"},
    {"GLM", "glm::make_mat4(viewProjection) // rows", "glm::transpose(glm::make_mat4(viewProjection))"},
    {"Qt", "QMatrix4x4(viewProjection) // takes rows; these are columns", "QMatrix4x4(viewProjection).transposed()"},
    {"three.js", "matrix.fromArray(viewProjection); // rows", "matrix.fromArray(viewProjection).transpose();"},
    {"NumPy", "viewProjection = np.array(m).reshape(4, 4)  # OpenGL's columns",
     "viewProjection = np.array(m).reshape(4, 4).T"},
};
constexpr CodeChange kInverseOrder[] = {
    {"GLU", "inverse = product(inverted(projection), inverted(modelview));",
     "inverse = product(inverted(modelview), inverted(projection));"},
    {"GLM", "glm::inverse(projection) * glm::inverse(view) * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "projection.inverted() * view.inverted() * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.applyMatrix4(camera.matrixWorld).applyMatrix4(camera.projectionMatrixInverse);",
     "p.applyMatrix4(camera.projectionMatrixInverse).applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "inv(projection) @ inv(view) @ ndc", "inv(projection @ view) @ ndc"},
};
constexpr CodeChange kNotInverted[] = {
    {"GLU", "gluProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "projection * view * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "projection * view * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.project(camera);", "p.unproject(camera);"},
    {"NumPy", "projection @ view @ ndc", "inv(projection @ view) @ ndc"},
};
constexpr CodeChange kViewInverseAsView[] = {
    {"GLU", "glLoadMatrixd(cameraMatrix);", "glLoadMatrixd(inverseOfCameraMatrix);"},
    {"GLM", "glm::unProject(w, camera, projection, viewport)",
     "glm::unProject(w, glm::inverse(camera), projection, viewport)"},
    {"Qt", "w.unproject(camera, projection, viewport)", "w.unproject(camera.inverted(), projection, viewport)"},
    {"three.js", "const view = camera.matrixWorld;", "const view = camera.matrixWorldInverse;"},
    {"NumPy", "view = camera_pose", "view = inv(camera_pose)"},
};
constexpr CodeChange kViewLeftOut[] = {
    {"GLU", "gluUnProject(x, H - y, d, identity, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "glm::inverse(projection) * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "projection.inverted() * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.applyMatrix4(camera.projectionMatrixInverse);",
     "p.applyMatrix4(camera.projectionMatrixInverse).applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "inv(projection) @ ndc", "inv(projection @ view) @ ndc"},
};
constexpr CodeChange kProjectionLeftOut[] = {
    {"GLU", "gluUnProject(x, H - y, d, modelview, identity, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "glm::inverse(view) * ndc", "glm::inverse(projection * view) * ndc"},
    {"Qt", "view.inverted() * ndc", "(projection * view).inverted() * ndc"},
    {"three.js", "p.applyMatrix4(camera.matrixWorld);",
     "p.applyMatrix4(camera.projectionMatrixInverse).applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "inv(view) @ ndc", "inv(projection @ view) @ ndc"},
};
constexpr CodeChange kOverwrittenInPlace[] = {
    {"GLU", "for (i = 0; i < 4; ++i) v[i] = m[i] * v[0] + m[4 + i] * v[1] + m[8 + i] * v[2] + m[12 + i] * v[3];",
     "for (i = 0; i < 4; ++i) r[i] = m[i] * v[0] + m[4 + i] * v[1] + m[8 + i] * v[2] + m[12 + i] * v[3];"},
    {"GLM", "v.x = dot(row(m, 0), v); v.y = dot(row(m, 1), v); …", "v = m * v;"},
    {"Qt", "v.setX(QVector4D::dotProduct(m.row(0), v)); …", "v = m * v;"},
    {"three.js", "v.x = e[0] * v.x + …; v.y = e[1] * v.x + …;", "v.applyMatrix4(m);"},
    {"NumPy", "for i in range(4): v[i] = m[i] @ v", "v = m @ v"},
};
constexpr CodeChange kModelLeftIn[] = {
    {"GLU", "gluUnProject(x, H - y, d, viewTimesModel, projection, viewport, &X, &Y, &Z);",
     "gluUnProject(x, H - y, d, view, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "glm::unProject(w, view * model, projection, viewport)", "glm::unProject(w, view, projection, viewport)"},
    {"Qt", "w.unproject(view * model, projection, viewport)", "w.unproject(view, projection, viewport)"},
    {"three.js", "mesh.worldToLocal(p);", "// p is in world space already"},
    {"NumPy", "inv(projection @ view @ model) @ ndc", "inv(projection @ view) @ ndc"},
};
constexpr CodeChange kModelLeftOut[] = {
    {"GLU", "gluUnProject(x, H - y, d, view, projection, viewport, &X, &Y, &Z); // for the object's coordinates",
     "gluUnProject(x, H - y, d, viewTimesModel, projection, viewport, &X, &Y, &Z);"},
    {"GLM", "p = glm::dvec3(model * glm::dvec4(p, 1)); // of a point in world space", "// p is in world space already"},
    {"Qt", "p = model.map(p); // of a point in world space", "// p is in world space already"},
    {"three.js", "mesh.localToWorld(p);", "// p is in world space already"},
    {"NumPy", "p = (model @ np.append(p, 1))[:3]", "# p is in world space already"},
};
constexpr CodeChange kEyeAdded[] = {
    {"GLM", "p = eye + glm::unProject(w, view, projection, viewport);",
     "p = glm::unProject(w, view, projection, viewport);"},
    {"Qt", "p = eye + w.unproject(view, projection, viewport);", "p = w.unproject(view, projection, viewport);"},
    {"three.js", "p.unproject(camera).add(camera.position);", "p.unproject(camera);"},
    {"NumPy", "p = eye + v[:3] / v[3]", "p = v[:3] / v[3]"},
};
constexpr CodeChange kEyeSubtracted[] = {
    {"GLM", "p = glm::transpose(glm::dmat3(view)) * eyePoint;",
     "p = glm::transpose(glm::dmat3(view)) * eyePoint + eye;"},
    {"Qt", "p = view.inverted().mapVector(eyePoint);", "p = view.inverted().map(eyePoint);"},
    {"three.js", "p.transformDirection(camera.matrixWorld);", "p.applyMatrix4(camera.matrixWorld);"},
    {"NumPy", "p = view[:3, :3].T @ p_eye", "p = view[:3, :3].T @ p_eye + eye"},
};
constexpr CodeChange kEyeZPositive[] = {
    {"GLU", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},   {"GLM", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},
    {"Qt", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},    {"three.js", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},
    {"NumPy", "p_eye = (x, y, z)", "p_eye = (x, y, -z)"},
};
constexpr CodeChange kEyeXyMirrored[] = {
    {"GLU", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"GLM", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"Qt", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"three.js", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
    {"NumPy", "x_e = x_n * r * z_eye / n", "x_e = x_n * r * -z_eye / n"},
};
constexpr CodeChange kAxesSwapped[] = {
    {"GLU", "p = (p.x, p.z, p.y)", "p = (p.x, p.y, p.z)"},   {"GLM", "p = (p.x, p.z, p.y)", "p = (p.x, p.y, p.z)"},
    {"Qt", "p = (p.x, p.z, p.y)", "p = (p.x, p.y, p.z)"},    {"three.js", "p = (p.x, p.z, p.y)", "p = (p.x, p.y, p.z)"},
    {"NumPy", "p = (p.x, p.z, p.y)", "p = (p.x, p.y, p.z)"},
};

constexpr Remedy kRemedies[] = {
    {"y-not-flipped", marked("y not flipped"),
     marked("y is not turned over: rows of a window count from the top, OpenGL's from the bottom."), kYNotFlipped},
    {"row-above", marked("row above"), marked("The row is one too high: H - y is taken for H - 1 - y."), kRowAbove},
    {"row-below", marked("row below"),
     marked("The row is one too low: H - 1 - y is taken for H - y, though y has its half already."), kRowBelow},
    {"pixel-corner", marked("pixel corner"),
     marked("The pixel's corner is unprojected instead of its centre: half a pixel is missing."), kPixelCorner},
    {"ratio-logical-in-device", marked("logical pixels in a device viewport"),
     marked("The pixel is in logical pixels, the viewport and the height of the flip are in device pixels."),
     kRatioLogicalInDevice},
    {"ratio-logical-both", marked("pixel and flip in logical pixels"),
     marked("The pixel and the height of the flip are in logical pixels, the viewport is in device pixels."),
     kRatioLogicalBoth},
    {"ratio-device-in-logical", marked("device pixels in a logical viewport"),
     marked("The viewport is in logical pixels, the pixel in device pixels; or the pixel ratio is applied twice."),
     kRatioDeviceInLogical},
    {"viewport-origin-ignored", marked("viewport's origin ignored"),
     marked("The viewport's origin is ignored, as if it lay in the window's corner."), kViewportOriginIgnored},
    {"viewport-y-from-top", marked("viewport's y from the top"),
     marked("The viewport's y is counted from the top of the window; OpenGL counts it from the bottom."),
     kViewportYFromTop},
    {"flipped-with-viewport-height", marked("flipped with the viewport's height"),
     marked("y is turned over with the viewport's height instead of the framebuffer's."), kFlippedWithViewportHeight},
    {"viewport-is-window", marked("window taken for viewport"), marked("The whole window is taken for the viewport."),
     kViewportIsWindow},
    {"xy-swapped", marked("x and y swapped"), marked("x and y are swapped."), kXySwapped},
    {"aspect-integer", marked("aspect integer"), marked("The aspect is divided in whole numbers: 800 / 600 is 1."),
     kAspectInteger},
    {"aspect-inverted", marked("aspect inverted"), marked("The aspect is turned round: height by width."),
     kAspectInverted},
    {"aspect-of-window", marked("aspect of the window"), marked("The aspect is the window's, not the viewport's."),
     kAspectOfWindow},
    {"aspect-left-out", marked("aspect left out"), marked("The aspect is left out, as in a square viewport."),
     kAspectLeftOut},
    {"aspect-stale", marked("aspect of another size"),
     marked("The aspect is another one than the viewport's: of the window's size before, or a fixed one."),
     kAspectStale},
    {"viewport-stale", marked("viewport of another size"),
     marked("The viewport or the height of the flip is that of another size."), kViewportStale},
    {"fov-degrees-as-radians", marked("degrees taken for radians"),
     marked("The field of view is in degrees where radians are meant."), kFovDegreesAsRadians},
    {"fov-radians-as-degrees", marked("radians taken for degrees"),
     marked("The field of view is in radians where degrees are meant."), kFovRadiansAsDegrees},
    {"fov-half", marked("half the field of view"), marked("Half the field of view is taken for the whole."), kFovHalf},
    {"fov-double", marked("twice the field of view"),
     marked("The field of view is twice as large: half the angle is the one that has the tangent."), kFovDouble},
    {"fov-horizontal", marked("horizontal field of view"),
     marked("The field of view of one axis is taken for the other's: these functions want the vertical angle."),
     kFovHorizontal},
    {"frustum-centred", marked("frustum taken for centred"),
     marked("The frustum is taken for a centred one, though the view axis is not in its middle."), kFrustumCentred},
    {"depth-not-remapped", marked("depth not remapped"),
     marked("z in NDC is taken to be the depth itself: depths go from 0 to 1, OpenGL's NDC from -1 to 1."),
     kDepthNotRemapped},
    {"depth-remapped-twice", marked("depth remapped twice"),
     marked(
         "The depth is mapped to -1 to 1 once too often: the function does it itself, or the matrix goes by 0 to 1."),
     kDepthRemappedTwice},
    {"depth-linear", marked("depth taken for linear"),
     marked("A depth is not linear in the distance: a share of the way from near to far is confused with it."),
     kDepthLinear},
    {"depth-zero", marked("depth 0"), marked("The depth is 0: it was not read, or not where the picture is."),
     kDepthZero},
    {"depth-one", marked("depth 1"), marked("The depth is 1: that of the background, or of a buffer that was cleared."),
     kDepthOne},
    {"depth-is-eye-distance", marked("distance taken for depth"),
     marked("A distance from the eye is confused with the depth."), kDepthIsEyeDistance},
    {"depth-reversed", marked("depth reversed"),
     marked("The depth is turned round: reversed depths are taken for ordinary ones, or ordinary for reversed ones."),
     kDepthReversed},
    {"depth-rounded", marked("depth rounded"), marked("The depth is rounded to few bits."), kDepthRounded},
    {"depth-range-ignored", marked("depth range ignored"),
     marked("The depth range is ignored, as if it went from 0 to 1."), kDepthRangeIgnored},
    {"depth-of-another-row", marked("depth of another row"), marked("The depth is that of a neighbouring row."),
     kDepthOfAnotherRow},
    {"near-differs", marked("another near plane"), marked("The near plane is not that of the picture."), kNearDiffers},
    {"far-differs", marked("another far plane"), marked("The far plane is not that of the picture."), kFarDiffers},
    {"ray-length-as-z", marked("length of the ray taken for z"),
     marked("The length of the ray is taken for z: z is measured along the view axis."), kRayLengthAsZ},
    {"z-as-ray-length", marked("z taken for length of the ray"),
     marked("z is taken for the length of the ray: z is measured along the view axis."), kZAsRayLength},
    {"linear-angle", marked("angle interpolated"),
     marked("The ray's angle is interpolated; it is its tangent that is linear in the pixel."), kLinearAngle},
    {"ortho-formula", marked("orthographic formula"),
     marked("The formula of an orthographic view is used in a perspective one: x and y are not scaled by z / near."),
     kOrthoFormula},
    {"divided-by-far", marked("divided by far"),
     marked("The near plane's window is scaled by z / far instead of z / near."), kDividedByFar},
    {"perspective-formula", marked("perspective formula"),
     marked("The formula of a perspective is used in an orthographic view, as if rays came from the eye."),
     kPerspectiveFormula},
    {"no-w-divide", marked("not divided by w"), marked("The result is not divided by w."), kNoWDivide},
    {"w-divided-twice", marked("divided by w twice"), marked("The result is divided by w twice."), kWDividedTwice},
    {"projection-transposed", marked("projection transposed"),
     marked("The projection matrix is transposed: its rows are taken for columns."), kProjectionTransposed},
    {"view-transposed", marked("view transposed"),
     marked("The view matrix is transposed: its rows are taken for columns."), kViewTransposed},
    {"both-transposed", marked("both transposed"),
     marked("Projection and view matrix are transposed: rows are taken for columns."), kBothTransposed},
    {"product-transposed", marked("product transposed"),
     marked("The product of projection and view is transposed: its rows are taken for columns."), kProductTransposed},
    {"inverse-order", marked("inverses in the wrong order"),
     marked("The inverses stand in the wrong order: the inverse of P V is inverse(V) inverse(P)."), kInverseOrder},
    {"not-inverted", marked("not inverted"), marked("The matrices are not inverted."), kNotInverted},
    {"view-inverse-as-view", marked("view's inverse taken for view"),
     marked("The camera's own matrix, which is the view's inverse, is passed for the view."), kViewInverseAsView},
    {"view-left-out", marked("view left out"),
     marked("The view matrix is left out: what comes is the point in eye space."), kViewLeftOut},
    {"projection-left-out", marked("projection left out"), marked("The projection matrix is left out."),
     kProjectionLeftOut},
    {"overwritten-in-place", marked("overwritten in place"),
     marked("The vector is overwritten while it is still needed: y is computed with the new x."), kOverwrittenInPlace},
    {"model-left-in", marked("model left in"),
     marked("The model matrix is left in: these are the object's own coordinates, not the world's."), kModelLeftIn},
    {"model-left-out", marked("model left out"),
     marked("The model matrix is applied once too often, or left out of the inverse."), kModelLeftOut},
    {"eye-added", marked("eye added"), marked("The eye's position is added to a point that has it already."),
     kEyeAdded},
    {"eye-subtracted", marked("eye subtracted"),
     marked("The eye's position is missing: the point is counted from the eye, along the world's axes."),
     kEyeSubtracted},
    {"eye-z-positive", marked("z of the eye point positive"),
     marked("z of the eye point has the wrong sign: an eye looks down -z."), kEyeZPositive},
    {"eye-xy-mirrored", marked("eye point mirrored"),
     marked("x and y of the eye point are mirrored: the formulas want z as a distance, above 0."), kEyeXyMirrored},
    {"axes-swapped", marked("axes swapped"), marked("Axes are exchanged, as between y up and z up."), kAxesSwapped},
};

} // namespace

const Remedy &remedyOf(std::string_view id)
{
    const auto *found =
        std::find_if(std::begin(kRemedies), std::end(kRemedies), [&](const Remedy &remedy) { return remedy.id == id; });
    assert(found != std::end(kRemedies));
    return *found;
}

} // namespace unprojector::doctor
