// Matrices as other programs write them, and the program's findings on them.

#include "tests/core/cameras/fault_names.h"
#include "tests/support/test.h"

#include "core/cameras/pasted_matrix.h"
#include "core/geometry/view_matrix.h"
#include "core/pipeline/decomposition.h"
#include "core/pipeline/matrix_findings.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::cameras;
using namespace unprojector::pipeline;

namespace {

/// Row r, column c (from 0) holds 10 r + c + 1/2, the last row 0 0 0 1: no two entries are equal.
glm::dmat4 told()
{
    glm::dmat4 m(1.0);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 4; ++c)
            m[c][r] = 10.0 * r + c + 0.5;
    }
    return m;
}

glm::dmat4 read(const PastedMatrix &pasted)
{
    return matrixOf(pasted.numbers, orderOf(pasted.form));
}

glm::dmat4 perspective(double n, double f)
{
    return glm::perspective(glm::radians(50.0), 4.0 / 3.0, n, f);
}

glm::dmat4 zeroToOne(double n, double f)
{
    glm::dmat4 m = perspective(n, f);
    m[2][2] = -f / (f - n);
    m[3][2] = -f * n / (f - n);
    return m;
}

glm::dmat4 view()
{
    return glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0.0), glm::dvec3(0, 1, 0));
}

QStringList idsOf(const std::vector<MatrixFinding> &found)
{
    QStringList ids;
    for (const MatrixFinding &finding : found)
        ids << QString::fromStdString(std::string(idOf(finding.fault)));
    return ids;
}

/// The matrix as a program prints it with so many decimals.
glm::dmat4 rounded(const glm::dmat4 &matrix, int decimals)
{
    const double power = std::pow(10.0, decimals);
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i)
        m[i / 4][i % 4] = std::round(matrix[i / 4][i % 4] * power) / power;
    return m;
}

bool isClose(const glm::dmat4 &a, const glm::dmat4 &b)
{
    double off = 0.0;
    for (int i = 0; i < 16; ++i)
        off = std::max(off, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return off <= 1e-12;
}

/// The matrix printed with six digits and read back.
glm::dmat4 inSixDigits(glm::dmat4 m)
{
    for (int i = 0; i < 16; ++i)
        m[i / 4][i % 4] = QByteArray::number(m[i / 4][i % 4], 'g', 6).toDouble();
    return m;
}

} // namespace

Q_DECLARE_METATYPE(glm::dmat4)
Q_DECLARE_METATYPE(unprojector::cameras::MatrixForm)
Q_DECLARE_METATYPE(unprojector::pipeline::MatrixRole)

