// .pp of MeshLab, points picked on a mesh, and .pptpl, their names alone. XML.

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using base::tr;
namespace {

using Json = nlohmann::ordered_json;
using Tree = boost::property_tree::ptree;

constexpr const char *kDocumentData = "DocumentData";
constexpr const char *kFileName = "DataFileName";
constexpr const char *kTemplateName = "templateName";

// ---- reading ------------------------------------------------------------------------------------

/// Data that the XML library does not provide: the lines on which points begin, and where the text
/// can be cut into pieces. It also limits the nesting of elements, because the library recurses for
/// each level.
class Outline {
public:
    /// The start of a piece, and its line, counted from 1.
    struct Cut {
        std::size_t offset = 0, line = 1;
    };

    explicit Outline(std::string_view text)
    {
        std::size_t level = 0;
        for (std::size_t i = text.find('<'); i < text.size(); i = text.find('<', i)) {
            advanceTo(text, i);
            const std::string_view rest = text.substr(i);
            if (rest.starts_with("<!--")) {
                i = behind(text, i, "-->");
            } else if (rest.starts_with("<![CDATA[")) {
                i = behind(text, i, "]]>");
            } else if (rest.starts_with("<?")) {
                i = behind(text, i, "?>");
            } else if (rest.starts_with("<!")) {
                i = behind(text, i, ">");
            } else if (rest.starts_with("</")) {
                if (level > 0)
                    --level;
                i = behind(text, i, ">");
            } else {
                const std::size_t end = tagEnd(text, i);
                const std::string_view tag = text.substr(i + 1, end - i - 1);
                if (tag.substr(0, tag.find_first_of(" \t\r\n/")) == "point") {
                    if (level == 1 && m_points.size() % kPointsOfPiece == 0 && !m_points.empty())
                        m_cuts.push_back({i, m_line});
                    m_points.push_back(m_line);
                }
                if (!tag.ends_with('/'))
                    ++level;
                if (level > kMostLevels)
                    fail(m_line,
                         tr("elements are nested deeper than %1 levels; a file of picked points has two", kMostLevels));
                i = end;
            }
        }
    }

    /// The line of a point, whose index counts from 0; 0 if unknown.
    std::size_t lineOf(std::size_t point) const { return point < m_points.size() ? m_points[point] : 0; }
    /// Positions between two children of the root, ascending.
    const std::vector<Cut> &cuts() const { return m_cuts; }

private:
    static constexpr std::size_t kMostLevels = 64;
    static constexpr std::size_t kPointsOfPiece = 4096;

    void advanceTo(std::string_view text, std::size_t place)
    {
        m_line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(m_at),
                                                      text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
        m_at = place;
    }
    static std::size_t behind(std::string_view text, std::size_t from, std::string_view what)
    {
        const std::size_t end = text.find(what, from);
        return end == text.npos ? text.size() : end + what.size();
    }
    /// The position of the '>' that ends a tag, ignoring quotes.
    static std::size_t tagEnd(std::string_view text, std::size_t from)
    {
        char quote = '\0';
        for (std::size_t i = from; i < text.size(); ++i) {
            if (quote != '\0')
                quote = text[i] == quote ? '\0' : quote;
            else if (text[i] == '"' || text[i] == '\'')
                quote = text[i];
            else if (text[i] == '>')
                return i;
        }
        return text.size();
    }

