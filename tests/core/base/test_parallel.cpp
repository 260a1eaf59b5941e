// Work on several threads at once.
#include "tests/support/test.h"

#include "core/base/parallel.h"

#include <cstddef>
#include <vector>

using namespace unprojector::base;

namespace {

void fillTo(std::vector<std::size_t> &values, std::size_t count)
{
    fillInParallel(values, count, {}, [&values](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            values[i] = i;
    });
}

} // namespace

class TestParallel : public QObject {
    Q_OBJECT

private slots:
    void fillsAnArray()
    {
        std::vector<std::size_t> values;
        fillTo(values, 100000);
        QCOMPARE(values.size(), std::size_t{100000});
        QCOMPARE(values.capacity(), std::size_t{100000});
        for (std::size_t i = 0; i < values.size(); ++i)
            QCOMPARE(values[i], i);
    }

    /// Instances are added one by one: to copy all previous ones a thousand times would take minutes.
    void anArrayThatGrowsIsSeldomCopied()
    {
        std::vector<std::size_t> values;
        int copies = 0;
        for (std::size_t count = 10; count <= 10000; count += 10) {
            const std::size_t *const before = values.data();
            const std::size_t capacity = values.capacity();
            fillTo(values, count);
            copies += values.data() != before || values.capacity() != capacity ? 1 : 0;
        }
        QCOMPARE(values.size(), std::size_t{10000});
        QCOMPARE(values.back(), std::size_t{9999});
        QVERIFY2(copies < 20, qPrintable(QString::number(copies)));
    }
};

UNPROJECTOR_TEST(TestParallel, threads)
#include "test_parallel.moc"
