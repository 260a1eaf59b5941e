// The installed files next to the programs: one version, the manual and the completions with the
// actual names, the icon.

#include "tests/support/test.h"

#include "core/scene_file/scene_file.h"
#include "gui/shell/about_dialog.h"
#include "gui/widgets/icons.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QImage>
#include <QLabel>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

using namespace unprojector::gui;

namespace {

const QString kVersion = QStringLiteral(UNPROJECTOR_VERSION);

QString textOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(path));
    return QString::fromUtf8(file.readAll());
}

QString packagingFile(const QString &name)
{
    return QStringLiteral(UNPROJECTOR_SOURCES "/resources/packaging/") + name;
}

QString manualFile(const QString &name)
{
    return QStringLiteral(UNPROJECTOR_MANUAL "/") + name;
}

/// A program's standard output; empty if its exit code is not 0.
QString said(const QString &program, const QStringList &arguments)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("LANGUAGE"));
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    const bool ended = process.waitForFinished(kPatienceMilliseconds) && process.exitStatus() == QProcess::NormalExit;
    const QByteArray errors = process.readAllStandardError();
    if (!ended || process.exitCode() != 0)
        qWarning("%s %s: %s", qPrintable(program), qPrintable(arguments.join(u' ')), errors.constData());
    return ended && process.exitCode() == 0 ? QString::fromUtf8(process.readAllStandardOutput()) : QString();
}

/// The first words of the lines that stand two columns in, below a heading.
QStringList entriesBelow(const QString &heading, const QString &help)
{
    QStringList entries;
    bool isBelow = false;
    for (const QString &line : help.split(u'\n')) {
        if (!line.startsWith(u' '))
            isBelow = line == heading;
        static const QRegularExpression entry(QStringLiteral("^  (-[^ ,]+(, ?-[^ ,<]+)*|[a-z]+)"));
        if (const auto match = entry.match(line); isBelow && match.hasMatch())
            entries << match.captured(1);
    }
    return entries;
}

/// Every name of every option: -o, --output.
QStringList optionsOf(const QString &help)
{
    QStringList names;
    for (const QString &entry : entriesBelow(QStringLiteral("Options:"), help)) {
        for (const QString &name : entry.split(u','))
            names << name.trimmed();
    }
    return names;
}

QString betweenLines(const QString &text, const QString &start, const QString &end)
{
    const qsizetype from = text.indexOf(start);
    return from < 0 ? QString() : text.mid(from, text.indexOf(end, from + start.size()) - from);
}

} // namespace

