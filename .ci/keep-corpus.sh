#!/usr/bin/env bash
# bash .ci/keep-corpus.sh [NAME …]: makes tests/fuzz/corpus anew from itself and from the findings
# of the fuzzers of build/asan since (.ci/fuzz.sh). It keeps the smallest set of small inputs that
# reaches the same code, however often. Files with names are kept as they are.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

build=$root/build/asan
names=("$@")
[ ${#names[@]} -gt 0 ] || mapfile -t names < <(ls "$build/corpus")
for name in "${names[@]}"; do
    kept=$root/tests/fuzz/corpus/$name merged=$(mktemp -d)
    # A merge keeps the inputs of its first folder, and adds the others that reach new code, the
    # smallest first.
    find "$kept" -type f -name '*.*' -exec cp -t "$merged" {} +
    "$build/tests/fuzz/fuzz_$name" -merge=1 -use_counters=0 -max_len=1024 -timeout=20 -rss_limit_mb=3000 -close_fd_mask=1 \
        "$merged" "$build/corpus/$name" "$kept" >"$build/merge.log" 2>&1 || { tail -n 20 "$build/merge.log"; exit 1; }
    find "$kept" -type f ! -name '*.*' -delete
    find "$merged" -type f ! -name '*.*' -exec cp -t "$kept" {} +
    rm -r "$merged"
    printf 'fuzz_%s: %s inputs, %s\n' "$name" "$(find "$kept" -type f | wc -l)" "$(du -sh --apparent-size "$kept" | cut -f 1)"
done
