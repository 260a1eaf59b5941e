#pragma once

#include "core/base/json_value.h"
#include "core/geometry/numbers.h"
#include "core/scene_file/json_node.h"
#include "core/scene_file/json_values.h"

#include <algorithm>
#include <concepts>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace unprojector::scene_file {

// A function describes a struct's JSON once:
//
//   void describe(auto &json, Is<Viewport> auto &viewport)
//   {
//       json.required("x", viewport.x);
//       ...
//   }
//
// A FieldReader runs it to fill the struct, a FieldWriter to write it, in the same order of keys.
// So a new key takes one line. Keys that no line names are unknown: they are kept, and written
// after the known ones. The unknown keys of a nested object are kept under its key, in the nearest
// enclosing struct that has a member `extra` for them.

/// A struct, const or not, as a description takes it.
template <class T, class Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

template <class T, class Fields>
concept DescribedTo = requires(Fields &fields, T &value)
{
    describe(fields, value);
};

template <class T>
concept KeepsUnknownKeys = requires(T &value)
{
    value.extra;
};

/// The keys of an object that its description has named.
class KnownKeys {
public:
    void add(const char *key)
    {
        if (!has(key))
            m_keys.push_back(key);
    }
    bool has(std::string_view key) const { return std::find(m_keys.begin(), m_keys.end(), key) != m_keys.end(); }

private:
    std::vector<std::string_view> m_keys; ///< literals of the descriptions
};

/// Reads an object by its description.
class FieldReader {
public:
    using Json = nlohmann::ordered_json;
    static constexpr bool kReads = true;

    explicit FieldReader(const JsonNode &object) : m_object(object) { static_cast<void>(object.isObject()); }

    bool failed() const { return m_object.failed(); }

    /// Reads a member that must be present.
    /// @param how  a form (see json_values.h), or a description of the member; the default follows
    ///         from its type
    template <class T, class How = Plain>
    void required(const char *key, T &value, const How &how = {})
    {
        m_known.add(key);
        keep(key, read(m_object.member(key), value, how));
    }

    /// Reads a member that may be missing in a file; then it keeps its value. It is always written.
    template <class T, class How = Plain>
    void optional(const char *key, T &value, const How &how = {})
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists())
            keep(key, read(member, value, how));
    }

    /// A member that is written but never read; a file may have any value there.
    void written(const char *key, const char *) { m_known.add(key); }

    /// Reads a member that may be missing; it is written only if it has a value.
    template <class T, class How = Plain>
    void optional(const char *key, std::optional<T> &value, const How &how = {})
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists())
            keep(key, read(member, value.emplace(), how));
    }

    /// Reads a member that may be missing or null; it is written as null if it has no value.
    template <class T, class How = Plain>
    void nullable(const char *key, std::optional<T> &value, const How &how = {})
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists() && !member.json().is_null())
            keep(key, read(member, value.emplace(), how));
    }

    /// Reads members in an object of their own, which must be present.
    template <class Describe>
    void object(const char *key, const Describe &description)
    {
        m_known.add(key);
        keep(key, readObject(m_object.member(key), description));
    }

    /// The same for an object that may be missing; it is written only if it is not empty.
    template <class Describe>
    void optionalObject(const char *key, const Describe &description)
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists())
            keep(key, readObject(member, description));
    }

    /// Reads an array, which may be missing. Stops at the first error, since an element takes far
    /// more memory than its text.
    template <class T, class How = Plain>
    void list(const char *key, std::vector<T> &values, std::size_t most = kAnyNumber, const How &how = {})
    {
        m_known.add(key);
        const JsonNode member = m_object.member(key);
        if (!member.exists())
            return;
        const std::size_t count = checkedSize(member, most);
        values.clear();
        for (std::size_t i = 0; i < count && !failed(); ++i)
            static_cast<void>(read(member.element(i), values.emplace_back(), how));
    }

    /// Reads an angle, in degrees in JSON. An angle that was given in radians has these under a key
    /// of their own beside it.
    void angle(const char *degreesKey, const char *radiansKey, geometry::Angle &angle);
    void number(const char *key, geometry::DoubleDouble &number)
    {
        double value = 0.0;
        required(key, value);
        number = value;
    }

    /// Returns whether a member is present, if that decides how to read the others. The key counts
    /// as known in either case.
    /// @param isWritten  the answer when writing
    bool has(const char *key, [[maybe_unused]] bool isWritten)
    {
        m_known.add(key);
        return m_object.member(key).exists();
    }

    /// The number of elements of an array, 0 if it is missing: for a list that is left out when
    /// empty, or whose elements depend on their number.
    /// @param written  the number when writing
    std::size_t sizeOf(const char *key, [[maybe_unused]] std::size_t written)
    {
        return has(key, true) ? m_object.member(key).size() : 0;
    }

    /// The index of the key that is present: exactly one must be, beside any others.
    /// @param written  the one to write
    std::size_t oneKeyOf(std::span<const char *const> keys, std::size_t written);

    /// Adds an error of core about the values read.
    /// @param check  called if everything before it was read without an error
    /// @param key    of the member that the error is about, or a function from the error to the key
    template <class Checking, class Key>
    void check(const Checking &check, const Key &key)
    {
        if (failed())
            return;
        const geometry::Check valid = check();
        if (valid)
            return;
        if constexpr (std::invocable<Key, const geometry::Error &>)
            m_object.member(key(valid.error())).fail(valid.error());
        else
            m_object.member(key).fail(valid.error());
    }

    /// Reads a value. Returns its unknown keys, unless it keeps them itself.
    template <class T, class How>
    static Json read(const JsonNode &node, T &value, const How &how)
    {
        Json unknown;
        if constexpr (std::invocable<How, FieldReader &, T &>)
            unknown = readObject(node, [&](FieldReader &fields) { how(fields, value); });
        else if constexpr (DescribedTo<T, FieldReader>)
            unknown = readObject(node, [&](FieldReader &fields) { describe(fields, value); });
        else
            how.read(node, value);
        if constexpr (KeepsUnknownKeys<T>)
            value.extra = base::JsonValue(std::exchange(unknown, nullptr));
        return unknown;
    }

    static constexpr std::size_t kAnyNumber = std::size_t(-1);

