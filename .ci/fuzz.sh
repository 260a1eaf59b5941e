#!/usr/bin/env bash
# bash .ci/fuzz.sh [SECONDS [NAME …]]: runs the fuzzers of build/asan, two at a time, each for
# SECONDS seconds (60). An input that breaks something is left in build/asan/findings, and its
# fuzzer's last words are shown: it goes into tests/fuzz/findings with a name.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

export seconds=${1:-60}
shift $(($# > 0 ? 1 : 0))
export build=$root/build/asan findings=$root/build/asan/findings
mkdir -p "$findings"

fuzzOne() {
    local name=$1 corpus=$build/corpus/$1 log=$findings/$1.log inputs=()
    mkdir -p "$corpus"
    for folder in "$build/tests/fuzz/corpora/$name" "$root/tests/fuzz/findings/$name"; do
        [ ! -d "$folder" ] || inputs+=("$folder")
    done
    if "$build/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -max_len=8192 -timeout=20 -rss_limit_mb=3000 \
        -artifact_prefix="$findings/$name-" -print_final_stats=1 -close_fd_mask=1 "$corpus" "${inputs[@]}" >"$log" 2>&1 </dev/null; then
        printf 'fuzz_%s: %s inputs in %s s, nothing found\n' "$name" \
            "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" "$seconds"
    else
        printf 'fuzz_%s: found something\n' "$name"
        tail -n 60 "$log"
        return 1
    fi
}
export -f fuzzOne

names=("$@")
if [ ${#names[@]} -eq 0 ]; then
    for program in "$build"/tests/fuzz/fuzz_*; do
        [ -x "$program" ] && [ -f "$program" ] && names+=("${program##*/fuzz_}")
    done
fi
[ ${#names[@]} -gt 0 ] || { echo "There are no fuzzers in $build/tests/fuzz" >&2; exit 1; }
# shellcheck disable=SC2016 # the name is for the shell that xargs starts
printf '%s\0' "${names[@]}" | xargs -0 -n 1 -P 2 bash -c 'fuzzOne "$1"' _
