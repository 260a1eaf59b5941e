#!/usr/bin/env bash
# bash .ci/check-packages.sh: builds the three Debian packages and checks them. lintian finds nothing;
# both programs, the example for the library and the Python module work from the packages' folders; no
# file is left after their removal. It uses a root folder of its own: nothing is installed here. The
# wheel works in a new virtual environment.
# shellcheck source=.ci/common.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh" || exit 1
cd -- "$root"
bash .ci/setup.sh lintian desktop-file-utils appstream pkg-config python3-venv
rm -f build/package/*.deb
bash .ci/package.sh

fail() {
    echo "$1" >&2
    exit 1
}

# The module's version is that of its distribution, and it computes. runModule WHAT PYTHON…
runModule() {
    local what=$1
    shift
    "$@" - <<'END' || fail "$what does not work"
import importlib.metadata
import numpy as np
import unprojector as up

assert up.__version__ == importlib.metadata.version("unprojector"), up.__version__
setup = up.Setup.perspective(fovy=45, near=0.1, far=100, eye=(3, 2, 5), center=(0, 0, 0), size=(800, 600))
print(up.__file__, setup)
END
}

work=$root/build/package/check
tree=$work/root
share=$tree/usr/share
rm -rf "$work" && mkdir -p "$tree"/var/lib/dpkg/{info,updates} && touch "$tree/var/lib/dpkg/status"
lintian --allow-root --fail-on error,warning build/package/*.deb
# Its dependencies are installed here, since it was built here.
dpkg --root="$tree" --force-depends -i build/package/*.deb 2>"$work/dpkg.log" || fail "$(cat "$work/dpkg.log")"
desktop-file-validate "$share"/applications/*.desktop
appstreamcli validate --no-net "$share"/metainfo/*.xml

# The middle of the window, halfway through the depths of near 1 and far 3, seen from (0, 0, 5): 1.5
# before the eye.
"$tree/usr/bin/unproject" scene -o "$work/scene.json" --from-matrices \
    'modelview 1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 projection 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0 viewport 0 0 800 600'
printf 'px,py,depth\n400,300,0.5\n' | "$tree/usr/bin/unproject" points "$work/scene.json" | grep -q '^400,300,0.5,0,0,3.5,' ||
    fail "unproject does not work from $tree"
onVirtualDisplay "$tree/usr/bin/unprojector" --screenshot "$work/window.png" --view-size 600x500 --click 300,250 >"$work/window.json"
{ grep -q '"world"' "$work/window.json" && [ -s "$work/window.png" ]; } || fail "unprojector does not work from $tree"
bash tests/library/use_library.sh resources/examples/library "$tree/usr"
runModule "The package's module" env PYTHONPATH="$tree/usr/lib/python3/dist-packages" /usr/bin/python3

cmake --build --preset release --target unprojector_wheel
/usr/bin/python3 -m venv --system-site-packages "$work/venv"
"$work/venv/bin/pip" install --quiet --no-index --disable-pip-version-check build/release/unprojector-*.whl
runModule "The wheel" "$work/venv/bin/python3"
"$work/venv/bin/pip" uninstall --quiet --yes unprojector
[ -z "$(find "$work/venv/lib" -iname '*unprojector*')" ] || fail "The wheel leaves files behind"

packages=()
for file in build/package/*.deb; do packages+=("$(dpkg-deb --field "$file" Package)"); done
dpkg --root="$tree" --force-script-chrootless --purge "${packages[@]}" # the root has no shell
left=$(find "$tree" -path "$tree/var" -prune -o ! -type d -print) # dpkg's own files stay
[ -z "$left" ] || fail "The packages leave behind: $left"
du -h build/package/*.deb
