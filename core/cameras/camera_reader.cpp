#include "core/cameras/camera_reader.h"

#include "core/base/byte_order.h"
#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/program_text.h"
#include "core/geometry/finite.h"

#include <nlohmann/json.hpp>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::cameras {
using base::tr;

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

using CameraRead = std::optional<base::Expected<ForeignCamera, base::Error>>;

/// All forms. The first that recognises the texts reads them: the most particular one is first.
const std::vector<Form> &forms()
{
    static const std::vector<Form> all = [] {
        std::vector<Form> list;
        const auto add = [&list](std::span<const Form> some, Format format = Format::Print) {
            for (const Form &form : some)
                list.emplace_back(form).format = format;
        };
        add(colmapForms());
        add(xmlForms(), Format::Xml);
        add(fileForms());
        add(jsonForms(), Format::Json);
        add(sceneForms());
        add(printForms());
        add(lookAtForms());
        list.push_back({.program = "DSO", .readAll = readTables});
        list.push_back({.program = "OpenCV", .readAll = readNamedParts});
        return list;
    }();
    return all;
}

void readParts(Reading &reading, const Form &form)
{
    const Parts &parts = form.parts;
    const Found &one = reading;
    if (!one.lens)
        failWithoutLens(reading);
    if ((*parts.pose || parts.count == 7) && one.pose)
        reading.setPose(one.pose, parts.pose, parts.count, parts.at, parts.isByColumns);
    if (reading.camera.pose)
        reading.camera.pose = one.parent * *reading.camera.pose;
    if (*parts.centre && one.pose)
        reading.camera.center = one.pose.vector(parts.centre);
    if (*parts.size)
        reading.setSize(one.lens, parts.size);
    else if (form.format == Format::Print)
        reading.camera.size = sizeIn(one.lens);
    if (*parts.planes)
        reading.setPlanes(one.lens, parts.planes);
    if (*parts.lens)
        reading.setLens(one.lens, parts.lens, parts.centres);
    if (*parts.distortion && one.lens.has(parts.distortion))
        setDistortion(reading, one.lens.numbers(parts.distortion));
    if (form.quirk)
        form.quirk(reading);
    if (*parts.note)
        reading.say(tr(parts.note));
    if (const std::string names = one.pose.unused(); !names.empty())
        reading.say(tr("Not used: %1.", names));
}

/// Reads the camera of a text; returns false if the text has another form.
bool readForm(Reading &reading, const Form &form)
{
    base::Json document;
    reading.used.clear();
    if (!openDocument(reading, form, document))
        return false;
    const Cameras found =
        form.cameras ? form.cameras(reading, reading.file) : listed(form.parts, form.format, reading.file);
    if (found.empty() && !*form.parts.having && reading.file.has(form.parts.list) && *form.parts.list)
        reading.fail(tr("there are no cameras"));
    if (found.empty())
        return false;
    std::vector<std::string> ids;
    for (const Found &one : found) {
        if (!one.name.empty() || found.size() > 1)
            reading.camera.images.push_back(one.name);
        ids.push_back(one.id);
    }
    reading.begin(form.program, form.frame);
    reading.chooseImage(ids);
    static_cast<Found &>(reading) = found[reading.camera.image];
    readParts(reading, form);
    return true;
}

/// The form that recognises the texts, with what it reads.
std::pair<const Form *, CameraRead> firstRead(std::span<const NamedText> texts, const CameraChoices &choices)
{
    std::vector<Reading> readings;
    for (const NamedText &text : texts)
        readings.emplace_back(text, choices).all = texts;
    for (const Form &form : forms()) {
        try {
            if (form.readAll) {
                if (auto camera = form.readAll(texts, choices))
                    return {&form, std::move(*camera)};
                continue;
            }
            for (Reading &reading : readings) {
                if (readForm(reading, form)) {
                    reading.camera.files.push_back(reading.text.name);
                    return {&form, std::move(reading.camera)};
                }
                reading.camera = {};
            }
        } catch (base::Error &error) {
            return {&form, std::move(error)};
        }
    }
    return {nullptr, std::nullopt};
}

