// Calls of other programs in pasted text: each against its matrix, computed here by the formulas of
// its API or by GLM.

#include "tests/core/cameras/pasted_text.h"
#include "tests/support/test.h"

#include "core/cameras/pasted_calls.h"
#include "core/geometry/numbers.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::cameras;
using namespace unprojector::pipeline;

Q_DECLARE_METATYPE(glm::dmat4)

namespace {

double difference(const glm::dmat4 &a, const glm::dmat4 &b)
{
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return largest;
}

/// The matrix of DirectXMath and System.Numerics, given for row vectors and returned for column
/// vectors. @param rows  m11 to m44
glm::dmat4 ofRows(const std::array<double, 16> &rows)
{
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i)
        m[i / 4][i % 4] = rows[std::size_t(i)];
    return m;
}

/// The formulas of the pages of XMMatrixPerspectiveFovRH and LH.
glm::dmat4 directXPerspective(double fov, double aspect, double n, double f, bool isLeftHanded)
{
    const double h = std::cos(fov / 2.0) / std::sin(fov / 2.0), w = h / aspect;
    const double range = isLeftHanded ? f / (f - n) : f / (n - f);
    return ofRows({w, 0, 0, 0, 0, h, 0, 0, 0, 0, range, isLeftHanded ? 1.0 : -1.0, 0, 0,
                   isLeftHanded ? -range * n : range * n, 0});
}

/// The matrix of XMMatrixLookAtLH: the axes as rows, for column vectors.
glm::dmat4 directXLookAt(const glm::dvec3 &eye, const glm::dvec3 &at, const glm::dvec3 &up, bool isLeftHanded)
{
    const glm::dvec3 z = glm::normalize(isLeftHanded ? at - eye : eye - at), x = glm::normalize(glm::cross(up, z)),
                     y = glm::cross(z, x);
    return ofRows({x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, -glm::dot(x, eye), -glm::dot(y, eye),
                   -glm::dot(z, eye), 1});
}

/// glm::perspective with NDC depths in [0, 1].
glm::dmat4 zeroToOne(glm::dmat4 m, double n, double f)
{
    m[2][2] = f / (n - f);
    m[3][2] = -f * n / (f - n);
    return m;
}

glm::dmat4 perspective()
{
    return glm::perspective(kPi / 4.0, 800.0 / 600.0, 0.1, 100.0);
}

glm::dmat4 view()
{
    return glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0, 0.5, 0), glm::dvec3(0, 1, 0));
}

PastedCalls read(const QString &text)
{
    const auto calls = pastedCalls(text.toStdString());
    if (!calls || !calls->hasAny) {
        qWarning("%s: %s", qPrintable(text), calls ? "no call" : calls.error().text.c_str());
        return {};
    }
    return *calls;
}

} // namespace

