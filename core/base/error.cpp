#include "core/base/error.h"

namespace unprojector::base {

std::string Error::message() const
{
    std::string before = file;
    for (const int number : {line, column}) {
        if (number > 0)
            before += ':' + std::to_string(number);
    }
    for (const std::string &part : {subject, text}) {
        if (!before.empty() && !part.empty())
            before += ": ";
        before += part;
    }
    return before;
}

} // namespace unprojector::base
