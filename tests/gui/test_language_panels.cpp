// Another language is chosen while the program runs: panels and lessons go on as they stood, and have room for their texts.

#include "broken_texts.h"
#include "cut_texts.h"
#include "document_edits.h"
#include "language_user.h"

#include "gui/click/comparison_panel.h"
#include "gui/document/camera_looks.h"
#include "gui/lessons/lesson_panel.h"
#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/shell/widget_state.h"
#include "gui/text/translation.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/segmented_switch.h"
#include "tests/support/patience.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QSlider>
#include <QTest>

#include <algorithm>
#include <array>
#include <utility>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

/// What a panel shows and how it stands. The views are not of quite the same size, and the numbers in texts neither.
QStringList shownBy(const QWidget &panel)
{
    static const QRegularExpression number(QStringLiteral("[0-9.e−-]*[0-9]"));
    QStringList shown;
    for (const QWidget *widget : panel.findChildren<QWidget *>()) {
        if (!widget->isVisibleTo(&panel))
            continue;
        if (const auto *label = qobject_cast<const QLabel *>(widget))
            shown << label->text().replace(number, QStringLiteral("0"));
        else if (const auto *button = qobject_cast<const QAbstractButton *>(widget))
            shown << button->text() + (button->isChecked() ? QStringLiteral(", on") : QString());
        else if (const auto *box = qobject_cast<const QComboBox *>(widget))
            shown << box->currentText();
        else if (const auto *slider = qobject_cast<const QSlider *>(widget))
            shown << QStringLiteral("slider at %1").arg(slider->value());
    }
    return shown;
}

/// Of the places and panels that have something to choose.
constexpr std::array kPanels{
    std::pair("click", "comparison"),    std::pair("click", "objects"),      std::pair("pipeline", "pipeline"),
    std::pair("pipeline", "parameters"), std::pair("pipeline", "inspector"), std::pair("pipeline", "precision"),
    std::pair("points", "points"),       std::pair("points", "series"),      std::pair("doctor", "doctor")};

QStringList shownByPanels(MainWindow &window)
{
    QStringList shown;
    for (const auto &[place, panel] : kPanels) {
        window.places().enter(place);
        window.places().show(panel);
        settle(30);
        for (const QString &text : shownBy(*dockOf(window, panel)->widget()))
            shown << QStringLiteral("%1: %2").arg(QLatin1String(panel), text);
    }
    return shown;
}

/// How often a widget was painted.
class Paints : public QObject {
public:
    explicit Paints(QWidget &widget) { widget.installEventFilter(this); }
    int count() const { return m_count; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        m_count += event->type() == QEvent::Paint ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }

private:
    int m_count = 0;
};

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

} // namespace

class TestLanguagePanels : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void whatPanelsShowStays();
    void panelsOutOfSightChangeNothing();
    void partsAreKnownByTheirNames();
    void noTextOfAPanelIsCut_data();
    void noTextOfAPanelIsCut();
    void noTextOfALessonIsCut_data();
    void noTextOfALessonIsCut();
    void aLessonGoesOn();
    void aLessonThatCannotBeReadIsLeft();
    void anAnswerStaysAnswered_data();
    void anAnswerStaysAnswered();
    void aPanelOfItsOwnWindowGoesOn_data();
    void aPanelOfItsOwnWindowGoesOn();
    void aLessonLeavesTheObserverAsItWas_data();
    void aLessonLeavesTheObserverAsItWas();
    void whatTheDoctorWasToldStays();

private:
    const QStringList m_english{QStringLiteral("en")};
};

void TestLanguagePanels::initTestCase()
{
#ifndef UNPROJECTOR_IS_TRANSLATED
    QSKIP("Built without Qt's LinguistTools.");
#endif
    redirectSettings();
    QSettings().setValue(QStringLiteral("firstSteps/areDone"), true);
}

