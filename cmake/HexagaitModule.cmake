# hexagait_module(NAME  SOURCES … [TESTS …] [PUBLIC …] [PRIVATE …])
#
# A library target hexagait::NAME with its tests. Headers, sources and tests lie side by side in
# NAME/hexagait/NAME, and NAME/ is the module's include root: a module can include only what it
# links to, and headers are spelt the same in the tree and when installed.
function(hexagait_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion
                         $<$<BOOL:${HEXAGAIT_WERROR}>:-Werror>)
endfunction()

function(hexagait_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;TESTS;TEST_LIBRARIES;PUBLIC;PRIVATE")
  list(TRANSFORM arg_SOURCES PREPEND hexagait/${name}/)
  list(TRANSFORM arg_TESTS PREPEND hexagait/${name}/)

  add_library(hexagait_${name} STATIC ${arg_SOURCES})
  add_library(hexagait::${name} ALIAS hexagait_${name})
  set_target_properties(hexagait_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(hexagait_${name} PUBLIC cxx_std_20)
  # No fused multiply-add: the same bits from every optimisation level that keeps IEEE arithmetic.
  target_compile_options(hexagait_${name} PUBLIC -ffp-contract=off)
  target_include_directories(hexagait_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(hexagait_${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  hexagait_warnings(hexagait_${name})

  install(TARGETS hexagait_${name} EXPORT hexagait-targets)
  install(DIRECTORY hexagait/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hexagait
          FILES_MATCHING PATTERN "*.hpp" PATTERN "detail" EXCLUDE)

  if(HEXAGAIT_TESTS AND arg_TESTS)
    hexagait_test(${name}_test SOURCES ${arg_TESTS} LIBRARIES hexagait::${name} ${arg_TEST_LIBRARIES})
  endif()
endfunction()

# What every test includes is read once: a quarter of the time that it takes to compile one. Only
# tests: that each header and source of the library includes what it uses, is seen by compiling it.
function(hexagait_precompiled target)
  if(NOT TARGET hexagait_test_headers)
    file(CONFIGURE OUTPUT test_headers.cpp CONTENT "")
    add_library(hexagait_test_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp)
    target_compile_features(hexagait_test_headers PRIVATE cxx_std_20)
    target_compile_options(hexagait_test_headers PRIVATE -ffp-contract=off)
    target_link_libraries(hexagait_test_headers PRIVATE Eigen3::Eigen GTest::gmock)
    target_precompile_headers(hexagait_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <Eigen/Geometry>)
    hexagait_warnings(hexagait_test_headers)
  endif()
  target_precompile_headers(${target} REUSE_FROM hexagait_test_headers)
endfunction()

# hexagait_test(NAME  SOURCES … LIBRARIES …): a GoogleTest program, one ctest entry per test.
function(hexagait_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gmock_main)
  hexagait_precompiled(${name})
  # Only where it is used: elsewhere ccache finds what another clone has compiled.
  foreach(source IN LISTS arg_SOURCES)
    file(STRINGS ${source} uses REGEX HEXAGAIT_SOURCE_DIR LIMIT_COUNT 1)
    if(uses)
      set_source_files_properties(${source} PROPERTIES COMPILE_DEFINITIONS
                                  HEXAGAIT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    endif()
  endforeach()
  hexagait_warnings(${name})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST)
endfunction()
