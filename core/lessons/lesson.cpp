#include "core/lessons/lesson.h"

#include "core/examples/examples.h"
#include "core/geometry/drawable.h"
#include "core/lessons/highlights.h"
#include "core/lessons/set_link.h"
#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/scene_fields.h"
#include "core/scene_file/strict_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace unprojector::lessons {
using namespace geometry;

namespace {

using Json = nlohmann::ordered_json;
using namespace scene_file;

/// Names that paths use already.
constexpr std::array kTaken{"scene",  "model", "view",    "projection", "viewport", "modelview", "whole",
                            "object", "world", "eye",     "clip",       "ndc",      "window",    "device",
                            "widget", "pixel", "formula", "inverse",    "point",    "surface",   "set",
                            "pi",     "sqrt",  "deg",     "rad"};

LessonError failed(std::string_view file, const std::string &key, const std::string &reason)
{
    return {std::string(file) + ": " + key + ": " + reason};
}

bool isName(std::string_view name)
{
    const auto isPart = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && name.front() >= 'a' && std::all_of(name.begin(), name.end(), isPart);
}

/// Reads a lesson; keeps the first error.
class LessonReader {
public:
    explicit LessonReader(std::string file) : m_file(std::move(file)) {}

    Result<Json, LessonError> document(std::string_view text) const
    {
        Result<Json, SceneFileError> json = parseStrictJson(text);
        if (json)
            return std::move(json).value();
        SceneFileError error = json.error();
        error.file = m_file;
        return LessonError{sceneErrorText(error)};
    }

    /// Runs a description on an object; keys that it does not name are an error.
    template <class Describe>
    void object(const JsonNode &node, const Describe &describe)
    {
        int nothing = 0;
        const Json unknown = FieldReader::read(node, nothing, [&](FieldReader &fields, int &) { describe(fields); });
        if (!unknown.empty())
            fail(node, "there is no key \"" + unknown.begin().key() + "\"");
    }

    /// Records an error.
    /// @param reason  a sentence; only the first one is kept
    void fail(const JsonNode &node, const std::string &reason)
    {
        if (!m_error && !m_jsonError)
            m_error = failed(m_file, node.path(), reason);
    }

