# SPDX-License-Identifier: Apache-2.0
# `make install` and `make package`: programs, library, Python package, data, manual page, completion.

# One library for programs of others: what the folders are made of stays inside.
add_library(ionskin_library SHARED ${CMAKE_CURRENT_LIST_DIR}/library.cpp)
target_link_libraries(ionskin_library PRIVATE ionskin_study)
# Whole: nothing in here asks for their contents. CMake's own WHOLE_ARCHIVE refuses what other archives ask for too.
set(archives $<TARGET_FILE:ionskin_study> $<TARGET_FILE:ionskin_results> $<TARGET_FILE:ionskin_case>
    $<TARGET_FILE:ionskin_base>)
target_link_options(ionskin_library PRIVATE "LINKER:--whole-archive" ${archives} "LINKER:--no-whole-archive")
target_compile_features(ionskin_library INTERFACE cxx_std_20)
target_include_directories(ionskin_library INTERFACE $<INSTALL_INTERFACE:include>)
set_target_properties(ionskin_library PROPERTIES OUTPUT_NAME ionskin EXPORT_NAME ionskin
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

install(TARGETS ionskin RUNTIME DESTINATION ${IONSKIN_BIN_FOLDER})
# The library of FMUs stands beside the program that puts it into them.
foreach(part ionskin-solver ionskin-extras ionskin-studio ionskin_live_fmu_library)
  if(TARGET ${part})
    install(TARGETS ${part} DESTINATION ${IONSKIN_LIBEXEC_FOLDER})
  endif()
endforeach()
install(TARGETS ionskin_library EXPORT ionskin LIBRARY DESTINATION ${IONSKIN_LIBRARY_FOLDER})

# What a program of others needs to read and run a case, and what that includes.
foreach(header base/error base/progress base/system/interrupt case/case case/document/case_document
        case/reading/read_case case/schema/schema case/text/place laws/law_parameter readout/metrics readout/signals results/summary_json
        shapes/height_map shapes/shape study/errors/stated_errors study/run/run_case units/dimension)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/src/ionskin/${header}.hpp DESTINATION ${IONSKIN_INCLUDE_FOLDER}/${folder})
endforeach()
# The loop of a controller needs no more than this.
set_target_properties(ionskin_live_library PROPERTIES EXPORT_NAME live)
target_include_directories(ionskin_live_library INTERFACE $<INSTALL_INTERFACE:include>)
install(TARGETS ionskin_live_library EXPORT ionskin LIBRARY DESTINATION ${IONSKIN_LIBRARY_FOLDER})
install(FILES ${PROJECT_SOURCE_DIR}/src/ionskin/live/interface/ionskin_live.h ${PROJECT_SOURCE_DIR}/src/ionskin/live/interface/ionskin_live.hpp
        DESTINATION include)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/ionskin-config-version.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT ionskin NAMESPACE ionskin:: FILE ionskin-config.cmake DESTINATION ${IONSKIN_CMAKE_FOLDER})
install(FILES ${CMAKE_BINARY_DIR}/ionskin-config-version.cmake DESTINATION ${IONSKIN_CMAKE_FOLDER})

if(IONSKIN_PYTHON_MODULE)
  install(TARGETS _ionskin_solver LIBRARY DESTINATION ${IONSKIN_PYTHON_FOLDER})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/ionskin DESTINATION ${IONSKIN_PYTHON_FOLDER}
        PATTERN __pycache__ EXCLUDE)
# Debian's Python looks below /usr/local in a folder of its own version, which then names ours.
install(CODE "
  if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr/local\")
    set(file /usr/local/lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages/ionskin.pth)
    file(WRITE \"\$ENV{DESTDIR}\${file}\" \"/usr/local/${IONSKIN_PYTHON_FOLDER}\\n\")
    list(APPEND CMAKE_INSTALL_MANIFEST_FILES \${file})
  endif()")

install(DIRECTORY ${PROJECT_SOURCE_DIR}/cases ${PROJECT_SOURCE_DIR}/materials DESTINATION ${IONSKIN_DATA_FOLDER}
        USE_SOURCE_PERMISSIONS)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CITATION.cff
              ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/packaging/copyright DESTINATION ${IONSKIN_DOC_FOLDER})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${IONSKIN_DOC_FOLDER}/examples)

# The program writes them itself.
add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/share/ionskin.1.gz ${CMAKE_BINARY_DIR}/share/ionskin
  COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/share
  COMMAND ionskin man > ${CMAKE_BINARY_DIR}/share/ionskin.1
  COMMAND gzip -9nf ${CMAKE_BINARY_DIR}/share/ionskin.1
  COMMAND ionskin completion bash > ${CMAKE_BINARY_DIR}/share/ionskin
  DEPENDS ionskin VERBATIM)
add_custom_target(ionskin_shell_files ALL DEPENDS ${CMAKE_BINARY_DIR}/share/ionskin.1.gz ${CMAKE_BINARY_DIR}/share/ionskin)
install(FILES ${CMAKE_BINARY_DIR}/share/ionskin.1.gz DESTINATION share/man/man1)
install(FILES ${CMAKE_BINARY_DIR}/share/ionskin DESTINATION share/bash-completion/completions)

# For pip: scripts/make_wheel.py. It takes what is built.
add_custom_target(wheel COMMAND ${IONSKIN_PYTHON} ${PROJECT_SOURCE_DIR}/scripts/make_wheel.py ${CMAKE_BINARY_DIR} ${PROJECT_VERSION}
                  DEPENDS ionskin ionskin_live_library USES_TERMINAL VERBATIM)
foreach(part ionskin-extras ionskin-studio ionskin_live_fmu_library _ionskin_solver)
  if(TARGET ${part})
    add_dependencies(wheel ${part})
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ionskin)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/package)
set(CPACK_PACKAGE_CONTACT "The ionskin contributors <ionskin@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of ionic artificial skins")
set(CPACK_PACKAGE_DESCRIPTION "Frictional contact of a slider with a layered ionic polymer-metal skin, and the
electrode currents of the ion transport that its shear drives: a program, a Python package and a C++ library.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# The extension module is made for one version of Python.
math(EXPR next_python "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}~), \
python3 (<< ${Python_VERSION_MAJOR}.${next_python}), python3-numpy, python3-h5py, python3-matplotlib, python3-contourpy, python3-pil, python3-jinja2")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "man-db, bash-completion, python3-distributed, openssl, python3-openturns, python3-scipy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-xarray, cmake, g++")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/postinst ${PROJECT_SOURCE_DIR}/packaging/prerm
    ${PROJECT_SOURCE_DIR}/packaging/triggers)
include(CPack)
