# SPDX-License-Identifier: Apache-2.0
# Compiler flags of our own code, collected in one interface target.
option(IONSKIN_SANITIZE "Address and undefined-behaviour sanitizers, fuzzers; needs clang" OFF)
option(IONSKIN_SANITIZE_THREADS "Thread sanitizer" OFF)
option(IONSKIN_ASSERTIONS "Keep assertions in an optimised build" OFF)
set(IONSKIN_VECTOR_LEVEL "x86-64-v3" CACHE STRING
    "Vector instructions of the physics: x86-64 (any machine), x86-64-v3 (AVX2), x86-64-v4 (AVX-512), native")

add_library(ionskin_flags INTERFACE)
target_compile_options(ionskin_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                       -Wno-missing-field-initializers -Werror)
target_include_directories(ionskin_flags INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_link_options(ionskin_flags INTERFACE -Wl,--as-needed)
# Units compiled with and without vector instructions share Eigen's inline functions: one alignment for all of them.
target_compile_definitions(ionskin_flags INTERFACE EIGEN_MAX_ALIGN_BYTES=64)
if(IONSKIN_SANITIZE)
  # What is found ends a test. Clang's warnings are not those that the code is kept free of.
  target_compile_options(ionskin_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer -Wno-error)
  target_link_options(ionskin_flags INTERFACE -fsanitize=address,undefined)
endif()
if(IONSKIN_SANITIZE_THREADS)
  target_compile_options(ionskin_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(ionskin_flags INTERFACE -fsanitize=thread)
endif()
if(IONSKIN_ASSERTIONS)
  target_compile_options(ionskin_flags INTERFACE -UNDEBUG)
endif()

# Sources in which no loop costs a user time: the compiler's does. Under the sanitizers half of that goes into optimisation.
add_library(ionskin_light_flags INTERFACE)
target_compile_options(ionskin_light_flags INTERFACE $<IF:$<BOOL:${IONSKIN_SANITIZE}>,-O0,-O1>)

# The physics folders use the vector level, and so does whatever else uses Eigen: of a template that two folders compile the linker
# keeps one. Everything that runs before the processor has been checked (apps, base) is compiled for any machine.
add_library(ionskin_vector_flags INTERFACE)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT IONSKIN_VECTOR_LEVEL STREQUAL "x86-64")
  target_compile_options(ionskin_vector_flags INTERFACE -march=${IONSKIN_VECTOR_LEVEL})
endif()
# What asks the processor for them before they are used.
set(IONSKIN_VECTOR_DEFINITIONS)
if(IONSKIN_VECTOR_LEVEL STREQUAL "x86-64-v3" OR IONSKIN_VECTOR_LEVEL STREQUAL "x86-64-v4")
  list(APPEND IONSKIN_VECTOR_DEFINITIONS IONSKIN_VECTOR_LEVEL_V3)
endif()
if(IONSKIN_VECTOR_LEVEL STREQUAL "x86-64-v4")
  list(APPEND IONSKIN_VECTOR_DEFINITIONS IONSKIN_VECTOR_LEVEL_V4)
endif()
