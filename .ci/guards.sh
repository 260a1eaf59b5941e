#!/usr/bin/env bash
# bash .ci/guards.sh [format] [package] [asan] [tidy] [tsan] [fuzz]: the guards beside the tests; without names, all of them.
#
#   format  clang-format has nothing to change
#   package the Debian package of the preset ci's programs: what lintian says of it, whether both programs work from where it
#           puts them, and whether anything is left when it is removed. In a root folder of its own: nothing is installed here
#   asan    everything compiles with Clang without a warning; all tests under the address and undefined behaviour
#           sanitizers, with all assertions
#   tidy    clang-tidy finds nothing in what changed lately
#   tsan    the loader's and the rows' tests under the thread sanitizer
#   fuzz    each reader's fuzzer for a minute
#
# A guard whose tools are not there, or are of another version than Debian 12's where that matters, is passed over, and says
# so. The last line names those that failed.
# shellcheck source=.ci/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

export LC_ALL=C.UTF-8
cd -- "$root" # Presets are looked for in the current folder.
bash .ci/setup.sh git clang clang-format clang-tidy libclang-rt-dev lld llvm ccache \
    dpkg-dev file lintian desktop-file-utils appstream fonts-noto-cjk fonts-noto-core fonts-noto-mono fonts-liberation ||
    echo "The guards' tools could not be installed: those that need them are passed over."
if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

# In a container the clone may belong to somebody else.
repository() { git -c safe.directory="$root" "$@"; }

isThere() {
    command -v "$1" >/dev/null && return
    echo "There is no $1: passed over"
    return 1
}

# Debian 12's. Other versions of the tools have other opinions.
isVersion14() { "$1" --version | grep 'version 14\.' >/dev/null; }

isDebian12s() {
    isThere "$1" || return
    isVersion14 "$1" && return
    echo "$1 is not version 14, Debian 12's: passed over"
    return 1
}

# Builds the preset asan, or the targets named of it; the warnings of another Clang are no errors.
buildWithClang() {
    local errors=ON
    local linker=()
    isVersion14 clang++ || { echo "clang++ is not version 14, Debian 12's: its warnings are no errors"; errors=OFF; }
    ! command -v ld.lld >/dev/null || linker=(-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld)
    cmake --preset asan -DUNPROJECTOR_WARNINGS_AS_ERRORS=$errors "${linker[@]}" >/dev/null &&
        cmake --build --preset asan "$@"
}

# The same for tools whose version says less than the release that they are of.
isReleaseDebian12() {
    isThere "$1" || return
    [ "$(sed -n 's/^ID=//p' /etc/os-release)-$(sed -n 's/^VERSION_ID="\(.*\)"/\1/p' /etc/os-release)" = debian-12 ] && return
    echo "$1 is not Debian 12's: passed over"
    return 1
}

format() {
    isDebian12s clang-format || return 0
    find core gui tests '(' -name '*.cpp' -o -name '*.h' -o -name '*.inl' ')' -print0 | xargs -0 clang-format --dry-run --Werror
}

asan() {
    isThere clang++ || return 0
    buildWithClang && onVirtualDisplay ctest --preset asan
}

# Sources that changed against main or, on main itself, in its last commits, and those whose header did: the latest
# changes first.
changedSources() {
    local from
    from=$(repository merge-base HEAD origin/main 2>/dev/null || true)
    if [ -z "$from" ] || [ "$from" = "$(repository rev-parse HEAD)" ]; then
        from=$(repository rev-list --first-parent HEAD | sed -n '1,20p' | tail -n 1)
    fi
    repository log --format= --name-only "$from..HEAD" -- core gui tests | sed -n 's/\.h$/.cpp/p; /\.cpp$/p' |
        awk '!seen[$0]++' | while read -r file; do
        # Only what is compiled: fuzzers and benchmarks are not, everywhere.
        if [ -f "$file" ] && grep -qF "/$file\"" build/asan/compile_commands.json; then echo "$file"; fi
    done
}

tidy() {
    isDebian12s clang-tidy || return 0
    [ -e build/asan/compile_commands.json ] || { echo "It needs what the guard asan builds: run that first"; return 1; }
    local changed rc=0
    changed=$(changedSources)
    [ -n "$changed" ] || { echo "No source changed."; return 0; }
    echo "$(wc -l <<<"$changed") changed sources"
    # A minute and a half's worth of them: the whole is to end within 35 minutes on two cores.
    timeout 90 xargs -P 2 -n 1 clang-tidy -p build/asan --quiet --warnings-as-errors='*' <<<"$changed" \
        >build/asan/tidy.log 2>/dev/null || rc=$?
    cat build/asan/tidy.log
    [ "$rc" -ne 124 ] || echo "The time was over before all were read."
    # Out of time is no finding, but what was found before it is.
    [ "$rc" -eq 0 ] || { [ "$rc" -eq 124 ] && ! grep -q ' error: ' build/asan/tidy.log; }
}

tsan() {
    cmake --workflow --preset tsan
}

fuzz() {
    isThere clang++ || return 0
    buildWithClang --target unprojector_fuzzers && bash .ci/fuzz.sh 60
}

# Files that are in a root folder, but for dpkg's own.
filesIn() { find "$1" -path "$1/var" -prune -o ! -type d -print; }

package() {
    isThere dpkg-shlibdeps && isThere file || return 0
    [ "$(id -u)" -eq 0 ] || { echo "Only root unpacks packages: passed over"; return 0; }
    local work=$root/build/ci/package lib=var/lib/dpkg tree share
    rm -rf "$work" && mkdir -p "$work/root/$lib/info" "$work/root/$lib/updates" && touch "$work/root/$lib/status"
    cmake --preset ci >/dev/null && cmake --build --preset ci --target unproject unprojector unprojector_manual &&
        cpack --config build/ci/CPackConfig.cmake -B "$work" || return
    ! isReleaseDebian12 lintian || lintian --allow-root --fail-on error,warning "$work"/*.deb || return
    tree=$work/root share=$work/root/usr/share
    # What it depends on is here, since it was built here.
    dpkg --root="$tree" --force-depends -i "$work"/*.deb 2>"$work/dpkg.log" || { cat "$work/dpkg.log"; return 1; }
    ! command -v desktop-file-validate >/dev/null || desktop-file-validate "$share"/applications/*.desktop || return
    ! isReleaseDebian12 appstreamcli || appstreamcli validate --no-net "$share"/metainfo/*.xml || return
    # The middle of the window, halfway through the depths of near 1 and far 3, seen from (0, 0, 5): 1.5 before the eye.
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
    dpkg --root="$tree" --purge unprojector || return
    [ -z "$(filesIn "$tree")" ] || { echo "The package leaves behind:"; filesIn "$tree"; return 1; }
    echo "$(du -h "$work"/*.deb | cut -f 1) package: installed, both programs ran, removed without a trace"
}

guards=("$@")
[ ${#guards[@]} -gt 0 ] || guards=(format package asan tidy tsan fuzz)
failed=()
for guard in "${guards[@]}"; do
    case $guard in
    format | package | tidy | asan | tsan | fuzz) ;;
    *) echo "There is no guard $guard" >&2; exit 2 ;;
    esac
    echo "== $guard"
    start=$SECONDS
    "$guard" || failed+=("$guard")
    echo "== $guard: $((SECONDS - start)) s"
done
if [ ${#failed[@]} -gt 0 ]; then
    echo "Guards failed: ${failed[*]}"
    exit 1
fi
echo "All guards passed: ${guards[*]}"
