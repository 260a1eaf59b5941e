// The parameters as a person uses them: keys into the panel, then the document's scene and setup.
// Expected numbers are literals.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/parameters/panel_user.h"

#include <QLabel>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

/// A field's name and what its number is in the scene.
struct FieldRow {
    const char *field;
    const char *text;
    double expected;
    double (*read)(const Scene &);
};

const FieldRow kFieldRows[] = {
    {"eyeX", "1.5", 1.5, [](const Scene &s) { return s.camera->eye.x; }},
    {"eyeY", "-2", -2.0, [](const Scene &s) { return s.camera->eye.y; }},
    {"eyeZ", "1e1", 10.0, [](const Scene &s) { return s.camera->eye.z; }},
    {"centerX", "0,25", 0.25, [](const Scene &s) { return s.camera->center.x; }},
    {"centerZ", "-7", -7.0, [](const Scene &s) { return s.camera->center.z; }},
    {"upX", "3", 3.0, [](const Scene &s) { return s.camera->up.x; }},
    {"left", "-0.6", -0.6, [](const Scene &s) { return frustumOf(s).left; }},
    {"right", "2", 2.0, [](const Scene &s) { return frustumOf(s).right; }},
    {"bottom", "-3", -3.0, [](const Scene &s) { return frustumOf(s).bottom; }},
    {"top", "4.5", 4.5, [](const Scene &s) { return frustumOf(s).top; }},
    {"nearDistance", "0.01", 0.01, [](const Scene &s) { return frustumOf(s).nearDistance; }},
    {"farDistance", "1e6", 1e6, [](const Scene &s) { return frustumOf(s).farDistance; }},
    {"depthAtNear", "0.25", 0.25, [](const Scene &s) { return s.depthRange.atNear; }},
    {"depthAtFar", "0.5", 0.5, [](const Scene &s) { return s.depthRange.atFar; }},
};

using Prepare = void (*)(Scene &);

struct BadRow {
    const char *situation;
    Prepare prepare;
    const char *field;
    const char *text;
    const char *reason;
};

const BadRow kBadRows[] = {
    {"near-is-0", asIs, "nearDistance", "0", "Near is 0; it must be greater than 0"},
    {"near-is-far", asIs, "nearDistance", "100", "Near is 100; it must be smaller than far (100)"},
    {"near-by-an-expression", asIs, "nearDistance", "2*100", "Near is 200; it must be smaller than far (100)"},
    {"far-is-near", asIs, "farDistance", "1", "Near is 1; it must be smaller than far (1)"},
    {"near-behind-far-in-a-box", box, "nearDistance", "200", "Near is 200"},
    {"far-is-infinite", asIs, "farDistance", "1e999", "1e999 is too large or too small"},
    {"no-number", asIs, "nearDistance", "abc", "“abc” is not a number"},
    {"a-thousand-or-1", asIs, "farDistance", "1,000", "“1,000” can be read in two ways: type 1000 or 1.000"},
    {"unfinished", asIs, "nearDistance", "2*", "“2*” ends where a number is expected"},
    {"wrong-place", asIs, "nearDistance", "1//3", "“1//3”: a number is missing before “/” (character 3)"},
    {"empty", asIs, "farDistance", "", "Far is empty"},
    {"left-is-right", asIs, "left", "0.75", "Left and right are both 0.75"},
    {"bottom-is-top", asIs, "bottom", "0.25", "Bottom and top are both 0.25"},
    {"field-of-view-0", perspective, "fovy", "0", "it must lie between 0 and 180"},
    {"field-of-view-180", perspective, "fovy", "180", "it must lie between 0 and 180"},
    {"aspect-0", perspective, "aspect", "0", "The aspect is 0"},
    {"shear-0", oblique, "theta", "0", "The angle is 0 degrees"},
    {"shear-200", oblique, "phi", "200", "The angle is 200 degrees"},
    {"up-is-zero", asIs, "upY", "0", "Up is (0, 0, 0)"},
    {"eye-is-center", asIs, "eyeZ", "0", "Eye and center are the same point"},
    {"viewport-width-0", fixedViewport, "viewportWidth", "0", "The viewport is 0 × 480 pixels"},
    {"viewport-height-negative", fixedViewport, "viewportHeight", "-4", "The viewport is 640 × -4 pixels"},
    {"half-a-pixel", fixedViewport, "viewportX", "0.5", "0.5 is not a whole number of pixels"},
    {"letterbox-aspect-0", letterbox, "viewportAspect", "0", "The aspect is 0"},
    {"depth-range-empty", asIs, "depthAtNear", "1", "Both ends of the depth range are 1"},
    {"depth-beyond-1", asIs, "depthAtFar", "1.5", "The depth is 1.5; it must lie between 0 and 1"},
    {"scale-0", scaled, "number0", "0", "The scale is 0"},
    {"axis-0", rotated, "number2", "0", "The rotation axis is (0, 0, 0)"},
    {"plane-without-a-normal", cut, "number0", "0", "A, B and C of the clip plane are all 0"},
};

} // namespace

