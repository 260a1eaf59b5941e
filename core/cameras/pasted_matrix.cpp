#include "core/cameras/pasted_matrix.h"

#include "core/base/translation.h"
#include "core/cameras/pasted_numbers.h"
#include "core/geometry/condition_number.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>
#include <utility>

namespace unprojector::cameras {
using namespace geometry;

namespace {

using Numbers = std::span<const PastedNumber>;
constexpr std::size_t kEntries = 16;

/// Returns whether the numbers come in four runs of four with different keys.
template <class Key>
bool isFourTimesFour(Numbers numbers, const Key &keyOf)
{
    std::set<std::size_t> keys;
    for (std::size_t i = 0; i < kEntries; ++i) {
        if (keyOf(numbers[i]) != keyOf(numbers[i - i % 4]))
            return false;
        keys.insert(keyOf(numbers[i]));
    }
    return keys.size() == 4;
}

bool anyWord(Numbers numbers, std::size_t count, std::string_view part)
{
    return std::any_of(numbers.begin(), numbers.begin() + std::ptrdiff_t(count), [&](const PastedNumber &n) {
        return std::any_of(n.words.begin(), n.words.end(),
                           [&](const std::string &word) { return word.find(part) != std::string::npos; });
    });
}

bool haveSubscripts(Numbers numbers, std::size_t count)
{
    return std::all_of(numbers.begin(), numbers.end(),
                       [&](const PastedNumber &n) { return n.subscripts.size() == count; });
}

/// Returns whether columns are named X, Y, Z and a fourth name, as Godot prints them.
bool areAxes(Numbers numbers, std::size_t rows, std::string_view fourth)
{
    const std::array<std::string_view, 4> names{"x", "y", "z", fourth};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::vector<std::string> &words = numbers[i * rows].words;
        if (words.empty() || words.back() != names[i])
            return false;
    }
    return true;
}

/// Completes twelve numbers to sixteen by the row 0 0 0 1: three rows of four, or Godot's four
/// columns of three.
void completeRows(std::vector<PastedNumber> &numbers)
{
    constexpr std::size_t kGiven = 12;
    if (numbers.size() != kGiven)
        return;
    const auto added = [&numbers](double value, std::size_t at) {
        PastedNumber number = numbers[at];
        number.value = value;
        number.words.clear();
        number.isBehindSemicolon = false;
        return number;
    };
    if (areAxes(numbers, 3, "o")) {
        std::vector<PastedNumber> columns;
        for (std::size_t i = 0; i < kGiven; ++i) {
            columns.push_back(numbers[i]);
            if (i % 3 == 2)
                columns.push_back(added(i == kGiven - 1 ? 1.0 : 0.0, i));
        }
        columns.front().words.emplace_back("vec4"); // by columns
        numbers = std::move(columns);
        return;
    }
    const auto areRows = [&numbers](const auto &keyOf) {
        for (std::size_t i = 1; i < kGiven; ++i) {
            if ((keyOf(numbers[i]) == keyOf(numbers[i - 1])) != (i % 4 != 0))
                return false;
        }
        return true;
    };
    const bool areSemicolonsBetween =
        std::count_if(numbers.begin(), numbers.end(), [](const PastedNumber &n) { return n.isBehindSemicolon; }) == 2;
    if (!areRows([](const PastedNumber &n) { return n.bracket; })
        && !areRows([](const PastedNumber &n) { return n.line; })
        && !(areSemicolonsBetween && numbers[4].isBehindSemicolon && numbers[8].isBehindSemicolon))
        return;
    for (const double value : {0.0, 0.0, 0.0, 1.0}) {
        PastedNumber number = added(value, kGiven - 1);
        number.line = numbers[kGiven - 1].line + 1;
        number.bracket =
            numbers[0].bracket == numbers[kGiven - 1].bracket ? numbers[0].bracket : numbers[kGiven - 1].bracket + 1;
        number.isBehindSemicolon = areSemicolonsBetween && numbers.size() == kGiven;
        numbers.push_back(std::move(number));
    }
}

MatrixForm formOf(Numbers numbers)
{
    if (haveSubscripts(numbers, 1))
        return MatrixForm::Indexed;
    if (haveSubscripts(numbers, 2))
        return MatrixForm::IndexPairs;
    // mat4x4((…), …), glm::dmat4(…), vec4(…)
    if (anyWord(numbers, kEntries, "mat4") || anyWord(numbers, kEntries, "vec4"))
        return MatrixForm::GlmColumns;
    if (isFourTimesFour(numbers, [](const PastedNumber &n) { return n.bracket; }))
        return areAxes(numbers, 4, "w") ? MatrixForm::GlmColumns : MatrixForm::NestedRows;
    bool areSemicolonsBetweenRows = true;
    for (std::size_t i = 1; i < kEntries; ++i)
        areSemicolonsBetweenRows = areSemicolonsBetweenRows && numbers[i].isBehindSemicolon == (i % 4 == 0);
    const bool isLineARow = isFourTimesFour(numbers, [](const PastedNumber &n) { return n.line; });
    const bool isBare = numbers.front().bracket == 0 || anyWord(numbers, 1, "matrix4x4");
    if (areSemicolonsBetweenRows || (isLineARow && isBare))
        return MatrixForm::RowLines;
    return MatrixForm::Flat;
}

/// Sorts the numbers by their subscripts if these give each a position; else keeps the text order.
PastedMatrix assembled(Numbers numbers)
{
    PastedMatrix matrix;
    matrix.form = formOf(numbers);
    matrix.isInverse = numbers.front().isInverse;
    matrix.part = numbers.front().part;
    matrix.name = numbers.front().partName;
    matrix.line = numbers.front().line;
    for (std::size_t i = 0; i < kEntries; ++i)
        matrix.numbers[i] = numbers[i].value;
    if (matrix.form != MatrixForm::Indexed && matrix.form != MatrixForm::IndexPairs)
        return matrix;
    // Some libraries count from 1: m11 to m44.
    int least = 16;
    for (const PastedNumber &n : numbers)
        least = std::min(least, *std::min_element(n.subscripts.begin(), n.subscripts.end()));
    std::array<bool, kEntries> isTaken{};
    PastedMatrix placed = matrix;
    for (const PastedNumber &n : numbers) {
        const int first = n.subscripts[0] - least;
        const int index = n.subscripts.size() == 1 ? first : 4 * first + n.subscripts[1] - least;
        const bool isEntry = index >= 0 && index < int(kEntries) && (n.subscripts.size() == 1 || first < 4);
        if (!isEntry || isTaken[std::size_t(index)])
            return matrix;
        isTaken[std::size_t(index)] = true;
        placed.numbers[std::size_t(index)] = n.value;
    }
    return placed;
}

struct Part {
    PastedPart part;
    std::vector<PastedNumber> numbers{};
    std::vector<PastedNumber> inverse{}; ///< numbers with the name of the inverse
    /// True if a viewport is given as its matrix, and for all other parts.
    bool isMatrix() const { return part != PastedPart::Viewport || numbers.size() == kEntries; }
    std::size_t wanted() const { return isMatrix() ? kEntries : 4; }
    bool isWhole() const { return part == PastedPart::ToWindow || numbers.size() == wanted(); }

