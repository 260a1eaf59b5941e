#!/usr/bin/env bash
# Installs missing packages, builds the program and opens it; arguments are the program's own.
# Without a display it clicks the middle of the view, prints the click with its coordinate, and writes
# a picture of the window, unprojector.png, to the current folder.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1

bash "$root/.ci/setup.sh"
# CMake looks for presets in the current folder. This script doesn't build the command, unproject.
(cd -- "$root" && cmake --preset release && cmake --build --preset release --target unprojector)
program=$root/build/release/gui/unprojector

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec "$program" "$@"
fi
echo "There is no display (DISPLAY and WAYLAND_DISPLAY are empty): using a virtual one."
case " $* " in
*" --screenshot"* | *" --help"* | *" --version"* | *" -h "* | *" -v "*) onVirtualDisplay "$program" "$@" ;;
*)
    # The middle of the view, where the model is: the same pixel with any font. The scene that follows
    # the answers is left out.
    run=(onVirtualDisplay "$program" --screenshot unprojector.png)
    case " $* " in
    *" --size"* | *" --view-size"* | *" --click"*) "${run[@]}" "$@" ;;
    *) "${run[@]}" --view-size 824x690 --click 412,345 "$@" | sed '/^ *"scene": /,$d' ;;
    esac
    echo "The window's picture: $PWD/unprojector.png"
    ;;
esac
