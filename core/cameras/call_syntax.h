#pragma once

#include "core/base/letters.h"

namespace unprojector::cameras::syntax {

using base::isDigit;
using base::isLetter;

} // namespace unprojector::cameras::syntax
