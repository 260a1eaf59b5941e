// A view of a size that the user has chosen: smaller than its widget, and larger. Run at two pixel
// ratios.

#include "tests/support/test.h"

#include "core/scene_file/scene_file.h"
#include "gui/lessons/lesson_player.h"
#include "gui/shell/view_size_dialog.h"
#include "gui/view/surface_place.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <glm/geometric.hpp>

#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

const EditLabel kLabel{QStringLiteral("edit")};
/// The size of the view's widget, in logical pixels.
constexpr QSize kRoom(500, 400);

void setSize(SceneDocument &document, const Surface &surface)
{
    QVERIFY(document.edit(kLabel, [&surface](Scene &scene) { scene.windowSize = surface; }));
}

/// A plane across the whole picture of a box 300 units wide: at 300 pixels, one unit is one pixel.
std::unique_ptr<MainWindow> planeWindow()
{
    auto window = shownWindow(false, kRoom);
    Scene scene;
    scene.camera = scene.home = {WorldPoint(0, 0, 0), WorldPoint(0, 0, -1), {0, 1, 0}};
    scene.projection = Ortho{-150, 150, -150, 150, 0, 10};
    scene.projectionFollowsViewport = scene.clipDistancesFitObjects = false;
    scene.objects = planeScene({0, 0, -9}, {300, 0, 0}, {0, 300, 0});
    if (!window->document().open(scene))
        qFatal("the plane does not open");
    return window;
}

/// The position of the mouse over a position on the surface, by hand: centred, and no larger than
/// the view.
QPointF mouseOver(const SceneView &view, const Surface &surface, const glm::dvec2 &device)
{
    const double ratio = view.devicePixelRatio();
    const glm::ivec2 widget(std::floor(view.width() * ratio + 0.5), std::floor(view.height() * ratio + 0.5));
    const double scale =
        std::min({1.0, double(widget.x) / surface.widthPixels, double(widget.y) / surface.heightPixels});
    const glm::ivec2 shown(std::lround(surface.widthPixels * scale), std::lround(surface.heightPixels * scale));
    const glm::ivec2 corner = (widget - shown) / 2;
    const QPoint origin = view.mapTo(view.window(), QPoint(0, 0));
    const auto composed = [ratio](int logical) { return std::floor(logical * ratio + 0.5) / ratio - logical; };
    return {(corner.x + device.x * shown.x / surface.widthPixels) / ratio + composed(origin.x()),
            (corner.y + device.y * shown.y / surface.heightPixels) / ratio + composed(origin.y())};
}

void addSizes()
{
    addColumn<int>("width"); // logical pixels
    addColumn<int>("height");
    addColumn<double>("ratio");
    for (const double ratio : {1.0, 2.0}) {
        const auto row = [ratio](const char *name, int width, int height) {
            addRow("%s@%gx", name, ratio) << width << height << ratio;
        };
        row("the paper's", 300, 300);
        row("smaller than any widget", 90, 60);
        row("larger than the widget", 1800, 1300);
        row("wider than the widget", 900, 100);
    }
    newRow("a ratio that is not whole") << 211 << 173 << 1.75;
}

QSpinBox &number(QDialog &dialog, const char *name)
{
    return *dialog.findChild<QSpinBox *>(QLatin1String(name));
}

} // namespace

