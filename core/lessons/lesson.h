#pragma once

#include "core/base/json.h"
#include "core/geometry/given_point.h"
#include "core/geometry/result.h"
#include "core/geometry/viewport.h"
#include "core/lessons/highlight.h"
#include "core/lessons/link.h"
#include "core/ray/scene_rays.h"

#include <glm/vec2.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Lessons: tours through the program, step by step, as files. Each lesson is one file,
/// resources/lessons/NAME.json, with all its data and its texts in English. NAME_LANGUAGE.json
/// beside it has only the texts in another language, by the steps' ids, in the form for
/// translators' tools. lessons.json lists the names in order.
///
///   {
///     "title": "The Pipeline",
///     "steps": [{
///       "id": "model_view",                    small letters, digits and _, a letter first
///       "title": "Modelview",
///       "text": ["A paragraph …", "…"],        a little HTML, links and statements, see below
///       "source": "Zhang Ci, figure 2.7",      optional
///       "scene": "zhangci-model-view",         one of examples::kExamples, or a scene document as in
///                                              scene_file.h
///       "change": {"projection": {"near": 2}}, or, instead: merged into the previous step's
///                                              scene (RFC 7396)
///       "view": [300, 300],                    optional: the view's size that the numbers
///                                              need, device pixels
///       "place": "pipeline",                   optional: the workspace, see kWorkspaceNames
///       "panels": ["parameters"],              optional: panels to show, see kPanelNames
///       "highlights": ["axes", "volume"],      optional: letters added to the views, see Highlight
///       "points": {                            optional: points for paths and links
///         "corner": {"space": "object", "coordinates": [4, 4, -4], "object": "Quad"},
///         "clicked": {"pixel": [162, 187]},    a click: the pixel's centre, the depth of the mesh
///         "taken": {"pixel": [162, 187], "snap": "vertex"}},
///                                              or the vertex, edge or face it snaps to: ray::Snap
///       "set": {                               optional: changes by links, see settingsWith
///         "other": {"point": {"space": "eye", "coordinates": [2, 1, 0]}}},
///       "question": {                          optional
///         "text": "Which z …?", "answer": "eye.z", "tolerance": 0.01, "reveal": ["…"],
///                                              or "quoted 4", a number of the source
///         "hides": ["inspector"]}              optional: more panels with the answer than its source
///                                              tells
///     }]
///   }
///
/// A step without "scene" takes the previous step's scene, with its own "change" if it has one, and
/// the previous view, place, points and changes too. Titles and texts contain numbers as
/// statements,
///
///   its z is {−8 = modelview[2][3]}, at {(0.5, 0.5) = corner.ndc.x, corner.ndc.y}
///
/// The reader sees the part before the last " = ". The part behind it is the source of each number,
/// see StepNumbers, or the word "quoted" for numbers of the text's source. A test computes all but
/// the quoted ones, and checks names, changes and links. It rejects sources without a path: {1 = 1}
/// would always be right.
///
/// link.h lists the targets of links.
namespace unprojector::lessons {

/// A click on a pixel, and the element of the mesh that it snaps to.
struct ClickedPixel {
    geometry::DevicePixel pixel{};
    ray::Snap snap = ray::Snap::Surface;
};

/// A point for a step's paths and links: in numbers, or by a click.
using StepPoint = std::variant<geometry::GivenPoint, ClickedPixel>;

struct Question {
    std::string text;
    std::string answer;              ///< an expression of StepNumbers, or "quoted" and a number of the source
    double tolerance = 0.0;          ///< largest error of a correct answer
    std::vector<std::string> reveal; ///< paragraphs: the explanation
    std::vector<Panel> hides;        ///< panels that show the answer, covered until the user gives it
};

struct Step {
    std::string id;
    std::string title;
    std::vector<std::string> text; ///< paragraphs
    std::string source;            ///< may be empty
    base::JsonValue scene;         ///< the whole document, or the name of one of examples::kExamples
    std::optional<glm::ivec2> view;
    std::optional<Workspace> workspace; ///< empty: any
    std::vector<Panel> panels;
    std::set<Highlight> highlights;
    std::map<std::string, StepPoint> points;
    std::map<std::string, base::JsonValue> changes; ///< "set": merge patches of the scene document, by name
    std::optional<Question> question;
};

struct Lesson {
    std::string name; ///< name of its file, without suffix
    std::string title;
    std::vector<Step> steps; ///< at least one

    /// The step with an id.
    /// @return null if there is none
    const Step *step(std::string_view id) const;
};

/// Parses a lesson.
/// @param json   content of NAME.json
/// @param texts  content of NAME_LANGUAGE.json, or empty. Texts that it lacks stay English; a step
///         or a key that the lesson lacks is an error
base::Expected<Lesson, base::Error> parseLesson(std::string_view name, std::string_view json,
                                                const std::optional<std::string_view> &texts = {});

/// A title or a paragraph as the reader sees it: statements without braces and sources.
std::string shownText(std::string_view text);

/// Adds the names of the points that links of these paragraphs click.
void addClicked(const std::vector<std::string> &paragraphs, std::set<std::string> &names);

/// The names that lessons.json lists.
base::Expected<std::vector<std::string>, base::Error> parseLessonNames(std::string_view json);

} // namespace unprojector::lessons
