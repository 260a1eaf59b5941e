#pragma once

#include "unprojector/setup.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <string>
#include <utility>

/// The Python module: thin functions over the C++ library. Each function here adds one part.
namespace unprojector::python {

namespace py = pybind11;

using SetupClass = py::class_<Setup>;

SetupClass bindSetup(py::module_ &module);
void bindUnproject(SetupClass &setup);
void bindProject(py::module_ &module, SetupClass &setup);
void bindCloud(py::module_ &module, SetupClass &setup);
void bindScene(py::module_ &module);
void bindDiagnose(py::module_ &module);
void bindLandmarks(py::module_ &module);

/// The value, or the Python exception of the error: ValueError or OSError.
template <class T>
T valueOrRaise(Result<T> result)
{
    if (result)
        return std::move(result).value();
    PyObject *type = PyExc_ValueError;
    switch (result.error().kind) {
    case Error::Kind::Value: break;
    case Error::Kind::File: type = PyExc_OSError; break;
    case Error::Kind::MissingFile: type = PyExc_FileNotFoundError; break;
    }
    PyErr_SetString(type, result.error().message.c_str());
    throw py::error_already_set();
}

/// The value of a call that runs without the GIL, or the exception of its error.
template <class Call>
auto withoutGil(const Call &call)
{
    return valueOrRaise([&] {
        const py::gil_scoped_release released;
        return call();
    }());
}

/// Issues a UserWarning.
/// @return the exception that the user made of it
inline void warn(const std::string &text)
{
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0)
        throw py::error_already_set();
}

} // namespace unprojector::python
