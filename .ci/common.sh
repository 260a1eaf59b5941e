# shellcheck shell=bash
# Sourced by the scripts beside it.
set -euo pipefail
export root
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

# CMake reads this when it configures a build folder for the first time. The cache of one clone
# serves another: the folder's own name is not part of the compilation.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=true
# Precompiled headers count by their content.
export CCACHE_SLOPPINESS=pch_defines,time_macros
# A source that is missing in the cache is not preprocessed first.
export CCACHE_DEPEND=true

# The compiler cache, where it is installed.
useCcache() {
    ! command -v ccache >/dev/null || export CMAKE_CXX_COMPILER_LAUNCHER=ccache
}
useCcache

# A display of its own, with software OpenGL. QT_QPA_PLATFORM or a Wayland display of the caller
# would keep Qt away from it.
onVirtualDisplay() {
    env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX" "$@"
}

# The Python module, which is built where these are installed.
pythonPackages=(python3-dev pybind11-dev python3-numpy)
# What the tests need besides the program: the fonts that tests/fonts names, lld, which links them in
# seconds, pkg-config, which a program of the library may be built with, and the NumPy that
# runs the scene's code. For the module: pytest, exact numbers to compare with, a cluster, and
# figures.
# shellcheck disable=SC2034 # for the scripts that source this
testPackages=(fonts-noto-cjk lld pkg-config "${pythonPackages[@]}"
    python3-pytest python3-mpmath python3-dask python3-distributed python3-matplotlib)
