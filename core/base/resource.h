#pragma once

#include <string_view>

namespace unprojector::base {

/// The bytes of a file of the folder resources, which are compiled in: core/CMakeLists.txt lists
/// these files.
/// @param path  "translations/unproject_zh_CN.json"
std::string_view resource(std::string_view path);

} // namespace unprojector::base
