# hexagait_module(NAME  COMPONENT … SOURCES … [COLD] [TESTS …] [TEST_LIBRARIES …] [PUBLIC …]
#                 [PRIVATE …])
#
# A room: a library target hexagait::NAME with its tests. Headers, sources and tests lie side by side
# in hexagait/NAME below the room's folder, where there are many in folders of it. The room's folder is
# its include root: a room can include only what it links to, and headers are spelt the same in the tree
# and when installed. COMPONENT is the one of find_package(hexagait COMPONENTS …) that brings it; what
# lies in detail/ is not installed.

# Warnings, for our own targets only; and no fused multiply-add: the same bits from every processor and
# every optimisation level that keeps IEEE arithmetic. Those who link to us get this as well, from the
# room math: inline functions of our headers are compiled in their sources too. Nobody reads errno or the
# flags of floating-point exceptions after a square root: not to set them changes no result. Nor does
# that a function calls another one of its library without asking who else may define it.
#
# GCC collects garbage seldom: it takes a tenth less time, and a fifth more memory, 1.2 GB at most.
#
# hexagait_options(TARGET [COLD | TEST])  COLD: it spends no time, so it is compiled fast rather than to be fast;
#                                         TEST: it spends some
# The configuration Sanitize is that of the sanitize preset: see hexagait_fast_first().
function(hexagait_options target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COLD;TEST" "" "")
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off
                         -fno-math-errno -fno-trapping-math -fno-semantic-interposition
                         $<$<BOOL:${HEXAGAIT_WERROR}>:-Werror>
                         $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=400>
                         $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=400000>
                         $<$<AND:$<BOOL:${arg_COLD}>,$<CONFIG:Release>>:-Og>
                         $<$<AND:$<BOOL:${arg_TEST}>,$<CONFIG:Release>>:-O1>
                         $<$<AND:$<OR:$<BOOL:${arg_COLD}>,$<BOOL:${arg_TEST}>>,$<CONFIG:Sanitize>>:-O0>)
  if(arg_COLD)
    set_property(TARGET ${target} PROPERTY hexagait_cold TRUE)
  endif()
endfunction()

# hexagait_fast_first(PROGRAM), after its target_link_libraries: where Sanitize compiles its sources with -O0,
# it still computes with the optimised inline functions and templates of the rooms: of several definitions the
# linker takes the first, so that the rooms come before the objects of the program.
function(hexagait_fast_first program)
  get_target_property(queue ${program} LINK_LIBRARIES)
  while(queue)
    list(POP_FRONT queue library)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" library "${library}")
    string(REPLACE "hexagait::" "hexagait_" library "${library}")
    if(NOT library MATCHES "^hexagait_" OR NOT TARGET ${library} OR library IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${library})
    get_target_property(needs ${library} INTERFACE_LINK_LIBRARIES)
    get_target_property(type ${library} TYPE)
    get_target_property(cold ${library} hexagait_cold)
    if(needs)
      list(APPEND queue ${needs})
    endif()
    if(type STREQUAL STATIC_LIBRARY AND NOT cold)
      list(APPEND fast $<TARGET_FILE:${library}>)
    endif()
  endwhile()
  if(fast)
    target_link_options(${program} PRIVATE
      "$<$<CONFIG:Sanitize>:-Wl,--whole-archive;${fast};-Wl,--no-whole-archive>")
  endif()
endfunction()

