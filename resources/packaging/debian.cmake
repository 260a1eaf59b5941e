# The package for Debian and Ubuntu. It depends on the libraries that the programs were linked with:
# it is for the release that it was built on, and later ones as long as they keep those libraries.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
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
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Press the mouse button on a model and read the coordinate of that pixel, by
formulas in closed form and by the inverted matrix of the pipeline, side by
side, with the cause of their difference and how certain the digits are.
.
The command unproject does the same for tables of pixels and whole depth
images, without a window.")
if(UNPROJECTOR_BUILD_GUI)
    # Loaded when the program runs: the texts of Qt's own buttons in other languages, fonts,
    # software OpenGL.
    set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-translations-l10n, fonts-dejavu-core | fonts-freefont-ttf, libgl1-mesa-dri")
    set(CPACK_DEBIAN_PACKAGE_SUGGESTS "qt6-wayland, fonts-noto-cjk | fonts-wqy-microhei")
endif()
