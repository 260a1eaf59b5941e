#pragma once

#include "core/base/json.h"
#include "core/base/translation.h"

#include <nlohmann/json.hpp>

#include <concepts>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::base {

// A function describes a struct's JSON once:
//
//   template <class Fields, Is<Viewport> T>
//   void describe(Fields &json, T &viewport)
//   {
//       json.required("x", viewport.x);
//       ...
//   }
//
// A JsonReader runs it to fill the struct, a JsonWriter to write it, in the same order of keys. So
// a new key takes one line. Keys that no line names are unknown: they are kept, and written after
// the known ones. The unknown keys of a nested object are kept under its key, in the nearest
// enclosing struct that has a member `extra` for them.
//
// Numbers, texts, vectors and lists need no description. Another form of a value is a function
// object, `how`, with the same two parameters; for a list, it describes an element.
//
// JsonReader and JsonWriter have a room as a parameter: any struct in the namespace with the
// descriptions, which are found through it.

/// A struct, const or not, as a description takes it.
template <class T, class Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

template <class T>
concept KeepsUnknownKeys = requires(T &value)
{
    value.extra;
};

/// A vector such as GLM's.
template <class T>
concept HasLength = requires(T &value)
{
    T::length();
    value[0];
};

template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class T, class... Types>
inline constexpr bool kIsOneOf = (std::same_as<T, Types> || ...);

/// The form of a type's own description.
struct Plain {};

/// The elements of a vector or an array.
template <class T>
auto elementsOf(T &values)
{
    if constexpr (HasLength<T>)
        return std::span(&values[0], static_cast<std::size_t>(T::length()));
    else
        return std::span(values);
}

/// Whether a value is as if it were missing.
template <class T>
bool isDefault(const T &value)
{
    if constexpr (requires { value.empty(); })
        return value.empty();
    else
        return value == T{};
}

/// A value of a document that is read, or the place of a missing one. Each function throws an Error
/// with the path, the line and the column if the value is missing or is not what is asked for.
///
/// A node refers to its parent, which must outlive it: the path is built only for an error.
class JsonNode {
public:
    static constexpr bool kReads = true;

    /// @param text  of the document; may be empty
    explicit JsonNode(const Json &document, std::string_view text = {}) : m_json(&document), m_text(text) {}
    /// A member, present or missing.
    JsonNode(const JsonNode &object, std::string_view key);
    JsonNode(const JsonNode &list, std::size_t index)
        : m_json(&(*list.m_json)[index]), m_parent(&list), m_step{{}, index}
    {
    }
    JsonNode(const JsonNode &) = delete;
    JsonNode &operator=(const JsonNode &) = delete;

    bool exists() const { return m_json != nullptr; }
    /// @pre exists()
    const Json &json() const { return *m_json; }

    /// @param text  as Error::text
    [[noreturn]] void fail(std::string text) const;
    [[noreturn]] void failAt(std::string_view key, std::string text) const
    {
        JsonNode(*this, key).fail(std::move(text));
    }

    void requireObject() const;
    /// The number of elements of a list.
    std::size_t size(std::size_t most = std::numeric_limits<std::size_t>::max()) const;
    /// Checks the number of elements of a list.
    /// @param expected  what it is, for an error, with %1 for the size
    void requireSize(std::size_t size, const char *expected) const;
    double number() const;
    /// A number within both ends.
    double number(double lowest, double highest) const;
    double whole(double lowest, double highest) const;
    std::string text() const;
    /// The index of a text among the allowed words.
    std::size_t oneOf(std::span<const char *const> words) const;
    [[noreturn]] void failChoice(std::span<const char *const> choices) const;

    /// Returns whether a member is present, if that decides how to read the others. The key counts
    /// as known in either case.
    /// @param isWritten  the answer when writing
    bool has(std::string_view key, bool isWritten = true);
    /// The index of the key that is present: exactly one must be, beside any others.
    /// @param written  the one to write
    std::size_t oneKeyOf(std::span<const char *const> keys, std::size_t written = 0);
    /// A member that is written but never read; a file may have any value there.
    void written(std::string_view key, const char *);
    /// The members that no call has named, and those of nested objects; null if there are none.
    Json take();

protected:
    void scalar(bool &value) const;
    void scalar(double &value) const { value = number(); }
    void scalar(std::string &value) const { value = text(); }
    /// Not empty, without a zero byte.
    void scalar(std::filesystem::path &value) const;

