#pragma once

#include "core/scene_file/json_node.h"
#include "core/scene_file/json_values.h"
#include "core/text/json_value.h"

#include <algorithm>
#include <concepts>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace unprojector::scene_file {

// How a struct stands in JSON is said once, by a function
//
//   void describe(auto &json, Is<Viewport> auto &viewport)
//   {
//       json.required("x", viewport.x);
//       ...
//   }
//
// that a FieldReader runs to fill the struct and a FieldWriter to write it, in the same order of keys. So a new key is one
// line. Keys that no line names are unknown: they are kept, and written again behind the known ones. Those of an object in
// an object are kept under its key, up to the next struct that has a member `extra` for them.

/// A struct, or a const one, as a description takes it.
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

    /// A member that must be there.
    /// @param how  a form (see json_values.h), or what describes the member; by default what its type says
    template <class T, class How = Plain>
    void required(const char *key, T &value, const How &how = {})
    {
        m_known.add(key);
        keep(key, read(m_object.member(key), value, how));
    }

    /// A member that may be missing in a file. It keeps its value then, and is written all the same.
    template <class T, class How = Plain>
    void optional(const char *key, T &value, const How &how = {})
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists())
            keep(key, read(member, value, how));
    }

    /// A member that is written, and whatever a file has in its place is passed over.
    void written(const char *key, const char *) { m_known.add(key); }

    /// A member that may be missing and is written only where it has a value.
    template <class T, class How = Plain>
    void optional(const char *key, std::optional<T> &value, const How &how = {})
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists())
            keep(key, read(member, value.emplace(), how));
    }

    /// A member that may be missing or null, and is written as null where it has no value.
    template <class T, class How = Plain>
    void nullable(const char *key, std::optional<T> &value, const How &how = {})
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists() && !member.json().is_null())
            keep(key, read(member, value.emplace(), how));
    }

    /// Members in an object of their own, which must be there.
    template <class Describe>
    void object(const char *key, const Describe &description)
    {
        m_known.add(key);
        keep(key, readObject(m_object.member(key), description));
    }

    /// The same where it may be missing; it is written only where something is in it.
    template <class Describe>
    void optionalObject(const char *key, const Describe &description)
    {
        m_known.add(key);
        if (const JsonNode member = m_object.member(key); member.exists())
            keep(key, readObject(member, description));
    }

    /// An array, which may be missing. It is read only as far as the first error: an element takes far more memory than
    /// its text, which need not be one.
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

    /// An angle, in degrees in JSON. Where no number of degrees gives the same radians again, those stand under a key of
    /// their own beside them.
    void angle(const char *degreesKey, const char *radiansKey, double &radians);

    /// Whether a member is there: for what decides how the others are read. The key is known even where it is left out.
    /// @param isWritten  what decides when writing
    bool has(const char *key, [[maybe_unused]] bool isWritten)
    {
        m_known.add(key);
        return m_object.member(key).exists();
    }

    /// How many elements an array has, 0 where it is missing: for a list that is left out when it is empty, or whose
    /// elements depend on their number.
    /// @param written  the number when writing
    std::size_t sizeOf(const char *key, [[maybe_unused]] std::size_t written)
    {
        return has(key, true) ? m_object.member(key).size() : 0;
    }

    /// Which of the keys is there: exactly one must be, besides any others.
    /// @param written  which one to write
    std::size_t oneKeyOf(std::span<const char *const> keys, std::size_t written);

    /// Notes what core says of what was read.
    /// @param check  asked once everything before it was read without an error
    /// @param key    of the member that the error is about, or what gives it for an error
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

    /// Reads a value and gives its unknown keys, where it has no place for them itself.
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
            value.extra = text::JsonValue(std::exchange(unknown, nullptr));
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
    Json m_unknown; ///< of the objects in this one
};

/// Writes an object by its description. What is described is const.
class FieldWriter {
public:
    using Json = nlohmann::ordered_json;
    static constexpr bool kReads = false;

    /// @param unknown  an object whose keys are written behind those described, or null
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
    void angle(const char *degreesKey, const char *radiansKey, double radians);
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

    /// @param unknown  as in the constructor; a value that has its own unknown keys takes those
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