void TestLanguagePanels::whatPanelsShowStays()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral("no counterpart")));
    Translation translation(m_english);
    const auto window = windowIn(translation);
    SceneDocument &document = window->document();
    window->comparison().setShowsFloat(true);
    window->places().enter("pipeline");
    settle();
    const auto chooseItem = [](QComboBox *box, int item) {
        box->setCurrentIndex(item);
        emit box->activated(item);
    };
    chooseItem(dockOf(*window, "parameters")->findChild<QComboBox *>(QStringLiteral("object")), 2);
    dockOf(*window, "inspector")->findChild<SegmentedSwitch *>()->setChoice(1);
    auto *pipeline = dockOf(*window, "pipeline")->findChild<PipelinePanel *>();
    for (QComboBox *box : pipeline->findChildren<QComboBox *>()) {
        if (box->objectName().isEmpty())
            chooseItem(box, 3); // whose object space
    }
    pipeline->setMatrixView({MatrixLayout::Row, false, Digits::Double, true});
    pipeline->takeApart(PipelineStage::ProjectionMatrix);
    int at = 10;
    for (QSlider *slider : pipeline->findChildren<QSlider *>())
        slider->setValue(at += 10);
    QVERIFY(editGivenPoint(document, GivenPoint{WorldPoint(1.0, 1.0, 0.0)}, {QStringLiteral("Give")}).hasValue());
    window->view().pickPixel(kPixel); // the last of the two, and so the one to follow
    NumberGrid *world = nullptr;
    for (NumberGrid *grid : pipeline->findChildren<NumberGrid *>()) {
        if (grid->model() == pipeline->model().point(PointModel::Space::World))
            world = grid;
    }
    QVERIFY(world);
    emit world->entered(pipeline->model().point(PointModel::Space::World)->indexOf(1));
    QVERIFY(!pipeline->model().followsGiven());
    const QStringList before = shownByPanels(*window);
    QVERIFY(before.contains(QStringLiteral("pipeline: slider at 60")));
    chooseChinese(*window);
    chooseEnglish(*window);
    const QStringList after = shownByPanels(*window);
    for (qsizetype i = 0; i < std::min(before.size(), after.size()); ++i)
        QCOMPARE(after[i], before[i]);
    QCOMPARE(after.size(), before.size());
}

/// A panel out of sight shows what there was when it was seen: it is not the one who says what there is.
void TestLanguagePanels::panelsOutOfSightChangeNothing()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    SceneDocument &document = window->document();
    window->places().enter("pipeline");
    window->places().show("parameters");
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "parameters"), kPatienceMilliseconds);
    window->places().enter("click");
    switchProjection(document);
    const ProjectionKind kind = kindOf(document.scene().projection);
    const int deeds = document.undoStack().count();
    chooseChinese(*window);
    QCOMPARE(kindOf(document.scene().projection), kind);
    QCOMPARE(document.undoStack().count(), deeds);
}

void TestLanguagePanels::partsAreKnownByTheirNames()
{
    QWidget former, now;
    const auto add = [](QWidget &to, const char *name, bool isOn) {
        auto *box = new QCheckBox(&to);
        box->setObjectName(QLatin1String(name));
        box->setChecked(isOn);
        return box;
    };
    add(former, "a", true);
    add(former, "b", false);
    add(former, "", true);
    auto *slider = new QSlider(&former);
    slider->setValue(30);
    const QCheckBox *other = add(now, "other", false), *b = add(now, "b", true), *a = add(now, "a", false);
    auto *taken = new QSlider(&now);
    const QCheckBox *unnamed = add(now, "", false);
    QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("other.*no counterpart")));
    takeOverState(now, former);
    QVERIFY(!other->isChecked() && !b->isChecked() && a->isChecked() && unnamed->isChecked());
    QCOMPARE(taken->value(), 30);
}

void TestLanguagePanels::noTextOfAPanelIsCut_data()
{
    QTest::addColumn<double>("points");
    for (const int points : {9, 10, 11, 13})
        QTest::addRow("%d pt", points) << double(points);
}

