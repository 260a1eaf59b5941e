#pragma once

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace unprojector::gui {

/// The values of an enumeration with their names in settings and on the command line.
template <class Value, std::size_t count>
using NamedValues = std::array<std::pair<Value, const char *>, count>;

/// The value of this name; nothing if there is none.
template <class Value, std::size_t count>
std::optional<Value> valueNamed(const QString &name, const NamedValues<Value, count> &values)
{
    for (const auto &[value, itsName] : values) {
        if (name == QLatin1String(itsName))
            return value;
    }
    return std::nullopt;
}

/// The name of this value; empty if there is none.
template <class Value, std::size_t count>
QString nameAmong(const NamedValues<Value, count> &values, Value value)
{
    for (const auto &[candidate, name] : values) {
        if (candidate == value)
            return QLatin1String(name);
    }
    return {};
}

} // namespace unprojector::gui
