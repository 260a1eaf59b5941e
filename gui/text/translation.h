#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>

#include <optional>

namespace unprojector::gui {

/// What the user can choose as the language of the program.
enum class Language {
    System, ///< the first of the user's languages that the program has
    English,
    Chinese,
};

/// "system", "en", "zh_CN"; nothing for any other.
std::optional<Language> languageOf(const QString &name);
/// The choice in the settings, which the next start of the program follows; System where they have none.
Language keptLanguage();
void keepLanguage(Language language);
/// What Translation takes: the names of the languages that a choice means, the preferred one first.
QStringList languagesOf(Language choice);

/// While it lives, the program, the texts of core and Qt's own dialogs use the first of these languages that they have; the
/// texts of the source are English. Made before the first widget, which keeps the texts that it is made with. The
/// application must live longer.
class Translation {
public:
    /// @param hasHanzi  whether Chinese can be shown: without it, English takes its place
    explicit Translation(const QStringList &languages = QLocale().uiLanguages(), bool hasHanzi = true);
    ~Translation();
    Translation(const Translation &) = delete;
    Translation &operator=(const Translation &) = delete;

    bool hasHanzi() const { return m_hasHanzi; }
    /// Whether the language that comes first is passed over because its letters cannot be shown.
    bool lacksFont() const { return m_lacksFont; }

private:
    void install(const QLocale &locale);

    bool m_hasHanzi;
    bool m_lacksFont = false;
    QTranslator m_program;
    QTranslator m_qt;
};

} // namespace unprojector::gui
