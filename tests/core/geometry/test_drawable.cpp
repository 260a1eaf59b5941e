// The part of a setup that OpenGL takes: the same numbers in integers and floats, or an error that
// names the value.
#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "core/geometry/drawable.h"
#include "core/scene/scene.h"

#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Setup pictureWith(const Viewport &viewport, const DepthRange &range)
{
    return {{800, 600, 1.0}, viewport, range, Projection(Frustum{-1, 1, -0.75, 0.75, 1, 100}), LookAt{}};
}

} // namespace

class TestDrawable : public QObject {
    Q_OBJECT

private slots:
    void numbersAreThoseOfOpenGl_data()
    {
        addColumn<double>("atNear");
        addColumn<double>("atFar");
        newRow("as usual") << 0.0 << 1.0;
        newRow("reversed") << 1.0 << 0.0;
        newRow("a part") << 0.2 << 0.9;
        newRow("the front") << 0.0 << 0.65;
    }

    void numbersAreThoseOfOpenGl()
    {
        QFETCH(double, atNear);
        QFETCH(double, atFar);
        const Result<Drawable> drawn = drawable(pictureWith({-5, 7, 640, 480}, {atNear, atFar}));
        QVERIFY(drawn);
        QCOMPARE(drawn->x, -5);
        QCOMPARE(drawn->y, 7);
        QCOMPARE(drawn->width, 640);
        QCOMPARE(drawn->height, 480);
        QVERIFY(drawn->depthAtNear == static_cast<float>(atNear) && drawn->depthAtFar == static_cast<float>(atFar));
        // Clicks are unprojected with just these, not with the doubles they came from.
        const DepthRange &range = drawn->setup.depthRange;
        QVERIFY(range.atNear == double(drawn->depthAtNear) && range.atFar == double(drawn->depthAtFar));
        QVERIFY((drawn->setup.viewport == Viewport{-5, 7, 640, 480}));
    }

    void whatOpenGlWouldChangeIsRefused_data()
    {
        addColumn<Setup>("picture");
        addColumn<ErrorCode>("code");
        addColumn<double>("value");
        const Viewport whole{0, 0, 800, 600};
        newRow("x with a fraction") << pictureWith({0.5, 0, 800, 600}, {}) << ErrorCode::ViewportNotWhole << 0.5;
        newRow("height with a fraction") << pictureWith({0, 0, 800, 599.75}, {}) << ErrorCode::ViewportNotWhole
                                         << 599.75;
        newRow("too wide") << pictureWith({0, 0, 16385, 600}, {}) << ErrorCode::ViewportTooLarge << 16385.0;
        newRow("too far left") << pictureWith({-16385, 0, 800, 600}, {}) << ErrorCode::ViewportTooLarge << -16385.0;
        newRow("far above 1") << pictureWith(whole, {0.0, 1.5}) << ErrorCode::DepthRangeNotDrawable << 1.5;
        newRow("near below 0") << pictureWith(whole, {-0.25, 1.0}) << ErrorCode::DepthRangeNotDrawable << -0.25;
        newRow("ends that are one float")
            << pictureWith(whole, {0.5, 0.5 + 1e-12}) << ErrorCode::EmptyDepthRange << 0.5;
        Setup large = pictureWith(whole, {});
        large.surface = {20000, 600, 1.0};
        newRow("a window that no driver draws") << large << ErrorCode::FramebufferTooLarge << 20000.0;
        Setup broken = pictureWith({0, 0, kNan, 600}, {});
        newRow("no number") << broken << ErrorCode::NotFinite << kNan;
    }

    void whatOpenGlWouldChangeIsRefused()
    {
        QFETCH(Setup, picture);
        QFETCH(ErrorCode, code);
        QFETCH(double, value);
        const Result<Drawable> drawn = drawable(picture);
        QVERIFY(!drawn);
        QCOMPARE(drawn.error().code, code);
        QVERIFY(drawn.error().value == value || (drawn.error().value != drawn.error().value && value != value));
    }

    void aScenesPictureIsTheOneDrawn()
    {
        Scene scene;
        scene.objects = examples::bundledScene();
        scene.projection = Frustum{-1, 1, -0.75, 0.75, 1, 100};
        scene.depthRange = {0.0, 0.65};
        const Result<Setup> setup = setupOf(scene, {800, 600, 1.0}, {});
        QVERIFY(setup);
        QVERIFY(setup->depthRange.atFar == double(0.65f) && setup->depthRange.atFar != 0.65);
        scene.viewport = {ViewportRule::Kind::Fixed, {0.5, 0, 640, 480}, 1.0};
        QCOMPARE(setupOf(scene, {800, 600, 1.0}, {}).error().code, ErrorCode::ViewportNotWhole);
    }
};

UNPROJECTOR_TEST(TestDrawable)
#include "test_drawable.moc"
