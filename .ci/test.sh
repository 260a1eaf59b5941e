#!/usr/bin/env bash
# bash .ci/test.sh [LABEL]: installs missing packages, builds the release with warnings as errors
# and runs every test. With a LABEL, "optimised", it builds the programs and the tests with that
# label, and runs those.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

bash "$root/.ci/setup.sh" "${testPackages[@]}"
cd -- "$root" # Presets are looked for in the current folder.
if [ $# -eq 0 ]; then
    cmake --workflow --preset ci
else
    cmake --preset ci
    cmake --build --preset ci --target unproject unprojector unprojector_manual "unprojector_$1_tests"
    ctest --preset ci -L "^$1\$"
fi
