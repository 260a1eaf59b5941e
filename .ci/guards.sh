#!/usr/bin/env bash
# bash .ci/guards.sh [push | night | NAME]…: the checks of a push, the checks of each night, or the
# checks named. `.ci/run` runs the first six, `.ci/nightly` the rest.
#
#   format   clang-format changes nothing
#   release  the release build: compiler warnings are errors, and all tests pass
#   package  the three Debian packages of the release build: lintian finds nothing, both programs,
#            the example for the library and the Python module work from the packages' folders, no
#            file is left after their removal. It uses a root folder of its own: nothing is installed
#            here. The wheel works in a new virtual environment
#   asan     everything compiles with Clang without a warning; all tests pass under the address and
#            undefined behaviour sanitizers, with all assertions. Runs with the label "variant" are
#            left to the night
#   tidy     clang-tidy finds nothing in the sources that changed last, in 90 seconds
#   fuzz     no reader fails on its corpus or on its fuzzer's inputs of 10 seconds
#
#   plain    the release build without precompiled headers and with the default linker: a missing
#            #include and a wrong order of libraries are errors; all tests
#   variants the runs with the label "variant" under the address sanitizer
#   tsan     the tests with the label "threads" under the thread sanitizer
#   windows  the build for Windows by MinGW, and its tests under Wine. Needs MINGW_SYSROOT, a folder
#            with Qt and the other libraries, mingw-toolchain.cmake and run-wine.sh
#   tidyall  clang-tidy finds nothing in any source
#   fuzzlong as fuzz, for 10 minutes a reader
#
# The table at the end has a line a check: its result, its seconds, and the number of compilations
# from the cache. A check is marked as skipped if its tools are missing, or if their version is not
# Debian 12's where that matters.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

export LC_ALL=C.UTF-8
cd -- "$root" # Presets are looked for in the current folder.

push=(format release package asan tidy fuzz)
night=(plain variants tsan windows tidyall fuzzlong)
guards=()
for name in "${@-push}"; do
    case $name in
    push) guards+=("${push[@]}") ;;
    night) guards+=("${night[@]}") ;;
    *)
        printf '%s\n' "${push[@]}" "${night[@]}" | grep -qxF -- "$name" || { echo "There is no check $name" >&2; exit 2; }
        guards+=("$name")
        ;;
    esac
done

bash .ci/setup.sh git clang clang-format clang-tidy libclang-rt-dev llvm ccache \
    dpkg-dev file lintian desktop-file-utils appstream python3-venv "${testPackages[@]}" ||
    echo "The tools could not be installed: checks that need them are skipped."
useCcache

# The clone may belong to another user in a container.
repository() { git -c safe.directory="$root" "$@"; }

# skip REASON: reports a part that a check leaves out. The table names the check as skipped.
skip() {
    echo "$1: skipped"
    skipped=1
}

isThere() {
    command -v "$1" >/dev/null && return
    skip "There is no $1"
    return 1
}

# Debian 12's versions. Other versions of the tools have other opinions.
isVersion14() { "$1" --version | grep 'version 14\.' >/dev/null; }

isDebian12s() {
    isThere "$1" || return
    isVersion14 "$1" && return
    skip "$1 is not version 14, Debian 12's"
    return 1
}

# Builds the preset asan, or the named targets of it; the warnings of another Clang are no errors.
buildWithClang() {
    local errors=ON
    isVersion14 clang++ || { echo "clang++ is not version 14, Debian 12's: its warnings are no errors"; errors=OFF; }
    cmake --preset asan -DUNPROJECTOR_WARNINGS_AS_ERRORS=$errors >/dev/null &&
        cmake --build --preset asan "$@"
}

# The same for tools whose version says less than their release.
isReleaseDebian12() {
    isThere "$1" || return
    [ "$(sed -n 's/^ID=//p' /etc/os-release)-$(sed -n 's/^VERSION_ID="\(.*\)"/\1/p' /etc/os-release)" = debian-12 ] && return
    skip "$1 is not Debian 12's"
    return 1
}

