#include "core/files/standard_streams.h"
#include "core/threads/parallel.h"
#include "gui/document/portable.h"
#include "gui/lessons/lesson_player.h"
#include "gui/shell/appearance.h"
#include "gui/shell/language_menu.h"
#include "gui/shell/main_window.h"
#include "gui/shell/screenshot_run.h"
#include "gui/text/error_text.h"
#include "gui/text/print.h"
#include "gui/text/translation.h"
#include "gui/view/opengl_check.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFontDatabase>
#include <QMessageBox>
#include <QSettings>

#include <cstdio>
#include <cstdlib>
#include <optional>

namespace {

using namespace unprojector;
using namespace unprojector::gui;

struct CommandLine {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

constexpr QSize kLeastSize(200, 150), kMostSize(16384, 16384);

/// "1280x800", with any of x, X and ×
std::optional<QSize> parsedSize(QString text)
{
    const QStringList parts = text.replace(u'×', u'x').split(u'x', Qt::KeepEmptyParts, Qt::CaseInsensitive);
    bool isWidth = false, isHeight = false;
    const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(&isWidth), parts[1].toInt(&isHeight)) : QSize();
    const bool isSensible = isWidth && isHeight && size == size.expandedTo(kLeastSize).boundedTo(kMostSize);
    return isSensible ? std::optional(size) : std::nullopt;
}

/// "412,300" or "412.5,300.25"
std::optional<WidgetPoint> parsedPosition(const QString &text)
{
    const QStringList parts = text.split(u',');
    bool isX = false, isY = false;
    if (parts.size() != 2)
        return std::nullopt;
    const WidgetPoint position(parts[0].toDouble(&isX), parts[1].toDouble(&isY));
    return isX && isY ? std::optional(position) : std::nullopt;
}

/// Looked for before all words are judged: what is wrong with them is said in it.
std::optional<Language> languageIn(const QStringList &words)
{
    const QCommandLineOption language(QStringLiteral("language"), {}, QStringLiteral("LANGUAGE"));
    QCommandLineParser parser;
    parser.addOption(language);
    parser.parse(words);
    return languageOf(parser.value(language));
}

int usageError(const QString &reason)
{
    std::fprintf(stderr, "unprojector: %s\n", printed(reason).constData());
    return 2;
}

/// Prints what was asked for; a full disk is an error, not an answer.
int told(const QString &text)
{
    const std::string problem = print(printed(text).toStdString());
    return problem.empty()
               ? 0
               : usageError(
                   CommandLine::tr("Standard output cannot be written: %1.").arg(QString::fromStdString(problem)));
}

bool hasHanzi()
{
    return QFontDatabase::writingSystems().contains(QFontDatabase::SimplifiedChinese);
}

/// While it lives, Qt's abort where it cannot open a window, as on a display that does not answer, is a sentence and an exit
/// code. What else Qt says is said when it ends.
class WindowsOrReason {
public:
    /// @param sentence  with %1 for Qt's reason
    explicit WindowsOrReason(const QString &sentence)
    {
        s_sentence = sentence;
        s_said.clear();
        m_before = qInstallMessageHandler(hear);
    }
    ~WindowsOrReason()
    {
        qInstallMessageHandler(m_before);
        for (const QString &said : std::as_const(s_said))
            std::fprintf(stderr, "%s\n", printed(said).constData());
    }
    WindowsOrReason(const WindowsOrReason &) = delete;
    WindowsOrReason &operator=(const WindowsOrReason &) = delete;

private:
    static void hear(QtMsgType type, const QMessageLogContext &, const QString &message)
    {
        s_said << message;
        if (type == QtFatalMsg) // the first is of the display, the last of plugins
            std::_Exit(usageError(s_sentence.arg(s_said.front().section(u'\n', 0, 0).trimmed())));
    }

