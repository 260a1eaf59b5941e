#!/usr/bin/env bash
# bash use_library.sh EXAMPLE PREFIX: builds the example against the library that is installed below
# PREFIX, by CMake and by pkg-config, and runs it. CMAKE_GENERATOR is CMake's.
set -euo pipefail
example=$1 prefix=$2
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export LC_ALL=C.UTF-8 CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}
fail() { echo "FAIL: $*" >&2; exit 1; }

# check PROGRAM: it loads the library of PREFIX, and both methods give the point that gluUnProject gives.
check() {
    LD_LIBRARY_PATH=$(dirname -- "$library") ldd "$1" | grep -F "=> $(dirname -- "$library")/" >/dev/null || fail "$1 loads another library"
    LD_LIBRARY_PATH=$(dirname -- "$library") "$1" >"$work/out.txt" || fail "$1: $(cat "$work/out.txt")"
    [ "$(grep -cE '^(formula|matrix) +-0\.04008164381[0-9]* -0\.03375573101[0-9]* -0\.07519692645[0-9]*' "$work/out.txt")" = 2 ] ||
        fail "$1 says $(cat "$work/out.txt")"
    [ "$(grep -cE '^ +pixel 400\.5 300\.5, depth 0\.985$' "$work/out.txt")" = 2 ] || fail "$1: the way back is $(cat "$work/out.txt")"
}

library=$(find "$prefix" -name 'libunprojector.so')
[ -n "$library" ] || fail "there is no library below $prefix"
if ! cmake -S "$example" -B "$work/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release >"$work/log.txt" 2>&1 ||
    ! cmake --build "$work/build" >>"$work/log.txt" 2>&1; then
    cat "$work/log.txt"
    fail "the example does not build"
fi
check "$work/build/click"
# A program that wants another minor version does not get this one.
for version in 0.0 0.2 1.0; do
    mkdir "$work/$version"
    printf 'cmake_minimum_required(VERSION 3.22)\nproject(p LANGUAGES CXX)\nfind_package(Unprojector %s REQUIRED)\n' $version \
        >"$work/$version/CMakeLists.txt"
    ! cmake -S "$work/$version" -B "$work/$version/build" -DCMAKE_PREFIX_PATH="$prefix" >"$work/log.txt" 2>&1 ||
        fail "version $version was found"
    grep -q 'compatible with requested version' "$work/log.txt" || { cat "$work/log.txt"; fail "version $version: another error"; }
done
if command -v pkg-config >/dev/null; then
    PKG_CONFIG_PATH=$(dirname -- "$library")/pkgconfig
    export PKG_CONFIG_PATH
    # shellcheck disable=SC2046 # words
    "${CXX:-c++}" -std=c++20 "$example/main.cpp" -o "$work/click" $(pkg-config --cflags --libs unprojector)
    check "$work/click"
else
    echo "There is no pkg-config: unprojector.pc was not tried"
fi
sed -n '/^formula/p' "$work/out.txt"
