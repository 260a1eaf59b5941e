// `unproject scene --from-matrices`, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <cmath>

namespace {

// gluLookAt(0,0,5, 0,0,0, 0,1,0) and glFrustum(-1,1,-1,1,1,3), as glGetDoublev gives them.
const QByteArray kModelview = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1";
const QByteArray kProjection = "1 0 0 0  0 1 0 0  0 0 -2 -1  0 0 -3 0";
const QByteArray kViewport = "0 0 400 300";

} // namespace

class TestSceneCommand : public QObject {
    Q_OBJECT

private slots:
    void everyWayToPasteGivesTheSameScene_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("order");
        QTest::newRow("in order") << kModelview + ' ' + kProjection + ' ' + kViewport << "column";
        QTest::newRow("named, in another order")
            << "Viewport: " + kViewport + "\nPROJECTION_MATRIX = " + kProjection + "\nmodelview\n" + kModelview
            << "column";
        QTest::newRow("brackets and commas")
            << QByteArray("modelview [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,-5,1]]\nprojection "
                          "{1.0f, 0.0f, 0.f, 0, 0, +1.0f, 0, 0, 0, 0, -2e0f, -1, 0, 0, -3, "
                          "0};\r\nviewport (0, 0, 400, 300)")
            << "column";
        QTest::newRow("row by row") << QByteArray(
            "1 0 0 0\n0 1 0 0\n0 0 1 -5\n0 0 0 1\n\n1 0 0 0\n0 1 0 0\n0 0 -2 -3\n0 0 -1 0\n"
            "\n0 0 400 300\n") << "row";
    }

    void everyWayToPasteGivesTheSameScene()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, order);
        const Run expected = runCommand(
            {"scene", "--from-matrices", QString::fromUtf8(kModelview + ' ' + kProjection + ' ' + kViewport)});
        QCOMPARE(expected.exitCode, 0);
        const Run argument = runCommand({"scene", "--order", order, "--from-matrices", QString::fromUtf8(text)});
        const Run file = runCommand({"scene", "--order", order, "--from-matrices", m_folder.write("m.txt", text)});
        const Run stream = runCommand({"scene", "--order", order, "--from-matrices", "-"}, text);
        for (const Run &run : {argument, file, stream}) {
            QCOMPARE(run.errors, QByteArray());
            QCOMPARE(run.exitCode, 0);
            QCOMPARE(run.output, expected.output);
        }
    }

    void theSceneUnprojects()
    {
        const Run scene =
            runCommand({"scene", "--from-matrices", "-"}, kModelview + ' ' + kProjection + ' ' + kViewport);
        const QString file = m_folder.write("scene.json", scene.output);
        const Run points = runCommand({"points", file}, "px,py,depth\n0,0,0\n400,300,1\n");
        QCOMPARE(points.errors, QByteArray());
        const QList<QList<double>> expected{{-1, 1, 4}, {3, -3, 2}};
        for (int row = 0; row < 2; ++row) {
            const QList<QByteArray> cells = points.lines().at(row + 1).split(',');
            for (int k = 0; k < 3; ++k) {
                QVERIFY2(std::abs(cells[3 + k].toDouble() - expected[row][k]) <= 1e-14, points.output.constData());
                QVERIFY2(std::abs(cells[6 + k].toDouble() - expected[row][k]) <= 1e-13, points.output.constData());
            }
        }
    }

    void matricesComeBackAsTheyWere()
    {
        const Run scene =
            runCommand({"scene", "--from-matrices", "-"}, kModelview + ' ' + kProjection + ' ' + kViewport);
        const Run matrices = runCommand({"matrices", "--format", "json", m_folder.write("scene.json", scene.output)});
        QVERIFY2(matrices.output.contains("\"view\": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -5], [0, 0, 0, 1]]"),
                 matrices.output.constData());
        QVERIFY(
            matrices.output.contains("\"projection\": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -2, -3], [0, 0, -1, 0]]"));
    }

    void whatMatricesPrintsIsTaken_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QString>("conventions");
        const auto add = [](const char *format, const char *conventions) {
            QTest::addRow("%s, %s", format, conventions) << format << conventions;
        };
        for (const char *format : {"text", "c", "numpy", "json", "latex"}) {
            add(format, "opengl");
            add(format, "direct3d");
        }
        // All conventions but OpenCV's, which are R, t and K.
        for (const char *conventions : {"vulkan", "metal", "webgpu", "threejs", "unity", "opencascade"})
            add("text", conventions);
    }

    void whatMatricesPrintsIsTaken()
    {
        QFETCH(QString, format);
        QFETCH(QString, conventions);
        // Depths from 0.3 to 1.
        const QByteArray numbers = "modelview 0.8 0 0.6 0  0 1 0 0  -0.6 0 0.8 0  1e-9 0 -5 1 projection " + kProjection
                                   + " viewport 200 0 0 0  0 150 0 0  0 0 0.35 0  210 170 0.65 1";
        const QByteArray none = R"("objects": [])",
                         two = "\"objects\": [{\"name\": \"a\", \"bundled\": \"cube\"}, {\"name\": \"face (2)\", "
                               "\"bundled\": \"cube\"}, {\"name\": \"[3 f\", \"bundled\": \"cube\"}]";
        const Run scene = runCommand({"scene", "--window", "500x400", "--from-matrices", "-"}, numbers);
        QCOMPARE(scene.exitCode, 0);
        QByteArray withObjects = scene.output;
        QVERIFY(withObjects.contains(none));
        withObjects.replace(none, two);
        const QString points = "px,py,depth\n20,90,0.3\n400,300,0.75\n";
        const auto unprojected = [&](const QByteArray &text) {
            QList<double> world;
            for (const QByteArray &line :
                 runCommand({"points", m_folder.write("taken.json", text)}, points.toUtf8()).lines().mid(1)) {
                for (const QByteArray &cell : line.split(',').mid(0, 9))
                    world << cell.toDouble();
            }
            return world;
        };
        const QList<double> expected = unprojected(scene.output);
        QCOMPARE(expected.size(), 18);
        for (const QByteArray &text : {scene.output, withObjects}) {
            const Run matrices = runCommand(
                {"matrices", "--format", format, "--conventions", conventions, m_folder.write("printed.json", text)});
            QCOMPARE(matrices.exitCode, 0);
            const Run again =
                runCommand({"scene", "--conventions", conventions, "--window", "500x400", "--from-matrices", "-"},
                           matrices.output);
            QVERIFY2(again.errors.contains("product: ignored"), again.errors.constData());
            const QList<double> found = unprojected(again.output);
            QCOMPARE(found.size(), expected.size());
            for (qsizetype i = 0; i < found.size(); ++i)
                QVERIFY2(std::abs(found[i] - expected[i]) <= 1e-12, again.output.constData());
            QVERIFY(again.output.contains("\"viewport\": {\"x\": 10, \"y\": 20, \"width\": 400, \"height\": 300}"));
        }
        // The default conventions give the same, to the last digit.
        const Run plain = runCommand({"matrices", "--format", format, m_folder.write("plain.json", withObjects)});
        QCOMPARE(runCommand({"scene", "--window", "500x400", "--from-matrices", "-"}, plain.output).output,
                 scene.output);
    }

    void aViewportFromTheTopIsTurned()
    {
        // x 10, y 30 from the top, 400 x 300.
        const QByteArray viewport = "viewport 200 0 0 0  0 -150 0 0  0 0 1 0  210 180 0 1 ";
        const QByteArray text =
            viewport + "view " + kModelview + " projection 1 0 0 0  0 1 0 0  0 0 -1.5 -1  0 0 -1.5 0";
        const Run alone = runCommand({"scene", "--conventions", "metal", "--from-matrices", "-"}, text);
        QVERIFY(alone.errors.contains("the window is assumed to end with the viewport, at 410x330"));
        const Run scene =
            runCommand({"scene", "--conventions", "metal", "--window", "500x400", "--from-matrices", "-"}, text);
        QCOMPARE(scene.errors, QByteArray());
        // The near plane's top left corner, 30 pixels from the top.
        for (const Run &run : {alone, scene}) {
            const Run points = runCommand({"points", "--method", "formula", m_folder.write("top.json", run.output)},
                                          "px,py,depth\n10,30,0\n");
            QVERIFY2(points.output.endsWith("\n10,30,0,-1,1,4\n"), points.output.constData());
        }
        const Run unsaid = runCommand({"scene", "--from-matrices", "-"}, text);
        QCOMPARE(unsaid.exitCode, 2);
        QVERIFY2(unsaid.errors.contains("for pixels counted from the top: give its --conventions"), unsaid.errors);
    }

    void viewportsAreReadAsTheyArePrinted_data()
    {
        QTest::addColumn<QByteArray>("viewport");
        QTest::newRow("QRect") << QByteArray("QRect(0,0 400x300)");
        QTest::newRow("QRectF, named") << QByteArray("viewport QRectF(0,0 400x300)");
        QTest::newRow("glm::vec4") << QByteArray("viewport vec4(0.000000, 0.000000, 400.000000, 300.000000)");
        QTest::newRow("three.js") << QByteArray(R"(viewport: {"x": 0, "y": 0, "z": 400, "w": 300})");
        QTest::newRow("its matrix") << QByteArray("viewport 200 0 0 0  0 150 0 0  0 0 0.5 0  200 150 0.5 1");
    }

    void viewportsAreReadAsTheyArePrinted()
    {
        QFETCH(QByteArray, viewport);
        const QByteArray matrices = "modelview " + kModelview + " projection " + kProjection + ' ';
        const Run expected = runCommand({"scene", "--from-matrices", "-"}, matrices + "viewport " + kViewport);
        const Run run = runCommand({"scene", "--from-matrices", "-"}, matrices + viewport);
        QCOMPARE(run.errors, QByteArray());
        QCOMPARE(run.output, expected.output);
    }

    void fileAndWindow()
    {
        const QString output = m_folder.path("made.json");
        const Run run = runCommand({"scene", "--from-matrices", "-", "--window", "500x400", "-o", output},
                                   kModelview + ' ' + kProjection + ' ' + kViewport);
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.output, QByteArray());
        // The viewport's bottom left corner is the window's: 400 pixels down.
        const Run points = runCommand({"points", "--method", "formula", output}, "px,py,depth\n0,400,0\n");
        QVERIFY2(points.output.endsWith("\n0,400,0,-1,-1,4\n"), points.output.constData());
    }

    void whatIsToBeSeenOfAMatrixIsSaid_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("said");
        // glFrustum(-1,1,-1,1,0.1,100), with depths in [0, 1] and y reversed for Vulkan.
        const QByteArray zeroToOne = "projection 0.1 0 0 0  0 0.1 0 0  0 0 -1.001001 -1  0 0 -0.1001001 0 ";
        const QByteArray turned = "projection 1 0 0 0  0 -1 0 0  0 0 -2 -1  0 0 -3 0 ";
        const QByteArray reversed = "projection 1 0 0 0  0 1 0 0  0 0 0 -1  0 0 0.5 0 ";
        const QByteArray rest = "modelview " + kModelview + " viewport " + kViewport;
        const QByteArray none;
        QTest::newRow("Eigen's rows need no word") << QByteArray("modelview\n1 0 0 0\n0 1 0 0\n0 0 1 -5\n0 0 0 1\n")
                                                          + "projection " + kProjection + " viewport " + kViewport
                                                   << QStringList() << none;
        QTest::newRow("rows taken for columns")
            << "modelview 1 0 0 0  0 1 0 0  0 0 1 -5  0 0 0 1 projection " + kProjection + " viewport " + kViewport
            << QStringList()
            << QByteArray(
                   "stdin: modelview: is read in the order, by rows or by columns, that makes 0 0 0 1 its last row; "
                   "read by rows, --order "
                   "column reads it by columns\n");
        QTest::newRow("rows taken for columns, as asked for")
            << "modelview 1 0 0 0  0 1 0 0  0 0 1 -5  0 0 0 1 projection " + kProjection + " viewport " + kViewport
            << QStringList{"--order", "column"}
            << QByteArray("stdin: modelview: looks transposed: its last column, not its last row, is 0 0 0 1; read by "
                          "columns, --order row reads it by rows\n");
        QTest::newRow("[0, 1]") << zeroToOne + rest << QStringList()
                                << QByteArray(
                                       "stdin: projection: seems to use NDC depths from 0 to 1 (Direct3D, Vulkan): "
                                       "near is then 0.1; it is read with depths from -1 to 1, near 0.050025; "
                                       "--depth zero-to-one reads it so, --depth minus-one-to-one does not\n");
        QTest::newRow("[0, 1], asked for") << zeroToOne + rest << QStringList{"--depth", "zero-to-one"} << none;
        QTest::newRow("[-1, 1], asked for") << zeroToOne + rest << QStringList{"--depth", "minus-one-to-one"} << none;
        QTest::newRow("Vulkan's y") << turned + rest << QStringList()
                                    << QByteArray(
                                           "stdin: projection: flips y, as is done for Vulkan: the view is upside "
                                           "down in OpenGL; --y down flips it back, --y up keeps it\n");
        QTest::newRow("Vulkan's y, turned back") << turned + rest << QStringList{"--y", "down"} << none;
        QTest::newRow("Vulkan's y, left") << turned + rest << QStringList{"--y", "up"} << none;
        QTest::newRow("four decimals")
            << "projection " + kProjection
                   + " modelview 0.7071 0 0.7071 0  0 1 0 0  -0.7071 0 0.7071 0  0 0 -5 1 viewport " + kViewport
            << QStringList()
            << QByteArray(
                   "stdin: modelview: has axes that deviate by 1.9e-05 from perpendicular and length 1, as after "
                   "rounding or many rotations; the formulas need 0.00001; give more decimals; --orthonormal uses "
                   "the nearest axes that are\n");
        QTest::newRow("full digits, yet not quite rigid")
            << "projection " + kProjection + " modelview 1.0000123456789 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1 viewport "
                   + kViewport
            << QStringList()
            << QByteArray(
                   "stdin: modelview: has axes that deviate by 2.5e-05 from perpendicular and length 1, as after "
                   "rounding or many rotations; the formulas need 0.00001; give more decimals; --orthonormal uses "
                   "the nearest axes that are\n");
        QTest::newRow("full digits, mended")
            << "projection " + kProjection + " modelview 1.0000123456789 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1 viewport "
                   + kViewport
            << QStringList("--orthonormal") << QByteArray();
        QTest::newRow("four decimals, mended")
            << "projection " + kProjection
                   + " modelview 0.7071 0 0.7071 0  0 1 0 0  -0.7071 0 0.7071 0  0 0 -5 1 viewport " + kViewport
            << QStringList{"--orthonormal"} << none;
        QTest::newRow("four decimals, mended, mirrored")
            << "projection " + kProjection
                   + " modelview -0.7071 0 0.7071 0  0 1 0 0  0.7071 0 0.7071 0  0 0 -5 1 viewport " + kViewport
            << QStringList{"--orthonormal"} << QByteArray("stdin: modelview: is mirrored: its axes are left-handed\n");
        QTest::newRow("negated")
            << "MVP -1 0 0 0  0 -1 0 0  0 0 2 1  0 0 -7 -5 viewport " + kViewport << QStringList()
            << QByteArray("stdin: product: has every entry negated: the same points, but w < 0 in front of "
                          "the eye, which OpenGL cuts off; its signs are flipped\nstdin: product: decomposed "
                          "into projection and view, with a residual of 0 of its largest entry\n");
        QTest::newRow("reversed, asked for")
            << reversed + rest << QStringList{"--reversed", "--depth", "zero-to-one"}
            << QByteArray("stdin: projection: has its far plane at infinity: depths there have no point\n");
        const QByteArray view = "view " + kModelview, viewport = " viewport " + kViewport;
        QTest::newRow("an inverse by its name")
            << rest
                   + " projectionMatrixInverse 1 0 0 0  0 1 0 0  0 0 0 -0.333333333333333333  0 0 -1 "
                     "0.66666666666666667"
            << QStringList() << QByteArray("stdin: projection: by its name it is an inverse: it is inverted\n");
        QTest::newRow("an inverse too many")
            << rest + " projection " + kProjection + " matrixWorld " + kModelview << QStringList()
            << QByteArray("stdin: view: its inverse is ignored, because the needed matrices are given\n");
        QTest::newRow("a product that goes with them")
            << view + " projection " + kProjection + " mvp 1 0 0 0  0 1 0 0  0 0 -2 -1  0 0 7 5" + viewport
            << QStringList() << QByteArray("stdin: product: ignored, because the projection and the view are given\n");
        QTest::newRow("a product of zeros")
            << view + " projection " + kProjection + " mvp 0 0 0 0  0 0 0 0  0 0 0 0  0 0 0 0" + viewport
            << QStringList()
            << QByteArray("stdin: product: ignored, because the projection and the view "
                          "are given, and it is not their product, but all zeros\n");
        QTest::newRow("a product that does not")
            << view + " projection " + kProjection + " mvp 1 0 0 0  0 1 0 0  0 0 -2 -1  0 0 6 5" + viewport
            << QStringList()
            << QByteArray(
                   "stdin: product: ignored, because the projection and the view are given, and it differs from "
                   "their product by 0.072 of its largest entry: one of them is of another setup, or contains an "
                   "object's matrix\n");
        QTest::newRow("a product that goes with them, by rows")
            << "view 1 0 0 0  0 1 0 0  0 0 1 -5  0 0 0 1 projection 1 0 0 0  0 1 0 0  0 0 -2 -3  0 0 -1 0 mvp 1 0 0 0  "
               "0 1 "
               "0 0  0 0 -2 7  0 0 -1 5"
                   + viewport
            << QStringList{"--order", "row"}
            << QByteArray("stdin: product: ignored, because the projection and the view are given\n");
        QTest::newRow("a view beside a product")
            << "view 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -4 1 mvp 1 0 0 0  0 1 0 0  0 0 -2 -1  0 0 7 5" + viewport
            << QStringList()
            << QByteArray("stdin: view: ignored without a projection: only the product counts, and it differs from the "
                          "product's\nstdin: product: decomposed into projection and view, with a residual of 0 of its "
                          "largest entry\n");
        QTest::newRow("a negated view") << "view -1 0 0 0  0 -1 0 0  0 0 -1 0  0 0 5 -1 projection " + kProjection
                                               + viewport
                                        << QStringList()
                                        << QByteArray(
                                               "stdin: view: has every entry negated: the same points, but w < 0 in "
                                               "front of the eye, which OpenGL cuts off; its signs are flipped\n");
        QTest::newRow("a sheared view, made orthonormal")
            << "view 2 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1 projection " + kProjection + viewport
            << QStringList{"--orthonormal"}
            << QByteArray(
                   "stdin: view: has axes of different lengths or not perpendicular, the longest 2: results are "
                   "object coordinates, not world coordinates\nstdin: view: --orthonormal is for rounded axes and "
                   "would change this camera; give the view without the model's scale\n");
        QTest::newRow("depths beyond a window's")
            << view + " projection " + kProjection + " viewport 200 0 0 0  0 150 0 0  0 0 1.5 0  200 150 0.5 1"
            << QStringList()
            << QByteArray("stdin: viewport: its depths go from -1 to 2, beyond the 0 to 1 of a window; give their NDC "
                          "depths with --depth\n");
        QTest::newRow("y up for Vulkan")
            << view + " projection 1 0 0 0  0 1 0 0  0 0 -1.01010101 -1  0 0 -1.01010101 0 " + viewport
            << QStringList{"--conventions", "vulkan"}
            << QByteArray("stdin: projection: converted from Vulkan's conventions to OpenGL's, it "
                          "flips y, as is done for Vulkan: the view is upside down in OpenGL; it is "
                          "not changed: if it is unwanted, give --conventions of its API\n");
        QTest::newRow("a model beside it")
            << "model " + kModelview + ' ' + rest + " projection " + kProjection << QStringList()
            << QByteArray("stdin: model: ignored: world coordinates do not need it\n");
    }

    void whatIsToBeSeenOfAMatrixIsSaid()
    {
        QFETCH(QByteArray, text);
        QFETCH(QStringList, options);
        QFETCH(QByteArray, said);
        const Run run = runCommand(QStringList{"scene", "--from-matrices", "-"} + options, text);
        QCOMPARE(run.errors, said);
        QCOMPARE(run.exitCode, 0);
        QVERIFY(!run.output.isEmpty());
    }

    void aProductAloneUnprojects_data()
    {
        QTest::addColumn<QByteArray>("product");
        QTest::addColumn<QByteArray>("said");
        QTest::addColumn<QString>("method");
        QTest::addColumn<QList<double>>("expected");
        // kProjection times kModelview, and glOrtho(-1,1,-1,1,1,3) times kModelview.
        const QByteArray perspective = "1 0 0 0  0 1 0 0  0 0 -2 -1  0 0 7 5",
                         box = "1 0 0 0  0 1 0 0  0 0 -1 0  0 0 3 1";
        const QByteArray apart =
            "stdin: product: decomposed into projection and view, with a residual of 0 of its largest entry\n";
        const QByteArray onNear =
            "stdin: product: decomposed into projection and view, with a residual of 0 of its largest entry; an "
            "orthographic eye may be anywhere along the view: it is put on the near plane\n";
        const QByteArray whole =
            "stdin: product: it cannot be decomposed: only the inverted matrix will answer, because "
            "the formulas need projection and view\n";
        QTest::newRow("perspective, matrix") << perspective << apart << "matrix" << QList<double>{3, -3, 2};
        QTest::newRow("perspective, formula") << perspective << apart << "formula" << QList<double>{3, -3, 2};
        QTest::newRow("negated, formula")
            << QByteArray("-1 0 0 0  0 -1 0 0  0 0 2 1  0 0 -7 -5")
            << "stdin: product: has every entry negated: the same points, but w < 0 in front "
               "of the eye, which OpenGL cuts off; its signs are flipped\n"
                   + apart
            << "formula" << QList<double>{3, -3, 2};
        QTest::newRow("box, matrix") << box << onNear << "matrix" << QList<double>{1, -1, 2};
        QTest::newRow("box, formula") << box << onNear << "formula" << QList<double>{1, -1, 2};
        // x sheared along z.
        QTest::newRow("oblique, matrix") << QByteArray("1 0 0 0  0 1 0 0  0.5 0 -1 0  -2.5 0 3 1") << whole << "matrix"
                                         << QList<double>{2.5, -1, 2};
    }

    void aProductAloneUnprojects()
    {
        QFETCH(QByteArray, product);
        QFETCH(QByteArray, said);
        QFETCH(QString, method);
        QFETCH(QList<double>, expected);
        const Run scene = runCommand({"scene", "--from-matrices", "-"}, "MVP " + product + " viewport " + kViewport);
        QCOMPARE(scene.errors, said);
        QCOMPARE(scene.exitCode, 0);
        const Run points = runCommand({"points", "--method", method, m_folder.write("product.json", scene.output)},
                                      "px,py,depth\n400,300,1\n");
        const QList<QByteArray> cells = points.lines().at(1).split(',');
        for (int k = 0; k < 3; ++k)
            QVERIFY2(std::abs(cells[3 + k].toDouble() - expected[k]) <= 1e-13, points.output.constData());
    }

    void optionsTakeMatricesOtherwise_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QList<double>>("expected");
        QTest::newRow("as they are") << QStringList() << QByteArray("200,0,0") << QList<double>{0, 1, 4};
        QTest::newRow("y down") << QStringList{"--y", "down"} << QByteArray("200,0,0") << QList<double>{0, -1, 4};
        QTest::newRow("reversed") << QStringList{"--reversed"} << QByteArray("200,0,1") << QList<double>{0, 1, 4};
        // -2 z - 3 over z is 0 at a distance of 1.5.
        QTest::newRow("[0, 1]") << QStringList{"--depth", "zero-to-one"} << QByteArray("200,0,0")
                                << QList<double>{0, 1.5, 3.5};
    }

    void optionsTakeMatricesOtherwise()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, row);
        QFETCH(QList<double>, expected);
        const Run scene = runCommand(QStringList{"scene", "--from-matrices", "-"} + options,
                                     kModelview + ' ' + kProjection + ' ' + kViewport);
        QCOMPARE(scene.exitCode, 0);
        const Run points =
            runCommand({"points", m_folder.write("otherwise.json", scene.output)}, "px,py,depth\n" + row);
        const QList<QByteArray> cells = points.lines().at(1).split(',');
        for (int k = 0; k < 3; ++k) {
            QVERIFY2(std::abs(cells[3 + k].toDouble() - expected[k]) <= 1e-13, points.output.constData());
            QVERIFY2(std::abs(cells[6 + k].toDouble() - expected[k]) <= 1e-13, points.output.constData());
        }
    }

    void matricesOfOtherApisGiveTheSameWorld_data()
    {
        QTest::addColumn<QByteArray>("text");
        // The same eye, near 1 and far 3 as above. Direct3D's matrices are as XMStoreFloat4x4 prints
        // them: row vectors in four lines.
        QTest::newRow("vulkan") << QByteArray("view 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1 "
                                              "projection 1 0 0 0  0 -1 0 0  0 0 -1.5 -1  0 0 -1.5 0");
        QTest::newRow("direct3d") << QByteArray("view\n1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 5 1\n"
                                                "projection\n1 0 0 0\n0 1 0 0\n0 0 1.5 1\n0 0 -1.5 0\n");
        QTest::newRow("opencascade") << QByteArray("view\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 -5 1\n"
                                                   "projection\n1 0 0 0\n0 1 0 0\n0 0 -2 -1\n0 0 -3 0\n");
    }

    void matricesOfOtherApisGiveTheSameWorld()
    {
        QFETCH(QByteArray, text);
        const QString key = QTest::currentDataTag();
        const Run scene =
            runCommand({"scene", "--conventions", key, "--from-matrices", "-"}, text + " viewport 0 0 400 300");
        QCOMPARE(scene.errors, QByteArray());
        QVERIFY2(scene.output.contains("\"conventions\": \"" + key.toUtf8() + '"'), scene.output);
        const Run points = runCommand({"points", "--method", "formula", m_folder.write("api.json", scene.output)},
                                      "px,py,depth\n400,300,1\n");
        QCOMPARE(points.errors, QByteArray());
        QVERIFY2(points.output.contains("400,300,1,3,-3,2\n"), points.output);
    }

    void badMatricesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("nothing") << QByteArray(" ") << QByteArray("modelview: 0 numbers found, 16 are needed");
        QTest::newRow("one short") << kModelview + ' ' + kProjection + " 0 0 400"
                                   << QByteArray("viewport: 3 numbers found, 4 are needed");
        QTest::newRow("one too many") << "viewport " + kViewport + " modelview 1 " + kModelview + " projection "
                                             + kProjection
                                      << QByteArray("modelview: 17 numbers found, 16 are needed");
        QTest::newRow("NaN") << "nan " + kModelview + ' ' + kProjection + ' ' + kViewport
                             << QByteArray("stdin:1:1: \"nan\" is not a finite number");
        QTest::newRow("infinity on another line")
            << QByteArray(kModelview).replace(" 0 0 1 0", "\n  inf 0 1 0") + kProjection
            << QByteArray("stdin:2:3: \"inf\" is not a finite number");
        QTest::newRow("empty viewport") << kModelview + ' ' + kProjection + " 0 0 0 300" << QByteArray("viewport");
        QTest::newRow("enormous viewport")
            << kModelview + ' ' + kProjection + " 0 0 1e300 300" << QByteArray("viewport");
    }

    void badMatricesAreRefused()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        const Run run = runCommand({"scene", "--from-matrices", "-"}, text);
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        QVERIFY2(run.errors.contains(message), run.errors.constData());
        QVERIFY2(run.errors.startsWith("stdin:") || run.errors.startsWith("scene:")
                     || run.errors.startsWith("viewport:"),
                 run.errors.constData());
    }

    void badArgumentsAreNamed_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("message");
        const QString numbers = QString::fromUtf8(kModelview + ' ' + kProjection + ' ' + kViewport);
        const QString missing = m_folder.path("none/matrices2.txt");
        QTest::newRow("no such file") << QStringList{missing} << missing.toUtf8() + ": there is no such file\n";
        QTest::newRow("a folder") << QStringList{m_folder.path(".")}
                                  << m_folder.path(".").toUtf8() + ": this is a folder; give a file\n";
        QTest::newRow("too few words") << QStringList{"1", "2"}
                                       << QByteArray("--from-matrices: modelview: 2 numbers found, 16 are needed\n");
        QTest::newRow("no size") << QStringList{numbers, "--window", "3by4"}
                                 << QByteArray("--window 3by4: give width and height in pixels, as in 800x600\n");
        QTest::newRow("empty size") << QStringList{numbers, "--window", "0x4"}
                                    << QByteArray("scene: window.width: 0 must lie between 1 and 65536\n");
        QTest::newRow("nowhere to write") << QStringList{numbers, "-o", m_folder.path("none/scene.json")}
                                          << m_folder.path("none/scene.json").toUtf8() + ": there is no such folder";
        QTest::newRow("no order") << QStringList{numbers, "--order", "rows"}
                                  << QByteArray("--order: \"rows\" is not one of column, row\n");
    }

    void badArgumentsAreNamed()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, message);
        const Run run = runCommand(QStringList{"scene", "--from-matrices"} + arguments);
        QVERIFY2(run.errors.startsWith(message), run.errors.constData());
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestSceneCommand)
#include "test_scene_command.moc"
