#pragma once

#include "core/base/translation.h"

#include <string>

namespace unprojector::cli {

/// The environment's settings of the user's language; empty where not set.
struct LanguageWishes {
    std::string all;      ///< LC_ALL
    std::string messages; ///< LC_MESSAGES
    std::string lang;     ///< LANG
    std::string list;     ///< LANGUAGE: several, the preferred first, separated by :
    std::string system;   ///< the languages of the system's own windows, in the form of LANGUAGE
};

LanguageWishes languageWishes();

/// The language of the command, chosen as programs with gettext do:
/// - The first of LC_ALL, LC_MESSAGES, LANG and the system's that is not empty decides. If it is C
///   or POSIX, or none is set, the language is English.
/// - Otherwise the first known language of LANGUAGE counts, where that is set.
/// - Deviation from gettext: a locale with an encoding other than UTF-8 gets English, because the
///   output is UTF-8.
/// - Chinese is simplified. Locales with traditional characters (zh_TW, zh_HK, zh_MO) do not get
///   it.
///
/// Source: GNU gettext manual, "Setting the POSIX Locale"; POSIX, Base Definitions, 8.2.
base::Language chosenLanguage(const LanguageWishes &wishes);

} // namespace unprojector::cli
