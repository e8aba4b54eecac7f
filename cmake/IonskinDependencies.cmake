# SPDX-License-Identifier: Apache-2.0
# Every library comes from a Debian package named in packages.txt; scripts/check_packages.py compares the two. What is
# REQUIRED is in its first tier; what else is missing leaves out a part.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(ZLIB REQUIRED)
set(Python_EXECUTABLE ${IONSKIN_PYTHON})
find_package(Python REQUIRED COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module)

# Prints a clear error when a library or header is missing.
function(ionskin_find_library target header library)
  cmake_parse_arguments(ARG "" "" "HEADER_PATHS;LIBRARY_PATHS" ${ARGN})
  find_path(${target}_include ${header} PATHS ${ARG_HEADER_PATHS} REQUIRED)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${${target}_include})
  if(NOT library STREQUAL "")
    find_library(${target}_library ${library} PATHS ${ARG_LIBRARY_PATHS} REQUIRED)
    target_link_libraries(${target} INTERFACE ${${target}_library})
  endif()
endfunction()

ionskin_find_library(dep_toml11 toml.hpp "")
ionskin_find_library(dep_udunits2 udunits2.h udunits2)
# The serial flavour, which h5py loads too.
pkg_check_modules(hdf5 REQUIRED IMPORTED_TARGET hdf5-serial)
add_library(dep_hdf5 INTERFACE IMPORTED)
find_library(hdf5_high_level hdf5_hl PATHS ${hdf5_LIBRARY_DIRS} NO_DEFAULT_PATH REQUIRED)
target_link_libraries(dep_hdf5 INTERFACE ${hdf5_high_level} PkgConfig::hdf5)

# ionskin_part(VARIABLE WHAT TIER FOUND...) sets VARIABLE to whether every FOUND is true, and else says which packages
# bring the part.
function(ionskin_part variable what tier)
  set(there ON)
  foreach(found IN LISTS ARGN)
    if(NOT ${found})
      set(there OFF)
    endif()
  endforeach()
  if(NOT there)
    message(STATUS "${what}: left out, needs packages of the tier '${tier}': scripts/install_packages.sh ${tier}")
  endif()
  set(${variable} ${there} PARENT_SCOPE)
endfunction()

# By hand: its package looks for glog and gflags, which we do not use.
find_path(ceres_include ceres/ceres.h)
find_library(ceres_library ceres)
ionskin_part(IONSKIN_FIT "ionskin fit" parts ceres_include ceres_library)
if(IONSKIN_FIT)
  add_library(dep_ceres INTERFACE IMPORTED)
  target_include_directories(dep_ceres SYSTEM INTERFACE ${ceres_include})
  target_link_libraries(dep_ceres INTERFACE ${ceres_library})
endif()
pkg_check_modules(minizip QUIET IMPORTED_TARGET minizip)
ionskin_part(IONSKIN_EXTRAS "ionskin live and verify" parts minizip_FOUND)
find_program(IONSKIN_NPM npm)
ionskin_part(IONSKIN_STUDIO "ionskin studio" parts IONSKIN_NPM)
find_package(pybind11 QUIET)
ionskin_part(IONSKIN_PYTHON_MODULE "Solver for Python" parts Python_Development.Module_FOUND pybind11_FOUND IONSKIN_FIT)
find_package(GTest QUIET)
find_package(benchmark QUIET)
ionskin_part(IONSKIN_TESTS "Tests and benchmarks" tests GTest_FOUND benchmark_FOUND IONSKIN_FIT IONSKIN_EXTRAS
             IONSKIN_STUDIO IONSKIN_PYTHON_MODULE)
