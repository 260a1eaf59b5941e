// Another language is chosen while the program runs.

#include "cut_texts.h"
#include "window_user.h"

#include "core/scene/bundled_models.h"
#include "core/scene_file/scene_file.h"
#include "gui/document/lesson_player.h"
#include "gui/panels/comparison_panel.h"
#include "gui/panels/doctor_panel.h"
#include "gui/panels/observer_panel.h"
#include "gui/text/bundled_names.h"
#include "gui/text/translation.h"
#include "gui/view/scene_view.h"
#include "gui/window/appearance.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDirIterator>
#include <QFile>
#include <QFontDatabase>
#include <QFontInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QTabBar>
#include <QTest>
#include <QTreeView>

#include <algorithm>
#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

constexpr QSize kSize(1180, 760), kViewSize(600, 480);
constexpr DevicePixel kPixel{300, 320};

/// A window on the bundled scene, with a pick.
std::unique_ptr<MainWindow> windowIn(Translation &translation, bool remembers = false)
{
    MainWindow::Options options;
    options.smoothEdges = false;
    options.remembers = remembers;
    options.translation = &translation;
    auto window = std::make_unique<MainWindow>(options);
    window->resize(kSize);
    window->session().openBundledScene();
    bringUp(*window);
    window->view().pickPixel(kPixel);
    return window;
}

void choose(MainWindow &window, const QString &language)
{
    actionOf(window, language)->trigger();
    QCoreApplication::sendPostedEvents();
    QTest::qWait(50);
}
void chooseChinese(MainWindow &window)
{
    choose(window, QStringLiteral("简体中文(C)"));
}
void chooseEnglish(MainWindow &window)
{
    choose(window, QStringLiteral("English"));
}

void addMenu(QStringList &texts, const QMenu &menu, const QString &where)
{
    for (const QAction *action : menu.actions()) {
        texts << where + action->text() + u'|' + action->toolTip() + u'|' + action->statusTip();
        if (action->menu())
            addMenu(texts, *action->menu(), where + action->text() + QStringLiteral(" > "));
    }
}

/// All that a window says, in menus, bars and panels, with 0 for every number.
QStringList textsOf(const MainWindow &window)
{
    QStringList texts;
    for (const QAction *action : window.menuBar()->actions()) {
        texts << action->text();
        addMenu(texts, *action->menu(), action->text() + QStringLiteral(" > "));
    }
    const QString progress = MainWindow::tr("Preparing the ray on the mesh"); // hidden, and what it was once
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        QStringList own{widget->windowTitle(), widget->toolTip(), widget->accessibleName(),
                        widget->accessibleDescription()};
        if (qobject_cast<const QTabBar *>(widget->parentWidget()))
            continue; // Qt's own, whose number is its own matter
        if (const auto *label = qobject_cast<const QLabel *>(widget); label && !label->text().startsWith(progress))
            own << label->text();
        if (const auto *button = qobject_cast<const QAbstractButton *>(widget))
            own << button->text();
        if (const auto *field = qobject_cast<const QLineEdit *>(widget))
            own << field->text() << field->placeholderText();
        if (const auto *box = qobject_cast<const QComboBox *>(widget)) {
            for (int i = 0; i < box->count(); ++i)
                own << box->itemText(i);
        }
        own.removeAll(QString());
        if (!own.isEmpty())
            texts << QStringLiteral("%1: %2").arg(QLatin1String(widget->metaObject()->className()),
                                                  own.join(QStringLiteral(" | ")));
    }
    // The views are not of quite the same size, and the numbers neither.
    static const QRegularExpression number(QStringLiteral("[0-9.e−-]*[0-9]"));
    texts.replaceInStrings(number, QStringLiteral("0"));
    texts.sort();
    return texts;
}

/// The same of a view of one size, once all places were seen and a pixel picked.
QStringList textsWithPick(MainWindow &window)
{
    window.document().clearPick(); // the doctor would keep it
    for (const char *place : {"pipeline", "points", "doctor", "click"}) {
        window.places().enter(place);
        QTest::qWait(20);
    }
    for (int trial = 0; trial < 5 && window.view().size() != kViewSize; ++trial) {
        window.setViewSize(kViewSize);
        QTest::qWait(20);
    }
    if (window.view().size() != kViewSize)
        return {QStringLiteral("no such view")};
    window.document().goHome();
    window.document().fit(); // near and far depend on the sizes before
    window.view().pickPixel(kPixel);
    window.places().show("precision"); // hidden, it would tell of the last time that it was seen
    QTest::qWait(20);
    dockOf(window, "precision")->hide();
    return textsOf(window);
}

