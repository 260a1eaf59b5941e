// A field for one number, by itself: what it reads, what it shows, how it steps, and when it leaves the user's text alone.

#include "core/geometry/angle.h"
#include "gui/panels/parameters/number_field.h"

#include <QTest>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;

class TestNumberField : public QObject {
    Q_OBJECT

private slots:
    void init();
    void aTextIsReadAsANumber_data();
    void aTextIsReadAsANumber();
    void degreesComeBackWithoutNoise_data();
    void degreesComeBackWithoutNoise();
    void withoutTheFocusItShowsSevenDigits_data();
    void withoutTheFocusItShowsSevenDigits();
    void withTheFocusItShowsAllDigits();
    void aNarrowFieldShowsFewerDigits();
    void arrowKeysStep_data();
    void arrowKeysStep();
    void theWheelStepsOnlyWithTheFocus();
    void theSameNumberLeavesTextAndCursor();
    void anotherNumberReplacesWhatIsTyped();
    void aRefusedTextStaysUntilTheValueChanges();
    void escapeRestoresARefusedText_data();
    void escapeRestoresARefusedText();
    void undoIsLeftToTheWindow();
    void theReasonIsTold();
    void everyFocusIsASessionOfItsOwn();

private:
    std::unique_ptr<QWidget> m_window;
    NumberField *m_field = nullptr;
    QLineEdit *m_other = nullptr;
};

void TestNumberField::init()
{
    m_window = std::make_unique<QWidget>();
    auto *layout = new QVBoxLayout(m_window.get());
    m_other = new QLineEdit;
    m_field = new NumberField(QStringLiteral("Near"), QStringLiteral("Distance of the near plane, eye units"));
    layout->addWidget(m_other);
    layout->addWidget(m_field);
    m_window->resize(300, 100);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_other->setFocus();
}

void TestNumberField::aTextIsReadAsANumber_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isNumber");
    QTest::addColumn<double>("value");
    QTest::newRow("whole") << "12" << true << 12.0;
    QTest::newRow("decimal-point") << "0.25" << true << 0.25;
    QTest::newRow("decimal-comma") << "0,25" << true << 0.25;
    QTest::newRow("no-leading-zero") << ".5" << true << 0.5;
    QTest::newRow("exponent") << "1e-3" << true << 0.001;
    QTest::newRow("blanks-around") << "  7 " << true << 7.0;
    QTest::newRow("typographic-minus") << QStringLiteral("−3.5") << true << -3.5;
    QTest::newRow("infinity") << "inf" << true << std::numeric_limits<double>::infinity();
    QTest::newRow("empty") << "" << false << 0.0;
    QTest::newRow("only-a-minus") << "-" << false << 0.0;
    QTest::newRow("unfinished-exponent") << "1e" << false << 0.0;
    QTest::newRow("word") << "abc" << false << 0.0;
    QTest::newRow("comma-and-point") << "1,234.5" << false << 0.0;
    QTest::newRow("two-commas") << "1,2,3" << false << 0.0;
    QTest::newRow("two-numbers") << "1 2" << false << 0.0;
}

void TestNumberField::aTextIsReadAsANumber()
{
    QFETCH(QString, text);
    QFETCH(bool, isNumber);
    QFETCH(double, value);
    const std::optional<double> number = numberFromText(text);
    QCOMPARE(number.has_value(), isNumber);
    if (isNumber)
        QVERIFY2(*number == value, qPrintable(QString::number(*number, 'g', 17)));
}

void TestNumberField::degreesComeBackWithoutNoise_data()
{
    QTest::addColumn<double>("degrees");
    for (const double degrees : {0.1, 29.0, 30.0, 45.0, 57.3, 60.0, 90.0, 123.456, 179.99})
        QTest::newRow(qPrintable(QString::number(degrees))) << degrees;
}

void TestNumberField::degreesComeBackWithoutNoise()
{
    QFETCH(double, degrees);
    QVERIFY(degreesFromRadians(radiansFromDegrees(degrees)) == degrees);
}

void TestNumberField::withoutTheFocusItShowsSevenDigits_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("whole") << 5.0 << "5";
    QTest::newRow("short") << 0.1 << "0.1";
    QTest::newRow("third") << 1.0 / 3.0 << "0.3333333";
    QTest::newRow("large") << 123456789.0 << "1.234568e+08";
    QTest::newRow("small") << 1.5e-12 << "1.5e-12";
    QTest::newRow("rounding-noise") << 0.1 + 0.2 << "0.3";
    QTest::newRow("negative-zero") << -0.0 << "0";
}

