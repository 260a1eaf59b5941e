#include "core/lessons/covered_panels.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

namespace unprojector::lessons {
namespace {

/// The names of the step's points in its answer.
std::set<std::string> pointsIn(const Step &step)
{
    constexpr std::string_view kNameCharacters = "abcdefghijklmnopqrstuvwxyz0123456789_";
    std::set<std::string> names;
    const std::string_view answer = step.question->answer;
    for (std::size_t at = 0; at < answer.size();) {
        const std::size_t end = std::min(answer.find_first_not_of(kNameCharacters, at), answer.size());
        const std::string name(answer.substr(at, end - at));
        const bool isHead = at == 0 || answer[at - 1] != '.';
        if (isHead && step.points.contains(name))
            names.insert(name);
        at = std::max(end, at + 1);
    }
    return names;
}

/// True if both are clicks on the same pixel, with or without a snap.
bool haveSamePixel(const StepPoint &one, const StepPoint &other)
{
    const auto *a = std::get_if<ClickedPixel>(&one), *b = std::get_if<ClickedPixel>(&other);
    return a && b && a->pixel == b->pixel;
}

/// The points that texts up to a step have clicked in its scene.
std::set<std::string> clickedUpTo(const Lesson &lesson, std::size_t index)
{
    std::set<std::string> names;
    for (std::size_t i = 0; i <= index; ++i) {
        const Step &step = lesson.steps[i];
        if (step.scene != lesson.steps[index].scene)
            continue;
        addClicked(step.text, names);
        if (step.question)
            addClicked(step.question->reveal, names);
    }
    return names;
}

bool isInSight(const Step &asking, const std::set<std::string> &clicked)
{
    const std::set<std::string> named = pointsIn(asking);
    return named.empty() || std::any_of(named.begin(), named.end(), [&](const std::string &name) {
               return std::any_of(clicked.begin(), clicked.end(), [&](const std::string &one) {
                   const auto found = asking.points.find(one);
                   return one == name
                          || (found != asking.points.end() && haveSamePixel(asking.points.at(name), found->second));
               });
           });
}

} // namespace

std::vector<CoveredPanel> coveredPanels(const Lesson &lesson, std::size_t index, const std::set<std::size_t> &given)
{
    std::map<Panel, std::size_t> covered;
    const std::set<std::string> clicked = clickedUpTo(lesson, index);
    for (std::size_t i = index; i < lesson.steps.size() && lesson.steps[i].scene == lesson.steps[index].scene; ++i) {
        const Step &step = lesson.steps[i];
        if (!step.question || given.contains(i) || (i != index && !isInSight(step, clicked)))
            continue;
        for (const Panel panel : step.question->hides)
            covered[panel] = i;
    }
    std::vector<CoveredPanel> panels;
    panels.reserve(covered.size());
    for (const auto &[panel, until] : covered)
        panels.push_back({panel, until});
    return panels;
}

} // namespace unprojector::lessons
