# Run with -P: writes what PROGRAM prints as manual page and completions into FOLDER.
file(MAKE_DIRECTORY ${FOLDER})
foreach(form_and_file IN ITEMS man:shatterpave.1 bash:shatterpave.bash zsh:_shatterpave)
  string(REPLACE ":" ";" pair ${form_and_file})
  list(GET pair 0 form)
  list(GET pair 1 file)
  execute_process(COMMAND ${PROGRAM} manual --form ${form} OUTPUT_FILE ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
