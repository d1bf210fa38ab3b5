# install(…), find_package(swayaw) and pkg-config.
include(CMakePackageConfigHelpers)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/swayaw-config.cmake.in
  ${PROJECT_BINARY_DIR}/swayaw-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swayaw)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/swayaw-config-version.cmake
  COMPATIBILITY SameMinorVersion)

install(EXPORT swayaw NAMESPACE swayaw:: FILE swayaw-targets.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swayaw COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/swayaw-config.cmake ${PROJECT_BINARY_DIR}/swayaw-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindGeographicLib.cmake ${CMAKE_CURRENT_LIST_DIR}/FindMatio.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swayaw COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/ships/ DESTINATION ${CMAKE_INSTALL_DATADIR}/swayaw/ships COMPONENT program
  FILES_MATCHING PATTERN "*.toml")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
install(FILES ${PROJECT_SOURCE_DIR}/THIRD_PARTY_NOTICES.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# Whoever links static libraries links what they use; shared ones know it themselves, and no public header asks for it.
set(pc_requires "")
set(pc_libraries "")
if(NOT BUILD_SHARED_LIBS)
  set(pc_requires " fmt tomlplusplus")
  set(pc_libraries " -pthread")
  if(SWAYAW_HAS_GEOGRAPHICLIB)
    string(PREPEND pc_libraries " ${GeographicLib_LIBRARY}")
  endif()
  if(SWAYAW_HAS_MATIO)
    string(PREPEND pc_libraries " ${Matio_LIBRARY}")
  endif()
endif()
set(pc_includes "")
foreach(folder ${SWAYAW_CERES_INCLUDE} ${SWAYAW_XSIMD_INCLUDE})
  if(IS_DIRECTORY ${folder} AND NOT folder IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    string(APPEND pc_includes " -I${folder}")
  endif()
endforeach()
# the prefix as seen from the file, so that the tree can be moved
file(RELATIVE_PATH pc_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(${CMAKE_CURRENT_LIST_DIR}/swayaw.pc.in ${PROJECT_BINARY_DIR}/swayaw.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/swayaw.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

option(SWAYAW_PACKAGES "Debian packages, by cpack; set by the preset debian" OFF)
if(SWAYAW_PACKAGES)
  include(${CMAKE_CURRENT_LIST_DIR}/SwayawPackages.cmake)
endif()