    std::vector<std::size_t> m_points;
    std::vector<Cut> m_cuts;
    std::size_t m_at = 0, m_line = 1;
};

/// @param firstLine  line of the text in its file
Tree treeOf(const std::string &text, std::size_t firstLine)
{
    try {
        std::istringstream stream(text);
        Tree tree;
        boost::property_tree::read_xml(stream, tree, boost::property_tree::xml_parser::trim_whitespace);
        return tree;
    } catch (const boost::property_tree::xml_parser_error &error) {
        fail(error.line() + firstLine - 1, tr("this is not XML: %1", error.message()));
    }
}

/// Calls a function with the root of each piece of a document. A tree of the whole document would
/// need kilobytes per point.
template <class Take>
void forEachPiece(std::string_view text, const std::string &root, const Outline &outline, const Take &take)
{
    Outline::Cut start;
    for (std::size_t i = 0; i <= outline.cuts().size(); ++i) {
        const bool isLast = i == outline.cuts().size();
        const Outline::Cut end = isLast ? Outline::Cut{text.size(), 0} : outline.cuts()[i];
        std::string piece(text.substr(start.offset, end.offset - start.offset));
        if (i > 0)
            piece.insert(0, '<' + root + '>');
        if (!isLast)
            piece += "</" + root + '>';
        const Tree tree = treeOf(piece, start.line);
        const auto points = tree.get_child_optional(root);
        if (!points)
            fail(1, tr("there is no <%1>, which holds the points of MeshLab; is it another file?", root));
        take(*points);
        start = end;
    }
}

Json attributesOf(const Tree &element)
{
    Json attributes = Json::object();
    if (const auto child = element.get_child_optional("<xmlattr>")) {
        for (const auto &[name, value] : *child)
            attributes.emplace(name, value.data());
    }
    return attributes;
}

void readDocumentData(const Tree &data, LandmarkSet &set)
{
    Json others = Json::object();
    for (const auto &[tag, element] : data) {
        if (tag == kFileName)
            set.mesh = attributesOf(element).value("name", "");
        else if (tag != "<xmlattr>" && tag != "<xmlcomment>"
                 && (tag != kTemplateName || attributesOf(element).value("name", "?") != ""))
            others[tag] = attributesOf(element);
    }
    if (!others.empty())
        set.extra.edit()[kDocumentData] = std::move(others);
}

Landmark pointOf(const Tree &point, std::size_t line, std::size_t number, bool isTemplate, Notes &notes)
{
    Json attributes = attributesOf(point);
    Landmark landmark;
    landmark.name = attributes.value("name", "");
    const std::string who =
        tr("point %1", number + 1) + (landmark.name.empty() ? "" : " (" + base::quoted(landmark.name) + ')');
    glm::dvec3 v(0.0);
    const std::string active = attributes.value("active", "1");
    if (active != "0" && active != "1")
        fail(line, tr("active of %1 is %2; write 1, or 0 where it is not placed", who, base::quoted(active)));
    const bool isMissing = std::all_of(kAxes.begin(), kAxes.end(), [&attributes](const char *axis) {
        return isMissingWord(attributes.value(axis, ""));
    });
    for (std::size_t i = 0; i < kAxes.size() && !isTemplate && !isMissing; ++i) {
        if (attributes.contains(kAxes[i]))
            v[static_cast<int>(i)] = numberOf(attributes.value(kAxes[i], ""), line, tr("%1 of %2", kAxes[i], who));
        else if (active == "1")
            fail(line, tr("%1 of %2 is missing; give it, or write active=\"0\"", kAxes[i], who));
    }
    if (active == "1" && !isTemplate && !isMissing)
        landmark.world = WorldPoint(v);
    else if (v != glm::dvec3(0.0))
        notes.add(kHadPosition);
    for (const char *known : {"x", "y", "z", "active", "name"})
        attributes.erase(known);
    if (!attributes.empty())
        landmark.extra = base::JsonValue(std::move(attributes));
    return landmark;
}

ReadLandmarks read(std::string_view text, bool isTemplate)
{
    const char *root = isTemplate ? "PickPointsTemplate" : "PickedPoints";
    const Outline outline(text);
    ReadLandmarks found;
    Notes notes;
    LandmarkSet &set = found.sets.emplace_back();
    forEachPiece(text, root, outline, [&](const Tree &points) {
        for (const auto &[tag, element] : points) {
            const std::size_t number = set.landmarks.size();
            if (tag == "point")
                set.landmarks.push_back(pointOf(element, outline.lineOf(number), number, isTemplate, notes));
            else if (tag == kDocumentData)
                readDocumentData(element, set);
            else if (tag == "<xmlcomment>")
                notes.add(kCommentsLeftOut);
            else
                notes.addSpecimenKeys(tag);
        }
    });
    found.notes = notes.take();
    return found;
}

// ---- writing ------------------------------------------------------------------------------------

void appendAttribute(std::string &text, const std::string &name, std::string_view value)
{
    text += ' ' + name + "=\"";
    for (const char c : value) {
        switch (c) {
        case '&': text += "&amp;"; break;
        case '<': text += "&lt;"; break;
        case '>': text += "&gt;"; break;
        case '"': text += "&quot;"; break;
        case '\n': text += "&#10;"; break; // a point stays on one line
        case '\r': text += "&#13;"; break;
        case '\t': text += "&#9;"; break;
        default: text += c;
        }
    }
    text += '"';
}

/// A number without an exponent, because line-based readers take its letter for a part of a name.
/// It has the fewest digits that read back.
std::string fixedNumber(double value)
{
    std::array<char, 512> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
    return {digits.data(), end};
}

bool isXmlName(const std::string &name)
{
    return !name.empty() && !(name.front() >= '0' && name.front() <= '9')
           && std::all_of(name.begin(), name.end(), [](char c) {
                  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
              });
}

constexpr std::string_view kEscaped = "\n\r\t\x7f"; ///< control characters that XML can hold

/// The elements of DocumentData other than the mesh's name, as they were read. Elements that do not
/// fit get a note.
std::string documentData(const LandmarkSet &set, Notes &notes)
{
    std::string text;
    bool hasTemplate = false;
    for (auto it = set.extra.json().begin(); it != set.extra.json().end(); ++it) {
        if (it.key() != kDocumentData || !it->is_object()) {
            notes.addSpecimenKeys(it.key());
            continue;
        }
        for (auto element = it->begin(); element != it->end(); ++element) {
            if (!isXmlName(element.key()) || !element->is_object()) {
                notes.addSpecimenKeys(element.key());
                continue;
            }
            hasTemplate = hasTemplate || element.key() == kTemplateName;
            text += "  <" + element.key();
            for (auto value = element->begin(); value != element->end(); ++value) {
                if (isXmlName(value.key()) && value->is_string())
                    appendAttribute(text, value.key(), value->get<std::string>());
            }
            text += "/>\n";
        }
    }
    return hasTemplate ? text : text + "  <templateName name=\"\"/>\n";
}

} // namespace

