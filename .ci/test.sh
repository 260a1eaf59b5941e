#!/usr/bin/env bash
# Installs missing packages, builds with warnings as errors, and runs every test.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

bash "$root/.ci/setup.sh" "${testPackages[@]}"
cd -- "$root" && cmake --workflow --preset dev # Presets are looked for in the current folder.
