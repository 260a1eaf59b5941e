#pragma once

#include <QString>

#include <string>
#include <vector>

/// What the tests of lessons write and read.
namespace lessontexts {

/// Each on a line.
inline QString written(const std::vector<std::string> &lines)
{
    QString text;
    for (const std::string &line : lines)
        text += QString::fromStdString(line) + QLatin1Char('\n');
    return text;
}

/// A lesson of one step on a scene that is there, with these members besides.
inline std::string oneStep(const char *members)
{
    return std::string(R"({"title": "T", "steps": [{"id": "a", "title": "A", "text": ["x"])") + members + "}]}";
}

} // namespace lessontexts
