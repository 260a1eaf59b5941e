// Each language of the program from the start: the messages, the names of objects, and the choice
// for the next start.

#include "tests/support/test.h"

#include "tests/gui/text/language_user.h"

#include "core/examples/examples.h"
#include "core/scene_file/scene_file.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_edits.h"
#include "gui/shell/appearance.h"
#include "gui/text/bundled_names.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QDirIterator>
#include <QFile>
#include <QFontDatabase>
#include <QFontInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLibraryInfo>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeView>

#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "gui/shell/language_menu.h"

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::scene;

namespace {

const QStringList kEnglish{QStringLiteral("en")}, kChinese{QStringLiteral("zh-CN")};

QStringList listedObjects(const MainWindow &window)
{
    QStringList names;
    const QAbstractItemModel *list = dockOf(window, "objects")->findChild<QTreeView *>()->model();
    for (int row = 0; row < list->rowCount(); ++row)
        names << list->index(row, 0).data().toString();
    return names;
}

} // namespace

class TestLanguage : public QObject {
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

    void objectsAreNamedInTheLanguage()
    {
        QCOMPARE(readName("Teapot (2)"), QStringLiteral("Teapot (2)"));
        const Translation translation(kChinese);
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
        const QString written = QString::fromStdString(scene_file::sceneText(window->session().contents()).value());
        QVERIFY(written.contains(QStringLiteral("\"Torus\"")) && !written.contains(QStringLiteral("圆环")));
        for (const char *taken : {"圆环", "Torus"}) {
            QVERIFY(!list->setData(first, QString::fromUtf8(taken)));
            QCOMPARE(document.objects().front().name, std::string("Teapot"));
        }
        QVERIFY(list->setData(first, QStringLiteral("壶")));
        QCOMPARE(document.objects().front().name, std::string("壶"));
    }

    void objectsOfFilesKeepTheirNames()
    {
        const Translation translation(kChinese);
        const auto window = windowIn(translation);
        SceneObject box = window->document().objects().front();
        box.name = "Box";
        box.file = "Box.stl";
        QVERIFY(addObjects(window->document(), {box}).hasValue());
        QCOMPARE(readName("Box"), QStringLiteral("长方体")); // as one of the program's is called
        QCOMPARE(listedObjects(*window).constLast(), QStringLiteral("Box"));
        QCOMPARE(listedObjects(*window).constFirst(), QStringLiteral("茶壶"));
    }

    void twoObjectsNeverLookTheSame()
    {
        const Translation translation(kChinese);
        const auto window = windowIn(translation);
        SceneDocument &document = window->document();
        std::vector<SceneObject> objects = document.objects();
        objects[1].name = "茶壶"; // given where the program spoke English
        openObjects(document, std::move(objects));
        QStringList names = listedObjects(*window);
        QCOMPARE(names[2], QStringLiteral("圆环"));
        QCOMPARE(names.removeDuplicates(), 0);
        // The list shows the teapot under its own name, so this name belongs to one object alone, which
        // may keep it.
        QCOMPARE(renameObject(document, 1, QStringLiteral("茶壶")), NameFault::None);
        QCOMPARE(renameObject(document, 2, QStringLiteral("茶壶")), NameFault::Taken);
        QCOMPARE(renameObject(document, 1, QStringLiteral("Teapot")), NameFault::Taken);
    }

