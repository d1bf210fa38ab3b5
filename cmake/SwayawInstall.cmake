# install(…) and find_package(swayaw).
include(CMakePackageConfigHelpers)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/swayaw-config.cmake.in
  ${PROJECT_BINARY_DIR}/swayaw-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swayaw)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/swayaw-config-version.cmake
  COMPATIBILITY SameMinorVersion)

install(EXPORT swayaw NAMESPACE swayaw:: FILE swayaw-targets.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swayaw)
install(FILES ${PROJECT_BINARY_DIR}/swayaw-config.cmake ${PROJECT_BINARY_DIR}/swayaw-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindGeographicLib.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swayaw)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/ships/ DESTINATION ${CMAKE_INSTALL_DATADIR}/swayaw/ships
  FILES_MATCHING PATTERN "*.toml")
