#pragma once

#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/ply_header.h"
#include "core/text/text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace unprojector::mesh::reader {

/// A value as it lies in a binary file.
double plyValue(const std::uint8_t *bytes, PlyType type, PlyFormat format);

/// Reads the values after a PLY header one by one. Every function throws Failure (Malformed) where the file ends, or holds
/// something else.
class PlyBody {
public:
    PlyBody(const Source &source, const PlyHeader &header);

    /// Before an element's values; in text it begins a line.
    void beginElement(const PlyElement &element, std::size_t number);
    double value(PlyType type);
    /// The number of a vertex, -1 where a strip begins anew; -2 where it is none that a file could have. Throws for what is no
    /// whole number.
    std::int64_t corner(PlyType type);
    /// A list's length, checked against what is left of the file.
    std::size_t listLength(const PlyProperty &list);
    void skip(const PlyProperty &property);
    /// After an element's values; in text its line ends with them.
    void endElement();
    /// Skips all of an element's instances.
    void skipAll(const PlyElement &element);
    /// After the last element. In text only blanks may follow.
    /// @return the bytes that follow in a binary file, 0 where they are blank
    std::size_t end();

    /// Reads all of an element's instances, each a line of a long text, by all cores; moves on behind them.
    /// @param read  called at once from several threads, each with a body of its own that stands before the first of them
    /// @return false where that is not worth while, or something is not as it should be: then nothing is read, and one by one
    ///         will say what. What `read` has stored by then is to be stored anew
    bool readLines(const PlyElement &element,
                   const std::function<void(PlyBody &part, std::size_t first, std::size_t count)> &read);

    /// Where the next values of a binary file are.
    const std::uint8_t *next() const { return m_bytes.data() + m_at; }
    /// The same, and moves on.
    const std::uint8_t *take(std::size_t size);
    std::size_t bytesLeft() const { return m_bytes.size() - offset(); }

private:
    void skipComments();
    std::size_t offset() const { return m_format == PlyFormat::Ascii ? m_scanner.offset() : m_at; }
    std::string where() const { return m_element->name + ' ' + std::to_string(m_number); }
    [[noreturn]] void failTruncated() const;
    [[noreturn]] void failAtLine(const std::string &what) const;
    /// The next word of a line of text, of any size.
    double asciiNumber(PlyType type);
    /// The same, which must be a number of its type.
    double asciiValue(PlyType type);

    const Source &m_source;
    PlyFormat m_format;
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at;
    text::TextScanner m_scanner;
    bool m_isPart = false; ///< read beside others: it reports nothing
    const PlyElement *m_element = nullptr;
    std::size_t m_number = 0;
};

} // namespace unprojector::mesh::reader
