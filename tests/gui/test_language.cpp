// Another language is chosen while the program runs.

#include "broken_texts.h"
#include "cut_texts.h"
#include "window_user.h"

#include "core/scene/bundled_models.h"
#include "core/scene_file/scene_file.h"
#include "gui/document/lesson_player.h"
#include "gui/panels/comparison_panel.h"
#include "gui/panels/doctor_panel.h"
#include "gui/panels/number_grid.h"
#include "gui/panels/observer_panel.h"
#include "gui/panels/pipeline_panel.h"
#include "gui/panels/segmented_switch.h"
#include "gui/text/bundled_names.h"
#include "gui/text/translation.h"
#include "gui/view/scene_view.h"
#include "gui/window/appearance.h"
#include "gui/window/find_bar.h"
#include "gui/window/formulas_window.h"
#include "gui/window/lesson_panel.h"
#include "gui/window/widget_state.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDirIterator>
#include <QFile>
#include <QFontDatabase>
#include <QFontInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLibraryInfo>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QSlider>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <utility>

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
        QTest::qWait(30);
        for (const QString &text : shownBy(*dockOf(window, panel)->widget()))
            shown << QStringLiteral("%1: %2").arg(QLatin1String(panel), text);
    }
    return shown;
}

QStringList listedObjects(const MainWindow &window)
{
    QStringList names;
    const QAbstractItemModel *list = dockOf(window, "objects")->findChild<QTreeView *>()->model();
    for (int row = 0; row < list->rowCount(); ++row)
        names << list->index(row, 0).data().toString();
    return names;
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

std::string sceneOf(MainWindow &window)
{
    return scene_file::sceneText(window.session().contents()).value();
}

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

} // namespace

class TestLanguage : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everythingSpeaksTheLanguageThatIsChosen();
    void nothingIsLost();
    void whatPanelsShowStays();
    void panelsOutOfSightChangeNothing();
    void partsAreKnownByTheirNames();
    void aDeedIsNamedByItsLastPart();
    void objectsAreNamedInTheLanguage();
    void objectsOfFilesKeepTheirNames();
    void twoObjectsNeverLookTheSame();
    void menusHaveRoomForTheirTexts();
    void noTextOfAPanelIsCut_data();
    void noTextOfAPanelIsCut();
    void noTextOfALessonIsCut_data();
    void noTextOfALessonIsCut();
    void qtSpeaksChineseToo();
    void hanziAreThoseOfChina();
    void everyBundledNameIsChinese();
    void aLessonGoesOn();
    void aLessonThatCannotBeReadIsLeft();
    void anAnswerStaysAnswered_data();
    void anAnswerStaysAnswered();
    void whatHelpIsSearchedForStays();
    void aPanelOfItsOwnWindowGoesOn_data();
    void aPanelOfItsOwnWindowGoesOn();
    void aLessonLeavesTheObserverAsItWas_data();
    void aLessonLeavesTheObserverAsItWas();
    void whatTheDoctorWasToldStays();
    void whatCoreSaysIsInTheLanguage_data();
    void whatCoreSaysIsInTheLanguage();
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

void TestLanguage::whatPanelsShowStays()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral("no counterpart")));
    Translation translation(m_english);
    const auto window = windowIn(translation);
    SceneDocument &document = window->document();
    window->comparison().setShowsFloat(true);
    window->places().enter("pipeline");
    QTest::qWait(50);
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
    QVERIFY(document.editGivenPoint(GivenPoint{WorldPoint(1.0, 1.0, 0.0)}, {QStringLiteral("Give")}).hasValue());
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
void TestLanguage::panelsOutOfSightChangeNothing()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    SceneDocument &document = window->document();
    window->places().enter("pipeline");
    window->places().show("parameters");
    QTRY_VERIFY(isSeen(*window, "parameters"));
    window->places().enter("click");
    document.switchProjection();
    const ProjectionKind kind = kindOf(document.scene().projection);
    const int deeds = document.undoStack().count();
    chooseChinese(*window);
    QCOMPARE(kindOf(document.scene().projection), kind);
    QCOMPARE(document.undoStack().count(), deeds);
}

void TestLanguage::partsAreKnownByTheirNames()
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

