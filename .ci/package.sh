#!/usr/bin/env bash
# Installs missing packages and builds a package for this release of Debian or Ubuntu,
# build/package/unprojector_….deb.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

bash "$root/.ci/setup.sh" dpkg-dev file
cd -- "$root" && cmake --workflow --preset package # Presets are looked for in the current folder.