function(hexagait_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COLD" "COMPONENT"
                        "SOURCES;TESTS;TEST_LIBRARIES;PUBLIC;PRIVATE")
  list(TRANSFORM arg_SOURCES PREPEND hexagait/${name}/)
  list(TRANSFORM arg_TESTS PREPEND hexagait/${name}/)

  set(scope PUBLIC)
  if(arg_SOURCES)
    add_library(hexagait_${name} ${arg_SOURCES})  # static, or shared with BUILD_SHARED_LIBS
    set_target_properties(hexagait_${name} PROPERTIES
      POSITION_INDEPENDENT_CODE ON DEFINE_SYMBOL "" INSTALL_RPATH "$ORIGIN"
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    if(arg_COLD)
      hexagait_options(hexagait_${name} COLD)
    else()
      hexagait_options(hexagait_${name})
    endif()
    # What is headers only and private, those who link to an installed room need not have.
    list(TRANSFORM arg_PRIVATE REPLACE "^(nlohmann_json::.*|Boost::headers)$" "$<BUILD_INTERFACE:\\1>")
    target_link_libraries(hexagait_${name} PRIVATE ${arg_PRIVATE})
  else()
    set(scope INTERFACE)
    add_library(hexagait_${name} INTERFACE)
  endif()
  add_library(hexagait::${name} ALIAS hexagait_${name})
  set_target_properties(hexagait_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(hexagait_${name} ${scope} cxx_std_20)
  target_include_directories(hexagait_${name} ${scope}
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(hexagait_${name} ${scope} ${arg_PUBLIC})

  hexagait_register(${name} ${arg_COMPONENT} ${arg_PUBLIC} ${arg_PRIVATE})
  install(TARGETS hexagait_${name} EXPORT hexagait-${arg_COMPONENT}-targets)
  install(DIRECTORY hexagait/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hexagait
          FILES_MATCHING PATTERN "*.hpp" PATTERN "detail" EXCLUDE)

  if(HEXAGAIT_TESTS AND arg_TESTS)
    hexagait_test(${name}_test SOURCES ${arg_TESTS}
                  LIBRARIES hexagait::${name} ${arg_TEST_LIBRARIES})
  endif()
endfunction()

# hexagait_register(ROOM COMPONENT LIBRARY…): for HexagaitInstall: the components in the order in which
# they build on each other, and of each its rooms, the components and the foreign libraries it needs.
function(hexagait_register room component)
  get_property(components GLOBAL PROPERTY hexagait_components)
  if(NOT component IN_LIST components)
    set_property(GLOBAL APPEND PROPERTY hexagait_components ${component})
  endif()
  set_property(GLOBAL APPEND PROPERTY hexagait_rooms_of_${component} ${room})
  set_property(GLOBAL PROPERTY hexagait_component_of_${room} ${component})
  foreach(library IN LISTS ARGN)
    if(library MATCHES "^hexagait::(.*)")
      get_property(other GLOBAL PROPERTY hexagait_component_of_${CMAKE_MATCH_1})
      if(NOT other STREQUAL component)
        set_property(GLOBAL APPEND PROPERTY hexagait_needs_of_${component} ${other})
      endif()
    elseif(NOT library MATCHES "BUILD_INTERFACE")
      set_property(GLOBAL APPEND PROPERTY hexagait_foreign_of_${component} ${library})
    endif()
  endforeach()
endfunction()

# hexagait_scripts(ROOM FILE…): gnuplot scripts and other texts hexagait/ROOM/FILE, built into the room's
# library. Its sources include <hexagait/ROOM/FILE.hpp> and have the text as scripts::ROOM::NAME, by
# the file's name without its ending; nothing reads the file after the build.
set(hexagait_embed_script ${CMAKE_CURRENT_LIST_DIR}/embed_script.cmake)
function(hexagait_scripts room)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  foreach(file IN LISTS ARGN)
    set(in ${CMAKE_CURRENT_SOURCE_DIR}/hexagait/${room}/${file})
    set(out ${generated}/hexagait/${room}/${file}.hpp)
    add_custom_command(
      OUTPUT ${out} DEPENDS ${in} ${hexagait_embed_script} VERBATIM
      COMMAND ${CMAKE_COMMAND} -DIN=${in} -DOUT=${out} -DROOM=${room} -P ${hexagait_embed_script})
    target_sources(hexagait_${room} PRIVATE ${out})
    list(APPEND headers ${out})
  endforeach()
  # A target that links to nothing: else Ninja writes no header, and compiles nothing of the room, before
  # all libraries are there that the room links to.
  add_custom_target(hexagait_${room}_scripts DEPENDS ${headers})
  add_dependencies(hexagait_${room} hexagait_${room}_scripts)
  target_include_directories(hexagait_${room} PRIVATE ${generated})
endfunction()

# What every test includes is read once: a quarter of the time that it takes to compile one. Only
# tests: that each header and source of the library includes what it uses, is seen by compiling it.
function(hexagait_precompiled target)
  if(NOT TARGET hexagait_test_headers)
    file(CONFIGURE OUTPUT test_headers.cpp CONTENT "")
    add_library(hexagait_test_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp)
    target_compile_features(hexagait_test_headers PRIVATE cxx_std_20)
    target_link_libraries(hexagait_test_headers PRIVATE Eigen3::Eigen GTest::gmock)
    target_precompile_headers(hexagait_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <Eigen/Geometry>)
    hexagait_options(hexagait_test_headers TEST)
  endif()
  target_precompile_headers(${target} REUSE_FROM hexagait_test_headers)
endfunction()

# hexagait_test(NAME  SOURCES … LIBRARIES …): a GoogleTest program, one ctest entry per test. A unity build joins
# its SOURCES, since most of their time is that of the templates which they share: where helpers have names that
# those of another test have, too, they are in a namespace that is named after the file.
function(hexagait_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} hexagait_source_path GTest::gmock_main)
  hexagait_precompiled(${name})
  set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 16)
  hexagait_options(${name} TEST)
  hexagait_fast_first(${name})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST)
endfunction()
