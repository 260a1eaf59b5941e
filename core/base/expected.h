#pragma once

#include <cassert>
#include <utility>
#include <variant>

namespace unprojector::base {

/// A value, or an error that explains why there is none. There are no sentinel values: "no answer"
/// is always an error.
template <class T, class E>
class [[nodiscard]] Expected {
public:
    Expected(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Expected(E error) : m_state(std::in_place_index<1>, std::move(error)) {}

    bool hasValue() const { return m_state.index() == 0; }
    explicit operator bool() const { return hasValue(); }

    const T &value() const &
    {
        assert(hasValue());
        return *std::get_if<0>(&m_state);
    }
    /// Returns a value, not a reference, because `const T &kept = f().value()` would dangle
    /// otherwise.
    T value() &&
    {
        assert(hasValue());
        return std::move(*std::get_if<0>(&m_state));
    }
    T value() const && = delete;

    const T &operator*() const & { return value(); }
    T operator*() && { return std::move(*this).value(); }
    T operator*() const && = delete;

    const T *operator->() const & { return &value(); }
    const T *operator->() const && = delete; // it would point into the temporary: write f().value().member

    const E &error() const &
    {
        assert(!hasValue());
        return *std::get_if<1>(&m_state);
    }
    E error() &&
    {
        assert(!hasValue());
        return std::move(*std::get_if<1>(&m_state));
    }
    E error() const && = delete;

private:
    std::variant<T, E> m_state;
};

} // namespace unprojector::base