    static inline QString s_sentence;
    static inline QStringList s_said;
    QtMessageHandler m_before;
};

bool hasDisplay()
{
#ifdef Q_OS_LINUX
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")
           || !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication::setApplicationName(QStringLiteral("Unprojector"));
    QCoreApplication::setOrganizationName(QStringLiteral("Unprojector"));
    QCoreApplication::setApplicationVersion(QStringLiteral(UNPROJECTOR_VERSION));

    std::optional<files::ParentConsole> console(std::in_place);
    // The words are judged before there is a window, so that --help and mistakes need no display.
    std::optional<QCoreApplication> words(std::in_place, argc, argv);
    const std::optional<Language> spoken = languageIn(words->arguments());
    std::optional<Translation> translation(std::in_place, languagesOf(spoken.value_or(Language::System)));
    const QString folder = QCoreApplication::applicationDirPath();
    if (isPortable(folder)) {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
    }

    QCommandLineParser parser;
    parser.setApplicationDescription(
        CommandLine::tr("Click a pixel of a 3-D view and get its world coordinate, computed twice."));
    // Qt's own help option brings --help-all along, which here would be the same.
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")},
                                  CommandLine::tr("Say how the program is called, and quit."));
    const QCommandLineOption version = parser.addVersionOption();
    const QCommandLineOption screenshot(
        QStringLiteral("screenshot"),
        CommandLine::tr("Open, save a picture of the whole window, print the clicks as JSON, and quit."),
        QStringLiteral("OUT.png"));
    const QCommandLineOption size(QStringLiteral("size"),
                                  CommandLine::tr("Size of the window in logical pixels (default 1280x800)."),
                                  QStringLiteral("WxH"), QStringLiteral("1280x800"));
    const QCommandLineOption viewSize(
        QStringLiteral("view-size"),
        CommandLine::tr("Size of the view itself in logical pixels, whatever font and language make of the panels: the "
                        "same clicks then mean the same pixels everywhere. Instead of --size."),
        QStringLiteral("WxH"));
    const QCommandLineOption noPanels(QStringLiteral("no-panels"), CommandLine::tr("Give the view the whole window."));
    QStringList places;
    for (const char *name : lessons::kWorkspaceNames)
        places << QLatin1String(name);
    const QCommandLineOption place(
        QStringLiteral("place"),
        CommandLine::tr(
            "Work place to start at: %1. Without it that of the last time; for a picture the first of them.")
            .arg(places.join(QStringLiteral(", "))),
        QStringLiteral("PLACE"));
    const QCommandLineOption appearance(QStringLiteral("appearance"),
                                        CommandLine::tr("Colours of the window: desktop (as the desktop has them; "
                                                        "default), light or dark."),
                                        QStringLiteral("DESKTOP|LIGHT|DARK"));
    const QCommandLineOption language(
        QStringLiteral("language"),
        CommandLine::tr("Language of the program: system (that of the desktop; default), en or zh_CN."),
        QStringLiteral("SYSTEM|EN|ZH_CN"));
    const QCommandLineOption click(
        QStringLiteral("click"),
        CommandLine::tr("With --screenshot: press the left button at this position of the view, logical pixels from "
                        "its top-left corner. May be given several times."),
        QStringLiteral("X,Y"));
    const QCommandLineOption lesson(QStringLiteral("lesson"),
                                    CommandLine::tr("Start with a lesson, or with one of its steps: first, weng:3."),
                                    QStringLiteral("NAME[:STEP]"));
    const QCommandLineOption smooth(QStringLiteral("smooth-edges"),
                                    CommandLine::tr("Whether the edges of surfaces are drawn without steps: on or off. "
                                                    "What clicks read is the same."),
                                    QStringLiteral("ON|OFF"));
    parser.addOptions({help, screenshot, size, viewSize, noPanels, place, appearance, language, click, lesson, smooth});
    parser.addPositionalArgument(
        QStringLiteral("MODEL"),
        CommandLine::tr(
            "A scene, or model files: OBJ, STL, PLY, OFF, glTF, GLB; files of points beside them. Without any, the "
            "bundled scene."),
        QStringLiteral("[SCENE | MODEL …]"));

    if (!parser.parse(words->arguments()))
        return usageError(CommandLine::tr("%1 See --help.").arg(parser.errorText()));
    if (parser.isSet(help))
        return told(parser.helpText());
    if (parser.isSet(version))
        return told(QCoreApplication::applicationName() + u' ' + QCoreApplication::applicationVersion() + u'\n');
    const auto sizeError = [](const QString &option, const QString &value) {
        return usageError(
            CommandLine::tr("--%1 is %2; give width x height in pixels, such as 1280x800, from %3x%4 to %5x%6.")
                .arg(option, value)
                .arg(kLeastSize.width())
                .arg(kLeastSize.height())
                .arg(kMostSize.width())
                .arg(kMostSize.height()));
    };
    const std::optional<QSize> windowSize = parsedSize(parser.value(size));
    if (!windowSize)
        return sizeError(QStringLiteral("size"), parser.value(size));
    std::optional<QSize> sizeOfView;
    if (parser.isSet(viewSize)) {
        if (parser.isSet(size))
            return usageError(CommandLine::tr("Give --size or --view-size, not both."));
        sizeOfView = parsedSize(parser.value(viewSize));
        if (!sizeOfView)
            return sizeError(QStringLiteral("view-size"), parser.value(viewSize));
    }
    if (parser.isSet(place) && !places.contains(parser.value(place)))
        return usageError(CommandLine::tr("--place is %1; give one of: %2.")
                              .arg(parser.value(place), places.join(QStringLiteral(", "))));
    const std::optional<Appearance> colors = appearanceOf(parser.value(appearance));
    if (parser.isSet(appearance) && !colors)
        return usageError(
            CommandLine::tr("--appearance is %1; give desktop, light or dark.").arg(parser.value(appearance)));
    if (parser.isSet(language) && !spoken)
        return usageError(CommandLine::tr("--language is %1; give system, en or zh_CN.").arg(parser.value(language)));
    std::vector<WidgetPoint> clicks;
    for (const QString &text : parser.values(click)) {
        const std::optional<WidgetPoint> position = parsedPosition(text);
        if (!position)
            return usageError(
                CommandLine::tr("--click is %1; give x,y in logical pixels of the view, such as 412,300.").arg(text));
        clicks.push_back(*position);
    }
    if (!clicks.empty() && !parser.isSet(screenshot))
        return usageError(CommandLine::tr("--click works together with --screenshot OUT.png."));
    if (parser.isSet(lesson) && !parser.positionalArguments().isEmpty())
        return usageError(CommandLine::tr("Give --lesson or what to open, not both."));
    std::optional<bool> smoothEdges;
    if (parser.isSet(smooth)) {
        const QString choice = parser.value(smooth);
        if (choice != QStringLiteral("on") && choice != QStringLiteral("off"))
            return usageError(CommandLine::tr("--smooth-edges is %1; give on or off.").arg(choice));
        smoothEdges = choice == QStringLiteral("on");
    }
    std::vector<std::filesystem::path> files;
    for (const QString &file : parser.positionalArguments())
        files.emplace_back(file.toStdU16String());
    if (!hasDisplay())
        return usageError(CommandLine::tr("There is no display. Set DISPLAY, or run under xvfb-run."));
    // Qt and the drivers of OpenGL wait for ever for threads that do not start.
    constexpr std::size_t kThreadsOfAWindow = 16;
    if (!threads::canStartThreads(kThreadsOfAWindow))
        return usageError(
            CommandLine::tr("The system cannot start %1 more threads. Close other programs, then try again.")
                .arg(kThreadsOfAWindow));