class TestPackaging : public QObject {
    Q_OBJECT

private slots:
    void everythingSaysTheSameVersion_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("start");
        const auto row = [](const char *name, const QString &text, const QString &start) {
            newRow(name) << text << start;
        };
        row("unproject", said(QStringLiteral(UNPROJECT_COMMAND), {QStringLiteral("--version")}),
            QStringLiteral("unproject %1\n"));
        row("unprojector", said(QStringLiteral(UNPROJECTOR_EXECUTABLE), {QStringLiteral("--version")}),
            QStringLiteral("Unprojector %1\n"));
        const AboutDialog about({}, {}, nullptr);
        QString versions;
        for (const QLabel *label : about.findChildren<QLabel *>()) {
            if (label->text().startsWith(QStringLiteral("Unprojector ")))
                versions = label->text();
        }
        row("About", versions, QStringLiteral("Unprojector %1\n"));
        row("change log", textOf(packagingFile(QStringLiteral("changelog"))), QStringLiteral("unprojector (%1) "));
        const QString metainfo =
            textOf(packagingFile(QStringLiteral("io.github.unprojector.unprojector.metainfo.xml")));
        row("release notes", metainfo.mid(metainfo.indexOf(QStringLiteral("<release "))),
            QStringLiteral("<release version=\"%1\""));
        const QString vcpkg = textOf(QStringLiteral(UNPROJECTOR_SOURCES "/vcpkg.json"));
        row("vcpkg", vcpkg.mid(vcpkg.indexOf(QStringLiteral("\"version\""))), QStringLiteral("\"version\": \"%1\""));
        const QString page = textOf(manualFile(QStringLiteral("unproject.1")));
        // The file may come from any program.
        const auto scene = unprojector::scene_file::parseScene(R"({"unprojector": 1, "generator": ["Other", 7],
        "window": {"width": 9, "height": 9},
        "projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9},
        "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}})",
                                                               "x.json");
        const QString written = QString::fromStdString(unprojector::scene_file::sceneText(scene.value()).value());
        row("scene file", written.mid(written.indexOf(QStringLiteral("\"Unprojector"))),
            QStringLiteral("\"Unprojector %1\""));
        row("manual", page.mid(page.indexOf(QStringLiteral("\"Unprojector"))), QStringLiteral("\"Unprojector %1\""));
    }

    void everythingSaysTheSameVersion()
    {
        QFETCH(QString, text);
        QFETCH(QString, start);
        QVERIFY2(text.startsWith(start.arg(kVersion)), qPrintable(text.left(80)));
    }

    void everyOptionIsInTheManualAndTheCompletions_data()
    {
        addColumn<QString>("program");
        addColumn<QString>("command");
        newRow("unprojector") << QStringLiteral("unprojector") << QString();
        newRow("unproject") << QStringLiteral("unproject") << QString();
        const QString help = said(QStringLiteral(UNPROJECT_COMMAND), {QStringLiteral("--help")});
        for (const QString &command : entriesBelow(QStringLiteral("Subcommands:"), help))
            newRow(qPrintable(command)) << QStringLiteral("unproject") << command;
    }

    void everyOptionIsInTheManualAndTheCompletions()
    {
        QFETCH(QString, program);
        QFETCH(QString, command);
        const bool isWindow = program == QStringLiteral("unprojector");
        const QString path = isWindow ? QStringLiteral(UNPROJECTOR_EXECUTABLE) : QStringLiteral(UNPROJECT_COMMAND);
        QStringList words{QStringLiteral("--help")};
        if (!command.isEmpty())
            words.prepend(command);
        const QString help = said(path, words);

        QString page = textOf(manualFile(program + QStringLiteral(".1")));
        page.replace(QStringLiteral("\\-"), QStringLiteral("-"));
        const QString bash = textOf(manualFile(program + QStringLiteral(".bash")));
        const QString zsh = textOf(manualFile(program + QStringLiteral(".zsh")));
        const QString fish = textOf(manualFile(program + QStringLiteral(".fish")));
        const QString inPage =
            command.isEmpty() ? page : betweenLines(page, QStringLiteral(".SS unproject %1\n").arg(command), ".SS ");
        const QString bashWords =
            command.isEmpty() ? bash : betweenLines(bash, QStringLiteral("            %1) words=").arg(command), "\n");
        const QString inZsh =
            command.isEmpty() ? zsh : betweenLines(zsh, QStringLiteral("    %1)\n").arg(command), "        ;;");

        const QStringList options = optionsOf(help);
        QVERIFY(options.contains(QStringLiteral("--help")));
        for (const QString &option : options) {
            const auto message = [&](const char *where) {
                return qPrintable(option + QStringLiteral(" is not in ") + where);
            };
            const QString asWord = QStringLiteral("(?<![a-z-])%1(?![a-z-])").arg(QRegularExpression::escape(option));
            const QRegularExpression word(asWord);
            QVERIFY2(inPage.contains(word), message("the manual page"));
            QVERIFY2(bashWords.contains(word), message("bash's"));
            QVERIFY2(inZsh.contains(u'\'' + option + u'['), message("zsh's"));
            QString fishLine = QStringLiteral("complete -c %1").arg(program);
            if (!isWindow)
                fishLine += command.isEmpty() ? QStringLiteral(" -n __fish_use_subcommand")
                                              : QStringLiteral(" -n '__fish_seen_subcommand_from %1'").arg(command);
            const QString inFish = option.startsWith(QStringLiteral("--")) ? QStringLiteral(" -l ") + option.mid(2)
                                                                           : QStringLiteral(" -s ") + option.mid(1);
            const QRegularExpression line(QRegularExpression::escape(fishLine) + QStringLiteral("[^\n]*") + inFish
                                          + u' ');
            QVERIFY2(fish.contains(line), message("fish's"));
        }
        const QStringList commands = entriesBelow(QStringLiteral("Subcommands:"), help);
        QCOMPARE(commands.isEmpty(), isWindow || !command.isEmpty());
        for (const QString &name : commands) {
            QVERIFY2(page.contains(QStringLiteral(".SS unproject %1\n").arg(name)), qPrintable(name));
            QVERIFY2(bash.contains(QStringLiteral(" %1 ").arg(name)), qPrintable(name));
            QVERIFY2(zsh.contains(QStringLiteral("'%1:").arg(name)), qPrintable(name));
            QVERIFY2(fish.contains(QStringLiteral(" -a %1 ").arg(name)), qPrintable(name));
        }
    }

    void theShellsReadTheirCompletions_data()
    {
        addColumn<QString>("shell");
        for (const char *shell : {"bash", "zsh", "fish"})
            newRow(shell) << QString::fromLatin1(shell);
    }

    void theShellsReadTheirCompletions()
    {
        QFETCH(QString, shell);
        if (QStandardPaths::findExecutable(shell).isEmpty())
            QSKIP("This shell is not installed.");
        for (const char *program : {"unproject", "unprojector"}) {
            const QString file = manualFile(QLatin1String(program) + u'.' + shell);
            QCOMPARE(QProcess::execute(shell, {QStringLiteral("-n"), file}), 0);
        }
    }

    void bashCompletes_data()
    {
        addColumn<QString>("line");
        addColumn<QString>("offers");
        const auto row = [](const char *line, const char *offers) {
            newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(offers);
        };
        row("unproject po", "points");
        row("unproject points --f", "--format");
        row("unproject points --format j", "jsonl");
        row("unproject scene --y ''", "down up");
        row("unproject points sc", "");
        row("unproject cloud -o --", "");
        row("unproject landmarks --table /us", "/usr"); // a folder, and no file
        row("unprojector --pl", "--place");
        row("unprojector --place d", "doctor");
        row("unprojector --smooth-edges ''", "on off");
        row("unprojector scan", "");
    }

    void bashCompletes()
    {
        if (QStandardPaths::findExecutable(QStringLiteral("bash")).isEmpty())
            QSKIP("bash is not installed.");
        QFETCH(QString, line);
        QFETCH(QString, offers);
        const QString program = line.section(u' ', 0, 0);
        const QString script =
            QStringLiteral("source '%1'; COMP_WORDS=(%2); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _%3; "
                           "echo \"${COMPREPLY[*]}\"")
                .arg(manualFile(program + QStringLiteral(".bash")), line, program);
        QCOMPARE(said(QStringLiteral("bash"), {QStringLiteral("-c"), script}).trimmed(), offers);
    }

    void theManualIsWellFormed_data()
    {
        addColumn<QString>("page");
        for (const char *page : {"unproject.1", "unprojector.1"})
            newRow(page) << manualFile(QString::fromLatin1(page));
    }

    /// Every line begins with a known request or is text, and no escape is unknown.
    void theManualIsWellFormed()
    {
        QFETCH(QString, page);
        const QString text = textOf(page);
        static const QRegularExpression request(QStringLiteral("^[.'].*$"), QRegularExpression::MultilineOption);
        static const QRegularExpression known(QStringLiteral("^\\.(TH|SH|SS|B|BR|PP|TP|nf|fi)( |$)"));
        for (auto lines = request.globalMatch(text); lines.hasNext();) {
            const QString line = lines.next().captured();
            QVERIFY2(known.match(line).hasMatch(), qPrintable(line));
        }
        static const QRegularExpression unknownEscape(QStringLiteral("\\\\[^e&f-].*"));
        QVERIFY2(!text.contains(unknownEscape), qPrintable(unknownEscape.match(text).captured()));
    }

    void theIconHasItsSizes()
    {
        QList<int> widths;
        for (const QSize &size : programIcon().availableSizes()) {
            QCOMPARE(size.width(), size.height());
            widths << size.width();
        }
        std::sort(widths.begin(), widths.end());
        QCOMPARE(widths, (QList<int>{16, 24, 32, 48, 64, 128, 256}));
        for (const int width : std::as_const(widths))
            QCOMPARE(QImage(QStringLiteral(":/icons/unprojector-%1.png").arg(width)).size(), QSize(width, width));
    }

    void theDesktopTakesItsFiles_data()
    {
        addColumn<QString>("program");
        addColumn<QStringList>("arguments");
        const QString base = packagingFile(QStringLiteral("io.github.unprojector.unprojector"));
        newRow("menu entry") << QStringLiteral("desktop-file-validate")
                             << QStringList{base + QStringLiteral(".desktop")};
        newRow("software centre") << QStringLiteral("appstreamcli")
                                  << QStringList{QStringLiteral("validate"), QStringLiteral("--no-net"),
                                                 QStringLiteral("--pedantic"), base + QStringLiteral(".metainfo.xml")};
    }

    void theDesktopTakesItsFiles()
    {
        QFETCH(QString, program);
        QFETCH(QStringList, arguments);
        if (QStandardPaths::findExecutable(program).isEmpty())
            QSKIP("The validator is not installed.");
        if (program == QStringLiteral("appstreamcli")
            && !said(program, {QStringLiteral("--version")}).contains(QStringLiteral(" 0.")))
            QSKIP("Later versions want an address on the web.");
        QCOMPARE(QProcess::execute(program, arguments), 0);
    }
};

UNPROJECTOR_TEST(TestPackaging)
#include "test_packaging.moc"
