# Every foreign library, found once. ODE, urdfdom and KDL come without CMake targets: pkg-config.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(yaml-cpp REQUIRED)
find_package(fmt REQUIRED)
find_package(box2d REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(urdfdom REQUIRED IMPORTED_TARGET urdfdom)
pkg_check_modules(ode REQUIRED IMPORTED_TARGET ode)

if(HEXAGAIT_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  include(GoogleTest)
  pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt)            # an oracle of optimisation
  pkg_check_modules(orocos_kdl REQUIRED IMPORTED_TARGET orocos-kdl)  # an oracle of kinematics
endif()
if(HEXAGAIT_TOOLS)
  find_package(Boost REQUIRED)  # headers only: statistics
  find_package(CLI11 REQUIRED)
  find_package(nlohmann_json REQUIRED)
endif()
if(HEXAGAIT_BENCH)
  find_package(benchmark REQUIRED)
endif()
