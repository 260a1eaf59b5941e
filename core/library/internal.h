#pragma once

#include "unprojector/result.h"
#include "unprojector/setup.h"

#include "core/base/translation.h"
#include "core/geometry/api_conventions.h"
#include "core/geometry/error_text.h"
#include "core/geometry/result.h"
#include "core/geometry/setup.h"

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
    /// @pre check(setup)
    static Setup make(const geometry::Setup &setup, std::vector<std::string> findings = {})
    {
        return Setup(std::make_shared<const Setup::Data>(Setup::Data{setup, std::move(findings)}));
    }
};

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

/// The public error of a value.
inline Error valueError(const geometry::Error &error)
{
    return {Error::Kind::Value, geometry::errorText(error)};
}

inline Error valueError(std::string message)
{
    return {Error::Kind::Value, std::move(message)};
}

} // namespace unprojector