/// The texts that only one of them has.
QString difference(const QStringList &a, const QStringList &b)
{
    QStringList onlyA, onlyB;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(onlyA));
    std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(onlyB));
    if (onlyA.isEmpty() && onlyB.isEmpty())
        return {};
    return QStringLiteral("only the one: %1\nonly the other: %2").arg(onlyA.join(u'\n'), onlyB.join(u'\n'));
}

std::string sceneOf(MainWindow &window)
{
    return scene_file::sceneText(window.session().contents()).value();
}

} // namespace

class TestLanguage : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everythingSpeaksTheLanguageThatIsChosen();
    void nothingIsLost();
    void objectsAreNamedInTheLanguage();
    void menusHaveRoomForTheirTexts();
    void noTextOfAPanelIsCut_data();
    void noTextOfAPanelIsCut();
    void hanziAreThoseOfChina();
    void everyBundledNameIsChinese();
    void aLessonGoesOn();
    void aLessonLeavesTheObserverAsItWas_data();
    void aLessonLeavesTheObserverAsItWas();
    void whatTheDoctorWasToldStays();
    void theChoiceIsKept();
    void withoutAFontThereIsNoChinese();

private:
    const QStringList m_english{QStringLiteral("en")};
};

void TestLanguage::initTestCase()
{
#ifndef UNPROJECTOR_IS_TRANSLATED
    QSKIP("Built without Qt's LinguistTools.");
#endif
    redirectSettings();
    QSettings().setValue(QStringLiteral("firstSteps/areDone"), true);
}

void TestLanguage::everythingSpeaksTheLanguageThatIsChosen()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    const QStringList english = textsWithPick(*window);
    chooseChinese(*window);
    QCOMPARE(window->menuBar()->actions().constFirst()->text(), QStringLiteral("文件(&F)"));
    const auto fromTheStart = windowIn(translation);
    const QString inChinese = difference(textsWithPick(*window), textsWithPick(*fromTheStart));
    QVERIFY2(inChinese.isEmpty(), qPrintable(inChinese));
    QCOMPARE(window->windowTitle(), fromTheStart->windowTitle());
    chooseEnglish(*window);
    const QString inEnglish = difference(textsWithPick(*window), english);
    QVERIFY2(inEnglish.isEmpty(), qPrintable(inEnglish));
}

void TestLanguage::nothingIsLost()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    SceneDocument &document = window->document();
    QCOMPARE(document.renameObject(0, QStringLiteral("Pot")), NameFault::None);
    landmarks::Landmark point;
    point.name = "tip";
    point.world = document.pickedPoint().value();
    QVERIFY(document.points().place(point).hasValue());
    document.goHome();
    QVERIFY(document.removeObject(4).hasValue());
    document.undoStack().undo();
    window->places().enter("points");
    QTest::qWait(50);
    const std::string scene = sceneOf(*window);
    const auto state = [&] {
        const QUndoStack &stack = document.undoStack();
        return QStringList{QString::number(stack.count()),
                           QString::number(stack.index()),
                           stack.redoText(),
                           QString::number(document.landmarks().size()),
                           QString::number(document.points().selection().size()),
                           QString::number(document.isEdited()),
                           QString::number(window->isWindowModified()),
                           QString::fromLatin1(window->places().current()),
                           QStringLiteral("%1x%2").arg(window->width()).arg(window->height()),
                           QStringLiteral("%1x%2").arg(window->view().width()).arg(window->view().height())};
    };
    const QStringList before = state();
    QVERIFY(!before[2].isEmpty());
    const SceneView *view = &window->view();
    const WorldPoint picked = document.pickedPoint().value();
    chooseChinese(*window);
    QVERIFY(document.undoStack().redoText().isEmpty()); // it has no name in this language
    QVERIFY(isSeen(*window, "points"));
    const QString written = QString::fromStdString(sceneOf(*window)); // of a view of another size
    QVERIFY(written.contains(QStringLiteral("\"Torus\"")) && !written.contains(QStringLiteral("圆环")));
    chooseEnglish(*window);
    QCOMPARE(state(), before);
    QVERIFY(sceneOf(*window) == scene);
    QVERIFY(document.pickedPoint() == picked);
    QVERIFY(&window->view() == view);
    document.undoStack().redo();
    QCOMPARE(document.objects().size(), std::size_t(4));
    while (document.undoStack().canUndo())
        document.undoStack().undo();
    QCOMPARE(document.objects().front().name, std::string("Teapot"));
}

