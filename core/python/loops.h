#pragma once

#include "core/base/parallel.h"
#include "core/python/bindings.h"

#include "unprojector/unproject.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>

namespace unprojector::python {

/// The number of points of a block: its arrays fit the processor's first cache.
constexpr std::size_t kBlock = 512;

/// A whole number; one beyond the range of ssize_t is the nearer end of the range.
/// @return TypeError: another type; it names the argument and says what to give
inline py::ssize_t wholeNumberOf(const char *name, const py::object &argument, const char *give)
{
    if (PyIndex_Check(argument.ptr()) == 0)
        throw py::type_error(std::string(name) + " is " + std::string(py::repr(argument)) + "; give " + give);
    const py::ssize_t number = PyNumber_AsSsize_t(argument.ptr(), nullptr);
    if (number == -1 && PyErr_Occurred() != nullptr)
        throw py::error_already_set();
    return number;
}

/// The value of the argument threads: a number of threads, or None for all cores.
/// @return ValueError: less than 1; TypeError
inline std::size_t threadsOf(const py::object &threads)
{
    if (threads.is_none())
        return 0;
    constexpr const char *kGive = "1 or more, or None for all cores";
    const py::ssize_t count = wholeNumberOf("threads", threads, kGive);
    if (count < 1)
        throw py::value_error("threads is " + std::string(py::str(threads)) + "; give " + kGive);
    return static_cast<std::size_t>(count);
}

/// Calls block(begin, count) for blocks of `size` elements, in parallel and without the GIL.
/// @param task  the elements that a thread takes at a time
template <class Block>
void inBlocks(std::size_t size, std::size_t task, std::size_t threads, const Block &block)
{
    const py::gil_scoped_release released;
    base::inParallelRanges(
        size, task, {},
        [&](std::size_t begin, std::size_t end) {
            for (; begin < end; begin += kBlock)
                block(begin, std::min(kBlock, end - begin));
        },
        threads);
}

/// The value of a word.
/// @param words  in the order of the enumeration
/// @return ValueError: it is none of these
template <class Value>
Value valueOf(const char *name, const std::string &word, std::initializer_list<const char *> words)
{
    std::string known;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string each = words.begin()[i];
        if (word == each)
            return static_cast<Value>(i);
        known += (i == 0 ? "\"" : i + 1 < words.size() ? ", \"" : " or \"") + each + '"';
    }
    throw py::value_error(std::string(name) + " is \"" + word + "\"; give " + known);
}

inline Space spaceOf(const std::string &word)
{
    return valueOf<Space>("space", word, {"world", "eye"});
}

inline Method methodOf(const std::string &word)
{
    return valueOf<Method>("method", word, {"formula", "matrix"});
}

} // namespace unprojector::python
