#pragma once

#include "core/base/json.h"
#include "core/cameras/foreign_camera.h"
#include "core/cameras/named_values.h"

#include <glm/vec3.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

class Reading;

/// The keys of a value. "a/b" is b inside a; "x y" are the numbers of both, one after the other; of
/// "x|y" the first that is there counts.
using Keys = std::string_view;
using Numbers = std::vector<double>;
using Words = std::vector<std::string_view>;

/// A part of a text: a value of JSON, an element of XML, or the named values of a printed text. XML is
/// read as JSON: an element is an object, its attributes are texts, "" is its own text, "@" the offset
/// of its '<', and each tag has the list of its children. A name of a printed text is found by its
/// letters and digits in lower case, as in NamedValues.
class Node {
public:
    Node() = default; ///< nothing
    Node(const Reading &reading, const base::Json &json, base::JsonPath path = {});
    /// @param text  what has the values
    Node(const Reading &reading, std::shared_ptr<const NamedValues> values, std::string_view text);

    explicit operator bool() const;
    const base::Json &json() const;
    const NamedValues &values() const { return *m_values; }
    std::string_view text() const { return m_text; } ///< of the values
    /// Its own key; the index of a list's element.
    std::string key() const;
    /// The key of its list: the tag of an element of XML.
    std::string tag() const;

    /// The value along a path. On the way, the first element with a tag of XML counts.
    Node operator[](Keys path) const;
    /// The elements of a list or with a tag, or an object's members.
    std::vector<Node> list(Keys path) const;
    /// The elements of a list; another value itself.
    std::vector<Node> elements() const;
    /// Those of list() by a word of each, the first of equal ones; by their own keys without one.
    std::map<std::string, Node> index(Keys path, Keys key) const;

    bool has(Keys keys) const;
    /// Returns whether a value is there and no empty list or object.
    bool holds(Keys keys) const;
    /// A text, or JSON's value as it is written; empty without one.
    std::string word(Keys keys) const;
    /// Returns whether a value is true or a number other than 0.
    bool isTrue(Keys keys) const;
    /// Finite numbers: of nested lists one after the other, and in texts between blanks or commas. Empty if
    /// there is anything else, or less than the fewest. A vector of a printed text may have its x, y and z
    /// apart.
    Numbers numbers(Keys keys, std::size_t fewest = 1) const;
    /// A value that is one number; of a printed text, its first one.
    std::optional<double> number(Keys keys) const;
    /// @param otherwise  without the key; a key with another value than one number fails
    double number(Keys keys, double otherwise) const;
    /// The same; another count of numbers fails in the line of the key.
    Numbers needed(Keys keys, std::size_t count) const;
    double needed(Keys key) const { return needed(key, 1)[0]; }
    glm::dvec3 vector(Keys keys) const;
    /// "K2 (9 numbers), pose (16 numbers)": the values of names of a camera's parts that were not looked up.
    std::string unused() const;

    /// Fails in the line of the key, or of the node without one.
    [[noreturn]] void fail(std::string reason, Keys key = {}) const;

private:
    const base::Json *member(Keys path) const;
    base::JsonPath pathTo(Keys path) const;
    std::size_t lineOf(Keys key) const;

    const Reading *m_reading = nullptr;
    const base::Json *m_json = nullptr;
    std::shared_ptr<const NamedValues> m_values;
    std::string_view m_text;
    base::JsonPath m_path; ///< from the document
};

/// An element of XML, behind those around it, from a root on.
using Trail = std::vector<Node>;
/// The trails to all elements with a tag, in the text's order.
std::vector<Trail> trailsTo(const Node &document, std::string_view tag);

/// The parts of a text between two characters: "a|b" has a and b.
Words split(std::string_view text, char at);

/// A vector from three of the numbers.
glm::dvec3 vectorOf(const Numbers &numbers, std::size_t from = 0);

/// Returns whether a text begins as a JSON object or list, or as XML.
bool isJson(std::string_view text);
bool isXml(std::string_view text);

/// JSON with blanks in the places of its comments, // and /* */, which some programs write.
std::string withoutComments(std::string text);
/// The document of JSON. Throws a base::Error with the position and reason of a mistake in its syntax.
base::Json parsedJson(const NamedText &text);
/// The elements of XML, under an object that stands for the document; a part of a file may have several
/// roots. Throws a base::Error with the line of a mistake.
base::Json parsedXml(const NamedText &text);

} // namespace unprojector::cameras
