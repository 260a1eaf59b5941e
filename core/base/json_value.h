#pragma once

#include <nlohmann/json_fwd.hpp>

#include <memory>

namespace unprojector::base {

/// A JSON value to keep in a struct. Its header does not include the JSON library, whose 25,000
/// lines every user of the struct would otherwise parse. Code that works with the value includes
/// <nlohmann/json.hpp>.
///
/// Copies share the value until one of them is edited, so a copy costs a pointer.
class JsonValue {
public:
    JsonValue() = default; ///< null
    /// Explicit, because braces that are an object in JSON would become a list here. For those, see
    /// edit().
    explicit JsonValue(nlohmann::ordered_json json);

    const nlohmann::ordered_json &json() const;
    /// The value to change. The reference is valid until this object is copied, assigned or
    /// destroyed.
    nlohmann::ordered_json &edit();

    friend bool operator==(const JsonValue &a, const JsonValue &b);

private:
    std::shared_ptr<nlohmann::ordered_json> m_json; ///< none for null
};

} // namespace unprojector::base
