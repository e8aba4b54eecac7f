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

# ionskin_unit_test(FOLDER [SHARDS N] SOURCES ... DEPENDS ...): one test program per source folder, built by the target
# unit_tests; its tests run in N parts.
function(ionskin_unit_test folder)
  cmake_parse_arguments(ARG "" "SHARDS" "SOURCES;DEPENDS" ${ARGN})
  add_executable(unit_${folder} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  target_link_libraries(unit_${folder} PRIVATE ionskin_flags ${ARG_DEPENDS} GTest::gtest_main)
  # Helpers of a folder's tests lie beside its CMakeLists.txt.
  target_include_directories(unit_${folder} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  # What is tested is optimised; the tests themselves compile in half the time without.
  target_compile_options(unit_${folder} PRIVATE -O0)
  set_target_properties(unit_${folder} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  if(ARG_SHARDS) # parts of a long test run side by side
    math(EXPR last "${ARG_SHARDS} - 1")
    foreach(shard RANGE ${last})
      add_test(NAME unit_${folder}_${shard} COMMAND unit_${folder})
      set_tests_properties(unit_${folder}_${shard} PROPERTIES LABELS unit COST 100
        ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${shard}")
    endforeach()
  else()
    add_test(NAME unit_${folder} COMMAND unit_${folder})
    set_tests_properties(unit_${folder} PROPERTIES LABELS unit)
  endif()
  add_dependencies(unit_tests unit_${folder})
endfunction()
