// `unproject doctor`: which mistake makes a wrong coordinate.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <array>

class TestDoctorCommand : public QObject {
    Q_OBJECT

private slots:
    void anEndlessTableIsRefused()
    {
        const QByteArray row = "568.6475,274.3378,0.838330516,0.7051,-0.4122,0.0918\n";
        const Run run = runCommand({"doctor", m_folder.write("scene.json", kFrustumScene), "--points", "-"},
                                   row.repeated((1 << 24) / row.size() + 1));
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(
            run.errors,
            QByteArray("stdin: larger than 16 MB; give only the points to check, of which the first 100 are used\n"));
    }

    /// Worked out with 60 digits: where the ray meets the plane of the triangle, and the point at the
    /// depth. Points with other mistakes, and points beside it, leave it as it is.
    void theRightPointDoesNotDependOnTheWrongOne_data()
    {
        addColumn<QStringList>("depth");
        addColumn<QString>("space");
        addColumn<QList<double>>("right");
        newRow("on the mesh") << QStringList() << "world"
                              << QList<double>{-0.13299627234133754, 0.30059249120590026, 0.15124660325173694};
        newRow("on the mesh, eye space") << QStringList() << "eye"
                                         << QList<double>{-0.19185909807468562, 0.26445443248132344,
                                                          -6.008936259069092};
        newRow("a depth") << QStringList{"--depth", "0.9243156"} << "world"
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
        constexpr std::array kOff{-7e-5, 0.0, 6e-5, 0.3, 11.0};
        for (std::size_t i = 0; i < 25; i += std::size_t(25 / tests::rounds(25))) {
            QStringList got;
            for (int axis = 0; axis < 3; ++axis)
                got << QString::number(right[axis] + kOff[axis == 1 ? i % kOff.size() : i / kOff.size()], 'f', 4);
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

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestDoctorCommand)
#include "test_doctor_command.moc"
