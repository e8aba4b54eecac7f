# SPDX-License-Identifier: Apache-2.0
# Every library comes from a Debian package named in packages.txt.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)
find_package(ZLIB REQUIRED)
set(Python_EXECUTABLE ${IONSKIN_PYTHON})
find_package(Python REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 REQUIRED)

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

pkg_check_modules(minizip REQUIRED IMPORTED_TARGET minizip)
ionskin_find_library(dep_toml11 toml.hpp "")
# By hand: its package looks for glog and gflags, which we do not use.
ionskin_find_library(dep_ceres ceres/ceres.h ceres)
ionskin_find_library(dep_udunits2 udunits2.h udunits2)
ionskin_find_library(dep_cholmod cholmod.h cholmod HEADER_PATHS /usr/include/suitesparse)
# The serial flavour, which h5py loads too.
pkg_check_modules(hdf5 REQUIRED IMPORTED_TARGET hdf5-serial)
add_library(dep_hdf5 INTERFACE IMPORTED)
find_library(hdf5_high_level hdf5_hl PATHS ${hdf5_LIBRARY_DIRS} NO_DEFAULT_PATH REQUIRED)
target_link_libraries(dep_hdf5 INTERFACE ${hdf5_high_level} PkgConfig::hdf5)
# CHOLMOD's own threads are held back through it.
find_package(OpenMP REQUIRED COMPONENTS CXX)
pkg_check_modules(openblas REQUIRED IMPORTED_TARGET openblas)
add_library(dep_openblas INTERFACE IMPORTED)
target_link_libraries(dep_openblas INTERFACE PkgConfig::openblas)
