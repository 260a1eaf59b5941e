#pragma once

#include <QString>
#include <QStringList>

#include <string>

namespace unprojector::gui {

/// A text of core with the full stop that core omits.
QString ended(const std::string &said);
/// The same with a capital letter: for a text that begins with a word, not with a file name.
QString sentence(const std::string &said);

/// Joins sentences with blanks, but without one after a Chinese sentence, whose full stop includes
/// its space. Skips empty ones.
QString joinSentences(const QStringList &said);

} // namespace unprojector::gui
