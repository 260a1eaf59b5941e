#include "gui/text/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>

#include <array>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr std::array<std::pair<Language, const char *>, 3> kNames{
    {{Language::System, "system"}, {Language::English, "en"}, {Language::Chinese, "zh_CN"}}};

} // namespace

std::optional<Language> languageOf(const QString &name)
{
    for (const auto &[language, itsName] : kNames) {
        if (name == QLatin1String(itsName))
            return language;
    }
    return std::nullopt;
}

QString languageName(Language language)
{
    for (const auto &[candidate, name] : kNames) {
        if (candidate == language)
            return QLatin1String(name);
    }
    return {};
}

Translation::Translation(const QStringList &languages, bool hasHanzi) : m_system(languages), m_hasHanzi(hasHanzi)
{
    speak(m_system);
}

void Translation::choose(Language language)
{
    m_choice = language;
    speak(language == Language::System ? m_system : QStringList{languageName(language)});
}

void Translation::speak(const QStringList &languages)
{
    m_lacksFont = false;
    QString spoken;
    for (const QString &language : languages) {
        const QLocale locale(language);
        // English needs no file: a user who lists it before Chinese must not get Chinese.
        if (locale.language() == QLocale::English)
            break;
        QTranslator found;
        if (!found.load(locale, QStringLiteral("unprojector"), QStringLiteral("_"), QStringLiteral(":/translations")))
            continue;
        m_lacksFont = !m_hasHanzi && locale.language() == QLocale::Chinese;
        if (!m_lacksFont)
            spoken = language;
        break;
    }
    if (spoken == m_spoken)
        return;
    QCoreApplication::removeTranslator(&m_program);
    QCoreApplication::removeTranslator(&m_qt);
    m_spoken = spoken;
    if (spoken.isEmpty())
        return;
    const QLocale locale(spoken);
    if (m_program.load(locale, QStringLiteral("unprojector"), QStringLiteral("_"), QStringLiteral(":/translations")))
        QCoreApplication::installTranslator(&m_program);
    // The programs that pack Qt for Windows and macOS put all its modules into one file, "qt".
    const QString folder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
    if (m_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), folder)
        || m_qt.load(locale, QStringLiteral("qt"), QStringLiteral("_"), folder))
        QCoreApplication::installTranslator(&m_qt);
}

} // namespace unprojector::gui
