# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# The tests of a test program as CTest sees them: gudgeon_add_gtests(TARGET FOLDER property value ...).
# One by one, each in a process of its own. Under sanitizers a process takes 0.4 s of processor time to start, a hundred
# times what most tests take: there a program is started a few times, each time with its share of the tests.
include(GoogleTest)

set(GUDGEON_TEST_SHARES 4)

function(gudgeon_add_gtests target folder)
  if(NOT GUDGEON_SANITIZE)
    gudgeon_discover_gtests(${target} ${folder} "*" ${ARGN})
    return()
  endif()
  math(EXPR last "${GUDGEON_TEST_SHARES} - 1")
  foreach(share RANGE ${last})
    set(name ${folder}/share_${share})
    add_test(NAME ${name} COMMAND ${target})
    set_tests_properties(${name} PROPERTIES ${ARGN}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${GUDGEON_TEST_SHARES};GTEST_SHARD_INDEX=${share}")
  endforeach()
endfunction()

# Listing the tests before they run, not while building, keeps a broken program from breaking the build.
function(gudgeon_discover_gtests target folder filter)
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES TEST_PREFIX ${folder}/
    TEST_FILTER "${filter}" PROPERTIES ${ARGN})
endfunction()

# The same, where those that the filter names set up a fixture for others. A share cannot be told apart from the others.
function(gudgeon_add_gtests_with_fixture target folder fixture filter)
  if(GUDGEON_SANITIZE)
    gudgeon_add_gtests(${target} ${folder} ${ARGN} FIXTURES_SETUP ${fixture})
    return()
  endif()
  gudgeon_discover_gtests(${target} ${folder} "${filter}" ${ARGN} FIXTURES_SETUP ${fixture})
  gudgeon_discover_gtests(${target} ${folder} "-${filter}" ${ARGN})
endfunction()
