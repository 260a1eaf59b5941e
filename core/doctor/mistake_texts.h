#pragma once

#include "core/doctor/diagnosis.h"

#include <string>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

// What is said of mistakes, in the language of text::tr(), for the command and the window. Ids are those of a candidate, of two
// mistakes "a+b".

/// The mistakes of an id: one or two; none of "right", "unknown", "known-point" and "".
std::vector<std::string> partsOf(std::string_view id);
/// In a few words: "y not flipped", of two "y not flipped + not divided by w".
std::string mistakeName(std::string_view id);
/// What the program does, a sentence for each of its mistakes.
std::string mistakeSentence(std::string_view id);
/// In which ways mistakes are made: "ratio 1.5; x only"; empty for none.
std::string waysText(const std::vector<VariantName> &ways);

/// "the world's origin and the camera's centre".
std::string knownPointName(const std::vector<KnownPoint> &known);
/// That the point is these, and what that usually comes from.
std::string knownPointSentence(const std::vector<KnownPoint> &known);

/// What a candidate that cannot be told from the first one shares with it, and what would tell them apart.
std::string alikeSentence(const Candidate &candidate);

} // namespace unprojector::doctor