void TestLanguage::aDeedIsNamedByItsLastPart()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    SceneDocument &document = window->document();
    LookAt camera = document.scene().camera;
    const auto move = [&](const QString &name) {
        camera.eye.x += 1.0;
        QVERIFY(document.editCamera(camera, {name, QStringLiteral("eye")}).hasValue());
    };
    const int count = document.undoStack().count();
    move(QStringLiteral("Eye"));
    chooseChinese(*window);
    QCOMPARE(document.undoStack().undoText(), QString());
    move(QStringLiteral("眼"));
    QCOMPARE(document.undoStack().count(), count + 1);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("眼"));
    chooseEnglish(*window);
    QCOMPARE(document.undoStack().undoText(), QString());
    chooseChinese(*window);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("眼"));
}

void TestLanguage::objectsOfFilesKeepTheirNames()
{
    Translation translation({QStringLiteral("zh-CN")});
    const auto window = windowIn(translation);
    SceneObject box = window->document().objects().front();
    box.name = "Box";
    box.file = "Box.stl";
    QVERIFY(window->document().addObjects({box}).hasValue());
    QCOMPARE(readName("Box"), QStringLiteral("长方体")); // as one of the program's is called
    QCOMPARE(listedObjects(*window).constLast(), QStringLiteral("Box"));
    QCOMPARE(listedObjects(*window).constFirst(), QStringLiteral("茶壶"));
}

void TestLanguage::twoObjectsNeverLookTheSame()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    QCOMPARE(window->document().renameObject(1, QStringLiteral("茶壶")), NameFault::None);
    const auto areOthers = [&] {
        QStringList names = listedObjects(*window);
        return names.removeDuplicates() == 0;
    };
    QVERIFY(areOthers());
    chooseChinese(*window);
    QVERIFY(areOthers());
    QCOMPARE(listedObjects(*window)[2], QStringLiteral("圆环"));
    // The teapot is read by its own name beside that one, which so is nobody else's: it may be called as it is.
    QCOMPARE(window->document().renameObject(1, QStringLiteral("茶壶")), NameFault::None);
    QCOMPARE(window->document().renameObject(2, QStringLiteral("茶壶")), NameFault::Taken);
    QCOMPARE(window->document().renameObject(1, QStringLiteral("Teapot")), NameFault::Taken);
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
    QTest::newRow("11 pt") << 11.0;
    QTest::newRow("13 pt") << 13.0;
}

void TestLanguage::noTextOfAPanelIsCut()
{
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
            QTest::qWait(20);
            QStringList texts;
            for (int trial = 0; trial < 5 && !(texts = cutTexts(*panel.widget)).isEmpty(); ++trial)
                QTest::qWait(50); // until it is laid out
            for (const QString &text : texts)
                cut << QStringLiteral("%1 in %2: %3").arg(QLatin1String(panel.id), QLatin1String(place), text);
        }
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

void TestLanguage::noTextOfALessonIsCut_data()
{
    QTest::addColumn<double>("points");
    QTest::newRow("9 pt") << 9.0;
    QTest::newRow("13 pt") << 13.0;
}

