#include "gui/shell/start_options.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace unprojector::gui {
namespace {

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

/// The words for the sides in --view, in the order of StandardView.
constexpr std::array kSides{"front", "back", "right", "left", "top", "bottom"};

std::optional<geometry::StandardView> sideOf(const QString &word)
{
    const auto side = std::find(kSides.begin(), kSides.end(), word);
    return side != kSides.end() ? std::optional(static_cast<geometry::StandardView>(side - kSides.begin()))
                                : std::nullopt;
}

/// "412,300" or "412.5,300.25"
std::optional<geometry::WidgetPoint> parsedPosition(const QString &text)
{
    const QStringList parts = text.split(u',');
    bool isX = false, isY = false;
    if (parts.size() != 2)
        return std::nullopt;
    const geometry::WidgetPoint position(parts[0].toDouble(&isX), parts[1].toDouble(&isY));
    return isX && isY ? std::optional(position) : std::nullopt;
}

/// Reads the options and keeps the first error.
class OptionReader {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::StartOptions)
public:
    OptionReader();
    geometry::Result<StartOptions, QString> read(const QStringList &words);

private:
    void mistake(const QString &text)
    {
        if (m_mistake.isEmpty())
            m_mistake = text;
    }
    void readSizes();
    std::optional<QSize> size(const QString &option);
    void readLooks();
    void readClicks();

    QCommandLineParser m_parser;
    StartOptions m_options;
    QString m_mistake; ///< sentence
};

QString workspaceNames()
{
    QStringList names;
    for (const char *name : lessons::kWorkspaceNames)
        names << QLatin1String(name);
    return names.join(QStringLiteral(", "));
}

OptionReader::OptionReader()
{
    m_parser.setApplicationDescription(tr("Click a pixel of a 3-D view and get its world coordinate, computed twice."));
    m_parser.addVersionOption();
    m_parser.addOptions({
        // Qt's own help option adds --help-all, which would be the same here.
        {{"h", "help"}, tr("Print this help and quit.")},
        {"screenshot", tr("Open, save an image of the whole window, print the clicks as JSON, and quit."), "OUT.png"},
        {"series", tr("Open a folder of scans as a series. The landmarks of each scan are saved beside it."), "FOLDER"},
        {"screenshots",
         tr("With --series: write an image of each scan with its landmarks, and contact-sheet.png with all of them, to "
            "this folder, and quit."),
         "OUT"},
        {"view",
         tr("With --screenshots: the side that the images show: front, back, right, left, top or bottom. Default: the "
            "view in which the series opens."),
         "SIDE"},
        {"size", tr("Size of the window in logical pixels (default 1280x800); with --screenshots, of each image."),
         "WxH", "1280x800"},
        {"view-size",
         tr("Size of the view itself in logical pixels, instead of --size. The same clicks then mean the same pixels "
            "for every font and language."),
         "WxH"},
        {"no-panels", tr("Give the view the whole window.")},
        {"place",
         tr("Workspace to start in: %1. Default: the one used last; with --screenshot the first.")
             .arg(workspaceNames()),
         "PLACE"},
        {"appearance", tr("Colours of the window: desktop (the system's; default), light or dark."),
         "DESKTOP|LIGHT|DARK"},
        {"language", tr("Language of the program: system (the desktop's; default), en or zh_CN."), "SYSTEM|EN|ZH_CN"},
        {"click",
         tr("With --screenshot: press the left button at this position of the view, logical pixels from its top-left "
            "corner. May be given several times."),
         "X,Y"},
        {"lesson", tr("Start with a lesson or with one of its steps. Examples: weng, weng:3."), "NAME[:STEP]"},
        {"smooth-edges", tr("Draw smooth edges: on or off. Clicks read the same depths either way."), "ON|OFF"},
    });
    m_parser.addPositionalArgument("MODEL",
                                   tr("A scene, or model files (OBJ, STL, PLY, OFF, glTF, GLB) with files of "
                                      "landmarks. Default: the bundled scene."),
                                   "[SCENE | MODEL …]");
}