    void menusHaveRoomForTheirTexts()
    {
        const QFont own = QApplication::font();
        QFont large = own;
        large.setPointSizeF(13.0);
        QApplication::setFont(large);
        setAppearance(Appearance::Light);
        const Translation translation(kChinese);
        const auto window = windowIn(translation, true);
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

    void qtSpeaksChineseToo()
    {
        if (!QFile::exists(QLibraryInfo::path(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_zh_CN.qm")))
            QSKIP("Qt has no translations here.");
        const auto cancelIn = [](const QStringList &languages) {
            const Translation translation(languages);
            const QDialogButtonBox box(QDialogButtonBox::Cancel);
            return box.button(QDialogButtonBox::Cancel)->text().remove(u'&');
        };
        QCOMPARE(cancelIn(kEnglish), QStringLiteral("Cancel"));
        QVERIFY2(cancelIn(kChinese).contains(QStringLiteral("取消")), qPrintable(cancelIn(kChinese)));
    }

    void hanziAreThoseOfChina()
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

    void everyBundledNameIsChinese()
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
        const Translation translation(kChinese);
        const QStringList letters{QStringLiteral("WC"), QStringLiteral("VC")}; // as the sources have them
        for (const QString &name : names)
            QVERIFY2(letters.contains(name) || readName(name.toStdString()) != name, qPrintable(name));
    }

    void whatCoreSaysIsInTheLanguage_data()
    {
        addColumn<QStringList>("languages");
        addColumn<QStringList>("said"); // of a model, a scene and points
        newRow("English") << kEnglish
                          << QStringList{"broken.ply: the file is damaged: the file ends within ",
                                         ":1:16: 1 found where \":\" is expected", ":2: z is \"far\"; write a number"};
        newRow("Chinese") << kChinese
                          << QStringList{"broken.ply：文件已损坏：文件在 face 1（共 9 个）之内结束",
                                         ":1:16: 此处应为“:”，却是 1", ":2: z 为 “far”；请写一个数"};
    }

    /// Core's loaders report a file's errors in their own threads.
    void whatCoreSaysIsInTheLanguage()
    {
        QFETCH(QStringList, languages);
        QFETCH(QStringList, said);
        const std::array<std::pair<const char *, QByteArray>, 3> files{
            {{"broken.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 9\nproperty list uchar int vertex_indices\n"
                            "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
             {"broken.json", R"({"unprojector" 1})"},
             {"broken.csv", "name,x,y,z\na,1,2,far\n"}}};
        const QTemporaryDir folder;
        const Translation translation(languages);
        const auto window = windowIn(translation);
        for (std::size_t i = 0; i < files.size(); ++i) {
            QFile file(folder.filePath(QLatin1String(files[i].first)));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(files[i].second) == files[i].second.size());
            file.close();
            window->session().openFiles({std::filesystem::path(file.fileName().toStdU16String())});
            QTRY_VERIFY_WITH_TIMEOUT(!window->session().isLoading(), kPatienceMilliseconds);
            QVERIFY2(window->message().contains(said[static_cast<qsizetype>(i)]), qPrintable(window->message()));
            static const QRegularExpression words(QStringLiteral("\\b[a-z]{2,}[,;:]? [a-z]{2,}\\b"));
            QVERIFY2(languages == kEnglish || !words.match(window->message()).hasMatch(),
                     qPrintable(window->message()));
        }
    }

    void theChoiceIsForTheNextStart()
    {
        QCOMPARE(keptLanguage(), Language::System);
        QCOMPARE(languagesOf(Language::System), QLocale().uiLanguages());
        const Translation translation(kEnglish);
        const auto chosen = [](const MainWindow &window) { return actionOf(window, QStringLiteral("简体中文(C)")); };
        {
            const auto window = windowIn(translation, true);
            QVERIFY(actionOf(*window, QStringLiteral("System"))->isChecked());
            chosen(*window)->trigger();
            QVERIFY(chosen(*window)->isChecked());
            QCOMPARE(keptLanguage(), Language::Chinese);
            QCOMPARE(languagesOf(keptLanguage()), QStringList{QStringLiteral("zh_CN")});
            QCOMPARE(window->message(), QStringLiteral("程序下次启动时使用简体中文。")); // in the new language
            QCOMPARE(window->menuBar()->actions().constFirst()->text(), QStringLiteral("&File"));
            settle(); // messages of one moment stand together
            actionOf(*window, QStringLiteral("English"))->trigger();
            QCOMPARE(languagesOf(keptLanguage()), QStringList{QStringLiteral("en")});
            QCOMPARE(window->message(), QStringLiteral("The program uses English when it starts next time."));
            chosen(*window)->trigger();
        }
        QVERIFY(chosen(*windowIn(translation, true))->isChecked());
        QVERIFY(!chosen(*windowIn(translation)));
        keepLanguage(Language::System);
    }

    void withoutAFontThereIsNoChinese()
    {
        const Translation translation({QStringLiteral("zh-CN"), QStringLiteral("en")}, false);
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
};

UNPROJECTOR_TEST(TestLanguage, display)
#include "test_language.moc"
