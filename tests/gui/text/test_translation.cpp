#include "tests/support/test.h"

#include "core/doctor/report_text.h"
#include "gui/shell/main_window.h"
#include "gui/shell/window_menus.h"
#include "gui/text/error_text.h"
#include "gui/text/sentences.h"
#include "gui/text/translation.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMenuBar>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>
#include <array>
#include <memory>

namespace unprojector::gui {
using namespace geometry;

namespace {

struct Message {
    QString context;
    QString source;
    QString comment; ///< distinguishes equal sources
    QString translation;
    QString state;
};

QList<Message> messagesOfFile()
{
    QFile file(QStringLiteral(UNPROJECTOR_TRANSLATION_FILE));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QList<Message> messages;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"source") {
            messages.append({context, xml.readElementText(), {}, {}, {}});
        } else if (xml.name() == u"comment") {
            messages.last().comment = xml.readElementText();
        } else if (xml.name() == u"translation") {
            messages.last().state = xml.attributes().value(QStringLiteral("type")).toString();
            messages.last().translation = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
        }
    }
    return xml.hasError() ? QList<Message>() : messages;
}

/// "%1", "%2" and "%n", sorted; or the links of a rich text.
QStringList found(const QString &text, const QString &pattern)
{
    QStringList result;
    for (auto match = QRegularExpression(pattern).globalMatch(text); match.hasNext();)
        result << match.next().captured();
    std::sort(result.begin(), result.end());
    return result;
}

const QStringList kChinese{QStringLiteral("zh-CN")};

/// One word for one thing, in the window, the command, the lessons and Help alike.
struct Term {
    const char *wrong; ///< a regular expression: its other names
    const char *right;
};

constexpr std::array kTerms{
    Term{"视野角|(?<!场)视角", "视场角: the field of view"},
    Term{"[近远]裁剪面", "近平面, 远平面"},
    Term{"(?<![近远])裁剪面", "裁剪平面: a clip plane"},
    Term{"(?<!渲染)(?<!图形)管线|流水线", "渲染管线: the pipeline"},
    Term{"(?<!模型)视图(矩阵|变换)|投影(与|和| × )视图|视图原为", "观察矩阵, 观察变换: the view matrix"},
    Term{"外部视图", "从外部观察: View from Outside"},
    Term{"法向", "法线: a normal"},
    Term{"描述表", "上下文: a context, DC or RC"},
    Term{"反推|逆投影", "反投影: to unproject"},
    Term{"封闭形式|闭式", "解析形式, 解析公式: closed form"},
    Term{"(?<!JSON )对象", "物体: an object"},
    Term{"(?<!物体坐标（)模型坐标|模型空间", "物体坐标（模型坐标，MC）: object coordinates"},
    Term{"屏幕位置|屏幕空间|到屏幕|>屏幕[<（]", "控件: the widget's"},
    Term{"(?<!Windows )屏幕坐标", "控件坐标（Windows 屏幕坐标）, 窗口坐标: the widget's, the window's"},
    Term{"视坐标|眼坐标", "观察坐标: eye coordinates"},
    Term{"归一化", "规范化: normalised"},
    Term{"视锥|视见体", "视景体: the view volume"},
    Term{"你", "您"},
    Term{"，[0-9]+ 节", "第 n 节: section n"},
};

} // namespace

class TestTranslation : public QObject {
    Q_OBJECT

private slots:
    void everyMessageIsTranslated()
    {
        const QList<Message> messages = messagesOfFile();
        QVERIFY(messages.size() > 500);
        for (const Message &m : messages) {
            QVERIFY2(m.state.isEmpty() && !m.translation.isEmpty(),
                     qPrintable(m.context + QStringLiteral(": ") + m.source));
            for (const char *pattern : {"%[0-9]+|%n", "href='[^']*'", "</?[a-z]+"}) {
                const QString p = QString::fromLatin1(pattern);
                QVERIFY2(found(m.source, p) == found(m.translation, p),
                         qPrintable(m.source + QStringLiteral(" -> ") + m.translation));
            }
            // A menu's access key stays one.
            const QString key = QStringLiteral("&[A-Za-z]");
            QVERIFY2(found(m.source, key).size() == found(m.translation, key).size(),
                     qPrintable(m.source + QStringLiteral(" -> ") + m.translation));
        }
    }