geometry::Result<StartOptions, QString> OptionReader::read(const QStringList &words)
{
    if (!m_parser.parse(words))
        return tr("%1 See --help.").arg(m_parser.errorText());
    if (m_parser.isSet("help")) {
        m_options.textToPrint = m_parser.helpText();
        return m_options;
    }
    if (m_parser.isSet("version")) {
        m_options.textToPrint =
            QCoreApplication::applicationName() + u' ' + QCoreApplication::applicationVersion() + u'\n';
        return m_options;
    }
    if (m_parser.isSet("screenshot"))
        m_options.picture = m_parser.value("screenshot");
    if (m_parser.isSet("lesson"))
        m_options.lesson = m_parser.value("lesson");
    if (m_parser.isSet("series"))
        m_options.series = m_parser.value("series");
    if (m_parser.isSet("screenshots"))
        m_options.pictures = m_parser.value("screenshots");
    for (const QString &file : m_parser.positionalArguments())
        m_options.files.emplace_back(file.toStdU16String());
    readSizes();
    readLooks();
    readClicks();
    if (m_options.lesson && !m_options.files.empty())
        mistake(tr("Give --lesson or files to open, not both."));
    if (m_options.series && (m_options.lesson || !m_options.files.empty()))
        mistake(tr("Give --series alone, without --lesson and without files to open."));
    if (m_options.pictures && !m_options.series)
        mistake(tr("--screenshots works together with --series FOLDER."));
    if (m_parser.isSet("view")) {
        m_options.side = sideOf(m_parser.value("view"));
        if (!m_options.side)
            mistake(tr("--view is %1; give front, back, right, left, top or bottom.").arg(m_parser.value("view")));
        if (!m_options.pictures)
            mistake(tr("--view works together with --screenshots OUT."));
    }
    if (m_options.picture && m_options.series)
        mistake(tr("--screenshot writes one image. For a series, give --screenshots OUT."));
    if (!m_mistake.isEmpty())
        return m_mistake;
    return m_options;
}

void OptionReader::readSizes()
{
    if (m_parser.isSet("size") && m_parser.isSet("view-size"))
        mistake(tr("Give --size or --view-size, not both."));
    if (m_parser.isSet("size") || m_options.isScreenshotRun())
        m_options.windowSize = size("size");
    if (m_parser.isSet("view-size"))
        m_options.viewSize = size("view-size");
}

std::optional<QSize> OptionReader::size(const QString &option)
{
    const std::optional<QSize> size = parsedSize(m_parser.value(option));
    if (!size)
        mistake(tr("--%1 is %2; give width x height in pixels, such as 1280x800, from %3x%4 to %5x%6.")
                    .arg(option, m_parser.value(option))
                    .arg(kLeastSize.width())
                    .arg(kLeastSize.height())
                    .arg(kMostSize.width())
                    .arg(kMostSize.height()));
    return size;
}

void OptionReader::readLooks()
{
    m_options.hasPanels = !m_parser.isSet("no-panels");
    const QString place = m_parser.value("place"), appearance = m_parser.value("appearance"),
                  language = m_parser.value("language"), smooth = m_parser.value("smooth-edges");
    m_options.workspace = lessons::workspaceOf(place.toStdString());
    if (m_parser.isSet("place") && !m_options.workspace)
        mistake(tr("--place is %1; give one of: %2.").arg(place, workspaceNames()));
    m_options.appearance = appearanceOf(appearance);
    if (m_parser.isSet("appearance") && !m_options.appearance)
        mistake(tr("--appearance is %1; give desktop, light or dark.").arg(appearance));
    m_options.language = languageOf(language);
    if (m_parser.isSet("language") && !m_options.language)
        mistake(tr("--language is %1; give system, en or zh_CN.").arg(language));
    if (smooth == "on" || smooth == "off")
        m_options.smoothEdges = smooth == "on";
    else if (m_parser.isSet("smooth-edges"))
        mistake(tr("--smooth-edges is %1; give on or off.").arg(smooth));
}

void OptionReader::readClicks()
{
    for (const QString &text : m_parser.values("click")) {
        if (const std::optional<geometry::WidgetPoint> position = parsedPosition(text))
            m_options.clicks.push_back(*position);
        else
            mistake(tr("--click is %1; give x,y in logical pixels of the view, such as 412,300.").arg(text));
    }
    if (m_parser.isSet("click") && !m_options.picture)
        mistake(tr("--click works together with --screenshot OUT.png."));
}

} // namespace

std::optional<Language> languageIn(const QStringList &words)
{
    QCommandLineParser parser;
    parser.addOption(QCommandLineOption("language", {}, "LANGUAGE"));
    parser.parse(words);
    return languageOf(parser.value("language"));
}

geometry::Result<StartOptions, QString> startOptions(const QStringList &words)
{
    return OptionReader().read(words);
}

} // namespace unprojector::gui
