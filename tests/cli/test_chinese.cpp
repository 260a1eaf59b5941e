// The command in Chinese: the choice of the language, no English left, and machine-readable output
// unchanged.
#include "tests/support/test.h"

#include "core/cli/terminal/language_choice.h"
#include "tests/cli/command.h"

#include <QRegularExpression>

#include "core/text/columns.h"

using namespace unprojector;
using cli::LanguageWishes;

namespace {

const Variables kChinese{{"LC_ALL", "zh_CN.UTF-8"}};

const char *const kCommands[] = {"points",  "pick", "project",  "info", "scene",     "cloud",
                                 "compare", "map",  "matrices", "code", "landmarks", "doctor"};

/// Returns whether the line has two English words side by side, apart from typed ones: commands,
/// and options with their values.
bool hasEnglish(QString line)
{
    static const QRegularExpression typed(QStringLiteral("unproject [a-z]+|--[a-z-]+ [a-z]+"));
    static const QRegularExpression words(QStringLiteral("\\b[a-z]{2,} [a-z]{2,}\\b"));
    return words.match(line.remove(typed)).hasMatch();
}

bool isExample(const QString &line)
{
    static const QRegularExpression start(QStringLiteral("^  +(?:unproject|printf|parallel|projection) "));
    return start.match(line).hasMatch();
}

} // namespace

class TestChinese : public QObject {
    Q_OBJECT

private slots:
    void theLanguageIsTheUsers_data()
    {
        QTest::addColumn<QStringList>("wishes"); // LC_ALL, LC_MESSAGES, LANG, LANGUAGE, the system's
        QTest::addColumn<bool>("isChinese");

        QTest::newRow("nothing") << QStringList{"", "", "", "", ""} << false;
        QTest::newRow("lang") << QStringList{"", "", "zh_CN.UTF-8", "", ""} << true;
        QTest::newRow("messages-before-lang") << QStringList{"", "zh_CN.UTF-8", "en_US.UTF-8", "", ""} << true;
        QTest::newRow("all-before-messages")
            << QStringList{"en_US.UTF-8", "zh_CN.UTF-8", "zh_CN.UTF-8", "", ""} << false;
        QTest::newRow("list-before-all") << QStringList{"en_US.UTF-8", "", "", "zh_CN", ""} << true;
        QTest::newRow("first-of-list") << QStringList{"zh_CN.UTF-8", "", "", "en:zh_CN", ""} << false;
        QTest::newRow("first-known-of-list") << QStringList{"de_DE.UTF-8", "", "", "de:zh_CN:en", ""} << true;
        QTest::newRow("none-known-of-list") << QStringList{"zh_CN.UTF-8", "", "", "de:fr", ""} << false;
        QTest::newRow("c-before-list") << QStringList{"C", "", "zh_CN.UTF-8", "zh_CN", ""} << false;
        QTest::newRow("c-utf8-before-list") << QStringList{"C.UTF-8", "", "", "zh_CN", ""} << false;
        QTest::newRow("posix") << QStringList{"POSIX", "", "zh_CN.UTF-8", "", ""} << false;
        QTest::newRow("list-alone") << QStringList{"", "", "", "zh_CN", ""} << false;
        QTest::newRow("no-encoding") << QStringList{"", "", "zh_CN", "", ""} << true;
        QTest::newRow("utf8-otherwise") << QStringList{"", "", "zh_CN.utf8@pinyin", "", ""} << true;
        QTest::newRow("other-encoding") << QStringList{"", "", "zh_CN.GB18030", "", ""} << false;
        QTest::newRow("singapore") << QStringList{"", "", "zh_SG.UTF-8", "", ""} << true;
        QTest::newRow("traditional") << QStringList{"", "", "zh_TW.UTF-8", "", ""} << false;
        QTest::newRow("system") << QStringList{"", "", "", "", "zh-CN:en-US"} << true;
        QTest::newRow("system-with-script") << QStringList{"", "", "", "", "zh-Hans-CN"} << true;
        QTest::newRow("system-english-first") << QStringList{"", "", "", "", "en-US:zh-CN"} << false;
        QTest::newRow("environment-before-system") << QStringList{"", "", "en_US.UTF-8", "", "zh-CN"} << false;
    }

