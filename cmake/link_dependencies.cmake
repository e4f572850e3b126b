# The libraries that ours is linked with. The installed package configuration includes this file too, so that a consumer finds
# the same ones.
include(CMakeFindDependencyMacro)
find_dependency(PkgConfig)
find_dependency(OpenSSL)
find_dependency(TBB)
find_dependency(fmt)
find_dependency(pugixml)
find_dependency(tomlplusplus)
# By pkg-config, since Debian's OpenImageIOConfig.cmake demands the headers of OpenCV.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR)
pkg_check_modules(libpng REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
# Bullet in double precision: its build in single precision takes another way through processors that have more.
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(tinygltf REQUIRED IMPORTED_TARGET tinygltf)
pkg_check_modules(sleef REQUIRED IMPORTED_TARGET sleef)
# Of OpenCV core and imgproc alone, by their files: its package configuration demands the headers of all its modules.
if(NOT TARGET OpenCV::imgproc)
  find_path(OpenCV_HEADERS opencv2/imgproc.hpp PATH_SUFFIXES opencv4 REQUIRED)
  foreach(module IN ITEMS core imgproc)
    find_library(OpenCV_${module} opencv_${module} REQUIRED)
    add_library(OpenCV::${module} UNKNOWN IMPORTED)
    set_target_properties(OpenCV::${module} PROPERTIES IMPORTED_LOCATION ${OpenCV_${module}}
      INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_HEADERS} INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${OpenCV_HEADERS})
  endforeach()
endif()