class TestParametersPanel : public QObject, PanelUser {
    Q_OBJECT

private slots:
    void init() { start(); }

    void aTypedNumberIsTheScenes_data()
    {
        addColumn<int>("row");
        int index = 0;
        for (const FieldRow &row : kFieldRows)
            newRow(row.field) << index++;
    }

    void aTypedNumberIsTheScenes()
    {
        QFETCH(int, row);
        const FieldRow &r = kFieldRows[row];
        type(QString::fromUtf8(r.field), QString::fromUtf8(r.text));
        QVERIFY2(r.read(scene()) == r.expected, qPrintable(QString::number(r.read(scene()), 'g', 17)));
        QVERIFY(!field(QString::fromUtf8(r.field))->isBad());
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), startScene()));
    }

    void aBadNumberIsRedAndTheLastGoodViewStays_data()
    {
        addColumn<int>("row");
        int index = 0;
        for (const BadRow &row : kBadRows)
            newRow(row.situation) << index++;
    }

    void aBadNumberIsRedAndTheLastGoodViewStays()
    {
        QFETCH(int, row);
        const BadRow &r = kBadRows[row];
        Scene prepared = startScene();
        r.prepare(prepared);
        open(prepared);
        const QString within = r.prepare == cut                              ? QStringLiteral("plane1")
                               : r.prepare == scaled || r.prepare == rotated ? QStringLiteral("step1")
                                                                             : QString();
        NumberField *target = field(QString::fromUtf8(r.field), within);
        const Scene before = scene();
        type(target, QString::fromUtf8(r.text));

        QVERIFY(target->isBad());
        QVERIFY2(target->reason().contains(QString::fromUtf8(r.reason)), qPrintable(target->reason()));
        QCOMPARE(target->accessibleDescription(), target->reason());
        QVERIFY(target->palette().color(QPalette::Base).red() > target->palette().color(QPalette::Base).green() + 20);
        QCOMPARE(reasonBeneath(target), target->reason());
        QVERIFY(isSameScene(scene(), before));
        QCOMPARE(m_document->undoStack().count(), 0);
        QCOMPARE(target->text(), QString::fromUtf8(r.text));

        QTest::keyClick(target, Qt::Key_Escape);
        QVERIFY(!target->isBad());
        QCOMPARE(reasonBeneath(target), QString());
        QVERIFY(!target->isTyping());
    }

    void upAlongTheViewIsRed()
    {
        type(QStringLiteral("upZ"), QStringLiteral("1"));
        QVERIFY(!field(QStringLiteral("upZ"))->isBad());
        type(QStringLiteral("upY"), QStringLiteral("0"));
        QVERIFY(field(QStringLiteral("upY"))->reason().contains(QStringLiteral("along the view direction")));
        QVERIFY(scene().camera->up == WorldVector(0.0, 1.0, 1.0));
    }

    void aRedNumberStaysUntilEscape()
    {
        NumberField *nearField = field(QStringLiteral("nearDistance"));
        type(nearField, QStringLiteral("500"));
        field(QStringLiteral("top"))->setFocus();
        QVERIFY(nearField->isBad());
        QCOMPARE(nearField->text(), QStringLiteral("500"));
        QCOMPARE(frustumOf(scene()).nearDistance, 1.0);
        nearField->setFocus();
        QTest::keyClick(nearField, Qt::Key_Escape);
        QVERIFY(!nearField->isBad());
        QCOMPARE(nearField->text(), QStringLiteral("1"));
    }

    void nearAndFarMovePastEachOther()
    {
        NumberField *nearField = field(QStringLiteral("nearDistance"));
        NumberField *farField = field(QStringLiteral("farDistance"));
        type(nearField, QStringLiteral("200"));
        QVERIFY(nearField->isBad());
        type(farField, QStringLiteral("300"));
        QVERIFY(!nearField->isBad());
        QVERIFY(!farField->isBad());
        QCOMPARE(frustumOf(scene()).nearDistance, 200.0);
        QCOMPARE(frustumOf(scene()).farDistance, 300.0);
        QCOMPARE(nearField->text(), QStringLiteral("200"));
        // The far's own edit takes both back.
        m_document->undoStack().undo();
        QCOMPARE(frustumOf(scene()).nearDistance, 1.0);
        QCOMPARE(frustumOf(scene()).farDistance, 100.0);
        m_document->undoStack().redo();
        QCOMPARE(frustumOf(scene()).nearDistance, 200.0);
    }

    void aPlaneTurnsByTwoNumbers()
    {
        Scene prepared = startScene();
        cut(prepared);
        open(prepared);
        showGroup(QStringLiteral("clipGroup"));
        type(field(QStringLiteral("number0"), QStringLiteral("plane1")), QStringLiteral("0"));
        QCOMPARE(scene().clipPlanes.at(0).x, 1.0);
        type(field(QStringLiteral("number1"), QStringLiteral("plane1")), QStringLiteral("-1"));
        // The -1 makes both valid.
        QVERIFY(scene().clipPlanes.at(0) == glm::dvec4(0.0, -1.0, 0.0, 0.5));
        QVERIFY(!field(QStringLiteral("number0"), QStringLiteral("plane1"))->isBad());
    }

    void whatStillCannotBeTakenStaysRed()
    {
        NumberField *nearField = field(QStringLiteral("nearDistance"));
        type(nearField, QStringLiteral("200"));
        type(QStringLiteral("farDistance"), QStringLiteral("150"));
        QCOMPARE(frustumOf(scene()).farDistance, 150.0);
        QCOMPARE(frustumOf(scene()).nearDistance, 1.0);
        QVERIFY(nearField->isBad());
        QVERIFY2(nearField->reason().contains(QStringLiteral("far (150)")), qPrintable(nearField->reason()));
        // Two refused numbers, of which the next edit makes only one valid.
        type(QStringLiteral("left"), QStringLiteral("0.75"));
        QVERIFY(field(QStringLiteral("left"))->isBad());
        type(QStringLiteral("right"), QStringLiteral("1"));
        QVERIFY(!field(QStringLiteral("left"))->isBad());
        QVERIFY(nearField->isBad());
        QCOMPARE(frustumOf(scene()).left, 0.75);
    }

    void whatCanBeTakenAfterAllWaitsForEnter()
    {
        NumberField *nearField = field(QStringLiteral("nearDistance"));
        type(nearField, QStringLiteral("150"));
        QVERIFY(nearField->isBad());
        Frustum longer = frustumOf(scene());
        longer.farDistance = 1000.0;
        QVERIFY(editProjection(*m_document, {longer, false, false}, {QStringLiteral("by another")}));
        QCOMPARE(frustumOf(scene()).nearDistance, 1.0);
        QVERIFY2(nearField->reason().contains(QStringLiteral("press Enter")), qPrintable(nearField->reason()));
        QTest::keyClick(nearField, Qt::Key_Return);
        QCOMPARE(frustumOf(scene()).nearDistance, 150.0);
        QVERIFY(!nearField->isBad());
    }

    void aHalfTypedNumberIsNotApplied()
    {
        NumberField *nearField = field(QStringLiteral("nearDistance"));
        begin(nearField, QStringLiteral("9"));
        QVERIFY(isSameScene(scene(), startScene()));
        QTest::keyClicks(nearField, QStringLiteral("9"));
        QVERIFY(isSameScene(scene(), startScene()));
        QVERIFY(!nearField->isBad());
        QTest::keyClick(nearField, Qt::Key_Tab);
        QCOMPARE(frustumOf(scene()).nearDistance, 99.0);
        QCOMPARE(m_document->undoStack().count(), 1);
        begin(nearField, QStringLiteral("5"));
        QTest::keyClick(nearField, Qt::Key_Escape);
        QCOMPARE(nearField->text(), QStringLiteral("99"));
        QTest::keyClick(nearField, Qt::Key_Tab);
        QCOMPARE(frustumOf(scene()).nearDistance, 99.0);
        QCOMPARE(m_document->undoStack().count(), 1);
    }

    void expressionsAreTaken()
    {
        type(QStringLiteral("nearDistance"), QStringLiteral("1/3"));
        QVERIFY(frustumOf(scene()).nearDistance == 1.0 / 3.0);
        QCOMPARE(field(QStringLiteral("nearDistance"))->text(), QStringLiteral("0.3333333333333333"));
        type(QStringLiteral("farDistance"), QStringLiteral("2*pi"));
        QVERIFY(frustumOf(scene()).farDistance == 6.283185307179586);
        QCOMPARE(m_document->undoStack().count(), 2);
    }

    void whatIsTypedCountsForWhoAsks()
    {
        begin(field(QStringLiteral("nearDistance")), QStringLiteral("7"));
        m_panel->applyTyped();
        QCOMPARE(frustumOf(scene()).nearDistance, 7.0);
    }

    void theReasonGoesWhenTheTextIsRight()
    {
        NumberField *nearField = field(QStringLiteral("nearDistance"));
        type(nearField, QStringLiteral("200"));
        QVERIFY(!reasonBeneath(nearField).isEmpty());
        QTest::keyClick(nearField, Qt::Key_End);
        QTest::keyClick(nearField, Qt::Key_Backspace);
        QCOMPARE(nearField->text(), QStringLiteral("20"));
        QVERIFY(!nearField->isBad());
        QCOMPARE(reasonBeneath(nearField), QString());
        QCOMPARE(frustumOf(scene()).nearDistance, 1.0);
        QTest::keyClick(nearField, Qt::Key_Return);
        QCOMPARE(frustumOf(scene()).nearDistance, 20.0);
    }

    void lookingChangesNothing()
    {
        Scene prepared = startScene();
        perspective(prepared);
        auto perspective = std::get<Perspective>(*prepared.projection);
        perspective.verticalFov = 0.77777777777777779;
        prepared.projection = perspective;
        prepared.camera = {WorldPoint(0.1 + 0.2, 1.0 / 3.0, 1e20 / 3.0), prepared.camera->center, prepared.camera->up};
        prepared.clipPlanes = {{1.0 / 3.0, 0.1 + 0.2, -0.0, 1e-300}};
        rotated(prepared);
        open(prepared);
        for (const char *group : {"viewGroup", "projectionGroup", "viewportGroup", "modelGroup", "clipGroup"})
            showGroup(QString::fromLatin1(group));
        NumberField *first = field(QStringLiteral("eyeX"));
        first->setFocus();
        int fields = 0;
        do {
            QWidget *focus = QApplication::focusWidget();
            fields += qobject_cast<NumberField *>(focus) ? 1 : 0;
            if (qobject_cast<NumberField *>(focus))
                QTest::keyClick(focus, Qt::Key_Return);
            QTest::keyClick(focus, Qt::Key_Tab);
        } while (QApplication::focusWidget() != first);
        QVERIFY2(fields >= 20, qPrintable(QString::number(fields)));
        QCOMPARE(m_document->undoStack().count(), 0);
        QVERIFY(isSameScene(scene(), prepared));
    }

    void stepsInARowAreUndoneAsOne()
    {
        NumberField *top = field(QStringLiteral("top"));
        type(top, QStringLiteral("1.25"));
        QTest::keyClick(top, Qt::Key_Up);
        QTest::keyClick(top, Qt::Key_Up);
        QCOMPARE(frustumOf(scene()).top, 1.45);
        QCOMPARE(m_document->undoStack().count(), 2);
        QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Top"));
        m_document->undoStack().undo();
        QCOMPARE(frustumOf(scene()).top, 1.25);
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), startScene()));
        m_document->undoStack().redo();
        QCOMPARE(frustumOf(scene()).top, 1.25);
    }

    void theDigitUnderTheCaretIsStepped()
    {
        NumberField *top = field(QStringLiteral("top"));
        type(top, QStringLiteral("12.38"));
        top->setCursorPosition(4);
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(top, Qt::Key_Up);
        QCOMPARE(frustumOf(scene()).top, 12.41);
        QCOMPARE(top->text(), QStringLiteral("12.41"));
        QTest::keyClick(top, Qt::Key_Down);
        QCOMPARE(top->text(), QStringLiteral("12.40")); // the digit stays in sight
        QCOMPARE(top->cursorPosition(), 4);
        QTest::keyClick(top, Qt::Key_PageDown);
        QCOMPARE(frustumOf(scene()).top, 12.3);
        QCOMPARE(m_document->undoStack().count(), 2);
        top->clearFocus();
        QCOMPARE(top->text(), QStringLiteral("12.3"));
    }

    void editsOfTwoFieldsAreUndoneOneByOne()
    {
        type(QStringLiteral("top"), QStringLiteral("12"));
        type(QStringLiteral("bottom"), QStringLiteral("-1"));
        type(QStringLiteral("top"), QStringLiteral("34"));
        QCOMPARE(m_document->undoStack().count(), 3);
        m_document->undoStack().undo();
        QCOMPARE(frustumOf(scene()).top, 12.0);
        m_document->undoStack().undo();
        QCOMPARE(frustumOf(scene()).bottom, -0.375);
        QCOMPARE(frustumOf(scene()).top, 12.0);
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), startScene()));
        // The same field after the focus was elsewhere and nothing else was changed.
        type(QStringLiteral("top"), QStringLiteral("5"));
        field(QStringLiteral("bottom"))->setFocus();
        type(QStringLiteral("top"), QStringLiteral("6"));
        QCOMPARE(m_document->undoStack().count(), 2);
    }

    void anUndoIsSeenInTheFieldBeingTyped()
    {
        NumberField *top = field(QStringLiteral("top"));
        type(top, QStringLiteral("12"));
        m_document->undoStack().undo();
        QCOMPARE(top->text(), QStringLiteral("0.25"));
        m_document->undoStack().redo();
        QCOMPARE(top->text(), QStringLiteral("12"));
    }

    void typingTheSameNumberIsNoChange()
    {
        type(QStringLiteral("top"), QStringLiteral("0.250"));
        QCOMPARE(field(QStringLiteral("top"))->text(), QStringLiteral("0.25"));
        type(QStringLiteral("eyeZ"), QStringLiteral("2*5"));
        type(QStringLiteral("farDistance"), QStringLiteral("1e2"));
        QVERIFY(!field(QStringLiteral("farDistance"))->isBad());
        QCOMPARE(m_document->undoStack().count(), 0);
    }

    void aHiddenPanelDoesNothingUntilItIsShown()
    {
        NumberField *eye = field(QStringLiteral("eyeX"));
        m_panel->hide();
        LookAt camera = scene().camera;
        camera.eye.x = 3.0;
        QVERIFY(editCamera(*m_document, camera, {QStringLiteral("by another")}));
        QCOMPARE(eye->text(), QStringLiteral("0"));
        m_panel->show();
        QCOMPARE(eye->text(), QStringLiteral("3"));
    }

    void theDepthRangeThatOpenGlTakesIsShown()
    {
        const auto shown = [this] {
            for (const QLabel *label : m_panel->findChildren<QLabel *>()) {
                if (label->accessibleName() == QStringLiteral("Depth range in use"))
                    return label->text();
            }
            return QString();
        };
        type(QStringLiteral("depthAtNear"), QStringLiteral("0.25"));
        QCOMPARE(shown(), QStringLiteral("glDepthRangef(0.25, 1)"));
        type(QStringLiteral("depthAtFar"), QStringLiteral("0.65"));
        QVERIFY(scene().depthRange.atFar == 0.65);
        QCOMPARE(shown(), QStringLiteral("glDepthRangef(0.25, 0.649999976)"));
    }
};

UNPROJECTOR_TEST(TestParametersPanel)
#include "test_parameters_panel.moc"
