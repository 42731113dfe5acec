# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# One target a floor: gudgeon_add_floor(NAME [UNHURRIED] [READS] USES lower floors and libraries); READS is said of those
# that take bytes from outside.
# Headers and sources are the files of the floor's folder; each header is checked to stand alone.

add_library(gudgeon_options INTERFACE)
target_compile_features(gudgeon_options INTERFACE cxx_std_20)
target_compile_options(gudgeon_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<BOOL:${GUDGEON_WERROR}>:-Werror>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 sees overlaps in std::string that are not there (bug 105651)
  -ffp-contract=off  # same bits whatever instruction set the compiler is allowed to use
  # comparisons and square roots need neither errno nor floating-point traps
  -fno-math-errno -fno-trapping-math)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # Processors of the last fifteen years; rounding down is then one instruction, not a call.
  target_compile_options(gudgeon_options INTERFACE -march=x86-64-v2)
endif()
if(GUDGEON_SANITIZE)
  target_compile_options(gudgeon_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gudgeon_options INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(gudgeon_options INTERFACE GUDGEON_SANITIZE)
endif()
if(GUDGEON_FUZZ OR (GUDGEON_SANITIZE AND CMAKE_CXX_COMPILER_ID MATCHES "Clang"))
  set(GUDGEON_HAS_FUZZERS ON)
endif()
if(GUDGEON_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "GUDGEON_FUZZ takes Clang: -DCMAKE_CXX_COMPILER=clang++")
  endif()
  target_compile_options(gudgeon_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -g)
  target_link_options(gudgeon_options INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(gudgeon_options INTERFACE GUDGEON_SANITIZE)
endif()

# What only drives the engine, the program, the tests and the floors that are UNHURRIED, is not optimized under
# sanitizers: optimizing it takes longer than it saves. The floors that do the arithmetic are.
add_library(gudgeon_unhurried_options INTERFACE)
target_link_libraries(gudgeon_unhurried_options INTERFACE gudgeon_options)
if(GUDGEON_SANITIZE)
  target_compile_options(gudgeon_unhurried_options INTERFACE -O0)
endif()

function(gudgeon_add_floor name)
  cmake_parse_arguments(arg "UNHURRIED;READS" "" "USES;PRIVATE_USES" ${ARGN})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.h)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  set(target gudgeon_${name})
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE gudgeon_options ${arg_PRIVATE_USES})
    if(arg_UNHURRIED)
      target_link_libraries(${target} PRIVATE gudgeon_unhurried_options)
    endif()
    if(arg_READS AND GUDGEON_HAS_FUZZERS)
      target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)  # libFuzzer sees which lines an input reaches
    endif()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${headers})
  target_include_directories(${target} ${scope} ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} ${scope} ${arg_USES})
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()