    std::optional<LessonError> error() const
    {
        if (m_error)
            return m_error;
        if (!m_jsonError)
            return std::nullopt;
        SceneFileError error = *m_jsonError;
        error.file = m_file;
        return LessonError{sceneErrorText(error)};
    }
    bool hasFailed() const { return m_error || m_jsonError; }
    JsonNode::FirstError &jsonError() { return m_jsonError; }

private:
    std::string m_file;
    std::optional<LessonError> m_error;
    JsonNode::FirstError m_jsonError;
};

/// The members that a translation has as well.
void describeTexts(FieldReader &json, Question &question)
{
    json.optional("text", question.text);
    json.list("reveal", question.reveal);
}

void describeTexts(FieldReader &json, Step &step)
{
    json.required("id", step.id);
    json.optional("title", step.title);
    json.list("text", step.text);
    json.optional("source", step.source);
}

StepPoint readPoint(LessonReader &reader, const JsonNode &node)
{
    StepPoint point;
    if (node.isObject() && node.json().contains("pixel"))
        reader.object(node, [&](FieldReader &json) {
            static constexpr std::array kSnaps{"surface", "vertex", "edge", "face"};
            auto &clicked = point.emplace<ClickedPixel>();
            json.required("pixel", clicked.pixel);
            if (json.has("snap", true))
                json.required("snap", clicked.snap, Words{kSnaps});
        });
    else
        reader.object(node, [&](FieldReader &json) { describe(json, point.emplace<GivenPoint>()); });
    return point;
}

/// @param document  of the previous step, null for the first
void readScene(LessonReader &reader, const JsonNode &node, Json &document)
{
    const JsonNode whole = node.member("scene"), change = node.member("change");
    if (whole.exists() && change.exists())
        reader.fail(node, "has a \"scene\" and a \"change\"; there may be one of both");
    else if (whole.exists() && whole.json().is_string()) {
        if (const std::string_view example = examples::exampleScene(whole.text()); !example.empty())
            document = Json::parse(example);
        else
            reader.fail(whole, "the program brings along no scene \"" + whole.text() + "\"");
    } else if (whole.exists())
        document = whole.json();
    else if (document.is_null())
        reader.fail(node, "the first step must have a \"scene\"");
    else if (change.exists())
        document.merge_patch(change.json());
}

/// The names in quotes, with commas.
template <class Names>
std::string listed(const Names &names)
{
    std::string text;
    for (const std::string_view name : names)
        text += (text.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    return text;
}

/// Checks that each link of the texts has a target.
void checkLinks(LessonReader &reader, const JsonNode &node, const std::vector<std::string> &paragraphs)
{
    constexpr std::string_view kStart = "<a href='";
    for (const std::string &paragraph : paragraphs) {
        for (auto at = paragraph.find(kStart); at != std::string::npos; at = paragraph.find(kStart, at + 1)) {
            const std::size_t from = at + kStart.size();
            const std::string link = paragraph.substr(from, paragraph.find('\'', from) - from);
            if (!parseLink(link))
                reader.fail(node, "the link \"" + link + "\" leads nowhere");
        }
    }
}

void readChanges(LessonReader &reader, const JsonNode &node, FieldReader &json, Step &step)
{
    static_cast<void>(json.has("set", true));
    const JsonNode changes = node.member("set");
    if (!changes.exists() || !changes.isObject())
        return;
    for (const auto &[name, change] : changes.json().items()) {
        const JsonNode one = changes.member(name.c_str());
        if (!isName(name))
            reader.fail(changes,
                        "\"" + name + "\" is no name; take one of small letters, digits and _, a letter first");
        if (!one.isObject())
            return;
        for (const auto &[key, value] : change.items()) {
            if (std::find(kSettableKeys.begin(), kSettableKeys.end(), key) == kSettableKeys.end())
                reader.fail(one, "a link cannot change \"" + key + "\", only " + listed(kSettableKeys));
        }
        step.changes[name] = base::JsonValue(change);
    }
}

/// The points that a click can read: pixels, and points that links of the texts click, in this step
/// and the previous ones.
std::set<std::string> clickedPoints(const Step &step, const std::vector<Step> &before)
{
    constexpr std::string_view kLink = "'click:";
    std::set<std::string> clicked;
    for (const auto &[name, point] : step.points) {
        if (std::holds_alternative<ClickedPixel>(point))
            clicked.insert(name);
    }
    const auto look = [&](const std::vector<std::string> &paragraphs) {
        for (const std::string &paragraph : paragraphs) {
            for (auto at = paragraph.find(kLink); at != std::string::npos; at = paragraph.find(kLink, at + 1)) {
                const std::size_t from = at + kLink.size();
                clicked.insert(paragraph.substr(from, paragraph.find('\'', from) - from));
            }
        }
    };
    look(step.text);
    for (const Step &one : before) { // a click stays as long as the scene does
        if (one.scene != step.scene)
            continue;
        look(one.text);
        if (one.question)
            look(one.question->reveal);
    }
    return clicked;
}

/// @param earlier  the steps read before
void readStep(LessonReader &reader, const JsonNode &node, const std::vector<Step> &earlier, Step &step)
{
    const Step *before = earlier.empty() ? nullptr : &earlier.back();
    reader.object(node, [&](FieldReader &json) {
        describeTexts(json, step);
        if (const bool hasScene = json.has("scene", true); before && !hasScene) {
            step.scene = before->scene;
            step.view = before->view;
            step.workspace = before->workspace;
            step.points = before->points;
            step.changes = before->changes;
        }
        static_cast<void>(json.has("change", true));
        readScene(reader, node, step.scene.edit());
        if (json.has("view", true)) {
            glm::dvec2 size{0.0};
            json.required("view", size);
            const auto isSide = [](double side) {
                return side >= 1.0 && side <= kMostDrawnPixels && side == std::floor(side);
            };
            if (isSide(size.x) && isSide(size.y))
                step.view = glm::ivec2(size);
            else
                reader.fail(node, "\"view\" must be two whole numbers from 1 to " + std::to_string(kMostDrawnPixels));
        }
        if (json.has("place", true))
            json.required("place", step.workspace.emplace(), Words{kWorkspaceNames});
        json.list("panels", step.panels, kPanelNames.size(), Words{kPanelNames});
        std::vector<Highlight> highlights;
        json.list("highlights", highlights, kHighlightNames.size(), Words{kHighlightNames});
        step.highlights = {highlights.begin(), highlights.end()};
        readChanges(reader, node, json, step);
        static_cast<void>(json.has("points", true));
        if (const JsonNode points = node.member("points"); points.exists() && points.isObject()) {
            for (const auto &[name, point] : points.json().items()) {
                if (!isName(name) || std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end())
                    reader.fail(
                        points,
                        "\"" + name
                            + "\" is no free name; take others, of small letters, digits and _, a letter first");
                step.points[name] = readPoint(reader, points.member(name.c_str()));
            }
        }
        static_cast<void>(json.has("question", true));
        if (const JsonNode question = node.member("question"); question.exists()) {
            Question &asked = step.question.emplace();
            reader.object(question, [&](FieldReader &fields) {
                describeTexts(fields, asked);
                fields.required("answer", asked.answer);
                fields.required("tolerance", asked.tolerance);
                fields.list("hides", asked.hides, kPanelNames.size(), Words{kPanelNames});
            });
            for (const Panel panel : panelsWithAnswer(asked.answer, clickedPoints(step, earlier))) {
                if (std::find(asked.hides.begin(), asked.hides.end(), panel) == asked.hides.end())
                    asked.hides.push_back(panel);
            }
            checkLinks(reader, question, asked.reveal);
            if (!(asked.tolerance > 0.0))
                reader.fail(question, "\"tolerance\" must be greater than 0");
        }
    });
    checkLinks(reader, node, step.text);
    if (!isName(step.id))
        reader.fail(node, "\"id\" must be of small letters, digits and _, a letter first");
    if (step.title.empty() || step.text.empty())
        reader.fail(node, "must have a \"title\" and a \"text\"");
}

/// Replaces the texts of the lesson by a translation's.
void readTexts(LessonReader &reader, const JsonNode &root, Lesson &lesson)
{
    reader.object(root, [&](FieldReader &json) {
        json.optional("title", lesson.title);
        static_cast<void>(json.has("steps", true));
    });
    const JsonNode steps = root.member("steps");
    for (std::size_t i = 0; !reader.hasFailed() && i < steps.size(); ++i) {
        const JsonNode node = steps.element(i);
        const JsonNode id = node.member("id");
        const std::string named = node.isObject() && id.exists() ? id.text() : std::string();
        const auto step = std::find_if(lesson.steps.begin(), lesson.steps.end(),
                                       [&named](const Step &one) { return one.id == named; });
        if (step == lesson.steps.end()) {
            reader.fail(node, "the lesson has no step \"" + named + "\"");
            return;
        }
        reader.object(node, [&](FieldReader &json) {
            describeTexts(json, *step);
            static_cast<void>(json.has("question", true));
            const JsonNode question = node.member("question");
            if (!question.exists())
                return;
            if (step->question)
                reader.object(question, [&](FieldReader &fields) { describeTexts(fields, *step->question); });
            else
                reader.fail(question, "the lesson asks nothing here");
        });
    }
}

} // namespace

const Step *Lesson::step(std::string_view id) const
{
    const auto found = std::find_if(steps.begin(), steps.end(), [id](const Step &one) { return one.id == id; });
    return found == steps.end() ? nullptr : &*found;
}

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
    if (isOneOf(kPixelSpaces, head) && answer.ends_with(".z"))
        return {Panel::Pipeline, Panel::Comparison, Panel::Precision, Panel::Lifecycle};
    if (isOneOf(kPixelSpaces, head))
        return {Panel::Pipeline, Panel::Comparison, Panel::Inspector, Panel::Lifecycle};
    if (isOneOf(kSpaces, head))
        return {Panel::Pipeline, Panel::Comparison};
    if (isOneOf(kMatrices, head))
        return {Panel::Pipeline};
    return {};
}

