// Models that take too long to be drawn while the view moves: the view shows stand-ins, and never
// reads from them.

#include "tests/support/test.h"

#include "core/examples/solids.h"
#include "gui/document/camera_looks.h"
#include "gui/document/model_store.h"
#include "gui/document/picks.h"
#include "gui/shell/overlay_bars.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>

using namespace guitest;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::mesh;
using namespace unprojector::scene;

namespace {

/// Two balls of 327,680 triangles each, one model: more than is drawn in motion.
std::vector<SceneObject> largeScene()
{
    auto model = std::make_shared<Model>();
    model->name = "ball";
    model->meshes.push_back(examples::sphereMesh(1.0, 7));
    model->bounds = boundsOf(model->meshes);
    return {{"left", {}, model, {Translate{{-1.2, 0.0, 0.0}}}}, {"right", {}, model, {Translate{{1.2, 0.0, 0.0}}}}};
}

const LookAt kFromBefore{WorldPoint(0.0, 0.0, 8.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};

LookAt turned(double degrees)
{
    const double angle = degrees * kPi / 180.0;
    return {WorldPoint(8.0 * std::sin(angle), 0.0, 8.0 * std::cos(angle)), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
}

/// A view of the large scene with stand-ins that are made, at rest.
struct LargeView {
    SceneDocument document;
    ModelStore models;
    SceneView view{document};

    bool show()
    {
        openObjects(document, largeScene(), kFromBefore);
        view.setModelStore(models);
        view.setSmoothEdges(false);
        view.setMotionBudget(0.0); // a fast machine would need no stand-ins
        QSignalSpy made(&models, &ModelStore::standInReady);
        view.resize(320, 240);
        view.show();
        return QTest::qWaitForWindowExposed(&view, kPatienceMilliseconds)
               && QTest::qWaitFor([&] { return view.isReady(); }, kPatienceMilliseconds)
               && QTest::qWaitFor([&] { return !made.isEmpty(); }, kPatienceMilliseconds) && rest();
    }
    /// Turns the camera, and waits until that is on the screen.
    bool turn(double degrees)
    {
        setCamera(document, turned(degrees), {});
        return QTest::qWaitFor([&] { return view.isCoarse(); }, kPatienceMilliseconds);
    }
    bool rest()
    {
        return QTest::qWaitFor([&] { return !view.isCoarse(); }, kPatienceMilliseconds);
    }
};

} // namespace

class TestLargeModels : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void standInsAreOfWhatIsTooLarge()
    {
        ModelStore models;
        QSignalSpy made(&models, &ModelStore::standInReady);
        std::vector<SceneObject> objects = largeScene();
        QVERIFY(ModelStore::areLarge(objects));
        QVERIFY(!models.standInsFor(objects));
        models.makeStandIns(objects);
        models.makeStandIns(objects); // they are under way
        QVERIFY(made.wait(kPatienceMilliseconds));
        settle();
        QCOMPARE(made.size(), 1);
        const auto standIns = models.standInsFor(objects);
        QVERIFY(standIns);
        QCOMPARE(standIns->size(), objects.size());
        for (std::size_t i = 0; i < objects.size(); ++i) {
            QCOMPARE(standIns->at(i).name, objects[i].name);
            QVERIFY(standIns->at(i).model->triangleCount() < 100'000);
            QVERIFY(standIns->at(i).model->triangleCount() > 20'000);
        }
        for (SceneObject &object : objects)
            object.isHidden = true;
        QVERIFY2(!models.standInsFor(objects), "what is hidden takes no time");
    }

    void whatIsReadIsWhole()
    {
        LargeView shown;
        QVERIFY(shown.show());
        // The truth: the same without stand-ins.
        SceneDocument document;
        openObjects(document, largeScene(), kFromBefore);
        SceneView whole(document);
        whole.resize(shown.view.size());
        whole.show();
        QVERIFY(QTest::qWaitForWindowExposed(&whole, kPatienceMilliseconds)
                && QTest::qWaitFor([&] { return whole.isReady(); }, kPatienceMilliseconds));

        for (const double degrees : {20.0, -35.0}) {
            QVERIFY(shown.turn(degrees));
            setCamera(document, turned(degrees), {});
            const WidgetPoint position(shown.view.width() / 2.0 - 40.0, shown.view.height() / 2.0 + 5.0);
            whole.onLButtonDown(position);
            shown.view.onLButtonDown(position);
            QVERIFY2(!shown.view.isCoarse(), "a click completes the picture");
            QVERIFY(document.picks().pick() && shown.document.picks().pick() && document.picks().pick()->hit());
            QCOMPARE(shown.document.picks().pick()->window.z, document.picks().pick()->window.z);
        }
    }

    void aPictureIsWhole()
    {
        LargeView shown;
        QVERIFY(shown.show());
        QVERIFY(shown.turn(30.0));
        const QImage grabbed = shown.view.grabFramebuffer();
        QVERIFY(!shown.view.isCoarse());
        shown.view.setModelStore(shown.models);
        QVERIFY(shown.rest());
        QCOMPARE(differentPixels(grabbed, shown.view.grabFramebuffer()), 0);
    }

    void coarsePicturesAreTold()
    {
        LargeView shown;
        QVERIFY(shown.show());
        qRegisterMetaType<LifecycleEvent>();
        QSignalSpy steps(&shown.view, &SceneView::happened);
        const auto coarse = [&steps] {
            int count = 0;
            for (const QList<QVariant> &step : steps)
                count += step.at(0).value<LifecycleEvent>().hasStandIns ? 1 : 0;
            return count;
        };
        QVERIFY(shown.turn(30.0));
        QTRY_COMPARE_WITH_TIMEOUT(coarse(), 1, kPatienceMilliseconds);
        QVERIFY(shown.rest());
        QVERIFY(shown.turn(0.0));
        QTRY_COMPARE_WITH_TIMEOUT(coarse(), 2, kPatienceMilliseconds);
        shown.view.onLButtonDown(WidgetPoint(160.0, 120.0));
        settle(20);
        QCOMPARE(coarse(), 2); // a click needs all of it, and that is no coarse picture
    }

    void longDrawingIsTold()
    {
        LargeView shown;
        shown.view.setSlice(0); // a fast machine would draw it at once
        QSignalSpy told(&shown.view, &FrameView::drawingProgressed);
        QVERIFY(shown.show());
        // No picture was shown before there were stand-ins.
        const auto shareAt = [&told](qsizetype i) { return told.at(i).at(0).toDouble(); };
        QVERIFY(told.size() > 2);
        for (qsizetype i = 1; i < told.size(); ++i)
            QVERIFY(shareAt(i) >= shareAt(i - 1) || shareAt(i) == 0.0);
        QCOMPARE(shareAt(0), 0.0);
        QCOMPARE(shareAt(told.size() - 1), 1.0);
        bool isBetween = false;
        for (qsizetype i = 0; i < told.size(); ++i)
            isBetween = isBetween || (shareAt(i) > 0.05 && shareAt(i) < 0.95);
        QVERIFY2(isBetween, "only the beginning and the end are told");
        told.clear();
        QVERIFY(shown.turn(25.0));
        QVERIFY(shown.rest());
        QVERIFY2(told.isEmpty(), "stand-ins are seen");

        // A picture that is awaited is announced, but not where it never comes onto a screen.
        QVERIFY(!shown.view.awaitPicture());
        setCamera(shown.document, kFromBefore, {});
        QVERIFY(shown.view.awaitPicture());
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, kPatienceMilliseconds);
        QCOMPARE(shareAt(0), 1.0);
        SceneView unseen(shown.document);
        unseen.setAttribute(Qt::WA_DontShowOnScreen);
        unseen.show();
        static_cast<void>(unseen.grab());
        QVERIFY(unseen.isReady());
        setCamera(shown.document, turned(5.0), {});
        QVERIFY(!unseen.awaitPicture());

        LoadingBar bar;
        bar.setDrawn(0.25);
        QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible(), kPatienceMilliseconds);
        QVERIFY(bar.findChild<QLabel *>()->text().startsWith(QStringLiteral("Drawing")));
        QCOMPARE(bar.findChild<QProgressBar *>()->value(), 25);
        QVERIFY(bar.findChild<QPushButton *>()->isHidden());
        bar.setDrawn(1.0);
        QVERIFY(bar.isHidden());
        bar.start();
        bar.setDrawn(0.5); // of the scene that is there
        QVERIFY(bar.findChild<QLabel *>()->text().startsWith(QStringLiteral("Opening")));
        QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible(), kPatienceMilliseconds);
        QVERIFY(!bar.findChild<QPushButton *>()->isHidden());
    }

