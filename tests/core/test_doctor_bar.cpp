// The doctor judged by wrong programs that share no line with core: a small share of what
// bench_doctor_bar runs.

#include "core/doctor/diagnosis.h"
#include "tests/support/doctor_bar.h"

#include <QTest>

#include <algorithm>

using namespace unprojector;
using namespace doctor_bar;
using oracle::Random;

class TestDoctorBar : public QObject {
    Q_OBJECT

private slots:
    void everyMistakeIsSimulated();
    void singleMistakesAreNamed();
    void pairsAreAmongTheFirstThree();
    void rightPointsAreCalledRight();
    void randomPointsAreNotExplained();
};

/// The bar cannot judge mistakes that the doctor knows and no program here makes.
void TestDoctorBar::everyMistakeIsSimulated()
{
    const std::vector<std::string> known = doctor::mistakeIds();
    for (const wrong_programs::Mistake &mistake : wrong_programs::mistakes())
        QVERIFY2(std::find(known.begin(), known.end(), mistake.id) != known.end(), mistake.id.data());
}

void TestDoctorBar::singleMistakesAreNamed()
{
    Random random(12);
    Tally tally;
    addSingles(tally, random, 4);
    QVERIFY2(tally.all.first >= 0.97 * tally.all.asked, doctor_bar::lines(tally.missed).c_str());
    QVERIFY2(tally.all.firstThree >= 0.995 * tally.all.asked, doctor_bar::lines(tally.missed).c_str());
    for (const auto &[id, count] : tally.ofId)
        QVERIFY2(2 * count.first >= count.asked, id.c_str());
}

void TestDoctorBar::pairsAreAmongTheFirstThree()
{
    Random random(13);
    Tally tally;
    addPairs(tally, random, 1);
    QVERIFY2(tally.all.firstThree >= 0.9 * tally.all.asked, doctor_bar::lines(tally.missed).c_str());
}

void TestDoctorBar::rightPointsAreCalledRight()
{
    Random random(14);
    QCOMPARE(rightsMissed(random, 10), 0);
}

void TestDoctorBar::randomPointsAreNotExplained()
{
    Random random(15);
    QCOMPARE(garbageExplained(random, 10), 0);
}

QTEST_GUILESS_MAIN(TestDoctorBar)
#include "test_doctor_bar.moc"
