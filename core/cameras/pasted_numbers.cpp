#include "core/cameras/pasted_numbers.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/pasted_names.h"

#include <algorithm>
#include <cmath>

namespace unprojector::cameras {
using namespace geometry;

namespace {

class Reader {
public:
    explicit Reader(std::string_view text) : m_text(text) {}

    Result<PastedNumbers, PasteError> read()
    {
        for (const Group &group : scan(m_text)) {
            addName(group);
            for (const ScannedNumber &number : group.numbers) {
                tell();
                const bool isOnLine = number.line == m_nameLine;
                const bool isOfSize = m_named.part == PastedPart::Viewport || (isOnLine && m_sides.size() == 2);
                if (number.isInWord && !isOfSize)
                    continue;
                if (!std::isfinite(number.value))
                    return PasteError{
                        base::tr("\"%1\" is not a finite number", std::string(m_text.substr(number.at, number.length))),
                        number.line, number.at - m_text.rfind('\n', number.at)};
                if (!isOnLine || !takeAside(number.value))
                    add(number);
            }
        }
        addSize();
        return std::move(m_read);
    }

private:
    void addName(const Group &group)
    {
        const std::string letters = lettersOf(group.name);
        if (letters.empty())
            return;
        if (m_isInverse) // "inverse(view)"
            m_names.back() += ' ';
        else
            m_names.emplace_back();
        m_names.back() += group.name;
        m_isInverse = group.kind == GroupKind::Other && (letters.ends_with("inverse") || letters.ends_with("inv"));
        m_nameLine = group.line;
    }

    /// Finds what the names before a number tell: the last one about the numbers of its line, and
    /// the last one that is of a part.
    void tell()
    {
        m_isInverse = false;
        NamedPart found;
        for (std::size_t i = m_names.size(); i > m_told && !found.part; --i) {
            // Adjacent words form one name: "model view", "projection * view". Names are short. Prose,
            // as one name, would be searched again at each of its words.
            constexpr std::size_t kLongestName = 80;
            std::string name, letters;
            base::TextScanner words(m_names[i - 1]);
            for (std::string_view word = words.nextWord(); !word.empty(); word = words.nextWord()) {
                name = name.empty() || name.size() >= kLongestName ? std::string(word) : name + ' ' + std::string(word);
                letters = lettersOf(name);
                const auto named = isAside(letters) || isSize(letters) ? std::nullopt : namedBy(name);
                found = named.value_or(found);
            }
            if (i < m_names.size())
                continue;
            m_aside = isAside(letters) ? name : "";
            m_sizeName = name;
            m_sides.clear();
            m_sizeNumbers = 0;
            if (letters == "width" || isSize(letters))
                m_sides.push_back(&m_width);
            if (letters == "height" || isSize(letters))
                m_sides.push_back(&m_height);
        }
        m_named = found.part ? found : m_named;
        m_told = m_names.size();
    }

    /// Takes a number that belongs to no matrix. Returns whether it is one. The first width and
    /// height are used; a name that repeats them with other numbers is reported.
    bool takeAside(double value)
    {
        if (m_sizeNumbers < m_sides.size()) {
            std::optional<double> &side = *m_sides[m_sizeNumbers++];
            if (!side || *side <= kMatrixSide)
                side = value;
            else if (*side != value)
                nameAside(m_sizeName);
            return true;
        }
        if (!m_aside.empty())
            nameAside(m_aside);
        return !m_aside.empty();
    }

    void nameAside(const std::string &name)
    {
        if (m_read.aside.empty() || m_read.aside.back() != name)
            m_read.aside.push_back(name);
    }

    /// The viewport of a width and a height, 0 0 width height, if the text names no other.
    void addSize()
    {
        const bool hasViewport =
            std::any_of(m_read.numbers.begin(), m_read.numbers.end(),
                        [](const PastedNumber &number) { return number.part == PastedPart::Viewport; });
        const bool isOfMatrix = m_width && m_height && *m_width <= kMatrixSide && *m_height <= kMatrixSide;
        if (m_read.numbers.empty() || hasViewport || !m_width || !m_height || isOfMatrix) {
            if (m_width)
                m_read.aside.emplace_back("width");
            if (m_height)
                m_read.aside.emplace_back("height");
            return;
        }
        m_named = {PastedPart::Viewport};
        for (const double value : {0.0, 0.0, *m_width, *m_height})
            add({value});
    }

    void add(const ScannedNumber &number)
    {
        PastedNumber pasted{number, {}, m_named.part, m_named.isInverse};
        for (const std::string &name : m_names)
            pasted.words.push_back(base::lowerCase(name));
        m_read.numbers.push_back(std::move(pasted));
        m_names.clear();
        m_told = 0;
    }

    static constexpr double kMatrixSide = 4.0; ///< "size 4x4" is a matrix's

    std::string_view m_text;
    std::vector<std::string> m_names; ///< since the last number of a matrix
    std::size_t m_told = 0;           ///< how many of them were searched
    bool m_isInverse = false;         ///< the last one is "inverse("
    std::size_t m_nameLine = 0;
    NamedPart m_named;
    std::string m_aside, m_sizeName; ///< names of numbers of this line that belong to no matrix
    std::vector<std::optional<double> *> m_sides;
    std::size_t m_sizeNumbers = 0; ///< read after the size's name
    std::optional<double> m_width, m_height;
    PastedNumbers m_read;
};

} // namespace

Result<PastedNumbers, PasteError> pastedNumbers(std::string_view text)
{
    return Reader(text).read();
}

} // namespace unprojector::cameras
