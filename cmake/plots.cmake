# What pages of the program run in browsers, as its authors publish it in npm packages: Vega and Vega-Lite, which plot in the report
# of `measure`, and three.js, which shows the bodies in the live view (`serve`). They are fetched by npm when this is configured,
# checked, and made part of the binary; the repository does not hold them.
#
# Sets shatterpave_plot_files and shatterpave_view_files: scripts and licences for shatterpave_embed; empty where they could not be
# had and need not.
set(SHATTERPAVE_PLOTS AUTO CACHE STRING
    "The report's plotting library and the live view's three.js: REQUIRED, AUTO (left out where it cannot be had) or OFF")
set_property(CACHE SHATTERPAVE_PLOTS PROPERTY STRINGS REQUIRED AUTO OFF)
set(SHATTERPAVE_PLOTS_FOLDER ${PROJECT_BINARY_DIR}/plots CACHE PATH
    "Folder of the packages vega-VERSION.tgz, vega-lite-VERSION.tgz and three-VERSION.tgz; those that are not there are fetched into it")

# shatterpave_browser_package(NAME VERSION SHA512 FILES FILE…): unpacks the package NAME-VERSION.tgz beside the build, after fetching
# it if it is not there, and sets FILES to its licence, NAME.licence, and those files, which keep the names they have without their
# folders. Sets shatterpave_plot_failure instead, where that cannot be done.
function(shatterpave_browser_package name version sha512 files)
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
  list(TRANSFORM ARGN PREPEND package/ OUTPUT_VARIABLE members)
  if(NOT EXISTS ${folder}/unpacked)
    file(ARCHIVE_EXTRACT INPUT ${package} DESTINATION ${folder} PATTERNS ${members} package/LICENSE)
    file(RENAME ${folder}/package/LICENSE ${folder}/${name}.licence)
    foreach(member IN LISTS members)
      get_filename_component(file ${member} NAME)
      file(RENAME ${folder}/${member} ${folder}/${file})
    endforeach()
    file(TOUCH ${folder}/unpacked)
  endif()
  set(found ${folder}/${name}.licence)
  foreach(member IN LISTS members)
    get_filename_component(file ${member} NAME)
    list(APPEND found ${folder}/${file})
  endforeach()
  set(${files} ${found} PARENT_SCOPE)
endfunction()

set(shatterpave_plot_files "")
set(shatterpave_view_files "")
set(shatterpave_plot_failure "")
if(NOT SHATTERPAVE_PLOTS STREQUAL "OFF")
  shatterpave_browser_package(vega 6.4.0
    ac75c2ab62e911608b3235c1123ee1a1c63d1b4fe2e5319845ac861928f4e954c5e3e976206d99ee87992828d66d487fee14c4fe65616da38f07bdb0084961ea
    vega_files build/vega.min.js)
  if(NOT shatterpave_plot_failure)
    shatterpave_browser_package(vega-lite 6.5.0
      7cc5c5eacd0cac88345135a72c87de16d8122f3561cb348aa1bcc6ae1e6b852fa62fa14e6051b79bba2e278536de08fae442be825f452084f9c3bc0b35a03390
      vega_lite_files build/vega-lite.min.js)
  endif()
  if(NOT shatterpave_plot_failure)
    shatterpave_browser_package(three 0.161.0
      2c2dbc545b636cec84bb96fddcad1b3512f0d6b425309f3996294ab188fa7604eefbb8b5ed6f8908211bbeba6634717517734052a0d25aae74503ef0f47db143
      shatterpave_view_files
      build/three.module.min.js examples/jsm/controls/OrbitControls.js examples/jsm/environments/RoomEnvironment.js)
  endif()
  set(shatterpave_plot_files ${vega_files} ${vega_lite_files})
endif()
# A page may name no other address: what the scripts import is beside them (serve/page.cpp).
foreach(file IN LISTS shatterpave_view_files)
  if(file MATCHES "/(OrbitControls|RoomEnvironment)\\.js$")
    file(READ ${file} text)
    string(REPLACE "from 'three'" "from './three.js'" text "${text}")
    file(WRITE ${file} "${text}")
  endif()
endforeach()
if(shatterpave_plot_failure)
  if(SHATTERPAVE_PLOTS STREQUAL "REQUIRED")
    message(FATAL_ERROR "The plotting library of the report is missing: ${shatterpave_plot_failure}")
  endif()
  message(STATUS "measure will leave out its report: ${shatterpave_plot_failure}")
  message(STATUS "serve will have no page: ${shatterpave_plot_failure}")
  set(shatterpave_plot_files "")
  set(shatterpave_view_files "")
endif()
