# Bundles the page of reports into report_template.cpp, in the build tree: npm fetches what
# package-lock.json pins, esbuild makes one script of it. Sets report_source.
find_program(NODE NAMES node nodejs)
find_program(NPM npm)
if(NOT NODE OR NOT NPM)
  message(FATAL_ERROR "Reports need Node 18 or later with npm (Debian: nodejs npm), which were not found. "
    "Install them, or build without reports: cmake -DRACEWAY_REPORT=OFF")
endif()
set(report_dir ${CMAKE_CURRENT_SOURCE_DIR}/report)
set(packages_dir ${CMAKE_CURRENT_BINARY_DIR}/report)
set(report_source ${CMAKE_CURRENT_BINARY_DIR}/report_template.cpp)
file(GLOB_RECURSE report_files CONFIGURE_DEPENDS ${report_dir}/src/*.ts)
add_custom_command(OUTPUT ${packages_dir}/packages.stamp
  COMMAND ${CMAKE_COMMAND} -E copy ${report_dir}/package.json ${report_dir}/package-lock.json ${report_dir}/.npmrc ${packages_dir}
  COMMAND ${NPM} ci
  COMMAND ${CMAKE_COMMAND} -E touch packages.stamp
  DEPENDS ${report_dir}/package.json ${report_dir}/package-lock.json ${report_dir}/.npmrc
  WORKING_DIRECTORY ${packages_dir}
  COMMENT "Fetching the plotting library (npm ci); -DRACEWAY_REPORT=OFF builds without it"
  VERBATIM)
file(MAKE_DIRECTORY ${packages_dir})
add_custom_command(OUTPUT ${report_source}
  COMMAND ${NODE} ${report_dir}/bundle.mjs ${packages_dir} ${report_source}
  DEPENDS ${packages_dir}/packages.stamp ${report_files} ${report_dir}/bundle.mjs ${report_dir}/page.html
    ${report_dir}/style.css ${report_dir}/licences.txt ${report_dir}/tsconfig.json
  COMMENT "Bundling the page of reports"
  VERBATIM)
