#pragma once

#include <string>
#include <string_view>

namespace unprojector::cameras {

/// A text in the form that NamedValues reads, "name: numbers", with as many lines:
///
/// - XML: <fx>800</fx> becomes fx: 800
/// - C++: Mat K = (Mat_<double>(3, 3) << 800, …) and Vec3d t(0, 0, 5) become K = 800, … and t = 0, 0, 5
/// - `unproject matrices`: a comment "# K: …" above numbers becomes K:
/// - NumPy: eye(3) and zeros(3) become their numbers
std::string withNames(std::string_view text);

} // namespace unprojector::cameras
