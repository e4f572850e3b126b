# The plotting library of the report of `measure`: Vega and Vega-Lite, as their authors publish them for browsers in npm packages.
# They are fetched by npm when this is configured, checked, and made part of the binary; the repository does not hold them.
#
# Sets shatterpave_plot_files: scripts and licences for shatterpave_embed; empty where they could not be had and need not.
set(SHATTERPAVE_PLOTS AUTO CACHE STRING
    "The report's plotting library: REQUIRED, AUTO (left out where it cannot be had) or OFF")
set_property(CACHE SHATTERPAVE_PLOTS PROPERTY STRINGS REQUIRED AUTO OFF)
set(SHATTERPAVE_PLOTS_FOLDER ${PROJECT_BINARY_DIR}/plots CACHE PATH
    "Folder of the packages vega-VERSION.tgz and vega-lite-VERSION.tgz; those that are not there are fetched into it")

# shatterpave_plot_package(NAME VERSION SHA512): unpacks the package NAME-VERSION.tgz beside the build, after fetching it if it
# is not there, and appends its script for browsers and its licence to shatterpave_plot_files. Sets shatterpave_plot_failure
# instead, where that cannot be done.
function(shatterpave_plot_package name version sha512)
  set(package ${SHATTERPAVE_PLOTS_FOLDER}/${name}-${version}.tgz)
  if(NOT EXISTS ${package})
    find_program(SHATTERPAVE_NPM npm)
    if(NOT SHATTERPAVE_NPM)
      set(shatterpave_plot_failure "npm was not found (Debian package npm)" PARENT_SCOPE)
      return()
    endif()
    file(MAKE_DIRECTORY ${SHATTERPAVE_PLOTS_FOLDER})
    execute_process(
      COMMAND ${SHATTERPAVE_NPM} pack ${name}@${version} --ignore-scripts --silent --fetch-retries=1 --fetch-timeout=60000
              --pack-destination ${SHATTERPAVE_PLOTS_FOLDER}
      WORKING_DIRECTORY ${SHATTERPAVE_PLOTS_FOLDER} TIMEOUT 180 RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(NOT status EQUAL 0 OR NOT EXISTS ${package})
      set(shatterpave_plot_failure "npm could not fetch ${name} ${version}" PARENT_SCOPE)
      return()
    endif()
  endif()
  file(SHA512 ${package} found)
  if(NOT found STREQUAL sha512)
    message(FATAL_ERROR "${package}: expected SHA-512\n  ${sha512}, got\n  ${found}")
  endif()
  set(folder ${PROJECT_BINARY_DIR}/plots/${name}-${version})
  if(NOT EXISTS ${folder}/${name}.min.js)
    file(ARCHIVE_EXTRACT INPUT ${package} DESTINATION ${folder}
         PATTERNS package/build/${name}.min.js package/LICENSE)
    file(RENAME ${folder}/package/LICENSE ${folder}/${name}.licence)
    file(RENAME ${folder}/package/build/${name}.min.js ${folder}/${name}.min.js)
  endif()
  set(shatterpave_plot_files ${shatterpave_plot_files} ${folder}/${name}.min.js ${folder}/${name}.licence PARENT_SCOPE)
endfunction()

set(shatterpave_plot_files "")
set(shatterpave_plot_failure "")
if(NOT SHATTERPAVE_PLOTS STREQUAL "OFF")
  shatterpave_plot_package(vega 6.4.0
    ac75c2ab62e911608b3235c1123ee1a1c63d1b4fe2e5319845ac861928f4e954c5e3e976206d99ee87992828d66d487fee14c4fe65616da38f07bdb0084961ea)
  if(NOT shatterpave_plot_failure)
    shatterpave_plot_package(vega-lite 6.5.0
      7cc5c5eacd0cac88345135a72c87de16d8122f3561cb348aa1bcc6ae1e6b852fa62fa14e6051b79bba2e278536de08fae442be825f452084f9c3bc0b35a03390)
  endif()
endif()
if(shatterpave_plot_failure)
  if(SHATTERPAVE_PLOTS STREQUAL "REQUIRED")
    message(FATAL_ERROR "The plotting library of the report is missing: ${shatterpave_plot_failure}")
  endif()
  message(STATUS "measure will leave out its report: ${shatterpave_plot_failure}")
  set(shatterpave_plot_files "")
endif()
