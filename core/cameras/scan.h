#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// A number of a text with its place.
struct ScannedNumber {
    /// NaN or infinite if the text has no finite number here: nan, 1.#QNAN, 1e400, 3 - 5, --2, 0.1q3, or a word of a
    /// list, [0, null, 1].
    double value = 0.0;
    bool isInWord = false;            ///< one of 800x600, or 50mm
    bool isBehindSemicolon = false;   ///< a semicolon stands between it and the number before it
    std::size_t at = 0, length = 0;   ///< its bytes in the text
    std::size_t line = 0;             ///< from 1
    std::size_t bracket = 0;          ///< the number of its innermost bracket pair, counted as they open; 0: none
    std::vector<int> subscripts = {}; ///< m[3] = 1: {3}; m(0,1) = 1 and m01 = 1: {0, 1}; those above 16 are left out
    bool isOperand = false;           ///< what the text computes with is no value: the 2 of "1280 / 2"
};

enum class GroupKind {
    Name, ///< the numbers up to the next name are its values: "near clip plane: 0.3"
    Word, ///< a value: 'AUTO'
    Other ///< a type or function before brackets, np.array(, or words of a comment
};

/// Group::arithmetic of R's matrix(c(...)) without byrow: its numbers are by columns.
inline constexpr std::string_view kByColumns = "by columns";

/// Adjacent words of a text, and the numbers between them and the next ones.
struct Group {
    std::string_view name; ///< as written: "cam.nearClipPlane"; the first group has none
    GroupKind kind = GroupKind::Name;
    std::size_t line = 0;                    ///< from 1
    std::string arithmetic = {};             ///< what the text computes with a name's values: "/ 1000", ".T"
    std::vector<ScannedNumber> numbers = {}; ///< without those of comments
    std::string unit = {};                   ///< behind a name's values: "mm", letters such as "g"; "mm m" for several
};

/// The words and numbers of any text, in its order: JSON, YAML, XML, source code and printed
/// arrays. What printing adds is skipped: sizes (Array(16), 4×4 Matrix), labels of rows and
/// columns, addresses, times, and the second and third name of a component in a debugger (x = 1,
/// r = 1, s = 1). Applied: MATLAB's common factor, "1.0e+03 *", decimal commas, exponents of
/// Fortran, Mathematica and LaTeX, np.radians(60), np.pi / 3, math.sqrt(2), np.eye(3), and
/// assignments of several names, fx, fy = 600, 610.
/// Throws a base::Error for a text of more than half a million names.
/// @return views of the text
std::vector<Group> scan(std::string_view text);

/// The text with blanks for the comments that no sign in a line begins: ; and rem lines, and
/// Python's docstrings.
std::string withoutRemarks(std::string_view text);

/// The letters and digits of a name in lower case: "nearclip" of "near_Clip".
std::string plain(std::string_view name);
/// The words of names in lower case, split at marks, between digits and letters, and at changes of case:
/// "inv_viewMatrix" has "inv", "view" and "matrix". The 2 of "world2cam" is the word "to".
std::vector<std::string> wordsOf(std::string_view names);
/// The part of "camera.data.lens", "cam->lens" or "cv::Mat" behind the last dot, arrow or colon.
std::string_view lastPart(std::string_view path);

} // namespace unprojector::cameras