format() {
    isDebian12s clang-format || return 0
    find core gui tests resources/examples '(' -name '*.cpp' -o -name '*.h' -o -name '*.inl' ')' -print0 | xargs -0 clang-format --dry-run --Werror
}

release() { bash .ci/test.sh; }

# testWithSanitizers OPTION …: ctest's options. The preset repeats a failed test: it names those
# tests at the end.
testWithSanitizers() {
    local log=build/asan/ctest.log rc=0 again
    ctest --preset asan "$@" | tee "$log" || rc=$?
    again=$(sed -n 's/^ *[0-9]*\/[0-9]* Test *#[0-9]*: \([^ ]*\) .*\*\*\*.*/\1/p' "$log" | sort -u | tr '\n' ' ')
    [ -z "$again" ] || echo "Failed at least once: $again"
    return "$rc"
}

asan() {
    isThere clang++ || return 0
    buildWithClang && testWithSanitizers -LE '^variant$'
}

variants() {
    isThere clang++ || return 0
    buildWithClang && testWithSanitizers -L '^variant$'
}

# Sources that changed against main or, on main itself, in its last commits, and sources whose
# header did: the latest changes first.
changedSources() {
    local from
    from=$(repository merge-base HEAD origin/main 2>/dev/null || true)
    if [ -z "$from" ] || [ "$from" = "$(repository rev-parse HEAD)" ]; then
        from=$(repository rev-list --first-parent HEAD | sed -n '1,20p' | tail -n 1)
    fi
    repository log --format= --name-only "$from..HEAD" -- core gui tests | sed -n 's/\.h$/.cpp/p; /\.cpp$/p' |
        awk '!seen[$0]++' | while read -r file; do
        # Only compiled sources count: fuzzers and benchmarks are not compiled everywhere.
        if [ -f "$file" ] && grep -qF "/$file\"" build/asan/compile_commands.json; then echo "$file"; fi
    done
}

# tidySources SECONDS: clang-tidy on the sources that it reads from standard input, in so much time
# at most. Returns 124 if the time was over before all were read and nothing was found.
tidySources() {
    local rc=0
    timeout "$1" xargs -P 2 -n 1 clang-tidy -p build/asan --quiet --warnings-as-errors='*' \
        >build/asan/tidy.log 2>/dev/null || rc=$?
    cat build/asan/tidy.log
    [ "$rc" -ne 124 ] || echo "The time was over before all were read."
    ! grep -q ' error: ' build/asan/tidy.log || rc=1
    return "$rc"
}

tidy() {
    isDebian12s clang-tidy || return 0
    [ -e build/asan/compile_commands.json ] || { echo "It needs what the check asan builds: run that first"; return 1; }
    local changed
    changed=$(changedSources)
    [ -n "$changed" ] || { echo "No source changed."; return 0; }
    echo "$(wc -l <<<"$changed") changed sources"
    tidySources 90 <<<"$changed" || [ $? -eq 124 ] # those that changed last come first, and the night reads all
}

tidyall() {
    isDebian12s clang-tidy || return 0
    buildWithClang || return
    find core gui tests -name '*.cpp' | while read -r file; do
        if grep -qF "/$file\"" build/asan/compile_commands.json; then echo "$file"; fi
    done | tidySources 14400
}

plain() {
    cmake --workflow --preset plain-headers
}

tsan() {
    cmake --workflow --preset tsan
}

# fuzzFor SECONDS: runs each fuzzer.
fuzzFor() {
    isThere clang++ || return 0
    buildWithClang --target unprojector_fuzzers && bash .ci/fuzz.sh "$1"
}
# The findings at a push depend on the change alone: the night tries other inputs each time.
fuzz() { FUZZ_SEED=1 fuzzFor 10; }
fuzzlong() { fuzzFor 600; }

