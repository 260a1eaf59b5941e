#pragma once

#include <QStringList>
#include <QTest>

#include <functional>
#include <memory>
#include <vector>

// Every table of a test is made of these.
using QTest::addColumn;
using QTest::addRow;
using QTest::newRow;

/// What a test class needs to be run by its folder's program.
namespace tests {

struct Class {
    const QMetaObject *meta;
    std::function<std::unique_ptr<QObject>()> make;
};

/// The classes of the program.
std::vector<Class> &classes();

template <class Test>
struct Registered {
    Registered()
    {
        classes().push_back({&Test::staticMetaObject, [] { return std::make_unique<Test>(); }});
    }
};

/// How often a test repeats itself with other values: a tenth as often under a sanitizer, which takes ten
/// times as long.
constexpr int rounds(int count)
{
#ifdef UNPROJECTOR_IS_SANITIZED
    return (count + 9) / 10;
#else
    return count;
#endif
}

/// The distance of the places that a test looks at on a grid: three times as far under a sanitizer.
constexpr int spacing(int distance)
{
#ifdef UNPROJECTOR_IS_SANITIZED
    return 3 * distance;
#else
    return distance;
#endif
}

/// A part of a test that runs as a program of its own: PROGRAM --NAME WORD …
struct Helper {
    Helper(const QString &name, std::function<int(const QStringList &words)> run);
};

} // namespace tests

/// Registers a test class: `PROGRAM test_name [FUNCTION[:ROW]] …` runs it, as `ctest -R test_name` does. The
/// words behind the class say how ctest runs it; tests/CMakeLists.txt lists them.
#define UNPROJECTOR_TEST(Test, ...)                                                                                    \
    namespace {                                                                                                        \
    const tests::Registered<Test> registered;                                                                          \
    }
