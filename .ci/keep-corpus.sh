#!/usr/bin/env bash
# bash .ci/keep-corpus.sh [NAME …]: makes tests/fuzz/corpora.tar.xz anew from itself and from what the
# fuzzers of build/asan have tried since (.ci/fuzz.sh). It keeps the smallest set of small inputs that
# reaches the same code, however often.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

build=$root/build/asan kept=$build/tests/fuzz/corpora
names=("$@")
[ ${#names[@]} -gt 0 ] || mapfile -t names < <(ls "$build/corpus")
[ ${#names[@]} -gt 0 ] && [ -n "$(ls "$kept")" ] || { echo "Build the fuzzers and run .ci/fuzz.sh first" >&2; exit 1; }
for name in "${names[@]}"; do
    merged=$(mktemp -d)
    mkdir -p "$kept/$name"
    "$build/tests/fuzz/fuzz_$name" -merge=1 -use_counters=0 -max_len=1024 -timeout=20 -rss_limit_mb=3000 -close_fd_mask=1 \
        "$merged" "$build/corpus/$name" "$kept/$name" >"$build/merge.log" 2>&1 || { tail -n 20 "$build/merge.log"; exit 1; }
    rm -r "${kept:?}/$name"
    mv "$merged" "$kept/$name"
    printf 'fuzz_%s: %s inputs\n' "$name" "$(find "$kept/$name" -type f | wc -l)"
done
tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --format=ustar -cf - -C "$kept" . | xz -9e >"$root/tests/fuzz/corpora.tar.xz"
