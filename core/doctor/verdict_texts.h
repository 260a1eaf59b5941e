#pragma once

#include "core/doctor/diagnosis.h"

#include <string>

namespace unprojector::doctor {

// The sentences about a diagnosis, for the command and the window, in the language of text::tr().

/// "y not flipped", and which of several ways to make it: "pixel corner (x only)".
std::string candidateName(const Candidate &candidate);
/// A headline: "right", "right, as far as the ray tells", "unknown", or the points of the scene that the point is.
/// @pre no mistake is named
std::string verdictName(const Diagnosis &diagnosis);
/// That the point is right, that it is one of the scene, or why neither this nor a mistake can be said.
/// @pre no mistake is named
std::string verdictSentence(const Diagnosis &diagnosis);
/// "all 11 digits given", "all 9 digits that count of the 12 given, the last not rounded but cut off".
std::string digitsText(const Candidate &candidate, const Diagnosis &diagnosis);
/// Where the first point lies in the picture, by the right matrices, and what of that is wrong.
std::string projectedText(const Diagnosis &diagnosis);
/// "less than 0.0001 % that an unrelated point is explained as well".
std::string chanceText(double chance);
/// That digits were given which single precision does not hold.
std::string precisionSentence();
/// What tells the candidates apart: "by a click at 125.5 635.5: the answers are 5.1 or more apart there".
/// @pre there is such a click
std::string nextClickText(const Diagnosis &diagnosis);
/// How the code of two mistakes is to be read, which are named.
std::string twoChangesSentence(const std::string &first, const std::string &second);

} // namespace unprojector::doctor
