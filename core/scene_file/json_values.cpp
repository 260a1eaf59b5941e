#include "core/scene_file/json_values.h"

#include "core/base/path_text.h"
#include "core/geometry/condition_number.h"
#include "core/scene_file/strict_json.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::scene_file {
using namespace geometry;
using namespace base;
namespace {

using Json = nlohmann::ordered_json;

Json numbersJson(std::span<const double> numbers)
{
    Json json = Json::array();
    for (const double number : numbers)
        json.push_back(jsonNumber(number));
    return json;
}

template <class Vector>
Json vectorJson(const Vector &v)
{
    return numbersJson({glm::value_ptr(v), static_cast<std::size_t>(Vector::length())});
}

void failDepth(const JsonNode &node, std::vector<std::string> choices)
{
    SceneFileError error;
    error.code = SceneFileErrorCode::UnknownChoice;
    error.foundKind = JsonKind::Array;
    error.found = shortened(compactJson(node.json()));
    error.choices = std::move(choices);
    node.fail(std::move(error));
}

} // namespace

void Plain::read(const JsonNode &node, std::filesystem::path &value)
{
    const std::string text = node.text();
    if (node.failed())
        return;
    if (text.empty() || text.find('\0') != std::string::npos)
        return node.fail(SceneFileErrorCode::BadFileName);
    value = pathFromUtf8(text);
}

void Plain::read(const JsonNode &node, glm::dvec2 &value)
{
    node.numbers(glm::value_ptr(value), 2, JsonKind::TwoNumbers);
}

void Plain::read(const JsonNode &node, glm::dvec3 &value)
{
    node.numbers(glm::value_ptr(value), 3, JsonKind::ThreeNumbers);
}

void Plain::read(const JsonNode &node, glm::dvec4 &value)
{
    node.numbers(glm::value_ptr(value), 4, JsonKind::FourNumbers);
}

void Plain::read(const JsonNode &node, glm::dmat4 &value)
{
    node.numbers(glm::value_ptr(value), 16, JsonKind::Matrix);
}

void Plain::read(const JsonNode &node, DepthRange &value)
{
    glm::dvec2 ends(value.atNear, value.atFar);
    read(node, ends);
    value = {ends.x, ends.y};
}

void Plain::read(const JsonNode &node, DevicePixel &value)
{
    constexpr int kMost = std::numeric_limits<int>::max();
    if (node.hasSize(2, JsonKind::TwoNumbers))
        value = {node.element(0).count(-kMost, kMost), node.element(1).count(-kMost, kMost)};
}

void Plain::read(const JsonNode &node, NdcDepth &value)
{
    glm::dvec2 ends(0.0);
    read(node, ends);
    if (node.failed())
        return;
    if (ends == glm::dvec2(0.0, 1.0)) {
        value = NdcDepth::ZeroToOne;
    } else if (ends == glm::dvec2(-1.0, 1.0)) {
        value = NdcDepth::MinusOneToOne;
    } else {
        failDepth(node, {"[-1, 1]", "[0, 1]"});
    }
}

void NdcDepthOf::read(const JsonNode &node, NdcDepth &value) const
{
    Plain::read(node, value);
    const ApiConventions &conventions = conventionsOf(api);
    if (!node.failed() && conventions.hasOnlyThatDepth && value != conventions.ndcDepth)
        failDepth(node, {"[0, 1] (\"conventions\": \"" + std::string(conventions.key) + "\")"});
}

void Plain::read(const JsonNode &node, Rotate &value)
{
    glm::dvec4 numbers(value.degrees, value.axis);
    read(node, numbers);
    value = {numbers.x, {numbers.y, numbers.z, numbers.w}};
}

Json Plain::write(const std::filesystem::path &value)
{
    return utf8FromPath(value);
}

Json Plain::write(const glm::dvec2 &value)
{
    return vectorJson(value);
}

Json Plain::write(const glm::dvec3 &value)
{
    return vectorJson(value);
}

Json Plain::write(const glm::dvec4 &value)
{
    return vectorJson(value);
}

Json Plain::write(const glm::dmat4 &value)
{
    return numbersJson({glm::value_ptr(value), 16});
}

Json Plain::write(const DepthRange &value)
{
    return vectorJson(glm::dvec2(value.atNear, value.atFar));
}

Json Plain::write(NdcDepth value)
{
    return vectorJson(glm::dvec2(value == NdcDepth::ZeroToOne ? 0.0 : -1.0, 1.0));
}

Json Plain::write(const Rotate &value)
{
    return vectorJson(glm::dvec4(value.degrees, value.axis));
}

void SomeText::read(const JsonNode &node, std::string &value)
{
    value = node.text();
    if (value.empty())
        node.fail(SceneFileErrorCode::BadFileName);
}

void InvertibleMatrix::read(const JsonNode &node, glm::dmat4 &value)
{
    Plain::read(node, value);
    if (!node.failed() && std::isinf(conditionNumber(value)))
        node.fail(Error{ErrorCode::SingularMatrix});
}

void ClipPlaneNumbers::read(const JsonNode &node, glm::dvec4 &value)
{
    Plain::read(node, value);
    if (!node.failed() && glm::dvec3(value) == glm::dvec3(0.0))
        node.fail(Error{ErrorCode::ClipPlaneHasNoNormal});
}

void PixelRatio::read(const JsonNode &node, double &value) const
{
    value = node.number();
    if (!(value > 0.0))
        node.fail(Error{ErrorCode::PixelRatioNotPositive, value});
    static_cast<void>(node.numberBetween(0.5 / std::min(width, height), double(most) / std::max(width, height)));
}

void Version::read(const JsonNode &node, int &value) const
{
    const double found = node.number();
    if (found == readable) {
        value = readable;
        return;
    }
    SceneFileError error;
    error.code = SceneFileErrorCode::UnknownVersion;
    error.value = found;
    error.limit = readable;
    node.fail(std::move(error));
}

} // namespace unprojector::scene_file
