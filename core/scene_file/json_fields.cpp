#include "core/scene_file/json_fields.h"

#include "core/geometry/numbers.h"
#include "core/scene_file/json_text.h"

#include <cmath>

namespace unprojector::scene_file {
using namespace geometry;

namespace {

using Json = nlohmann::ordered_json;

/// Appends a member without searching for the key: a search takes time linear in the members.
void append(Json &object, std::string key, Json value)
{
    auto &members = static_cast<Json::object_t::Container &>(object.get_ref<Json::object_t &>());
    members.emplace_back(std::move(key), std::move(value));
}

SceneFileError notOneOf(std::span<const char *const> keys)
{
    SceneFileError error;
    error.code = SceneFileErrorCode::NotOneChoice;
    error.choices.assign(keys.begin(), keys.end());
    return error;
}

} // namespace

void FieldReader::angle(const char *degreesKey, const char *radiansKey, Angle &angle)
{
    double degrees = 0.0;
    required(degreesKey, degrees);
    angle = Angle::fromDegrees(degrees);
    m_known.add(radiansKey);
    const JsonNode exactly = m_object.member(radiansKey);
    if (!exactly.exists())
        return;
    const double exact = exactly.number();
    // Other programs may have rewritten the degrees with fewer digits; a different angle is a
    // deliberate change.
    constexpr double kSame = 1e-9;
    if (const double radians = angle.radians.value; std::abs(exact - radians) <= kSame * std::abs(radians)) {
        angle = exact;
        return;
    }
    SceneFileError error;
    error.code = SceneFileErrorCode::OtherAngle;
    error.value = exact;
    error.limit = degrees;
    error.found = degreesKey;
    exactly.fail(std::move(error));
}

std::size_t FieldReader::oneKeyOf(std::span<const char *const> keys, std::size_t)
{
    std::size_t found = 0, count = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        m_known.add(keys[i]);
        if (m_object.member(keys[i]).exists()) {
            found = i;
            ++count;
        }
    }
    if (count != 1)
        m_object.fail(notOneOf(keys));
    return found;
}

std::size_t FieldReader::checkedSize(const JsonNode &list, std::size_t most)
{
    const std::size_t size = list.size();
    if (size <= most)
        return size;
    SceneFileError error;
    error.code = SceneFileErrorCode::TooMany;
    error.value = double(size);
    error.limit = double(most);
    list.fail(std::move(error));
    return 0;
}

void FieldReader::keep(const char *key, Json &&unknown)
{
    if (unknown.is_null())
        return;
    if (m_unknown.is_null())
        m_unknown = Json::object();
    append(m_unknown, key, std::move(unknown));
}

Json FieldReader::takeUnknown()
{
    if (failed())
        return nullptr;
    for (const auto &[key, value] : m_object.json().get_ref<const Json::object_t &>()) {
        if (m_known.has(key))
            continue;
        if (m_unknown.is_null())
            m_unknown = Json::object();
        append(m_unknown, key, value);
    }
    return std::move(m_unknown);
}

void FieldWriter::angle(const char *degreesKey, const char *radiansKey, const Angle &angle)
{
    const double degrees = angle.degrees();
    required(degreesKey, degrees);
    m_known.add(radiansKey);
    if (Angle::fromDegrees(degrees) != angle)
        add(radiansKey, jsonNumber(angle.radians.value));
}

void FieldWriter::add(const char *key, Json &&value)
{
    append(m_json, key, std::move(value));
}

const Json *FieldWriter::unknownOf(const char *key) const
{
    if (m_unknown == nullptr || !m_unknown->is_object())
        return nullptr;
    const auto found = m_unknown->find(key);
    return found != m_unknown->end() ? &*found : nullptr;
}

Json FieldWriter::take()
{
    if (m_unknown != nullptr && m_unknown->is_object()) {
        for (const auto &[key, value] : m_unknown->get_ref<const Json::object_t &>()) {
            if (!m_known.has(key))
                append(m_json, key, value);
        }
    }
    return std::move(m_json);
}

} // namespace unprojector::scene_file
