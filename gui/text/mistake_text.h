#pragma once

#include <QString>

#include <string>

namespace unprojector::gui {

// What core/doctor finds, in the language of the window. Ids are its own, of two mistakes "a+b".

/// In a few words: "y not flipped".
QString mistakeName(const std::string &id);
/// What the program does, a sentence for each of its mistakes.
QString mistakeSentence(const std::string &id);
/// Which of several ways to make it, as core/doctor says it: "ratio 1.5".
QString variantText(const std::string &variant);

} // namespace unprojector::gui
