# Every library that the binary is made of comes from Debian 12 (packages.txt). (What cmake/plots.cmake fetches is text that the
# report of `measure` holds, and runs in a browser.)
include(cmake/link_dependencies.cmake)
# Headers only: of no use to who has the binary.
find_package(Boost 1.74 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
# Of the command alone: its live view.
pkg_check_modules(httplib REQUIRED IMPORTED_TARGET cpp-httplib)
# PROJ is opened at run time, by the name that the library has for its programs: libproj.so.25.
pkg_check_modules(proj REQUIRED proj>=9)
pkg_get_variable(proj_libdir proj libdir)
pkg_get_variable(proj_datadir proj datadir)
get_filename_component(proj_soname ${proj_libdir}/libproj.so REALPATH)
string(REGEX MATCH "libproj\\.so\\.[0-9]+" proj_soname ${proj_soname})
# GDAL too: libgdal.so.32.
pkg_check_modules(gdal REQUIRED gdal>=3.6)
pkg_get_variable(gdal_libdir gdal libdir)
find_library(gdal_library gdal REQUIRED HINTS ${gdal_libdir})
get_filename_component(gdal_soname ${gdal_library} REALPATH)
string(REGEX MATCH "libgdal\\.so\\.[0-9]+" gdal_soname ${gdal_soname})
