# Bundles the page of reports into report_template.cpp, in the build tree. Sets report_source.
include(${PROJECT_SOURCE_DIR}/cmake/npm_packages.cmake)
find_node()
set(report_dir ${CMAKE_CURRENT_SOURCE_DIR}/report)
set(packages_dir ${CMAKE_CURRENT_BINARY_DIR}/report)
set(report_source ${CMAKE_CURRENT_BINARY_DIR}/report_template.cpp)
npm_packages(${report_dir} ${packages_dir})
file(GLOB report_files CONFIGURE_DEPENDS ${report_dir}/src/*.ts)
add_custom_command(OUTPUT ${report_source}
  COMMAND ${NODE} ${report_dir}/bundle.mjs ${packages_dir} ${report_source}
  DEPENDS ${packages_dir}/packages.stamp ${report_files} ${report_dir}/bundle.mjs
    ${report_dir}/page.html ${report_dir}/style.css ${report_dir}/licences.txt
  COMMENT "Bundling the page of reports"
  VERBATIM)
