#pragma once

#include "core/doctor/diagnosis.h"

#include <string>

namespace unprojector::cli {

/// A diagnosis as one JSON object on one line.
std::string doctorJson(const doctor::Diagnosis &diagnosis);

} // namespace unprojector::cli
