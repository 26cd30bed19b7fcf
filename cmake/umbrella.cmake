# Headers of a folder for users of the library: what is installed, and all.h with all of it.

# raceway_headers(folder): installs the headers of a folder and of the folders in it, but for those in detail/, and with
# them all.h. (A name as bearing/bearing.h is taken: bearing, model, record, spindle.)
function(raceway_headers folder)
  file(GLOB headers RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *.h */*.h)
  list(FILTER headers EXCLUDE REGEX "detail/")
  if(NOT headers)
    return()
  endif()
  string(CONCAT text "// All headers of ${folder} for users of the library; made by cmake/umbrella.cmake.\n"
    "// Threads: functions, and members that are const, may be called by several threads at once, on the same objects\n"
    "// too; other members by one thread at a time. Where it is otherwise a header says so.\n#pragma once\n\n")
  foreach(header IN LISTS headers)
    get_filename_component(within ${header} DIRECTORY)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/raceway/${folder}/${within})
    string(APPEND text "#include \"${folder}/${header}\"\n")
  endforeach()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/umbrella/${folder}/all.h CONTENT "${text}" @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/umbrella/${folder}/all.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/raceway/${folder})
endfunction()
