# Install and export: a consumer writes find_package(shatterpave) and links shatterpave::shatterpave. Of the headers only the
# public ones, include/shatterpave/, are installed.
include(CMakePackageConfigHelpers)

install(TARGETS shatterpave EXPORT shatterpave COMPONENT development)
install(TARGETS shatterpave_command shatterpave_rasters RUNTIME COMPONENT command)
install(DIRECTORY include/shatterpave DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        FILES_MATCHING PATTERN "*.h")
install(EXPORT shatterpave NAMESPACE shatterpave:: FILE shatterpaveTargets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shatterpave COMPONENT development)
configure_package_config_file(cmake/shatterpaveConfig.cmake.in ${PROJECT_BINARY_DIR}/shatterpaveConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shatterpave)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/shatterpaveConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/shatterpaveConfig.cmake ${PROJECT_BINARY_DIR}/shatterpaveConfigVersion.cmake
        cmake/link_dependencies.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shatterpave COMPONENT development)