class TestPastedMatrices : public QObject {
    Q_OBJECT

private slots:
    void everyFormIsRead_data()
    {
        addColumn<QString>("text");
        addColumn<MatrixForm>("form");
        newRow("glm::to_string") << "dmat4x4((0.500000, 10.500000, 20.500000, 0.000000), (1.500000, 11.500000, "
                                    "21.500000, 0.000000), (2.500000, 12.500000, 22.500000, 0.000000), (3.500000, "
                                    "13.500000, 23.500000, 1.000000))"
                                 << MatrixForm::GlmColumns;
        newRow("GLM's constructor") << "const glm::mat4 m(0.5f, 10.5f, 20.5f, 0.f,\n 1.5f, 11.5f, 21.5f, 0.f,\n "
                                       "2.5f, 12.5f, 22.5f, 0.f,\n 3.5f, "
                                       "13.5f, 23.5f, 1.f);"
                                    << MatrixForm::GlmColumns;
        newRow("GLSL's vec4s") << "mat4(vec4(0.5, 10.5, 20.5, 0), vec4(1.5, 11.5, 21.5, 0), vec4(2.5, 12.5, 22.5, "
                                  "0), vec4(3.5, 13.5, 23.5, 1))"
                               << MatrixForm::GlmColumns;
        newRow("NumPy, printed") << "[[ 0.5  1.5  2.5  3.5]\n [10.5 11.5 12.5 13.5]\n [20.5 21.5 22.5 23.5]\n [ 0.   "
                                    "0.   0.   1. ]]"
                                 << MatrixForm::NestedRows;
        newRow("NumPy, repr") << "m = np.array([[0.5, 1.5, 2.5, 3.5],\n [1.05e+01, 11.5, 12.5, 13.5],\n [20.5, 21.5, "
                                 "22.5, 23.5],\n [0., 0., 0., 1.]], dtype=float32)"
                              << MatrixForm::NestedRows;
        newRow("JSON, nested")
            << "{\"view\": [[0.5,1.5,2.5,3.5],[10.5,11.5,12.5,13.5],[20.5,21.5,22.5,23.5],[0,0,0,1]]}"
            << MatrixForm::NestedRows;
        newRow("JSON, flat")
            << "\"view\": [0.5, 10.5, 20.5, 0,\n 1.5, 11.5, 21.5, 0,\n 2.5, 12.5, 22.5, 0,\n 3.5, 13.5, 23.5, 1]"
            << MatrixForm::Flat;
        newRow("three.js") << "{\"elements\":[0.5,10.5,20.5,0,1.5,11.5,21.5,0,2.5,12.5,22.5,0,3.5,13.5,23.5,1]}"
                           << MatrixForm::Flat;
        newRow("a Float32Array as JSON")
            << "{\"0\":0.5,\"1\":10.5,\"2\":20.5,\"3\":0,\"4\":1.5,\"5\":11.5,\"6\":21.5,\"7\":0,\"8\":2.5,\"9\":12.5,"
               "\"10\":22.5,\"11\":0,\"12\":3.5,\"13\":13.5,\"14\":23.5,\"15\":1}"
            << MatrixForm::Indexed;
        newRow("C array") << "float m[16] = {0.5f, 10.5f, 20.5f, 0, 1.5f, 11.5f, 21.5f, 0, 2.5f, 12.5f, 22.5f, "
                             "0, 3.5f, 13.5f, 23.5f, 1};"
                          << MatrixForm::Flat;
        newRow("C array of arrays") << "double m[4][4] = {{0.5, 1.5, 2.5, 3.5}, {10.5, 11.5, 12.5, 13.5}, {20.5, 21.5, "
                                       "22.5, 23.5}, {0, 0, 0, 1}};"
                                    << MatrixForm::NestedRows;
        QString listing, pairs, fields, columns;
        const glm::dmat4 m = told();
        for (int i = 15; i >= 0; --i) {
            listing += QString("m[%1] = %2;\n").arg(i).arg(m[i / 4][i % 4]);
            pairs += QString("m(%1, %2) = %3\n").arg(i % 4).arg(i / 4).arg(m[i / 4][i % 4]);
            columns += QString("m[%1][%2] = %3\n").arg(i / 4).arg(i % 4).arg(m[i / 4][i % 4]);
        }
        for (int i = 0; i < 16; ++i)
            fields += QString("M%1%2:%3 ").arg(i / 4 + 1).arg(i % 4 + 1).arg(m[i % 4][i / 4]);
        newRow("m[0..15], from behind") << listing << MatrixForm::Indexed;
        newRow("m[column][row]") << columns << MatrixForm::Indexed;
        newRow("m(row, column)") << pairs << MatrixForm::IndexPairs;
        newRow("M11 to M44") << fields << MatrixForm::IndexPairs;
        newRow("Eigen") << " 0.5  1.5  2.5  3.5\n10.5 11.5 12.5 13.5\n20.5 21.5 22.5 23.5\n   0    0    0    1"
                        << MatrixForm::RowLines;
        newRow("OpenCV") << "[0.5, 1.5, 2.5, 3.5;\n 10.5, 11.5, 12.5, 13.5;\n 20.5, 21.5, 22.5, 23.5;\n 0, 0, 0, 1]"
                         << MatrixForm::RowLines;
        newRow("QMatrix4x4") << "QMatrix4x4(type:Translation,Rotation2D\n 0.5 1.5 2.5 3.5\n 10.5 11.5 12.5 13.5\n "
                                "20.5 21.5 22.5 23.5\n 0 0 0 "
                                "1\n)"
                             << MatrixForm::RowLines;
        newRow("Blender") << "<Matrix 4x4 (0.5, 1.5, 2.5, 3.5)\n (10.5, 11.5, 12.5, 13.5)\n (20.5, 21.5, 22.5, 23.5)\n "
                             "(0.0, 0.0, 0.0, 1.0)>"
                          << MatrixForm::NestedRows;
    }

