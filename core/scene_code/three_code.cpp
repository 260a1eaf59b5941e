#include "core/scene_code/code_text.h"
#include "core/scene_code/dialects.h"

namespace unprojector::scene_code {
using namespace geometry;
using namespace scene_file;

namespace {

constexpr NumberStyle kStyle = NumberStyle::JavaScript;

std::string number(double value)
{
    return literal(value, kStyle);
}

std::string rows(const glm::dmat4 &matrix)
{
    return "( // row by row\n    " + list(matrix, MatrixOrder::ByRows, kStyle, "    ") + ");\n";
}

/// left, right, top, bottom, near, far: a different order than glOrtho's.
std::string window(const ProjectionWindow &w)
{
    return list({w.left, w.right, w.top, w.bottom, w.nearDistance, w.farDistance}, kStyle);
}

const char *const kOwnMatrix = "// Its projection is set as a matrix: there is no updateProjectionMatrix to call.\n"
                               "export const camera = new THREE.Camera();\n";
std::string multiplied(const glm::dmat4 &shear)
{
    return "camera.projectionMatrix.multiply(new THREE.Matrix4().set(\n    "
           + list(shear, MatrixOrder::ByRows, kStyle, "    ") + "));\n";
}

const char *const kItsInverse = "camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();\n";

std::string cameraLines(const Setup &setup)
{
    if (const auto *matrix = std::get_if<MatrixProjection>(&setup.lens))
        return kOwnMatrix + ("camera.projectionMatrix.set" + rows(matrix->clipFromEye)) + kItsInverse;
    struct Visitor {
        const Setup &setup;
        std::string operator()(const Frustum &f) const
        {
            return kOwnMatrix
                   + ("camera.projectionMatrix.makePerspective(" + window(projectionWindow(f))
                      + "); // left, right, top, bottom, near, far\n")
                   + (f.skew == 0.0 ? std::string() : multiplied(shearOf(f))) + kItsInverse;
        }
        std::string operator()(const Pinhole &p) const { return (*this)(frustumFromPinhole(p)); }
        std::string operator()(const Ortho &o) const
        {
            return "export const camera = new THREE.OrthographicCamera(" + window(projectionWindow(o))
                   + "); // left, right, top, bottom, near, far\n";
        }
        std::string operator()(const Perspective &p) const
        {
            std::string aspect = number(p.aspect.value);
            if (hasViewportsAspect(setup))
                aspect = "viewport.z / viewport.w";
            return "export const camera = new THREE.PerspectiveCamera(" + number(p.verticalFov.degrees()) + ", "
                   + aspect + ", " + list({p.nearDistance, p.farDistance}, kStyle) + ");\n";
        }
        std::string operator()(const Oblique &o) const
        {
            return kOwnMatrix
                   + ("camera.projectionMatrix.makeOrthographic(" + window(projectionWindow(o))
                      + "); // left, right, top, bottom, near, far\n")
                   + multiplied(shearOf(o)) + kItsInverse;
        }
    };
    return std::visit(Visitor{setup}, setup.projection());
}

std::string poseLines(const Setup &setup)
{
    if (const auto *matrix = std::get_if<glm::dmat4>(&setup.pose))
        return "camera.matrixAutoUpdate = camera.matrixWorldAutoUpdate = false; // these stay as they are given\n"
               "camera.matrixWorldInverse.set"
               + rows(*matrix) + "camera.matrixWorld.copy(camera.matrixWorldInverse).invert();\n";
    const LookAt &look = setup.camera();
    return "camera.position.set(" + list({look.eye.x, look.eye.y, look.eye.z}, kStyle) + ");\n" + "camera.up.set("
           + list({look.up.x, look.up.y, look.up.z}, kStyle) + ");\n" + "camera.lookAt("
           + list({look.center.x, look.center.y, look.center.z}, kStyle) + "); // after position and up\n"
           + "camera.updateMatrixWorld();\n";
}

std::string stepCall(const TransformStep &step)
{
    struct Visitor {
        std::string operator()(const Translate &t) const { return "makeTranslation(" + list(t.offset, kStyle) + ')'; }
        std::string operator()(const Rotate &r) const
        {
            return "makeRotationAxis(new THREE.Vector3(" + list(axisForCode(r.axis), kStyle)
                   + ").normalize(), THREE.MathUtils.degToRad(" + number(r.degrees) + "))";
        }
        std::string operator()(const Scale &s) const { return "makeScale(" + list(s.factors, kStyle) + ')'; }
    };
    return "\n    .multiply(new THREE.Matrix4()." + std::visit(Visitor{}, step) + ')';
}

std::string objectLines(const SceneFileObject &object, const std::string &id)
{
    const std::string name = "object_" + id;
    std::string text = "\n// " + whatIs(object) + ": add its mesh here.\nexport const " + name
                       + " = new THREE.Group();\n" + name + ".matrixAutoUpdate = false;\n";
    if (!object.transform.empty()) {
        text += name + ".matrix";
        for (const TransformStep &step : object.transform)
            text += stepCall(step);
        text += ";\n";
    }
    if (object.isHidden)
        text += name + ".visible = false;\n";
    return text + "scene.add(" + name + ");\n";
}

std::string setUpLines(const SceneFile &scene, const Setup &setup)
{
    const Surface &surface = setup.surface;
    const DepthRange &range = setup.depthRange;
    std::string text = "    renderer.setPixelRatio(1);\n"
                       "    renderer.setSize(windowWidth, windowHeight, false); // device pixels";
    if (surface.devicePixelRatio != 1.0)
        text += "; the canvas' style has them divided by " + number(surface.devicePixelRatio);
    text += "\n    renderer.setViewport(viewport);\n";
    if (range != DepthRange{})
        text += "    renderer.getContext().depthRange(" + list({range.atNear, range.atFar}, kStyle)
                + "); // WebGL cuts it to [0, 1]; three.js leaves it alone\n";
    if (isNearGreater(setup))
        text += "    renderer.state.buffers.depth.setClear(0); // near has the greater depths: of every material,\n"
                "    // depthFunc = THREE.GreaterDepth\n";
    if (isDepthZeroToOne(setup))
        text +=
            "    // The projection's depths go from 0 to 1, which WebGL has by the extension EXT_clip_control only:\n"
            "    const clipControl = renderer.getContext().getExtension('EXT_clip_control');\n"
            "    if (clipControl === null)\n"
            "        throw new Error('This browser has no EXT_clip_control');\n"
            "    clipControl.clipControlEXT(clipControl.LOWER_LEFT_EXT, clipControl.ZERO_TO_ONE_EXT);\n";
    if (!scene.clipPlanes.empty()) {
        text += "    renderer.clippingPlanes = [ // world space; three.js wants normals of length 1\n";
        for (const glm::dvec4 &p : scene.clipPlanes)
            text += "        new THREE.Plane(new THREE.Vector3(" + list({p.x, p.y, p.z}, kStyle) + "), " + number(p.w)
                    + ").normalize(),\n";
        text += "    ];\n";
    }
    return text;
}

} // namespace

std::string threeCode(const SceneFile &scene)
{
    const Setup p = setupOf(scene);
    std::string text = headerComment(scene, "A setup's camera and the inverse from a pixel, with three.js");
    text += "\n"
            "import * as THREE from 'three';\n"
            "\n"
            "export const windowWidth = "
            + std::to_string(p.surface.widthPixels) + ", windowHeight = " + std::to_string(p.surface.heightPixels)
            + "; // device pixels\n"
              "// x, y from the bottom, width, height\n"
              "export const viewport = new THREE.Vector4("
            + list({p.viewport.x, p.viewport.y, p.viewport.width, p.viewport.height}, kStyle)
            + ");\n"
              "export const depthAtNear = "
            + number(p.depthRange.atNear) + ", depthAtFar = " + number(p.depthRange.atFar) + ";\n\n" + cameraLines(p)
            + poseLines(p) + "\nexport const scene = new THREE.Scene();\n" + ofEachObject(scene, objectLines)
            + "\n"
              "// Once, with a renderer of neither logarithmicDepthBuffer nor reversedDepthBuffer.\n"
              "export function setUp(renderer) {\n"
            + setUpLines(scene, p) + "}\n";
    text += "\n"
            "// The world coordinate of a pixel's centre, for the depth that is read there. i counts device pixels "
            "from the canvas' "
            "left,\n"
            "// j from its top. WebGL reads no depths from the canvas: draw into a THREE.WebGLRenderTarget with a "
            "depthTexture; its "
            "rows\n"
            "// count from the bottom, so that of the pixel is windowHeight - 1 - j. "
            + number(clearDepth(p))
            + " is the background.\n"
              "export function screen2world(i, j, depth) {\n"
              "    const share = (depth - depthAtNear) / (depthAtFar - depthAtNear);\n"
              "    const ndc = new THREE.Vector3(\n"
              "        2 * (i + 0.5 - viewport.x) / viewport.z - 1,\n"
              "        2 * (windowHeight - j - 0.5 - viewport.y) / viewport.w - 1,\n"
              "        "
            + (isDepthZeroToOne(p) ? "share" : "2 * share - 1")
            + ");\n"
              "    return ndc.unproject(camera);\n}\n";
    return text;
}

} // namespace unprojector::scene_code
