# hexagait_switch(NAME TEXT DEFAULT [NEEDED…]): an option that can only be on if all NEEDED are; where
# one is off, so is this, unless it is asked for: then hexagait_check_switches() says what is wrong.
function(hexagait_switch name text default)
  set(lacking)
  foreach(needed IN LISTS ARGN)
    if(NOT ${needed})
      list(APPEND lacking ${needed})
    endif()
  endforeach()
  if(lacking)
    set(default OFF)
  endif()
  option(${name} "${text}" ${default})
  if(${name} AND lacking)
    list(JOIN lacking ", " lacking)
    set_property(GLOBAL APPEND_STRING PROPERTY hexagait_conflicts
                 "\n  ${name} is ON, but it needs ${lacking}: turn that on as well, or ${name} OFF")
  endif()
endfunction()

function(hexagait_check_switches)
  get_property(conflicts GLOBAL PROPERTY hexagait_conflicts)
  if(conflicts)
    message(FATAL_ERROR "These switches contradict each other:${conflicts}")
  endif()
endfunction()

# The controller needs Eigen and is always built. All else can be left out, with what it depends on.
hexagait_switch(HEXAGAIT_URDF "Load robots from URDF; needs tinyxml2" ON)
hexagait_switch(HEXAGAIT_MESHES "Read the meshes of a URDF; needs assimp" ON HEXAGAIT_URDF)
hexagait_switch(HEXAGAIT_ACTIONS "Load Free Gait actions from YAML, and walk; needs yaml-cpp and fmt" ON)
hexagait_switch(HEXAGAIT_VERIFY "Prove the theorems on gaits case by case; needs fmt" ON)
hexagait_switch(HEXAGAIT_SIM2D "The slice model and Genghis in two dimensions; needs Box2D" ON)
hexagait_switch(HEXAGAIT_SIM3D "Robots in three dimensions; needs ODE" ON)
hexagait_switch(HEXAGAIT_FIGURES "Traces, figures and statistics of walks; needs Boost and nlohmann-json"
                ON HEXAGAIT_ACTIONS HEXAGAIT_SIM2D HEXAGAIT_SIM3D)
# Without libwebsockets this is off by itself: hexagait steer then says what it lacks.
if(HEXAGAIT_FIGURES AND NOT DEFINED HEXAGAIT_VIEWER)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(libwebsockets QUIET libwebsockets)
  endif()
  if(NOT libwebsockets_FOUND)
    set(libwebsockets_FOUND OFF)
    message(STATUS "No libwebsockets: HEXAGAIT_VIEWER (hexagait steer) is off")
  endif()
endif()
hexagait_switch(HEXAGAIT_VIEWER "Walks to watch and steer, hexagait steer; needs libwebsockets"
                "${libwebsockets_FOUND}" HEXAGAIT_FIGURES)
option(HEXAGAIT_PAGE "The page of hexagait steer, if Node.js and npm are there" ON)
hexagait_switch(HEXAGAIT_SWEEPS "Grids of trials by many processes" ON HEXAGAIT_FIGURES HEXAGAIT_URDF)
hexagait_switch(HEXAGAIT_TOOLS "The hexagait command, the experiments and the examples; needs CLI11"
                ${PROJECT_IS_TOP_LEVEL} HEXAGAIT_SWEEPS HEXAGAIT_VERIFY)
hexagait_switch(HEXAGAIT_TESTS "The tests; need GoogleTest, RapidCheck, NLopt and Orocos KDL"
                ${PROJECT_IS_TOP_LEVEL} HEXAGAIT_SWEEPS HEXAGAIT_VERIFY)
hexagait_switch(HEXAGAIT_BENCH "The benchmarks; need Google Benchmark" OFF HEXAGAIT_SWEEPS)
hexagait_switch(HEXAGAIT_FUZZ "The fuzzers of the loaders; need clang" OFF HEXAGAIT_ACTIONS HEXAGAIT_URDF)
option(HEXAGAIT_WERROR "Treat warnings as errors" OFF)
hexagait_check_switches()