void TestNumberField::withoutTheFocusItShowsSevenDigits()
{
    QFETCH(double, value);
    m_field->setValue(value);
    QTEST(m_field->text(), "text");
}

void TestNumberField::withTheFocusItShowsAllDigits()
{
    m_field->setValue(1.0 / 3.0);
    m_field->setFocus();
    QCOMPARE(m_field->text(), QStringLiteral("0.3333333333333333"));
    m_other->setFocus();
    QCOMPARE(m_field->text(), QStringLiteral("0.3333333"));
}

void TestNumberField::aNarrowFieldShowsFewerDigits()
{
    m_field->setValue(-1.0 / 3.0);
    m_field->setFixedWidth(m_field->fontMetrics().horizontalAdvance(QStringLiteral("-0.3333")) + 20);
    QTRY_VERIFY(m_field->text().size() < QStringLiteral("-0.3333333").size());
    QVERIFY2(m_field->text().startsWith(QStringLiteral("-0.33")), qPrintable(m_field->text()));
    QVERIFY(m_field->value() == -1.0 / 3.0);
}

void TestNumberField::arrowKeysStep_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("fixedStep");
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<bool>("withShift");
    QTest::addColumn<QString>("text");
    const double relative = 0.0;
    QTest::newRow("up-from-1") << 1.0 << relative << Qt::Key_Up << false << "1.1";
    QTest::newRow("down-from-1") << 1.0 << relative << Qt::Key_Down << false << "0.99";
    QTest::newRow("up-from-10") << 10.0 << relative << Qt::Key_Up << false << "11";
    QTest::newRow("shift-up-from-1") << 1.0 << relative << Qt::Key_Up << true << "2";
    QTest::newRow("shift-down-from-1-stays-positive") << 1.0 << relative << Qt::Key_Down << true << "0.9";
    QTest::newRow("up-from-minus-1") << -1.0 << relative << Qt::Key_Up << false << "-0.99";
    QTest::newRow("down-from-minus-1") << -1.0 << relative << Qt::Key_Down << false << "-1.1";
    QTest::newRow("up-from-0") << 0.0 << relative << Qt::Key_Up << false << "0.1";
    QTest::newRow("no-rounding-noise") << 0.2 << 0.1 << Qt::Key_Up << false << "0.3";
    QTest::newRow("fixed-reaches-0") << 0.1 << 0.1 << Qt::Key_Down << false << "0";
    QTest::newRow("fixed-passes-0") << 0.0 << 0.1 << Qt::Key_Down << false << "-0.1";
    QTest::newRow("a-pixel") << 640.0 << 1.0 << Qt::Key_Up << false << "641";
    QTest::newRow("ten-pixels") << 640.0 << 1.0 << Qt::Key_Down << true << "630";
}

void TestNumberField::arrowKeysStep()
{
    QFETCH(double, value);
    QFETCH(double, fixedStep);
    QFETCH(Qt::Key, key);
    QFETCH(bool, withShift);
    if (fixedStep > 0.0)
        m_field->setFixedStep(fixedStep);
    m_field->setValue(value);
    m_field->setFocus();
    int edits = 0;
    connect(m_field, &NumberField::edited, this, [&] { ++edits; });
    QTest::keyClick(m_field, key, withShift ? Qt::ShiftModifier : Qt::NoModifier);
    QTEST(m_field->text(), "text");
    QCOMPARE(edits, 1);
}

void TestNumberField::theWheelStepsOnlyWithTheFocus()
{
    const auto turn = [this](int angle) {
        const QPointF position(5.0, 5.0);
        QWheelEvent event(position, m_field->mapToGlobal(position), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_field, &event);
        return event.isAccepted();
    };
    m_field->setValue(5.0);
    QVERIFY(!turn(120));
    QCOMPARE(m_field->text(), QStringLiteral("5"));
    m_field->setFocus();
    QVERIFY(turn(120));
    QCOMPARE(m_field->text(), QStringLiteral("5.1"));
    m_field->setValue(5.1);
    QVERIFY(turn(60)); // a touchpad's half a step
    QCOMPARE(m_field->text(), QStringLiteral("5.1"));
    QVERIFY(turn(60));
    QCOMPARE(m_field->text(), QStringLiteral("5.2"));
}