    /// Keeps only the first of several matrices, each with a name of its own.
    /// @return whether there were several
    bool keepFirst()
    {
        if (numbers.size() <= kEntries || numbers.size() % kEntries != 0)
            return false;
        for (std::size_t i = 0; i < numbers.size(); i += kEntries) {
            if (numbers[i].words.empty())
                return false;
        }
        numbers.resize(kEntries);
        return true;
    }
};

constexpr std::array<PastedPart, 7> kParts{PastedPart::ModelView,  PastedPart::View,    PastedPart::Model,
                                           PastedPart::Projection, PastedPart::Product, PastedPart::Viewport,
                                           PastedPart::ToWindow};

class Parts {
public:
    Parts()
    {
        for (const PastedPart part : kParts)
            m_parts[std::size_t(part)].part = part;
    }
    Part &operator[](PastedPart part) { return m_parts[std::size_t(part)]; }
    bool has(PastedPart part) { return !(*this)[part].numbers.empty(); }

    /// The parts that make a scene, among those present.
    std::vector<PastedPart> needed()
    {
        const bool isWhole = has(PastedPart::Projection) && (has(PastedPart::ModelView) || has(PastedPart::View));
        if (has(PastedPart::Product) && !isWhole)
            return {PastedPart::Product, PastedPart::Viewport};
        const bool isViewAlone = has(PastedPart::View) && !has(PastedPart::ModelView);
        return {isViewAlone ? PastedPart::View : PastedPart::ModelView, PastedPart::Projection, PastedPart::Viewport};
    }

private:
    std::array<Part, kParts.size()> m_parts;
};

/// Assigns the numbers of an inverse to the part if it has no others; for the view, only if there
/// is no modelview either.
void sortInverses(Parts &parts)
{
    for (const PastedPart part : kParts) {
        const bool isTaken = parts.has(part) || (part == PastedPart::View && parts.has(PastedPart::ModelView));
        if (!isTaken)
            parts[part].numbers = std::exchange(parts[part].inverse, {});
    }
}

/// Drops numbers beside named matrices that have a name of no part, and the count of none: "camera pos: 1 2 3".
/// @param aside  gets their names
void dropOthers(std::vector<PastedNumber> &numbers, std::vector<std::string> &aside)
{
    const auto isOf = [&numbers](PastedPart part) {
        return std::ranges::any_of(numbers, [&](const PastedNumber &number) { return number.part == part; });
    };
    const bool isView = isOf(PastedPart::View) || isOf(PastedPart::ModelView);
    if (!isOf(PastedPart::Product) && !(isView && isOf(PastedPart::Projection)))
        return;
    std::vector<PastedNumber> kept;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end].words.empty() && numbers[end].part == numbers[i].part)
            ++end;
        const std::size_t count = end - i;
        const bool isOther =
            !numbers[i].part && !numbers[i].words.empty() && count != 4 && count != 12 && count != kEntries;
        if (isOther)
            aside.push_back(numbers[i].words.back());
        else
            std::move(numbers.begin() + std::ptrdiff_t(i), numbers.begin() + std::ptrdiff_t(end),
                      std::back_inserter(kept));
        i = end;
    }
    numbers = std::move(kept);
}

