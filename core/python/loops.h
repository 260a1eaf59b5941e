#pragma once

#include "core/base/parallel.h"
#include "core/python/bindings.h"

#include "unprojector/unproject.h"

#include <algorithm>
#include <cstddef>
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

/// Describes a word that is none of the known ones, as ValueError.
[[noreturn]] inline void refuseWord(const char *name, const std::string &word, const char *known)
{
    throw py::value_error(std::string(name) + " is \"" + word + "\"; give " + known);
}

inline Space spaceOf(const std::string &word)
{
    if (word != "world" && word != "eye")
        refuseWord("space", word, "\"world\" or \"eye\"");
    return word == "eye" ? Space::Eye : Space::World;
}

inline Method methodOf(const std::string &word)
{
    if (word != "formula" && word != "matrix")
        refuseWord("method", word, "\"formula\" or \"matrix\"");
    return word == "matrix" ? Method::Matrix : Method::Formula;
}

} // namespace unprojector::python