void TestNumberField::theSameNumberLeavesTextAndCursor()
{
    m_field->setFocus();
    m_field->selectAll();
    QTest::keyClicks(m_field, QStringLiteral("1.500"));
    m_field->setCursorPosition(2);
    m_field->setValue(1.5);
    QCOMPARE(m_field->text(), QStringLiteral("1.500"));
    QCOMPARE(m_field->cursorPosition(), 2);
    m_field->setValue(1.5);
    QCOMPARE(m_field->text(), QStringLiteral("1.500"));
    m_other->setFocus();
    QCOMPARE(m_field->text(), QStringLiteral("1.5"));
}

void TestNumberField::anotherNumberReplacesWhatIsTyped()
{
    m_field->setFocus();
    m_field->selectAll();
    QTest::keyClicks(m_field, QStringLiteral("3"));
    m_field->setValue(3.0);
    m_field->setValue(4.0);
    QCOMPARE(m_field->text(), QStringLiteral("4"));
}

void TestNumberField::aRefusedTextStaysUntilTheValueChanges()
{
    m_field->setValue(1.0);
    m_field->setFocus();
    m_field->selectAll();
    QTest::keyClicks(m_field, QStringLiteral("200"));
    m_field->setReason(QStringLiteral("Too large."));
    m_field->setValue(1.0);
    m_other->setFocus();
    QVERIFY(m_field->isBad());
    QCOMPARE(m_field->text(), QStringLiteral("200"));
    m_field->setFocus();
    QCOMPARE(m_field->text(), QStringLiteral("200"));
    m_field->setValue(2.0);
    QVERIFY(!m_field->isBad());
    QCOMPARE(m_field->text(), QStringLiteral("2"));
}

void TestNumberField::escapeRestoresARefusedText_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("escape") << Qt::Key_Escape << Qt::KeyboardModifiers(Qt::NoModifier);
    QTest::newRow("undo") << Qt::Key_Z << Qt::KeyboardModifiers(Qt::ControlModifier);
}

void TestNumberField::escapeRestoresARefusedText()
{
    QFETCH(Qt::Key, key);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    m_field->setValue(0.1);
    m_field->setFocus();
    m_field->selectAll();
    QTest::keyClicks(m_field, QStringLiteral("x"));
    m_field->setReason(QStringLiteral("No number."));
    QTest::keyClick(m_field, key, modifiers);
    QVERIFY(!m_field->isBad());
    QCOMPARE(m_field->text(), QStringLiteral("0.1"));
}

void TestNumberField::undoIsLeftToTheWindow()
{
    m_field->setValue(1.0);
    m_field->setFocus();
    m_field->selectAll();
    QTest::keyClicks(m_field, QStringLiteral("2"));
    m_field->setValue(2.0);
    QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    undo.ignore();
    QCoreApplication::sendEvent(m_field, &undo);
    QVERIFY(!undo.isAccepted()); // so that the window's own Undo gets the key
    QTest::keyClick(m_field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_field->text(), QStringLiteral("2"));
}

void TestNumberField::theReasonIsTold()
{
    const QColor good = m_field->palette().color(QPalette::Base);
    m_field->setValue(1.0 / 3.0);
    const auto toolTip = [this] {
        QHelpEvent event(QEvent::ToolTip, {5, 5}, m_field->mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(m_field, &event);
        return m_field->toolTip();
    };
    QVERIFY2(toolTip().contains(QStringLiteral("0.3333333333333333")), qPrintable(toolTip()));
    QVERIFY(toolTip().contains(QStringLiteral("eye units")));
    QCOMPARE(m_field->accessibleDescription(), QStringLiteral("Distance of the near plane, eye units"));

    m_field->setReason(QStringLiteral("Too near."));
    QVERIFY(toolTip().contains(QStringLiteral("Too near.")));
    QCOMPARE(m_field->accessibleDescription(), QStringLiteral("Too near."));
    const QColor bad = m_field->palette().color(QPalette::Base);
    QVERIFY(bad.red() > bad.green() + 20 && bad.red() > bad.blue() + 20);

    m_field->setReason({});
    QCOMPARE(m_field->palette().color(QPalette::Base), good);
    QCOMPARE(m_field->accessibleDescription(), QStringLiteral("Distance of the near plane, eye units"));
    QToolTip::hideText();
}

void TestNumberField::everyFocusIsASessionOfItsOwn()
{
    m_field->setFocus();
    const quint64 first = m_field->session();
    QTest::keyClicks(m_field, QStringLiteral("12"));
    QCOMPARE(m_field->session(), first);
    m_other->setFocus();
    m_field->setFocus();
    QVERIFY(m_field->session() != first);
}

QTEST_MAIN(TestNumberField)
#include "test_number_field.moc"