/// Assigns unnamed numbers to the first required part that is not full yet.
void sort(std::vector<PastedNumber> &numbers, Parts &parts)
{
    constexpr std::size_t kProductAndViewport = 20;
    const bool isUnnamed = std::none_of(numbers.begin(), numbers.end(), [](const auto &n) { return bool(n.part); });
    std::vector<PastedNumber> unnamed;
    for (PastedNumber &number : numbers) {
        if (number.part && number.isInverse)
            parts[*number.part].inverse.push_back(std::move(number));
        else if (number.part)
            parts[*number.part].numbers.push_back(std::move(number));
        else
            unnamed.push_back(std::move(number));
    }
    sortInverses(parts);
    // "VP = [0 0 800 600]"
    std::vector<PastedNumber> &product = parts[PastedPart::Product].numbers;
    if (product.size() == 4 && !parts.has(PastedPart::Viewport) && product[2].value > 0.0 && product[3].value > 0.0)
        parts[PastedPart::Viewport].numbers = std::exchange(product, {});
    for (const PastedPart part : kParts) {
        if (part != PastedPart::Viewport)
            completeRows(parts[part].numbers);
    }
    std::vector<PastedPart> needed = parts.needed();
    if (isUnnamed && unnamed.size() == kProductAndViewport)
        needed = {PastedPart::Product, PastedPart::Viewport};
    for (PastedNumber &number : unnamed) {
        const auto open = std::find_if(needed.begin(), needed.end(), [&](PastedPart part) {
            return parts[part].numbers.size() < parts[part].wanted();
        });
        parts[open == needed.end() ? needed.back() : *open].numbers.push_back(std::move(number));
    }
}

} // namespace

NumberOrder orderOf(MatrixForm form)
{
    switch (form) {
    case MatrixForm::Flat:
    case MatrixForm::Indexed:
    case MatrixForm::GlmColumns:
    case MatrixForm::Call: return NumberOrder::ByColumns;
    case MatrixForm::IndexPairs:
    case MatrixForm::RowLines:
    case MatrixForm::NestedRows: break;
    }
    return NumberOrder::ByRows;
}

NumberOrder opposite(NumberOrder order)
{
    return order == NumberOrder::ByColumns ? NumberOrder::ByRows : NumberOrder::ByColumns;
}

glm::dmat4 matrixOf(const std::array<double, 16> &numbers, NumberOrder order)
{
    glm::dmat4 m;
    for (int i = 0; i < int(kEntries); ++i) {
        const int outer = i / 4, inner = i % 4;
        (order == NumberOrder::ByRows ? m[inner][outer] : m[outer][inner]) = numbers[std::size_t(i)];
    }
    return m;
}

glm::dmat4 meantMatrix(const PastedMatrix &matrix, NumberOrder order)
{
    const glm::dmat4 m = matrixOf(matrix.numbers, order);
    return matrix.isInverse && !isSingular(m) ? glm::inverse(m) : m;
}

