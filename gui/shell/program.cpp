#include "gui/shell/program.h"

#include "core/base/parallel.h"
#include "gui/document/portable.h"
#include "gui/shell/language_menu.h"
#include "gui/shell/main_window.h"
#include "gui/shell/screenshot_run.h"
#include "gui/shell/series_pictures.h"
#include "gui/shell/start_window.h"
#include "gui/text/print.h"
#include "gui/view/opengl_check.h"

#include <QFontDatabase>
#include <QMessageBox>
#include <QSettings>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr int kMistake = 2; ///< exit code

int failed(const QString &reason)
{
    printMessage(reason);
    return kMistake;
}

bool hasHanzi()
{
    return QFontDatabase::writingSystems().contains(QFontDatabase::SimplifiedChinese);
}

/// Converts Qt's abort when it cannot open a window, as on a display that does not answer, to a
/// sentence and an exit code. Prints Qt's other messages when it is destroyed.
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
        if (type == QtFatalMsg) // the first concerns the display, the last plugins
            std::_Exit(failed(s_sentence.arg(s_said.front().section(u'\n', 0, 0).trimmed())));
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

int Program::run()
{
    if (const std::optional<int> exitCode = readOptions())
        return *exitCode;
    // The desktop finds the window's menu entry and icon by this name.
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.unprojector.unprojector"));
    createApplication();
    QString problem = openGLProblem();
#ifdef Q_OS_WIN
    if (!problem.isEmpty() && hasSoftwareOpenGL()) {
        // Only a new application chooses its OpenGL again.
        QCoreApplication::setAttribute(Qt::AA_UseSoftwareOpenGL);
        createApplication();
        problem = openGLProblem();
    }
#endif
    if (m_options.isScreenshotRun())
        return problem.isEmpty() ? runForPicture() : failed(problem);
    if (problem.isEmpty())
        return runForUser();
    m_console.reset();
    QMessageBox::critical(nullptr, QCoreApplication::applicationName(), problem);
    return kMistake;
}

std::optional<int> Program::readOptions()
{
    const QCoreApplication application(m_argc, m_argv);
    const Translation translation(languagesOf(languageIn(QCoreApplication::arguments()).value_or(Language::System)));
    const QString folder = QCoreApplication::applicationDirPath();
    if (isPortable(folder)) {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
    }
    geometry::Result<StartOptions, QString> options = startOptions(QCoreApplication::arguments());
    if (!options)
        return failed(options.error());
    m_options = std::move(options).value();
    if (!m_options.textToPrint.isEmpty()) {
        // A full disk is an error.
        const std::string problem = print(printed(m_options.textToPrint).toStdString());
        return problem.empty()
                   ? 0
                   : failed(tr("Standard output cannot be written: %1.").arg(QString::fromStdString(problem)));
    }
    if (!hasDisplay())
        return failed(tr("There is no display. Set DISPLAY, or run under xvfb-run."));
    // Qt and OpenGL drivers wait for ever for threads that do not start.
    constexpr std::size_t kThreadsOfAWindow = 16;
    if (!base::canStartThreads(kThreadsOfAWindow))
        return failed(tr("The system cannot start %1 more threads. Close other programs, then try again.")
                          .arg(kThreadsOfAWindow));
    m_noWindow = tr("No window can be opened (%1). Set DISPLAY to a display that answers, or run under xvfb-run.");
    return std::nullopt;
}

void Program::createApplication()
{
    m_translation.reset();
    m_application.reset();
    {
        const WindowsOrReason windows(m_noWindow);
        m_application.emplace(m_argc, m_argv);
    }
    // A script gets the same image with any language chosen in the menu.
    const Language unlessSaid = m_options.isScreenshotRun() ? Language::System : keptLanguage();
    m_translation.emplace(languagesOf(m_options.language.value_or(unlessSaid)), hasHanzi());
    preferHanziOfChina();
}

int Program::runForUser()
{
    const QString kept = QSettings().value(QStringLiteral("window/appearance")).toString();
    setAppearance(m_options.appearance.value_or(appearanceOf(kept).value_or(Appearance::Desktop)));
    MainWindow::Options options;
    options.smoothEdges = m_options.smoothEdges;
    options.translation = &*m_translation;
    MainWindow window(options);
    if (const QString mistake = startWindow(window, m_options); !mistake.isEmpty())
        return failed(mistake);
    m_console.reset(); // the calling shell gets it back
    return QApplication::exec();
}

int Program::runForPicture()
{
    if (m_options.appearance)
        setAppearance(*m_options.appearance);
    if (m_options.language && m_translation->lacksFont()) // the requested language is replaced
        printMessage(missingFontText());
    const auto until = [this](auto run) {
        QObject::connect(&run, &decltype(run)::ended, &*m_application, &QCoreApplication::exit, Qt::QueuedConnection);
        run.start();
        return QApplication::exec();
    };
    return m_options.pictures ? until(SeriesPictures(m_options)) : until(ScreenshotRun(m_options));
}

} // namespace unprojector::gui
