#pragma once

#include "core/base/text_scanner.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/ply_header.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace unprojector::mesh::reader {

/// Reads a value from the bytes of a binary file.
double plyValue(const std::uint8_t *bytes, PlyType type, PlyFormat format);

/// Reads the values after a PLY header one by one. Every function throws Damage if the
/// file ends or holds an unexpected value.
class PlyBody {
public:
    PlyBody(const Source &source, const PlyHeader &header);

    /// Begins an element's values; in text, at the start of a line.
    void beginElement(const PlyElement &element, std::size_t number);
    double value(PlyType type);
    /// Reads a vertex number: -1 where a strip restarts, -2 for a number that no file can have.
    /// Throws if it is not a whole number.
    std::int64_t corner(PlyType type);
    /// Reads a list's length, checked against the rest of the file.
    std::size_t listLength(const PlyProperty &list);
    void skip(const PlyProperty &property);
    /// Ends an element's values; in text, its line must end here.
    void endElement();
    /// Skips all instances of an element.
    void skipAll(const PlyElement &element);
    /// Ends the file after the last element. In text only blanks may follow.
    /// @return the number of bytes that follow in a binary file, 0 if they are blank
    std::size_t end();

    /// Reads all instances of an element on all cores, each one a line of a long text, and moves
    /// past them.
    /// @param read  called at once from several threads, each with a body of its own at its first
    ///         instance
    /// @return false if parallel reading does not pay off, or anything is wrong. Then the position
    ///         is unchanged, and sequential reading reports the error. The values that `read` has
    ///         stored must be stored anew
    bool readLines(const PlyElement &element,
                   const std::function<void(PlyBody &part, std::size_t first, std::size_t count)> &read);

    /// The position of the next values of a binary file.
    const std::uint8_t *next() const { return m_bytes.data() + m_at; }
    /// The same, and moves past them.
    const std::uint8_t *take(std::size_t size);
    std::size_t bytesLeft() const { return m_bytes.size() - offset(); }

private:
    void skipComments();
    std::size_t offset() const { return m_format == PlyFormat::Ascii ? m_scanner.offset() : m_at; }
    std::string where() const { return m_element->name + ' ' + std::to_string(m_number); }
    [[noreturn]] void failTruncated() const;
    /// Reads the next number of a line of text; its range is not checked.
    double asciiNumber(PlyType type);
    /// Reads the next number and checks that its type can hold it.
    double asciiValue(PlyType type);

    const Source &m_source;
    PlyFormat m_format;
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at;
    base::TextScanner m_scanner;
    bool m_isPart = false; ///< read in parallel with others: it reports nothing
    const PlyElement *m_element = nullptr;
    std::size_t m_number = 0;
};

} // namespace unprojector::mesh::reader
