#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace unprojector {

/// The reason why there is no value.
struct Error {
    enum class Kind {
        Value,      ///< an argument, or the contents of a file
        File,       ///< a file that cannot be opened, read or written
        MissingFile ///< a file that does not exist
    };
    Kind kind = Kind::Value;
    /// UTF-8. Names the value, or the file and the line, and what to do: "near is 0; it must be
    /// greater than 0".
    std::string message;
};

/// A value, or the error that explains why there is none. There are no sentinel values.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    bool hasValue() const { return m_state.index() == 0; }
    explicit operator bool() const { return hasValue(); }

    /// @pre hasValue()
    const T &value() const &
    {
        assert(hasValue());
        return *std::get_if<0>(&m_state);
    }
    T value() &&
    {
        assert(hasValue());
        return std::move(*std::get_if<0>(&m_state));
    }
    const T &operator*() const & { return value(); }
    T operator*() && { return std::move(*this).value(); }
    const T *operator->() const & { return &value(); }

    /// @pre not hasValue()
    const Error &error() const
    {
        assert(!hasValue());
        return *std::get_if<1>(&m_state);
    }

private:
    std::variant<T, Error> m_state;
};

} // namespace unprojector
