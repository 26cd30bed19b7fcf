# The command as a module of JavaScript beside its WebAssembly: engine.mjs of this folder asks it.
target_link_options(raceway PRIVATE -sMODULARIZE -sEXPORT_ES6 -sUSE_ES6_IMPORT_META=0 -sEXPORT_NAME=raceway
  -sENVIRONMENT=worker -sINVOKE_RUN=0 -sEXIT_RUNTIME -sEXPORTED_RUNTIME_METHODS=callMain,FS -sFORCE_FILESYSTEM
  -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=67108864 -sTOTAL_STACK=8388608 -sDYNAMIC_EXECUTION=0
  "--embed-file=${PROJECT_SOURCE_DIR}/data/bearings@/usr/share/raceway/bearings")
set_target_properties(raceway PROPERTIES SUFFIX .mjs)
add_custom_target(engine DEPENDS raceway)

# The page with the engine inside, where a program of another preset finds it (files::data_file) and installs it from.
set(workbench ${PROJECT_SOURCE_DIR}/build/share/raceway/workbench.html)
file(GLOB_RECURSE page CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/*.mjs ${PROJECT_SOURCE_DIR}/web/page/* ${PROJECT_SOURCE_DIR}/report/page/*)
file(MAKE_DIRECTORY ${PROJECT_SOURCE_DIR}/build/share/raceway)
add_custom_command(OUTPUT ${workbench}
  COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/web/bundle.mjs ${workbench} ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR}/report/page
  DEPENDS raceway ${page}
  COMMENT "Putting the engine into the page of the workbench"
  VERBATIM)
add_custom_target(workbench DEPENDS ${workbench})
