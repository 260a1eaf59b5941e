#pragma once

#include <QString>

#include <string>
#include <vector>

/// Helpers that the tests of lessons share.
namespace lessontexts {

/// Each on a line.
inline QString written(const std::vector<std::string> &lines)
{
    QString text;
    for (const std::string &line : lines)
        text += QString::fromStdString(line) + QLatin1Char('\n');
    return text;
}

/// A lesson of one step on an existing scene, with these additional members.
inline std::string oneStep(const char *members)
{
    return std::string(R"({"title": "T", "steps": [{"id": "a", "title": "A", "text": ["x"])") + members + "}]}";
}

} // namespace lessontexts