    void everyFormIsRead()
    {
        QFETCH(QString, text);
        QFETCH(MatrixForm, form);
        const auto pasted = pastedMatrix(text.toStdString());
        QVERIFY2(pasted, qPrintable(QString::number(pasted ? 0 : pasted.error().found)));
        QCOMPARE(int(pasted->form), int(form));
        QCOMPARE(read(*pasted), told());
    }

    /// A megabyte of prose on one line is read in linear time.
    void longLinesEnd()
    {
        std::string text;
        while (text.size() < 1000000)
            text += "abc ";
        const auto parts = pastedParts(text);
        QVERIFY(parts && !parts->modelView);
    }

    void whatIsNoMatrixIsRefused_data()
    {
        addColumn<QString>("text");
        addColumn<int>("found");
        addColumn<QString>("word");
        newRow("nothing") << "" << 0 << "";
        newRow("fifteen") << "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15" << 15 << "";
        newRow("commas without blanks, a number with a point")
            << "1,5,2,5,3,5,4,5,5,5,6,5,7,5,8,5,9.5,0,1,5,2,5,3,5,4,5,5,5,6,5" << 30 << "";
        newRow("a sign apart") << "1 2\n 3 - 5 6" << 0 << "-";
        newRow("infinity") << "1 2\n 3 -inf 5" << 0 << "-inf";
        for (const char *word : {"1.#QNAN0", "-1.#IND", "0x10", "1e400", "-1.0d0", "1.2.3"})
            newRow(word) << QStringLiteral("1 2\n 3 %1 5").arg(QLatin1String(word)) << 0 << word;
    }

    void whatIsNoMatrixIsRefused()
    {
        QFETCH(QString, text);
        QFETCH(int, found);
        QFETCH(QString, word);
        const auto pasted = pastedMatrix(text.toStdString());
        QVERIFY(!pasted);
        QCOMPARE(pasted.error().line > 0, !word.isEmpty());
        QCOMPARE(int(pasted.error().found), found);
        if (word.isEmpty())
            return;
        QVERIFY(QString::fromStdString(pasted.error().text).startsWith(u'"' + word + u'"'));
        QCOMPARE(std::pair(pasted.error().line, pasted.error().column), std::pair(std::size_t(2), std::size_t(4)));
    }

