#include "core/mesh_import/mesh_reader.h"
#include "core/mesh_import/text_scanner.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace unprojector::mesh_import::mesh_reader {

namespace {

constexpr std::size_t kLinesBetweenReports = 1 << 14;
constexpr const char *kPartNames[] = {"vertex", "texture coordinate", "normal"};

[[noreturn]] void failAtLine(std::size_t line, const std::string &what)
{
    failMalformed("line " + std::to_string(line) + ": " + what);
}

struct ObjCounts {
    long long vertices = 0;
    long long texcoords = 0;
    long long normals = 0;
    std::size_t faces = 0;
};

/// Walks over the file; a backslash joins a line with the next, as in every OBJ statement.
class ObjChecker {
public:
    explicit ObjChecker(const Source &source) : m_source(source), m_scanner(source.text()) {}

    void check()
    {
        // Faces refer to vertices further up in nearly every file: then one walk is enough.
        bool mayReferForward = false;
        const ObjCounts total = walk(
            [&](const ObjCounts &soFar, const char *element) {
                mayReferForward = mayReferForward || !problemOf(element, soFar, soFar).empty();
            },
            true);
        if (mayReferForward) {
            m_scanner = TextScanner(m_source.text());
            walk(
                [&](const ObjCounts &soFar, const char *element) {
                    if (const std::string problem = problemOf(element, soFar, total); !problem.empty())
                        failAtLine(m_scanner.line(), problem);
                },
                false);
        }
        if (total.faces > 0)
            return;
        // A file of any text would pass so far.
        if (total.vertices == 0)
            failMalformed("the file holds no OBJ vertices and no faces");
        throw Failure(ImportErrorCode::NoTriangles);
    }

private:
    /// Calls `visitElement` for every face, line and point; returns what the file holds.
    template <class Visitor>
    ObjCounts walk(const Visitor &visitElement, bool checksCoordinates)
    {
        ObjCounts counts;
        for (std::size_t lines = 0; !m_scanner.isAtEnd(); ++lines) {
            if (lines % kLinesBetweenReports == 0)
                m_source.progress.report(0.0);
            const std::string_view keyword = m_scanner.nextWordInLine();
            if (keyword == "v") {
                if (checksCoordinates)
                    checkCoordinates(static_cast<std::size_t>(counts.vertices));
                ++counts.vertices;
            } else if (keyword == "vt") {
                ++counts.texcoords;
            } else if (keyword == "vn") {
                ++counts.normals;
            } else if (keyword == "f") {
                ++counts.faces;
                visitElement(counts, "face");
            } else if (keyword == "l") {
                visitElement(counts, "line");
            } else if (keyword == "p") {
                visitElement(counts, "point");
            }
            m_scanner.skipLine();
        }
        return counts;
    }

    std::string_view nextWord()
    {
        std::string_view word = m_scanner.nextWordInLine();
        while (word == "\\") {
            m_scanner.skipLine();
            word = m_scanner.nextWordInLine();
        }
        return word;
    }

    void checkCoordinates(std::size_t vertex)
    {
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = nextWord();
            const std::optional<float> value = floatFromWord(word);
            if (!value)
                failAtLine(m_scanner.line(), word.empty() ? "a vertex needs three numbers"
                                                          : "a vertex needs three numbers, not " + quoted(word));
            if (!std::isfinite(*value))
                throw Failure(ImportErrorCode::NotFinite, {}, vertex);
        }
    }

    /// What is wrong with the corners in the rest of the line, or nothing.
    std::string problemOf(const char *element, const ObjCounts &soFar, const ObjCounts &total)
    {
        for (std::string_view word = nextWord(); !word.empty() && word.front() != '#'; word = nextWord()) {
            const std::string_view whole = word;
            for (int part = 0; part < 3 && !word.empty(); ++part) {
                const std::size_t slash = word.find('/');
                const std::string_view number = word.substr(0, slash);
                word.remove_prefix(slash == word.npos ? word.size() : slash + 1);
                if (number.empty() && part > 0)
                    continue;
                const std::optional<long long> index = integerFromWord(number);
                if (!index)
                    return quoted(whole) + " is no corner of a " + element;
                const long long before[] = {soFar.vertices, soFar.texcoords, soFar.normals};
                const long long all[] = {total.vertices, total.texcoords, total.normals};
                const bool exists = *index > 0 ? *index <= all[part] : *index < 0 && *index >= -before[part];
                if (!exists)
                    return std::string("a ") + element + " refers to " + kPartNames[part] + ' ' + std::to_string(*index)
                           + ", the file has " + std::to_string(all[part]);
            }
        }
        return {};
    }

    const Source &m_source;
    TextScanner m_scanner;
};

} // namespace

void checkObj(const Source &source)
{
    ObjChecker(source).check();
}

} // namespace unprojector::mesh_import::mesh_reader