void TestLanguagePanels::noTextOfAPanelIsCut()
{
    if (!hasHanzi())
        QSKIP("No font here has Hanzi: boxes say nothing of their room. Install one, such as fonts-noto-cjk.");
    QFETCH(double, points);
    const TemporaryFontSize size(points);
    Translation translation({QStringLiteral("zh-CN")});
    const auto window = windowIn(translation);
    QStringList cut;
    for (const char *place : {"click", "pipeline", "points", "doctor"}) {
        window->places().enter(place);
        for (const WorkPlaces::Panel &panel : window->places().panels()) {
            if (qstrcmp(panel.id, "lesson") == 0 || qstrcmp(panel.id, "observer") == 0)
                continue; // there is none of them: a lesson has both
            window->places().show(panel.id);
            settle(20);
            QStringList texts;
            for (int trial = 0; trial < 5 && !(texts = cutTexts(*panel.widget)).isEmpty(); ++trial)
                settle(); // until it is laid out
            for (const QString &text : texts)
                cut << QStringLiteral("%1 in %2: %3").arg(QLatin1String(panel.id), QLatin1String(place), text);
        }
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

void TestLanguagePanels::noTextOfALessonIsCut_data()
{
    QTest::addColumn<double>("points");
    for (const int points : {9, 11, 13})
        QTest::addRow("%d pt", points) << double(points);
}

/// The texts of a lesson, its question's answers among them, and the view from outside.
void TestLanguagePanels::noTextOfALessonIsCut()
{
    if (!hasHanzi())
        QSKIP("No font here has Hanzi: boxes say nothing of their room. Install one, such as fonts-noto-cjk.");
    QFETCH(double, points);
    const TemporaryFontSize size(points);
    Translation translation({QStringLiteral("zh-CN")});
    const auto window = windowIn(translation);
    LessonPlayer &lessons = window->lessons();
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

void TestLanguagePanels::aLessonGoesOn()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    LessonPlayer &lessons = window->lessons();
    QVERIFY(lessons.start(lessons.lessons().front().name));
    QVERIFY(lessons.next());
    settle();
    const std::string name = lessons.lesson()->name, title = lessons.step().title;
    const std::size_t place = lessons.place();
    chooseChinese(*window);
    QVERIFY(lessons.lesson() && isSeen(*window, "lesson"));
    QCOMPARE(lessons.lesson()->name, name);
    QCOMPARE(lessons.place(), place);
    QVERIFY(lessons.step().title != title);
    QVERIFY(lessons.isAsTheStep());
    QVERIFY(window->windowTitle().contains(window->session().name()));
    QVERIFY(lessons.leave());
    QVERIFY(window->windowTitle().contains(Session::tr("Bundled scene")));
    QVERIFY(Session::tr("Bundled scene") != QStringLiteral("Bundled scene"));
}

void TestLanguagePanels::aLessonThatCannotBeReadIsLeft()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    const QString name = window->session().name();
    const int objects = static_cast<int>(window->document().objects().size());
    QVERIFY(window->lessons().start("pipeline"));
    QVERIFY(actionOf(*window, QStringLiteral("Leave Lesson"))->isEnabled());
    BrokenTexts texts;
    QVERIFY(QCoreApplication::installTranslator(&texts));
    QTRY_VERIFY_WITH_TIMEOUT(!window->lessons().lesson(), kPatienceMilliseconds);
    QCOMPARE(window->session().name(), name);
    QCOMPARE(static_cast<int>(window->document().objects().size()), objects);
    QVERIFY(!actionOf(*window, QStringLiteral("Leave Lesson"))->isEnabled());
    QVERIFY(dockOf(*window, "lesson")->isHidden());
}

void TestLanguagePanels::anAnswerStaysAnswered_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("verdict");
    QTest::newRow("right") << "312.5"
                           << "Right: 312.5.";
    QTest::newRow("wrong") << "187.5"
                           << "187.5 is not it. Try again, or have it shown.";
    QTest::newRow("no number") << "2+"
                               << "";
    QTest::newRow("shown") << ""
                           << "It is 312.5.";
}

void TestLanguagePanels::anAnswerStaysAnswered()
{
    QFETCH(QString, typed);
    QFETCH(QString, verdict);
    Translation translation(m_english);
    const auto window = windowIn(translation);
    QVERIFY(window->lessons().start("first"));
    QVERIFY(window->lessons().next());
    const auto panel = [&] { return window->findChild<LessonPanel *>(); };
    const QSize view(500, 500);
    emit panel()->linkFollowed(QStringLiteral("view"), QStringLiteral("500x500"));
    QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), view, kPatienceMilliseconds);
    const auto said = [&] {
        for (const QLabel *label : panel()->findChildren<QLabel *>()) {
            if (label->accessibleName() == LessonPanel::tr("Whether your answer is right"))
                return label->text();
        }
        return QString();
    };
    if (typed.isEmpty()) {
        for (QPushButton *button : panel()->findChildren<QPushButton *>()) {
            if (button->text() == LessonPanel::tr("Sho&w"))
                button->click();
        }
    } else {
        auto *field = panel()->findChild<QLineEdit *>();
        field->setText(typed);
        QTest::keyClick(field, Qt::Key_Return);
    }
    const QString before = said();
    if (!verdict.isEmpty())
        QCOMPARE(before, verdict);
    chooseChinese(*window);
    QVERIFY(!said().isEmpty() && said() != before);
    settle();
    QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), view, kPatienceMilliseconds);
    chooseEnglish(*window);
    QCOMPARE(said(), before);
    QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), view, kPatienceMilliseconds);
}

void TestLanguagePanels::aPanelOfItsOwnWindowGoesOn_data()
{
    QTest::addColumn<bool>("isHidden");
    QTest::newRow("seen") << false;
    QTest::newRow("hidden meanwhile") << true;
}

