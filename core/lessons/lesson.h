#pragma once

#include "core/geometry/given_point.h"
#include "core/geometry/result.h"
#include "core/geometry/viewport.h"
#include "core/lessons/highlight.h"
#include "core/lessons/link.h"
#include "core/ray/scene_rays.h"
#include "core/text/json_value.h"

#include <glm/vec2.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Lessons: what to look at, step by step, as files. One file a lesson, resources/lessons/NAME.json, with everything in it and its
/// texts in English; NAME_LANGUAGE.json beside it has the texts alone in another language, by the steps' ids, as translators'
/// tools expect them. lessons.json lists the names in their order.
///
///   {
///     "title": "The Pipeline",
///     "steps": [{
///       "id": "model_view",                     small letters, digits and _, a letter first: paths name it
///       "title": "Modelview",
///       "text": ["A paragraph …", "…"],         a little HTML, links and statements, see below
///       "source": "Zhang Ci, figure 2.7",       optional
///       "scene": "zhangci-model-view",          one of scene::examples(), or a scene document as in scene_file.h
///       "change": {"projection": {"near": 2}},  or, instead: the scene of the step before, with this merged in (RFC 7396)
///       "view": [300, 300],                     optional: the view's size, device pixels, that the numbers need
///       "place": "pipeline",                    optional: the workspace, see kWorkspaceNames
///       "panels": ["parameters"],               optional: shown there, see kPanelNames
///       "highlights": ["axes", "volume"],       optional: letters written into the pictures, see Highlight
///       "points": {                             optional: what paths and links name
///         "corner": {"space": "object", "coordinates": [4, 4, -4], "object": "Quad"},
///         "clicked": {"pixel": [162, 187]},     what a click there gives: the pixel's centre, the depth of the mesh
///         "taken": {"pixel": [162, 187], "snap": "vertex"}},   or the vertex, edge or face that it takes: ray::Snap
///       "set": {                                optional: what links change of the scene, see settingsWith
///         "other": {"point": {"space": "eye", "coordinates": [2, 1, 0]}}},
///       "question": {                           optional
///         "text": "Which z …?", "answer": "eye.z", "tolerance": 0.01, "reveal": ["…"],     or "quoted 4", of the source
///         "hides": ["inspector"]}               optional: more panels that have the answer, see panelsWithAnswer
///     }]
///   }
///
/// A step without "scene" has that of the step before, with its "change" if there is one, and its view, place, points and changes too.
/// Titles and texts say their numbers by statements,
///
///   its z is {−8 = modelview[2][3]}, at {(0.5, 0.5) = corner.ndc.x, corner.ndc.y}
///
/// of which the reader sees what stands before the last " = "; what stands behind it says where each number comes from, see
/// StepNumbers, or is the word "quoted" for numbers of the source that the text speaks of. A test computes all but those, and
/// takes none that has no path in it: {1 = 1} would always be right.
///
/// Links lead on; link.h says where to.
namespace unprojector::lessons {

/// What is wrong with a lesson: one line in English that names file and key, for those who write lessons.
struct LessonError {
    std::string text;
};

/// What a click on a pixel gives, or takes of the meshes.
struct ClickedPixel {
    geometry::DevicePixel pixel{};
    ray::Snap snap = ray::Snap::Surface;
};

/// A point that a step's paths and links name: in numbers, or by a click.
using StepPoint = std::variant<geometry::GivenPoint, ClickedPixel>;

struct Question {
    std::string text;
    std::string answer;              ///< an expression of StepNumbers, or "quoted" and a number of the source
    double tolerance = 0.0;          ///< how far off an answer may be
    std::vector<std::string> reveal; ///< paragraphs: why it is so
    std::vector<Panel> hides;        ///< panels that show the answer, covered until it is given
};

struct Step {
    std::string id;
    std::string title;
    std::vector<std::string> text; ///< paragraphs
    std::string source;            ///< may be empty
    text::JsonValue scene;         ///< the whole document, or the name of one of scene::examples()
    std::optional<glm::ivec2> view;
    std::optional<Workspace> workspace; ///< nothing: wherever one is
    std::vector<Panel> panels;
    std::set<Highlight> highlights;
    std::map<std::string, StepPoint> points;
    std::map<std::string, text::JsonValue> changes; ///< "set": merge patches of the scene document, by name
    std::optional<Question> question;
};

struct Lesson {
    std::string name; ///< of its file, without suffix
    std::string title;
    std::vector<Step> steps; ///< at least one

    /// @return null where there is none
    const Step *step(std::string_view id) const;
};

/// @param json   of NAME.json
/// @param texts  of NAME_LANGUAGE.json, or nothing. What it does not have stays English, a step or a key that the lesson does not
///               have is an error
geometry::Result<Lesson, LessonError> parseLesson(std::string_view name, std::string_view json,
                                                  const std::optional<std::string_view> &texts = {});

/// What of `lesson` has no text in a translation, as keys: "model_view.title". For the test.
/// @return the errors of parseLesson
geometry::Result<std::vector<std::string>, LessonError> untranslated(const Lesson &lesson, std::string_view texts);

/// The panels that show an answer. They are derived, so that no question can leave one uncovered: Pipeline and Comparison the
/// coordinate of a point that is followed or can be clicked, Pipeline the entry of a matrix or of its factors. Viewport and Life of
/// the View show pixels as well, Depth Precision and Life of the View depths.
/// @param answer   an expression of StepNumbers: one that is more than a path, or of another step, stands in no panel
/// @param clicked  the step's points that a click can read
std::vector<Panel> panelsWithAnswer(std::string_view answer, const std::set<std::string> &clicked);

/// The names that lessons.json lists.
geometry::Result<std::vector<std::string>, LessonError> parseLessonNames(std::string_view json);

} // namespace unprojector::lessons
