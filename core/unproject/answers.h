#pragma once

#include "core/geometry/result.h"
#include "core/geometry/spaces.h"

#include <array>
#include <cstddef>
#include <utility>

namespace unprojector::unproject {

/// The methods that compute a point. Code that computes or writes answers, as JSON and as CSV,
/// iterates over kMethods; code that compares two of them names them.
enum class Method {
    Formula,      ///< (9) to (12), without inverting a matrix; rounded once
    Matrix,       ///< the inverted matrix, as in gluUnProject
    MatrixInFloat ///< the same entirely in single precision, as in most programs
};
constexpr std::array kMethods{Method::Formula, Method::Matrix, Method::MatrixInFloat};

/// The name of a method in files: "formula", "matrix", "matrixInFloat".
constexpr const char *keyOf(Method method)
{
    switch (method) {
    case Method::Formula: return "formula";
    case Method::Matrix: return "matrix";
    case Method::MatrixInFloat: return "matrixInFloat";
    }
    return "";
}

/// One point of a space, by each method. Each holds its own error if it has no answer.
template <class Space>
class Answers {
public:
    /// Calls `by(method)` for each method.
    template <class By>
    static Answers of(const By &by)
    {
        return [&]<std::size_t... place>(std::index_sequence<place...>)
        {
            return Answers({by(kMethods[place])...});
        }
        (std::make_index_sequence<kMethods.size()>());
    }

    const geometry::Result<geometry::Point<Space>> &operator[](Method method) const
    {
        return m_of[static_cast<std::size_t>(method)];
    }

    /// formula - matrix.
    /// @pre both have an answer
    geometry::Vector<Space> difference() const { return *(*this)[Method::Formula] - *(*this)[Method::Matrix]; }

private:
    explicit Answers(std::array<geometry::Result<geometry::Point<Space>>, kMethods.size()> of) : m_of(std::move(of)) {}

    std::array<geometry::Result<geometry::Point<Space>>, kMethods.size()> m_of;
};

/// A window position unprojected by every method, to both spaces.
struct Unprojected {
    Answers<geometry::EyeSpace> eye;
    Answers<geometry::WorldSpace> world;
};

/// The spacing of doubles at the largest component of a point: the unit for differences of this
/// point. With a unit per component, the noise of a component near 0 would look enormous.
double ulpOfLargest(const geometry::Components<3> &point);

} // namespace unprojector::unproject
