# Every library that the binary is made of comes from Debian 12 (packages.txt). (What cmake/plots.cmake fetches is text that the
# report of `measure` holds, and runs in a browser.)
# The installed package configuration includes this file too, so that a consumer finds the same ones.
include(CMakeFindDependencyMacro)
find_dependency(PkgConfig)
find_dependency(Boost 1.74)
find_dependency(CLI11)
find_dependency(OpenSSL)
find_dependency(TBB)
find_dependency(fmt)
find_dependency(glm)
find_dependency(nlohmann_json)
find_dependency(pugixml)
find_dependency(tomlplusplus)
# By pkg-config, since Debian's OpenImageIOConfig.cmake demands the headers of OpenCV.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
# Bullet in double precision: its build in single precision takes another way through processors that have more.
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(tinygltf REQUIRED IMPORTED_TARGET tinygltf)
pkg_check_modules(sleef REQUIRED IMPORTED_TARGET sleef)
# PROJ is opened at run time, by the name that the library has for its programs: libproj.so.25.
pkg_check_modules(proj REQUIRED proj>=9)
pkg_get_variable(proj_libdir proj libdir)
pkg_get_variable(proj_datadir proj datadir)
get_filename_component(proj_soname ${proj_libdir}/libproj.so REALPATH)
string(REGEX MATCH "libproj\\.so\\.[0-9]+" proj_soname ${proj_soname})
