#pragma once

#include <nlohmann/json.hpp>

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

/// The keys of a lesson's texts that a translation lacks, or has alone: "model_view.title".
/// @param lesson, translation  contents of the files
inline std::vector<std::string> untranslated(const std::string &lesson, const std::string &translation)
{
    const auto wanted = nlohmann::json::parse(lesson), there = nlohmann::json::parse(translation);
    std::vector<std::string> missing;
    const auto look = [&missing](const nlohmann::json &english, const nlohmann::json &own, const std::string &place,
                                 std::initializer_list<const char *> keys) {
        for (const char *key : keys) {
            const auto has = [key](const nlohmann::json &texts) { return texts.contains(key) && !texts[key].empty(); };
            if (has(english) != has(own))
                missing.push_back(place + key);
        }
    };
    look(wanted, there, {}, {"title"});
    for (const nlohmann::json &step : wanted.at("steps")) {
        nlohmann::json own = nlohmann::json::object();
        for (const nlohmann::json &each : there.at("steps")) {
            if (each.at("id") == step.at("id"))
                own = each;
        }
        const std::string id = step.at("id");
        look(step, own, id + '.', {"title", "text", "source"});
        if (step.contains("question"))
            look(step["question"], own.value("question", nlohmann::json::object()), id + ".question.",
                 {"text", "reveal"});
    }
    return missing;
}

} // namespace lessontexts
