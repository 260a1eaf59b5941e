#pragma once

/// How long a test waits for what must come, in milliseconds. It goes on as soon as that comes, so only a failure takes as
/// long; a machine may be slow and have other things to do.
inline constexpr int kPatienceMilliseconds = 60000;