class TestPastedCalls : public QObject {
    Q_OBJECT

private slots:
    void projectionsAreRead_data()
    {
        addColumn<QString>("text");
        addColumn<glm::dmat4>("expected");
        addColumn<NdcDepth>("depth");
        using enum NdcDepth;
        const glm::dmat4 box = glm::ortho(-4.0, 4.0, -3.0, 2.0, 1.0, 50.0);
        const glm::dmat4 frustum = glm::frustum(-1.0, 2.0, -0.75, 0.5, 2.0, 50.0);
        const glm::dmat4 leftHanded = directXPerspective(kPi / 4.0, 4.0 / 3.0, 0.1, 100.0, true);
        const glm::dmat4 rightHanded = directXPerspective(kPi / 4.0, 4.0 / 3.0, 0.1, 100.0, false);
        newRow("gluPerspective") << "gluPerspective(45, 1.3333333333333333, 0.1, 100);" << perspective()
                                 << MinusOneToOne;
        newRow("glFrustum") << "glFrustum(-1, 2, -0.75, 0.5, 2, 50)" << frustum << MinusOneToOne;
        newRow("glOrtho") << "glOrtho (-4.0, 4.0, -3.0, 2.0,\n 1.0, 50.0);" << box << MinusOneToOne;
        newRow("gluOrtho2D") << "gluOrtho2D(-4, 4, -3, 2)" << glm::ortho(-4.0, 4.0, -3.0, 2.0) << MinusOneToOne;
        newRow("glm::perspective")
            << "glm::mat4 p = glm::perspective(glm::radians(45.0f), 800.0f / 600.0f, 0.1f, 100.0f);" << perspective()
            << MinusOneToOne;
        newRow("glm::perspectiveFov") << "glm::perspectiveFov(glm::radians(45.0), 800.0, 600.0, 0.1, 100.0)"
                                      << perspective() << MinusOneToOne;
        newRow("glm::ortho") << "glm::ortho(-4.f, 4.f, -3.f, 2.f, 1.f, 50.f)" << box << MinusOneToOne;
        newRow("glm::ortho of four") << "glm::ortho(-4.f, 4.f, -3.f, 2.f)" << glm::ortho(-4.0, 4.0, -3.0, 2.0)
                                     << MinusOneToOne;
        newRow("glm::frustum") << "glm::frustum<double>(-1, 2, -0.75, 0.5, 2, 50)" << frustum << MinusOneToOne;
        newRow("GLM by 0 to 1, by its macro") << "#define GLM_FORCE_DEPTH_ZERO_TO_ONE\nauto p = "
                                                 "glm::perspective(glm::quarter_pi<float>(), 4.f / 3.f, .1f, "
                                                 "100.f);"
                                              << zeroToOne(perspective(), 0.1, 100.0) << ZeroToOne;
        newRow("GLM, left-handed by 0 to 1, by its name")
            << "glm::perspectiveLH_ZO(glm::radians(45.0f), 4.f / 3.f, 0.1f, 100.0f)" << leftHanded << ZeroToOne;
        newRow("three.js, perspective") << "const camera = new THREE.PerspectiveCamera( 45, 800 / 600, 0.1, 100 );"
                                        << perspective() << MinusOneToOne;
        newRow("three.js, defaults") << "new PerspectiveCamera()"
                                     << glm::perspective(50.0 * kPi / 180.0, 1.0, 0.1, 2000.0) << MinusOneToOne;
        newRow("three.js, box, whose top comes first")
            << "new THREE.OrthographicCamera(-4, 4, 2, -3, 1, 50)" << box << MinusOneToOne;
        newRow("Numerics, field of view")
            << "var p = Matrix4x4.CreatePerspectiveFieldOfView(MathF.PI / 4, 800f / 600f, 0.1f, 100f);" << rightHanded
            << ZeroToOne;
        newRow("Numerics, perspective") << "Matrix4x4.CreatePerspective(4, 3, 2, 50)"
                                        << ofRows({2.0 * 2.0 / 4.0, 0, 0, 0, 0, 2.0 * 2.0 / 3.0, 0, 0, 0, 0,
                                                   50.0 / (2.0 - 50.0), -1, 0, 0, 2.0 * 50.0 / (2.0 - 50.0), 0})
                                        << ZeroToOne;
        newRow("Numerics, box") << "System.Numerics.Matrix4x4.CreateOrthographic(8.0f, 6.0f, 1.0f, 50.0f)"
                                << ofRows({2.0 / 8.0, 0, 0, 0, 0, 2.0 / 6.0, 0, 0, 0, 0, 1.0 / (1.0 - 50.0), 0, 0, 0,
                                           1.0 / (1.0 - 50.0), 1})
                                << ZeroToOne;
        newRow("Numerics, off center") << "Matrix4x4.CreateOrthographicOffCenter(-4, 4, -3, 2, 1, 50)"
                                       << ofRows({2.0 / 8.0, 0, 0, 0, 0, 2.0 / 5.0, 0, 0, 0, 0, 1.0 / (1.0 - 50.0), 0,
                                                  0, 1.0 / 5.0, 1.0 / (1.0 - 50.0), 1})
                                       << ZeroToOne;
        newRow("OpenTK") << "Matrix4.CreatePerspectiveFieldOfView(MathHelper.PiOver4, 800f / 600f, 0.1f, 100f)"
                         << perspective() << MinusOneToOne;
        newRow("DirectXMath, right-handed")
            << "XMMatrixPerspectiveFovRH(XM_PIDIV4, 800.0f / 600.0f, 0.1f, 100.0f)" << rightHanded << ZeroToOne;
        newRow("DirectXMath, left-handed")
            << "XMMATRIX p = DirectX::XMMatrixPerspectiveFovLH(XMConvertToRadians(45.f), 800.0f / 600.0f, 0.1f, "
               "100.0f);"
            << leftHanded << ZeroToOne;
        newRow("DirectXMath, off center, left-handed")
            << "XMMatrixPerspectiveOffCenterLH(-1, 2, -0.75, 0.5, 2, 50)"
            << ofRows({2.0 * 2.0 / 3.0, 0, 0, 0, 0, 2.0 * 2.0 / 1.25, 0, 0, -1.0 / 3.0, 0.25 / 1.25, 50.0 / 48.0, 1, 0,
                       0, -2.0 * 50.0 / 48.0, 0})
            << ZeroToOne;
        newRow("QMatrix4x4") << "QMatrix4x4 m;\nm.perspective(45.0f, 800.0f / 600.0f, 0.1f, 100.0f);" << perspective()
                             << MinusOneToOne;
        newRow("D3DX") << "D3DXMatrixPerspectiveFovRH(&p, D3DX_PI / 4, 800.0f / 600.0f, 0.1f, 100.0f);" << rightHanded
                       << ZeroToOne;
        newRow("D3DX, box") << "D3DXMatrixOrthoOffCenterRH(&p, -4, 4, -3, 2, 1, 50)"
                            << ofRows({0.25, 0, 0, 0, 0, 0.4, 0, 0, 0, 0, -1.0 / 49, 0, 0, 0.2, -1.0 / 49, 1})
                            << ZeroToOne;
        newRow("SharpDX") << "Matrix.PerspectiveFovRH((float)Math.PI / 4, 800f / 600f, 0.1f, 100f)" << rightHanded
                          << ZeroToOne;
        newRow("PyBullet, field of view")
            << "p.computeProjectionMatrixFOV(fov=45.0, aspect=4 / 3, nearVal=0.1, farVal=100.0)" << perspective()
            << MinusOneToOne;
        newRow("PyBullet, keywords in another order")
            << "p.computeProjectionMatrixFOV(aspect=4 / 3, farVal=100.0, fov=45.0, nearVal=0.1, physicsClientId=client)"
            << perspective() << MinusOneToOne;
        newRow("PyBullet, keywords after positions")
            << "p.computeProjectionMatrixFOV(45.0, 4 / 3, farVal=100.0, nearVal=0.1)" << perspective() << MinusOneToOne;
        newRow("System.Numerics, names in another order")
            << "Matrix4x4.CreatePerspectiveFieldOfView(aspectRatio: 4f / 3f, fieldOfView: MathF.PI / 4, "
               "farPlaneDistance: 100, nearPlaneDistance: 0.1f)"
            << rightHanded << ZeroToOne;
        newRow("PyBullet, edges by keyword")
            << "p.computeProjectionMatrix(right=2, left=-1, top=0.5, bottom=-0.75, farVal=50, nearVal=2)" << frustum
            << MinusOneToOne;
        newRow("PyBullet, edges") << "p.computeProjectionMatrix(-1, 2, -0.75, 0.5, 2, 50)" << frustum << MinusOneToOne;
        newRow("Android") << "Matrix.perspectiveM(m, 0, 45f, 800f / 600f, 0.1f, 100f);" << perspective()
                          << MinusOneToOne;
        newRow("Android, frustum") << "Matrix.frustumM(m, 0, -1f, 2f, -0.75f, 0.5f, 2f, 50f);" << frustum
                                   << MinusOneToOne;
        newRow("glam") << "Mat4::perspective_rh(45f32.to_radians(), 4.0 / 3.0, 0.1, 100.0)" << rightHanded << ZeroToOne;
        newRow("glam of OpenGL") << "Mat4::perspective_rh_gl(std::f32::consts::FRAC_PI_4, 4.0 / 3.0, 0.1, 100.0)"
                                 << perspective() << MinusOneToOne;
        newRow("gl-matrix") << "mat4.perspective(projection, Math.PI / 4, 800 / 600, 0.1, 100);" << perspective()
                            << MinusOneToOne;
    }

