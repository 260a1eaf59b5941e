#pragma once

#include "core/doctor/diagnosis.h"

#include <QString>

#include <string>
#include <vector>

namespace unprojector::gui {

// What core/doctor says of what it finds, in the language of the window. Ids are its own, of two mistakes "a+b".

/// In a few words: "y not flipped".
QString mistakeName(const std::string &id);
/// What the program does, a sentence for each of its mistakes.
QString mistakeSentence(const std::string &id);
/// In which of several ways they are made: "ratio 1.5".
QString waysText(const std::vector<doctor::Way> &ways);
/// That the point is one of the scene, and what that usually comes from.
QString knownPointSentence(const std::vector<doctor::KnownPoint> &known);
/// These points of the scene, named.
QString knownPointName(const std::vector<doctor::KnownPoint> &known);
/// What a candidate that cannot be told from the first one shares with it, and what would tell them apart.
QString alikeSentence(const doctor::Candidate &candidate);

} // namespace unprojector::gui
