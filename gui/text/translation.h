#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>

#include <optional>

namespace unprojector::gui {

/// What somebody can choose as the language of the program.
enum class Language {
    System, ///< the first of the user's languages that the program has
    English,
    Chinese,
};

/// "system", "en", "zh_CN"; nothing for any other.
std::optional<Language> languageOf(const QString &name);
QString languageName(Language language);

/// As long as it lives, the program, what core words, and Qt's own dialogs speak the first of these languages that they
/// have; the texts of the source are English. The application must live longer.
class Translation {
public:
    /// @param hasHanzi  whether Chinese can be shown: without it, it is passed over and English spoken
    explicit Translation(const QStringList &languages = QLocale().uiLanguages(), bool hasHanzi = true);
    ~Translation();
    Translation(const Translation &) = delete;
    Translation &operator=(const Translation &) = delete;

    Language choice() const { return m_choice; }
    bool hasHanzi() const { return m_hasHanzi; }
    /// Whether the language that comes first is passed over because its letters cannot be shown.
    bool lacksFont() const { return m_lacksFont; }

    /// Speaks another one. Windows hear of it by QEvent::LanguageChange, where anything changes.
    void choose(Language language);

private:
    void speak(const QStringList &languages);

    QStringList m_system;
    Language m_choice = Language::System;
    bool m_hasHanzi;
    bool m_lacksFont = false;
    QString m_spoken; ///< empty: English
    QTranslator m_program;
    QTranslator m_qt;
};

} // namespace unprojector::gui