ReadLandmarks readMeshLab(std::string_view text)
{
    return read(text, false);
}

ReadLandmarks readMeshLabTemplate(std::string_view text)
{
    return read(text, true);
}

std::string meshLabText(std::span<const LandmarkSet> sets, Notes &notes)
{
    const LandmarkSet &set = sets.front();
    PlainNames names("", false, notes, kEscaped);
    std::string text = "<!DOCTYPE PickedPoints>\n<PickedPoints>\n <DocumentData>\n  <DataFileName";
    appendAttribute(text, "name", names.of(set.mesh));
    text += "/>\n" + documentData(set, notes) + " </DocumentData>\n";
    for (const Landmark &landmark : set.landmarks) {
        const glm::dvec3 v = landmark.world ? landmark.world->coordinates() : glm::dvec3(0.0);
        text += " <point x=\"" + fixedNumber(v.x) + "\" y=\"" + fixedNumber(v.y) + "\" z=\"" + fixedNumber(v.z);
        text += landmark.world ? "\" active=\"1\"" : "\" active=\"0\"";
        appendAttribute(text, "name", names.of(landmark.name));
        text += "/>\n";
    }
    return text + "</PickedPoints>\n";
}

std::string meshLabTemplateText(std::span<const LandmarkSet> sets, Notes &notes)
{
    PlainNames names("", false, notes, kEscaped);
    std::string text = "<!DOCTYPE PickPointsTemplate>\n<PickPointsTemplate>\n";
    for (const Landmark &landmark : sets.front().landmarks) {
        text += " <point";
        appendAttribute(text, "name", names.of(landmark.name));
        text += "/>\n";
    }
    return text + "</PickPointsTemplate>\n";
}

} // namespace unprojector::landmark_files
