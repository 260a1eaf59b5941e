#include "gui/text/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>

namespace unprojector::gui {

Translation::Translation(const QStringList &languages)
{
    for (const QString &language : languages) {
        const QLocale locale(language);
        // English needs no file: a user who lists it before Chinese must not get Chinese.
        if (locale.language() == QLocale::English)
            return;
        if (!m_program.load(locale, QStringLiteral("unprojector"), QStringLiteral("_"),
                            QStringLiteral(":/translations")))
            continue;
        QCoreApplication::installTranslator(&m_program);
        // The programs that pack Qt for Windows and macOS put all its modules into one file, "qt".
        const QString folder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
        if (m_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), folder)
            || m_qt.load(locale, QStringLiteral("qt"), QStringLiteral("_"), folder))
            QCoreApplication::installTranslator(&m_qt);
        return;
    }
}

} // namespace unprojector::gui
