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
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
# Bullet in double precision: its build in single precision takes another way through processors that have more.
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(tinygltf REQUIRED IMPORTED_TARGET tinygltf)
pkg_check_modules(sleef REQUIRED IMPORTED_TARGET sleef)
