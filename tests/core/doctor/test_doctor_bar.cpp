// The doctor judged by wrong programs that share no line with core: a small share of what
// bench_doctor_bar runs.

#include "tests/support/test.h"

#include "core/doctor/diagnosis.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "tests/support/doctor_bar.h"
#include "tests/support/wrong_values.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>

using namespace unprojector;
using namespace doctor_bar;
using oracle::Random;

namespace {

/// The candidates' names, and those of the report's rows: "pixel-shifted (8 to the right, 31 down)".
QStringList namesOf(const doctor::Diagnosis &diagnosis)
{
    QStringList names;
    for (const doctor::Candidate &candidate : diagnosis.candidates)
        names << QString::fromStdString(candidateName(candidate));
    return names;
}

QStringList rowsOf(const doctor::Diagnosis &diagnosis)
{
    static const QRegularExpression row(QStringLiteral("^  (?:explains|closest|as well|next best) +(.*?): -?\\d"),
                                        QRegularExpression::MultilineOption);
    QStringList rows;
    const QString report = QString::fromStdString(asText(reportOf(diagnosis, {})));
    for (auto it = row.globalMatch(report); it.hasNext();)
        rows << it.next().captured(1);
    return rows;
}

bool hasTwice(QStringList texts)
{
    return texts.removeDuplicates() > 0;
}

} // namespace

class TestDoctorBar : public QObject {
    Q_OBJECT

private slots:
    /// The bar cannot judge mistakes that the doctor knows and no program here makes.
    void everyMistakeIsSimulated()
    {
        for (const wrong_programs::Mistake &mistake : wrong_programs::mistakes())
            QCOMPARE(doctor::mistakeOf(mistake.id).id, mistake.id);
    }

    void singleMistakesAreNamed()
    {
        Random random(12);
        Tally tally;
        addSingles(tally, random, 4);
        QVERIFY2(tally.all.first >= 0.97 * tally.all.asked, doctor_bar::lines(tally.missed).c_str());
        QVERIFY2(tally.all.firstThree >= 0.995 * tally.all.asked, doctor_bar::lines(tally.missed).c_str());
        for (const auto &[id, count] : tally.ofId)
            QVERIFY2(2 * count.first >= count.asked, id.c_str());
    }

    void pairsAreAmongTheFirstThree()
    {
        Random random(13);
        Tally tally;
        addPairs(tally, random, 1);
        QVERIFY2(tally.all.firstThree >= 0.9 * tally.all.asked, doctor_bar::lines(tally.missed).c_str());
    }

    void rightPointsAreCalledRight()
    {
        Random random(14);
        QCOMPARE(rightsMissed(random, 10), 0);
    }

    void randomPointsAreNotExplained()
    {
        Random random(15);
        QCOMPARE(garbageExplained(random, 10), 0);
    }

    /// Programs with one mistake, and with values that are not round, which several mistakes explain.
    void eachCandidateIsNamedOnce()
    {
        Random random(16);
        int open = 0;
        for (int i = 0; i < 3; ++i) {
            const Shot shot = randomShot(random);
            std::vector<std::optional<glm::dvec3>> points;
            for (const wrong_programs::Mistake &mistake : wrong_programs::mistakes())
                points.push_back(printed(shot.scene, shot.click, {{mistake.id, i % mistake.variants}}));
            for (int n = 0; n < 10; ++n) {
                const double dx = random.uniform(-200.0, 200.0), dy = random.uniform(-200.0, 200.0);
                const wrong_programs::WrongValue shifted{"pixel-shifted", {{"dx", {dx}}, {"dy", {dy}}}, {}, 0};
                const wrong_programs::WrongValue farther{"far-differs", {{"far", {random.uniform(20.0, 45.0)}}}, {}, 0};
                points.push_back(printed(shot.scene, shot.click, shifted));
                points.push_back(printed(shot.scene, shot.click, farther));
            }
            for (const std::optional<glm::dvec3> &point : points) {
                const auto diagnosis = point ? diagnosed(shot, *point) : geometry::Error{};
                if (!diagnosis)
                    continue;
                const QStringList names = namesOf(*diagnosis), rows = rowsOf(*diagnosis);
                QVERIFY2(!hasTwice(names), qPrintable(names.join(u'\n')));
                QVERIFY2(!hasTwice(rows) && !rows.isEmpty(), qPrintable(rows.join(u'\n')));
                // An explanation as good as the first one is none that is next best.
                const auto asWell = diagnosis->asWell();
                const bool isOpen = diagnosis->verdict == "unknown" && diagnosis->candidates.front().explains;
                open += isOpen && !asWell.empty() ? 1 : 0;
                if (const doctor::Candidate *next = diagnosis->runnerUp(); isOpen && next)
                    QVERIFY2(!next->explains, qPrintable(rows.join(u'\n')));
            }
        }
        QVERIFY(open >= 10);
    }
};

UNPROJECTOR_TEST(TestDoctorBar, unsanitized)
#include "test_doctor_bar.moc"