void TestLanguage::objectsAreNamedInTheLanguage()
{
    QCOMPARE(readName("Teapot (2)"), QStringLiteral("Teapot (2)"));
    Translation translation({QStringLiteral("zh-CN")});
    QCOMPARE(readName("Teapot"), QStringLiteral("茶壶"));
    QCOMPARE(readName("Teapot (2)"), QStringLiteral("茶壶 (2)"));
    QCOMPARE(readName("Teapot of mine"), QStringLiteral("Teapot of mine"));
    const auto window = windowIn(translation);
    QAbstractItemModel *list = dockOf(*window, "objects")->findChild<QTreeView *>()->model();
    const QModelIndex first = list->index(0, 0);
    QCOMPARE(first.data().toString(), QStringLiteral("茶壶"));
    const SceneDocument &document = window->document();
    QVERIFY(list->setData(first, first.data(Qt::EditRole))); // looked at, and left as it was
    QCOMPARE(document.objects().front().name, std::string("Teapot"));
    for (const char *taken : {"圆环", "Torus"}) {
        QVERIFY(!list->setData(first, QString::fromUtf8(taken)));
        QCOMPARE(document.objects().front().name, std::string("Teapot"));
    }
    QVERIFY(list->setData(first, QStringLiteral("壶")));
    QCOMPARE(document.objects().front().name, std::string("壶"));
}