    void aSceneIsSortedByNames_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("parts");
        // The sign is U+2212.
        const QString m = QStringLiteral(" 1 0 0 0 0 1 0 0 0 0 1 0 0 0 \u22125 1\n"), v = " 0 0 400 300\n";
        newRow("nothing named") << m + m + v << "modelview projection";
        newRow("a product alone") << m + v << "product";
        newRow("MVP") << "MVP:" + m + "viewport" + v << "product";
        newRow("P * V, unnamed viewport") << "P * V =" + m.trimmed().replace(' ', ", ") + "\nviewport" + v << "product";
        newRow("OpenGL's names") << "GL_PROJECTION_MATRIX" + m + "GL_VIEWPORT" + v + "gl_ModelViewMatrix" + m
                                 << "modelview projection";
        newRow("view and model") << "projectionMatrix" + m + "model" + m + "viewMatrix" + m + "viewport" + v
                                 << "view model projection";
        newRow("three.js's names") << "camera.projectionMatrix" + m + "camera.matrixWorldInverse" + m + "viewport" + v
                                   << "view projection";
        newRow("all of them") << "view" + m + "projection" + m + "viewProjection" + m + "viewport" + v
                              << "view projection product";
    }

    void aSceneIsSortedByNames()
    {
        QFETCH(QString, text);
        QFETCH(QString, parts);
        const auto scene = pastedParts(text.toStdString());
        QVERIFY2(scene, scene ? "" : nameOf(scene.error().part));
        QStringList found;
        for (const auto &[name, matrix] : {std::pair("modelview", scene->modelView), std::pair("view", scene->view),
                                           std::pair("model", scene->model), std::pair("projection", scene->projection),
                                           std::pair("product", scene->product)}) {
            if (!matrix)
                continue;
            found << name;
            QCOMPARE(matrix->numbers[14], -5.0);
        }
        QCOMPARE(found.join(' '), parts);
        QVERIFY(scene->viewport == (Viewport{0.0, 0.0, 400.0, 300.0}));
    }

    void inversesAreReadAsSuch_data()
    {
        addColumn<QString>("name");
        addColumn<MatrixRole>("role");
        addColumn<bool>("isInverse");
        using enum MatrixRole;
        for (const char *name : {"projectionMatrixInverse", "gl_ProjectionMatrixInverse", "inverse(projection)",
                                 "invProj", "proj_inv", "eyeFromClip", "inverse(clipFromView)"})
            newRow(name) << QString::fromLatin1(name) << Projection << true;
        for (const char *name :
             {"viewInverse", "inverseView", "View_Inv", "camera.matrixWorld", "matrixWorld", "Camera.matrix_world",
              "cameraToWorldMatrix", "worldFromEye", "invview", "inv view", "view.inverted()"})
            newRow(name) << QString::fromLatin1(name) << View << true;
        for (const char *name : {"viewProjectionInverse", "inverse MVP", "worldFromClip"})
            newRow(name) << QString::fromLatin1(name) << Product << true;
        for (const char *name : {"camera.matrixWorldInverse", "worldToCameraMatrix", "viewMatrix", "involved view",
                                 "inventor view", "inverse(worldFromEye)"})
            newRow(name) << QString::fromLatin1(name) << View << false;
        // The name of its object doesn't change the meaning of a name.
        for (const char *object :
             {"cam.", "camera.", "Camera.main.", "self.cam_", "mainCam.", "world.", "modelCam.", "Matrix4x4 cam."}) {
            for (const char *name : {"worldToCameraMatrix", "worldToCamera", "world_to_camera", "world2cam",
                                     "cameraFromWorld", "worldToView"})
                addRow("%s%s", object, name) << QString::fromLatin1(object) + name << View << false;
            for (const char *name : {"cameraToWorldMatrix", "cameraToWorld", "camera_to_world", "cam2world",
                                     "worldFromCamera", "viewToWorld"})
                addRow("%s%s", object, name) << QString::fromLatin1(object) + name << View << true;
        }
        newRow("cam_world") << QStringLiteral("cam_world") << View << true;
        for (const char *name : {"cam.viewProj", "self.viewProjection", "cam.clipFromWorld", "camera.mvp"})
            newRow(name) << QString::fromLatin1(name) << Product << false;
        for (const char *name : {"cam.proj", "self.projectionMatrix", "viewCamera.projection"})
            newRow(name) << QString::fromLatin1(name) << Projection << false;
        for (const char *name : {"inverse depth projection", "inverse-z projection", "invDepthProjection",
                                 "clipFromView", "viewToClip", "clipFromEye", "eyeToClip"})
            newRow(name) << QString::fromLatin1(name) << Projection << false;
    }

    void inversesAreReadAsSuch()
    {
        QFETCH(QString, name);
        QFETCH(MatrixRole, role);
        QFETCH(bool, isInverse);
        const QString shift = QStringLiteral(" 1 0 0 0 0 1 0 0 0 0 1 0 0 0 7 1\n");
        const auto parts = pastedParts((name + shift).toStdString());
        QVERIFY(parts);
        const auto &matrix = role == MatrixRole::View         ? parts->view
                             : role == MatrixRole::Projection ? parts->projection
                                                              : parts->product;
        QVERIFY(matrix);
        QCOMPARE(matrix->isInverse, isInverse);
        QCOMPARE(meantMatrix(*matrix, NumberOrder::ByColumns)[3][2], isInverse ? -7.0 : 7.0);
        // The matrix itself is preferred to its inverse, at any position.
        const QString own = role == MatrixRole::View         ? QStringLiteral("view")
                            : role == MatrixRole::Projection ? QStringLiteral("projection")
                                                             : QStringLiteral("mvp");
        if (!isInverse)
            return;
        const auto both = pastedParts((name + shift + own + QString(shift).replace('7', '9')).toStdString());
        QVERIFY(both);
        const auto &first = role == MatrixRole::View         ? both->view
                            : role == MatrixRole::Projection ? both->projection
                                                             : both->product;
        QVERIFY(first && !first->isInverse);
        QCOMPARE(first->numbers[14], 9.0);
        QCOMPARE(both->inversesLeft.size(), std::size_t(1));
    }

    void rangesAreThoseOfAWindow()
    {
        const auto rangeOf = [](double scale, double shift) {
            glm::dmat4 m(1.0);
            m[2][2] = scale;
            m[3][2] = shift;
            return viewportOf(m, {}).depthRange;
        };
        QVERIFY(rangeOf(0.25, 0.75) == (DepthRange{0.5, 1.0}));
        QVERIFY(rangeOf(0.8, 0.2) == (DepthRange{0.2, 1.0}));  // by [0, 1]: by [-1, 1] it would begin at -0.6
        QVERIFY(rangeOf(1.5, 0.5) == (DepthRange{-1.0, 2.0})); // no window's by either: OpenGL's way
    }

    void faultsAreFound_data()
    {
        addColumn<glm::dmat4>("matrix");
        addColumn<MatrixRole>("role");
        addColumn<QString>("ids");
        const glm::dmat4 p = perspective(0.1, 100.0), v = view(), d = zeroToOne(0.1, 100.0);
        glm::dmat4 turned = p, mirrored = p, infinite = p, reversed = d, scaled = v, leftHanded = p;
        for (int c = 0; c < 4; ++c) {
            turned[c][1] = -turned[c][1];
            mirrored[c][0] = -mirrored[c][0];
            leftHanded[2][c] = -leftHanded[2][c];
        }
        infinite[2][2] = -1.0;
        infinite[3][2] = -0.2;
        reversed[2][2] = 0.0;
        reversed[3][2] = 0.1;
        for (int c = 0; c < 3; ++c)
            scaled[c] *= 2.0;
        const glm::dmat4 box = glm::ortho(-3.0, 3.0, -2.0, 2.0, 1.0, 50.0);
        using enum MatrixRole;
        newRow("a perspective by rows") << glm::transpose(p) << Projection << "transposed";
        newRow("the same, near 2") << glm::transpose(perspective(2.0, 100.0)) << Projection << "transposed";
        newRow("a box by rows") << glm::transpose(box) << Projection << "transposed";
        newRow("a perspective's inverse") << glm::inverse(p) << Projection << "inverse";
        newRow("its transposed inverse") << glm::transpose(glm::inverse(p)) << Projection << "transposed inverse";
        newRow("a view for the projection") << v << Projection << "exchanged";
        newRow("a product for the projection") << p * v << Projection << "unknown-form";
        newRow("[0, 1]") << d << Projection << "depth-zero-to-one";
        newRow("[0, 1] in six digits") << inSixDigits(d) << Projection << "depth-zero-to-one";
        newRow("reversed, far at infinity")
            << reversed << Projection << "depth-zero-to-one depth-reversed far-at-infinity";
        newRow("far at infinity") << infinite << Projection << "far-at-infinity";
        newRow("Vulkan's y") << turned << Projection << "y-down";
        newRow("mirrored") << mirrored << Projection << "mirrored";
        newRow("along +z") << leftHanded << Projection << "left-handed";
        newRow("a view by rows") << glm::transpose(v) << View << "transposed";
        newRow("a projection for the view") << p << View << "exchanged";
        newRow("a scaled view") << scaled << View << "scaled";
        newRow("an unevenly scaled view") << v * glm::scale(glm::dmat4(1.0), glm::dvec3(1, 2, 1)) << View << "scaled";
        newRow("a mirrored view") << v * glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1)) << View << "mirrored";
        newRow("a camera's own matrix") << glm::inverse(v) << View << "inverse";
        newRow("a view in five decimals") << rounded(v, 5) << View << "rounded";
        newRow("a view in four decimals") << rounded(v, 4) << View << "rounded";
        newRow("a view in three decimals") << rounded(v, 3) << View << "rounded";
        newRow("a scale of 1.01 is no rounding") << glm::scale(glm::dmat4(1.0), glm::dvec3(1.01)) << View << "scaled";
        newRow("a negated projection") << -p << Projection << "negated";
        newRow("a negated view") << -v << View << "negated";
        newRow("a negated product") << -(p * v) << Product << "negated";
        newRow("a box's product") << box * v << Product << "";
        newRow("a product in four decimals") << rounded(p * v, 4) << Product << "";
        newRow("a product by rows") << glm::transpose(p * v) << Product << "transposed";
        newRow("a product's inverse") << glm::inverse(p * v) << Product << "inverse";
        newRow("a product in [0, 1]") << d * v << Product << "depth-zero-to-one";
        newRow("a product for Vulkan") << turned * v << Product << "y-down";
    }

    void faultsAreFound()
    {
        QFETCH(glm::dmat4, matrix);
        QFETCH(MatrixRole, role);
        QFETCH(QString, ids);
        const auto clipFromEye =
            role == MatrixRole::View ? std::optional(perspective(0.1, 100.0)) : std::optional<glm::dmat4>();
        QCOMPARE(idsOf(findings(matrix, role, std::nullopt, clipFromEye)).join(' '), ids);
        if (ids == "inverse")
            QCOMPARE(idsOf(findings(matrix, role)).join(' '), ids);
    }

    void rightMatricesHaveNone_data()
    {
        addColumn<glm::dmat4>("projection");
        addColumn<glm::dmat4>("view");
        for (const double n : {0.01, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0}) {
            for (const double f : {20.0, 100.0, 1000.0})
                addRow("near %g, far %g", n, f) << perspective(n, f) << view();
        }
        newRow("near 5, far 80000") << perspective(5.0, 80000.0) << view();
        newRow("off-centre") << glm::frustum(-0.1, 0.3, -0.05, 0.1, 0.1, 10.0) << view();
        newRow("a box") << glm::ortho(-3.0, 4.0, -2.0, 2.0, 1.0, 50.0) << view();
        newRow("the identity") << perspective(1.0, 10.0) << glm::dmat4(1.0);
        newRow("from behind") << perspective(0.1, 100.0)
                              << glm::lookAt(glm::dvec3(-3, 2, -5), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1));
    }

    void rightMatricesHaveNone()
    {
        QFETCH(glm::dmat4, projection);
        QFETCH(glm::dmat4, view);
        QCOMPARE(idsOf(findings(projection, MatrixRole::Projection)), QStringList());
        QCOMPARE(idsOf(findings(inSixDigits(projection), MatrixRole::Projection)), QStringList());
        QCOMPARE(idsOf(findings(view, MatrixRole::View, std::nullopt, projection)), QStringList());
        QCOMPARE(idsOf(findings(inSixDigits(view), MatrixRole::View, std::nullopt, projection)), QStringList());
        QCOMPARE(idsOf(findings(projection * view, MatrixRole::Product)), QStringList());
    }

    void repairsGiveTheMatrixBack()
    {
        const glm::dmat4 p = perspective(0.1, 100.0), v = view();
        glm::dmat4 turned = p, scaled = v;
        for (int c = 0; c < 4; ++c)
            turned[c][1] = -turned[c][1];
        for (int c = 0; c < 3; ++c)
            scaled[c] *= 2.0;
        const auto once = [](const glm::dmat4 &m, MatrixRole role) { return repaired(m, findings(m, role).at(0)); };
        QVERIFY(isClose(once(glm::transpose(p), MatrixRole::Projection), p));
        QVERIFY(isClose(once(glm::inverse(p), MatrixRole::Projection), p));
        QVERIFY(isClose(once(turned, MatrixRole::Projection), p));
        QVERIFY(isClose(once(glm::transpose(v), MatrixRole::View), v));
        QVERIFY(isClose(once(glm::inverse(v), MatrixRole::View), v));
        QVERIFY(isClose(once(scaled, MatrixRole::View), v));
        QVERIFY(isClose(once(-p, MatrixRole::Projection), p));
        QVERIFY(isClose(once(-(p * v), MatrixRole::Product), p * v));
        for (const int decimals : {5, 4, 3}) {
            const glm::dmat4 printed = rounded(v, decimals), mended = once(printed, MatrixRole::View);
            QVERIFY(axesOff(mended) && *axesOff(mended) <= 1e-14);
            for (int i = 0; i < 16; ++i)
                QVERIFY(std::abs(mended[i / 4][i % 4] - printed[i / 4][i % 4]) <= std::pow(10.0, -decimals));
        }
        // Turning the eye leaves the product, whichever way the axes are.
        for (const double z : {1.0, -1.0}) {
            const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1)),
                             spun = glm::scale(glm::dmat4(1.0), glm::dvec3(1, z, -1));
            glm::dmat4 clipFromEye = p * mirror, eyeFromWorld = spun * v;
            const glm::dmat4 product = clipFromEye * eyeFromWorld;
            turnEye(clipFromEye, eyeFromWorld);
            QVERIFY(isClose(clipFromEye * eyeFromWorld, product));
            QCOMPARE(idsOf(findings(clipFromEye, MatrixRole::Projection)).contains("left-handed"), false);
            QVERIFY(glm::determinant(eyeFromWorld) > 0.0);
        }
    }

    void productsAreTakenApart_data()
    {
        addColumn<glm::dmat4>("projection");
        addColumn<glm::dmat4>("view");
        glm::dmat4 turned = perspective(0.1, 100.0), infinite = turned;
        for (int c = 0; c < 4; ++c)
            turned[c][1] = -turned[c][1];
        infinite[2][2] = -1.0;
        infinite[3][2] = -0.2;
        newRow("gluPerspective") << perspective(0.1, 100.0) << view();
        newRow("off-centre") << glm::frustum(-0.1, 0.3, -0.05, 0.1, 0.1, 10.0) << view();
        newRow("Vulkan's") << turned << view();
        newRow("far at infinity") << infinite << view();
    }

    void productsAreTakenApart()
    {
        QFETCH(glm::dmat4, projection);
        QFETCH(glm::dmat4, view);
        for (const double scale : {1.0, 2.5}) {
            const auto apart = decomposed(projection * view * scale);
            QVERIFY(apart);
            QVERIFY(isClose(apart->clipFromEye, projection));
            QVERIFY(isClose(apart->eyeFromWorld, view));
            QVERIFY(apart->residual <= 1e-14);
        }
        const auto printed = decomposed(inSixDigits(projection * view));
        QVERIFY(printed);
        QVERIFY(printed->residual > 1e-9 && printed->residual <= 1e-4);
        // The eye of a box is put on its near plane.
        const glm::dmat4 box = glm::ortho(-3.0, 3.0, -2.0, 2.0, 1.0, 50.0);
        glm::dmat4 sheared(1.0);
        sheared[2][0] = 0.5;
        const auto ofBox = decomposed(box * view * 2.0);
        QVERIFY(ofBox && ofBox->isBox && axesOff(ofBox->eyeFromWorld));
        QVERIFY(isClose(ofBox->clipFromEye, glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.0, 49.0)));
        QVERIFY(isClose(ofBox->clipFromEye * ofBox->eyeFromWorld, box * view));
        QVERIFY(!decomposed(box * sheared * view));
        // A last decimal leaves as much, for any w.
        glm::dmat4 rounded = box * view * 0.3;
        for (int i = 0; i < 16; ++i)
            rounded[i / 4][i % 4] = std::round(rounded[i / 4][i % 4] * 1e3) / 1e3;
        QVERIFY(decomposed(rounded));
    }

    void everyFindingIsASentence()
    {
        QStringList sentences;
        for (int fault = 0; fault <= int(MatrixFault::Scaled); ++fault) {
            const MatrixFinding finding{MatrixFault(fault), MatrixRepair::None, 0.1};
            for (const MatrixRole role : {MatrixRole::View, MatrixRole::Projection})
                sentences << QString::fromStdString(findingText(finding, role));
            QVERIFY(!idOf(finding.fault).empty());
        }
        QVERIFY(std::all_of(sentences.begin(), sentences.end(), [](const QString &s) { return s.size() > 8; }));
    }
};

UNPROJECTOR_TEST(TestPastedMatrices)
#include "test_pasted_matrices.moc"
