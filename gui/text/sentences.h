#pragma once

#include <QString>
#include <QStringList>

#include <string>

namespace unprojector::gui {

/// What core says, with the full stop that its texts do not have.
QString ended(const std::string &said);
/// The same with a capital letter: for what begins with a word, not with the name of a file.
QString sentence(const std::string &said);

/// Sentences one after the other: with a blank between them, and with none where the one before ends as Chinese ones do, whose
/// full stop has its own room. Empty ones are left out.
QString joinSentences(const QStringList &said);

} // namespace unprojector::gui