void TestLanguage::everyBundledNameIsChinese()
{
    QStringList names;
    for (const auto &[name, model] : scene::bundledModels())
        names << QString::fromStdString(name);
    QDirIterator lessons(QStringLiteral(":/lessons"), {QStringLiteral("*.json")});
    while (lessons.hasNext()) {
        QFile file(lessons.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        for (const QJsonValue step : QJsonDocument::fromJson(file.readAll())[u"steps"].toArray()) {
            for (const QJsonValue object : step[u"scene"][u"objects"].toArray())
                names << object[u"name"].toString();
        }
    }
    QVERIFY(names.contains(QStringLiteral("Its projection")));
    Translation translation({QStringLiteral("zh-CN")});
    const QStringList letters{QStringLiteral("WC"), QStringLiteral("VC")}; // as the sources have them
    for (const QString &name : names)
        QVERIFY2(letters.contains(name) || readName(name.toStdString()) != name, qPrintable(name));
}

void TestLanguage::menusHaveRoomForTheirTexts()
{
    const QFont own = QApplication::font();
    QFont large = own;
    large.setPointSizeF(13.0);
    QApplication::setFont(large);
    setAppearance(Appearance::Light);
    Translation translation({QStringLiteral("zh-CN")});
    const auto window = windowIn(translation);
    constexpr int kFrame = 4; // of the menu, at the right
    for (const QMenu *menu : window->menuBar()->findChildren<QMenu *>()) {
        QMenu narrow, wide;
        narrow.addActions(menu->actions());
        narrow.resize(narrow.sizeHint());
        wide.addActions(menu->actions());
        wide.setMinimumWidth(narrow.width() + 100);
        wide.resize(wide.sizeHint());
        const QImage picture = narrow.grab().toImage(), roomy = wide.grab().toImage();
        for (QAction *action : menu->actions()) {
            const QRect place = narrow.actionGeometry(action).adjusted(0, 0, -kFrame, 0);
            if (action->isSeparator() || action->menu() || !action->shortcut().isEmpty())
                continue; // something stands at the right
            QVERIFY2(picture.copy(place) == roomy.copy(place), qPrintable(action->text()));
        }
    }
    setAppearance(Appearance::Desktop);
    QApplication::setFont(own);
}

void TestLanguage::noTextOfAPanelIsCut_data()
{
    QTest::addColumn<double>("points");
    QTest::newRow("9 pt") << 9.0;
    QTest::newRow("13 pt") << 13.0;
}

void TestLanguage::noTextOfAPanelIsCut()
{
    QFETCH(double, points);
    const QFont own = QApplication::font();
    QFont font = own;
    font.setPointSizeF(points);
    QApplication::setFont(font);
    Translation translation({QStringLiteral("zh-CN")});
    const auto window = windowIn(translation);
    QStringList cut;
    for (const char *place : {"click", "pipeline", "points", "doctor"}) {
        window->places().enter(place);
        for (const WorkPlaces::Panel &panel : window->places().panels()) {
            if (qstrcmp(panel.id, "lesson") == 0 || qstrcmp(panel.id, "observer") == 0)
                continue; // there is none of them
            window->places().show(panel.id);
            QTest::qWait(20);
            QStringList texts;
            for (int trial = 0; trial < 5 && !(texts = cutTexts(*panel.widget)).isEmpty(); ++trial)
                QTest::qWait(50); // until it is laid out
            for (const QString &text : texts)
                cut << QStringLiteral("%1 in %2: %3").arg(QLatin1String(panel.id), QLatin1String(place), text);
        }
    }
    QApplication::setFont(own);
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

void TestLanguage::hanziAreThoseOfChina()
{
    const QFont own = QApplication::font();
    preferHanziOfChina();
    const QFont font = QApplication::font();
    QCOMPARE(QFontInfo(font).family(), QFontInfo(own).family());
    QCOMPARE(font.pointSizeF(), own.pointSizeF());
    const QString chinese = QStringLiteral("Noto Sans CJK SC");
    if (QFontDatabase::hasFamily(chinese) && QLocale::system().language() == QLocale::C)
        QCOMPARE(font.families().constLast(), chinese);
    QApplication::setFont(own);
}

void TestLanguage::aLessonGoesOn()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    LessonPlayer &lessons = window->lessons();
    QVERIFY(lessons.start(lessons.lessons().front().name));
    QVERIFY(lessons.next());
    QTest::qWait(50);
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

void TestLanguage::aLessonLeavesTheObserverAsItWas_data()
{
    QTest::addColumn<bool>("wasShown");
    QTest::addColumn<bool>("isHidden");
    QTest::newRow("brought by the lesson") << false << false;
    QTest::newRow("brought, then hidden") << false << true;
    QTest::newRow("there before") << true << false;
    QTest::newRow("there before, then hidden") << true << true;
}

void TestLanguage::aLessonLeavesTheObserverAsItWas()
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

void TestLanguage::whatTheDoctorWasToldStays()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    window->places().enter("doctor");
    QTest::qWait(50);
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
    QTRY_VERIFY(!window->document().wrongPoints().empty());
    chooseChinese(*window);
    QCOMPARE(fieldsOf(), before);
    QTRY_VERIFY(!window->document().wrongPoints().empty());
}

void TestLanguage::theChoiceIsKept()
{
    Translation translation(m_english);
    const QString key = QStringLiteral("window/language");
    const auto window = windowIn(translation, true);
    QVERIFY(!QSettings().contains(key));
    chooseChinese(*window);
    QCOMPARE(QSettings().value(key).toString(), QStringLiteral("zh_CN"));
    QVERIFY(actionOf(*window, QStringLiteral("简体中文(C)"))->isChecked());
    chooseEnglish(*window);
    QCOMPARE(QSettings().value(key).toString(), QStringLiteral("en"));
}

void TestLanguage::withoutAFontThereIsNoChinese()
{
    Translation translation({QStringLiteral("zh-CN"), QStringLiteral("en")}, false);
    QVERIFY(translation.lacksFont());
    {
        const auto window = windowIn(translation, true);
        QCOMPARE(window->menuBar()->actions().constFirst()->text(), QStringLiteral("&File"));
        QVERIFY(window->message().contains(QStringLiteral("fonts-noto-cjk")));
        const QAction *chinese = actionOf(*window, QStringLiteral("Chinese, simplified"));
        QVERIFY(chinese && !chinese->isEnabled());
        QVERIFY(chinese->toolTip().contains(QStringLiteral("fonts-noto-cjk")));
    }
    const auto again = windowIn(translation, true);
    QVERIFY2(again->message().isEmpty(), qPrintable(again->message()));
}

QTEST_MAIN(TestLanguage)
#include "test_language.moc"
