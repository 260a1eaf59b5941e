#pragma once

#include "core/geometry/result.h"
#include "core/geometry/spaces.h"

#include <array>
#include <cstddef>
#include <utility>

namespace unprojector::unproject {

/// The ways to a point. What computes and what writes answers, as JSON and as CSV, goes through kMethods; what compares
/// two of them side by side names them.
enum class Method {
    Formula,      ///< (9) to (12), no matrix is inverted; rounded once
    Matrix,       ///< the inverted matrix, as gluUnProject does it
    MatrixInFloat ///< the same wholly in single precision, as most programs do
};
constexpr std::array kMethods{Method::Formula, Method::Matrix, Method::MatrixInFloat};

/// The name that files call a method by: "formula", "matrix", "matrixInFloat".
constexpr const char *keyOf(Method method)
{
    switch (method) {
    case Method::Formula: return "formula";
    case Method::Matrix: return "matrix";
    case Method::MatrixInFloat: return "matrixInFloat";
    }
    return "";
}

/// One point of a space, by each method. Each says for itself why it has no answer.
template <class Space>
class Answers {
public:
    /// Asks `by(method)` for each method.
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

/// The spacing of doubles at the largest component of a point: the unit that differences of this point are
/// counted in. Counting each component in its own unit would call the noise of a component near 0 enormous.
double ulpOfLargest(const geometry::Components<3> &point);

} // namespace unprojector::unproject
