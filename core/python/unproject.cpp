#include "unprojector/unproject.h"

#include "core/python/arrays.h"
#include "core/python/loops.h"

#include <array>
#include <optional>
#include <string>

namespace unprojector::python {
namespace {

constexpr const char *kUnprojectHelp = R"(The points under pixels.

unproject(px, py, depth, *, method="formula", space="world", uncertainty=False,
          depth_bits=24, exact=True, out=None, threads=None)

px, py : array_like
    Device pixels. The origin is the top-left corner, y points down, and the
    centre of pixel (i, j) is (i + 0.5, j + 0.5).
depth : array_like
    Window depths, in the setup's depth range.
method : "formula" or "matrix"
    The closed-form inverse formulas, or the inverted matrix as in gluUnProject.
space : "world" or "eye"
    The space of the points.
uncertainty : bool
    Whether to return the uncertainty too.
depth_bits : int or "float"
    The depth buffer that the depths come from, for the uncertainty: 16, 24 or 32
    bits, or single precision.
exact : bool
    True: the digits of `unproject points`, computed with about 30 digits and
    rounded once. The formulas give the double nearest to the truth, at every
    position. The inverted matrix loses the digits that rounding to the doubles of
    its elements loses: up to five with near : far = 0.1 : 10000.
    False: plain double, as in `unproject cloud --precision double`, about twice as
    fast; 8 units in the last place of the largest coordinate for 99.99 % of the
    points of a usual setup.
out : array of shape (..., 3), float64 or float32, optional
    Receives the points.
threads : int, optional
    The maximum number of threads; None: all cores.

px, py and depth are broadcast. float64 and float32 arrays of any strides are read
in place.

Returns the points, float64 of shape (..., 3); with uncertainty, a tuple of the points
and their uncertainties. The uncertainty bounds the error of each coordinate that
comes from the rounding of the depth in the depth buffer, and of exact=True. The errors
of a rasteriser, and of exact=False, are not included.

A point is (nan, nan, nan) where its depth is outside the depth range, a number is
not finite, or the point is at infinity.)";

constexpr const char *kDepthBits = "1 to 32, or \"float\"";

DepthBuffer depthBufferOf(const py::object &bits)
{
    DepthBuffer buffer;
    if (py::isinstance<py::str>(bits)) {
        buffer.isFloat = true;
        if (bits.cast<std::string>() != "float")
            throw py::value_error("depth_bits is \"" + bits.cast<std::string>() + "\"; give " + kDepthBits);
    } else {
        const py::ssize_t number = wholeNumberOf("depth_bits", bits, kDepthBits);
        buffer.bits = static_cast<int>(number);
        if (buffer.bits != number)
            throw py::value_error("depth_bits is " + std::string(py::str(bits)) + "; give " + kDepthBits);
    }
    return buffer;
}

py::object unproject(const Setup &setup, const py::object &pixelX, const py::object &pixelY, const py::object &depth,
                     const std::string &method, const std::string &space, bool hasUncertainty,
                     const py::object &depthBits, bool isExact, const py::object &out, const py::object &threads)
{
    UnprojectOptions options;
    options.method = methodOf(method);
    options.space = spaceOf(space);
    options.digits = isExact ? Digits::Exact : Digits::Double;
    options.depthBuffer = depthBufferOf(depthBits);
    const std::size_t most = threadsOf(threads);
    const Unprojection unprojection = valueOrRaise(Unprojection::of(setup, options));
    if (hasUncertainty && !unprojection.hasUncertainty())
        throw py::value_error(
            "uncertainty: the matrix is no perspective and no parallel projection: its points have no uncertainty");

    const std::array<Numbers, 3> given{numbersOf("px", pixelX), numbersOf("py", pixelY), numbersOf("depth", depth)};
    Shape shape = broadcastShape(given);
    Strides strides(shape);
    shape.push_back(3);
    const Input x(given[0], strides), y(given[1], strides), d(given[2], strides);
    const Output points(outputOf(out, shape, given), strides);
    std::optional<Output> bounds;
    if (hasUncertainty)
        bounds.emplace(py::array_t<double>(shape), strides);
    strides.join();

    constexpr std::size_t kTask = std::size_t{1} << 15; // about 0.3 ms
    inBlocks(strides.size(), kTask, most, [&](std::size_t begin, std::size_t count) {
        std::array<double, kBlock> xs, ys, ds;
        std::array<double, 3 * kBlock> results, uncertainties;
        double *const to = points.room(strides, begin, results.data());
        double *const boundsTo = bounds ? bounds->room(strides, begin, uncertainties.data()) : nullptr;
        unprojection(x.block(strides, begin, count, xs.data()), y.block(strides, begin, count, ys.data()),
                     d.block(strides, begin, count, ds.data()), to, count, boundsTo);
        points.write(strides, begin, count, results.data());
        if (bounds)
            bounds->write(strides, begin, count, uncertainties.data());
    });
    if (bounds)
        return py::make_tuple(points.array(), bounds->array());
    return points.array();
}

} // namespace

void bindUnproject(SetupClass &setup)
{
    setup.def("unproject", &unproject, py::arg("px"), py::arg("py"), py::arg("depth"), py::kw_only(),
              py::arg("method") = "formula", py::arg("space") = "world", py::arg("uncertainty") = false,
              py::arg("depth_bits") = 24, py::arg("exact") = true, py::arg("out") = py::none(),
              py::arg("threads") = py::none(), kUnprojectHelp);
}

} // namespace unprojector::python
