#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>

#include <optional>

namespace unprojector::gui {

/// The user's choice of the program's language.
enum class Language {
    System, ///< the first of the user's languages that the program supports
    English,
    Chinese,
};

/// The choice named "system", "en" or "zh_CN"; nothing for any other name.
std::optional<Language> languageOf(const QString &name);
/// The saved choice, which applies at the next start; System if none is saved.
Language keptLanguage();
void keepLanguage(Language language);
/// The languages of a choice for Translation, the preferred one first.
QStringList languagesOf(Language choice);

/// Translates the program, the texts of core and Qt's dialogs while it lives: to the first of these
/// languages that they support; the texts in the source are English. Create it before the first
/// widget, because widgets keep their initial texts. The application must outlive it.
class Translation {
public:
    /// @param hasHanzi  whether Chinese can be displayed: without it, English replaces Chinese
    explicit Translation(const QStringList &languages = QLocale().uiLanguages(), bool hasHanzi = true);
    ~Translation();
    Translation(const Translation &) = delete;
    Translation &operator=(const Translation &) = delete;

    bool hasHanzi() const { return m_hasHanzi; }
    /// Returns whether the preferred language is skipped because its letters cannot be displayed.
    bool lacksFont() const { return m_lacksFont; }

private:
    void install(const QLocale &locale);

    bool m_hasHanzi;
    bool m_lacksFont = false;
    QTranslator m_program;
    QTranslator m_qt;
};

} // namespace unprojector::gui
