#!/usr/bin/env bash
# Installs what is missing, builds the program and opens it; arguments are the program's own. Without a display it
# leaves a picture of the window, unprojector.png, in the current folder.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

bash "$root/.ci/setup.sh"
# Presets are looked for in the current folder. The command, unproject, is left to those who build it all.
(cd -- "$root" && cmake --preset release && cmake --build --preset release --target unprojector)
program=$root/build/release/gui/unprojector

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec "$program" "$@"
fi
echo "There is no display (DISPLAY and WAYLAND_DISPLAY are empty): using a virtual one."
case " $* " in
*" --screenshot"* | *" --help"* | *" --version"* | *" -h "* | *" -v "*) onVirtualDisplay "$program" "$@" ;;
*)
    onVirtualDisplay "$program" --screenshot unprojector.png --size 1280x800 "$@"
    echo "The window's picture: $PWD/unprojector.png"
    ;;
esac
