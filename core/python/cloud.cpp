#include "unprojector/cloud.h"

#include "core/python/arrays.h"
#include "core/python/loops.h"

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace unprojector::python {
namespace {

constexpr const char *kCloudHelp = R"(The points under the pixels of a depth image.

cloud(depth, *, depth_is, scale=None, baseline=None, disparity_offset=None,
      no_data=None, method="formula", out=None, dtype=None, counts=False, threads=None)

depth : array of shape (..., height, width)
    A depth image of the setup's size, or a stack of them: uint8, uint16, other whole
    numbers, float32 or float64, of any strides. It is read in place.
depth_is : str
    "buffer"     window depths, in the setup's depth range; uint8 and uint16 are shares
                 of 255 and 65535
    "range"      0 to 1 over the setup's depth range
    "z"          distances from the eye along the view axis
    "distance"   distances from the eye along the pixel's ray
    "disparity"  pixels between two cameras side by side:
                 z = fx baseline / (disparity + disparity_offset)
scale : float, optional
    The numbers are divided by it: 1000 for millimetres in a world of metres.
baseline : float, optional
    The distance of the two cameras of a disparity, world units.
disparity_offset : float, optional
    Pixels: the second camera's cx less the first's, as doffs of Middlebury.
no_data : float or list of floats, optional
    Numbers of the image that mean no measurement, before the scale: 65535 in many
    images of 16 bits.
method : "formula" or "matrix"
    See unproject.
out : array of shape (..., height, width, 3), float32 or float64, optional
    Receives the points.
dtype : float64 or float32, optional
    The type of a new array; None: float64.
counts : bool
    Whether to return the number of pixels without a point, too.
threads : int, optional
    The maximum number of threads; None: all cores.

Returns world coordinates of shape (..., height, width, 3): nan for a pixel without a
point, where nothing was measured, or that lies before the near plane, on the far plane
or behind it. With counts, a tuple of the points and a dict: "kept", "zero", "nan",
"infinite", "negative", "before near", "at far", "outside range", "no data".

A UserWarning says that no pixel has a point. The digits are those of `unproject cloud`.)";

/// A depth image of any strides.
struct Depths {
    py::array array;
    NumberType type = NumberType::Float64;
    bool isConverted = false;

    /// Copies numbers of a row.
    template <class Target>
    void read(const char *row, py::ssize_t step, std::span<Target> numbers) const
    {
        const auto copy = [&]<class Number>(const Number *) {
            for (Target &number : numbers) {
                number = static_cast<Target>(*reinterpret_cast<const Number *>(row));
                row += step;
            }
        };
        switch (isConverted ? NumberType::Float64 : type) {
        case NumberType::Uint8: return copy(static_cast<const std::uint8_t *>(nullptr));
        case NumberType::Uint16: return copy(static_cast<const std::uint16_t *>(nullptr));
        case NumberType::Int32: return copy(static_cast<const std::int32_t *>(nullptr));
        case NumberType::Float32: return copy(static_cast<const float *>(nullptr));
        case NumberType::Float64: return copy(static_cast<const double *>(nullptr));
        }
    }
    /// Numbers of a row: in place where they are floats one after the other, else copied.
    std::span<const float> floats(const char *row, py::ssize_t step, std::span<float> scratch) const
    {
        if (type == NumberType::Float32 && step == py::ssize_t{sizeof(float)})
            return {reinterpret_cast<const float *>(row), scratch.size()};
        read(row, step, scratch);
        return scratch;
    }
};

/// The counts, under their names in the result.
struct NamedCount {
    const char *name;
    std::size_t CloudCounts::*count;
};
constexpr NamedCount kCounts[] = {
    {"kept", &CloudCounts::kept},         {"zero", &CloudCounts::zero},
    {"nan", &CloudCounts::notANumber},    {"infinite", &CloudCounts::infinite},
    {"negative", &CloudCounts::negative}, {"before near", &CloudCounts::beforeNear},
    {"at far", &CloudCounts::atFar},      {"outside range", &CloudCounts::outsideRange},
    {"no data", &CloudCounts::noData},
};

Depths depthsOf(const py::object &argument)
{
    Depths depths{py::array::ensure(argument)};
    if (!depths.array) {
        PyErr_Clear();
        throw py::type_error("depth is no array of numbers");
    }
    constexpr std::array kTypes{"uint8", "uint16", "int32", "float32", "float64"}; // in the order of NumberType
    const bool isAligned = py::cast<bool>(depths.array.attr("flags").attr("aligned"));
    for (std::size_t i = 0; i < kTypes.size(); ++i) {
        if (isAligned && depths.array.dtype().equal(py::dtype(kTypes[i]))) {
            depths.type = static_cast<NumberType>(i);
            return depths;
        }
    }
    const char kind = depths.array.dtype().kind();
    const py::ssize_t size = depths.array.dtype().itemsize();
    if (kind == 'u' && size <= 2)
        depths.type = size == 1 ? NumberType::Uint8 : NumberType::Uint16;
    else
        depths.type = kind == 'f' ? (size == 4 ? NumberType::Float32 : NumberType::Float64) : NumberType::Int32;
    depths.array = numbersOf("depth", depths.array).array;
    // numbersOf keeps single precision only where it is aligned and native; then it was taken above.
    depths.isConverted = true;
    return depths;
}

/// The rows of an array's images: strides of all axes but the last two, and of those.
struct Rows {
    explicit Rows(const py::array &array, py::ssize_t lastAxes)
        : shape(array.shape(), array.shape() + array.ndim() - lastAxes),
          strides(array.strides(), array.strides() + array.ndim() - lastAxes)
    {
    }
    /// The offset of a row, counted through all images.
    py::ssize_t offset(std::size_t row) const
    {
        py::ssize_t sum = 0;
        for (std::size_t axis = shape.size(); axis-- > 0;) {
            const auto length = static_cast<std::size_t>(shape[axis]);
            sum += static_cast<py::ssize_t>(row % length) * strides[axis];
            row /= length;
        }
        return sum;
    }

    Shape shape, strides;
};

/// Receives the points of a row in an array of any strides.
template <class Scalar>
class PointRows {
public:
    explicit PointRows(py::array &array)
        : m_rows(array, 2), m_data(static_cast<char *>(array.mutable_data())), m_pixel(array.strides(array.ndim() - 2)),
          m_component(array.strides(array.ndim() - 1))
    {
    }
    bool areDense() const { return m_component == py::ssize_t{sizeof(Scalar)} && m_pixel == 3 * m_component; }
    Scalar *at(std::size_t row, std::size_t first) const
    {
        return reinterpret_cast<Scalar *>(m_data + m_rows.offset(row) + static_cast<py::ssize_t>(first) * m_pixel);
    }
    void write(std::size_t row, std::size_t first, const Scalar *points, std::size_t count) const
    {
        char *to = reinterpret_cast<char *>(at(row, first));
        for (std::size_t i = 0; i < count; ++i, to += m_pixel) {
            for (py::ssize_t k = 0; k < 3; ++k)
                *reinterpret_cast<Scalar *>(to + k * m_component) = *points++;
        }
    }

private:
    Rows m_rows;
    char *m_data;
    py::ssize_t m_pixel, m_component;
};

struct Outcome {
    bool hasPoint = false;
    CloudCounts counts;
};

template <class Scalar>
Outcome computed(const Cloud &cloud, const Depths &depths, py::array &points, bool hasCounts, std::size_t threads)
{
    const Rows rows(depths.array, 1);
    const PointRows<Scalar> results(points);
    const auto *data = static_cast<const char *>(depths.array.data());
    const py::ssize_t step = depths.array.strides(depths.array.ndim() - 1);
    std::size_t count = 1;
    for (const py::ssize_t length : rows.shape)
        count *= static_cast<std::size_t>(length);
    const auto width = static_cast<std::size_t>(cloud.width()), height = static_cast<std::size_t>(cloud.height());
    const bool takesFloats = cloud.canTakeFloats() && !depths.isConverted;
    std::atomic<bool> hasPoint = false;
    std::mutex mutex;
    CloudCounts counts;
    const py::gil_scoped_release released;
    constexpr std::size_t kTask = 16; // rows
    base::inParallelRanges(
        count, kTask, {},
        [&](std::size_t begin, std::size_t end) {
            std::vector<double> numbers;
            std::vector<float> floats(kBlock);
            std::vector<Scalar> scratch(3 * kBlock);
            CloudCounts own;
            bool hasOwn = false;
            for (std::size_t row = begin; row < end; ++row) {
                const char *const from = data + rows.offset(row);
                if (hasCounts) {
                    numbers.resize(width);
                    depths.read(from, step, std::span(numbers));
                    cloud.count(row % height, numbers, own);
                }
                for (std::size_t first = 0; first < width; first += kBlock) {
                    const std::size_t size = std::min(kBlock, width - first);
                    const char *const start = from + static_cast<py::ssize_t>(first) * step;
                    Scalar *const to = results.areDense() ? results.at(row, first) : scratch.data();
                    if (takesFloats) {
                        cloud.row(row % height, first, depths.floats(start, step, std::span(floats).first(size)), to);
                    } else {
                        numbers.resize(size);
                        depths.read(start, step, std::span(numbers));
                        cloud.row(row % height, first, numbers, to);
                    }
                    for (std::size_t i = 0; !hasOwn && i < size; ++i)
                        hasOwn = !std::isnan(to[3 * i]);
                    if (!results.areDense())
                        results.write(row, first, to, size);
                }
            }
            if (hasOwn)
                hasPoint = true;
            const std::lock_guard lock(mutex);
            for (const NamedCount &each : kCounts)
                counts.*each.count += own.*each.count;
        },
        threads);
    return {hasPoint, counts};
}

py::object cloudOf(const Setup &setup, const py::object &depth, const std::string &depthIs, std::optional<double> scale,
                   std::optional<double> baseline, std::optional<double> disparityOffset,
                   const std::optional<std::variant<double, std::vector<double>>> &noData, const std::string &method,
                   const py::object &out, const py::object &dtype, bool hasCounts, const py::object &threads)
{
    const Depths depths = depthsOf(depth);
    CloudOptions options;
    options.depthIs = valueOf<DepthIs>("depth_is", depthIs, {"buffer", "range", "z", "distance", "disparity"});
    options.scale = scale;
    options.baseline = baseline;
    options.disparityOffset = disparityOffset;
    if (noData)
        options.noData = noData->index() == 0 ? std::vector{std::get<0>(*noData)} : std::get<1>(*noData);
    options.method = methodOf(method);
    options.type = depths.type;
    const std::size_t most = threadsOf(threads);
    const Cloud cloud = valueOrRaise(Cloud::of(setup, options));
    Shape shape = shapeOf(depths.array);
    const std::size_t axes = shape.size();
    if (axes < 2 || shape[axes - 2] != cloud.height() || shape[axes - 1] != cloud.width())
        throw py::value_error("depth has the shape " + shapeText(shape) + "; the setup's window has "
                              + std::to_string(cloud.height()) + " rows and " + std::to_string(cloud.width())
                              + " columns");
    shape.push_back(3);
    py::array points;
    if (out.is_none()) {
        const py::dtype type = dtype.is_none() ? py::dtype("float64") : py::dtype::from_args(dtype);
        if (!type.equal(py::dtype("float64")) && !type.equal(py::dtype("float32")))
            throw py::value_error("dtype is " + py::str(static_cast<const py::handle &>(type)).cast<std::string>()
                                  + "; give float64 or float32");
        points = py::array(type, shape);
    } else {
        if (!dtype.is_none())
            throw py::value_error("out has a type of its own; leave dtype out");
        const Numbers input{"depth", depths.array};
        points = outputOf(out, shape, {&input, 1});
    }
    const Outcome outcome = points.dtype().equal(py::dtype("float32"))
                                ? computed<float>(cloud, depths, points, hasCounts, most)
                                : computed<double>(cloud, depths, points, hasCounts, most);
    if (!outcome.hasPoint && depths.array.size() > 0)
        warn("no pixel has a point; check depth_is, scale, near and far");
    if (!hasCounts)
        return points;
    py::dict counts;
    for (const NamedCount &each : kCounts)
        counts[each.name] = outcome.counts.*each.count;
    return py::make_tuple(points, counts);
}

} // namespace

