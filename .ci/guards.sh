#!/usr/bin/env bash
# bash .ci/guards.sh [push | night | NAME]…: the checks of a push, those of each night, or those named.
#
#   format   clang-format changes nothing; rules.py finds nothing
#   build    test.sh, the README's command: everything compiles without a warning, all tests pass
#   asan     the same programs by Clang, under the address and undefined behaviour sanitizers; the
#            fuzzers read their kept inputs
#   tidy     clang-tidy finds nothing in the sources that changed last, in 90 seconds
#   speed    speed.py finds nothing slower than KEPT_BUILD, a build folder of the preset bench
#
#   plain    the build without precompiled headers and with the default linker: a missing #include and a
#            wrong order of libraries are errors; its tests, optimised, and a session ten times as long
#   unsanitized   under the sanitizers of asan, the tests that asan leaves out because they are slow
#   tsan     the tests with the label "threads" under the thread sanitizer
#   tidyall  clang-tidy finds nothing in any source
#   fuzz     each fuzzer, for 10 minutes
#   packages check-packages.sh
#   windows  windows.sh with MINGW_SYSROOT
#
# The table at the end has a line a check: its result, its seconds, and how much came from the compiler
# cache. A check is skipped if its tools are missing, or are not Debian 12's where that matters.
# shellcheck disable=SC2317 # the loop at the end calls the checks by their names
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

export LC_ALL=C.UTF-8
cd -- "$root" # Presets are looked for in the current folder.
checks=" ${*:-push} "
checks=${checks/ push / format build asan tidy speed }
checks=${checks/ night / plain unsanitized tsan tidyall fuzz packages windows }
bash .ci/setup.sh git clang clang-format clang-tidy libclang-rt-dev llvm ccache "${testPackages[@]}" ||
    echo "The tools could not be installed: checks that need them are skipped."
useCcache

# A check returns it if it cannot run here: skip REASON; return
skip() {
    echo "Skipped: $1"
    return 77
}
# Other versions of Clang's tools have other opinions.
is14() { "$1" --version 2>/dev/null | grep -q 'version 14\.' || skip "$1 is not version 14, Debian 12's"; }
sources() { git -c safe.directory="$root" ls-files '*.cpp' '*.h' '*.inl'; }
buildAsan() { cmake --preset asan >/dev/null && cmake --build --preset asan "$@"; }

format() { python3 .ci/rules.py && is14 clang-format && sources | xargs clang-format --dry-run --Werror; }
build() { bash .ci/test.sh; }
asan() {
    is14 clang++ || return
    local log=build/asan/ctest.log result=0 again
    buildAsan || return
    ctest --preset asan | tee "$log" || result=$?
    again=$(sed -n 's/^ *[0-9]*\/[0-9]* Test *#[0-9]*: \([^ ]*\) .*\*\*\*.*/\1/p' "$log" | sort -u | tr '\n' ' ')
    [ -z "$again" ] || echo "Failed at least once: $again" # a failed test is run again
    return "$result"
}

# tidySources SECONDS: clang-tidy on the compiled sources that it reads. Returns 124 if the time is over,
# and fails if it cannot read its settings: then it would find nothing.
tidySources() {
    is14 clang-tidy && buildAsan --target help >/dev/null || return
    local log=build/asan/tidy.log result=0
    while read -r file; do ! grep -qF "/$file\"" build/asan/compile_commands.json || echo "$file"; done |
        timeout "$1" xargs -r -P 2 -n 1 clang-tidy -p build/asan --quiet --warnings-as-errors='*' >"$log" 2>"$log.errors" || result=$?
    cat "$log"
    ! grep -q ' error: ' "$log" && ! grep 'Error parsing' "$log.errors" && return "$result"
}
# Sources that changed in the last 20 commits, and those whose header did: the latest changes first.
tidy() {
    git -c safe.directory="$root" log -20 --first-parent --format= --name-only -- core gui tests |
        sed -n 's/\.h$/.cpp/p; /\.cpp$/p' | awk '!seen[$0]++' | tidySources 90 || [ $? -eq 124 ]
}
tidyall() { sources | grep '\.cpp$' | tidySources 14400; }
speed() {
    [ -n "${KEPT_BUILD:-}" ] || { skip "KEPT_BUILD is empty"; return; }
    bash .ci/setup.sh libbenchmark-dev && cmake --preset bench >/dev/null && cmake --build --preset bench && python3 .ci/speed.py "$KEPT_BUILD" build/bench
}
plain() {
    cmake --preset dev -B build/plain -DUNPROJECTOR_PRECOMPILED_HEADERS=OFF -DUNPROJECTOR_FAST_LINKER=OFF >/dev/null &&
        cmake --build build/plain && ctest --test-dir build/plain -j 3 --output-on-failure --no-tests=error &&
        bash tests/launch.sh --display UNPROJECTOR_SESSION_STEPS=800 -- build/plain/tests/tests_gui_window test_long_session
}
unsanitized() { is14 clang++ && buildAsan && ctest --preset unsanitized; }
tsan() { cmake --workflow --preset tsan; }
fuzz() { is14 clang++ && buildAsan --target unprojector_fuzzers && bash .ci/fuzz.sh 600; }
packages() {
    [ "$(id -u)" = 0 ] && grep -q '^VERSION_CODENAME=bookworm' /etc/os-release || { skip "needs root on Debian 12"; return; }
    bash .ci/check-packages.sh
}
windows() {
    [ -n "${MINGW_SYSROOT:-}" ] || { skip "MINGW_SYSROOT is empty"; return; }
    bash .ci/windows.sh "$MINGW_SYSROOT"
}

# "HITS MISSES" of the compiler cache so far.
cacheCounts() {
    { ccache --print-stats 2>/dev/null || true; } | awk '$1 ~ /^(direct|preprocessed)_cache_hit$/ { hits += $2 } $1 == "cache_miss" { misses += $2 }
        END { print hits + 0, misses + 0 }'
}

table=$(printf '%-11s %-7s %7s  %s' check result seconds 'from the cache')
failed=0
for check in $checks; do
    [ "$(type -t "$check")" = function ] || { echo "There is no check $check" >&2; exit 2; }
    echo "== $check"
    start=$SECONDS result=passed
    read -r hits misses < <(cacheCounts)
    # `set -e` has no effect in a function that is tested: its commands are joined by && and ||.
    "$check" || result=$([ $? -eq 77 ] && echo skipped || echo FAILED)
    [ "$result" != FAILED ] || failed=1
    read -r hitsNow missesNow < <(cacheCounts)
    row=$(printf '%-11s %-7s %7d  %d of %d' "$check" "$result" $((SECONDS - start)) $((hitsNow - hits)) $((hitsNow - hits + missesNow - misses)))
    table+=$'\n'$row
    echo "== $row"
done
printf '%s\n%-11s %-7s %7d\n' "$table" total '' "$SECONDS"
exit "$failed"