    void theLanguageIsTheUsers()
    {
        QFETCH(QStringList, wishes);
        QFETCH(bool, isChinese);
        const LanguageWishes given{wishes[0].toStdString(), wishes[1].toStdString(), wishes[2].toStdString(),
                                   wishes[3].toStdString(), wishes[4].toStdString()};
        QCOMPARE(cli::chosenLanguage(given) == text::Language::Chinese, isChinese);
    }

    void helpIsChinese_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("program") << QStringList{"--help"};
        for (const char *command : kCommands)
            QTest::newRow(command) << QStringList{command, "--help"};
    }

    void helpIsChinese()
    {
        QFETCH(QStringList, words);
        const Run run = runCommand(words, {}, kChinese);
        VERIFY_SUCCEEDED(run);
        const QString help = QString::fromUtf8(run.output);
        QVERIFY(help.contains(QStringLiteral("\n用法：unproject")));
        QVERIFY(!help.contains(QChar::ReplacementCharacter));
        for (const QString &line : help.split(u'\n')) {
            if (isExample(line))
                continue;
            QVERIFY2(!hasEnglish(line), qPrintable(line));
            const bool isHead = line.startsWith(QStringLiteral("  ")) && !line.startsWith(QStringLiteral("   "));
            QVERIFY2(isHead || text::columnsOf(line.toStdString()) <= 80, qPrintable(line));
        }
    }

    /// A user who prefers English gets it byte for byte, in any locale.
    void englishIsNotTouched()
    {
        for (const QStringList &words : {QStringList{"--help"}, QStringList{"map", "--help"}}) {
            const Run english = runCommand(words, {}, {{"LC_ALL", "C"}});
            const Run preferred = runCommand(words, {}, {{"LC_ALL", "zh_CN.UTF-8"}, {"LANGUAGE", "en"}});
            QVERIFY(english.output.contains("\nUsage: unproject"));
            QCOMPARE(preferred.output, english.output);
        }
    }

    void wrongWordsAreSaidInChinese_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("said");

        QTest::newRow("command") << QStringList{"pionts"} << "“pionts”不是命令；请从中选一个：points, pick, ";
        QTest::newRow("no-command") << QStringList{} << "缺少命令；详见 'unproject --help'\n";
        QTest::newRow("option") << QStringList{"info", "--jsn", "a"}
                                << "--jsn 不是 'unproject info' 的选项；'unproject info --help' 列出了全部选项\n";
        QTest::newRow("too-many") << QStringList{"info", "a", "b"} << "“b”对 'unproject info' 来说是多余的；";
        QTest::newRow("choice") << QStringList{"points", "--method", "fast", "a"}
                                << "--method: “fast”不在可选值之中：all, both, formula, matrix, matrixInFloat\n";
        QTest::newRow("range") << QStringList{"points", "--threads", "0", "a"} << "--threads: 值 0 不在 1 到 64 之间\n";
        QTest::newRow("required") << QStringList{"info"} << "缺少 SCENE；详见 'unproject info --help'\n";
        QTest::newRow("needs") << QStringList{"pick", "--json", "a"} << "--json 须与 --at 一起使用；";
        QTest::newRow("excludes") << QStringList{"pick", "a", "b", "--at", "1,2"} << " 不能同时使用；请去掉其中一个\n";
        QTest::newRow("missing") << QStringList{"info", "a", "--json", "--", "b"} << "是多余的";
        QTest::newRow("value-missing") << QStringList{"code", "a", "-o"} << "--output: 其后缺少文件；";
        QTest::newRow("no-number") << QStringList{"map", "a", "--depth", "x", "-o", "b", "--what", "uncertainty"}
                                   << "--depth x: 请给出一个数\n";
    }

    void wrongWordsAreSaidInChinese()
    {
        QFETCH(QStringList, words);
        QFETCH(QString, said);
        const Run run = runCommand(words, {}, kChinese);
        QCOMPARE(run.exitCode, 2);
        const QString errors = QString::fromUtf8(run.errors);
        QVERIFY2(errors.contains(said), qPrintable(errors));
        QVERIFY2(!hasEnglish(errors), qPrintable(errors));
    }

    void messagesAreSaidInChinese_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QString>("said");

        QTest::newRow("cell") << QStringList{"points", "scene.json"} << QByteArray("px,py,depth\nfar,1,0\n")
                              << "stdin:2:1: px: “far”不是数\n";
        QTest::newRow("depth") << QStringList{"points", "scene.json"} << QByteArray("px,py,depth\n1,1,2.5\n")
                               << "stdin:2:5: depth: 2.5 在深度范围 0 到 1 之外\n";
        QTest::newRow("header") << QStringList{"project", "scene.json"} << QByteArray("x;y;z\n")
                                << "stdin:1:1: 表头没有 x 列；首行应为 x,y,z 或 formula_x,formula_y,formula_z；"
                                   "这里各列以逗号分隔，而不是分号\n";
        QTest::newRow("no-file") << QStringList{"info", "nothing.obj"} << QByteArray()
                                 << "nothing.obj: 没有这个文件；请检查名称和文件夹\n";
        QTest::newRow("scene-value") << QStringList{"matrices", "-"}
                                     << QByteArray(R"({"unprojector": 1, "window": {"width": -3, "height": 2}})")
                                     << "-3 必须在 1 与 65536 之间\n";
        QTest::newRow("system") << QStringList{"landmarks", "nothing.pp", "-", "--to", "csv"} << QByteArray()
                                << "nothing.pp: 无法读取：没有那个文件或目录\n";
        QTest::newRow("syntax") << QStringList{"matrices", "-"} << QByteArray(R"({"unprojector" 1})")
                                << "stdin:1:16: 此处应为“:”，却是 1\n";
        const auto json = [](const char *name, const QByteArray &text, const char *message) {
            QTest::newRow(name) << QStringList{"matrices", "-"} << text << QStringLiteral("stdin:1:") + message;
        };
        json("no-literal", "hello", "1: 此处应为值，却是 hello\n");
        json("not-utf8", "{\"a\": \"\xFF\"}", "8: 此处有不是 UTF-8 的字节；请把文件存为 UTF-8\n");
        json("backslash", R"({"a": "\d"})", "9: 引号中的文字含有 JSON 不认识的反斜杠；反斜杠请写成 \\\\\n");
        json("hex-digits", R"({"a": "\u12"})", "12: \\u 之后没有 4 位十六进制数字\n");
        json("control-character", "{\"a\": \"b\tc\"}",
             "9: 引号中的文字含有换行、制表符或其他控制字符；请写成 \\n、\\t 或 \\u 加编号\n");
        json("open-key", "{\"a", "4: 引号中的文字没有结束；请用 \" 结束它\n");
        json("number", R"({"a": -})", "7: - 不是数；请写 1、-0.5 或 2e3 这样的数\n");
        json("exponent", R"({"a": 1e})", "7: 1e 不是数；请写 1、-0.5 或 2e3 这样的数\n");
        json("comma-missing", R"({"a": 1 "b": 2})", "9: 此处应为“,”或“}”，却是 \"b\"\n");
        QTest::newRow("model") << QStringList{"info", "broken.obj"} << QByteArray()
                               << "broken.obj: 文件已损坏：第 1 行：顶点需要三个数，而不是 “x”\n";
        QTest::newRow("landmark-row") << QStringList{"landmarks", "--from", "csv", "--to", "pp", "-", "-"}
                                      << QByteArray("name,x,y,z\na,1,2,far\n") << "stdin:2: z 为 “far”；请写一个数\n";
        QTest::newRow("several") << QStringList{"pick", "scene.json"} << QByteArray("px,py\n-1,0\n900,0\n")
                                 << "stdin: 2 个像素在画面（800x600）的视口之外，那里什么也不会遇到\n";
        QTest::newRow("finding")
            << QStringList{"scene", "--from-matrices",
                           "modelview 1 0 0 0 0 1 0 0 0 0 1 -5 0 0 0 1 projection 1 0 0 0 0 1 0 0 0 0 "
                           "-1.2 -1 0 0 -2.2 0 viewport 0 0 800 600"}
            << QByteArray() << "modelview: 按 0 0 0 1 成为最后一行的次序读取；现按行读取，--order column 按列读取";
        QTest::newRow("statistics") << QStringList{"map",    "scene.json", "--what", "formula-ray",
                                                   "--size", "40x30",      "-o",     "map.pfm"}
                                    << QByteArray() << "formula-ray，世界单位：1200 个像素中有 1200 个；最小 ";
        QTest::newRow("cloud") << QStringList{"cloud", "wide.json", "depth.pfm", "-o", "-"} << QByteArray()
                               << "depth.pfm: 1 个点超出单精度的范围；--precision double 的范围更大\n";
        QTest::newRow("landmarks") << QStringList{"landmarks", "--from", "csv", "--to", "pp", "-", "-"}
                                   << QByteArray("name,x,y,z,note\na,1,2,3,left\nb,1,2,3,\n")
                                   << "stdout: 1 个标志点的备注未写出";
    }

    void messagesAreSaidInChinese()
    {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, input);
        QFETCH(QString, said);
        const QString errors = QString::fromUtf8(runCommand(inFolder(words), input, kChinese).errors);
        QVERIFY2(errors.contains(said), qPrintable(errors));
        QVERIFY2(!hasEnglish(errors), qPrintable(errors));
    }

    void reportsAreChinese_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("said");

        QTest::newRow("info") << QStringList{"info", "scene.json"}
                              << "face\n  顶点       4\n  三角形     2\n  面积       16\n";
        QTest::newRow("note") << QStringList{"info", "scene.json"} << "说明：未显示的线和点：1\n";
        QTest::newRow("pick") << QStringList{"pick", "scene.json", "--at", "400.5,300.5"}
                              << "像素 400.5 300.5\n  物体         face\n  三角形       0，重心坐标 ";
        QTest::newRow("compare") << QStringList{"compare", "--pixels", "2", "--depths", "2", "scene.json"}
                                 << "8 个点与扩展精度结果之差，世界单位；ulp 指最大坐标的末位单位\n\n"
                                    "方法     精度                最大       平均    99.99 %\n公式     double  x    ";
        QTest::newRow("doctor") << QStringList{"doctor",  "scene.json", "--pixel", "100.5,200.5",
                                               "--depth", "0.6666667",  "--got",   "-1.4975,-0.4975,3.00000"}
                                << "y-not-flipped 或 axes-differ（x,-y,z，镜像） 或 camera-axes-differ（x,-y,z）\n"
                                   "  y 没有翻转：窗口的行从上往下数，OpenGL 的行从下往上数。\n  或 axes-differ（";
        QTest::newRow("doctor-unknown") << QStringList{"doctor",  "scene.json", "--pixel", "100.5,200.5",
                                                       "--depth", "0.66667",    "--got",   "1,2,3"}
                                        << "像素比 ";
    }

    void reportsAreChinese()
    {
        QFETCH(QStringList, words);
        QFETCH(QString, said);
        const Run run = runCommand(inFolder(words), {}, kChinese);
        VERIFY_SUCCEEDED(run);
        const QString report = QString::fromUtf8(run.output);
        QVERIFY2(report.contains(said), qPrintable(report));
        static const QRegularExpression code(QStringLiteral("^ .*[ -+] .*[;=].*$"),
                                             QRegularExpression::MultilineOption);
        for (const QString &line : report.split(u'\n'))
            QVERIFY2(!hasEnglish(line) || code.match(line).hasMatch(), qPrintable(line));
    }

    void dataIsTheSameInEveryLanguage_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("input");

        const QByteArray clicks("px,py,depth\n400,300,0.5\nx,1,2\n"), points("x,y,z\n0,0,0\n0,0,5\n");
        QTest::newRow("points") << QStringList{"points", "scene.json"} << clicks;
        QTest::newRow("points-jsonl") << QStringList{"points", "--format", "jsonl", "scene.json"} << clicks;
        QTest::newRow("project") << QStringList{"project", "scene.json"} << points;
        QTest::newRow("pick") << QStringList{"pick", "scene.json"} << QByteArray("px,py\n400.5,300.5\n-1,0\n");
        QTest::newRow("pick-json") << QStringList{"pick", "--json", "scene.json", "--at", "400.5,300.5"}
                                   << QByteArray();
        QTest::newRow("info-json") << QStringList{"info", "--json", "scene.json"} << QByteArray();
        QTest::newRow("compare-json") << QStringList{"compare",  "--json", "--pixels",  "2",
                                                     "--depths", "2",      "scene.json"}
                                      << QByteArray();
        QTest::newRow("matrices") << QStringList{"matrices", "--conventions", "unity", "scene.json"} << QByteArray();
        QTest::newRow("matrices-json") << QStringList{"matrices", "--format", "json", "scene.json"} << QByteArray();
        QTest::newRow("matrices-numpy") << QStringList{"matrices", "--format", "numpy", "scene.json"} << QByteArray();
        QTest::newRow("code") << QStringList{"code", "scene.json", "--for", "glu"} << QByteArray();
        QTest::newRow("map-json") << QStringList{"map",   "scene.json", "--what", "formula-ray", "--size",
                                                 "40x30", "--json",     "-o",     "map.pfm"}
                                  << QByteArray();
        QTest::newRow("doctor-json") << QStringList{"doctor",      "scene.json",        "--pixel",
                                                    "100.5,200.5", "--depth",           "0.66667",
                                                    "--got",       "-1.4981,-0.4981,3", "--json"}
                                     << QByteArray();
        QTest::newRow("landmarks") << QStringList{"landmarks", "--from", "csv", "--to", "mrk.json", "-", "-"}
                                   << QByteArray("name,x,y,z\nnose,1,2,3\n");
    }

    /// Its messages are not: they are for people.
    void dataIsTheSameInEveryLanguage()
    {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, input);
        words = inFolder(words);
        const Run english = runCommand(words, input, {{"LC_ALL", "C"}});
        const Run chinese = runCommand(words, input, kChinese);
        QVERIFY2(!english.output.isEmpty(), english.errors.constData());
        QCOMPARE(chinese.output, english.output);
        QCOMPARE(chinese.exitCode, english.exitCode);
    }

