#pragma once

#include "core/cameras/camera_json.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

// XML of other programs, as JSON. An element is an object: its attributes are texts, "" is its own text,
// "@" the offset of its '<', and each tag has the list of its children. Prefixes of names are dropped.

/// The elements of an XML text that has all these words, under an object that stands for the document; a
/// part of a file may have several roots. Null for another text. Throws a base::Error with the line of a
/// mistake.
nlohmann::ordered_json xmlWith(const NamedText &text, JsonKeys words);

/// The first child along a path of tags; null where one is missing.
const nlohmann::ordered_json &child(const nlohmann::ordered_json &element, JsonKeys path);
/// All children with a tag.
const nlohmann::ordered_json &children(const nlohmann::ordered_json &element, std::string_view tag);

/// An element of a path, with its tag.
struct XmlStep {
    std::string_view tag;
    const nlohmann::ordered_json *element = nullptr;
};
/// The elements from a root to an element inside it.
using XmlPath = std::vector<XmlStep>;

/// The paths to all elements with a tag, in the text's order.
std::vector<XmlPath> pathsTo(const nlohmann::ordered_json &document, std::string_view tag);

/// The text of an attribute, or of the first child with this tag; empty without both.
std::string xmlText(const nlohmann::ordered_json &element, std::string_view key);
/// The numbers in such a text, between blanks or commas; empty if it has anything else.
std::vector<double> xmlNumbers(const nlohmann::ordered_json &element, std::string_view key);
/// The number of such a text; the other one if it is none.
double xmlNumber(const nlohmann::ordered_json &element, std::string_view key, double otherwise);
/// The same; for another count they fail, in the element's line.
std::vector<double> neededXml(const Reading &reading, const nlohmann::ordered_json &element, std::string_view key,
                              std::size_t count);
glm::dvec3 neededXmlVector(const Reading &reading, const nlohmann::ordered_json &element, std::string_view key);

} // namespace unprojector::cameras