    bool isNull(bool) const { return m_json->is_null(); }
    void limitSize(std::size_t most) const { static_cast<void>(size(most)); }
    /// Keeps what a member's take() returned.
    void add(std::string_view key, Json &&unknown, bool mayBeMissing);
    static void addElement(Json &&) {}

private:
    void require(bool isIt, const char *expected, std::size_t count = 0) const;
    std::string shown() const;

    const Json *m_json = nullptr;
    std::string_view m_text;
    const JsonNode *m_parent = nullptr;
    JsonStep m_step; ///< from the parent
    std::vector<std::string_view> m_known;
    Json m_unknown; ///< of the nested objects
};

/// A value of a document that is written, with the functions of JsonNode that a description calls.
class JsonOutput {
public:
    static constexpr bool kReads = false;

    JsonOutput() = default;
    JsonOutput(const JsonOutput &object, std::string_view key);
    JsonOutput(const JsonOutput &, std::size_t) {}

    /// Sets a value that is no object.
    void set(Json json) { m_json = std::move(json); }
    bool has(std::string_view key, bool isWritten);
    std::size_t oneKeyOf(std::span<const char *const> keys, std::size_t written);
    void written(std::string_view key, const char *text) { add(key, text, false); }
    Json take();

protected:
    void scalar(const bool &value) { m_json = value; }
    void scalar(const double &value) { m_json = jsonNumber(value); }
    void scalar(const std::string &value) { m_json = value; }
    void scalar(const std::filesystem::path &value);

    static bool isNull(bool hasValue) { return !hasValue; }
    static void limitSize(std::size_t) {}
    void requireSize(std::size_t, const char *) { m_json = Json::array(); }
    void add(std::string_view key, Json &&value, bool mayBeMissing);
    void addElement(Json &&value) { m_json.push_back(std::move(value)); }

    Json m_json;
    std::vector<std::string_view> m_known;
    const Json *m_unknown = nullptr; ///< an object whose members are written after the described ones
};

/// Reads or writes a value by its description. A written value is const.
template <class Room, class Side>
class JsonFields : public Side {
public:
    using Side::kReads;
    using Side::Side;

    /// A member that must be present.
    template <class T, class How = Plain>
    void required(std::string_view key, T &value, const How &how = {})
    {
        object(key, [&](JsonFields &member) { member.value(value, how); });
    }
    /// A member that may be missing in a file; then it keeps its value. It is written unless it is
    /// an optional without a value.
    template <class T, class How = Plain>
    void optional(std::string_view key, T &value, const How &how = {})
    {
        bool isWritten = true;
        if constexpr (kIsOptional<std::remove_const_t<T>>)
            isWritten = value.has_value();
        if (Side::has(key, isWritten))
            required(key, value, how);
    }
    /// The same for a member that is not written if it is empty, 0 or the first word.
    template <class T, class How = Plain>
    void unlessDefault(std::string_view key, T &value, const How &how = {})
    {
        if (Side::has(key, !isDefault(value)))
            required(key, value, how);
    }
    /// A member that may be missing or null; it is written as null if it has no value.
    template <class Optional>
    void nullable(std::string_view key, Optional &value)
    {
        optionalMember(key, [&](JsonFields &member) {
            if (!member.isNull(value.has_value()))
                member.value(value);
        });
    }
    /// A list that may be missing in a file.
    /// @param how  of an element
    template <class T, class How = Plain>
    void list(std::string_view key, T &values, std::size_t most, const How &how = {})
    {
        optionalMember(key, [&](JsonFields &member) {
            member.limitSize(most);
            member.value(values, how);
        });
    }
    /// Members in an object of their own, which must be present.
    template <class Describe>
    void object(std::string_view key, const Describe &description, bool mayBeMissing = false)
    {
        JsonFields member(*this, key);
        description(member);
        Side::add(key, member.take(), mayBeMissing);
    }
    /// The same for an object that may be missing; it is written only if it is not empty.
    template <class Describe>
    void optionalObject(std::string_view key, const Describe &description)
    {
        if (Side::has(key, true))
            object(key, description, true);
    }