    // What a script gets does not depend on what somebody has chosen in a menu.
    const auto speak = [&] {
        const Language unlessSaid = parser.isSet(screenshot) ? Language::System : keptLanguage();
        translation.emplace(languagesOf(spoken.value_or(unlessSaid)), hasHanzi());
    };
    const QString noWindow =
        CommandLine::tr("No window can be opened (%1). Set DISPLAY to a display that answers, or run under xvfb-run.");
    translation.reset();
    words.reset();
    // By this the desktop knows the window's menu entry and icon.
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.unprojector.unprojector"));
    std::optional<WindowsOrReason> windows(noWindow);
    std::optional<QApplication> application(std::in_place, argc, argv);
    windows.reset();
    speak();
    preferHanziOfChina();
    QString problem = openGLProblem();
#ifdef Q_OS_WIN
    if (!problem.isEmpty() && hasSoftwareOpenGL()) {
        // Only a new application chooses its OpenGL anew.
        translation.reset();
        application.reset();
        QCoreApplication::setAttribute(Qt::AA_UseSoftwareOpenGL);
        application.emplace(argc, argv);
        speak();
        preferHanziOfChina();
        problem = openGLProblem();
    }
#endif
    if (!problem.isEmpty()) {
        if (parser.isSet(screenshot))
            return usageError(problem);
        console.reset();
        QMessageBox::critical(nullptr, QCoreApplication::applicationName(), problem);
        return 2;
    }
    if (colors)
        setAppearance(*colors);
    else if (!parser.isSet(screenshot))
        setAppearance(appearanceOf(QSettings().value(QStringLiteral("window/appearance")).toString())
                          .value_or(Appearance::Desktop));

    if (parser.isSet(screenshot)) {
        if (spoken && translation->lacksFont()) // what was asked for is not what comes
            std::fprintf(stderr, "unprojector: %s\n", printed(missingFontText()).constData());
        ScreenshotRun run({parser.value(screenshot), *windowSize, sizeOfView, parser.value(place),
                           !parser.isSet(noPanels), parser.value(lesson), std::move(clicks), std::move(files),
                           smoothEdges});
        QObject::connect(&run, &ScreenshotRun::ended, &*application, &QCoreApplication::exit, Qt::QueuedConnection);
        run.start();
        return application->exec();
    }

    MainWindow::Options options;
    options.smoothEdges = smoothEdges;
    options.translation = &*translation;
    MainWindow window(options);
    if (parser.isSet(size))
        window.resize(*windowSize);
    if (files.empty())
        window.session().openBundledScene();
    else
        window.session().openFiles(std::move(files));
    window.session().offerRecovery();
    if (parser.isSet(place))
        window.workspaces().enter(*lessons::workspaceOf(parser.value(place).toStdString()));
    if (parser.isSet(noPanels))
        window.workspaces().hidePanels(true);
    window.show();
    if (parser.isSet(lesson)) {
        if (const QString unknown = window.findChild<LessonPlayer *>()->startAt(parser.value(lesson));
            !unknown.isEmpty())
            return usageError(unknown);
    }
    console.reset(); // whoever started the program goes on with it
    if (sizeOfView)
        window.setViewSize(*sizeOfView);
    return application->exec();
}
