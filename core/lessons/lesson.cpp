#include "core/lessons/lesson.h"

#include "core/base/json.h"
#include "core/examples/examples.h"
#include "core/geometry/drawable.h"
#include "core/lessons/highlights.h"
#include "core/scene_file/scene_fields.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace unprojector::lessons {
using namespace geometry;

namespace {

using base::Json, base::JsonNode;
using namespace scene_file;

/// Runs a description on an object; keys that it does not name are an error.
template <class Describe>
void readStrictly(SceneReader &json, const Describe &description)
{
    description(json);
    if (const Json unknown = json.take(); !unknown.empty())
        json.fail("there is no key \"" + unknown.begin().key() + "\"");
}

/// Parses a text and runs a description on it.
template <class Describe>
base::Done read(const std::string &file, std::string_view text, const Describe &description)
{
    const auto document = base::parseJson(text, file);
    if (!document)
        return document.error();
    try {
        SceneReader root(*document, text);
        readStrictly(root, description);
        return std::monostate{};
    } catch (base::Error &error) {
        error.file = file;
        return error;
    }
}

/// The members that a translation has as well.
void describeTexts(SceneReader &json, Question &question)
{
    json.optional("text", question.text);
    json.optional("reveal", question.reveal);
}

void describeTexts(SceneReader &json, Step &step)
{
    json.required("id", step.id);
    json.optional("title", step.title);
    json.optional("text", step.text);
    json.optional("source", step.source);
}

StepPoint readPoint(SceneReader &node)
{
    StepPoint point;
    readStrictly(node, [&](SceneReader &json) {
        static constexpr std::array kSnaps{"surface", "vertex", "edge", "face"};
        if (!json.has("pixel"))
            return describe(json, point.emplace<GivenPoint>());
        auto &clicked = point.emplace<ClickedPixel>();
        json.required("pixel", clicked.pixel);
        json.optional("snap", clicked.snap, Words{kSnaps});
    });
    return point;
}

/// @param document  of the previous step, null for the first
void readScene(SceneReader &json, Json &document)
{
    const bool hasScene = json.has("scene"), hasChange = json.has("change");
    const JsonNode whole(json, "scene");
    if (hasScene && hasChange)
        json.fail("has a \"scene\" and a \"change\"; there may be one of both");
    if (hasScene && whole.json().is_string()) {
        const std::string_view example = examples::exampleScene(whole.text());
        if (example.empty())
            whole.fail("the program brings along no scene \"" + whole.text() + "\"");
        document = Json::parse(example);
    } else if (hasScene) {
        document = whole.json();
    } else if (document.is_null()) {
        json.fail("the first step must have a \"scene\"");
    } else if (hasChange) {
        document.merge_patch(JsonNode(json, "change").json());
    }
}

/// The points that a click can read: pixels, and points that links of the texts click, in this step
/// and the previous ones.
std::set<std::string> clickedPoints(const Step &step, const std::vector<Step> &before)
{
    std::set<std::string> clicked;
    for (const auto &[name, point] : step.points) {
        if (std::holds_alternative<ClickedPixel>(point))
            clicked.insert(name);
    }
    addClicked(step.text, clicked);
    for (const Step &one : before) { // a click stays as long as the scene does
        if (one.scene != step.scene)
            continue;
        addClicked(one.text, clicked);
        if (one.question)
            addClicked(one.question->reveal, clicked);
    }
    return clicked;
}

/// The panels that show an answer. They are computed, so that no question can leave one uncovered:
/// - Pipeline and Comparison show the coordinates of a followed or clickable point.
/// - Pipeline shows the entries of matrices and of their factors.
/// - Viewport and Life of the View show pixels as well.
/// - Depth Precision and Life of the View show depths.
///
/// @param answer   an expression of StepNumbers. No panel shows an expression beyond a path, or
///         another step's number
/// @param clicked  the step's points that a click can read
std::vector<Panel> panelsWithAnswer(std::string_view answer, const std::set<std::string> &clicked)
{
    constexpr std::array kSpaces{"object", "world",  "eye",    "clip",    "ndc",
                                 "window", "device", "widget", "formula", "inverse"};
    constexpr std::array kPixelSpaces{"window", "device", "widget"};
    constexpr std::array kMatrices{"model",     "view",  "projection", "viewport",
                                   "modelview", "whole", "viewSteps",  "projectionSteps"};
    const auto isOneOf = [](const auto &names, std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!answer.empty() && answer.front() == '-') // the distance is no secret beside z
        answer.remove_prefix(1);
    if (answer.find_first_not_of("abcdefghijklmnopqrstuvwxyzS0123456789_.[]") != std::string_view::npos)
        return {};
    std::string_view head = answer.substr(0, answer.find_first_of(".["));
    const bool isOfNamed = head.size() < answer.size() && !isOneOf(kSpaces, head) && !isOneOf(kMatrices, head);
    if (isOfNamed) {
        if (!clicked.contains(std::string(head)))
            return {};
        answer.remove_prefix(head.size() + 1);
        head = answer.substr(0, answer.find_first_of(".["));
    }
    if (isOneOf(kPixelSpaces, head))
        return {Panel::Pipeline, Panel::Comparison, answer.ends_with(".z") ? Panel::Precision : Panel::Inspector,
                Panel::Lifecycle};
    if (isOneOf(kSpaces, head))
        return {Panel::Pipeline, Panel::Comparison};
    if (isOneOf(kMatrices, head))
        return {Panel::Pipeline};
    return {};
}

/// @param earlier  the steps read before
void describeStep(SceneReader &json, const std::vector<Step> &earlier, Step &step)
{
    describeTexts(json, step);
    if (!earlier.empty() && !json.has("scene")) {
        const Step &before = earlier.back();
        step.scene = before.scene;
        step.view = before.view;
        step.workspace = before.workspace;
        step.points = before.points;
        step.changes = before.changes;
    }
    readScene(json, step.scene.edit());
    json.optional("view", step.view, [](SceneReader &view, glm::ivec2 &size) {
        view.elements(size, Whole{1.0, double(kMostDrawnPixels)});
    });
    json.optional("place", step.workspace, Words{kWorkspaceNames});
    json.list("panels", step.panels, kPanelNames.size(), Words{kPanelNames});
    std::vector<Highlight> highlights;
    json.list("highlights", highlights, kHighlightNames.size(), Words{kHighlightNames});
    step.highlights = {highlights.begin(), highlights.end()};
    json.optionalObject("set", [&step](SceneReader &changes) {
        changes.requireObject();
        for (const auto &[name, change] : changes.json().items())
            step.changes[name] = base::JsonValue(change);
    });
    json.optionalObject("points", [&step](SceneReader &points) {
        points.requireObject();
        for (const auto &[name, point] : points.json().items()) {
            SceneReader one(points, name);
            step.points[name] = readPoint(one);
        }
    });
    json.optionalObject("question", [&](SceneReader &question) {
        Question &asked = step.question.emplace();
        readStrictly(question, [&](SceneReader &fields) {
            describeTexts(fields, asked);
            fields.required("answer", asked.answer);
            fields.required("tolerance", asked.tolerance);
            fields.list("hides", asked.hides, kPanelNames.size(), Words{kPanelNames});
        });
        for (const Panel panel : panelsWithAnswer(asked.answer, clickedPoints(step, earlier))) {
            if (std::find(asked.hides.begin(), asked.hides.end(), panel) == asked.hides.end())
                asked.hides.push_back(panel);
        }
    });
}

/// Reads each of the "steps", which must be there.
/// @return their number
template <class Describe>
std::size_t readSteps(SceneReader &json, const Describe &description)
{
    static_cast<void>(json.has("steps"));
    const JsonNode steps(json, "steps");
    for (std::size_t i = 0; i < steps.size(); ++i) {
        SceneReader step(steps, i);
        readStrictly(step, description);
    }
    return steps.size();
}

/// Replaces the texts of the lesson by a translation's.
base::Done readTexts(std::string_view texts, Lesson &lesson)
{
    return read(lesson.name + ", translated", texts, [&lesson](SceneReader &root) {
        root.optional("title", lesson.title);
        readSteps(root, [&lesson](SceneReader &json) {
            std::string id;
            json.optional("id", id);
            const auto step =
                std::find_if(lesson.steps.begin(), lesson.steps.end(), [&id](const Step &one) { return one.id == id; });
            if (step == lesson.steps.end())
                json.fail("the lesson has no step \"" + id + "\"");
            describeTexts(json, *step);
            json.optionalObject("question", [&step](SceneReader &question) {
                if (!step->question)
                    question.fail("the lesson asks nothing here");
                readStrictly(question, [&step](SceneReader &fields) { describeTexts(fields, *step->question); });
            });
        });
    });
}

} // namespace

