// The code for OpenGL with GLU, compiled and run on OpenGL: its matrices and its unprojection equal
// core's.

#include "tests/support/test.h"

#include "tests/scene_code/core_clicks.h"
#include "tests/scene_code/mfc_stand_ins.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#ifdef _WIN32
#include <windows.h>
#endif
#include <GL/gl.h>
#include <GL/glu.h>

namespace frustum {
#include "frustum_glu.h"
int facesDrawn = 0;
double faceDepth = 0.0; ///< in NDC, where faces are drawn over the whole window
void draw_face()
{
    ++facesDrawn;
    glPushMatrix();
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glDisable(GL_CLIP_PLANE0);
    glDisable(GL_CLIP_PLANE1);
    glBegin(GL_TRIANGLES);
    for (const double x : {-1.0, 3.0})
        glVertex3d(x, -1.0, faceDepth);
    glVertex3d(-1.0, 3.0, faceDepth);
    glEnd();
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPopMatrix();
}
} // namespace frustum
namespace matrices {
#include "matrices_glu.h"
}
namespace oblique {
#include "oblique_glu.h"
}
namespace off_centre {
#include "off_centre_glu.h"
}
namespace ortho {
#include "ortho_glu.h"
}
namespace perspective {
#include "perspective_glu.h"
}

using namespace unprojector::scene_file;
using namespace unprojector::geometry;

namespace {

struct Compiled {
    const char *scene;
    void (*setUp)();
    void (*setViewport)();
    void (*setProjection)();
    void (*setCamera)();
    bool (*screen2world)(int, int, GLdouble, GLdouble *);
    bool (*screen2worldRead)(int, int, GLdouble *);
};

#define COMPILED(scene)                                                                                                \
    Compiled                                                                                                           \
    {                                                                                                                  \
#scene, scene::setUp, scene::setViewport, scene::setProjection, scene::setCamera, scene::screen2world,         \
            scene::screen2world                                                                                        \
    }

glm::dmat4 current(GLenum name)
{
    glm::dmat4 m;
    glGetDoublev(name, &m[0][0]);
    return m;
}

/// Drivers keep matrices in single precision, and gluLookAt computes in it.
constexpr double kInFloat = 1e-6;

} // namespace

Q_DECLARE_METATYPE(Compiled)

#ifndef _WIN32

namespace {

class View : public frustum::SceneView {
public:
    using SceneView::OnCreate;
    using SceneView::OnDestroy;
    using SceneView::OnDraw;
    using SceneView::OnLButtonDown;
    using SceneView::OnSize;
    using SceneView::PreCreateWindow;
};

} // namespace

#endif

