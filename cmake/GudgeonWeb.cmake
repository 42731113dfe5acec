# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# The report's page: packages of web/package-lock.json, bundled by esbuild into one script and one style, which become
# a C++ source. gudgeon_add_page(TARGET) adds it. Users of the program need no Node.js.

find_program(NODE_PROGRAM NAMES node nodejs)
find_program(NPM_PROGRAM npm)
if(NOT NODE_PROGRAM OR NOT NPM_PROGRAM)
  message(FATAL_ERROR "Node.js and npm bundle the page of 'gudgeon report'; setup.sh installs them")
endif()

function(gudgeon_add_page target)
  set(web ${PROJECT_SOURCE_DIR}/web)
  set(out ${PROJECT_BINARY_DIR}/web)
  file(GLOB sources CONFIGURE_DEPENDS ${web}/src/*.js ${web}/src/*.css)

  # Beside the build, so that the sources stay clean.
  add_custom_command(OUTPUT ${out}/packages.stamp
    COMMAND ${CMAKE_COMMAND} -E copy ${web}/package.json ${web}/package-lock.json ${out}
    COMMAND ${CMAKE_COMMAND} -E env PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1
      ${NPM_PROGRAM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${out}/packages.stamp
    DEPENDS ${web}/package.json ${web}/package-lock.json
    WORKING_DIRECTORY ${out} COMMENT "Fetching the page's packages" VERBATIM)
  file(MAKE_DIRECTORY ${out})

  add_custom_command(OUTPUT ${out}/page_assets.cpp
    COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${out}/node_modules
      ${NODE_PROGRAM} ${out}/node_modules/esbuild/bin/esbuild ${web}/src/main.js
      --bundle --minify --target=es2020 --charset=utf8 --legal-comments=inline --log-level=warning
      --outfile=${out}/page.js
    COMMAND ${NODE_PROGRAM} ${web}/embed.mjs ${out}/page.js ${out}/page.css ${out}/page_assets.cpp
    DEPENDS ${out}/packages.stamp ${web}/embed.mjs ${sources}
    COMMENT "Bundling the report's page" VERBATIM)

  target_sources(${target} PRIVATE ${out}/page_assets.cpp)
  set_source_files_properties(${out}/page_assets.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
    COMPILE_OPTIONS -Wno-overlength-strings)  # longer than compilers must support; GCC and Clang do
endfunction()
