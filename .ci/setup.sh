#!/usr/bin/env bash
# Installs the packages for building, testing and running on Debian 12 or later and Ubuntu 24.04 or
# later, and the packages named. Does nothing if all are installed.
set -euo pipefail

packages=(
    cmake g++ ninja-build
    # The window (Qt's OpenGL module is only recommended by qt6-base-dev); lrelease for the translations
    qt6-base-dev libqt6opengl6-dev libgl-dev libopengl-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools
    # Vectors and matrices, rays on meshes, JSON of scenes and glTF, the command's options, extended
    # precision
    libglm-dev libembree-dev nlohmann-json3-dev libcli11-dev libboost-dev
    # Packed glTF files
    libdraco-dev libmeshoptimizer-dev
    # Depth images and their colors
    libpng-dev libjpeg-dev libtiff-dev libopenexr-dev
    # For the tests: they compile and run the code that is written for GLU
    libglu1-mesa-dev
    # At run time: software OpenGL and a font, which Qt's packages do not depend on; a display for
    # machines without one; the texts of Qt's own buttons and dialogs, without which a Chinese
    # window asks its questions with an English Save
    libgl1-mesa-dri fonts-dejavu-core xvfb xauth qt6-translations-l10n
    "$@"
)

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    cat >&2 <<EOF
This script installs packages on Debian and Ubuntu only. Elsewhere, install a C++20 compiler, CMake 3.25 or later,
Ninja, Qt 6.4 or later (base and tools), GLM, CLI11, Embree, Draco, meshoptimizer, libpng, libjpeg, libtiff, OpenEXR, nlohmann-json, the Boost headers and Xvfb, then run
    cmake --workflow --preset release && build/release/gui/unprojector
EOF
    exit 1
fi

# Names of the installed packages and of their "provides": newer releases have Qt's OpenGL module in
# qt6-base-dev.
installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package},${Provides}\n' |
    sed -n 's/^installed //p' | sed 's/([^)]*)//g' | tr -d ' ' | tr ',' '\n')
missing=()
for package in "${packages[@]}"; do
    grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

asRoot=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "Packages are missing and there is no sudo. As root, run: apt-get install ${missing[*]}" >&2
        exit 1
    fi
    asRoot=(sudo)
fi

echo "Installing ${missing[*]}"
apt=("${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)
"${apt[@]}" update </dev/null
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null >/dev/null
