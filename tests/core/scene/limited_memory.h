#pragma once

#include <cstddef>

/// Larger allocations of the program fail while a test sets it, so that a failure is a row and not a
/// machine without memory. The sanitizers have their own allocations, which it does not limit.
extern std::size_t mostBytesAtOnce;
