#pragma once

#include "unprojector/result.h"
#include "unprojector/setup.h"

#include "core/base/error.h"
#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/error_text.h"
#include "core/geometry/result.h"
#include "core/geometry/setup.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace unprojector {

struct Setup::Data {
    geometry::Setup setup;
    std::vector<std::string> findings;
};

/// The way of the library's own code into a Setup.
struct SetupAccess {
    static const geometry::Setup &of(const Setup &setup) { return setup.m_data->setup; }
    /// @return Value: the errors of check(setup)
    static Result<Setup> make(const geometry::Setup &setup, std::vector<std::string> findings = {});
};

/// The value of one of the two enumerations, public and core's, that list the same values in the same order.
template <class Target, class Source>
constexpr Target sameOf(Source value)
{
    return static_cast<Target>(value);
}

/// The finding that the world of these conventions is not the scene's. Empty where it is.
inline std::vector<std::string> worldFindings(geometry::Api api)
{
    const geometry::ApiConventions &conventions = geometry::conventionsOf(api);
    if (!conventions.isWorldMirrored)
        return {};
    return {"conventions: "
            + base::tr("%1's own world has z negated; world coordinates here are the scene's, right-handed",
                       conventions.name)};
}

/// @param file  the file that the user named; empty: the error's own
inline Error publicError(base::Error error, const std::filesystem::path &file = {})
{
    if (!file.empty())
        error.file = base::utf8FromPath(file);
    const bool isMissing = error.kind == base::Error::Kind::NoFile;
    return {isMissing                               ? Error::Kind::MissingFile
            : error.kind == base::Error::Kind::File ? Error::Kind::File
                                                    : Error::Kind::Value,
            error.message()};
}

/// The public error of a value.
inline Error valueError(std::string message)
{
    return {Error::Kind::Value, std::move(message)};
}

inline Error valueError(const geometry::Error &error)
{
    return valueError(geometry::errorText(error));
}

inline Result<Setup> SetupAccess::make(const geometry::Setup &setup, std::vector<std::string> findings)
{
    if (const geometry::Check valid = check(setup); !valid)
        return valueError(valid.error());
    return Setup(std::make_shared<const Setup::Data>(Setup::Data{setup, std::move(findings)}));
}

} // namespace unprojector
