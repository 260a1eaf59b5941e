// Jobs on threads of their own: their results, their failures, and their cancellation at any time.
// No window: the thread sanitizer can follow this.

#include "tests/support/test.h"

#include "tests/gui/job_faults.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

using namespace jobfaults;
using namespace unprojector::gui;

namespace {

constexpr int kPatienceMilliseconds = 60000;

bool isDone(const Background &background)
{
    return QTest::qWaitFor([&] { return !background.isRunning(); }, kPatienceMilliseconds);
}

/// Works until it is cancelled.
int workOn(Job &job)
{
    while (job.report(0.5))
        std::this_thread::yield();
    return 0;
}

using Thrower = std::function<void()>;

} // namespace

Q_DECLARE_METATYPE(Thrower)

class TestBackground : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { Background::fault = nullptr; }

    void theResultComesToTheOwnersThread()
    {
        Background background;
        std::string result;
        std::thread::id worker, owner;
        bool isRunning = true;
        background.start(
            [&worker](Job &) {
                worker = std::this_thread::get_id();
                return std::string("text");
            },
            [&](const JobResult<std::string> &text) {
                owner = std::this_thread::get_id();
                isRunning = background.isRunning();
                result = *text;
            });
        QVERIFY(background.isRunning() && result.empty());
        QVERIFY(isDone(background));
        QCOMPARE(result, std::string("text"));
        QVERIFY(!isRunning);
        QVERIFY(owner == std::this_thread::get_id() && worker != owner);
    }

    void whatIsThrownIsAFailure_data()
    {
        addColumn<Thrower>("thrower");
        addColumn<QString>("reason");
        const QString memory = QStringLiteral("there is not enough memory");
        newRow("no memory") << Thrower([] { throw std::bad_alloc(); }) << memory;
        newRow("more than any memory") << Thrower([] { throw std::length_error("long"); }) << memory;
        newRow("no thread") << Thrower([] {
            throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
        }) << QStringLiteral("the system cannot start another thread");
        newRow("exception") << Thrower([] { throw std::runtime_error("odd"); })
                            << QStringLiteral("an unexpected error occurred (odd)");
        newRow("anything") << Thrower([] { throw 1; }) << QStringLiteral("an unexpected error occurred (?)");
    }

    void whatIsThrownIsAFailure()
    {
        QFETCH(Thrower, thrower);
        QFETCH(QString, reason);
        Background background;
        QString text;
        background.start(
            [thrower](Job &) {
                thrower();
                return 1;
            },
            [&text](const JobResult<int> &result) { text = result ? QString() : failureText(result.error()); });
        QVERIFY(isDone(background));
        QCOMPARE(text, reason);
    }

    void aThreadThatCannotStartIsAFailure()
    {
        Background background;
        std::vector<JobFailure::Kind> kinds;
        const auto done = [&kinds](const JobResult<int> &result) { kinds.push_back(result.error().kind); };
        Background::fault = [](Background::Step) {
            throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
        };
        for (int i = 0; i < 2; ++i)
            background.start([](Job &) { return 1; }, done);
        QVERIFY2(kinds.empty() && background.isRunning(), "it comes later, as a result does");
        QVERIFY(isDone(background));
        QCOMPARE(kinds.size(), std::size_t(2));
        QVERIFY(kinds[0] == JobFailure::Kind::NoThread && kinds[1] == kinds[0]);
        background.start([](Job &) { return 1; }, done);
        background.finish();
        QCOMPARE(kinds.size(), std::size_t(3));
        Background::fault = nullptr;
        int result = 0;
        background.start([](Job &) { return 7; }, [&result](const JobResult<int> &seven) { result = *seven; });
        QVERIFY(isDone(background));
        QCOMPARE(result, 7);
    }

    void nothingComesAfterACancel()
    {
        Background background;
        std::atomic<bool> hasBegun = false;
        bool isToldOf = false;
        background.start(
            [&hasBegun](Job &job) {
                hasBegun = true;
                return workOn(job);
            },
            [&](const JobResult<int> &) { isToldOf = true; }, [&](double) { isToldOf = true; });
        while (!hasBegun)
            std::this_thread::yield();
        background.cancel();
        QVERIFY(!background.isRunning());
        QTest::qWait(50);
        QVERIFY(!isToldOf);
    }

    void aLaterJobTakesTheFirstOnesPlace()
    {
        Background background;
        std::atomic<int> running = 0;
        std::atomic<bool> wereTogether = false;
        std::vector<int> results;
        for (int i = 0; i < 4; ++i) {
            background.cancel();
            background.start(
                [&, i](Job &job) {
                    wereTogether = wereTogether || ++running > 1;
                    if (i < 3)
                        workOn(job);
                    std::this_thread::sleep_for(std::chrono::milliseconds(5)); // it ends slowly
                    --running;
                    return i;
                },
                [&results](const JobResult<int> &number) { results.push_back(*number); });
            QTest::qWait(i);
        }
        QVERIFY(isDone(background));
        QCOMPARE(results, std::vector<int>{3});
        QVERIFY2(!wereTogether, "one that is ending keeps its thread");
    }

    void onlySoManyThreadsRun()
    {
        constexpr int kJobs = 12, kMost = 3;
        Background background(kMost);
        std::atomic<int> running = 0;
        std::atomic<bool> wereMore = false;
        std::vector<int> results;
        for (int i = 0; i < kJobs; ++i) {
            background.start(
                [&, i](Job &) {
                    wereMore = wereMore || ++running > kMost;
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                    --running;
                    return i;
                },
                [&results](const JobResult<int> &number) { results.push_back(*number); });
        }
        QVERIFY(isDone(background));
        QVERIFY(!wereMore);
        std::sort(results.begin(), results.end());
        QCOMPARE(results.size(), std::size_t(kJobs));
        QVERIFY(results.front() == 0 && results.back() == kJobs - 1);
    }

    void progressRises()
    {
        constexpr int kSteps = 10000;
        Background background;
        std::vector<double> shares;
        std::size_t sharesWhenDone = 0;
        background.start(
            [](Job &job) {
                for (int i = 0; i <= kSteps; ++i)
                    job.report(static_cast<double>(i) / kSteps);
                job.report(1.0);
                return 0;
            },
            [&](const JobResult<int> &) { sharesWhenDone = shares.size(); },
            [&shares](double share) { shares.push_back(share); });
        QVERIFY(isDone(background));
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QCOMPARE(shares.back(), 1.0);
        QVERIFY2(shares.size() > 50 && shares.size() <= 101, "each is an event for the window");
        QTest::qWait(10);
        QCOMPARE(shares.size(), sharesWhenDone);
    }

    void allCanBeWaitedFor()
    {
        Background background;
        int sum = 0;
        bool isLate = false;
        for (int i = 1; i <= 3; ++i) {
            background.start(
                [i](Job &job) {
                    job.report(0.5);
                    return i;
                },
                [&sum](const JobResult<int> &number) { sum += *number; }, [&isLate](double) { isLate = true; });
        }
        background.finish();
        QCOMPARE(sum, 6);
        QVERIFY(!background.isRunning());
        QTest::qWait(10);
        QCOMPARE(sum, 6);
        QVERIFY2(!isLate, "no progress of what is done");
    }

    void aJobMayStartAnother()
    {
        Background background;
        int last = 0;
        std::function<void(int)> startFrom = [&](int number) {
            background.start([number](Job &) { return number; },
                             [&](const JobResult<int> &result) {
                                 last = *result;
                                 if (last < 5)
                                     startFrom(last + 1);
                             });
        };
        startFrom(1);
        background.finish();
        QCOMPARE(last, 5);
        startFrom(1);
        QVERIFY(isDone(background));
        QCOMPARE(last, 5);
    }

    void whatTheWorkHoldsIsLetGo()
    {
        Background background;
        const auto start = [&background](bool &isHeld) {
            auto held = std::make_shared<int>(1);
            std::weak_ptr<int> seen = held;
            background.start(
                [held = std::move(held)](Job &) { return held.use_count(); },
                [seen, &isHeld](const JobResult<long> &count) { isHeld = !seen.expired() || (count && *count != 1); });
        };
        bool isHeld = true;
        start(isHeld);
        QVERIFY(isDone(background));
        QVERIFY2(!isHeld, "it had it alone, and has it no longer");
        const Fault fault(JobFailure::Kind::NoThread);
        isHeld = true;
        start(isHeld);
        QVERIFY(isDone(background));
        QVERIFY(!isHeld);
    }

    void itMayGoWhileJobsRun()
    {
        bool isToldOf = false;
        std::atomic<bool> isUsed = false;
        for (int i = 0; i < 10; ++i) {
            const auto alive = std::make_shared<std::atomic<bool>>(true);
            {
                Background background;
                for (int k = 0; k < 2; ++k) {
                    background.start(
                        [&isUsed, alive](Job &job) {
                            const int result = workOn(job);
                            isUsed = isUsed || !*alive;
                            return result;
                        },
                        [&isToldOf](const JobResult<int> &) { isToldOf = true; });
                }
                QTest::qWait(i);
            }
            *alive = false;
            QCOMPARE(alive.use_count(), 1L);
        }
        QTest::qWait(10);
        QVERIFY(!isToldOf && !isUsed);
    }
};

UNPROJECTOR_TEST(TestBackground, threads)
#include "test_background.moc"
