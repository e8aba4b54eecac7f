# SPDX-License-Identifier: Apache-2.0

# ionskin_folder(NAME [VECTOR] SOURCES ... [DEPENDS ...] [PRIVATE_DEPENDS ...])
# One static library per source folder. DEPENDS are linked publicly, PRIVATE_DEPENDS privately.
# VECTOR compiles the folder with the vector instructions of IONSKIN_VECTOR_LEVEL.
function(ionskin_folder name)
  cmake_parse_arguments(ARG "VECTOR" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(ionskin_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(ionskin_${name} PUBLIC ionskin_flags ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
  # Sources of a folder include the same headers: twice the preset's number of them together parse these half as often.
  set_target_properties(ionskin_${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 16)
  if(ARG_VECTOR)
    target_link_libraries(ionskin_${name} PRIVATE ionskin_vector_flags)
  elseif(CMAKE_BUILD_TYPE STREQUAL "Release")
    # No loop here costs a user time; the compiler's does.
    target_compile_options(ionskin_${name} PRIVATE -O1)
  endif()
endfunction()
