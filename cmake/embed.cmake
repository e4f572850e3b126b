# shatterpave_embed(TARGET FILE…): makes text files part of the binary, so that the command works from any
# folder and after installation. Each becomes an entry of `shatterpave::embedded_files()` by its file name.
function(shatterpave_embed target)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_files.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} "-DFILES=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    COMMENT "Embedding templates"
    VERBATIM)
  target_sources(${target} PRIVATE ${source})
endfunction()