void bindCloud(py::module_ &module, SetupClass &setup)
{
    setup.def("cloud", &cloudOf, py::arg("depth"), py::kw_only(), py::arg("depth_is"), py::arg("scale") = py::none(),
              py::arg("baseline") = py::none(), py::arg("disparity_offset") = py::none(),
              py::arg("no_data") = py::none(), py::arg("method") = "formula", py::arg("out") = py::none(),
              py::arg("dtype") = py::none(), py::arg("counts") = false, py::arg("threads") = py::none(), kCloudHelp);
    module.def(
        "read_depth",
        [](const std::filesystem::path &file, const std::string &channel, const std::string &byteOrder) {
            std::optional<std::endian> order;
            if (!byteOrder.empty())
                order =
                    valueOf<bool>("byte_order", byteOrder, {"little", "big"}) ? std::endian::big : std::endian::little;
            const DepthImage image = withoutGil([&] { return readDepth(file, channel, order); });
            for (const std::string &note : image.notes)
                warn(note);
            return std::visit(
                [&image](const auto &numbers) -> py::array {
                    using Number = typename std::remove_cvref_t<decltype(numbers)>::value_type;
                    return py::array_t<Number>({image.height, image.width}, numbers.data());
                },
                image.numbers);
        },
        py::arg("file"), py::kw_only(), py::arg("channel") = "", py::arg("byte_order") = "",
        R"(The numbers of a depth image.

read_depth(file, *, channel="", byte_order="")

file : path
    PNG, TIFF, OpenEXR, PFM, PGM, COLMAP's .bin or NumPy's .npy, by its contents.
channel : str
    The channel of OpenEXR. Empty: the one named Z or depth.
byte_order : str
    "little" or "big", of a PGM of 16 bits. Empty: big, as the format has it.

Returns an array of shape (height, width) in the type of the file: uint8, uint16,
float32 or float64. What was chosen or ignored is a UserWarning.)");
}

} // namespace unprojector::python
