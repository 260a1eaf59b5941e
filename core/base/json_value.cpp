#include "core/base/json_value.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace unprojector::base {

JsonValue::JsonValue(nlohmann::ordered_json json)
    : m_json(json.is_null() ? nullptr : std::make_shared<nlohmann::ordered_json>(std::move(json)))
{
}

const nlohmann::ordered_json &JsonValue::json() const
{
    static const nlohmann::ordered_json null;
    return m_json ? *m_json : null;
}

nlohmann::ordered_json &JsonValue::edit()
{
    if (!m_json)
        m_json = std::make_shared<nlohmann::ordered_json>();
    else if (m_json.use_count() > 1)
        m_json = std::make_shared<nlohmann::ordered_json>(*m_json);
    return *m_json;
}

bool operator==(const JsonValue &a, const JsonValue &b)
{
    return a.m_json == b.m_json || a.json() == b.json();
}

} // namespace unprojector::base
