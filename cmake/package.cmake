# The manual page and completions for shells, which the command itself prints, and packages of all that is installed:
#   cpack --config build/CPackConfig.cmake -G DEB -B DIR    shatterpave_….deb, libshatterpave-dev_….deb
#   cpack --config build/CPackConfig.cmake -G TGZ -B DIR    one tarball, which runs from any folder where the libraries are
set(manual ${PROJECT_BINARY_DIR}/manual)
add_custom_command(
  OUTPUT ${manual}/shatterpave.1 ${manual}/shatterpave.bash ${manual}/_shatterpave
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:shatterpave_command> -DFOLDER=${manual}
          -P ${PROJECT_SOURCE_DIR}/cmake/manual.cmake
  DEPENDS shatterpave_command ${PROJECT_SOURCE_DIR}/cmake/manual.cmake VERBATIM)
add_custom_target(shatterpave_manual ALL DEPENDS ${manual}/shatterpave.1)
install(FILES ${manual}/shatterpave.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)
install(FILES ${manual}/shatterpave.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME shatterpave
        COMPONENT command)
install(FILES ${manual}/_shatterpave DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT command)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/shatterpave RENAME copyright COMPONENT command)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libshatterpave-dev RENAME copyright COMPONENT development)

install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/shatterpave COMPONENT command)

set(CPACK_PACKAGE_NAME shatterpave)
set(CPACK_PACKAGE_CONTACT "The shatterpave authors <shatterpave@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package_prefix.cmake)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME shatterpave)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
# The renderer; its standard includes; libraries that are opened when a plan needs them; environments (docs/camera-and-light.md).
set(CPACK_DEBIAN_COMMAND_PACKAGE_DEPENDS "povray, povray-includes, libgdal32, libproj25")
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "blender-data")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libshatterpave-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What a program that links the library needs (cmake/link_dependencies.cmake).
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libgdal32, libproj25, libbullet-dev, libfmt-dev, libopencv-imgproc-dev, libopenexr-dev, libopenimageio-dev, libpng-dev, libpolyclipping-dev, libpugixml-dev, libsleef-dev, libssl-dev, libtbb-dev, libtinygltf-dev, libtomlplusplus-dev, pkg-config")
include(CPack)