class TestViewSize : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void positionsGoThereAndBack_data()
    {
        addColumn<QSize>("widget"); // device pixels
        addColumn<double>("widgetRatio");
        addColumn<QSize>("surface");
        addColumn<double>("ratio");
        addColumn<QRect>("shown");
        addColumn<QPointF>("local");
        addColumn<QPointF>("onSurface");
        const QSize room(500, 400);
        newRow("the widget's own") << room << 1.0 << room << 1.0 << QRect(0, 0, 500, 400) << QPointF(165, 135)
                                   << QPointF(165, 135);
        newRow("the paper's") << room << 1.0 << QSize(300, 300) << 1.0 << QRect(100, 50, 300, 300) << QPointF(265, 185)
                              << QPointF(165, 135);
        newRow("the paper's at 2 on a screen of 1")
            << QSize(1000, 800) << 1.0 << QSize(600, 600) << 2.0 << QRect(200, 100, 600, 600) << QPointF(530, 370)
            << QPointF(165, 135);
        newRow("the paper's at 1 on a screen of 2")
            << QSize(1000, 800) << 2.0 << QSize(300, 300) << 1.0 << QRect(350, 250, 300, 300) << QPointF(257.5, 192.5)
            << QPointF(165, 135);
        newRow("twice as large") << room << 1.0 << QSize(1000, 800) << 1.0 << QRect(0, 0, 500, 400) << QPointF(250, 100)
                                 << QPointF(500, 200);
        newRow("too wide alone") << room << 1.0 << QSize(1000, 200) << 1.0 << QRect(0, 150, 500, 100)
                                 << QPointF(10, 160) << QPointF(20, 20);
        newRow("beside it") << room << 1.0 << QSize(300, 300) << 1.0 << QRect(100, 50, 300, 300) << QPointF(90, 40)
                            << QPointF(-10, -10);
    }

    void positionsGoThereAndBack()
    {
        QFETCH(QSize, widget);
        QFETCH(double, widgetRatio);
        QFETCH(QSize, surface);
        QFETCH(double, ratio);
        QFETCH(QRect, shown);
        QFETCH(QPointF, local);
        QFETCH(QPointF, onSurface);
        const SurfacePlace place({widget.width(), widget.height(), widgetRatio},
                                 {surface.width(), surface.height(), ratio});
        QCOMPARE(place.rectangle(), shown);
        const WidgetPoint there = place.onSurface(WidgetPoint(local.x(), local.y()));
        QCOMPARE(there.x, onSurface.x());
        QCOMPARE(there.y, onSurface.y());
        const WidgetPoint back = place.onWidget(there);
        QCOMPARE(back.x, local.x());
        QCOMPARE(back.y, local.y());
    }

    void aClickReadsThePixelUnderIt_data() { addSizes(); }

    void aClickReadsThePixelUnderIt()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(double, ratio);
        const auto window = planeWindow();
        SceneDocument &document = window->document();
        const Surface surface = surfaceFromWidget(width, height, ratio);
        setSize(document, surface);
        QCOMPARE(document.setup().surface, surface);
        settle();
        // The last pixels that a mouse reaches: if the surface is shown smaller, its last position
        // covers several.
        const auto last = [](int pixels, int logical) { return pixels - 1 - pixels / logical; };
        const int right = last(surface.widthPixels, kRoom.width()), bottom = last(surface.heightPixels, kRoom.height());
        for (const DevicePixel &pixel : {DevicePixel{0, 0}, DevicePixel{right, 0}, DevicePixel{0, bottom},
                                         DevicePixel{right, bottom}, DevicePixel{right / 3, bottom / 5}}) {
            click(window->view(), mouseOver(window->view(), surface, {pixel.i + 0.5, pixel.j + 0.5}));
            const Pick *pick = document.picks().pick() ? &*document.picks().pick() : nullptr;
            QVERIFY(pick);
            QCOMPARE(pick->devicePixel.i, pixel.i);
            QCOMPARE(pick->devicePixel.j, pixel.j);
            const glm::dvec2 at(pixel.i + 0.5, surface.heightPixels - pixel.j - 0.5);
            const glm::dvec3 expected(300.0 * at.x / surface.widthPixels - 150.0,
                                      300.0 * at.y / surface.heightPixels - 150.0, -9.0);
            QVERIFY(pick->hit());
            const double off = glm::distance(pick->point.world[Method::Formula]->coordinates(), expected);
            QVERIFY2(off < 1e-4, qPrintable(QString::number(off)));
        }
    }

    void thePapersPointIsFound_data() { addSizes(); }

    void thePapersPointIsFound()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(double, ratio);
        const auto window = planeWindow();
        SceneDocument &document = window->document();
        const Surface surface = surfaceFromWidget(width, height, ratio);
        setSize(document, surface);
        settle();
        // The paper's window has the point at (165, 165, 0.9), 135 from the top.
        const Result<WindowPoint> point = windowFromWorld(document.setup(), WorldPoint(15, 15, -9));
        QVERIFY(point);
        const double across = surface.widthPixels / 300.0, up = surface.heightPixels / 300.0;
        QVERIFY(std::abs(point->x - 165 * across) < 1e-9 && std::abs(point->y - 165 * up) < 1e-9);
        QVERIFY(std::abs(point->z - 0.9) < 1e-12);
        const WidgetPoint widget = widgetFromDevice(surface, deviceFromWindow(surface, *point));
        QVERIFY(std::abs(widget.y - 135.0 * up / ratio) < 1e-9);
        // The click is a hair beside the edge between pixels, on which the point lies.
        click(window->view(), mouseOver(window->view(), surface, {165 * across + 0.25, 135 * up + 0.25}));
        QVERIFY(document.picks().pick() && document.picks().pick()->hit());
        const glm::dvec3 world = document.picks().pick()->point.world[Method::Formula]->coordinates();
        QVERIFY2(std::abs(world.x - 15) <= 1.0 / across && std::abs(world.y - 15) <= 1.0 / up
                     && std::abs(world.z + 9) < 1e-4,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(world.x).arg(world.y).arg(world.z)));
    }

    void besideTheSurfaceNothingIsRead()
    {
        const auto window = planeWindow();
        SceneDocument &document = window->document();
        setSize(document, {100, 100, 1.0});
        settle();
        QSignalSpy hovers(&window->view(), &SceneView::hovered), leaves(&window->view(), &SceneView::pointerLeft);
        sendMouse(window->view(), QEvent::MouseMove, mouseOver(window->view(), {100, 100, 1.0}, {50.5, 50.5}),
                  Qt::NoButton, Qt::NoButton);
        QTRY_VERIFY_WITH_TIMEOUT(!hovers.isEmpty(), kPatienceMilliseconds);
        QVERIFY(leaves.isEmpty());
        sendMouse(window->view(), QEvent::MouseMove, {20, 20}, Qt::NoButton, Qt::NoButton);
        QCOMPARE(leaves.size(), 1);
        click(window->view(), {20, 20});
        QVERIFY(!document.picks().pick());
    }

    void whatIsDrawnStandsWhereItIsClicked_data() { addSizes(); }

    /// A click reads the red face of a cube where it is drawn.
    void whatIsDrawnStandsWhereItIsClicked()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(double, ratio);
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const Surface surface = surfaceFromWidget(width, height, ratio);
        setSize(window->document(), surface);
        settle();
        const QImage shown = view.grabFramebuffer();
        const double ofScreen = view.devicePixelRatio();
        int seen = 0;
        for (std::size_t i = 0; i < cubeFaces().size(); ++i) {
            const glm::dvec3 center = kCubeCenter + cubeFaces()[i].normal;
            if (glm::dot(cubeFaces()[i].normal, window->document().setup().camera().eye.coordinates() - center) <= 0.0)
                continue;
            const glm::dvec2 at = placeOf(*window, center);
            const QPointF local = mouseOver(view, surface, {at.x, surface.heightPixels - at.y});
            const QPoint pixel(int(local.x() * ofScreen), int(local.y() * ofScreen));
            QCOMPARE(faceOfColor(shown.pixelColor(pixel)), int(i));
            click(view, local);
            QVERIFY(window->document().picks().pick() && window->document().picks().pick()->hit());
            const glm::dvec3 world = window->document().picks().pick()->point.world[Method::Formula]->coordinates();
            QVERIFY(std::abs(glm::dot(world - center, cubeFaces()[i].normal)) < 1e-3);
            ++seen;
        }
        QCOMPARE(seen, 3);
    }

    void aDragTurnsAsItDoesInAWholeView()
    {
        // A way across the same share of the picture turns by the same angle, however large the surface
        // is.
        const auto turned = [](const Surface &surface) {
            const auto window = cubeWindow(true);
            setSize(window->document(), surface);
            settle();
            const LookAt before = window->document().setup().camera();
            drag(window->view(),
                 mouseOver(window->view(), surface, {0.02 * surface.widthPixels, 0.1 * surface.heightPixels}),
                 mouseOver(window->view(), surface, {0.02 * surface.widthPixels, 0.6 * surface.heightPixels}),
                 Qt::LeftButton);
            return glm::dot(forwardOf(before), forwardOf(window->document().setup().camera()));
        };
        const double small = turned({200, 200, 1.0}), large = turned({2000, 2000, 1.0});
        QVERIFY(small < 0.99);
        QVERIFY2(std::abs(small - large) < 0.02, qPrintable(QStringLiteral("%1 %2").arg(small).arg(large)));
    }

    void theSizeIsUndoneAndFitsAgain()
    {
        const auto window = planeWindow();
        SceneDocument &document = window->document();
        const Surface before = document.setup().surface;
        QAction *fit = actionOf(*window, QStringLiteral("Fit the Window"));
        QVERIFY(fit && !fit->isEnabled());
        setSize(document, {300, 300, 1.0});
        QVERIFY(fit->isEnabled());
        QVERIFY(document.isEdited());
        document.undoStack().undo();
        QCOMPARE(document.setup().surface, before);
        document.undoStack().redo();
        QCOMPARE(document.setup().surface, (Surface{300, 300, 1.0}));
        QVERIFY(resized(*window, kRoom + QSize(40, 20)));
        QCOMPARE(document.setup().surface, (Surface{300, 300, 1.0})); // for any size of the window
        fit->trigger();
        settle();
        QCOMPARE(document.setup().surface, window->view().widgetSurface());
        QVERIFY(!fit->isEnabled());
    }

    void theSizeIsKeptInTheFile()
    {
        namespace file = unprojector::scene_file;
        const auto window = planeWindow();
        SceneDocument &document = window->document();
        const Surface surface = surfaceFromWidget(301, 203, 1.75);
        setSize(document, surface);
        Scene plain = document.scene();
        plain.objects.clear(); // they have no file
        const auto text = sceneText(file::sceneFileFrom(plain, document.setup(), "scene.json"));
        QVERIFY(text);
        const auto read = file::parseScene(*text, "scene.json");
        QVERIFY(read && read->isWindowFixed);
        const auto scene = file::sceneFromFile(*read, "scene.json", document.objects());
        QVERIFY(scene);
        const auto other = planeWindow();
        QVERIFY(other->document().open(*scene));
        QCOMPARE(other->document().setup().surface, surface);
    }

    void aFileWithoutAChoiceFillsTheWindow()
    {
        namespace file = unprojector::scene_file;
        const auto window = planeWindow();
        SceneDocument &document = window->document();
        Scene plain = document.scene();
        plain.objects.clear(); // they have no file
        const auto text = sceneText(file::sceneFileFrom(plain, document.setup(), "scene.json"));
        QVERIFY(text && text->find("\"fixed\": true") == std::string::npos);
        const auto read = file::parseScene(*text, "scene.json");
        QVERIFY(read && !read->isWindowFixed);
        const auto scene = file::sceneFromFile(*read, "scene.json", document.objects());
        QVERIFY(scene && !scene->windowSize);
    }

    void moreThanCanBeDrawnIsSaid()
    {
        const auto window = planeWindow();
        setSize(window->document(), {16000, 16000, 1.0});
        window->view().grabFramebuffer();
        QVERIFY2(window->message().contains(QStringLiteral("16000 × 16000")), qPrintable(window->message()));
        setSize(window->document(), {300, 300, 1.0});
        window->view().grabFramebuffer();
        click(window->view(), mouseOver(window->view(), {300, 300, 1.0}, {150.5, 150.5}));
        QVERIFY(window->document().picks().pick());
    }

    void theDialogTakesEitherPixels()
    {
        const auto window = planeWindow();
        SceneDocument &document = window->document();
        ViewSizeDialog dialog(document, window->view());
        const Surface own = document.setup().surface;
        QCOMPARE(number(dialog, "deviceWidth").value(), own.widthPixels);
        QCOMPARE(number(dialog, "logicalWidth").value(), kRoom.width());
        auto &ratio = *dialog.findChild<QDoubleSpinBox *>();
        QCOMPARE(ratio.value(), own.devicePixelRatio);
        ratio.setValue(2.0);
        QCOMPARE(number(dialog, "deviceWidth").value(), 2 * kRoom.width());
        number(dialog, "logicalWidth").setValue(300);
        number(dialog, "deviceHeight").setValue(400);
        QCOMPARE(number(dialog, "deviceWidth").value(), 600);
        QCOMPARE(number(dialog, "logicalHeight").value(), 200);
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        QCOMPARE(document.setup().surface, (Surface{600, 400, 2.0}));
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("View size"));
    }

    void theDialogSaysWhatCannotBeHad()
    {
        const auto window = planeWindow();
        ViewSizeDialog dialog(window->document(), window->view());
        dialog.findChild<QDoubleSpinBox *>()->setValue(2.0);
        auto &width = number(dialog, "deviceWidth");
        const auto &note = *dialog.findChild<QLabel *>(QStringLiteral("note"));
        width.setValue(601);
        QCOMPARE(width.value(), 602);
        QVERIFY2(note.text().contains(QStringLiteral("601")), qPrintable(note.text()));
        dialog.accept(); // the user may not have seen it yet
        QVERIFY(!window->document().scene().windowSize);
        dialog.accept();
        QCOMPARE(window->document().setup().surface.widthPixels, 602);
        width.stepDown();
        QCOMPARE(width.value(), 600);
        number(dialog, "logicalWidth").setValue(4000);
        QVERIFY2(note.text().contains(u'%'), qPrintable(note.text()));
    }

    /// No whole number of logical pixels may be as many device pixels as a lesson asks for.
    void aSizeThatTheScreenCannotShowIsTold()
    {
        const auto window = windowOfSize({1280, 800});
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("weng"));
        constexpr int kAskedFor = 400;
        const double ratio = window->view().devicePixelRatioF();
        const int logical = static_cast<int>(std::lround(kAskedFor / ratio));
        const int device = static_cast<int>(std::floor(logical * ratio + 0.5)); // of a widget that is so large
        window->follow(*unprojector::lessons::parseLink("view:400x400"));
        QTRY_COMPARE_WITH_TIMEOUT(window->view().width(), logical, kPatienceMilliseconds);
        settle(300);
        if (device == kAskedFor) {
            QCOMPARE(window->message(), QString());
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(window->message().contains(QString::number(device))
                                         && window->message().contains(QString::number(kAskedFor)),
                                     kPatienceMilliseconds);
            QVERIFY(window->message().contains(QString::number(ratio)));
            QVERIFY(!player.hasViewOfStep());
        }
    }

    void theDialogIsReachedFromTheNumbers_data()
    {
        addColumn<QString>("label");
        newRow("in the parameters") << QStringLiteral("Size of the window");
        newRow("in the viewport panel") << QStringLiteral("Window");
    }

    void theDialogIsReachedFromTheNumbers()
    {
        QFETCH(QString, label);
        const auto window = planeWindow();
        for (QLabel *each : window->findChildren<QLabel *>()) {
            if (each->accessibleName() == label)
                emit each->linkActivated(QStringLiteral("size"));
        }
        auto *dialog = window->findChild<ViewSizeDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        dialog->reject();
    }
};

UNPROJECTOR_TEST(TestViewSize, display, at 1.5)
#include "test_view_size.moc"