const Step *Lesson::step(std::string_view id) const
{
    const auto found = std::find_if(steps.begin(), steps.end(), [id](const Step &one) { return one.id == id; });
    return found == steps.end() ? nullptr : &*found;
}

base::Expected<Lesson, base::Error> parseLesson(std::string_view name, std::string_view json,
                                                const std::optional<std::string_view> &texts)
{
    Lesson lesson{std::string(name), {}, {}};
    base::Done done = read(lesson.name + ".json", json, [&lesson](SceneReader &root) {
        root.required("title", lesson.title);
        std::set<std::string> ids;
        const std::size_t count = readSteps(root, [&](SceneReader &node) {
            Step step;
            describeStep(node, lesson.steps, step);
            if (!ids.insert(step.id).second)
                node.fail("a step before has the id \"" + step.id + "\" already");
            lesson.steps.push_back(std::move(step));
        });
        if (count == 0)
            root.fail("must have \"steps\"");
    });
    if (done && texts)
        done = readTexts(*texts, lesson);
    if (!done)
        return done.error();
    return lesson;
}

std::string shownText(std::string_view text)
{
    std::string shown;
    for (;;) {
        const std::size_t open = text.find('{');
        shown += text.substr(0, open);
        const std::size_t close = text.find('}', open);
        if (close == std::string_view::npos)
            return shown;
        const std::string_view statement = text.substr(open + 1, close - open - 1);
        shown += statement.substr(0, statement.rfind(" = "));
        text.remove_prefix(close + 1);
    }
}

void addClicked(const std::vector<std::string> &paragraphs, std::set<std::string> &names)
{
    constexpr std::string_view kLink = "'click:";
    for (const std::string &paragraph : paragraphs) {
        for (auto at = paragraph.find(kLink); at != std::string::npos; at = paragraph.find(kLink, at + 1)) {
            const std::size_t from = at + kLink.size();
            names.insert(paragraph.substr(from, paragraph.find('\'', from) - from));
        }
    }
}

base::Expected<std::vector<std::string>, base::Error> parseLessonNames(std::string_view json)
{
    std::vector<std::string> names;
    const base::Done done =
        read("lessons.json", json, [&names](SceneReader &fields) { fields.optional("lessons", names); });
    if (!done)
        return done.error();
    return names;
}

} // namespace unprojector::lessons
