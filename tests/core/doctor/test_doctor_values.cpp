// The doctor's solved values, judged by wrong programs that share no line with core: a small share of
// what bench_doctor_bar runs.

#include "tests/support/test.h"

#include "tests/support/value_bar.h"

#include <set>

using namespace value_bar;
using oracle::Random;

class TestDoctorValues : public QObject {
    Q_OBJECT

private slots:
    void onePointFindsTheValueAmongThree()
    {
        static const std::set<std::string> ofOnePoint{"far-differs",           "near-differs",  "fovy-differs",
                                                      "pixel-shifted",         "ratio-differs", "scaled",
                                                      "pixel-scaled-and-moved"};
        Random random(21);
        const Tally tally = tested(random, 25, 1);
        int asked = 0, found = 0;
        for (const auto &[id, count] : tally.ofId) {
            asked += ofOnePoint.contains(id) ? count.asked : 0;
            found += ofOnePoint.contains(id) ? count.firstThree : 0;
        }
        QVERIFY(asked >= 80);
        QVERIFY2(found >= 0.95 * asked, doctor_bar::lines(tally.missed).c_str());
    }

    void threePointsNameTheValue()
    {
        Random random(22);
        const Tally tally = tested(random, 20, 3);
        int asked = 0, named = 0;
        for (const auto &[id, count] : tally.ofId) {
            QVERIFY2(2 * count.verdicts >= count.asked, (id + ": " + doctor_bar::lines(tally.missed)).c_str());
            asked += count.asked;
            named += count.verdicts;
        }
        QVERIFY(asked >= 120);
        QVERIFY2(named >= 0.97 * asked, doctor_bar::lines(tally.missed).c_str());
    }

    void twoPointsNameRoundPlanes()
    {
        Random random(25);
        const Count count = roundPlanesFromTwo(random, 50);
        QVERIFY(count.asked >= 20);
        const std::string text = std::to_string(count.verdicts) + " of " + std::to_string(count.asked);
        QVERIFY2(count.verdicts >= 0.9 * count.asked, text.c_str());
    }

    void fourPointsTellAMirroredFrame()
    {
        Random random(24);
        const Tally tally = tested(random, 15, 4);
        const Count &frames = tally.ofId.at("frame-differs");
        QVERIFY(frames.asked >= 10);
        QVERIFY2(frames.verdicts >= frames.asked - 1, doctor_bar::lines(tally.missed).c_str());
    }

    void randomPointsAreNotExplained()
    {
        Random random(23);
        QCOMPARE(garbageExplained(random, 20), 0);
    }
};

UNPROJECTOR_TEST(TestDoctorValues, unsanitized)
#include "test_doctor_values.moc"
