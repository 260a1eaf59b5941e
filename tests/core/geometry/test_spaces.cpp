// The operations of points and vectors, and the operations that must not compile. The claims up to
// the class are checked by compiling this file.

#include "tests/support/test.h"

#include "core/geometry/spaces.h"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <type_traits>

using namespace unprojector;
using namespace unprojector::geometry;

namespace {

template <class A, class B>
concept CanAdd = requires(const A &a, const B &b)
{
    a + b;
};
template <class A, class B>
concept CanSubtract = requires(const A &a, const B &b)
{
    a - b;
};
template <class A, class B>
concept CanMultiply = requires(const A &a, const B &b)
{
    a *b;
};
template <class A, class B>
concept CanDivide = requires(const A &a, const B &b)
{
    a / b;
};
template <class A, class B>
concept CanCompare = requires(const A &a, const B &b)
{
    a == b;
};
template <class A, class B>
concept CanAddTo = requires(A &a, const B &b)
{
    a += b;
};
template <class A, class B>
concept CanSubtractFrom = requires(A &a, const B &b)
{
    a -= b;
};
template <class A, class B>
concept HasDistance = requires(const A &a, const B &b)
{
    distance(a, b);
};
template <class A, class B>
concept HasGlmDistance = requires(const A &a, const B &b)
{
    glm::distance(a, b);
};
template <class A, class B>
concept HasDot = requires(const A &a, const B &b)
{
    dot(a, b);
};
template <class A, class B>
concept HasCross = requires(const A &a, const B &b)
{
    cross(a, b);
};
template <class A>
concept HasLength = requires(const A &a)
{
    length(a);
};
template <class A>
concept HasUnit = requires(const A &a)
{
    normalized(a);
};
template <class A>
concept HasMinus = requires(const A &a)
{
    -a;
};
template <class From, class To>
concept BecomesUnasked = std::is_convertible_v<From, To> || std::is_assignable_v<To &, From>;
template <class From, class To>
concept Becomes = BecomesUnasked<From, To> || std::is_constructible_v<To, From>;

/// Nothing at all can be done with these two, this way round.
template <class A, class B>
concept Strangers =
    !CanAdd<
        A,
        B> && !CanSubtract<A, B> && !CanMultiply<A, B> && !CanDivide<A, B> && !CanCompare<A, B> && !CanAddTo<A, B> && !CanSubtractFrom<A, B> && !HasDistance<A, B> && !HasGlmDistance<A, B> && !HasDot<A, B> && !HasCross<A, B> && !Becomes<A, B>;

template <class... Spaces>
struct List {
};
using AffineSpaces = List<ObjectSpace, WorldSpace, EyeSpace, NdcSpace, WindowSpace, DeviceSpace, WidgetSpace>;

// ---- within one space ------------------------------------------------------------------------

template <class Space>
constexpr bool isAffine()
{
    using P = Point<Space>;
    using V = Vector<Space>;
    static_assert(std::same_as<decltype(P() - P()), V>);
    static_assert(std::same_as<decltype(P() + V()), P> && std::same_as<decltype(P() - V()), P>);
    static_assert(std::same_as<decltype(V() + V()), V> && std::same_as<decltype(V() - V()), V>);
    static_assert(std::same_as<decltype(-V()), V>);
    static_assert(std::same_as<decltype(V() * 2.0), V> && std::same_as<decltype(2 * V()), V>);
    static_assert(std::same_as<decltype(V() / 2.0), V>);
    static_assert(CanAddTo<P, V> && CanSubtractFrom<P, V> && CanAddTo<V, V> && CanSubtractFrom<V, V>);
    static_assert(CanCompare<P, P> && CanCompare<V, V>);
    static_assert(HasDistance<P, P> && HasDot<V, V> && HasLength<V> && HasUnit<V>);
    static_assert(HasCross<V, V> == (Space::kDimension == 3));

    static_assert(!CanAdd<P, P>, "a sum of two places is no place");
    static_assert(!CanAdd<V, P> && !CanSubtract<V, P>);
    static_assert(!CanMultiply<P, double> && !CanMultiply<double, P> && !CanDivide<P, double> && !HasMinus<P>);
    static_assert(!CanMultiply<V, V> && !CanDivide<V, V> && !CanDivide<double, V>, "dot or cross?");
    static_assert(!CanMultiply<P, P> && !CanMultiply<P, V> && !CanMultiply<V, P>);
    static_assert(!CanAdd<V, double> && !CanSubtract<V, double> && !CanAdd<P, double> && !CanSubtract<P, double>);
    static_assert(!CanAddTo<P, P> && !CanSubtractFrom<P, P> && !CanAddTo<V, P> && !CanSubtractFrom<V, P>);
    static_assert(!CanCompare<P, V> && !CanCompare<V, P>);
    static_assert(!HasLength<P> && !HasUnit<P> && !HasDot<P, P> && !HasDot<P, V> && !HasCross<P, P>);
    static_assert(!HasDistance<V, V> && !HasDistance<P, V> && !HasDistance<V, P>);
    static_assert(!Becomes<P, V> && !Becomes<V, P>);
    return true;
}

template <class... Spaces>
constexpr bool areAffine(List<Spaces...>)
{
    return (isAffine<Spaces>() && ...);
}
static_assert(areAffine(AffineSpaces{}));

// ---- between spaces --------------------------------------------------------------------------

template <class A, class B>
constexpr bool isApart()
{
    if constexpr (!std::same_as<A, B>) {
        static_assert(Strangers<Point<A>, Point<B>>);
        static_assert(Strangers<Vector<A>, Vector<B>>);
        static_assert(Strangers<Point<A>, Vector<B>> && Strangers<Vector<B>, Point<A>>);
    }
    static_assert(Strangers<Point<A>, ClipPoint> && Strangers<ClipPoint, Point<A>>);
    static_assert(Strangers<Vector<A>, ClipPoint> && Strangers<ClipPoint, Vector<A>>);
    return true;
}

template <class A, class... B>
constexpr bool isApartFromAll(List<B...>)
{
    return (isApart<A, B>() && ...);
}

template <class... A>
constexpr bool areAllApart(List<A...> all)
{
    return (isApartFromAll<A>(all) && ...);
}
static_assert(areAllApart(AffineSpaces{}));

// ---- clip space is homogeneous ---------------------------------------------------------------

template <class Space>
concept HasVectors = requires
{
    typename Vector<Space>;
};
static_assert(HasVectors<NdcSpace> && !HasVectors<ClipSpace>);
static_assert(CanCompare<ClipPoint, ClipPoint>);
static_assert(!CanAdd<ClipPoint, ClipPoint> && !CanSubtract<ClipPoint, ClipPoint>);
static_assert(!CanMultiply<ClipPoint, double> && !CanDivide<ClipPoint, double>);
static_assert(!HasDistance<ClipPoint, ClipPoint>);

// ---- to and from GLM by name only ------------------------------------------------------------

template <class Numbers, class Glm>
constexpr bool meetsGlmByNameOnly()
{
    static_assert(std::same_as<decltype(Numbers().coordinates()), Glm>);
    static_assert(std::is_constructible_v<Numbers, Glm> && !BecomesUnasked<Glm, Numbers>);
    static_assert(Strangers<Numbers, Glm> && !CanAdd<Glm, Numbers> && !CanSubtract<Glm, Numbers>);
    static_assert(!CanCompare<Glm, Numbers> && !CanMultiply<glm::dmat4, Numbers>);
    return true;
}
static_assert(meetsGlmByNameOnly<WorldPoint, glm::dvec3>() && meetsGlmByNameOnly<WorldVector, glm::dvec3>());
static_assert(meetsGlmByNameOnly<WidgetPoint, glm::dvec2>() && meetsGlmByNameOnly<ClipPoint, glm::dvec4>());

// GLM would shorten a longer vector and lengthen a number.
static_assert(!Becomes<glm::dvec4, WorldPoint> && !Becomes<glm::dvec3, WidgetPoint> && !Becomes<double, WorldPoint>);
static_assert(!Becomes<glm::dvec2, WorldPoint> && !Becomes<glm::vec3, WorldPoint>);
static_assert(!std::is_constructible_v<WorldPoint, double, double>);
static_assert(!std::is_constructible_v<WidgetPoint, double, double, double>);
// Once a space is given up, it does not come back by itself.
static_assert(std::is_convertible_v<WorldPoint, Components<3>> && !Becomes<Components<3>, EyePoint>);

// ---- at no cost ------------------------------------------------------------------------------

template <class Numbers, int Dimension>
constexpr bool isJustItsNumbers = sizeof(Numbers) == Dimension * sizeof(double) && alignof(Numbers) == alignof(double)
                                  && std::is_trivially_copyable_v<Numbers> &&std::is_trivially_destructible_v<Numbers>
                                      &&std::is_standard_layout_v<Numbers>;
static_assert(isJustItsNumbers<WorldPoint, 3> && isJustItsNumbers<WorldVector, 3>);
static_assert(isJustItsNumbers<WidgetPoint, 2> && isJustItsNumbers<ClipPoint, 4>);
static_assert(WorldPoint(1.0, 2.0, 3.0) - WorldPoint(1.0, 1.0, 1.0) == WorldVector(0.0, 1.0, 2.0));

} // namespace

