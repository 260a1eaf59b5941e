# The packages for Debian and Ubuntu. They depend on the libraries that their programs were linked with:
# they are for the release that they were built on, and later ones as long as they keep those libraries.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# A package a component.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME unprojector)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libunprojector-dev)
if(UNPROJECTOR_HAS_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-unprojector)
endif()
# The files that Debian requires in a package, and the change log in Debian's format.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_BINARY_DIR}/debian_tree.cmake)
configure_file(debian_tree.cmake.in debian_tree.cmake @ONLY)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Unprojector authors <unprojector@localhost>" CACHE STRING
    "Who answers for the package: name <address>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS TRUE)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Each description begins with its own summary.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION
"${PROJECT_DESCRIPTION}
Press the mouse button on a model and read the coordinate of that pixel, by
formulas in closed form and by the inverted matrix of the pipeline, side by
side, with the cause of their difference and how certain the digits are.
.
The command unproject does the same for tables of pixels and whole depth
images, without a window.")
if(UNPROJECTOR_BUILD_GUI)
    # Loaded when the program runs: the texts of Qt's own buttons in other languages, fonts,
    # software OpenGL.
    set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "qt6-translations-l10n, fonts-dejavu-core | fonts-freefont-ttf, libgl1-mesa-dri")
    set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "qt6-wayland, fonts-noto-cjk | fonts-wqy-microhei")
endif()

set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"World coordinates under pixels, for C++ programs
The library of Unprojector with its headers: pixels and depths become world
coordinates, by formulas in closed form and by the inverted matrix.
.
CMake finds it by find_package(Unprojector), pkg-config as unprojector.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS FALSE) # debian_tree.cmake sets what it depends on
configure_file(shlibs.in shlibs @ONLY)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/triggers ${CMAKE_CURRENT_BINARY_DIR}/shlibs)

if(UNPROJECTOR_HAS_PYTHON)
    set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"World coordinates under pixels, for Python and NumPy
The Python module of Unprojector: arrays of pixels and depths become arrays of
world coordinates, by formulas in closed form and by the inverted matrix.")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/prerm)
    # A compiled module is for one version of Python, and for NumPy's since the one it was built with.
    math(EXPR next_python "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
        "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy (>= 1:${numpy_minimum})")
endif()