Result<Lesson, LessonError> parseLesson(std::string_view name, std::string_view json,
                                        const std::optional<std::string_view> &texts)
{
    Lesson lesson{std::string(name), {}, {}};
    LessonReader reader(lesson.name + ".json");
    const Result<Json, LessonError> document = reader.document(json);
    if (!document)
        return document.error();
    const JsonNode root(*document, reader.jsonError());
    reader.object(root, [&](FieldReader &fields) {
        fields.required("title", lesson.title);
        static_cast<void>(fields.has("steps", true));
    });
    const JsonNode steps = root.member("steps");
    std::set<std::string> ids;
    for (std::size_t i = 0; !reader.hasFailed() && i < steps.size(); ++i) {
        const JsonNode node = steps.element(i);
        Step step;
        readStep(reader, node, lesson.steps, step);
        if (!ids.insert(step.id).second)
            reader.fail(node, "a step before has the id \"" + step.id + "\" already");
        lesson.steps.push_back(std::move(step));
    }
    if (lesson.steps.empty() && !reader.hasFailed())
        reader.fail(root, "must have \"steps\"");
    if (reader.hasFailed())
        return *reader.error();
    if (!texts)
        return lesson;
    LessonReader translation(lesson.name + ", translated");
    const Result<Json, LessonError> translated = translation.document(*texts);
    if (!translated)
        return translated.error();
    readTexts(translation, JsonNode(*translated, translation.jsonError()), lesson);
    if (translation.hasFailed())
        return *translation.error();
    return lesson;
}

