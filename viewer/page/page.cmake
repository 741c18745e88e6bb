# The page: bundled by esbuild, compressed, and put into the library as bytes. npm brings three and
# esbuild once per build directory, from package-lock.json; nothing is fetched after that, and the page
# itself never asks anybody but its server.
set(page_source ${CMAKE_CURRENT_SOURCE_DIR}/page)
set(page_build ${CMAKE_CURRENT_BINARY_DIR}/page)
set(page_by hexagait/viewer/server/page_by_none.cpp)
if(HEXAGAIT_PAGE AND HEXAGAIT_NODE AND HEXAGAIT_NPM)
  file(MAKE_DIRECTORY ${page_build})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_source}/package-lock.json)
  file(SHA256 ${page_source}/package-lock.json lock)
  set(stamp ${page_build}/node_modules/.of-${lock})
  if(NOT EXISTS ${stamp})
    message(STATUS "Page of hexagait steer: npm ci")
    configure_file(${page_source}/package.json ${page_build}/package.json COPYONLY)
    configure_file(${page_source}/package-lock.json ${page_build}/package-lock.json COPYONLY)
    execute_process(
      COMMAND ${HEXAGAIT_NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
      WORKING_DIRECTORY ${page_build} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE said)
    if(failed)
      message(WARNING "npm can't fetch what the page of hexagait steer is built from, so it is built "
                      "without: ${said}")
    else()
      file(TOUCH ${stamp})
    endif()
  endif()
  if(EXISTS ${stamp})
    set(page_by ${page_build}/page_files.cpp)
    file(GLOB page_files CONFIGURE_DEPENDS ${page_source}/src/*)
    add_custom_command(
      OUTPUT ${page_by} DEPENDS ${page_files} ${page_source}/build.mjs ${stamp} VERBATIM
      COMMAND ${HEXAGAIT_NODE} ${page_source}/build.mjs ${page_source}/src ${page_build})
  endif()
endif()
target_sources(hexagait_viewer PRIVATE ${page_by})
