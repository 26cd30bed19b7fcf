# Node and npm, and the packages that a package-lock.json pins, fetched into the build tree.

# find_node(): sets NODE and NPM, or ends with what to do.
function(find_node)
  find_program(NODE NAMES node nodejs)
  find_program(NPM npm)
  if(NODE)
    execute_process(COMMAND ${NODE} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REGEX REPLACE "^v" "" version "${version}")
  endif()
  if(NOT NODE OR NOT NPM OR version VERSION_LESS 18)
    message(FATAL_ERROR "Reports need Node 18 or later with npm (Debian: nodejs npm); found: ${NODE} ${version}, ${NPM}. "
      "Install them, or build without reports: -DRACEWAY_REPORT=OFF")
  endif()
endfunction()

# npm_packages(source_dir packages_dir): a rule that makes packages_dir/packages.stamp, beside which
# node_modules then is. Scripts of packages are not run.
function(npm_packages source_dir packages_dir)
  set(files ${source_dir}/package.json ${source_dir}/package-lock.json ${source_dir}/.npmrc)
  file(MAKE_DIRECTORY ${packages_dir})
  add_custom_command(OUTPUT ${packages_dir}/packages.stamp
    COMMAND ${CMAKE_COMMAND} -E copy ${files} ${packages_dir}
    COMMAND ${NPM} ci
    COMMAND ${CMAKE_COMMAND} -E touch packages.stamp
    DEPENDS ${files}
    WORKING_DIRECTORY ${packages_dir}
    COMMENT "npm ci in ${packages_dir}; without network: -DRACEWAY_REPORT=OFF"
    VERBATIM)
endfunction()
