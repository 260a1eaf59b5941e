// Mixing two spaces up must be a compile error. These claims are checked by compiling this file.

#include "core/geometry/spaces.h"

#include <QTest>

#include <type_traits>

using namespace unprojector;
using namespace unprojector::geometry;

namespace {

template <class... Points>
struct List {
};
using AllPoints = List<ObjectPoint, WorldPoint, EyePoint, ClipPoint, NdcPoint, WindowPoint, DevicePoint, WidgetPoint>;

template <class From, class To>
constexpr bool isSeparate()
{
    if constexpr (std::is_same_v<From, To>) {
        return std::is_convertible_v<From, To> && std::is_assignable_v<To &, From>;
    } else {
        return !std::is_convertible_v<From,
                                      To> && !std::is_constructible_v<To, From> && !std::is_assignable_v<To &, From>;
    }
}

template <class From, class... To>
constexpr bool isSeparateFromAll(List<To...>)
{
    return (isSeparate<From, To>() && ...);
}

template <class... From>
constexpr bool areAllSeparate(List<From...> all)
{
    return (isSeparateFromAll<From>(all) && ...);
}

static_assert(areAllSeparate(AllPoints{}));

// A result of arithmetic has no space; giving it one takes the space's name.
static_assert(std::is_constructible_v<WorldPoint, glm::dvec3>);
static_assert(std::is_convertible_v<WorldPoint, glm::dvec3>);
static_assert(std::is_same_v<decltype(std::declval<WorldPoint>() - std::declval<WorldPoint>()), glm::dvec3>);
static_assert(std::is_base_of_v<glm::dvec4, ClipPoint>);
static_assert(std::is_base_of_v<glm::dvec2, WidgetPoint>);

} // namespace

class TestSpaces : public QObject {
    Q_OBJECT

private slots:
    void aNewPointIsTheOrigin();
    void aPointReadsAsItsCoordinates();
};

void TestSpaces::aNewPointIsTheOrigin()
{
    QVERIFY(WorldPoint().coordinates() == glm::dvec3(0, 0, 0));
    QVERIFY(ClipPoint().coordinates() == glm::dvec4(0, 0, 0, 0));
    QVERIFY(WidgetPoint().coordinates() == glm::dvec2(0, 0));
}

void TestSpaces::aPointReadsAsItsCoordinates()
{
    const WindowPoint point(1, 2, 0.5);
    QVERIFY(point.coordinates() == glm::dvec3(1, 2, 0.5));
    QCOMPARE(point.x + point.y + point.z, 3.5);
    QVERIFY(WindowPoint(point).coordinates() == point.coordinates());
}

QTEST_GUILESS_MAIN(TestSpaces)
#include "test_spaces.moc"