/// The error of files of several programs, of which all but one would be ignored.
std::optional<base::Error> mixedError(std::span<const NamedText> texts, const CameraChoices &choices, const Form *form)
{
    std::string list;
    bool hasSame = false, hasOther = false;
    for (const NamedText &text : texts) {
        const Form *alone = firstRead({&text, 1}, choices).first;
        const bool isSame = alone && std::string_view(alone->program) == form->program;
        hasSame = hasSame || isSame;
        hasOther = hasOther || (alone && !isSame);
        if (alone)
            list += (list.empty() ? "" : ", ") + text.name + " (" + alone->program + ')';
    }
    if (!hasSame || !hasOther)
        return std::nullopt;
    return base::Error{.text = tr("the files are of several programs: %1. Give those of one program", list),
                       .file = texts.front().name};
}

/// The error of a camera with numbers that no camera has.
std::optional<std::string> reasonAgainst(const ForeignCamera &camera, const CameraChoices &choices)
{
    if ((camera.pose && !geometry::isFinite(*camera.pose))
        || (camera.projection && !geometry::isFinite(camera.projection->clipFromEye)))
        return tr("a number is not finite");
    if (!camera.intrinsics)
        return std::nullopt;
    const Intrinsics &k = *camera.intrinsics;
    if (!std::isfinite(k.fx + k.fy + k.cx + k.cy + k.skew))
        return tr("a number is not finite");
    for (const auto &[name, value] : {std::pair("fx", k.fx), std::pair("fy", k.fy)}) {
        if (value < 0.0)
            return tr("the focal length %1 is %2; it must be greater than 0", name, base::shortestText(value));
    }
    const std::optional<ImageSize> size = choices.size ? choices.size : camera.size;
    constexpr double kLargest = 20.0; // in image widths; an angle of 3 degrees
    const bool isNormalized = k.cx > 0.0 && k.cx < 1.0 && k.cy > 0.0 && k.cy < 1.0
                              && ((k.fx < kLargest && k.fy < kLargest) || !k.isCentreComputed);
    if (isNormalized && !(size && size->width <= 2 && size->height <= 2))
        return tr("fx %1, fy %2, cx %3, cy %4 are no pixels; they look normalized. Multiply fx and cx by the image's "
                  "width, fy and cy by its height",
                  base::shortestText(k.fx), base::shortestText(k.fy), base::shortestText(k.cx),
                  base::shortestText(k.cy));
    return std::nullopt;
}

/// The JSON of a text, without comments: the first chunk of a .glb; an object around what people paste of its middle.
std::string jsonIn(const std::string &text, bool mayBePart)
{
    constexpr std::size_t kHeader = 20; // magic, version, length; the chunk's length and type
    if (text.starts_with("glTF") && text.size() >= kHeader)
        return text.substr(kHeader, base::numberAt<std::uint32_t>(reinterpret_cast<const std::uint8_t *>(&text[12])));
    std::string all = withoutComments(text);
    const std::string_view part = base::trimmed(all);
    if (mayBePart && part.starts_with('"'))
        return '{' + std::string(part.substr(0, part.find_last_not_of(',') + 1)) + '}';
    return all;
}

} // namespace

bool openDocument(Reading &reading, const Form &form, base::Json &document)
{
    const std::string &text = reading.text.text;
    const bool areKeys = form.format == Format::Json;
    for (const std::string_view mark : split(form.marks, ' ')) {
        const Words any = split(mark, '|');
        if (std::none_of(any.begin(), any.end(), [&](std::string_view one) {
                return text.find(areKeys ? '"' + std::string(one) + '"' : std::string(one)) != text.npos;
            }))
            return false;
    }
    if (form.format == Format::Print) {
        reading.file = Node(reading, reading.values(), text);
        return true;
    }
    reading.json = areKeys ? jsonIn(text, form.parts.mayBePart) : std::string();
    if (areKeys ? isJson(reading.json) : isXml(text)) {
        try {
            document = areKeys ? parsedJson({reading.text.name, reading.json}) : parsedXml(reading.text);
        } catch (const base::Error &) {
            if (!form.parts.isLax)
                throw;
        }
    }
    reading.file = Node(reading, document);
    return bool(reading.file);
}

