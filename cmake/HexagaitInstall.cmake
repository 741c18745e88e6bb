# hexagait::hexagait is all of the library; find_package(hexagait) brings it back after an install.

add_library(hexagait INTERFACE)
add_library(hexagait::hexagait ALIAS hexagait)
get_property(directories DIRECTORY PROPERTY SUBDIRECTORIES)
foreach(directory IN LISTS directories)
  cmake_path(GET directory FILENAME module)
  if(TARGET hexagait_${module})
    get_target_property(name hexagait_${module} EXPORT_NAME)  # hexagait_module() gives one
    if(name STREQUAL module)
      target_link_libraries(hexagait INTERFACE hexagait_${module})
    endif()
  endif()
endforeach()
install(TARGETS hexagait EXPORT hexagait-targets)

include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hexagait)
set(robots_dir ${CMAKE_INSTALL_DATADIR}/hexagait/robots)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/hexagaitConfig.cmake.in hexagaitConfig.cmake
                              INSTALL_DESTINATION ${config_dir} PATH_VARS robots_dir)
write_basic_package_version_file(hexagaitConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hexagaitConfig.cmake
              ${PROJECT_BINARY_DIR}/hexagaitConfigVersion.cmake
        DESTINATION ${config_dir})
install(EXPORT hexagait-targets NAMESPACE hexagait:: DESTINATION ${config_dir})

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
      "libeigen3-dev, libfmt-dev, libode-dev, liburdfdom-dev, libyaml-cpp-dev, pkg-config")
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  include(CPack)
endif()