std::string inverseText(const PastedMatrix &matrix)
{
    return base::tr(isSingular(matrixOf(matrix.numbers, orderOf(matrix.form)))
                        ? "by its name it is an inverse, but it is singular: it is used unchanged"
                        : "by its name it is an inverse: it is inverted");
}

bool isWindowsOwn(const DepthRange &range)
{
    constexpr double kPrinted = 1e-6; // error of single precision
    return std::abs(range.atNear - 0.5) <= 0.5 + kPrinted && std::abs(range.atFar - 0.5) <= 0.5 + kPrinted;
}

ViewportAndDepths viewportOf(const glm::dmat4 &windowFromNdc, const std::optional<NdcDepth> &depth)
{
    const glm::dmat4 &m = windowFromNdc;
    const DepthRange fromMinusOne{m[3][2] - m[2][2], m[3][2] + m[2][2]}, fromZero{m[3][2], m[3][2] + m[2][2]};
    const bool isFromZero =
        depth ? *depth == NdcDepth::ZeroToOne : !isWindowsOwn(fromMinusOne) && isWindowsOwn(fromZero);
    return {{m[3][0] - m[0][0], m[3][1] - m[1][1], 2.0 * m[0][0], 2.0 * m[1][1]}, isFromZero ? fromZero : fromMinusOne};
}

const char *nameOf(PastedPart part)
{
    switch (part) {
    case PastedPart::ModelView: return "modelview";
    case PastedPart::View: return "view";
    case PastedPart::Model: return "model";
    case PastedPart::Projection: return "projection";
    case PastedPart::Product: return "product";
    case PastedPart::ToWindow: return "window";
    case PastedPart::Viewport: break;
    }
    return "viewport";
}

base::Error errorOf(const PasteError &error)
{
    const bool isAboutPart = !error.isOfCall && error.line == 0;
    return {.text = error.text,
            .subject = isAboutPart ? nameOf(error.part) : "",
            .line = int(error.line),
            .column = int(error.column)};
}

PasteError countError(PastedPart part, std::size_t found, std::size_t wanted, std::size_t all)
{
    PasteError error{
        base::tr(found == 1 ? "%1 number found, %2 are needed" : "%1 numbers found, %2 are needed", found, wanted)};
    if (part == PastedPart::Viewport)
        error.text += base::tr(": x y width height, or 16 of a matrix");
    error.part = part;
    error.found = found;
    error.wanted = wanted;
    error.all = all;
    return error;
}

Result<PastedMatrix, PasteError> pastedMatrix(std::string_view text)
{
    Result<PastedNumbers, PasteError> read = pastedNumbers(text);
    if (!read)
        return read.error();
    std::vector<PastedNumber> numbers = std::move(read).value().numbers;
    completeRows(numbers);
    if (numbers.size() == kEntries)
        return assembled(numbers);
    return countError(PastedPart::ModelView, numbers.size(), kEntries, numbers.size());
}

Result<PastedScene, PasteError> pastedParts(std::string_view text)
{
    Result<PastedNumbers, PasteError> read = pastedNumbers(text);
    if (!read)
        return read.error();
    Parts parts;
    PastedNumbers all = std::move(read).value();
    const std::size_t count = all.numbers.size();
    dropOthers(all.numbers, all.aside);
    sort(all.numbers, parts);
    PastedScene scene;
    scene.aside = std::move(all.aside);
    for (const PastedPart part : kParts) {
        if (parts[part].keepFirst())
            scene.more.push_back(part);
        if (!parts[part].inverse.empty())
            scene.inversesLeft.push_back(part);
        if (parts.has(part) && !parts[part].isWhole())
            return countError(part, parts[part].numbers.size(), parts[part].wanted(), count);
    }
    const auto matrix = [&parts](PastedPart part) -> std::optional<PastedMatrix> {
        if (!parts.has(part))
            return std::nullopt;
        return assembled(parts[part].numbers);
    };
    scene.modelView = matrix(PastedPart::ModelView);
    scene.view = matrix(PastedPart::View);
    scene.model = matrix(PastedPart::Model);
    scene.projection = matrix(PastedPart::Projection);
    scene.product = matrix(PastedPart::Product);
    const std::vector<PastedNumber> &viewport = parts[PastedPart::Viewport].numbers;
    if (viewport.size() == 4)
        scene.viewport = {viewport[0].value, viewport[1].value, viewport[2].value, viewport[3].value};
    else
        scene.viewportMatrix = matrix(PastedPart::Viewport);
    return scene;
}

} // namespace unprojector::cameras
