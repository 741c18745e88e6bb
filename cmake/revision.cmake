# cmake -D SOURCE=… -D TEMPLATE=… -D OUTPUT=… -D … -P revision.cmake
#
# Fills a template with what git says of the tree now. The output is touched only when it changes,
# so that a build after a commit compiles one file.
find_package(Git QUIET)
set(HEXAGAIT_REVISION "unknown")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty
                  WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE revision
                  RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(HEXAGAIT_REVISION "${revision}")
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
