# Every foreign library, found once, and only where something needs it. ODE, tinyxml2, assimp and KDL by
# pkg-config: they come without CMake targets, or with some that need more than they do.

# Those that our libraries link to: the CMake target; how find_package(hexagait) looks for it; its
# name for pkg-config; the Debian package that has it.
set(hexagait_foreign_libraries
    "Eigen3::Eigen|find_dependency(Eigen3 3.4 NO_MODULE)|eigen3|libeigen3-dev"
    "fmt::fmt|find_dependency(fmt)|fmt|libfmt-dev"
    "yaml-cpp|find_dependency(yaml-cpp)|yaml-cpp|libyaml-cpp-dev"
    "box2d::box2d|find_dependency(box2d)|box2d|libbox2d-dev"
    "PkgConfig::tinyxml2|hexagait_find_by_pkg_config(tinyxml2)|tinyxml2|libtinyxml2-dev"
    "PkgConfig::assimp|hexagait_find_by_pkg_config(assimp)|assimp|libassimp-dev"
    "PkgConfig::ode|hexagait_find_by_pkg_config(ode)|ode|libode-dev"
    "PkgConfig::libpng|hexagait_find_by_pkg_config(libpng)|libpng|libpng-dev"
    "PkgConfig::libwebsockets|hexagait_find_by_pkg_config(libwebsockets)|libwebsockets|libwebsockets-dev"
    "PkgConfig::zlib|hexagait_find_by_pkg_config(zlib)|zlib|zlib1g-dev")

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
if(HEXAGAIT_ACTIONS OR HEXAGAIT_VERIFY)
  find_package(fmt REQUIRED)
endif()
if(HEXAGAIT_ACTIONS)
  find_package(yaml-cpp REQUIRED)
endif()
if(HEXAGAIT_ACTIONS OR HEXAGAIT_SIM2D OR HEXAGAIT_SIM3D)
  find_path(hexagait_random123 Random123/philox.h REQUIRED)  # headers only, without a CMake package
endif()
if(HEXAGAIT_SIM2D)
  find_package(box2d REQUIRED)
endif()
if(HEXAGAIT_URDF OR HEXAGAIT_SIM3D)
  find_package(PkgConfig REQUIRED)
endif()
if(HEXAGAIT_URDF)
  pkg_check_modules(tinyxml2 REQUIRED IMPORTED_TARGET tinyxml2)
endif()
if(HEXAGAIT_MESHES)
  pkg_check_modules(assimp REQUIRED IMPORTED_TARGET assimp)
endif()
if(HEXAGAIT_SIM3D)
  pkg_check_modules(ode REQUIRED IMPORTED_TARGET ode)
endif()
if(HEXAGAIT_PNG)
  pkg_check_modules(libpng REQUIRED IMPORTED_TARGET libpng)
endif()
if(HEXAGAIT_VIEWER)
  pkg_check_modules(libwebsockets REQUIRED IMPORTED_TARGET libwebsockets)
  pkg_check_modules(zlib REQUIRED IMPORTED_TARGET zlib)
  if(HEXAGAIT_PAGE)
    find_program(HEXAGAIT_NODE NAMES node nodejs)
    find_program(HEXAGAIT_NPM npm)
  endif()
  if(HEXAGAIT_PAGE AND NOT (HEXAGAIT_NODE AND HEXAGAIT_NPM))
    message(STATUS "No Node.js with npm: hexagait steer is built without its page")
  endif()
endif()
if(HEXAGAIT_FIGURES)
  find_package(Boost REQUIRED)  # headers only: statistics
  find_package(nlohmann_json REQUIRED)
endif()
if(HEXAGAIT_TOOLS)
  find_package(CLI11 REQUIRED)
endif()

if(HEXAGAIT_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  include(GoogleTest)
  pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt)            # an oracle of optimisation
  pkg_check_modules(orocos_kdl REQUIRED IMPORTED_TARGET orocos-kdl)  # an oracle of kinematics
endif()
if(HEXAGAIT_BENCH)
  find_package(benchmark REQUIRED)
endif()
