#pragma once

#include "core/doctor/diagnosis.h"
#include "core/report/report.h"

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

// Sentences about a diagnosis, for the command and the window, in the language of base::tr().

/// The candidate's name: "y not flipped", with the variant if there are several: "pixel corner (x
/// only)".
std::string candidateName(const Candidate &candidate);
/// A headline: "right", "right, as far as the ray tells", "unknown", or the names of the known
/// points.
/// @pre no mistake is named
std::string verdictName(const Diagnosis &diagnosis);
/// The sentence that the point is right, that it equals a point of the scene, or why neither this
/// nor a mistake is certain.
/// @pre no mistake is named
std::string verdictSentence(const Diagnosis &diagnosis);
/// The sentence that names the point which the verdict does not hold for. @pre diagnosis.except
std::string exceptSentence(const Diagnosis &diagnosis);
/// The explained digits: "all 11 digits given", "all 9 digits that count of the 12 given, the last
/// not rounded but cut off".
std::string digitsText(const Candidate &candidate, const Diagnosis &diagnosis);
/// The first point projected with the right matrices, and the part of it that is wrong.
std::string projectedText(const Diagnosis &diagnosis);
/// The chance in words: "less than 0.0001 % that an unrelated point is explained as well".
std::string chanceText(double chance);
/// The sentence that more digits were given than single precision holds.
std::string precisionSentence();
/// The click that distinguishes the candidates: "by a click at 125.5 635.5: the answers are 5.1 or
/// more apart there".
/// @pre such a click exists
std::string nextClickText(const Diagnosis &diagnosis);
/// The instruction for combining the code changes of two named mistakes.
std::string twoChangesSentence(const std::string &first, const std::string &second);

/// The whole diagnosis, with the lines of code to change. In the language of base::tr().
/// @param first  the point that the coordinates of the diagnosis belong to
report::Report reportOf(const Diagnosis &diagnosis, const WrongPoint &first);

} // namespace unprojector::doctor
