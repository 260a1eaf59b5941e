# The library for C++ programs: find_package(Unprojector), or pkg-config.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Unprojector)
install(TARGETS unprojector_shared EXPORT UnprojectorTargets
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT development
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        PUBLIC_HEADER DESTINATION include/unprojector COMPONENT development)
install(EXPORT UnprojectorTargets NAMESPACE Unprojector:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(UnprojectorConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/UnprojectorConfig.cmake
                              INSTALL_DESTINATION ${package} NO_SET_AND_CHECK_MACRO)
# While the major version is 0, each minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/UnprojectorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/UnprojectorConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/UnprojectorConfigVersion.cmake
        DESTINATION ${package} COMPONENT development)
if(NOT MSVC)
    # Relative to the file's own folder, so that the tree can be moved.
    file(RELATIVE_PATH prefix_from_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    cmake_path(SET prefix_from_pkgconfig NORMALIZE "${prefix_from_pkgconfig}")
    configure_file(unprojector.pc.in unprojector.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/unprojector.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endif()
