#pragma once

#include <string>
#include <string_view>

namespace unprojector::cameras {

/// A pasted text in which only numbers of matrices look like numbers. Blanks replace what printing
/// adds: sizes (Array(16), 4×4 Matrix), labels of rows and columns, addresses, times, and the
/// second and third name of a component in a debugger (x = 1, r = 1, s = 1). Decimal commas become points,
/// and the D of a Fortran exponent becomes E.
/// @return as long as the text, so that positions stay
std::string withoutPrintersMarks(std::string_view text);

} // namespace unprojector::cameras
