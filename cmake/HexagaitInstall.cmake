# find_package(hexagait COMPONENTS …) and pkg-config bring back, after an install, what was built: a
# target for every room and one for every component, hexagait::controller …, and hexagait-COMPONENT.pc.
# Who needs whom is what hexagait_module() was told.

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hexagait)
set(data_dir ${CMAKE_INSTALL_DATADIR}/hexagait)

# hexagait_foreign(COMPONENT FIELD OUT): of the foreign libraries of a component their FIELD, see
# HexagaitDependencies: 0 target, 1 how to find it, 2 its name for pkg-config, 3 its Debian package.
function(hexagait_foreign component field out)
  get_property(used GLOBAL PROPERTY hexagait_foreign_of_${component})
  set(result)
  foreach(row IN LISTS hexagait_foreign_libraries)
    string(REPLACE "|" ";" row "${row}")
    list(GET row 0 target)
    if(target IN_LIST used)
      list(GET row ${field} value)
      list(APPEND result "${value}")
    endif()
  endforeach()
  set(${out} "${result}" PARENT_SCOPE)
endfunction()

# hexagait-COMPONENT.pc. A static library brings all that it needs, a shared one what its headers need.
function(hexagait_install_pc component)
  get_property(rooms GLOBAL PROPERTY hexagait_rooms_of_${component})
  get_property(needs GLOBAL PROPERTY hexagait_needs_of_${component})
  list(REMOVE_DUPLICATES needs)
  hexagait_foreign(${component} 2 foreign)
  list(REVERSE rooms)  # a static library stands before those that it needs
  set(libraries)
  foreach(room IN LISTS rooms)
    get_target_property(type hexagait_${room} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      string(APPEND libraries " -lhexagait_${room}")
    endif()
  endforeach()
  list(TRANSFORM needs PREPEND hexagait-)
  set(requires ${needs})
  set(requires_private)
  foreach(library IN LISTS foreign)
    if(BUILD_SHARED_LIBS AND NOT library STREQUAL "eigen3")
      list(APPEND requires_private ${library})
    else()
      list(APPEND requires ${library})
    endif()
  endforeach()
  list(JOIN requires ", " requires)
  list(JOIN requires_private ", " requires_private)
  file(CONFIGURE OUTPUT hexagait-${component}.pc @ONLY CONTENT [[
prefix=${pcfiledir}/@up@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: hexagait-@component@
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Requires: @requires@
Requires.private: @requires_private@
Libs: -L${libdir}@libraries@
Cflags: -I${includedir} -ffp-contract=off
]])
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hexagait-${component}.pc
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)  # so that a tree can be moved
string(REGEX REPLACE "/$" "" up "${up}")

add_library(hexagait INTERFACE)
add_library(hexagait::hexagait ALIAS hexagait)
get_property(components GLOBAL PROPERTY hexagait_components)
set(needs_of_components)  # for the configuration: all that each needs, however far below
set(find_foreign)
set(debian_packages)
foreach(component IN LISTS components)
  get_property(rooms GLOBAL PROPERTY hexagait_rooms_of_${component})
  if(NOT component IN_LIST rooms)  # several rooms, or one of another name
    add_library(hexagait_${component} INTERFACE)
    add_library(hexagait::${component} ALIAS hexagait_${component})
    set_target_properties(hexagait_${component} PROPERTIES EXPORT_NAME ${component})
    list(TRANSFORM rooms PREPEND hexagait_)
    target_link_libraries(hexagait_${component} INTERFACE ${rooms})
    install(TARGETS hexagait_${component} EXPORT hexagait-${component}-targets)
  elseif(NOT rooms STREQUAL component)
    message(FATAL_ERROR "Component ${component} has the rooms ${rooms}; no room of several may have its name")
  endif()
  target_link_libraries(hexagait INTERFACE hexagait_${component})
  install(EXPORT hexagait-${component}-targets NAMESPACE hexagait:: DESTINATION ${config_dir})
  hexagait_install_pc(${component})

  get_property(needs GLOBAL PROPERTY hexagait_needs_of_${component})
  set(closure_of_${component} ${needs})
  foreach(needed IN LISTS needs)
    list(APPEND closure_of_${component} ${closure_of_${needed}})
  endforeach()
  list(REMOVE_DUPLICATES closure_of_${component})
  string(APPEND needs_of_components "set(hexagait_needs_${component} ${closure_of_${component}})\n")
  hexagait_foreign(${component} 1 commands)
  foreach(command IN LISTS commands)
    string(APPEND find_foreign "if(\"${component}\" IN_LIST hexagait_wanted)\n  ${command}\nendif()\n")
  endforeach()
  hexagait_foreign(${component} 3 packages)
  list(APPEND debian_packages ${packages})
endforeach()
list(REMOVE_DUPLICATES debian_packages)
install(TARGETS hexagait EXPORT hexagait-targets)
install(EXPORT hexagait-targets NAMESPACE hexagait:: DESTINATION ${config_dir})

include(CMakePackageConfigHelpers)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/hexagaitConfig.cmake.in hexagaitConfig.cmake
                              INSTALL_DESTINATION ${config_dir} PATH_VARS data_dir)
write_basic_package_version_file(hexagaitConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hexagaitConfig.cmake
              ${PROJECT_BINARY_DIR}/hexagaitConfigVersion.cmake
        DESTINATION ${config_dir})

install(DIRECTORY robots actions paths DESTINATION ${data_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR}
        PATTERN "hexagait.1" EXCLUDE REGEX "examples/CMakeLists.txt$" EXCLUDE)
if(HEXAGAIT_TOOLS)
  install(TARGETS hexagait_app)
  install(DIRECTORY sweeps DESTINATION ${data_dir})
  install(FILES docs/hexagait.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()

# `cpack -G DEB` in the build directory makes one package of it all. Of the libraries that the headers
# and archives need, the development packages; of those that the command is linked to, what dpkg finds.
if(PROJECT_IS_TOP_LEVEL)
  list(JOIN debian_packages ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
  set(CPACK_PACKAGE_CONTACT "The hexagait authors")
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, pkg-config")
  if(HEXAGAIT_TOOLS)
    set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
  endif()
  include(CPack)
endif()