Cameras onlyIf(bool isIt, const Node &text)
{
    return isIt ? std::vector{Found{{}, {}, text, text}} : Cameras();
}

Cameras sections(const Reading &reading, const Node &text, std::string_view mark, std::string_view end,
                 std::string_view word)
{
    Cameras found;
    const std::string_view all = reading.text.text;
    for (std::size_t at = all.find(mark); at != all.npos; at = all.find(mark, at + 1)) {
        const std::string_view part = all.substr(at, all.find(end, at + mark.size()) - at);
        if (part.find(word) == part.npos)
            continue;
        const Words quoted = split(split(part, '\n')[0], '"');
        const std::string name(quoted.size() > 1 ? quoted[1] : "");
        const Node node(reading, std::make_shared<NamedValues>(part), part);
        found.push_back({name.empty() ? std::to_string(found.size()) : name, {}, node, node});
    }
    return found.empty() ? onlyIf(true, text) : found;
}

Cameras listed(const Parts &parts, Format format, const Node &text)
{
    if (!*parts.list) {
        const Words all = split(parts.having, ' ');
        return onlyIf(!*parts.having || std::all_of(all.begin(), all.end(), [&](Keys keys) { return text.has(keys); }),
                      text);
    }
    Cameras found;
    for (const std::string_view path : split(parts.list, '|')) {
        std::vector<Trail> trails = format == Format::Xml ? trailsTo(text, path) : std::vector<Trail>();
        const Node value = path == "*" ? text : text[path];
        for (const Node &one : format == Format::Json && value ? value.elements() : Trail())
            trails.push_back({one});
        for (const Trail &trail : trails) {
            const Node &one = trail.back();
            const auto named =
                std::find_if(trail.rbegin(), trail.rend(), [&](const Node &node) { return node.has(parts.name); });
            const bool isItem = format == Format::Xml ? *parts.name : value.json().is_array();
            if (one.holds(parts.having))
                found.push_back({named != trail.rend() ? named->word(parts.name)
                                 : isItem              ? std::to_string(found.size())
                                                       : "",
                                 one.word(parts.id),
                                 one,
                                 one,
                                 {},
                                 glm::dmat4(1.0),
                                 trail});
        }
        if (!found.empty())
            break;
    }
    return found;
}

std::optional<base::Expected<ForeignCamera, base::Error>> readCamera(std::span<const NamedText> given,
                                                                     const CameraChoices &choices)
{
    if (given.empty())
        return std::nullopt;
    std::vector<NamedText> prepared(given.begin(), given.end());
    for (NamedText &text : prepared) {
        text.text.erase(0, text.text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
        text.text = withValues(std::move(text.text));
    }
    const std::span<const NamedText> texts = prepared;
    for (const NamedText &text : texts) {
        constexpr std::size_t kBeginning = 200;
        if (text.text.starts_with('{')
            && std::string_view(text.text).substr(0, kBeginning).find("\"unprojector\"") != text.text.npos)
            return base::Error{.text = tr("this is a scene of Unprojector, not another program's camera; open it as a "
                                          "scene"),
                               .file = text.name};
    }
    auto [form, read] = firstRead(texts, choices);
    if (!read)
        return std::nullopt;
    if (texts.size() > 1) {
        if (auto error = mixedError(texts, choices, form))
            return *error;
    }
    if (!*read)
        return std::move(read);
    ForeignCamera camera = **read;
    for (const NamedText &text : texts.size() > 1 ? texts : std::span<const NamedText>()) {
        if (std::find(camera.files.begin(), camera.files.end(), text.name) == camera.files.end())
            return base::Error{.text = tr("nothing in it is read; leave it out, or give its numbers the names of a "
                                          "camera's parts"),
                               .file = text.name};
    }
    if (auto reason = reasonAgainst(camera, choices))
        return base::Error{.text = std::move(*reason), .file = texts.size() == 1 ? texts.front().name : std::string()};
    for (std::optional<double> *distance : {&camera.nearDistance, &camera.farDistance}) {
        if (*distance && !std::isfinite(**distance))
            distance->reset(); // "far: inf", as if it were missing
    }
    return camera;
}

} // namespace unprojector::cameras
