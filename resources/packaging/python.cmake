# The Python module, for this system's Python and as a wheel.
set(UNPROJECTOR_PYTHON_DIR "" CACHE STRING "The folder, below the prefix, that the Python module is installed in; empty: where its Python looks below /usr")
set(python_dir "${UNPROJECTOR_PYTHON_DIR}")
if(NOT python_dir AND Python_EXECUTABLE STREQUAL "/usr/bin/python3" AND EXISTS /usr/lib/python3/dist-packages)
    set(python_dir lib/python3/dist-packages) # Debian's
elseif(NOT python_dir)
    set(python_dir lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/site-packages)
endif()
string(REGEX MATCH "^[0-9]+[.][0-9]+" numpy_minimum "${Python_NumPy_VERSION}")
configure_file(METADATA.in ${CMAKE_CURRENT_BINARY_DIR}/METADATA @ONLY)

get_target_property(module_files unprojector_python UNPROJECTOR_PACKAGE_FILES)
install(TARGETS unprojector_python LIBRARY DESTINATION ${python_dir}/unprojector COMPONENT python)
install(FILES ${module_files} DESTINATION ${python_dir}/unprojector COMPONENT python)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/METADATA DESTINATION ${python_dir}/unprojector-${PROJECT_VERSION}.dist-info COMPONENT python)

# The wheel is for this machine and others with the same distribution: the libraries that the module
# is linked with (Embree and those of image formats) are not inside.
add_custom_target(unprojector_wheel
    COMMAND ${Python_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/wheel.py --metadata ${CMAKE_CURRENT_BINARY_DIR}/METADATA
            --licence ${PROJECT_SOURCE_DIR}/LICENSE --licence ${CMAKE_CURRENT_SOURCE_DIR}/copyright "--strip=${CMAKE_STRIP}"
            --out ${PROJECT_BINARY_DIR} $<TARGET_FILE:unprojector_python> ${module_files}
    VERBATIM COMMENT "Packing the wheel")
add_dependencies(unprojector_wheel unprojector_python)
