#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::cameras {

/// The nesting of a text: the braces and lists of JSON and source code, YAML's indentation, XML's
/// elements, and sections [of an INI file].
class Outline {
public:
    /// A part of a text that has a heading, or is an item of a list.
    struct Node {
        std::size_t parent = 0;   ///< the root is its own
        std::string name{};       ///< of its heading; of an item, the list's
        std::string label{};      ///< the name, label or id that it gives itself
        std::size_t item = 0;     ///< its index among the items of its list, or the elements of its name, from 0
        bool isOfSeveral = false; ///< there are several such items
    };

    explicit Outline(std::string_view text);

    /// The innermost node at a place in the text; 0 is the whole text.
    std::size_t nodeAt(std::size_t at) const;
    const Node &node(std::size_t index) const { return m_nodes[index]; }
    std::size_t size() const { return m_nodes.size(); } ///< parents stand before their children
    /// The nodes from the root to a node.
    std::vector<std::size_t> pathTo(std::size_t index) const;
    /// Returns whether the text ends inside of a bracket.
    bool isUnclosed() const { return m_isUnclosed; }
    /// Returns whether the text closes a bracket that is not open.
    bool isOverclosed() const { return m_isOverclosed; }
    /// What to call a node: its label, its heading, or its index in its list.
    std::string nameOf(std::size_t index) const;

private:
    friend class OutlineReader;
    struct Change {
        std::size_t at, node;
    };
    std::vector<Node> m_nodes{Node{}};
    std::map<std::pair<std::size_t, std::string>, std::pair<std::size_t, std::size_t>> m_items; ///< first and count
    std::vector<Change> m_changes{{0, 0}};
    bool m_isUnclosed = false, m_isOverclosed = false;
};

} // namespace unprojector::cameras
