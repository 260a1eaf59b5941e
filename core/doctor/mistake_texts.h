#pragma once

#include "core/doctor/diagnosis.h"

#include <string>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

// Texts about mistakes, in the language of base::tr(), for the command and the window. Ids are
// candidates' ids; two mistakes are "a+b".

/// The mistakes of an id: one or two; none for "right", "unknown", "known-point" and "".
std::vector<std::string> partsOf(std::string_view id);
/// A short name: "y not flipped", or for two "y not flipped + not divided by w".
std::string mistakeName(std::string_view id);
/// The program's behaviour, one sentence for each of its mistakes.
std::string mistakeSentence(std::string_view id);
/// The same for a candidate, after its solved values: "Your program's far plane is at 50, the scene's at 100."
std::string candidateSentence(const Candidate &candidate);
/// The variants of the mistakes: "ratio 1.5; x only"; empty for none.
std::string waysText(const std::vector<VariantName> &ways);

/// The names of known points: "the world's origin and the camera's centre".
std::string knownPointName(const std::vector<KnownPoint> &known);
/// The sentence that the point equals these, and the usual cause.
std::string knownPointSentence(const std::vector<KnownPoint> &known);

/// The sentence about a candidate that cannot be distinguished from the first one: what both share,
/// and what would distinguish them.
std::string alikeSentence(const Candidate &candidate);

} // namespace unprojector::doctor
