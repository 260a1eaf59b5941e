// Results cannot dangle: the value of a temporary result is moved out, never referenced. These
// claims are checked by compiling this file.

#include "tests/support/test.h"

#include "core/geometry/result.h"

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

using namespace unprojector::geometry;

namespace {

using Text = Result<std::string, int>;

template <class R>
concept HasArrow = requires(R &&r)
{
    std::forward<R>(r).operator->();
};
template <class R>
concept HasStar = requires(R &&r)
{
    *std::forward<R>(r);
};
template <class R>
concept HasValue = requires(R &&r)
{
    std::forward<R>(r).value();
};
template <class R>
concept HasError = requires(R &&r)
{
    std::forward<R>(r).error();
};

// A named result gives references.
static_assert(std::is_same_v<decltype(std::declval<Text &>().value()), const std::string &>);
static_assert(std::is_same_v<decltype(*std::declval<const Text &>()), const std::string &>);
static_assert(HasArrow<Text &> && HasArrow<const Text &>);
// A temporary gives values.
static_assert(std::is_same_v<decltype(std::declval<Text>().value()), std::string>);
static_assert(std::is_same_v<decltype(*std::declval<Text>()), std::string>);
static_assert(std::is_same_v<decltype(std::declval<Text>().error()), int>);
static_assert(!HasArrow<Text>);
// One that cannot be moved from gives nothing.
static_assert(!HasValue<const Text> && !HasStar<const Text> && !HasArrow<const Text> && !HasError<const Text>);

Text longText()
{
    return std::string("a text that is too long to lie inside the string");
}

} // namespace

class TestResult : public QObject {
    Q_OBJECT

private slots:
    void aTemporarysValueOutlivesIt()
    {
        const std::string &byName = longText().value();
        const std::string &byStar = *longText();
        QCOMPARE(byName, *longText());
        QCOMPARE(byStar, *longText());
        int letters = 0;
        for (const char c : *longText())
            letters += c == 'a';
        QCOMPARE(letters, 2);
    }

    void whatCannotBeCopiedIsMovedOut()
    {
        Result<std::unique_ptr<int>, int> kept = std::make_unique<int>(3);
        QCOMPARE(**kept, 3);
        const std::unique_ptr<int> taken = std::move(kept).value();
        QCOMPARE(*taken, 3);
    }
};

UNPROJECTOR_TEST(TestResult)
#include "test_result.moc"
