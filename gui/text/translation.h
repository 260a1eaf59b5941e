#pragma once

#include <QLocale>
#include <QStringList>
#include <QTranslator>

namespace unprojector::gui {

/// As long as it lives, the program and Qt's own dialogs speak the first of the user's languages that they have; the
/// texts of the source are English. The application must live longer.
class Translation {
public:
    explicit Translation(const QStringList &languages = QLocale().uiLanguages());

private:
    QTranslator m_program;
    QTranslator m_qt;
};

} // namespace unprojector::gui
