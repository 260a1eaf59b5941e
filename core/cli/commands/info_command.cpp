#include "core/base/csv.h"
#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/commands/inputs.h"
#include "core/cli/rows/byte_stream.h"
#include "core/cli/terminal/refusal.h"
#include "core/report/report.h"
#include "core/scene/measures.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <unordered_set>
#include <vector>

namespace unprojector::cli {
using namespace mesh;
using namespace scene;
using namespace base;
namespace {

struct InfoOptions {
    std::string file; ///< a model, a scene or clicks; "-" is a scene from stdin
    bool isJson = false;
};

/// A number as JSON, which has no infinity.
std::string jsonOfNumber(double value)
{
    return std::isfinite(value) ? shortestText(value) : "null";
}

std::string tableText(double value, double halfGap = 0.0)
{
    return std::isfinite(value) ? shortestText(value, halfGap) : tr("missing|number");
}

/// The coordinates in the fewest digits that identify the same floats; mostly the digits of the
/// file.
std::string tableText(const glm::dvec3 &v, const glm::dvec3 &halfGap)
{
    return tableText(v.x, halfGap.x) + ' ' + tableText(v.y, halfGap.y) + ' ' + tableText(v.z, halfGap.z);
}

std::string jsonOfPoint(const glm::dvec3 &point)
{
    return '[' + jsonOfNumber(point.x) + ", " + jsonOfNumber(point.y) + ", " + jsonOfNumber(point.z) + ']';
}

/// The members that a scene and an object share, without brackets.
std::string json(const Measures &m)
{
    std::string text =
        "\"vertices\": " + std::to_string(m.vertices) + ", \"triangles\": " + std::to_string(m.triangles);
    text += ", \"area\": " + jsonOfNumber(m.area) + ", \"volume\": " + jsonOfNumber(m.volume) + ", \"box\": ";
    if (m.box.isEmpty())
        return text + "null";
    return text + "{\"min\": " + jsonOfPoint(m.box.lowest) + ", \"max\": " + jsonOfPoint(m.box.highest) + '}';
}

report::Section section(const std::string &title, const Measures &m)
{
    report::Rows rows{11};
    rows.add(tr("vertices|row"), std::to_string(m.vertices));
    rows.add(tr("triangles|row"), std::to_string(m.triangles));
    rows.add(tr("area|row"), tableText(m.area));
    rows.add(tr("volume|row"), tableText(m.volume));
    rows.add(tr("box|row"), m.box.isEmpty() ? tr("empty|box")
                                            : tr("%1  to  %2", tableText(m.box.lowest, m.lowestHalfGap),
                                                 tableText(m.box.highest, m.highestHalfGap)));
    return {title, {rows}};
}

/// The distinct notes in the order of the objects, with the object's name if there are several
/// objects.
std::vector<std::string> notesOf(const std::vector<SceneObject> &objects)
{
    std::vector<std::string> notes;
    std::unordered_set<std::string> known;
    for (const SceneObject &object : objects) {
        for (const Note &note : object.model->notes) {
            const std::string text = (objects.size() > 1 ? object.name + ": " : std::string()) + note.text();
            if (known.insert(text).second)
                notes.push_back(text);
        }
    }
    return notes;
}

bool isFinite(const Measures &m)
{
    const auto isFinitePoint = [](const glm::dvec3 &p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    };
    return std::isfinite(m.area) && std::isfinite(m.volume)
           && (m.box.isEmpty() || (isFinitePoint(m.box.lowest) && isFinitePoint(m.box.highest)));
}

ExitCode runInfo(const InfoOptions &options)
{
    const OpenedScene opened = openScene(options.file);
    // JSON is in English, because programs read the notes too.
    std::optional<InEnglish> english;
    if (options.isJson)
        english.emplace();
    Measures all;
    std::string objects;
    report::Report report;
    std::vector<std::string> openOnes;
    for (const SceneObject &object : opened.objects) {
        const Measures measures = measuresOf(object);
        all.add(measures);
        if (measures.isOpen)
            openOnes.push_back((opened.objects.size() > 1 ? object.name + ": " : std::string())
                               + tr("the surface is open, so the volume is undefined: it depends on the origin"));
        objects += objects.empty() ? "" : ", ";
        objects += "{\"name\": " + jsonText(object.name) + ", " + json(measures) + '}';
        report.push_back(section(object.isHidden ? tr("%1 (hidden)", object.name) : object.name, measures));
    }
    std::vector<std::string> notes = notesOf(opened.objects);
    notes.insert(notes.end(), openOnes.begin(), openOnes.end());
    if (!isFinite(all))
        notes.push_back(tr("missing numbers are beyond the range of a double; check the scales of the objects"));
    ByteSink sink("-", opened.files);
    if (options.isJson) {
        sink.write('{' + json(all) + ", \"objects\": [" + objects + "], \"notes\": " + jsonLine(notes) + "}\n");
    } else {
        if (opened.objects.size() != 1)
            report.insert(report.begin(), section(tr("all|objects"), all));
        for (const std::string &note : notes)
            report.back().blocks.push_back(report::Note{note});
        sink.print(asText(report));
    }
    return sink.finish();
}

} // namespace

void addInfo(const Command &command)
{
    const auto options = std::make_shared<InfoOptions>();
    command.modelOrScene(options->file);
    command.flag("--json", options->isJson);
    command.runs(options, runInfo);
}

} // namespace unprojector::cli
