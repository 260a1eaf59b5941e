#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors and runs every test.
# shellcheck source=.ci/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

# Numbers, translations and fonts must not depend on who runs the tests.
export LC_ALL=C.UTF-8

# The fonts that the files of tests/fonts show.
bash "$root/.ci/setup.sh" fonts-noto-cjk fonts-noto-core fonts-noto-mono fonts-liberation
cd -- "$root" # Presets are looked for in the current folder.
if [ "${CI:-}" = true ] || [ -z "${DISPLAY:-}" ]; then
    onVirtualDisplay cmake --workflow --preset ci
else
    cmake --workflow --preset ci
fi