    void theProgramFindsEveryTranslation()
    {
#ifndef UNPROJECTOR_IS_TRANSLATED
        QSKIP("Built without Qt's LinguistTools.");
#endif
        QVERIFY(isBuilt());
        const Translation translation(kChinese);
        for (const Message &m : messagesOfFile()) {
            if (!m.source.contains(u"%n"))
                QCOMPARE(QCoreApplication::translate(m.context.toUtf8().constData(), m.source.toUtf8().constData(),
                                                     m.comment.toUtf8().constData()),
                         m.translation);
        }
    }

    void theWindowSpeaksChinese()
    {
#ifndef UNPROJECTOR_IS_TRANSLATED
        QSKIP("Built without Qt's LinguistTools.");
#endif
        const Translation translation(kChinese);
        MainWindow window({});
        QCOMPARE(window.menuBar()->actions().constFirst()->text(), QStringLiteral("文件(&F)"));
        // A text of a free function, which is not in a context of a Qt class.
        QCOMPARE(errorText(Error{ErrorCode::NotFinite, 2.5}), QStringLiteral("2.5 不是有限的数；请给出一个数。"));
        QCOMPARE(SceneOpener::tr("%1 and %n more", nullptr, 3).arg(QStringLiteral("a.obj")),
                 QStringLiteral("a.obj 及另外 3 个"));
    }

    void theFirstLanguageCounts()
    {
#ifndef UNPROJECTOR_IS_TRANSLATED
        QSKIP("Built without Qt's LinguistTools.");
#endif
        const auto nameOfTools = [](const QStringList &languages) {
            const Translation translation(languages);
            return WindowMenus::tr("Tools");
        };
        QCOMPARE(nameOfTools({QStringLiteral("en-US"), QStringLiteral("zh-CN")}), QStringLiteral("Tools"));
        QCOMPARE(nameOfTools({QStringLiteral("C")}), QStringLiteral("Tools"));
        QCOMPARE(nameOfTools({QStringLiteral("fr-FR"), QStringLiteral("zh-Hans-CN")}), QStringLiteral("工具"));
        QCOMPARE(WindowMenus::tr("Tools"), QStringLiteral("Tools"));
    }

    void chineseSentencesHaveNoBlankBetween()
    {
        QCOMPARE(joinSentences({QStringLiteral("One."), QString(), QStringLiteral("Two: three.")}),
                 QStringLiteral("One. Two: three."));
        QCOMPARE(joinSentences({QStringLiteral("一。"), QStringLiteral("二。"), QStringLiteral("3 个")}),
                 QStringLiteral("一。二。3 个"));
        QCOMPARE(joinSentences({}), QString());
        static const QRegularExpression blank(QStringLiteral("[。！？；：，、] "));
        for (const Message &m : messagesOfFile())
            QVERIFY2(!m.translation.contains(blank), qPrintable(m.translation));
#ifdef UNPROJECTOR_IS_TRANSLATED
        const Translation translation(kChinese);
        const QString two = QString::fromStdString(doctor::mistakeSentence("y-not-flipped+xy-swapped"));
        QVERIFY2(two.contains(u'。') && !two.contains(blank), qPrintable(two));
#endif
    }

    void oneThingHasOneName_data()
    {
        addColumn<QString>("file");
        const QDir resources(QFileInfo(QStringLiteral(UNPROJECTOR_TRANSLATION_FILE)).path() + QStringLiteral("/.."));
        for (const char *folder : {"translations", "lessons", "help"}) {
            const QDir files(resources.filePath(QLatin1String(folder)));
            for (const QString &name : files.entryList({QStringLiteral("*_zh_CN.*")}, QDir::Files))
                newRow(qPrintable(name)) << files.filePath(name);
        }
    }

    void oneThingHasOneName()
    {
        QFETCH(QString, file);
        QFile source(file);
        QVERIFY(source.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(source.readAll()).split(u'\n');
        QStringList found;
        for (const Term &term : kTerms) {
            const QRegularExpression wrong(QString::fromUtf8(term.wrong));
            QVERIFY2(wrong.isValid(), term.wrong);
            for (qsizetype i = 0; i < lines.size(); ++i) {
                if (const auto match = wrong.match(lines[i]); match.hasMatch())
                    found << QStringLiteral("line %1: %2, but it is %3")
                                 .arg(i + 1)
                                 .arg(match.captured(), QString::fromUtf8(term.right));
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }

private:
    static bool isBuilt()
    {
        return QFile::exists(QStringLiteral(":/translations/unprojector_zh_CN.qm"));
    }
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestTranslation)
#include "test_translation.moc"
