// Another language is chosen while the program runs: what is said, what is kept, what objects are called.

#include "document_edits.h"
#include "language_user.h"

#include "core/examples/bundled_models.h"
#include "core/scene_file/scene_file.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_edits.h"
#include "gui/lessons/find_bar.h"
#include "gui/lessons/formulas_window.h"
#include "gui/lessons/lesson_panel.h"
#include "gui/shell/appearance.h"
#include "gui/text/bundled_names.h"
#include "gui/text/translation.h"
#include "gui/view/scene_view.h"
#include "tests/support/patience.h"

#include <QAbstractButton>
#include <QApplication>
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
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <algorithm>
#include <filesystem>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

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
        settle(20);
    }
    for (int trial = 0; trial < 5 && window.view().size() != kViewSize; ++trial) {
        window.setViewSize(kViewSize);
        settle(20);
    }
    if (window.view().size() != kViewSize)
        return {QStringLiteral("no such view")};
    goHome(window.document());
    fitAll(window.document()); // near and far depend on the sizes before
    window.view().pickPixel(kPixel);
    window.places().show("precision"); // hidden, it would tell of the last time that it was seen
    settle(20);
    dockOf(window, "precision")->hide();
    // How many blanks stand before a fraction goes by the font's widths to a fraction of a pixel.
    static const QRegularExpression blanks(QStringLiteral("  +"));
    QStringList texts = textsOf(window).replaceInStrings(blanks, QStringLiteral(" "));
    texts.sort();
    return texts;
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

QStringList listedObjects(const MainWindow &window)
{
    QStringList names;
    const QAbstractItemModel *list = dockOf(window, "objects")->findChild<QTreeView *>()->model();
    for (int row = 0; row < list->rowCount(); ++row)
        names << list->index(row, 0).data().toString();
    return names;
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
    void aDeedIsNamedByItsLastPart();
    void objectsAreNamedInTheLanguage();
    void objectsOfFilesKeepTheirNames();
    void twoObjectsNeverLookTheSame();
    void menusHaveRoomForTheirTexts();
    void qtSpeaksChineseToo();
    void hanziAreThoseOfChina();
    void everyBundledNameIsChinese();
    void whatHelpIsSearchedForStays();
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
    QCOMPARE(renameObject(document, 0, QStringLiteral("Pot")), NameFault::None);
    landmarks::Landmark point;
    point.name = "tip";
    point.world = document.pickedPoint().value();
    QVERIFY(document.points().place(point).hasValue());
    goHome(document);
    QVERIFY(removeObject(document, 4).hasValue());
    document.undoStack().undo();
    window->places().enter("points");
    settle();
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

void TestLanguage::aDeedIsNamedByItsLastPart()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    SceneDocument &document = window->document();
    LookAt camera = document.scene().camera;
    const auto move = [&](const QString &name) {
        camera.eye.x += 1.0;
        QVERIFY(editCamera(document, camera, {name, QStringLiteral("eye")}).hasValue());
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

void TestLanguage::objectsOfFilesKeepTheirNames()
{
    Translation translation({QStringLiteral("zh-CN")});
    const auto window = windowIn(translation);
    SceneObject box = window->document().objects().front();
    box.name = "Box";
    box.file = "Box.stl";
    QVERIFY(addObjects(window->document(), {box}).hasValue());
    QCOMPARE(readName("Box"), QStringLiteral("长方体")); // as one of the program's is called
    QCOMPARE(listedObjects(*window).constLast(), QStringLiteral("Box"));
    QCOMPARE(listedObjects(*window).constFirst(), QStringLiteral("茶壶"));
}

void TestLanguage::twoObjectsNeverLookTheSame()
{
    Translation translation(m_english);
    const auto window = windowIn(translation);
    QCOMPARE(renameObject(window->document(), 1, QStringLiteral("茶壶")), NameFault::None);
    const auto areOthers = [&] {
        QStringList names = listedObjects(*window);
        return names.removeDuplicates() == 0;
    };
    QVERIFY(areOthers());
    chooseChinese(*window);
    QVERIFY(areOthers());
    QCOMPARE(listedObjects(*window)[2], QStringLiteral("圆环"));
    // The teapot is read by its own name beside that one, which so is nobody else's: it may be called as it is.
    QCOMPARE(renameObject(window->document(), 1, QStringLiteral("茶壶")), NameFault::None);
    QCOMPARE(renameObject(window->document(), 2, QStringLiteral("茶壶")), NameFault::Taken);
    QCOMPARE(renameObject(window->document(), 1, QStringLiteral("Teapot")), NameFault::Taken);
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

void TestLanguage::everyBundledNameIsChinese()
{
    QStringList names;
    for (const auto &[name, model] : examples::bundledModels())
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
    QTest::newRow("scene") << "broken.json" << QByteArray(R"({"unprojector" 1})") << ":1:16: 此处应为“:”，却是 1"
                           << ":1:16: 1 stands where \":\" is expected";
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
        const bool isDone = QTest::qWaitFor([&] { return !window->session().isLoading(); }, kPatienceMilliseconds);
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
        QCOMPARE(window->message(), missingFontText());
#ifdef Q_OS_LINUX
        QVERIFY(window->message().contains(QStringLiteral("fonts-noto-cjk")));
#endif
        const QAction *chinese = actionOf(*window, QStringLiteral("Chinese, simplified"));
        QVERIFY(chinese && !chinese->isEnabled());
        QVERIFY(chinese->toolTip().startsWith(QStringLiteral("No font here has Chinese characters. ")));
    }
    const auto again = windowIn(translation, true);
    QVERIFY2(again->message().isEmpty(), qPrintable(again->message()));
}

QTEST_MAIN(TestLanguage)
#include "test_language.moc"
