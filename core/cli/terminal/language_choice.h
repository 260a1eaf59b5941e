#pragma once

#include "core/text/translation.h"

#include <string>

namespace unprojector::cli {

/// What says which language a user wants; empty where it is not set.
struct LanguageWishes {
    std::string all;      ///< LC_ALL
    std::string messages; ///< LC_MESSAGES
    std::string lang;     ///< LANG
    std::string list;     ///< LANGUAGE: several, the preferred first, with : between them
    std::string system;   ///< the languages of the system's own windows, as LANGUAGE has them
};

LanguageWishes languageWishes();

/// The language of the command, as programs that use gettext choose it: the first of LC_ALL, LC_MESSAGES, LANG and the
/// system's that is not empty says whether there is one at all; where it is C or POSIX, or nothing is set, it is English.
/// Else the first known one of LANGUAGE counts, where that is set. Deviation from gettext: a locale of another encoding than
/// UTF-8 gets English, since what is printed is UTF-8. Chinese is of the mainland: where traditional characters are written
/// (zh_TW, zh_HK, zh_MO) it is not taken.
/// Source: GNU gettext manual, "Setting the POSIX Locale"; POSIX, Base Definitions, 8.2.
text::Language chosenLanguage(const LanguageWishes &wishes);

} // namespace unprojector::cli