class TestSpaces : public QObject {
    Q_OBJECT

private slots:
    void aNewOneIsZero()
    {
        QVERIFY(WorldPoint().coordinates() == glm::dvec3(0.0));
        QVERIFY(WorldVector().coordinates() == glm::dvec3(0.0));
        QVERIFY(ClipPoint().coordinates() == glm::dvec4(0.0));
        QVERIFY(WidgetPoint().coordinates() == glm::dvec2(0.0));
    }

    void componentsByNameAndByPlace()
    {
        WindowPoint window(1.0, 2.0, 0.5);
        QVERIFY(window.coordinates() == glm::dvec3(1.0, 2.0, 0.5));
        QVERIFY(WindowPoint(window.coordinates()) == window);
        ClipPoint clip(1.0, 2.0, 3.0, 4.0);
        QVERIFY(ClipPoint(clip.coordinates()) == clip);
        WidgetPoint widget(1.0, 2.0);
        QVERIFY(WidgetPoint(widget.coordinates()) == widget);

        const auto hasInOrder = [](const auto &point, std::initializer_list<double> numbers) {
            int place = 0;
            return std::all_of(numbers.begin(), numbers.end(), [&](double number) { return point[place++] == number; });
        };
        QVERIFY(hasInOrder(window, {window.x, window.y, window.z}));
        QVERIFY(hasInOrder(clip, {clip.x, clip.y, clip.z, clip.w}));
        QVERIFY(hasInOrder(widget, {widget.x, widget.y}));
        for (int i = 0; i < 4; ++i)
            clip[i] = 10.0 * i;
        QVERIFY(clip == ClipPoint(0.0, 10.0, 20.0, 30.0));
        for (int i = 0; i < 3; ++i)
            window[i] = 10.0 * i;
        QVERIFY(window == WindowPoint(0.0, 10.0, 20.0));
        for (int i = 0; i < 2; ++i)
            widget[i] = 10.0 * i;
        QVERIFY(widget == WidgetPoint(0.0, 10.0));
        QVERIFY(!(widget == WidgetPoint(0.0, 11.0)) && widget != WidgetPoint(1.0, 10.0));
    }

