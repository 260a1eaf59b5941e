// The marks of the formulas' quantities in both views, and the marked term in the formulas while
// the pointer is over its quantity.

#include "tests/support/test.h"

#include "tests/gui/window_user.h"

#include "core/geometry/view_volume.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/text/formula_text.h"
#include "gui/view/quantity_marks.h"
#include "gui/widgets/formula_view.h"
#include "tests/support/patience.h"

#include <QMouseEvent>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

using Tips = HighlightMarks::Tips;

constexpr double kPixel = 1.0; // logical; tolerance for rounded positions

/// A window after a click on the cube's front face, with View from Outside visible.
std::unique_ptr<MainWindow> clickedWindow()
{
    auto window = shownWindow(false, {1100, 760}, true);
    openObjects(window->document(), cubeScene(),
                {WorldPoint(kCubeCenter + glm::dvec3(1.9, 2.3, 7.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
    actionOf(*window, QStringLiteral("View from Outside"))->setChecked(true);
    settle();
    click(window->view(), localOf(*window, kCubeCenter + glm::dvec3(-0.4, 0.6, 1.0)));
    settle();
    return window;
}

ObserverView &outsideOf(MainWindow &window)
{
    return window.findChild<ObserverPanel *>()->view();
}

const Pick &pickOf(MainWindow &window)
{
    return *window.document().picks().pick();
}

HighlightMarks inView(MainWindow &window, const char *term)
{
    return termInView(window.document(), QString::fromUtf8(term));
}

void movePointer(QWidget &widget, const QPointF &position)
{
    QMouseEvent event(QEvent::MouseMove, position, widget.mapToGlobal(position), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

void leave(QWidget &widget)
{
    QEvent event(QEvent::Leave);
    QApplication::sendEvent(&widget, &event);
}

bool isNear(const QPointF &a, const QPointF &b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y()) <= kPixel;
}

/// Returns whether a line ends at a point.
bool ends(const QLineF &line, const QPointF &point)
{
    return isNear(line.p1(), point) || isNear(line.p2(), point);
}

/// The clicked point's position in the view, logical pixels.
QPointF pickedPlace(MainWindow &window)
{
    return localOf(window, pickOf(window).point.world[Method::Formula]->coordinates());
}

bool hasLetter(const HighlightMarks &marks, const char *letter)
{
    return std::any_of(marks.texts.begin(), marks.texts.end(),
                       [letter](const HighlightMarks::Text &text) { return text.letter.letter == letter; });
}

/// The middle of the near (0) or far (4) plane's upper edge.
QPointF edgeFromOutside(MainWindow &window, std::size_t plane)
{
    const Setup &setup = window.document().setup();
    const auto corners = viewVolumeCorners(setup.projection());
    const glm::dvec3 middle = (corners[plane + 2].coordinates() + corners[plane + 3].coordinates()) / 2.0;
    return *outsideOf(window).placeOf(worldFromEye(*eyeFrame(setup.camera()), EyePoint(middle)));
}

} // namespace

class TestQuantityMarks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void everyTermIsMarked()
    {
        const auto window = clickedWindow();
        const PickFormulas formulas = formulasOf(pickOf(*window));
        static const QRegularExpression marked(QStringLiteral("<t ([A-Za-z]+)>"));
        const QStringList onlyInWindow{QStringLiteral("H"), QStringLiteral("vx"), QStringLiteral("vy")};
        ObserverView &outside = outsideOf(*window);
        int count = 0;
        for (const FormulaWithNumbers &formula : formulas.formulas) {
            for (auto it = marked.globalMatch(formula.symbols()); it.hasNext(); ++count) {
                const QString term = it.next().captured(1);
                QVERIFY2(!termInView(window->document(), term).isEmpty(), qPrintable(term));
                outside.setMarkedTerm(term);
                QVERIFY2(outside.highlightMarks().isEmpty() == onlyInWindow.contains(term), qPrintable(term));
            }
        }
        QVERIFY(count > 25);
        QVERIFY(inView(*window, "").isEmpty() && inView(*window, "nothing").isEmpty());
    }

    void thePixelIsMeasuredFromTheEdges()
    {
        const auto window = clickedWindow();
        const QPointF pixel = pickedPlace(*window); // its centre
        const HighlightMarks x = inView(*window, "px"), y = inView(*window, "py"), height = inView(*window, "H");
        QCOMPARE(x.arrows.size(), std::size_t(1));
        QVERIFY(ends(x.arrows[0].line, pixel) && ends(x.arrows[0].line, {0.0, pixel.y()}));
        QVERIFY(ends(y.arrows[0].line, pixel) && ends(y.arrows[0].line, {pixel.x(), 0.0}));
        QVERIFY(hasLetter(x, "px") && hasLetter(y, "py") && hasLetter(height, "H"));
        QVERIFY(std::abs(height.arrows[0].line.length() - window->view().height()) <= kPixel);
    }

    void thePointIsMeasuredAlongTheEyesAxes()
    {
        const auto window = clickedWindow();
        const QPointF point = pickedPlace(*window), middle = QRectF(window->view().rect()).center();
        const HighlightMarks x = inView(*window, "x"), y = inView(*window, "y"), z = inView(*window, "z");
        // The view axis is end-on, in the middle of a symmetric projection.
        QVERIFY(ends(x.arrows[0].line, point) && ends(x.arrows[0].line, {middle.x(), point.y()}));
        QVERIFY(ends(y.arrows[0].line, point) && ends(y.arrows[0].line, {point.x(), middle.y()}));
        QCOMPARE(z.arrows.size(), std::size_t(2));
        QVERIFY(z.arrows[0].tips == Tips::Away && isNear(z.arrows[0].line.p2(), middle));
        QVERIFY(z.arrows[1].tips == Tips::None && ends(z.arrows[1].line, middle) && ends(z.arrows[1].line, point));
        QVERIFY(hasLetter(z, "z") && hasLetter(inView(*window, "d"), "d"));
        // Its length in View from Outside is the formula's.
        ObserverView &outside = outsideOf(*window);
        outside.setMarkedTerm(QStringLiteral("z"));
        const auto eye = outside.placeOf(window->document().setup().camera().eye);
        const EyeFrame frame = *eyeFrame(window->document().setup().camera());
        const double distance = -pickOf(*window).point.eye[Method::Formula]->z;
        const auto end = outside.placeOf(worldFromEye(frame, EyePoint(0.0, 0.0, -distance)));
        const QLineF line = outside.highlightMarks().arrows.at(0).line;
        QVERIFY(eye && end && ends(line, *eye) && ends(line, *end));
        // The depth is measured from the near plane on.
        outside.setMarkedTerm(QStringLiteral("d"));
        const double nearDistance = projectionWindow(window->document().setup().projection()).nearDistance;
        const auto start = outside.placeOf(worldFromEye(frame, EyePoint(0.0, 0.0, -nearDistance)));
        const QLineF depth = outside.highlightMarks().arrows.at(0).line;
        QVERIFY(start && ends(depth, *start) && ends(depth, *end));
    }

    void thePlanesAndTheirEdgesLieAtTheViewport()
    {
        const auto window = clickedWindow();
        const QRectF viewport(window->view().rect());
        constexpr double kInset = 8.0;
        for (const char *plane : {"n", "f"}) {
            const HighlightMarks marks = inView(*window, plane);
            QCOMPARE(marks.arrows.size(), std::size_t(4));
            QCOMPARE(marks.texts.size(), std::size_t(1));
            for (const HighlightMarks::Arrow &side : marks.arrows) {
                QVERIFY(side.tips == Tips::None);
                QVERIFY(viewport.contains(side.line.p1()) && viewport.contains(side.line.p2()));
            }
        }
        QVERIFY(inView(*window, "n").arrows[0].color != inView(*window, "f").arrows[0].color);
        const auto sideOf = [&window](const char *term) { return inView(*window, term).arrows.at(0).line; };
        QVERIFY(sideOf("l").center().x() < kInset && sideOf("r").center().x() > viewport.right() - kInset);
        QVERIFY(sideOf("t").center().y() < kInset && sideOf("b").center().y() > viewport.bottom() - kInset);
        QVERIFY(sideOf("l").length() > viewport.height() - 2.0 * kInset);
        QVERIFY(std::abs(sideOf("width").length() - viewport.width()) <= kPixel);
        QVERIFY(std::abs(sideOf("height").length() - viewport.height()) <= kPixel);
        QVERIFY(sideOf("vx").center().x() < kInset);
        // The projection window from outside.
        ObserverView &outside = outsideOf(*window);
        outside.setMarkedTerm(QStringLiteral("t"));
        const Setup &setup = window->document().setup();
        const auto corners = viewVolumeCorners(setup.projection());
        for (const std::size_t corner : {std::size_t(2), std::size_t(3)}) {
            const auto place = outside.placeOf(worldFromEye(*eyeFrame(setup.camera()), corners[corner]));
            QVERIFY(place && ends(outside.highlightMarks().arrows.at(0).line, *place));
        }
        QVERIFY(hasLetter(outside.highlightMarks(), "t"));
    }

    void theEyesAxesAreNamed()
    {
        const auto window = clickedWindow();
        const HighlightMarks eye = inView(*window, "eye");
        QCOMPARE(eye.arrows.size(), std::size_t(3));
        const QPointF middle = QRectF(window->view().rect()).center();
        const auto wayOf = [](const HighlightMarks &marks) {
            return marks.arrows.at(0).line.p2() - marks.arrows.at(0).line.p1();
        };
        const QPointF side = wayOf(inView(*window, "s")), upward = wayOf(inView(*window, "u"));
        QVERIFY(side.x() > 20.0 && std::abs(side.y()) <= kPixel);
        QVERIFY(upward.y() < -20.0 && std::abs(upward.x()) <= kPixel);
        const HighlightMarks forward = inView(*window, "forward");
        QVERIFY(forward.arrows.at(0).tips == Tips::Away && isNear(forward.arrows[0].line.p2(), middle));
    }

    void theBackgroundHasItsRay()
    {
        const auto window = clickedWindow();
        click(window->view(), {20.0, 20.0});
        QVERIFY(!pickOf(*window).hit());
        ObserverView &outside = outsideOf(*window);
        outside.setMarkedTerm(QStringLiteral("way"));
        const QLineF way = outside.highlightMarks().arrows.at(0).line;
        QVERIFY(ends(way, *outside.placeOf(*pickOf(*window).rayNear.world[Method::Formula]))
                && ends(way, *outside.placeOf(*pickOf(*window).rayFar.world[Method::Formula])));
        QVERIFY(isNear(inView(*window, "near").arrows.at(0).line.p2(), {20.5, 20.5}));
        QVERIFY(inView(*window, "t").isEmpty()); // here t is the share of the way, not the top edge
    }

    void marksAreOfTheViewAsItIs()
    {
        const auto window = clickedWindow();
        LookAt camera = window->document().setup().camera();
        camera.eye.x += 1.0;
        setCamera(window->document(), camera);
        settle();
        QVERIFY(ends(inView(*window, "x").arrows.at(0).line, pickedPlace(*window)));
        // A point behind the eye has no length in the view.
        camera.center = camera.eye + (camera.eye - camera.center);
        setCamera(window->document(), camera);
        QVERIFY(inView(*window, "x").isEmpty() && inView(*window, "s").isEmpty());
        QVERIFY(!inView(*window, "n").isEmpty());
    }

    void thePixelIsOfTheClicksWindow()
    {
        const auto window = clickedWindow();
        QVERIFY(!inView(*window, "px").isEmpty() && !inView(*window, "py").isEmpty());
        window->resize(window->width(), window->height() - 40);
        settle();
        QVERIFY(inView(*window, "px").isEmpty() && inView(*window, "py").isEmpty());
        QVERIFY(!inView(*window, "x").isEmpty());
    }

    void aTermOfTheFormulaMarksBothViews()
    {
        const auto window = clickedWindow();
        auto &formula = part<FormulaView>(*window);
        const QImage before = window->view().grabFramebuffer(), beforeOutside = outsideOf(*window).grabFramebuffer();
        movePointer(*formula.viewport(), formula.placesOf(QStringLiteral("n")).at(0).center());
        QCOMPARE(formula.markedTerm(), QStringLiteral("n"));
        const QImage marked = window->view().grabFramebuffer(), markedOutside = outsideOf(*window).grabFramebuffer();
        QVERIFY(differentPixels(before, marked) > marked.width()); // four sides
        QVERIFY(differentPixels(beforeOutside, markedOutside) > 20);
        QVERIFY(hasLetter(outsideOf(*window).highlightMarks(), "n"));
        leave(*formula.viewport());
        QCOMPARE(differentPixels(before, window->view().grabFramebuffer()), 0);
        QCOMPARE(differentPixels(beforeOutside, outsideOf(*window).grabFramebuffer()), 0);
        // A mark disappears with its formula.
        movePointer(*formula.viewport(), formula.placesOf(QStringLiteral("n")).at(0).center());
        window->document().picks().clearPick();
        QVERIFY(outsideOf(*window).highlightMarks().isEmpty());
        QCOMPARE(formula.markedTerm(), QString());
    }

    void aPlaneFromOutsideMarksItsTerm()
    {
        const auto window = clickedWindow();
        auto &formula = part<FormulaView>(*window);
        ObserverView &outside = outsideOf(*window);
        const std::array planes{std::pair(0, "n"), std::pair(4, "f")};
        for (const auto &[plane, term] : planes) {
            movePointer(outside, edgeFromOutside(*window, std::size_t(plane)));
            QCOMPARE(formula.markedTerm(), QString::fromLatin1(term));
            movePointer(outside, {2.0, 2.0});
            QCOMPARE(formula.markedTerm(), QString());
        }
        movePointer(outside, edgeFromOutside(*window, 0));
        leave(outside);
        QCOMPARE(formula.markedTerm(), QString());
    }

    void theMarkOfThePickMarksThePoint()
    {
        const auto window = clickedWindow();
        auto &formula = part<FormulaView>(*window);
        const auto at = [&](const QPointF &off) {
            sendMouse(window->view(), QEvent::MouseMove, pickedPlace(*window) + off, Qt::NoButton, Qt::NoButton);
        };
        at({40.0, 0.0});
        QTRY_COMPARE_WITH_TIMEOUT(formula.markedTerm(), QString(), kPatienceMilliseconds);
        at({2.0, 0.0});
        QTRY_COMPARE_WITH_TIMEOUT(formula.markedTerm(), QStringLiteral("world"), kPatienceMilliseconds);
        at({40.0, 0.0});
        QTRY_COMPARE_WITH_TIMEOUT(formula.markedTerm(), QString(), kPatienceMilliseconds);
        // The mark follows the point to its current position.
        LookAt camera = window->document().setup().camera();
        camera.eye.x += 1.0;
        setCamera(window->document(), camera);
        settle();
        at({0.0, 2.0});
        QTRY_COMPARE_WITH_TIMEOUT(formula.markedTerm(), QStringLiteral("world"), kPatienceMilliseconds);
    }
};

UNPROJECTOR_TEST(TestQuantityMarks, display)
#include "test_quantity_marks.moc"