private:
    /// The words of a command with the paths of its files, which are made.
    QStringList inFolder(const QStringList &words)
    {
        m_folder.write(QStringLiteral("scene.json"), kFrustumScene);
        // The mesh is open and has a line, so that there is something to note.
        m_folder.write(QStringLiteral("face.obj"), "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\nl 1 2\n");
        m_folder.write(QStringLiteral("broken.obj"), "v 1 2 x\n");
        // One scene is too wide for single precision to hold its points; the other is one pixel.
        m_folder.write(QStringLiteral("wide.json"),
                       QByteArray(kFrustumScene)
                           .replace("800, \"height\": 600", "1, \"height\": 1")
                           .replace("\"left\": -1, \"right\": 1", "\"left\": 1e39, \"right\": 2e39"));
        m_folder.write(QStringLiteral("depth.pfm"), QByteArray("Pf\n1 1\n-1.0\n").append("\0\0\0\x3f", 4));
        static const QRegularExpression file(
            QStringLiteral("^(scene\\.json|wide\\.json|depth\\.pfm|broken\\.obj|map\\.pfm)$"));
        QStringList placed;
        for (const QString &word : words)
            placed << (file.match(word).hasMatch() ? m_folder.path(word) : word);
        return placed;
    }

    Folder m_folder;
};

UNPROJECTOR_TEST(TestChinese)
#include "test_chinese.moc"
