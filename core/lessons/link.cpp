#include "core/lessons/link.h"

#include "core/base/text_scanner.h"

#include <algorithm>

namespace unprojector::lessons {
namespace {

template <class Id, std::size_t count>
std::optional<Id> named(const std::array<const char *, count> &names, std::string_view name)
{
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<Id>(found - names.begin()));
}

std::optional<Link> viewSizeOf(std::string_view text)
{
    const std::size_t between = text.find('x');
    if (between == std::string_view::npos)
        return std::nullopt;
    const auto width = base::numberIn<int>(text.substr(0, between)),
               height = base::numberIn<int>(text.substr(between + 1));
    return width > 0 && height > 0 ? std::optional<Link>(ViewSizeLink{{*width, *height}}) : std::nullopt;
}

std::optional<Link> matrixOf(std::string_view text)
{
    static_assert(static_cast<int>(pipeline::PipelineStage::ViewportMatrix) == 3);
    constexpr std::array kNames{"model", "view", "projection", "viewport"};
    const auto stage = named<pipeline::PipelineStage>(kNames, text);
    return stage ? std::optional<Link>(MatrixLink{*stage}) : std::nullopt;
}

std::optional<Link> actionOf(std::string_view text)
{
    const std::size_t colon = text.find(':');
    const std::string_view state = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
    if (text.substr(0, colon).empty() || (colon != std::string_view::npos && state != "off"))
        return std::nullopt;
    return ActionLink{std::string(text.substr(0, colon)), state.empty()};
}

} // namespace

std::optional<Panel> panelOf(std::string_view name)
{
    return named<Panel>(kPanelNames, name);
}

std::optional<Workspace> workspaceOf(std::string_view name)
{
    return named<Workspace>(kWorkspaceNames, name);
}

std::optional<Link> parseLink(std::string_view text)
{
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos)
        return std::nullopt;
    const std::string_view scheme = text.substr(0, colon), target = text.substr(colon + 1);
    if (scheme == "restart" && target.empty())
        return RestartLink{};
    if (scheme == "point" && target.empty())
        return GivenPointLink{};
    if (target.empty())
        return std::nullopt;
    if (scheme == "formulas")
        return FormulasLink{std::string(target)};
    if (scheme == "click")
        return ClickLink{std::string(target)};
    if (scheme == "set")
        return SetLink{std::string(target)};
    if (scheme == "step")
        return StepLink{std::string(target)};
    if (scheme == "panel") {
        const std::optional<Panel> panel = panelOf(target);
        return panel ? std::optional<Link>(PanelLink{*panel}) : std::nullopt;
    }
    if (scheme == "place") {
        const std::optional<Workspace> workspace = workspaceOf(target);
        return workspace ? std::optional<Link>(WorkspaceLink{*workspace}) : std::nullopt;
    }
    if (scheme == "apart" && target == "view")
        return FactorsLink{FactorsLink::Matrix::View};
    if (scheme == "apart" && target == "projection")
        return FactorsLink{FactorsLink::Matrix::Projection};
    if (scheme == "matrix")
        return matrixOf(target);
    if (scheme == "action")
        return actionOf(target);
    if (scheme == "view")
        return viewSizeOf(target);
    return std::nullopt;
}

} // namespace unprojector::lessons