Result<std::vector<std::string>, LessonError> untranslated(const Lesson &lesson, std::string_view texts)
{
    // Apply the translation to a lesson without texts; texts that are still empty have no
    // translation.
    Lesson silent = lesson;
    silent.title.clear();
    for (Step &step : silent.steps) {
        step.title.clear();
        step.text.clear();
        step.source.clear();
        if (step.question) {
            step.question->text.clear();
            step.question->reveal.clear();
        }
    }
    LessonReader reader(lesson.name + ", translated");
    const Result<Json, LessonError> document = reader.document(texts);
    if (!document)
        return document.error();
    readTexts(reader, JsonNode(*document, reader.jsonError()), silent);
    if (reader.hasFailed())
        return *reader.error();
    std::vector<std::string> missing;
    const auto look = [&missing](const auto &wanted, const auto &there, const std::string &key) {
        if (wanted.empty() != there.empty())
            missing.push_back(key);
    };
    look(lesson.title, silent.title, "title");
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const Step &wanted = lesson.steps[i], &there = silent.steps[i];
        look(wanted.title, there.title, wanted.id + ".title");
        look(wanted.text, there.text, wanted.id + ".text");
        look(wanted.source, there.source, wanted.id + ".source");
        if (!wanted.question)
            continue;
        look(wanted.question->text, there.question->text, wanted.id + ".question.text");
        look(wanted.question->reveal, there.question->reveal, wanted.id + ".question.reveal");
    }
    return missing;
}

Result<std::vector<std::string>, LessonError> parseLessonNames(std::string_view json)
{
    LessonReader reader("lessons.json");
    const Result<Json, LessonError> document = reader.document(json);
    if (!document)
        return document.error();
    std::vector<std::string> names;
    reader.object(JsonNode(*document, reader.jsonError()), [&](FieldReader &fields) { fields.list("lessons", names); });
    if (reader.hasFailed())
        return *reader.error();
    return names;
}

} // namespace unprojector::lessons
