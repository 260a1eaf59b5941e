#!/bin/sh
# launch.sh [--display] [VARIABLE=value …] -- PROGRAM [ARGUMENT …]: runs a test isolated from the
# user's environment: no variables but the ones named here, its own home folder, no fonts but the
# ones the project names, no terminal.
#
# --display  an X server of its own (Xvfb) with software OpenGL, so that tests with windows run side
#            by side; without it, Qt's offscreen platform
set -u
folder=$(cd -- "$(dirname -- "$0")" && pwd)
platform=offscreen
[ "${1:-}" != --display ] || { platform=xcb; shift; }

home=$(mktemp -d "${TMPDIR:-/tmp}/unprojector-test.XXXXXX") || exit 1
home=$(cd -- "$home" && pwd)
server= program=
cleanUp() {
    trap '' HUP INT TERM
    [ -z "$program" ] || kill "$program" 2>/dev/null
    [ -z "$server" ] || { kill "$server" 2>/dev/null; wait "$server" 2>/dev/null; }
    rm -rf "$home"
}
trap cleanUp EXIT
trap 'exit 143' HUP INT TERM
mkdir -m 700 "$home/run"
mkdir -m 1777 "$home/tmp"
chmod 711 "$home" # a test of permissions reads its files as another user

# The test's own variables come last and win.
set -- QT_QPA_PLATFORM=$platform "$@"
# The variables that configure sanitizers and libraries outside the system's folders.
for name in LD_LIBRARY_PATH LD_PRELOAD ASAN_OPTIONS LSAN_OPTIONS UBSAN_OPTIONS TSAN_OPTIONS; do
    eval "value=\${$name:-}"
    [ -z "$value" ] || set -- "$name=$value" "$@"
done
unset LD_PRELOAD # of the test, not of the programs below

if [ $platform = xcb ]; then
    mkfifo "$home/display"
    Xvfb -displayfd 3 -screen 0 1280x1024x24 +extension GLX -nolisten tcp -noreset \
        3>"$home/display" >"$home/server.log" 2>&1 </dev/null &
    server=$!
    read -r number <"$home/display" || { echo "Xvfb did not start:"; cat "$home/server.log"; exit 1; }
    set -- DISPLAY=":$number" "$@"
fi

# Two tests at a time share two cores: software OpenGL would take all of them for each.
set -- PATH="$PATH" HOME="$home" TMPDIR="$home/tmp" XDG_RUNTIME_DIR="$home/run" LC_ALL=C.UTF-8 TZ=UTC TERM=dumb \
    LP_NUM_THREADS=1 FONTCONFIG_FILE="$folder/fonts/dejavu.conf" "$@"
# env runs the words after the variables, without the "--".
for argument; do
    shift
    if [ -z "${ended:-}" ] && [ "$argument" = -- ]; then ended=1; else set -- "$@" "$argument"; fi
    last=$argument
done
[ -n "${ended:-}" ] && [ "$last" != -- ] || { echo "launch.sh [--display] [VARIABLE=value …] -- PROGRAM [ARGUMENT …]" >&2; exit 2; }
# The program runs beside the shell, which otherwise acts on a signal only after the program's end.
# A shell starts such a program with INT and QUIT ignored.
env --default-signal=INT,QUIT -i "$@" </dev/null &
program=$!
wait "$program"
status=$?
program=
exit "$status"
