# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# What `cmake --install` puts where: the program with its manual page and completions; the library as one archive with
# the headers its users need, for find_package(gudgeon). The target gudgeon_package builds all of it, and
# `cpack --config build/CPackConfig.cmake` makes a Debian package of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The floors of the library in one archive.
set(floors base geometry laws model system results sim analysis io library)
add_library(gudgeon_archive STATIC)
add_library(gudgeon::gudgeon ALIAS gudgeon_archive)
set_target_properties(gudgeon_archive PROPERTIES OUTPUT_NAME gudgeon EXPORT_NAME gudgeon LINKER_LANGUAGE CXX)
target_compile_features(gudgeon_archive INTERFACE cxx_std_20)
foreach(floor ${floors})
  get_target_property(type gudgeon_${floor} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    target_sources(gudgeon_archive PRIVATE $<TARGET_OBJECTS:gudgeon_${floor}>)
  endif()
endforeach()

# Linking takes the shared libraries below it, by the names they have at run time: those are there wherever the program
# runs, their development packages need not be. That of CVODE holds the matrices and vectors it works with.
function(gudgeon_link_runtime library)
  find_library(GUDGEON_LINK_${library} ${library} HINTS ${HDF5_LIBRARY_DIRS} ${TOMLPP_LIBRARY_DIRS} REQUIRED)
  mark_as_advanced(GUDGEON_LINK_${library})
  execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${GUDGEON_LINK_${library}}
    OUTPUT_VARIABLE headers ERROR_QUIET)
  if(headers MATCHES "SONAME +([^ \n]+)")
    set(flag -l:${CMAKE_MATCH_1})
  else()
    set(flag ${GUDGEON_LINK_${library}})
  endif()
  target_link_libraries(gudgeon_archive INTERFACE $<BUILD_INTERFACE:${GUDGEON_LINK_${library}}>
    $<INSTALL_INTERFACE:${flag}>)
endfunction()
foreach(library fmt ${TOMLPP_LIBRARIES} muparser ${HDF5_LIBRARIES} sundials_cvode)
  gudgeon_link_runtime(${library})
endforeach()
target_link_libraries(gudgeon_archive INTERFACE Threads::Threads)

# The umbrella header and what it includes, however far down; nothing else is public.
function(gudgeon_find_headers header found)
  set(known ${${found}} ${header})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/${header})
  file(STRINGS ${PROJECT_SOURCE_DIR}/src/${header} lines REGEX "^#include \"gudgeon/")
  foreach(line ${lines})
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included ${line})
    if(NOT included IN_LIST known)
      gudgeon_find_headers(${included} known)
    endif()
  endforeach()
  set(${found} ${known} PARENT_SCOPE)
endfunction()
gudgeon_find_headers(gudgeon/gudgeon.h public_headers)
list(TRANSFORM public_headers PREPEND ${PROJECT_SOURCE_DIR}/src/)
target_sources(gudgeon_archive INTERFACE
  FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${public_headers})

install(TARGETS gudgeon RUNTIME)
install(TARGETS gudgeon_archive EXPORT gudgeon_targets ARCHIVE FILE_SET HEADERS)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gudgeon)
install(EXPORT gudgeon_targets NAMESPACE gudgeon:: FILE gudgeonTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/packaging/gudgeonConfig.cmake.in
  ${PROJECT_BINARY_DIR}/packaging/gudgeonConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/packaging/gudgeonConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/packaging/gudgeonConfig.cmake
  ${PROJECT_BINARY_DIR}/packaging/gudgeonConfigVersion.cmake DESTINATION ${package_dir})

# Manual page and completions say what the built program says of itself.
set(shell_files ${PROJECT_BINARY_DIR}/packaging/gudgeon.1 ${PROJECT_BINARY_DIR}/packaging/gudgeon.bash
  ${PROJECT_BINARY_DIR}/packaging/_gudgeon)
file(GLOB scripts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/packaging/*.awk)
set(script ${PROJECT_SOURCE_DIR}/packaging/make_shell_files.sh)
add_custom_command(OUTPUT ${shell_files}
  COMMAND bash ${script} $<TARGET_FILE:gudgeon> ${PROJECT_BINARY_DIR}/packaging
  DEPENDS gudgeon ${script} ${scripts}
  COMMENT "Writing manual page and completions" VERBATIM)
set(schema ${PROJECT_BINARY_DIR}/packaging/model.schema.json)
add_custom_command(OUTPUT ${schema}
  COMMAND bash -c "\"$1\" keys --schema > \"$2\"" bash $<TARGET_FILE:gudgeon> ${schema}
  DEPENDS gudgeon
  COMMENT "Writing the schema of model files" VERBATIM)
add_custom_target(gudgeon_package ALL DEPENDS ${shell_files} ${schema})
add_dependencies(gudgeon_package gudgeon gudgeon_archive)
install(FILES ${PROJECT_BINARY_DIR}/packaging/gudgeon.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/packaging/gudgeon.bash RENAME gudgeon
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${PROJECT_BINARY_DIR}/packaging/_gudgeon DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${schema} DESTINATION ${CMAKE_INSTALL_DATADIR}/gudgeon)
install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "gudgeon contributors")
set(CPACK_PACKAGE_CONTACT "gudgeon contributors <gudgeon@localhost>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "librsvg2-bin")
set(CPACK_PACKAGE_DESCRIPTION
"gudgeon simulates planar mechanisms whose joints have clearance and predicts
their wear. A mechanism is a text file with units; a run is one command and one
self-describing HDF5 file. The C++ library is included: find_package(gudgeon).")
include(CPack)
