#pragma once

#include "core/pipeline/pipeline.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// The targets of a lesson's links, and the parts of the window that a lesson names.
namespace unprojector::lessons {

/// The panels of the window, in the order of its menus.
enum class Panel {
    Comparison,
    Pipeline,
    Parameters,
    Inspector,
    Lifecycle,
    Precision,
    Objects,
    Landmarks,
    Series,
    Doctor,
    Observer,
    Lesson
};
/// The names of panels, in the order of Panel. Lesson files, saved layouts and dock object names
/// use them.
inline constexpr std::array kPanelNames{"comparison", "pipeline", "parameters", "inspector", "lifecycle", "precision",
                                        "objects",    "points",   "series",     "doctor",    "observer",  "lesson"};

/// The workspaces of the window, in the order of its tool bar; the first one is the initial one.
enum class Workspace { Click, Pipeline, Landmarks, Doctor };
/// The names of workspaces, in the order of Workspace. Lesson files, saved layouts and the command
/// line use them.
inline constexpr std::array kWorkspaceNames{"click", "pipeline", "points", "doctor"};

static_assert(kPanelNames.size() == static_cast<std::size_t>(Panel::Lesson) + 1);
static_assert(kWorkspaceNames.size() == static_cast<std::size_t>(Workspace::Doctor) + 1);

constexpr const char *nameOf(Panel panel)
{
    return kPanelNames[static_cast<std::size_t>(panel)];
}
constexpr const char *nameOf(Workspace workspace)
{
    return kWorkspaceNames[static_cast<std::size_t>(workspace)];
}
/// @return empty if none has the name
std::optional<Panel> panelOf(std::string_view name);
std::optional<Workspace> workspaceOf(std::string_view name);

/// "formulas:frustum": an anchor in the page of formulas.
struct FormulasLink {
    std::string anchor;
};
/// "click:corner": a click on a point of the step.
struct ClickLink {
    std::string point;
};
/// "set:other": a change of the scene that the step defines under that name.
struct SetLink {
    std::string change;
};
/// "panel:pipeline": shows the panel.
struct PanelLink {
    Panel panel;
};
/// "place:click": goes to the workspace.
struct WorkspaceLink {
    Workspace workspace;
};
/// "step:ortho": goes to a step of the same lesson.
struct StepLink {
    std::string id;
};
/// "restart:": restores the initial scene of the step.
struct RestartLink {};
/// "apart:view" and "apart:projection": the factors of a matrix, in the pipeline's panel.
struct FactorsLink {
    enum class Matrix { View, Projection };
    Matrix matrix;
};
/// "matrix:projection": shows the matrix, in the pipeline's panel. Also "model", "view" and
/// "viewport".
struct MatrixLink {
    pipeline::PipelineStage stage; ///< one of these four
};
/// "action:perspective": triggers the action of that name in a menu or panel, and switches it on if
/// it can be off; "action:perspective:off" switches it off.
struct ActionLink {
    std::string name;
    bool isOn = true;
};
/// "view:300x300": gives the view a size.
struct ViewSizeLink {
    glm::ivec2 size; ///< device pixels
};
/// "point:": shows the given point in each space of the pipeline.
struct GivenPointLink {};

using Link = std::variant<FormulasLink, ClickLink, SetLink, PanelLink, WorkspaceLink, StepLink, RestartLink,
                          FactorsLink, MatrixLink, ActionLink, ViewSizeLink, GivenPointLink>;

/// @return empty if the text is no link of a lesson
std::optional<Link> parseLink(std::string_view text);

} // namespace unprojector::lessons
