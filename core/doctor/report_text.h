#pragma once

#include "core/doctor/diagnosis.h"

#include <string>

namespace unprojector::doctor {

/// A diagnosis as text, with the lines of code to change. In the language of base::tr().
/// @param first  the point that the coordinates of the diagnosis belong to
std::string reportText(const Diagnosis &diagnosis, const WrongPoint &first);

} // namespace unprojector::doctor
