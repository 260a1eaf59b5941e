#pragma once

#include <glm/vec3.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Arrays of any strides, read and written block by block, so that none is copied as a whole.
namespace unprojector::python {

namespace py = pybind11;

/// A number for each axis of an array.
using Shape = std::vector<py::ssize_t>;

/// A vector or a matrix that acts on column vectors, by rows.
py::array_t<double> arrayOf(const glm::dvec3 &vector);
template <class Matrix>
py::array_t<double> arrayOf(const Matrix &matrix, bool isTransposed = false)
{
    constexpr auto kSize = static_cast<py::ssize_t>(Matrix::length());
    // The columns of GLM are rows in memory.
    py::array_t<double> array({kSize, kSize});
    for (py::ssize_t i = 0; i < kSize; ++i) {
        for (py::ssize_t j = 0; j < kSize; ++j)
            array.mutable_at(isTransposed ? i : j, isTransposed ? j : i) =
                matrix[static_cast<glm::length_t>(i)][static_cast<glm::length_t>(j)];
    }
    return array;
}

/// A shape, and for each array the bytes from one element to the next along each axis. Axes that
/// all arrays go through in one step are joined; at least one remains.
class Strides {
public:
    explicit Strides(Shape shape) : m_shape(std::move(shape)) {}
    /// @param strides  one for each axis of the shape
    /// @return the array's index
    std::size_t add(Shape strides);
    /// Joins axes. Call it after the last `add`.
    void join();

    std::size_t axes() const { return m_shape.size(); }
    std::size_t size() const;
    /// Calls run(offsets of the arrays, strides of the arrays, count) for runs of equal strides that
    /// cover the elements from begin on.
    using Run = std::function<void(const Shape &offsets, const Shape &strides, std::size_t count)>;
    void eachRun(std::size_t begin, std::size_t count, const Run &run) const;
    /// True if the elements of every array lie at equal distances: lineStride.
    bool isLine() const { return m_shape.size() == 1; }
    py::ssize_t lineStride(std::size_t array) const { return m_strides[array][0]; }

private:
    Shape m_shape;
    std::vector<Shape> m_strides; ///< of each array, an axis each
};

/// The numbers of an argument: an array of float64 or float32, of any strides.
struct Numbers {
    const char *name;
    py::array array;
    bool isFloat = false;
};

/// The array of an argument. Whole numbers and other floats are converted to float64.
/// @return TypeError for what is no array of numbers; it names the argument
Numbers numbersOf(const char *name, const py::object &argument);

/// The shape that arguments broadcast to.
/// @return ValueError; it names the shapes
Shape broadcastShape(std::span<const Numbers> arguments);

/// "(480, 640)".
std::string shapeText(const Shape &shape);
Shape shapeOf(const py::array &array);
/// @return ValueError: the array has a shape, and another one is to be given
[[noreturn]] void refuseShape(const char *name, const py::array &array, const std::string &give);
/// @return ValueError: the shape is not (n, 3)
void requireRowsOfThree(const char *name, const py::array &array);

/// The argument out, or a new array of float64 where it is None.
/// @return ValueError: another shape or type, read-only, or it lies on an input, which would be
///         overwritten before it is read
py::array outputOf(const py::object &out, const Shape &shape, std::span<const Numbers> inputs);

/// One input of a loop: hands out its numbers in blocks.
class Input {
public:
    /// @param strides  gets the array
    Input(const Numbers &numbers, Strides &strides);

    /// The numbers from `begin` on as doubles: in place where they lie so, else in `scratch`. The
    /// stride of the array is the loop's; the GIL is not needed.
    const double *block(const Strides &strides, std::size_t begin, std::size_t count, double *scratch) const;

private:
    const char *m_data;
    bool m_isFloat;
    std::size_t m_index;
};

/// An output with vectors along its last axis, of any strides.
class Output {
public:
    /// @param array    of float64 or float32
    /// @param strides  gets the array
    Output(py::array array, Strides &strides);

    const py::array &array() const { return m_array; }

    /// Room for the vectors of a block: in place where they lie so, else `scratch`.
    double *room(const Strides &strides, std::size_t begin, double *scratch) const;
    /// Writes the vectors of a block from there, unless they lie in place.
    void write(const Strides &strides, std::size_t begin, std::size_t count, const double *vectors) const;

private:
    py::array m_array;
    char *m_data;
    bool m_isFloat;
    py::ssize_t m_width, m_componentStride;
    std::size_t m_index;
};

} // namespace unprojector::python
