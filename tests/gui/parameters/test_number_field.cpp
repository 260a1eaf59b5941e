// A field for one number, by itself: its parsing, its display, its steps, and its care for the
// user's text.

#include "tests/support/test.h"

#include "core/geometry/numbers.h"
#include "gui/parameters/digit_step.h"
#include "gui/parameters/number_field.h"
#include "tests/support/patience.h"

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
    void init()
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
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kPatienceMilliseconds));
        m_other->setFocus();
    }

    void degreesComeBackWithoutNoise_data()
    {
        addColumn<double>("degrees");
        for (const double degrees : {0.1, 29.0, 30.0, 45.0, 57.3, 60.0, 90.0, 123.456, 179.99})
            newRow(qPrintable(QString::number(degrees))) << degrees;
    }

    void degreesComeBackWithoutNoise()
    {
        QFETCH(double, degrees);
        QVERIFY(degreesFromRadians(radiansFromDegrees(degrees)) == degrees);
    }

    void theValueIsWrittenToBeRead_data()
    {
        addColumn<double>("value");
        addColumn<QString>("text");
        newRow("whole") << 5.0 << "5";
        newRow("short") << 0.1 << "0.1";
        newRow("third") << 1.0 / 3.0 << "0.3333333333333333";
        newRow("round-and-large") << 80000.0 << "80000";
        newRow("million") << 1e6 << "1000000";
        newRow("large") << 123456789.0 << "123456789";
        newRow("too-large-to-read") << 1e12 << "1e+12";
        newRow("small") << 1e-5 << "0.00001";
        newRow("too-small-to-read") << 1.5e-12 << "1.5e-12";
        newRow("rounding-noise") << 0.1 + 0.2 << "0.30000000000000004";
        newRow("negative-zero") << -0.0 << "0";
    }

    void theValueIsWrittenToBeRead()
    {
        QFETCH(double, value);
        m_field->setValue(value);
        QTEST(m_field->text(), "text");
    }

    void withTheFocusItShowsAllDigits()
    {
        m_field->setValue(1.0 / 3.0);
        m_field->setFocus();
        QCOMPARE(m_field->text(), QStringLiteral("0.3333333333333333"));
        m_other->setFocus();
        QCOMPARE(m_field->text(), QStringLiteral("0.3333333333333333"));
        m_field->setFixedWidth(m_field->minimumSizeHint().width());
        QTRY_VERIFY_WITH_TIMEOUT(m_field->text().size() < 18, kPatienceMilliseconds);
        m_field->setFocus();
        QCOMPARE(m_field->text(), QStringLiteral("0.3333333333333333"));
        QVERIFY(!m_field->isTyping());
    }

    void aNarrowFieldShowsFewerDigits()
    {
        m_field->setValue(-1.0 / 3.0);
        m_field->setFixedWidth(m_field->fontMetrics().horizontalAdvance(QStringLiteral("-0.3333")) + 20);
        QTRY_VERIFY_WITH_TIMEOUT(m_field->text().size() <= QStringLiteral("-0.3333333").size(), kPatienceMilliseconds);
        QVERIFY2(m_field->text().startsWith(QStringLiteral("-0.33")), qPrintable(m_field->text()));
        QVERIFY(m_field->value() == -1.0 / 3.0);
    }

    void arrowKeysStep_data()
    {
        addColumn<double>("value");
        addColumn<double>("fixedStep");
        addColumn<Qt::Key>("key");
        addColumn<bool>("withShift");
        addColumn<QString>("text");
        const double relative = 0.0;
        newRow("up-from-1") << 1.0 << relative << Qt::Key_Up << false << "1.1";
        newRow("down-from-1") << 1.0 << relative << Qt::Key_Down << false << "0.99";
        newRow("up-from-10") << 10.0 << relative << Qt::Key_Up << false << "11";
        newRow("shift-up-from-1") << 1.0 << relative << Qt::Key_Up << true << "2";
        newRow("shift-down-from-1-stays-positive") << 1.0 << relative << Qt::Key_Down << true << "0.9";
        newRow("up-from-minus-1") << -1.0 << relative << Qt::Key_Up << false << "-0.99";
        newRow("down-from-minus-1") << -1.0 << relative << Qt::Key_Down << false << "-1.1";
        newRow("up-from-0") << 0.0 << relative << Qt::Key_Up << false << "0.1";
        newRow("no-rounding-noise") << 0.2 << 0.1 << Qt::Key_Up << false << "0.3";
        newRow("fixed-reaches-0") << 0.1 << 0.1 << Qt::Key_Down << false << "0";
        newRow("fixed-passes-0") << 0.0 << 0.1 << Qt::Key_Down << false << "-0.1";
        newRow("a-pixel") << 640.0 << 1.0 << Qt::Key_Up << false << "641";
        newRow("ten-pixels") << 640.0 << 1.0 << Qt::Key_Down << true << "630";
    }

    void arrowKeysStep()
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
        connect(m_field, &NumberField::committed, this, [&] { ++edits; });
        QTest::keyClick(m_field, key, withShift ? Qt::ShiftModifier : Qt::NoModifier);
        QTEST(m_field->text(), "text");
        QCOMPARE(edits, 1);
    }

    void theWheelStepsOnlyWithTheFocusOrCtrl()
    {
        const auto turn = [this](int angle, Qt::KeyboardModifier held = Qt::NoModifier) {
            const QPointF position(5.0, 5.0);
            QWheelEvent event(position, m_field->mapToGlobal(position), {}, {0, angle}, Qt::NoButton, held,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(m_field, &event);
            return event.isAccepted();
        };
        m_field->setValue(5.0);
        QVERIFY(!turn(120));
        QCOMPARE(m_field->text(), QStringLiteral("5"));
        QVERIFY(turn(-120, Qt::ControlModifier));
        QCOMPARE(m_field->text(), QStringLiteral("4.9"));
        m_field->restore();
        m_field->setFocus();
        QVERIFY(turn(120));
        QCOMPARE(m_field->text(), QStringLiteral("5.1"));
        m_field->setValue(5.1);
        QVERIFY(turn(60)); // a touchpad's half a step
        QCOMPARE(m_field->text(), QStringLiteral("5.1"));
        QVERIFY(turn(60));
        QCOMPARE(m_field->text(), QStringLiteral("5.2"));
    }

    void theSameNumberLeavesWhatIsTyped()
    {
        m_field->setValue(1.5);
        m_field->setFocus();
        QTest::keyClicks(m_field, QStringLiteral("1.500"));
        m_field->setCursorPosition(2);
        m_field->setValue(1.5);
        QCOMPARE(m_field->text(), QStringLiteral("1.500"));
        QCOMPARE(m_field->cursorPosition(), 2);
    }

    void anotherNumberReplacesWhatIsTyped()
    {
        m_field->setFocus();
        QTest::keyClicks(m_field, QStringLiteral("3"));
        m_field->setValue(4.0);
        QCOMPARE(m_field->text(), QStringLiteral("4"));
        QVERIFY(!m_field->isTyping());
    }

    void typingIsFinishedBy_data()
    {
        addColumn<int>("way");
        addColumn<int>("commits");
        newRow("enter") << 0 << 1;
        newRow("tab") << 1 << 1;
        newRow("focus-elsewhere") << 2 << 1;
        newRow("the-window-s-shortcut") << 3 << 1;
        newRow("another-character") << 4 << 0;
        newRow("escape") << 5 << 0;
        newRow("copying") << 6 << 0;
        newRow("enter-and-tab") << 7 << 1;
        newRow("another-window-of-the-program") << 8 << 1;
    }

    void typingIsFinishedBy()
    {
        QFETCH(int, way);
        int commits = 0;
        connect(m_field, &NumberField::committed, this, [&] { ++commits; });
        m_field->setValue(3.0);
        m_field->setFocus();
        QTest::keyClick(m_field, Qt::Key_Return);
        QTest::keyClick(m_field, Qt::Key_Tab);
        m_field->setFocus();
        QCOMPARE(commits, 0); // nothing was typed
        QTest::keyClicks(m_field, QStringLiteral("1/3"));
        QCOMPARE(commits, 0);
        const auto shortcut = [this](Qt::Key key) {
            QKeyEvent event(QEvent::ShortcutOverride, key, Qt::ControlModifier);
            event.ignore();
            QCoreApplication::sendEvent(m_field, &event);
        };
        switch (way) {
        case 0: QTest::keyClick(m_field, Qt::Key_Return); break;
        case 1: QTest::keyClick(m_field, Qt::Key_Tab); break;
        case 2: m_other->setFocus(); break;
        case 3: shortcut(Qt::Key_S); break;
        case 4: QTest::keyClick(m_field, Qt::Key_3); break;
        case 5:
            QTest::keyClick(m_field, Qt::Key_Escape);
            QCOMPARE(m_field->text(), QStringLiteral("3"));
            QTest::keyClick(m_field, Qt::Key_Tab);
            break;
        case 6: shortcut(Qt::Key_C); break;
        case 8: {
            QWidget window;
            window.show();
            window.activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(&window, kPatienceMilliseconds));
            QTRY_COMPARE_WITH_TIMEOUT(commits, 1, kPatienceMilliseconds);
            break;
        }
        case 7:
            QTest::keyClick(m_field, Qt::Key_Return);
            m_field->setReason(QStringLiteral("Refused."));
            QTest::keyClick(m_field, Qt::Key_Tab); // it was asked for once
            break;
        }
        QTEST(commits, "commits");
        if (commits > 0)
            QVERIFY(*m_field->typed() == 1.0 / 3.0);
    }

    void theDigitAtTheCaretIsStepped_data()
    {
        addColumn<QString>("before"); // the caret is the bar
        addColumn<int>("steps");
        addColumn<QString>("after");
        newRow("hundredths") << "12.3|4" << 1 << "12.3|5";
        newRow("hundredths-at-the-end") << "12.34|" << 1 << "12.35|";
        newRow("tenths-behind-the-point") << "12.|34" << -1 << "12.|24";
        newRow("ones-before-the-point") << "12|.34" << 1 << "13|.34";
        newRow("tens") << "|12.34" << -1 << "|2.34";
        newRow("carries") << "9.|9" << 1 << "10.|0";
        newRow("a-digit-more") << "|9" << 1 << "1|0";
        newRow("zeros-stay") << "0.1|9" << 1 << "0.2|0";
        newRow("through-0") << "0.0|5" << -10 << "-0.0|5";
        newRow("to-0") << "-0|.5" << 1 << "0|.5";
        newRow("before-the-sign") << "|-5" << 1 << "-|4";
        newRow("never-minus-0") << "-|1" << 1 << "|0";
        newRow("power-of-ten") << "1.|5e-12" << 1 << "1.|6e-12";
        newRow("in-the-power") << "1.5e-|12" << 1 << "1.6|e-12";
        newRow("no-noise") << "0.|1" << 2 << "0.|3";
        newRow("all-digits-stay") << "0.3|333333333333333" << 1 << "0.3|433333333333333";
        newRow("decimal-comma") << "1,|5" << 1 << "1.|6";
        newRow("no-leading-zero") << ".|5" << 1 << "0.|6";
    }

    void theDigitAtTheCaretIsStepped()
    {
        QFETCH(QString, before);
        QFETCH(int, steps);
        QFETCH(QString, after);
        const CaretText start{QString(before).remove(u'|'), static_cast<int>(before.indexOf(u'|'))};
        const std::optional<int> place = digitAt(start);
        QVERIFY(place);
        CaretText end = withDigitStepped(start, *place, steps);
        QCOMPARE(end.text.insert(end.caret, u'|'), after);
    }

    void onlyPlainNumbersHaveDigits()
    {
        for (const char *text : {"", "1/3", "abc", "-", ".", "2*7"})
            QVERIFY2(!digitAt({QString::fromLatin1(text), 0}), text);
    }

    void stepsGoOnAtTheSameDigit()
    {
        connect(m_field, &NumberField::committed, this, [this] { m_field->accept(*m_field->typed()); });
        m_field->setValue(120.0);
        m_field->setFocus();
        m_field->setCursorPosition(0); // the hundreds
        const quint64 session = m_field->session();
        QTest::keyClick(m_field, Qt::Key_Down);
        QCOMPARE(m_field->text(), QStringLiteral("20"));
        QTest::keyClick(m_field, Qt::Key_Up);
        QTest::keyClick(m_field, Qt::Key_Up);
        QCOMPARE(m_field->text(), QStringLiteral("220"));
        QTest::keyClick(m_field, Qt::Key_PageUp);
        QCOMPARE(m_field->text(), QStringLiteral("1220"));
        const quint64 stepped = m_field->session();
        QVERIFY(stepped != session);
        m_field->setCursorPosition(3);
        QTest::keyClick(m_field, Qt::Key_PageDown);
        QCOMPARE(m_field->text(), QStringLiteral("1210"));
        QCOMPARE(m_field->session(), stepped);
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("7"));
        QTest::keyClick(m_field, Qt::Key_Return);
        QVERIFY(m_field->session() != stepped); // a typed number is undone by itself
    }

    void theHeadOfALongNumberIsInSight()
    {
        m_field->setFixedWidth(m_field->minimumSizeHint().width());
        m_field->setValue(-1.0 / 3.0);
        QTest::keyClick(m_other, Qt::Key_Tab);
        QVERIFY(m_field->hasFocus());
        QCOMPARE(m_field->selectedText(), QStringLiteral("-0.3333333333333333"));
        QCOMPARE(m_field->cursorPosition(), 0);
        QTest::keyClick(m_field, Qt::Key_End);
        QTest::keyClicks(m_field, QStringLiteral("4"));
        m_field->setReason(QStringLiteral("Refused."));
        QTest::keyClick(m_field, Qt::Key_Backtab);
        QCOMPARE(m_field->text(), QStringLiteral("-0.33333333333333334"));
        QCOMPARE(m_field->cursorPosition(), 0);
    }

    void aRefusedTextStaysUntilTheValueChanges()
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

    void escapeRestoresARefusedText_data()
    {
        addColumn<Qt::Key>("key");
        addColumn<Qt::KeyboardModifiers>("modifiers");
        newRow("escape") << Qt::Key_Escape << Qt::KeyboardModifiers(Qt::NoModifier);
        newRow("undo") << Qt::Key_Z << Qt::KeyboardModifiers(Qt::ControlModifier);
    }

    void escapeRestoresARefusedText()
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

    void undoIsTheWindowsUnlessSomethingIsTyped()
    {
        const auto isTaken = [this] {
            QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
            undo.ignore();
            QCoreApplication::sendEvent(m_field, &undo);
            return undo.isAccepted();
        };
        m_field->setValue(1.0);
        m_field->setFocus();
        QVERIFY(!isTaken());
        QTest::keyClick(m_field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_field->text(), QStringLiteral("1"));
        QTest::keyClicks(m_field, QStringLiteral("2"));
        QVERIFY(isTaken());
        QTest::keyClick(m_field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_field->text(), QStringLiteral("1"));
        QVERIFY(!isTaken());
    }

    void theReasonIsTold()
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

private:
    std::unique_ptr<QWidget> m_window;
    NumberField *m_field = nullptr;
    QLineEdit *m_other = nullptr;
};

UNPROJECTOR_TEST(TestNumberField)
#include "test_number_field.moc"
