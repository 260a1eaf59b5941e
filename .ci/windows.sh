#!/usr/bin/env bash
# bash .ci/windows.sh SYSROOT: builds for Windows by MinGW, and runs the tests under Wine. SYSROOT: a
# folder with Qt and the other libraries, mingw-toolchain.cmake and run-wine.sh.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1
cd -- "$root"
[ -e "$1/mingw-toolchain.cmake" ] || { echo "There is no $1/mingw-toolchain.cmake" >&2; exit 1; }
bash .ci/setup.sh g++-mingw-w64-x86-64-posix wine64 wine nsis zip
# Header-only libraries are this system's, in a folder of their own: /usr/include as a whole would hide
# MinGW's headers.
headers=$root/build/windows-headers
rm -rf "$headers" && mkdir -p "$headers/include" "$headers/share/cmake"
cp -r /usr/include/nlohmann /usr/include/CLI "$headers/include/"
cp -r /usr/share/cmake/nlohmann_json "$headers/share/cmake/"
ln -s /usr/include/boost "$headers/include/boost"
cmake -S . -B build/windows -G Ninja -DCMAKE_BUILD_TYPE=Release -DUNPROJECTOR_WARNINGS_AS_ERRORS=ON \
    -DCMAKE_TOOLCHAIN_FILE="$1/mingw-toolchain.cmake" -Dnlohmann_json_DIR="$headers/share/cmake/nlohmann_json" \
    -DUNPROJECTOR_CLI11_INCLUDE_DIR="$headers/include" -DUNPROJECTOR_BOOST_INCLUDE_DIR="$headers/include"
cmake --build build/windows
onVirtualDisplay env -u QT_QPA_PLATFORM ctest --test-dir build/windows --output-on-failure --no-tests=error
