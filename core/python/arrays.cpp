#include "core/python/arrays.h"

#include <algorithm>
#include <cstring>

namespace unprojector::python {
namespace {

bool isNative(const py::array &array, const char *kind)
{
    return array.dtype().equal(py::dtype(kind));
}

bool isAligned(const py::array &array)
{
    return (array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) != 0;
}

} // namespace

py::array_t<double> arrayOf(const glm::dvec3 &vector)
{
    return py::array_t<double>(3, &vector.x);
}

std::size_t Strides::add(Shape strides)
{
    m_strides.push_back(std::move(strides));
    return m_strides.size() - 1;
}

void Strides::join()
{
    Shape shape;
    std::vector<Shape> strides(m_strides.size());
    for (std::size_t axis = 0; axis < m_shape.size(); ++axis) {
        if (m_shape[axis] == 1)
            continue;
        // The last joined axis and this one are one if a step of the former is the whole of the latter.
        bool isOne = !shape.empty();
        for (std::size_t a = 0; isOne && a < m_strides.size(); ++a)
            isOne = strides[a].back() == m_strides[a][axis] * m_shape[axis];
        for (std::size_t a = 0; a < m_strides.size(); ++a) {
            if (isOne)
                strides[a].back() = m_strides[a][axis];
            else
                strides[a].push_back(m_strides[a][axis]);
        }
        if (isOne)
            shape.back() *= m_shape[axis];
        else
            shape.push_back(m_shape[axis]);
    }
    if (shape.empty()) { // of one element
        shape.push_back(1);
        for (Shape &own : strides)
            own.push_back(0);
    }
    m_shape = std::move(shape);
    m_strides = std::move(strides);
}

std::size_t Strides::size() const
{
    std::size_t size = 1;
    for (const py::ssize_t length : m_shape)
        size *= static_cast<std::size_t>(length);
    return size;
}

void Strides::eachRun(std::size_t begin, std::size_t count, const Run &run) const
{
    const std::size_t axes = m_shape.size(), arrays = m_strides.size();
    Shape offsets(arrays), steps(arrays);
    for (std::size_t a = 0; a < arrays; ++a)
        steps[a] = m_strides[a].back();
    while (count > 0) {
        std::fill(offsets.begin(), offsets.end(), py::ssize_t{0});
        std::size_t rest = begin;
        py::ssize_t last = 0;
        for (std::size_t axis = axes; axis-- > 0;) {
            const auto length = static_cast<std::size_t>(m_shape[axis]);
            const auto index = static_cast<py::ssize_t>(rest % length);
            rest /= length;
            if (axis + 1 == axes)
                last = index;
            for (std::size_t a = 0; a < arrays; ++a)
                offsets[a] += index * m_strides[a][axis];
        }
        const std::size_t size = std::min(count, static_cast<std::size_t>(m_shape.back() - last));
        run(offsets, steps, size);
        begin += size;
        count -= size;
    }
}

Numbers numbersOf(const char *name, const py::object &argument)
{
    py::array array = py::array::ensure(argument);
    if (!array) {
        PyErr_Clear();
        throw py::type_error(std::string(name) + " is no array of numbers");
    }
    const bool isDouble = isNative(array, "float64"), isFloat = isNative(array, "float32");
    if ((isDouble || isFloat) && isAligned(array))
        return {name, array, isFloat};
    const char kind = array.dtype().kind();
    if (kind != 'f' && kind != 'i' && kind != 'u')
        throw py::type_error(std::string(name) + " has the type " + std::string(py::str(array.dtype()))
                             + "; give float64, float32 or whole numbers");
    return {name, array.attr("astype")("float64"), false};
}

std::string shapeText(const Shape &shape)
{
    std::string text = "(";
    for (std::size_t i = 0; i < shape.size(); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
    return text + (shape.size() == 1 ? ",)" : ")");
}

Shape shapeOf(const py::array &array)
{
    return {array.shape(), array.shape() + array.ndim()};
}

void refuseShape(const char *name, const py::array &array, const std::string &give)
{
    throw py::value_error(std::string(name) + " has the shape " + shapeText(shapeOf(array)) + "; give " + give);
}

void requireRowsOfThree(const char *name, const py::array &array)
{
    if (array.ndim() != 2 || array.shape(1) != 3)
        refuseShape(name, array, "(n, 3)");
}

Shape broadcastShape(std::span<const Numbers> arguments)
{
    py::list arrays;
    std::string shapes;
    for (const Numbers &each : arguments) {
        arrays.append(each.array);
        shapes += std::string(shapes.empty() ? " " : ", ") + each.name + ' ' + shapeText(shapeOf(each.array));
    }
    try {
        const py::object together = py::module_::import("numpy").attr("broadcast")(*arrays);
        return together.attr("shape").cast<Shape>();
    } catch (const py::error_already_set &error) {
        if (!error.matches(PyExc_ValueError))
            throw;
        throw py::value_error("these shapes do not broadcast:" + shapes);
    }
}

namespace {

/// The strides of an array that is broadcast to a shape; 0 along repeated axes.
Shape broadcastStrides(const py::array &array, std::size_t axes)
{
    Shape strides(axes, 0);
    const auto own = static_cast<std::size_t>(array.ndim());
    for (std::size_t axis = 0; axis < own; ++axis) {
        const auto k = static_cast<py::ssize_t>(axis);
        strides[axes - own + axis] = array.shape(k) == 1 ? 0 : array.strides(k);
    }
    return strides;
}

/// False only where NumPy finds out quickly that no element is of both.
bool doOverlap(const py::array &a, const py::array &b)
{
    const py::object numpy = py::module_::import("numpy");
    if (!numpy.attr("may_share_memory")(a, b).cast<bool>())
        return false;
    constexpr int kMostWork = 100000; // beyond it, NumPy raises an exception
    try {
        return numpy.attr("shares_memory")(a, b, py::arg("max_work") = kMostWork).cast<bool>();
    } catch (const py::error_already_set &) {
        return true;
    }
}

} // namespace

py::array outputOf(const py::object &out, const Shape &shape, std::span<const Numbers> inputs)
{
    if (out.is_none())
        return py::array_t<double>(shape);
    if (!py::isinstance<py::array>(out))
        throw py::type_error("out is no NumPy array");
    auto array = py::reinterpret_borrow<py::array>(out);
    if (shapeOf(array) != shape)
        refuseShape("out", array, shapeText(shape));
    if ((!isNative(array, "float32") && !isNative(array, "float64")) || !isAligned(array))
        throw py::value_error("out has the type " + std::string(py::str(array.dtype())) + "; give float64 or float32");
    if (!array.writeable())
        throw py::value_error("out is read-only");
    for (const Numbers &input : inputs) {
        if (doOverlap(array, input.array))
            throw py::value_error(std::string("out shares memory with ") + input.name);
    }
    return array;
}

Input::Input(const Numbers &numbers, Strides &strides)
    : m_data(static_cast<const char *>(numbers.array.data())), m_isFloat(numbers.isFloat),
      m_index(strides.add(broadcastStrides(numbers.array, strides.axes())))
{
}

const double *Input::block(const Strides &strides, std::size_t begin, std::size_t count, double *scratch) const
{
    if (!m_isFloat && strides.isLine() && strides.lineStride(m_index) == py::ssize_t{sizeof(double)})
        return reinterpret_cast<const double *>(m_data) + begin;
    double *to = scratch;
    strides.eachRun(begin, count, [&](const auto &offsets, const auto &steps, std::size_t size) {
        const char *from = m_data + offsets[m_index];
        const auto copy = [&]<class Number>(const Number *) {
            for (std::size_t i = 0; i < size; ++i, from += steps[m_index])
                *to++ = static_cast<double>(*reinterpret_cast<const Number *>(from));
        };
        if (m_isFloat)
            copy(static_cast<const float *>(nullptr));
        else
            copy(static_cast<const double *>(nullptr));
    });
    return scratch;
}

Output::Output(py::array array, Strides &strides)
    : m_array(std::move(array)), m_data(static_cast<char *>(m_array.mutable_data())),
      m_isFloat(isNative(m_array, "float32")), m_width(m_array.shape(m_array.ndim() - 1)),
      m_componentStride(m_array.strides(m_array.ndim() - 1)),
      m_index(strides.add({m_array.strides(), m_array.strides() + m_array.ndim() - 1}))
{
}

double *Output::room(const Strides &strides, std::size_t begin, double *scratch) const
{
    constexpr auto kDouble = static_cast<py::ssize_t>(sizeof(double));
    const bool isInPlace = !m_isFloat && m_componentStride == kDouble && strides.isLine()
                           && (strides.lineStride(m_index) == m_width * kDouble || strides.size() <= 1);
    return isInPlace ? reinterpret_cast<double *>(m_data) + begin * static_cast<std::size_t>(m_width) : scratch;
}

void Output::write(const Strides &strides, std::size_t begin, std::size_t count, const double *vectors) const
{
    if (room(strides, begin, nullptr) != nullptr)
        return;
    strides.eachRun(begin, count, [&](const auto &offsets, const auto &steps, std::size_t size) {
        char *to = m_data + offsets[m_index];
        for (std::size_t i = 0; i < size; ++i, to += steps[m_index]) {
            for (py::ssize_t k = 0; k < m_width; ++k) {
                char *component = to + k * m_componentStride;
                if (m_isFloat)
                    *reinterpret_cast<float *>(component) = static_cast<float>(*vectors++);
                else
                    *reinterpret_cast<double *>(component) = *vectors++;
            }
        }
    });
}

} // namespace unprojector::python
