// Finding words in Help.

#include "tests/support/test.h"

#include "gui/lessons/find_bar.h"
#include "gui/lessons/formulas_window.h"
#include "gui/shell/appearance.h"
#include "gui/text/translation.h"
#include "tests/support/patience.h"

#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTextDocument>

namespace unprojector::gui {
namespace {

/// A window whose field is open, as after Ctrl+F.
struct Search {
    Search()
    {
        window.resize(700, 500);
        window.show();
        window.activateWindow();
        isActive = QTest::qWaitForWindowActive(&window, kPatienceMilliseconds);
        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
    }
    void type(const QString &words)
    {
        field().clear();
        field().insert(words);
    }
    FindBar &bar() { return window.findBar(); }
    QLineEdit &field() { return *bar().findChild<QLineEdit *>(); }
    QString count() { return bar().findChild<QLabel *>()->text(); }
    QString present()
    {
        for (const QTextEdit::ExtraSelection &mark : window.page().extraSelections()) {
            if (mark.format.hasProperty(QTextFormat::ForegroundBrush))
                return mark.cursor.selectedText();
        }
        return {};
    }
    bool isPresentSeen()
    {
        const QTextCursor cursor = window.page().textCursor();
        return window.page().viewport()->rect().contains(window.page().cursorRect(cursor));
    }

    FormulasWindow window;
    bool isActive = false; ///< else its shortcuts do nothing
};

} // namespace

class TestHelpSearch : public QObject {
    Q_OBJECT

private slots:
    void allHitsAreMarkedAndCounted_data()
    {
        addColumn<QString>("language");
        addColumn<QString>("words");
        addColumn<QString>("counted");
        newRow("a word, small letters") << "en-US"
                                        << "glfrustum"
                                        << "1 of %1";
        newRow("across italics") << "en-US"
                                 << "z is"
                                 << "1 of %1";
#ifdef UNPROJECTOR_IS_TRANSLATED
        newRow("Chinese") << "zh-CN" << QStringLiteral("投影") << QStringLiteral("第 1 处，共 %1 处");
#endif
    }

    void allHitsAreMarkedAndCounted()
    {
        QFETCH(QString, language);
        QFETCH(QString, words);
        QFETCH(QString, counted);
        const Translation translation({language});
        Search search;
        QVERIFY(search.isActive);
        QVERIFY(search.bar().isVisible());
        search.type(words);
        const auto expected = search.window.page().toPlainText().count(words, Qt::CaseInsensitive);
        QVERIFY(expected > 1);
        QCOMPARE(search.window.page().extraSelections().size(), expected);
        QCOMPARE(search.count(), counted.arg(expected));
        QCOMPARE(search.present().compare(words, Qt::CaseInsensitive), 0);
    }

    void theHitsAreWalkedRoundTheEnds()
    {
        Search search;
        QVERIFY(search.isActive);
        search.type(QStringLiteral("gluPerspective"));
        const int count = static_cast<int>(search.bar().hits().size());
        QVERIFY(count > 3);
        const auto at = [count](int hit) { return QStringLiteral("%1 of %2").arg(hit).arg(count); };
        QTest::keyClick(&search.field(), Qt::Key_Return);
        QCOMPARE(search.count(), at(2));
        QTest::keyClick(&search.window, Qt::Key_F3);
        QCOMPARE(search.count(), at(3));
        for (int back : {2, 1, count}) {
            QTest::keyClick(&search.field(), Qt::Key_Return, Qt::ShiftModifier);
            QCOMPARE(search.count(), at(back));
            QVERIFY2(search.isPresentSeen(), qPrintable(at(back)));
        }
        QTest::keyClick(&search.window, Qt::Key_F3);
        QCOMPARE(search.count(), at(1));
        QTest::keyClick(&search.window, Qt::Key_F3, Qt::ShiftModifier);
        QCOMPARE(search.count(), at(count));
    }

    void aHyphenFindsAMinus()
    {
        Search search;
        QVERIFY(search.isActive);
        search.type(QStringLiteral("H - 1 - j"));
        QCOMPARE(search.present(), QStringLiteral("H − 1 − j"));
    }

    void nothingFoundIsSaid()
    {
        Search search;
        QVERIFY(search.isActive);
        const int place = search.window.page().verticalScrollBar()->value();
        search.type(QStringLiteral("(.*[quaternion"));
        QCOMPARE(search.count(), QStringLiteral("Nothing found"));
        QVERIFY(search.window.page().extraSelections().isEmpty());
        QTest::keyClick(&search.field(), Qt::Key_Return);
        QCOMPARE(search.window.page().verticalScrollBar()->value(), place);
        search.field().clear();
        QCOMPARE(search.count(), QString());
    }

    void escapeClosesTheFieldAndThenTheWindow()
    {
        Search search;
        QVERIFY(search.isActive);
        search.type(QStringLiteral("cavalier"));
        QTest::keyClick(&search.window, Qt::Key_F, Qt::ControlModifier);
        QCOMPARE(search.field().selectedText(), QStringLiteral("cavalier"));
        search.window.page().setFocus();
        QTest::keyClick(&search.window.page(), Qt::Key_Escape);
        QVERIFY(!search.bar().isVisible());
        QVERIFY(search.window.page().extraSelections().isEmpty());
        QCOMPARE(search.window.page().textCursor().selectedText(), QStringLiteral("cavalier"));
        QVERIFY(search.window.isVisible());
        search.field().setText(QStringLiteral("cabinet"));
        QVERIFY(search.window.page().extraSelections().isEmpty());
        search.field().setText(QStringLiteral("cavalier"));
        QTest::keyClick(&search.window, Qt::Key_F3); // opens it again
        QCOMPARE(search.present(), QStringLiteral("cavalier"));
        for (int i = 0; i < 2; ++i)
            QTest::keyClick(&search.field(), Qt::Key_Escape);
        QTest::keyClick(&search.window.page(), Qt::Key_Escape);
        QVERIFY(!search.window.isVisible());
    }

    void theSearchOutlivesOtherColours()
    {
        const Appearance before = currentAppearance();
        Search search;
        QVERIFY(search.isActive);
        search.type(QStringLiteral("thermometer"));
        const auto hits = search.bar().hits().size();
        setAppearance(Appearance::Dark);
        QTRY_VERIFY_WITH_TIMEOUT(search.window.page().palette().color(QPalette::Base).lightnessF() < 0.5F,
                                 kPatienceMilliseconds);
        QCOMPARE(search.bar().hits().size(), hits);
        QCOMPARE(search.present(), QStringLiteral("thermometer"));
        setAppearance(before);
    }
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestHelpSearch)
#include "test_help_search.moc"