windows() {
    [ -n "${MINGW_SYSROOT:-}" ] || { skip "MINGW_SYSROOT is empty"; return 0; }
    [ -e "$MINGW_SYSROOT/mingw-toolchain.cmake" ] || { echo "There is no $MINGW_SYSROOT/mingw-toolchain.cmake"; return 1; }
    bash .ci/setup.sh g++-mingw-w64-x86-64-posix wine64 wine nsis zip || return
    # Header-only libraries are this system's, in a folder of their own: /usr/include as a whole
    # would hide MinGW's headers.
    local headers=$root/build/windows-headers
    rm -rf "$headers" && mkdir -p "$headers/include" "$headers/share/cmake"
    cp -r /usr/include/nlohmann /usr/include/CLI "$headers/include/"
    cp -r /usr/share/cmake/nlohmann_json "$headers/share/cmake/"
    ln -s /usr/include/boost "$headers/include/boost"
    cmake -S . -B build/windows -G Ninja -DCMAKE_BUILD_TYPE=Release -DUNPROJECTOR_WARNINGS_AS_ERRORS=ON \
        -DCMAKE_TOOLCHAIN_FILE="$MINGW_SYSROOT/mingw-toolchain.cmake" -Dnlohmann_json_DIR="$headers/share/cmake/nlohmann_json" \
        -DUNPROJECTOR_CLI11_INCLUDE_DIR="$headers/include" -DUNPROJECTOR_BOOST_INCLUDE_DIR="$headers/include" >/dev/null &&
        cmake --build build/windows && onVirtualDisplay env -u QT_QPA_PLATFORM ctest --test-dir build/windows --output-on-failure
}

# The files in a root folder, except dpkg's own.
filesIn() { find "$1" -path "$1/var" -prune -o ! -type d -print; }

# Whether the preset ci builds the Python module.
hasPythonModule() { grep -q '^unprojector_wheel:' <<<"$(cmake --build --preset ci --target help)"; }

# runModule WHAT PYTHON…: the module's version is that of its distribution, and it computes.
runModule() {
    local what=$1
    shift
    "$@" - <<'END' || { echo "$what does not work"; return 1; }
import importlib.metadata
import numpy as np
import unprojector as up

assert up.__version__ == importlib.metadata.version("unprojector"), up.__version__
setup = up.Setup.perspective(fovy=45, near=0.1, far=100, eye=(3, 2, 5), center=(0, 0, 0), size=(800, 600))
print(up.__file__, setup)
END
}

# useWheel FOLDER WHEEL: installs the wheel in a new virtual environment, without a network.
useWheel() {
    /usr/bin/python3 -m venv --system-site-packages "$1" || { skip "python3 makes no virtual environments (Debian: python3-venv)"; return 0; }
    "$1/bin/pip" install --quiet --no-index --disable-pip-version-check "$2" && runModule "The wheel" "$1/bin/python3" &&
        "$1/bin/pip" uninstall --quiet --yes unprojector || return
    [ -z "$(find "$1/lib" -iname '*unprojector*')" ] || { echo "The wheel leaves files behind"; return 1; }
}