    void projectionsAreRead()
    {
        QFETCH(QString, text);
        QFETCH(glm::dmat4, expected);
        QFETCH(NdcDepth, depth);
        const PastedCalls calls = read(text);
        QVERIFY(calls.parts.projection && !calls.parts.view);
        const glm::dmat4 matrix = meantMatrix(*calls.parts.projection, orderOf(calls.parts.projection->form));
        QVERIFY2(difference(matrix, expected) <= 1e-12, qPrintable(QString::number(difference(matrix, expected))));
        QCOMPARE(int(*calls.parts.projection->ndcDepth), int(depth));
        // The dialog's paste.
        const PastedCamera camera = pasted(text.toStdString());
        QVERIFY(camera.projection && !camera.eyeFromWorld);
        QCOMPARE(std::get<MatrixProjection>(*camera.projection), (MatrixProjection{matrix, depth}));
    }

    void viewsAreRead_data()
    {
        addColumn<QString>("text");
        addColumn<glm::dmat4>("expected");
        const glm::dvec3 eye(3, 2, 5), center(0, 0.5, 0), up(0, 1, 0);
        const glm::dmat4 leftHanded = directXLookAt(eye, center, up, true);
        newRow("gluLookAt") << "gluLookAt(3, 2, 5,  0, 0.5, 0,  0, 1, 0);" << view();
        newRow("glm::lookAt")
            << "auto v = glm::lookAt(glm::vec3(3.0f, 2.0f, 5.0f), glm::vec3{0, 0.5, 0}, glm::vec3(0, 1, 0));" << view();
        newRow("GLM, one number three times") << "glm::lookAt(glm::dvec3(2.0), glm::dvec3(0), glm::dvec3(0, 0, 1))"
                                              << glm::lookAt(glm::dvec3(2.0), glm::dvec3(0.0), glm::dvec3(0, 0, 1));
        newRow("GLM, left-handed") << "glm::lookAtLH(glm::vec3(3, 2, 5), glm::vec3(0, 0.5, 0), glm::vec3(0, 1, 0))"
                                   << leftHanded;
        newRow("three.js") << "camera.position.set(3, 2, 5);\ncamera.lookAt(0, 0.5, 0);" << view();
        newRow("three.js, a vector")
            << "camera.position.set( 3, 2, 5 );\ncamera.lookAt( new THREE.Vector3( 0, 0.5, 0 ) );" << view();
        newRow("three.js, coordinate by coordinate")
            << "camera.position.x = 3;\ncamera.position.y = 2;\ncamera.position.z = 5\ncamera.lookAt(0, 0.5, 0);"
            << view();
        newRow("three.js, up") << "camera.up.set(0, 0, 1)\ncamera.position.set(3, 2, 5)\ncamera.lookAt(0, 0.5, 0)"
                               << glm::lookAt(eye, center, glm::dvec3(0, 0, 1));
        newRow("three.js, up, coordinate by coordinate")
            << "camera.up.y = 0\ncamera.up.z = 1\ncamera.position.set(3, 2, 5)\ncamera.lookAt(0, 0.5, 0)"
            << glm::lookAt(eye, center, glm::dvec3(0, 0, 1));
        newRow("three.js, moved after it was turned") // keeps its direction
            << "camera.position.set(3, 2, 4); camera.lookAt(0, 0.5, -1); camera.position.z = 5;"
            << glm::lookAt(eye, center, up);
        newRow("three.js, moved only") << "camera.position.set(0, 0, 5)"
                                       << glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -5));
        newRow("Numerics") << "Matrix4x4.CreateLookAt(new Vector3(3, 2, 5), new Vector3(0, 0.5f, 0), Vector3.UnitY)"
                           << directXLookAt(eye, center, up, false);
        newRow("DirectXMath, right-handed")
            << "XMMatrixLookAtRH(XMVectorSet(3, 2, 5, 1), XMVectorSet(0, 0.5f, 0, 1), XMVectorSet(0, 1, 0, 0))"
            << directXLookAt(eye, center, up, false);
        newRow("DirectXMath, left-handed")
            << "XMMatrixLookAtLH(XMVectorSet(3, 2, 5, 1), XMVectorSet(0, 0.5f, 0, 1), XMVectorSet(0, 1, 0, 0))"
            << leftHanded;
        newRow("DirectXMath, a direction")
            << "XMMatrixLookToLH(XMVectorSet(3, 2, 5, 1), XMVectorSet(-3, -1.5f, -5, 0), XMVectorSet(0, 1, 0, 0))"
            << leftHanded;
        newRow("D3DX") << "D3DXMatrixLookAtLH(&v, &D3DXVECTOR3(3, 2, 5), &D3DXVECTOR3(0, 0.5f, 0), "
                          "&D3DXVECTOR3(0, 1, 0));"
                       << leftHanded;
        newRow("SharpDX") << "Matrix.LookAtRH(new Vector3(3, 2, 5), new Vector3(0, 0.5f, 0), Vector3.UnitY)"
                          << directXLookAt(eye, center, up, false);
        newRow("PyBullet") << "v = p.computeViewMatrix(cameraEyePosition=[3, 2, 5], cameraTargetPosition=[0, 0.5, "
                              "0], cameraUpVector=[0, 1, 0])"
                           << view();
        newRow("PyBullet, keywords in another order")
            << "v = p.computeViewMatrix(cameraTargetPosition=[0, 0.5, 0], cameraUpVector=[0, 1, 0], "
               "cameraEyePosition=[3, 2, 5])"
            << view();
        newRow("Android") << "Matrix.setLookAtM(view, 0, 3f, 2f, 5f, 0f, 0.5f, 0f, 0f, 1f, 0f);" << view();
        newRow("glam") << "Mat4::look_at_rh(Vec3::new(3.0, 2.0, 5.0), vec3(0.0, 0.5, 0.0), vec3(0.0, 1.0, 0.0))"
                       << view();
        newRow("glam, left-handed")
            << "Mat4::look_to_lh(vec3(3.0, 2.0, 5.0), vec3(-3.0, -1.5, -5.0), vec3(0.0, 1.0, 0.0))" << leftHanded;
        newRow("gl-matrix") << "mat4.lookAt(out, [3, 2, 5], [0, 0.5, 0], [0, 1, 0])" << view();
        newRow("vectors of the text") << "glm::vec3 eye = glm::vec3(3, 2, 5);\nglm::vec3 up = {0, 1, 0};\n"
                                         "glm::lookAt(eye, glm::vec3(0, 0.5, 0), up)"
                                      << view();
    }

    void viewsAreRead()
    {
        QFETCH(QString, text);
        QFETCH(glm::dmat4, expected);
        const PastedCalls calls = read(text);
        QVERIFY(calls.parts.view && !calls.parts.projection);
        const glm::dmat4 matrix = meantMatrix(*calls.parts.view, orderOf(calls.parts.view->form));
        QVERIFY2(difference(matrix, expected) <= 1e-12, qPrintable(QString::number(difference(matrix, expected))));
        const PastedCamera camera = pasted(text.toStdString());
        QVERIFY(!camera.projection && camera.eyeFromWorld == std::optional(matrix));
    }

    void argumentsAreRead_data()
    {
        addColumn<QString>("angle"); // of gluPerspective, whose fovy is 45
        for (const char *text :
             {"45", "+45.", "4.5e1", "90 / 2", "-(-45)", "15 * 3", "30 + 15", "(GLdouble)45", "45.0f", "float(45)",
              "static_cast<double>(45)", "degrees(M_PI / 4)", "fovy /* of the lens */", "fovy // of the lens\n",
              "2 * atan(tan(M_PI_4 / 2)) * 180 / M_PI", "60.f - 15.f"})
            newRow(text) << QString::fromLatin1(text);
    }

    void argumentsAreRead()
    {
        QFETCH(QString, angle);
        const PastedCalls calls = read("const double fovy = 45.0;\n// gluPerspective(1, 2, 3, 4);\ngluPerspective("
                                       + angle + ", 4.0 / 3, 1e-1, 1.0e2);");
        QVERIFY(calls.parts.projection);
        const glm::dmat4 matrix = meantMatrix(*calls.parts.projection, NumberOrder::ByColumns);
        QVERIFY2(difference(matrix, perspective()) <= 1e-12,
                 qPrintable(QString::number(difference(matrix, perspective()))));
    }

    void whatIsAssumedIsReported_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("said");
        newRow("degrees") << "gluPerspective(45, 1.5, 0.1, 100)"
                          << "gluPerspective: fovy 45°, aspect 1.5, near 0.1, far 100";
        newRow("radians") << "glm::perspective(0.7853981633974483, 1.5, 0.1, 100.0)"
                          << "glm::perspective: fovy 45°, aspect 1.5, near 0.1, far 100";
        newRow("another range of depths") << "XMMatrixPerspectiveFovRH(XM_PIDIV4, 1.5f, 0.1f, 100.f)"
                                          << "XMMatrixPerspectiveFovRH: fovy 45°, aspect 1.5, near 0.1, far "
                                             "100; right-handed, NDC depths from 0 to 1";
        newRow("left-handed") << "XMMatrixPerspectiveLH(2, 2, 1, 9)"
                              << "XMMatrixPerspectiveLH: left -1, right 1, bottom -1, top 1, near 1, far 9; "
                                 "left-handed, NDC depths from 0 to 1";
        newRow("radians for degrees") << "gluPerspective(0.7853981633974483, 1.5, 0.1, 100)"
                                      << "gluPerspective: fovy 0.7854°, aspect 1.5, near 0.1, far 100. The angle is "
                                         "in degrees: 0.7854 would be 45° if it were in radians";
        newRow("whole numbers") << "gluPerspective(45, 800 / 600, 0.1, 100)"
                                << "gluPerspective: fovy 45°, aspect 1.3333, near 0.1, far 100. 800 / 600 is read "
                                   "as 1.3333; in C, C++ and C# it is 1, as long as no number of it has a point";
        newRow("whole numbers in JavaScript") << "new THREE.PerspectiveCamera(45, 800 / 600, 0.1, 100)"
                                              << "THREE.PerspectiveCamera: fovy 45°, aspect 1.3333, near 0.1, far 100";
        newRow("two of them") << "glOrtho(0, 2, 0, 2, 0, 2); glOrtho(0, 1, 0, 1, 0, 1);"
                              << "glOrtho: left 0, right 2, bottom 0, top 2, near 0, far 2. glOrtho follows and is "
                                 "ignored: one projection is read";
        newRow("set afterwards") << "const camera = new THREE.PerspectiveCamera(45, 1, 1, 9);\ncamera.aspect = 2;\n"
                                    "this.camera.fov = 50"
                                 << "THREE.PerspectiveCamera: fovy 50°, aspect 2, near 1, far 9";
        newRow("set to what is no number")
            << "const camera = new THREE.PerspectiveCamera(45, 1, 1, 9);\ncamera.aspect = innerWidth / innerHeight;"
            << "THREE.PerspectiveCamera: fovy 45°, aspect 1, near 1, far 9. camera.aspect is ignored: put its value "
               "into the call";
        newRow("Vulkan's y") << "proj = glm::perspective(0.7853981633974483, 1.5, 0.1, 10.0);\nproj[1][1]*=-1;"
                             << "glm::perspective: fovy 45°, aspect 1.5, near 0.1, far 10. [1][1] *= -1 is ignored: "
                                "the picture is the same";
        newRow("moved by other calls")
            << "gluLookAt(3, 2, 5, 0, 0.5, 0, 0, 1, 0); glTranslatef(0, 0, 1); glRotated(a, 0, 1, 0); glTranslatef(1, "
               "0, "
               "0);"
            << "gluLookAt: eye (3, 2, 5), center (0, 0.5, 0), up (0, 1, 0). glTranslatef is ignored: the view is read "
               "without it. glRotated is ignored: the view is read without it";
        newRow("turned otherwise") << "camera.position.set(0, 0, 5); camera.rotation.set(0, 1, 0); mesh.rotateX(1);"
                                   << "camera: eye (0, 0, 5), center (0, 0, 4), up (0, 1, 0). camera.rotation.set "
                                      "is ignored: the view is read without it";
        newRow("a view") << "gluLookAt(3, 2, 5, 0, 0.5, 0, 0, 1, 0)"
                         << "gluLookAt: eye (3, 2, 5), center (0, 0.5, 0), up (0, 1, 0)";
    }

    void whatIsAssumedIsReported()
    {
        QFETCH(QString, text);
        QFETCH(QString, said);
        const PastedCalls calls = read(text);
        const auto &part = calls.parts.projection ? calls.parts.projection : calls.parts.view;
        QVERIFY(part);
        QCOMPARE(QString::fromStdString(part->call), said);
    }

    void whatIsNoNumberIsNamed_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("message");
        newRow("a variable") << "gluPerspective(45.0, aspect, 0.1, 100)"
                             << "gluPerspective: the argument 'aspect' is not a number. Put its value there";
        newRow("a product of variables") << "glOrtho(-w / 2, w / 2, -1, 1, 0, 9)"
                                         << "glOrtho: the argument '-w / 2' is not a number. Put its value there";
        newRow("a variable with two values") << "a = 1.0\ngluPerspective(45.0, a, 0.1, 100)\na = 2.0"
                                             << "gluPerspective: the argument 'a' is not a number. Put its value there";
        newRow("a variable that hangs on itself")
            << "a = a + 1\ngluPerspective(45.0, a, 0.1, 100)"
            << "gluPerspective: the argument 'a' is not a number. Put its value there";
        newRow("a division by 0") << "gluPerspective(45, 1 / 0, 0.1, 100)"
                                  << "gluPerspective: the argument '1 / 0' is not a number. Put its value there";
        newRow("a vector") << "glm::lookAt(eye, glm::vec3(0), glm::vec3(0, 1, 0))"
                           << "glm::lookAt: the argument 'eye' is not a vector of numbers. Put three numbers there";
        newRow("a coordinate") << "camera.position.z = radius;\ncamera.lookAt(0, 0, 0);"
                               << "camera.position.z: the argument 'radius' is not a number. Put its value there";
        newRow("an argument too few") << "gluPerspective(45, 1.5, 0.1)"
                                      << "gluPerspective: 3 arguments found, 4 are needed";
        newRow("an unknown keyword")
            << "p.computeProjectionMatrixFOV(fov=60, ratio=1.5, nearVal=1, farVal=9)"
            << "p.computeProjectionMatrixFOV: the argument 'ratio' is not known. Use the names of the call's own "
               "arguments, or none";
        newRow("a keyword twice") << "gluPerspective(60, 1.5, fovy=1, zNear=9)"
                                  << "gluPerspective: the argument 'fovy' is given twice. Remove one of them";
        newRow("a keyword too few") << "p.computeProjectionMatrixFOV(farVal=9, fov=60, aspect=1.5)"
                                    << "p.computeProjectionMatrixFOV: 3 arguments found, 4 are needed";
        newRow("degrees for radians")
            << "glm::perspective(45.0f, 1.5f, 0.1f, 100.0f)"
            << "glm::perspective: the angle is in radians and must be smaller than pi. You entered 45";
        newRow("near 0") << "gluPerspective(45, 1.5, 0, 100)"
                         << "gluPerspective: near";
        newRow("far behind the eye") << "gluPerspective(45, 1.5, 1, -100)"
                                     << "gluPerspective: near is -100; it must be greater than 0 and smaller than far "
                                        "(1)";
        newRow("a flat window") << "glFrustum(1, 1, -1, 1, 1, 9)"
                                << "glFrustum: left";
        newRow("an eye in its center") << "gluLookAt(1, 2, 3, 1, 2, 3, 0, 1, 0)"
                                       << "gluLookAt: ";
        newRow("an empty viewport") << "glViewport(0, 0, 0, 600)"
                                    << "glViewport: ";
    }

    void whatIsNoNumberIsNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const PastedCamera camera = pasted(text.toStdString());
        QVERIFY(camera.fault);
        const QString reason = QString::fromStdString(camera.fault->message());
        QVERIFY2(message.endsWith(u' ') || message.count(u' ') == 1 ? reason.startsWith(message) : reason == message,
                 qPrintable(reason));
    }

    void textsWithoutCallsAreNotRead_data()
    {
        addColumn<QString>("text");
        newRow("a matrix") << "mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)";
        newRow("in a comment") << "// gluPerspective(45, 1, 1, 9)\n1 2 3";
        newRow("a name alone") << "gluPerspective";
        newRow("not closed") << "gluPerspective(45, 1, 1, 9";
        newRow("a camera that no call turns") << "camera.position.z = radius;\nrender(camera)";
        newRow("another library's") << "view.lookAt(a, b, c)";
        newRow("nothing") << "";
        newRow("brackets only") << ")))((([[[{{{";
    }

    void textsWithoutCallsAreNotRead()
    {
        QFETCH(QString, text);
        const auto calls = pastedCalls(text.toStdString());
        QVERIFY(calls && !calls->hasAny);
    }

    void onlyTheCameraOfThreeIsMoved()
    {
        const PastedCalls calls =
            read("const eye = new THREE.PerspectiveCamera(45, 1, 1, 9);\nmesh.position.set(7, 7, 7);\n"
                 "eye.position.set(0, 0, 5);\nsun.lookAt(3, 3, 3);\ncamera.position.set(8, 8, 8);");
        QVERIFY(calls.parts.view);
        QVERIFY(difference(meantMatrix(*calls.parts.view, NumberOrder::ByColumns),
                           glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -5)))
                <= 1e-15);
    }

    void oneTextFillsBothMatricesAndTheViewport()
    {
        const PastedCamera camera =
            pasted("glViewport(0, 0, 800, 600);\nglMatrixMode(GL_PROJECTION);\nglLoadIdentity();\n"
                   "gluPerspective(45.0, 800.0 / 600.0, 0.1, 100.0);\nglMatrixMode(GL_MODELVIEW);\n"
                   "gluLookAt(3, 2, 5, 0, 0.5, 0, 0, 1, 0);");
        QVERIFY(camera.projection && camera.eyeFromWorld);
        QVERIFY(difference(std::get<MatrixProjection>(*camera.projection).clipFromEye, perspective()) <= 1e-12);
        QVERIFY(difference(*camera.eyeFromWorld, view()) <= 1e-12);
        QVERIFY(camera.isViewportSet && camera.viewport == std::optional(Viewport{0, 0, 800, 600}));
        QVERIFY(camera.matrices[0].findings.empty() && camera.matrices[1].findings.empty());
    }

    void aWindowsSizeIsItsViewport_data()
    {
        addColumn<QString>("calls");
        newRow("GLUT") << "glViewport(0, 0, width, height);\nglutInitWindowSize(800, 600);";
        newRow("GLFW") << "glfwCreateWindow(800, 600, \"title\", NULL, NULL);";
        newRow("three.js") << "const W = 800;\nrenderer.setSize(W, 600);";
        newRow("another viewport")
            << "glfwCreateWindow(1024, 768, \"title\", NULL, NULL);\nglViewport(0, 0, 800, 600);";
    }

    void aWindowsSizeIsItsViewport()
    {
        QFETCH(QString, calls);
        const PastedCamera camera = pasted("gluPerspective(45.0, 800.0 / 600.0, 0.1, 100.0);\n"
                                           "gluLookAt(3, 2, 5, 0, 0.5, 0, 0, 1, 0);\n"
                                           + calls.toStdString());
        QVERIFY(camera.isViewportSet && camera.viewport == std::optional(Viewport{0, 0, 800, 600}));
    }

    void anAspectWithoutNumberIsThatOfTheSize()
    {
        const auto calls =
            pastedCalls("glViewport(0, 0, w, h);\ngluPerspective(45.0, float(w) / h, 0.1, 100.0);", 4.0 / 3.0);
        QVERIFY(calls && calls->parts.projection && !calls->parts.viewport);
        QVERIFY(difference(meantMatrix(*calls->parts.projection, NumberOrder::ByColumns), perspective()) <= 1e-12);
        QVERIFY(calls->parts.projection->call.ends_with(". The aspect float(w) / h is that of the size"));
    }

    void constantsAreArguments()
    {
        const PastedCamera camera = pasted(
            "#define W 800\nconst float H = 600;\nglm::perspective(glm::radians(45.f), float(W) / H, .1f, 100.f);");
        QVERIFY(camera.projection);
        QVERIFY(difference(std::get<MatrixProjection>(*camera.projection).clipFromEye, perspective()) <= 1e-7);
    }

    /// As PyBullet prints them.
    void numbersBesideNamedMatricesAreNamed()
    {
        const PastedCamera camera = pasted("camera pos:\n 2 0 1\ntarget pos:\n 0 0 0\n\n"
                                           "projection = [1, 0, 0, 0,  0, 1, 0, 0,  0, 0, -1.002, -1,  0, 0, -0.2, 0]\n"
                                           "view = [1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, -5, 1]");
        QVERIFY(camera.projection && camera.eyeFromWorld);
        QCOMPARE(camera.aside.size(), std::size_t{2});
    }

    void matricesMayStandBesideCalls()
    {
        const PastedCamera camera = pasted("int width = 800;\ngluPerspective(45.0, 4.0 / 3.0, 0.1, 100.0);\n"
                                           "view = [1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, -5, 1]");
        QVERIFY(camera.projection);
        QVERIFY(camera.eyeFromWorld == std::optional(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -5))));
    }

    /// A left-handed pair, as with pasted numbers: the window looks along -z, and one correction makes
    /// both matrices do so.
    void aLeftHandedPairIsTurned()
    {
        const std::string text =
            "XMMatrixPerspectiveFovLH(XM_PIDIV4, 800.0f / 600.0f, 0.1f, 100.0f);\n"
            "XMMatrixLookAtLH(XMVectorSet(3, 2, 5, 1), XMVectorSet(0, 0.5f, 0, 1), XMVectorSet(0, 1, 0, 0))";
        const PastedCamera before = pasted(text);
        const std::vector<MatrixFinding> &found = matrixOf(before, MatrixRole::Projection)->findings;
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(int(found[0].fault), int(MatrixFault::LeftHanded));
        PasteChoices choices;
        choices.corrections.push_back({MatrixRole::Projection, found[0]});
        const PastedCamera after = pasted(text, choices);
        const auto &lens = std::get<MatrixProjection>(*after.projection);
        const auto &lensBefore = std::get<MatrixProjection>(*before.projection);
        QVERIFY(difference(lens.clipFromEye * *after.eyeFromWorld, lensBefore.clipFromEye * *before.eyeFromWorld)
                <= 1e-12);
        const auto form = recognised(lens);
        QVERIFY(form && !form->looksAlongPlusZ);
    }

    void nestedBracketsAreNoTrouble_data()
    {
        addColumn<QString>("text");
        const int times = 30000;
        newRow("names") << QStringLiteral("a(").repeated(times) + QStringLiteral(")").repeated(times);
        newRow("an argument") << "gluPerspective(" + QStringLiteral("(").repeated(times)
                                     + QStringLiteral(")").repeated(times) + ", 1, 1, 9)";
        newRow("signs") << "glm::lookAt(" + QStringLiteral("-").repeated(times) + "a, b, c)";
        newRow("signs of a number") << "gluPerspective(" + QStringLiteral("-").repeated(times) + "1, 1, 1, 9)";
        newRow("not closed") << QStringLiteral("gluLookAt(").repeated(times / 4);
    }

    void nestedBracketsAreNoTrouble()
    {
        QFETCH(QString, text);
        const auto calls = pastedCalls(text.toStdString());
        QVERIFY(!calls || !calls->parts.projection);
    }
};

UNPROJECTOR_TEST(TestPastedCalls)
#include "test_pasted_calls.moc"
