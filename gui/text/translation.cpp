#include "gui/text/translation.h"

#include "core/base/translation.h"
#include "gui/text/named_values.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QSettings>

namespace unprojector::gui {
namespace {

constexpr NamedValues<Language, 3> kNames{
    {{Language::System, "system"}, {Language::English, "en"}, {Language::Chinese, "zh_CN"}}};

const QString kLanguageKey = QStringLiteral("window/language");

} // namespace

std::optional<Language> languageOf(const QString &name)
{
    return valueNamed(name, kNames);
}

Language keptLanguage()
{
    return languageOf(QSettings().value(kLanguageKey).toString()).value_or(Language::System);
}

void keepLanguage(Language language)
{
    QSettings().setValue(kLanguageKey, nameAmong(kNames, language));
}

QStringList languagesOf(Language choice)
{
    return choice == Language::System ? QLocale().uiLanguages() : QStringList{nameAmong(kNames, choice)};
}

Translation::Translation(const QStringList &languages, bool hasHanzi) : m_hasHanzi(hasHanzi)
{
    for (const QString &language : languages) {
        const QLocale locale(language);
        // English needs no file: a user who lists it before Chinese must not get Chinese.
        if (locale.language() == QLocale::English)
            return;
        if (!m_program.load(locale, QStringLiteral("unprojector"), QStringLiteral("_"),
                            QStringLiteral(":/translations")))
            continue;
        m_lacksFont = !hasHanzi && locale.language() == QLocale::Chinese;
        if (!m_lacksFont)
            install(locale);
        return;
    }
}

void Translation::install(const QLocale &locale)
{
    QCoreApplication::installTranslator(&m_program);
    if (locale.language() == QLocale::Chinese)
        base::setLanguage(base::Language::Chinese);
    // Qt's own texts are in Qt's folder, or packed with the program. Some packagers put all modules
    // into one file, "qt".
    const auto loadsQt = [&](const QString &folder) {
        return m_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), folder)
               || m_qt.load(locale, QStringLiteral("qt"), QStringLiteral("_"), folder);
    };
    if (loadsQt(QLibraryInfo::path(QLibraryInfo::TranslationsPath))
        || loadsQt(QCoreApplication::applicationDirPath() + QStringLiteral("/translations")))
        QCoreApplication::installTranslator(&m_qt);
}

Translation::~Translation()
{
    base::setLanguage(base::Language::English);
}

} // namespace unprojector::gui