/// The texts of a lesson, its question's answers among them, and the view from outside.
void TestLanguage::noTextOfALessonIsCut()
{
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
                QTest::qWait(20); // until it is laid out
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

void TestLanguage::qtSpeaksChineseToo()
{
    if (!QFile::exists(QLibraryInfo::path(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_zh_CN.qm")))
        QSKIP("Qt has no translations here.");
    Translation translation(m_english);
    QCOMPARE(QDialogButtonBox(QDialogButtonBox::Cancel).button(QDialogButtonBox::Cancel)->text().remove(u'&'),
             QStringLiteral("Cancel"));
    translation.choose(Language::Chinese);
    const QDialogButtonBox box(QDialogButtonBox::Cancel);
    QVERIFY2(box.button(QDialogButtonBox::Cancel)->text().contains(QStringLiteral("取消")),
             qPrintable(box.button(QDialogButtonBox::Cancel)->text()));
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

void TestLanguage::aLessonThatCannotBeReadIsLeft()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    const QString name = window->session().name();
    const int objects = static_cast<int>(window->document().objects().size());
    QVERIFY(window->lessons().start("pipeline"));
    QVERIFY(actionOf(*window, QStringLiteral("Leave Lesson"))->isEnabled());
    BrokenTexts texts;
    QVERIFY(QCoreApplication::installTranslator(&texts));
    QTRY_VERIFY(!window->lessons().lesson());
    QCOMPARE(window->session().name(), name);
    QCOMPARE(static_cast<int>(window->document().objects().size()), objects);
    QVERIFY(!actionOf(*window, QStringLiteral("Leave Lesson"))->isEnabled());
    QVERIFY(dockOf(*window, "lesson")->isHidden());
}

void TestLanguage::anAnswerStaysAnswered_data()
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

void TestLanguage::anAnswerStaysAnswered()
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
    QTRY_COMPARE(window->view().size(), view);
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
    QTest::qWait(50);
    QTRY_COMPARE(window->view().size(), view);
    chooseEnglish(*window);
    QCOMPARE(said(), before);
    QTRY_COMPARE(window->view().size(), view);
}

void TestLanguage::whatHelpIsSearchedForStays()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    emit window->findChild<LessonPanel *>()->linkFollowed(QStringLiteral("formulas"), {});
    const auto bar = [&] { return &window->findChild<FormulasWindow *>()->findBar(); };
    bar()->openField();
    bar()->findChild<QLineEdit *>()->setText(QStringLiteral("gluUnProject"));
    QVERIFY(!bar()->hits().empty());
    chooseChinese(*window);
    QVERIFY(bar()->isVisible());
    QCOMPARE(bar()->findChild<QLineEdit *>()->text(), QStringLiteral("gluUnProject"));
    QVERIFY(!bar()->hits().empty());
    bar()->closeField();
    chooseEnglish(*window);
    QVERIFY(!bar()->isVisible());
}

void TestLanguage::aPanelOfItsOwnWindowGoesOn_data()
{
    QTest::addColumn<bool>("isHidden");
    QTest::newRow("seen") << false;
    QTest::newRow("hidden meanwhile") << true;
}

void TestLanguage::aPanelOfItsOwnWindowGoesOn()
{
    QFETCH(bool, isHidden);
    Translation translation(m_english);
    const auto window = windowIn(translation);
    QVERIFY(window->lessons().start("first"));
    window->places().enter("pipeline");
    for (const char *panel : {"pipeline", "lesson"}) {
        dockOf(*window, panel)->setFloating(true);
        QTest::qWait(50);
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
        QTRY_VERIFY2(paints.count() > 0, panel);
    }
    QCOMPARE(dockOf(*window, "pipeline")->windowTitle(), QStringLiteral("渲染管线"));
    auto *steps = dockOf(*window, "lesson")->findChild<QComboBox *>();
    QVERIFY(steps->currentText().contains(QString::fromStdString(window->lessons().step().title)));
    Paints paints(*steps);
    QVERIFY(window->lessons().next());
    QTRY_VERIFY(paints.count() > 0);
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

void TestLanguage::whatCoreSaysIsInTheLanguage_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("chinese");
    QTest::addColumn<QString>("english");

    QTest::newRow("model") << "broken.ply"
                           << QByteArray("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                         "property float z\nelement face 9\nproperty list uchar int vertex_indices\n"
                                         "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
                           << "broken.ply 已损坏：文件在 face 1（共 9 个）之内结束"
                           << "broken.ply is damaged: the file ends within ";
    QTest::newRow("scene") << "broken.json" << QByteArray(R"({"unprojector" 1})")
                           << ":1:16: 读取键之后的分隔符时遇到意外的数；应为':'"
                           << ":1:16: while parsing object separator - unexpected number literal; expected ':'";
    QTest::newRow("points") << "broken.csv" << QByteArray("name,x,y,z\na,1,2,far\n") << ":2: z 为 “far”；请写一个数"
                            << ":2: z is \"far\"; write a number";
}

/// Core's loaders say in their own threads what is wrong with a file.
void TestLanguage::whatCoreSaysIsInTheLanguage()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    const QTemporaryDir folder;
    QFile file(folder.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    file.close();

    Translation translation(m_english);
    const auto window = windowIn(translation);
    const auto messageOfOpening = [&] {
        window->session().openFiles({std::filesystem::path(file.fileName().toStdU16String())});
        const bool isDone = QTest::qWaitFor([&] { return !window->session().isLoading(); });
        return isDone ? window->message() : QString();
    };
    QFETCH(QString, english);
    QVERIFY2(messageOfOpening().contains(english), qPrintable(window->message()));
    chooseChinese(*window);
    QFETCH(QString, chinese);
    QVERIFY2(messageOfOpening().contains(chinese), qPrintable(window->message()));
    static const QRegularExpression words(QStringLiteral("\\b[a-z]{2,}[,;:]? [a-z]{2,}\\b"));
    QVERIFY2(!words.match(window->message()).hasMatch(), qPrintable(window->message()));
    chooseEnglish(*window);
    QVERIFY2(messageOfOpening().contains(english), qPrintable(window->message()));
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