    template <class T, class How = Plain>
    void value(T &value, const How &how = {})
    {
        using Value = std::remove_const_t<T>;
        if constexpr (KeepsUnknownKeys<T> && !kReads)
            Side::m_unknown = &value.extra.json();
        if constexpr (kIsOptional<Value>) {
            if constexpr (kReads)
                value.emplace();
            this->value(*value, how);
        } else if constexpr (kIsList<Value> && kReads) {
            // Stops at the first error, since an element takes far more memory than its text.
            value.clear();
            for (std::size_t i = 0, count = Side::size(); i < count; ++i)
                JsonFields(*this, i).value(value.emplace_back(), how);
        } else if constexpr (kIsList<Value>) {
            elements(value, how);
        } else if constexpr (std::invocable<How, JsonFields &, T &>) {
            how(*this, value);
        } else if constexpr (HasLength<T>) {
            elements(value, how);
        } else if constexpr (kIsOneOf<Value, bool, double, std::string, std::filesystem::path>) {
            Side::scalar(value);
        } else {
            describe(*this, value);
        }
        if constexpr (KeepsUnknownKeys<T> && kReads)
            value.extra = JsonValue(Side::take());
    }

    /// A list of a fixed length.
    /// @param expected  what it is, for an error
    template <class T, class How = Plain>
    void elements(T &&values, const How &how = {}, const char *expected = marked("a list of %1 numbers"))
    {
        const auto all = elementsOf(values);
        Side::requireSize(all.size(), expected);
        for (std::size_t i = 0; i < all.size(); ++i) {
            JsonFields element(*this, i);
            element.value(all[i], how);
            Side::addElement(element.take());
        }
    }

private:
    template <class Describe>
    void optionalMember(std::string_view key, const Describe &description)
    {
        if (Side::has(key, true))
            object(key, description);
    }
};

template <class Room>
using JsonReader = JsonFields<Room, JsonNode>;
template <class Room>
using JsonWriter = JsonFields<Room, JsonOutput>;

/// A whole number within both ends.
struct Whole {
    double lowest, highest;

    template <class Fields, class T>
    requires std::integral<T>
    void operator()(Fields &json, T &value) const
    {
        if constexpr (Fields::kReads)
            value = static_cast<T>(json.whole(lowest, highest));
        else
            json.set(value);
    }
};

/// One of some words, in the order of an enumeration's values.
struct Words {
    std::span<const char *const> words;

    template <class Fields, class T>
    void operator()(Fields &json, T &value) const
    {
        if constexpr (Fields::kReads)
            value = static_cast<T>(json.oneOf(words));
        else
            json.set(words[static_cast<std::size_t>(value)]);
    }
};

/// Describes the alternative of a variant that has an index; when reading, sets the variant to it.
template <class Variant, class Describe>
void describeAlternative(Variant &variant, std::size_t index, const Describe &description)
{
    if constexpr (!std::is_const_v<Variant>) {
        const auto set = [&]<std::size_t... I>(std::index_sequence<I...>)
        {
            ((index == I ? void(variant.template emplace<I>()) : void()), ...);
        };
        set(std::make_index_sequence<std::variant_size_v<Variant>>());
    }
    std::visit(description, variant);
}

/// Reads a described value. @param text  of the document, for the lines of errors; may be empty
template <class Room, class T>
Expected<T, Error> valueOfJson(const Json &json, std::string_view text, const std::string &file)
{
    try {
        T value;
        JsonReader<Room>(json, text).value(value);
        return value;
    } catch (Error &error) {
        error.file = file;
        return error;
    }
}

template <class Room, class T>
Json jsonOfValue(const T &value)
{
    JsonWriter<Room> json;
    json.value(value);
    return json.take();
}

} // namespace unprojector::base
