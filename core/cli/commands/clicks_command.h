#pragma once

#include "core/cli/commands/points_command.h"

namespace unprojector::cli {

/// Runs `unproject points` on clicks: computes each again with its own scene, one row per click. A
/// click on the background has no point and counts as a bad row.
ExitCode runClicks(const PointsOptions &options, const std::vector<scene_file::Click> &clicks);

} // namespace unprojector::cli
