#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

/// Arrays of any strides, read and written block by block, so that none is copied as a whole.
namespace unprojector::python {

namespace py = pybind11;

/// A shape, and for each array the bytes from one element to the next along each axis. Axes that
/// all arrays go through in one step are joined.
class Strides {
public:
    explicit Strides(std::vector<py::ssize_t> shape) : m_shape(std::move(shape)) {}
    /// @param strides  one for each axis of the shape
    /// @return the array's index
    std::size_t add(std::vector<py::ssize_t> strides);
    /// Joins axes. Call it after the last `add`.
    void join();

    std::size_t axes() const { return m_shape.size(); }
    std::size_t size() const;
    /// Calls run(offsets of the arrays, strides of the arrays, count) for runs of equal strides that
    /// cover the elements from begin on.
    using Run = std::function<void(const std::vector<py::ssize_t> &offsets, const std::vector<py::ssize_t> &strides,
                                   std::size_t count)>;
    void eachRun(std::size_t begin, std::size_t count, const Run &run) const;
    /// True if the elements of every array lie at equal distances: lineStride.
    bool isLine() const { return m_shape.size() <= 1; }
    py::ssize_t lineStride(std::size_t array) const { return m_shape.empty() ? 0 : m_strides[array][0]; }

private:
    std::vector<py::ssize_t> m_shape;
    std::vector<std::vector<py::ssize_t>> m_strides; ///< of each array, an axis each
};

/// The numbers that a caller gave: an array of float64 or float32, of any strides.
struct Numbers {
    py::array array;
    bool isFloat = false;
};

/// The array of an argument. Whole numbers and other floats are converted to float64.
/// @return TypeError for what is no array of numbers; it names the argument
Numbers numbersOf(const char *name, const py::object &argument);

/// The shape that arguments broadcast to.
/// @return ValueError; it names the shapes
std::vector<py::ssize_t> broadcastShape(std::initializer_list<std::pair<const char *, const py::array *>> arguments);

/// "(480, 640)".
std::string shapeText(const std::vector<py::ssize_t> &shape);
std::vector<py::ssize_t> shapeOf(const py::array &array);

/// The strides of an array that is broadcast to a shape; 0 along repeated axes.
std::vector<py::ssize_t> broadcastStrides(const py::array &array, std::size_t axes);

/// @return ValueError: an output lies on an input, which would be overwritten before it is read
void refuseOverlap(const char *name, const py::array &output,
                   std::initializer_list<std::pair<const char *, const py::array *>> inputs);

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
    /// @param given   out= of the caller, or None: a new array of float64
    /// @param shape   of the array without its last axis
    /// @param width   of the last axis
    /// @return ValueError: another shape or type, read-only
    Output(const char *name, const py::object &given, const std::vector<py::ssize_t> &shape, py::ssize_t width);

    void addTo(Strides &strides);
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
    std::size_t m_index = 0;
};

} // namespace unprojector::python
