# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# The tests of a test program as CTest sees them: gudgeon_add_gtests(TARGET FOLDER FILTER property value ...).
# A program takes up to 0.1 s to start, and 0.4 s under sanitizers, far more than most tests take: it is started a few
# times, each time with its share of the tests that the filter names. Where a test takes seconds, each has a process of
# its own, so that the longest can go first; but not under sanitizers.
include(GoogleTest)

set(long_folders app random verification)

function(gudgeon_add_gtests target folder filter)
  if(folder IN_LIST long_folders AND NOT GUDGEON_SANITIZE)
    # Listing the tests before they run, not while building, keeps a broken program from breaking the build.
    gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES TEST_PREFIX ${folder}/
      TEST_FILTER "${filter}" PROPERTIES ${ARGN})
    return()
  endif()
  set(shares 1)
  if(GUDGEON_SANITIZE OR folder MATCHES "^(io|sim)$")
    set(shares 4)
  endif()
  math(EXPR last "${shares} - 1")
  foreach(share RANGE ${last})
    set(name ${folder}/share_${share})
    add_test(NAME ${name} COMMAND ${target} "--gtest_filter=${filter}")
    set_tests_properties(${name} PROPERTIES ${ARGN}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${shares};GTEST_SHARD_INDEX=${share}")
  endforeach()
endfunction()

# Those that the filter names, in one process, as a test of that name.
function(gudgeon_add_gtest_group target name filter)
  add_test(NAME ${name} COMMAND ${target} "--gtest_filter=${filter}")
  set_tests_properties(${name} PROPERTIES ${ARGN})
endfunction()
