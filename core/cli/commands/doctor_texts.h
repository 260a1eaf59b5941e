#pragma once

#include "core/doctor/diagnosis.h"

#include <string>

namespace unprojector::cli {

/// A diagnosis as one JSON object on one line.
std::string doctorJson(const doctor::Diagnosis &diagnosis);
/// A diagnosis as text, with the lines of code to change.
/// @param first  the point that the coordinates of the diagnosis belong to
std::string doctorText(const doctor::Diagnosis &diagnosis, const doctor::WrongPoint &first);

} // namespace unprojector::cli
