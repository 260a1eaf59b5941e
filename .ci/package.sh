#!/usr/bin/env bash
# Installs missing packages and builds three packages for this release of Debian or Ubuntu:
# build/package/{unprojector,libunprojector-dev,python3-unprojector}_….deb.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

bash "$root/.ci/setup.sh" dpkg-dev file "${pythonPackages[@]}"
cd -- "$root" && cmake --workflow --preset release && # Presets are looked for in the current folder.
    cpack --config build/release/CPackConfig.cmake -B build/package
