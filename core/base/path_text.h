#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace unprojector::base {

/// A path as UTF-8 with '/' between its parts, in any system encoding.
inline std::string utf8FromPath(const std::filesystem::path &path)
{
    const std::u8string text = path.generic_u8string();
    return std::string(text.begin(), text.end());
}

inline std::filesystem::path pathFromUtf8(std::string_view text)
{
    return std::filesystem::path(std::u8string(text.begin(), text.end()));
}

} // namespace unprojector::base
