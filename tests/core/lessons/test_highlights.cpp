// The labels of a lesson's step in the pictures.

#include "tests/support/test.h"

#include "core/lessons/highlights.h"

#include <cmath>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::lessons;
using namespace unprojector::scene;

class TestHighlights : public QObject {
    Q_OBJECT

private slots:
    void axesAreNamed_data()
    {
        addColumn<QList<double>>("offset");
        addColumn<double>("mirror");
        addColumn<QStringList>("names");
        newRow("moved and mirrored") << QList<double>{4, 3, 0} << -2.0 << QStringList{"MC", "WC", "VC"};
        newRow("at rest") << QList<double>{0, 0, 0} << 1.0 << QStringList{"MC = WC", "VC"};
    }

    void axesAreNamed()
    {
        QFETCH(QList<double>, offset);
        QFETCH(double, mirror);
        QFETCH(QStringList, names);
        Scene scene;
        scene.objects.resize(2);
        scene.objects[0].name = "other";
        scene.objects[0].transform = {Translate{glm::dvec3(9, 9, 9)}};
        scene.objects[1].name = "followed";
        scene.objects[1].transform = {Translate{glm::dvec3(offset[0], offset[1], offset[2])},
                                      Scale{glm::dvec3(mirror, 1, 1)}};
        scene.givenPoint = GivenPoint{ObjectPoint(), "followed"};
        const EyeFrame eye = *eyeFrame(LookAt{WorldPoint(5, 2, 0), WorldPoint(5, 2, 1), WorldVector(0, -1, 0)});
        const std::vector<NamedAxes> axes = namedAxes(scene, eye);
        QStringList found;
        for (const NamedAxes &one : axes)
            found << QString::fromStdString(one.name);
        QCOMPARE(found, names);
        QVERIFY(axes.front().origin == WorldPoint(offset[0], offset[1], offset[2]));
        QVERIFY(axes.front().directions[0] == WorldVector(mirror < 0.0 ? -1 : 1, 0, 0)); // a unit, and still mirrored
        QVERIFY(axes.back().origin == WorldPoint(5, 2, 0));
        QVERIFY(axes.back().directions[1] == WorldVector(0, -1, 0));
        QVERIFY(axes.back().directions[2] == WorldVector(0, 0, -1)); // it looks along its own -z
    }

    void theVolumesSidesAreLettered_data()
    {
        addColumn<bool>("isPerspective");
        newRow("a pyramid") << true;
        newRow("a box") << false;
    }

    void theVolumesSidesAreLettered()
    {
        QFETCH(bool, isPerspective);
        const Projection projection =
            isPerspective ? Projection(Frustum{-1, 3, -2, 2, 5, 10}) : Projection(Ortho{-1, 3, -2, 2, 5, 10});
        // Halfway between near and far a pyramid of twice the depth is half as large again.
        const double share = isPerspective ? 1.5 : 1.0;
        const QMap<QString, EyePoint> wanted{{"l", EyePoint(-1 * share, 0, -7.5)},
                                             {"r", EyePoint(3 * share, 0, -7.5)},
                                             {"b", EyePoint(1 * share, -2 * share, -7.5)},
                                             {"t", EyePoint(1 * share, 2 * share, -7.5)},
                                             {"n", EyePoint(1, 0, -5)},
                                             {"f", EyePoint(isPerspective ? 2 : 1, 0, -10)}};
        for (const auto &[letter, at] : volumeLetters(projection))
            QVERIFY2(distance(at, wanted[QString::fromStdString(letter.letter)]) < 1e-12, letter.letter.c_str());
    }

    void theCubesSidesAreNumbered()
    {
        QStringList found;
        for (const auto &[letter, at] : cubeLetters()) {
            QCOMPARE(std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z), 1.0);
            QCOMPARE(QString::fromStdString(letter.letter),
                     at.x + at.y + at.z < 0.0 ? QStringLiteral("−1") : QStringLiteral("1"));
            found << QStringLiteral("%1 %2 %3").arg(at.x).arg(at.y).arg(at.z);
        }
        found.removeDuplicates();
        QCOMPARE(found.size(), 6);
    }

    void theViewportIsMeasured()
    {
        const auto written = [](const Viewport &viewport) {
            QStringList lines;
            for (const LetteredArrow &arrow : viewportArrows(viewport, {500, 450, 1.0}, 6.0))
                lines << QStringLiteral("%1%2 %3,%4 %5,%6")
                             .arg(arrow.letter.letter.c_str(), arrow.letter.index.c_str())
                             .arg(arrow.from.x)
                             .arg(arrow.from.y)
                             .arg(arrow.to.x)
                             .arg(arrow.to.y);
            return lines;
        };
        QCOMPARE(written({100, 40, 400, 300}),
                 (QStringList{"xv 6,6 494,6", "yv 6,6 6,444", "width 100,334 500,334", "height 494,40 494,340",
                              "vx 0,190 100,190", "vy 300,0 300,40", "H 404,450 404,0"}));
        const QStringList whole = written({0, 0, 500, 450});
        QCOMPARE(whole.filter(QStringLiteral("vx")) + whole.filter(QStringLiteral("vy")), QStringList());
    }
};

UNPROJECTOR_TEST(TestHighlights)
#include "test_highlights.moc"