private:
    template <class Describe>
    static Json readObject(const JsonNode &node, const Describe &description)
    {
        FieldReader fields(node);
        description(fields);
        return fields.takeUnknown();
    }

    static std::size_t checkedSize(const JsonNode &list, std::size_t most);
    void keep(const char *key, Json &&unknown);
    Json takeUnknown();

    const JsonNode &m_object;
    KnownKeys m_known;
    Json m_unknown; ///< of the nested objects
};

/// Writes an object by its description. The described value is const.
class FieldWriter {
public:
    using Json = nlohmann::ordered_json;
    static constexpr bool kReads = false;

    /// @param unknown  an object whose keys are written after the described ones, or null
    explicit FieldWriter(const Json *unknown) : m_unknown(unknown) {}

    static constexpr bool failed() { return false; }

    template <class T, class How = Plain>
    void required(const char *key, const T &value, const How &how = {})
    {
        m_known.add(key);
        add(key, write(value, how, unknownOf(key)));
    }
    template <class T, class How = Plain>
    void optional(const char *key, const T &value, const How &how = {})
    {
        required(key, value, how);
    }
    void written(const char *key, const char *text)
    {
        m_known.add(key);
        add(key, Json(text));
    }
    template <class T, class How = Plain>
    void optional(const char *key, const std::optional<T> &value, const How &how = {})
    {
        m_known.add(key);
        if (value)
            add(key, write(*value, how, unknownOf(key)));
    }
    template <class T, class How = Plain>
    void nullable(const char *key, const std::optional<T> &value, const How &how = {})
    {
        m_known.add(key);
        add(key, value ? write(*value, how, unknownOf(key)) : Json());
    }
    template <class Describe>
    void object(const char *key, const Describe &description)
    {
        m_known.add(key);
        add(key, writeObject(description, unknownOf(key)));
    }
    template <class Describe>
    void optionalObject(const char *key, const Describe &description)
    {
        m_known.add(key);
        if (Json written = writeObject(description, unknownOf(key)); !written.empty())
            add(key, std::move(written));
    }
    template <class T, class How = Plain>
    void list(const char *key, const std::vector<T> &values, [[maybe_unused]] std::size_t most = 0, const How &how = {})
    {
        m_known.add(key);
        Json elements = Json::array();
        for (const T &value : values)
            elements.push_back(write(value, how, nullptr));
        add(key, std::move(elements));
    }
    void angle(const char *degreesKey, const char *radiansKey, const geometry::Angle &angle);
    void number(const char *key, const geometry::DoubleDouble &number) { required(key, number.value); }
    bool has(const char *key, bool isWritten)
    {
        m_known.add(key);
        return isWritten;
    }
    std::size_t sizeOf(const char *key, std::size_t written)
    {
        m_known.add(key);
        return written;
    }
    std::size_t oneKeyOf(std::span<const char *const> keys, std::size_t written)
    {
        for (const char *key : keys)
            m_known.add(key);
        return written;
    }
    template <class Checking, class Key>
    void check(const Checking &, const Key &)
    {
    }

    /// @param unknown  as in the constructor; a value that keeps its own unknown keys takes those
    template <class T, class How>
    static Json write(const T &value, const How &how, const Json *unknown)
    {
        if constexpr (KeepsUnknownKeys<const T>)
            unknown = &value.extra.json();
        if constexpr (std::invocable<How, FieldWriter &, const T &>)
            return writeObject([&](FieldWriter &fields) { how(fields, value); }, unknown);
        else if constexpr (DescribedTo<const T, FieldWriter>)
            return writeObject([&](FieldWriter &fields) { describe(fields, value); }, unknown);
        else
            return how.write(value);
    }

private:
    template <class Describe>
    static Json writeObject(const Describe &description, const Json *unknown)
    {
        FieldWriter fields(unknown);
        description(fields);
        return fields.take();
    }

    void add(const char *key, Json &&value);
    const Json *unknownOf(const char *key) const;
    Json take();

    Json m_json = Json::object();
    KnownKeys m_known;
    const Json *m_unknown;
};

} // namespace unprojector::scene_file
