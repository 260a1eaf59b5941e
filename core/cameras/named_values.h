#pragma once

#include "core/base/error.h"
#include "core/cameras/scan.h"

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// A name in a printed text with the values behind it.
struct NamedValue {
    std::vector<std::string> words; ///< of the name, letters and digits in lower case: {"near", "clipplane"}
    std::string written;            ///< the name as in the text: "cam.nearClipPlane"
    std::string parent;             ///< the last name before it that has no values: "location" of "Location: X=1 Y=2"
    std::string word;               ///< the value, if it is of words: "HORIZONTAL"
    std::vector<double> numbers;    ///< the values up to the next name
    std::size_t line = 0;           ///< of the name, from 1
    std::size_t at = 0;             ///< of the name in the text
    std::string arithmetic{};       ///< what the text computes with the values: "/ 1000", ".T"; empty: nothing
    std::string unit{};             ///< behind the values, see Group
    std::string decimal{};          ///< two numbers that may be one with a decimal comma: "600,5"
    /// The error of a value that the text computes with.
    base::Error computedError() const;
    /// The first number, with * and / applied.
    /// Throws a base::Error where the text computes with it otherwise, or it may have a decimal comma.
    double number() const;
    bool isNamed(std::string_view name) const; ///< by all its words or by its last ones
};

/// The names and values of any text, see scan(): "fov = 60", "near clip plane: 0.3", "lens 50 mm",
/// "Location X=1 Y=2 Z=3", "matrix_world = Matrix(((…), (…)))", JSON, YAML, XML. Skips comments, and
/// names of types before brackets. nan and inf count as numbers, so no other number takes their
/// position.
class NamedValues {
public:
    explicit NamedValues(std::string_view text);

    /// The first value under a name; null if there is none. Names are letters and digits in lower
    /// case: "nearclipplane" finds near_clip_plane too.
    /// @param fewest  numbers that the value has
    const NamedValue *find(std::string_view name, std::size_t fewest = 0) const;
    bool has(std::string_view name) const { return find(name) != nullptr; }
    /// A value of at least `count` numbers under a name, or one number under each component of the
    /// name: "position: {x: 1, y: 2, z: 3}". Empty if there is neither.
    /// Throws a base::Error for numbers that the text computes with.
    std::vector<double> numbers(std::string_view name, std::size_t count,
                                std::initializer_list<std::string_view> components = {}) const;

    /// Returns whether the first value under a name is True, true or a number other than 0.
    bool isTrue(std::string_view name) const;

    /// All values in their order. The first one has no name: the numbers before any name.
    const std::vector<NamedValue> &all() const { return m_values; }

private:
    std::vector<NamedValue> m_values;
};

} // namespace unprojector::cameras
