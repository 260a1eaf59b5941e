#pragma once

/// The time that a test waits for an expected event, in milliseconds. It continues as soon as the
/// event comes, so only a failure takes this long. It leaves time for slow and busy machines.
inline constexpr int kPatienceMilliseconds = 60000;
