#pragma once

#include <string>
#include <string_view>

namespace unprojector::cameras {

/// The text; NamedValues reads it in any form.
inline std::string withNames(std::string_view text)
{
    return std::string(text);
}

} // namespace unprojector::cameras
