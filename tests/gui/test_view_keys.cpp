// Keys on the view: the standard views, fit, home, the projection.

#include "tests/gui/gui_scene.h"

#include <glm/geometric.hpp>

using namespace guitest;

class TestViewKeys : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void keysLookFromTheSides_data();
    void keysLookFromTheSides();
    void keysFitGoHomeAndSwitchTheProjection();
};

void TestViewKeys::keysLookFromTheSides_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<glm::dvec3>("forward");
    QTest::addColumn<QString>("face");
    const auto row = [](const char *name, Qt::Key key, Qt::KeyboardModifiers modifiers, const glm::dvec3 &forward,
                        const char *face) {
        QTest::newRow(name) << int(key) << int(modifiers) << forward << QString::fromLatin1(face);
    };
    row("1: front", Qt::Key_1, Qt::NoModifier, {0.0, 0.0, -1.0}, "+z, blue");
    row("ctrl 1: back", Qt::Key_1, Qt::ControlModifier, {0.0, 0.0, 1.0}, "-z, yellow");
    row("3: right", Qt::Key_3, Qt::NoModifier, {-1.0, 0.0, 0.0}, "+x, red");
    row("ctrl 3: left", Qt::Key_3, Qt::ControlModifier, {1.0, 0.0, 0.0}, "-x, cyan");
    row("7: top", Qt::Key_7, Qt::NoModifier, {0.0, -1.0, 0.0}, "+y, green");
    row("ctrl 7: bottom", Qt::Key_7, Qt::ControlModifier, {0.0, 1.0, 0.0}, "-y, magenta");
}

void TestViewKeys::keysLookFromTheSides()
{
    QFETCH(int, key);
    QFETCH(int, modifiers);
    QFETCH(glm::dvec3, forward);
    QFETCH(QString, face);
    const auto window = cubeWindow(false);
    window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    const LookAt before = window->document().geometry().camera();
    QTest::keyClick(&window->view(), static_cast<Qt::Key>(key), static_cast<Qt::KeyboardModifiers>(modifiers));
    const LookAt &after = window->document().geometry().camera();
    QVERIFY(glm::length(forwardOf(after) - forward) < 1e-12);
    QCOMPARE(after.center.coordinates(), before.center.coordinates());
    const QImage picture = window->view().grabFramebuffer();
    // A little beside the middle, where the bottom is crossed by the ground's lines.
    const int shown = faceOfColor(picture.pixelColor(picture.width() / 2 + 9, picture.height() / 2 + 7));
    QVERIFY(shown >= 0);
    QCOMPARE(QString::fromLatin1(cubeFaces()[static_cast<std::size_t>(shown)].name), face);
}

void TestViewKeys::keysFitGoHomeAndSwitchTheProjection()
{
    const auto window = shownWindow(false, {500, 400});
    SceneDocument &document = window->document();
    document.setObjects(cubeScene());
    const Picture home = document.geometry();
    window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    SceneView &view = window->view();

    QTest::keyClick(&view, Qt::Key_5);
    QVERIFY(!isPerspective(document.geometry().projection()));
    QTest::keyClick(&view, Qt::Key_5);
    QVERIFY(isPerspective(document.geometry().projection()));

    QTest::keyClick(&view, Qt::Key_1);
    turnWheel(view, QPointF(100.0, 80.0), 8);
    QTest::keyClick(&view, Qt::Key_F);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 world =
            kCubeCenter + glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        QVERIFY(QRectF(view.rect()).contains(localOf(*window, world)));
    }
    QVERIFY(glm::length(forwardOf(document.geometry().camera()) - glm::dvec3(0.0, 0.0, -1.0)) < 1e-12);

    QTest::keyClick(&view, Qt::Key_Home);
    QVERIFY(document.geometry().camera() == home.camera());
    QVERIFY(document.geometry().projection() == home.projection());
}

QTEST_MAIN(TestViewKeys)
#include "test_view_keys.moc"
