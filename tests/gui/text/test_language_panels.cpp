// Panels and lessons have room for their texts in each language.

#include "tests/support/test.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/text/language_user.h"

#include "gui/lessons/lesson_player.h"

#include <QApplication>
#include <QFontDatabase>
#include <QSettings>

#include <initializer_list>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

/// The program's letters in another size, while it lives.
class TemporaryFontSize {
public:
    explicit TemporaryFontSize(double points) : m_own(QApplication::font())
    {
        QFont font = m_own;
        font.setPointSizeF(points);
        QApplication::setFont(font);
    }
    ~TemporaryFontSize() { QApplication::setFont(m_own); }
    TemporaryFontSize(const TemporaryFontSize &) = delete;
    TemporaryFontSize &operator=(const TemporaryFontSize &) = delete;

private:
    QFont m_own;
};

bool hasHanzi()
{
    return QFontDatabase::writingSystems().contains(QFontDatabase::SimplifiedChinese);
}

/// The letters' sizes, each in both languages.
void addRows(std::initializer_list<int> sizes)
{
    QTest::addColumn<double>("points");
    QTest::addColumn<QString>("language");
    for (const int points : sizes) {
        for (const QString &language : {QStringLiteral("en"), QStringLiteral("zh_CN")})
            QTest::addRow("%d pt, %s", points, qPrintable(language)) << double(points) << language;
    }
}

} // namespace

class TestLanguagePanels : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
#ifndef UNPROJECTOR_IS_TRANSLATED
        QSKIP("Built without Qt's LinguistTools.");
#endif
        redirectSettings();
        QSettings().setValue(QStringLiteral("firstSteps/areDone"), true);
    }

    void noTextOfAPanelIsCut_data()
    {
        addRows({9, 10, 11, 13});
    }

    void noTextOfAPanelIsCut()
    {
        QFETCH(double, points);
        QFETCH(QString, language);
        if (language != QStringLiteral("en") && !hasHanzi())
            QSKIP("No font here has Hanzi: boxes say nothing of their room. Install one, such as fonts-noto-cjk.");
        const TemporaryFontSize size(points);
        const Translation translation({language});
        const auto window = windowIn(translation);
        QStringList cut;
        for (const char *place : lessons::kWorkspaceNames) {
            enter(*window, place);
            // The shared docks exclude the separate ones: a lesson, and the view from outside,
            // which a lesson has as well.
            for (const QDockWidget *dock : window->workspaces().sharedDocks()) {
                window->workspaces().show(panelNamed(dock->objectName()));
                settle(20);
                QStringList texts;
                for (int trial = 0; trial < 5 && !(texts = cutTexts(*dock->widget())).isEmpty(); ++trial)
                    settle(); // until it is laid out
                for (const QString &text : texts)
                    cut << QStringLiteral("%1 in %2: %3").arg(dock->objectName(), QLatin1String(place), text);
            }
        }
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
    }

    void noTextOfALessonIsCut_data()
    {
        addRows({9, 11, 13});
    }

    /// The texts of a lesson, its question's answers among them, and the view from outside.
    void noTextOfALessonIsCut()
    {
        QFETCH(double, points);
        QFETCH(QString, language);
        if (language != QStringLiteral("en") && !hasHanzi())
            QSKIP("No font here has Hanzi: boxes say nothing of their room. Install one, such as fonts-noto-cjk.");
        const TemporaryFontSize size(points);
        const Translation translation({language});
        const auto window = windowIn(translation);
        LessonPlayer &lessons = part<LessonPlayer>(*window);
        QStringList cut;
        const auto look = [&] {
            for (const char *id : {"lesson", "observer"}) {
                if (!isSeen(*window, id))
                    continue;
                const QWidget &panel = *dockOf(*window, id)->widget();
                QStringList texts;
                for (int trial = 0; trial < 5 && !(texts = cutTexts(panel)).isEmpty(); ++trial)
                    settle(20); // until it is laid out
                for (const QString &text : texts)
                    cut << QStringLiteral("%1 in “%2”: %3")
                               .arg(QLatin1String(id), QString::fromStdString(lessons.step().title), text);
            }
        };
        for (const auto &lesson : lessons.lessons()) {
            QVERIFY(lessons.start(lesson.name));
            do {
                look();
                lessons.reveal();
                look();
            } while (lessons.hasNext() && lessons.next());
            QVERIFY(lessons.leave());
        }
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
    }
};

UNPROJECTOR_TEST(TestLanguagePanels, layout, display, fonts)
#include "test_language_panels.moc"
