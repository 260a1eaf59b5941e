// The view from outside: it draws without errors, and its handles move only their own part.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "core/geometry/drawable.h"
#include "core/geometry/numbers.h"
#include "core/geometry/view_volume.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScreen>
#include <QSignalSpy>
#include <QSlider>
#include <QVBoxLayout>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <memory>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using guitest::differentPixels;

namespace {

void send(QWidget &widget, QEvent::Type type, const QPointF &position, Qt::MouseButton button, Qt::MouseButtons buttons)
{
    QMouseEvent event(type, position, widget.mapToGlobal(position), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

/// Presses, moves in steps, and releases.
void drag(QWidget &widget, const QPointF &from, const QPointF &to)
{
    send(widget, QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for (int i = 1; i <= 10; ++i)
        send(widget, QEvent::MouseMove, from + (to - from) * (i / 10.0), Qt::NoButton, Qt::LeftButton);
    send(widget, QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
}

} // namespace

Q_DECLARE_METATYPE(unprojector::geometry::Projection)

class TestObserverView : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<SceneDocument>();
        m_document->setSurface({900, 600, 1.0});
        openObjects(*m_document, examples::bundledScene(),
                    {WorldPoint(6.5, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
        m_panel = std::make_unique<ObserverPanel>(*m_document);
        m_panel->resize(500, 600);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get(), kPatienceMilliseconds));
        view().grabFramebuffer();
    }

    void cleanup()
    {
        m_panel.reset();
        m_document.reset();
    }

    void itDrawsWithoutErrors_data() { addProjections(); }

    void itDrawsWithoutErrors()
    {
        QFETCH(Projection, projection);
        show(projection);
        pickAt(*m_document, WidgetPoint(450.0, 300.0), {0.7, 0, 24});
        QVERIFY(m_document->picks().pick().has_value());
        for (const double t : {0.0, 1e-6, 0.5, 1.0 - 1e-6, 1.0}) {
            view().setMorph(t);
            const QImage picture = view().grabFramebuffer();
            QVERIFY(!picture.isNull());
            view().makeCurrent();
            QCOMPARE(view().context()->functions()->glGetError(), static_cast<GLenum>(GL_NO_ERROR));
            view().doneCurrent();
            // The near plane's colour is somewhere in it.
            int blue = 0;
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) {
                    const QColor color = picture.pixelColor(x, y);
                    blue += color.blue() > color.red() + 100 && color.blue() > color.green() + 50;
                }
            }
            QVERIFY2(blue > 200, qPrintable(QStringLiteral("t %1: %2 blue pixels").arg(t).arg(blue)));
        }
    }

    void theWholeVolumeIsInThePictureAllTheWay_data() { addProjections(); }

    void theWholeVolumeIsInThePictureAllTheWay()
    {
        QFETCH(Projection, projection);
        show(projection);
        for (int i = 0; i <= 20; ++i) {
            view().setMorph(i / 20.0);
            for (const EyePoint &corner : viewVolumeCorners(m_document->setup().projection()))
                QVERIFY(QRectF(view().rect()).contains(placeOfEye(corner)));
        }
        view().setMorph(0.0);
        QVERIFY(QRectF(view().rect()).contains(placeOfEye(EyePoint())));
    }

    void theSliderMorphsThePicture()
    {
        auto *slider = m_panel->findChild<QSlider *>();
        QVERIFY(slider);
        const QImage eyeSpace = view().grabFramebuffer();
        slider->setValue(slider->maximum() / 2);
        QCOMPARE(view().morph(), 0.5);
        const QImage between = view().grabFramebuffer();
        slider->setValue(slider->maximum());
        QCOMPARE(view().morph(), 1.0);
        const QImage cube = view().grabFramebuffer();
        QVERIFY(differentPixels(eyeSpace, between) > 2000);
        QVERIFY(differentPixels(between, cube) > 2000);
        slider->setValue(0);
        QVERIFY(differentPixels(eyeSpace, view().grabFramebuffer()) == 0);
        view().setMorph(0.25);
        QCOMPARE(slider->value(), slider->maximum() / 4);
        QVERIFY(m_document->undoStack().count() == 0);
    }

    void aDraggedEdgeMovesThePlaneAsOneUndoStep_data()
    {
        addColumn<Projection>("projection");
        addColumn<bool>("movesFar");
        addColumn<double>("wanted");
        addColumn<double>("t");
        const Projection perspective = Perspective{kPi / 4.0, 1.5, 6.0, 20.0};
        const Projection oblique = Oblique{{-6.0, 6.0, -4.0, 4.0, 6.0, 20.0}, kPi / 3.0, kPi / 2.5};
        newRow("perspective, near closer") << perspective << false << 4.5 << 0.0;
        newRow("perspective, near deeper") << perspective << false << 9.0 << 0.0;
        newRow("perspective, far closer") << perspective << true << 15.0 << 0.0;
        newRow("perspective, near deeper, half way") << perspective << false << 9.0 << 0.5;
        newRow("oblique, near closer") << oblique << false << 3.0 << 0.0;
        newRow("oblique, far closer") << oblique << true << 15.0 << 0.0;
    }

    void aDraggedEdgeMovesThePlaneAsOneUndoStep()
    {
        QFETCH(Projection, projection);
        QFETCH(bool, movesFar);
        QFETCH(double, wanted);
        QFETCH(double, t);
        show(projection);
        view().setMorph(t);
        // The drag starts in the middle of the lower edge, which no other edge crosses, and ends in the
        // middle of the moved edge.
        const auto middleOf = [&](const Projection &of) {
            const std::array<EyePoint, 8> corners = viewVolumeCorners(of);
            const std::size_t first = movesFar ? 4 : 0;
            return placeOfEye(EyePoint((corners[first].coordinates() + corners[first + 1].coordinates()) / 2.0));
        };
        const QPointF from = middleOf(projection);
        const QPointF to = middleOf(withClipDistances(projection, movesFar ? 6.0 : wanted, movesFar ? wanted : 20.0));
        send(view(), QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
        QVERIFY(view().cursor().shape() == Qt::SizeHorCursor || view().cursor().shape() == Qt::SizeVerCursor);
        drag(view(), from, to);

        const ProjectionWindow after = projectionWindow(m_document->setup().projection());
        const double moved = movesFar ? after.farDistance : after.nearDistance;
        QVERIFY2(std::abs(moved - wanted) < 0.1, qPrintable(QStringLiteral("%1 instead of %2").arg(moved).arg(wanted)));
        QCOMPARE(movesFar ? after.nearDistance : after.farDistance, movesFar ? 6.0 : 20.0);
        QVERIFY(!m_document->scene().clipDistancesFitObjects);
        QCOMPARE(m_document->undoStack().count(), 1);
        m_document->undoStack().undo();
        QVERIFY(m_document->setup().projection() == projection);
        // Another drag is another step.
        drag(view(), from, to);
        drag(view(), middleOf(m_document->setup().projection()), from);
        QCOMPARE(m_document->undoStack().count(), 2);
    }

    void orbitLeavesTheDocumentAlone()
    {
        const Setup before = m_document->setup();
        const LookAt observer = view().observer();
        const QImage picture = view().grabFramebuffer();
        drag(view(), QPointF(10.0, 10.0), QPointF(90.0, 40.0));
        QVERIFY(glm::length(view().observer().eye.coordinates() - observer.eye.coordinates()) > 1.0);
        QVERIFY(glm::length(view().observer().center.coordinates() - observer.center.coordinates()) < 1e-9);
        QVERIFY(differentPixels(picture, view().grabFramebuffer()) > 2000);
        QCOMPARE(m_document->undoStack().count(), 0);
        QVERIFY(m_document->setup().camera().eye.coordinates() == before.camera().eye.coordinates());
        QVERIFY(m_document->setup().projection() == before.projection());
        QVERIFY(view().cursor().shape() == Qt::ArrowCursor);
    }

    void theWatchedCameraMovesAloneInTheWorld()
    {
        const LookAt observer = view().observer();
        const WorldPoint corner(1.0, 2.0, 0.5);
        const std::optional<QPointF> before = view().placeOf(corner);
        const QPointF eyeBefore = placeOfEye(EyePoint());
        LookAt camera = m_document->scene().camera;
        camera.eye.x -= 4.0;
        setCamera(*m_document, camera);
        view().grabFramebuffer();
        QVERIFY(view().observer().eye.coordinates() == observer.eye.coordinates());
        const std::optional<QPointF> after = view().placeOf(corner);
        QVERIFY(before && after && QLineF(*before, *after).length() < 1e-6);
        QVERIFY(QLineF(eyeBefore, placeOfEye(EyePoint())).length() > 5.0);
    }

    void theCubeStandsStillWhileTheCameraMoves()
    {
        view().setMorph(1.0);
        const auto corners = [this] {
            std::vector<QPointF> places;
            for (const EyePoint &corner : viewVolumeCorners(m_document->setup().projection()))
                places.push_back(placeOfEye(corner));
            return places;
        };
        const std::vector<QPointF> before = corners();
        LookAt camera = m_document->scene().camera;
        camera.eye = WorldPoint(-9.0, 3.0, 4.0);
        setCamera(*m_document, camera);
        const std::vector<QPointF> after = corners();
        for (std::size_t i = 0; i < before.size(); ++i)
            QVERIFY(QLineF(before[i], after[i]).length() < 1e-6);
    }

    void aNewSceneIsFitted()
    {
        drag(view(), QPointF(10.0, 10.0), QPointF(90.0, 40.0));
        openObjects(*m_document, examples::bundledScene(),
                    {WorldPoint(65.0, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
        view().grabFramebuffer();
        for (const EyePoint &corner : viewVolumeCorners(m_document->setup().projection()))
            QVERIFY(QRectF(view().rect()).contains(placeOfEye(corner)));
        openObjects(*m_document, {});
        view().grabFramebuffer();
        view().setMorph(1.0);
        view().grabFramebuffer();
        QVERIFY(QRectF(view().rect()).contains(placeOfEye(viewVolumeCorners(m_document->setup().projection())[7])));
    }

    void keysTurnAndZoom()
    {
        const LookAt placed = view().observer();
        const auto distance = [this] {
            return glm::length(view().observer().eye.coordinates() - view().observer().center.coordinates());
        };
        const double placedDistance = distance();
        QTest::keyClick(&view(), Qt::Key_Left);
        QVERIFY(glm::length(view().observer().eye.coordinates() - placed.eye.coordinates()) > 0.1);
        QTest::keyClick(&view(), Qt::Key_Right);
        QVERIFY(glm::length(view().observer().eye.coordinates() - placed.eye.coordinates()) < 1e-9 * placedDistance);
        QTest::keyClick(&view(), Qt::Key_Plus);
        QVERIFY(distance() < placedDistance * 0.9);
        QTest::keyClick(&view(), Qt::Key_F);
        QVERIFY(std::abs(distance() - placedDistance) < 1e-6 * placedDistance);
    }

    void aPictureThatCannotBeDrawnIsToldOnce()
    {
        // The view is inside a window: Windows makes no window larger than the screen.
        QWidget window;
        window.resize(400, 160);
        ObserverView wide(*m_document, &window);
        QSignalSpy failed(&wide, &ObserverView::failed);
        wide.resize(kMostDrawnPixels + 100, 160);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMilliseconds));
        for (int i = 0; i < 3; ++i)
            (void)wide.grabFramebuffer();
        QCOMPARE(failed.size(), 1);
        QVERIFY2(failed[0][0].toString().contains(QString::number(kMostDrawnPixels + 100)),
                 qPrintable(failed[0][0].toString()));
        // Another try is made for another picture.
        wide.fit();
        wide.setMorph(0.5);
        (void)wide.grabFramebuffer();
        QCOMPARE(failed.size(), 2);
        wide.resize(300, 200);
        QTRY_COMPARE_WITH_TIMEOUT(wide.size(), QSize(300, 200), kPatienceMilliseconds);
        (void)wide.grabFramebuffer();
        QCOMPARE(failed.size(), 2);
    }

    /// The view moves between two parts of one window, as between the view's corner and a dock. The
    /// picture on the screen counts: grabbing the framebuffer would paint it.
    void itIsDrawnWhereverItIsMoved()
    {
        QWidget window;
        auto *homes = new QHBoxLayout(&window);
        std::array<QWidget *, 2> home;
        for (std::size_t i = 0; i < home.size(); ++i) {
            home[i] = new QWidget;
            new QVBoxLayout(home[i]);
            homes->addWidget(home[i], i == 0 ? 1 : 2); // of different sizes
            home[i]->hide();
        }
        window.resize(900, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMilliseconds));
        const auto isDrawn = [&] {
            const QPoint middle = view().mapTo(&window, view().rect().center());
            const QImage shown = window.screen()->grabWindow(window.winId()).toImage();
            return shown.pixelColor(middle).lightness() > 40;
        };
        for (const std::size_t i : {0, 1, 0}) {
            home[1 - i]->hide();
            home[i]->layout()->addWidget(m_panel.get());
            home[i]->show();
            m_panel->show();
            QTRY_VERIFY_WITH_TIMEOUT(isDrawn(), kPatienceMilliseconds);
        }
        m_panel->setParent(nullptr);
    }

private:
    static void addProjections()
    {
        addColumn<Projection>("projection");
        const Ortho box{-6.0, 6.0, -4.0, 4.0, 6.0, 20.0};
        newRow("perspective") << Projection(Perspective{kPi / 4.0, 1.5, 6.0, 20.0});
        newRow("frustum, off-centre") << Projection(Frustum{-1.0, 4.0, -0.5, 3.0, 6.0, 20.0});
        newRow("frustum, mirrored") << Projection(Frustum{3.0, -3.0, -2.0, 2.0, 6.0, 20.0});
        newRow("ortho") << Projection(box);
        newRow("oblique") << Projection(Oblique{box, kPi / 3.0, kPi / 2.5});
    }

    void show(const Projection &projection)
    {
        QVERIFY(editProjection(*m_document, {projection, false, false}, {QStringLiteral("Projection")}));
        m_document->undoStack().clear();
        view().fit();
    }

    QPointF placeOfEye(const EyePoint &point) const
    {
        const EyeFrame frame = *eyeFrame(m_document->setup().camera());
        return m_panel->view().placeOf(worldFromEye(frame, point)).value_or(QPointF(-1.0, -1.0));
    }

    ObserverView &view() { return m_panel->view(); }

    std::unique_ptr<SceneDocument> m_document;
    std::unique_ptr<ObserverPanel> m_panel;
};

UNPROJECTOR_TEST(TestObserverView, display)
#include "test_observer_view.moc"
