#include "core/cameras/pasted_numbers.h"

#include "core/base/error.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/pasted_names.h"

#include <algorithm>
#include <cmath>

namespace unprojector::cameras {
using namespace geometry;

namespace {

constexpr double kMatrixSide = 4.0;           ///< "size 4x4" is a matrix's
constexpr std::size_t kMostNumbers = 100'000; ///< of 6,000 matrices; the rest of a larger text is not read

class Reader {
public:
    Result<PastedNumbers, PasteError> read(std::string_view text)
    {
        for (const Group &group : scan(text)) {
            addName(group);
            for (const ScannedNumber &number : group.numbers) {
                tell();
                const bool isOnLine = number.line == m_nameLine,
                           isOfSize = isOnLine && m_last.isWidth && m_last.isHeight;
                if (number.isInWord && !isOfSize && m_part.part != PastedPart::Viewport)
                    continue;
                if (!std::isfinite(number.value))
                    return PasteError{
                        base::tr("\"%1\" is not a finite number", std::string(text.substr(number.at, number.length))),
                        number.line, number.at - text.rfind('\n', number.at)};
                if (isOnLine && takeAside(number.value))
                    continue;
                if (m_read.numbers.size() == kMostNumbers)
                    return PasteError{
                        .text = base::tr("it has more than %1 numbers; give the matrices alone", kMostNumbers),
                        .line = number.line,
                        .column = 1};
                add(number);
            }
        }
        addSize();
        return std::move(m_read);
    }

private:
    void addName(const Group &group)
    {
        if (plain(group.name).find_first_not_of("0123456789") == std::string::npos)
            return;
        if (!m_isInverse) // "inverse(view)" is one name
            m_names.emplace_back();
        m_names.back() += (m_isInverse ? " " : "") + std::string(group.name);
        m_isInverse = group.kind == GroupKind::Other && (group.name.ends_with("nverse") || group.name.ends_with("inv"));
        m_nameLine = group.line;
    }

    /// Finds what the names before a number tell: the last one about the numbers of its line, and
    /// the last one that is of a part.
    void tell()
    {
        m_isInverse = false;
        NamedPart found;
        std::string foundName;
        for (auto i = m_names.size(); i > m_told && !found.part; --i) {
            // Adjacent words form one name: "model view", "projection * view". Names are short. Prose,
            // as one name, would be searched again at each of its words.
            constexpr std::size_t kLongestName = 80;
            std::string name;
            NamedPart last;
            base::TextScanner words(m_names[i - 1]);
            for (auto word = words.nextWord(); !word.empty(); word = words.nextWord()) {
                name = name.empty() || name.size() >= kLongestName ? word : name + ' ' + std::string(word);
                last = namedBy(name);
                if (last.part) {
                    found = last;
                    foundName = m_names[i - 1].size() <= kLongestName ? m_names[i - 1] : "";
                }
            }
            if (i == m_names.size()) {
                m_last = last;
                m_lastName = name;
            }
        }
        m_sides = m_told < m_names.size() ? 0 : m_sides;
        if (found.part) {
            m_part = found;
            m_partName = foundName;
        }
        m_told = m_names.size();
    }

    /// Takes a number that belongs to no matrix. Returns whether it is one. The first width and
    /// height are used; a name that repeats them with other numbers is reported.
    bool takeAside(double value)
    {
        const std::size_t sides = std::size_t(m_last.isWidth) + m_last.isHeight;
        if (!m_last.isAside && m_sides == sides)
            return false;
        bool isUsed = false;
        if (m_sides < sides) {
            std::optional<double> &side = m_sides++ == 0 && m_last.isWidth ? m_width : m_height;
            isUsed = !side || *side <= kMatrixSide || *side == value;
            side = isUsed ? value : side;
        }
        if (!isUsed && (m_read.aside.empty() || m_read.aside.back() != m_lastName))
            m_read.aside.push_back(m_lastName);
        return true;
    }

    /// The viewport of a width and a height, 0 0 width height, if the text names no other.
    void addSize()
    {
        const bool hasViewport =
            std::any_of(m_read.numbers.begin(), m_read.numbers.end(),
                        [](const PastedNumber &number) { return number.part == PastedPart::Viewport; });
        const bool isImage = m_width && m_height && std::max(*m_width, *m_height) > kMatrixSide;
        if (isImage && !hasViewport && !m_read.numbers.empty()) {
            m_part = {PastedPart::Viewport};
            for (const double value : {0.0, 0.0, *m_width, *m_height})
                add({value});
            return;
        }
        if (m_width)
            m_read.aside.emplace_back("width");
        if (m_height)
            m_read.aside.emplace_back("height");
    }

    void add(const ScannedNumber &number)
    {
        PastedNumber pasted{number, {}, m_part.part, m_partName, m_part.isInverse};
        for (const std::string &name : m_names)
            pasted.words.push_back(base::lowerCase(name));
        m_read.numbers.push_back(std::move(pasted));
        m_names.clear();
        m_told = 0;
    }

    std::vector<std::string> m_names; ///< since the last number of a matrix
    std::size_t m_told = 0;           ///< how many of them were searched
    bool m_isInverse = false;         ///< the last one is "inverse("
    std::size_t m_nameLine = 0;
    NamedPart m_part, m_last; ///< what the last name of a part tells, and the last of all
    std::string m_partName, m_lastName;
    std::size_t m_sides = 0; ///< of a size, read after its name
    std::optional<double> m_width, m_height;
    PastedNumbers m_read;
};

} // namespace

Result<PastedNumbers, PasteError> pastedNumbers(std::string_view text)
{
    try {
        return Reader().read(text);
    } catch (const base::Error &error) {
        return PasteError{error.text, std::size_t(error.line), 1};
    }
}

} // namespace unprojector::cameras
