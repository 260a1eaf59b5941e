#pragma once

#include <nlohmann/json.hpp>

#include <QTest>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The texts in tests/data: what other programs write and print, and what this one must read in it.
namespace data_files {

inline std::string read(const std::filesystem::path &file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw std::runtime_error("there is no " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The entries of a folder of tests/data, by name.
inline std::vector<std::filesystem::path> in(const std::filesystem::path &folder)
{
    std::vector<std::filesystem::path> entries;
    for (const auto &entry : std::filesystem::directory_iterator(std::filesystem::path(UNPROJECTOR_TEST_DATA) / folder))
        entries.push_back(entry.path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

struct NamedText {
    std::string name, text;
};

/// A camera as another program writes it, and that program's own projections of some points: computed
/// by Blender (world_to_camera_view), three.js (Vector3.project), with the pose that COLMAP wrote for
/// Bundler, or with the formulas of the programs' documentation. A folder of tests/data/cameras:
/// its files, and expected.json.
struct CameraExample {
    struct Point {
        std::vector<double> world; ///< of the scene: right-handed
        std::vector<double> pixel; ///< as the program counts
    };
    std::string name;
    std::vector<NamedText> texts;
    std::string image; ///< chosen; empty: none
    int width, height; ///< chosen; 0: none
    double tolerance;  ///< relative to the image's size
    double corner;     ///< added to the program's pixels: from the image's corner
    std::vector<Point> points;
};

inline CameraExample cameraExample(const std::filesystem::path &folder)
{
    const nlohmann::json expected = nlohmann::json::parse(read(folder / "expected.json"));
    const std::vector<int> size = expected.value("size", std::vector<int>{0, 0});
    CameraExample example{expected.at("name"),
                          {},
                          expected.value("image", ""),
                          size.at(0),
                          size.at(1),
                          expected.at("tolerance"),
                          expected.value("corner", 0.0),
                          {}};
    for (const std::string name : expected.at("files"))
        example.texts.push_back({name, read(folder / name)});
    for (const nlohmann::json &point : expected.at("points"))
        example.points.push_back({point.at("world"), point.at("pixel")});
    if (example.points.empty())
        throw std::runtime_error("no points are expected");
    return example;
}

inline const std::vector<CameraExample> &cameraExamples()
{
    static const std::vector<CameraExample> examples = [] {
        std::vector<CameraExample> all;
        for (const std::filesystem::path &folder : in("cameras")) {
            try {
                all.push_back(cameraExample(folder));
            } catch (const std::exception &why) {
                qFatal("%s: %s", folder.string().c_str(), why.what());
            }
        }
        return all;
    }();
    return examples;
}

/// A text, and what must come of it by words of its test: "malformed" and the message.
struct Case {
    std::string name, text;
    std::vector<std::pair<std::string, std::string>> told;

    std::vector<std::string> all(std::string_view word) const
    {
        std::vector<std::string> texts;
        for (const auto &[key, value] : told) {
            if (key == word)
                texts.push_back(value);
        }
        return texts;
    }
    /// The message of a case that is refused, and nothing else.
    std::string refused() const
    {
        if (told.size() != 1 || told.front().first != "refused")
            throw std::runtime_error(name + ": one line refused: is all that comes of it");
        return told.front().second;
    }
};

/// Reads the cases in a file of tests/data/texts:
///
///     # a remark
///     :: box                 a text that cases begin with
///     | f 1 2 3              its lines
///
///     == a vertex too many   a case
///     from: box
///     - 2 3                  what is replaced where it is there first; each such line is a line of it
///     + 2 9                  by this
///     | # more               a line behind it; after ~ one without a line end
///     malformed: line 1: …   what must come of it
///
/// The bytes \n, \t, \r, \\ and \xNN are written so. A case without anything that must come of it, or the
/// other way round, is an error.
class CaseReader {
public:
    explicit CaseReader(const std::string &name) : m_name(name + ".txt")
    {
        std::istringstream lines(read(std::filesystem::path(UNPROJECTOR_TEST_DATA) / "texts" / m_name));
        for (std::string line; std::getline(lines, line);) {
            ++m_line;
            if (line.ends_with('\r'))
                line.pop_back();
            if (!line.empty() && line.front() != '#')
                take(line);
        }
        endCase();
        for (const auto &[base, use] : m_bases) {
            if (!use.isUsed)
                fail("no case begins with " + base);
        }
        if (cases.empty())
            fail("there are no cases");
    }

    std::vector<Case> cases;

private:
    struct Base {
        std::string text;
        bool isUsed = false;
    };

    void take(const std::string &line)
    {
        const std::string mark = line.substr(0, line.find(' ')),
                          rest = unescaped(line.substr(std::min(line.size(), mark.size() + 1)));
        if (mark == "+" || mark == "-") {
            if (mark == "-" && m_new)
                endEdit();
            std::optional<std::string> &part = mark == "-" ? m_old : m_new;
            part = part ? *part + '\n' + rest : rest;
            return;
        }
        endEdit();
        if (mark == "==" || mark == "::") {
            endCase();
            if (!m_names.insert(mark + rest).second)
                fail("\"" + rest + "\" is there twice");
            if (mark == "==")
                cases.push_back({rest, {}, {}});
            m_text = mark == "==" ? &cases.back().text : &m_bases[rest].text;
        } else if (!m_text) {
            fail("this belongs to no case");
        } else if (mark == "|" || mark == "~") {
            *m_text += mark == "|" ? rest + '\n' : rest;
        } else if (const std::size_t colon = line.find(':'); colon == std::string::npos) {
            fail("a line begins with |, ~, -, +, ==, :: or a word and a colon");
        } else if (const std::string word = line.substr(0, colon),
                   value = unescaped(line.substr(std::min(line.size(), colon + 2)));
                   word == "from") {
            const auto base = m_bases.find(value);
            if (base == m_bases.end())
                fail("there is no text \"" + value + "\" above");
            base->second.isUsed = true;
            *m_text = base->second.text;
        } else if (cases.empty() || m_text != &cases.back().text) {
            fail("only a case has something that must come of it");
        } else {
            cases.back().told.emplace_back(word, value);
        }
    }
    void endEdit()
    {
        if (!m_old && !m_new)
            return;
        const std::size_t at = m_text && m_old ? m_text->find(*m_old) : std::string::npos;
        if (at == std::string::npos)
            fail("there is nothing to replace");
        m_text->replace(at, m_old->size(), m_new.value_or(""));
        m_old.reset();
        m_new.reset();
    }
    void endCase()
    {
        endEdit();
        if (!cases.empty() && cases.back().told.empty())
            fail("nothing must come of \"" + cases.back().name + '"');
    }
    static std::string unescaped(const std::string &line)
    {
        std::string text;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (line[i] != '\\') {
                text += line[i];
                continue;
            }
            switch (line.at(++i)) {
            case 'n': text += '\n'; break;
            case 't': text += '\t'; break;
            case 'r': text += '\r'; break;
            case 'x':
                text += static_cast<char>(std::stoi(line.substr(i + 1, 2), nullptr, 16));
                i += 2;
                break;
            default: text += line[i];
            }
        }
        return text;
    }
    [[noreturn]] void fail(const std::string &why) const
    {
        throw std::runtime_error(m_name + ':' + std::to_string(m_line) + ": " + why);
    }

    std::string m_name;
    int m_line = 0;
    std::set<std::string> m_names;
    std::map<std::string, Base> m_bases;
    std::string *m_text = nullptr; ///< of the case or of the text that cases begin with
    std::optional<std::string> m_old, m_new;
};

/// The cases in a file of tests/data/texts. The test fails if there is an error in it.
inline std::vector<Case> cases(const std::string &name)
{
    try {
        return CaseReader(name).cases;
    } catch (const std::exception &why) {
        QTest::qFail(why.what(), __FILE__, __LINE__);
        return {};
    }
}

/// Adds them as rows of the column "example".
inline void addCases(const std::string &name)
{
    QTest::addColumn<Case>("example");
    for (const Case &example : cases(name))
        QTest::newRow(example.name.c_str()) << example;
}

} // namespace data_files
