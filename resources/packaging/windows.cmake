# A folder that runs from anywhere, as a zip; and, where makensis is there, an installer of the same
# files.
set(CPACK_GENERATOR ZIP)
set(CPACK_SYSTEM_NAME windows-x64)
# The library for C++ is in the same folder: its headers in include, its CMake package in lib.
set(modules $<TARGET_FILE:unprojector_shared>)
if(UNPROJECTOR_BUILD_GUI)
    # Files that Qt loads when the program runs.
    foreach(plugin platforms/QWindowsIntegrationPlugin styles/QWindowsVistaStylePlugin styles/QModernWindowsStylePlugin
                   imageformats/QJpegPlugin)
        cmake_path(GET plugin FILENAME target)
        cmake_path(GET plugin PARENT_PATH folder)
        if(TARGET Qt6::${target})
            install(FILES $<TARGET_FILE:Qt6::${target}> DESTINATION ${folder})
            list(APPEND modules $<TARGET_FILE:Qt6::${target}>)
        endif()
    endforeach()
    if(NOT TARGET Qt6::QWindowsIntegrationPlugin)
        message(FATAL_ERROR "Qt's platform plugin for Windows is not there; without it no window opens.")
    endif()
    # The texts of Qt's own buttons and dialogs; if Qt for Windows was built without them, the texts
    # of the building Qt.
    find_file(UNPROJECTOR_QT_CHINESE qtbase_zh_CN.qm
              PATHS ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_TRANSLATIONS} ${QT_HOST_PATH}/share/qt6/translations
              NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH DOC "Qt's own texts in Chinese")
    mark_as_advanced(UNPROJECTOR_QT_CHINESE)
    if(UNPROJECTOR_QT_CHINESE)
        install(FILES ${UNPROJECTOR_QT_CHINESE} DESTINATION translations)
    else()
        message(STATUS "There is no qtbase_zh_CN.qm: in Chinese, the packed program's questions are answered in English")
    endif()
    set(window_program $<TARGET_FILE:unprojector>)
endif()

# The libraries that the programs and the plugins are linked with, except Windows' own.
get_filename_component(compiler_folder ${CMAKE_CXX_COMPILER} DIRECTORY)
set(library_folders ${compiler_folder})
foreach(prefix IN LISTS CMAKE_PREFIX_PATH)
    list(APPEND library_folders ${prefix}/bin)
endforeach()
set(windows_imports)
if(NOT CMAKE_HOST_WIN32) # there Windows' own libraries cannot be found
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libkernel32.a OUTPUT_VARIABLE kernel32
                    OUTPUT_STRIP_TRAILING_WHITESPACE)
    cmake_path(GET kernel32 PARENT_PATH windows_imports)
endif()
install(CODE "
    set(programs \"$<TARGET_FILE:unproject>;${window_program}\")
    set(modules \"${modules}\")
    set(folders \"${library_folders}\")
    set(windows_imports \"${windows_imports}\")
    set(objdump \"$<$<NOT:$<BOOL:${MSVC}>>:${CMAKE_OBJDUMP}>\")
")
install(SCRIPT windows_libraries.cmake)
if(MSVC)
    set(CMAKE_INSTALL_SYSTEM_RUNTIME_DESTINATION .)
    include(InstallRequiredSystemLibraries)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION . RENAME LICENSE.txt)
install(FILES libraries.txt DESTINATION licences)
foreach(prefix IN LISTS CMAKE_PREFIX_PATH) # vcpkg has each library's
    file(GLOB texts ${prefix}/share/*/copyright)
    foreach(text IN LISTS texts)
        cmake_path(GET text PARENT_PATH library)
        cmake_path(GET library FILENAME library)
        install(FILES ${text} DESTINATION licences RENAME ${library}.txt)
    endforeach()
endforeach()
foreach(licence LGPL-3 GPL-3 Apache-2.0)
    if(EXISTS /usr/share/common-licenses/${licence})
        install(FILES /usr/share/common-licenses/${licence} DESTINATION licences RENAME ${licence}.txt)
    endif()
endforeach()

find_program(UNPROJECTOR_MAKENSIS makensis DOC "NSIS's compiler of installers (Debian: nsis)")
mark_as_advanced(UNPROJECTOR_MAKENSIS)
if(NOT UNPROJECTOR_MAKENSIS)
    message(STATUS "There is no makensis: a zip is packed, and no installer")
else()
    configure_file(windows_installer.cmake.in windows_installer.cmake @ONLY)
    set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_BINARY_DIR}/windows_installer.cmake)
endif()