    /// The old objects would be under the new name, and clicks would hit them.
    void anotherSceneBeginsEmpty()
    {
        /// A coarse picture may last shorter than a test waits: the first one is looked at as it is drawn.
        struct OpenView : SceneView {
            using SceneView::SceneView;
            QRgb shownAt(int x, int y)
            {
                glBindFramebuffer(GL_READ_FRAMEBUFFER, frame().framebuffer());
                std::array<unsigned char, 4> color{};
                glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
                return qRgb(color[0], color[1], color[2]);
            }
            bool showsBall() { return shownAt(110, 120) != shownAt(2, 120); }
            void paintGL() override
            {
                SceneView::paintGL();
                if (!isCoarse() || wasCoarse)
                    return;
                wasCoarse = true;
                wasEmpty = !showsBall();
            }
            bool wasCoarse = false, wasEmpty = false;
        };
        SceneDocument document;
        ModelStore models;
        OpenView view(document);
        openObjects(document, largeScene(), kFromBefore);
        view.setModelStore(models);
        view.setMotionBudget(0.0);
        view.resize(320, 240);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view, kPatienceMilliseconds));
        QTRY_VERIFY_WITH_TIMEOUT(view.isReady() && !view.isCoarse(), kPatienceMilliseconds);
        const auto showsBall = [&view] {
            view.makeCurrent();
            const bool shows = view.showsBall();
            view.doneCurrent();
            return shows;
        };
        QVERIFY(showsBall());
        view.wasCoarse = false;
        openObjects(document, largeScene(), kFromBefore);
        QTRY_VERIFY_WITH_TIMEOUT(view.wasCoarse, kPatienceMilliseconds);
        QVERIFY(view.wasEmpty);
        QTRY_VERIFY_WITH_TIMEOUT(!view.isCoarse(), kPatienceMilliseconds);
        QVERIFY(showsBall());
    }

    void restBringsAll()
    {
        LargeView shown;
        QVERIFY(shown.show());
        const QImage before = shown.view.grabFramebuffer();
        QVERIFY(shown.turn(30.0));
        QVERIFY(shown.turn(0.0));
        QVERIFY(shown.rest());
        QVERIFY(differentPixels(before, shown.view.grabFramebuffer()) <= 2);
    }

    void smallModelsAreDrawnAtOnce()
    {
        SceneDocument document;
        ModelStore models;
        SceneView view(document);
        openObjects(document, cubeScene(), kFromBefore);
        view.setModelStore(models);
        view.resize(320, 240);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view, kPatienceMilliseconds)
                && QTest::qWaitFor([&] { return view.isReady(); }, kPatienceMilliseconds));
        for (int i = 1; i < 10; ++i) {
            setCamera(document, turned(i), {});
            QTest::qWait(2);
            QVERIFY(!view.isCoarse());
        }
    }
};

UNPROJECTOR_TEST(TestLargeModels, display)
#include "test_large_models.moc"