void TestLanguagePanels::aPanelOfItsOwnWindowGoesOn()
{
    QFETCH(bool, isHidden);
    Translation translation(m_english);
    const auto window = windowIn(translation);
    QVERIFY(window->lessons().start("first"));
    window->places().enter("pipeline");
    for (const char *panel : {"pipeline", "lesson"}) {
        dockOf(*window, panel)->setFloating(true);
        settle();
        dockOf(*window, panel)->setHidden(isHidden);
    }
    chooseChinese(*window);
    for (const char *panel : {"pipeline", "lesson"}) {
        QDockWidget *dock = dockOf(*window, panel);
        QVERIFY(dock->isFloating());
        dock->show();
        QVERIFY(dock->updatesEnabled());
        QWidget *part = dock->findChild<QComboBox *>();
        Paints paints(*part);
        part->update();
        QTRY_VERIFY2_WITH_TIMEOUT(paints.count() > 0, panel, kPatienceMilliseconds);
    }
    QCOMPARE(dockOf(*window, "pipeline")->windowTitle(), QStringLiteral("渲染管线"));
    auto *steps = dockOf(*window, "lesson")->findChild<QComboBox *>();
    QVERIFY(steps->currentText().contains(QString::fromStdString(window->lessons().step().title)));
    Paints paints(*steps);
    QVERIFY(window->lessons().next());
    QTRY_VERIFY_WITH_TIMEOUT(paints.count() > 0, kPatienceMilliseconds);
}

void TestLanguagePanels::aLessonLeavesTheObserverAsItWas_data()
{
    QTest::addColumn<bool>("wasShown");
    QTest::addColumn<bool>("isHidden");
    QTest::newRow("brought by the lesson") << false << false;
    QTest::newRow("brought, then hidden") << false << true;
    QTest::newRow("there before") << true << false;
    QTest::newRow("there before, then hidden") << true << true;
}

void TestLanguagePanels::aLessonLeavesTheObserverAsItWas()
{
    QFETCH(bool, wasShown);
    QFETCH(bool, isHidden);
    Translation translation(m_english);
    const auto window = windowIn(translation);
    const auto observer = [&] { return window->findChild<ObserverPanel *>(); };
    const auto action = [&] { return actionOf(*window, MainWindow::tr("&View from Outside").remove(u'&')); };
    action()->setChecked(wasShown);
    LessonPlayer &lessons = window->lessons();
    QVERIFY(lessons.start("first"));
    while (!lessons.step().highlights.contains(lessons::Highlight::Volume))
        QVERIFY(lessons.next());
    const auto isShown = [&] { return !dockOf(*window, "observer")->isHidden(); };
    QVERIFY(isShown());
    action()->setChecked(!isHidden);
    chooseChinese(*window);
    QVERIFY(observer());
    QCOMPARE(action()->isChecked(), !isHidden);
    QCOMPARE(isShown(), !isHidden);
    QVERIFY(lessons.next()); // which lets it go
    QVERIFY(!isShown());
    QCOMPARE(action()->isChecked(), wasShown);
    QCOMPARE(observer()->isVisible(), wasShown); // over the view
    QVERIFY(lessons.leave());
}

void TestLanguagePanels::whatTheDoctorWasToldStays()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    window->places().enter("doctor");
    settle();
    const auto fieldsOf = [&] {
        QStringList texts;
        for (const QLineEdit *field : dockOf(*window, "doctor")->findChildren<QLineEdit *>())
            texts << field->text();
        texts.sort();
        return texts;
    };
    QLineEdit *got = nullptr;
    for (QLineEdit *field : dockOf(*window, "doctor")->findChildren<QLineEdit *>()) {
        if (field->placeholderText().startsWith(QStringLiteral("0.7051")))
            got = field;
    }
    QVERIFY(got);
    QTest::keyClicks(got, QStringLiteral("1.5 2.5 -3.5"));
    window->view().pickPixel({kPixel.i + 20, kPixel.j}); // another row
    const QStringList before = fieldsOf();
    QVERIFY(before.size() >= 8); // two rows and the program's two sizes
    QTRY_VERIFY_WITH_TIMEOUT(!window->document().wrongPoints().empty(), kPatienceMilliseconds);
    chooseChinese(*window);
    QCOMPARE(fieldsOf(), before);
    QTRY_VERIFY_WITH_TIMEOUT(!window->document().wrongPoints().empty(), kPatienceMilliseconds);
}

QTEST_MAIN(TestLanguagePanels)
#include "test_language_panels.moc"
