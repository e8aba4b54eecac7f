# SPDX-License-Identifier: Apache-2.0
# Every test belongs to the smallest tier that runs it, which is one of its labels:
#   quick  `make quick`, `make check` and `make check-long`
#   check  `make check` and `make check-long`
#   long   `make check-long` alone
# scripts/run_tests.py refuses a test without a tier or without a time limit.

# ionskin_tier(NAME quick|check|long [TIMEOUT SECONDS] [LABELS ...]): tier, further labels and time limit of a test. The
# limit ends what hangs; it is not a measure of speed: it is ten times what the slowest test of the tier takes.
function(ionskin_tier name tier)
  cmake_parse_arguments(ARG "" "TIMEOUT" "LABELS" ${ARGN})
  set(limit_quick 600)
  set(limit_check 1500)
  set(limit_long 5400)
  if(NOT DEFINED limit_${tier})
    message(FATAL_ERROR "${name}: ${tier} is not a tier; quick, check and long are")
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT ${limit_${tier}})
  endif()
  # Sanitizers make a program some ten times slower.
  if(IONSKIN_SANITIZE OR IONSKIN_SANITIZE_THREADS)
    math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${tier};${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()

# ionskin_python_test(NAME FILE [TIER check] [LONG] [MAY_SKIP REASON] [ENVIRONMENT ...]): the tests of a file of unittest's.
# With LONG, those that are marked @long_test are a test of their own, NAME_long, of the tier `long`. A skipped test is a
# failure unless MAY_SKIP, a regular expression, matches the reason.
function(ionskin_python_test name file)
  cmake_parse_arguments(ARG "LONG" "TIER;MAY_SKIP" "ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIER)
    set(ARG_TIER check)
  endif()
  set_property(GLOBAL APPEND PROPERTY IONSKIN_PYTHON_TEST_FILES ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  set(parts ${name})
  if(ARG_LONG)
    list(APPEND parts ${name}_long)
  endif()
  foreach(part ${parts})
    set(options)
    set(tier ${ARG_TIER})
    if(part STREQUAL "${name}_long")
      set(options --part long)
      set(tier long)
    elseif(ARG_LONG)
      set(options --part short)
    endif()
    if(ARG_MAY_SKIP)
      list(APPEND options --may-skip ${ARG_MAY_SKIP})
    endif()
    add_test(NAME ${part} COMMAND ${IONSKIN_PYTHON} ${PROJECT_SOURCE_DIR}/tests/run_file.py ${options}
                                  ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    ionskin_tier(${part} ${tier} LABELS program)
    set_tests_properties(${part} PROPERTIES
      ENVIRONMENT "IONSKIN_PROGRAM=${CMAKE_BINARY_DIR}/ionskin;PYTHONDONTWRITEBYTECODE=1;${ARG_ENVIRONMENT}")
  endforeach()
endfunction()

# Refuses a Python test file below this folder that no ionskin_python_test names: nothing would run it.
function(ionskin_require_python_tests)
  get_property(listed GLOBAL PROPERTY IONSKIN_PYTHON_TEST_FILES)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/test_*.py)
  list(REMOVE_ITEM files ${listed})
  if(files)
    message(FATAL_ERROR "${files}: no test runs it; name it in an ionskin_python_test")
  endif()
endfunction()

# ionskin_unit_test(FOLDER [USERS_FILES] [LONG] [TEMPLATES] [SHARDS N] SOURCES ... DEPENDS ...): one test program per source
# folder, built by the target unit_tests; its tests run in N parts. TEMPLATES says that the tests use Eigen, as the folder does: of
# a template that both compile the linker keeps the test's, which must be no slower than what ships. Tests of suites whose name ends in Long are a test of their
# own, unit_FOLDER_long. What reads or writes USERS_FILES also runs under the sanitizers in `make check`.
function(ionskin_unit_test folder)
  cmake_parse_arguments(ARG "USERS_FILES;LONG;TEMPLATES" "SHARDS" "SOURCES;DEPENDS" ${ARGN})
  add_executable(unit_${folder} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  target_link_libraries(unit_${folder} PRIVATE ionskin_flags ${ARG_DEPENDS} GTest::gtest_main)
  # Helpers of a folder's tests lie beside its CMakeLists.txt.
  target_include_directories(unit_${folder} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  # What is tested is optimised; the tests themselves compile in half the time without.
  if(ARG_TEMPLATES)
    target_link_libraries(unit_${folder} PRIVATE ionskin_vector_flags)
  else()
    target_compile_options(unit_${folder} PRIVATE -O0)
  endif()
  # Tests of different subjects use the same names for different things: fewer compile together than the presets say.
  set_target_properties(unit_${folder} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests UNITY_BUILD_BATCH_SIZE 8)
  add_dependencies(unit_tests unit_${folder})
  set(labels unit)
  if(ARG_USERS_FILES)
    list(APPEND labels users_files)
    add_dependencies(unit_tests_users_files unit_${folder})
  endif()
  set(shards 1)
  if(ARG_SHARDS)
    set(shards ${ARG_SHARDS})
  endif()
  math(EXPR last "${shards} - 1")
  foreach(shard RANGE ${last})
    set(name unit_${folder})
    if(shards GREATER 1)
      string(APPEND name _${shard})
    endif()
    add_test(NAME ${name} COMMAND unit_${folder} --gtest_filter=-*Long.*)
    ionskin_tier(${name} quick LABELS ${labels})
    if(shards GREATER 1) # parts of a long test run side by side, and begin early
      set_tests_properties(${name} PROPERTIES COST 50)
    endif()
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${shard}")
    list(APPEND tests ${name})
  endforeach()
  if(ARG_LONG)
    add_test(NAME unit_${folder}_long COMMAND unit_${folder} --gtest_filter=*Long.*)
    ionskin_tier(unit_${folder}_long long LABELS ${labels})
    list(APPEND tests unit_${folder}_long)
  endif()
  # No unit test has a reason to be skipped.
  set_tests_properties(${tests} PROPERTIES FAIL_REGULAR_EXPRESSION "\\[  SKIPPED \\]|DISABLED TEST|\\[==========\\] Running 0 tests")
endfunction()
