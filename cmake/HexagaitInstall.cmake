# find_package(hexagait COMPONENTS …) brings back, after an install, what was built: a target for every
# room and one for every component, hexagait::controller …; without components, all of them.

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hexagait)
set(robots_dir ${CMAKE_INSTALL_DATADIR}/hexagait/robots)

add_library(hexagait INTERFACE)
add_library(hexagait::hexagait ALIAS hexagait)
set(components)
foreach(component controller sim verify urdf actions sim2d sim3d walk figures sweeps)
  get_property(rooms GLOBAL PROPERTY hexagait_rooms_of_${component})
  if(NOT rooms)
    continue()
  endif()
  list(APPEND components ${component})
  if(NOT component IN_LIST rooms)  # several rooms, or one of another name
    add_library(hexagait_${component} INTERFACE)
    add_library(hexagait::${component} ALIAS hexagait_${component})
    set_target_properties(hexagait_${component} PROPERTIES EXPORT_NAME ${component})
    list(TRANSFORM rooms PREPEND hexagait_)
    target_link_libraries(hexagait_${component} INTERFACE ${rooms})
    install(TARGETS hexagait_${component} EXPORT hexagait-${component}-targets COMPONENT ${component})
  endif()
  target_link_libraries(hexagait INTERFACE hexagait_${component})
  install(EXPORT hexagait-${component}-targets NAMESPACE hexagait:: DESTINATION ${config_dir}
          COMPONENT ${component})
endforeach()
install(TARGETS hexagait EXPORT hexagait-targets)
install(EXPORT hexagait-targets NAMESPACE hexagait:: DESTINATION ${config_dir})

include(CMakePackageConfigHelpers)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/hexagaitConfig.cmake.in hexagaitConfig.cmake
                              INSTALL_DESTINATION ${config_dir} PATH_VARS robots_dir)
write_basic_package_version_file(hexagaitConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hexagaitConfig.cmake
              ${PROJECT_BINARY_DIR}/hexagaitConfigVersion.cmake
        DESTINATION ${config_dir})

install(DIRECTORY robots/ DESTINATION ${robots_dir})
install(DIRECTORY actions/ DESTINATION ${CMAKE_INSTALL_DATADIR}/hexagait/actions)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
if(TARGET hexagait_app)
  install(TARGETS hexagait_app)
endif()

# `cpack -G DEB` in the build directory makes one package of it all.
if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_PACKAGE_CONTACT "The hexagait authors")
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
      "libbox2d-dev, libeigen3-dev, libfmt-dev, libode-dev, liburdfdom-dev, libyaml-cpp-dev, nlohmann-json3-dev, pkg-config, gnuplot-nox")
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  include(CPack)
endif()
