#include "core/cli/terminal/refusal.h"

#include "core/base/printable.h"
#include "core/cli/terminal/progress_bar.h"

#include <cstdio>

namespace unprojector::cli {

void complain(std::string_view line)
{
    std::string text = base::printableLine(line);
    text += '\n';
    withoutProgressBar([&text] { std::fwrite(text.data(), 1, text.size(), stderr); });
}

void refuse(std::string_view reason)
{
    complain(reason);
    throw Refused();
}

} // namespace unprojector::cli