class TestGluCode : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSurfaceFormat format;
        format.setVersion(2, 1);
        format.setProfile(QSurfaceFormat::NoProfile);
        m_context.setFormat(format);
        m_surface.setFormat(format);
        m_surface.create();
        QVERIFY(m_context.create());
        QVERIFY(m_context.makeCurrent(&m_surface));
    }

    void matricesAreCores_data() { compiledRows(); }

    void matricesAreCores()
    {
        QFETCH(Compiled, code);
        const Setup setup = setupOf(core_clicks::sceneNamed(code.scene));
        code.setUp();
        code.setViewport();
        code.setProjection();
        code.setCamera();
        core_clicks::compareMatrices(current(GL_PROJECTION_MATRIX), *clipFromEye(setup), kInFloat);
        core_clicks::compareMatrices(current(GL_MODELVIEW_MATRIX), *eyeFromWorld(setup), kInFloat);
        QCOMPARE(glGetError(), GLenum(GL_NO_ERROR));
    }

    void objectsAreWhereCoreHasThem()
    {
        const SceneFile scene = core_clicks::sceneNamed("frustum");
        glMatrixMode(GL_MODELVIEW);
        int place = 0;
        for (void (*const put)() : {frustum::place_face, frustum::place_2}) {
            glLoadIdentity();
            put();
            core_clicks::compareMatrices(current(GL_MODELVIEW_MATRIX),
                                         worldFromObject(scene.objects[place++].transform), kInFloat);
        }
        frustum::drawScene();
        QCOMPARE(frustum::facesDrawn, 1);
        GLdouble plane[4];
        glGetClipPlane(GL_CLIP_PLANE0, plane);
        // The planes are in eye space: the inverse of the camera's matrix gives them.
        const glm::dmat4 view = *eyeFromWorld(setupOf(scene));
        const glm::dvec4 expected = scene.clipPlanes[0] * glm::inverse(view);
        for (int k = 0; k < 4; ++k)
            QVERIFY(std::abs(plane[k] - expected[k]) < 1e-5);
        QCOMPARE(glGetError(), GLenum(GL_NO_ERROR));
    }

    void aHundredPointsAreCores_data() { compiledRows(); }

    void aHundredPointsAreCores()
    {
        QFETCH(Compiled, code);
        code.setViewport();
        code.setProjection();
        const auto screen2world = [&code](int i, int j, double depth) {
            GLdouble world[3];
            return code.screen2world(i, j, depth, world) ? glm::dvec3(world[0], world[1], world[2]) : glm::dvec3(NAN);
        };
        core_clicks::compareClicks(core_clicks::sceneNamed(code.scene), screen2world, 20.0 * kInFloat);
    }

    void theDepthOfThePixelsOwnRowIsRead_data() { compiledRows(); }

    void theDepthOfThePixelsOwnRowIsRead()
    {
        QFETCH(Compiled, code);
        const Setup setup = setupOf(core_clicks::sceneNamed(code.scene));
        const int height = setup.surface.heightPixels;
        QOpenGLFramebufferObject frame(setup.surface.widthPixels, height, QOpenGLFramebufferObject::Depth);
        QVERIFY(frame.bind());
        code.setUp();
        code.setViewport();
        code.setProjection();
        glClear(GL_DEPTH_BUFFER_BIT);
        const double clicked = 0.25 * setup.depthRange.atNear + 0.75 * setup.depthRange.atFar;
        glEnable(GL_SCISSOR_TEST);
        glScissor(123, height - 1 - 100, 1, 1);
        glClearDepth(clicked);
        glClear(GL_DEPTH_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);

        GLdouble read[3], expected[3];
        QVERIFY(code.screen2worldRead(123, 100, read));
        QVERIFY(code.screen2world(123, 100, clicked, expected));
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(read[axis] - expected[axis]) < 1e-4);
        for (const auto &[i, j] : {std::pair{123, 99}, {123, 101}, {122, 100}, {124, 100}})
            QVERIFY(!code.screen2worldRead(i, j, read)); // nothing was drawn there
        QVERIFY(frame.release());
        QCOMPARE(glGetError(), GLenum(GL_NO_ERROR));
    }

    /// declared on each system: moc does not know _WIN32
    void thePapersHandlersAnswerAClick()
    {
#ifdef _WIN32
        QSKIP("the stand-ins for MFC would meet the real names of windows.h");
#else
        QOpenGLFramebufferObject frame(800, 600, QOpenGLFramebufferObject::Depth);
        QVERIFY(frame.bind());
        View view;
        CREATESTRUCT asked;
        QVERIFY(view.PreCreateWindow(asked));
        QVERIFY(asked.style & WS_CLIPCHILDREN);
        QCOMPARE(view.OnCreate(&asked), 0);
        view.OnSize(0, 800, 600);
        frustum::faceDepth = 0.8; // of NDC
        const int before = swaps;
        view.OnDraw(nullptr);
        QCOMPARE(swaps, before + 1);
        view.OnLButtonDown(0, {200, 100});
        const QStringList shown = QString::fromStdString(mainWindow.title.text()).split(QStringLiteral(", "));
        GLdouble expected[3];
        QVERIFY(frustum::screen2world(200, 100, 0.9, expected));
        QCOMPARE(shown.size(), 3);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(shown[axis].toDouble() - expected[axis]) < 1e-4);

        frustum::faceDepth = 2.0; // behind the far plane
        view.OnLButtonDown(0, {200, 100});
        QCOMPARE(mainWindow.title.text(), std::string("Background: no surface here"));
        view.OnDestroy();
        QVERIFY(frame.release());
        QCOMPARE(glGetError(), GLenum(GL_NO_ERROR));
#endif
    }

private:
    static void compiledRows()
    {
        addColumn<Compiled>("code");
        newRow("frustum") << COMPILED(frustum);
        newRow("matrices") << COMPILED(matrices);
        newRow("oblique") << COMPILED(oblique);
        newRow("off-centre") << COMPILED(off_centre);
        newRow("ortho") << COMPILED(ortho);
        newRow("perspective") << COMPILED(perspective);
    }

    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
};

UNPROJECTOR_TEST(TestGluCode, display)
#include "test_glu_code.moc"
