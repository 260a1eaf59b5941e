#include "core/mesh_reader.h"
#include "core/text_scanner.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace unprojector::mesh_reader {

namespace {

constexpr std::size_t kLinesBetweenReports = 1 << 14;

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

    ObjCounts counts()
    {
        ObjCounts counts;
        walk([&](std::string_view keyword) {
            if (keyword == "v") {
                checkCoordinates(static_cast<std::size_t>(counts.vertices++));
            } else if (keyword == "vt") {
                ++counts.texcoords;
            } else if (keyword == "vn") {
                ++counts.normals;
            } else if (keyword == "f" || keyword == "fo") {
                ++counts.faces;
            }
        });
        return counts;
    }

    void checkFaces(const ObjCounts &total)
    {
        m_scanner = TextScanner(m_source.text());
        ObjCounts soFar;
        walk([&](std::string_view keyword) {
            if (keyword == "v")
                ++soFar.vertices;
            else if (keyword == "vt")
                ++soFar.texcoords;
            else if (keyword == "vn")
                ++soFar.normals;
            else if (keyword == "f" || keyword == "fo" || keyword == "l" || keyword == "p")
                checkElement(soFar, total, keyword[0] == 'f' ? "face" : keyword[0] == 'l' ? "line" : "point");
        });
    }

private:
    template <class Statement>
    void walk(const Statement &statement)
    {
        for (std::size_t lines = 0; !m_scanner.isAtEnd(); ++lines) {
            if (lines % kLinesBetweenReports == 0)
                m_source.progress.report(0.0);
            statement(m_scanner.nextWordInLine());
            m_scanner.skipLine();
        }
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
                failAtLine(m_scanner.line(), "a vertex needs three numbers"
                                                 + (word.empty() ? std::string()
                                                                 : ", not \"" + std::string(word.substr(0, 40)) + '"'));
            if (!std::isfinite(*value))
                throw Failure(ImportErrorCode::NotFinite, {}, vertex);
        }
    }

    void checkElement(const ObjCounts &soFar, const ObjCounts &total, const char *element)
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
                    failAtLine(m_scanner.line(), "\"" + std::string(whole.substr(0, 40)) + "\" is no corner of a "
                                                     + element);
                checkIndex(*index, part, soFar, total, element);
            }
        }
    }

    void checkIndex(long long index, int part, const ObjCounts &soFar, const ObjCounts &total, const char *element)
    {
        static constexpr const char *kNames[] = {"vertex", "texture coordinate", "normal"};
        const long long before[] = {soFar.vertices, soFar.texcoords, soFar.normals};
        const long long all[] = {total.vertices, total.texcoords, total.normals};
        const bool exists = index > 0 ? index <= all[part] : index < 0 && -index <= before[part];
        if (!exists)
            failAtLine(m_scanner.line(), std::string("a ") + element + " refers to " + kNames[part] + ' '
                                             + std::to_string(index) + ", the file has " + std::to_string(all[part]));
    }

    const Source &m_source;
    TextScanner m_scanner;
};

} // namespace

void checkObj(const Source &source)
{
    ObjChecker checker(source);
    const ObjCounts counts = checker.counts();
    checker.checkFaces(counts);
    if (counts.faces == 0) {
        // A file of any text would pass so far.
        if (counts.vertices == 0)
            failMalformed("the file holds no OBJ vertices and no faces");
        throw Failure(ImportErrorCode::NoTriangles);
    }
}

} // namespace unprojector::mesh_reader
