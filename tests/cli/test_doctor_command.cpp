// `unproject doctor`: which mistake makes a wrong coordinate.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <cmath>

namespace {

/// The point (0.5, 0.75, -0.25) lies on pixel 568.647, 274.338 (from the top) at the depth
/// 0.838331.
const QByteArray kScene = R"({
  "unprojector": 1,
  "window": {"width": 1000, "height": 700},
  "viewport": {"x": 100, "y": 40, "width": 800, "height": 600},
  "projection": {"type": "perspective", "fovy": 45, "near": 1, "far": 100},
  "view": {"eye": [3, 2, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
  "objects": [{"name": "box", "file": "missing.obj", "transform": [{"translate": [2, 0, -1]}]}]
})";
const QStringList kClick{"--pixel", "568.6475,274.3378", "--depth", "0.838330516"};

} // namespace

class TestDoctorCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kScene); }

    void theVerdictInJson_data()
    {
        QTest::addColumn<QString>("got");
        QTest::addColumn<QString>("verdict");
        QTest::newRow("flip") << "0.7051,-0.4122,0.0918"
                              << "y-not-flipped";
        QTest::newRow("starts with a minus") << "-1.7223,-0.3612,-4.9168"
                                             << "depth-not-remapped";
        QTest::newRow("in brackets") << "[ -0.1383, -0.0869, 0.1686 ]"
                                     << "view-transposed";
        QTest::newRow("blanks") << "0.7051 -0.4122 0.0918"
                                << "y-not-flipped";
        QTest::newRow("as GLM prints") << "dvec3(0.705100, -0.412200, 0.091800)"
                                       << "y-not-flipped";
        QTest::newRow("typeset") << QString::fromUtf8("[−0.1383 −0.0869 0.1686]") << "view-transposed";
        QTest::newRow("named, of floats") << "x=0.7051f y=-0.4122f z=0.0918f"
                                          << "y-not-flipped";
        QTest::newRow("with w") << "(0.7051, -0.4122, 0.0918, 1)"
                                << "y-not-flipped";
        QTest::newRow("right") << "0.5000,0.7500,-0.2500"
                               << "right";
        QTest::newRow("unknown") << "1.1234,2.2345,0.3456"
                                 << "unknown";
    }

    void theVerdictInJson()
    {
        QFETCH(QString, got);
        QFETCH(QString, verdict);
        const Run run = doctor(kClick + QStringList{"--got", got, "--json"});
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.lines().size(), 1);
        const QJsonObject json = QJsonDocument::fromJson(run.output).object();
        QCOMPARE(json["verdict"].toString(), verdict);
        const QJsonArray candidates = json["candidates"].toArray();
        QVERIFY(candidates.size() >= 5);
        for (const QJsonValue value : candidates) {
            const QJsonObject candidate = value.toObject();
            QVERIFY(!candidate["id"].toString().isEmpty());
            QCOMPARE(candidate["point"].toArray().size(), 3);
            QVERIFY(candidate["distance"].isDouble());
            QVERIFY(candidate["digits"].toInt() <= json["digitsGiven"].toInt());
        }
        if (verdict != "unknown") {
            QCOMPARE(candidates[0].toObject()["id"].toString(), verdict);
            QVERIFY(candidates[0].toObject()["distance"].toDouble() < 0.6);
        }
        QCOMPARE(json["projected"].toArray().size(), 3);
        QCOMPARE(json["next"].toObject()["pixel"].toArray().size(), 2);
        QCOMPARE(json["code"].toArray().isEmpty(), verdict == "right" || verdict == "unknown");
    }

    void theAnswerInWords()
    {
        const Run run = doctor(kClick + QStringList{"--got", "0.7051,-0.4122,0.0918"});
        VERIFY_SUCCEEDED(run);
        QVERIFY(run.output.startsWith("y-not-flipped\n  y is not flipped"));
        QVERIFY(run.output.contains("all 11 digits given, off by"));
        // The last digits are cut off, so the doctor does not report them as explained.
        const Run cutOff = doctor(kClick + QStringList{"--got", "0.7051,-0.4121,0.0918"});
        QVERIFY2(cutOff.output.contains("digits given, the last not rounded but cut off, off by"), cutOff.output);
        // They are cut off towards zero: an answer on the other side explains them no better than any
        // other.
        const Run further = doctor(kClick + QStringList{"--got", "0.7052,-0.4122,0.0918"});
        QVERIFY2(!further.output.contains("cut off") && further.output.startsWith("unknown"), further.output);
        // Digits beyond a double's precision have no effect.
        const Run longer =
            doctor(kClick + QStringList{"--got", "0.50000000000000000,0.7500000000000000,-0.2500000000000000"});
        QVERIFY2(longer.output.contains("digits that count of the "), longer.output);
        QVERIFY(run.output.contains("next best"));
        QVERIFY(run.output.contains("click at"));
        QVERIFY(run.output.contains("the depth is right, the pixel is not"));
        QVERIFY2(run.output.contains("right is     0.500000 0.750000 -0.250000\n"), run.output);
        for (const char *library : {"GLU", "GLM", "Qt", "three.js", "NumPy"})
            QVERIFY2(run.output.contains(library), library);
        const Run right = doctor(kClick + QStringList{"--got", "0.5000,0.7500,-0.2500"});
        VERIFY_SUCCEEDED(right);
        QVERIFY(right.output.startsWith("right\n  The point is right to the digits given."));
        QVERIFY(!right.output.contains("To change"));
        const Run unknown = doctor(kClick + QStringList{"--got", "1.1234,2.2345,0.3456"});
        VERIFY_SUCCEEDED(unknown);
        QVERIFY(unknown.output.startsWith("unknown\n  No known mistake explains this point"));
        QVERIFY(unknown.output.contains("projects     to pixel"));
    }

    /// Near is 0.001, far 100000: the depth begins with nines. The reported landing position gives the
    /// point again.
    void theDepthHasTheDigitsOfThePoint()
    {
        const QString scene = m_folder.write("deep.json", R"({
        "unprojector": 1, "window": {"width": 1000, "height": 700},
        "projection": {"type": "perspective", "fovy": 45, "near": 0.001, "far": 100000},
        "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}, "objects": []})");
        const Run run = runCommand({"doctor", scene, "--pixel", "500.5,350.5", "--got", "0.50000,0.25000,2.03364"});
        static const QRegularExpression landing("to pixel ([^ ]+) ([^ ]+), depth ([^ ]+), by");
        const QRegularExpressionMatch place = landing.match(run.output);
        QVERIFY2(place.hasMatch(), run.output);
        QVERIFY2(place.captured(3).size() < 14, run.output); // no more than it needs
        const QByteArray row = (place.captured(1) + ',' + place.captured(2) + ',' + place.captured(3)).toUtf8();
        const Run back =
            runCommand({"points", "--method", "formula", "--no-header", scene}, "px,py,depth\n" + row + '\n');
        const double expected[] = {0.5, 0.25, 2.03364};
        for (int k = 0; k < 3; ++k)
            QVERIFY2(std::abs(back.lines()[0].split(',')[3 + k].toDouble() - expected[k]) < 1e-5, back.output);
    }

    void theRightPointHasItsOwnDigits_data()
    {
        QTest::addColumn<QString>("depth");
        QTest::addColumn<QString>("got");
        QTest::addColumn<QByteArray>("right");
        QTest::newRow("few given") << "0.838330516"
                                   << "12,2,3" << QByteArray("0.500000 0.750000 -0.250000");
        QTest::newRow("more given than the depth leaves")
            << "0.838331"
            << "1.123456789,2.123456789,3.123456789" << QByteArray("0.5000 0.7500 -0.2500");
        QTest::newRow("a depth of few digits") << "0.8383"
                                               << "1.1234,2.1234,3.1234" << QByteArray("0.50 0.75 -0.25");
    }

    void theRightPointHasItsOwnDigits()
    {
        QFETCH(QString, depth);
        QFETCH(QString, got);
        QFETCH(QByteArray, right);
        const Run run = doctor({"--pixel", "568.6475,274.3378", "--depth", depth, "--got", got});
        VERIFY_SUCCEEDED(run);
        QVERIFY2(run.output.contains("right is     " + right + '\n'), run.output);
    }

    void ofTwoChangesOneIsFirst()
    {
        const Run run = doctor(kClick + QStringList{"--got", "0.651062,-0.335494,0.093560"});
        VERIFY_SUCCEEDED(run);
        QVERIFY2(run.output.contains("Two changes: first \"ratio-logical-in-device\", then \"xy-swapped\". Each"),
                 run.output);
        QVERIFY(!doctor(kClick + QStringList{"--got", "0.7051,-0.4122,0.0918"}).output.contains("Two changes"));
    }

    /// 0.50 has two decimals, 0.5000 four: a pixel's corner is 0.4972 0.7462 -0.2468.
    void digitsAreReadAsWritten()
    {
        const auto verdict = [&](const QString &got) {
            const Run run = doctor(kClick + QStringList{"--got", got, "--json"});
            return QJsonDocument::fromJson(run.output).object()["verdict"].toString();
        };
        QCOMPARE(verdict("0.50,0.75,-0.25"), QString("right"));
        QCOMPARE(verdict("0.4972,0.7462,-0.2468"), QString("pixel-corner"));
        QCOMPARE(verdict("5.0e-1,7.5E-1,-2.5e-1"), QString("right"));
        QCOMPARE(verdict("5.010e-1,7.5E-1,-2.5e-1"), QString("unknown"));
        QCOMPARE(verdict("1e308,-1e308,0e-2000000000"), QString("unknown"));
    }

    /// A point on the axes of a camera that looks along them: rounding makes it -1e-17 and the like.
    void noZeroIsBelowZero()
    {
        const Run run = runCommand({"doctor", m_folder.write("frustum.json", kFrustumScene), "--pixel", "400,300",
                                    "--depth", "0.5", "--got", "-0.0000,0.0000,1.2345"});
        QVERIFY2(run.exitCode == 0, run.errors.constData());
        QVERIFY2(!run.output.contains(" -0.0000") && !run.output.contains(" -0 "), run.output.constData());
    }

    void aTableIsOneProgram()
    {
        const QString points = m_folder.write("wrong.csv", "px,py,depth,x,y,z\r\n"
                                                           "568.6475,274.3378,0.838330516,0.7051,-0.4122,0.0918\r\n"
                                                           "\r\n"
                                                           "500,360,0.8484848484848485,0.2299,-0.1552,0.2299\r\n");
        const Run run = doctor({"--points", points, "--json"});
        QCOMPARE(run.exitCode, 0);
        const QJsonObject json = QJsonDocument::fromJson(run.output).object();
        QVERIFY(json["digitsGiven"].toInt() > 20);
        // The rows come from standard input, without a header and without the depth.
        const Run bare = doctor({"--points", "-", "--json"}, "568.6475,274.3378,0.838330516,0.7051,-0.4122,0.0918\n");
        VERIFY_SUCCEEDED(bare);
        QCOMPARE(QJsonDocument::fromJson(bare.output).object()["verdict"].toString(), QString("y-not-flipped"));
        const Run named = doctor({"--points", "-", "--json"}, "z,x,y,py,px\n0.0918,0.7051,-0.4122,274.3378,568.6475\n");
        QCOMPARE(named.exitCode, 0);
        QCOMPARE(QJsonDocument::fromJson(named.output).object()["candidates"].toArray()[0].toObject()["id"].toString(),
                 QString("y-not-flipped"));
    }

    void theExceptionIsNamed()
    {
        const QByteArray rows = "568.6475,274.3378,0.838330516,0.7051,-0.4122,0.0918\n"
                                "300.5,200.5,0.85,-1.3578,-1.1964,1.1148\n"
                                "300,300,0.85,1.1234,2.2345,3.3456\n";
        const QJsonObject json = QJsonDocument::fromJson(doctor({"--points", "-", "--json"}, rows).output).object();
        QCOMPARE(json["verdict"].toString(), QString("y-not-flipped"));
        QCOMPARE(json["except"].toArray(), QJsonArray{3});
        const Run inWords = doctor({"--points", "-"}, rows);
        QVERIFY2(
            inWords.output.contains("  This holds for all points but point 3, at pixel 300 300: check its digits.\n"),
            inWords.output.constData());
    }

    void anEndlessTableIsRefused()
    {
        const QByteArray row = "568.6475,274.3378,0.838330516,0.7051,-0.4122,0.0918\n";
        const Run run = doctor({"--points", "-"}, row.repeated((1 << 24) / row.size() + 1));
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(
            run.errors,
            QByteArray("stdin: larger than 16 MB; give only the points to check, of which the first 100 are used\n"));
    }

    void badRowsAreNamed()
    {
        const Run run =
            doctor({"--points", "-", "--json"}, "px,py,depth,x,y,z\n568.6475,274.3378,0.838330516,0.7051,nan,1\n"
                                                "568.6475,274.3378,0.838330516,0.7051,-0.4122,0.0918\n");
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.errors, QByteArray("stdin:2: y: \"nan\" is not a number\n"));
        // Quoted text may stand before it, and the header may be missing.
        const QByteArray row = "568.6475,274.3378,0.838330516,0.7051,-0.4122,0.0918";
        const auto errors = [&](const QByteArray &table) {
            const Run one = doctor({"--points", "-", "--json"}, table);
            return QByteArray::number(one.exitCode) + ' ' + one.errors;
        };
        QCOMPARE(errors("note,px,py,depth,x,y,z\n\"two\nlines\"," + row + "\n,1,2,,3,4x,5\n"),
                 QByteArray("1 stdin:4: y: \"4x\" is not a number\n"));
        QCOMPARE(errors("568.6x,274.3,0.8,1,2,3\n" + row + '\n'),
                 QByteArray("1 stdin:1: px: \"568.6x\" is not a number\n"));
        QVERIFY(
            errors("px,py,depth,x,x,y,z\n1,2,0.5,3,3,4,5\n").startsWith("2 stdin:1: the column \"x\" is there twice"));
        QVERIFY(
            errors("568,6,274,3,0,8,1,2,3\n" + row + '\n').startsWith("1 stdin:1: the row has more than six cells"));
        QVERIFY(errors("\"1,2,0.5,3,3,4\n").startsWith("2 stdin:1: a quote is opened"));
        QVERIFY(errors("2000,5,0.5,1,2,3\n" + row + '\n')
                    .startsWith("1 stdin:1: 2000,5 lies outside the view of 1000x700"));
        QCOMPARE(QJsonDocument::fromJson(run.output).object()["verdict"].toString(), QString("y-not-flipped"));
    }

    /// A face in the plane z = 3, 2 in front of the eye. Its depth 2/3 taken for NDC is 5/6, the depth
    /// of 8/3.
    void theMeshGivesTheDepth()
    {
        m_folder.write("face.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
        const QString scene = m_folder.write("frustum.json", kFrustumScene);
        const QStringList click{"doctor", scene, "--json", "--pixel", "600,150", "--got"};
        const Run right = runCommand(click + QStringList{"1.0000,0.7500,3.0000"});
        VERIFY_SUCCEEDED(right);
        const QJsonObject json = QJsonDocument::fromJson(right.output).object();
        QCOMPARE(json["verdict"].toString(), QString("right"));
        QCOMPARE(json["depth"].toString(), QString("mesh"));
        const Run wrong = runCommand(click + QStringList{"1.3333,1.0000,2.3333"});
        VERIFY_SUCCEEDED(wrong);
        QCOMPARE(QJsonDocument::fromJson(wrong.output).object()["verdict"].toString(), QString("depth-not-remapped"));
    }

    /// Worked out with 60 digits: where the ray meets the plane of the triangle, and the point at the
    /// depth. Points with other mistakes, and points beside it, leave it as it is.
    void theRightPointDoesNotDependOnTheWrongOne_data()
    {
        QTest::addColumn<QStringList>("depth");
        QTest::addColumn<QString>("space");
        QTest::addColumn<QList<double>>("right");
        QTest::newRow("on the mesh") << QStringList() << "world"
                                     << QList<double>{-0.13299627234133754, 0.30059249120590026, 0.15124660325173694};
        QTest::newRow("on the mesh, eye space")
            << QStringList() << "eye" << QList<double>{-0.19185909807468562, 0.26445443248132344, -6.008936259069092};
        QTest::newRow("a depth") << QStringList{"--depth", "0.9243156"} << "world"
                                 << QList<double>{-0.06961323669434467, 0.33497287258700154, 0.24934078615987723};
    }

    void theRightPointDoesNotDependOnTheWrongOne()
    {
        QFETCH(QStringList, depth);
        QFETCH(QString, space);
        QFETCH(QList<double>, right);
        m_folder.write("leaning.obj", "v -2 -1 0.5\nv 2 -1.5 -0.5\nv 0 2 0.25\nf 1 2 3\n");
        const QString scene = m_folder.write("leaning.json", R"({
        "unprojector": 1, "window": {"width": 640, "height": 480},
        "projection": {"type": "perspective", "fovy": 45, "near": 0.5, "far": 50},
        "view": {"eye": [3, 2, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
        "objects": [{"name": "leaning", "file": "leaning.obj"}]})");
        const double places[] = {-7e-5, 0.0, 6e-5, 0.3, 11.0};
        for (const double along : places) {
            for (const double beside : places) {
                QStringList got;
                for (int axis = 0; axis < 3; ++axis)
                    got << QString::number(right[axis] + (axis == 1 ? beside : along), 'f', 4);
                const QStringList words = QStringList{"doctor", scene, "--pixel", "301.5,214.5", "--got-space", space}
                                          + depth + QStringList{"--got", got.join(u',')};
                const Run inJson = runCommand(words + QStringList{"--json"});
                VERIFY_SUCCEEDED(inJson);
                const QJsonArray point = QJsonDocument::fromJson(inJson.output).object()["right"].toArray();
                for (int axis = 0; axis < 3; ++axis)
                    QCOMPARE(point[axis].toDouble(), right[axis]);
                const Run inWords = runCommand(words);
                // The number of digits follows those of the typed point; each number is rounded from the right one.
                static const QRegularExpression line(QStringLiteral("right is +(\\S+) (\\S+) (\\S+)\\n"));
                const QRegularExpressionMatch shown = line.match(QString::fromUtf8(inWords.output));
                QVERIFY2(shown.hasMatch(), inWords.output);
                for (int axis = 0; axis < 3; ++axis) {
                    const QString number = shown.captured(axis + 1);
                    const auto decimals = static_cast<int>(number.size() - number.indexOf(u'.') - 1);
                    QVERIFY2(decimals >= 4, inWords.output);
                    QCOMPARE(number, QString::number(right[axis], 'f', decimals));
                }
            }
        }
    }

    void theRayJudgesWithoutModels()
    {
        const QStringList click{"--json", "--pixel", "568.6475,274.3378", "--got"};
        const Run run = doctor(click + QStringList{"0.7051,-0.4122,0.0918"});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.errors.contains("missing.obj"));
        QVERIFY(run.errors.contains("are checked by their rays only"));
        const QJsonObject json = QJsonDocument::fromJson(run.output).object();
        QCOMPARE(json["verdict"].toString(), QString("y-not-flipped"));
        QCOMPARE(json["depth"].toString(), QString("unknown"));
        QVERIFY(json["right"].isNull());
        // A given depth needs no models.
        VERIFY_SUCCEEDED(doctor(kClick + QStringList{"--got", "0.7051,-0.4122,0.0918"}));
        VERIFY_SUCCEEDED(
            runCommand(QStringList{"doctor", "-"} + kClick + QStringList{"--got", "0.7051,-0.4122,0.0918"}, kScene));
    }

    void theSpaceOfThePoint()
    {
        const auto verdict = [&](const QString &space, const QString &got) {
            const Run run = doctor(kClick + QStringList{"--got", got, "--got-space", space, "--json"});
            return QJsonDocument::fromJson(run.output).object()["verdict"].toString();
        };
        QCOMPARE(verdict("eye", "0.5574,0.6955,-5.8805"), QString("right"));
        QCOMPARE(verdict("world", "0.5574,0.6955,-5.8805"), QString("view-left-out"));
        QCOMPARE(verdict("object", "-1.5000,0.7500,0.7500"), QString("right"));
        QCOMPARE(verdict("object:box", "-1.5000,0.7500,0.7500"), QString("right"));
        QCOMPARE(verdict("world", "-1.5000,0.7500,0.7500"), QString("model-left-in"));
    }

    void aPointOfTheSceneIsNamed()
    {
        const QStringList got = kClick + QStringList{"--got", "3.000000,2.000000,5.000000"};
        const Run run = doctor(got);
        VERIFY_SUCCEEDED(run);
        QVERIFY2(run.output.startsWith("the eye\n  The point given is the eye. Usually the program returns where"),
                 run.output);
        // The report contains nothing about similar hypotheses.
        for (const char *row : {"closest", "explains", "next best", "to be sure", "chance"})
            QVERIFY2(!run.output.contains(row), run.output);
        QVERIFY(!run.output.contains("To change"));
        const QJsonObject json = QJsonDocument::fromJson(doctor(got + QStringList{"--json"}).output).object();
        QCOMPARE(json["verdict"].toString(), QString("known-point"));
        QCOMPARE(json["known"].toArray()[0].toObject()["kind"].toString(), QString("eye"));
        QVERIFY(json["sentence"].toString().startsWith("The point given is the eye."));
        QVERIFY(json["code"].toArray().isEmpty());
    }

    void aVertexOfTheMeshIsNamed()
    {
        m_folder.write("face.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
        const QString scene = m_folder.write("frustum.json", kFrustumScene);
        // The point, with the depth and without it.
        for (const QStringList &depth : {QStringList{}, QStringList{"--depth", "0.66666667"}}) {
            const Run run = runCommand(QStringList{"doctor", scene, "--json", "--pixel", "600,150"} + depth
                                       + QStringList{"--got", "2.0000,2.0000,3.0000"});
            VERIFY_SUCCEEDED(run);
            const QJsonObject json = QJsonDocument::fromJson(run.output).object();
            QCOMPARE(json["verdict"].toString(), QString("known-point"));
            const QJsonObject known = json["known"].toArray()[0].toObject();
            QCOMPARE(known["kind"].toString(), QString("vertex"));
            QCOMPARE(known["object"].toString(), QString("face"));
            QCOMPARE(known["vertex"].toInt(), 2);
        }
    }

    void whatCannotBeToldApartIsNamedTogether()
    {
        const QStringList got = kClick + QStringList{"--got", "0.3805,0.7500,-0.1783"};
        const Run run = doctor(got);
        VERIFY_SUCCEEDED(run);
        QVERIFY2(run.output.startsWith("aspect-integer or aspect-left-out\n"), run.output);
        QVERIFY2(
            run.output.contains(
                "\n  Or aspect-left-out: The aspect is left out, as in a square viewport.\n  Both use the same wrong "
                "projection matrix. They cannot be separated: every click in this scene gives the same point.\n"),
            run.output);
        QVERIFY2(run.output.contains("\n  as well      aspect-left-out: 0.3805 0.7500 -0.1783, all "), run.output);
        QVERIFY(!run.output.contains("next best    aspect-left-out"));
        QVERIFY(run.output.contains("To change for aspect-integer:")
                && run.output.contains("To change for aspect-left-out:"));
        const QJsonObject json = QJsonDocument::fromJson(doctor(got + QStringList{"--json"}).output).object();
        QCOMPARE(json["verdict"].toString(), QString("aspect-integer"));
        const QJsonObject second = json["candidates"].toArray()[1].toObject();
        QCOMPARE(second["alike"].toString(), QString("always"));
        QCOMPARE(second["shared"].toString(), QString("projection"));
        QVERIFY(!json["candidates"].toArray()[0].toObject().contains("alike"));
    }

    void axesAreAValue()
    {
        const Run run = doctor(kClick + QStringList{"--got", "0.5000,0.2500,0.7500", "--json"});
        VERIFY_SUCCEEDED(run);
        const QJsonObject json = QJsonDocument::fromJson(run.output).object();
        QCOMPARE(json["verdict"].toString(), QStringLiteral("axes-differ"));
        QCOMPARE(json["candidates"][0]["values"]["axes"].toString(), QStringLiteral("x,-z,y"));
    }

    /// K of the scene: focal length 300 / tan(22.5 degrees), centre (500, 360).
    void thePixelsMayBeDistorted()
    {
        const double focal = 300.0 / std::tan(std::acos(-1.0) / 8.0);
        const double x = (568.6475 - 500.0) / focal, y = (274.3378 - 360.0) / focal, k1 = -0.2;
        const double radial = 1.0 + k1 * (x * x + y * y);
        const QString pixel = QString::number(500.0 + focal * x * radial, 'f', 9) + QLatin1Char(',')
                              + QString::number(360.0 + focal * y * radial, 'f', 9);
        const auto verdict = [&](const QStringList &more) {
            const Run run = doctor(
                QStringList{"--pixel", pixel, "--depth", "0.838330516", "--got", "0.50000,0.75000,-0.25000", "--json"}
                + more);
            return QJsonDocument::fromJson(run.output).object()["verdict"].toString();
        };
        QCOMPARE(verdict({"--distortion", "-0.2,0,0,0"}), QStringLiteral("right"));
        QVERIFY(verdict({}) != QStringLiteral("right"));
        // Coefficients that fold the image have no inverse.
        const Run folded = doctor(kClick + QStringList{"--got", "1,2,3", "--distortion", "-90,0,0,0,0"});
        QCOMPARE(folded.exitCode, 2);
        QVERIFY2(folded.errors.contains("the distortion cannot be undone"), folded.errors.constData());
    }

    void unusable_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("named");
        const QStringList got{"--got", "1,2,3"};
        QTest::newRow("no pixel") << got << QByteArray("--pixel");
        QTest::newRow("no point") << kClick << QByteArray("--got");
        QTest::newRow("pixel of one number") << QStringList{"--pixel", "400"} + got << QByteArray("--pixel 400");
        QTest::newRow("pixel of words") << QStringList{"--pixel", "a,b"} + got << QByteArray("--pixel a,b");
        QTest::newRow("infinite point") << kClick + QStringList{"--got", "1,2,inf"} << QByteArray("--got 1,2,inf");
        QTest::newRow("zero beyond all digits")
            << kClick + QStringList{"--got", "1,2,0e2000000000"} << QByteArray("--got 1,2,0e2000000000");
        QTest::newRow("two coordinates") << kClick + QStringList{"--got", "1,2"} << QByteArray("--got 1,2");
        QTest::newRow("depth of words") << QStringList{"--pixel", "4,5", "--depth", "far"} + got
                                        << QByteArray("--depth far");
        QTest::newRow("depth is a distance") << QStringList{"--pixel", "4,5", "--depth", "5.88"} + got
                                             << QByteArray("--depth: the depth 5.88 lies outside");
        QTest::newRow("no such space") << kClick + got + QStringList{"--got-space", "clip"} << QByteArray("clip");
        QTest::newRow("no such object") << kClick + got + QStringList{"--got-space", "object:ball"}
                                        << QByteArray("object:ball");
        QTest::newRow("points and a pixel") << kClick + QStringList{"--points", "-"} << QByteArray("--points");
        QTest::newRow("no such table") << QStringList{"--points", "nowhere.csv"} << QByteArray("nowhere.csv");
        QTest::newRow("coefficients of words")
            << kClick + got + QStringList{"--distortion", "k1,0,0,0"}
            << QByteArray("--distortion k1,0,0,0: this is neither a file of a camera nor");
        QTest::newRow("three coefficients")
            << kClick + got + QStringList{"--distortion", "0.1,0,0"} << QByteArray("--distortion 0.1,0,0: ");
        QTest::newRow("no size") << kClick + got + QStringList{"--other-size", "640"} << QByteArray("--other-size 640");
        QTest::newRow("outside the view")
            << QStringList{"--pixel", "1001,5"} + got << QByteArray("--pixel: 1001,5 lies");
        QTest::newRow("a sign apart") << kClick + QStringList{"--got", "1 - 2 3"} << QByteArray("--got 1 - 2 3");
        QTest::newRow("NaN") << kClick + QStringList{"--got", "nan nan nan"}
                             << QByteArray("\"nan\" is not a finite number; give a click");
        QTest::newRow("decimal commas") << kClick + QStringList{"--got", "1,5 2 3"}
                                        << QByteArray("write decimals with a point");
        QTest::newRow("a rectangle") << kClick + QStringList{"--got", "QRect(0,0 0x0)"}
                                     << QByteArray("\"0x0\" is not a number; give the three coordinates");
        QTest::newRow("one coordinate") << kClick + QStringList{"--got", "7"}
                                        << QByteArray("it has 1 number; give the three");
        QTest::newRow("thousands") << kClick + QStringList{"--got", "1,500.5 2 1"} << QByteArray("--got 1,500.5");
        QTest::newRow("no rows") << QStringList{"--points", "-"} << QByteArray("stdin");
    }

    void unusable()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, named);
        const Run run = doctor(options);
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.errors.contains(named), run.errors.constData());
        QVERIFY(run.output.isEmpty());
    }

private:
    Run doctor(const QStringList &more, const QByteArray &input = {}) const
    {
        return runCommand(QStringList{"doctor", m_scene} + more, input);
    }

    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestDoctorCommand)
#include "test_doctor_command.moc"
