# SPDX-License-Identifier: Apache-2.0

# ionskin_folder(NAME [VECTOR] SOURCES ... [DEPENDS ...] [PRIVATE_DEPENDS ...])
# One static library per source folder. DEPENDS are linked publicly, PRIVATE_DEPENDS privately.
# VECTOR compiles the folder with the vector instructions of IONSKIN_VECTOR_LEVEL.
function(ionskin_folder name)
  cmake_parse_arguments(ARG "VECTOR" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(ionskin_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(ionskin_${name} PUBLIC ionskin_flags ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
  if(ARG_VECTOR)
    target_link_libraries(ionskin_${name} PRIVATE ionskin_vector_flags)
  else()
    target_link_libraries(ionskin_${name} PRIVATE ionskin_light_flags)
  endif()
endfunction()
