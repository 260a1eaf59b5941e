#include "gui/text/translation.h"

#include "core/text/translation.h"
#include "gui/text/named_values.h"

#include <QCoreApplication>
#include <QLibraryInfo>

namespace unprojector::gui {
namespace {

constexpr NamedValues<Language, 3> kNames{
    {{Language::System, "system"}, {Language::English, "en"}, {Language::Chinese, "zh_CN"}}};

} // namespace

std::optional<Language> languageOf(const QString &name)
{
    return valueNamed(name, kNames);
}

QString languageName(Language language)
{
    return nameAmong(kNames, language);
}

Translation::Translation(const QStringList &languages, bool hasHanzi) : m_system(languages), m_hasHanzi(hasHanzi)
{
    speak(m_system);
}

Translation::~Translation()
{
    text::setLanguage(text::Language::English);
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
    const bool isChinese = !spoken.isEmpty() && QLocale(spoken).language() == QLocale::Chinese;
    text::setLanguage(isChinese ? text::Language::Chinese : text::Language::English);
    if (spoken.isEmpty())
        return;
    const QLocale locale(spoken);
    if (m_program.load(locale, QStringLiteral("unprojector"), QStringLiteral("_"), QStringLiteral(":/translations")))
        QCoreApplication::installTranslator(&m_program);
    // Qt's own texts are where Qt is, or where the program was packed with it. Some that pack it put all its modules into
    // one file, "qt".
    const auto loadsQt = [&](const QString &folder) {
        return m_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), folder)
               || m_qt.load(locale, QStringLiteral("qt"), QStringLiteral("_"), folder);
    };
    if (loadsQt(QLibraryInfo::path(QLibraryInfo::TranslationsPath))
        || loadsQt(QCoreApplication::applicationDirPath() + QStringLiteral("/translations")))
        QCoreApplication::installTranslator(&m_qt);
}

} // namespace unprojector::gui
