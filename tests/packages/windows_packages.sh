#!/usr/bin/env bash
# bash windows_packages.sh EMULATOR BUILD [PROGRAM]: packs the program for Windows in the folder
# BUILD, as zip and as installer. Uses both as a person does, by EMULATOR (Wine): opens a model,
# clicks on it, uninstalls. Builds the example against the library in the zip. PROGRAM: unprojector for this system, which must pick the same.
set -euo pipefail
emulator=$1 build=$2 program=${3:-}
work=$(mktemp -d) sysroot=${QT_MINGW_PREFIX:-}
export LC_ALL=C.UTF-8
# A Windows of our own, and no libraries but the package's.
export WINEPREFIX=$work/wine QT_MINGW_PREFIX=$work/none WINEDEBUG=-all
mkdir -p "$QT_MINGW_PREFIX/bin"
cleanUp() { ! command -v wineserver >/dev/null || wineserver -k || true; rm -rf -- "$work"; }
trap cleanUp EXIT
fail() { echo "FAIL: $*" >&2; exit 1; }
windows() { "$emulator" "$@" 2>>"$work/errors.txt" || { cat "$work/errors.txt" >&2; fail "$*"; }; }

place="$work/空 格 folder"
mkdir -p "$place"
printf 'v -50 -50 1.25\nv 50 -50 1.25\nv 0 50 1.25\nf 1 2 3\n' >"$place/茶壶 1.obj"
# picks PROGRAM…: the coordinates, by formula and by matrix, of its click on a plane of z = 1.25
picks() {
    (cd "$place" && "$@" --screenshot 图.png --view-size 600x500 --click 300,250 "茶壶 1.obj") >"$work/picked.json"
    [ -s "$place/图.png" ] || fail "no picture by $*"
    rm "$place/图.png"
    python3 - "$work/picked.json" <<'END'
import json, sys
click = json.load(open(sys.argv[1], encoding="utf-8"))[0]
if not click["hit"] or abs(click["world"]["formula"][2] - 1.25) > 1e-3:
    sys.exit("a click on the plane z = 1.25 gave %s" % click["world"])
print(click["world"]["formula"], click["world"]["matrix"])
END
}

(cd "$build" && cpack --config CPackConfig.cmake -B "$work/packages" >"$work/cpack.txt") || { cat "$work/cpack.txt"; exit 1; }
zip=$(echo "$work"/packages/unprojector-*-windows-x64.zip)
setup=$(echo "$build"/unprojector-*-windows-x64-setup.exe)
[ -s "$zip" ] || fail "no zip"

(cd "$place" && cmake -E tar xf "$zip")
folder=$(echo "$place"/unprojector-*)
! grep -q 'UNPROJECTOR_QT_CHINESE:FILEPATH=/' "$build/CMakeCache.txt" || [ -s "$folder/translations/qtbase_zh_CN.qm" ] ||
    fail "Qt's own texts in Chinese are not in the zip"
zipped=$(picks windows "$folder/unprojector.exe")
echo "zip: $zipped"
printed=$(windows "$folder/unproject.exe" --version)
[ -n "$printed" ] || fail "unproject says no version"
if [ -n "$program" ]; then
    here=$(picks "$program")
    [ "$here" = "$zipped" ] || fail "this system picks $here"
fi

toolchain=$(sed -n 's/^CMAKE_TOOLCHAIN_FILE:[^=]*=//p' "$build/CMakeCache.txt")
if [ -n "$toolchain" ]; then
    example=$(dirname -- "$0")/../../resources/examples/library
    if ! env -u QT_MINGW_PREFIX ${sysroot:+"QT_MINGW_PREFIX=$sysroot"} \
        cmake -S "$example" -B "$work/example" -DCMAKE_TOOLCHAIN_FILE="$toolchain" \
        -DUnprojector_DIR="$folder/lib/cmake/Unprojector" -DCMAKE_BUILD_TYPE=Release >"$work/example.txt" 2>&1 ||
        ! cmake --build "$work/example" >>"$work/example.txt" 2>&1; then
        cat "$work/example.txt"
        fail "the example does not build"
    fi
    cp "$work/example/click.exe" "$folder/" # beside the library
    [ "$(windows "$folder/click.exe" | grep -c '^\(formula\|matrix\) *-0.0400816438')" = 2 ] || fail "the example says something else"
    rm "$folder/click.exe"
    echo "library: the example built and ran"
fi

if [ -s "$setup" ]; then
    windows "$setup" /S '/D=C:\软件\Unprojector'
    installed="$WINEPREFIX/drive_c/软件/Unprojector"
    [ -s "$installed/uninstall.exe" ] || fail "nothing was installed"
    command=$(windows reg query 'HKCU\Software\Classes\Unprojector.File\shell\open\command' | tr -d '\r')
    [[ $command == *'unprojector.exe" "%1"'* ]] || fail "files are opened by: $command"
    [ "$(picks windows "$installed/unprojector.exe")" = "$zipped" ] || fail "what is installed picks something else"
    touch "$installed/kept.txt" # a user's file stays
    windows reg add 'HKCU\Software\Unprojector\Unprojector' /v chosen /d kept /f >/dev/null
    windows "$setup" /S # over itself, as over an older version, where it was
    windows reg query 'HKCU\Software\Unprojector\Unprojector' /v chosen >/dev/null
    [ "$(picks windows "$installed/unprojector.exe")" = "$zipped" ] || fail "installed again, it picks something else"
    windows "$installed/uninstall.exe" /S
    for _ in $(seq 60); do
        [ -e "$installed/uninstall.exe" ] || break
        sleep 0.5
    done
    rest=$(cd "$installed" && find . -mindepth 1)
    [ "$rest" = ./kept.txt ] || fail "left behind: $rest"
    rm -r "$installed"
    for key in 'Unprojector' 'Classes\Unprojector.File' 'Classes\.obj' 'Classes\Applications\unprojector.exe' \
               'Microsoft\Windows\CurrentVersion\Uninstall\Unprojector'; do
        ! "$emulator" reg query "HKCU\\Software\\$key" >/dev/null 2>&1 || fail "left behind: HKCU\\Software\\$key"
    done
    rest=$(find "$WINEPREFIX/drive_c/users" -iname '*unprojector*')
    [ -z "$rest" ] || fail "left behind: $rest"
    echo "setup: installed, used, taken away"
else
    echo "setup: not made here, makensis is missing"
fi
