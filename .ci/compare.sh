#!/usr/bin/env bash
# bash .ci/compare.sh OLD NEW: checks that two builds give the same digits, words and pixels. OLD and
# NEW are build folders. compare.py describes what is compared.
exec python3 "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/compare.py" "$@"