    void pointsDifferByVectors()
    {
        const WorldPoint a(1.0, 2.0, 3.0), b(4.0, 6.0, 3.0);
        QVERIFY(b - a == WorldVector(3.0, 4.0, 0.0));
        QVERIFY(a + (b - a) == b);
        QVERIFY(b - (b - a) == a);
        QCOMPARE(distance(a, b), 5.0);
        WorldPoint moved = a;
        moved += b - a;
        QVERIFY(moved == b);
        moved -= b - a;
        QVERIFY(moved == a);
    }

    void vectorsAddAndStretch()
    {
        const WorldVector v(1.0, 2.0, 3.0), w(3.0, 2.0, 1.0);
        QVERIFY(v + w == WorldVector(4.0, 4.0, 4.0));
        QVERIFY(v - w == WorldVector(-2.0, 0.0, 2.0));
        QVERIFY(-v == WorldVector(-1.0, -2.0, -3.0));
        QVERIFY(v * 2.0 == WorldVector(2.0, 4.0, 6.0) && 2.0 * v == v * 2.0);
        QVERIFY(v / 2.0 == WorldVector(0.5, 1.0, 1.5));
        QCOMPARE(dot(v, w), 10.0);
        QVERIFY(cross(WorldVector(1.0, 0.0, 0.0), WorldVector(0.0, 1.0, 0.0)) == WorldVector(0.0, 0.0, 1.0));
        QCOMPARE(length(WorldVector(3.0, 0.0, -4.0)), 5.0);
        QVERIFY(normalized(WorldVector(0.0, 0.5, 0.0)) == WorldVector(0.0, 1.0, 0.0));
        WorldVector sum = v;
        sum += w;
        QVERIFY(sum == v + w);
        sum -= v;
        QVERIFY(sum == w);
    }
};

UNPROJECTOR_TEST(TestSpaces)
#include "test_spaces.moc"