package() {
    isThere dpkg-shlibdeps && isThere file || return 0
    [ "$(id -u)" -eq 0 ] || { skip "Only root unpacks packages"; return 0; }
    local work=$root/build/ci/package lib=var/lib/dpkg tree share file packages=() targets=(unproject unprojector unprojector_manual unprojector_shared)
    rm -rf "$work" && mkdir -p "$work/root/$lib/info" "$work/root/$lib/updates" && touch "$work/root/$lib/status"
    cmake --preset ci >/dev/null || return
    ! hasPythonModule || targets+=(unprojector_wheel)
    cmake --build --preset ci --target "${targets[@]}" &&
        cpack --config build/ci/CPackConfig.cmake -B "$work" || return
    ! isReleaseDebian12 lintian || lintian --allow-root --fail-on error,warning "$work"/*.deb || return
    tree=$work/root share=$work/root/usr/share
    # Its dependencies are installed here, since it was built here.
    dpkg --root="$tree" --force-depends -i "$work"/*.deb 2>"$work/dpkg.log" || { cat "$work/dpkg.log"; return 1; }
    ! command -v desktop-file-validate >/dev/null || desktop-file-validate "$share"/applications/*.desktop || return
    ! isReleaseDebian12 appstreamcli || appstreamcli validate --no-net "$share"/metainfo/*.xml || return
    # The middle of the window, halfway through the depths of near 1 and far 3, seen from (0, 0, 5):
    # 1.5 before the eye.
    if ! "$tree/usr/bin/unproject" scene -o "$work/scene.json" --from-matrices \
        'modelview 1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 projection 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0 viewport 0 0 800 600' ||
        ! printf 'px,py,depth\n400,300,0.5\n' | "$tree/usr/bin/unproject" points "$work/scene.json" >"$work/points.csv" ||
        ! grep -q '^400,300,0.5,0,0,3.5,' "$work/points.csv"; then
        echo "unproject does not work from $tree"
        return 1
    fi
    if ! onVirtualDisplay "$tree/usr/bin/unprojector" --screenshot "$work/window.png" --view-size 600x500 \
        --click 300,250 >"$work/window.json" || ! grep -q '"world"' "$work/window.json"; then
        echo "unprojector does not work from $tree"
        return 1
    fi
    [ -s "$work/window.png" ] || { echo "There is no picture of the window"; return 1; }
    bash tests/library/use_library.sh resources/examples/library "$tree/usr" || return
    if hasPythonModule; then
        runModule "The package's module" env PYTHONPATH="$tree/usr/lib/python3/dist-packages" /usr/bin/python3 &&
            useWheel "$work/venv" build/ci/unprojector-*.whl || return
    else
        skip "The build has no Python module"
    fi
    for file in "$work"/*.deb; do packages+=("$(dpkg-deb --field "$file" Package)"); done
    dpkg --root="$tree" --force-script-chrootless --purge "${packages[@]}" || return # the root has no shell
    [ -z "$(filesIn "$tree")" ] || { echo "The packages leave behind:"; filesIn "$tree"; return 1; }
    du -h "$work"/*.deb | sed "s|$work/||"
    echo "Installed, the programs, the library and the module ran, removed without a trace"
}

# "HITS MISSES" of the compiler cache so far; empty without one.
cacheCounts() {
    ! command -v ccache >/dev/null || ccache --print-stats | awk '
        $1 == "direct_cache_hit" || $1 == "preprocessed_cache_hit" { hits += $2 }
        $1 == "cache_miss" { misses += $2 }
        END { print hits + 0, misses + 0 }'
}

failed=()
passed=()
table=$(printf '%-9s %-7s %7s  %s' check result seconds 'compilations from the cache')
for guard in "${guards[@]}"; do
    echo "== $guard"
    start=$SECONDS result=passed cached=- skipped=0
    read -r hits misses <<<"$(cacheCounts)" || true
    "$guard" || { failed+=("$guard"); result=FAILED; }
    [ "$result" = FAILED ] || [ "$skipped" = 0 ] || result=skipped
    [ "$result" != passed ] || passed+=("$guard")
    read -r hitsNow missesNow <<<"$(cacheCounts)" || true
    if [ -n "${hits:-}" ] && [ $((hitsNow - hits + missesNow - misses)) -gt 0 ]; then
        cached="$((hitsNow - hits)) of $((hitsNow - hits + missesNow - misses))"
    fi
    table+=$(printf '\n%-9s %-7s %7d  %s' "$guard" $result $((SECONDS - start)) "$cached")
    echo "== $guard: $((SECONDS - start)) s"
done
table+=$(printf '\n%-9s %-7s %7d' total '' "$SECONDS")
echo "$table"
if [ ${#failed[@]} -gt 0 ]; then
    echo "Failed: ${failed[*]}"
    exit 1
fi
if [ ${#passed[@]} -eq ${#guards[@]} ]; then
    echo "All passed: ${guards[*]}"
else
    echo "Nothing failed, but not all was checked. Passed: ${passed[*]}"
fi
