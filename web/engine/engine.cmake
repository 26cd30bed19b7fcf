# The command as a module of JavaScript beside its WebAssembly: engine.mjs of this folder asks it.
target_link_options(raceway PRIVATE -sMODULARIZE -sEXPORT_ES6 -sUSE_ES6_IMPORT_META=0 -sEXPORT_NAME=raceway
  -sENVIRONMENT=worker,node -sINVOKE_RUN=0 -sEXIT_RUNTIME -sEXPORTED_RUNTIME_METHODS=callMain,FS -sFORCE_FILESYSTEM
  -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=67108864 -sTOTAL_STACK=8388608 -sDYNAMIC_EXECUTION=0
  "--embed-file=${PROJECT_SOURCE_DIR}/data/bearings@/usr/share/raceway/bearings")
set_target_properties(raceway PROPERTIES SUFFIX .mjs)
add_custom_target(engine DEPENDS raceway)
